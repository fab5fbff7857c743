use super::column::{Column, Format, Holds};
use super::instrument::{Instrument, instrument};
use super::launch_monitor;
use super::shot::{Measurement, Shot, Stationary};
use super::statistics::Uncertainties;
use crate::drive::{Outcome, Part};
use crate::error::{Error, Result};
use crate::foreign::of_csv;
use crate::launch::Launch;
use crate::parameters::{Parameter, Setup};
use crate::units::{Digits, Message};
use csv::{ReaderBuilder, StringRecord, Trim};
use std::io::Read;

/// Measured shots, a row each.
///
/// The head names parameters (inputs of the shot), outcomes (what was measured), `sigma OUTCOME` (its standard uncertainty),
/// `stationary` (names of parameters, separated by spaces, in which carry is at its largest there), `sigma stationary`, and
/// `note`; with its unit in brackets. Heads, units, separators and sides may also be those of a launch monitor's export; carry is the
/// distance to the landing point, [`Outcome::CarryDistance`]. Where `ball_speed`, `launch_angle` and `spin` or `backspin` stand beside no
/// parameter of swing, club, strike or impact, the rows are launch conditions, and the ball flies from them without an impact.
#[derive(Clone, Debug)]
pub struct ShotTable {
    /// Where it was read from, for messages.
    pub file: String,
    /// The shots.
    pub shots: Vec<Shot>,
    /// Whether rows are launch conditions.
    pub is_launched: bool,
    /// What deserves a word: outcomes without a sigma column.
    pub remarks: Vec<Message>,
    /// What the standard uncertainties of the measured values are worth.
    pub uncertainties: Uncertainties,
}

/// No outcome of a drive is larger than this, in whatever SI unit.
const MOST: f64 = 1e9;

/// Outcomes that, all together, are a launch.
const CONDITIONS: [Outcome; 7] = [
    Outcome::BallSpeed,
    Outcome::LaunchAngle,
    Outcome::LaunchDirection,
    Outcome::Spin,
    Outcome::Backspin,
    Outcome::Sidespin,
    Outcome::SpinAxis,
];

impl ShotTable {
    /// Reads a table in CSV.
    ///
    /// # Errors
    /// [`Error::Table`] with row and column for a column that is unknown, given twice or in a wrong unit, a cell that is no
    /// number, a sigma that is not positive, a value outside its range, a row without a measurement, and a table without rows.
    pub fn read(setup: &Setup<f64>, file: &str, source: impl Read) -> Result<Self> {
        let refused = |place: String, reason: String| Error::Table { file: file.into(), place, reason };
        let mut text = String::new();
        let mut source = source;
        source
            .read_to_string(&mut text)
            .map_err(|error| refused(String::new(), format!("it cannot be read ({error})")))?;
        let (separator, text) = launch_monitor::separated(&text);
        let mut reader =
            ReaderBuilder::new().trim(Trim::All).comment(Some(b'#')).delimiter(separator).from_reader(text.as_bytes());
        let head = reader.headers().map_err(|error| refused(String::new(), of_csv(&error)))?.clone();
        let mut records = reader.records().peekable();
        let is_export = launch_monitor::is_export(head.iter());
        let format = Format { is_export, has_decimal_comma: separator != b',' };
        let units = match records.peek() {
            Some(Ok(first)) => launch_monitor::units_row(first.iter()),
            _ => None,
        };
        if units.is_some() {
            records.next();
        }
        let mut columns: Vec<Column> = vec![];
        for (at, text) in head.iter().enumerate() {
            let place = || format!(", column {}", at + 1);
            let below = units.as_ref().and_then(|units| units.get(at)?.as_deref());
            let column =
                Column::read(setup, text, below, format).map_err(|error| refused(place(), error.to_string()))?;
            if column.holds != Holds::Note && columns.iter().any(|other| other.holds == column.holds) {
                return Err(refused(place(), format!("'{}' has two columns; keep one", column.head)));
            }
            columns.push(column);
        }
        let mut remarks = vec![];
        if is_export {
            remarks.extend(left_out(&mut columns));
        }
        let reading = Reading { setup, is_launched: is_launched(&columns), columns };
        if is_export && !reading.is_launched && !reading.columns.iter().any(is_of_the_strike) {
            let reason = "it has neither a whole launch (ball speed, launch angle and spin) nor a column of the club, such as club \
                          speed; add the missing columns";
            return Err(refused(String::new(), reason.into()));
        }
        let mut shots = vec![];
        for (at, record) in records.enumerate() {
            let row = at + 1;
            let record = record.map_err(|error| refused(format!(", row {row}"), of_csv(&error)))?;
            let shot = reading.shot(row, &record);
            shots.push(shot.map_err(|(column, why)| {
                let column = column.map_or(String::new(), |name| format!(", column {name}"));
                refused(format!(", row {row}{column}"), why)
            })?);
        }
        if shots.is_empty() {
            return Err(refused(String::new(), "it has no rows; give one for each shot".into()));
        }
        let (assumed, uncertainties) = reading.assumed();
        remarks.extend(assumed);
        let Reading { is_launched, .. } = reading;
        Ok(Self { file: file.into(), shots, is_launched, remarks, uncertainties })
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

/// Whether the columns are those of launch conditions.
fn is_launched(columns: &[Column]) -> bool {
    let has = |outcome| columns.iter().any(|column| column.holds == Holds::Outcome(outcome));
    let has_spin = has(Outcome::Spin) || has(Outcome::Backspin);
    has(Outcome::BallSpeed) && has(Outcome::LaunchAngle) && has_spin && !columns.iter().any(is_of_the_strike)
}

/// Whether a column is of the delivery of the club.
fn is_of_the_strike(column: &Column) -> bool {
    let groups = ["swing.", "club.", "strike.", "impact."];
    matches!(column.holds, Holds::Input(parameter) if groups.iter().any(|group| parameter.name.starts_with(group)))
}

/// Leaves out what a launch monitor's table has and the fit cannot use, and says so: columns without a name here; where the launch
/// was measured, those of the club; of backspin, sidespin and the spin axis what repeats the spin.
fn left_out(columns: &mut [Column]) -> Vec<Message> {
    let named = |columns: &[Column], is: &dyn Fn(&Column) -> bool| -> Vec<String> {
        columns
            .iter()
            .filter(|column| is(column))
            .map(|column| column.head.clone())
            .filter(|head| !head.is_empty())
            .collect()
    };
    let mut remarks = vec![];
    let unknown = named(columns, &Column::is_unknown);
    if !unknown.is_empty() {
        remarks.push(format!("columns without a name here are left out: {}", unknown.join(", ")).into());
    }
    let has = |columns: &[Column], outcome| columns.iter().any(|column| column.holds == Holds::Outcome(outcome));
    let has_spin = has(columns, Outcome::Spin) || has(columns, Outcome::Backspin);
    if has(columns, Outcome::BallSpeed) && has(columns, Outcome::LaunchAngle) && has_spin {
        let is_club =
            |column: &Column| is_of_the_strike(column) || column.holds == Holds::Outcome(Outcome::SmashFactor);
        let club = named(columns, &is_club);
        if !club.is_empty() {
            remarks.push(
                format!(
                    "the ball flies from its measured launch; columns of the club are left out: {}",
                    club.join(", ")
                )
                .into(),
            );
        }
        let repeated: &[Outcome] = match has(columns, Outcome::Spin)
            && (has(columns, Outcome::SpinAxis) || !has(columns, Outcome::Sidespin))
        {
            true => &[Outcome::Backspin, Outcome::Sidespin],
            false if has(columns, Outcome::Backspin) => &[Outcome::Spin, Outcome::SpinAxis],
            false => &[],
        };
        let repeats = |column: &Column| repeated.iter().any(|outcome| column.holds == Holds::Outcome(*outcome));
        let again = named(columns, &repeats);
        if !again.is_empty() {
            remarks.push(format!("the spin is stated twice; left out: {}", again.join(", ")).into());
        }
        for column in columns.iter_mut().filter(|column| is_club(column) || repeats(column)) {
            column.holds = Holds::Note;
        }
    }
    remarks
}

/// A table being read.
struct Reading<'a> {
    setup: &'a Setup<f64>,
    columns: Vec<Column>,
    is_launched: bool,
}

/// The column in which something is wrong, and what.
type Wrong = (Option<String>, String);

impl Reading<'_> {
    fn cell(&self, record: &StringRecord, holds: Holds) -> Result<Option<f64>, Wrong> {
        let Some(at) = self.columns.iter().position(|column| column.holds == holds) else { return Ok(None) };
        let column = &self.columns[at];
        column.value(record.get(at).unwrap_or_default()).map_err(|why| (Some(column.head.clone()), why))
    }

    fn sigma(&self, record: &StringRecord, holds: Holds, one: f64) -> Result<f64, Wrong> {
        let sigma = self.cell(record, holds)?;
        let has_column = self.columns.iter().any(|column| column.holds == holds);
        match sigma {
            Some(sigma) if sigma > 0.0 => Ok(sigma),
            None if !has_column => Ok(one),
            _ => {
                let head = self.columns.iter().find(|column| column.holds == holds).map(|column| column.head.clone());
                Err((head, "a standard uncertainty must be a number above 0 wherever there is a measurement".into()))
            }
        }
    }

    fn shot(&self, row: usize, record: &StringRecord) -> Result<Shot, Wrong> {
        let (mut inputs, mut measured) = (vec![], vec![]);
        let mut at_shot = *self.setup;
        for column in &self.columns {
            let here = || Some(column.head.clone());
            match column.holds {
                Holds::Input(parameter) => {
                    let Some(value) = self.cell(record, column.holds)? else {
                        return Err((here(), "the cell is empty; every row needs the shot's own inputs".into()));
                    };
                    at_shot.set_value(parameter, Some(value)).map_err(|error| (here(), error.to_string()))?;
                    inputs.push((parameter, value));
                }
                Holds::Outcome(outcome) if !(self.is_launched && CONDITIONS.contains(&outcome)) => {
                    if self.is_launched && outcome.part() == Part::Launch {
                        return Err((here(), "rows of launch conditions have no club".into()));
                    }
                    if let Some(value) = self.cell(record, column.holds)? {
                        if value.abs() > MOST {
                            let (shown, most) = (outcome.show(value), outcome.show(MOST));
                            return Err((
                                here(),
                                format!("{shown} is outside its range −{most} .. {most}; correct the cell"),
                            ));
                        }
                        let assumed = instrument(outcome).map_or(column.one(), |(_, sigma)| sigma);
                        let sigma = self.sigma(record, Holds::Sigma(outcome), assumed)?;
                        measured.push(Measurement { outcome, value, sigma });
                    }
                }
                _ => {}
            }
        }
        at_shot.validate().map_err(|error| (None, error.to_string()))?;
        let launch = if self.is_launched { Some(self.launch(record)?) } else { None };
        let stationary = self.stationary(record, &at_shot)?;
        if measured.is_empty() && stationary.is_empty() {
            return Err((None, "nothing is measured in it; give an outcome, or take the row out".into()));
        }
        Ok(Shot { row, inputs, launch, measured, stationary })
    }

    fn launch(&self, record: &StringRecord) -> Result<Launch<f64>, Wrong> {
        let [speed, angle, direction, spin, backspin, sidespin, axis] =
            CONDITIONS.map(|outcome| self.cell(record, Holds::Outcome(outcome)));
        let wanted = |cell: Option<f64>, what: Outcome| {
            cell.ok_or_else(|| (Some(what.name().to_owned()), "the cell is empty; every launch needs one".to_owned()))
        };
        let (speed, angle) = (wanted(speed?, Outcome::BallSpeed)?, wanted(angle?, Outcome::LaunchAngle)?);
        let wrong = |what: Outcome, why: &str| Err((Some(what.name().to_owned()), why.to_owned()));
        if speed <= 0.0 {
            return wrong(Outcome::BallSpeed, "the ball's speed must be above 0");
        }
        if angle.abs() >= std::f64::consts::FRAC_PI_2 {
            return wrong(Outcome::LaunchAngle, "the launch must be between −90° and 90°");
        }
        let (back, side) = match (spin?, backspin?, sidespin?, axis?) {
            (None, Some(back), side, None) => (back, side.unwrap_or(0.0)),
            (Some(spin), None, None, axis) => {
                let (sin, cos) = axis.unwrap_or(0.0).sin_cos();
                (spin * cos, spin * sin)
            }
            (Some(spin), None, Some(side), None) if side.abs() <= spin => ((spin * spin - side * side).sqrt(), side),
            _ => {
                return wrong(
                    Outcome::Spin,
                    "give the spin once: backspin with sidespin, or spin with spin_axis or with a sidespin no larger",
                );
            }
        };
        Ok(Launch::with_conditions(speed, angle, direction?.unwrap_or(0.0), back, side))
    }

    fn stationary(&self, record: &StringRecord, at_shot: &Setup<f64>) -> Result<Vec<Stationary>, Wrong> {
        let Some(at) = self.columns.iter().position(|column| column.holds == Holds::Stationary) else {
            return Ok(vec![]);
        };
        let here = || Some("stationary".to_owned());
        let mut all = vec![];
        for name in record.get(at).unwrap_or_default().split_whitespace() {
            let parameter = at_shot.variable(name).map_err(|error| (here(), error.to_string()))?;
            if self.is_launched {
                return Err((here(), "rows of launch conditions have no parameter to be best in".into()));
            }
            let one = crate::units::Quantity::ANGLE.size_of("deg").unwrap_or(1.0);
            if parameter.quantity != crate::units::Quantity::ANGLE {
                return Err((here(), format!("{name} is no angle; optima are read in angles")));
            }
            all.push(Stationary { parameter, sigma: self.sigma(record, Holds::SigmaStationary, one)? });
        }
        Ok(all)
    }

    /// What is taken where no standard uncertainty stands beside a measured column, and what they are worth in all.
    fn assumed(&self) -> (Vec<Message>, Uncertainties) {
        let has = |holds: Holds| self.columns.iter().any(|column| column.holds == holds);
        let mut worth = Uncertainties::Stated;
        let mut remarks = vec![];
        for column in &self.columns {
            match column.holds {
                Holds::Outcome(outcome) if self.is_launched && CONDITIONS.contains(&outcome) => {}
                Holds::Outcome(outcome) if !has(Holds::Sigma(outcome)) => match instrument(outcome) {
                    Some((Instrument { source, .. }, sigma)) => {
                        let without = format!("{} has no column 'sigma {}': ", column.head, outcome.name());
                        let remark = Message::from(without)
                            .quantity(outcome.quantity(), outcome.unit(), sigma, Digits::Significant(3))
                            .words(format!(" is taken for each ({source})"));
                        remarks.push(remark);
                        if worth == Uncertainties::Stated {
                            worth = Uncertainties::Instruments;
                        }
                    }
                    None => {
                        remarks.push(
                            format!(
                                "{0} has no column 'sigma {0}': 1 {1} is taken for each, as a weight",
                                outcome.name(),
                                column.unit()
                            )
                            .into(),
                        );
                        worth = Uncertainties::Weights;
                    }
                },
                Holds::Stationary if !has(Holds::SigmaStationary) => {
                    remarks.push(
                        "stationary has no column 'sigma stationary': 1 deg is taken for each, as a weight".into(),
                    );
                    worth = Uncertainties::Weights;
                }
                _ => {}
            }
        }
        (remarks, worth)
    }
}
