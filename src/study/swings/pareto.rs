use super::optimum::{SwingsSearch, posed, violated};
use super::problem::SwingsProblem;
use super::read::{Goal, GoalLimit};
use super::scenarios::Scenarios;
use crate::error::{Error, Result};
use crate::optimize::front::{Front, FrontEvent, FrontPoint, NoFront, front};
use crate::optimize::sensitivity::Held;
use crate::optimize::{Evaluation, Follow, Options, Problem, Status};
use crate::parameters::{Setup, Vary};
use crate::study::stoppable::stopped;
use crate::study::{Active, ChartEvent, Sense};
use std::sync::atomic::{AtomicBool, Ordering};

/// Two goals to be weighed against each other.
#[derive(Clone, Debug)]
pub struct ParetoSearch {
    /// The goals, and which value of each is better.
    pub goals: [(Goal, Sense); 2],
    /// The parameters of the design to vary.
    pub vary: Vec<Vary>,
    /// Goals to hold between limits.
    pub subject_to: Vec<GoalLimit>,
    /// Points spread evenly along the front, with its ends.
    pub points: usize,
    /// The optimizer's settings.
    pub options: Options,
}

/// The best compromises between two goals, from the best of the first to the best of the second.
#[derive(Clone, Debug)]
pub struct Pareto {
    /// What was asked.
    pub search: ParetoSearch,
    /// The swings.
    pub scenarios: Scenarios,
    /// The compromises, in order.
    pub points: Vec<ParetoPoint>,
    /// Which of them is the knee (see [`Front::knee`]).
    pub knee: Option<usize>,
    /// How far the front bends off the straight line between its ends, as a part of that line's
    /// length, where both goals are scaled from one end to the other.
    pub bend: f64,
    /// The goals with the setup's own design, `None` where a swing does not fly.
    pub as_set_up: Option<[f64; 2]>,
    /// Compromises found that others are better than in both goals, and that are left out.
    pub dominated: usize,
    /// Why a part of the front is missing, if it is.
    pub ended: Option<String>,
    /// Whether it was stopped from outside before its end.
    pub interrupted: bool,
}

/// A design than which none is better in both goals.
#[derive(Clone, Debug)]
pub struct ParetoPoint {
    /// The varied parameters, SI.
    pub design: Vec<f64>,
    /// The two goals, SI.
    pub goals: [f64; 2],
    /// What the first goal changes by for each unit of the second, along the front: the price of
    /// the second. `None` where the front has no one slope.
    pub slope: Option<f64>,
    /// The bounds and limits that hold it.
    pub active: Vec<Active>,
    /// What happens here.
    pub event: Option<String>,
    /// Whether no designs lead to it from the point before.
    pub is_apart: bool,
    /// The setup with this design.
    pub setup: Setup<f64>,
}

impl Pareto {
    /// How it ended, in a word.
    pub fn status(&self) -> &'static str {
        match &self.ended {
            _ if self.interrupted => "interrupted",
            Some(_) => "partial",
            None => "done",
        }
    }

    /// Why there is no knee, if there is none.
    pub fn no_knee(&self) -> Option<String> {
        let [first, second] = self
            .search
            .goals
            .each_ref()
            .map(|(goal, _)| goal.expression.as_str());
        match (self.points.len(), self.knee) {
            (_, Some(_)) => None,
            _ if self.interrupted => None,
            (1, _) => Some(format!(
                "one design is best for both {first} and {second}: there is nothing \
                              to choose between"
            )),
            _ => Some(
                "no knee: the front is nearly straight, or bends the other way, so that no point \
                 of it stands out"
                    .into(),
            ),
        }
    }
}

/// The best compromises between two goals over swings, or between two outcomes of one drive
/// ([`Scenarios::one_drive`]).
///
/// # Errors
/// [`Error::NotConverged`] where the best of one goal alone is not found; as
/// [`swings_optimum`](super::swings_optimum).
pub fn pareto(
    setup: &Setup<f64>,
    search: ParetoSearch,
    scenarios: Scenarios,
    follow: &Follow,
) -> Result<Pareto> {
    let [(first, sense), (second, against)] = search.goals.clone();
    let (expression, low, high) = (second.expression.clone(), f64::NEG_INFINITY, f64::INFINITY);
    let limits = search.subject_to.iter().cloned().chain([GoalLimit {
        expression,
        goal: second,
        low,
        high,
    }]);
    let (vary, options) = (search.vary.clone(), search.options.clone());
    let alone = SwingsSearch {
        of: first,
        sense,
        vary,
        subject_to: limits.collect(),
        options,
    };
    let problem = posed(setup, &alone, scenarios, &follow.interrupt)?;
    let own = problem.as_set_up();
    if own.is_err() && follow.interrupt.load(Ordering::Relaxed) {
        return Err(stopped("the search began"));
    }
    let minimised = |x: &[f64]| {
        let Evaluation {
            objective,
            mut constraints,
        } = problem.evaluate(x)?;
        if against == Sense::Maximize {
            let second = constraints.pop().unwrap_or_default();
            constraints.push(second.negated());
        }
        Ok(Evaluation {
            objective,
            constraints,
        })
    };
    let start = problem.domain.variables.project(&problem.start());
    let found = front(
        &minimised,
        &problem.domain,
        &start,
        (&search.options, search.points),
        follow,
    );
    let Front {
        points,
        knee,
        bend,
        dominated,
        ended,
        interrupted,
    } = found.map_err(|error| named(error, &search, &problem))?;
    let signs = [sense.sign(), against.sign()];
    // also after a stop: what was found until then is told
    let never = AtomicBool::new(false);
    let point = |point: FrontPoint| {
        let active = search.active(&point.x, &point.held);
        let is_apart = point.event == Some(FrontEvent::Jump);
        let event = point.event.map(|event| match event {
            FrontEvent::Jump => {
                "other designs are better from here on, which those before do not lead to"
                    .to_owned()
            }
            FrontEvent::Changed { before } => {
                let before = search.active(&point.x, &before);
                let only = |these: &[Active], others: &[Active]| {
                    these
                        .iter()
                        .filter(|active| !others.contains(active))
                        .cloned()
                        .collect::<Vec<_>>()
                };
                ChartEvent::Changed {
                    begins: only(&active, &before),
                    ends: only(&before, &active),
                }
                .to_string()
            }
        });
        let values = problem.values_until(&point.x, &never)?;
        Ok(ParetoPoint {
            setup: problem.moved(&point.x)?,
            goals: [values[0], values[values.len() - 1]],
            slope: point.slope.map(|slope| signs[0] * signs[1] * slope),
            design: point.x,
            active,
            event,
            is_apart,
        })
    };
    let points = points.into_iter().map(point).collect::<Result<Vec<_>>>()?;
    let as_set_up = own
        .ok()
        .and_then(|values| Some([*values.first()?, *values.last()?]));
    let scenarios = problem.scenarios().clone();
    Ok(Pareto {
        search,
        scenarios,
        points,
        knee,
        bend,
        as_set_up,
        dominated,
        ended,
        interrupted,
    })
}

impl ParetoSearch {
    /// The bounds and limits that hold a design.
    fn active(&self, x: &[f64], held: &Held) -> Vec<Active> {
        let is_bounded = |i: &usize| held.variables[*i] && self.vary[*i].low < self.vary[*i].high;
        let bound = |i: usize| {
            let Vary {
                parameter,
                low,
                high,
            } = self.vary[i];
            let end = if x[i] - low <= high - x[i] {
                "lower"
            } else {
                "upper"
            };
            Active {
                name: parameter.name.into(),
                end: Some(end),
            }
        };
        let bounds = (0..self.vary.len()).filter(is_bounded).map(bound);
        let limits = held
            .tight()
            .into_iter()
            .filter_map(|j| self.subject_to.get(j));
        bounds
            .chain(limits.map(|limit| Active {
                name: limit.expression.clone(),
                end: None,
            }))
            .collect()
    }
}

/// Why the best of a goal alone was not found, in the goal's name.
fn named(none: NoFront, search: &ParetoSearch, problem: &SwingsProblem) -> Error {
    let NoFront::NoEnd { function, found } = none else {
        return none.into_error();
    };
    let (goal, sense) = &search.goals[function];
    let why = match (&found.undefined_at_start, found.status) {
        (Some(why), Status::Undefined) => why.clone(),
        (_, Status::Infeasible) => violated(
            &search.subject_to,
            &found,
            problem.values(&found.x).ok().as_deref(),
        ),
        _ => found.message.clone(),
    };
    let status = match found.status {
        Status::Undefined => "no-flight",
        status => status.name(),
    };
    Error::NotConverged {
        status,
        message: format!("for the {} {}: {why}", sense.adjective(), goal.expression).into(),
    }
}
