use super::column::{Column, Format, Holds};
use super::launch_monitor;
use super::reading::Reading;
use super::shot::Shot;
use super::statistics::Uncertainties;
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::foreign::of_csv;
use crate::parameters::{Parameter, Setup};
use crate::units::{Message, counted};
use csv::{ReaderBuilder, Trim};
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

impl ShotTable {
    /// Reads a table in CSV.
    ///
    /// # Errors
    /// [`Error::Table`] with row and column for a column that is unknown, given twice or in a wrong unit, a cell that is no
    /// number, a sigma that is not positive, a value outside its range, a row without a measurement, and a table without rows. Of a
    /// launch monitor's export, rows that sum up others and rows with an empty cell that every shot needs are left out, and named in the
    /// remarks.
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
            remarks.extend(in_degrees(&columns).map(Message::from));
        }
        let reading = Reading { setup, is_launched: is_launched(&columns), columns };
        if is_export && !reading.is_launched && !reading.columns.iter().any(is_of_the_strike) {
            let reason = "it has neither a whole launch (ball speed, launch angle and spin) nor a column of the club, such as club \
                          speed; add the missing columns";
            return Err(refused(String::new(), reason.into()));
        }
        let (mut shots, mut summaries, mut incomplete) = (vec![], vec![], vec![]);
        for (at, record) in records.enumerate() {
            let row = at + 1;
            let record = record.map_err(|error| refused(format!(", row {row}"), of_csv(&error)))?;
            if let Some(word) = launch_monitor::summary(record.iter()).filter(|_| is_export) {
                summaries.push(format!("{row} ({word})"));
                continue;
            }
            match reading.shot(row, &record) {
                Ok(shot) => shots.push(shot),
                Err(wrong) if is_export && wrong.is_incomplete => {
                    let column = wrong.column.unwrap_or_else(|| "nothing is measured".into());
                    incomplete.push(format!("{row} ({column})"));
                }
                Err(wrong) => {
                    let column = wrong.column.map_or(String::new(), |name| format!(", column {name}"));
                    return Err(refused(format!(", row {row}{column}"), wrong.why));
                }
            }
        }
        let left_out: Vec<String> = [(summaries, "summing up others"), (incomplete, "without what every shot needs")]
            .into_iter()
            .filter(|(rows, _)| !rows.is_empty())
            .map(|(rows, what)| format!("{} {what} left out: {}", counted(rows.len() as u64, "row"), rows.join(", ")))
            .collect();
        if shots.is_empty() {
            let reason = match left_out.is_empty() {
                true => "it has no rows; give one for each shot".into(),
                false => format!("no shot is left of it ({}); give a row for each shot", left_out.join("; ")),
            };
            return Err(refused(String::new(), reason));
        }
        remarks.extend(left_out.into_iter().map(Message::from));
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

/// The angles whose unit is taken for granted.
fn in_degrees(columns: &[Column]) -> Option<String> {
    let heads: Vec<&str> =
        columns.iter().filter(|column| column.is_in_degrees_untold()).map(|column| column.head.as_str()).collect();
    let (is, angles) = if heads.len() == 1 { ("is", "an angle") } else { ("are", "angles") };
    (!heads.is_empty()).then(|| {
        format!("{} {is} read in degrees: {angles} without a unit, and launch monitors write degrees", heads.join(", "))
    })
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
