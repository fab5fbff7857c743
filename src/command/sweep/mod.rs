//! Writes very many drives to a file.

mod args;
mod disk_space;
mod journal;
#[cfg(feature = "parquet")]
pub mod parts;
mod request;
mod resumable;
mod rows;
mod target;

pub use args::Args;

use crate::batch::{Batch, Points, Run, Status, StatusCounts, SweepDefinition};
use crate::command::args::{refuse_threads, stated};
#[cfg(not(feature = "parquet"))]
use crate::command::files::refused;
use crate::command::files::{Destination, DestinationKind};
use crate::command::interrupt;
use crate::command::output::{
    Answer, bar, is_json, note, say_error, stated_system, warn, warnings,
};
use crate::command::rows_target::RowsTarget;
use crate::report::{Ending, Reply};
use crate::units::{Message, counted};
use crate::{Error, Outcome, Result};
use args::SweepFormat;
use journal::JournalHeader;
use request::SweepRequest;
use resumable::part_of;
use rows::{FormattedRows, RowFormatter};
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use target::{SweepOutput, destination};

pub fn run(args: &Args) -> Result<Answer> {
    refuse_threads(args.threads)?;
    let folder = args.part.and(Some(args.output.as_path()));
    match args.check.as_deref().or(folder) {
        #[cfg(feature = "parquet")]
        Some(folder) => match args.part {
            Some(part) => parts::write(args, part, folder),
            None => parts::check(args, folder),
        },
        #[cfg(not(feature = "parquet"))]
        Some(folder) => Err(refused(folder, crate::features::how_to_get("parquet"))),
        None => whole_sweep(args),
    }
}

/// Writes all rows into one file, or to standard output.
fn whole_sweep(args: &Args) -> Result<Answer> {
    refuse_options_of_parts(args)?;
    // interruptible from here on: reading a long table takes time before the first drive
    let work = interrupt::enable("stopping after the drives under way");
    let request = args.setup_args.request()?;
    let target = RowsTarget::new(&args.output, args.overwrite)?;
    let format = target.format(args.format, SweepFormat::Csv)?;
    let destination = destination(args, &request, target)?;
    let SweepRequest { mut points, batch } = SweepRequest::of(args, &request)?;
    let definition = SweepDefinition::new(&batch, points.as_ref(), String::new(), 1);
    let formatter = RowFormatter::new(&batch, format, &definition)?;
    disk_space::check(
        args,
        &batch,
        points.as_mut(),
        &formatter,
        destination.file(),
    )?;
    let header = JournalHeader {
        definition,
        format: match (format, stated_system()) {
            (SweepFormat::Csv, Some(system)) => format!("csv in {system} units"),
            _ => format!("{format:?}").to_lowercase(),
        },
        overwrite: args.overwrite,
    };
    let mut output = SweepOutput::open(&destination, header, &formatter, args.resume)?;
    let total = points.rows();
    let is_complete = write_rows(
        args,
        &batch,
        points.as_mut(),
        &formatter,
        &mut output,
        &work.stop,
    )?;
    let counts = output.status_counts();
    // an incomplete file has the name FILE.part
    let part = destination.file().filter(|_| !is_complete).map(part_of);
    let file = part.as_deref().unwrap_or(&args.output);
    let summary = SweepSummary {
        counts: counts.clone(),
        file: file.display().to_string(),
        rows: total,
        written: counts.total(),
        statuses: counts.counts().collect(),
        remarks: points.notes(),
    };
    warn(counts.warnings(&batch.setup().law));
    if !is_complete {
        note(&stopped(&summary, &output));
    }
    let nothing = (is_complete && !counts.has_any(batch.outcomes()))
        .then(|| no_outcome(&summary, batch.outcomes()));
    Ok(answer(&summary, &destination, is_complete, nothing))
}

/// The answer; `nothing` is the reason if no drive has an outcome.
fn answer(
    summary: &SweepSummary,
    destination: &Destination,
    is_complete: bool,
    nothing: Option<String>,
) -> Answer {
    if let Some(nothing) = &nothing {
        say_error(nothing);
    }
    let is_answered = is_complete && nothing.is_none();
    let is_standard_output = destination.kind == DestinationKind::StandardOutput;
    // standard output contains the rows: report the counts of drives that did not land as a note
    let all_landed = summary.counts.count(Status::Landed) == summary.written;
    if is_answered && is_standard_output && !all_landed {
        note(&summary.text(None));
    }
    let answer = if is_json() {
        let ending = match (is_complete, nothing) {
            (true, None) => Ending::DONE,
            (true, Some(nothing)) => Ending {
                status: "no-answer",
                message: Some(nothing),
            },
            (false, _) => Ending {
                status: "interrupted",
                message: Some(format!("stopped: {}", summary.text(None))),
            },
        };
        Answer::json(&Reply::done("sweep", warnings(), summary).ended(ending))
    } else if is_complete && !is_standard_output {
        let file = destination.file().and(destination.shown_on_disk());
        Answer::text(summary.text(file) + "\n")
    } else {
        Answer::text(String::new())
    };
    answer.found(is_answered)
}

/// Refuses options that apply only to a part of a sweep if the request writes no part.
fn refuse_options_of_parts(args: &Args) -> Result<()> {
    let options = [
        ("`histogram`", !args.histogram.is_empty()),
        ("`highest`", !args.highest.is_empty()),
        ("`lowest`", !args.lowest.is_empty()),
    ];
    match stated(options).next() {
        Some(option) => Err(Error::Together {
            given: option.into(),
            reason: "it applies only to a part of a sweep; add `part 1/1` for a sweep in one part"
                .into(),
        }),
        None => Ok(()),
    }
}

/// Computes the rows and writes them. Returns true if the rows are complete.
fn write_rows(
    args: &Args,
    batch: &Batch,
    points: &mut dyn Points,
    formatter: &RowFormatter,
    output: &mut SweepOutput<'_>,
    stop: &AtomicBool,
) -> Result<bool> {
    let total = points.rows();
    let bar = bar("drives");
    bar.set_length(total);
    bar.set_position(output.recorded_rows());
    bar.reset_eta();
    let run = Run {
        first_row: output.recorded_rows(),
        threads: args.threads,
        stop: Some(stop),
        ..Run::default()
    };
    let done = batch.run(
        points,
        &run,
        |block| formatter.rows(block),
        |rows: FormattedRows| {
            bar.inc(rows.count());
            output.push(rows)
        },
    );
    bar.finish();
    let is_complete = done.as_ref().is_ok_and(|done| *done == total);
    // an error on closing the file has precedence over an error of the rows
    output.close(is_complete)?;
    done?;
    Ok(is_complete)
}

/// The note about an interrupted sweep, with the command to continue it.
fn stopped(summary: &SweepSummary, output: &SweepOutput<'_>) -> String {
    let drives = summary.text(None);
    match output {
        SweepOutput::Resumable(file) => format!(
            "stopped: {drives}; the rows so far are in {}; {} continues after {}",
            summary.file,
            file.resuming_command(),
            counted(file.recorded_rows, "row")
        ),
        SweepOutput::Stream { .. } => {
            format!("stopped: {drives}; a sweep with `output FILE` can be resumed")
        }
    }
}

/// The error of a sweep in which no drive has a requested outcome.
fn no_outcome(summary: &SweepSummary, of: &[Outcome]) -> String {
    let which = if of.len() == 1 {
        "the requested outcome"
    } else {
        "any of the requested outcomes"
    };
    let diverged = if summary.counts.count(Status::Diverged) > 0 {
        "; simulate one of the diverged drives to see what to change"
    } else {
        ""
    };
    format!("no drive has {which}: {}{diverged}", summary.text(None))
}

/// The result of a sweep, as JSON.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct SweepSummary {
    /// Numbers of drives by status, for the text.
    #[serde(skip)]
    counts: StatusCounts,
    /// The file with the rows; `FILE.part` if the sweep was interrupted.
    file: String,
    /// Number of rows of the whole sweep.
    rows: u64,
    /// Number of rows that are written.
    written: u64,
    /// Number of drives by status.
    statuses: BTreeMap<Status, u64>,
    /// Remarks about unused columns of the table of points; empty if there are none.
    remarks: Vec<Message>,
}

impl SweepSummary {
    fn text(&self, file: Option<&Path>) -> String {
        let file = file.map_or(String::new(), |file| format!(" in {}", file.display()));
        // "1 drive", "2 drives", "1 of 2 drives"
        let drives = counted(self.rows, "drive");
        let written = if self.written == self.rows {
            drives
        } else {
            format!("{} of {drives}", self.written)
        };
        if self.written == 0 {
            return format!("{written}{file}");
        }
        format!("{written}{file}: {}", self.counts)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sweep_stopped_before_its_first_row_lists_no_statuses() {
        let summary = SweepSummary {
            counts: StatusCounts::default(),
            file: "a.csv".into(),
            rows: 1200,
            written: 0,
            statuses: BTreeMap::new(),
            remarks: vec![],
        };
        assert_eq!(summary.text(None), "0 of 1200 drives");
    }
}
