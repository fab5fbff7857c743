//! A table of measured shots.

use super::statistics::SigmaOrigin;
use crate::drive::Outcome;
use crate::parameters::{Parameter, Setup, Vary};
use crate::statistics::largest_magnitude;
use crate::units::Message;
use serde::Serialize;

/// Measured shots, one per row.
///
/// A column head is the name of a parameter (input), an outcome (measured), `sigma OUTCOME` (its
/// standard uncertainty), `stationary` (parameters in which the row's carry is maximal, separated
/// by spaces), `sigma stationary` or `note`, with its unit in brackets. Exports of launch monitors
/// are also read, with their own heads, units, separators, and marks for left and right. The carry
/// of an export is the distance to the landing point,
/// [`Outcome::CarryDistance`](crate::Outcome::CarryDistance).
///
/// Rows with `ball_speed`, `launch_angle` and `spin` or `backspin`, but no parameter of swing,
/// club, strike or impact, are launch conditions: the ball flies from them without an impact.
#[derive(Clone, Debug)]
pub struct ShotTable {
    /// Name of the source, for messages.
    pub file: String,
    /// The shots.
    pub shots: Vec<MeasuredShot>,
    /// True if each row states launch conditions, from which its ball flies without an impact.
    pub is_launched: bool,
    /// Notes, such as outcomes without a sigma column.
    pub remarks: Vec<Message>,
    /// Warnings about shots of several clubs; for a table that is not an export, also about
    /// rejected rows and contradictory spins.
    pub warnings: Vec<Message>,
    /// Column heads of the launch and of the club, if the table has both. The rows are then
    /// deliveries.
    pub(super) launch_beside_club: Option<[String; 2]>,
    /// Origin of the standard uncertainties. If there are several origins, the last of these in
    /// [`SigmaOrigin`] counts.
    pub sigma_origin: SigmaOrigin,
}

impl ShotTable {
    /// Number of residuals.
    pub fn residuals(&self) -> usize {
        self.shots.iter().map(MeasuredShot::residuals).sum()
    }

    /// A residual up to this size counts as a rounding error: 1e-12 · max |measured value/standard
    /// uncertainty|.
    pub fn rounding(&self) -> f64 {
        let measured = self.shots.iter().flat_map(|shot| &shot.measured);
        1e-12 * largest_magnitude(measured.map(|measurement| measurement.value / measurement.sigma))
    }

    /// The parameters of a setup that at least one shot states.
    pub fn given(&self, setup: &Setup<f64>) -> Vec<&'static Parameter> {
        let mut parameters = setup.parameters();
        parameters.retain(|parameter| self.gives(parameter));
        parameters
    }

    /// True if at least one shot states this parameter.
    pub fn gives(&self, parameter: &'static Parameter) -> bool {
        self.shots.iter().any(|shot| shot.gives(parameter))
    }
}

/// A measured shot: its inputs and its measured outcomes.
#[derive(Clone, Debug, Default)]
pub struct MeasuredShot {
    /// Row of the table, from 1.
    pub row: usize,
    /// Parameters that the row states, SI. They include the launch conditions if the row states a
    /// launch but no club values. All other parameters have the values of the setup.
    pub inputs: Vec<(&'static Parameter, f64)>,
    /// The measured outcomes.
    pub measured: Vec<Measurement>,
    /// Parameters in which the carry of this shot is at its maximum.
    pub stationary: Vec<Stationary>,
}

/// A measured outcome, SI. If its standard uncertainty is unknown, one unit of the column replaces
/// it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Measurement {
    /// The outcome.
    #[serde(rename = "of")]
    pub outcome: Outcome,
    /// The measured value, SI.
    #[serde(rename = "measured")]
    pub value: f64,
    /// The standard uncertainty of the measured value, SI.
    #[serde(rename = "standard_uncertainty")]
    pub sigma: f64,
}

impl Measurement {
    /// The computed minus the measured value, in units of the standard uncertainty.
    pub(in crate::study) fn residual(&self, computed: f64) -> f64 {
        self.outcome.change(self.value, computed) / self.sigma
    }
}

/// A parameter in which the carry is stationary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stationary {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// Standard uncertainty of the parameter value at which carry is maximal, SI.
    pub sigma: f64,
}

impl MeasuredShot {
    /// Number of residuals.
    pub fn residuals(&self) -> usize {
        self.measured.len() + self.stationary.len()
    }

    /// True if the row states this parameter.
    pub fn gives(&self, parameter: &'static Parameter) -> bool {
        self.inputs.iter().any(|(row, _)| *row == parameter)
    }
}

/// Ranges of the parameters that the rows state, and of the fitted parameters. The range of a
/// stated parameter contains its values in all rows. A fitted parameter has its range in `fit`. If
/// this range is unbounded or the whole allowed range, the parameter is omitted, and keeps the
/// setup's value.
pub fn ranges(table: &ShotTable, fit: &[Vary]) -> Vec<Vary> {
    let mut ranges: Vec<Vary> = vec![];
    let mut widen = |parameter, value: f64| match ranges
        .iter_mut()
        .find(|range| range.parameter == parameter)
    {
        Some(range) => (range.low, range.high) = (range.low.min(value), range.high.max(value)),
        None => ranges.push(Vary {
            parameter,
            low: value,
            high: value,
        }),
    };
    for shot in &table.shots {
        for (parameter, value) in &shot.inputs {
            widen(*parameter, *value);
        }
    }
    let is_given = |vary: &&Vary| {
        let own = &vary.parameter.range;
        (vary.low, vary.high) != (own.low, own.high) && (vary.high - vary.low).is_finite()
    };
    ranges.extend(fit.iter().filter(is_given));
    ranges
}
