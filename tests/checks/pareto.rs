//! Fronts between two functions or goals, compared with known fronts.

use crate::common::close;
use longdrive::number::Number;
use longdrive::optimize::front::{Front, FrontError, FrontEvent, front};
use longdrive::optimize::{
    Domain, Evaluation, Exact, Functions, Observers, Options, Problem, Status,
};
use std::cell::Cell;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// |x|² and |x − q|² with q = (2, 1).
struct Distances;

impl Functions for Distances {
    fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String> {
        let first = x[0].powi(2) + x[1].powi(2);
        Ok(Evaluation {
            objective: first,
            constraints: vec![(x[0] - 2.0).powi(2) + (x[1] - 1.0).powi(2)],
        })
    }
}

/// f₁ = x² + (y − 3)² and f₂ = (x − 1)².
struct IndependentOfY;

impl Functions for IndependentOfY {
    fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String> {
        Ok(Evaluation {
            objective: x[0].powi(2) + (x[1] - 3.0).powi(2),
            constraints: vec![(x[0] - 1.0).powi(2)],
        })
    }
}

/// 1 − exp(−|x − p|²) and 1 − exp(−|x + p|²), p = (1, 1)/√2, a concave front (Fonseca & Fleming
/// 1995).
struct Concave;

impl Functions for Concave {
    fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String> {
        let at = |p: f64| -(-((x[0] - p).powi(2) + (x[1] - p).powi(2))).exp() + 1.0;
        Ok(Evaluation {
            objective: at(0.5_f64.sqrt()),
            constraints: vec![at(-0.5_f64.sqrt())],
        })
    }
}

/// f₁ = x + y and f₂ = −x: the front is straight, and its ends are vertices.
struct Straight;

impl Functions for Straight {
    fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String> {
        Ok(Evaluation {
            objective: x[0] + x[1],
            constraints: vec![-x[0]],
        })
    }
}

/// x² + 2 y², and −x − y.
struct Corner;

impl Functions for Corner {
    fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String> {
        Ok(Evaluation {
            objective: x[0].powi(2) + x[1].powi(2) * 2.0,
            constraints: vec![-x[0] - x[1]],
        })
    }
}

/// f₁ = x + y and f₂ = −(x³/3 − 3x²/2 + 2x) + y, with a local minimum of f₂ at x = 1 and y = 0.
struct TurnsBack;

impl Functions for TurnsBack {
    fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String> {
        let cubic = x[0].powi(3) / 3.0 - x[0].powi(2) * 1.5 + x[0] * 2.0;
        Ok(Evaluation {
            objective: x[0] + x[1],
            constraints: vec![-cubic + x[1]],
        })
    }
}

fn between(functions: impl Functions, low: [f64; 2], high: [f64; 2], count: usize) -> Front {
    between_from(vec![vec![0.3, 0.9]], functions, low, high, count)
}

/// The searches for the ends begin at `starts`.
fn between_from(
    starts: Vec<Vec<f64>>,
    functions: impl Functions,
    low: [f64; 2],
    high: [f64; 2],
    count: usize,
) -> Front {
    let free = (vec![f64::NEG_INFINITY], vec![f64::INFINITY]);
    let domain = Domain::new(low.to_vec(), high.to_vec())
        .unwrap()
        .with_constraints(free.0, free.1)
        .unwrap();
    let options = Options::default();
    front(
        &Exact(functions),
        &domain,
        |_| Ok(starts.clone()),
        &options,
        count,
        &Observers::default(),
    )
    .unwrap()
}

/// For x in [0, 3] and y ≥ 0, f₂ falls from x = 0 to 1 and from x = 2 to 3, and f₂(2.5) = f₂(1).
/// So the front is y = 0 with x in [0, 1] or [2.5, 3], and its slope is 1/f₂′ = −1/((x − 1)(x − 2)).
/// Between x = 1 and 2 both functions rise along the path from one end to the other.
#[test]
fn exact_front_whose_path_turns_back() {
    for count in 5..24 {
        let starts = vec![vec![0.3, 0.9], vec![2.9, 0.9]];
        let found = between_from(starts, TurnsBack, [0.0; 2], [3.0, 1.0], count);
        assert_eq!(found.ended, None, "{count}");
        let inner = found.points.len() - 1;
        for point in &found.points[1..inner] {
            let x = point.x[0];
            let is_turned_back = (1.0 + 1e-6..=2.0).contains(&x);
            assert!(!is_turned_back, "{count}: x = {x}, slope {:?}", point.slope);
            let slope = -((x - 1.0) * (x - 2.0)).recip();
            if let Some(found) = point.slope.filter(|_| slope.abs() < 1e3) {
                close(found, slope, slope.abs(), 1e-6, "slope");
            }
        }
    }
}

/// The front is √f₁ + √f₂ = |q − p|, with the slope −√(f₁/f₂). Its knee is in the middle, and its
/// points are evenly spaced.
#[test]
fn exact_front_of_two_distances() {
    let found = between(Distances, [-5.0; 2], [5.0; 2], 12);
    let length = 5.0_f64;
    assert_eq!(
        (found.points.len(), found.dominated, &found.ended),
        (13, 0, &None)
    );
    for point in &found.points {
        let [first, second] = point.values;
        close(
            first.max(0.0).sqrt() + second.max(0.0).sqrt(),
            length.sqrt(),
            1.0,
            1e-6,
            "on the front",
        );
        close(point.x[0], 2.0 * point.x[1], 1.0, 1e-7, "between the two");
    }
    let ends = [&found.points[0], &found.points[12]];
    close(
        ends[0].values[1],
        length,
        length,
        1e-12,
        "the first's own minimum",
    );
    close(
        ends[1].values[0],
        length,
        length,
        1e-12,
        "the second's own minimum",
    );
    let inner = &found.points[1..12];
    for point in inner {
        let slope = -(point.values[0] / point.values[1]).sqrt();
        close(point.slope.unwrap(), slope, 1.0, 1e-7, "slope");
        // on the front x = t q and f₁ − f₂ = 5 (2 t − 1), so the scaled difference s is 2 t − 1
        close(point.rates[0], 1.0, 1.0, 1e-7, "dx/ds");
    }
    close(
        ends[0].slope.unwrap(),
        0.0,
        1.0,
        1e-6,
        "slope at the first end",
    );
    let knee = &found.points[found.knee.unwrap()];
    close(knee.values[0], length / 4.0, 1.0, 1e-8, "knee");
    close(knee.slope.unwrap(), -1.0, 1.0, 1e-8, "slope at the knee");
    close(found.relative_bulge, 0.25, 1.0, 1e-9, "bend");
    let spread: Vec<_> = found
        .points
        .iter()
        .enumerate()
        .filter(|(k, _)| Some(*k) != found.knee)
        .collect();
    let steps: Vec<f64> = spread
        .windows(2)
        .map(|pair| {
            let [a, b] = [pair[0].1.values, pair[1].1.values];
            (a[0] - b[0]).hypot(a[1] - b[1])
        })
        .collect();
    let mean = steps.iter().sum::<f64>() / steps.len() as f64;
    assert!(
        steps.iter().all(|step| (step / mean - 1.0).abs() < 0.03),
        "{steps:?}"
    );
}

/// After an interrupt in any evaluation, no further evaluation begins. The result is an error
/// before the first end of the front is found. Later it contains the points found so far.
#[test]
fn same_points_of_a_front_stopped_within_any_evaluation() {
    let free = (vec![f64::NEG_INFINITY], vec![f64::INFINITY]);
    let domain = Domain::new(vec![-5.0; 2], vec![5.0; 2])
        .unwrap()
        .with_constraints(free.0, free.1)
        .unwrap();
    let options = Options::default();
    let stopped_in = |evaluation: usize| {
        let (flag, begun) = (Arc::new(AtomicBool::new(false)), Cell::new(0));
        let problem = |x: &[f64]| {
            if flag.load(Ordering::Relaxed) {
                return Err("stopped".to_owned());
            }
            begun.set(begun.get() + 1);
            flag.store(begun.get() == evaluation, Ordering::Relaxed);
            Exact(Distances).evaluate(x)
        };
        let observers = Observers {
            interrupt: flag.clone(),
            ..Observers::default()
        };
        (
            front(
                &problem,
                &domain,
                |_| Ok(vec![vec![0.3, 0.9]]),
                &options,
                6,
                &observers,
            ),
            begun.get(),
        )
    };
    let (whole, evaluations) = stopped_in(usize::MAX);
    let whole = whole.unwrap();
    let mut most = 0;
    for evaluation in 1..evaluations {
        let (found, begun) = stopped_in(evaluation);
        assert_eq!(begun, evaluation, "evaluations after the flag");
        match found {
            Err(FrontError::NoEnd { function, found }) => {
                assert_eq!(
                    (function, found.status, most),
                    (0, Status::Interrupted, 0),
                    "in evaluation {evaluation}"
                );
            }
            Err(FrontError::Refused(error)) => {
                assert_eq!((error.status(), most), ("interrupted", 0), "{error}")
            }
            Ok(found) => {
                assert!(found.interrupted && found.ended.is_some() && !found.points.is_empty());
                assert_eq!(
                    found.points[0].values, whole.points[0].values,
                    "the first end"
                );
                for point in &found.points {
                    let [first, second] = point.values;
                    close(
                        first.max(0.0).sqrt() + second.max(0.0).sqrt(),
                        5.0_f64.sqrt(),
                        1.0,
                        1e-6,
                        "on the front",
                    );
                }
                most = most.max(found.points.len());
            }
        }
    }
    assert!(most > 3, "{most} of {}", whole.points.len());
}

/// With x ≤ 1 the front leaves the line between the two minima at (1, ½) and follows the bound
/// upwards.
#[test]
fn exact_event_where_a_bound_becomes_active_on_a_front() {
    let found = between(Distances, [-5.0; 2], [1.0, 5.0], 9);
    let events: Vec<_> = found
        .points
        .iter()
        .filter(|point| point.event.is_some())
        .collect();
    assert_eq!(events.len(), 1, "{events:?}");
    let event = events[0];
    close(event.x[0], 1.0, 1.0, 1e-12, "at the bound");
    close(event.x[1], 0.5, 1.0, 1e-7, "where the line meets it");
    assert!(matches!(&event.event, Some(FrontEvent::Changed { before }) if !before.variables[0]));
    assert!(event.active_set.variables[0] && !event.active_set.variables[1]);
    close(found.points.last().unwrap().x[1], 1.0, 1.0, 1e-9, "end");
}

/// The front ends at the corner (1, 1). Near the corner x = 1, f₁ = 1 + 2 y² and f₂ = −1 − y. At
/// the corner the bound of y becomes active, so the slope −4 y is one-sided there.
#[test]
fn exact_slope_at_an_end_where_a_bound_begins() {
    let found = between(Corner, [-5.0; 2], [1.0; 2], 5);
    let end = found.points.last().unwrap();
    close(end.x[1], 1.0, 1.0, 1e-9, "corner");
    close(end.slope.unwrap(), -4.0, 1.0, 1e-6, "slope");
    assert_eq!(end.event, None);
}

#[test]
fn end_of_a_front_among_equal_minima() {
    let found = between(IndependentOfY, [-5.0; 2], [5.0; 2], 5);
    for point in &found.points {
        close(point.x[1], 3.0, 1.0, 1e-5, "y");
    }
    close(
        found.points.last().unwrap().values[0],
        1.0,
        1.0,
        1e-3,
        "end",
    );
}

#[test]
fn concave_and_straight_fronts_have_no_knee() {
    let concave = between(Concave, [-2.0; 2], [2.0; 2], 11);
    assert_eq!((concave.points.len(), concave.knee), (11, None));
    // `relative_bulge` measures convexity: this front is convex only close to its ends
    assert!(concave.relative_bulge < 1e-3, "{}", concave.relative_bulge);
    for point in &concave.points {
        close(point.x[0], point.x[1], 1.0, 1e-7, "on the diagonal");
    }
    let straight = between(Straight, [0.0; 2], [1.0; 2], 5);
    assert_eq!(
        (straight.points.len(), straight.knee),
        (5, None),
        "{straight:#?}"
    );
    for (k, point) in straight.points.iter().enumerate() {
        close(point.values[0], k as f64 / 4.0, 1.0, 1e-9, "even");
        close(point.x[1], 0.0, 1.0, 1e-12, "y costs");
        assert!(
            point.slope.is_none_or(|slope| (slope + 1.0).abs() < 1e-9),
            "{point:?}"
        );
    }
}

#[test]
fn no_front_if_one_point_is_best_for_both_goals() {
    struct Both;
    impl Functions for Both {
        fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String> {
            let first = (x[0] - 1.0).powi(2) + x[1].powi(2);
            Ok(Evaluation {
                objective: first,
                constraints: vec![first * 2.0 + 1.0],
            })
        }
    }
    let found = between(Both, [-5.0; 2], [5.0; 2], 9);
    assert_eq!((found.points.len(), found.knee), (1, None));
    close(found.points[0].x[0], 1.0, 1.0, 1e-9, "x");
}
