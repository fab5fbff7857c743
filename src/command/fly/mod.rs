//! Flies the shots of a launch monitor.

mod args;
pub mod listen;
mod request;
mod target;

pub use args::Args;

use crate::batch::Run;
use crate::command::args::refuse_threads;
use crate::command::files::{Destination, DestinationKind, OutputStream};
use crate::command::interrupt;
use crate::command::output::{Answer, is_json, note, note_each, say_error, system, text_of, warn};
use crate::command::request::Request;
use crate::command::rows_target::RowsTarget;
use crate::drive::CheckScope;
use crate::input_file;
use crate::parameters::{Law, Preset};
use crate::report::{Ending, Report, ShotWriter, ShotsReport};
#[cfg(feature = "parquet")]
use crate::report::{PARQUET_MAGIC, ShotParquet};
use crate::shots::{Flying, ShotStatistics, Shots};
use crate::table::{ASSUMED_UNITS, CONDITIONS, RowFilter};
use crate::units::{Message, counted};
use crate::{Error, Outcome, Result, Setup};
use args::FlyFormat;
use request::{flying_within_tolerance, requested_outcomes, setup};
use std::path::Path;
use target::{destination, format_of};

pub fn run(args: &Args) -> Result<Answer> {
    match args.listen {
        Some(port) => listen::run(args, port),
        None => fly(args),
    }
}

fn fly(args: &Args) -> Result<Answer> {
    let Some(file) = &args.shots else {
        return Err(Error::Nothing {
            doing: "fly",
            what: "file of shots",
        });
    };
    refuse_preset(file)?;
    refuse_threads(args.threads)?;
    let request = args.setup_args.request()?;
    let setup = setup(&request, &format!("the rows of {}", file.display()))?;
    let target = RowsTarget::new(&args.output, args.overwrite)?;
    let format = format_of(args, target)?;
    let destination = destination(args, target, file, &request)?;
    let work = interrupt::enable("stopping after the rows under way");
    let filter = RowFilter::read(&args.only)?;
    let mut shots = read_shots(file, filter, &request, &setup)?;
    // `requested_outcomes` prints notes about the outcomes: call it after all checks of the input
    let of = requested_outcomes(args)?;
    let flying = flying(&request, &setup, &shots, &of)?;
    let mut remarks = shots.remarks().to_vec();
    remarks.extend(not_compared(&shots, &of, request.gives_ground()));
    note_each(file.display(), &remarks);
    let run = Run {
        threads: args.threads,
        stop: Some(&work.stop),
        ..Run::default()
    };
    let maker = shots.maker();
    let mut output = destination.begin()?;
    let FlownRows { tally, remark } = write_rows(&mut output, format, &flying, &mut shots, &run)?;
    let mut closing = shots.final_remarks();
    closing.extend(remark);
    closing.extend(of_further_clubs(&tally));
    note_each(file.display(), &closing);
    remarks.extend(closing);
    if tally.is_complete {
        refuse_no_rows(&tally, file)?;
        output.finish()?;
    }
    warn_about_shots(&tally, &shots, &setup.law);
    let stopped = (!tally.is_complete).then(|| stopped(&tally, &destination));
    let nothing = nothing(&tally, &remarks);
    if is_json() {
        warn(nothing.iter().cloned().map(Message::from));
    }
    Ok(answer(
        &request,
        &destination,
        &tally,
        maker,
        &remarks,
        stopped,
        nothing,
    ))
}

/// The flights of the shots. If the request states a ground, the measured roll-outs are compared
/// with the computed roll-outs on this ground.
fn flying(request: &Request, setup: &Setup<f64>, shots: &Shots, of: &[Outcome]) -> Result<Flying> {
    request.refuse_replaced(setup, &shots.other_parameters)?;
    let mut flying = flying_within_tolerance(request, setup, &shots.other_parameters, of)?;
    flying.compares_roll_out = request.gives_ground();
    Ok(flying)
}

/// Refuses a preset name given as the file of shots.
fn refuse_preset(file: &Path) -> Result<()> {
    if Preset::named(&file.to_string_lossy()).is_none() || input_file::exists(file) {
        return Ok(());
    }
    let source = format!(
        "it is a setup; the shots come first, as in longdrive fly shots.csv {}",
        file.display()
    );
    Err(Error::unreadable(file.display().to_string(), source))
}

/// Opens the shots. Refuses a setting of a parameter that the rows give.
fn read_shots(
    file: &Path,
    filter: RowFilter,
    request: &Request,
    setup: &Setup<f64>,
) -> Result<Shots> {
    let shots = Shots::open(setup, file, filter, request.gives_air())?;
    let of_rows = CONDITIONS
        .iter()
        .filter_map(|of| setup.launch_condition(of.name()));
    let of_rows: Vec<_> = of_rows
        .chain(shots.other_parameters.iter().copied())
        .collect();
    request.refuse_stated(&of_rows, "every row has a value of its own")?;
    Ok(shots)
}

fn refuse_no_rows(tally: &ShotStatistics, file: &Path) -> Result<()> {
    if tally.rows > 0 {
        return Ok(());
    }
    let reason = "it has no rows; give a row for each shot";
    Err(Error::table(file.display().to_string(), "", reason))
}

/// Remarks on measured outcomes that are not compared, with advice.
fn not_compared(shots: &Shots, of: &[Outcome], compares_roll_out: bool) -> Vec<Message> {
    let mut remarks = vec![];
    if !compares_roll_out && of.iter().any(|of| of.needs_run() && shots.has(*of)) {
        remarks.push(Message::from(
            "the measured totals are not compared: the ground is not given; name it with \
             `set ground.turf=average`, or another",
        ));
    }
    if of.contains(&Outcome::Carry)
        && shots.has(Outcome::CarryDistance)
        && !of.contains(&Outcome::CarryDistance)
    {
        remarks.push(Message::from(
            "the measured carry is not compared: it is the distance from the tee; name \
             carry_distance with `of`",
        ));
    }
    remarks
}

/// Warns about shots outside of the validity range of the law, and about columns with a likely
/// wrong unit or sign.
fn warn_about_shots(tally: &ShotStatistics, shots: &Shots, law: &Law<f64>) {
    warn(tally.exceeded.warnings(
        law,
        ["shot that landed", "shots that landed"],
        CheckScope::Launch,
    ));
    warn(tally.unit_warnings(shots));
}

/// A remark with the number of rows that are missing in the statistics by club.
fn of_further_clubs(tally: &ShotStatistics) -> Option<Message> {
    (tally.rows_of_further_clubs > 0).then(|| {
        format!(
            "the statistics by club lack {}: they have at most {} clubs; select clubs with `only`",
            counted(tally.rows_of_further_clubs, "row"),
            tally.clubs.len()
        )
        .into()
    })
}

/// The result of [`write_rows`].
struct FlownRows {
    tally: ShotStatistics,
    /// A remark about values that the format cannot store.
    remark: Option<Message>,
}

/// Flies the shots and writes the rows. The caller finishes the output.
fn write_rows(
    output: &mut OutputStream,
    format: FlyFormat,
    flying: &Flying,
    shots: &mut Shots,
    run: &Run<'_>,
) -> Result<FlownRows> {
    let of = flying.outcomes();
    let writer = match format {
        FlyFormat::Csv => ShotWriter::csv(shots, of, system()),
        FlyFormat::LaunchMonitor => ShotWriter::launch_monitor(shots, of, system()),
        FlyFormat::Jsonl => ShotWriter::json_lines(shots, of),
        FlyFormat::OpenConnect => ShotWriter::open_connect(),
        FlyFormat::Screen => ShotWriter::screen(of, system()),
        #[cfg(feature = "parquet")]
        FlyFormat::Parquet => {
            let mut writer = ShotParquet::new(shots, of)?;
            output.write(PARQUET_MAGIC)?;
            let tally = flying.fly(
                shots,
                run,
                |flown| flown,
                |flown| output.write(&writer.push(flown)?),
            )?;
            output.write(&writer.finish()?)?;
            let remark = writer.remark(shots);
            return Ok(FlownRows { tally, remark });
        }
    };
    output.write(&writer.head())?;
    let tally = flying.fly(
        shots,
        run,
        |flown| writer.rows(&flown),
        |bytes| output.write(&bytes),
    )?;
    let remark = writer.remark(shots);
    Ok(FlownRows { tally, remark })
}

/// The note about an interruption: the number of rows before it, and the state of the file.
fn stopped(tally: &ShotStatistics, destination: &Destination) -> String {
    let rows = counted(tally.rows, "row");
    match destination.shown_on_disk() {
        Some(file) => format!("stopped after {rows}; {} is not written", file.display()),
        None => format!("stopped after {rows}"),
    }
}

/// The message that no row was flown, with the error of the first row and the assumed units.
/// `None` if a row was flown.
fn nothing(tally: &ShotStatistics, remarks: &[Message]) -> Option<String> {
    (tally.flown == 0 && tally.rows > 0).then(|| {
        let first = tally.refused.values().min_by_key(|refused| refused.line);
        let first = first.map_or(String::new(), |first| {
            format!("; line {}: {}", first.line, first.reason)
        });
        let remarks = remarks.iter().map(|remark| remark.in_units(system()));
        let units: String = remarks
            .filter(|remark| remark.starts_with(ASSUMED_UNITS))
            .map(|remark| format!("; {remark}"))
            .collect();
        let all = if tally.rows == 1 {
            "the only row could not".into()
        } else {
            format!("none of {} rows could", tally.rows)
        };
        format!("{all} be flown{first}{units}")
    })
}

/// The answer; `stopped` and `nothing` are the reasons for missing rows.
fn answer(
    request: &Request,
    destination: &Destination,
    tally: &ShotStatistics,
    source: Option<&'static str>,
    remarks: &[Message],
    stopped: Option<String>,
    nothing: Option<String>,
) -> Answer {
    let is_answered = stopped.is_none() && nothing.is_none();
    let file = destination
        .shown_on_disk()
        .filter(|_| stopped.is_none())
        .map(|file| file.display().to_string());
    let mut report = ShotsReport::new(tally, source, file, remarks);
    if is_json() {
        let status = match (&stopped, &nothing) {
            (Some(_), _) => "interrupted",
            (None, Some(_)) => "no-answer",
            (None, None) => "done",
        };
        report.ending = Ending {
            status,
            message: stopped.or(nothing),
        };
        return Answer::report(&report, &request.origin_of_shots()).found(is_answered);
    }
    let mut document = report.document(system());
    request
        .origin_of_shots()
        .put_before(&mut document, system());
    let text = text_of(&document);
    for message in stopped.iter().chain(&nothing) {
        say_error(message);
    }
    let answer = match destination.shown_on_disk() {
        Some(file) if is_answered => Answer::text(format!("{text}wrote {}\n", file.display())),
        // standard output already has the rows
        None if destination.kind != DestinationKind::Nowhere => {
            note(&text);
            Answer::text(String::new())
        }
        _ => Answer::text(text),
    };
    answer.found(is_answered)
}
