//! The iterations of the search for the best drive, each with its quadratic model.

use crate::message;
use crate::refusal::Refusal;
use crate::request::{RangeRequest, SetupRequest};
use longdrive::optimize::{Iteration, Observer, QuadraticModel};
use longdrive::parameters::Vary;
use longdrive::study::{Optimum, Search, optimum};
use longdrive::units::System;
use longdrive::{Error, Outcome, Setup};
use serde::{Deserialize, Serialize};
use std::cell::RefCell;
use std::rc::Rc;

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

/// The iterations of one search, in order.
type Iterations = Vec<Iteration>;

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
    let found = searches(&checked.setup, &search).map_err(|error| checked.refused(&error))?;
    let mut numbers = vec![];
    for (number, iterations) in found.iterations.iter().enumerate() {
        for (at, iteration) in iterations.iter().enumerate() {
            numbers.push(number as f64);
            append(&search, iteration, iterations.get(at + 1), &mut numbers);
        }
    }
    let head = Head {
        status: "done",
        message: checked.text(&found.optimum.message()),
        of: &request.of,
        parameters: search.vary.iter().map(|vary| vary.parameter.name).collect(),
        iterations: found.iterations.iter().map(Vec::len).sum(),
    };
    Ok(message::with_numbers(&head, &numbers))
}

/// The searches that led to the best drive.
struct Searches {
    optimum: Optimum,
    iterations: Vec<Iterations>,
}

/// The search from the setup's values. If a sample of the ranges led to a better drive, also the
/// search from that point of the sample.
fn searches(setup: &Setup<f64>, search: &Search) -> Result<Searches, Error> {
    let (optimum, first) = observed(setup, search)?;
    let mut iterations = vec![first];
    if optimum.sample.is_some_and(|sample| sample.improved) {
        let mut moved = *setup;
        for (vary, value) in search.vary.iter().zip(&optimum.solution.initial_point) {
            moved.set_value(vary.parameter, Some(*value))?;
        }
        iterations.push(observed(&moved, search)?.1);
    }
    Ok(Searches {
        optimum,
        iterations,
    })
}

/// The optimum, with the iterations of the search from the setup's own values.
fn observed(setup: &Setup<f64>, search: &Search) -> Result<(Optimum, Iterations), Error> {
    let kept = Rc::new(RefCell::new(vec![]));
    let iterations = Rc::clone(&kept);
    let observer = Observer {
        models: true,
        ..Observer::showing(move |iteration| iterations.borrow_mut().push(iteration.clone()))
    };
    let optimum = optimum(setup, search.clone(), observer)?;
    Ok((optimum, kept.take()))
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
