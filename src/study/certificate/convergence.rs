use super::order::{Errors, MEASURED, MeasuredOrder, measure, measure_largest};
use super::scale::{scale, size_of_terms};
use crate::aerodynamics::AerodynamicLaw;
use crate::derivative::check::{NEGLIGIBLE, Verdict};
use crate::derivative::{Order, Taylor, evaluate};
use crate::drive::{ComputedFrom, Drive, Outcome};
use crate::error::Result;
use crate::parameters::{Parameter, Setup};
use crate::statistics::largest_magnitude;
use serde::Serialize;

/// Step sizes for a smooth law. The error of the apex depends on its position within a time step.
/// Each level has several neighbouring step sizes, so that a fit averages over this position.
const LEVELS: Levels = Levels {
    coarsest: 16,
    count: 6,
    neighbours: 3,
    octaves: 0.36,
};

/// Step sizes for a piecewise law with k continuous derivatives at its joins. A step across a join
/// has an error of h^(k+2) times a function of the join's position in the step. The sum of these
/// errors varies irregularly from flight to flight, so only the largest error of many flights
/// decreases with a power of h. The steps must be short: few of them may cross two joins.
pub(super) const LEVELS_ACROSS_JOINS: Levels = Levels {
    coarsest: 64,
    count: 4,
    neighbours: 12,
    octaves: 1.0,
};

/// Number of steps of the reference flight.
const REFERENCE: u32 = 4096;

/// Number of steps of a second reference flight, which differs from the first mainly by rounding.
/// Errors below `ROUNDING_FACTOR` times this difference count as rounding.
const SECOND_REFERENCE: u32 = 2048;
const ROUNDING_FACTOR: f64 = 10.0;

/// Reason for no result in a logarithmic wind.
pub(super) const LOG_WIND: &str = "the logarithmic wind changes within half a metre above the \
                                   ground, and most of the compared time steps cross this layer \
                                   in one step";
const STEPS_TOO_LONG: &str = "the time steps from which the order is measured are too long for \
                              this flight, or for the decay of its spin";
const NO_REFERENCE: &str = "a flight with short time steps, to which the others are compared, \
                            failed";

/// Thresholds for the relative errors of the value and of the gradient. Smaller errors count as
/// rounding.
const ROUNDING: [f64; 2] = [1e-12, 1e-11];

/// Numbers of time steps of the flights. The numbers double from level to level.
pub(super) struct Levels {
    /// Smallest number of steps of the coarsest level.
    coarsest: u32,
    pub count: usize,
    /// Flights per level, with logarithmically spaced numbers of steps.
    neighbours: u32,
    /// Range of the numbers of steps of a level, in octaves (factors of 2).
    octaves: f64,
}

impl Levels {
    pub fn steps(&self, level: usize) -> impl Iterator<Item = u32> {
        let first = f64::from(self.coarsest << level);
        let spacing = self.octaves / f64::from(self.neighbours);
        (0..self.neighbours).map(move |k| (first * (f64::from(k) * spacing).exp2()).round() as u32)
    }
}

/// The convergence of an outcome with the time step.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "ConvergenceCheck"))]
pub struct Convergence {
    /// The outcome.
    pub of: Outcome,
    /// The time steps, s.
    pub steps: Vec<f64>,
    /// The relative error of the value for each time step.
    pub value_errors: Vec<f64>,
    /// The relative error of the gradient for each time step.
    pub gradient_errors: Vec<f64>,
    /// The measured orders for value and gradient; `null` if the errors are dominated by rounding.
    pub orders: [Option<f64>; 2],
    /// The expected orders.
    pub expected: [u32; 2],
    /// The number of continuous derivatives of drag and lift where the pieces of the law meet, if
    /// this lowers an expected order; otherwise `null`.
    pub limited_by_law: Option<u32>,
    /// `pass` or `fail`.
    pub verdict: Verdict,
    /// For value and gradient: true if the order is lower than expected. A low slope of the errors
    /// does not prove this: the slope is also low where the first two error terms cancel.
    #[serde(skip)]
    pub falls_short: [bool; 2],
    /// For value and gradient: true if the test fails with the expected order plus 1. The test is
    /// then sensitive enough to detect a mistake.
    #[serde(skip)]
    pub would_detect_higher_order: [bool; 2],
}

/// Convergence of outcomes and of their derivatives by `wrt` with decreasing time step. Steps
/// longer than 1 s or than the spin decay time are skipped. The inner error is the reason why the
/// order cannot be measured: a logarithmic wind, too few remaining steps, or a reference flight
/// that failed. Empty if `goes_on` returns false.
///
/// # Errors
/// The errors of [`evaluate`].
pub(super) fn convergence(
    setup: &Setup<f64>,
    of: &[Outcome],
    wrt: &[&'static Parameter],
    goes_on: &dyn Fn() -> bool,
) -> Result<std::result::Result<Vec<Convergence>, &'static str>> {
    if setup.wind.roughness.is_some() {
        return Ok(Err(LOG_WIND));
    }
    let drive = Drive::new(setup)?;
    let Some(time) = fine_flight_time(setup, drive.landed()?.flight_time) else {
        return Ok(Err(NO_REFERENCE));
    };
    // initial decay rate of spin, 1/s: δ + κ |v|/R (docs/model.md, eq. 13)
    let by_way = setup.aero.spin_damping.unwrap_or_default() / setup.ball.radius;
    let decay_rate = setup.aero.spin_decay + by_way * drive.launch.ball_speed();
    // the landing lies in the middle of the last step: this keeps the ends of steps away from the
    // landing
    let step = |steps: u32| time / (f64::from(steps) - 0.5);
    let is_short = |steps: u32| step(steps) <= 1.0 && step(steps) * decay_rate <= 1.0;
    if !is_short(SECOND_REFERENCE) {
        return Ok(Err(STEPS_TOO_LONG));
    }
    let at = |level: usize, steps: u32| {
        let mut setup = *setup;
        setup.flight.step = step(steps);
        if !is_short(steps) || !goes_on() {
            return None;
        }
        Some(SteppedDrive {
            level,
            step: setup.flight.step,
            // skip a flight that fails because its step is too long
            taylors: evaluate(&setup, of, wrt, Order::First).ok()?,
        })
    };
    let scales = wrt.iter().map(|parameter| scale(setup, parameter));
    let comparison = StepComparison::new(setup, &drive, scales.collect(), &at);
    if !goes_on() {
        return Ok(Ok(vec![]));
    }
    let convergences = |comparison: StepComparison<'_>| {
        let outcomes = of.iter().enumerate();
        outcomes
            .map(|(i, of)| comparison.convergence(i, *of))
            .collect()
    };
    Ok(comparison.map(convergences))
}

/// Outcomes with derivatives, computed with one time step.
struct SteppedDrive {
    /// Level to which the number of steps belongs; see [`Levels`].
    level: usize,
    /// Time step, s.
    step: f64,
    taylors: Vec<Taylor>,
}

/// A flight at several time steps, and the reference flights.
struct StepComparison<'a> {
    setup: &'a Setup<f64>,
    drive: &'a Drive<f64>,
    scales: Vec<f64>,
    reference: Vec<Taylor>,
    /// Outcomes of a second reference flight, which differ from `reference` mainly by rounding.
    second_reference: Vec<Taylor>,
    flown: Vec<SteppedDrive>,
    measure: fn(&[Errors], u32, f64) -> Option<MeasuredOrder>,
}

impl<'a> StepComparison<'a> {
    /// Computes the reference flights, then the flights with the step sizes of all levels.
    ///
    /// # Errors
    /// The reason, if a reference flight fails, or if flights succeed at too few levels to measure
    /// an order.
    fn new(
        setup: &'a Setup<f64>,
        drive: &'a Drive<f64>,
        scales: Vec<f64>,
        fly: &dyn Fn(usize, u32) -> Option<SteppedDrive>,
    ) -> std::result::Result<Self, &'static str> {
        let reference = fly(0, REFERENCE).ok_or(NO_REFERENCE)?.taylors;
        let second_reference = fly(0, SECOND_REFERENCE).ok_or(NO_REFERENCE)?.taylors;
        let has_joins = setup.law.properties().continuous_derivatives.is_some();
        let levels = if has_joins {
            LEVELS_ACROSS_JOINS
        } else {
            LEVELS
        };
        let flown: Vec<SteppedDrive> = (0..levels.count)
            .flat_map(|level| levels.steps(level).map(move |steps| (level, steps)))
            .filter_map(|(level, steps)| fly(level, steps))
            .collect();
        let coarsest = flown.iter().map(|flown| flown.level).min();
        if coarsest.is_none_or(|level| level + MEASURED > levels.count) {
            return Err(STEPS_TOO_LONG);
        }
        Ok(Self {
            setup,
            drive,
            scales,
            reference,
            second_reference,
            flown,
            measure: if has_joins { measure_largest } else { measure },
        })
    }

    fn convergence(&self, i: usize, of: Outcome) -> Convergence {
        let size = size_of_terms(of, self.setup, self.drive);
        let errors_of =
            |taylors: &[Taylor]| errors(&taylors[i], &self.reference[i], size, &self.scales);
        let sample = |flown: &SteppedDrive| {
            errors_of(&flown.taylors).map(|errors| Errors {
                level: flown.level,
                step: flown.step,
                errors,
            })
        };
        let samples: Vec<[Errors; 2]> = self.flown.iter().map(sample).collect();
        let rounding = errors_of(&self.second_reference)
            .map(|errors| ROUNDING_FACTOR * largest_magnitude(&errors));
        let of_smooth_law = orders_of_smooth_law(self.setup, of);
        let law_derivatives = self.setup.law.properties().continuous_derivatives;
        // a step across a join has an error of h^(k+2) times a function of the join's position in
        // the step; a parameter moves the join through the steps at a rate proportional to 1/h, so
        // the derivative has an error of h^(k+1)
        let expected = match law_derivatives {
            Some(k) => [of_smooth_law[0].min(k + 2), of_smooth_law[1].min(k + 1)],
            None => of_smooth_law,
        };
        let measure_with = |more: u32| {
            [0, 1].map(|which: usize| {
                let samples: Vec<Errors> = samples.iter().map(|pair| pair[which].clone()).collect();
                (self.measure)(
                    &samples,
                    expected[which] + more,
                    ROUNDING[which].max(rounding[which]),
                )
            })
        };
        let measured = measure_with(0);
        let falls_short = measured.map(|measured| measured.is_some_and(|it| it.falls_short));
        let largest_of = |which: usize| {
            let errors = samples.iter().map(|pair| &pair[which].errors);
            errors.map(largest_magnitude).collect()
        };
        Convergence {
            of,
            steps: samples.iter().map(|pair| pair[0].step).collect(),
            value_errors: largest_of(0),
            gradient_errors: largest_of(1),
            orders: measured.map(|measured| measured.map(|it| it.order)),
            expected,
            limited_by_law: law_derivatives.filter(|_| expected != of_smooth_law),
            verdict: Verdict::of(falls_short == [false; 2]),
            falls_short,
            would_detect_higher_order: measure_with(1)
                .map(|measured| measured.is_some_and(|it| it.falls_short)),
        }
    }
}

/// Flight time at the reference step; `None` if the ball does not land. The flight time at the
/// setup's own step is not exact enough: its error may be as long as a compared step, so that a
/// compared step could end at the landing.
fn fine_flight_time(setup: &Setup<f64>, about: f64) -> Option<f64> {
    let mut setup = *setup;
    setup.flight.step = about / f64::from(REFERENCE);
    Some(Drive::new(&setup).ok()?.landed().ok()?.flight_time)
}

/// Expected orders of convergence p of the value and of the gradient for a smooth law: the order of
/// the method, or the order of the interpolation if that is lower.
/// - Dense output of degree 7: the error is h⁸ in a position and h⁷ in its derivatives. A velocity,
///   and the time at which a velocity is 0, have one order less.
/// - Apex: within a step, the velocity error is h^p times a function of the position in the step. A
///   parameter moves the apex through the steps at a rate proportional to 1/h, so the derivatives
///   have errors h^(p−1). A landing keeps the order p: it lies in the middle of a step, where this
///   function is flat.
fn orders_of_smooth_law(setup: &Setup<f64>, of: Outcome) -> [u32; 2] {
    let interpolated = match of.computed_from() {
        // with spin damping, the spin at landing is interpolated with degree 5
        ComputedFrom::Rest => [6, 5],
        ComputedFrom::LandingVelocity | ComputedFrom::ApexTime => [7, 6],
        ComputedFrom::Landing
        | ComputedFrom::ApexHeight
        | ComputedFrom::Launch
        | ComputedFrom::Head => [8, 7],
    };
    let order = setup.method.order();
    let of_method = match of.computed_from() {
        ComputedFrom::ApexTime => [order, order - 1],
        _ => [order; 2],
    };
    [0, 1].map(|which: usize| of_method[which].min(interpolated[which]))
}

/// Relative errors of the value and of each gradient entry. The error of the value is divided by
/// `size`, the outcome's magnitude. The errors of the gradient (by scaled parameters) are divided
/// by its largest entry, or by [`NEGLIGIBLE`] times `size` if that is larger.
fn errors(found: &Taylor, reference: &Taylor, size: f64, scales: &[f64]) -> [Vec<f64>; 2] {
    let entries = reference
        .gradient
        .iter()
        .zip(scales)
        .map(|(d, scale)| (d * scale).abs());
    let steepness = entries.fold(NEGLIGIBLE * size, f64::max);
    let off = found.gradient.iter().zip(&reference.gradient).zip(scales);
    let of_gradient =
        off.map(|((found, reference), scale)| (found - reference) * scale / steepness);
    [
        vec![(found.value - reference.value) / size],
        of_gradient.collect(),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reason_without_convergence_tells_a_failed_reference_from_too_long_steps() {
        let setup = Setup::modern_driver();
        let drive = Drive::new(&setup).unwrap();
        let reason = |fly: &dyn Fn(usize, u32) -> Option<SteppedDrive>| {
            StepComparison::new(&setup, &drive, vec![], fly).err()
        };
        let reference_only = |level: usize, steps: u32| {
            (steps >= SECOND_REFERENCE).then(|| SteppedDrive {
                level,
                step: 1.0 / f64::from(steps),
                taylors: vec![],
            })
        };
        assert_eq!(reason(&|_, _| None), Some(NO_REFERENCE));
        assert_eq!(reason(&reference_only), Some(STEPS_TOO_LONG));
    }
}
