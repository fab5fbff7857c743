use super::order::{Errors, MEASURED, Measured, measure, measure_largest};
use super::scale::{scale, size};
use crate::aerodynamics::AerodynamicLaw;
use crate::derivative::check::NEXT_TO_NOTHING;
use crate::derivative::{Taylor, jacobian};
use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::parameters::{Parameter, Setup};

/// Levels of steps: what is read off one time step has errors that change with its place in the
/// step, and neighbours show how much.
const LEVELS: Levels = Levels {
    coarsest: 16,
    count: 6,
    neighbours: 3,
    octaves: 0.36,
};

/// Levels for a law with joins. A step across a join is off by h^(k+2) times a function of the
/// join's place in the step. Their sum changes its size and sign from flight to flight, so that
/// only the largest of many falls with a power of h, and it does so once a step hardly ever crosses
/// two joins.
pub(super) const LEVELS_ACROSS_JOINS: Levels = Levels {
    coarsest: 64,
    count: 4,
    neighbours: 12,
    octaves: 1.0,
};

/// Steps to the flight that is the reference.
const REFERENCE: u32 = 4096;

/// Steps to a flight that differs from the reference by little but the rounding of so many steps:
/// errors that do not stand out of this difference by a factor are rounding too.
const BESIDE_THE_REFERENCE: u32 = 2048;
const OUT_OF_IT: f64 = 10.0;

/// Errors of value and gradient smaller than this, relative, are rounding.
const ROUNDING: [f64; 2] = [1e-12, 1e-11];

/// How far below the expected order the slope of the errors may be without a look at why. The
/// error's next term still shows at steps like these; a mistake in a method costs a whole order.
const SHORT_OF: f64 = 0.75;

/// Numbers of steps to a flight, in levels that double.
pub(super) struct Levels {
    /// The first number of the coarsest level.
    coarsest: u32,
    pub count: usize,
    /// Flights per level, whose numbers of steps are spread evenly (in logarithms) …
    neighbours: u32,
    /// … over so many octaves.
    octaves: f64,
}

impl Levels {
    pub fn steps(&self, level: usize) -> impl Iterator<Item = u32> {
        let first = f64::from(self.coarsest << level);
        let spacing = self.octaves / f64::from(self.neighbours);
        (0..self.neighbours).map(move |k| (first * (f64::from(k) * spacing).exp2()).round() as u32)
    }
}

/// How an outcome converges with the time step.
#[derive(Clone, Debug)]
pub struct Convergence {
    /// The outcome.
    pub of: Outcome,
    /// Steps, s, with the errors of value and gradient there, relative to the numbers they are made
    /// of.
    pub errors: Vec<(f64, [f64; 2])>,
    /// The measured orders of value and gradient; `None` where too few errors stand out of the
    /// rounding.
    pub orders: [Option<f64>; 2],
    /// The orders expected of them.
    pub expected: [u32; 2],
    /// Number of continuous derivatives of the law, where its joins limit an expected order.
    pub limited_by_law: Option<u32>,
    /// Whether they fall short of these: an order may be measured lower where the error's first two
    /// terms have opposite signs and it passes through 0.
    pub falls_short: [bool; 2],
    /// Whether a method of one order less would be found short: held to one order more than
    /// expected, these errors are.
    pub would_show: [bool; 2],
}

impl Convergence {
    /// Whether the orders are the method's.
    pub fn passed(&self) -> bool {
        self.falls_short == [false; 2]
    }
}

/// How the outcomes of the flight, and their derivatives by `wrt`, converge with the step. A
/// logarithmic wind is left out: it changes over half a metre of height, and no order shows at
/// steps that cross this at once. Steps within which the spin fades show none either; where too few
/// are left, nothing is measured, nor once `goes_on` is false.
///
/// # Errors
/// As [`jacobian`].
pub(super) fn convergence(
    setup: &Setup<f64>,
    of: &[Outcome],
    wrt: &[&'static Parameter],
    goes_on: &dyn Fn() -> bool,
) -> Result<Vec<Convergence>> {
    if setup.wind.roughness.is_some() {
        return Ok(vec![]);
    }
    let drive = Drive::new(setup)?;
    let Some(time) = fine_flight_time(setup, drive.landed()?.flight_time) else {
        return Ok(vec![]);
    };
    let fading = fading(setup, &drive);
    let at = |steps: u32| {
        let mut setup = *setup;
        // a little more than a whole number of steps, so that none ends just before or just after
        // the landing
        setup.flight.step = time / (f64::from(steps) - 0.5);
        // too coarse a step may not follow the flight: an error at that step there is none
        let is_short = setup.flight.step <= 1.0 && setup.flight.step * fading <= 1.0;
        let taylors = (is_short && goes_on())
            .then(|| jacobian(&setup, of, wrt).ok())
            .flatten();
        taylors.map(|taylors| (setup.flight.step, taylors))
    };
    let (Some((_, reference)), Some((_, beside))) = (at(REFERENCE), at(BESIDE_THE_REFERENCE))
    else {
        return Ok(vec![]);
    };
    let has_joins = setup.law.continuous_derivatives().is_some();
    let (levels, measure) = if has_joins {
        (
            LEVELS_ACROSS_JOINS,
            measure_largest as fn(&[Errors], u32, f64, f64) -> Option<Measured>,
        )
    } else {
        (
            LEVELS,
            measure as fn(&[Errors], u32, f64, f64) -> Option<Measured>,
        )
    };
    let flown: Vec<_> = (0..levels.count)
        .flat_map(|level| levels.steps(level).map(move |steps| (level, steps)))
        .filter_map(|(level, steps)| Some((level, at(steps)?)))
        .collect();
    let coarsest = flown
        .iter()
        .map(|(level, _)| *level)
        .min()
        .unwrap_or(levels.count);
    if coarsest + MEASURED > levels.count || !goes_on() {
        return Ok(vec![]);
    }
    let scales: Vec<f64> = wrt
        .iter()
        .map(|parameter| scale(setup, parameter))
        .collect();
    let convergence = |(i, of): (usize, &Outcome)| {
        let size = size(*of, setup, &drive);
        let sample = |(level, (step, taylors)): &(usize, (f64, Vec<Taylor>))| {
            let errors = errors(&taylors[i], &reference[i], size, &scales);
            errors.map(|errors| Errors {
                level: *level,
                step: *step,
                errors,
            })
        };
        let samples: Vec<[Errors; 2]> = flown.iter().map(sample).collect();
        let largest = |errors: &Vec<f64>| {
            errors
                .iter()
                .fold(0.0_f64, |most, error| most.max(error.abs()))
        };
        let rounding = errors(&beside[i], &reference[i], size, &scales)
            .map(|errors| OUT_OF_IT * largest(&errors));
        let Expected {
            orders: expected,
            limited_by_law,
        } = expected(setup, *of);
        let held_to = |more: u32| {
            [0, 1].map(|which: usize| {
                let samples: Vec<Errors> = samples.iter().map(|pair| pair[which].clone()).collect();
                measure(
                    &samples,
                    expected[which] + more,
                    SHORT_OF,
                    ROUNDING[which].max(rounding[which]),
                )
            })
        };
        let measured = held_to(0);
        Convergence {
            of: *of,
            errors: samples
                .iter()
                .map(|pair| {
                    (
                        pair[0].step,
                        [0, 1].map(|which: usize| pair[which].largest()),
                    )
                })
                .collect(),
            orders: measured.map(|measured| measured.map(|it| it.order)),
            expected,
            limited_by_law,
            falls_short: measured.map(|measured| measured.is_some_and(|it| it.falls_short)),
            would_show: held_to(1).map(|measured| measured.is_some_and(|it| it.falls_short)),
        }
    };
    Ok(of.iter().enumerate().map(convergence).collect())
}

/// The flight time in steps as short as the reference's. That of a long step of the setup may be
/// off by a part of the steps compared here, which then end just before or after the landing.
fn fine_flight_time(setup: &Setup<f64>, about: f64) -> Option<f64> {
    let mut setup = *setup;
    setup.flight.step = about / f64::from(REFERENCE);
    Some(Drive::new(&setup).ok()?.landed().ok()?.flight_time)
}

/// The orders that an outcome is held to.
struct Expected {
    /// Of value and gradient.
    orders: [u32; 2],
    /// As [`Convergence::limited_by_law`].
    limited_by_law: Option<u32>,
}

/// The orders of value and gradient: the method's, as far as the polynomial of degree 7 between the
/// steps goes: h⁸ in a position and h⁷ in its derivatives, one less in a velocity and in the root
/// of one. A step adds to the position what it adds to the velocity only up to h^(p+1), so that a
/// velocity within it is off by h^p times a function of the place in the step; the apex moves
/// through the step as a parameter changes, at a rate of 1/h, and its derivatives are off by
/// h^(p−1). (The landing lies in the middle of a step here, where that function is flat.) Across a
/// join of a law with k continuous derivatives a step is off by h^(k+2) times a function of the
/// join's place in the step, which moves at a rate of 1/h: its derivative is off by h^(k+1).
fn expected(setup: &Setup<f64>, of: Outcome) -> Expected {
    use Outcome::{ApexDownrange, ApexTime, DescentAngle, LandingSpeed};
    let is_of_a_velocity = matches!(of, DescentAngle | LandingSpeed | ApexTime | ApexDownrange);
    let interpolated = match of {
        // the spin at the landing is interpolated by degree 5 where it is damped by the way through
        // the air
        _ if of.needs_run() => [6, 5],
        _ if is_of_a_velocity => [7, 6],
        _ => [8, 7],
    };
    let order = setup.method.order();
    let of_method = if matches!(of, ApexTime | ApexDownrange) {
        [order, order - 1]
    } else {
        [order; 2]
    };
    let of_smooth_law = [0, 1].map(|which: usize| of_method[which].min(interpolated[which]));
    let Some(derivatives) = setup.law.continuous_derivatives() else {
        return Expected {
            orders: of_smooth_law,
            limited_by_law: None,
        };
    };
    let across_joins = [derivatives + 2, derivatives + 1];
    let orders = [0, 1].map(|which: usize| of_smooth_law[which].min(across_joins[which]));
    Expected {
        orders,
        limited_by_law: (orders != of_smooth_law).then_some(derivatives),
    }
}

/// How fast the spin fades as the ball leaves, 1/s: δ + κ |v|/R (docs/model.md, eq. 13).
fn fading(setup: &Setup<f64>, drive: &Drive<f64>) -> f64 {
    let by_way = setup.aero.spin_damping.unwrap_or_default() / setup.ball.radius;
    setup.aero.spin_decay + by_way * drive.launch.ball_speed()
}

/// The errors of the value and of each entry of the gradient, relative to the size of the outcome;
/// those of a gradient that is more than next to nothing relative to its largest entry.
fn errors(found: &Taylor, reference: &Taylor, size: f64, scales: &[f64]) -> [Vec<f64>; 2] {
    let entries = reference
        .gradient
        .iter()
        .zip(scales)
        .map(|(d, scale)| (d * scale).abs());
    let steepness = entries.fold(NEXT_TO_NOTHING * size, f64::max);
    let off = found.gradient.iter().zip(&reference.gradient).zip(scales);
    let of_gradient =
        off.map(|((found, reference), scale)| (found - reference) * scale / steepness);
    [
        vec![(found.value - reference.value) / size],
        of_gradient.collect(),
    ]
}
