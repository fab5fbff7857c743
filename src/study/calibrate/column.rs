//! What the head of a table of shots says of a column.

use super::launch_monitor::{self, Meaning};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup};
use crate::units::Quantity;

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Holds {
    /// A parameter of the shot.
    Input(&'static Parameter),
    /// An outcome: measured, or a launch condition.
    Outcome(Outcome),
    /// The standard uncertainty of a measured outcome.
    Sigma(Outcome),
    /// Names of the parameters in which carry is stationary.
    Stationary,
    /// The standard uncertainty of where it is.
    SigmaStationary,
    /// A remark, which is not read.
    Note,
}

/// A column, with the unit that its numbers are in; SI where the head names none.
#[derive(Clone, Debug)]
pub(super) struct Column {
    pub holds: Holds,
    pub head: String,
    unit: Option<String>,
    format: Format,
    /// Whether it is an angle of a launch monitor that states no unit.
    is_in_degrees_untold: bool,
}

/// How a table is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Format {
    /// Whether its heads are those of a launch monitor: columns that this program has no name for are then left out.
    pub is_export: bool,
    /// Whether numbers may have a decimal comma.
    pub has_decimal_comma: bool,
}

/// A column of optima.
const STATIONARY: &str = "stationary";
/// A column for people.
const NOTE: &str = "note";

impl Column {
    /// Reads `carry [yd]`, `sigma carry [yd]`, `club.loft [deg]`, `stationary`, `note`, or a head as launch monitors write it;
    /// `below` is the unit that a second line states.
    ///
    /// A measured carry is the distance to where the ball lands, as launch monitors count it, not its part along the target line.
    pub fn read(setup: &Setup<f64>, head: &str, below: Option<&str>, format: Format) -> Result<Self> {
        let head = head.trim();
        let (name, unit) = launch_monitor::split_unit(head);
        let unit = unit.or_else(|| below.map(str::to_owned)).map(|unit| launch_monitor::unit(&unit));
        let holds =
            match (name.strip_prefix("sigma ").map(str::trim), launch_monitor::meaning_with(name, unit.as_deref())) {
                (Some(STATIONARY), _) => Holds::SigmaStationary,
                (Some(outcome), _) => Holds::Sigma(measured(Outcome::named(outcome)?)),
                (None, Some(Meaning::Outcome(outcome))) => Holds::Outcome(outcome),
                (None, Some(Meaning::Input(parameter))) => Holds::Input(setup.variable(parameter)?),
                (None, None) if name == STATIONARY => Holds::Stationary,
                (None, None) if name == NOTE || is_foreign(name, format) => Holds::Note,
                (None, None) => Outcome::named(name)
                    .map(|outcome| Holds::Outcome(measured(outcome)))
                    .or_else(|_| known(setup, name).map(Holds::Input))?,
            };
        let mut column = Self { holds, head: name.into(), unit, format, is_in_degrees_untold: false };
        let is_of_an_export = format.is_export && launch_monitor::meaning(name).is_some();
        if is_of_an_export && column.unit.is_none() && column.quantity() == Some(Quantity::ANGLE) {
            (column.unit, column.is_in_degrees_untold) = (Some("deg".into()), true);
        }
        column.check_unit()?;
        Ok(column)
    }

    /// Whether it is left out because this program has no name for it.
    pub fn is_unknown(&self) -> bool {
        self.holds == Holds::Note && self.head != NOTE
    }

    /// Whether it states no unit and is read in degrees, as launch monitors write angles.
    pub fn is_in_degrees_untold(&self) -> bool {
        self.is_in_degrees_untold && self.holds != Holds::Note
    }

    fn check_unit(&self) -> Result<()> {
        match (&self.unit, self.quantity()) {
            _ if self.is_unknown() => Ok(()),
            (None, Some(quantity)) if !quantity.si.is_empty() => {
                let unit = self.usual_unit();
                Err(self.unreadable(format!("it has no unit; write it into the head, as in '{} [{unit}]'", self.head)))
            }
            (None, _) => Ok(()),
            (Some(unit), Some(quantity)) => {
                quantity.read(&format!("1 {unit}")).map(drop).map_err(|e| self.unreadable(e))
            }
            (Some(unit), None) => Err(self.unreadable(format!("it has no unit, and [{unit}] is one"))),
        }
    }

    fn unreadable(&self, why: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> Error {
        Error::Unreadable { name: format!("the column '{}'", self.head), source: why.into() }
    }

    fn quantity(&self) -> Option<Quantity> {
        match self.holds {
            Holds::Input(parameter) => Some(parameter.quantity),
            Holds::Outcome(outcome) | Holds::Sigma(outcome) => Some(outcome.quantity()),
            Holds::SigmaStationary => Some(Quantity::ANGLE),
            Holds::Stationary | Holds::Note => None,
        }
    }

    /// The unit that people read it in.
    fn usual_unit(&self) -> &'static str {
        match self.holds {
            Holds::Input(parameter) => parameter.unit,
            Holds::Outcome(outcome) | Holds::Sigma(outcome) => outcome.unit(),
            _ => "deg",
        }
    }

    /// Whether its numbers may have a side: `3.2 L`.
    fn has_side(&self) -> bool {
        match self.holds {
            Holds::Input(parameter) => ["swing.path", "swing.face_angle"].contains(&parameter.name),
            Holds::Outcome(outcome) => {
                [Outcome::Lateral, Outcome::LaunchDirection, Outcome::Sidespin, Outcome::SpinAxis].contains(&outcome)
            }
            _ => false,
        }
    }

    /// One unit of the column, SI.
    pub fn one(&self) -> f64 {
        let size = self.unit.as_ref().and_then(|unit| self.quantity()?.size_of(unit));
        size.unwrap_or(1.0)
    }

    /// The unit that the head names.
    pub fn unit(&self) -> &str {
        self.unit.as_deref().or_else(|| self.quantity().map(|quantity| quantity.si)).unwrap_or_default()
    }

    /// The SI value of a cell; `None` for one that is empty.
    ///
    /// # Errors
    /// A sentence for a cell that is no finite number.
    pub fn value(&self, cell: &str) -> std::result::Result<Option<f64>, String> {
        if cell.is_empty() {
            return Ok(None);
        }
        let Some(number) = launch_monitor::number(cell, self.format.has_decimal_comma, self.has_side()) else {
            return Err(format!(
                "'{cell}' is not a number; units stand in the head, as in '{} [{}]', and an empty cell is a missing value",
                self.head,
                self.unit()
            ));
        };
        match (&self.unit, self.quantity()) {
            (Some(unit), Some(quantity)) => {
                quantity.read(&format!("{number} {unit}")).map(Some).map_err(|error| error.to_string())
            }
            _ => Ok(Some(number)),
        }
    }
}

/// What a measured outcome is: launch monitors, and people, mean the distance to the landing point by carry.
fn measured(outcome: Outcome) -> Outcome {
    if outcome == Outcome::Carry { Outcome::CarryDistance } else { outcome }
}

/// Whether a head is none of this program's: a launch monitor's own, and not spelled as names are here.
fn is_foreign(name: &str, format: Format) -> bool {
    format.is_export && !name.contains(['_', '.']) && name.chars().any(char::is_uppercase)
        || format.is_export && name.is_empty()
        || format.is_export && name.contains(". ")
}

/// The parameter of a column, or an error that names outcomes too.
fn known(setup: &Setup<f64>, name: &str) -> Result<&'static Parameter> {
    setup.variable(name).map_err(|error| match error {
        Error::Unknown { .. } => {
            let names: Vec<_> = setup.parameters().iter().map(|row| row.name).collect();
            let outcomes = Outcome::ALL.iter().map(|outcome| outcome.name());
            let advice =
                "a column is a parameter, an outcome, 'sigma OUTCOME', 'stationary', 'sigma stationary' or 'note'";
            Error::unknown("column", name, names.into_iter().chain(outcomes), advice)
        }
        error => error,
    })
}
