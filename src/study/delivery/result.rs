//! The delivery found for a launch: posterior of each unknown, and unidentified directions.

use super::unknown::Unknown;
use crate::optimize::least_squares::Status;
use crate::parameters::{Parameter, Setup};
use crate::study::calibrate::Measurement;
use nalgebra::{DMatrix, SymmetricEigen};

/// Posterior of one parameter, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Posterior {
    /// The parameter with its prior.
    pub unknown: Unknown,
    /// The most probable value.
    pub value: f64,
    /// Standard uncertainty of the value; `None` if the value lies on a bound.
    pub sigma: Option<f64>,
    /// Fraction of the prior variance that the shot removes: 1 if the launch determines the
    /// parameter, 0 if it carries no information. `None` if the value lies on a bound.
    pub variance_removed: Option<f64>,
}

/// A measured outcome and its computed value, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Explained {
    /// The measurement.
    pub measured: Measurement,
    /// The value computed from the delivery.
    pub computed: f64,
}

impl Explained {
    /// Computed − measured, divided by the standard uncertainty of the measurement.
    pub fn residual(&self) -> f64 {
        let Measurement {
            outcome,
            value,
            sigma,
        } = self.measured;
        (outcome.unwrap_angle(self.computed, value) - value) / sigma
    }
}

/// Largest residual of a launch that counts as explained, in standard uncertainties.
const EXPLAINED_WITHIN: f64 = 3.0;

/// The most probable delivery for a measured launch.
#[derive(Clone, Debug)]
pub struct Delivered {
    /// The setup with this delivery.
    pub setup: Setup<f64>,
    /// Status of the search.
    pub status: Status,
    /// The status as a sentence.
    pub message: String,
    /// The posterior of each unknown.
    pub posteriors: Vec<Posterior>,
    /// The measured outcomes with their computed values.
    pub explained: Vec<Explained>,
    /// Derivatives of the measured outcomes by the unknowns, divided by the outcome's standard
    /// uncertainty, at the solution.
    pub jacobian: Vec<Vec<f64>>,
    /// Directions that the launch does not identify, the least identified first.
    pub unidentified: Vec<Unidentified>,
}

impl Delivered {
    /// The worst residual if it is too large: no delivery within the ranges gives this launch.
    pub fn unexplained(&self) -> Option<&Explained> {
        let worst = self
            .explained
            .iter()
            .max_by(|a, b| a.residual().abs().total_cmp(&b.residual().abs()));
        worst.filter(|worst| worst.residual().abs() > EXPLAINED_WITHIN)
    }

    /// True if the search converged and explains the launch.
    pub fn is_found(&self) -> bool {
        self.status == Status::Converged && self.unexplained().is_none()
    }
}

/// Threshold for unidentified directions: the shot removes a smaller fraction of the prior variance
/// along the direction.
const UNIDENTIFIED_BELOW: f64 = 0.5;
/// Threshold for the components of a direction. Smaller components are omitted.
const LEAST_COMPONENT: f64 = 0.1;

/// A combined change of parameters that hardly changes the launch.
#[derive(Clone, Debug, PartialEq)]
pub struct Unidentified {
    /// Fraction of the prior variance along the direction that the shot removes, below one half.
    pub variance_removed: f64,
    /// Change of each parameter, SI. The total change is one prior standard uncertainty; the first
    /// component is positive.
    pub changes: Vec<(&'static Parameter, f64)>,
}

/// The unidentified directions: eigenvectors of JᵀJ with small eigenvalues. `jacobian` holds the
/// derivatives of the residuals by the parameters in units of their prior standard uncertainty.
pub(super) fn unidentified(
    jacobian: &DMatrix<f64>,
    free_parameters: &[(&'static Parameter, f64)],
) -> Vec<Unidentified> {
    // every parameter lies on a bound
    if free_parameters.is_empty() {
        return vec![];
    }
    let SymmetricEigen {
        eigenvalues,
        eigenvectors,
    } = (jacobian.transpose() * jacobian).symmetric_eigen();
    let mut all: Vec<Unidentified> = (0..free_parameters.len())
        .map(|k| {
            let eigenvalue = eigenvalues[k].max(0.0);
            let direction = eigenvectors.column(k);
            let part = free_parameters.iter().zip(direction.iter());
            let large: Vec<_> = part
                .filter(|(_, part)| part.abs() >= LEAST_COMPONENT)
                .collect();
            let sign = large.first().map_or(1.0, |(_, part)| part.signum());
            let changes = large
                .into_iter()
                .map(|((parameter, sigma), part)| (*parameter, sign * part * sigma));
            Unidentified {
                variance_removed: eigenvalue / (1.0 + eigenvalue),
                changes: changes.collect(),
            }
        })
        .filter(|direction| direction.variance_removed < UNIDENTIFIED_BELOW)
        .collect();
    all.sort_by(|a, b| a.variance_removed.total_cmp(&b.variance_removed));
    all
}
