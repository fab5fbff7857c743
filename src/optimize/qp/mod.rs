//! The quadratic program of a step. Of bounds alone, a walk over the faces of the box solves it; in general a dual active-set
//! method finds what holds the step, a polish makes it exact, and Clarabel takes over where the method does not answer.

mod active_set;
mod dual;
mod ends;
mod faces;
mod interior_point;
mod linear;
mod polish;
mod program;
mod solve;
mod walk;

pub(super) use ends::{clamp, corrected_end};
pub(super) use program::quadratic_form;
pub use program::{End, Method, Piece, QuadraticProgram, Row, Step};

#[cfg(test)]
mod tests {
    use super::{End, Piece, QuadraticProgram, Row};
    use nalgebra::{DMatrix, DVector};

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
            curvature: DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.0, 1.0]),
            pieces: vec![
                Piece { offset: 0.0, gradient: DVector::from_vec(vec![-1.0, 0.5]) },
                Piece { offset: -0.3, gradient: DVector::from_vec(vec![2.0, 0.5]) },
            ],
            low: DVector::from_vec(vec![-1.0, -1.0]),
            high: DVector::from_vec(vec![1.0, 1.0]),
            rows: vec![],
        };
        let step = qp.solve().unwrap();
        assert!((step.d[0] - 0.1).abs() < 1e-14 && (step.d[1] + 0.5).abs() < 1e-14, "{step:?}");
        // stationary: d₀ − α₀ + 2 α₁ = 0, α₀ + α₁ = 1
        assert!((step.weights[0] - 0.7).abs() < 1e-14 && (step.weights[1] - 0.3).abs() < 1e-14);
    }

    /// Random convex programs with rows, of which some cannot be met; the first row of most is an equation.
    fn random_programs_with_rows(count: usize) -> impl Iterator<Item = QuadraticProgram> {
        let mut state = 0.3_f64;
        let mut random = move || {
            state = (state * 97.409_1 + 0.137).fract();
            2.0 * state - 1.0
        };
        (0..count).map(move |case| {
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
            QuadraticProgram { curvature, pieces, low, high, rows }
        })
    }

    /// Each also by Clarabel, an interior-point method: both exact once polished, so they agree.
    #[test]
    fn independent_methods_agree_on_random_programs_with_rows() {
        let (mut infeasible, mut compared) = (0, 0);
        for (case, qp) in random_programs_with_rows(400).enumerate() {
            let n = qp.low.len();
            let clarabel = qp.clarabel().map(|active| qp.polished(active, None, super::Method::Clarabel).unwrap());
            match (qp.solve(), clarabel) {
                (Some(step), Some(clarabel)) => {
                    compared += 1;
                    assert_eq!(step.by, super::Method::Dual);
                    assert!((&step.d - &clarabel.d).amax() < 1e-9, "case {case}: {step:?} against {clarabel:?}");
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
                (step, clarabel) => panic!("case {case}: {step:?} against {clarabel:?}"),
            }
        }
        assert!(compared > 100 && infeasible > 20, "{compared} {infeasible}");
    }
}
