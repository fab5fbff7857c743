//! From an active set to the exact solution it implies, and from there to a better active set.

use super::active_set::ActiveSet;
use super::linear::solved;
use super::program::{End, Method, Piece, QuadraticProgram, Row, Step};
use nalgebra::{DMatrix, DVector};

/// What an active set implies, perhaps outside the ends.
pub(super) struct Candidate {
    pub d: DVector<f64>,
    weights: Vec<f64>,
    multipliers: Vec<f64>,
    /// The pieces' common value.
    pub level: f64,
}

/// Rounding allowed where a row is compared with its ends.
pub(super) const ROUNDING: f64 = 1e-11;

impl QuadraticProgram {
    /// The exact solution from an active set to begin with. `Err` where none is consistent: the best step met on the
    /// way, if one is worth taking.
    pub(super) fn polished(&self, mut active: ActiveSet, by: Method) -> Result<Step, Option<Step>> {
        let mut best: Option<(f64, Step)> = None;
        for _ in 0..self.most_corrections() {
            let Some(candidate) = self.equality_step(&active, solved) else { break };
            let corrected = self.corrected(&active, &candidate);
            let step = self.taken(&candidate, &active, by);
            if corrected == active {
                return if self.is_worth_it(&step) { Ok(step) } else { Err(None) };
            }
            let value = self.value(&step.d);
            if self.is_worth_it(&step) && best.as_ref().is_none_or(|(least, _)| value < *least) {
                best = Some((value, step));
            }
            active = corrected;
        }
        Err(best.map(|(_, step)| step))
    }

    /// Corrections of an active set after which it is given up.
    pub(super) fn most_corrections(&self) -> usize {
        2 * (self.dimension() + self.rows.len() + self.pieces.len()) + 4
    }

    /// Whether a step meets the rows and, where staying would meet them too, is better than that.
    pub(super) fn is_worth_it(&self, step: &Step) -> bool {
        let rows_met = self.missed(&step.d) <= 1e-9 * (1.0 + step.d.amax());
        // a step that should be none is rounding, up or down
        let reach = self.high.amax().max(self.low.amax());
        let rounding = 1e-14 * reach * self.pieces.iter().map(|piece| piece.gradient.amax()).fold(0.0, f64::max);
        let staying = self.pieces.iter().map(|piece| piece.offset).fold(f64::NEG_INFINITY, f64::max);
        let staying_misses = self.rows.iter().any(|row| row.low > 0.0 || row.high < 0.0);
        rows_met && (staying_misses || self.value(&step.d) <= staying + rounding)
    }

    /// Solves the program with the active ends, rows and pieces as equations:
    /// B d + Σ αₖ gradientₖ + Σ μⱼ normalⱼ = 0 on the free variables, Σ αₖ = 1, offsetₖ + gradientₖ · d = t.
    pub(super) fn equality_step(
        &self,
        active: &ActiveSet,
        solved: impl FnOnce(DMatrix<f64>, DVector<f64>) -> Option<DVector<f64>>,
    ) -> Option<Candidate> {
        let free: Vec<usize> = (0..self.dimension()).filter(|&i| active.ends[i] == End::Free).collect();
        let held: Vec<usize> = (0..self.pieces.len()).filter(|&k| active.pieces[k]).collect();
        let tight: Vec<usize> = (0..self.rows.len()).filter(|&j| active.rows[j] != End::Free).collect();
        let mut d = DVector::from_fn(self.dimension(), |i, _| match active.ends[i] {
            End::Free => 0.0,
            End::Low => self.low[i],
            End::High => self.high[i],
        });
        let bent = &self.curvature * &d;

        let (f, after_pieces) = (free.len(), free.len() + held.len() + 1);
        let size = after_pieces + tight.len();
        let mut matrix = DMatrix::zeros(size, size);
        let mut right = DVector::zeros(size);
        for (row, &i) in free.iter().enumerate() {
            for (column, &j) in free.iter().enumerate() {
                matrix[(row, column)] = self.curvature[(i, j)];
            }
            right[row] = -bent[i];
        }
        for (at, &k) in held.iter().enumerate() {
            let Piece { offset, gradient } = &self.pieces[k];
            for (row, &i) in free.iter().enumerate() {
                matrix[(row, f + at)] = gradient[i];
                matrix[(f + at, row)] = gradient[i];
            }
            matrix[(f + at, after_pieces - 1)] = -1.0;
            matrix[(after_pieces - 1, f + at)] = 1.0;
            right[f + at] = -offset - gradient.dot(&d);
        }
        right[after_pieces - 1] = 1.0;
        for (at, &j) in tight.iter().enumerate() {
            let Row { normal, low, high } = &self.rows[j];
            for (row, &i) in free.iter().enumerate() {
                matrix[(row, after_pieces + at)] = normal[i];
                matrix[(after_pieces + at, row)] = normal[i];
            }
            right[after_pieces + at] = if active.rows[j] == End::Low { *low } else { *high } - normal.dot(&d);
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
        Some(Candidate {
            d,
            weights: spread(self.pieces.len(), &held, f),
            multipliers: spread(self.rows.len(), &tight, after_pieces),
            level: solution[after_pieces - 1],
        })
    }

    /// The active set with what a candidate contradicts put right: free variables and rows beyond an end are held,
    /// held ones that pull inward are freed, and likewise for the pieces.
    pub(super) fn corrected(&self, active: &ActiveSet, candidate: &Candidate) -> ActiveSet {
        let Candidate { d, weights, multipliers, level } = candidate;
        let mut pull = &self.curvature * d;
        for (piece, weight) in self.pieces.iter().zip(weights) {
            pull += &piece.gradient * *weight;
        }
        for (row, multiplier) in self.rows.iter().zip(multipliers) {
            pull += &row.normal * *multiplier;
        }
        let row = |j: usize| {
            let Row { normal, low, high } = &self.rows[j];
            let (value, rounding) = (normal.dot(d), ROUNDING * (1.0 + normal.amax() * d.amax()));
            match active.rows[j] {
                _ if low == high => End::Low,
                End::Free if value < low - rounding => End::Low,
                End::Free if value > high + rounding => End::High,
                End::Low if multipliers[j] > 0.0 => End::Free,
                End::High if multipliers[j] < 0.0 => End::Free,
                same => same,
            }
        };
        let tolerance = 1e-12 * (1.0 + level.abs());
        let piece = |k: usize| {
            let Piece { offset, gradient } = &self.pieces[k];
            if active.pieces[k] { weights[k] >= 0.0 } else { offset + gradient.dot(d) > level + tolerance }
        };
        ActiveSet {
            ends: (0..self.dimension()).map(|i| self.corrected_end(i, active.ends[i], d[i], pull[i])).collect(),
            rows: (0..self.rows.len()).map(row).collect(),
            pieces: (0..self.pieces.len()).map(piece).collect(),
        }
    }

    /// Where a variable ends instead, with what its place and its pull contradict put right.
    pub(super) fn corrected_end(&self, i: usize, end: End, d: f64, pull: f64) -> End {
        match end {
            _ if self.low[i] == self.high[i] => End::Low,
            End::Free if d < self.low[i] => End::Low,
            End::Free if d > self.high[i] => End::High,
            End::Low if pull < 0.0 => End::Free,
            End::High if pull > 0.0 => End::Free,
            same => same,
        }
    }

    /// The candidate as a step, inside the ends.
    pub(super) fn taken(&self, candidate: &Candidate, active: &ActiveSet, by: Method) -> Step {
        let Candidate { d, weights, multipliers, .. } = candidate;
        let mut step = Step {
            d: d.clone(),
            ends: active.ends.clone(),
            weights: weights.clone(),
            multipliers: multipliers.clone(),
            by,
        };
        self.clamp(&mut step);
        step
    }

    /// Moves a step inside the ends.
    pub(super) fn clamp(&self, step: &mut Step) {
        for i in 0..self.dimension() {
            let (low, high) = (self.low[i], self.high[i]);
            step.ends[i] = match step.d[i] {
                d if d <= low => End::Low,
                d if d >= high => End::High,
                _ => End::Free,
            };
            step.d[i] = step.d[i].clamp(low, high);
        }
    }
}
