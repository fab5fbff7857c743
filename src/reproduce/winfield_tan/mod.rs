//! Winfield & Tan (1994), "Optimization of clubhead loft and swing elevation angles for maximum
//! distance of a golf drive", Computers & Structures 53(1), 19–25.
//!
//! Their drag and lift curves are not printed. The law `winfield-tan` is what their tables say of
//! them: its coefficients come from calibrating it to what the paper prints, and stand in the
//! preset. Everything here flies that preset.

mod average;
mod fit;
mod printed;
mod shot;
mod tables;

pub use average::Mean;
pub use fit::{Decay, Fitted};
pub use printed::MISPRINTS;
pub use shot::{SingleShot, Struck};
pub use tables::{Best, Point};

use crate::error::Result;
use crate::parameters::Setup;
use crate::units::System;

/// The paper, reproduced.
#[derive(Clone, Debug)]
pub struct WinfieldTan {
    /// The preset that is flown.
    pub setup: Setup<f64>,
    /// The single shot of 103 mph: impact and flight.
    pub shot: Struck,
    /// The optimum over loft and attack angle.
    pub optimum: Best,
    /// Along the ridge that it lies on: the best loft at attack angles around it.
    pub ridge: Vec<Point>,
    /// Table 1: the best attack angle at each loft.
    pub table1: Vec<Best>,
    /// Table 2: the best loft at each attack angle.
    pub table2: Vec<Best>,
    /// The average over attack angles of 0–10°.
    pub average: Mean,
    /// How the law came out of the print.
    pub fitted: Fitted,
}

impl WinfieldTan {
    /// The units that the paper prints.
    pub const UNITS: System = System::Us;
}

/// The paper, reproduced; `progress` is told what is being computed.
///
/// # Errors
/// Only what a change to the preset could bring about: what [`optimum`](crate::study::optimum) and
/// [`calibrate`](crate::study::calibrate::calibrate) refuse.
pub fn winfield_tan(mut progress: impl FnMut(&str)) -> Result<WinfieldTan> {
    let setup = Setup::preset("winfield-tan")?;
    progress("the single shot");
    let shot = Struck::new(&setup)?;
    progress("the optimum and the tables");
    let optimum = tables::optimum(&setup)?;
    let (table1, table2) = (tables::table1(&setup)?, tables::table2(&setup)?);
    let ridge = tables::ridge(&setup, &optimum)?;
    progress("the average over attack angles");
    let average = Mean::new(&setup)?;
    progress("the law, calibrated again to the paper");
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
