//! A warm start: the active set that holds the point is tried on the program of the next step, before Clarabel is asked.

use super::active_set::ActiveSet;
use super::linear::solved_uniquely;
use super::polish::{Candidate, ROUNDING};
use super::program::{End, Method, Piece, QuadraticProgram, Row, Step};

impl QuadraticProgram {
    /// The exact solution from a guess of its active set, corrected until the KKT conditions hold: proof enough, for the
    /// program is strictly convex. `None` where that does not end, where active equations depend on each other, and where
    /// an end, row or piece is met that does not hold the step: there the multipliers may not be the only ones.
    pub(super) fn warm_started(&self, mut active: ActiveSet) -> Option<Step> {
        for _ in 0..self.most_corrections() {
            let candidate = self.equality_step(&active, solved_uniquely)?;
            let corrected = self.corrected(&active, &candidate);
            if corrected == active {
                let step = self.taken(&candidate, &active, Method::WarmStart);
                return (self.is_held_by_active_alone(&active, &candidate) && self.is_worth_it(&step)).then_some(step);
            }
            active = corrected;
        }
        None
    }

    /// Whether every end, row and piece that is not active lies farther away than rounding.
    fn is_held_by_active_alone(&self, active: &ActiveSet, candidate: &Candidate) -> bool {
        let Candidate { d, level, .. } = candidate;
        let is_within = |value: f64, low: f64, high: f64, size: f64| (value - low).min(high - value) > ROUNDING * size;
        let is_variable_apart = |i: usize| is_within(d[i], self.low[i], self.high[i], self.high[i] - self.low[i]);
        let is_row_apart = |j: usize| {
            let Row { normal, low, high } = &self.rows[j];
            is_within(normal.dot(d), *low, *high, 1.0 + normal.amax() * d.amax())
        };
        let is_piece_apart = |k: usize| {
            let Piece { offset, gradient } = &self.pieces[k];
            level - (offset + gradient.dot(d)) > ROUNDING * (1.0 + level.abs())
        };
        (0..self.dimension()).all(|i| active.ends[i] != End::Free || is_variable_apart(i))
            && (0..self.rows.len()).all(|j| active.rows[j] != End::Free || is_row_apart(j))
            && (0..self.pieces.len()).all(|k| active.pieces[k] || is_piece_apart(k))
    }
}

#[cfg(test)]
mod tests {
    use super::super::active_set::Holder;
    use super::super::tests::random_programs_with_rows;
    use super::super::{End, Method, Piece, QuadraticProgram, Row};
    use nalgebra::{DMatrix, dvector};

    /// Guesses, of which most are wrong: nothing, everything at one end, and every other one.
    fn guesses(qp: &QuadraticProgram) -> [Vec<Holder>; 4] {
        let all = |end: End| {
            let variables = (0..qp.low.len()).map(move |i| Holder::Variable(i, end));
            variables.chain((0..qp.rows.len()).map(move |j| Holder::Row(j, end)))
        };
        [vec![], all(End::Low).collect(), all(End::High).collect(), all(End::High).step_by(2).collect()]
    }

    #[test]
    fn exact_bits_of_clarabels_polished_step_come_from_any_guess_that_a_warm_start_accepts() {
        let mut accepted = 0;
        for (case, qp) in random_programs_with_rows(400).enumerate() {
            for guess in guesses(&qp) {
                let Some(warm) = qp.warm_started(qp.held_by(guess)) else { continue };
                let clarabel = qp.polished(qp.clarabel().unwrap(), Method::Clarabel).unwrap();
                assert_eq!((&warm.d, &warm.ends), (&clarabel.d, &clarabel.ends), "case {case}");
                assert_eq!(warm.multipliers, clarabel.multipliers, "case {case}");
                assert_eq!((warm.by, clarabel.by), (Method::WarmStart, Method::Clarabel));
                accepted += 1;
            }
        }
        assert!(accepted > 150, "{accepted}");
    }

    /// ½ |d|² − 2 d₀ − 2 d₁ in a box of half-width 4, with these rows.
    fn towards_two(rows: Vec<Row>) -> QuadraticProgram {
        QuadraticProgram {
            curvature: DMatrix::identity(2, 2),
            pieces: vec![Piece { offset: 0.0, gradient: dvector![-2.0, -2.0] }],
            low: dvector![-4.0, -4.0],
            high: dvector![4.0, 4.0],
            rows,
        }
    }

    fn at_most(first: f64, second: f64, high: f64) -> Row {
        Row { normal: dvector![first, second], low: f64::NEG_INFINITY, high }
    }

    #[test]
    fn exact_steps_with_several_sets_of_multipliers_are_left_to_clarabel() {
        let corner = towards_two(vec![at_most(1.0, 0.0, 1.0), at_most(0.0, 1.0, 1.0)]);
        let plain = corner.solve().unwrap();
        assert_eq!(plain.by, Method::WarmStart);
        assert!((&plain.d - dvector![1.0, 1.0]).amax() < 1e-12, "{plain:?}");
        // a third row through the same corner can take any part of what the first two bear
        let mut shared = corner.clone();
        shared.rows.push(at_most(1.0, 1.0, 2.0));
        for guess in [vec![], (0..2).map(|j| Holder::Row(j, End::High)).collect(), vec![Holder::Row(2, End::High)]] {
            let step = shared.solve_from(guess).unwrap();
            assert!((&step.d - dvector![1.0, 1.0]).amax() < 1e-12, "{step:?}");
            assert_eq!(step.by, Method::Clarabel);
            assert_eq!(step.multipliers, shared.solve().unwrap().multipliers);
        }
        // one equation twice
        let mut twice = towards_two(vec![Row { normal: dvector![1.0, 1.0], low: 1.0, high: 1.0 }]);
        assert_eq!(twice.solve().unwrap().by, Method::WarmStart);
        twice.rows.push(Row { normal: dvector![2.0, 2.0], low: 2.0, high: 2.0 });
        let step = twice.solve().unwrap();
        assert!((&step.d - dvector![0.5, 0.5]).amax() < 1e-12, "{step:?}");
        assert_eq!(step.by, Method::Clarabel);
    }

    #[test]
    fn exact_step_into_a_kink_of_more_sides_than_hold_it_is_left_to_clarabel() {
        let side = |slope: f64| Piece { offset: 0.0, gradient: dvector![slope] };
        let mut kink = QuadraticProgram {
            curvature: DMatrix::identity(1, 1),
            pieces: vec![side(1.0), side(-1.0)],
            low: dvector![-4.0],
            high: dvector![4.0],
            rows: vec![],
        };
        let both = || (0..2).map(Holder::Piece);
        assert_eq!(kink.solve_from(both()).unwrap().by, Method::WarmStart);
        kink.pieces.push(side(0.5));
        let step = kink.solve_from(both()).unwrap();
        assert_ne!(step.by, Method::WarmStart);
        assert!(step.d[0].abs() < 1e-12, "{step:?}");
        assert_eq!(step.weights, kink.solve().unwrap().weights);
    }
}
