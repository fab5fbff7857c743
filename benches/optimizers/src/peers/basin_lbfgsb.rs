//! basin's L-BFGS-B.

use super::{End, ITERATIONS, TOLERANCE};
use crate::oracle::{Oracle, start};
use ::basin::{
    BoxBounds, ConstraintDescription, ConstraintSet, Constraints, CostFunction, Executor,
    FirstOrderState, Gradient, Lbfgsb,
};
use std::convert::Infallible;

struct Bounded<'a, 'b> {
    oracle: &'a Oracle<'b>,
    low: Vec<f64>,
    high: Vec<f64>,
}

impl Constraints for Bounded<'_, '_> {
    type Set = ConstraintSet<BoxBounds<Vec<f64>>>;

    fn constraints(&self) -> <Self::Set as ConstraintDescription>::Borrowed<'_> {
        ConstraintSet::new().with_bounds(BoxBounds::new(Some(&self.low), Some(&self.high)))
    }
}

impl CostFunction for Bounded<'_, '_> {
    type Param = Vec<f64>;
    type Output = f64;
    type Error = Infallible;

    fn cost(&self, x: &Vec<f64>) -> Result<f64, Infallible> {
        Ok(self.oracle.read(x, |at| at.objective.value))
    }
}

impl Gradient for Bounded<'_, '_> {
    type Gradient = Vec<f64>;

    fn gradient(&self, x: &Vec<f64>) -> Result<Vec<f64>, Infallible> {
        Ok(self.oracle.read(x, |at| at.objective.gradient.clone()))
    }
}

pub fn solve(oracle: &Oracle) -> Result<End, String> {
    let case = oracle.case;
    let problem = Bounded {
        oracle,
        low: case.low.to_vec(),
        high: case.high.to_vec(),
    };
    // the tolerance for the decrease of f is the solver's default, 10 ε
    let solver = Lbfgsb::new().with_absolute_projected_gradient_tolerance(TOLERANCE);
    let result = Executor::new(problem, solver, FirstOrderState::new(start(case)))
        .max_iter(ITERATIONS)
        .run()
        .map_err(|e| format!("{e:?}"))?;
    Ok(End {
        x: result.param().clone(),
        status: format!("{:?}", result.report.code()),
        iterations: None,
    })
}
