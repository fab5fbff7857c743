use super::program::{SparseActive, SparseProgram, SparseRow};
use crate::optimize::plan::Program;
use crate::optimize::qp::{End, Method, Step};
use nalgebra::DVector;

/// Corrections of an active set after which Clarabel is asked.
const MOST_CORRECTIONS: usize = 1000;
/// What Clarabel's own point may miss a row by, in units of the box.
const ACCURACY: f64 = 1e-7;

impl Program for SparseProgram {
    /// Solves the program; `None` where the rows cannot be met within the ends.
    ///
    /// The active set is guessed, then corrected as what it implies contradicts it (the primal-dual active-set method of Hintermüller, Ito
    /// & Kunisch 2002); where nothing is left to change the KKT conditions hold, which is proof enough for a convex program. Where that
    /// does not end Clarabel is asked, and its active set made exact in the same way. Where H is not convex, but is so along what is
    /// active, the step with H itself is taken in place of that with B, if it is better: with it comes Newton's rate.
    fn solve(&self) -> Option<Step> {
        let by_guess = self.settled(&self.convex, self.guess(), MOST_CORRECTIONS, Method::Faces);
        let (step, active) = by_guess.or_else(|| {
            let (point, active) = self.clarabel()?;
            let accuracy = ACCURACY * self.high.amax().max(self.low.amax());
            let is_missed = |row: &SparseRow| {
                let value = row.value(&point.d);
                (row.low - value).max(value - row.high) > accuracy * row.largest()
            };
            let is_near = !self.rows.iter().any(is_missed);
            let exact = self.settled(&self.convex, active.clone(), MOST_CORRECTIONS, Method::Clarabel);
            exact.or_else(|| is_near.then_some((point, active)))
        })?;
        if self.shift == 0.0 {
            return Some(step);
        }
        let by_own = self.settled(&self.hessian, active, MOST_CORRECTIONS, step.by);
        let is_better = |own: &Step| self.value(&self.hessian, &own.d) <= self.value(&self.hessian, &step.d);
        Some(by_own.map(|(own, _)| own).filter(is_better).unwrap_or(step))
    }

    fn limits(&mut self) -> impl Iterator<Item = (&mut f64, &mut f64)> {
        self.rows.iter_mut().map(|row| (&mut row.low, &mut row.high))
    }

    fn left_over(&self, d: &DVector<f64>) -> impl Iterator<Item = f64> {
        self.rows.iter().map(|row| {
            let value = row.value(d);
            value - value.clamp(row.low, row.high)
        })
    }
}

impl SparseProgram {
    /// What is guessed to hold the step, with what holds any.
    fn guess(&self) -> SparseActive {
        let mut active = self.equations();
        let guessed =
            active.ends.iter_mut().chain(&mut active.rows).zip(self.guess.ends.iter().chain(&self.guess.rows));
        for (end, guessed) in guessed.filter(|(end, _)| **end == End::Free) {
            *end = *guessed;
        }
        active
    }
}
