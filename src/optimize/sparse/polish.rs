//! From an active set to the exact solution it implies, and from there to a better active set.

use super::kkt::Kkt;
use super::program::{SparseActive, SparseProgram, SparseRow};
use super::symmetric::Symmetric;
use crate::optimize::qp::{End, Method, Step, clamp, corrected_end};
use nalgebra::DVector;

/// What the equations of a step may miss of their right-hand side …
const EXACT: f64 = 1e-10;
/// … and those of an active set on the way, which are only asked what contradicts it: of very many places held side by side they are
/// nearly singular.
const ROUGH: f64 = 1e-6;
/// Rounding allowed where a row is compared with its ends.
const ROUNDING: f64 = 1e-11;

impl SparseProgram {
    /// The exact solution with one of the two matrices from an active set to begin with, corrected so often at most; `None` where the
    /// active set does not settle, and where the matrix is not convex along it. With the active set that it ends with.
    pub(super) fn settled(
        &self,
        matrix: &Symmetric,
        mut active: SparseActive,
        most: usize,
        by: Method,
    ) -> Option<(Step, SparseActive)> {
        // a set that comes again would come again and again
        let mut seen = vec![];
        while seen.len() < most && !seen.contains(&active) {
            let (d, multipliers, left) = self.equality_step(matrix, &active)?;
            let corrected = self.corrected(matrix, &active, &d, &multipliers);
            if corrected == active {
                let mut step = Step { d, ends: active.ends.clone(), weights: vec![1.0], multipliers, by };
                clamp(&self.low, &self.high, &mut step);
                return (left <= EXACT && self.is_worth_it(matrix, &step)).then_some((step, active));
            }
            seen.push(std::mem::replace(&mut active, corrected));
        }
        None
    }

    /// Solves the program with the active ends and rows as equations: M d + gradient + Σ μⱼ normalⱼ = 0 on the free variables; and the part of
    /// the right-hand side that this misses.
    fn equality_step(&self, matrix: &Symmetric, active: &SparseActive) -> Option<(DVector<f64>, Vec<f64>, f64)> {
        let n = self.dimension();
        let mut place = vec![None; n];
        let free: Vec<usize> = (0..n).filter(|&i| active.ends[i] == End::Free).collect();
        free.iter().enumerate().for_each(|(at, &i)| place[i] = Some(at));
        let tight: Vec<usize> = (0..self.rows.len()).filter(|&j| active.rows[j] != End::Free).collect();
        let mut d = DVector::from_fn(n, |i, _| match active.ends[i] {
            End::Free => 0.0,
            End::Low => self.low[i],
            End::High => self.high[i],
        });
        let bend = matrix.times(d.as_slice());
        let mut right: Vec<f64> = free.iter().map(|&i| -self.gradient[i] - bend[i]).collect();
        let mut entries: Vec<_> =
            matrix.entries().filter_map(|(i, j, value)| Some((place[i]?, place[j]?, value))).collect();
        for (at, &j) in tight.iter().enumerate() {
            let row = &self.rows[j];
            right.push(if active.rows[j] == End::Low { row.low } else { row.high } - row.value(&d));
            entries.extend(row.normal.iter().filter_map(|(i, a)| Some((place[*i]?, free.len() + at, *a))));
        }
        let (mut multipliers, mut left) = (vec![0.0; self.rows.len()], 0.0);
        if !right.is_empty() {
            let mut kkt = Kkt::new(free.len(), &Symmetric::sum(right.len(), entries))?;
            let (solution, missed) = kkt.is_convex().then(|| kkt.refined(&right))?;
            if missed > ROUGH {
                return None;
            }
            left = missed;
            free.iter().zip(&solution).for_each(|(&i, value)| d[i] = *value);
            tight.iter().zip(&solution[free.len()..]).for_each(|(&j, multiplier)| multipliers[j] = *multiplier);
        }
        Some((d, multipliers, left))
    }

    /// The active set with what its solution contradicts put right: free variables and rows beyond an end are held, held ones that pull
    /// inward are freed.
    fn corrected(
        &self,
        matrix: &Symmetric,
        active: &SparseActive,
        d: &DVector<f64>,
        multipliers: &[f64],
    ) -> SparseActive {
        let mut pull = matrix.times(d.as_slice()) + &self.gradient;
        for (SparseRow { normal, .. }, multiplier) in self.rows.iter().zip(multipliers) {
            normal.iter().for_each(|(i, a)| pull[*i] += multiplier * a);
        }
        let size = d.amax();
        let row = |j: usize| {
            let row = &self.rows[j];
            let (value, rounding) = (row.value(d), ROUNDING * (1.0 + row.largest() * size));
            match active.rows[j] {
                _ if row.low == row.high => End::Low,
                End::Free if value < row.low - rounding => End::Low,
                End::Free if value > row.high + rounding => End::High,
                End::Low if multipliers[j] > 0.0 => End::Free,
                End::High if multipliers[j] < 0.0 => End::Free,
                same => same,
            }
        };
        let end = |i: usize| corrected_end((self.low[i], self.high[i]), active.ends[i], d[i], pull[i], || size);
        SparseActive { ends: (0..d.len()).map(end).collect(), rows: (0..self.rows.len()).map(row).collect() }
    }
}
