use super::result::{Delivered, Explained, Posterior, unidentified};
use super::unknown::Unknown;
use crate::derivative::{Evaluator, Order, Taylor};
use crate::drive::{Outcome, OutcomeGroup};
use crate::error::{Error, Result};
use crate::optimize::Domain;
use crate::optimize::least_squares::{FitOptions, Rows, fit};
use crate::parameters::Setup;
use crate::study::calibrate::Measurement;
use nalgebra::DMatrix;

/// The most probable delivery and strike for a measured launch: bounded least squares of the
/// measurements and the priors, each divided by its standard uncertainty (Rodgers 2000, Inverse
/// Methods for Atmospheric Sounding, ch. 2 and 5; docs/model.md). `setup` must not give a launch:
/// the club strikes the ball. [`launches`](super::launches) makes `measured` from a setup that
/// does.
///
/// # Errors
/// [`Error::Delivery`] if `measured` or `unknowns` is empty, if a measured outcome does not belong
/// to the launch, or if the club does not strike the ball with the prior values; the errors of
/// [`Evaluator::new`].
pub fn delivery(
    setup: &Setup<f64>,
    measured: &[Measurement],
    unknowns: &[Unknown],
) -> Result<Delivered> {
    check(measured, unknowns)?;
    let priors: Vec<f64> = unknowns.iter().map(|unknown| unknown.prior).collect();
    let wrt: Vec<_> = unknowns.iter().map(|unknown| unknown.parameter).collect();
    let own = setup.with_values(&wrt, &priors)?;
    let of: Vec<Outcome> = measured
        .iter()
        .map(|measurement| measurement.outcome)
        .collect();
    let evaluator = Evaluator::new(&own, &of, &wrt, Order::First)?;
    let rows = |x: &[f64]| match evaluator.at(x) {
        Ok(taylors) => Ok(rows(&taylors, measured, unknowns, x)),
        Err(error) => Err(error.to_string()),
    };
    let domain = Domain::new(
        unknowns.iter().map(|unknown| unknown.range[0]).collect(),
        unknowns.iter().map(|unknown| unknown.range[1]).collect(),
    )?;
    let found = fit(&rows, &domain, &priors, &FitOptions::default())?;
    if found.rows.residuals.is_empty() {
        return Err(Error::Delivery {
            reason: format!(
                "the search cannot begin at the setup's own values: {}",
                found.message
            ),
        });
    }
    let moved = own.with_values(&wrt, &found.x)?;
    let computed = evaluator.at(&found.x)?;
    let explained = measured.iter().zip(&computed);
    let explained = explained.map(|(measured, taylor)| Explained {
        measured: *measured,
        computed: taylor.value,
        residual: measured.residual(taylor.value),
    });
    let free: Vec<usize> = (0..unknowns.len())
        .filter(|&i| {
            let [low, high] = unknowns[i].range;
            low < found.x[i] && found.x[i] < high
        })
        .collect();
    // derivatives of the residuals by parameters in units of their prior standard uncertainties
    let jacobian = DMatrix::from_fn(measured.len(), free.len(), |row, column| {
        found.rows.jacobian[row][free[column]] * unknowns[free[column]].sigma
    });
    let posteriors = posteriors(&jacobian, &free, unknowns, &found.x)?;
    let free_parameters: Vec<_> = free
        .iter()
        .map(|&i| (unknowns[i].parameter, unknowns[i].sigma))
        .collect();
    Ok(Delivered {
        setup: moved,
        status: found.status,
        message: found.message.clone(),
        posteriors,
        measured: vec![],
        given: vec![],
        explained: explained.collect(),
        unidentified: unidentified(&jacobian, &free_parameters),
    })
}

/// Refuses a search without measurements or unknowns, and a measured outcome that does not belong
/// to the launch.
fn check(measured: &[Measurement], unknowns: &[Unknown]) -> Result<()> {
    let refuse = |reason: String| Error::Delivery { reason };
    if measured.is_empty() || unknowns.is_empty() {
        let what = if measured.is_empty() {
            "no outcome of the launch is measured"
        } else {
            "no parameter is to be found"
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
            "{} is not an outcome of the launch; leave it out",
            other.outcome.name()
        )));
    }
    Ok(())
}

/// Posterior of each unknown at `x`. The covariance of the `free` unknowns is (JᵀJ + I)⁻¹, in units
/// of the prior standard uncertainties.
fn posteriors(
    jacobian: &DMatrix<f64>,
    free: &[usize],
    unknowns: &[Unknown],
    x: &[f64],
) -> Result<Vec<Posterior>> {
    let information = jacobian.transpose() * jacobian + DMatrix::identity(free.len(), free.len());
    let covariance = information.try_inverse().ok_or_else(|| Error::Delivery {
        reason: "the uncertainties of the measurements differ by too many orders of magnitude"
            .into(),
    })?;
    let posterior = |(i, unknown): (usize, &Unknown)| {
        let variance = free
            .iter()
            .position(|at| *at == i)
            .map(|at| covariance[(at, at)]);
        Posterior {
            unknown: *unknown,
            value: x[i],
            sigma: variance.map(|variance| unknown.sigma * variance.max(0.0).sqrt()),
            variance_removed: variance.map(|variance| (1.0 - variance).clamp(0.0, 1.0)),
        }
    };
    Ok(unknowns.iter().enumerate().map(posterior).collect())
}

/// The residuals of the measurements, then the residuals of the priors.
fn rows(taylors: &[Taylor], measured: &[Measurement], unknowns: &[Unknown], x: &[f64]) -> Rows {
    let (mut residuals, mut jacobian) = (vec![], vec![]);
    for (taylor, measurement) in taylors.iter().zip(measured) {
        residuals.push(measurement.residual(taylor.value));
        jacobian.push(
            taylor
                .gradient
                .iter()
                .map(|slope| slope / measurement.sigma)
                .collect(),
        );
    }
    for (i, (unknown, value)) in unknowns.iter().zip(x).enumerate() {
        residuals.push(unknown.residual(*value));
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
