//! The quadratic program of a step: Clarabel finds the active set, a polish makes it exact.

mod interior_point;
mod polish;

use nalgebra::{DMatrix, DVector};
use polish::{ActiveSet, Candidate};

/// minimise  ½ dᵀB d + maxₖ (offsetₖ + gradientₖ · d)  over  low ≤ d ≤ high, with B positive definite.
///
/// One piece is the usual quadratic model of a smooth function; more describe a function with a kink, each
/// smooth side of it by a piece.
#[derive(Clone, Debug)]
pub struct QuadraticProgram {
    /// B.
    pub curvature: DMatrix<f64>,
    /// The linear pieces; the first is the one that holds at d = 0.
    pub pieces: Vec<Piece>,
    /// Lower ends of the step, ≤ 0.
    pub low: DVector<f64>,
    /// Upper ends of the step, ≥ 0.
    pub high: DVector<f64>,
}

/// offset + gradient · d.
#[derive(Clone, Debug)]
pub struct Piece {
    /// Value at d = 0.
    pub offset: f64,
    /// Slope.
    pub gradient: DVector<f64>,
}

/// Where a variable of a step ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// Between its ends.
    Free,
    /// Exactly at the lower end.
    Low,
    /// Exactly at the upper end.
    High,
}

/// A step.
#[derive(Clone, Debug)]
pub struct Step {
    /// d; a variable at an end is there exactly.
    pub d: DVector<f64>,
    /// Where each variable ends.
    pub ends: Vec<End>,
    /// Weight of each piece, ≥ 0, together 1.
    pub weights: Vec<f64>,
}

impl QuadraticProgram {
    /// Solves the program.
    ///
    /// Clarabel's answer is good to about 1e-8 and may lie that far outside; it tells which ends and pieces are
    /// active. The polish then solves the remaining equations to rounding, and corrects the active set where
    /// they disagree with it.
    pub fn solve(&self) -> Step {
        let mut active = self.clarabel().unwrap_or_else(|| self.guess());
        let mut best = None;
        for _ in 0..2 * (self.dimension() + self.pieces.len()) + 4 {
            let Some(candidate) = self.equality_step(&active) else { break };
            let corrected = self.corrected(&active, &candidate);
            let (step, consistent) = (self.clamped(&candidate, &active), corrected == active);
            let value = self.value(&step.d);
            if consistent || best.as_ref().is_none_or(|(least, _)| value < *least) {
                best = Some((value, step));
            }
            if consistent {
                break;
            }
            active = corrected;
        }
        let at_rest = self.value(&DVector::zeros(self.dimension()));
        best.filter(|(value, _)| *value <= at_rest).map_or_else(|| self.steepest(), |(_, step)| step)
    }

    /// The objective.
    pub fn value(&self, d: &DVector<f64>) -> f64 {
        let pieces = self.pieces.iter().map(|piece| piece.offset + piece.gradient.dot(d));
        0.5 * d.dot(&(&self.curvature * d)) + pieces.fold(f64::NEG_INFINITY, f64::max)
    }

    fn dimension(&self) -> usize {
        self.low.len()
    }

    /// An active set to start from without Clarabel: where the first piece's slope leads.
    fn guess(&self) -> ActiveSet {
        let end = |i: usize| match self.pieces[0].gradient[i] {
            _ if self.low[i] == self.high[i] => End::Low,
            slope if slope > 0.0 && self.low[i] == 0.0 => End::Low,
            slope if slope < 0.0 && self.high[i] == 0.0 => End::High,
            _ => End::Free,
        };
        let pieces = (0..self.pieces.len()).map(|k| k == 0).collect();
        ActiveSet { ends: (0..self.dimension()).map(end).collect(), pieces }
    }

    /// The best step down the first piece's slope alone, for when no active set can be solved.
    fn steepest(&self) -> Step {
        let slope = &self.pieces[0].gradient;
        let bend = slope.dot(&(&self.curvature * slope));
        let length = if bend > 0.0 { slope.norm_squared() / bend } else { 1.0 };
        let candidate = Candidate { d: -slope * length, weights: vec![0.0; self.pieces.len()], level: 0.0 };
        let active = ActiveSet { ends: vec![End::Free; self.dimension()], pieces: vec![] };
        let mut step = self.clamped(&candidate, &active);
        step.weights[0] = 1.0;
        step
    }
}

#[cfg(test)]
mod tests {
    use super::{End, Piece, QuadraticProgram};
    use nalgebra::{DMatrix, DVector, dmatrix, dvector};

    /// The minimum over every combination of free, low and high variables: exact, by enumeration.
    fn enumerated(qp: &QuadraticProgram) -> f64 {
        let n = qp.low.len();
        let mut least = f64::INFINITY;
        for code in 0..3_usize.pow(n as u32) {
            let ends: Vec<usize> = (0..n).map(|i| code / 3_usize.pow(i as u32) % 3).collect();
            let free: Vec<usize> = (0..n).filter(|&i| ends[i] == 0).collect();
            let mut d = DVector::from_fn(n, |i, _| [0.0, qp.low[i], qp.high[i]][ends[i]]);
            let right = -(&qp.curvature * &d + &qp.pieces[0].gradient).select_rows(&free);
            let block = qp.curvature.select_rows(&free).select_columns(&free);
            if let Some(x) = block.cholesky().map(|c| c.solve(&right)) {
                for (row, &i) in free.iter().enumerate() {
                    d[i] = x[row];
                }
            }
            if (0..n).all(|i| qp.low[i] <= d[i] && d[i] <= qp.high[i]) {
                least = least.min(qp.value(&d));
            }
        }
        least
    }

    #[test]
    fn exact_minimum_of_random_box_programs() {
        // a fixed sequence without pattern: fractional parts of multiples of √2 powers
        let mut state = 0.5_f64;
        let mut random = || {
            state = (state * 97.409_1 + 0.137).fract();
            2.0 * state - 1.0
        };
        for case in 0..300 {
            let n = 1 + case % 5;
            let a = DMatrix::from_fn(n, n, |_, _| random());
            let curvature = &a * a.transpose() + DMatrix::identity(n, n) * 1e-3;
            let gradient = DVector::from_fn(n, |_, _| random() * 10_f64.powi(case as i32 % 7 - 3));
            let low = DVector::from_fn(n, |_, _| -random().abs());
            let high = DVector::from_fn(n, |_, _| random().abs());
            let qp = QuadraticProgram { curvature, pieces: vec![Piece { offset: 0.0, gradient }], low, high };
            let step = qp.solve();
            let (value, least) = (qp.value(&step.d), enumerated(&qp));
            assert!(value <= least + 1e-12 * least.abs().max(1e-3), "case {case}: {value} against {least}");
            for i in 0..n {
                match step.ends[i] {
                    End::Low => assert_eq!(step.d[i], qp.low[i]),
                    End::High => assert_eq!(step.d[i], qp.high[i]),
                    End::Free => assert!(qp.low[i] < step.d[i] && step.d[i] < qp.high[i]),
                }
            }
        }
    }

    #[test]
    fn exact_step_into_a_kink() {
        // ½ d² + max(−d₀, 2 d₀ − 0.3) + d₁-parabola: the pieces meet at d₀ = 0.1
        let qp = QuadraticProgram {
            curvature: dmatrix![1.0, 0.0; 0.0, 1.0],
            pieces: vec![
                Piece { offset: 0.0, gradient: dvector![-1.0, 0.5] },
                Piece { offset: -0.3, gradient: dvector![2.0, 0.5] },
            ],
            low: dvector![-1.0, -1.0],
            high: dvector![1.0, 1.0],
        };
        let step = qp.solve();
        assert!((step.d[0] - 0.1).abs() < 1e-14 && (step.d[1] + 0.5).abs() < 1e-14, "{step:?}");
        // stationary: d₀ − α₀ + 2 α₁ = 0, α₀ + α₁ = 1
        assert!((step.weights[0] - 0.7).abs() < 1e-14 && (step.weights[1] - 0.3).abs() < 1e-14);
    }
}
