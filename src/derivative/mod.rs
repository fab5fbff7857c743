//! Exact derivatives of any outcomes with respect to any parameters, chosen by name at run time. Dual
//! numbers enter and leave here only.

use crate::drive::{Drive, Outcome};
use crate::error::{Error, Result};
use crate::number::{Pairs, Seedable, Seeded, first, second, values};
use crate::parameters::{Parameter, Setup};

pub use crate::number::{Order, Taylor};

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
    checked(setup, of, wrt, order, Pairs::All, progress)
}

/// As [`evaluate`] to second order, with those second derivatives alone that the last parameter takes part in: what the
/// sensitivity of an optimum to it asks for. The other entries of the Hessians are 0.
///
/// # Errors
/// As [`evaluate`].
pub(crate) fn towards_last(setup: &Setup<f64>, of: &[Outcome], wrt: &[&'static Parameter]) -> Result<Vec<Taylor>> {
    checked(setup, of, wrt, Order::Second, Pairs::WithLast, |_, _| ())
}

fn checked(
    setup: &Setup<f64>,
    of: &[Outcome],
    wrt: &[&'static Parameter],
    order: Order,
    pairs: Pairs,
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
    let (outcomes, n) = (Outcomes { setup, of, wrt }, wrt.len());
    let taylors = match order {
        Order::Value => values(&outcomes)?,
        Order::First => first(&outcomes, n, progress)?,
        Order::Second => second(&outcomes, n, pairs, progress)?,
    };
    for (outcome, taylor) in of.iter().zip(&taylors) {
        check(taylor, *outcome, wrt)?;
    }
    Ok(taylors)
}

/// Outcomes of a setup, to be differentiated by parameters.
struct Outcomes<'a> {
    setup: &'a Setup<f64>,
    of: &'a [Outcome],
    wrt: &'a [&'static Parameter],
}

impl Seedable for Outcomes<'_> {
    type Error = Error;

    fn outputs<D: Seeded>(&self, seeds: &[usize]) -> Result<Vec<D>> {
        let is_seeded = |parameter| seeds.iter().position(|&seed| self.wrt[seed] == parameter);
        let lifted = self.setup.map(|parameter, value| match is_seeded(parameter) {
            Some(direction) => D::seeded(value, direction),
            None => D::constant(value),
        });
        let drive = Drive::new(&lifted)?;
        self.of.iter().map(|outcome| outcome.of(&drive)).collect()
    }
}

fn single(mut taylors: Vec<Taylor>) -> Result<Taylor> {
    taylors.pop().ok_or(Error::Nothing { doing: "evaluate", what: "outcome" })
}

/// No NaN leaves: a value or derivative that is not finite does not exist.
fn check(taylor: &Taylor, outcome: Outcome, wrt: &[&'static Parameter]) -> Result<()> {
    let undefined = |what: String, reason: &str| Err(Error::Undefined { what, reason: reason.into() });
    if !taylor.value.is_finite() {
        return undefined(
            outcome.name().into(),
            "the direction it measures does not exist (vertical, or without spin)",
        );
    }
    let edge = "it lies on the edge of a domain (a vertical launch, no spin, a landing at the apex)";
    for (i, parameter) in wrt.iter().enumerate() {
        if taylor.gradient.get(i).is_some_and(|d| !d.is_finite()) {
            return undefined(format!("d {}/d {}", outcome.name(), parameter.name), edge);
        }
        if taylor.hessian.get(i).is_some_and(|row| row.iter().any(|d| !d.is_finite())) {
            return undefined(format!("the second derivative of {} by {}", outcome.name(), parameter.name), edge);
        }
    }
    Ok(())
}
