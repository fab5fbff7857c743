//! What the time step leaves of an error in the outcomes and their derivatives: a certificate holds
//! the derivatives of the flight as it is integrated, which differ from those of the exact flight
//! by as much.

use super::scale::{scale, size};
use crate::derivative::jacobian;
use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::parameters::{Parameter, Setup};
use crate::units::Message;

/// The drive is held against one with a step this many times shorter: of an error of order 4 that
/// leaves a part in 4096.
const SHORTER: f64 = 8.0;

/// A derivative that moves the outcome by less than this part of it over the whole scale of its
/// parameter is not told from none.
const LEAST: f64 = 1e-6;

/// Relative errors of a derivative above this deserve a warning.
const WORTH_A_WORD: f64 = 1e-6;

/// The error that the time step leaves in an outcome and its derivatives, by a flight with steps of
/// an eighth.
#[derive(Clone, Copy, Debug)]
pub struct StepError {
    /// The outcome.
    pub of: Outcome,
    /// The step, s, and the shorter one that it is held against.
    pub steps: [f64; 2],
    /// The error of the value, relative to the numbers that it is made of.
    pub value: f64,
    /// The parameter by which the derivative has the largest error, relative to itself, and that
    /// error.
    pub derivative: Option<(&'static Parameter, f64)>,
    /// The largest error of a derivative, relative to the outcome per size of the parameter.
    pub of_outcome: f64,
}

impl StepError {
    /// What is to be said where a derivative is off by more than a millionth.
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

/// The errors of some outcomes of the flight, and of their derivatives by `wrt`; empty where a step
/// of an eighth is too short to be allowed.
///
/// # Errors
/// As [`jacobian`].
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
