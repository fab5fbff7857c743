//! The delivery found for a launch: posterior of each unknown, and unidentified directions.

use super::unknown::Unknown;
use crate::json::by_name;
use crate::optimize::least_squares::FitStatus;
use crate::parameters::{Parameter, Setup};
use crate::statistics::largest_magnitude;
use crate::study::calibrate::Measurement;
use crate::units::{Digits, DisplayUnit, Message, fixed};
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use serde::Serialize;

/// A parameter of a delivery.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "KnownReport"))]
pub struct Posterior {
    /// The parameter with its prior.
    #[serde(flatten)]
    pub unknown: Unknown,
    /// The most probable value, SI.
    pub value: f64,
    /// The posterior standard uncertainty, SI; `null` at a bound.
    #[serde(rename = "standard_uncertainty")]
    pub sigma: Option<f64>,
    /// The fraction of the prior variance that the shot removes, 0 to 1; `null` at a bound.
    // 1 if the launch determines the parameter, 0 if it carries no information
    #[serde(rename = "told")]
    pub variance_removed: Option<f64>,
}

impl Posterior {
    /// The found minus the prior value, in prior standard uncertainties.
    pub fn residual(&self) -> f64 {
        self.unknown.residual(self.value)
    }
}

/// An outcome of a launch, measured and computed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "ExplainedReport"))]
pub struct Explained {
    /// The measurement.
    #[serde(flatten)]
    pub measured: Measurement,
    /// The value computed from the most probable delivery, SI.
    pub computed: f64,
    /// The computed minus the measured value, in units of the standard uncertainty.
    pub residual: f64,
}

/// A value counts as explained if it differs from the given value by at most this number of
/// standard uncertainties.
const EXPLAINED_WITHIN: f64 = 3.0;

/// Digits of the values in [`Delivered::unexplained`].
const DIGITS: Digits = Digits::Significant(4);

/// The most probable delivery for a measured launch.
#[derive(Clone, Debug)]
pub struct Delivered {
    /// The setup with this delivery.
    pub setup: Setup<f64>,
    /// Status of the search.
    pub status: FitStatus,
    /// The status as a sentence.
    pub message: String,
    /// The posterior of each unknown.
    pub posteriors: Vec<Posterior>,
    /// Unknowns whose prior is a club value that was measured with this launch.
    pub measured: Vec<&'static Parameter>,
    /// Parameters with a value in the row of this shot that are not unknowns, such as the loft.
    pub given: Vec<&'static Parameter>,
    /// The measured outcomes with their computed values.
    pub explained: Vec<Explained>,
    /// Directions that the launch does not identify, the least identified first.
    pub unidentified: Vec<Unidentified>,
}

impl Delivered {
    /// The parameters with a stated value or uncertainty. The delivery must agree with them, as it
    /// must agree with the launch.
    pub fn stated(&self) -> impl Iterator<Item = &Posterior> {
        let all = self.posteriors.iter();
        all.filter(|posterior| posterior.unknown.is_stated())
    }

    /// The largest residual, in standard uncertainties, of the values of the launch and the stated
    /// values of the club.
    pub fn largest_residual(&self) -> f64 {
        let launch = self.explained.iter().map(|explained| explained.residual);
        largest_magnitude(launch.chain(self.stated().map(Posterior::residual)))
    }

    /// The reason why the delivery does not explain the launch; `None` if all values agree within 3
    /// standard uncertainties. The reason names the value that differs most.
    pub fn unexplained(&self) -> Option<Message> {
        let size = self.largest_residual();
        if size <= EXPLAINED_WITHIN {
            return None;
        }
        let message = |name: &str, of: DisplayUnit, values: [f64; 2]| {
            let [given, found] = values
                .map(|value| Message::default().quantity(of.quantity, of.unit, value, DIGITS));
            Message::from(
                "no delivery within the ranges agrees with all given values of launch and club: \
                 the most probable one has ",
            )
            .words(format!("{name} "))
            .message(found)
            .words(" in place of ")
            .message(given)
            .words(format!(
                ", {} standard uncertainties away; check each of these values, the club (`set`) \
                 and the ranges (`vary`)",
                fixed(size, 1)
            ))
        };
        let mut launch = self.explained.iter();
        if let Some(worst) = launch.find(|explained| explained.residual.abs() == size) {
            let Measurement { outcome, value, .. } = worst.measured;
            let values = [value, worst.computed];
            return Some(message(outcome.name(), outcome.into(), values));
        }
        let worst = self
            .stated()
            .find(|stated| stated.residual().abs() == size)?;
        let parameter = worst.unknown.parameter;
        let values = [worst.unknown.prior, worst.value];
        Some(message(parameter.name, parameter.into(), values))
    }
}

/// A direction is unidentified if the shot removes less than this fraction of the prior variance
/// along the direction.
const UNIDENTIFIED_BELOW: f64 = 0.5;
/// Smaller components of a direction, which is a unit vector, may be omitted.
const LEAST_COMPONENT: f64 = 0.1;
/// Omitted components together change the launch by at most this part of its standard
/// uncertainties (root of the sum of squares).
const OMITTED_EFFECT: f64 = 0.05;

/// A change of the delivery that the launch does not determine.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "UnidentifiedReport"))]
pub struct Unidentified {
    /// The fraction of the prior variance that the shot removes, 0 to 1.
    #[serde(rename = "told")]
    pub variance_removed: f64,
    /// The change of each parameter, SI: a component of the unit vector along the direction, times
    /// the prior standard uncertainty of the parameter. Small components are omitted if they
    /// hardly change the launch. The first change is positive.
    #[serde(serialize_with = "by_name")]
    #[cfg_attr(test, schemars(with = "std::collections::BTreeMap<String, f64>"))]
    pub changes: Vec<(&'static Parameter, f64)>,
}

/// The unidentified directions: eigenvectors of JᵀJ with small eigenvalues. J (`jacobian`) has the
/// derivatives of the residuals by the free parameters, in units of their prior standard
/// uncertainties. `free_parameters` has the parameters that are not at a bound, each with this
/// uncertainty.
pub(super) fn unidentified(
    jacobian: &DMatrix<f64>,
    free_parameters: &[(&'static Parameter, f64)],
) -> Vec<Unidentified> {
    // if every parameter is at a bound, there is no direction
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
            let direction: Vec<f64> = eigenvectors.column(k).iter().copied().collect();
            let shown = shown_components(jacobian, &direction);
            let sign = shown.first().map_or(1.0, |i| direction[*i].signum());
            let changes = shown.into_iter().map(|i| {
                let (parameter, sigma) = free_parameters[i];
                (parameter, sign * direction[i] * sigma)
            });
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

/// The components of a direction that are shown, in order. The smallest components are omitted, as
/// long as they are below [`LEAST_COMPONENT`] and their effect is at most [`OMITTED_EFFECT`].
fn shown_components(jacobian: &DMatrix<f64>, direction: &[f64]) -> Vec<usize> {
    let mut shown: Vec<usize> = (0..direction.len()).collect();
    shown.sort_by(|a, b| direction[*a].abs().total_cmp(&direction[*b].abs()));
    let mut omitted = DVector::zeros(jacobian.nrows());
    let count = shown
        .iter()
        .take_while(|&&i| {
            omitted += jacobian.column(i) * direction[i];
            direction[i].abs() < LEAST_COMPONENT && omitted.norm() <= OMITTED_EFFECT
        })
        .count();
    shown.drain(..count);
    shown.sort_unstable();
    shown
}
