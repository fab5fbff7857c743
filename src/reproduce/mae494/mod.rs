//! The MAE 494 student report "Optimization of a Golf Driver", which redid Winfield & Tan (1994).
//!
//! Its flight loop overshoots the ground, its optimizer got lost in the teeth that makes, and a
//! regression took its place. Here its constants stand in Winfield & Tan's equations (the preset
//! `mae494`), and every optimum it prints is held against the exact one.

mod average;
mod delivery;
mod launches;
mod lbfgs;
mod noise;
mod parametric;
mod printed;
mod regression;
mod searches;
mod sought;
mod tables;
mod while_loop;

pub use average::Average;
pub use delivery::Delivery;
pub use launches::{Energy, Launched, Subsystems};
pub use noise::{Landings, Noise, Slopes, Teeth};
pub use parametric::{Constant, Parametric};
pub use regression::{Peak, Regression};
pub use searches::{End, Searches};
pub use sought::{Landing, Method};
pub use tables::Row;
pub(super) use while_loop::fly_past_the_ground;

use crate::error::Result;
use crate::parameters::Setup;
use crate::units::System;

/// The report, reproduced.
#[derive(Clone, Debug)]
pub struct Mae494 {
    /// The optimum over both angles, beside the one the report recommends.
    pub optimum: Row,
    /// Its Table 1: the best loft at each attack angle.
    pub table1: Vec<Row>,
    /// Its Table 2: the best attack angle at each loft.
    pub table2: Vec<Row>,
    /// Its regression.
    pub regression: Regression,
    /// The optimum that the slipped regression gives, with what it carries in the model.
    pub slipped: Delivery,
    /// Why its distances cannot be.
    pub energy: Energy,
    /// Its subsystems, each with its own optimum.
    pub subsystems: Subsystems,
    /// Its third study.
    pub average: Average,
    /// Its parametric study.
    pub parametric: Parametric,
    /// Its noise.
    pub noise: Noise,
    /// What searches make of that noise, and of landings without.
    pub searches: Vec<Searches>,
}

impl Mae494 {
    /// The units that the report prints.
    pub const UNITS: System = System::Metric;
}

/// Reproduces the report; `progress` is told what is computed.
///
/// # Errors
/// [`Error::NotConverged`](crate::Error::NotConverged) where a search fails.
pub fn mae494(mut progress: impl FnMut(&str)) -> Result<Mae494> {
    let setup = Setup::preset("mae494")?;
    progress("the regression");
    let regression = Regression::new()?;
    let slipped = Delivery {
        loft: regression.slipped.loft,
        attack_angle: printed::REGRESSION_ATTACK.to_radians(),
        carry: 0.0,
    };
    let slipped = Delivery {
        carry: tables::carried(&slipped.set(&setup))?,
        ..slipped
    };
    progress("the tables");
    let optimum = tables::optimum(&setup)?;
    let (table1, table2) = (tables::table1(&setup)?, tables::table2(&setup)?);
    progress("launches");
    let energy = Energy::new(&setup, optimum.printed.carry)?;
    let subsystems = Subsystems::new(&optimum)?;
    progress("the flight loop's noise");
    let noise = Noise::new(&setup)?;
    progress("searches with the flight loop");
    let searches = searches::searches(&setup)?;
    progress("the parametric study");
    Ok(Mae494 {
        average: Average::new(&setup)?,
        parametric: Parametric::new(&optimum)?,
        optimum,
        table1,
        table2,
        regression,
        slipped,
        energy,
        subsystems,
        noise,
        searches,
    })
}
