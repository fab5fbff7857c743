//! Wrong use of the optimizer: an error, and no panic.

use longdrive::number::Number;
use longdrive::optimize::least_squares::{self, Rows, fit};
use longdrive::optimize::sensitivity::response;
use longdrive::optimize::{
    Checkpoint, Domain, Evaluation, Exact, Functions, Observer, Observers, Options, Problem,
    SavedSearch, Snapshot, Status, minimize, minimize_from, minimize_observed, starts,
};
use serde_json::Value;
use std::sync::atomic::Ordering;
use std::sync::{Arc, Mutex};

/// Rosenbrock's function of any number of variables, within a disc about 0.
struct Valley;

impl Functions for Valley {
    fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String> {
        let steps = x
            .windows(2)
            .map(|pair| (pair[1] - pair[0].powi(2)).powi(2) * 100.0 + (-pair[0] + 1.0).powi(2));
        let square = x.iter().fold(T::zero(), |sum, x| sum + x.powi(2));
        Ok(Evaluation {
            objective: steps.fold(T::zero(), |sum, step| sum + step),
            constraints: vec![square],
        })
    }
}

fn disc(n: usize) -> Domain {
    Domain::new(vec![-2.0; n], vec![2.0; n])
        .unwrap()
        .with_constraints(vec![0.0], vec![1.5])
        .unwrap()
}

/// The search after five iterations.
fn snapshot() -> Snapshot {
    let last_snapshot = Arc::new(Mutex::new(None));
    let (keeper, interrupt) = (last_snapshot.clone(), Observer::default().interrupt);
    let stop = interrupt.clone();
    let keep = move |snapshot: &Snapshot| {
        *keeper.lock().unwrap() = Some(snapshot.clone());
        stop.store(snapshot.iterations >= 5, Ordering::Relaxed);
        Ok(())
    };
    let observer = Observer {
        save: Some(Box::new(keep)),
        interrupt,
        ..Observer::default()
    };
    let found = minimize_observed(
        &Exact(Valley),
        &disc(2),
        &[-1.2, 1.0],
        &Options::default(),
        observer,
    )
    .unwrap();
    assert_eq!(found.status, Status::Interrupted);
    let snapshot = last_snapshot.lock().unwrap().take().unwrap();
    assert!(snapshot.iterations >= 5);
    snapshot
}

fn resumed(
    problem: &dyn Problem,
    domain: &Domain,
    snapshot: Snapshot,
) -> longdrive::Result<longdrive::optimize::Solution> {
    let start = vec![0.5; domain.variables.dimension()];
    minimize_observed(
        problem,
        domain,
        &start,
        &Options::default(),
        Observer {
            resume: Some(snapshot),
            ..Observer::default()
        },
    )
}

#[test]
fn a_saved_search_of_another_problem_is_refused() {
    let other = |domain: Domain, what: &str| {
        let error = resumed(&Exact(Valley), &domain, snapshot()).unwrap_err();
        assert!(
            error.to_string().contains("another problem"),
            "{what}: {error}"
        );
    };
    other(disc(3), "three variables");
    other(
        Domain::new(vec![-2.0; 2], vec![2.0; 2]).unwrap(),
        "no constraint",
    );
    let own = resumed(&Exact(Valley), &disc(2), snapshot()).unwrap();
    assert_eq!(
        own,
        minimize(&Exact(Valley), &disc(2), &[-1.2, 1.0], &Options::default()).unwrap()
    );
}

/// For each array of a saved search: removes an entry of this array alone.
#[test]
fn a_damaged_search_is_refused_and_nothing_panics() {
    fn arrays(value: &Value, path: &str, found: &mut Vec<String>) {
        let inner: Vec<(String, &Value)> = match value {
            Value::Object(map) => map
                .iter()
                .map(|(key, value)| (key.clone(), value))
                .collect(),
            Value::Array(all) => all
                .iter()
                .enumerate()
                .map(|(i, value)| (i.to_string(), value))
                .collect(),
            _ => return,
        };
        if value.as_array().is_some_and(|all| !all.is_empty()) {
            found.push(path.into());
        }
        inner
            .into_iter()
            .for_each(|(key, value)| arrays(value, &format!("{path}/{key}"), found));
    }
    let whole = serde_json::to_value(snapshot()).unwrap();
    let mut paths = vec![];
    arrays(&whole, "", &mut paths);
    let mut refused = 0;
    for path in &paths {
        let mut damaged = whole.clone();
        damaged
            .pointer_mut(path)
            .unwrap()
            .as_array_mut()
            .unwrap()
            .pop();
        let Ok(snapshot) = serde_json::from_value::<Snapshot>(damaged) else {
            continue;
        };
        let end = resumed(&Exact(Valley), &disc(2), snapshot);
        assert!(end.is_err(), "{path}: {end:?}");
        refused += 1;
    }
    assert!(refused > 10, "{refused} of {paths:?}");
}

#[test]
fn a_checkpoint_of_another_problem_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    for run in ["going", "done"] {
        let checkpoint = Checkpoint::open(&folder.path().join(run), "valley").unwrap();
        let done =
            || minimize(&Exact(Valley), &disc(2), &[-1.2, 1.0], &Options::default()).unwrap();
        let last_snapshot = if run == "going" {
            SavedSearch::Unfinished(Box::new(snapshot()))
        } else {
            SavedSearch::Done(Box::new(done()))
        };
        checkpoint.save(0, last_snapshot).unwrap();
        let observers = Observers {
            checkpoint: Some(Arc::new(checkpoint)),
            ..Observers::default()
        };
        let error = minimize_from(
            &Exact(Valley),
            &disc(3),
            &[vec![0.5; 3]],
            &Options::default(),
            &observers,
        )
        .unwrap_err();
        assert!(
            error.to_string().contains("another problem"),
            "{run}: {error}"
        );
    }
}

/// The fields of a domain are public: values that its constructors refuse are refused at its use.
#[test]
fn impossible_domains_and_starts_are_refused() {
    for (low, high) in [(f64::NAN, 1.0), (3.0, 1.0), (f64::INFINITY, f64::INFINITY)] {
        let mut domain = disc(2);
        (domain.variables.low[1], domain.variables.high[1]) = (low, high);
        let error =
            minimize(&Exact(Valley), &domain, &[0.0, 0.0], &Options::default()).unwrap_err();
        assert!(error.to_string().contains("the limits [1]"), "{error}");
        assert!(starts(&domain, &[0.0, 0.0], 4).is_err());
        let mut domain = disc(2);
        (domain.constraints.low[0], domain.constraints.high[0]) = (low, high);
        assert!(minimize(&Exact(Valley), &domain, &[0.0, 0.0], &Options::default()).is_err());
    }
    for start in [&[0.0][..], &[0.0, f64::NAN], &[0.0; 3]] {
        assert!(starts(&disc(2), start, 4).is_err(), "{start:?}");
    }
    assert!(
        minimize_from(
            &Exact(Valley),
            &disc(2),
            &[],
            &Options::default(),
            &Observers::default()
        )
        .is_err()
    );
}

#[test]
fn a_fit_refuses_constraints() {
    let residuals = |x: &[f64]| {
        Ok(Rows {
            residuals: vec![x[0] - 1.0, x[1] - 2.0],
            jacobian: vec![vec![1.0, 0.0], vec![0.0, 1.0]],
        })
    };
    let error = fit(
        &residuals,
        &disc(2),
        &[0.0, 0.0],
        &least_squares::FitOptions::default(),
    )
    .unwrap_err();
    assert!(error.to_string().contains("without constraints"), "{error}");
}

/// As a gradient of the wrong length, and unlike residuals that are undefined at the start.
#[test]
fn residuals_of_a_wrong_shape_are_an_error() {
    let domain = Domain::new(vec![-2.0; 2], vec![2.0; 2]).unwrap();
    for (residuals, jacobian, says) in [
        (vec![1.0, 2.0], vec![vec![1.0, 0.0]], "it must be 2 by 2"),
        (vec![1.0], vec![vec![1.0]], "it must be 1 by 2"),
        (vec![], vec![], "no residuals"),
    ] {
        let rows = Rows {
            residuals,
            jacobian,
        };
        let given = |_: &[f64]| Ok(rows.clone());
        let options = least_squares::FitOptions::default();
        let error = fit(&given, &domain, &[0.0, 0.0], &options).unwrap_err();
        assert!(error.to_string().contains(says), "{error}");
    }
}

#[test]
fn a_response_is_that_of_an_optimum_with_its_own_functions() {
    let problem = Exact(Valley);
    let found = minimize(&problem, &disc(2), &[-1.2, 1.0], &Options::default()).unwrap();
    let at = problem.evaluate(&found.x).unwrap();
    // the gradients of these functions end with the derivatives by the variables; `response` needs
    // a derivative by a parameter after them
    assert!(
        response(&found, &disc(2), &at)
            .unwrap_err()
            .to_string()
            .contains("and the parameter")
    );
    assert!(
        response(&found, &disc(3), &at)
            .unwrap_err()
            .to_string()
            .contains("domain")
    );
    let options = Options {
        max_iterations: 2,
        ..Options::default()
    };
    let early = minimize(&problem, &disc(2), &[-1.2, 1.0], &options).unwrap();
    assert!(matches!(
        response(&early, &disc(2), &at),
        Err(longdrive::Error::NotConverged { .. })
    ));
}
