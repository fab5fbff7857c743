//! Runs a solver on a problem in a separate process, because a solver may panic, abort or hang.

use crate::all;
use crate::oracle::Oracle;
use crate::outcome::Outcome;
use crate::peers::PEERS;
use std::error::Error;
use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};
use std::sync::mpsc;
use std::time::{Duration, Instant};

/// Time limit of a repetition. A solver that exceeds the limit in the first repetition counts as
/// failed. If a later repetition exceeds it, the outcomes of the earlier ones count.
const PATIENCE: Duration = Duration::from_secs(10);
/// Number of times that a solver solves a problem. The fastest time is kept.
const REPETITIONS: usize = 3;

/// The work of the child process: prints the outcome of each repetition as a line of JSON.
pub fn solve(solver: &str, problem: &str) -> Result<(), Box<dyn Error>> {
    let peer = PEERS
        .iter()
        .find(|peer| peer.name == solver)
        .ok_or("no such solver")?;
    let cases = all();
    let case = cases
        .iter()
        .find(|case| case.name == problem)
        .ok_or("no such problem")?;
    for _ in 0..REPETITIONS {
        let oracle = Oracle::new(case);
        let started = Instant::now();
        let end = (peer.solve)(&oracle)?;
        let seconds = started
            .elapsed()
            .saturating_sub(oracle.spent())
            .as_secs_f64();
        let outcome = Outcome {
            solver: solver.into(),
            problem: problem.into(),
            status: end.status,
            x: end
                .x
                .into_iter()
                .map(|x| x.is_finite().then_some(x))
                .collect(),
            evaluations: oracle.evaluations(),
            iterations: end.iterations,
            seconds,
        };
        println!("{}", serde_json::to_string(&outcome)?);
    }
    Ok(())
}

/// Runs the child process. Returns the outcome of its last repetition, with the time of the fastest
/// repetition.
pub fn run(solver: &str, problem: &str) -> Result<Outcome, Box<dyn Error>> {
    let mut child = Command::new(std::env::current_exe()?)
        .args(["--solve", solver, problem])
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()?;
    let output = BufReader::new(child.stdout.take().ok_or("no output")?);
    let (send, receive) = mpsc::channel();
    let reader = std::thread::spawn(move || {
        for outcome in output
            .lines()
            .map_while(Result::ok)
            .filter_map(|line| serde_json::from_str(&line).ok())
        {
            if send.send(outcome).is_err() {
                return;
            }
        }
    });
    let mut found: Option<Outcome> = None;
    let mut is_late = false;
    loop {
        match receive.recv_timeout(PATIENCE) {
            Ok(outcome) => {
                let outcome: Outcome = outcome;
                let seconds = found
                    .as_ref()
                    .map_or(outcome.seconds, |found| found.seconds.min(outcome.seconds));
                found = Some(Outcome { seconds, ..outcome });
            }
            Err(mpsc::RecvTimeoutError::Timeout) => {
                is_late = true;
                child.kill()?;
                break;
            }
            Err(mpsc::RecvTimeoutError::Disconnected) => break,
        }
    }
    let status = child.wait()?;
    reader
        .join()
        .map_err(|_| "the thread that reads the solver's output panicked")?;
    let why = if is_late {
        "more than 10 s".into()
    } else {
        format!("failed, {status}")
    };
    Ok(found.unwrap_or_else(|| Outcome::failed(solver, problem, why)))
}
