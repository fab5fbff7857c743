//! A sweep divided into parts, each with its own file.

use super::args::{Args, PartOf};
use super::request::SweepRequest;
use crate::batch::{Batch, Points, Run, SweepDefinition};
use crate::command::args::stated;
use crate::command::files::{refused, unwritable};
use crate::command::interrupt;
use crate::command::output::{Answer, bar, is_json, note, system, text_of, warn, warnings};
use crate::input_file::is_in_memory;
use crate::parameters::DEFAULT_PRESET;
use crate::parts::{self, Checked, Dataset, Manifest, PartResult};
use crate::report::{Ending, Reply, summary_document};
use crate::statistics::{Histogram, Ranking};
use crate::units::{Message, counted};
use crate::{Error, Outcome, Result};
use serde::Serialize;
use std::io::ErrorKind;
use std::path::Path;

/// A completed part, as JSON.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct WrittenPart {
    /// The folder.
    folder: String,
    #[serde(flatten)]
    manifest: Manifest,
    /// Remarks about the source of the points.
    remarks: Vec<Message>,
}

/// Writes a part.
pub fn write(args: &Args, part: PartOf, folder: &Path) -> Result<Answer> {
    let work =
        interrupt::enable("stopping after the drives under way; nothing of the part is kept");
    let request = args.setup_args.request()?;
    let SweepRequest { mut points, batch } = SweepRequest::of(args, &request)?;
    let setup = *batch.setup();
    let dataset = dataset_of(args, batch, points.as_ref(), part.parts)?;
    let rows = parts::rows_of(part.part, part.parts, points.rows())?;
    make(folder)?;
    let bar = bar("drives");
    bar.set_length(rows.end - rows.start);
    let run = Run {
        threads: args.threads,
        stop: Some(&work.stop),
        ..Run::default()
    };
    let progress = |done| bar.set_position(done);
    let written = dataset.write(
        points.as_mut(),
        part.part,
        folder,
        &run,
        args.overwrite,
        progress,
    );
    bar.finish();
    let (manifest, is_new) = match written? {
        PartResult::New(manifest) => (manifest, true),
        PartResult::Existing(manifest) => (manifest, false),
        PartResult::Stopped => return Ok(stopped(part)),
    };
    warn(manifest.part.summary.status_counts.warnings(&setup.law));
    let there = (!is_new)
        .then(|| "it existed already, complete and of the same sweep, and is kept".to_owned());
    if is_json() {
        let body = WrittenPart {
            folder: folder.display().to_string(),
            manifest,
            remarks: points.notes(),
        };
        let ending = Ending {
            status: "done",
            message: there,
        };
        let reply = Reply::done("sweep", warnings(), body).ended(ending);
        return Ok(Answer::json(&reply));
    }
    Ok(Answer::text(written_text(part, folder, &manifest, there)))
}

/// A text such as "part 1 of 8: 1000 drives in sweep/part-1.parquet".
fn written_text(part: PartOf, folder: &Path, manifest: &Manifest, there: Option<String>) -> String {
    let drives = counted(manifest.part.rows, "drive");
    let path = folder.join(&manifest.file);
    let there = there.map_or(String::new(), |there| format!("; {there}"));
    format!(
        "part {} of {}: {drives} in {}{there}\n",
        part.part,
        part.parts,
        path.display()
    )
}

/// The answer for an interrupted part.
fn stopped(PartOf { part, parts }: PartOf) -> Answer {
    let message = format!(
        "stopped: nothing of part {part} of {parts} is kept; the same command begins it again"
    );
    note(&message);
    let answer = if is_json() {
        Answer::none("interrupted", message)
    } else {
        Answer::text(String::new())
    };
    answer.found(false)
}

/// The sweep that the options describe, divided into parts.
fn dataset_of(args: &Args, batch: Batch, points: &dyn Points, parts: u64) -> Result<Dataset> {
    let histograms = args.histogram.iter().map(|text| Histogram::read(text));
    let histograms = histograms.collect::<Result<_>>()?;
    let highest = args.highest.iter().map(|text| Ranking::read(text, true));
    let lowest = args.lowest.iter().map(|text| Ranking::read(text, false));
    let best = highest.chain(lowest).collect::<Result<_>>()?;
    Dataset::new(batch, points, parts, histograms, best)
}

/// Creates the folder of the parts. Another process may create it at the same time.
fn make(folder: &Path) -> Result<()> {
    if folder == Path::new("-") {
        return Err(refused(
            folder,
            "a part is written into a folder; name one with `output`, as in `output parts`",
        ));
    }
    let is_file = || {
        let reason = "it is a file; name a folder, into which the parts are written";
        Err(refused(folder, reason))
    };
    if is_in_memory(folder) {
        return is_file();
    }
    match std::fs::create_dir(folder) {
        Ok(()) => Ok(()),
        Err(error) if error.kind() == ErrorKind::AlreadyExists && folder.is_dir() => Ok(()),
        Err(error) if error.kind() == ErrorKind::AlreadyExists => is_file(),
        Err(error) => Err(unwritable(folder, &error)),
    }
}

/// Checks the parts in a folder.
pub fn check(args: &Args, folder: &Path) -> Result<Answer> {
    let wanted = wanted(args)?;
    let checked = parts::check(folder, wanted.as_ref(), args.hash)?;
    if let (Some(wanted), Some(_)) = (&wanted, args.instructions)
        && wanted.instructions != checked.definition.instructions
    {
        let reason = format!(
            "its parts are computed with the instructions {}, and not {}",
            checked.definition.instructions, wanted.instructions
        );
        return Err(refused(folder, reason));
    }
    let (is_complete, lines) = (checked.is_complete(), sentences(&checked));
    if is_json() {
        let ending = match is_complete {
            true => Ending::DONE,
            false => Ending {
                status: "partial",
                message: Some(lines.join("; ")),
            },
        };
        let reply = Reply::done("sweep", warnings(), checked).ended(ending);
        return Ok(Answer::json(&reply).found(is_complete));
    }
    let text = lines.join("\n") + "\n\n" + &text_of(&summary_document(&checked.summary, system()));
    Ok(Answer::text(text).found(is_complete))
}

/// The definition of the sweep that the options describe; `None` without points.
fn wanted(args: &Args) -> Result<Option<SweepDefinition>> {
    if args.over.is_empty() && args.points.is_none() {
        return refuse_without_points(args).map(|()| None);
    }
    let SweepRequest { points, batch, .. } = SweepRequest::of(args, &args.setup_args.request()?)?;
    // 1 is a placeholder: the files determine the number of parts
    let dataset = dataset_of(args, batch, points.as_ref(), 1)?;
    Ok(Some(dataset.definition))
}

/// Refuses options of a sweep if its points are not given: without points, the parts are not
/// compared with the options.
fn refuse_without_points(args: &Args) -> Result<()> {
    let drive = &args.setup_args.drive;
    let options = [
        ("`set`", !drive.set.is_empty()),
        ("`launch`", !drive.launch.is_empty()),
        ("`sample`", args.sample.is_some()),
        ("`outcomes`", args.outcomes != [Outcome::Carry.name()]),
        ("`gradient`", args.gradient),
        ("`wrt`", !args.wrt.is_empty()),
        ("`histogram`", !args.histogram.is_empty()),
        ("`highest`", !args.highest.is_empty()),
        ("`lowest`", !args.lowest.is_empty()),
        ("`instructions`", args.instructions.is_some()),
        ("`tolerance`", args.setup_args.tolerance.is_some()),
        ("`own_step`", args.setup_args.own_step),
    ];
    let short_name = drive.short_names().next();
    let short_name = short_name.map(|(option, ..)| format!("`{option}`"));
    let setup = (drive.setup != DEFAULT_PRESET).then(|| format!("the setup {}", drive.setup));
    let mut unused = stated(options)
        .map(str::to_owned)
        .chain(short_name)
        .chain(setup);
    match unused.next() {
        None => Ok(()),
        Some(unused) => Err(Error::Together {
            given: format!("`check` with {unused}"),
            reason: format!(
                "the parts are compared with the options only if the swept parameters are given; \
                 give them with `over` or `points`, or leave {unused} out"
            ),
        }),
    }
}

/// The present and missing parts, as sentences.
fn sentences(checked: &Checked) -> Vec<String> {
    let Checked {
        definition,
        present,
        missing,
        faults,
        unfinished,
        rows,
        bytes,
        sha256,
        ..
    } = checked;
    let mut lines = vec![match checked.is_complete() {
        true => format!(
            "complete: {} of {}, {bytes} bytes, computed with the processor instructions {}",
            counted(*present, "part"),
            counted(*rows, "drive"),
            definition.instructions
        ),
        false if *present == definition.parts => format!(
            "{} are present and valid, but the folder has other files too; remove the files that \
             are no part of the sweep",
            counted(*present, "part")
        ),
        false => format!(
            "not complete: {present} of {} are present and valid",
            counted(definition.parts, "part")
        ),
    }];
    if !missing.is_empty() {
        lines.push(format!("missing: {}", ranges(missing)));
    }
    lines.extend(
        faults
            .iter()
            .map(|fault| format!("{}: {}", fault.file, fault.reason)),
    );
    if !unfinished.is_empty() {
        lines.push(format!(
            "{} left by writers that are running or were killed; delete them if no writer is running",
            counted(unfinished.len() as u64, "file")
        ));
    }
    lines.extend(
        sha256
            .as_ref()
            .map(|hash| format!("SHA-256 of the set: {hash}")),
    );
    lines
}

/// Numbers in the syntax of job arrays: `3,17-20`.
fn ranges(numbers: &[u64]) -> String {
    let range = |run: &[u64]| match run {
        [first, .., last] => format!("{first}-{last}"),
        single => single.iter().map(u64::to_string).collect(),
    };
    let runs = numbers.chunk_by(|before, number| before + 1 == *number);
    runs.map(range).collect::<Vec<_>>().join(",")
}
