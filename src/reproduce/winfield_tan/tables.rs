//! The printed optima, recomputed.

use crate::drive::{Drive, Outcome};
use crate::error::{Error, Result};
use crate::optimize::{Observer, Status};
use crate::parameters::{Setup, Vary};
use crate::reproduce::delivery::{Delivery, LOFT};
use crate::study::{Search, optimum as search};
use crate::units::Quantity;

/// Search range of the loft, deg, far beyond the printed values.
const LOFTS: [f64; 2] = [-10.0, 40.0];
/// Search range of the attack angle, deg, far beyond the printed values.
const ATTACKS: [f64; 2] = [-20.0, 50.0];

/// An optimum, computed and printed.
#[derive(Clone, Copy, Debug)]
pub struct Best {
    /// Computed optimum.
    pub computed: Delivery,
    /// Printed optimum, corrected.
    pub printed: Delivery,
    /// Carry that the model computes for the printed delivery, m.
    pub at_printed: f64,
}

/// The optima of a printed table: loft, deg; attack angle, deg; carry, yd.
pub(super) fn rows(setup: &Setup<f64>, printed: &[[f64; 3]], names: &[&str]) -> Result<Vec<Best>> {
    printed
        .iter()
        .map(|printed| best(setup, *printed, names))
        .collect()
}

/// Best loft at attack angles within ±6° of the optimum.
pub(super) fn ridge(setup: &Setup<f64>, top: &Best) -> Result<Vec<Delivery>> {
    let steps = (-6..=6).map(|step| top.computed.attack_angle + f64::from(step).to_radians());
    let mut from = top.computed;
    steps
        .map(|attack_angle| {
            from.attack_angle = attack_angle;
            from = searched(setup, from, &[LOFT])?;
            Ok(from)
        })
        .collect()
}

/// The optimum over the parameters `names`, compared with the printed one: loft, deg; attack angle,
/// deg; carry, yd.
pub(super) fn best(setup: &Setup<f64>, printed: [f64; 3], names: &[&str]) -> Result<Best> {
    let [loft, attack_angle, carry] = printed;
    let yard = Quantity::LENGTH.size_of("yd").unwrap_or(f64::NAN);
    let printed = Delivery::in_degrees(loft, attack_angle, carry * yard);
    let at_printed = Drive::new(&printed.set(setup))?.landed()?.carry;
    Ok(Best {
        computed: searched(setup, printed, names)?,
        printed,
        at_printed,
    })
}

/// The optimum over the parameters `names`, searched from the delivery `from`.
fn searched(setup: &Setup<f64>, from: Delivery, names: &[&str]) -> Result<Delivery> {
    let range = |name: &&str| {
        let [low, high] = if *name == LOFT { LOFTS } else { ATTACKS };
        Vary::new(setup.variable(name)?, low.to_radians(), high.to_radians())
    };
    let vary = names.iter().map(range).collect::<Result<Vec<_>>>()?;
    let asked = Search {
        vary,
        ..Search::largest(Outcome::Carry)
    };
    let found = search(&from.set(setup), asked, Observer::default())?;
    match found.value() {
        Some(carry) if found.solution.status == Status::Converged => Ok(Delivery {
            loft: found.setup.club.loft,
            attack_angle: found.setup.swing.attack_angle,
            carry,
        }),
        _ => Err(Error::NotConverged {
            status: found.status(),
            message: found.message(),
        }),
    }
}
