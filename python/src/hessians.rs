//! Hessians of the rows of a batch.

use longdrive::Outcome;
use longdrive::batch::{Block, Status};
use longdrive::derivative::{Evaluator, Order, Taylor};
use longdrive::integration::Integration;
use longdrive::parameters::Parameter;
use std::sync::atomic::AtomicBool;

/// Second derivatives of outcomes at the points of a batch.
pub struct Hessians {
    integration: Integration,
    points: Vec<&'static Parameter>,
    of: Vec<Outcome>,
    wrt: Vec<&'static Parameter>,
    /// The evaluator of all rows. `None` if each row needs its own evaluator, because the points
    /// set a parameter that is not in `wrt`, or `wrt` has a parameter without a value in the setup.
    once: Option<Evaluator>,
}

impl Hessians {
    /// Second derivatives of the outcomes `of` by `wrt`, at points that give values to `points`.
    ///
    /// # Errors
    /// The errors of [`Evaluator::new`].
    pub fn new(
        integration: &Integration,
        points: &[&'static Parameter],
        of: &[Outcome],
        wrt: &[&'static Parameter],
    ) -> longdrive::Result<Self> {
        let is_once = points.iter().all(|row| wrt.contains(row))
            && wrt
                .iter()
                .all(|row| integration.setup.variable(row.name).is_ok());
        let once = is_once
            .then(|| integration.evaluator(of, wrt, Order::Second))
            .transpose()?;
        Ok(Self {
            integration: integration.clone(),
            points: points.to_vec(),
            of: of.to_vec(),
            wrt: wrt.to_vec(),
            once,
        })
    }

    /// Number of second derivatives in a row.
    pub fn width(&self) -> usize {
        self.of.len() * self.wrt.len() * self.wrt.len()
    }

    /// The Hessians of the outcomes of a row, one after the other; `None` if they do not exist.
    pub fn of_row(&self, block: &Block, row: usize) -> Option<Vec<f64>> {
        if matches!(
            block.status(row),
            Status::OutOfRange | Status::NoStrike | Status::Diverged
        ) {
            return None;
        }
        let taylors = self.taylors(block.point(row)).ok()?;
        Some(
            taylors
                .into_iter()
                .flat_map(|taylor| taylor.hessian.concat())
                .collect(),
        )
    }

    fn taylors(&self, point: &[f64]) -> longdrive::Result<Vec<Taylor>> {
        if let Some(evaluator) = &self.once {
            let given = |row: &&'static Parameter| {
                let at = self.points.iter().position(|point| point == row);
                at.map(|at| point[at])
                    .or_else(|| self.integration.setup.value(row))
                    .unwrap_or(f64::NAN)
            };
            return evaluator.at(&self.wrt.iter().map(given).collect::<Vec<_>>());
        }
        let mut moved = self.integration.clone();
        for (row, value) in self.points.iter().zip(point) {
            moved.setup.set_value(row, Some(*value))?;
        }
        let never = AtomicBool::new(false);
        moved.evaluate_until(&self.of, &self.wrt, Order::Second, &never)
    }
}
