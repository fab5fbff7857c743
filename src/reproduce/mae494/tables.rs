use super::printed;
use crate::drive::{Drive, Outcome};
use crate::error::{Error, Result};
use crate::optimize::Observers;
use crate::parameters::{Setup, Vary};
use crate::reproduce::delivery::{Delivery, LOFT};
use crate::study::{Active, Optimum, Search, optima};

/// A row of a printed table compared with the exact optimum of the same model.
#[derive(Clone, Debug)]
pub struct Row {
    /// The printed row.
    pub printed: Delivery,
    /// The exact optimum of the varied parameters.
    pub best: Optimum,
    /// Active bounds.
    pub active: Vec<Active>,
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
        let setup = &self.best.setup;
        Delivery {
            loft: setup.club.loft,
            attack_angle: setup.swing.attack_angle,
            carry: self.best.value().unwrap_or_default(),
        }
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
    let vary = names
        .iter()
        .map(|name| range(setup, name))
        .collect::<Result<_>>()?;
    let search = Search {
        vary,
        ..Search::largest(Outcome::Carry)
    };
    // the ball does not fly at some printed optima, and carry may have several maxima: use several
    // starts
    let best = optima(&at, &search, 8, &Observers::default())?.best;
    Ok(Row {
        printed,
        active: best.active(),
        best,
        at_printed: carried_if_flown(&at)?,
    })
}

/// The report's range of a parameter.
fn range(setup: &Setup<f64>, name: &str) -> Result<Vary> {
    let ends = if name == LOFT {
        printed::LOFT
    } else {
        printed::ATTACK
    };
    let [low, high] = ends.map(f64::to_radians);
    Vary::new(setup.variable(name)?, low, high)
}

/// Carry of a drive, m.
pub(super) fn carried(setup: &Setup<f64>) -> Result<f64> {
    Ok(Drive::new(setup)?.landed()?.carry)
}

/// Carry of a drive, m; `None` if the ball does not fly.
pub(super) fn carried_if_flown(setup: &Setup<f64>) -> Result<Option<f64>> {
    match carried(setup) {
        Err(Error::NoFlight { .. }) => Ok(None),
        carried => carried.map(Some),
    }
}
