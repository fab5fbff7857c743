use crate::command::args::Calibrate;
use crate::command::files::Rule;
use crate::command::interrupt::{self, BEST_SO_FAR};
use crate::command::output::{Answer, system, tell, warn};
use crate::command::reproduce::{DOCUMENT, write};
use crate::command::running::running;
use crate::optimize::least_squares::{Follow, Loss, Status};
use crate::parameters::{Law, Vary};
use crate::report::{CalibrationReport, Report};
use crate::study::calibrate::{
    Calibration, HeldOut, Plan, ShotTable, beyond, calibrate, check_folds, held_out, ranges,
};
use crate::units::{Message, System};
use crate::{Error, Result, Setup};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

pub fn run(args: &Calibrate) -> Result<Answer> {
    let request = args.setup_args.request()?;
    let setup = request.setup()?;
    let rule = Rule::new(request.inputs().chain([args.data.clone()]), args.overwrite);
    let folder = args
        .plot
        .as_ref()
        .map(|folder| rule.folder(folder, &DOCUMENT))
        .transpose()?;
    let rule = rule.and_not(args.plot.as_deref());
    let output = args
        .output
        .as_ref()
        .map(|file| rule.setup_file(file))
        .transpose()?;
    if setup.launch.is_given() {
        let source = format!(
            "calibrate reads the launch of each ball from columns of the table; leave this out, \
             and add the columns to {} if it has none: \
             ball_speed, launch_angle, and backspin or spin, with their units, as in \"ball_speed \
             [mph]\"",
            args.data.display()
        );
        return Err(Error::Unreadable {
            name: request.launch_from(),
            source: source.into(),
        });
    }
    let mut warnings = setup.warnings();
    warn(&warnings);
    let file = args.data.display().to_string();
    let mut table = ShotTable::open(&setup, &args.data)?;
    warn(&table.warnings);
    warnings.extend(table.warnings.clone());
    if request.gives_air() {
        table.in_given_air();
    }
    if table.is_launched {
        request.refuse_club(&format!("the rows of {file} are launches"))?;
    }
    let given: Vec<_> = setup
        .parameters()
        .into_iter()
        .filter(|parameter| table.gives(parameter))
        .collect();
    request.refuse_stated(
        &given,
        &format!("every row of {file} has a value of its own"),
    )?;
    request.refuse_replaced(&setup, &given)?;
    let mut plan = Plan::read(&setup, &args.fit)?;
    let setup = request.for_many(setup, &ranges(&table, &plan.fit))?;
    plan.starts = args.starts as usize;
    plan.options.max_iterations = args.max_iterations;
    if args.huber {
        plan.options.loss = Loss::HUBER;
    }
    let folds = if args.folds > 0 {
        args.folds as usize
    } else {
        5.min(table.shots.len())
    };
    let compared = args
        .compare
        .iter()
        .map(|law| Compared::new(&setup, law, &plan))
        .collect::<Result<Vec<_>>>()?;
    let is_cross_validated = args.folds > 0 || !args.compare.is_empty();
    if is_cross_validated {
        check_folds(&table, &plan, folds)?;
    }
    for Compared { law, plan, .. } in &compared {
        check_folds(&table, plan, folds).map_err(|error| Error::Unreadable {
            name: format!("`compare {law}`"),
            source: error.into(),
        })?;
    }
    let one_drive: Vec<_> = table.one_drive(&setup, &plan.fit).into_iter().collect();
    warn(&one_drive);
    warnings.extend(one_drive);
    let follow = Follow {
        iteration: Some(Arc::new(shown(args.starts > 1))),
        interrupt: interrupt::stops(BEST_SO_FAR),
    };
    let found = calibrate(&setup, &table, &plan, &follow)?;
    let shots = beyond(&found.setup, &table.shots, &follow.interrupt);
    let shots = [shots, found.warnings(&table)].concat();
    warn(&shots);
    warnings.extend(shots);

    let quiet = Follow {
        iteration: None,
        ..follow
    };
    let mut held = vec![];
    if is_cross_validated {
        if !quiet.is_interrupted() {
            tell(&format!(
                "cross-validation: fitting {folds} times, each time without a part of the rows"
            ));
        }
        let name = format!("{}, fitted as above", setup.law.name());
        held.push((name, held_out(&setup, &table, &plan, folds, &quiet)?));
        if !args.compare.iter().any(|law| law == setup.law.name()) {
            let unfitted = HeldOut::as_it_stands(&setup, &table, &quiet)?;
            held.push((format!("{}, {AS_SET_UP}", setup.law.name()), unfitted));
        }
        for Compared {
            law,
            as_it_stands,
            setup,
            plan,
        } in &compared
        {
            held.push((
                format!("{law}, {as_it_stands}"),
                HeldOut::as_it_stands(setup, &table, &quiet)?,
            ));
            held.push((
                format!("{law}, all coefficients fitted"),
                held_out(setup, &table, plan, folds, &quiet)?,
            ));
        }
    }
    let mut report = CalibrationReport::new(&table, &found, &held);
    if !report.is_found() {
        let without_minimum = [Message::from(format!(
            "the fit ended as '{}': {}",
            report.status(),
            report.message()
        ))];
        warn(&without_minimum);
        warnings.extend(without_minimum);
    }
    let output = output.filter(|output| {
        let is_fitted = is_fitted(&found);
        if !is_fitted {
            let why = "the fit ended before it came to a minimum";
            let unwritten = [Message::from(format!(
                "{} is not written: {why}",
                output.path().display()
            ))];
            warn(&unwritten);
            warnings.extend(unwritten);
        }
        is_fitted
    });
    if let Some(output) = &output {
        let toml = report.toml(request.source().preset(), &file)?;
        output.write(request.with_stated_step(toml)?.as_bytes())?;
        tell(&format!(
            "wrote the fitted setup into {}",
            output.path().display()
        ));
    }
    if let Some(folder) = &folder {
        write(
            folder,
            &System::ALL.map(|system| report.document(system)),
            system(),
        )?;
    }
    let named = |path: &PathBuf| path.display().to_string();
    report.file = args.output.as_ref().filter(|_| output.is_some()).map(named);
    report.folder = args.plot.as_ref().map(named);
    let answer = Answer::report(&report, warnings, request.is_json());
    Ok(answer.found(report.is_found()))
}

/// Whether the values are those of a fit: one that was stopped on its way has those that it had
/// come to.
fn is_fitted(found: &Calibration) -> bool {
    found.is_minimum
        || !matches!(
            found.fit.status,
            Status::Interrupted | Status::IterationLimit
        )
}

/// Shows each iteration, and where there are several searches the number of the search: each begins
/// with iteration 0.
fn shown(is_numbered: bool) -> impl Fn(u64, f64) {
    let (running, begun) = (running(), AtomicU64::new(0));
    move |iteration, sum| {
        let begins = u64::from(iteration == 0);
        let search = begun.fetch_add(begins, Relaxed) + begins;
        let search = if is_numbered {
            format!("search {search}  ")
        } else {
            String::new()
        };
        running.tell(&format!(
            "{search}iteration {iteration:3}  half the sum of squares {sum:.6e}"
        ));
    }
}

/// What a law is called whose parameters are not fitted.
const AS_SET_UP: &str = "as the setup has it";

/// Another law on the same rows: as it is published, and with all its coefficients fitted.
struct Compared<'a> {
    law: &'a str,
    as_it_stands: &'static str,
    setup: Setup<f64>,
    plan: Plan,
}

impl<'a> Compared<'a> {
    fn new(setup: &Setup<f64>, law: &'a str, plan: &Plan) -> Result<Self> {
        let mut other = *setup;
        other.set_law(law)?;
        let as_it_stands = if law == setup.law.name() {
            AS_SET_UP
        } else {
            "as published"
        };
        let own = Law::all_rows().filter(|row| row.law == Some(other.law.name()));
        let coefficients = own.map(|row| Vary {
            parameter: row,
            low: row.range.low,
            high: row.range.high,
        });
        let kept = plan
            .fit
            .iter()
            .filter(|vary| vary.parameter.law.is_none())
            .copied();
        let plan = Plan {
            fit: kept.chain(coefficients).collect(),
            ..plan.clone()
        };
        Ok(Self {
            law,
            as_it_stands,
            setup: other,
            plan,
        })
    }
}
