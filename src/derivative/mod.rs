//! Exact derivatives of outcomes by parameters. Outcomes and parameters are chosen by name at run
//! time.

mod chain;
pub mod check;
mod directions;
mod evaluator;
mod pass;
mod variables;

pub use crate::number::Taylor;
pub use evaluator::{Evaluator, Order};
pub use variables::{all_variables, default_variables};

use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::{Parameter, Setup};
use directions::Entries;

/// Value and gradient of an outcome.
///
/// # Errors
/// The errors of [`evaluate`].
pub fn gradient(setup: &Setup<f64>, of: Outcome, wrt: &[&'static Parameter]) -> Result<Taylor> {
    Ok(evaluate(setup, &[of], wrt, Order::First)?.swap_remove(0))
}

/// Value, gradient and Hessian of an outcome.
///
/// ```
/// use longdrive::{Outcome, Setup, derivative};
/// // in a vacuum (air density 0) carry = v² sin 2θ/g
/// let mut setup = Setup::preset("mae494").unwrap();
/// setup.set("air.density", "0 kg/m^3").unwrap();
/// let gravity = [setup.variable("gravity").unwrap()];
/// let carry = derivative::hessian(&setup, Outcome::Carry, &gravity).unwrap();
/// let g = 9.81;
/// assert!((carry.gradient[0] + carry.value / g).abs() < 1e-11);
/// assert!((carry.hessian[0][0] - 2.0 * carry.value / (g * g)).abs() < 1e-11);
/// ```
///
/// # Errors
/// The errors of [`evaluate`].
pub fn hessian(setup: &Setup<f64>, of: Outcome, wrt: &[&'static Parameter]) -> Result<Taylor> {
    Ok(evaluate(setup, &[of], wrt, Order::Second)?.swap_remove(0))
}

/// Values and gradients of several outcomes of one drive, and the diagonals of their Hessians: for
/// each parameter p the second derivative ∂²/∂p². The other entries of the Hessians are 0.
///
/// For 8 parameters, 8 second derivatives are computed instead of 36.
///
/// # Errors
/// The errors of [`evaluate`].
pub fn diagonal(
    setup: &Setup<f64>,
    of: &[Outcome],
    wrt: &[&'static Parameter],
) -> Result<Vec<Taylor>> {
    Evaluator::new(setup, of, wrt, Order::Second)?
        .with_entries(Entries::Diagonal)
        .at_setup(None, &|_, _| ())
}

/// Outcomes of a drive with their derivatives up to `order`. The gradients are the rows of the
/// Jacobian. [`Evaluator::at_setup`] does the same, and reports its progress.
///
/// # Errors
/// Errors of [`Evaluator::new`] and [`Drive::new`](crate::Drive::new);
/// [`Error::NoFlight`](crate::Error::NoFlight) for an outcome of a ball that does not fly;
/// [`Error::Undefined`](crate::Error::Undefined) if a value or derivative does not exist.
pub fn evaluate(
    setup: &Setup<f64>,
    of: &[Outcome],
    wrt: &[&'static Parameter],
    order: Order,
) -> Result<Vec<Taylor>> {
    Evaluator::new(setup, of, wrt, order)?.at_setup(None, &|_, _| ())
}

/// Like [`evaluate`] to second order, but computes only the last row and column of each Hessian:
/// the second derivatives that involve the last parameter. The other entries are 0. The sensitivity
/// of an optimum needs only these second derivatives.
///
/// # Errors
/// The errors of [`evaluate`].
pub(crate) fn last_hessian_row(
    setup: &Setup<f64>,
    of: &[Outcome],
    wrt: &[&'static Parameter],
) -> Result<Vec<Taylor>> {
    Evaluator::new(setup, of, wrt, Order::Second)?
        .with_entries(Entries::LastRow)
        .at_setup(None, &|_, _| ())
}
