use super::printed;
use crate::error::{Error, Result};
use crate::optimize::Observers;
use crate::parameters::Setup;
use crate::reproduce::delivery::{Delivery, carried};
use crate::study::{Optimum, optima};

/// A row of a printed table compared with the exact optimum of the same model.
#[derive(Clone, Debug)]
pub struct Row {
    /// The printed row.
    pub printed: Delivery,
    /// The exact optimum of the varied parameters.
    pub best: Optimum,
    /// Carry that the same model gives for the printed optimum, m; `None` if the ball does not fly.
    pub at_printed: Option<f64>,
}

impl Row {
    /// Loss of carry at the printed optimum, m; the whole carry if the ball does not fly.
    pub fn cost(&self) -> f64 {
        self.best.value().unwrap_or_default() - self.at_printed.unwrap_or_default()
    }

    /// Delivery and carry of the exact optimum.
    pub fn exact(&self) -> Delivery {
        Delivery::of(&self.best)
    }
}

/// The rows of a printed table: loft, deg; attack angle, deg; distance, m.
pub(super) fn rows(setup: &Setup<f64>, printed: &[[f64; 3]], names: &[&str]) -> Result<Vec<Row>> {
    printed
        .iter()
        .map(|printed| row(setup, *printed, names))
        .collect()
}

/// The exact optimum over the parameters `names` within the report's ranges. All other parameters
/// have the printed values: loft, deg; attack angle, deg; distance, m.
pub(super) fn row(setup: &Setup<f64>, printed: [f64; 3], names: &[&str]) -> Result<Row> {
    let [loft, attack_angle, distance] = printed;
    let printed = Delivery::in_degrees(loft, attack_angle, distance);
    let at = printed.set(setup);
    let search = printed::RANGES.longest_carry(setup, names)?;
    // the ball does not fly at some printed optima, and carry may have several maxima: use several
    // starts
    Ok(Row {
        printed,
        best: optima(&at, &search, 8, &Observers::default())?.best,
        at_printed: carried_if_flown(&at)?,
    })
}

/// Carry of a drive, m; `None` if the ball does not fly.
pub(super) fn carried_if_flown(setup: &Setup<f64>) -> Result<Option<f64>> {
    match carried(setup) {
        Err(Error::NoFlight { .. }) => Ok(None),
        carried => carried.map(Some),
    }
}
