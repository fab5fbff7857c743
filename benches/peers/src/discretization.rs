//! Computation time and error by method and step of the integration.

use crate::clock;
use crate::grid;
use crate::tasks::{Discretization, mae494, operation, two};
use longdrive::derivative::{Evaluator, Order, Taylor};
use longdrive::{Outcome, Result};
use serde_json::{Value, json};

/// Loft and attack angle, deg, of two drives whose errors are measured: the drive of the
/// comparison, and the drive with the longest carry.
const PLACES: [[f64; 2]; 2] = [[10.0, 0.0], [14.682_922_531_9, 10.0]];
/// Methods of the table of computation time over error.
const METHODS: [&str; 2] = ["rk4", "dp8"];
/// Steps of the table of computation time over error, s, for each method.
const LADDERS: [[f64; 7]; 2] = [
    [0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.3],
    [0.05, 0.1, 0.2, 0.4, 0.8, 1.2, 1.6],
];
/// Largest allowed error of carry, m, in the rows 'at 1 µm' of docs/performance.md.
const MICROMETRE: f64 = 1e-6;
/// Number of tried steps for the rows 'at 1 µm': the multiples of `LONGEST_STEP`/`STEPS`.
const STEPS: u32 = 200;
/// Longest tried step, s.
const LONGEST_STEP: f64 = 2.0;

fn reference() -> Discretization {
    Discretization::new("rk4", 0.0005)
}

fn taylors(by: &Discretization, order: Order) -> Result<Vec<Taylor>> {
    let setup = mae494(by)?;
    let evaluator = Evaluator::new(&setup, &[Outcome::Carry], &two(&setup)?, order)?;
    PLACES
        .iter()
        .map(|place| Ok(evaluator.at(&place.map(f64::to_radians))?.swap_remove(0)))
        .collect()
}

fn largest<'a>(pairs: impl Iterator<Item = (&'a f64, &'a f64)>) -> f64 {
    pairs
        .map(|(found, exact)| (found - exact).abs())
        .fold(0.0, f64::max)
}

/// The largest errors of carry, gradient and Hessian over the drives.
fn errors(found: &[Taylor], exact: &[Taylor]) -> [f64; 3] {
    let mut errors = [0.0_f64; 3];
    for (found, exact) in found.iter().zip(exact) {
        let hessians = found
            .hessian
            .iter()
            .flatten()
            .zip(exact.hessian.iter().flatten());
        let each = [
            (found.value - exact.value).abs(),
            largest(found.gradient.iter().zip(&exact.gradient)),
            largest(hessians),
        ];
        errors = std::array::from_fn(|i| errors[i].max(each[i]));
    }
    errors
}

/// Computation times of value, gradient and Hessian, s.
fn times(by: &Discretization, budget: f64) -> Result<[f64; 3]> {
    let mut seconds = [f64::NAN; 3];
    for (seconds, task) in seconds.iter_mut().zip(["T1", "T2", "T3"]) {
        if let Some(operation) = operation(task, by)? {
            *seconds = clock::fastest(budget, operation);
        }
    }
    Ok(seconds)
}

/// The methods in the order of their times, fastest first. The step of a method is the largest one
/// for which this step and all shorter tried steps have errors of at most 1 µm. A method without
/// such a step is omitted.
fn choose(
    error: impl Fn(&Discretization) -> Result<f64>,
    time: impl Fn(&Discretization) -> Result<f64>,
) -> Result<Value> {
    let mut candidates = vec![];
    for method in METHODS {
        let mut best = None;
        for i in 1..=STEPS {
            let step = LONGEST_STEP * f64::from(i) / f64::from(STEPS);
            let error = error(&Discretization::new(method, step))?;
            if error > MICROMETRE {
                break;
            }
            best = Some((step, error));
        }
        let Some((step, error)) = best else { continue };
        let seconds = time(&Discretization::new(method, step))?;
        candidates.push((
            seconds,
            json!({"method": method, "step": step, "error": error, "seconds": seconds}),
        ));
    }
    candidates.sort_by(|a, b| a.0.total_cmp(&b.0));
    Ok(candidates
        .into_iter()
        .map(|(_, candidate)| candidate)
        .collect())
}

/// The methods and steps with an error of carry of at most 1 µm, fastest first: the list `single`
/// is for the drives of `PLACES`, the list `grid` for the points of task T6.
pub fn one_micrometre() -> Result<Value> {
    let exact = taylors(&reference(), Order::Value)?;
    let single = choose(
        |by| Ok(errors(&taylors(by, Order::Value)?, &exact)[0]),
        |by| Ok(times(by, 0.1)?[1]),
    )?;
    let exact = grid::carries(&reference())?;
    let over_grid = |by: &Discretization| Ok(largest(grid::carries(by)?.iter().zip(&exact)));
    Ok(
        json!({"single": single, "grid": choose(over_grid, |by| Ok(grid::Rows::new(by)?.time_middle()))?}),
    )
}

/// Calls `row` with errors and times of each method and step in the table of computation time over
/// error.
pub fn work_precision(mut row: impl FnMut(Value)) -> Result<()> {
    let exact = taylors(&reference(), Order::Second)?;
    for (method, ladder) in METHODS.iter().zip(LADDERS) {
        for step in ladder {
            let by = Discretization::new(method, step);
            let [carry, gradient, hessian] = errors(&taylors(&by, Order::Second)?, &exact);
            row(json!({
                "method": method,
                "step": step,
                "errors": [carry, gradient, hessian],
                "seconds": times(&by, 0.1)?,
            }));
        }
    }
    Ok(())
}
