//! What the head of a table of shots says of a column.

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
}

/// A column of optima.
const STATIONARY: &str = "stationary";
/// A column for people.
const NOTE: &str = "note";

impl Column {
    /// Reads `carry [yd]`, `sigma carry [yd]`, `club.loft [deg]`, `stationary`, `note`.
    pub fn read(setup: &Setup<f64>, head: &str) -> Result<Self> {
        let head = head.trim_start_matches('\u{feff}').trim();
        let (name, unit) = match head.split_once('[') {
            Some((name, unit)) => (name.trim(), Some(unit.trim_end().trim_end_matches(']').trim().to_owned())),
            None => (head, None),
        };
        let holds = match name.strip_prefix("sigma ").map(str::trim) {
            Some(STATIONARY) => Holds::SigmaStationary,
            Some(outcome) => Holds::Sigma(Outcome::named(outcome)?),
            None if name == STATIONARY => Holds::Stationary,
            None if name == NOTE => Holds::Note,
            None => Outcome::named(name).map(Holds::Outcome).or_else(|_| known(setup, name).map(Holds::Input))?,
        };
        let column = Self { holds, head: name.into(), unit };
        column.check_unit()?;
        Ok(column)
    }

    fn check_unit(&self) -> Result<()> {
        match (&self.unit, self.quantity()) {
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
        let number: Option<f64> = cell.replace('\u{2212}', "-").parse().ok().filter(|number: &f64| number.is_finite());
        let Some(number) = number else {
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
