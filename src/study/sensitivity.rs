use super::optimum::{Optimum, optimum};
use super::search::Search;
use super::sigma::{AmountKind, amount_of};
use super::verdict::{Active, only_in};
use crate::error::{Error, Result};
use crate::optimize::Observer;
use crate::optimize::sensitivity::{Event, first_event, response};
use crate::parameters::{Parameter, Setup};
use crate::units::Message;
use serde::Serialize;

/// Sensitivity of an optimum to a parameter that the search does not vary.
#[derive(Clone, Debug)]
pub struct Sensitivity {
    /// d f*/dp: derivative of the optimal value f* by the parameter p, SI.
    pub value: f64,
    /// d² f*/dp², SI.
    pub curvature: f64,
    /// d x*/dp: derivative of the optimal value of each varied parameter, SI.
    pub optimum: Vec<f64>,
}

/// Sensitivity of an optimum to a parameter, from the KKT system with exact second derivatives
/// (`longdrive optimum-sensitivity`).
///
/// # Errors
/// [`Error::NotConverged`] without a converged optimum; [`Error::Unreadable`] if the search varies
/// `parameter`; the errors of [`Setup::variable`]; [`Error::Optimizer`] if the optimum is not
/// isolated.
pub fn sensitivity(best: &Optimum, parameter: &'static Parameter) -> Result<Sensitivity> {
    let problem = best.problem()?;
    refuse_varied(&best.search, parameter)?;
    refuse_corner(best)?;
    let at = problem.evaluate_with(&best.solution.x, parameter)?;
    let response = response(&best.solution, &problem.domain, &at)?;
    let sign = best.search.sense.sign();
    let (value, curvature) = (sign * response.value, sign * response.curvature);
    Ok(Sensitivity {
        value,
        curvature,
        optimum: response.x,
    })
}

/// Refuses an optimum at a kink of the objective between the bounds: the kink may move with the
/// parameter.
fn refuse_corner(best: &Optimum) -> Result<()> {
    let Some(kink) = best.solution.kink.filter(|kink| kink.is_between_bounds()) else {
        return Ok(());
    };
    let name = best.search.vary[kink.variable].parameter.name;
    Err(Error::unreadable(
        "the sensitivity of the optimum",
        format!(
            "{} has a corner along {name} at the optimum, which may move; state {name} instead of \
             varying it",
            best.search.of.expression
        ),
    ))
}

/// The sensitivity to each of several parameters, or the error of this sensitivity. `progress`
/// receives the number of finished parameters and the number of all parameters.
///
/// # Errors
/// [`Error::NotConverged`] without a converged optimum.
pub fn sensitivities(
    best: &Optimum,
    wrt: &[&'static Parameter],
    progress: &dyn Fn(usize, usize),
) -> Result<Vec<(&'static Parameter, Result<Sensitivity>)>> {
    best.problem()?;
    let one = |(done, parameter): (usize, &&'static Parameter)| {
        let sensitivity = sensitivity(best, parameter);
        progress(done + 1, wrt.len());
        (*parameter, sensitivity)
    };
    Ok(wrt.iter().enumerate().map(one).collect())
}

/// Refuses a parameter that the search varies: the optimum has no sensitivity to it.
///
/// # Errors
/// [`Error::Unreadable`] if the search varies `parameter`.
pub fn refuse_varied(search: &Search, parameter: &Parameter) -> Result<()> {
    if search.parameters().any(|varied| varied == parameter) {
        let name = parameter.name;
        let source = format!(
            "{name} is a varied parameter, so the search chooses it; choose another parameter, or \
             give `vary` without {name}"
        );
        return Err(Error::unreadable(
            format!("the sensitivity of the optimum to {name}"),
            source,
        ));
    }
    Ok(())
}

/// A requested change of a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// The amount, SI.
    pub delta: f64,
}

impl Change {
    /// Parses `NAME=+AMOUNT`, for example `swing.speed=+5mph`, or `air.density=-20%`. A percentage
    /// is relative to the parameter's value, also for a dimensionless parameter.
    ///
    /// # Errors
    /// [`Error::Unreadable`] for a text that is not a change, and for a percentage of a value that is
    /// 0, unset, or a temperature; the errors of [`Setup::variable`];
    /// [`Error::OutOfRange`] if the result is outside the parameter's range.
    pub fn read(setup: &Setup<f64>, text: &str) -> Result<Self> {
        let unreadable = |source| Error::Unreadable {
            name: format!("the change {}", text.trim()),
            source,
        };
        let (name, amount) = text.split_once('=').ok_or_else(|| {
            unreadable(
                "write NAME=AMOUNT, for example swing.speed=+5mph or air.density=-20%".into(),
            )
        })?;
        let parameter = setup.variable(name.trim())?;
        let amount = amount.trim();
        let amount = amount.strip_prefix('+').unwrap_or(amount);
        let delta = amount_of(setup, parameter, amount, AmountKind::Change).map_err(unreadable)?;
        let own = setup.value(parameter).unwrap_or_default();
        if !delta.is_finite() {
            return Err(unreadable("the amount must be a finite number".into()));
        }
        parameter.check(own + delta)?;
        Ok(Self { parameter, delta })
    }
}

/// A change of the active bounds and constraints.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "EventReport"))]
pub struct PredictedEvent {
    /// The fraction of the change at which the event occurs, 0 to 1.
    pub after: f64,
    /// The event.
    pub message: Message,
}

/// Effect of a change on an optimum: predicted from the sensitivity, and found by a new search.
#[derive(Clone, Debug)]
pub struct Changed {
    /// The change.
    pub change: Change,
    /// Predicted objective, to first order, SI.
    pub first_order: f64,
    /// Predicted objective, to second order, SI.
    pub second_order: f64,
    /// Predicted values of the varied parameters, to first order, SI.
    pub predicted: Vec<f64>,
    /// Optimum of the new search.
    pub resolved: Optimum,
    /// First change of the active set in the first-order prediction; `None` if there is none.
    pub event: Option<PredictedEvent>,
    /// Changes of the active set found by the new search.
    pub differences: Vec<Message>,
}

/// Effect of a change on an optimum. `integrated` adds an integration method and a time step for
/// the new search to the changed setup, because the new drives may need shorter steps.
///
/// # Errors
/// The errors of [`sensitivity`], of `integrated`, and of the new search.
pub fn change(
    best: &Optimum,
    change: Change,
    integrated: &dyn Fn(Setup<f64>) -> Result<Setup<f64>>,
) -> Result<Changed> {
    let problem = best.problem()?;
    refuse_varied(&best.search, change.parameter)?;
    refuse_corner(best)?;
    let solution = &best.solution;
    let at = problem.evaluate_with(&solution.x, change.parameter)?;
    let response = response(solution, &problem.domain, &at)?;
    let delta = change.delta;
    let mut setup = best.setup;
    let value = setup.value(change.parameter).unwrap_or_default();
    setup.set_value(change.parameter, Some(value + delta))?;
    let resolved = optimum(
        &integrated(setup)?,
        best.search.clone(),
        Observer::default(),
    )?;

    let before = best.value().unwrap_or_default();
    let sign = best.search.sense.sign();
    let first_order = before + sign * response.value * delta;
    let event = first_event(solution, &problem.domain, &response, delta);
    Ok(Changed {
        change,
        first_order,
        second_order: first_order + 0.5 * sign * response.curvature * delta * delta,
        predicted: solution
            .x
            .iter()
            .zip(&response.x)
            .map(|(x, rate)| x + rate * delta)
            .collect(),
        event: event.map(|(after, event)| PredictedEvent {
            after,
            message: in_words(&best.search, event),
        }),
        differences: differences(best, &resolved),
        resolved,
    })
}

fn in_words(search: &Search, event: Event) -> Message {
    let bound = |i: usize, is_lower: bool, what: &str| {
        let vary = &search.vary[i];
        let (name, end) = if is_lower {
            ("lower", vary.low)
        } else {
            ("upper", vary.high)
        };
        vary.parameter.append_value(
            format!("{} {what} its {name} bound ", vary.parameter.name).into(),
            end,
        )
    };
    match event {
        Event::BoundReached(i, is_lower) => bound(i, is_lower, "reaches"),
        Event::BoundLeft(i, is_lower) => bound(i, is_lower, "leaves"),
        Event::LimitReached(j, _) => search.subject_to[j].message().words(" becomes active"),
        Event::LimitLeft(j, _) => search.subject_to[j].message().words(" is no longer active"),
    }
}

/// Differences of the active sets of two optima.
fn differences(before: &Optimum, after: &Optimum) -> Vec<Message> {
    if !after.is_converged() {
        let why = Message::from(format!("no optimum was found ({}: ", after.status()));
        return vec![why.message(after.message()).words(")")];
    }
    let (was, is) = (before.active(), after.active());
    let ends = only_in(&was, &is).into_iter();
    let begins = only_in(&is, &was).into_iter();
    let words = |active: Active, words: &str| {
        let message = active.message(&after.search.subject_to);
        message.words(words)
    };
    ends.map(|one| words(one, " is no longer active"))
        .chain(begins.map(|one| words(one, " has become active")))
        .collect()
}
