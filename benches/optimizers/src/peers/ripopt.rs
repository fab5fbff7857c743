//! ripopt: an interior point method, exact Hessians.

use super::{End, ITERATIONS, TOLERANCE};
use crate::oracle::{Oracle, start};
use ::longdrive::optimize::Evaluation;
use ::ripopt::{NlpProblem, SolverOptions};

struct Program<'a, 'b>(&'a Oracle<'b>);

impl Program<'_, '_> {
    /// Calls `read` if all functions are defined at x. Returns true if they are.
    fn read(&self, x: &[f64], read: impl FnOnce(&Evaluation)) -> bool {
        self.0.read(x, |at| {
            let is_defined =
                at.objective.is_finite() && at.constraints.iter().all(|c| c.is_finite());
            if is_defined {
                read(at);
            }
            is_defined
        })
    }

    /// The (row, column) indices of the lower triangle of the Hessian, row by row.
    fn triangle(&self) -> impl Iterator<Item = (usize, usize)> {
        (0..self.num_variables()).flat_map(|i| (0..=i).map(move |j| (i, j)))
    }
}

impl NlpProblem for Program<'_, '_> {
    fn num_variables(&self) -> usize {
        self.0.case.start.len()
    }

    fn num_constraints(&self) -> usize {
        self.0.case.least.len()
    }

    fn bounds(&self, low: &mut [f64], high: &mut [f64]) {
        low.copy_from_slice(self.0.case.low);
        high.copy_from_slice(self.0.case.high);
    }

    fn constraint_bounds(&self, least: &mut [f64], most: &mut [f64]) {
        least.copy_from_slice(self.0.case.least);
        most.copy_from_slice(self.0.case.most);
    }

    fn initial_point(&self, x: &mut [f64]) {
        x.copy_from_slice(&start(self.0.case));
    }

    fn objective(&self, x: &[f64], _: bool, value: &mut f64) -> bool {
        self.read(x, |at| *value = at.objective.value)
    }

    fn gradient(&self, x: &[f64], _: bool, gradient: &mut [f64]) -> bool {
        self.read(x, |at| gradient.copy_from_slice(&at.objective.gradient))
    }

    fn constraints(&self, x: &[f64], _: bool, values: &mut [f64]) -> bool {
        self.read(x, |at| {
            values
                .iter_mut()
                .zip(&at.constraints)
                .for_each(|(value, c)| *value = c.value)
        })
    }

    fn jacobian_structure(&self) -> (Vec<usize>, Vec<usize>) {
        (0..self.num_constraints())
            .flat_map(|j| (0..self.num_variables()).map(move |i| (j, i)))
            .unzip()
    }

    fn jacobian_values(&self, x: &[f64], _: bool, values: &mut [f64]) -> bool {
        let n = self.num_variables();
        self.read(x, |at| {
            values
                .iter_mut()
                .enumerate()
                .for_each(|(k, value)| *value = at.constraints[k / n].gradient[k % n]);
        })
    }

    fn hessian_structure(&self) -> (Vec<usize>, Vec<usize>) {
        self.triangle().unzip()
    }

    fn hessian_values(
        &self,
        x: &[f64],
        _: bool,
        weight: f64,
        multipliers: &[f64],
        values: &mut [f64],
    ) -> bool {
        self.read(x, |at| {
            for (value, (i, j)) in values.iter_mut().zip(self.triangle()) {
                let constraints = at
                    .constraints
                    .iter()
                    .zip(multipliers)
                    .map(|(c, m)| m * c.hessian[i][j]);
                *value = weight * at.objective.hessian[i][j] + constraints.sum::<f64>();
            }
        })
    }
}

pub fn solve(oracle: &Oracle) -> Result<End, String> {
    let options = SolverOptions {
        tol: TOLERANCE,
        // ripopt also relaxes the bounds by up to this tolerance
        constr_viol_tol: TOLERANCE,
        compl_inf_tol: TOLERANCE,
        max_iter: ITERATIONS as usize,
        print_level: 0,
        ..SolverOptions::default()
    };
    let result = ::ripopt::solve(&Program(oracle), &options);
    Ok(End {
        x: result.x,
        status: format!("{:?}", result.status),
        iterations: Some(result.iterations as u64),
    })
}
