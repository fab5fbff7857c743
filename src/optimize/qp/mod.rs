//! Quadratic programs, solved by a warm start from the previous active set. If the warm start
//! fails, Clarabel solves the program, and polishing gives an exact KKT point (`QpSolver::solve`).

mod interior_point;
mod linear;
mod polish;
mod program;
mod solve;
mod working_set;

pub(super) use linear::SymmetricSystem;
pub(super) use program::quadratic_form;
pub use program::{Activity, LinearConstraint, MaxTerm, QpStep, QuadraticProgram, StepSource};
pub(super) use solve::QpSolver;

#[cfg(test)]
mod tests {
    use super::{Activity, LinearConstraint, MaxTerm, QpSolver, QuadraticProgram, StepSource};
    use nalgebra::{DMatrix, DVector};

    /// Exact minimum by enumeration of all active sets of bounds.
    fn enumerated(qp: &QuadraticProgram) -> f64 {
        let n = qp.low.len();
        let mut least = f64::INFINITY;
        for code in 0..3_usize.pow(n as u32) {
            let ends: Vec<usize> = (0..n).map(|i| code / 3_usize.pow(i as u32) % 3).collect();
            let free: Vec<usize> = (0..n).filter(|&i| ends[i] == 0).collect();
            let mut d = DVector::from_fn(n, |i, _| [0.0, qp.low[i], qp.high[i]][ends[i]]);
            let right = -(&qp.hessian * &d + &qp.max_terms[0].gradient).select_rows(&free);
            let block = qp.hessian.select_rows(&free).select_columns(&free);
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
        // deterministic pseudo-random numbers: fractional parts of a multiplicative recurrence
        let mut state = 0.5_f64;
        let mut random = || {
            state = (state * 97.409_1 + 0.137).fract();
            2.0 * state - 1.0
        };
        for case in 0..300 {
            let n = 1 + case % 5;
            let a = DMatrix::from_fn(n, n, |_, _| random());
            let hessian = &a * a.transpose() + DMatrix::identity(n, n) * 1e-3;
            let gradient = DVector::from_fn(n, |_, _| random() * 10_f64.powi(case as i32 % 7 - 3));
            let low = DVector::from_fn(n, |_, _| -random().abs());
            let high = DVector::from_fn(n, |_, _| random().abs());
            let max_terms = vec![MaxTerm {
                offset: 0.0,
                gradient,
            }];
            let qp = QuadraticProgram {
                hessian,
                max_terms,
                low,
                high,
                rows: vec![],
            };
            let step = QpSolver::default().solve(&qp).unwrap();
            let (value, least) = (qp.value(&step.d), enumerated(&qp));
            assert!(
                value <= least + 1e-12 * least.abs().max(1e-3),
                "case {case}: {value} against {least}"
            );
            for i in 0..n {
                match step.activities[i] {
                    Activity::Lower => assert_eq!(step.d[i], qp.low[i]),
                    Activity::Upper => assert_eq!(step.d[i], qp.high[i]),
                    Activity::Inactive => assert!(qp.low[i] < step.d[i] && step.d[i] < qp.high[i]),
                }
            }
        }
    }

    #[test]
    fn exact_step_to_a_kink() {
        // ½‖d‖² + ½ d₁ + max(−d₀, 2 d₀ − 0.3): the terms of the maximum are equal at d₀ = 0.1
        let qp = QuadraticProgram {
            hessian: DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.0, 1.0]),
            max_terms: vec![
                MaxTerm {
                    offset: 0.0,
                    gradient: DVector::from_vec(vec![-1.0, 0.5]),
                },
                MaxTerm {
                    offset: -0.3,
                    gradient: DVector::from_vec(vec![2.0, 0.5]),
                },
            ],
            low: DVector::from_vec(vec![-1.0, -1.0]),
            high: DVector::from_vec(vec![1.0, 1.0]),
            rows: vec![],
        };
        let step = QpSolver::default().solve(&qp).unwrap();
        assert!(
            (step.d[0] - 0.1).abs() < 1e-14 && (step.d[1] + 0.5).abs() < 1e-14,
            "{step:?}"
        );
        // stationarity, d₀ − α₀ + 2 α₁ = 0 with d₀ = 0.1, and α₀ + α₁ = 1 give α = (0.7, 0.3)
        assert!((step.weights[0] - 0.7).abs() < 1e-14 && (step.weights[1] - 0.3).abs() < 1e-14);
    }

    /// Random convex programs with rows. Some programs are infeasible. In most programs the first
    /// row is an equality.
    fn random_programs_with_rows(count: usize) -> impl Iterator<Item = QuadraticProgram> {
        let mut state = 0.3_f64;
        let mut random = move || {
            state = (state * 97.409_1 + 0.137).fract();
            2.0 * state - 1.0
        };
        (0..count).map(move |case| {
            let (n, m) = (1 + case % 5, 1 + case % 4);
            let a = DMatrix::from_fn(n, n, |_, _| random());
            let hessian = &a * a.transpose() + DMatrix::identity(n, n) * 1e-2;
            let max_terms = vec![MaxTerm {
                offset: 0.0,
                gradient: DVector::from_fn(n, |_, _| random()),
            }];
            let row = |random: &mut dyn FnMut() -> f64, is_equation: bool| {
                let normal = DVector::from_fn(n, |_, _| random());
                let low = random() * 0.6;
                LinearConstraint {
                    normal,
                    low,
                    high: if is_equation {
                        low
                    } else {
                        low + random().abs()
                    },
                }
            };
            let rows = (0..m).map(|j| row(&mut random, j == 0 && n > 1)).collect();
            let low = DVector::from_fn(n, |_, _| -random().abs());
            let high = DVector::from_fn(n, |_, _| random().abs());
            QuadraticProgram {
                hessian,
                max_terms,
                low,
                high,
                rows,
            }
        })
    }

    /// Computes the KKT conditions from the program's data; they are sufficient for a minimum,
    /// because the program is convex. If a program is reported as infeasible, its least violation
    /// is computed and must be positive.
    #[test]
    fn exact_kkt_conditions_of_random_programs_with_rows() {
        let (mut infeasible, mut solved) = (0, 0);
        for (case, qp) in random_programs_with_rows(400).enumerate() {
            let n = qp.low.len();
            let Some(step) = QpSolver::default().solve(&qp) else {
                infeasible += 1;
                assert!(least_violation(&qp) > 1e-8, "case {case} can be met");
                continue;
            };
            solved += 1;
            assert_eq!(step.source, StepSource::Clarabel, "case {case}");
            assert!(qp.violation(&step.d) < 1e-12);
            let mut gradient = &qp.hessian * &step.d + &qp.max_terms[0].gradient;
            for (row, multiplier) in qp.rows.iter().zip(&step.multipliers) {
                gradient += &row.normal * *multiplier;
                let value = row.normal.dot(&step.d);
                let limit = if *multiplier > 0.0 { row.high } else { row.low };
                assert!(
                    *multiplier == 0.0 || (value - limit).abs() < 1e-12,
                    "case {case}: {multiplier} {value} {limit}"
                );
            }
            for i in 0..n {
                let is_balanced = match step.activities[i] {
                    Activity::Inactive => gradient[i].abs() < 1e-9,
                    Activity::Lower => gradient[i] > -1e-9,
                    Activity::Upper => gradient[i] < 1e-9,
                };
                assert!(
                    is_balanced || qp.low[i] == qp.high[i],
                    "case {case}: {gradient}"
                );
            }
        }
        assert!(solved > 100 && infeasible > 20, "{solved} {infeasible}");
    }

    /// Minimum of the largest row violation within the bounds, by projected gradient descent on
    /// ½‖violation‖².
    fn least_violation(qp: &QuadraticProgram) -> f64 {
        let mut d = DVector::zeros(qp.low.len());
        let step = 1.0
            / qp.rows
                .iter()
                .map(|row| row.normal.norm_squared())
                .sum::<f64>()
                .max(1e-12);
        for _ in 0..200_000 {
            let slope = qp.rows.iter().fold(DVector::zeros(d.len()), |sum, row| {
                sum + &row.normal * row.excess(&d)
            });
            let moved = &d - slope * step;
            let next = DVector::from_fn(d.len(), |i, _| moved[i].clamp(qp.low[i], qp.high[i]));
            // a fixed point is the minimum, because the violation is convex
            if next == d {
                break;
            }
            d = next;
        }
        qp.violation(&d)
    }

    #[test]
    fn a_second_program_with_the_same_active_set_is_a_warm_start_with_the_same_solution() {
        for qp in random_programs_with_rows(60) {
            let mut solver = QpSolver::default();
            let Some(first) = solver.solve(&qp) else {
                continue;
            };
            let second = solver.solve(&qp).unwrap();
            assert_eq!(second.source, StepSource::WarmStart);
            assert_eq!((first.d, first.multipliers), (second.d, second.multipliers));
        }
    }

    #[test]
    fn same_bits_of_a_used_solver_and_of_a_new_one() {
        let mut used = QpSolver::default();
        for qp in random_programs_with_rows(200) {
            used.active_set = None;
            let (a, b) = (used.solve(&qp), QpSolver::default().solve(&qp));
            assert_eq!(
                a.map(|step| (step.d, step.multipliers)),
                b.map(|step| (step.d, step.multipliers))
            );
        }
    }
}
