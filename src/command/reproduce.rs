use crate::Result;
use crate::command::files::{Folder, OutputRule};
use crate::command::output::{Answer, is_json, note, stated_system, text_of, warnings};
use crate::report::{
    InBoth, Mae494Report, Reply, Report, TextFile, WinfieldTanReport, document_files,
};
use crate::reproduce::{Mae494, WinfieldTan, mae494, winfield_tan};
use crate::units::{System, counted};
use std::path::PathBuf;

/// Names of the files that every document has.
pub const DOCUMENT: [&str; 2] = ["report.md", "index.html"];

#[derive(clap::Args)]
pub struct Args {
    /// The study.
    #[arg(value_enum, value_name = "STUDY")]
    pub study: PublishedStudy,

    /// Print the answer as JSON (SI units and radians), and nothing else, to standard output.
    #[arg(long)]
    pub json: bool,

    /// Write the study into this folder too: a page (index.html), Markdown, and every plot as SVG
    /// with its data as CSV.
    #[arg(long, short, value_name = "DIR")]
    pub output: Option<PathBuf>,

    /// Replace files that exist.
    #[arg(long, requires = "output")]
    pub overwrite: bool,
}

/// A study that can be reproduced.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum PublishedStudy {
    /// The student report "Optimization of a Golf Driver", MAE 494.
    Mae494,
    /// Winfield & Tan (1994), "Optimization of clubhead loft and swing elevation angles".
    WinfieldTan,
}

pub fn run(args: &Args) -> Result<Answer> {
    let rule = OutputRule::new([], args.overwrite);
    let folder = args
        .output
        .as_ref()
        .map(|folder| rule.folder(folder, &DOCUMENT))
        .transpose()?;
    let computing = |what: &str| note(&format!("computing {what}"));
    match args.study {
        PublishedStudy::Mae494 => {
            let found = mae494(computing)?;
            answer(&Mae494Report::new(&found), Mae494::UNITS, folder.as_ref())
        }
        PublishedStudy::WinfieldTan => {
            let found = winfield_tan(computing)?;
            answer(
                &WinfieldTanReport::new(&found),
                WinfieldTan::UNITS,
                folder.as_ref(),
            )
        }
    }
}

/// Writes the report of a study if a folder is given, and returns the answer. The default units are
/// the study's.
fn answer(report: &impl Report, units: System, folder: Option<&Folder>) -> Result<Answer> {
    let system = stated_system().unwrap_or(units);
    if let Some(folder) = folder {
        write(folder, report, system)?;
    }
    if is_json() {
        return Ok(Answer::json(&Reply::of(report, warnings())));
    }
    Ok(Answer::text(text_of(&report.document(system))))
}

/// Writes the document of a report with its figures and their data into a folder.
pub fn write(folder: &Folder, report: &impl Report, system: System) -> Result<()> {
    let mut files = document_files(&InBoth::of(|system| report.document(system)), system)?;
    files.push(TextFile {
        name: DOCUMENT[0].into(),
        text: report.document(system).markdown(),
    });
    let count = folder.write(
        files
            .iter()
            .map(|TextFile { name, text }| (name.as_str(), text.as_bytes())),
    )?;
    note(&format!(
        "wrote {} into {}",
        counted(count as u64, "file"),
        folder.path.display()
    ));
    Ok(())
}
