//! Truncation error of outcomes and derivatives. The certificate checks derivatives of the
//! integrated flight, which differs from the exact flight by this error.

use super::scale::{scale, size_of_terms};
use crate::derivative::{Order, evaluate};
use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::json::number;
use crate::parameters::{Parameter, Setup};
use crate::units::Message;
use serde::Serialize;

/// Ratio of the time step to the step of the comparison flight. With a method of order 4, the error
/// of the comparison flight is 4096 times smaller.
const SHORTER: f64 = 8.0;

/// A derivative times the parameter's scale counts as at least this fraction of the outcome's
/// magnitude when the derivative's relative error is computed.
const LEAST_RELATIVE_SLOPE: f64 = 1e-6;

/// Relative derivative error that triggers a warning.
const WARNED_ERROR: f64 = 1e-6;

/// The truncation error of an outcome and of its derivatives, from a comparison with a shorter time
/// step.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "StepErrorReport"))]
pub struct StepError {
    /// The outcome.
    pub of: Outcome,
    /// The time step and the shorter step for comparison, s.
    pub steps: [f64; 2],
    /// The error of the value, relative to the magnitude of the terms from which the outcome is
    /// computed.
    #[serde(serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub value_error: f64,
    /// The parameter whose derivative has the largest relative error.
    pub parameter: Option<&'static Parameter>,
    /// The relative error of that derivative.
    #[serde(serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub derivative_error: Option<f64>,
    /// The error of a derivative times the typical size of its parameter, divided by the outcome's
    /// magnitude. This is the maximum over all parameters.
    #[serde(serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub derivative_error_of_outcome: f64,
}

impl StepError {
    /// Warning for a relative derivative error above 1e-6.
    pub fn warning(&self) -> Option<Message> {
        let error = self
            .derivative_error
            .filter(|error| *error > WARNED_ERROR)?;
        let parameter = self.parameter?;
        let (of, by, step) = (self.of.name(), parameter.name, 1e3 * self.steps[0]);
        let warning = format!(
            "the derivative of {of} by {by} is computed with time steps of {step} ms, and with \
             much shorter steps it would differ by {error:.0e} of \
             its value; reduce flight.step if you need it more exactly"
        );
        Some(warning.into())
    }
}

/// Truncation errors of flight outcomes and their derivatives by `wrt`; empty if an eighth of the
/// setup's time step is not an allowed step.
///
/// # Errors
/// The errors of [`evaluate`].
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
    let (found, exact) = (
        evaluate(setup, of, wrt, Order::First)?,
        evaluate(&finer, of, wrt, Order::First)?,
    );
    let error = |(i, of): (usize, &Outcome)| {
        let size = size_of_terms(*of, setup, &drive);
        let slopes = found[i].gradient.iter().zip(&exact[i].gradient).zip(wrt);
        let off = slopes.map(|((found, exact), parameter)| {
            let scale = scale(setup, parameter);
            let (off, slope) = ((found - exact).abs() * scale, exact.abs() * scale);
            (
                *parameter,
                off / slope.max(LEAST_RELATIVE_SLOPE * size),
                off / size,
            )
        });
        let off: Vec<_> = off.collect();
        let worst = off.iter().max_by(|a, b| a.1.total_cmp(&b.1));
        StepError {
            of: *of,
            steps: [setup.flight.step, finer.flight.step],
            value_error: (found[i].value - exact[i].value).abs() / size,
            parameter: worst.map(|it| it.0),
            derivative_error: worst.map(|it| it.1),
            derivative_error_of_outcome: off.iter().fold(0.0, |most, it| most.max(it.2)),
        }
    };
    Ok(of.iter().enumerate().map(error).collect())
}
