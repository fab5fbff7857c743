//! The printed optima, recomputed.

use crate::error::Result;
use crate::optimize::Observer;
use crate::parameters::Setup;
use crate::reproduce::delivery::{Delivery, LOFT, Ranges, carried};
use crate::study::optimum;
use crate::units::YARD;

/// Search ranges far beyond the printed values.
const RANGES: Ranges = Ranges {
    loft: [-10.0, 40.0],
    attack_angle: [-20.0, 50.0],
};

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
    let printed = Delivery::in_degrees(loft, attack_angle, carry * YARD);
    let at_printed = carried(&printed.set(setup))?;
    Ok(Best {
        computed: searched(setup, printed, names)?,
        printed,
        at_printed,
    })
}

/// The optimum over the parameters `names`, searched from the delivery `from`.
fn searched(setup: &Setup<f64>, from: Delivery, names: &[&str]) -> Result<Delivery> {
    let search = RANGES.longest_carry(setup, names)?;
    let found = optimum(&from.set(setup), search, Observer::default())?;
    found.check_converged()?;
    Ok(Delivery::of(&found))
}
