use super::found::{Delivered, Explained, Known};
use super::unknown::Unknown;
use super::untold::untold;
use crate::derivative::{Evaluator, Order, Taylor};
use crate::drive::{Outcome, OutcomeGroup};
use crate::error::{Error, Result};
use crate::optimize::Domain;
use crate::optimize::least_squares::{Options, Rows, fit};
use crate::parameters::Setup;
use crate::study::calibrate::Measurement;
use nalgebra::DMatrix;

/// The delivery and strike that explain a measured launch: the least sum of squares of what is
/// measured and of what was known before, each in units of its standard uncertainty, within the
/// bounds of the unknowns (Rodgers 2000, Inverse Methods for Atmospheric Sounding, ch. 2 and 5;
/// docs/model.md).
///
/// # Errors
/// [`Error::Delivery`] without measurements or unknowns, for an outcome that is not of the launch,
/// and where the setup's own values are no strike; as [`Evaluator::new`].
pub fn delivery(
    setup: &Setup<f64>,
    measured: &[Measurement],
    unknowns: &[Unknown],
) -> Result<Delivered> {
    let refuse = |reason: String| Error::Delivery { reason };
    if measured.is_empty() || unknowns.is_empty() {
        let what = if measured.is_empty() {
            "nothing is measured"
        } else {
            "nothing is sought"
        };
        return Err(refuse(format!(
            "{what}; give a launch, and parameters to find"
        )));
    }
    if let Some(other) = measured
        .iter()
        .find(|measurement| measurement.outcome.group() != OutcomeGroup::Launch)
    {
        return Err(refuse(format!(
            "{} is not of the launch; leave it out",
            other.outcome.name()
        )));
    }
    let mut own = *setup;
    for unknown in unknowns {
        own.set_value(unknown.parameter, Some(unknown.before))?;
    }
    let of: Vec<Outcome> = measured
        .iter()
        .map(|measurement| measurement.outcome)
        .collect();
    let wrt: Vec<_> = unknowns.iter().map(|unknown| unknown.parameter).collect();
    let evaluator = Evaluator::new(&own, &of, &wrt, Order::First)?;
    let rows = |x: &[f64]| match evaluator.at(x) {
        Ok(taylors) => Ok(rows(&taylors, measured, unknowns, x)),
        Err(error) => Err(error.to_string()),
    };
    let domain = Domain::new(
        unknowns.iter().map(|unknown| unknown.low).collect(),
        unknowns.iter().map(|unknown| unknown.high).collect(),
    )?;
    let start: Vec<f64> = unknowns.iter().map(|unknown| unknown.before).collect();
    let found = fit(&rows, &domain, &start, &Options::default())?;
    if found.rows.residuals.is_empty() {
        return Err(refuse(format!(
            "the search cannot begin at the setup's own values: {}",
            found.message
        )));
    }
    let mut moved = own;
    for (unknown, value) in unknowns.iter().zip(&found.x) {
        moved.set_value(unknown.parameter, Some(*value))?;
    }
    let taylors = evaluator.at(&found.x)?;
    let explained = measured
        .iter()
        .zip(&taylors)
        .map(|(measured, taylor)| Explained {
            measured: *measured,
            computed: taylor.value,
        });
    let free: Vec<usize> = (0..unknowns.len())
        .filter(|&i| (unknowns[i].low < found.x[i]) && (found.x[i] < unknowns[i].high))
        .collect();
    // each parameter in units of its uncertainty before
    let jacobian = DMatrix::from_fn(measured.len(), free.len(), |row, column| {
        found.rows.jacobian[row][free[column]] * unknowns[free[column]].sigma
    });
    let information = jacobian.transpose() * &jacobian + DMatrix::identity(free.len(), free.len());
    let covariance = information.try_inverse().ok_or_else(|| {
        refuse("the uncertainties of the measurements are too far apart to be computed with".into())
    })?;
    let known = unknowns.iter().enumerate().map(|(i, unknown)| {
        let variance = free
            .iter()
            .position(|at| *at == i)
            .map(|at| covariance[(at, at)]);
        Known {
            unknown: *unknown,
            value: found.x[i],
            sigma: variance.map(|variance| unknown.sigma * variance.max(0.0).sqrt()),
            told: variance.map(|variance| (1.0 - variance).clamp(0.0, 1.0)),
        }
    });
    let sought: Vec<_> = free
        .iter()
        .map(|&i| (unknowns[i].parameter, unknowns[i].sigma))
        .collect();
    Ok(Delivered {
        setup: moved,
        status: found.status,
        message: found.message.clone(),
        known: known.collect(),
        explained: explained.collect(),
        jacobian: found.rows.jacobian[..measured.len()].to_vec(),
        untold: untold(&jacobian, &sought),
    })
}

/// The residuals of the measured outcomes, then those of what was known before.
fn rows(taylors: &[Taylor], measured: &[Measurement], unknowns: &[Unknown], x: &[f64]) -> Rows {
    let (mut residuals, mut jacobian) = (vec![], vec![]);
    for (taylor, measurement) in taylors.iter().zip(measured) {
        let explained = Explained {
            measured: *measurement,
            computed: taylor.value,
        };
        residuals.push(explained.residual());
        jacobian.push(
            taylor
                .gradient
                .iter()
                .map(|slope| slope / measurement.sigma)
                .collect(),
        );
    }
    for (i, (unknown, value)) in unknowns.iter().zip(x).enumerate() {
        residuals.push((value - unknown.before) / unknown.sigma);
        jacobian.push(
            (0..unknowns.len())
                .map(|k| if k == i { 1.0 / unknown.sigma } else { 0.0 })
                .collect(),
        );
    }
    Rows {
        residuals,
        jacobian,
    }
}
