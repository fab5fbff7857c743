//! From an active set to the exact solution that it implies, and from there to a better active set.

use super::active_set::{ActiveConstraint, ActiveSet};
use super::linear::solved;
use super::program::{MaxTerm, QuadraticProgram, Row, Side, Step, StepSource};
use nalgebra::{DMatrix, DVector};

/// The solution of the equations of an active set. It may violate other constraints.
struct Candidate {
    d: DVector<f64>,
    weights: Vec<f64>,
    multipliers: Vec<f64>,
    /// The common value of the active terms of the maximum.
    epigraph: f64,
}

/// Clarabel's solution is this near to the exact one, relative.
const NEARBY: f64 = 1e-6;
/// Rounding of a row's value, relative to its terms.
const ROW_ROUNDING: f64 = 1e-11;
/// Rounding of a variable, relative to the largest of the step.
const BOUND_ROUNDING: f64 = 1e-14;

impl QuadraticProgram {
    /// The active set of these constraints, strongest first, without the weakest that contradict
    /// the others: two limits nearer to each other than Clarabel's tolerance both look active.
    pub(super) fn consistent_part(&self, mut ranked: Vec<ActiveConstraint>) -> ActiveSet {
        loop {
            let active = ActiveSet::new(self, ranked.iter().copied());
            if self.candidate(&active).is_some() || ranked.pop().is_none() {
                return active;
            }
        }
    }

    /// The exact solution near an active set, with its own: what contradicts the KKT conditions is
    /// corrected, up to a set that was there before. `None` where no set on the way is exact.
    pub(super) fn polished(
        &self,
        mut active: ActiveSet,
        source: StepSource,
    ) -> Option<(ActiveSet, Step)> {
        let mut seen = vec![];
        while seen.len() < self.most_corrections() && !seen.contains(&active) {
            let candidate = self.candidate(&active)?;
            let corrected = self.corrected(&active, &candidate);
            if corrected == active {
                let step = self.accepted(candidate, &active, source)?;
                return Some((active, step));
            }
            seen.push(std::mem::replace(&mut active, corrected));
        }
        None
    }

    /// The exact point of an active set with the multipliers of an approximate solution: where
    /// gradients of active constraints depend on each other the point is unique, its multipliers
    /// are not, and those of the equations may have the wrong sign.
    pub(super) fn with_multipliers_of(
        &self,
        active: &ActiveSet,
        approximate: &Step,
    ) -> Option<Step> {
        let candidate = self.candidate(active)?;
        let distance = (&candidate.d - &approximate.d).amax();
        if distance > NEARBY * (approximate.d.amax() + self.reach().min(1.0)) {
            return None;
        }
        let step = self.accepted(candidate, active, approximate.source)?;
        let Step {
            weights,
            multipliers,
            ..
        } = approximate.clone();
        Some(Step {
            weights,
            multipliers,
            ..step
        })
    }

    /// The solution that an active set implies, if the KKT conditions hold there.
    pub(super) fn exact_step(&self, active: &ActiveSet, source: StepSource) -> Option<Step> {
        let candidate = self.candidate(active)?;
        if self.corrected(active, &candidate) != *active {
            return None;
        }
        self.accepted(candidate, active, source)
    }

    /// Corrections after which a polish ends without a result.
    fn most_corrections(&self) -> usize {
        2 * (self.dimension() + self.rows.len() + self.max_terms.len()) + 4
    }

    /// A candidate as a step within the bounds; `None` where rounding has spoilt it.
    fn accepted(
        &self,
        candidate: Candidate,
        active: &ActiveSet,
        source: StepSource,
    ) -> Option<Step> {
        let Candidate {
            d,
            weights,
            multipliers,
            ..
        } = candidate;
        let mut step = Step {
            d,
            sides: active.bounds.clone(),
            weights,
            multipliers,
            source,
        };
        step.move_inside(self);
        let meets_rows = self.violation(&step.d) <= 1e-9 * (1.0 + step.d.amax());
        (meets_rows && self.is_no_worse_than_none(&step)).then_some(step)
    }

    /// Whether a step is better than none, where none meets the rows too.
    fn is_no_worse_than_none(&self, step: &Step) -> bool {
        if self.rows.iter().any(|row| row.low > 0.0 || row.high < 0.0) {
            return true;
        }
        let at_zero = self
            .max_terms
            .iter()
            .map(|term| term.offset)
            .fold(f64::NEG_INFINITY, f64::max);
        let rounding = 1e-14 * self.reach() * self.largest_slope();
        self.value(&step.d) <= at_zero + rounding
    }

    /// Solves the program with the active bounds, rows and terms as equations: B d + Σ αₖ gradientₖ
    /// + Σ μⱼ normalⱼ = 0 on the inactive variables, Σ αₖ = 1, and offsetₖ + gradientₖ · d equal
    /// for all active terms. The first active term is subtracted from the others, so that a single
    /// one needs no equation.
    fn candidate(&self, active: &ActiveSet) -> Option<Candidate> {
        let free: Vec<usize> = (0..self.dimension())
            .filter(|&i| active.bounds[i] == Side::Inactive)
            .collect();
        let active_rows: Vec<usize> = (0..self.rows.len())
            .filter(|&j| active.rows[j] != Side::Inactive)
            .collect();
        let mut others = (0..self.max_terms.len()).filter(|&k| active.max_terms[k]);
        let first = others.next()?;
        let others: Vec<usize> = others.collect();
        let MaxTerm { offset, gradient } = &self.max_terms[first];
        let mut d = DVector::from_fn(self.dimension(), |i, _| match active.bounds[i] {
            Side::Inactive => 0.0,
            Side::Lower => self.low[i],
            Side::Upper => self.high[i],
        });

        let (f, after_terms) = (free.len(), free.len() + others.len());
        let size = after_terms + active_rows.len();
        let mut matrix = DMatrix::zeros(size, size);
        let mut right = DVector::zeros(size);
        for (column, &i) in free.iter().enumerate() {
            let bend = self.hessian.column(i);
            for (row, &j) in free.iter().enumerate() {
                matrix[(row, column)] = bend[j];
            }
            right[column] = -gradient[i] - bend.dot(&d);
        }
        let mut border = |at: usize, normal: &dyn Fn(usize) -> f64, limit: f64| {
            for (row, &i) in free.iter().enumerate() {
                matrix[(row, at)] = normal(i);
                matrix[(at, row)] = normal(i);
            }
            right[at] = limit
                - d.iter()
                    .enumerate()
                    .map(|(i, d)| normal(i) * d)
                    .sum::<f64>();
        };
        for (at, &k) in others.iter().enumerate() {
            let other = &self.max_terms[k];
            border(
                f + at,
                &|i| other.gradient[i] - gradient[i],
                offset - other.offset,
            );
        }
        for (at, &j) in active_rows.iter().enumerate() {
            let Row { normal, low, high } = &self.rows[j];
            border(
                after_terms + at,
                &|i| normal[i],
                if active.rows[j] == Side::Lower {
                    *low
                } else {
                    *high
                },
            );
        }

        let solution = solved(matrix, right)?;
        for (row, &i) in free.iter().enumerate() {
            d[i] = solution[row];
        }
        let spread = |length: usize, places: &[usize], offset: usize| {
            let mut all = vec![0.0; length];
            for (at, &place) in places.iter().enumerate() {
                all[place] = solution[offset + at];
            }
            all
        };
        let mut weights = spread(self.max_terms.len(), &others, f);
        weights[first] = 1.0 - weights.iter().sum::<f64>();
        let epigraph = offset + gradient.dot(&d);
        Some(Candidate {
            weights,
            multipliers: spread(self.rows.len(), &active_rows, after_terms),
            epigraph,
            d,
        })
    }

    /// The active set with what a candidate contradicts corrected: a violated constraint becomes
    /// active, one whose multiplier has the wrong sign inactive.
    fn corrected(&self, active: &ActiveSet, candidate: &Candidate) -> ActiveSet {
        let slopes = self.lagrangian_slopes(candidate);
        ActiveSet {
            bounds: (0..self.dimension())
                .map(|i| self.corrected_bound(i, active, candidate, slopes[i]))
                .collect(),
            rows: (0..self.rows.len())
                .map(|j| self.corrected_row(j, active, candidate))
                .collect(),
            max_terms: (0..self.max_terms.len())
                .map(|k| self.corrected_term(k, active, candidate))
                .collect(),
        }
    }

    /// B d + Σ αₖ gradientₖ + Σ μⱼ normalⱼ.
    fn lagrangian_slopes(&self, candidate: &Candidate) -> DVector<f64> {
        let mut slopes = &self.hessian * &candidate.d;
        for (term, weight) in self.max_terms.iter().zip(&candidate.weights) {
            slopes.axpy(*weight, &term.gradient, 1.0);
        }
        for (row, multiplier) in self.rows.iter().zip(&candidate.multipliers) {
            slopes.axpy(*multiplier, &row.normal, 1.0);
        }
        slopes
    }

    fn corrected_bound(
        &self,
        i: usize,
        active: &ActiveSet,
        candidate: &Candidate,
        slope: f64,
    ) -> Side {
        let (low, high, d) = (self.low[i], self.high[i], candidate.d[i]);
        let is_beyond = |excess: f64| excess > 0.0 && excess > BOUND_ROUNDING * candidate.d.amax();
        match active.bounds[i] {
            _ if low == high => Side::Lower,
            Side::Inactive if is_beyond(low - d) => Side::Lower,
            Side::Inactive if is_beyond(d - high) => Side::Upper,
            Side::Lower if slope < 0.0 => Side::Inactive,
            Side::Upper if slope > 0.0 => Side::Inactive,
            same => same,
        }
    }

    fn corrected_row(&self, j: usize, active: &ActiveSet, candidate: &Candidate) -> Side {
        let (row, multiplier) = (&self.rows[j], candidate.multipliers[j]);
        let value = row.normal.dot(&candidate.d);
        let rounding = ROW_ROUNDING * (1.0 + row.normal.amax() * candidate.d.amax());
        match active.rows[j] {
            _ if row.is_equation() => Side::Lower,
            Side::Inactive if value < row.low - rounding => Side::Lower,
            Side::Inactive if value > row.high + rounding => Side::Upper,
            Side::Lower if multiplier > 0.0 => Side::Inactive,
            Side::Upper if multiplier < 0.0 => Side::Inactive,
            same => same,
        }
    }

    fn corrected_term(&self, k: usize, active: &ActiveSet, candidate: &Candidate) -> bool {
        if active.max_terms[k] {
            return candidate.weights[k] >= 0.0;
        }
        let MaxTerm { offset, gradient } = &self.max_terms[k];
        let rounding = 1e-12 * (1.0 + candidate.epigraph.abs());
        offset + gradient.dot(&candidate.d) > candidate.epigraph + rounding
    }
}

impl Step {
    /// Moves a step inside the bounds; a variable within rounding of one is set on it.
    pub(super) fn move_inside(&mut self, program: &QuadraticProgram) {
        let rounding = BOUND_ROUNDING * self.d.amax();
        for i in 0..self.d.len() {
            let (low, high, d) = (program.low[i], program.high[i], self.d[i]);
            (self.sides[i], self.d[i]) = if d - low <= rounding {
                (Side::Lower, low)
            } else if high - d <= rounding {
                (Side::Upper, high)
            } else {
                (Side::Inactive, d)
            };
        }
    }
}
