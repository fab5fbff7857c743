//! Winfield & Tan (1994), "Optimization of clubhead loft and swing elevation angles for maximum
//! distance of a golf drive", Computers & Structures 53(1), 19–25.
//!
//! The paper does not print its drag and lift curves. The coefficients of the law `winfield-tan`
//! come from a calibration to the printed results, and are stored in the preset, which is used
//! here.

mod average;
mod fit;
mod printed;
mod shot;
mod tables;

pub use average::Mean;
pub use fit::{Decay, Fitted, FittedNumber};
pub use printed::MISPRINTS;
pub use shot::{ShotComparison, SingleShot};
pub use tables::Best;

use crate::error::Result;
use crate::parameters::Setup;
use crate::reproduce::delivery::{ATTACK_ANGLE, Delivery, LOFT};
use crate::units::System;

/// Reproduction of the paper.
#[derive(Clone, Debug)]
pub struct WinfieldTan {
    /// The preset.
    pub setup: Setup<f64>,
    /// The single shot at 103 mph: impact and flight.
    pub shot: ShotComparison,
    /// The optimum over loft and attack angle.
    pub optimum: Best,
    /// Best loft at attack angles around the optimum.
    pub ridge: Vec<Delivery>,
    /// Table 1: best attack angle at each loft.
    pub table1: Vec<Best>,
    /// Table 2: best loft at each attack angle.
    pub table2: Vec<Best>,
    /// Mean over attack angles of 0–10°.
    pub average: Mean,
    /// Calibration of the law.
    pub fitted: Fitted,
}

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
    let optimum = tables::best(&setup, printed::OPTIMUM, &[LOFT, ATTACK_ANGLE])?;
    let table1 = tables::rows(&setup, &printed::TABLE_1, &[ATTACK_ANGLE])?;
    let by_attack = printed::TABLE_2.map(|[attack, loft, carry]| [loft, attack, carry]);
    let table2 = tables::rows(&setup, &by_attack, &[LOFT])?;
    let ridge = tables::ridge(&setup, &optimum)?;
    progress("the average over attack angles");
    let average = Mean::new(&setup)?;
    progress("the aerodynamic law, calibrated again to the data of the paper");
    let fitted = Fitted::new(&setup)?;
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
