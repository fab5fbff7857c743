//! Result of a calibration.

use super::statistics::FitStatistics;
use crate::drive::Outcome;
use crate::json::{by_name, number};
use crate::optimize::least_squares::{Fit, FitStatus};
use crate::parameters::{Parameter, Setup};
use serde::Serialize;
use std::fmt::{Display, Formatter};

/// The estimate of a parameter.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "EstimateReport"))]
pub struct Estimate {
    /// The parameter.
    #[serde(skip)]
    pub parameter: &'static Parameter,
    /// The estimate, SI.
    #[serde(serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub value: f64,
    /// The standard uncertainty, SI; `null` if the data do not determine the parameter or the scale
    /// of the uncertainties, or if the estimate is at a bound.
    #[serde(rename = "standard_uncertainty", serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub standard_error: Option<f64>,
    /// The 95 % interval, SI; `null` without a standard uncertainty.
    pub interval_95: Option<[f64; 2]>,
    /// True if the estimate is at a bound of the range.
    #[serde(rename = "at_bound")]
    pub is_at_bound: bool,
    /// True if the data determine the parameter, false if many of its values fit the data equally
    /// well.
    #[serde(rename = "determined")]
    pub is_determined: bool,
}

/// A residual, with the row and the outcome to which it belongs.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "Remainder"))]
pub struct FitResidual {
    /// The row of the table.
    pub row: usize,
    /// The measured outcome; carry if `parameter` is not `null`.
    #[serde(rename = "of")]
    pub outcome: Outcome,
    /// The parameter whose value in the row gives the greatest carry; `null` for the residual of a
    /// measured outcome.
    #[serde(rename = "parameter")]
    pub stationary: Option<&'static Parameter>,
    /// The measured value, SI; `null` if `parameter` is not `null`.
    pub measured: Option<f64>,
    /// Computed − measured, SI. With a `parameter`: its value at the computed maximum of carry (to
    /// first order) minus its value in the row.
    pub difference: f64,
    /// `difference` divided by the standard uncertainty of the difference.
    pub residual: f64,
}

/// The searches of a fit, each from another starting point.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "StartsReport"))]
pub struct Starts {
    /// Number of starts.
    pub made: usize,
    /// Number of starts that reached the smallest sum of squares.
    // reached: the sum exceeds the smallest by at most a relative 1e-6
    #[serde(rename = "same")]
    pub at_best: usize,
    /// Number of starts that did not reach the smallest sum of squares, by status; `undefined` if
    /// the ball of a row does not fly at the starting point.
    // empty from the second renewal of the curvatures on, since only the best search is repeated
    #[serde(rename = "elsewhere", serialize_with = "by_name")]
    #[cfg_attr(test, schemars(with = "std::collections::BTreeMap<String, usize>"))]
    pub others: Vec<(FitStatus, usize)>,
}

/// Status of a calibration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CalibrationStatus {
    /// The status of the searches, if no test of the data replaced it. Only converged and stalled
    /// searches are tested.
    Search(FitStatus),
    /// The sum is at a minimum that is not isolated: along some direction the residuals hardly
    /// change.
    Undetermined,
    /// The sum is at a minimum, but one residual is so large that the others have no influence.
    DominatedByOneResidual,
    /// The sum is at a minimum, but the residuals are much larger than their uncertainties: the
    /// model does not describe the data.
    Misfit,
}

impl CalibrationStatus {
    /// The sum is stationary within the bounds, and no test of the data failed.
    pub const CONVERGED: Self = Self::Search(FitStatus::Converged);
    /// A search was interrupted.
    pub const INTERRUPTED: Self = Self::Search(FitStatus::Interrupted);

    /// The names of all statuses.
    pub const NAMES: [&'static str; 8] = [
        Self::CONVERGED.name(),
        Self::Undetermined.name(),
        Self::DominatedByOneResidual.name(),
        Self::Misfit.name(),
        Self::Search(FitStatus::Stalled).name(),
        Self::Search(FitStatus::IterationLimit).name(),
        Self::INTERRUPTED.name(),
        Self::Search(FitStatus::Undefined).name(),
    ];

    /// Name in reports, such as `converged`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Search(status) => status.name(),
            Self::Undetermined => "undetermined",
            Self::DominatedByOneResidual => "outweighed",
            Self::Misfit => "misfit",
        }
    }
}

/// Writes the name.
impl Display for CalibrationStatus {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

/// The status of a calibration, with its reason.
#[derive(Clone, Debug)]
pub struct CalibrationVerdict {
    /// The status.
    pub status: CalibrationStatus,
    /// The status in a sentence, with the numbers of the test.
    pub message: String,
}

/// Parameters fitted to shots.
#[derive(Clone, Debug)]
pub struct Calibration {
    /// The setup with the fitted values.
    pub setup: Setup<f64>,
    /// Status of the calibration.
    pub verdict: CalibrationVerdict,
    /// Result of the best search.
    pub fit: Fit,
    /// Number of starts that reached the smallest sum of squares, and of those that did not.
    pub starts: Starts,
    /// Number of searches that were interrupted.
    pub stopped: usize,
    /// True if the best search converged to a minimum, even if other searches were interrupted.
    pub is_minimum: bool,
    /// The fitted parameters.
    pub estimates: Vec<Estimate>,
    /// Covariance, degrees of freedom and χ².
    pub statistics: FitStatistics,
    /// The residuals, in the order of the rows.
    pub residuals: Vec<FitResidual>,
}
