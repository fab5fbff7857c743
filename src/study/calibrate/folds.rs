//! How well a fit tells shots that it was not made from.

use super::data::ShotTable;
use super::estimate::{Plan, Remainder, calibrate, flown};
use crate::error::{Error, Result};
use crate::optimize::least_squares::Follow;
use crate::parameters::Setup;

/// Residuals of shots that each fit had not seen.
#[derive(Clone, Debug)]
pub struct HeldOut {
    /// Parts the shots were divided in; 0 for a setup flown as it stands.
    pub folds: usize,
    /// What was left over of the rows held out.
    pub remainders: Vec<Remainder>,
}

impl HeldOut {
    /// Mean of the squared residuals, in units of the standard uncertainties.
    pub fn mean_square(&self) -> f64 {
        let sum: f64 = self.remainders.iter().map(|remainder| remainder.residual.powi(2)).sum();
        sum / self.remainders.len() as f64
    }

    /// Shots flown with a setup as it stands: of shots it was not fitted to, that is their held-out error.
    ///
    /// # Errors
    /// [`Error::Calibration`] with the row that has no answer.
    pub fn as_it_stands(setup: &Setup<f64>, table: &ShotTable) -> Result<Self> {
        Ok(Self { folds: 0, remainders: flown(setup, &table.shots)? })
    }
}

/// k-fold cross-validation (Stone 1974): every k-th row is held out in turn, and told by a fit to the others.
///
/// # Errors
/// [`Error::Calibration`] for less than 2 or more parts than rows; as [`calibrate`].
pub fn held_out(setup: &Setup<f64>, table: &ShotTable, plan: &Plan, folds: usize, follow: &Follow) -> Result<HeldOut> {
    let rows = table.shots.len();
    if folds < 2 || folds > rows {
        let reason = format!("{folds} folds of {rows} rows; at least 2 and at most one for each row are possible");
        return Err(Error::Calibration { reason });
    }
    let mut remainders = vec![];
    for fold in 0..folds {
        let (told, seen): (Vec<_>, Vec<_>) =
            table.shots.iter().cloned().enumerate().partition(|(at, _)| at % folds == fold);
        let strip = |shots: Vec<(usize, _)>| shots.into_iter().map(|(_, shot)| shot).collect::<Vec<_>>();
        let seen = ShotTable { shots: strip(seen), ..table.clone() };
        let found = calibrate(setup, &seen, plan, follow)?;
        remainders.extend(flown(&found.setup, &strip(told))?);
    }
    remainders.sort_by_key(|remainder| remainder.row);
    Ok(HeldOut { folds, remainders })
}
