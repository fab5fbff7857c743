//! The interior-point solver Clarabel: active sets, approximate solutions, and proofs of
//! infeasibility.

use super::program::{Activity, QpStep, QuadraticProgram, StepSource};
use super::working_set::ActiveConstraint;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT};
use nalgebra::DVector;
use std::fmt;

/// Result of Clarabel.
pub(super) struct ClarabelResult {
    /// Active constraints, sorted by falling multiplier.
    pub active: Vec<ActiveConstraint>,
    /// The approximate solution; `None` if Clarabel reports that it is not accurate.
    pub step: Option<QpStep>,
}

/// Clarabel solver. If the next program has the same sparsity pattern, only the solver's data are
/// updated.
#[derive(Default)]
pub(super) struct InteriorPoint {
    solver: Option<DefaultSolver<f64>>,
    equations: usize,
}

impl Clone for InteriorPoint {
    /// Returns a new solver without data, so that the results of the clone do not depend on earlier
    /// programs.
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl fmt::Debug for InteriorPoint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("InteriorPoint")
    }
}

/// Clarabel's tolerances. They equal the default KKT tolerance of a search, because the search uses
/// Clarabel's own multipliers if polishing fails.
const TOLERANCE: f64 = 1e-10;

/// Constraint as a row a · x + s = limit of Clarabel's standard form, with s = 0 (equality) or s ≥
/// 0.
struct ConeRow {
    /// Coefficients, as (variable, value).
    coefficients: Vec<(usize, f64)>,
    limit: f64,
    constraint: ActiveConstraint,
    /// The program's multiplier divided by Clarabel's multiplier.
    multiplier_unit: f64,
}

/// Program in Clarabel's standard form, scaled. Steps are divided by the largest bound, the
/// objective by the size of its change over such a step, and each row by its largest coefficient.
/// This scaling replaces Clarabel's equilibration, because Clarabel's tolerances are absolute.
struct StandardForm {
    /// Number of variables. If there are several terms, this includes the epigraph variable t ≥
    /// offsetₖ + gradientₖ · d.
    size: usize,
    hessian: CscMatrix<f64>,
    gradient: Vec<f64>,
    equations: Vec<ConeRow>,
    inequalities: Vec<ConeRow>,
    length_unit: f64,
    value_unit: f64,
}

impl InteriorPoint {
    /// Solves a program; `None` if Clarabel proves that its rows are infeasible within the bounds,
    /// or if a number of Clarabel's result is not finite.
    pub fn solve(&mut self, program: &QuadraticProgram) -> Option<ClarabelResult> {
        let form = StandardForm::new(program);
        let solver = self.updated(&form)?;
        solver.solve();
        let solution = &solver.solution;
        match solution.status {
            SolverStatus::PrimalInfeasible | SolverStatus::AlmostPrimalInfeasible => {
                return None;
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
        // complementarity: a constraint is active if its multiplier z is larger than its slack s
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
        let step = is_accurate.then(|| form.step(program, &solution.x, &solution.z));
        Some(ClarabelResult { active, step })
    }

    /// Loads the data of a program into the solver.
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
            // presolve would remove rows that a later update needs
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
        let length_unit = program.largest_bound();
        let curvature = program.hessian.amax() * length_unit * length_unit;
        let slope = program.largest_gradient_component() * length_unit;
        // if the curvature is larger than the slope, divide by the geometric mean of the two, so
        // that neither becomes smaller than the tolerances
        let value_unit = if slope > 0.0 {
            (slope * slope.max(curvature)).sqrt()
        } else {
            curvature.max(f64::MIN_POSITIVE)
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
                let slopes = term.gradient.iter().map(|slope| slope / slope_unit);
                form.inequalities.push(ConeRow {
                    coefficients: slopes.chain([-1.0]).enumerate().collect(),
                    limit: -term.offset / value_unit,
                    constraint: ActiveConstraint::MaxTerm(k),
                    multiplier_unit: 1.0,
                });
            }
        }
        form
    }

    fn add_bounds(&mut self, program: &QuadraticProgram, i: usize) {
        let row = |value: f64, limit: f64, side: Activity| ConeRow {
            coefficients: vec![(i, value)],
            limit: limit / self.length_unit,
            constraint: ActiveConstraint::Bound(i, side),
            multiplier_unit: self.value_unit / self.length_unit,
        };
        let (upper, lower) = (
            row(1.0, program.high[i], Activity::Upper),
            row(-1.0, -program.low[i], Activity::Lower),
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
        let cone_row = |sign: f64, limit: f64, side: Activity| {
            let coefficients = row.normal.iter().map(|a| sign * a / largest);
            ConeRow {
                // the coefficient of the epigraph variable is 0
                coefficients: coefficients
                    .chain(std::iter::repeat(0.0))
                    .take(self.size)
                    .enumerate()
                    .collect(),
                limit: sign * limit / (self.length_unit * largest),
                constraint: ActiveConstraint::Row(j, side),
                multiplier_unit: sign * self.value_unit / (self.length_unit * largest),
            }
        };
        if row.is_equation() {
            let equation = cone_row(1.0, row.high, Activity::Upper);
            self.equations.push(equation);
            return;
        }
        let sides = [
            (1.0, row.high, Activity::Upper),
            (-1.0, row.low, Activity::Lower),
        ];
        let limits: Vec<ConeRow> = sides
            .into_iter()
            .filter(|(_, limit, _)| limit.is_finite())
            .map(|(sign, limit, side)| cone_row(sign, limit, side))
            .collect();
        self.inequalities.extend(limits);
    }

    /// All rows: equalities, then inequalities.
    fn rows(&self) -> impl Iterator<Item = &ConeRow> {
        self.equations.iter().chain(&self.inequalities)
    }

    /// Matrix A and limits b of A x + s = b.
    fn constraints(&self) -> (CscMatrix<f64>, Vec<f64>) {
        let mut entries = vec![];
        for (at, row) in self.rows().enumerate() {
            for (column, value) in &row.coefficients {
                entries.push((at, *column, *value));
            }
        }
        let limits: Vec<f64> = self.rows().map(|row| row.limit).collect();
        (sparse(limits.len(), self.size, &entries), limits)
    }

    /// Converts Clarabel's solution x and multipliers z to a step within the bounds.
    fn step(&self, program: &QuadraticProgram, x: &[f64], z: &[f64]) -> QpStep {
        let n = program.dimension();
        let mut step = QpStep {
            d: DVector::from_fn(n, |i, _| x[i] * self.length_unit),
            activities: vec![Activity::Inactive; n],
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
        step.project_on_bounds(program);
        step
    }
}

/// Upper triangle of the scaled Hessian, with a full sparsity pattern.
fn upper_triangle(program: &QuadraticProgram, size: usize, scale: f64) -> CscMatrix<f64> {
    let mut entries = vec![];
    for column in 0..program.dimension() {
        for row in 0..=column {
            entries.push((row, column, program.hessian[(row, column)] * scale));
        }
    }
    sparse(size, size, &entries)
}

/// Sparse matrix of these entries, as (row, column, value). Entries that are 0 belong to its
/// sparsity pattern too.
fn sparse(rows: usize, columns: usize, entries: &[(usize, usize, f64)]) -> CscMatrix<f64> {
    CscMatrix::new_from_triplets(
        rows,
        columns,
        entries.iter().map(|entry| entry.0).collect(),
        entries.iter().map(|entry| entry.1).collect(),
        entries.iter().map(|entry| entry.2).collect(),
    )
}
