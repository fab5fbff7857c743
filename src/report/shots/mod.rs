//! Output of flown shots: the rows of an export with their predictions, rows with the columns of a
//! launch monitor, JSON lines, messages of GSPro Open Connect, and a summary as text and JSON.

mod columns;
mod csv;
mod json_lines;
mod open_connect;
#[cfg(feature = "parquet")]
mod parquet;
mod screen;
mod summary;

#[cfg(test)]
pub use json_lines::FlyRow;
pub use open_connect::open_connect_answer;
#[cfg(feature = "parquet")]
pub use parquet::ShotParquet;
pub use summary::{
    BandReport, ClubOutcome, ClubShotsReport, OutcomeResiduals, ShotsReport, SumsReport,
};

use crate::drive::Outcome;
use crate::shots::{Flown, Section, Shots};
use crate::table::columns_remark;
use crate::units::{Message, System};
use columns::LaunchMonitorColumns;
use csv::{ExportRows, PredictionColumns};
use std::borrow::Cow;

/// Beginning of the remark on parameters without a column.
const LATER_PARAMETERS: &str =
    "parameters of later sections, which have no column in the file (JSON lines have them)";

/// Formats flown shots.
#[derive(Clone, Debug)]
pub struct ShotWriter {
    table: ShotFormat,
}

#[derive(Clone, Debug)]
enum ShotFormat {
    Copied(ExportRows),
    Columns(LaunchMonitorColumns),
    JsonLines(json_lines::Keys),
    OpenConnect,
    /// The launch of each shot, and the first requested outcome.
    Screen {
        of: Option<Outcome>,
        system: System,
    },
}

impl ShotWriter {
    /// The rows of the export, unchanged, with added columns for the predictions in the units of
    /// `system`. Shots that came as JSON messages have the columns of
    /// [`launch_monitor`](Self::launch_monitor).
    pub fn csv(shots: &Shots, of: &[Outcome], system: System) -> Self {
        match &shots.columns {
            Some(columns) => Self {
                table: ShotFormat::Copied(ExportRows::new(columns, of, system)),
            },
            None => Self::launch_monitor(shots, of, system),
        }
    }

    /// The columns of a launch monitor, with added columns for the parameters that each row states
    /// and for the predictions, in the units of `system`. The shots may come from an export or from
    /// JSON.
    pub fn launch_monitor(shots: &Shots, of: &[Outcome], system: System) -> Self {
        Self {
            table: ShotFormat::Columns(LaunchMonitorColumns::new(shots, of, system)),
        }
    }

    /// A remark that names the parameters of the rows that the format does not store. Call it after
    /// the last shot.
    pub fn remark(&self, shots: &Shots) -> Option<Message> {
        let later = shots.later_parameters();
        match &self.table {
            ShotFormat::OpenConnect => {
                let first = shots.other_parameters.iter().map(|row| row.name);
                let all: Vec<&str> = first.chain(later).collect();
                let what = "parameters of the rows that a message of Open Connect cannot state; \
                            when the messages are read, the setup's values replace these (JSON \
                            lines have them)";
                columns_remark(what, &all)
            }
            ShotFormat::Columns(_) => columns_remark(LATER_PARAMETERS, &later),
            _ => None,
        }
    }

    /// A JSON object per row, in SI.
    pub fn json_lines(shots: &Shots, of: &[Outcome]) -> Self {
        Self {
            table: ShotFormat::JsonLines(json_lines::Keys::new(shots, of)),
        }
    }

    /// A message of GSPro Open Connect per row.
    pub fn open_connect() -> Self {
        Self {
            table: ShotFormat::OpenConnect,
        }
    }

    /// Six columns of fixed width, for a terminal, in the units of a system.
    pub fn screen(of: &[Outcome], system: System) -> Self {
        Self {
            table: ShotFormat::Screen {
                of: of.first().copied(),
                system,
            },
        }
    }

    /// The first bytes of a file: the column heads, if the format has any.
    pub fn head(&self) -> Vec<u8> {
        match &self.table {
            ShotFormat::Copied(copied) => copied.head(),
            ShotFormat::Columns(columns) => columns.head(),
            ShotFormat::Screen { of, system } => screen::head(*of, *system),
            ShotFormat::JsonLines(_) | ShotFormat::OpenConnect => vec![],
        }
    }

    /// A line for each row. In CSV, every later section of the table begins with its own column
    /// heads.
    pub fn rows(&self, flown: &Flown) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(flown.shots.len() * 400);
        let format = self.of_section(flown.section.as_ref());
        let begins = flown.section.as_ref().is_some_and(|section| section.begins);
        if let (ShotFormat::Copied(copied), true) = (&*format, begins) {
            bytes.extend(copied.head());
        }
        for row in 0..flown.shots.len() {
            match &*format {
                ShotFormat::Copied(copied) => copied.row(flown, row, &mut bytes),
                ShotFormat::Columns(columns) => columns.row(flown, row, &mut bytes),
                ShotFormat::JsonLines(keys) => keys.row(flown, row, &mut bytes),
                ShotFormat::OpenConnect => open_connect::row(flown, row, &mut bytes),
                ShotFormat::Screen { of, system } => {
                    screen::row(*of, *system, flown, row, &mut bytes)
                }
            }
            bytes.push(b'\n');
        }
        bytes
    }

    /// The format with the column heads of a section of the table.
    fn of_section(&self, section: Option<&Section>) -> Cow<'_, ShotFormat> {
        match (&self.table, section) {
            (ShotFormat::Copied(copied), Some(section)) => {
                let PredictionColumns { of, system, .. } = &copied.added;
                Cow::Owned(ShotFormat::Copied(ExportRows::new(
                    &section.columns,
                    of,
                    *system,
                )))
            }
            (ShotFormat::JsonLines(keys), Some(section)) => {
                Cow::Owned(ShotFormat::JsonLines(keys.of_section(section)))
            }
            (format, _) => Cow::Borrowed(format),
        }
    }
}
