//! Status and result of the optimizer on small problems from public bug reports of other solvers.
//! Each solution is known in closed form, or to many digits.

use longdrive::number::Number;
use longdrive::optimize::{
    Domain, Evaluation, Exact, Functions, Gradients, Options, Problem, Solution, Status, minimize,
};

const FREE: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

/// Minimizes a problem within bounds of the variables and limits of the constraint functions.
fn solve(
    problem: &dyn Problem,
    bounds: &[(f64, f64)],
    limits: &[(f64, f64)],
    start: &[f64],
) -> Solution {
    let (low, high) = bounds.iter().copied().unzip();
    let (least, most) = limits.iter().copied().unzip();
    let domain = Domain::new(low, high)
        .unwrap()
        .with_constraints(least, most)
        .unwrap();
    let found = minimize(problem, &domain, start, &Options::default()).unwrap();
    assert!(
        !found.message.contains("inf ") && !found.message.contains("NaN"),
        "{}",
        found.message
    );
    found
}

fn converged(found: &Solution, value: f64, tolerance: f64) {
    assert_eq!(
        found.status,
        Status::Converged,
        "{} at {:?}",
        found.message,
        found.x
    );
    let apart = (found.value.unwrap() - value).abs();
    assert!(
        apart <= tolerance * value.abs().max(1.0),
        "{:?} in place of {value}",
        found.value
    );
}

fn plain<T>(objective: T) -> Result<Evaluation<T>, String> {
    Ok(Evaluation::unconstrained(objective))
}

/// x⁴ − x²: value and slope vanish at 0, which is a maximum.
struct DoubleWell;

impl Functions for DoubleWell {
    fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String> {
        plain(x[0].powi(4) - x[0].powi(2))
    }
}

#[test]
fn exact_minimum_from_a_start_whose_value_and_slope_vanish() {
    for bounds in [FREE, (-2.0, 2.0)] {
        let found = solve(&Exact(DoubleWell), &[bounds], &[], &[0.0]);
        converged(&found, -0.25, 1e-10);
        assert!(
            (found.x[0].abs() - 0.5_f64.sqrt()).abs() < 1e-8,
            "{:?}",
            found.x
        );
    }
}

#[test]
fn without_second_derivatives_a_stationary_point_is_reported_as_not_examined() {
    let found = solve(&Gradients(DoubleWell), &[FREE], &[], &[0.0]);
    assert!(
        found
            .message
            .contains("without second derivatives a saddle point"),
        "{}",
        found.message
    );
}

/// Objective eˣ (4x² + 2y² + 4xy + 2y + 1), constraint functions x² + y and xy.
struct Exponential;

impl Functions for Exponential {
    fn evaluate<T: Number>(&self, v: &[T]) -> Result<Evaluation<T>, String> {
        let (x, y) = (v[0], v[1]);
        let polynomial = x * x * 4.0 + y * y * 2.0 + x * y * 4.0 + y * 2.0 + 1.0;
        Ok(Evaluation {
            objective: x.exp() * polynomial,
            constraints: vec![x * x + y, x * y],
        })
    }
}

/// Objective x, constraint function x² + y.
struct Parabola;

impl Functions for Parabola {
    fn evaluate<T: Number>(&self, v: &[T]) -> Result<Evaluation<T>, String> {
        Ok(Evaluation {
            objective: v[0],
            constraints: vec![v[0] * v[0] + v[1]],
        })
    }
}

/// At (0, 1) the gradients of the constraint x² + y = 1 and of the bound y ≤ 1 are parallel. Near
/// this point, huge multipliers of constraint and bound can balance any gradient of the objective.
#[test]
fn exact_minima_beyond_a_point_where_a_constraint_touches_a_bound() {
    let limits = [(1.0, 1.0), (-10.0, f64::INFINITY)];
    let found = solve(
        &Exact(Exponential),
        &[(-1.0, 1.0); 2],
        &limits,
        &[0.99, -0.99],
    );
    converged(&found, 1.509_310_953_9, 1e-9);
    assert!(
        (found.x[0] + 0.752_879).abs() < 1e-5 && (found.x[1] - 0.433_173).abs() < 1e-5,
        "{:?}",
        found.x
    );
    let bounds = [(-2.0, f64::INFINITY), (f64::NEG_INFINITY, 1.0)];
    converged(
        &solve(&Exact(Parabola), &bounds, &[(1.0, 1.0)], &[1.0, 0.0]),
        -2.0,
        1e-9,
    );
    for start in [[0.5, 0.5], [1.5, -1.0], [0.1, 1.0]] {
        converged(
            &solve(&Exact(Parabola), &bounds, &[(1.0, 1.0)], &start),
            -2.0,
            1e-9,
        );
    }
}

/// Objective −0.7 (x₁ + x₂ + x₃ − 175000)(x₀² + 3x₀ + 3); each variable is a constraint function.
struct Profit;

impl Functions for Profit {
    fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String> {
        let amount = x[1] + x[2] + x[3] - 175_000.0;
        Ok(Evaluation {
            objective: -(amount * (x[0] * x[0] + x[0] * 3.0 + 3.0)) * 0.7,
            constraints: x.to_vec(),
        })
    }
}

/// Objective −xy, constraint functions x and y.
struct Product;

impl Functions for Product {
    fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String> {
        Ok(Evaluation {
            objective: -(x[0] * x[1]),
            constraints: x.to_vec(),
        })
    }
}

/// Objective −x − y, constraint function x² + y².
struct Disc;

impl Functions for Disc {
    fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String> {
        Ok(Evaluation {
            objective: -(x[0] + x[1]),
            constraints: vec![x[0] * x[0] + x[1] * x[1]],
        })
    }
}

#[test]
fn exact_optima_that_lie_far_from_the_start() {
    let limits = [
        (0.5, 1.5),
        (45_000.0, 250_000.0),
        (10_000.0, 125_000.0),
        (5_000.0, 75_000.0),
    ];
    converged(
        &solve(&Exact(Profit), &[FREE; 4], &limits, &[0.0; 4]),
        -1_876_875.0,
        1e-9,
    );
    let below = |most: f64| (f64::NEG_INFINITY, most);
    for start in [[1.0, 1.0], [0.5, 0.5], [0.1, 2.0]] {
        let found = solve(
            &Exact(Product),
            &[FREE; 2],
            &[below(1.5), below(1e5)],
            &start,
        );
        converged(&found, -150_000.0, 1e-9);
    }
    let found = solve(&Exact(Disc), &[FREE; 2], &[below(1e12)], &[0.1, 0.0]);
    converged(&found, -2e6 * 0.5_f64.sqrt(), 1e-9);
}

/// Objective x², and x as two constraint functions.
struct Twice;

impl Functions for Twice {
    fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String> {
        Ok(Evaluation {
            objective: x[0] * x[0],
            constraints: vec![x[0], x[0]],
        })
    }
}

#[test]
fn contradictions_by_very_little_are_infeasible_in_few_iterations() {
    for gap in [1e-9, 1e-8, 1e-6, 1e-3] {
        for start in [0.0, 1.0, -0.3] {
            let limits = [(f64::NEG_INFINITY, 0.0), (gap, f64::INFINITY)];
            let found = solve(&Exact(Twice), &[FREE], &limits, &[start]);
            assert_eq!(
                found.status,
                Status::Infeasible,
                "gap {gap:e} from {start}: {}",
                found.message
            );
            assert!(
                found.message.contains("no point was found"),
                "{}",
                found.message
            );
            assert!(
                found.iterations <= 40 && found.residual.largest().is_finite(),
                "{} iterations",
                found.iterations
            );
        }
    }
}

/// (x − 3)² plus a constant, such as 1e12.
struct WithConstant(f64);

impl Functions for WithConstant {
    fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String> {
        plain((x[0] - 3.0).powi(2) + self.0)
    }
}

#[test]
fn minimum_of_a_function_with_a_large_constant() {
    for constant in [1e6, 1e9, 1e12, -1e12] {
        let found = solve(&Exact(WithConstant(constant)), &[FREE], &[], &[0.0]);
        assert_eq!(found.status, Status::Converged, "{}", found.message);
        assert!((found.x[0] - 3.0).abs() < 1e-3, "{:?}", found.x);
    }
}

/// Objective √(w'Qw), constraint functions Σw and r'w: the weights of a portfolio, from a bug
/// report.
struct Portfolio;

const RETURNS: [f64; 5] = [0.129_64, 0.110_86, 0.034_39, 0.115_94, 0.064_68];
const COVARIANCE: [[f64; 5]; 5] = [
    [0.00463, 0.00407, 0.00102, 0.00212, 0.00272],
    [0.00407, 0.00412, 0.00079, 0.00185, 0.00289],
    [0.00102, 0.00079, 0.00039, 0.00061, 0.00054],
    [0.00212, 0.00185, 0.00061, 0.00134, 0.00129],
    [0.00272, 0.00289, 0.00054, 0.00129, 0.00214],
];

impl Functions for Portfolio {
    fn evaluate<T: Number>(&self, w: &[T]) -> Result<Evaluation<T>, String> {
        let zero = w[0] * 0.0;
        let dot = |weights: &[f64; 5]| {
            w.iter()
                .zip(weights)
                .fold(zero, |sum, (w, factor)| sum + *w * *factor)
        };
        let variance = w
            .iter()
            .zip(&COVARIANCE)
            .fold(zero, |sum, (w, row)| sum + *w * dot(row));
        Ok(Evaluation {
            objective: variance.sqrt(),
            constraints: vec![dot(&[1.0; 5]), dot(&RETURNS)],
        })
    }
}

#[test]
fn exact_point_where_only_one_is_feasible() {
    let bounds = [(0.0, 1.0), (0.0, 1.0), (0.2, 0.2), (0.0, 1.0), (0.0, 1.0)];
    let found = |wanted: f64| {
        solve(
            &Exact(Portfolio),
            &bounds,
            &[(1.0, 1.0), (wanted, wanted)],
            &[0.2; 5],
        )
    };
    let only = found(0.058_622);
    converged(&only, 0.039_471_5, 1e-7);
    for (w, expected) in only.x.iter().zip([0.0, 0.0, 0.2, 0.0, 0.8]) {
        assert!((w - expected).abs() < 1e-12, "{:?}", only.x);
    }
    assert_eq!(found(0.058_62).status, Status::Infeasible);
    converged(&found(0.07), 0.036_148_068_9, 1e-9);
}

fn larger<T: Number>(a: T, b: T) -> T {
    if a.re() >= b.re() { a } else { b }
}

/// max((x − 1)² + y², x² + (y − 1)²): ½ at (½, ½), on the oblique edge x = y.
struct Paraboloids;

impl Functions for Paraboloids {
    fn evaluate<T: Number>(&self, v: &[T]) -> Result<Evaluation<T>, String> {
        let (x, y) = (v[0], v[1]);
        plain(larger(
            (x - 1.0).powi(2) + y.powi(2),
            x.powi(2) + (y - 1.0).powi(2),
        ))
    }
}

/// |x − y| + (x + y − 1)²: 0 at (½, ½), on the oblique edge x = y.
struct Valley;

impl Functions for Valley {
    fn evaluate<T: Number>(&self, v: &[T]) -> Result<Evaluation<T>, String> {
        plain(larger(v[0] - v[1], v[1] - v[0]) + (v[0] + v[1] - 1.0).powi(2))
    }
}

#[test]
fn exact_minima_on_oblique_corners() {
    for k in 0..24 {
        let part = |step: f64| 8.0 * ((0.5 + f64::from(k) * step).fract() - 0.5);
        let start = [part(0.754_877_666), part(0.569_840_29)];
        for (problem, least) in [
            (&Exact(Paraboloids) as &dyn Problem, 0.5),
            (&Exact(Valley), 0.0),
        ] {
            let found = solve(problem, &[(-5.0, 5.0); 2], &[], &start);
            assert!(
                (found.value.unwrap() - least).abs() < 1e-6,
                "from {start:?}: {:?} {}",
                found.value,
                found.message
            );
        }
    }
}

/// The largest loss t of three models: the objective is t, and each model has the constraint
/// function c (x − mₖ)² − sₖ (y − 0.087) − t. The code adds and subtracts 275, because a loss of
/// carry is a difference of two carries.
struct GreatestLoss {
    curvature: f64,
    bests: [f64; 3],
    slopes: [f64; 3],
}

impl Functions for GreatestLoss {
    fn evaluate<T: Number>(&self, v: &[T]) -> Result<Evaluation<T>, String> {
        let (loft, attack, greatest) = (v[0], v[1], v[2]);
        let loss = |(best, slope): (&f64, &f64)| {
            let carry = (loft - *best).powi(2) * self.curvature - (attack - 0.087) * *slope + 275.0;
            carry - greatest - 275.0
        };
        let constraints = self.bests.iter().zip(&self.slopes).map(loss).collect();
        Ok(Evaluation {
            objective: greatest,
            constraints,
        })
    }
}

/// The problem [`GreatestLoss`] in closed form: y is at its bound 0.087, and x is in the middle
/// between the smallest and the largest of `bests`. The largest loss is `curvature` times the
/// square of half the difference of these two.
#[test]
fn exact_smallest_greatest_losses_from_three_starts() {
    for k in 0..100 {
        let part = |i: u32| {
            (f64::from(k) * (0.754_877_666 + 0.569_840_29 * f64::from(i)) + 0.1 * f64::from(i))
                .fract()
        };
        let curvature = 3000.0 + 3000.0 * part(1);
        let bests = [2, 3, 4].map(|i| 0.105 + 0.012 * part(i));
        let slopes = [5, 6, 7].map(|i| 60.0 + 60.0 * part(i));
        let low = bests.into_iter().fold(f64::INFINITY, f64::min);
        let high = bests.into_iter().fold(0.0, f64::max);
        let exact = curvature * (0.5 * (high - low)).powi(2);
        let bounds = [(0.0, 0.35), (-0.087, 0.087), FREE];
        let limits = [(f64::NEG_INFINITY, 0.0); 3];
        let elsewhere = [0.1 + 0.03 * part(8), 0.08 - 0.1 * part(9), 30.0];
        for start in [[0.18, 0.0, 60.0], [bests[0], 0.087, 0.5], elsewhere] {
            let problem = GreatestLoss {
                curvature,
                bests,
                slopes,
            };
            let found = solve(&Exact(problem), &bounds, &limits, &start);
            converged(&found, exact, 2e-9);
            assert!(
                found.iterations <= 40,
                "{k}: {} iterations from {start:?}",
                found.iterations
            );
        }
    }
}
