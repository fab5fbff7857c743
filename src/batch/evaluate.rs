//! Evaluation of a block: lane batches first, then scalar evaluation of the remaining rows.

use super::block::{Block, Status};
use super::definition::Batch;
use super::lane_batch::{LaneBatch, LaunchPartition};
use crate::derivative::{Evaluator, Order};
use crate::drive::{CheckScope, Drive, ExceededLimits, Outcome};
use crate::error::{Error, Result};
use crate::flight::{Flight, NoFlight};
use crate::number::MOST_PER_LANE;
use crate::parameters::{Parameter, Setup};
use std::sync::atomic::AtomicBool;

/// Largest number of parameters of differentiation in a lane batch. With more parameters, each row
/// is evaluated by itself: its directions fill the four lanes of AVX2, the widest level that a
/// single drive uses.
const MOST_IN_LANES: usize = 4 * MOST_PER_LANE;

impl Batch {
    /// Computes the drives of a block. `points` has the values of the swept parameters, SI, row by
    /// row.
    ///
    /// # Panics
    /// If the last point is incomplete.
    pub fn evaluate(&self, first_row: u64, points: Vec<f64>) -> Block {
        self.evaluate_until(first_row, points, &AtomicBool::new(false))
            .unwrap_or_else(|| unreachable!("the flag is never set"))
    }

    /// Like [`evaluate`](Self::evaluate). Returns `None` if `stop` became true and interrupted a
    /// flight.
    ///
    /// # Panics
    /// If the last point is incomplete.
    pub fn evaluate_until(
        &self,
        first_row: u64,
        points: Vec<f64>,
        stop: &AtomicBool,
    ) -> Option<Block> {
        let (values, parameters) = (points.len(), self.parameters.len());
        assert!(
            values.is_multiple_of(parameters),
            "points of {parameters} parameters need a multiple of {parameters} values; there are \
             {values}"
        );
        let rows = values / parameters;
        let empty = |columns: usize| vec![vec![f64::NAN; rows]; columns];
        let mut block = Block {
            first_row,
            parameters: self.parameters.len(),
            status: vec![Status::OutOfRange; rows],
            exceeded: vec![ExceededLimits::default(); rows],
            defect: vec![0.0; rows],
            outcomes: empty(self.of.len()),
            derivatives: empty(self.of.len() * self.wrt.len()),
            points,
        };
        let mut scalar_rows = self.evaluate_in_lanes(&mut block, stop);
        scalar_rows.extend((0..rows).filter(|&row| block.defect[row] > self.largest_defect));
        for row in scalar_rows {
            // discard the results of the lane batch
            block
                .outcomes
                .iter_mut()
                .chain(&mut block.derivatives)
                .for_each(|column| column[row] = f64::NAN);
            let setup = self.setup.with_values(&self.parameters, block.point(row));
            let Ok(setup) = setup.and_then(|setup| setup.validate().map(|()| setup)) else {
                continue;
            };
            if let Err(Error::Stopped) = self.evaluate_scalar(setup, row, &mut block, stop) {
                return None;
            }
        }
        Some(block)
    }

    /// Computes the drives of a block in lane batches, and returns the rows that need scalar
    /// evaluation. These are all rows in two cases: the inertia tensor is swept, so that it must be
    /// checked in each row, or there are more than [`MOST_IN_LANES`] parameters of differentiation.
    fn evaluate_in_lanes(&self, block: &mut Block, stop: &AtomicBool) -> Vec<usize> {
        if self.wrt.len() > MOST_IN_LANES
            || self
                .parameters
                .iter()
                .any(|parameter| parameter.is_of_inertia())
        {
            return (0..block.rows()).collect();
        }
        let (mut flying, mut scalar_rows) = (vec![], vec![]);
        self.level.run_sweep(LaunchPartition {
            batch: self,
            block,
            flying: &mut flying,
            scalar_rows: &mut scalar_rows,
        });
        // without derivatives, a single iteration computes the values
        for first in (0..self.wrt.len().max(1)).step_by(MOST_PER_LANE) {
            let wrt = &self.wrt[first..self.wrt.len().min(first + MOST_PER_LANE)];
            self.level.run_sweep(LaneBatch {
                batch: self,
                block,
                wrt,
                first,
                stop,
                flying: &flying,
                scalar_rows: &mut scalar_rows,
            });
        }
        scalar_rows.sort_unstable();
        scalar_rows.dedup();
        scalar_rows
    }

    /// Scalar evaluation of a drive. The step is halved until the defect of the integration is
    /// accepted.
    ///
    /// # Errors
    /// [`Error::Stopped`] if `stop` became true; the errors of a drive without an impact or with a
    /// diverged flight. The status of the drive is in the block also after an error.
    fn evaluate_scalar(
        &self,
        mut setup: Setup<f64>,
        row: usize,
        block: &mut Block,
        stop: &AtomicBool,
    ) -> Result<()> {
        let drive =
            Drive::refined(&mut setup, self.largest_defect, Some(stop)).inspect_err(|error| {
                block.status[row] = match error {
                    Error::Diverged { .. } | Error::LargeDefect { .. } => Status::Diverged,
                    _ => Status::NoStrike,
                }
            })?;
        let setup = &setup;
        block.status[row] = match &drive.flight {
            Flight::Landed(landed) => {
                block.defect[row] = landed.defect.unwrap_or_default();
                Status::Landed
            }
            Flight::None(NoFlight::Aloft { .. }) => Status::Aloft,
            Flight::None(_) => Status::NoFlight,
        };
        block.exceeded[row] = drive.exceeded_limits(setup, CheckScope::Launch, &self.of, stop);
        for (outcome, column) in self.of.iter().zip(&mut block.outcomes) {
            column[row] = outcome.value(&drive).unwrap_or(f64::NAN);
        }
        if !self.wrt.is_empty() {
            self.differentiate(setup, row, block, stop)?;
        }
        Ok(())
    }

    /// Computes the derivatives of all outcomes in one evaluation. If it fails, computes each
    /// derivative in an evaluation of its own; a derivative whose evaluation fails is missing.
    ///
    /// # Errors
    /// [`Error::Stopped`] if `stop` became true.
    fn differentiate(
        &self,
        setup: &Setup<f64>,
        row: usize,
        block: &mut Block,
        stop: &AtomicBool,
    ) -> Result<()> {
        let gradients = |of: &[Outcome], wrt: &[&'static Parameter]| {
            let evaluator = Evaluator::new(setup, of, wrt, Order::First)
                .map(|evaluator| evaluator.at_level(self.level));
            match evaluator.and_then(|evaluator| evaluator.at_setup(Some(stop), &|_, _| ())) {
                Err(Error::Stopped) => Err(Error::Stopped),
                found => Ok(found.ok()),
            }
        };
        let all = gradients(&self.of, &self.wrt)?;
        for (column, values) in block.derivatives.iter_mut().enumerate() {
            let (i, k) = (column / self.wrt.len(), column % self.wrt.len());
            let exists = block.outcomes[i][row].is_finite();
            values[row] = match &all {
                Some(taylors) => taylors[i].gradient[k],
                None if exists => gradients(&self.of[i..=i], &self.wrt[k..=k])?
                    .map_or(f64::NAN, |taylors| taylors[0].gradient[0]),
                None => f64::NAN,
            };
        }
        Ok(())
    }
}
