//! Cross-validation: prediction errors of shots that were not used in the fit.

use super::calibration::{CalibrationStatus, FitResidual};
use super::estimate::{FitPlan, calibrate, flown};
use super::shot_table::ShotTable;
use crate::error::{Error, Result};
use crate::optimize::least_squares::FitObserver;
use crate::parameters::Setup;
use crate::units::counted;

/// Residuals of held-out shots.
#[derive(Clone, Debug)]
pub struct HeldOut {
    /// Number of folds; 0 for a setup flown without a fit.
    pub folds: usize,
    /// Status of the fit of each fold. An interrupted fit gives no residuals.
    pub statuses: Vec<CalibrationStatus>,
    /// Residuals of the held-out rows.
    pub residuals: Vec<FitResidual>,
}

impl HeldOut {
    /// Mean square of the residuals, which are in units of standard uncertainty; `None` if every
    /// fit was interrupted.
    pub fn mean_square(&self) -> Option<f64> {
        let sum: f64 = self.residuals.iter().map(|one| one.residual.powi(2)).sum();
        (!self.residuals.is_empty()).then(|| sum / self.residuals.len() as f64)
    }

    /// Number of fits with this status.
    pub fn count(&self, status: CalibrationStatus) -> usize {
        self.statuses.iter().filter(|own| **own == status).count()
    }

    /// Reports whether a fit was interrupted.
    pub fn is_interrupted(&self) -> bool {
        self.count(CalibrationStatus::INTERRUPTED) > 0
    }

    /// Residuals of shots flown with the setup itself, without a fit. If the flights are
    /// interrupted, the result has the status of an interrupted fit and no residuals.
    ///
    /// # Errors
    /// [`Error::NoFit`], which lists the rows, if rows cannot be computed.
    pub fn as_it_stands(
        setup: &Setup<f64>,
        table: &ShotTable,
        observer: &FitObserver,
    ) -> Result<Self> {
        let flown = flown(setup, &table.shots, &observer.interrupt)?;
        let statuses = if flown.is_none() {
            vec![CalibrationStatus::INTERRUPTED]
        } else {
            vec![]
        };
        Ok(Self {
            folds: 0,
            statuses,
            residuals: flown.unwrap_or_default(),
        })
    }
}

/// Checks `plan` and the number of `folds` before any fit.
///
/// # Errors
/// [`Error::Calibration`] if there are fewer than 2 folds or more folds than rows, or if the rows
/// outside a fold have fewer measured values than there are parameters to fit; the errors of
/// [`calibrate`] about the plan.
pub fn check_folds(table: &ShotTable, plan: &FitPlan, folds: usize) -> Result<()> {
    let refuse = |reason: String| Err(Error::Calibration { reason });
    let rows = table.shots.len();
    if folds < 2 || folds > rows {
        let (folds, rows) = (counted(folds as u64, "fold"), counted(rows as u64, "row"));
        return refuse(format!(
            "{folds} cannot be made of {rows}; cross-validation needs 2 folds or more, and at most \
             one for each row"
        ));
    }
    plan.check(table)?;
    let left = |fold: usize| -> usize {
        let seen = table
            .shots
            .iter()
            .enumerate()
            .filter(|(at, _)| at % folds != fold);
        seen.map(|(_, shot)| shot.residuals()).sum()
    };
    let (least, parameters) = (
        (0..folds).map(left).min().unwrap_or_default(),
        plan.fit.len(),
    );
    if least < parameters {
        return refuse(format!(
            "the rows outside of a fold have {} of {}, fewer than the {} to fit; use more folds, more \
             rows, or fewer parameters",
            counted(least as u64, "measured value"),
            table.file,
            counted(parameters as u64, "parameter")
        ));
    }
    Ok(())
}

/// k-fold cross-validation (Stone 1974). A fold is every k-th row, and a fit to all other rows
/// predicts the rows of the fold. After an interruption, all remaining fits count as interrupted,
/// and their folds have no residuals.
///
/// # Errors
/// The errors of [`check_folds`] and [`calibrate`].
pub fn held_out(
    setup: &Setup<f64>,
    table: &ShotTable,
    plan: &FitPlan,
    folds: usize,
    observer: &FitObserver,
) -> Result<HeldOut> {
    check_folds(table, plan, folds)?;
    let (mut residuals, mut statuses) = (vec![], vec![]);
    for fold in 0..folds {
        if observer.is_interrupted() {
            statuses.push(CalibrationStatus::INTERRUPTED);
            continue;
        }
        let (held_out, seen): (Vec<_>, Vec<_>) = table
            .shots
            .iter()
            .cloned()
            .enumerate()
            .partition(|(at, _)| at % folds == fold);
        let strip =
            |shots: Vec<(usize, _)>| shots.into_iter().map(|(_, shot)| shot).collect::<Vec<_>>();
        let seen = ShotTable {
            shots: strip(seen),
            ..table.clone()
        };
        let found = match calibrate(setup, &seen, plan, observer) {
            // interrupted before the fit began
            Err(_) if observer.is_interrupted() => None,
            found => {
                Some(found?).filter(|found| found.verdict.status != CalibrationStatus::INTERRUPTED)
            }
        };
        let held_out = match &found {
            Some(found) => flown(&found.setup, &strip(held_out), &observer.interrupt)?,
            None => None,
        };
        let status = found
            .filter(|_| held_out.is_some())
            .map_or(CalibrationStatus::INTERRUPTED, |found| found.verdict.status);
        statuses.push(status);
        residuals.extend(held_out.into_iter().flatten());
    }
    residuals.sort_by_key(|residual| residual.row);
    Ok(HeldOut {
        folds,
        statuses,
        residuals,
    })
}
