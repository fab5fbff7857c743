//! Generated questions: correct and wrong command lines of all commands, with their files. For each,
//! the program ends with status 0, 1 or 2, does not panic, prints no NaN and no infinity, answers in
//! JSON according to its schemas, and touches no file that the command line does not name.
//!
//! `LONGDRIVE_QUESTIONS=100000` sets the number of questions, on all cores; `LONGDRIVE_SEED` the
//! seed. A failing question is printed with its number: `LONGDRIVE_QUESTION` runs that one alone.

mod choices;
mod files;
#[path = "../program.rs"]
mod program;
mod questions;
mod run;
#[path = "../schema/mod.rs"]
mod schema;
mod values;

use choices::Choices;
use questions::Question;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

/// Number of questions, if `LONGDRIVE_QUESTIONS` is not set.
const FEW: u64 = 300;
/// Number of failures that ends the run.
const MAX_FAILURES: usize = 20;

fn setting(name: &str) -> Option<u64> {
    std::env::var(name).ok().map(|text| {
        text.parse()
            .unwrap_or_else(|_| panic!("{name}={text} is no whole number"))
    })
}

#[test]
fn the_program_answers_every_generated_request_in_order() {
    let seed = setting("LONGDRIVE_SEED").unwrap_or(1);
    let numbers = match setting("LONGDRIVE_QUESTION") {
        Some(only) => only..only + 1,
        None => 0..setting("LONGDRIVE_QUESTIONS").unwrap_or(FEW),
    };
    let (next, failed) = (AtomicU64::new(numbers.start), Mutex::new(vec![]));
    // number of questions by command and exit status
    let ended: Mutex<BTreeMap<String, [u64; 4]>> = Mutex::default();
    let work = || {
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if number >= numbers.end || failed.lock().unwrap().len() >= MAX_FAILURES {
                return;
            }
            let question = Question::new(&mut Choices::new(seed, number));
            let (status, wrong) = run::ask(&question);
            let at = status
                .and_then(|status| usize::try_from(status).ok())
                .map_or(3, |status| status.min(3));
            ended
                .lock()
                .unwrap()
                .entry(question.command().to_owned())
                .or_default()[at] += 1;
            if !wrong.is_empty() {
                failed.lock().unwrap().push((number, question, wrong));
            }
        }
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(work);
        }
    });
    let failed = failed.into_inner().unwrap();
    let mut report = String::new();
    for (number, question, wrong) in &failed {
        let line = question
            .args
            .iter()
            .map(|arg| format!("{arg:?}"))
            .collect::<Vec<_>>()
            .join(" ");
        let _ = writeln!(
            report,
            "\nLONGDRIVE_SEED={seed} LONGDRIVE_QUESTION={number}: longdrive {line}"
        );
        for (name, bytes) in &question.files {
            let _ = writeln!(report, "  {name}: {:?}", String::from_utf8_lossy(bytes));
        }
        for wrong in wrong {
            let _ = writeln!(report, "  -> {wrong}");
        }
    }
    let ended = ended.into_inner().unwrap();
    for (command, counts) in &ended {
        println!("{command}: exit status 0, 1, 2 and others: {counts:?}");
    }
    assert!(
        failed.is_empty(),
        "{} of {} questions failed{report}",
        failed.len(),
        numbers.end - numbers.start
    );
    // a run with mostly refused questions would be useless
    for (command, [found, none, refused, _]) in ended {
        let (computed, all) = (found + none, found + none + refused);
        assert!(
            all < 25 || 4 * computed >= all,
            "{command}: only {computed} of {all} questions are not refused"
        );
    }
}
