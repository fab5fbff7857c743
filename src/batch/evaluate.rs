//! The drives of a block: side by side where that is possible, the rows left over one by one.

use super::abreast::{Abreast, DIRECTIONS};
use super::block::{Block, Status};
use super::question::Batch;
use crate::derivative::{Evaluator, Order};
use crate::drive::{Beyond, Drive, Looked, Outcome};
use crate::error::{Error, Result};
use crate::flight::{Flight, NoFlight};
use crate::number::Taylor;
use crate::parameters::{Parameter, Setup};

/// Halvings of the step within which a drive has to get below the largest defect.
const HALVINGS: usize = 12;

impl Batch {
    /// The drives of some points, given one after the other.
    ///
    /// # Panics
    /// Where the last point has not a value for each parameter.
    pub fn evaluate(&self, first_row: u64, points: Vec<f64>) -> Block {
        let (values, parameters) = (points.len(), self.parameters.len());
        assert!(
            values.is_multiple_of(parameters),
            "points of {parameters} parameters need a multiple of {parameters} values; there are {values}"
        );
        let rows = values / parameters;
        let empty = |columns: usize| vec![vec![f64::NAN; rows]; columns];
        let mut block = Block {
            first_row,
            parameters: self.parameters.len(),
            status: vec![Status::OutOfRange; rows],
            beyond: vec![Beyond::default(); rows],
            defect: vec![0.0; rows],
            outcomes: empty(self.of.len()),
            derivatives: empty(self.of.len() * self.wrt.len()),
            points,
        };
        let mut alone = if self.goes_abreast() { self.abreast(&mut block) } else { (0..rows).collect() };
        alone.extend((0..rows).filter(|&row| self.is_off(block.defect[row])));
        for row in alone {
            // what was found of it side by side
            block.outcomes.iter_mut().chain(&mut block.derivatives).for_each(|column| column[row] = f64::NAN);
            if let Ok(setup) = self.moved(block.point(row)) {
                self.drive(setup, row, &mut block);
            }
        }
        block
    }

    /// Whether drives are computed side by side. They are not where the inertia tensor is swept, which must be checked in each row, nor by so many
    /// parameters that the derivatives of one drive fill the lanes.
    fn goes_abreast(&self) -> bool {
        const MOST_DERIVATIVES: usize = 4 * DIRECTIONS;
        let sweeps_inertia = self.parameters.iter().any(|parameter| parameter.is_of_inertia());
        !sweeps_inertia && self.wrt.len() <= MOST_DERIVATIVES
    }

    /// Computes the drives of a block side by side; the rows that have to be looked at one by one are left over.
    fn abreast(&self, block: &mut Block) -> Vec<usize> {
        if self.wrt.is_empty() {
            return self.level.run(Abreast { batch: self, block, wrt: &[], first: 0 });
        }
        let mut alone = vec![];
        for (chunk, wrt) in self.wrt.chunks(DIRECTIONS).enumerate() {
            alone.extend(self.level.run(Abreast { batch: self, block, wrt, first: DIRECTIONS * chunk }));
        }
        alone.sort_unstable();
        alone.dedup();
        alone
    }

    fn moved(&self, point: &[f64]) -> Result<Setup<f64>> {
        let mut setup = self.setup;
        for (parameter, value) in self.parameters.iter().zip(point) {
            setup.set_value(parameter, Some(*value))?;
        }
        setup.validate()?;
        Ok(setup)
    }

    /// Whether a drive with this defect is not followed closely enough.
    fn is_off(&self, defect: f64) -> bool {
        defect > self.largest_defect
    }

    /// The drive with the longest of some steps, each half of the one before, that follows it closely enough. Without a largest
    /// defect that is the first.
    fn followed(&self, setup: &mut Setup<f64>) -> Result<Drive<f64>> {
        let mut halvings = if self.largest_defect.is_finite() { HALVINGS } else { 0 };
        loop {
            let found = Drive::in_any_steps(setup);
            let is_close = match &found {
                Ok(Drive { flight: Flight::Landed(landed), .. }) => !self.is_off(landed.defect),
                Err(Error::Diverged { .. }) => false,
                _ => true,
            };
            if is_close || halvings == 0 {
                return found;
            }
            halvings -= 1;
            setup.flight.step *= 0.5;
        }
    }

    fn drive(&self, mut setup: Setup<f64>, row: usize, block: &mut Block) {
        let drive = match self.followed(&mut setup) {
            Ok(drive) => drive,
            Err(Error::Diverged { .. }) => return block.status[row] = Status::Diverged,
            Err(_) => return block.status[row] = Status::NoStrike,
        };
        let setup = &setup;
        block.status[row] = match &drive.flight {
            Flight::Landed(landed) if self.is_off(landed.defect) => return block.status[row] = Status::Diverged,
            Flight::Landed(landed) => {
                block.defect[row] = landed.defect;
                Status::Landed
            }
            Flight::None(NoFlight::Aloft { .. }) => Status::Aloft,
            Flight::None(_) => Status::NoFlight,
        };
        block.beyond[row] = drive.beyond(setup, Looked::AtLaunch, &self.of);
        for (outcome, column) in self.of.iter().zip(&mut block.outcomes) {
            column[row] = outcome.value(&drive).unwrap_or(f64::NAN);
        }
        if !self.wrt.is_empty() {
            self.differentiate(setup, row, block);
        }
    }

    /// Outcomes of one drive with their gradients.
    fn gradients(&self, setup: &Setup<f64>, of: &[Outcome], wrt: &[&'static Parameter]) -> Result<Vec<Taylor>> {
        Evaluator::new(setup, of, wrt, Order::First)?.at_level(self.level).at_setup(setup, &mut |_, _| ())
    }

    /// The derivatives that exist: all at once, or where one is missing each by itself.
    fn differentiate(&self, setup: &Setup<f64>, row: usize, block: &mut Block) {
        let mut columns = block.derivatives.iter_mut();
        let mut put = |d: f64| {
            if let Some(column) = columns.next() {
                column[row] = d;
            }
        };
        match self.gradients(setup, &self.of, &self.wrt) {
            Ok(taylors) => taylors.iter().flat_map(|taylor| &taylor.gradient).for_each(|d| put(*d)),
            Err(_) => {
                for (outcome, values) in self.of.iter().zip(&block.outcomes) {
                    for parameter in &self.wrt {
                        let exists = values[row].is_finite();
                        let d = exists.then(|| self.gradients(setup, &[*outcome], &[parameter]));
                        put(d.and_then(Result::ok).map_or(f64::NAN, |taylors| taylors[0].gradient[0]));
                    }
                }
            }
        }
    }
}
