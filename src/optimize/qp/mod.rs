//! The quadratic program of a step. Of bounds alone, a walk over the faces of the box solves it; in general Clarabel
//! finds the active set, a polish makes it exact, and a dual active-set method takes over where Clarabel does not answer.

mod active_set;
mod dual;
mod faces;
mod interior_point;
mod polish;

use active_set::ActiveSet;
use nalgebra::{DMatrix, DVector};

/// minimise  ½ dᵀB d + maxₖ (offsetₖ + gradientₖ · d)  over  low ≤ d ≤ high  and  rows, with B positive definite.
///
/// One piece is the usual quadratic model of a smooth function; more describe a function with a kink, each
/// smooth side of it by a piece.
#[derive(Clone, Debug, Default)]
pub struct QuadraticProgram {
    /// B.
    pub curvature: DMatrix<f64>,
    /// The linear pieces; the first is the one that holds at d = 0.
    pub pieces: Vec<Piece>,
    /// Lower ends of the step, ≤ 0.
    pub low: DVector<f64>,
    /// Upper ends of the step, ≥ 0.
    pub high: DVector<f64>,
    /// Linear constraints.
    pub rows: Vec<Row>,
}

/// offset + gradient · d.
#[derive(Clone, Debug, Default)]
pub struct Piece {
    /// Value at d = 0.
    pub offset: f64,
    /// Slope.
    pub gradient: DVector<f64>,
}

/// low ≤ normal · d ≤ high; an equation where both are one number.
#[derive(Clone, Debug, Default)]
pub struct Row {
    /// Coefficients of d.
    pub normal: DVector<f64>,
    /// Lower end, or −∞.
    pub low: f64,
    /// Upper end, or ∞.
    pub high: f64,
}

/// Where a variable or a row ends.
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
    /// Multiplier of each row: > 0 at its upper end, < 0 at its lower, 0 between. Gradient, curvature and these
    /// balance: B d + Σ αₖ gradientₖ + Σ μⱼ normalⱼ = 0 on the variables that are free.
    pub multipliers: Vec<f64>,
    /// Who found the active set.
    pub by: Method,
}

/// Who found the active set of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The walk over the faces of the box.
    Faces,
    /// Clarabel.
    Clarabel,
    /// Clarabel, after the rows were rescaled.
    Rescaled,
    /// The dual active-set method.
    Dual,
    /// None: the step runs down the slope.
    Descent,
}

impl QuadraticProgram {
    /// Solves the program; `None` where the rows cannot be met within the ends.
    ///
    /// The faces of the box come first: where their walk ends its answer is proven, exact, and found in a fraction of
    /// the time that Clarabel takes. For all else, Clarabel's answer is good to about 1e-8 and may lie that far outside;
    /// it tells which ends, rows and pieces are active. The polish then solves the remaining equations to rounding, and
    /// corrects the active set where they disagree with it. Where Clarabel answers anything but "solved", or what it
    /// says cannot be polished, it is asked again with every row at length 1; then the dual active-set method decides.
    pub fn solve(&self) -> Option<Step> {
        if let Some(step) = self.by_faces() {
            return Some(step);
        }
        let mut second_best = None;
        let mut exact = |active: Option<ActiveSet>, method: Method| match self.polished(active?, method) {
            Ok(step) => Some(step),
            Err(step) => {
                second_best = second_best.take().or(step);
                None
            }
        };
        let by_clarabel = exact(self.clarabel(), Method::Clarabel);
        let has_rows = !self.rows.is_empty();
        let by_either =
            by_clarabel.or_else(|| if has_rows { exact(self.rescaled().clarabel(), Method::Rescaled) } else { None });
        if by_either.is_some() {
            return by_either;
        }
        let by_dual = self.dual_active_set();
        if by_dual.is_none() && has_rows {
            return None;
        }
        let by_any = exact(by_dual, Method::Dual).or(second_best);
        if has_rows { by_any } else { Some(by_any.unwrap_or_else(|| self.steepest())) }
    }

    /// Makes room for a program of `n` variables, one piece and `m` rows, without moving what has it.
    pub(super) fn resize(&mut self, n: usize, m: usize) {
        if self.dimension() != n {
            let own = Piece { offset: 0.0, gradient: DVector::zeros(n) };
            let (low, high) = (DVector::zeros(n), DVector::zeros(n));
            *self = Self { curvature: DMatrix::zeros(n, n), pieces: vec![own], low, high, rows: vec![] };
        }
        self.pieces.truncate(1);
        self.rows.resize_with(m, Row::default);
    }

    /// The objective.
    pub fn value(&self, d: &DVector<f64>) -> f64 {
        let pieces = self.pieces.iter().map(|piece| piece.offset + piece.gradient.dot(d));
        0.5 * quadratic_form(&self.curvature, d) + pieces.fold(f64::NEG_INFINITY, f64::max)
    }

    /// The largest amount by which a row is missed.
    fn missed(&self, d: &DVector<f64>) -> f64 {
        let missed = |row: &Row| {
            let value = row.normal.dot(d);
            (row.low - value).max(value - row.high).max(0.0)
        };
        self.rows.iter().map(missed).fold(0.0, f64::max)
    }

    fn dimension(&self) -> usize {
        self.low.len()
    }

    /// The same program with rows of length 1.
    fn rescaled(&self) -> Self {
        let mut scaled = self.clone();
        for row in &mut scaled.rows {
            let length = row.normal.norm();
            if length > 0.0 {
                *row = Row { normal: &row.normal / length, low: row.low / length, high: row.high / length };
            }
        }
        scaled
    }

    /// The best step down the first piece's slope alone, for when no active set can be solved.
    fn steepest(&self) -> Step {
        let slope = &self.pieces[0].gradient;
        let bend = slope.dot(&(&self.curvature * slope));
        let length = if bend > 0.0 { slope.norm_squared() / bend } else { 1.0 };
        let mut step = Step {
            d: -slope * length,
            ends: vec![End::Free; self.dimension()],
            weights: vec![0.0; self.pieces.len()],
            multipliers: vec![0.0; self.rows.len()],
            by: Method::Descent,
        };
        step.weights[0] = 1.0;
        self.clamp(&mut step);
        step
    }
}

/// dᵀ B d.
pub(super) fn quadratic_form(b: &DMatrix<f64>, d: &DVector<f64>) -> f64 {
    b.column_iter().zip(d).map(|(column, d_j)| d_j * column.dot(d)).sum()
}

#[cfg(test)]
mod tests {
    use super::{End, Piece, QuadraticProgram, Row};
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
            let pieces = vec![Piece { offset: 0.0, gradient }];
            let qp = QuadraticProgram { curvature, pieces, low, high, rows: vec![] };
            let step = qp.solve().unwrap();
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
            rows: vec![],
        };
        let step = qp.solve().unwrap();
        assert!((step.d[0] - 0.1).abs() < 1e-14 && (step.d[1] + 0.5).abs() < 1e-14, "{step:?}");
        // stationary: d₀ − α₀ + 2 α₁ = 0, α₀ + α₁ = 1
        assert!((step.weights[0] - 0.7).abs() < 1e-14 && (step.weights[1] - 0.3).abs() < 1e-14);
    }

    /// Random convex programs with rows, each also by the dual method alone: both exact, so they agree.
    #[test]
    fn independent_methods_agree_on_random_programs_with_rows() {
        let mut state = 0.3_f64;
        let mut random = || {
            state = (state * 97.409_1 + 0.137).fract();
            2.0 * state - 1.0
        };
        let (mut infeasible, mut compared) = (0, 0);
        for case in 0..400 {
            let (n, m) = (1 + case % 5, 1 + case % 4);
            let a = DMatrix::from_fn(n, n, |_, _| random());
            let curvature = &a * a.transpose() + DMatrix::identity(n, n) * 1e-2;
            let pieces = vec![Piece { offset: 0.0, gradient: DVector::from_fn(n, |_, _| random()) }];
            let row = |random: &mut dyn FnMut() -> f64, is_equation: bool| {
                let normal = DVector::from_fn(n, |_, _| random());
                let low = random() * 0.6;
                Row { normal, low, high: if is_equation { low } else { low + random().abs() } }
            };
            let rows = (0..m).map(|j| row(&mut random, j == 0 && n > 1)).collect();
            let low = DVector::from_fn(n, |_, _| -random().abs());
            let high = DVector::from_fn(n, |_, _| random().abs());
            let qp = QuadraticProgram { curvature, pieces, low, high, rows };
            let dual = qp.dual_active_set().map(|active| qp.polished(active, super::Method::Dual).unwrap());
            match (qp.solve(), dual) {
                (Some(step), Some(dual)) => {
                    compared += 1;
                    assert!((&step.d - &dual.d).amax() < 1e-9, "case {case}: {step:?} against {dual:?}");
                    assert!(qp.missed(&step.d) < 1e-12);
                    let mut pull = &qp.curvature * &step.d + &qp.pieces[0].gradient;
                    for (row, multiplier) in qp.rows.iter().zip(&step.multipliers) {
                        pull += &row.normal * *multiplier;
                    }
                    for i in (0..n).filter(|&i| step.ends[i] == End::Free) {
                        assert!(pull[i].abs() < 1e-9, "case {case}: {pull}");
                    }
                }
                (None, None) => infeasible += 1,
                (step, dual) => panic!("case {case}: {step:?} against {dual:?}"),
            }
        }
        assert!(compared > 100 && infeasible > 20, "{compared} {infeasible}");
    }
}
