//! Compares longdrive's optimizer with its peers on the published problems of tests/problems. See
//! run.sh.

#[expect(dead_code, reason = "only the tests use the published points")]
#[path = "../../../tests/problems/mod.rs"]
mod problems;

mod child;
mod judge;
mod nnls;
mod oracle;
mod outcome;
mod peers;
mod serve;
mod tables;

use outcome::Outcome;
use problems::Case;
use std::error::Error;
use std::path::PathBuf;

const USAGE: &str = "usage: optimizers [--scipy OUTCOMES.jsonl] [-o DIR]   compare all solvers
       optimizers --serve                              evaluate problems: JSON lines in and out
       optimizers --solve SOLVER PROBLEM               one solver on one problem (used by the \
                     comparison)";

fn all() -> Vec<Case> {
    problems::hock_schittkowski()
        .into_iter()
        .chain(problems::more_garbow_hillstrom())
        .collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match words.as_slice() {
        ["--serve"] => serve::serve(),
        ["--solve", solver, problem] => child::solve(solver, problem),
        options => compare(options),
    }
}

fn compare(options: &[&str]) -> Result<(), Box<dyn Error>> {
    let (mut directory, mut scipy) = (PathBuf::from("."), None);
    for option in options.chunks(2) {
        match option {
            ["-o", path] => directory = PathBuf::from(path),
            ["--scipy", path] => scipy = Some(PathBuf::from(path)),
            _ => return Err(USAGE.into()),
        }
    }
    let cases = all();
    let mut outcomes = vec![];
    for peer in &peers::PEERS {
        eprintln!("{}", peer.name);
        for case in cases.iter().filter(|case| peer.takes(case)) {
            outcomes.push(child::run(peer.name, case.name)?);
        }
    }
    if let Some(path) = scipy {
        for line in std::fs::read_to_string(path)?.lines() {
            outcomes.push(serde_json::from_str::<Outcome>(line)?);
        }
    }
    tables::write(&cases, &outcomes, &directory)
}
