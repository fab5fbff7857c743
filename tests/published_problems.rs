//! The optimizer on published collections of nonlinear programming problems.

mod problems;

use longdrive::optimize::{Domain, Options, Solution, Status, minimize};
use problems::Case;

fn domain(case: &Case) -> Domain {
    Domain::new(case.low.to_vec(), case.high.to_vec())
        .and_then(|domain| domain.subject_to(case.least.to_vec(), case.most.to_vec()))
        .unwrap()
}

fn solve(case: &Case) -> Solution {
    minimize(&case.evaluate, &domain(case), case.start, &Options::default()).unwrap()
}

#[test]
fn table() {
    for case in problems::hock_schittkowski().into_iter().chain(problems::more_garbow_hillstrom()) {
        let s = solve(&case);
        let value = s.value.unwrap_or(f64::NAN);
        let off = (value - case.optimum) / case.optimum.abs().max(1.0);
        let flag = if s.status != Status::Converged || off.abs() > 1e-5 { "  <<<<" } else { "" };
        println!(
            "{:8} n={:2} m={:2} {:16} it {:3} ev {:3} f {:.9e} published {:.9e} off {:+.1e} kkt {:.1e}/{:.1e} {:?}{flag}",
            case.name,
            case.start.len(),
            case.least.len(),
            s.status.name(),
            s.iterations,
            s.evaluations,
            value,
            case.optimum,
            off,
            s.residual.stationarity,
            s.residual.feasibility,
            (
                s.effort.clarabel,
                s.effort.rescaled,
                s.effort.dual,
                s.effort.descent,
                s.effort.relaxed,
                s.effort.corrections
            )
        );
    }
}

#[test]
fn trace() {
    let Ok(name) = std::env::var("CASE") else { return };
    for case in problems::hock_schittkowski().into_iter().chain(problems::more_garbow_hillstrom()).into_iter().filter(|case| case.name == name) {
        let watch = longdrive::optimize::Watch {
            iteration: Box::new(|i| {
                println!(
                    "{:3} f {:.6e} kkt {:.1e} v {:.1e} r {:.1e} kept {} x {:.5?}",
                    i.number, i.value, i.kkt_residual, i.violation, i.radius, i.kept, i.x
                )
            }),
            ..Default::default()
        };
        let s = longdrive::optimize::minimize_watched(
            &case.evaluate,
            &domain(&case),
            case.start,
            &Options::default(),
            watch,
        )
        .unwrap();
        println!("{} {} {:?}", s.status, s.message, s.constraints);
    }
}
