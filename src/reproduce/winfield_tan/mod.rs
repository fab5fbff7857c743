//! Winfield & Tan (1994), "Optimization of clubhead loft and swing elevation angles for maximum
//! distance of a golf drive", Computers & Structures 53(1), 19–25.
//!
//! The paper does not print its drag and lift curves. The coefficients of the law `winfield-tan`
//! come from a calibration to the printed results. The preset `winfield-tan` stores them, and the
//! reproduction uses this preset.

mod average;
mod fit;
mod printed;
mod shot;

pub use average::InterpolatedAverage;
pub use fit::{Decay, FittedNumber, RefittedLaw};
pub use printed::MISPRINTS;
pub use shot::{ShotComparison, SingleShot};

use crate::error::Result;
use crate::optimize::Observer;
use crate::parameters::Setup;
use crate::reproduce::RecomputedOptimum;
use crate::reproduce::delivery::{ATTACK_ANGLE, DeliveryCarry, LOFT, Ranges, with_delivery};
use crate::study::optimum;
use crate::units::{System, YARD};

/// Reproduction of the paper.
#[derive(Clone, Debug)]
pub struct WinfieldTan {
    /// The preset.
    pub setup: Setup<f64>,
    /// The single shot at 103 mph: impact and flight.
    pub shot: ShotComparison,
    /// The optimum over loft and attack angle.
    pub optimum: RecomputedOptimum,
    /// Best loft at attack angles around the optimum.
    pub ridge: Vec<DeliveryCarry>,
    /// Table 1: best attack angle at each loft.
    pub table1: Vec<RecomputedOptimum>,
    /// Table 2: best loft at each attack angle.
    pub table2: Vec<RecomputedOptimum>,
    /// Mean over attack angles of 0–10°.
    pub average: InterpolatedAverage,
    /// Calibration of the law.
    pub fitted: RefittedLaw,
}

/// Search ranges. They are far wider than the printed values.
const RANGES: Ranges = Ranges {
    loft: [-10.0, 40.0],
    attack_angle: [-20.0, 50.0],
};

impl WinfieldTan {
    /// Unit system of the paper.
    pub const UNITS: System = System::Us;
}

/// Reproduces the paper; `progress` receives the name of each step as it begins.
///
/// # Errors
/// The errors of [`optimum`](crate::study::optimum) and
/// [`calibrate`](crate::study::calibrate::calibrate), which occur only if the preset is modified.
pub fn winfield_tan(mut progress: impl FnMut(&str)) -> Result<WinfieldTan> {
    let setup = Setup::preset("winfield-tan")?;
    progress("the single shot");
    let shot = ShotComparison::new(&setup)?;
    progress("the optimum and the tables");
    let recomputed = |loft: f64, attack: f64, carry: f64, names: &[&str]| {
        let printed = DeliveryCarry::in_degrees(loft, attack, carry * YARD);
        RecomputedOptimum::new(&setup, printed, names, RANGES, 1)
    };
    let [loft, attack, carry] = printed::OPTIMUM;
    let optimum = recomputed(loft, attack, carry, &[LOFT, ATTACK_ANGLE])?;
    let table1 = printed::TABLE_1
        .into_iter()
        .map(|[loft, attack, carry]| recomputed(loft, attack, carry, &[ATTACK_ANGLE]))
        .collect::<Result<_>>()?;
    let table2 = printed::TABLE_2
        .into_iter()
        .map(|[attack, loft, carry]| recomputed(loft, attack, carry, &[LOFT]))
        .collect::<Result<_>>()?;
    let ridge = ridge(&setup, optimum.exact())?;
    progress("the average over attack angles");
    let average = InterpolatedAverage::new(&setup)?;
    progress("the aerodynamic law, calibrated again to the data of the paper");
    let fitted = RefittedLaw::new(&setup)?;
    Ok(WinfieldTan {
        setup,
        shot,
        optimum,
        ridge,
        table1,
        table2,
        average,
        fitted,
    })
}

/// Best loft at attack angles within ±6° of the optimum.
fn ridge(setup: &Setup<f64>, mut from: DeliveryCarry) -> Result<Vec<DeliveryCarry>> {
    let top = from.attack_angle;
    let search = RANGES.longest_carry(setup, &[LOFT])?;
    (-6..=6)
        .map(|step| {
            let attack_angle = top + f64::from(step).to_radians();
            let at = with_delivery(setup, from.loft, attack_angle);
            let found = optimum(&at, search.clone(), Observer::default())?;
            found.check_converged()?;
            from = DeliveryCarry::of(&found);
            Ok(from)
        })
        .collect()
}
