//! slsqp: NLopt's SLSQP in Rust. Its interface has inequalities only; an equality becomes two
//! inequalities.

use super::{DECREASE_TOLERANCE, End, ITERATIONS};
use crate::oracle::{Oracle, Row, rows, start};
use crate::problems::Case;
use ::slsqp::{Func, StopTols, minimize};

pub fn solve(oracle: &Oracle) -> Result<End, String> {
    let case = oracle.case;
    let constraints = inequalities(case);
    let objective = |x: &[f64], gradient: Option<&mut [f64]>, _: &mut ()| {
        oracle.read(x, |at| {
            if let Some(gradient) = gradient {
                gradient.copy_from_slice(&at.objective.gradient);
            }
            at.objective.value
        })
    };
    let functions: Vec<_> = constraints
        .iter()
        .map(|row| constraint(oracle, row))
        .collect();
    let functions: Vec<&dyn Func<()>> = functions
        .iter()
        .map(|function| function as &dyn Func<()>)
        .collect();
    let bounds: Vec<(f64, f64)> = case
        .low
        .iter()
        .copied()
        .zip(case.high.iter().copied())
        .collect();
    let stop = StopTols {
        ftol_rel: DECREASE_TOLERANCE,
        ..StopTols::default()
    };
    // slsqp limits evaluations instead of iterations: ten evaluations for each iteration
    let most = 10 * ITERATIONS as usize;
    let (status, x) = match minimize(
        objective,
        &start(case),
        &bounds,
        &functions,
        (),
        most,
        Some(stop),
    ) {
        Ok((status, x, _)) => (format!("{status:?}"), x),
        Err((status, x, _)) => (format!("{status:?}"), x),
    };
    Ok(End {
        x,
        status,
        iterations: None,
    })
}

/// The constraints of a case as inequalities, two for each equality.
fn inequalities(case: &Case) -> Vec<Row> {
    let (equalities, mut constraints) = rows(case);
    for row in equalities {
        let reversed = Row {
            sign: -row.sign,
            ..row
        };
        constraints.extend([row, reversed]);
    }
    constraints
}

fn constraint(oracle: &Oracle, row: &Row) -> impl Fn(&[f64], Option<&mut [f64]>, &mut ()) -> f64 {
    move |x, gradient, ()| {
        oracle.read(x, |at| {
            for (i, slope) in gradient.into_iter().flatten().enumerate() {
                *slope = row.slope(at, i);
            }
            row.value(at)
        })
    }
}
