//! Time of the optimizer alone, without the time of the functions, for the published problems of
//! `tests/problems` from their published starts. The timed searches read the function values from a
//! list that an untimed first search has written. `cargo bench --bench optimizer`.

#[expect(
    dead_code,
    reason = "only the tests use the published optima and points"
)]
#[path = "../tests/problems/mod.rs"]
mod problems;

use longdrive::optimize::{Domain, Evaluation, Options, Solution, minimize};
use problems::Case;
use std::cell::{Cell, RefCell};
use std::time::{Duration, Instant};

/// Number of timed searches of each problem. The fastest time is kept, because other programs slow
/// down some of the searches.
const TIMES: u32 = 30;
/// Largest number of variables of a small problem.
const FEW: usize = 4;

struct Measured {
    variables: usize,
    is_constrained: bool,
    solution: Solution,
    fastest: Duration,
}

impl Measured {
    fn micros_per_iteration(&self) -> f64 {
        self.fastest.as_secs_f64() * 1e6 / self.solution.iterations.max(1) as f64
    }
}

fn measured(case: &Case) -> Measured {
    let domain = Domain::new(case.low.to_vec(), case.high.to_vec())
        .and_then(|domain| domain.with_constraints(case.least.to_vec(), case.most.to_vec()))
        .expect("a domain of a published problem");
    let search = |problem: &dyn Fn(&[f64]) -> Result<Evaluation, String>| {
        minimize(&problem, &domain, case.start, &Options::default()).expect("a published problem")
    };
    let evaluations = RefCell::new(vec![]);
    let solution = search(&|x| {
        let at = (case.evaluate)(x);
        evaluations.borrow_mut().push(at.clone());
        at
    });
    let (evaluations, next) = (evaluations.into_inner(), Cell::new(0));
    let once = |_| {
        next.set(0);
        let start = Instant::now();
        let again = search(&|_| evaluations[next.replace(next.get() + 1)].clone());
        let time = start.elapsed();
        assert_eq!(again.x, solution.x, "{}: another search", case.name);
        time
    };
    let fastest = (0..TIMES).map(once).min().unwrap_or_default();
    Measured {
        variables: case.start.len(),
        is_constrained: !case.least.is_empty(),
        solution,
        fastest,
    }
}

fn print(what: &str, all: &[Measured], is_one: impl Fn(&Measured) -> bool) {
    let group: Vec<&Measured> = all.iter().filter(|one| is_one(one)).collect();
    let mut micros: Vec<f64> = group.iter().map(|one| one.micros_per_iteration()).collect();
    micros.sort_by(f64::total_cmp);
    let iterations: u64 = group.iter().map(|one| one.solution.iterations).sum();
    let programs: [u64; 3] =
        group
            .iter()
            .fold([0; 3], |[warm_starts, clarabel, unpolished], one| {
                let effort = &one.solution.effort;
                [
                    warm_starts + effort.warm_starts,
                    clarabel + effort.clarabel,
                    unpolished + effort.unpolished,
                ]
            });
    println!(
        "{what:<48} {:>8} {iterations:>10} {:>10.2} {:>10.2}   {programs:?}",
        group.len(),
        micros.get(micros.len() / 2).copied().unwrap_or(f64::NAN),
        micros.iter().copied().fold(0.0, f64::max),
    );
}

fn main() {
    let cases = problems::hock_schittkowski()
        .into_iter()
        .chain(problems::more_garbow_hillstrom());
    let all: Vec<Measured> = cases.map(|case| measured(&case)).collect();
    println!(
        "{:<48} {:>8} {:>10} {:>10} {:>10}   QPs by [warm start, Clarabel, unpolished]",
        "µs per iteration, without the functions", "problems", "iterations", "median", "largest"
    );
    for (size, is_small) in [("up to 4 variables", true), ("5 variables or more", false)] {
        let is_of_size = |one: &Measured| (one.variables <= FEW) == is_small;
        print(&format!("{size}, bounds alone"), &all, |one| {
            is_of_size(one) && !one.is_constrained
        });
        print(&format!("{size}, constraints"), &all, |one| {
            is_of_size(one) && one.is_constrained
        });
    }
}
