use super::searches::{Searches, searches};
use super::while_loop::{LoopLanding, fly_past_the_ground};
use crate::derivative::{self, Order};
use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::Setup;
use crate::reproduce::delivery::{LOFT, carry, with_delivery};
use serde::Serialize;

/// The "noise" of the report's flight loop: carry is a sawtooth function of loft, and finite
/// differences give the slope of a single tooth.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Noise {
    /// The attack angle, rad.
    #[serde(rename = "swing.attack_angle")]
    pub attack_angle: f64,
    /// The time step of the report's flight loop, s.
    pub step: f64,
    /// The increment of the loft for forward differences, rad: √ε, as in MATLAB's `fmincon`.
    pub difference: f64,
    /// The jumps (teeth) of the carry in `zoom`.
    pub teeth: Sawtooth,
    /// The derivative of carry by loft at each loft, m/rad.
    pub slopes: Vec<Slopes>,
    /// Number of lofts at which the forward difference of the report's loop has the wrong sign.
    pub wrong_signs: usize,
    /// Forward differences of the report's loop at loft 10°, for shorter time steps.
    pub shorter_steps: Vec<ShorterStep>,
    /// Forward differences at loft 10° with larger increments of the loft.
    pub longer_differences: Vec<LongerDifference>,
    /// The carry by loft near 10°.
    pub zoom: Vec<Landings>,
    /// Searches, by definition of the landing and by method.
    pub searches: Vec<Searches>,
}

/// The forward difference of the while-loop's carry with a shorter time step.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ShorterStep {
    /// The time step, s.
    pub step: f64,
    /// The forward difference of the report's loop, m/rad.
    #[serde(rename = "loop")]
    pub overshot: f64,
}

/// Forward differences for a larger increment of the loft.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct LongerDifference {
    /// The increment of the loft, rad.
    pub difference: f64,
    /// The forward difference of the report's loop, m/rad.
    #[serde(rename = "loop")]
    pub overshot: f64,
    /// The forward difference of the carry that is interpolated between the last two steps of the
    /// report's loop, m/rad.
    pub interpolated: f64,
    /// The forward difference of the carry of this library's flight, m/rad.
    pub smooth: f64,
}

/// Carry at one loft, by three definitions of the landing.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Landings {
    /// The loft, rad.
    #[serde(rename = "club.loft")]
    pub loft: f64,
    /// Carry at the end of the report's loop, m.
    #[serde(rename = "loop")]
    pub overshot: f64,
    /// Carry interpolated between the last two steps of the report's loop, m.
    pub interpolated: f64,
    /// Carry of this library's flight, a smooth function of loft, m.
    pub smooth: f64,
}

/// Sawtooth of the carry of the report's loop. The carry jumps where the number of time steps
/// changes.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Sawtooth {
    /// Number of jumps in `zoom`.
    pub count: usize,
    /// Mean spacing of the jumps, rad: the range of the lofts in `zoom`, divided by `count`.
    pub width: f64,
    /// Mean height of the jumps, m.
    pub height: f64,
}

/// Derivatives of carry by loft, m/rad.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Slopes {
    /// The loft, rad.
    #[serde(rename = "club.loft")]
    pub loft: f64,
    /// Exact derivative at landing.
    pub exact: f64,
    /// Exact derivative at a fixed flight time: without the term for the change of the landing
    /// time.
    pub at_fixed_time: f64,
    /// Forward difference of the report's loop.
    #[serde(rename = "loop")]
    pub overshot: f64,
    /// Forward difference of the carry that is interpolated between the last two steps of the
    /// report's loop.
    pub interpolated: f64,
    /// True if the forward difference of the report's loop has the wrong sign.
    pub sign_is_wrong: bool,
}

/// Number of intervals between the points of [`Noise::zoom`].
const ZOOM: u32 = 400;
/// Half-width of the range of [`Noise::zoom`] about 10°, deg.
const REACH: f64 = 0.5;

impl Noise {
    /// Studies the noise, with the air and the club of `setup`.
    pub(super) fn new(setup: &Setup<f64>, progress: &mut impl FnMut(&str)) -> Result<Self> {
        let (step, difference) = (setup.flight.step, f64::EPSILON.sqrt());
        let smooth_at = |loft: f64| carry(&with_delivery(setup, loft, 0.0));
        let ten = 10.0_f64.to_radians();

        let zoom = (0..=ZOOM).map(|k| {
            let loft = (10.0 + REACH * (2.0 * f64::from(k) / f64::from(ZOOM) - 1.0)).to_radians();
            Landings::at(setup, loft)
        });
        let zoom: Vec<Landings> = zoom.collect::<Result<_>>()?;
        let forward = |loft: f64, by: f64, step: f64| loop_slopes(setup, loft, by, step);
        let slopes =
            (6..=20).map(|degrees| Slopes::at(setup, f64::from(degrees).to_radians(), difference));
        let shorter = [step, 0.1 * step, 0.01 * step, 0.001 * step];
        let shorter = shorter.map(|step| {
            let [overshot, _] = forward(ten, difference, step)?;
            Ok(ShorterStep { step, overshot })
        });
        let longer = [difference, 1e-6, 1e-4, 1e-3, 1e-2, 1e-1].map(|longer| {
            let [overshot, interpolated] = forward(ten, longer, step)?;
            Ok(LongerDifference {
                difference: longer,
                overshot,
                interpolated,
                smooth: (smooth_at(ten + longer)? - smooth_at(ten)?) / longer,
            })
        });
        let slopes = slopes.collect::<Result<Vec<_>>>()?;
        let shorter_steps = shorter.into_iter().collect::<Result<_>>()?;
        let longer_differences = longer.into_iter().collect::<Result<_>>()?;
        progress("searches with the flight loop");
        Ok(Self {
            attack_angle: 0.0,
            step,
            difference,
            teeth: Sawtooth::of(&zoom),
            wrong_signs: slopes.iter().filter(|at| at.sign_is_wrong).count(),
            slopes,
            shorter_steps,
            longer_differences,
            zoom,
            searches: searches(setup)?,
        })
    }
}

impl Landings {
    /// The carries at this loft and attack angle 0°.
    fn at(setup: &Setup<f64>, loft: f64) -> Result<Self> {
        let level = with_delivery(setup, loft, 0.0);
        let LoopLanding {
            overshot,
            interpolated,
        } = fly_past_the_ground(&level, setup.flight.step)?;
        Ok(Self {
            loft,
            overshot,
            interpolated,
            smooth: carry(&level)?,
        })
    }
}

impl Slopes {
    fn at(setup: &Setup<f64>, loft: f64, difference: f64) -> Result<Self> {
        let step = setup.flight.step;
        let [overshot, interpolated] = loop_slopes(setup, loft, difference, step)?;
        let (exact, at_fixed_time) = exact_slopes(&with_delivery(setup, loft, 0.0))?;
        Ok(Self {
            loft,
            exact,
            at_fixed_time,
            overshot,
            interpolated,
            sign_is_wrong: overshot * exact < 0.0,
        })
    }
}

/// Forward differences of two carries of the report's loop, m/rad: at its last step, and
/// interpolated between its last two steps.
fn loop_slopes(setup: &Setup<f64>, loft: f64, by: f64, step: f64) -> Result<[f64; 2]> {
    let here = fly_past_the_ground(&with_delivery(setup, loft, 0.0), step)?;
    let there = fly_past_the_ground(&with_delivery(setup, loft + by, 0.0), step)?;
    Ok([
        (there.overshot - here.overshot) / by,
        (there.interpolated - here.interpolated) / by,
    ])
}

impl Sawtooth {
    /// Finds the jumps: pairs of neighbouring points at which the change of the loop's carry and
    /// the change of the smooth carry satisfy |Δloop − Δsmooth| > 3 |Δsmooth|.
    fn of(zoom: &[Landings]) -> Self {
        let jump = |pair: &[Landings]| {
            let smooth = pair[1].smooth - pair[0].smooth;
            (pair[1].overshot - pair[0].overshot - smooth, smooth)
        };
        let jumps = zoom
            .windows(2)
            .map(jump)
            .filter(|(jump, smooth)| jump.abs() > 3.0 * smooth.abs());
        let heights: Vec<f64> = jumps.map(|(jump, _)| jump.abs()).collect();
        let count = heights.len();
        let reach = zoom.last().map_or(0.0, |last| last.loft)
            - zoom.first().map_or(0.0, |first| first.loft);
        let per = count.max(1) as f64;
        Self {
            count,
            width: reach / per,
            height: heights.iter().sum::<f64>() / per,
        }
    }
}

/// Two derivatives by the loft λ: of the carry, and of the downrange position z at the fixed
/// landing time t, ∂z/∂λ = d carry/dλ − ż dt/dλ.
fn exact_slopes(setup: &Setup<f64>) -> Result<(f64, f64)> {
    let of = [
        Outcome::Carry,
        Outcome::FlightTime,
        Outcome::LandingSpeed,
        Outcome::DescentAngle,
    ];
    let at = derivative::evaluate(setup, &of, &[setup.variable(LOFT)?], Order::First)?;
    let (carry, time) = (at[0].gradient[0], at[1].gradient[0]);
    let downrange_speed = at[2].value * at[3].value.cos();
    Ok((carry, carry - downrange_speed * time))
}
