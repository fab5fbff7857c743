//! Very many drives, to a file.

mod asked;
mod journal;
mod kept;
#[cfg(feature = "parquet")]
mod parts;
mod points;
mod room;
mod rows;
mod target;

use crate::batch::{Run, Status, Tally};
use crate::command::args::Sweep;
use crate::command::interrupt;
use crate::command::output::{Answer, bar, say_error, tell, warn};
use crate::drive::CheckScope;
use crate::report::Reply;
use crate::units::{Message, counted};
use crate::{Error, Result};
use asked::Asked;
use rows::{Rows, Writer};
use serde::Serialize;
use serde_json::{Map, Value};
use std::path::Path;
use target::Target;

pub fn run(args: &Sweep) -> Result<Answer> {
    if let Some(path) = args
        .check
        .as_deref()
        .or(args.part.and(Some(args.output.as_path())))
    {
        return of_parts(args, path);
    }
    let of_parts = [
        ("`histogram`", &args.histogram),
        ("`highest`", &args.highest),
        ("`lowest`", &args.lowest),
    ];
    if let Some((option, _)) = of_parts.into_iter().find(|(_, given)| !given.is_empty()) {
        let reason =
            "it is kept with a part of a sweep; add `part 1/1` for a sweep in one part".into();
        return Err(Error::Together {
            given: option.into(),
            reason,
        });
    }
    // from here on: all of a table is read before the first drive, which takes a while where it is
    // long
    let stop = interrupt::stops("stopping after the drives under way");
    let request = args.setup_args.request()?;
    let target = Target::new(args, &request)?;
    let Asked {
        setup,
        mut points,
        batch,
        notes,
    } = Asked::of(args, &request)?;
    let of = batch.outcomes().to_vec();
    let writer = Writer::new(&batch, target.format, points.identity())?;
    room::check(args, &batch, points.as_mut(), &writer, &target)?;
    let mut output = target.open(&writer, args)?;
    let mut warnings = setup.warnings();
    warn(&warnings);

    let total = points.rows();
    let bar = bar("drives");
    bar.set_length(total);
    bar.set_position(output.rows());
    bar.reset_eta();
    let run = Run {
        first_row: output.rows(),
        threads: args.threads,
        stop: Some(&stop),
        ..Run::default()
    };
    let done = batch.run(
        points.as_mut(),
        &run,
        |block| writer.rows(block),
        |rows: Rows| {
            bar.inc(rows.rows);
            output.take(rows)
        },
    );
    bar.finish_and_clear();
    let is_complete = done.as_ref().is_ok_and(|done| *done == total);
    // what closing the file says of its rows is the last word
    output.close(is_complete)?;
    done?;

    // until all rows are there they are in a file beside it
    let file = target
        .part()
        .filter(|_| !is_complete)
        .unwrap_or(&args.output);
    let summary = Summary::new(total, output.tally(), notes, file);
    let beyond = output.tally().beyond();
    let beyond = beyond.warnings(
        &setup.law,
        ["drive that landed", "drives that landed"],
        CheckScope::Launch,
    );
    warn(&beyond);
    warnings.extend(beyond);
    if !is_complete {
        let drives = summary.text(None);
        tell(&match target.part() {
            Some(part) => format!(
                "stopped: {drives}; the rows so far are in {}; the same command with `resume` \
                 continues after {}",
                part.display(),
                counted(output.safe(), "row")
            ),
            None => format!("stopped: {drives}; with `output FILE` it could be resumed"),
        });
    }
    let nothing = (is_complete && !output.tally().has_any(&of)).then(|| {
        let which = if of.len() == 1 {
            "the outcome"
        } else {
            "any of the outcomes"
        };
        let diverged = if output
            .tally()
            .counts()
            .any(|(status, count)| status == Status::Diverged && count > 0)
        {
            "; simulate with the values of one that diverged says what to change"
        } else {
            ""
        };
        format!(
            "no drive has {which} that was asked for: {}{diverged}",
            summary.text(None)
        )
    });
    if let Some(nothing) = &nothing {
        say_error(nothing);
    }
    let is_answered = is_complete && nothing.is_none();
    // the rows of a file are counted on standard output
    let all_landed = output
        .tally()
        .counts()
        .all(|(status, count)| status == Status::Landed || count == 0);
    if is_answered && !all_landed && target.is_standard_output() {
        tell(&summary.text(None));
    }
    Ok(match (request.is_json(), target.is_standard_output()) {
        (true, _) => {
            let reply = Reply::done("sweep", warnings, &summary);
            let stopped = || Some(format!("stopped: {}", summary.text(None)));
            Answer::json(&match (is_complete, nothing) {
                (true, None) => reply,
                (true, nothing) => reply.ended("no-answer", nothing),
                (false, _) => reply.ended("interrupted", stopped()),
            })
        }
        (false, false) if is_complete => Answer::text(summary.text(target.file()) + "\n"),
        _ => Answer::text(String::new()),
    }
    .found(is_answered))
}

/// Writes a part of a sweep, or looks through those in a folder.
#[cfg(feature = "parquet")]
fn of_parts(args: &Sweep, folder: &Path) -> Result<Answer> {
    match args.part {
        Some(part) => parts::write(args, part, folder),
        None => parts::check(args, folder),
    }
}

/// The same where there is no Parquet.
#[cfg(not(feature = "parquet"))]
fn of_parts(_: &Sweep, folder: &Path) -> Result<Answer> {
    Err(crate::command::files::refused(
        folder,
        crate::features::how_to_get("parquet"),
    ))
}

/// What a sweep did, as JSON.
#[derive(Serialize)]
struct Summary {
    /// Where the rows are.
    file: String,
    /// Rows of the whole sweep.
    rows: u64,
    /// Rows that are written.
    written: u64,
    /// How many of them ended how.
    statuses: Map<String, Value>,
    /// What deserves a word about where the points come from.
    remarks: Vec<Message>,
}

impl Summary {
    fn new(rows: u64, tally: Tally, remarks: Vec<Message>, file: &Path) -> Self {
        let statuses = tally
            .counts()
            .map(|(status, count)| (status.name().into(), count.into()))
            .collect();
        let written = tally.counts().map(|(_, count)| count).sum();
        Self {
            file: file.display().to_string(),
            rows,
            written,
            statuses,
            remarks,
        }
    }

    fn text(&self, file: Option<&Path>) -> String {
        let counts = self
            .statuses
            .iter()
            .filter(|(_, count)| count.as_u64() != Some(0));
        let counts: Vec<_> = counts
            .map(|(status, count)| format!("{count} {status}"))
            .collect();
        let file = file.map_or(String::new(), |file| format!(" in {}", file.display()));
        // "1 drive", "2 drives", "1 of 2 drives"
        let drives = counted(self.rows, "drive");
        let written = if self.written == self.rows {
            drives
        } else {
            format!("{} of {drives}", self.written)
        };
        format!("{written}{file}: {}", counts.join(", "))
    }
}
