//! Clarabel, the interior-point method: active sets, approximate solutions, and proofs of
//! infeasibility.

use super::active_set::ActiveConstraint;
use super::program::{QuadraticProgram, Side, Step, StepSource};
use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT};
use nalgebra::DVector;
use std::fmt;

/// Clarabel's answer.
pub(super) enum Answer {
    /// The active constraints, those with the largest multipliers first, and the solution itself
    /// where Clarabel calls it one.
    Found(Vec<ActiveConstraint>, Option<Step>),
    /// The rows cannot be met within the bounds.
    Infeasible,
}

/// A Clarabel solver for programs of one sparsity pattern. A program of the same pattern only
/// updates its data.
#[derive(Default)]
pub(super) struct InteriorPoint {
    solver: Option<DefaultSolver<f64>>,
    equations: usize,
}

impl Clone for InteriorPoint {
    /// A solver without a program: the data of the next one are all that its answer depends on.
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl fmt::Debug for InteriorPoint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("InteriorPoint")
    }
}

/// Accuracy asked of Clarabel. Where no active set is exact, its own multipliers must meet the KKT
/// tolerance of a search.
const TOLERANCE: f64 = 1e-10;

/// A constraint as a row a · x + s = limit of Clarabel's standard form, with s = 0 or s ≥ 0.
struct ConeRow {
    coefficients: Coefficients,
    limit: f64,
    constraint: ActiveConstraint,
    /// The program's multiplier for a unit of Clarabel's.
    multiplier_unit: f64,
}

enum Coefficients {
    One { variable: usize, value: f64 },
    All(Vec<f64>),
}

impl ConeRow {
    /// The coefficient of a variable; `None` for an entry that is no part of the sparsity pattern.
    fn coefficient(&self, column: usize) -> Option<f64> {
        match &self.coefficients {
            Coefficients::One { variable, value } => (*variable == column).then_some(*value),
            Coefficients::All(all) => Some(all[column]),
        }
    }
}

/// A program in Clarabel's standard form, scaled: steps in units of the largest bound, the
/// objective in units of its change over it, rows with a largest coefficient of 1. Clarabel's
/// tolerances are absolute, and its own equilibration is then of no use.
struct StandardForm {
    /// The number of variables, with the epigraph variable t ≥ offsetₖ + gradientₖ · d where there
    /// are several terms.
    size: usize,
    hessian: CscMatrix<f64>,
    gradient: Vec<f64>,
    equations: Vec<ConeRow>,
    inequalities: Vec<ConeRow>,
    length_unit: f64,
    value_unit: f64,
}

impl InteriorPoint {
    /// Solves a program; `None` where Clarabel ends with neither a solution nor a proof.
    pub fn solve(&mut self, program: &QuadraticProgram) -> Option<Answer> {
        let form = StandardForm::new(program);
        let solver = self.updated(&form)?;
        solver.solve();
        let solution = &solver.solution;
        match solution.status {
            SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible => {
                return Some(Answer::Infeasible);
            }
            _ if !solution
                .x
                .iter()
                .chain(&solution.z)
                .all(|number| number.is_finite()) =>
            {
                return None;
            }
            _ => {}
        }
        let is_accurate = matches!(
            solution.status,
            SolverStatus::Solved | SolverStatus::AlmostSolved | SolverStatus::InsufficientProgress
        );
        // of a constraint's multiplier and its slack one vanishes at a solution: the larger says
        // which
        let first = form.equations.len();
        let mut active: Vec<(f64, ActiveConstraint)> = form
            .inequalities
            .iter()
            .zip(solution.z[first..].iter().zip(&solution.s[first..]))
            .filter(|(_, (z, s))| z > s)
            .map(|(row, (z, _))| (*z, row.constraint))
            .collect();
        active.sort_by(|a, b| b.0.total_cmp(&a.0));
        let active = active
            .into_iter()
            .map(|(_, constraint)| constraint)
            .collect();
        let own = is_accurate.then(|| form.step(program, &solution.x, &solution.z));
        Some(Answer::Found(active, own))
    }

    /// The solver with the data of a program.
    fn updated(&mut self, form: &StandardForm) -> Option<&mut DefaultSolver<f64>> {
        let (matrix, limits) = form.constraints();
        if self.equations == form.equations.len()
            && let Some(solver) = &mut self.solver
            && solver
                .update_data(&form.hessian, &form.gradient, &matrix, &limits)
                .is_ok()
        {
            return self.solver.as_mut();
        }
        let cones = [
            SupportedConeT::ZeroConeT(form.equations.len()),
            SupportedConeT::NonnegativeConeT(form.inequalities.len()),
        ];
        let settings = DefaultSettings {
            verbose: false,
            // data are updated, so nothing may be removed
            presolve_enable: false,
            equilibrate_enable: false,
            tol_gap_abs: TOLERANCE,
            tol_gap_rel: TOLERANCE,
            tol_feas: TOLERANCE,
            ..DefaultSettings::default()
        };
        self.equations = form.equations.len();
        self.solver = DefaultSolver::new(
            &form.hessian,
            &form.gradient,
            &matrix,
            &limits,
            &cones,
            settings,
        )
        .ok();
        self.solver.as_mut()
    }
}

impl StandardForm {
    fn new(program: &QuadraticProgram) -> Self {
        let (n, terms) = (program.dimension(), program.max_terms.len());
        let size = n + usize::from(terms > 1);
        let length_unit = program.reach();
        let bend = program.hessian.amax() * length_unit * length_unit;
        let slope = program.largest_slope() * length_unit;
        // between the two where curvature dominates: neither vanishes beside the tolerances
        let value_unit = if slope > 0.0 {
            (slope * slope.max(bend)).sqrt()
        } else {
            bend.max(f64::MIN_POSITIVE)
        };
        let slope_unit = value_unit / length_unit;

        let mut gradient = vec![0.0; size];
        if terms > 1 {
            gradient[n] = 1.0;
        } else {
            gradient.copy_from_slice((&program.max_terms[0].gradient / slope_unit).as_slice());
        }
        let mut form = Self {
            size,
            hessian: upper_triangle(program, size, length_unit * length_unit / value_unit),
            gradient,
            equations: vec![],
            inequalities: vec![],
            length_unit,
            value_unit,
        };
        for i in 0..n {
            form.add_bounds(program, i);
        }
        for j in 0..program.rows.len() {
            form.add_row(program, j);
        }
        if terms > 1 {
            for (k, term) in program.max_terms.iter().enumerate() {
                // gradientₖ · d − t ≤ −offsetₖ
                let mut coefficients: Vec<f64> = term
                    .gradient
                    .iter()
                    .map(|slope| slope / slope_unit)
                    .collect();
                coefficients.push(-1.0);
                form.inequalities.push(ConeRow {
                    coefficients: Coefficients::All(coefficients),
                    limit: -term.offset / value_unit,
                    constraint: ActiveConstraint::MaxTerm(k),
                    multiplier_unit: 1.0,
                });
            }
        }
        form
    }

    fn add_bounds(&mut self, program: &QuadraticProgram, i: usize) {
        let row = |value: f64, limit: f64, side: Side| ConeRow {
            coefficients: Coefficients::One { variable: i, value },
            limit: limit / self.length_unit,
            constraint: ActiveConstraint::Bound(i, side),
            multiplier_unit: self.value_unit / self.length_unit,
        };
        let (upper, lower) = (
            row(1.0, program.high[i], Side::Upper),
            row(-1.0, -program.low[i], Side::Lower),
        );
        if program.low[i] == program.high[i] {
            self.equations.push(upper);
            return;
        }
        self.inequalities.extend(
            [upper, lower]
                .into_iter()
                .filter(|row| row.limit.is_finite()),
        );
    }

    fn add_row(&mut self, program: &QuadraticProgram, j: usize) {
        let row = &program.rows[j];
        let largest = if row.normal.amax() > 0.0 {
            row.normal.amax()
        } else {
            1.0
        };
        let cone_row = |sign: f64, limit: f64, side: Side| {
            let mut coefficients: Vec<f64> =
                row.normal.iter().map(|a| sign * a / largest).collect();
            coefficients.resize(self.size, 0.0);
            ConeRow {
                coefficients: Coefficients::All(coefficients),
                limit: sign * limit / (self.length_unit * largest),
                constraint: ActiveConstraint::Row(j, side),
                multiplier_unit: sign * self.value_unit / (self.length_unit * largest),
            }
        };
        if row.is_equation() {
            let equation = cone_row(1.0, row.high, Side::Upper);
            self.equations.push(equation);
            return;
        }
        let sides = [(1.0, row.high, Side::Upper), (-1.0, row.low, Side::Lower)];
        let limits: Vec<ConeRow> = sides
            .into_iter()
            .filter(|(_, limit, _)| limit.is_finite())
            .map(|(sign, limit, side)| cone_row(sign, limit, side))
            .collect();
        self.inequalities.extend(limits);
    }

    /// Equations, then inequalities.
    fn rows(&self) -> impl Iterator<Item = &ConeRow> {
        self.equations.iter().chain(&self.inequalities)
    }

    /// The matrix A and the limits b of A x + s = b.
    fn constraints(&self) -> (CscMatrix<f64>, Vec<f64>) {
        let (mut starts, mut places, mut values) = (vec![0], vec![], vec![]);
        for column in 0..self.size {
            for (at, row) in self.rows().enumerate() {
                if let Some(value) = row.coefficient(column) {
                    places.push(at);
                    values.push(value);
                }
            }
            starts.push(values.len());
        }
        let limits: Vec<f64> = self.rows().map(|row| row.limit).collect();
        (
            CscMatrix::new(limits.len(), self.size, starts, places, values),
            limits,
        )
    }

    /// Clarabel's solution x with its multipliers z, moved inside the bounds.
    fn step(&self, program: &QuadraticProgram, x: &[f64], z: &[f64]) -> Step {
        let n = program.dimension();
        let mut step = Step {
            d: DVector::from_fn(n, |i, _| x[i] * self.length_unit),
            sides: vec![Side::Inactive; n],
            weights: vec![0.0; program.max_terms.len()],
            multipliers: vec![0.0; program.rows.len()],
            source: StepSource::Unpolished,
        };
        for (row, z) in self.rows().zip(z) {
            match row.constraint {
                ActiveConstraint::Bound(..) => {}
                ActiveConstraint::Row(j, _) => step.multipliers[j] += z * row.multiplier_unit,
                ActiveConstraint::MaxTerm(k) => step.weights[k] = *z,
            }
        }
        if let [weight] = step.weights.as_mut_slice() {
            *weight = 1.0;
        }
        step.move_inside(program);
        step
    }
}

/// The upper triangle of the scaled Hessian, with all entries in the sparsity pattern.
fn upper_triangle(program: &QuadraticProgram, size: usize, scale: f64) -> CscMatrix<f64> {
    let (n, mut starts, mut places, mut values) = (program.dimension(), vec![0], vec![], vec![]);
    for column in 0..size {
        if column < n {
            places.extend(0..=column);
            values.extend(
                program
                    .hessian
                    .column(column)
                    .iter()
                    .take(column + 1)
                    .map(|entry| entry * scale),
            );
        }
        starts.push(values.len());
    }
    CscMatrix::new(size, size, starts, places, values)
}
