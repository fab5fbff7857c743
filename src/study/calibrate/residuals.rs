//! Residuals of measured shots, (computed − measured)/σ, with exact Jacobians by the fitted
//! parameters.

use super::shot_table::{MeasuredShot, Measurement, Stationary};
use crate::derivative::{self, Evaluator, Order};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::optimize::least_squares::Rows;
use crate::parameters::{Parameter, Setup};
use crate::study::cancellable::{each_until, stopped_before};
use crate::units::significant;
use std::sync::atomic::AtomicBool;

/// End of the message "stopped before all shots were flown".
const FLOWN: &str = "all shots were flown";

/// Upper limit of a residual: larger residuals may overflow when they are squared and added.
const TOO_FAR: f64 = 1e150;

fn too_far(measurement: &Measurement, computed: f64) -> Error {
    let outcome = measurement.outcome;
    Error::Calibration {
        reason: format!(
            "{} was measured as {} and is computed as {}: the difference is more than {TOO_FAR:e} \
             times the standard uncertainty {}; correct the value or its sigma",
            outcome.name(),
            outcome.show(measurement.value),
            outcome.show(computed),
            outcome.show(measurement.sigma)
        ),
    }
}

/// Text of an error at trial values of the fitted parameters, without the prefix of an
/// [`Error::Calibration`].
fn reason(error: Error) -> String {
    match error {
        Error::Calibration { reason } => reason,
        // with an unphysical parameter value the flight diverges at any step size, so the advice to
        // shorten the step does not help
        Error::Diverged { time, .. } => format!(
            "with these values of the fitted parameters the flight diverges at t = {} s: drag or \
             lift is far too large",
            significant(time, 3)
        ),
        error => error.to_string(),
    }
}

/// Shots and the parameters fitted to them.
pub(super) struct ShotResiduals<'a> {
    pub setup: Setup<f64>,
    pub shots: &'a [MeasuredShot],
    pub fitted: Vec<&'static Parameter>,
    /// |∂²carry/∂q²|, m/rad², for each shot and each of its stationary parameters q. The slope
    /// ∂carry/∂q divided by this curvature is an angle. The curvatures are constant during a
    /// search, so that the Jacobian is exact.
    pub curvatures: Vec<Vec<f64>>,
    /// Cancellation flag: once true, no more shots are flown.
    pub stop: &'a AtomicBool,
}

impl ShotResiduals<'_> {
    /// The setup with the fitted parameters set to `x`. It may lack values that every shot has, such
    /// as the speed of the wind.
    pub fn moved(&self, x: &[f64]) -> Result<Setup<f64>> {
        let moved = self.setup.with_values(&self.fitted, x)?;
        moved.validate_values()?;
        Ok(moved)
    }

    /// |∂²carry/∂q²| at `x`, in the layout of [`curvatures`](Self::curvatures).
    pub fn curvatures_at(&self, x: &[f64]) -> Result<Vec<Vec<f64>>> {
        let moved = self.moved(x)?;
        let of = |shot: &MeasuredShot| {
            let setup = at_shot(&moved, shot)?;
            let one = |stationary: &Stationary| {
                Ok(
                    derivative::hessian(&setup, Outcome::Carry, &[stationary.parameter])?.hessian
                        [0][0]
                        .abs(),
                )
            };
            shot.stationary
                .iter()
                .map(one)
                .collect::<Result<Vec<f64>>>()
        };
        let all = each_until(self.shots, self.stop, of).ok_or_else(|| stopped_before(FLOWN))?;
        all.into_iter().collect()
    }

    /// The residuals of one shot, each with its row of the Jacobian.
    fn of(&self, moved: &Setup<f64>, shot: &MeasuredShot, curvatures: &[f64]) -> Result<Rows> {
        let setup = at_shot(moved, shot)?;
        let mut rows = Rows {
            residuals: vec![],
            jacobian: vec![],
        };
        if !shot.measured.is_empty() {
            let of: Vec<_> = shot
                .measured
                .iter()
                .map(|measurement| measurement.outcome)
                .collect();
            let values: Vec<_> = self
                .fitted
                .iter()
                .filter_map(|parameter| setup.value(parameter))
                .collect();
            let order = if self.fitted.is_empty() {
                Order::Value
            } else {
                Order::First
            };
            let evaluator = Evaluator::new(&setup, &of, &self.fitted, order)?;
            for (taylor, measurement) in evaluator.at(&values)?.into_iter().zip(&shot.measured) {
                let residual = measurement.residual(taylor.value);
                if residual.abs() > TOO_FAR {
                    let (outcome, value) = (measurement.outcome, measurement.value);
                    let computed = outcome.unwrap_angle(taylor.value, value);
                    return Err(too_far(measurement, computed));
                }
                rows.residuals.push(residual);
                let row = taylor.gradient.iter().map(|d| d / measurement.sigma);
                rows.jacobian.push(row.collect());
            }
        }
        for (stationary, curvature) in shot
            .stationary
            .iter()
            .zip(curvatures.iter().chain(std::iter::repeat(&1.0)))
        {
            let wrt: Vec<_> = self
                .fitted
                .iter()
                .copied()
                .chain([stationary.parameter])
                .collect();
            let last = self.fitted.len();
            let carry =
                derivative::last_hessian_row(&setup, &[Outcome::Carry], &wrt)?.swap_remove(0);
            let per = 1.0 / (curvature.max(f64::MIN_POSITIVE) * stationary.sigma);
            rows.residuals.push(carry.gradient[last] * per);
            let row = carry.hessian[last][..last].iter().map(|d| d * per);
            rows.jacobian.push(row.collect());
        }
        Ok(rows)
    }

    /// Residuals of each shot flown with a setup, or the error of the shot.
    pub fn by_shot(&self, moved: &Setup<f64>) -> Result<Vec<Result<Rows>>> {
        let all: Vec<_> = self.shots.iter().enumerate().collect();
        // there are no curvatures if `begin` failed; the caller then uses only the errors of the
        // shots
        let of = |&(at, shot): &(usize, &MeasuredShot)| {
            self.of(
                moved,
                shot,
                self.curvatures.get(at).map_or(&[], Vec::as_slice),
            )
        };
        each_until(&all, self.stop, of).ok_or_else(|| stopped_before(FLOWN))
    }

    /// Computes [`curvatures`](Self::curvatures) at `x` and checks every row; true if all rows can
    /// be computed.
    pub fn begin(&mut self, x: &[f64]) -> bool {
        let Ok(curvatures) = self.curvatures_at(x) else {
            return false;
        };
        self.curvatures = curvatures;
        self.evaluate(x).is_ok()
    }

    /// The residuals and their Jacobian at `x`, or why they are undefined.
    pub fn evaluate(&self, x: &[f64]) -> std::result::Result<Rows, String> {
        let moved = self.moved(x).map_err(|error| error.to_string())?;
        let by_shot = self.by_shot(&moved).map_err(|error| error.to_string())?;
        let mut all = Rows {
            residuals: vec![],
            jacobian: vec![],
        };
        for (rows, shot) in by_shot.into_iter().zip(self.shots) {
            let rows = rows.map_err(|error| format!("row {}: {}", shot.row, reason(error)))?;
            all.residuals.extend(rows.residuals);
            all.jacobian.extend(rows.jacobian);
        }
        Ok(all)
    }
}

/// The setup with the inputs of a shot.
pub(super) fn at_shot(setup: &Setup<f64>, shot: &MeasuredShot) -> Result<Setup<f64>> {
    let mut setup = *setup;
    for (parameter, value) in &shot.inputs {
        setup.set_value(parameter, Some(*value))?;
    }
    Ok(setup)
}
