use super::reading::{Reading, Row};
use super::shot::Shot;
use super::statistics::Uncertainties;
use crate::columns::{
    Club, Column, Head, Holds, Marks, Spin, air_as_given, air_of_rows, air_of_setup, decoded, near_known, separated,
    summary, unstated,
};
use crate::error::{Error, Result};
use crate::foreign::{NOT_UTF_8, of_io};
use crate::parameters::{Parameter, Setup};
use crate::shots::{Record, cells, miscounted, records, tabled};
use crate::units::{Message, counted};
use csv::StringRecord;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::Read;
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
    fn read_rows(setup: &Setup<f64>, file: &str, source: impl Read, club: Club) -> Result<Self> {
        let refused = |place: String, reason: String| Error::Table { file: file.into(), place, reason };
        let mut bytes = vec![];
        let read = decoded(source).and_then(|mut source| source.read_to_end(&mut bytes));
        read.map_err(|error| refused(String::new(), of_io(&error)))?;
        let text = String::from_utf8(bytes).map_err(|error| {
            let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
            let line = before.iter().filter(|byte| **byte == b'\n').count() + 1;
            refused(format!(", line {line}"), NOT_UTF_8.into())
        })?;
        let (table, of_source) = tabled(setup, &text);
        let (separator, text) = separated(&table);
        let mut records = records(file, text, separator)?.into_iter().peekable();
        let apart = |record: &Record| StringRecord::from(cells(&record.text, separator));
        let heads = records.next().map(|record| apart(&record)).unwrap_or_default();
        let first = records.peek().map(apart);
        let first = first.as_ref().map(StringRecord::iter);
        let at_column = |(at, error): (usize, Error)| refused(format!(", column {}", at + 1), error.to_string());
        let mut head = Head::read(setup, heads.iter(), first, separator, club, Spin::OfRow)
            .map_err(|wrong| wrong.in_file(file))?;
        if head.has_units_row {
            records.next();
        }
        let without_unit = if head.format.is_export { unstated(&mut head.columns) } else { None };
        for (at, column) in head.columns.iter().enumerate() {
            column.check_unit().map_err(|error| at_column((at, error)))?;
            let is_read = !matches!(column.holds, Holds::Note | Holds::Written);
            if is_read && head.columns[..at].iter().any(|other| other.holds == column.holds) {
                return Err(refused(
                    format!(", column {}", at + 1),
                    format!("'{}' has two columns; keep one", column.head),
                ));
            }
            let of = match column.holds {
                Holds::Sigma(outcome) => Holds::Outcome(outcome),
                Holds::SigmaStationary => Holds::Stationary,
                _ => continue,
            };
            if head.columns.iter().all(|other| other.holds != of) {
                let reason = format!(
                    "'{}' is the uncertainty of what has no column; add that column, or leave this out",
                    column.head
                );
                return Err(refused(format!(", column {}", at + 1), reason));
            }
        }
        let mut remarks = of_source;
        remarks.extend(head.remarks.clone());
        remarks.extend(without_unit.map(Message::from));
        let written = head.named(|column| column.holds == Holds::Written);
        remarks.extend(written.told("columns that a sweep writes beside what is measured are not read"));
        // where a delivery is sought, the launch is what was measured, and not given
        let (is_export, is_launched) = (head.format.is_export, head.is_launched() && club == Club::LeftOut);
        let inputs = head.columns.iter().filter_map(|column| match column.holds {
            Holds::Input(parameter) => Some(parameter.name),
            _ => None,
        });
        setup
            .refuse_replaced(&inputs.collect::<Vec<_>>())
            .map_err(|error| refused(String::new(), error.to_string()))?;
        let reading = Reading { setup, is_launched, is_export, club, columns: head.columns };
        if is_export
            && club == Club::LeftOut
            && !reading.is_launched
            && !reading.columns.iter().any(Column::is_of_the_strike)
        {
            let near = near_known(&reading.columns);
            let reason = format!(
                "it has neither a whole launch (ball speed, launch angle and spin) nor a column of the club, such as club speed{near}; add \
                 the missing columns"
            );
            return Err(refused(String::new(), reason));
        }
        let (mut shots, mut summaries, mut incomplete, mut unreadable) = (vec![], vec![], vec![], vec![]);
        let (mut sideways, mut contradictions) = (BTreeMap::<String, Vec<String>>::new(), vec![]);
        let mut lacking = None;
        let (mut marks, mut not_drives, mut airless) = (Marks::default(), vec![], vec![]);
        for (at, record) in records.enumerate() {
            let row = at + 1;
            let (unclosed, record) = (record.unclosed(), apart(&record));
            if let Some(word) = summary(record.iter()).filter(|_| is_export && unclosed.is_none()) {
                summaries.push(format!("row {row} ({word})"));
                continue;
            }
            let cells: Vec<&str> = record.iter().collect();
            match unclosed.or_else(|| miscounted(&cells, heads.len())) {
                Some(wrong) if is_export => {
                    unreadable.push(format!("row {row} ({})", wrong.reason));
                    continue;
                }
                Some(wrong) => return Err(refused(format!(", row {row}"), wrong.reason)),
                None => {}
            }
            for (column, cell) in reading.columns.iter().zip(&record) {
                let place = || format!(", row {row}, column {}", column.head);
                marks.look(row as u64, column, cell).map_err(|reason| refused(place(), reason))?;
            }
            match reading.shot(row, &record) {
                Ok(Row { shot, not_compared, contradiction, implausible, no_air }) => {
                    airless.extend(no_air.map(|why| format!("row {row}: {}", air_of_setup(&why))));
                    not_drives.extend(implausible.into_iter().map(|why| format!("row {row}: not compared: {why}")));
                    if let Some(head) = not_compared.filter(|_| reading.club == Club::LeftOut) {
                        sideways.entry(head).or_default().push(format!("row {row}"));
                    }
                    contradictions.extend(contradiction.map(|told| format!("row {row}: {told}")));
                    shots.push(shot);
                }
                Err(wrong) if wrong.is_incomplete => {
                    if !is_export {
                        let column = wrong.column.as_ref().map_or(String::new(), |name| format!(", column {name}"));
                        lacking.get_or_insert_with(|| refused(format!(", row {row}{column}"), wrong.why.clone()));
                    }
                    let column = wrong.column.unwrap_or_else(|| "nothing is measured".into());
                    incomplete.push(format!("row {row} ({column})"));
                }
                Err(wrong) if is_export => {
                    let column = wrong.column.map_or(String::new(), |name| format!("{name}: "));
                    unreadable.push(format!("row {row} ({column}{})", wrong.why));
                }
                Err(wrong) => {
                    let column = wrong.column.map_or(String::new(), |name| format!(", column {name}"));
                    return Err(refused(format!(", row {row}{column}"), wrong.why));
                }
            }
        }
        let left_out: Vec<String> = [
            (summaries, "sum up other rows"),
            (incomplete, "lack a value that every shot needs"),
            (unreadable, "cannot be used"),
        ]
        .into_iter()
        .filter(|(rows, _)| !rows.is_empty())
        .map(|(rows, what)| format!("rows left out, since they {what}: {}", rows.join(", ")))
        .collect();
        if shots.is_empty() {
            // of a table of one's own the first row says best what is wanted
            if let Some(first) = lacking {
                return Err(first);
            }
            let reason = match left_out.is_empty() {
                true => "it has no rows; give one for each shot".into(),
                false => format!("no shot is left in it ({}); give a row for each shot", left_out.join("; ")),
            };
            return Err(refused(String::new(), reason));
        }
        let left_out = left_out.into_iter().map(Message::from);
        let mut warnings: Vec<Message> = if is_export { vec![] } else { left_out.clone().collect() };
        if let Some(first) = contradictions.first().filter(|_| !is_export) {
            let others = contradictions.len() - 1;
            let others =
                if others > 0 { format!(" (so in {})", counted(others as u64, "other row")) } else { String::new() };
            warnings.push(format!("{first}{others}").into());
        }
        remarks.extend(left_out);
        remarks.extend(sideways.into_iter().map(|(head, rows)| {
            let why = "in rows without a measured launch direction or spin axis (or sidespin)";
            format!("{head} is not compared {why}: {}", rows.join(", ")).into()
        }));
        remarks.extend(not_drives.into_iter().map(Message::from));
        remarks.extend(contradictions.into_iter().map(Message::from));
        let stated_air = reading.columns.iter().find(|column| column.is_stated_air()).map(|column| column.head.clone());
        remarks.extend(stated_air.iter().map(|head| air_of_rows(head).into()));
        remarks.extend(airless.into_iter().map(Message::from));
        let (assumed, uncertainties) = reading.assumed(&shots);
        remarks.extend(assumed);
        let launch_beside_club = reading.launch_beside_club();
        let Reading { is_launched, .. } = reading;
        Ok(Self {
            file: file.into(),
            shots,
            is_launched,
            remarks,
            warnings,
            launch_beside_club,
            uncertainties,
            stated_air,
        })
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
