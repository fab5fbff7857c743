//! A table of measured shots.

use super::reading::Reading;
use super::rows::Rows;
use super::shot::Shot;
use super::statistics::Uncertainties;
use crate::error::{Error, Result};
use crate::foreign::of_io;
use crate::parameters::{Parameter, Setup};
use crate::shots::{Shots, is_json};
use crate::table::{Club, Entry, Text, TextTable, Wanted, air_as_given, air_of_rows};
use crate::units::Message;
use std::fs::File;
use std::io::{Cursor, Read};
use std::path::Path;

/// Measured shots, a row each.
///
/// The head names parameters (inputs of the shot), outcomes (what was measured), `sigma OUTCOME` (its standard uncertainty),
/// `stationary` (names of parameters, separated by spaces, in which carry is at its largest there), `sigma stationary`, and
/// `note`; with its unit in brackets. Heads, units, separators and sides may also be those of a launch monitor's export; carry is the
/// distance to the landing point, [`Outcome::CarryDistance`](crate::Outcome::CarryDistance). Where `ball_speed`, `launch_angle` and `spin` or `backspin` stand beside no
/// parameter of swing, club, strike or impact, the rows are launch conditions, and the ball flies from them without an impact.
#[derive(Clone, Debug)]
pub struct ShotTable {
    /// Where it was read from, for messages.
    pub file: String,
    /// The shots.
    pub shots: Vec<Shot>,
    /// Whether rows are launch conditions.
    pub is_launched: bool,
    /// Notes: outcomes without a sigma column.
    pub remarks: Vec<Message>,
    /// What deserves more than that, of a table that is no launch monitor's export: rows that were left out, and spins of which one is not used.
    pub warnings: Vec<Message>,
    /// The heads of a measured launch, and of the columns of the club beside it, where both are there: the rows are then deliveries.
    pub(super) launch_beside_club: Option<[String; 2]>,
    /// What the standard uncertainties of the measured values are worth.
    pub uncertainties: Uncertainties,
    /// The head of the column of each row's air, of an export that states it.
    pub(super) stated_air: Option<String>,
}

impl ShotTable {
    /// Reads a table in a CSV file.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn open(setup: &Setup<f64>, path: &Path) -> Result<Self> {
        Self::opened(setup, path, Club::LeftOut)
    }

    /// Reads a table in a CSV file whose rows may be launches alone, of which nothing more is measured. What it states of the club beside
    /// them is read too.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn open_launches(setup: &Setup<f64>, path: &Path) -> Result<Self> {
        Self::opened(setup, path, Club::Kept)
    }

    fn opened(setup: &Setup<f64>, path: &Path, club: Club) -> Result<Self> {
        let file = path.display().to_string();
        let source = File::open(path).map_err(|error| Error::Table {
            file: file.clone(),
            place: String::new(),
            reason: of_io(&error),
        })?;
        Self::read_rows(setup, &file, source, club)
    }

    /// Reads a table in CSV.
    ///
    /// # Errors
    /// [`Error::Table`] with row and column for a column that is unknown, given twice or in a wrong unit, a cell that is no number or whose
    /// decimal mark is uncertain, a sigma that is not positive, a value outside its range, and a table without rows. Rows that lack a value that
    /// every shot needs, or a measurement, are left out and named in the remarks. Of a
    /// launch monitor's export so are rows that sum up others or have a value that cannot be used, and measured values that no drive has, which are not compared. Messages of GSPro Open Connect, and exports with title lines before their head, are read too.
    pub fn read(setup: &Setup<f64>, file: &str, source: impl Read) -> Result<Self> {
        Self::read_rows(setup, file, source, Club::LeftOut)
    }

    /// The same; where the club beside a measured launch is read too, a row needs no measurement beside its launch.
    fn read_rows(setup: &Setup<f64>, file: &str, mut source: impl Read, club: Club) -> Result<Self> {
        let mut bytes = vec![];
        source.read_to_end(&mut bytes).map_err(|error| Error::Table {
            file: file.into(),
            place: String::new(),
            reason: of_io(&error),
        })?;
        let text = Text::open(file, Cursor::new(bytes))?;
        if is_json(&text.beginning) {
            return Self::of_messages(setup, Shots::of_text(setup, text)?, file, club);
        }
        let wanted = match club {
            Club::LeftOut => Wanted::MEASUREMENTS,
            Club::Kept => Wanted::DELIVERIES,
        };
        let (mut table, head) = TextTable::open(text, setup, &wanted)?;
        let (mut heads, mut units) = (head.heads.clone(), head.units.clone());
        let mut reading = Reading::of_head(setup, &table, head, club)?;
        let first = reading.clone();
        let mut rows = Rows::new(file);
        while let Some(entry) = table.next_entry()? {
            match entry {
                Entry::Row(record) => rows.take(&reading, &record, table.separator)?,
                Entry::Head(record) => {
                    let head = table.head(&record, setup, &wanted)?;
                    if head.is_like(&heads, units.as_deref()) {
                        continue;
                    }
                    (heads, units) = (head.heads.clone(), head.units.clone());
                    reading = Reading::of_head(setup, &table, head, club)?;
                    if reading.is_launched != first.is_launched {
                        let reason = "its rows are launches where those before are not, or the other way; give each a file of its own";
                        return Err(table.name.refused(format!(", line {}", record.line), reason));
                    }
                    rows.begin(record.line, &reading);
                }
            }
        }
        rows.table(first)
    }

    /// The shots of messages of GSPro Open Connect, and of lines that `fly` wrote.
    fn of_messages(setup: &Setup<f64>, shots: Shots, file: &str, club: Club) -> Result<Self> {
        let further = shots.further().to_vec();
        let shots = shots.all()?;
        let reading = Reading::of_shots(setup, &shots, &further, club);
        let mut rows = Rows::new(file);
        for shot in &shots {
            rows.take_shot(&reading, shot, &further);
        }
        rows.table(reading)
    }

    /// Leaves the air out that an export states of each row, where it is given otherwise.
    pub fn in_given_air(&mut self) {
        let Some(head) = self.stated_air.take() else { return };
        let told = air_of_rows(&head);
        for remark in self.remarks.iter_mut().filter(|remark| remark.to_string() == told) {
            *remark = air_as_given(&head).into();
        }
        for shot in &mut self.shots {
            shot.inputs.retain(|(parameter, _)| parameter.name != "air.density");
        }
    }

    /// How many residuals there are.
    pub fn residuals(&self) -> usize {
        self.shots.iter().map(Shot::residuals).sum()
    }

    /// Residuals up to this size are rounding: 1e-12 of the largest measured value in units of its standard uncertainty.
    pub fn rounding(&self) -> f64 {
        let measured = self.shots.iter().flat_map(|shot| &shot.measured);
        1e-12 * measured.map(|measurement| (measurement.value / measurement.sigma).abs()).fold(0.0, f64::max)
    }

    /// Whether a parameter is an input of the shots.
    pub fn gives(&self, parameter: &'static Parameter) -> bool {
        self.shots.iter().any(|shot| shot.inputs.iter().any(|(row, _)| *row == parameter))
    }
}
