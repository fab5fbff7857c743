//! From an active set to the exact solution it implies, and from there to a better active set.

use super::active_set::ActiveSet;
use super::ends::{clamp, corrected_end};
use super::linear::solved;
use super::program::{End, Method, Piece, QuadraticProgram, Row, Step};
use nalgebra::{DMatrix, DVector};

/// What an active set implies, perhaps outside the ends.
pub(super) struct Candidate {
    pub d: DVector<f64>,
    pub weights: Vec<f64>,
    pub multipliers: Vec<f64>,
    /// The pieces' common value.
    pub level: f64,
}

/// Rounding allowed where a row is compared with its ends.
const ROUNDING: f64 = 1e-11;

impl QuadraticProgram {
    /// The exact solution from an active set to begin with, and from what it implies if that is known. `Err` where none is consistent:
    /// the best step met on the way, if one is worth taking.
    pub(super) fn polished(
        &self,
        mut active: ActiveSet,
        mut implied: Option<Candidate>,
        by: Method,
    ) -> Result<Step, Option<Step>> {
        let mut best: Option<(f64, Step)> = None;
        // a set that comes again would come again and again
        let mut seen = vec![];
        while seen.len() < self.most_corrections() && !seen.contains(&active) {
            let Some(candidate) = implied.take().or_else(|| self.equality_step(&active)) else { break };
            let corrected = self.corrected(&active, &candidate);
            let step = self.taken(&candidate, &active, by);
            if corrected == active {
                return if self.is_worth_it(&step) { Ok(step) } else { Err(None) };
            }
            let value = self.value(&step.d);
            if self.is_worth_it(&step) && best.as_ref().is_none_or(|(least, _)| value < *least) {
                best = Some((value, step));
            }
            seen.push(std::mem::replace(&mut active, corrected));
        }
        Err(best.map(|(_, step)| step))
    }

    /// Corrections of an active set after which it is given up.
    fn most_corrections(&self) -> usize {
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

    /// Solves the program with the active ends, rows and pieces as equations: B d + Σ αₖ gradientₖ + Σ μⱼ normalⱼ = 0 on the free
    /// variables, Σ αₖ = 1, and offsetₖ + gradientₖ · d the same for every active piece. The first of these pieces is taken off
    /// the others, so that a single one asks for no equation.
    fn equality_step(&self, active: &ActiveSet) -> Option<Candidate> {
        let free: Vec<usize> = (0..self.dimension()).filter(|&i| active.ends[i] == End::Free).collect();
        let tight: Vec<usize> = (0..self.rows.len()).filter(|&j| active.rows[j] != End::Free).collect();
        let mut held = (0..self.pieces.len()).filter(|&k| active.pieces[k]);
        let first = held.next()?;
        let held: Vec<usize> = held.collect();
        let Piece { offset, gradient } = &self.pieces[first];
        let mut d = DVector::from_fn(self.dimension(), |i, _| match active.ends[i] {
            End::Free => 0.0,
            End::Low => self.low[i],
            End::High => self.high[i],
        });

        let (f, after_pieces) = (free.len(), free.len() + held.len());
        let size = after_pieces + tight.len();
        let mut matrix = DMatrix::zeros(size, size);
        let mut right = DVector::zeros(size);
        for (column, &i) in free.iter().enumerate() {
            let bend = self.curvature.column(i);
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
            right[at] = limit - d.iter().enumerate().map(|(i, d)| normal(i) * d).sum::<f64>();
        };
        for (at, &k) in held.iter().enumerate() {
            let other = &self.pieces[k];
            border(f + at, &|i| other.gradient[i] - gradient[i], offset - other.offset);
        }
        for (at, &j) in tight.iter().enumerate() {
            let Row { normal, low, high } = &self.rows[j];
            border(after_pieces + at, &|i| normal[i], if active.rows[j] == End::Low { *low } else { *high });
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
        let mut weights = spread(self.pieces.len(), &held, f);
        weights[first] = 1.0 - weights.iter().sum::<f64>();
        let level = offset + gradient.dot(&d);
        Some(Candidate { weights, multipliers: spread(self.rows.len(), &tight, after_pieces), level, d })
    }

    /// The active set with what a candidate contradicts put right: free variables and rows beyond an end are held,
    /// held ones that pull inward are freed, and likewise for the pieces.
    fn corrected(&self, active: &ActiveSet, candidate: &Candidate) -> ActiveSet {
        let Candidate { d, weights, multipliers, level } = candidate;
        let mut pull = &self.curvature * d;
        for (piece, weight) in self.pieces.iter().zip(weights) {
            pull.axpy(*weight, &piece.gradient, 1.0);
        }
        for (row, multiplier) in self.rows.iter().zip(multipliers) {
            pull.axpy(*multiplier, &row.normal, 1.0);
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
        let end = |i: usize| corrected_end((self.low[i], self.high[i]), active.ends[i], d[i], pull[i], || d.amax());
        ActiveSet {
            ends: (0..self.dimension()).map(end).collect(),
            rows: (0..self.rows.len()).map(row).collect(),
            pieces: (0..self.pieces.len()).map(piece).collect(),
        }
    }

    /// The candidate as a step, inside the ends.
    fn taken(&self, candidate: &Candidate, active: &ActiveSet, by: Method) -> Step {
        let Candidate { d, weights, multipliers, .. } = candidate;
        let mut step = Step {
            d: d.clone(),
            ends: active.ends.clone(),
            weights: weights.clone(),
            multipliers: multipliers.clone(),
            by,
        };
        clamp(&self.low, &self.high, &mut step);
        step
    }
}
