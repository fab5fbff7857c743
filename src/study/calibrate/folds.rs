//! How well a fit tells shots that it was not made from.

use super::calibration::Remainder;
use super::estimate::{Plan, calibrate, flown};
use super::shot_table::ShotTable;
use crate::error::{Error, Result};
use crate::optimize::least_squares::{Follow, Status};
use crate::parameters::Setup;
use crate::units::counted;

/// Residuals of shots that each fit had not seen.
#[derive(Clone, Debug)]
pub struct HeldOut {
    /// Parts the shots were divided in; 0 for a setup flown as it stands.
    pub folds: usize,
    /// How the fit for each part ended. What was left over by one that was interrupted is not told.
    pub ended: Vec<Status>,
    /// What was left over of the rows held out.
    pub remainders: Vec<Remainder>,
}

impl HeldOut {
    /// Mean of the squared residuals, in units of the standard uncertainties; `None` where every
    /// fit was interrupted.
    pub fn mean_square(&self) -> Option<f64> {
        let sum: f64 = self
            .remainders
            .iter()
            .map(|remainder| remainder.residual.powi(2))
            .sum();
        (!self.remainders.is_empty()).then(|| sum / self.remainders.len() as f64)
    }

    /// How many fits ended so.
    pub fn count(&self, status: Status) -> usize {
        self.ended.iter().filter(|ended| **ended == status).count()
    }

    /// Whether a fit was interrupted.
    pub fn is_interrupted(&self) -> bool {
        self.count(Status::Interrupted) > 0
    }

    /// Shots flown with a setup as it stands: of shots it was not fitted to, that is their held-out
    /// error. Once it is interrupted, that counts as one fit that was, and nothing is told of the
    /// rows.
    ///
    /// # Errors
    /// [`Error::NoFit`] with the rows that have no answer.
    pub fn as_it_stands(setup: &Setup<f64>, table: &ShotTable, follow: &Follow) -> Result<Self> {
        let flown = flown(setup, &table.shots, &follow.interrupt)?;
        let ended = if flown.is_none() {
            vec![Status::Interrupted]
        } else {
            vec![]
        };
        Ok(Self {
            folds: 0,
            ended,
            remainders: flown.unwrap_or_default(),
        })
    }
}

/// Whether a plan can be cross-validated in so many parts: what [`held_out`] refuses, said before
/// any fit.
///
/// # Errors
/// [`Error::Calibration`] for less than 2 or more parts than rows, for a plan that does not fit the
/// table, and where a fit would be left with fewer values than parameters.
pub fn check_folds(table: &ShotTable, plan: &Plan, folds: usize) -> Result<()> {
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
            "a fit without a fold has {} of {}, fewer than the {} to fit; take more folds, measure \
             more, or fit less",
            counted(least as u64, "measured value"),
            table.file,
            counted(parameters as u64, "parameter")
        ));
    }
    Ok(())
}

/// k-fold cross-validation (Stone 1974): every k-th row is held out in turn, and told by a fit to
/// the others. Once it is interrupted, the fit under way and those to come are counted as such, and
/// their rows left out.
///
/// # Errors
/// As [`check_folds`] and [`calibrate`].
pub fn held_out(
    setup: &Setup<f64>,
    table: &ShotTable,
    plan: &Plan,
    folds: usize,
    follow: &Follow,
) -> Result<HeldOut> {
    check_folds(table, plan, folds)?;
    let (mut remainders, mut ended) = (vec![], vec![]);
    for fold in 0..folds {
        if follow.is_interrupted() {
            ended.push(Status::Interrupted);
            continue;
        }
        let (told, seen): (Vec<_>, Vec<_>) = table
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
        let found = match calibrate(setup, &seen, plan, follow) {
            // before it had begun
            Err(_) if follow.is_interrupted() => None,
            found => Some(found?).filter(|found| found.fit.status != Status::Interrupted),
        };
        let told = match &found {
            Some(found) => flown(&found.setup, &strip(told), &follow.interrupt)?,
            None => None,
        };
        let status = found
            .filter(|_| told.is_some())
            .map_or(Status::Interrupted, |found| found.fit.status);
        ended.push(status);
        remainders.extend(told.into_iter().flatten());
    }
    remainders.sort_by_key(|remainder| remainder.row);
    Ok(HeldOut {
        folds,
        ended,
        remainders,
    })
}
