//! Searches that are stopped, saved and resumed.

use crate::command_line::{Output, wait_until};
use crate::program;
use longdrive::number::Number;
use longdrive::optimize::{
    Checkpoint, Domain, Evaluation, Exact, Functions, Observer, Observers, Options, Problem,
    SavedSearch, Snapshot, Solution, Status,
};
use longdrive::optimize::{least_squares, minimize_from, minimize_observed, starts};
use longdrive::{Error, Setup};
use std::cell::{Cell, RefCell};
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Rosenbrock's valley within a disc: curved, constrained, about twenty iterations.
struct Valley;

impl Functions for Valley {
    fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String> {
        let objective = (x[1] - x[0] * x[0]).powi(2) * 100.0 + (-x[0] + 1.0).powi(2);
        Ok(Evaluation {
            objective,
            constraints: vec![x[0] * x[0] + x[1] * x[1]],
        })
    }
}

fn disc() -> Domain {
    Domain::new(vec![-5.0; 2], vec![5.0; 2])
        .unwrap()
        .with_constraints(vec![f64::NEG_INFINITY], vec![1.5])
        .unwrap()
}

const START: [f64; 2] = [-1.2, 1.0];

fn whole() -> Solution {
    let whole = minimize_observed(
        &Exact(Valley),
        &disc(),
        &START,
        &Options::default(),
        Observer::default(),
    )
    .unwrap();
    assert_eq!(whole.status, Status::Converged);
    whole
}

/// A search that saves its snapshots, and stops after `most` iterations.
fn stopped_after(most: u64) -> (Solution, Option<Snapshot>) {
    let last_snapshot = Rc::new(RefCell::new(None));
    let (keeper, flag) = (
        Rc::clone(&last_snapshot),
        Arc::new(AtomicBool::new(most == 0)),
    );
    let stop = flag.clone();
    let observer = Observer {
        interrupt: flag,
        iteration: Box::new(move |iteration| {
            stop.store(iteration.number >= most, Ordering::Relaxed)
        }),
        save: Some(Box::new(move |snapshot| {
            // the snapshot is written as text and read again, as from a file
            let text = serde_json::to_string(snapshot).unwrap();
            *keeper.borrow_mut() = Some(serde_json::from_str(&text).unwrap());
            Ok(())
        })),
        resume: None,
        models: false,
    };
    let solution = minimize_observed(
        &Exact(Valley),
        &disc(),
        &START,
        &Options::default(),
        observer,
    )
    .unwrap();
    let snapshot = last_snapshot.borrow_mut().take();
    (solution, snapshot)
}

#[test]
fn same_end_of_a_search_stopped_and_resumed_anywhere() {
    let whole = whole();
    assert!(whole.iterations >= 10, "{}", whole.iterations);
    for most in 1..whole.iterations {
        let (stopped, snapshot) = stopped_after(most);
        assert_eq!(
            (stopped.status, stopped.iterations),
            (Status::Interrupted, most)
        );
        assert!(stopped.value.is_some() && stopped.message.contains("stopped after"));
        let observer = Observer {
            resume: snapshot,
            ..Observer::default()
        };
        let resumed = minimize_observed(
            &Exact(Valley),
            &disc(),
            &START,
            &Options::default(),
            observer,
        )
        .unwrap();
        assert_eq!(resumed, whole, "resumed after {most} iterations");
    }
}

/// An evaluation in ten blocks, as over many drives. Each block first reads the cancellation flag.
/// One block sets the flag.
struct InBlocks {
    flag: Arc<AtomicBool>,
    /// The block that sets the flag, counted from 1.
    raised_in: usize,
    blocks: Cell<usize>,
    finished: RefCell<Vec<Vec<f64>>>,
}

impl Problem for InBlocks {
    fn evaluate(&self, x: &[f64]) -> Result<Evaluation, String> {
        for _ in 0..10 {
            if self.flag.load(Ordering::Relaxed) {
                return Err("stopped".into());
            }
            self.blocks.set(self.blocks.get() + 1);
            if self.blocks.get() == self.raised_in {
                self.flag.store(true, Ordering::Relaxed);
            }
        }
        self.finished.borrow_mut().push(x.to_vec());
        Exact(Valley).evaluate(x)
    }
}

#[test]
fn no_block_starts_after_cancellation_and_the_search_ends_with_a_complete_point() {
    let whole = whole();
    let evaluations = usize::try_from(whole.effort.evaluations).unwrap();
    for raised_in in (1..10 * evaluations).step_by(3) {
        let flag = Arc::new(AtomicBool::new(false));
        let problem = InBlocks {
            flag: flag.clone(),
            raised_in,
            blocks: Cell::default(),
            finished: RefCell::default(),
        };
        let last_snapshot: Rc<RefCell<Option<Snapshot>>> = Rc::default();
        let (keeper, shown) = (Rc::clone(&last_snapshot), Rc::new(Cell::new(0)));
        let counted = Rc::clone(&shown);
        let observer = Observer {
            interrupt: flag,
            iteration: Box::new(move |iteration| counted.set(iteration.number)),
            save: Some(Box::new(move |snapshot| {
                *keeper.borrow_mut() = Some(snapshot.clone());
                Ok(())
            })),
            resume: None,
            models: false,
        };
        let stopped =
            minimize_observed(&problem, &disc(), &START, &Options::default(), observer).unwrap();
        assert_eq!(problem.blocks.get(), raised_in, "blocks after the flag");
        assert_eq!(
            (stopped.status, stopped.iterations),
            (Status::Interrupted, shown.get()),
            "raised in {raised_in}"
        );
        assert_eq!(
            stopped.value.is_some(),
            raised_in >= 10,
            "{}",
            stopped.message
        );
        if stopped.value.is_some() {
            assert!(
                problem.finished.borrow().contains(&stopped.x),
                "raised in {raised_in}"
            );
        } else {
            assert_eq!(
                (&stopped.x[..], &stopped.message[..]),
                (
                    &START[..],
                    "stopped before the functions were evaluated once"
                )
            );
        }
        let resume = last_snapshot.borrow_mut().take();
        assert_eq!(
            resume.as_ref().map_or(0, |snapshot| snapshot.iterations),
            stopped.iterations
        );
        let observer = Observer {
            resume,
            ..Observer::default()
        };
        let resumed = minimize_observed(
            &Exact(Valley),
            &disc(),
            &START,
            &Options::default(),
            observer,
        )
        .unwrap();
        assert_eq!(resumed, whole, "resumed after a stop in block {raised_in}");
    }
}

#[test]
fn no_block_of_a_fit_starts_after_cancellation() {
    // Misra's curve b₁ (1 − e^(−b₂ x)), fitted to three of its points in a few evaluations
    let rows = |b: &[f64]| {
        let at = |x: &f64| {
            (
                b[0] * (1.0 - (-b[1] * x).exp()),
                vec![1.0 - (-b[1] * x).exp(), b[0] * x * (-b[1] * x).exp()],
            )
        };
        let (values, jacobian): (Vec<f64>, _) = [77.6, 332.8, 760.0].iter().map(at).unzip();
        least_squares::Rows {
            residuals: values
                .iter()
                .zip([10.07, 40.02, 81.78])
                .map(|(v, y)| v - y)
                .collect(),
            jacobian,
        }
    };
    let domain = Domain::new(vec![0.0; 2], vec![1000.0, 1.0]).unwrap();
    let start = [250.0, 5e-4];
    let options = least_squares::FitOptions::default();
    let whole = least_squares::fit(&|b: &[f64]| Ok(rows(b)), &domain, &start, &options).unwrap();
    assert_eq!(whole.status, least_squares::FitStatus::Converged);
    for raised_in in 1..5 * usize::try_from(whole.evaluations).unwrap() {
        let observer = least_squares::FitObserver::default();
        let blocks = Cell::new(0);
        let in_blocks = |b: &[f64]| {
            for _ in 0..5 {
                if observer.is_interrupted() {
                    return Err("stopped".to_owned());
                }
                blocks.set(blocks.get() + 1);
                if blocks.get() == raised_in {
                    observer.interrupt.store(true, Ordering::Relaxed);
                }
            }
            Ok(rows(b))
        };
        let stopped =
            least_squares::fit_observed(&in_blocks, &domain, &start, &options, &observer).unwrap();
        assert_eq!(blocks.get(), raised_in, "blocks after the flag");
        assert_eq!(
            stopped.status,
            least_squares::FitStatus::Interrupted,
            "{}",
            stopped.message
        );
        assert_eq!(stopped.rows.residuals.is_empty(), raised_in < 5);
        assert!(stopped.rejected.count == 0 && (raised_in < 5 || stopped.rows == rows(&stopped.x)));
    }
}

#[test]
fn same_optima_when_some_searches_are_resumed() {
    let (domain, options) = (disc(), Options::default());
    let starts = starts(&domain, &START, 6).unwrap();
    let fresh = minimize_from(
        &Exact(Valley),
        &domain,
        &starts,
        &options,
        &Observers::default(),
    )
    .unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("last_snapshot.json");
    let observers = || Observers {
        checkpoint: Some(Arc::new(Checkpoint::open(&path, "valley").unwrap())),
        ..Observers::default()
    };
    minimize_from(
        &Exact(Valley),
        &domain,
        &starts[..3],
        &options,
        &observers(),
    )
    .unwrap();
    let checkpoint = Checkpoint::open(&path, "valley").unwrap();
    let saved = (0..starts.len()).filter_map(|number| checkpoint.saved(number));
    let ended = saved.filter(|run| matches!(run, SavedSearch::Done(_)));
    assert_eq!(ended.count(), 3);
    let Some(SavedSearch::Done(first)) = checkpoint.saved(0) else {
        panic!("the first search has ended")
    };
    assert_eq!(*first, whole());
    let resumed = minimize_from(&Exact(Valley), &domain, &starts, &options, &observers()).unwrap();
    assert_eq!(resumed.len(), fresh.len());
    for (resumed, fresh) in resumed.iter().zip(&fresh) {
        assert_eq!(
            (&resumed.solution, &resumed.starts),
            (&fresh.solution, &fresh.starts)
        );
    }
    let other = Checkpoint::open(&path, "another search").unwrap_err();
    assert!(
        matches!(&other, Error::Checkpoint { reason, .. } if reason.contains("options differ")),
        "{other}"
    );
    std::fs::write(&path, "{").unwrap();
    assert!(
        Checkpoint::open(&path, "valley")
            .unwrap_err()
            .to_string()
            .contains("is not a checkpoint")
    );
    assert!(Checkpoint::open(folder.path(), "valley").is_err());
}

#[test]
fn same_answer_of_the_program_after_repeated_kills() {
    let folder = tempfile::tempdir().unwrap();
    // steps so short that a search takes seconds
    let arguments = |checkpoint: &str| {
        let mut all = vec![
            "optimize",
            "--json",
            "--starts",
            "3",
            "--set",
            "flight.step=0.3ms",
            "--checkpoint",
        ];
        all.extend([checkpoint, "--subject-to", "apex_height <= 36 yd"]);
        all.into_iter().map(str::to_owned).collect::<Vec<_>>()
    };
    let run = |checkpoint: &std::path::Path| {
        let output = program::command()
            .args(arguments(&checkpoint.display().to_string()))
            .output()
            .unwrap();
        assert!(
            output.status.success(),
            "{}",
            String::from_utf8_lossy(&output.stderr)
        );
        output.stdout
    };
    let alone = run(&folder.path().join("alone.json"));
    let killed = folder.path().join("killed.json");
    // the first process is killed when its file exists; each later process is killed after one more
    // saved iteration
    for _ in 0..4 {
        let before = std::fs::read(&killed).ok();
        let mut child = program::command()
            .args(arguments(&killed.display().to_string()))
            .stdout(std::process::Stdio::null())
            .stderr(std::process::Stdio::null())
            .spawn()
            .unwrap();
        wait_until(&mut child, || std::fs::read(&killed).ok() != before);
        let _ = child.kill();
        child.wait().unwrap();
    }
    assert!(killed.exists(), "nothing was saved before the first kill");
    assert_eq!(run(&killed), alone);
}

/// Nearly all of ten thousand searches have not begun when they are stopped. The answer merges them
/// into one entry; as single entries they would all be compared with each other.
#[test]
fn searches_that_did_not_start_are_one_entry_with_all_their_starts() {
    let (domain, options) = (disc(), Options::default());
    let starts = starts(&domain, &START, 10_000).unwrap();
    let observers = Observers::default();
    observers.interrupt.store(true, Ordering::Relaxed);
    let none = minimize_from(&Exact(Valley), &domain, &starts, &options, &observers).unwrap();
    assert_eq!(
        (none.len(), none[0].starts.len(), none[0].solution.value),
        (1, 10_000, None)
    );
    let (flag, ended) = (Arc::new(AtomicBool::new(false)), AtomicUsize::new(0));
    let stop = flag.clone();
    let end = move |_: usize, _: &Solution| {
        stop.store(
            ended.fetch_add(1, Ordering::Relaxed) >= 20,
            Ordering::Relaxed,
        )
    };
    let observers = Observers {
        interrupt: flag,
        end: Some(Arc::new(end)),
        ..Observers::default()
    };
    let some = minimize_from(&Exact(Valley), &domain, &starts, &options, &observers).unwrap();
    assert_eq!(
        some.iter().map(|local| local.starts.len()).sum::<usize>(),
        10_000
    );
    assert_eq!(
        (
            some[0].solution.status,
            some.iter()
                .filter(|local| local.solution.value.is_none())
                .count()
        ),
        (Status::Converged, 1)
    );
}

#[test]
fn an_unwritable_checkpoint_is_an_error_before_the_search() {
    let path = std::path::Path::new("/nowhere/at/all.json");
    let error = Checkpoint::open(path, "anything").unwrap_err();
    assert!(
        matches!(&error, Error::Checkpoint { reason, .. } if reason.contains("cannot be written")),
        "{error}"
    );
    // a failing save ends the search with its own error
    let setup = Setup::modern_driver();
    let search = longdrive::study::Search::longest_drive(&setup).unwrap();
    let observer = Observer {
        save: Some(Box::new(|_| {
            Err(Error::Optimizer("the disk is full".into()))
        })),
        ..Observer::default()
    };
    let error = longdrive::study::optimum(&setup, search, observer).unwrap_err();
    assert!(error.to_string().contains("the disk is full"), "{error}");
}

/// Before a search, the program looks for a start that flies. Ctrl-C stops this too, and the
/// message says so. It takes long here, because the balls never land.
#[cfg(unix)]
#[test]
fn a_chart_is_interrupted_in_its_first_search() {
    for command in [
        &["chart", "--along", "swing.speed=80mph..130mph"][..],
        &["optimize"],
    ] {
        // a flight of ten minutes in steps of 1 ms takes a third of a second, and the program would
        // try 63 more starts
        let requested = [
            "modern-driver",
            "--set",
            "gravity=1e-6m/s^2",
            "--set",
            "flight.step=1ms",
            "--own-step",
            "--json",
            "--verbose",
        ];
        let Output { status, out, err } =
            crate::interrupts::interrupted(&[command, &requested].concat());
        assert_eq!(status, 1, "{out} {err}");
        assert!(out.contains("\"interrupted\""), "{out} {err}");
        assert!(
            out.contains("stopped before a drive that flies was found"),
            "{out} {err}"
        );
        assert!(
            command[0] != "chart" || err.contains("searching for an optimum at swing.speed 80 mph"),
            "{err}"
        );
    }
}
