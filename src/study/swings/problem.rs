use super::measure::Measure;
use super::read::{Goal, GoalLimit};
use super::scenarios::Scenarios;
use crate::derivative::{Evaluator, Order};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::number::Taylor;
use crate::optimize::{Domain, Evaluation, Problem};
use crate::parameters::{Parameter, Setup, Vary};
use crate::study::Sense;
use crate::study::problem::{moved, values};
use crate::study::stoppable::{each_until, stopped, stopped_before};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Goals as functions of what is varied: every scenario is hit and flown with exact derivatives, and the goals are made of them.
pub(super) struct SwingsProblem {
    /// The setup as it is given.
    set_up: Setup<f64>,
    /// The same with a value of everything that is varied.
    setup: Setup<f64>,
    vary: Vec<&'static Parameter>,
    scenarios: Scenarios,
    of: Vec<Outcome>,
    goals: Vec<Goal>,
    sense: Sense,
    /// A question for each scenario.
    drives: Vec<Evaluator>,
    /// Once it is true, no more drives are hit, and what needs them fails.
    stop: Arc<AtomicBool>,
    pub domain: Domain,
}

impl SwingsProblem {
    /// # Errors
    /// [`Error::Unreadable`] for a parameter that is both varied and distributed; what [`Evaluator::new`] refuses; [`Error::NotConverged`] once
    /// `stop` is true.
    pub fn new(
        setup: &Setup<f64>,
        (objective, sense): (&Goal, Sense),
        limits: &[GoalLimit],
        vary: &[Vary],
        scenarios: Scenarios,
        stop: &Arc<AtomicBool>,
    ) -> Result<Self> {
        vary.iter().try_for_each(Vary::check)?;
        for vary in vary {
            if scenarios.parameters.contains(&vary.parameter) {
                let source = "it is varied, and the swings have values of it; vary something else, or leave it out of the swings";
                return Err(Error::Unreadable { name: vary.parameter.name.into(), source: source.into() });
            }
        }
        let goals = || [objective].into_iter().chain(limits.iter().map(|limit| &limit.goal));
        let related = goals().flat_map(|goal| &goal.terms).filter_map(|(_, measure)| match measure {
            Measure::Parameter(parameter) => Some(*parameter),
            _ => None,
        });
        for parameter in related {
            if scenarios.parameters.contains(&parameter) {
                let source =
                    "a relation of the design has it, and the swings have values of it; leave it out of one of the two";
                return Err(Error::Unreadable { name: parameter.name.into(), source: source.into() });
            }
        }
        let ends = |end: fn(&Vary) -> f64| vary.iter().map(end).collect::<Vec<_>>();
        let limit_ends = |end: fn(&GoalLimit) -> f64| limits.iter().map(end).collect::<Vec<_>>();
        let domain = Domain::new(ends(|vary| vary.low), ends(|vary| vary.high))?
            .subject_to(limit_ends(|limit| limit.low), limit_ends(|limit| limit.high))?;
        let goals: Vec<Goal> = goals().cloned().collect();
        let mut of: Vec<Outcome> = vec![];
        for outcome in goals.iter().flat_map(Goal::outcomes) {
            if !of.contains(&outcome) {
                of.push(outcome);
            }
        }
        let (set_up, setup) = (*setup, Vary::begun(setup, vary)?);
        let vary: Vec<_> = vary.iter().map(|vary| vary.parameter).collect();
        let stop = Arc::clone(stop);
        let mut problem = Self { set_up, setup, vary, scenarios, of, goals, sense, drives: vec![], stop, domain };
        problem.drives = problem.evaluators(&problem.setup, &problem.vary, Order::Second)?;
        Ok(problem)
    }

    /// A question for each scenario of a setup. Of several mistakes always the first is told.
    fn evaluators(&self, setup: &Setup<f64>, wrt: &[&'static Parameter], order: Order) -> Result<Vec<Evaluator>> {
        let swung = |point: &Vec<f64>| moved(setup, &self.scenarios.parameters, point);
        let of = |point: &Vec<f64>| Evaluator::new(&swung(point)?, &self.of, wrt, order);
        let all = each_until(&self.scenarios.points, &self.stop, of);
        all.ok_or_else(|| stopped("all swings were set up"))?.into_iter().collect()
    }

    /// Where the search begins: the setup's own values of what is varied, and the middle of the range of what has none.
    pub fn start(&self) -> Vec<f64> {
        values(&self.setup, &self.vary)
    }

    /// The setup with what is varied at `x`, and every swing as the setup has it.
    pub fn moved(&self, x: &[f64]) -> Result<Setup<f64>> {
        moved(&self.setup, &self.vary, x)
    }

    /// The outcomes of every scenario, with derivatives to an order.
    fn flown(
        &self,
        drives: &[Evaluator],
        x: &[f64],
        order: Order,
        stop: &AtomicBool,
    ) -> std::result::Result<Vec<Vec<Taylor>>, String> {
        // in the order of the scenarios, whichever thread flies them: sums are the same to the last bit, and of several swings that do not
        // fly always the first is named
        let flown = each_until(drives, stop, |drive| drive.at_order(x, order));
        let flown = flown.ok_or_else(|| stopped_before("all swings were flown"))?.into_iter();
        flown
            .zip(&self.scenarios.points)
            .map(|(drive, point)| drive.map_err(|error| format!("{}{error}", self.named(point))))
            .collect()
    }

    /// A scenario in words before what is said of it; one drive alone needs none.
    fn named(&self, point: &[f64]) -> String {
        if self.scenarios.is_one_drive() {
            return String::new();
        }
        let value = |(parameter, value): (&&'static Parameter, &f64)| {
            format!("{} = {}", parameter.name, parameter.show(Some(*value)))
        };
        let values: Vec<_> = self.scenarios.parameters.iter().zip(point).map(value).collect();
        format!("the swing with {}: ", values.join(", "))
    }

    /// A term of a goal that no drive changes, with as many derivatives as drives have.
    fn of_the_design(&self, measure: &Measure, x: &[f64], like: &Taylor) -> Option<Taylor> {
        let (value, place) = match measure {
            Measure::One => (1.0, None),
            Measure::Parameter(parameter) => {
                let place = self.vary.iter().position(|vary| vary == parameter);
                (
                    place.map_or_else(
                        || self.setup.value(parameter).or(parameter.unset).unwrap_or(f64::NAN),
                        |place| x[place],
                    ),
                    place,
                )
            }
            _ => return None,
        };
        let slope = |i: usize| f64::from(u8::from(place == Some(i)));
        Some(Taylor {
            value,
            gradient: (0..like.gradient.len()).map(slope).collect(),
            hessian: vec![vec![0.0; like.gradient.len()]; like.hessian.len()],
        })
    }

    /// Each goal at `x` from the outcomes of every scenario, with other weights than the scenarios' own where they are given.
    fn measured(&self, x: &[f64], flown: &[Vec<Taylor>], weights: &[f64]) -> Vec<Taylor> {
        let like = flown.first().and_then(|outcomes| outcomes.first()).cloned().unwrap_or_default();
        let goal = |goal: &Goal| {
            let terms = goal.terms.iter().map(|(weight, measure)| {
                if let Some(term) = self.of_the_design(measure, x, &like) {
                    return (term, *weight);
                }
                let outcomes = measure.outcomes();
                let places: Vec<usize> =
                    outcomes.iter().filter_map(|of| self.of.iter().position(|it| it == of)).collect();
                let drives: Vec<Vec<&Taylor>> =
                    flown.iter().map(|outcomes| places.iter().map(|place| &outcomes[*place]).collect()).collect();
                (measure.of(&drives, weights), *weight)
            });
            let terms: Vec<_> = terms.collect();
            Taylor::sum(terms.iter().map(|(term, weight)| (term, *weight)))
        };
        self.goals.iter().map(goal).collect()
    }

    /// The values of the goals at `x`: the objective, then what is limited.
    ///
    /// # Errors
    /// Where a swing does not fly, or the work is stopped.
    pub fn values(&self, x: &[f64]) -> Result<Vec<f64>> {
        let weights = &self.scenarios.weights;
        Ok(self.goals_at(x, weights, Order::Value)?.into_iter().map(|goal| goal.value).collect())
    }

    /// The values of the goals with the design as set up, in which a parameter that has no value is left without.
    ///
    /// # Errors
    /// Where a swing does not fly, or the work is stopped.
    pub fn as_set_up(&self, weights: &[f64]) -> Result<Vec<f64>> {
        let drives = self.evaluators(&self.set_up, &[], Order::Value)?;
        let own = |parameter: &&'static Parameter| self.set_up.value(parameter).or(parameter.unset).unwrap_or(f64::NAN);
        let own: Vec<f64> = self.vary.iter().map(own).collect();
        let flown = self
            .flown(&drives, &[], Order::Value, &self.stop)
            .map_err(|reason| Error::NoFlight { reason: reason.into() })?;
        Ok(self.measured(&own, &flown, weights).into_iter().map(|goal| goal.value).collect())
    }

    /// The goals at `x` with other weights of the scenarios and derivatives to an order: the objective, then what is limited.
    ///
    /// # Errors
    /// Where a swing does not fly, or the work is stopped.
    pub fn goals_at(&self, x: &[f64], weights: &[f64], order: Order) -> Result<Vec<Taylor>> {
        self.goals_until(x, weights, order, &self.stop)
    }

    /// The same until this flag is true.
    ///
    /// # Errors
    /// As [`goals_at`](Self::goals_at).
    pub fn goals_until(&self, x: &[f64], weights: &[f64], order: Order, stop: &AtomicBool) -> Result<Vec<Taylor>> {
        let flown = self.flown(&self.drives, x, order, stop);
        let flown = flown.map_err(|reason| match stop.load(Ordering::Relaxed) {
            true => stopped("all swings were flown"),
            false => Error::NoFlight { reason: reason.into() },
        })?;
        Ok(self.measured(x, &flown, weights))
    }

    /// The share of scenarios with which a ball ends where a table of strokes does not reach; `None` without such a table.
    ///
    /// # Errors
    /// Where a swing does not fly.
    pub fn beyond_strokes(&self, x: &[f64]) -> Result<Option<f64>> {
        let tables: Vec<_> = self.goals.iter().flat_map(Goal::strokes).collect();
        if tables.is_empty() {
            return Ok(None);
        }
        let flown = self.flown(&self.drives, x, Order::Value, &self.stop);
        let flown = flown.map_err(|reason| Error::NoFlight { reason: reason.into() })?;
        let value = |outcomes: &[Taylor], of: Outcome| {
            self.of.iter().position(|it| *it == of).map_or(f64::NAN, |place| outcomes[place].value)
        };
        let is_beyond = |outcomes: &&Vec<Taylor>| {
            tables.iter().any(|(strokes, hole)| {
                let [downrange, right] = strokes.outcomes().map(|of| value(outcomes, of));
                !strokes.reaches((hole - downrange).hypot(right))
            })
        };
        let beyond = flown.iter().zip(&self.scenarios.weights).filter(|(outcomes, _)| is_beyond(outcomes));
        Ok(Some(beyond.map(|(_, weight)| weight).sum()))
    }

    /// The same with other weights.
    pub fn weighted(&self, weights: Vec<f64>) -> Weighted<'_> {
        Weighted { problem: self, weights }
    }

    pub fn scenarios(&self) -> &Scenarios {
        &self.scenarios
    }

    fn evaluated(&self, x: &[f64], weights: &[f64]) -> std::result::Result<Evaluation, String> {
        let mut goals = self.measured(x, &self.flown(&self.drives, x, Order::Second, &self.stop)?, weights);
        let constraints = goals.split_off(1);
        let objective = goals.pop().unwrap_or_default();
        let objective = if self.sense == Sense::Maximize { objective.negated() } else { objective };
        Ok(Evaluation { objective, constraints })
    }
}

impl Problem for SwingsProblem {
    fn evaluate(&self, x: &[f64]) -> std::result::Result<Evaluation, String> {
        self.evaluated(x, &self.scenarios.weights)
    }
}

/// The problem over a resample of its scenarios.
pub(super) struct Weighted<'a> {
    problem: &'a SwingsProblem,
    weights: Vec<f64>,
}

impl Problem for Weighted<'_> {
    fn evaluate(&self, x: &[f64]) -> std::result::Result<Evaluation, String> {
        self.problem.evaluated(x, &self.weights)
    }
}
