use super::order::{Errors, MEASURED, measure};
use super::scale::{scale, size};
use crate::derivative::check::NEXT_TO_NOTHING;
use crate::derivative::{Taylor, jacobian};
use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::parameters::{Law, Parameter, Setup};

/// Steps to a flight, in groups: what is read off one time step has errors that change with where in the step it lies, and neighbours
/// show how much.
const STEPS: [[u32; 3]; 6] =
    [[16, 17, 19], [32, 35, 38], [64, 70, 76], [128, 139, 151], [256, 277, 301], [512, 554, 601]];

/// Steps to the flight that is the reference.
const REFERENCE: u32 = 4096;

/// Steps to a flight that differs from the reference by little but the rounding of so many steps: errors that do not stand out of this
/// difference by a factor are rounding too.
const BESIDE_THE_REFERENCE: u32 = 2048;
const OUT_OF_IT: f64 = 10.0;

/// Errors of value and gradient smaller than this, relative, are rounding.
const ROUNDING: [f64; 2] = [1e-12, 1e-11];

/// How far below the expected order the slope of the errors may be without a look at why. The error's next term still shows at steps like
/// these; a mistake in a method costs a whole order.
const SHORT_OF: f64 = 0.75;

/// The same with a law that is joined to its smoothing, where errors scatter by how the steps happen to fall on the joint …
const SHORT_OF_ACROSS_A_JOINT: f64 = 1.0;

/// … and small ones are of nothing else.
const SCATTER_ACROSS_A_JOINT: [f64; 2] = [1e-8; 2];

/// How an outcome converges with the time step.
#[derive(Clone, Debug)]
pub struct Convergence {
    /// The outcome.
    pub of: Outcome,
    /// Steps, s, with the errors of value and gradient there, relative to the numbers they are made of.
    pub errors: Vec<(f64, [f64; 2])>,
    /// The measured orders of value and gradient; `None` where too few errors stand out of the rounding.
    pub orders: [Option<f64>; 2],
    /// The orders expected of them.
    pub expected: [u32; 2],
    /// Whether they fall short of these: an order may be measured lower where the error's first two terms have opposite signs and it
    /// passes through 0.
    pub falls_short: [bool; 2],
    /// Whether a method of one order less would be found short: held to one order more than expected, these errors are.
    pub would_show: [bool; 2],
}

impl Convergence {
    /// Whether the orders are the method's.
    pub fn passed(&self) -> bool {
        self.falls_short == [false; 2]
    }
}

/// How the outcomes of the flight, and their derivatives by `wrt`, converge with the step. A logarithmic wind is left out: it changes
/// within centimetres of the ground, and no order shows at steps that are longer. Steps within which the spin fades show none either; where too few
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
    let Some(time) = fine_flight_time(setup, drive.landed()?.flight_time) else { return Ok(vec![]) };
    let fading = fading(setup, &drive);
    let at = |steps: u32| {
        let mut setup = *setup;
        // a little more than a whole number of steps, so that none ends just before or just after the landing
        setup.flight.step = time / (f64::from(steps) - 0.5);
        // too coarse a step may not follow the flight: an error at that step there is none
        let is_short = setup.flight.step <= 1.0 && setup.flight.step * fading <= 1.0;
        let taylors = (is_short && goes_on()).then(|| jacobian(&setup, of, wrt).ok()).flatten();
        taylors.map(|taylors| (setup.flight.step, taylors))
    };
    let (Some((_, reference)), Some((_, beside))) = (at(REFERENCE), at(BESIDE_THE_REFERENCE)) else {
        return Ok(vec![]);
    };
    let groups = STEPS.iter().enumerate();
    let flown: Vec<_> = groups
        .flat_map(|(level, steps)| steps.map(|steps| (level, at(steps))))
        .filter_map(|(level, flown)| Some((level, flown?)))
        .collect();
    let coarsest = flown.iter().map(|(level, _)| *level).min().unwrap_or(STEPS.len());
    if coarsest + MEASURED > STEPS.len() || !goes_on() {
        return Ok(vec![]);
    }
    let scales: Vec<f64> = wrt.iter().map(|parameter| scale(setup, parameter)).collect();
    let (short_of, floor) =
        if is_joined(setup) { (SHORT_OF_ACROSS_A_JOINT, SCATTER_ACROSS_A_JOINT) } else { (SHORT_OF, ROUNDING) };
    let convergence = |(i, of): (usize, &Outcome)| {
        let size = size(*of, setup, &drive);
        let sample = |(level, (step, taylors)): &(usize, (f64, Vec<Taylor>))| {
            let errors = errors(&taylors[i], &reference[i], size, &scales);
            errors.map(|errors| Errors { level: *level, step: *step, errors })
        };
        let samples: Vec<[Errors; 2]> = flown.iter().map(sample).collect();
        let largest = |errors: &Vec<f64>| errors.iter().fold(0.0_f64, |most, error| most.max(error.abs()));
        let rounding = errors(&beside[i], &reference[i], size, &scales).map(|errors| OUT_OF_IT * largest(&errors));
        let expected = expected(setup, *of);
        let held_to = |more: u32| {
            [0, 1].map(|which: usize| {
                let samples: Vec<Errors> = samples.iter().map(|pair| pair[which].clone()).collect();
                measure(&samples, expected[which] + more, short_of, floor[which].max(rounding[which]))
            })
        };
        let measured = held_to(0);
        Convergence {
            of: *of,
            errors: samples
                .iter()
                .map(|pair| (pair[0].step, [0, 1].map(|which: usize| pair[which].largest())))
                .collect(),
            orders: measured.map(|measured| measured.map(|it| it.order)),
            expected,
            falls_short: measured.map(|measured| measured.is_some_and(|it| it.falls_short)),
            would_show: held_to(1).map(|measured| measured.is_some_and(|it| it.falls_short)),
        }
    };
    Ok(of.iter().enumerate().map(convergence).collect())
}

/// The flight time in steps as short as the reference's. That of a long step of the setup may be off by a part of the steps compared here, which then
/// end just before or after the landing.
fn fine_flight_time(setup: &Setup<f64>, about: f64) -> Option<f64> {
    let mut setup = *setup;
    setup.flight.step = about / f64::from(REFERENCE);
    Some(Drive::new(&setup).ok()?.landed().ok()?.flight_time)
}

/// The orders of value and gradient: the method's, as far as the polynomial of degree 7 between the steps goes: h⁸ in a position and h⁷ in
/// its derivatives, one less in a velocity and in the root of one. A step adds to the position what it adds to the velocity only up to h^(p+1), so that a
/// velocity within it is off by h^p times a function of the place in the step; the apex moves through the step as a parameter changes, at a rate of
/// 1/h, and its derivatives are off by h^(p−1). (The landing lies in the middle of a step here, where that function is flat.) A law that is joined to its smoothing has but two continuous
/// derivatives: the step that crosses the joint is off by h⁴, and its derivative by h³.
fn expected(setup: &Setup<f64>, of: Outcome) -> [u32; 2] {
    use Outcome::{ApexDownrange, ApexTime, DescentAngle, LandingSpeed};
    let is_of_a_velocity = matches!(of, DescentAngle | LandingSpeed | ApexTime | ApexDownrange);
    let interpolated = match of {
        // the spin at the landing is interpolated by degree 5 where it is damped by the way through the air
        _ if of.is_of_the_run() => [6, 5],
        _ if is_of_a_velocity => [7, 6],
        _ => [8, 7],
    };
    let forced = if is_joined(setup) { [4, 3] } else { [u32::MAX; 2] };
    let order = setup.method.order();
    let of_method = if matches!(of, ApexTime | ApexDownrange) { [order, order - 1] } else { [order; 2] };
    [0, 1].map(|which: usize| of_method[which].min(interpolated[which]).min(forced[which]))
}

/// How fast the spin fades as the ball leaves, 1/s: δ + κ |v|/R (docs/model.md, eq. 13).
fn fading(setup: &Setup<f64>, drive: &Drive<f64>) -> f64 {
    let by_way = setup.aero.spin_damping.unwrap_or_default() / setup.ball.radius;
    setup.aero.spin_decay + by_way * drive.launch.ball_speed()
}

fn is_joined(setup: &Setup<f64>) -> bool {
    matches!(
        setup.law,
        Law::Ferguson(_)
            | Law::SmitsSmith(_)
            | Law::MacdonaldHanzely(_)
            | Law::NaruoMizota(_)
            | Law::Nathan(_)
            | Law::Lyu(_)
            | Law::UsgaItr(_)
            | Law::BearmanHarvey(_)
            | Law::Table(_)
    )
}

/// The errors of the value and of each entry of the gradient, relative to the size of the outcome; those of a gradient that is more than next
/// to nothing relative to its largest entry.
fn errors(found: &Taylor, reference: &Taylor, size: f64, scales: &[f64]) -> [Vec<f64>; 2] {
    let entries = reference.gradient.iter().zip(scales).map(|(d, scale)| (d * scale).abs());
    let steepness = entries.fold(NEXT_TO_NOTHING * size, f64::max);
    let off = found.gradient.iter().zip(&reference.gradient).zip(scales);
    let of_gradient = off.map(|((found, reference), scale)| (found - reference) * scale / steepness);
    [vec![(found.value - reference.value) / size], of_gradient.collect()]
}
