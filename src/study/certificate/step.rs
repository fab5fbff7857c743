//! Truncation error of outcomes and derivatives. The certificate checks derivatives of the
//! integrated flight, which differs from the exact flight by this error.

use super::scale::{scale, size};
use crate::derivative::jacobian;
use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::parameters::{Parameter, Setup};
use crate::units::Message;

/// Step ratio of the comparison flight; order 4 leaves 1/4096 of the error.
const SHORTER: f64 = 8.0;

/// Lower bound of the divisor of a derivative's relative error. The divisor is the change of the
/// outcome over the parameter's scale, relative to the outcome's size.
const LEAST: f64 = 1e-6;

/// Relative derivative error that triggers a warning.
const WORTH_A_WORD: f64 = 1e-6;

/// Truncation error of an outcome and its derivatives, by comparison with steps of an eighth.
#[derive(Clone, Copy, Debug)]
pub struct StepError {
    /// The outcome.
    pub of: Outcome,
    /// The step (s) and the shorter step of the comparison.
    pub steps: [f64; 2],
    /// Error of the value, relative to the magnitude of its terms.
    pub value: f64,
    /// Parameter of the derivative with the largest relative error, and this error.
    pub derivative: Option<(&'static Parameter, f64)>,
    /// Largest derivative error relative to outcome per parameter scale.
    pub of_outcome: f64,
}

impl StepError {
    /// Warning for a relative derivative error above 1e-6.
    pub fn warning(&self) -> Option<Message> {
        let (parameter, error) = self.derivative.filter(|(_, error)| *error > WORTH_A_WORD)?;
        let (of, by, step) = (self.of.name(), parameter.name, 1e3 * self.steps[0]);
        let warning = format!(
            "the derivative of {of} by {by} is computed with time steps of {step} ms, and with \
             much shorter steps it would differ by {error:.0e} of \
             its value; reduce flight.step if you need it more exactly"
        );
        Some(warning.into())
    }
}

/// Truncation errors of flight outcomes and their derivatives by `wrt`; empty if a step of an
/// eighth is not allowed.
///
/// # Errors
/// The errors of [`jacobian`].
pub(super) fn step_errors(
    setup: &Setup<f64>,
    of: &[Outcome],
    wrt: &[&'static Parameter],
) -> Result<Vec<StepError>> {
    let mut finer = *setup;
    finer.flight.step /= SHORTER;
    if finer.validate().is_err() {
        return Ok(vec![]);
    }
    let drive = Drive::new(setup)?;
    let (found, exact) = (jacobian(setup, of, wrt)?, jacobian(&finer, of, wrt)?);
    let error = |(i, of): (usize, &Outcome)| {
        let size = size(*of, setup, &drive);
        let slopes = found[i].gradient.iter().zip(&exact[i].gradient).zip(wrt);
        let off = slopes.map(|((found, exact), parameter)| {
            let scale = scale(setup, parameter);
            let (off, slope) = ((found - exact).abs() * scale, exact.abs() * scale);
            (*parameter, off / slope.max(LEAST * size), off / size)
        });
        let off: Vec<_> = off.collect();
        StepError {
            of: *of,
            steps: [setup.flight.step, finer.flight.step],
            value: (found[i].value - exact[i].value).abs() / size,
            derivative: off
                .iter()
                .map(|it| (it.0, it.1))
                .max_by(|a, b| a.1.total_cmp(&b.1)),
            of_outcome: off.iter().fold(0.0, |most, it| most.max(it.2)),
        }
    };
    Ok(of.iter().enumerate().map(error).collect())
}
