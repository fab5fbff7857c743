//! Exact derivatives of any outcomes with respect to any parameters, chosen by name at run time. Dual
//! numbers enter and leave here only.

mod seed;

use crate::drive::{Drive, Outcome};
use crate::error::{Error, Result};
use crate::number::{Jet, Jet2};
use crate::parameters::{Parameter, Setup};
use num_dual::{Dual2_64, Dual64};
use seed::Seeded;

/// How far an evaluation goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Order {
    /// Values.
    Value,
    /// Values and gradients.
    First,
    /// Values, gradients and Hessians.
    Second,
}

/// An outcome with its derivatives, in the order of the parameters asked for, SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Taylor {
    /// The value.
    pub value: f64,
    /// ∂/∂pᵢ; empty where only values were asked for.
    pub gradient: Vec<f64>,
    /// ∂²/∂pᵢ∂pⱼ, row by row, symmetric; empty where no Hessian was asked for.
    pub hessian: Vec<Vec<f64>>,
}

/// Parameters differentiated by in one pass of a gradient: wider is cheaper for each, as far as measured.
const GRADIENT_WIDTH: usize = 12;

/// Value and gradient of an outcome.
///
/// # Errors
/// As [`evaluate`].
pub fn gradient(setup: &Setup<f64>, of: Outcome, wrt: &[&'static Parameter]) -> Result<Taylor> {
    single(evaluate(setup, &[of], wrt, Order::First)?)
}

/// Value, gradient and Hessian of an outcome.
///
/// ```
/// use longdrive::{Outcome, Setup, derivative};
/// // in a vacuum carry = v² sin 2θ/g, and air density is what bends it away from that
/// let mut setup = Setup::preset("mae494").unwrap();
/// setup.set("air.density", "0").unwrap();
/// let gravity = [setup.variable("gravity").unwrap()];
/// let carry = derivative::hessian(&setup, Outcome::Carry, &gravity).unwrap();
/// let g = 9.81;
/// assert!((carry.gradient[0] + carry.value / g).abs() < 1e-11);
/// assert!((carry.hessian[0][0] - 2.0 * carry.value / (g * g)).abs() < 1e-11);
/// ```
///
/// # Errors
/// As [`evaluate`].
pub fn hessian(setup: &Setup<f64>, of: Outcome, wrt: &[&'static Parameter]) -> Result<Taylor> {
    single(evaluate(setup, &[of], wrt, Order::Second)?)
}

/// Values and gradients of several outcomes of one drive: their Jacobian, a row each.
///
/// # Errors
/// As [`evaluate`].
pub fn jacobian(setup: &Setup<f64>, of: &[Outcome], wrt: &[&'static Parameter]) -> Result<Vec<Taylor>> {
    evaluate(setup, of, wrt, Order::First)
}

/// Outcomes of a drive with their derivatives up to `order`.
///
/// # Errors
/// What [`Setup::validate`], [`Setup::variable`] and [`Drive::new`] refuse; [`Error::NoFlight`] for an outcome
/// of a flight that is none; [`Error::Undefined`] where a value or derivative does not exist;
/// [`Error::Nothing`] without outcomes or, beyond values, without parameters.
pub fn evaluate(setup: &Setup<f64>, of: &[Outcome], wrt: &[&'static Parameter], order: Order) -> Result<Vec<Taylor>> {
    evaluate_with(setup, of, wrt, order, |_, _| ())
}

/// As [`evaluate`], telling `progress` how many passes of how many are done.
///
/// # Errors
/// As [`evaluate`].
pub fn evaluate_with(
    setup: &Setup<f64>,
    of: &[Outcome],
    wrt: &[&'static Parameter],
    order: Order,
    progress: impl FnMut(usize, usize),
) -> Result<Vec<Taylor>> {
    setup.validate()?;
    if of.is_empty() {
        return Err(Error::Nothing { doing: "evaluate", what: "outcome" });
    }
    if order > Order::Value {
        if wrt.is_empty() {
            return Err(Error::Nothing { doing: "differentiate by", what: "parameter" });
        }
        for parameter in wrt {
            setup.variable(parameter.name)?;
        }
    }
    let taylors = match order {
        Order::Value => values(setup, of)?,
        Order::First => first(setup, of, wrt, progress)?,
        Order::Second => second(setup, of, wrt, progress)?,
    };
    for (outcome, taylor) in of.iter().zip(&taylors) {
        taylor.check(*outcome, wrt)?;
    }
    Ok(taylors)
}

fn values(setup: &Setup<f64>, of: &[Outcome]) -> Result<Vec<Taylor>> {
    let drive = Drive::new(setup)?;
    let value = |outcome: &Outcome| Ok(Taylor { value: outcome.of(&drive)?, gradient: vec![], hessian: vec![] });
    of.iter().map(value).collect()
}

fn first(
    setup: &Setup<f64>,
    of: &[Outcome],
    wrt: &[&'static Parameter],
    mut progress: impl FnMut(usize, usize),
) -> Result<Vec<Taylor>> {
    let mut taylors = vec![Taylor::zero(wrt.len(), Order::First); of.len()];
    let places: Vec<usize> = (0..wrt.len()).collect();
    let chunks = places.chunks(GRADIENT_WIDTH);
    let passes = chunks.len();
    for (done, chunk) in chunks.enumerate() {
        match chunk.len() {
            1 => pass::<Dual64>(setup, of, wrt, chunk, &mut taylors)?,
            2 => pass::<Jet<2>>(setup, of, wrt, chunk, &mut taylors)?,
            3..=4 => pass::<Jet<4>>(setup, of, wrt, chunk, &mut taylors)?,
            _ => pass::<Jet<GRADIENT_WIDTH>>(setup, of, wrt, chunk, &mut taylors)?,
        }
        progress(done + 1, passes);
    }
    Ok(taylors)
}

fn second(
    setup: &Setup<f64>,
    of: &[Outcome],
    wrt: &[&'static Parameter],
    mut progress: impl FnMut(usize, usize),
) -> Result<Vec<Taylor>> {
    let mut taylors = vec![Taylor::zero(wrt.len(), Order::Second); of.len()];
    if wrt.len() == 1 {
        pass::<Dual2_64>(setup, of, wrt, &[0], &mut taylors)?;
        progress(1, 1);
        return Ok(taylors);
    }
    // a pass for each pair: wider second-order jets cost more for each entry
    let pairs: Vec<[usize; 2]> = (0..wrt.len()).flat_map(|i| (0..i).map(move |j| [j, i])).collect();
    for (done, pair) in pairs.iter().enumerate() {
        pass::<Jet2<2, 3>>(setup, of, wrt, pair, &mut taylors)?;
        progress(done + 1, pairs.len());
    }
    Ok(taylors)
}

/// One drive over `D`, with the parameters at `places` of `wrt` seeded; what it tells of the outcomes goes to
/// the same places of `taylors`.
#[inline(never)]
fn pass<D: Seeded>(
    setup: &Setup<f64>,
    of: &[Outcome],
    wrt: &[&'static Parameter],
    places: &[usize],
    taylors: &mut [Taylor],
) -> Result<()> {
    let lifted = setup.map(|parameter, value| match places.iter().position(|&place| wrt[place] == parameter) {
        Some(direction) => D::seeded(value, direction),
        None => D::constant(value),
    });
    let drive = Drive::new(&lifted)?;
    for (outcome, taylor) in of.iter().zip(taylors) {
        let result = outcome.of(&drive)?;
        taylor.value = result.re();
        for (i, &row) in places.iter().enumerate() {
            taylor.gradient[row] = result.first(i);
            if let Some(hessian_row) = taylor.hessian.get_mut(row) {
                for (j, &column) in places.iter().enumerate() {
                    hessian_row[column] = result.second(i, j);
                }
            }
        }
    }
    Ok(())
}

fn single(mut taylors: Vec<Taylor>) -> Result<Taylor> {
    taylors.pop().ok_or(Error::Nothing { doing: "evaluate", what: "outcome" })
}

impl Taylor {
    fn zero(parameters: usize, order: Order) -> Self {
        let rows = if order == Order::Second { parameters } else { 0 };
        Self { value: 0.0, gradient: vec![0.0; parameters], hessian: vec![vec![0.0; parameters]; rows] }
    }

    /// No NaN leaves: a value or derivative that is not finite does not exist.
    fn check(&self, outcome: Outcome, wrt: &[&'static Parameter]) -> Result<()> {
        let undefined = |what: String, reason: &str| Err(Error::Undefined { what, reason: reason.into() });
        if !self.value.is_finite() {
            return undefined(outcome.name().into(), "the launch has no such direction (vertical, or without spin)");
        }
        let edge = "it lies on the edge of a domain (a vertical launch, no spin, a landing at the apex)";
        for (i, parameter) in wrt.iter().enumerate() {
            if self.gradient.get(i).is_some_and(|d| !d.is_finite()) {
                return undefined(format!("d {}/d {}", outcome.name(), parameter.name), edge);
            }
            if self.hessian.get(i).is_some_and(|row| row.iter().any(|d| !d.is_finite())) {
                return undefined(format!("the second derivative of {} by {}", outcome.name(), parameter.name), edge);
            }
        }
        Ok(())
    }
}
