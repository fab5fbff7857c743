//! The MAE 494 student report "Optimization of a Golf Driver", which repeated Winfield & Tan
//! (1994).
//!
//! The report's flight loop overshoots the ground, which makes carry discontinuous. The report's
//! optimizer failed on these discontinuities, and a regression replaced the optimizer. Here the
//! report's constants are used in Winfield & Tan's equations (preset `mae494`), and every printed
//! optimum is compared with the exact optimum.

mod launches;
mod lbfgs;
mod noise;
mod objective;
mod parametric;
mod printed;
mod regression;
mod searches;
mod while_loop;

pub use launches::{ByLaunch, Energy, Launched, Subsystems};
pub use noise::{Landings, LongerDifference, Noise, Sawtooth, ShorterStep, Slopes};
pub use objective::{LandingDefinition, SearchMethod};
pub use parametric::{ChangedOptimum, Constant, ConstantChange, Parametric};
pub use regression::{Peak, Regression};
pub use searches::{End, Searches};
pub use while_loop::{LoopLanding, LoopRow, loop_landing, while_loop};

use crate::error::Result;
use crate::parameters::Setup;
use crate::reproduce::delivery::{ATTACK_ANGLE, DeliveryCarry, LOFT};
use crate::reproduce::{Average, RecomputedOptimum};
use crate::units::System;

/// Reproduction of the report.
#[derive(Clone, Debug)]
pub struct Mae494 {
    /// The optimum over loft and attack angle, compared with the recommended optimum.
    pub optimum: RecomputedOptimum,
    /// Table 1: best loft at each attack angle.
    pub table1: Vec<RecomputedOptimum>,
    /// Table 2: best attack angle at each loft.
    pub table2: Vec<RecomputedOptimum>,
    /// The report's regression.
    pub regression: Regression,
    /// Optimum of the regression polynomial that is evaluated with wrong powers of loft, and the
    /// carry that the model computes at this optimum.
    pub with_wrong_powers: DeliveryCarry,
    /// Check of the printed distances by energy.
    pub energy: Energy,
    /// Optima of the flight alone and of the impact alone.
    pub subsystems: Subsystems,
    /// Third study: mean over attack angles.
    pub average: Average,
    /// Parametric study.
    pub parametric: Parametric,
    /// The report's flight loop computes a carry with jumps: the jumps, and the ends of searches.
    pub noise: Noise,
}

impl Mae494 {
    /// Unit system of the report.
    pub const UNITS: System = System::Metric;
}

/// Number of starts of each search. One start is not enough: carry may have several maxima, and the
/// ball does not fly at some printed optima.
const STARTS: usize = 8;

/// Reproduces the report; `progress` receives the name of each study as it begins.
///
/// # Errors
/// [`Error::NotConverged`](crate::Error::NotConverged) if a search fails.
pub fn mae494(mut progress: impl FnMut(&str)) -> Result<Mae494> {
    let setup = Setup::preset("mae494")?;
    progress("the regression");
    let regression = Regression::new()?;
    let attack_angle = printed::REGRESSION_ATTACK.to_radians();
    let with_wrong_powers =
        DeliveryCarry::flown(&setup, regression.with_wrong_powers.loft, attack_angle)?;
    progress("the tables");
    let recomputed = |loft: f64, attack: f64, carry: f64, names: &[&str]| {
        let printed = DeliveryCarry::in_degrees(loft, attack, carry);
        RecomputedOptimum::new(&setup, printed, names, printed::RANGES, STARTS)
    };
    let [loft, attack, carry] = printed::OPTIMUM;
    let optimum = recomputed(loft, attack, carry, &[LOFT, ATTACK_ANGLE])?;
    let table1 = printed::TABLE_1
        .into_iter()
        .map(|[attack, loft, carry]| recomputed(loft, attack, carry, &[LOFT]))
        .collect::<Result<_>>()?;
    let table2 = printed::TABLE_2
        .into_iter()
        .map(|[loft, attack, carry]| recomputed(loft, attack, carry, &[ATTACK_ANGLE]))
        .collect::<Result<_>>()?;
    progress("launches");
    let energy = Energy::new(&setup, optimum.printed.carry)?;
    let subsystems = Subsystems::new(&optimum)?;
    progress("the flight loop's noise");
    let noise = Noise::new(&setup, &mut progress)?;
    progress("the parametric study");
    Ok(Mae494 {
        average: Average::new(
            &setup,
            &printed::AVERAGED_LOFTS,
            printed::AVERAGE_LOFT,
            printed::RANGES.loft,
        )?,
        parametric: Parametric::new(&optimum)?,
        optimum,
        table1,
        table2,
        regression,
        with_wrong_powers,
        energy,
        subsystems,
        noise,
    })
}
