//! basin's SLSQP.

use super::{DECREASE_TOLERANCE, End, ITERATIONS};
use crate::oracle::{Oracle, Row, rows, start};
use ::basin::{
    BoxBounds, ConstraintDescription, ConstraintJacobian, ConstraintSet, ConstraintSolveError,
    Constraints, CostFunction, DenseMatrix, Executor, Gradient, NoLinearConstraints,
    NonlinearBlock, NonlinearBlocks, NonlinearEqualityValues, NonlinearInequalityValues,
    SelectedFirstOrderState, Slsqp, State,
};
use std::convert::Infallible;

struct General<'a, 'b> {
    oracle: &'a Oracle<'b>,
    low: Vec<f64>,
    high: Vec<f64>,
    equalities: Vec<Row>,
    inequalities: Vec<Row>,
}

impl General<'_, '_> {
    fn values(&self, rows: &[Row], x: &[f64]) -> Vec<f64> {
        self.oracle
            .read(x, |at| rows.iter().map(|row| row.value(at)).collect())
    }
}

impl Constraints for General<'_, '_> {
    type Set = ConstraintSet<
        BoxBounds<Vec<f64>>,
        NoLinearConstraints,
        NonlinearBlocks<NonlinearBlock, NonlinearBlock>,
    >;

    fn constraints(&self) -> <Self::Set as ConstraintDescription>::Borrowed<'_> {
        ConstraintSet::new()
            .with_bounds(BoxBounds::new(Some(&self.low), Some(&self.high)))
            .with_nonlinear_equalities(self.equalities.len())
            .with_nonlinear_inequalities(self.inequalities.len())
    }
}

impl CostFunction for General<'_, '_> {
    type Param = Vec<f64>;
    type Output = f64;
    type Error = Infallible;

    fn cost(&self, x: &Vec<f64>) -> Result<f64, Infallible> {
        Ok(self.oracle.read(x, |at| at.objective.value))
    }
}

impl Gradient for General<'_, '_> {
    type Gradient = Vec<f64>;

    fn gradient(&self, x: &Vec<f64>) -> Result<Vec<f64>, Infallible> {
        Ok(self.oracle.read(x, |at| at.objective.gradient.clone()))
    }
}

impl NonlinearEqualityValues for General<'_, '_> {
    type Param = Vec<f64>;
    type Values = Vec<f64>;
    type Error = Infallible;

    fn nonlinear_equalities(
        &self,
        x: &Vec<f64>,
    ) -> Result<Vec<f64>, ConstraintSolveError<Infallible>> {
        Ok(self.values(&self.equalities, x))
    }
}

impl NonlinearInequalityValues for General<'_, '_> {
    type Param = Vec<f64>;
    type Values = Vec<f64>;
    type Error = Infallible;

    fn nonlinear_inequalities(
        &self,
        x: &Vec<f64>,
    ) -> Result<Vec<f64>, ConstraintSolveError<Infallible>> {
        Ok(self.values(&self.inequalities, x))
    }
}

impl ConstraintJacobian for General<'_, '_> {
    type Param = Vec<f64>;
    type Jacobian = DenseMatrix;
    type Error = Infallible;

    fn constraint_jacobian(
        &self,
        x: &Vec<f64>,
    ) -> Result<DenseMatrix, ConstraintSolveError<Infallible>> {
        let rows = || self.equalities.iter().chain(&self.inequalities);
        Ok(self.oracle.read(x, |at| {
            let entries: Vec<f64> = rows()
                .flat_map(|row| (0..x.len()).map(|i| row.slope(at, i)))
                .collect();
            DenseMatrix::from_row_slice(rows().count(), x.len(), &entries)
        }))
    }
}

pub fn solve(oracle: &Oracle) -> Result<End, String> {
    let case = oracle.case;
    let (equalities, inequalities) = rows(case);
    let problem = General {
        oracle,
        low: case.low.to_vec(),
        high: case.high.to_vec(),
        equalities,
        inequalities,
    };
    let solver = Slsqp::new().with_absolute_accuracy_tolerance(DECREASE_TOLERANCE);
    let result = Executor::new(problem, solver, SelectedFirstOrderState::new(start(case)))
        .max_iter(ITERATIONS)
        .run_with_solver()
        .map_err(|e| format!("{e:?}"))?;
    let status = match result.solver.failure() {
        Some(failure) => format!("{failure:?}"),
        None => format!("{:?}", result.report.code()),
    };
    Ok(End {
        x: result.state.param().clone(),
        status,
        iterations: Some(result.state.iter()),
    })
}
