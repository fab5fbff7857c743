use super::Vary;
use crate::derivative::{Evaluator, Order};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::optimize::sobol;
use crate::parameters::{Method, Setup};

/// How drives are to be integrated so that their carry is within a tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accuracy {
    /// The method that does it with the fewest evaluations of the force.
    pub method: Method,
    /// Its step, s.
    pub step: f64,
    /// The largest error of a carry found with it, m.
    pub error: f64,
    /// Drives that were looked at.
    pub drives: usize,
}

/// Half of the tolerance is kept for drives between those that are looked at.
const SAFETY: f64 = 0.5;
/// The step of the reference flights, s; with the method of order 8 their own error is below 1e-11 m in still air.
const REFERENCE_STEP: f64 = 0.01;
/// Steps tried, s, each 2^(−1/4) of the one before.
const LONGEST_STEP: f64 = 1.6;
const STEPS: i32 = 40;
/// Points within the ranges that are looked at.
const INSIDE: u64 = 32;
/// Ends of ranges are combined for so many parameters; of further ones the setup's own value is taken.
const MOST_COMBINED: usize = 4;

/// The cheapest method and step with which carry is within `tolerance` (m) of the exact one, for the setup and for drives at the
/// ends of the ranges and within them. Both are fixed beforehand and do not depend on the drive, so that carry stays as smooth as it is.
///
/// ```
/// use longdrive::{Setup, study::accuracy};
/// let setup = Setup::default();
/// let micrometre = accuracy(&setup, &[], 1e-6).unwrap();
/// assert!(micrometre.error < 1e-6 && micrometre.step > setup.flight.step);
/// ```
///
/// # Errors
/// [`Error::Tolerance`] for a tolerance that is none, or that none of the steps down to 1 ms reaches; as
/// [`Evaluator::at`] where the setup's drive has no carry and none at the ends of the ranges has.
pub fn accuracy(setup: &Setup<f64>, ranges: &[Vary], tolerance: f64) -> Result<Accuracy> {
    if !(tolerance > 0.0 && tolerance.is_finite()) {
        return Err(Error::Tolerance { tolerance, reason: "give a length above 0, for example 1 um".into() });
    }
    let reference = flown(setup, Method::DormandPrince8, REFERENCE_STEP);
    let drives = drives(&reference, ranges)?;
    let mut best: Option<Accuracy> = None;
    for &method in Method::ALL {
        let cost = |step: f64| f64::from(method.stages()) / step;
        for k in 0..STEPS {
            let step = LONGEST_STEP * 0.5_f64.powf(0.25 * f64::from(k));
            if best.is_some_and(|best| cost(step) >= f64::from(best.method.stages()) / best.step) {
                break;
            }
            if let Some(error) = largest_error(&flown(setup, method, step), ranges, &drives)
                && error <= SAFETY * tolerance
            {
                best = Some(Accuracy { method, step, error, drives: drives.len() });
                break;
            }
        }
    }
    best.ok_or_else(|| Error::Tolerance {
        tolerance,
        reason: format!(
            "no step of {LONGEST_STEP} s down to {:.1e} s reaches it; set flight.method and flight.step",
            LONGEST_STEP * 0.5_f64.powf(0.25 * f64::from(STEPS - 1))
        ),
    })
}

fn flown(setup: &Setup<f64>, method: Method, step: f64) -> Setup<f64> {
    let mut flown = Setup { method, ..*setup };
    flown.flight.step = step;
    flown
}

/// The drives looked at, as values of the ranges' parameters, with their carries; those that do not fly are left out.
fn drives(reference: &Setup<f64>, ranges: &[Vary]) -> Result<Vec<(Vec<f64>, f64)>> {
    // a launch that only the points have is taken in its middle
    let middle = |range: &Vary| 0.5 * (range.low + range.high);
    let own: Vec<f64> =
        ranges.iter().map(|range| reference.value(range.parameter).unwrap_or_else(|| middle(range))).collect();
    let mut points = vec![own.clone()];
    if !ranges.is_empty() {
        for corner in 0..1_usize << ranges.len().min(MOST_COMBINED) {
            let end = |(i, range): (usize, &Vary)| match corner >> i & 1 {
                _ if i >= MOST_COMBINED => own[i],
                0 => range.low,
                _ => range.high,
            };
            points.push(ranges.iter().enumerate().map(end).collect());
        }
        // and within: the shortest flights, in few steps, are seldom at a corner
        for k in 0..INSIDE {
            let at = |(i, range): (usize, &Vary)| range.low + (range.high - range.low) * sobol::coordinate(k, i, 0);
            points.push(ranges.iter().enumerate().map(at).collect());
        }
    }
    let carry = carry(reference, ranges)?;
    let mut found = vec![];
    let mut refused = None;
    for point in points {
        match carry.at(&point) {
            Ok(taylors) => found.push((point, taylors[0].value)),
            Err(error) => refused = refused.or(Some(error)),
        }
    }
    match refused {
        Some(error) if found.is_empty() => Err(error),
        _ => Ok(found),
    }
}

/// The largest error over the drives; nothing where one of them is not even flown. Where in its last step a ball lands makes a
/// difference, so each drive is flown with a few steps a little shorter too.
fn largest_error(setup: &Setup<f64>, ranges: &[Vary], drives: &[(Vec<f64>, f64)]) -> Option<f64> {
    const PHASES: u32 = 8;
    let mut largest = 0.0_f64;
    for phase in 0..PHASES {
        let step = setup.flight.step * (1.0 - 0.035 * f64::from(phase));
        let carry = carry(&flown(setup, setup.method, step), ranges).ok()?;
        for (point, exact) in drives {
            largest = largest.max((carry.at(point).ok()?[0].value - exact).abs());
        }
    }
    Some(largest)
}

fn carry(setup: &Setup<f64>, ranges: &[Vary]) -> Result<Evaluator> {
    let parameters: Vec<_> = ranges.iter().map(|range| range.parameter).collect();
    Evaluator::new(setup, &[Outcome::Carry], &parameters, Order::Value)
}
