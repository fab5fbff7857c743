use crate::args::Report;
use crate::files::Rule;
use crate::output::{Answer, bar, system, tell, warn};
use crate::plot::limits;
use longdrive::flight::Flight;
use longdrive::optimize::{Status, Watch};
use longdrive::report::Reply;
use longdrive::report::figures::Flown;
use longdrive::report::page::{Document, Findings, report_documents};
use longdrive::reproduce::while_loop;
use longdrive::study::certificate::{Row, certify};
use longdrive::study::{
    Chart, Fineness, Search, Sigma, Vary, chart, effects, flatness, map, optimum, usual_loss, with_defaults,
};
use longdrive::units::Message;
use longdrive::{Outcome, Result, Setup};
use serde_json::json;

/// Optima along the parameter are about this many: what the bar counts to.
const USUAL_POINTS: u64 = 24;

pub fn run(args: &Report) -> Result<Answer> {
    let setup = args.question.setup()?;
    let search = args.search.search(&setup)?;
    let along = Vary::read(&setup, &args.along)?;
    let ranges: Vec<_> = search.vary.iter().copied().chain([along]).collect();
    let setup = args.question.within_tolerance(setup, &ranges)?;
    let preset = args.question.preset()?;
    let given = args.sigma.iter().map(|text| Sigma::read(&setup, text)).collect::<Result<Vec<_>>>()?;
    let sigmas = with_defaults(&setup, &given)?;
    // before the work, not after it
    let folder = Rule::new(args.question.inputs(), args.overwrite).folder(&args.output, &["index.html"])?;

    let bar = bar("parts");
    bar.set_length(USUAL_POINTS + 5);
    let mut flown = vec![Flown::new("as set up", &setup)?];
    let mut remarks = flown[0].drive.warnings(&setup);
    bar.inc(1);

    let found = optimum(&setup, search.clone(), Watch::default())?;
    let is_found = found.solution.status == Status::Converged;
    if !is_found {
        remarks.push(Message::from(format!("no optimum: {}: ", found.status())).message(found.message()));
    }
    let best = is_found.then_some(&found);
    if let Some(best) = best {
        let longest = Flown::new("optimum", &best.setup)?;
        let of_drive = longest.drive.warnings(&best.setup).into_iter().filter(|warning| !remarks.contains(warning));
        let of_drive: Vec<_> = of_drive.map(|warning| Message::from("at the optimum: ").message(warning)).collect();
        remarks.extend(of_drive);
        flown.push(longest);
    }
    let flatness = best.map(|best| flatness(best, usual_loss(best))).transpose()?;
    bar.inc(1);

    let around = best.map_or(&setup, |best| &best.setup);
    let map = match search.vary[..] {
        [across, up, ..] => said(map(around, search.maximize, across, up, Fineness::default()), &mut remarks)?,
        _ => None,
    };
    let limits = said(limits(around, &search), &mut remarks)?.unwrap_or_default();
    bar.inc(1);
    let is_varied = search.vary.iter().any(|vary| vary.parameter == along.parameter);
    let chart = if is_found && !is_varied {
        let watch = |_: &_| {
            bar.inc(1);
            true
        };
        said(chart(&setup, &search, along, watch), &mut remarks)?
    } else {
        None
    };

    remarks.extend(chart.as_ref().map_or_else(Vec::new, Chart::warnings));

    let of = if search.maximize == Outcome::Lateral {
        vec![Outcome::Carry]
    } else {
        vec![search.maximize, Outcome::Lateral]
    };
    let effects = said(effects(&setup, &of, &sigmas, |_, _| ()), &mut remarks)?.unwrap_or_default();
    bar.inc(1);
    let rows = said(rows(&setup, &search), &mut remarks)?.unwrap_or_default();
    bar.inc(1);

    let findings = Findings {
        name: &args.question.setup,
        setup: &setup,
        preset,
        flown: &flown,
        best,
        flatness: flatness.as_ref(),
        map: map.as_ref(),
        limits: &limits,
        chart: chart.as_ref(),
        effects: &effects,
        rows: &rows,
        loops: &while_loop(&setup, &rows),
        system: system(),
        remarks: &remarks,
    };
    let documents = report_documents(&findings)?;
    folder.write(documents.iter().map(|Document { name, text }| (name.as_str(), text.as_bytes())))?;
    bar.finish_and_clear();
    warn(&remarks);
    let index = args.output.join("index.html");
    tell(&format!("{} ({} files)", index.display(), documents.len()));
    let names: Vec<&str> = documents.iter().map(|document| document.name.as_str()).collect();
    let answer = if args.question.json {
        let (status, message) = match &flown[0].drive.flight {
            Flight::None(why) => (why.status(), Some(why.to_string())),
            Flight::Landed(_) if is_found => ("done", None),
            Flight::Landed(_) => (found.status(), Some(found.message().to_string())),
        };
        let body = json!({ "folder": args.output.display().to_string(), "files": names });
        Answer::json(&Reply::done("report", remarks.clone(), body).ended(status, message))
    } else {
        Answer::text(String::new())
    };
    Ok(answer.found(is_found && flown[0].drive.landed().is_ok()))
}

/// The derivatives of the outcome by what is varied, and by the speed of the swing, beside differences.
fn rows(setup: &Setup<f64>, search: &Search) -> Result<Vec<Row>> {
    let mut wrt: Vec<_> = search.vary.iter().map(|vary| vary.parameter).collect();
    let speed = setup.variable("swing.speed")?;
    if !wrt.contains(&speed) {
        wrt.push(speed);
    }
    let of = search.maximize;
    let mut rows = certify(setup, &[of], &wrt, |_, _| true)?.rows;
    // not those of the landing, which are looked at beside
    rows.retain(|row| row.of == of);
    Ok(rows)
}

/// A part of the report; where it has no answer the report says so, and goes on.
fn said<T>(part: Result<T>, remarks: &mut Vec<Message>) -> Result<Option<T>> {
    match part {
        Ok(part) => Ok(Some(part)),
        Err(error) if error.is_an_outcome() => {
            let remark = error.message();
            if !remarks.contains(&remark) {
                remarks.push(remark);
            }
            Ok(None)
        }
        Err(error) => Err(error),
    }
}
