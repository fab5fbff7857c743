//! longdrive: SQP in a trust region, exact Hessians.

use super::{End, ITERATIONS, TOLERANCE};
use crate::oracle::{Oracle, start};
use ::longdrive::optimize::{Domain, Options, minimize};

pub fn solve(oracle: &Oracle) -> Result<End, String> {
    let case = oracle.case;
    let domain = Domain::new(case.low.to_vec(), case.high.to_vec())
        .and_then(|domain| domain.with_constraints(case.least.to_vec(), case.most.to_vec()))
        .map_err(|e| e.to_string())?;
    let options = Options {
        max_iterations: ITERATIONS,
        kkt_tolerance: TOLERANCE,
        ..Options::default()
    };
    let problem = |x: &[f64]| Ok(oracle.read(x, |at| at.clone()));
    let solution =
        minimize(&problem, &domain, &start(case), &options).map_err(|e| e.to_string())?;
    Ok(End {
        x: solution.x,
        status: solution.status.to_string(),
        iterations: Some(solution.iterations),
    })
}
