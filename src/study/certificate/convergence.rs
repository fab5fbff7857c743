use super::continuity::smoothness;
use crate::derivative::{Taylor, jacobian};
use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::parameters::{Law, Parameter, Setup};

/// Steps to a flight; the last are the reference.
const STEPS: [u32; 7] = [16, 32, 64, 128, 256, 512, 2048];

/// Errors smaller than this, relative, are rounding.
const ROUNDING: f64 = 1e-11;

/// An order is measured over at least so many errors.
const MEASURED: usize = 3;

/// How far below the expected order a measured one may be. The error's next term still shows at steps like these; a mistake in a method
/// costs a whole order.
const SHORT_OF: f64 = 0.75;

/// The same with a law that is joined to its smoothing, where errors scatter by how the steps happen to fall on the joint …
const SHORT_OF_ACROSS_A_JOINT: f64 = 1.0;

/// … and small ones are of nothing else.
const SCATTER_ACROSS_A_JOINT: f64 = 1e-8;

/// How an outcome converges with the time step.
#[derive(Clone, Debug)]
pub struct Convergence {
    /// The outcome.
    pub of: Outcome,
    /// Steps, s, with the relative errors of value and gradient there.
    pub errors: Vec<(f64, [f64; 2])>,
    /// The measured orders of value and gradient; `None` where too few errors stand out of the rounding.
    pub orders: [Option<f64>; 2],
    /// The orders expected of them.
    pub expected: [u32; 2],
    /// How far below these they may be.
    pub short_of: f64,
}

impl Convergence {
    /// Whether the orders are the method's.
    pub fn passed(&self) -> bool {
        let falls_short =
            |(order, expected): (&Option<f64>, u32)| order.is_some_and(|o| o < f64::from(expected) - self.short_of);
        !self.orders.iter().zip(self.expected).any(falls_short)
    }
}

/// How the outcomes of the flight, and their derivatives by `wrt`, converge with the step. A logarithmic wind is left out: it changes
/// within centimetres of the ground, and no order shows at steps that are longer.
///
/// # Errors
/// As [`jacobian`].
pub(super) fn convergence(setup: &Setup<f64>, of: &[Outcome], wrt: &[&'static Parameter]) -> Result<Vec<Convergence>> {
    if setup.wind.roughness.is_some() {
        return Ok(vec![]);
    }
    let time = Drive::new(setup)?.landed()?.flight_time;
    let mut flown = vec![];
    for steps in STEPS {
        let mut setup = *setup;
        // a little more than a whole number of steps, so that none ends just before or just after the landing
        setup.flight.step = time / (f64::from(steps) - 0.5);
        if setup.flight.step <= 1.0 {
            // too coarse a step may not follow the flight: an error at that step there is none
            if let Ok(taylors) = jacobian(&setup, of, wrt) {
                flown.push((setup.flight.step, taylors));
            }
        }
    }
    let Some((_, reference)) = flown.pop() else { return Ok(vec![]) };
    let (short_of, floor) =
        if is_joined(setup) { (SHORT_OF_ACROSS_A_JOINT, SCATTER_ACROSS_A_JOINT) } else { (SHORT_OF, ROUNDING) };
    let convergence = |(i, of): (usize, &Outcome)| {
        let errors: Vec<_> = flown.iter().map(|(step, taylors)| (*step, errors(&taylors[i], &reference[i]))).collect();
        let orders = [0, 1].map(|which| order(&errors, which, floor));
        Convergence { of: *of, errors, orders, expected: expected(setup, *of), short_of }
    };
    Ok(of.iter().enumerate().map(convergence).collect())
}

/// The orders of value and gradient: the method's, as far as the quintic between the steps goes: h⁶ in a position and h⁵ in its
/// derivatives, one less in a velocity, and h³ in the derivative of the root of its slope. A law that is joined to its smoothing has but
/// two continuous derivatives: the step that crosses the joint is off by h⁴, and its derivative by h³.
fn expected(setup: &Setup<f64>, of: Outcome) -> [u32; 2] {
    let interpolated = if smoothness(of) > 1 { [6, 5] } else { [5, 3] };
    let forced = if is_joined(setup) { [4, 3] } else { [u32::MAX; 2] };
    [0, 1].map(|which: usize| setup.method.order().min(interpolated[which]).min(forced[which]))
}

fn is_joined(setup: &Setup<f64>) -> bool {
    matches!(setup.law, Law::Ferguson(_) | Law::SmitsSmith(_))
}

/// Relative errors of value and gradient.
fn errors(found: &Taylor, reference: &Taylor) -> [f64; 2] {
    let size = reference.gradient.iter().fold(0.0_f64, |most, d| most.max(d.abs()));
    let off = found.gradient.iter().zip(&reference.gradient).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    let relative = |off: f64, size: f64| if size > 0.0 { off / size } else { 0.0 };
    [relative((found.value - reference.value).abs(), reference.value.abs()), relative(off, size)]
}

/// The median of the orders from each step to the next, as far as errors stand out of the rounding (`floor`): where an error passes through 0 at
/// one step, the order before it is too large and the one after too small.
fn order(errors: &[(f64, [f64; 2])], which: usize, floor: f64) -> Option<f64> {
    let standing: Vec<_> =
        errors.iter().map(|(step, pair)| (*step, pair[which])).take_while(|(_, e)| *e > floor).collect();
    let order = |pair: &[(f64, f64)]| (pair[0].1 / pair[1].1).ln() / (pair[0].0 / pair[1].0).ln();
    let mut orders: Vec<f64> = standing.windows(2).map(order).collect();
    orders.sort_by(f64::total_cmp);
    let middle = orders.len() / 2;
    match orders.len() {
        few if few + 1 < MEASURED => None,
        odd if odd % 2 == 1 => Some(orders[middle]),
        _ => Some(0.5 * (orders[middle - 1] + orders[middle])),
    }
}
