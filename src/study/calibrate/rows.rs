//! Collects the rows of a table: shots, and messages about rejected rows.

use super::reading::{ReadRow, Reading, RowError};
use super::shot_table::{MeasuredShot, ShotTable};
use super::statistics::SigmaOrigin;
use crate::error::{Error, Result};
use crate::parameters::Parameter;
use crate::shots::Shot;
use crate::table::{
    Content, NonShotRows, Record, RowFault, RowFilter, air_of_rows, air_of_setup, cells,
    columns_remark, counted_values, remark_from_line,
};
use crate::units::{Message, counted};
use std::collections::BTreeMap;

/// A section of a table: the rows below one line of column heads.
struct TableSection {
    /// Line of the column heads; `None` for the first section.
    line: Option<u64>,
    reading: Reading,
    /// Index of the section's first shot.
    first_shot: usize,
}

impl TableSection {
    /// The remark. In a later section, it begins with the line number of the section's column
    /// heads.
    fn remark(&self, remark: &Message) -> Message {
        match self.line {
            Some(line) => remark_from_line(line, remark),
            None => remark.clone(),
        }
    }
}

/// Rows read so far.
#[derive(Default)]
pub(super) struct ShotRows {
    file: String,
    /// Number of the last row read.
    row: usize,
    shots: Vec<MeasuredShot>,
    no_shots: NonShotRows,
    refused_messages: Vec<String>,
    /// Number of shots by the name of the club. In a table without a column of clubs, the last
    /// title above a shot names the club.
    clubs: BTreeMap<String, u64>,
    /// The last title above the current row.
    title: Option<String>,
    incomplete: Vec<String>,
    unreadable: Vec<String>,
    /// Lateral columns, each with the rows in which it is not compared because the launch direction
    /// or the spin axis is assumed.
    uncompared_laterals: BTreeMap<String, Vec<String>>,
    /// Messages on columns of the club without a usable value, with their rows.
    not_stated: BTreeMap<String, Vec<String>>,
    contradictions: Vec<String>,
    implausible: Vec<String>,
    rows_without_air: Vec<String>,
    sections: Vec<TableSection>,
    /// Error of the first incomplete row of a table that is not an export.
    first_incomplete: Option<Error>,
}

impl ShotRows {
    /// A collection without rows. `title` is the title above the column heads.
    pub fn new(file: &str, title: Option<String>) -> Self {
        Self {
            file: file.into(),
            title,
            ..Self::default()
        }
    }

    fn refused(&self, place: &str, reason: String) -> Error {
        Error::table(&self.file, format!(", row {}{place}", self.row), reason)
    }

    /// Begins a section of the table. `line` is the line of its column heads; `None` for the first
    /// section.
    pub fn begin(&mut self, line: Option<u64>, reading: &Reading) {
        self.sections.push(TableSection {
            line,
            reading: reading.clone(),
            first_shot: self.shots.len(),
        });
    }

    /// Adds a row of text.
    ///
    /// # Errors
    /// [`Error::Table`] for an error in a table that is not an export.
    pub fn take(&mut self, reading: &Reading, record: &Record, separator: u8) -> Result<()> {
        self.row += 1;
        let row = cells(&record.text, separator);
        if let Some(fault) = reading.head.row_fault(record, &row) {
            if let RowFault::Title(title) = fault {
                self.title = Some(title.into());
            }
            if let Err(wrong) = self.no_shots.add(self.row as u64, fault) {
                if !reading.head.format.is_export {
                    return Err(self.refused("", wrong.reason));
                }
                self.unreadable
                    .push(format!("row {} ({})", self.row, wrong.reason));
            }
            return Ok(());
        }
        let row: Vec<&str> = row.iter().map(AsRef::as_ref).collect();
        let shots = self.shots.len();
        self.add(reading, reading.shot_of_cells(self.row, &row))?;
        let club = reading.club_name.map(|at| row[at].trim());
        let club = club.or(self.title.as_deref());
        if let Some(club) = club.filter(|_| self.shots.len() > shots) {
            *self.clubs.entry(club.into()).or_default() += 1;
        }
        Ok(())
    }

    /// Skips a row that the filter excludes.
    pub fn skip(&mut self) {
        self.row += 1;
    }

    /// Adds the shot of a message.
    pub fn take_shot(
        &mut self,
        reading: &Reading,
        shot: &Shot,
        other_parameters: &[&'static Parameter],
    ) {
        self.row += 1;
        if let Some(refusal) = shot.refusal() {
            self.refused_messages.push(format!(
                "row {} (line {}: {})",
                self.row, shot.line, refusal.reason
            ));
            return;
        }
        let mut read = reading.shot_of_message(self.row, shot, other_parameters);
        if let Ok(row) = &mut read {
            let club = shot.club_name.clone().unwrap_or_default();
            *self.clubs.entry(club).or_default() += 1;
            match reading.is_delivery() {
                true => row.not_stated.extend(shot.club_notes().cloned()),
                false => row.implausible.extend(shot.not_compared()),
            }
        }
        // never an error: messages count as an export, whose faulty rows are left out
        let _ = self.add(reading, read);
    }

    fn add(
        &mut self,
        reading: &Reading,
        read: std::result::Result<ReadRow, RowError>,
    ) -> Result<()> {
        let row = match read {
            Ok(row) => row,
            Err(wrong) => return self.reject(reading, wrong),
        };
        let number = format!("row {}", self.row);
        self.rows_without_air.extend(
            row.no_air
                .map(|why| format!("{number}: {}", air_of_setup(&why))),
        );
        let implausible = row.implausible.into_iter();
        self.implausible
            .extend(implausible.map(|why| format!("{number}: not compared: {why}")));
        if !reading.is_delivery() {
            for head in row.not_compared {
                self.uncompared_laterals
                    .entry(head)
                    .or_default()
                    .push(number.clone());
            }
        }
        for why in row.not_stated {
            self.not_stated.entry(why).or_default().push(number.clone());
        }
        self.contradictions
            .extend(row.contradiction.map(|why| format!("{number}: {why}")));
        self.shots.push(row.shot);
        Ok(())
    }

    /// Leaves out a row that is incomplete or belongs to an export, and records its fault for a
    /// message.
    ///
    /// # Errors
    /// [`Error::Table`] for any other row.
    fn reject(&mut self, reading: &Reading, wrong: RowError) -> Result<()> {
        let row = self.row;
        let place = wrong
            .column
            .as_ref()
            .map_or(String::new(), |name| format!(", column {name}"));
        if wrong.is_incomplete {
            if !reading.head.format.is_export {
                let error = self.refused(&place, wrong.why);
                self.first_incomplete.get_or_insert(error);
            }
            let column = wrong.column.unwrap_or_else(|| "nothing is measured".into());
            self.incomplete.push(format!("row {row} ({column})"));
            return Ok(());
        }
        if !reading.head.format.is_export {
            return Err(self.refused(&place, wrong.why));
        }
        let column = wrong
            .column
            .map_or(String::new(), |name| format!("{name}: "));
        self.unreadable
            .push(format!("row {row} ({column}{})", wrong.why));
        Ok(())
    }

    /// Messages about rejected rows.
    fn rejected(&self) -> Vec<String> {
        let mut messages = self.no_shots.messages();
        let others = [
            (
                &self.incomplete,
                "rows left out, since they lack a value that every shot needs",
            ),
            (&self.unreadable, "rows left out, since they cannot be used"),
            (
                &self.refused_messages,
                "messages that are no shots are left out",
            ),
        ];
        messages.extend(
            others
                .into_iter()
                .filter(|(rows, _)| !rows.is_empty())
                .map(|(rows, what)| format!("{what}: {}", rows.join(", "))),
        );
        messages
    }

    /// Warning about the first row with contradictory spins, with the number of other such rows.
    fn contradiction_warning(&self) -> Option<Message> {
        let first = self.contradictions.first()?;
        let others = self.contradictions.len() - 1;
        let others = if others > 0 {
            format!(" (also in {})", counted(others as u64, "other row"))
        } else {
            String::new()
        };
        Some(format!("{first}{others}").into())
    }

    /// Remarks in this order: on columns, rejected rows, values that are not compared, club values
    /// that a prior distribution replaces, implausible values, and contradictory spins. Reasons
    /// that are given as warnings are not repeated.
    fn remarks(&mut self, left_out: Vec<Message>) -> Vec<Message> {
        let mut remarks: Vec<Message> = vec![];
        for section in &self.sections {
            let of_section = section.reading.head.remarks.iter();
            remarks.extend(of_section.map(|remark| section.remark(remark)));
        }
        remarks.extend(left_out);
        for (head, rows) in std::mem::take(&mut self.uncompared_laterals) {
            let why = "in rows without a measured launch direction, or without a measured spin \
                       axis or sidespin";
            remarks.push(format!("{head} is not compared {why}: {}", rows.join(", ")).into());
        }
        for (why, rows) in std::mem::take(&mut self.not_stated) {
            let rows = rows.join(", ");
            remarks.push(format!("{why}; the prior is used in its place: {rows}").into());
        }
        let messages = self.implausible.iter().chain(&self.contradictions);
        remarks.extend(messages.cloned().map(Message::from));
        remarks
    }

    /// Warning about shots of several clubs, unless the filter selects shots by the club.
    fn clubs_warning(&self, filter: &RowFilter) -> Option<Message> {
        if self.clubs.len() < 2 {
            return None;
        }
        let counts = counted_values(&self.clubs);
        let mut readings = self.sections.iter().map(|section| &section.reading);
        let head =
            readings.find_map(|reading| Some(&reading.head.columns[reading.club_name?].head));
        let Some(head) = head else {
            let file = &self.file;
            let warning = match self.title {
                Some(_) => format!(
                    "{file} has shots below several titles, such as clubs, which are fitted \
                     together: {counts}; to fit those of one title, put them with the column \
                     heads into a file of their own"
                ),
                None => format!(
                    "{file} has shots of several clubs, which are fitted together: {counts}; to \
                     fit one club alone, write its lines into a file of their own"
                ),
            };
            return Some(warning.into());
        };
        if filter.names(head) {
            return None;
        }
        let most = self
            .clubs
            .iter()
            .filter(|(name, _)| !name.is_empty())
            .max_by_key(|(_, count)| **count)?;
        let condition = format!("{head}={}", most.0);
        let condition = match condition.contains(' ') {
            true => format!("\"{condition}\""),
            false => condition,
        };
        Some(
            format!(
                "{} has shots of several clubs, which are fitted together: {counts}; one club \
                 alone: `only {condition}`",
                self.file
            )
            .into(),
        )
    }

    /// The sections, each with its shots.
    fn sections_with_shots(&self) -> impl Iterator<Item = (&TableSection, &[MeasuredShot])> {
        let next = self.sections.iter().skip(1);
        let ends = next.map(|next| next.first_shot).chain([self.shots.len()]);
        let sections = self.sections.iter().zip(ends);
        sections.map(|(section, end)| (section, &self.shots[section.first_shot..end]))
    }

    /// Remarks on the columns that state the air. Each remark says whether the column gives the air
    /// of any shot. Columns with the same head and the same use have one remark.
    fn air_remarks(&self) -> Vec<Message> {
        let mut given: Vec<Message> = vec![];
        let mut remarks = vec![];
        for (section, shots) in self.sections_with_shots() {
            let Some((_, column)) = section.reading.head.stated_air() else {
                continue;
            };
            let Content::Input(density) = column.content else {
                continue;
            };
            let remark = if shots.iter().any(|shot| shot.gives(density)) {
                Some(air_of_rows(&column.head).into())
            } else {
                columns_remark("columns that are not used", &[column.head.as_str()])
            };
            if let Some(remark) = remark.filter(|remark| !given.contains(remark)) {
                remarks.push(section.remark(&remark));
                given.push(remark);
            }
        }
        remarks
    }

    /// Origin of the standard uncertainties. Adds a remark on each assumed one.
    fn sigma_origin(&self, remarks: &mut Vec<Message>) -> SigmaOrigin {
        let mut origin = SigmaOrigin::Stated;
        let mut assumed: Vec<Message> = vec![];
        for (section, shots) in self.sections_with_shots() {
            let (of_section, origin_of_section) = section.reading.assumed_sigmas(shots);
            origin = origin.max(origin_of_section);
            for remark in of_section {
                if !assumed.contains(&remark) {
                    remarks.push(section.remark(&remark));
                    assumed.push(remark);
                }
            }
        }
        origin
    }

    /// Error of a table without a usable shot.
    fn without_shots(self, left_out: &[String]) -> Error {
        // the error of the first incomplete row names the missing column; the rows of an export
        // have no such error
        if let Some(first) = self.first_incomplete {
            return first;
        }
        let reason = match left_out.is_empty() {
            true => "it has no rows; give one row for each shot".to_owned(),
            false => format!(
                "it has no usable shot ({}); give a row for each shot",
                left_out.join("; ")
            ),
        };
        Error::table(self.file, "", reason)
    }

    /// Builds the table. `final_remarks` are the final remarks of the
    /// [`TextTable`](crate::table::TextTable).
    ///
    /// # Errors
    /// [`Error::Table`] if the table has no usable shot.
    pub fn table(mut self, filter: &RowFilter, final_remarks: Vec<Message>) -> Result<ShotTable> {
        let left_out = self.rejected();
        if self.shots.is_empty() {
            return Err(self.without_shots(&left_out));
        }
        let mut left_out: Vec<Message> = left_out.into_iter().map(Message::from).collect();
        let mut warnings = vec![];
        let mut sections = self.sections.iter();
        if !sections.any(|section| section.reading.head.format.is_export) {
            warnings.append(&mut left_out);
            warnings.extend(self.contradiction_warning());
            self.contradictions.clear();
        }
        warnings.extend(self.clubs_warning(filter));
        let readings = || self.sections.iter().map(|section| &section.reading);
        let is_launched = readings().any(|reading| reading.is_launched);
        let launch_beside_club = readings().find_map(Reading::launch_beside_club);
        let mut remarks = self.remarks(left_out);
        remarks.extend(final_remarks);
        remarks.extend(self.air_remarks());
        remarks.extend(self.rows_without_air.drain(..).map(Message::from));
        let sigma_origin = self.sigma_origin(&mut remarks);
        Ok(ShotTable {
            file: self.file,
            shots: self.shots,
            is_launched,
            remarks,
            warnings,
            launch_beside_club,
            sigma_origin,
        })
    }
}
