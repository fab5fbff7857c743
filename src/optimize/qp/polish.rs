//! Polishing: the exact KKT point of a working set, and corrections of the set.

use super::linear::SymmetricSystem;
use super::program::{Activity, LinearConstraint, MaxTerm, QpStep, QuadraticProgram, StepSource};
use super::working_set::{ActiveConstraint, WorkingSet};
use nalgebra::{DMatrix, DVector};

/// Unknowns of the equations of a working set, in this order: inactive variables, multipliers of
/// the active terms except the first, multipliers of the active rows.
struct Unknowns {
    free: Vec<usize>,
    first_term: usize,
    other_terms: Vec<usize>,
    rows: Vec<usize>,
}

impl Unknowns {
    /// `None` without an active term.
    fn new(program: &QuadraticProgram, active: &WorkingSet) -> Option<Self> {
        let mut terms = (0..program.max_terms.len()).filter(|&k| active.max_terms[k]);
        Some(Self {
            free: (0..program.dimension())
                .filter(|&i| active.bounds[i] == Activity::Inactive)
                .collect(),
            first_term: terms.next()?,
            other_terms: terms.collect(),
            rows: (0..program.rows.len())
                .filter(|&j| active.rows[j] != Activity::Inactive)
                .collect(),
        })
    }

    /// Index of the equation of the first active row.
    fn first_row(&self) -> usize {
        self.free.len() + self.other_terms.len()
    }
}

impl SymmetricSystem {
    /// Adds the equation normal · d = limit of an active term or row, and the column of its
    /// multiplier. `free` lists the unknown components of d; `d` holds the other components.
    fn add_equation(
        &mut self,
        at: usize,
        free: &[usize],
        d: &DVector<f64>,
        normal: impl Fn(usize) -> f64,
        limit: f64,
    ) {
        for (row, &i) in free.iter().enumerate() {
            self.matrix[(row, at)] = normal(i);
            self.matrix[(at, row)] = normal(i);
        }
        self.right[at] = limit
            - d.iter()
                .enumerate()
                .map(|(i, d)| normal(i) * d)
                .sum::<f64>();
    }
}

/// Largest distance between Clarabel's solution and the exact point of its active set, relative to
/// the size of the step.
const NEARBY: f64 = 1e-6;
/// Rounding error of the value normal · d of a row, relative to 1 + max |normalᵢ| max |dᵢ|.
const ROW_ROUNDING: f64 = 1e-11;
/// Rounding error of a variable at a bound, relative to the largest component of the step.
const BOUND_ROUNDING: f64 = 1e-14;

impl QuadraticProgram {
    /// Working set of the constraints `ranked`, which are sorted by falling multiplier. Drops
    /// constraints from the end of `ranked` until the equations are consistent. Clarabel reports
    /// two limits as active if they are closer than its tolerance, and their equations contradict
    /// each other.
    pub(super) fn consistent_working_set(&self, mut ranked: Vec<ActiveConstraint>) -> WorkingSet {
        loop {
            let active = WorkingSet::new(self, ranked.iter().copied());
            if self.candidate(&active).is_some() || ranked.pop().is_none() {
                return active;
            }
        }
    }

    /// Corrects a working set until its exact solution satisfies the KKT conditions. Returns the
    /// set and the solution; `None` if a set comes up again, or if a set has no solution.
    pub(super) fn polished(&self, mut active: WorkingSet) -> Option<(WorkingSet, QpStep)> {
        let most = 2 * (self.dimension() + self.rows.len() + self.max_terms.len()) + 4;
        let mut seen = vec![];
        while seen.len() < most && !seen.contains(&active) {
            let candidate = self.candidate(&active)?;
            let corrected = self.corrected(&active, &candidate);
            if corrected == active {
                return Some((active, self.checked_step(candidate)?));
            }
            seen.push(std::mem::replace(&mut active, corrected));
        }
        None
    }

    /// Exact point of a working set, with the multipliers of an approximate solution; `None` if the
    /// two points are not close. The exact equations do not determine the multipliers if the
    /// gradients of active constraints are linearly dependent; they may give a multiplier the wrong
    /// sign.
    pub(super) fn with_multipliers_of(
        &self,
        active: &WorkingSet,
        approximate: &QpStep,
    ) -> Option<QpStep> {
        let candidate = self.candidate(active)?;
        let distance = (&candidate.d - &approximate.d).amax();
        if distance > NEARBY * (approximate.d.amax() + self.largest_bound().min(1.0)) {
            return None;
        }
        let step = self.checked_step(candidate)?;
        let QpStep {
            weights,
            multipliers,
            ..
        } = approximate.clone();
        Some(QpStep {
            weights,
            multipliers,
            ..step
        })
    }

    /// Exact solution of a working set, if it satisfies the KKT conditions.
    pub(super) fn exact_step(&self, active: &WorkingSet) -> Option<QpStep> {
        let candidate = self.candidate(active)?;
        if self.corrected(active, &candidate) != *active {
            return None;
        }
        self.checked_step(candidate)
    }

    /// Projects a candidate on the bounds. `None` if the result, because of rounding, violates a
    /// row or has a higher objective than the zero step.
    fn checked_step(&self, mut step: QpStep) -> Option<QpStep> {
        step.project_on_bounds(self);
        let meets_rows = self.violation(&step.d) <= 1e-9 * (1.0 + step.d.amax());
        (meets_rows && self.is_no_worse_than_zero_step(&step)).then_some(step)
    }

    /// False if the zero step is feasible and has a lower objective.
    fn is_no_worse_than_zero_step(&self, step: &QpStep) -> bool {
        if self.rows.iter().any(|row| row.low > 0.0 || row.high < 0.0) {
            return true;
        }
        let at_zero = self
            .max_terms
            .iter()
            .map(|term| term.offset)
            .fold(f64::NEG_INFINITY, f64::max);
        let rounding = 1e-14 * self.largest_bound() * self.largest_gradient_component();
        self.value(&step.d) <= at_zero + rounding
    }

    /// Solves the program with the active bounds, rows and terms as equations, for the step d and
    /// the multipliers αₖ of the terms and μⱼ of the rows:
    ///
    /// - B d + Σ αₖ gradientₖ + Σ μⱼ normalⱼ = 0 for the inactive variables
    /// - Σ αₖ = 1
    /// - offsetₖ + gradientₖ · d is equal for all active terms
    /// - normalⱼ · d is equal to the limit of each active row.
    ///
    /// Subtracting the first active term from the other active terms eliminates the first term's
    /// multiplier and the equation Σ αₖ = 1. The solution may violate inactive constraints.
    fn candidate(&self, active: &WorkingSet) -> Option<QpStep> {
        let unknowns = Unknowns::new(self, active)?;
        let mut d = DVector::from_fn(self.dimension(), |i, _| match active.bounds[i] {
            Activity::Inactive => 0.0,
            Activity::Lower => self.low[i],
            Activity::Upper => self.high[i],
        });
        let solution = self.kkt_system(active, &unknowns, &d).solve()?;
        for (row, &i) in unknowns.free.iter().enumerate() {
            d[i] = solution[row];
        }
        let scattered = |length: usize, indices: &[usize], offset: usize| {
            let mut all = vec![0.0; length];
            for (k, &index) in indices.iter().enumerate() {
                all[index] = solution[offset + k];
            }
            all
        };
        let mut weights = scattered(
            self.max_terms.len(),
            &unknowns.other_terms,
            unknowns.free.len(),
        );
        weights[unknowns.first_term] = 1.0 - weights.iter().sum::<f64>();
        Some(QpStep {
            weights,
            multipliers: scattered(self.rows.len(), &unknowns.rows, unknowns.first_row()),
            activities: active.bounds.clone(),
            d,
            source: StepSource::Clarabel,
        })
    }

    /// The KKT equations of a working set, for the unknowns; `d` holds the variables at bounds.
    fn kkt_system(
        &self,
        active: &WorkingSet,
        unknowns: &Unknowns,
        d: &DVector<f64>,
    ) -> SymmetricSystem {
        let MaxTerm { offset, gradient } = &self.max_terms[unknowns.first_term];
        let size = unknowns.first_row() + unknowns.rows.len();
        let mut system = SymmetricSystem {
            matrix: DMatrix::zeros(size, size),
            right: DVector::zeros(size),
        };
        for (column, &i) in unknowns.free.iter().enumerate() {
            let curvature = self.hessian.column(i);
            for (row, &j) in unknowns.free.iter().enumerate() {
                system.matrix[(row, column)] = curvature[j];
            }
            system.right[column] = -gradient[i] - curvature.dot(d);
        }
        for (k, &term) in unknowns.other_terms.iter().enumerate() {
            let other = &self.max_terms[term];
            system.add_equation(
                unknowns.free.len() + k,
                &unknowns.free,
                d,
                |i| other.gradient[i] - gradient[i],
                offset - other.offset,
            );
        }
        for (k, &j) in unknowns.rows.iter().enumerate() {
            let LinearConstraint { normal, low, high } = &self.rows[j];
            let limit = if active.rows[j] == Activity::Lower {
                *low
            } else {
                *high
            };
            system.add_equation(
                unknowns.first_row() + k,
                &unknowns.free,
                d,
                |i| normal[i],
                limit,
            );
        }
        system
    }

    /// Corrects a working set. A constraint that `candidate` violates becomes active; an active
    /// constraint whose multiplier has the wrong sign becomes inactive.
    fn corrected(&self, active: &WorkingSet, candidate: &QpStep) -> WorkingSet {
        let gradient = self.lagrangian_gradient(candidate);
        // the active terms have a common value (epigraph variable)
        let first = active.max_terms.iter().position(|is_active| *is_active);
        let epigraph = first.map_or(0.0, |k| self.max_terms[k].value(&candidate.d));
        WorkingSet {
            bounds: (0..self.dimension())
                .map(|i| self.corrected_bound(i, active, candidate, gradient[i]))
                .collect(),
            rows: (0..self.rows.len())
                .map(|j| self.corrected_row(j, active, candidate))
                .collect(),
            max_terms: (0..self.max_terms.len())
                .map(|k| self.corrected_term(k, active, candidate, epigraph))
                .collect(),
        }
    }

    /// Gradient of the Lagrangian, B d + Σ αₖ gradientₖ + Σ μⱼ normalⱼ.
    fn lagrangian_gradient(&self, candidate: &QpStep) -> DVector<f64> {
        let mut gradient = &self.hessian * &candidate.d;
        for (term, weight) in self.max_terms.iter().zip(&candidate.weights) {
            gradient.axpy(*weight, &term.gradient, 1.0);
        }
        for (row, multiplier) in self.rows.iter().zip(&candidate.multipliers) {
            gradient.axpy(*multiplier, &row.normal, 1.0);
        }
        gradient
    }

    fn corrected_bound(
        &self,
        i: usize,
        active: &WorkingSet,
        candidate: &QpStep,
        slope: f64,
    ) -> Activity {
        let (low, high, d) = (self.low[i], self.high[i], candidate.d[i]);
        let is_beyond = |excess: f64| excess > 0.0 && excess > BOUND_ROUNDING * candidate.d.amax();
        match active.bounds[i] {
            _ if low == high => Activity::Lower,
            Activity::Inactive if is_beyond(low - d) => Activity::Lower,
            Activity::Inactive if is_beyond(d - high) => Activity::Upper,
            Activity::Lower if slope < 0.0 => Activity::Inactive,
            Activity::Upper if slope > 0.0 => Activity::Inactive,
            same => same,
        }
    }

    fn corrected_row(&self, j: usize, active: &WorkingSet, candidate: &QpStep) -> Activity {
        let (row, multiplier) = (&self.rows[j], candidate.multipliers[j]);
        let value = row.normal.dot(&candidate.d);
        let rounding = ROW_ROUNDING * (1.0 + row.normal.amax() * candidate.d.amax());
        match active.rows[j] {
            _ if row.is_equation() => Activity::Lower,
            Activity::Inactive if value < row.low - rounding => Activity::Lower,
            Activity::Inactive if value > row.high + rounding => Activity::Upper,
            Activity::Lower if multiplier > 0.0 => Activity::Inactive,
            Activity::Upper if multiplier < 0.0 => Activity::Inactive,
            same => same,
        }
    }

    fn corrected_term(
        &self,
        k: usize,
        active: &WorkingSet,
        candidate: &QpStep,
        epigraph: f64,
    ) -> bool {
        if active.max_terms[k] {
            return candidate.weights[k] >= 0.0;
        }
        let rounding = 1e-12 * (1.0 + epigraph.abs());
        self.max_terms[k].value(&candidate.d) > epigraph + rounding
    }
}

impl QpStep {
    /// Projects a step on the bounds; a variable within rounding of a bound is set to the bound.
    pub(super) fn project_on_bounds(&mut self, program: &QuadraticProgram) {
        let rounding = BOUND_ROUNDING * self.d.amax();
        for i in 0..self.d.len() {
            let (low, high, d) = (program.low[i], program.high[i], self.d[i]);
            (self.activities[i], self.d[i]) = if d - low <= rounding {
                (Activity::Lower, low)
            } else if high - d <= rounding {
                (Activity::Upper, high)
            } else {
                (Activity::Inactive, d)
            };
        }
    }
}
