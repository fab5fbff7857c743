//! longdrive's part of the comparison with other programs. See run.sh.

mod clock;
mod discretization;
mod grid;
mod start;
mod tasks;

use serde_json::json;
use std::error::Error;
use std::hint::black_box;
use tasks::Discretization;

const USAGE: &str = "usage: peers [--method M] [--step S] [--peer NAME] [TASK [once | count N]]
         all tasks or one, timed; once: printed untimed; count: N times, printing nothing (for \
                     instruction counts)
         TASK: T1 T2 T3 T4 T5 T6 T6-whole all 3-D 3-D-all
       peers one-micrometre                the method and step of the rows 'at 1 µm'
       peers work-precision                errors and times by method and step
       peers start NAME TASK COMMAND...    T7: seconds of a process";

/// CPU time for the timed batches of a task, s.
const BUDGET: f64 = 0.4;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let mut words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let (mut by, mut peer) = (Discretization::default(), "longdrive".to_owned());
    while let ["--method" | "--step" | "--peer", value, ..] = words[..] {
        match words[0] {
            "--method" => by.method = Some(value.into()),
            "--step" => by.step = Some(value.into()),
            _ => peer = value.into(),
        }
        words.drain(..2);
    }
    match words[..] {
        ["one-micrometre"] => println!("{}", discretization::one_micrometre()?),
        ["work-precision"] => discretization::work_precision(|row| println!("{row}"))?,
        ["start", name, task, ref command @ ..] => {
            emit(name, task, start::time(command)?, 0.0, &[], "")
        }
        [] => {
            for task in tasks::SINGLE.into_iter().chain(["T6", "T6-whole"]) {
                time(&peer, task, &by, false)?;
            }
        }
        [task] => time(&peer, task, &by, false)?,
        [task, "once"] => time(&peer, task, &by, true)?,
        [task, "count", count] => repeat(task, &by, count.parse()?)?,
        _ => return Err(USAGE.into()),
    }
    Ok(())
}

fn time(peer: &str, task: &str, by: &Discretization, once: bool) -> Result<(), Box<dyn Error>> {
    if let Some(operation) = tasks::operation(task, by)? {
        let (value, derivatives, note) = operation()?.parts();
        let seconds = if once {
            0.0
        } else {
            clock::fastest(BUDGET, &operation)
        };
        emit(peer, task, seconds, value, &derivatives, &note);
        return Ok(());
    }
    let (seconds, sums) = match task {
        "T6" => grid::Rows::new(by)?.time(),
        "T6-whole" => grid::whole(by)?,
        _ => return Err(USAGE.into()),
    };
    emit(peer, task, seconds, sums.all, &[sums.spinning], "");
    Ok(())
}

fn repeat(task: &str, by: &Discretization, count: u64) -> Result<(), Box<dyn Error>> {
    if let Some(operation) = tasks::operation(task, by)? {
        for _ in 0..count {
            black_box(operation()?);
        }
    } else {
        grid::Rows::new(by)?.repeat(count);
    }
    Ok(())
}

fn emit(peer: &str, task: &str, seconds: f64, value: f64, derivatives: &[f64], note: &str) {
    println!(
        "{}",
        json!({"peer": peer, "task": task, "seconds": seconds, "value": value, "grad": derivatives, "note": note})
    );
}
