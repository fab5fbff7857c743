use crate::command::args::{SearchArgs, SetupArgs};
use crate::command::date::today;
use crate::command::explore::page::compiled_in;
use crate::command::files::OutputRule;
use crate::command::host::Progress;
use crate::command::names::sigmas;
use crate::command::output::{
    Answer, bar, command_line, is_json, note, system, text_of, warn, warnings,
};
use crate::command::plot::{counted_points, limits};
use crate::command::request::Request;
use crate::command::running::running;
use crate::command::search::SearchRequest;
use crate::command::swings::of_a_drive;
use crate::command::wording::in_host_syntax;
use crate::derivative::default_variables;
use crate::flight::Flight;
use crate::optimize::Observer;
use crate::report::page::{EXPLORER_FILE, Findings, SETUP_FILE, report_documents};
use crate::report::{Document, Ending, Reply, SetupOrigin, TextFile, explorer_state};
use crate::reproduce::while_loop;
use crate::study::certificate::{DerivativeRow, certify};
use crate::study::{
    Chart, DriveRole, Face, Fineness, Landing, Launches, Map, NamedDrive, Region, Search, Sigma,
    Vary, chart, default_loss, effects, flatness, improve_from_club_alone, lofts, map, optimum,
    short_drive, with_defaults,
};
use crate::units::{Message, counted};
use crate::{Error, Outcome, Result, Setup};
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The typical number of optima in a chart, for the progress bar.
const USUAL_POINTS: u64 = 24;

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub search: SearchArgs,

    /// The folder to write: index.html, the best drive as setup.toml, and each plot as
    /// NAME-metric.svg, NAME-us.svg and NAME.csv. The folder is created if it does not exist; other
    /// files in it are not touched.
    #[arg(long, short, value_name = "DIR")]
    pub output: PathBuf,

    /// Replace files that exist.
    #[arg(long)]
    pub overwrite: bool,

    /// The standard uncertainty of a parameter, e.g. swing.speed=1mph or air.density=0.5%.
    /// Repeatable; other parameters have the default uncertainties of "longdrive sensitivity".
    #[arg(long, value_name = "NAME=AMOUNT")]
    pub sigma: Vec<String>,

    /// The parameter along which optima are computed, with its range [default:
    /// swing.speed=80mph..130mph; with --launch, launch.ball_speed=120mph..190mph; around the
    /// drive's own speed if that is outside of these ranges].
    #[arg(long, value_name = "NAME=LOW..HIGH", allow_hyphen_values = true)]
    pub along: Option<String>,
}

pub fn run(args: &Args) -> Result<Answer> {
    let request = args.setup_args.request()?;
    let inputs = ReportRequest::new(args, &request)?;
    let date = today()?;
    // before the work begins, refuse existing files whose names are known already
    let explorer_page = compiled_in();
    let state = explorer_state(&inputs.stated, request.source.content.preset, system());
    let explorer = explorer_page.and(state.ok());
    let explorer_page = explorer_page.filter(|_| explorer.is_some());
    let mut names = vec!["index.html", SETUP_FILE];
    names.extend(explorer_page.map(|_| EXPLORER_FILE));
    let folder = OutputRule::new(request.inputs(), args.overwrite).folder(&args.output, &names)?;

    let origin = match &inputs.drive_search {
        Some(drive_search) => drive_search.origin.clone(),
        None => request.origin(),
    };
    let bar = bar("parts");
    bar.set_length(USUAL_POINTS + 5);
    let mut findings = Findings {
        explorer,
        system: system(),
        command: command_line(&running().words),
        date,
        advice: in_host_syntax(&origin.advice),
        ..Findings::new(
            name_of(&request),
            inputs.stated,
            inputs.setup,
            inputs.of,
            request.source.content.clone(),
        )
    };
    add_sections(&mut findings, &inputs, &bar)?;
    let documents = report_documents(&findings)?;
    let files: Vec<_> = documents
        .iter()
        .map(|TextFile { name, text }| (name.as_str(), text.as_bytes()))
        .chain(explorer_page.map(|page| (EXPLORER_FILE, page)))
        .collect();
    folder.write(files.iter().copied())?;
    bar.finish();
    let why_none = findings.why_none.iter();
    warn(findings.remarks.iter().chain(why_none).cloned());
    note(&format!(
        "{} ({})",
        args.output.join("index.html").display(),
        counted(files.len() as u64, "file")
    ));
    let names = files.iter().map(|(name, _)| *name).collect();
    Ok(answer(args, &origin, &findings, names))
}

/// The drive and the search of a report.
struct ReportRequest {
    /// The setup of the request.
    stated: Setup<f64>,
    /// The setup of the request, with the integration method and step that keep the error of the
    /// flights within the tolerance.
    setup: Setup<f64>,
    /// The outcome that the report is about.
    of: Outcome,
    drive_search: Option<SearchRequest>,
    /// The reason why there is no search.
    reason: Option<String>,
    /// The parameter along which the chart runs. `None` if there is no chart: there is no search,
    /// or `--along` is not given and the search varies the default parameter.
    along: Option<Vary>,
    /// The stated uncertainties.
    given: Vec<Sigma>,
}

impl ReportRequest {
    fn new(args: &Args, request: &Request) -> Result<Self> {
        let stated = request.setup()?;
        let of = args.search.objective(of_a_drive, Outcome::Carry)?.0;
        let reason = args.search.nothing_to_vary(request)?;
        let (mut drive_search, mut along) = (None, None);
        if reason.is_none() {
            along = args.along(&stated)?;
            drive_search = Some(args.search.of_drive(request, along, None)?);
        } else {
            args.refuse_idle_search()?;
        }
        let setup = match &drive_search {
            Some(drive_search) => drive_search.setup,
            None => request.for_many(stated, &[])?,
        };
        let uncertain = request.with_assumed_launch(setup)?;
        let given = sigmas(&uncertain, &args.sigma)?;
        // refuse wrong uncertainties before the search
        with_defaults(&uncertain, &given, &[of])?;
        Ok(Self {
            stated,
            setup,
            of,
            drive_search,
            reason,
            along,
            given,
        })
    }
}

/// Computes the sections of a report. A section without an answer becomes a remark.
fn add_sections(
    findings: &mut Findings,
    inputs: &ReportRequest,
    bar: &Arc<dyn Progress>,
) -> Result<()> {
    let search = inputs.drive_search.as_ref();
    let search = search.map(|drive_search| &drive_search.search);
    let mut remarks = vec![];
    add_drives(findings, search, bar, &mut remarks)?;
    let why_none = why_none(findings, inputs.reason.as_deref());
    add_pictures(findings, &inputs.given, &mut remarks)?;
    add_optimum(findings, &mut remarks)?;
    bar.inc(1);
    add_map(findings, search, &mut remarks)?;
    bar.inc(1);
    if let (Some(search), Some(along), Some(_)) = (search, inputs.along, findings.best()) {
        let observer = counted_points(bar);
        let chart = chart(&findings.setup, search, along, &[], &observer);
        findings.chart = or_remark(chart, &mut remarks)?;
        remarks.extend(findings.chart.iter().flat_map(Chart::warnings));
    }
    add_derivatives(findings, search, &inputs.given, bar, &mut remarks)?;
    let in_words = |message: Message| message.map_words(in_host_syntax);
    findings.remarks = remarks.into_iter().map(in_words).collect();
    findings.why_none = why_none.map(in_words);
    Ok(())
}

/// The name of the setup. For a file, omit the folder (privacy).
fn name_of(request: &Request) -> String {
    Path::new(request.source.name()).file_name().map_or_else(
        || request.source.argument.clone(),
        |name| name.to_string_lossy().into_owned(),
    )
}

fn answer(args: &Args, origin: &SetupOrigin, findings: &Findings, files: Vec<&str>) -> Answer {
    let own = &findings.flown[0].drive;
    let missing = findings.found.as_ref();
    let missing = missing.filter(|_| findings.best().is_none());
    let answer = if is_json() {
        let ending = match (&own.flight, missing) {
            (Flight::None(why), _) => Ending {
                status: why.status(),
                message: Some(why.to_string()),
            },
            (Flight::Landed(_), None) => Ending::DONE,
            (Flight::Landed(_), Some(found)) => Ending {
                status: found.status(),
                message: Some(found.message().to_string()),
            },
        };
        let body = ReportFiles {
            folder: args.output.display().to_string(),
            files,
        };
        let reply = Reply::done("report", warnings(), body).about(origin);
        Answer::json(&reply.ended(ending))
    } else {
        let mut document = Document::default();
        origin.put_before(&mut document, system());
        Answer::text(text_of(&document))
    };
    answer.found(missing.is_none() && own.landed().is_ok())
}

/// Adds the drive as set up, the drive of the optimum, and the optimum of the club alone.
fn add_drives(
    findings: &mut Findings,
    search: Option<&Search>,
    bar: &Arc<dyn Progress>,
    remarks: &mut Vec<Message>,
) -> Result<()> {
    let setup = &findings.setup;
    let own = NamedDrive::new(DriveRole::AsSetUp, setup)?;
    remarks.extend(own.drive.warnings_about(setup, Outcome::OF_DRIVES));
    bar.inc(1);
    let mut found = search
        .map(|search| optimum(setup, search.clone(), Observer::default()))
        .transpose()?;
    let club_alone = found
        .as_mut()
        .map(|best| or_remark(improve_from_club_alone(best), remarks))
        .transpose()?;
    findings.club_alone = club_alone.flatten().flatten();
    findings.found = found;
    findings.flown.push(own);
    if let Some(best) = findings.best() {
        let longest = NamedDrive::new(DriveRole::Optimum, &best.setup)?;
        let mut of_drive = longest
            .drive
            .warnings_about(&best.setup, Outcome::OF_DRIVES);
        of_drive.retain(|warning| !remarks.contains(warning));
        remarks.extend(
            of_drive
                .into_iter()
                .map(|warning| Message::from("at the optimum: ").message(warning)),
        );
        findings.flown.push(longest);
    }
    Ok(())
}

/// The reason why there is no optimum. `reason` is given if there was no search.
fn why_none(findings: &Findings, reason: Option<&str>) -> Option<Message> {
    match (&findings.found, findings.best()) {
        (None, _) => reason.map(|reason| {
            Message::from(format!(
                "the optimum, its map and its chart are left out: {reason}"
            ))
        }),
        (Some(found), None) => Some(
            Message::from(format!("no optimum: {}: ", found.status())).message(found.message()),
        ),
        _ => None,
    }
}

/// Adds the flatness around the optimum, and the table of lofts.
fn add_optimum(findings: &mut Findings, remarks: &mut Vec<Message>) -> Result<()> {
    let best = findings.best();
    let short = best.and_then(short_drive);
    remarks.extend(short.map(|(_, message)| Message::from(message)));
    let flatness = best
        .map(|best| flatness(best, default_loss(best)))
        .transpose()?;
    let lofts = lofts(
        &findings.setup,
        best.map_or(&findings.setup, |best| &best.setup),
    )?;
    findings.flatness = flatness;
    findings.lofts = lofts;
    Ok(())
}

/// Adds the map around the optimum, or else around the setup, over the first two varied parameters.
fn add_map(
    findings: &mut Findings,
    search: Option<&Search>,
    remarks: &mut Vec<Message>,
) -> Result<()> {
    let best = findings.best();
    let around = best.map_or(&findings.setup, |best| &best.setup);
    let map = match search.map(|search| &search.vary[..]) {
        Some([across, up, ..]) => {
            let map = map(around, findings.of, *across, *up, Fineness::default());
            or_remark(map, remarks)?
        }
        _ => None,
    };
    let flat = map.as_ref().and_then(Map::flat);
    let map = map.filter(|_| flat.is_none());
    remarks.extend(flat);
    let limits = search
        .map(|search| or_remark(limits(around, search), remarks))
        .transpose()?
        .flatten();
    let region = match (best, &map) {
        (Some(best), Some(map)) => {
            let (across, up) = (map.plane.across, map.plane.up);
            Region::around(best, across, up, default_loss(best))?
        }
        _ => None,
    };
    findings.map = map;
    findings.limits = limits.unwrap_or_default();
    findings.region = region;
    Ok(())
}

/// Adds effects of uncertainties, and derivatives compared with finite differences.
fn add_derivatives(
    findings: &mut Findings,
    search: Option<&Search>,
    given: &[Sigma],
    bar: &Arc<dyn Progress>,
    remarks: &mut Vec<Message>,
) -> Result<()> {
    let (setup, of) = (&findings.setup, findings.of);
    let other = if of == Outcome::Lateral {
        Outcome::Carry
    } else {
        Outcome::Lateral
    };
    // other parameters may be uncertain at the optimum: a varied wind replaces `wind.right`
    let moved = |setup: &Setup<f64>, outcomes: &[Outcome]| {
        let setup = setup.with_assumed_launch()?;
        let sigmas = with_defaults(&setup, given, &[of])?;
        effects(&setup, outcomes, &sigmas, &|_, _| ())
    };
    let effects = or_remark(moved(setup, &[of, other]), remarks)?.unwrap_or_default();
    bar.inc(1);
    let at_best = findings
        .best()
        .map(|best| or_remark(moved(&best.setup, &[of]), remarks))
        .transpose()?;
    let rows = or_remark(rows(setup, of, search), remarks)?.unwrap_or_default();
    bar.inc(1);
    findings.loops = while_loop(setup, &rows);
    findings.effects = effects;
    findings.at_best = at_best.flatten().and_then(|mut effects| effects.pop());
    findings.rows = rows;
    Ok(())
}

impl Args {
    /// The parameter along which the chart runs. `None` if `--along` is not given and the search
    /// varies the default parameter.
    fn along(&self, setup: &Setup<f64>) -> Result<Option<Vary>> {
        if let Some(text) = &self.along {
            return Vary::read(setup, text).map(Some);
        }
        let along = default_speeds(setup)?;
        let is_varied = |range: &String| {
            let name = range.split('=').next();
            name.is_some_and(|name| name.trim() == along.parameter.name)
        };
        let is_free = !self.search.vary.iter().any(is_varied);
        Ok(is_free.then_some(along))
    }

    /// Refuses options of a search if there is nothing to vary. The objective is allowed, because
    /// the report is about this outcome.
    fn refuse_idle_search(&self) -> Result<()> {
        let along = self.along.as_ref().map(|_| "`along`");
        let options = self.search.stated().chain(along);
        let mut idle = options.filter(|option| !["`maximize`", "`minimize`"].contains(option));
        let Some(option) = idle.next() else {
            return Ok(());
        };
        let source = "it is an option of the search for an optimum; give `vary` too, for example \
                      launch.launch_angle=5deg..20deg, or leave it out";
        Err(Error::unreadable(option, source))
    }
}

/// The default speed range of the chart. If the drive's speed is outside of this range, a range of
/// equal width around the drive's speed is used, but not below half of the drive's speed.
fn default_speeds(setup: &Setup<f64>) -> Result<Vary> {
    let default = if setup.launch.is_given() {
        "launch.ball_speed=120mph..190mph"
    } else {
        "swing.speed=80mph..130mph"
    };
    let default = Vary::read(setup, default)?;
    let half = 0.5 * (default.high - default.low);
    match setup.value(default.parameter) {
        Some(own) if !(default.low..=default.high).contains(&own) => {
            let high = (own + half).min(default.parameter.range.high);
            Vary::new(default.parameter, (own - half).max(0.5 * own), high)
        }
        _ => Ok(default),
    }
}

/// Adds the plot data of the drive as set up and of the optimal drive. A drive that does not land
/// is omitted. `given` are the stated uncertainties.
fn add_pictures(
    findings: &mut Findings,
    given: &[Sigma],
    remarks: &mut Vec<Message>,
) -> Result<()> {
    let (setup, best, flown) = (&findings.setup, findings.best(), &findings.flown);
    let setups = std::iter::once(setup).chain(best.map(|best| &best.setup));
    let flying = flown
        .iter()
        .zip(setups)
        .filter(|(flown, _)| flown.drive.landed().is_ok());
    let drives: Vec<_> = flying.map(|(flown, setup)| (flown.role, setup)).collect();
    let landing = |(role, setup): &(DriveRole, &Setup<f64>)| {
        let setup = setup.with_assumed_launch()?;
        let sigmas = with_defaults(&setup, given, &[Outcome::Carry, Outcome::Lateral])?;
        Landing::of(*role, &setup, &sigmas)
    };
    let is_struck =
        !setup.launch.is_given() && flown.first().is_some_and(|own| own.drive.landed().is_ok());
    let launches = (!drives.is_empty())
        .then(|| or_remark(Launches::around(&drives), remarks))
        .transpose()?;
    let face = is_struck
        .then(|| or_remark(Face::of(setup), remarks))
        .transpose()?;
    let best_face = best
        .filter(|_| is_struck)
        .map(|best| or_remark(Face::of(&best.setup), remarks))
        .transpose()?;
    findings.landings = drives.iter().map(landing).collect::<Result<_>>()?;
    findings.launches = launches.flatten();
    findings.face = face.flatten();
    findings.best_face = best_face.flatten();
    Ok(())
}

/// Derivatives of the outcome by the varied (or default) parameters and by the club or ball speed,
/// compared with finite differences.
fn rows(setup: &Setup<f64>, of: Outcome, search: Option<&Search>) -> Result<Vec<DerivativeRow>> {
    let mut wrt = match search {
        Some(search) => search.parameters().collect(),
        None => default_variables(setup)?,
    };
    // the drive as set up has no derivative by a parameter that it does not have
    wrt.retain(|parameter| setup.value(parameter).is_some());
    let speed = setup.variable(if setup.launch.is_given() {
        "launch.ball_speed"
    } else {
        "swing.speed"
    })?;
    if !wrt.contains(&speed) {
        wrt.push(speed);
    }
    Ok(certify(setup, &[of], &wrt, &|_, _| true)?.rows)
}

/// A section of the report. If the section has no answer, adds the reason to the remarks and
/// returns `None`, so that the report continues.
fn or_remark<T>(part: Result<T>, remarks: &mut Vec<Message>) -> Result<Option<T>> {
    match part {
        Ok(part) => Ok(Some(part)),
        Err(error) if error.has_valid_input() => {
            let remark = error.message();
            if !remarks.contains(&remark) {
                remarks.push(remark);
            }
            Ok(None)
        }
        Err(error) => Err(error),
    }
}

/// The files of a page.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ReportFiles<'a> {
    /// The folder.
    folder: String,
    /// Names of the files.
    files: Vec<&'a str>,
}
