//! A program of bounds alone, from face to face of its box: what a search without constraints asks for at every step.

use super::ends::{clamp, corrected_end};
use super::program::{End, Method, Piece, QuadraticProgram, Step};
use crate::optimize::cholesky::{factorise, solve};
use nalgebra::{DMatrix, DVector};

/// Faces looked at before the program is left to Clarabel; a few are enough wherever the walk ends at all.
const MOST_FACES: usize = 20;

impl QuadraticProgram {
    /// The exact solution of a program of bounds alone, by the primal-dual active-set method (Hintermüller, Ito &
    /// Kunisch 2002): what is free is solved for, what then lies beyond an end is held there, what is held but pulls
    /// inward is freed. Where nothing is left to change the KKT conditions hold: proof enough, for the program is
    /// strictly convex. `None` where the walk does not end, or rows or corners belong to the program.
    pub(super) fn by_faces(&self) -> Option<Step> {
        let ([Piece { gradient, .. }], true) = (self.pieces.as_slice(), self.rows.is_empty()) else { return None };
        let n = self.dimension();
        let end = |i: usize| if self.low[i] == self.high[i] { End::Low } else { End::Free };
        let mut step = Step {
            d: DVector::zeros(n),
            ends: (0..n).map(end).collect(),
            weights: vec![1.0],
            multipliers: vec![],
            by: Method::Faces,
        };
        let mut room = DMatrix::zeros(n, n);
        for _ in 0..MOST_FACES {
            self.minimize_on_face(gradient, &mut step, &mut room)?;
            let mut is_settled = true;
            for i in 0..n {
                let pull = gradient[i] + self.curvature.column(i).dot(&step.d);
                let end = corrected_end((self.low[i], self.high[i]), step.ends[i], step.d[i], pull, || step.d.amax());
                is_settled &= end == step.ends[i];
                step.ends[i] = end;
            }
            if is_settled {
                clamp(&self.low, &self.high, &mut step);
                return self.is_worth_it(&step).then_some(step);
            }
        }
        None
    }

    /// Moves a step to the least value with the variables at an end held there: B d + gradient = 0 on the free ones, a
    /// system that is factorised in `room`.
    fn minimize_on_face(&self, gradient: &DVector<f64>, step: &mut Step, room: &mut DMatrix<f64>) -> Option<()> {
        let Step { d, ends, .. } = step;
        let (n, is_free) = (d.len(), |i: usize| ends[i] == End::Free);
        for i in (0..n).filter(|&i| !is_free(i)) {
            d[i] = if ends[i] == End::Low { self.low[i] } else { self.high[i] };
        }
        for i in (0..n).filter(|&i| is_free(i)) {
            let held = (0..n).filter(|&j| !is_free(j));
            d[i] = -gradient[i] - held.map(|j| self.curvature[(i, j)] * d[j]).sum::<f64>();
        }
        // what is held stays by an equation d = d of its own
        for (i, j) in (0..n).flat_map(|j| (j..n).map(move |i| (i, j))) {
            let is_free = is_free(i) && is_free(j);
            room[(i, j)] = if is_free { self.curvature[(i, j)] } else { f64::from(i == j) };
        }
        if !factorise(room) {
            return None;
        }
        solve(room, d.as_mut_slice());
        d.iter().all(|x| x.is_finite()).then_some(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Method, Piece, QuadraticProgram};
    use nalgebra::{DMatrix, DVector};

    #[test]
    fn independent_clarabel_agrees_with_the_walk_over_faces() {
        let mut state = 0.7_f64;
        let mut random = || {
            state = (state * 97.409_1 + 0.137).fract();
            2.0 * state - 1.0
        };
        for case in 0..200 {
            let n = 1 + case % 6;
            let a = DMatrix::from_fn(n, n, |_, _| random());
            let qp = QuadraticProgram {
                curvature: &a * a.transpose() + DMatrix::identity(n, n) * 1e-2,
                pieces: vec![Piece { offset: 0.0, gradient: DVector::from_fn(n, |_, _| random()) }],
                low: DVector::from_fn(n, |_, _| -random().abs()),
                high: DVector::from_fn(n, |_, _| random().abs()),
                rows: vec![],
            };
            let walked = qp.by_faces().unwrap();
            let clarabel = qp.polished(qp.clarabel().unwrap(), None, Method::Clarabel).unwrap();
            assert!((&walked.d - &clarabel.d).amax() < 1e-10, "case {case}: {walked:?} against {clarabel:?}");
            assert_eq!(walked.ends, clarabel.ends, "case {case}");
        }
    }
}
