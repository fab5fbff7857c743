//! Collects the rows of a table of measured shots: shots, and messages about rejected rows.

use super::reading::{Reading, Row, Values, Wrong};
use super::shot::Shot;
use super::shot_table::ShotTable;
use crate::error::{Error, Result};
use crate::parameters::Parameter;
use crate::shots::Shot as Stated;
use crate::table::{
    ClubColumns, DecimalMarks, NonShot, NonShotRows, Record, air_of_rows, air_of_setup, cells,
    miscounted,
};
use crate::units::{Message, counted};
use std::collections::BTreeMap;

/// Row numbers by message.
type RowsByMessage = BTreeMap<String, Vec<String>>;

/// Rows read so far.
pub(super) struct Rows {
    file: String,
    /// The number of the last row.
    row: usize,
    shots: Vec<Shot>,
    no_shots: NonShotRows,
    messages: Vec<String>,
    incomplete: Vec<String>,
    unreadable: Vec<String>,
    /// Lateral columns that are not compared because the direction or the tilt is assumed.
    sideways: RowsByMessage,
    /// Columns of the club without a usable value.
    not_stated: RowsByMessage,
    contradictions: Vec<String>,
    implausible: Vec<String>,
    airless: Vec<String>,
    of_sections: Vec<Message>,
    /// Error of the first incomplete row of a table that is no export.
    lacking: Option<Error>,
    marks: DecimalMarks,
}

impl Rows {
    pub fn new(file: &str) -> Self {
        Self {
            file: file.into(),
            row: 0,
            shots: vec![],
            no_shots: NonShotRows::default(),
            messages: vec![],
            incomplete: vec![],
            unreadable: vec![],
            sideways: RowsByMessage::new(),
            not_stated: RowsByMessage::new(),
            contradictions: vec![],
            implausible: vec![],
            airless: vec![],
            of_sections: vec![],
            lacking: None,
            marks: DecimalMarks::default(),
        }
    }

    fn refused(&self, place: &str, reason: String) -> Error {
        Error::Table {
            file: self.file.clone(),
            place: format!(", row {}{place}", self.row),
            reason,
        }
    }

    /// Begins a section with another head.
    pub fn begin(&mut self, line: u64, reading: &Reading) {
        let told = |remark: &Message| {
            Message::from(format!("from line {line} on: ")).message(remark.clone())
        };
        self.of_sections.extend(reading.remarks.iter().map(told));
    }

    /// Takes a row of text.
    ///
    /// # Errors
    /// [`Error::Table`] for what is wrong in a table of one's own, and for a number whose decimal
    /// mark is uncertain.
    pub fn take(&mut self, reading: &Reading, record: &Record, separator: u8) -> Result<()> {
        self.row += 1;
        let row = cells(&record.text, separator);
        let unclosed = record.unclosed();
        if let Some(no_shot) = NonShot::of(&row).filter(|_| reading.is_export && unclosed.is_none())
        {
            self.no_shots.add(self.row as u64, no_shot);
            return Ok(());
        }
        match unclosed.or_else(|| miscounted(&row, reading.columns.len())) {
            Some(wrong) if reading.is_export => {
                self.unreadable
                    .push(format!("row {} ({})", self.row, wrong.reason));
                return Ok(());
            }
            Some(wrong) => return Err(self.refused("", wrong.reason)),
            None => {}
        }
        for (column, cell) in reading.columns.iter().zip(&row) {
            let looked = self.marks.check(self.row as u64, column, cell);
            looked.map_err(|reason| self.refused(&format!(", column {}", column.head), reason))?;
        }
        let row: Vec<&str> = row.iter().map(AsRef::as_ref).collect();
        self.add(reading, reading.shot(self.row, Values::Cells(&row)))
    }

    /// Takes a message.
    pub fn take_shot(&mut self, reading: &Reading, shot: &Stated, further: &[&'static Parameter]) {
        self.row += 1;
        if let Some(refusal) = shot.refusal() {
            self.messages.push(format!(
                "row {} (line {}: {})",
                self.row, shot.line, refusal.reason
            ));
            return;
        }
        let numbers = reading.numbers(shot, further);
        // what is wrong in an export stops nothing
        let _ = self.add(reading, reading.shot(self.row, Values::Numbers(&numbers)));
    }

    fn add(&mut self, reading: &Reading, read: std::result::Result<Row, Wrong>) -> Result<()> {
        let row = self.row;
        let wrong = match read {
            Ok(Row {
                shot,
                not_compared,
                contradiction,
                implausible,
                no_air,
                not_stated,
            }) => {
                self.airless
                    .extend(no_air.map(|why| format!("row {row}: {}", air_of_setup(&why))));
                self.implausible.extend(
                    implausible
                        .into_iter()
                        .map(|why| format!("row {row}: not compared: {why}")),
                );
                if let Some(head) = not_compared.filter(|_| reading.club == ClubColumns::Ignored) {
                    self.sideways
                        .entry(head)
                        .or_default()
                        .push(format!("row {row}"));
                }
                for why in not_stated {
                    self.not_stated
                        .entry(why)
                        .or_default()
                        .push(format!("row {row}"));
                }
                self.contradictions
                    .extend(contradiction.map(|told| format!("row {row}: {told}")));
                self.shots.push(shot);
                return Ok(());
            }
            Err(wrong) => wrong,
        };
        if wrong.is_incomplete {
            if !reading.is_export {
                let column = wrong
                    .column
                    .as_ref()
                    .map_or(String::new(), |name| format!(", column {name}"));
                let lacking = self.refused(&column, wrong.why);
                self.lacking.get_or_insert(lacking);
            }
            let column = wrong.column.unwrap_or_else(|| "nothing is measured".into());
            self.incomplete.push(format!("row {row} ({column})"));
            return Ok(());
        }
        if reading.is_export {
            let column = wrong
                .column
                .map_or(String::new(), |name| format!("{name}: "));
            self.unreadable
                .push(format!("row {row} ({column}{})", wrong.why));
            return Ok(());
        }
        let column = wrong
            .column
            .map_or(String::new(), |name| format!(", column {name}"));
        Err(self.refused(&column, wrong.why))
    }

    /// Messages about rejected rows.
    fn left_out(&self) -> Vec<String> {
        let mut told = self.no_shots.messages();
        let others = [
            (
                &self.incomplete,
                "rows left out, since they lack a value that every shot needs",
            ),
            (&self.unreadable, "rows left out, since they cannot be used"),
            (&self.messages, "messages that are no shots are left out"),
        ];
        told.extend(
            others
                .into_iter()
                .filter(|(rows, _)| !rows.is_empty())
                .map(|(rows, what)| format!("{what}: {}", rows.join(", "))),
        );
        told
    }

    /// Builds the table; `reading` belongs to the first section.
    ///
    /// # Errors
    /// [`Error::Table`] without a shot.
    pub fn table(mut self, reading: Reading) -> Result<ShotTable> {
        let left_out = self.left_out();
        if self.shots.is_empty() {
            // of a table of one's own the first row says best what is wanted
            if let Some(first) = self.lacking {
                return Err(first);
            }
            let reason = match left_out.is_empty() {
                true => "it has no rows; give one for each shot".into(),
                false => format!(
                    "no shot is left in it ({}); give a row for each shot",
                    left_out.join("; ")
                ),
            };
            return Err(Error::Table {
                file: self.file,
                place: String::new(),
                reason,
            });
        }
        let left_out = left_out.into_iter().map(Message::from);
        let mut warnings: Vec<Message> = if reading.is_export {
            vec![]
        } else {
            left_out.clone().collect()
        };
        if let Some(first) = self.contradictions.first().filter(|_| !reading.is_export) {
            let others = self.contradictions.len() - 1;
            let others = if others > 0 {
                format!(" (so in {})", counted(others as u64, "other row"))
            } else {
                String::new()
            };
            warnings.push(format!("{first}{others}").into());
        }
        let mut remarks = reading.remarks.clone();
        remarks.append(&mut self.of_sections);
        remarks.extend(left_out);
        remarks.extend(self.sideways.into_iter().map(|(head, rows)| {
            let why = "in rows without a measured launch direction or spin axis (or sidespin)";
            format!("{head} is not compared {why}: {}", rows.join(", ")).into()
        }));
        remarks.extend(self.not_stated.into_iter().map(|(why, rows)| {
            format!(
                "{why}; what is known before the shot stands for it: {}",
                rows.join(", ")
            )
            .into()
        }));
        remarks.extend(self.implausible.into_iter().map(Message::from));
        remarks.extend(self.contradictions.into_iter().map(Message::from));
        let stated_air = reading
            .columns
            .iter()
            .find(|column| column.is_stated_air())
            .map(|column| column.head.clone());
        remarks.extend(stated_air.iter().map(|head| air_of_rows(head).into()));
        remarks.extend(self.airless.into_iter().map(Message::from));
        let (assumed, uncertainties) = reading.assumed(&self.shots);
        remarks.extend(assumed);
        let launch_beside_club = reading.launch_beside_club();
        Ok(ShotTable {
            file: self.file,
            shots: self.shots,
            is_launched: reading.is_launched,
            remarks,
            warnings,
            launch_beside_club,
            uncertainties,
            stated_air,
        })
    }
}
