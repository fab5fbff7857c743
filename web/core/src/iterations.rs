//! The iterations of the search for the best drive, each with its quadratic model.

use crate::message;
use crate::refusal::Refusal;
use crate::request::{RangeRequest, SetupRequest};
use longdrive::optimize::{Iteration, Observers, QuadraticModel};
use longdrive::parameters::Vary;
use longdrive::study::{Optimum, Search, optima};
use longdrive::units::System;
use longdrive::{Error, Outcome, Setup};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::sync::mpsc::{self, Sender};

/// The head of a request: the setup, the outcome to maximize, and the ranges of parameters.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    #[serde(default)]
    setup: SetupRequest,
    #[serde(default)]
    units: System,
    of: String,
    vary: Vec<RangeRequest>,
}

#[derive(Serialize)]
struct Head<'a> {
    status: &'static str,
    message: String,
    of: &'a str,
    parameters: Vec<&'static str>,
    iterations: usize,
}

/// An iteration, and the number of its search: 0 from the setup's values, 1 from a point of the
/// sample.
struct Observed {
    search: usize,
    iteration: Iteration,
}

/// Answers with the optimum, and with the iterations of the searches in the block.
///
/// # Errors
/// The message of the program, if there is nothing to search for.
pub fn answer(request: &Request) -> Result<Vec<u8>, Refusal> {
    let checked = request.setup.read(request.units)?;
    let of = checked.outcomes(std::slice::from_ref(&request.of))?;
    let vary = request.vary.iter().map(|range| checked.range(range));
    let search = Search {
        vary: vary.collect::<Result<_, _>>()?,
        ..Search::largest(of.first().copied().unwrap_or(Outcome::Carry))
    };
    let (sender, receiver) = mpsc::channel();
    let best = best(&checked.setup, &search, sender).map_err(|error| checked.refused(&error))?;
    let observed: Vec<Observed> = receiver.try_iter().collect();
    let mut shown = 0;
    let mut numbers = vec![];
    for iterations in observed.chunk_by(|_, next| next.iteration.number > 0) {
        if !is_shown(iterations, &best) {
            continue;
        }
        shown += iterations.len();
        for (at, observed) in iterations.iter().enumerate() {
            numbers.push(observed.search as f64);
            let next = iterations.get(at + 1).map(|next| &next.iteration);
            append(&search, &observed.iteration, next, &mut numbers);
        }
    }
    let head = Head {
        status: "done",
        message: checked.text(&best.message()),
        of: &request.of,
        parameters: search.vary.iter().map(|vary| vary.parameter.name).collect(),
        iterations: shown,
    };
    Ok(message::with_numbers(&head, &numbers))
}

/// Finds the best drive. Its iterations go to `sender`, search by search.
fn best(setup: &Setup<f64>, search: &Search, sender: Sender<Observed>) -> Result<Optimum, Error> {
    let send = move |search: usize, iteration: &Iteration| {
        let iteration = iteration.clone();
        sender.send(Observed { search, iteration }).ok();
    };
    let observers = Observers {
        iteration: Some(Arc::new(send)),
        models: true,
        ..Observers::default()
    };
    Ok(optima(setup, search, 1, &observers)?.best)
}

/// True for the search from the setup's values. If a search from a point of the sample led to a
/// better drive, also true for that search.
fn is_shown(iterations: &[Observed], best: &Optimum) -> bool {
    let is_improved = best.sample.is_some_and(|sample| sample.improved);
    iterations.first().is_some_and(|first| {
        first.search == 0 || is_improved && first.iteration.x == best.solution.initial_point
    })
}

/// Appends the numbers of an iteration after the number of its search, in the order of the README.
/// `next` states whether the step was accepted, and its predicted and actual reductions; it is
/// `None` for the last iteration of a search.
fn append(
    search: &Search,
    iteration: &Iteration,
    next: Option<&Iteration>,
    numbers: &mut Vec<f64>,
) {
    let sign = search.sense.sign();
    let of_step = |of: fn(&Iteration) -> f64| next.map_or(f64::NAN, of);
    let none = QuadraticModel::default();
    let model = iteration.model.as_ref().unwrap_or(&none);
    numbers.extend([
        iteration.number as f64,
        sign * iteration.value,
        iteration.kkt_residual,
        of_step(|next| f64::from(u8::from(next.accepted))),
        of_step(|next| next.predicted_reduction),
        of_step(|next| next.actual_reduction),
        f64::from(u8::from(model.is_reflected)),
    ]);
    let x = &iteration.x;
    numbers.extend(x);
    numbers.extend(search.vary.iter().zip(x).map(|(vary, x)| side(vary, *x)));
    numbers.extend(model.gradient.iter().map(|slope| sign * slope));
    let second = model.hessian.iter().flatten();
    numbers.extend(second.map(|second| sign * second));
    numbers.extend(&model.low);
    numbers.extend(&model.high);
    numbers.extend(&model.trial);
}

/// −1 if a value is at the lower end of its range, 1 at the upper end, else 0.
fn side(vary: &Vary, x: f64) -> f64 {
    f64::from(i8::from(x >= vary.high) - i8::from(x <= vary.low))
}
