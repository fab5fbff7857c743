use super::flown::{columns, no_flight};
use super::measure::Measure;
use super::part::part_of;
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
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

/// Goals as functions of what is varied, each made of the drives of all scenarios.
///
/// The search sees smooth goals, with exact gradients and with Hessians of a part of the scenarios.
/// Answers are told by the definitions of the goals ([`values`](Self::values)).
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
    /// The scenarios whose drives' second derivatives stand for those of all, in order.
    part: Vec<usize>,
    /// For how many scenarios each of them stands.
    stands_for: Vec<f64>,
    /// The last second derivatives of the part.
    seconds: Mutex<Option<Arc<Seconds>>>,
    /// Once it is true, no more drives are hit, and what needs them fails.
    stop: Arc<AtomicBool>,
    pub domain: Domain,
}

/// Second derivatives of the part's drives.
struct Seconds {
    at: Vec<f64>,
    /// A Hessian for each drive and outcome.
    of_drives: Vec<Vec<Vec<Vec<f64>>>>,
}

impl SwingsProblem {
    /// # Errors
    /// [`Error::Unreadable`] for a parameter that is both varied and distributed; what
    /// [`Evaluator::new`] refuses; [`Error::NotConverged`] once `stop` is true.
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
                let source = "it is varied, and the swings have values of it; vary something else, \
                              or leave it out of the swings";
                return Err(Error::Unreadable {
                    name: vary.parameter.name.into(),
                    source: source.into(),
                });
            }
        }
        let goals = || {
            [objective]
                .into_iter()
                .chain(limits.iter().map(|limit| &limit.goal))
        };
        let related =
            goals()
                .flat_map(|goal| &goal.terms)
                .filter_map(|(_, measure)| match measure {
                    Measure::Parameter(parameter) => Some(*parameter),
                    _ => None,
                });
        for parameter in related {
            if scenarios.parameters.contains(&parameter) {
                let source = "a relation of the design has it, and the swings have values of it; \
                              leave it out of one of the two";
                return Err(Error::Unreadable {
                    name: parameter.name.into(),
                    source: source.into(),
                });
            }
        }
        let ends = |end: fn(&Vary) -> f64| vary.iter().map(end).collect::<Vec<_>>();
        let limit_ends = |end: fn(&GoalLimit) -> f64| limits.iter().map(end).collect::<Vec<_>>();
        let domain = Domain::new(ends(|vary| vary.low), ends(|vary| vary.high))?.subject_to(
            limit_ends(|limit| limit.low),
            limit_ends(|limit| limit.high),
        )?;
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
        // the Hessian of a goal with an edge is that of the few drives at its edge: no part stands
        // for them
        let (part, stands_for) = match goals.iter().any(Goal::has_edge) {
            true => (
                (0..scenarios.points.len()).collect(),
                vec![1.0; scenarios.points.len()],
            ),
            false => part_of(&scenarios),
        };
        let question = |point: &Vec<f64>| {
            Evaluator::new(
                &moved(&setup, &scenarios.parameters, point)?,
                &of,
                &vary,
                Order::Second,
            )
        };
        // of several mistakes always the first is told
        let drives = each_until(&scenarios.points, &stop, question);
        let drives = drives
            .ok_or_else(|| stopped("all swings were set up"))?
            .into_iter()
            .collect::<Result<Vec<_>>>()?;
        Ok(Self {
            set_up,
            setup,
            vary,
            scenarios,
            of,
            goals,
            sense,
            drives,
            part,
            stands_for,
            seconds: Mutex::default(),
            stop,
            domain,
        })
    }

    /// Where the search begins: the setup's own values of what is varied, and the middle of the
    /// range of what has none.
    pub fn start(&self) -> Vec<f64> {
        values(&self.setup, &self.vary)
    }

    /// The setup with what is varied at `x`, and every swing as the setup has it.
    pub fn moved(&self, x: &[f64]) -> Result<Setup<f64>> {
        moved(&self.setup, &self.vary, x)
    }

    /// The outcomes of these scenarios, with derivatives to an order.
    fn flown(
        &self,
        scenarios: &[usize],
        x: &[f64],
        order: Order,
        stop: &AtomicBool,
    ) -> std::result::Result<Vec<Vec<Taylor>>, String> {
        // in the order of the scenarios, whichever thread flies them: sums are the same to the last
        // bit, and of several swings that do not fly always the first is named
        let flown = each_until(scenarios, stop, |k| self.drives[*k].at_order(x, order));
        let flown = flown
            .ok_or_else(|| stopped_before("all swings were flown"))?
            .into_iter()
            .zip(scenarios);
        let named = |k: usize, error| no_flight(&self.scenarios, &self.scenarios.points[k], &error);
        flown
            .map(|(drive, k)| drive.map_err(|error| named(*k, error)))
            .collect()
    }

    /// The second derivatives of the part near `x`, each times the number of scenarios that it
    /// stands for: at the nearest point of a grid over the ranges, so that near an optimum they are
    /// computed once. They are the same whatever was asked before.
    fn second_derivatives(&self, x: &[f64]) -> std::result::Result<Arc<Seconds>, String> {
        let nearest: Vec<f64> = (0..x.len()).map(|i| self.on_the_grid(i, x[i])).collect();
        let kept = |seconds: &Option<Arc<Seconds>>| {
            seconds.clone().filter(|seconds| seconds.at == nearest)
        };
        if let Some(seconds) = kept(&self.seconds.lock().unwrap_or_else(PoisonError::into_inner)) {
            return Ok(seconds);
        }
        let seconds = |at: &[f64]| {
            let mut flown = self.flown(&self.part, at, Order::Second, &self.stop)?;
            for (outcomes, factor) in flown.iter_mut().zip(&self.stands_for) {
                let seconds = outcomes
                    .iter_mut()
                    .flat_map(|outcome| outcome.hessian.iter_mut().flatten());
                seconds.for_each(|second| *second *= factor);
            }
            let hessians = |outcomes: Vec<Taylor>| {
                outcomes
                    .into_iter()
                    .map(|outcome| outcome.hessian)
                    .collect()
            };
            Ok(Arc::new(Seconds {
                at: at.to_vec(),
                of_drives: flown.into_iter().map(hessians).collect(),
            }))
        };
        // a swing may fly at `x` and not at the point of the grid
        let found = seconds(&nearest).or_else(|_: String| seconds(x))?;
        *self.seconds.lock().unwrap_or_else(PoisonError::into_inner) = Some(Arc::clone(&found));
        Ok(found)
    }

    /// The nearest point of the grid for second derivatives to a value of a parameter.
    fn on_the_grid(&self, i: usize, x: f64) -> f64 {
        /// Over the range of a parameter, so far apart that a drive's second derivatives change by
        /// a hundredth or so.
        const CELLS: f64 = 64.0;
        let [low, high] = [self.domain.variables.low[i], self.domain.variables.high[i]];
        let place = (CELLS * (x - low) / (high - low)).round() / CELLS;
        if place.is_finite() {
            (low + place * (high - low)).clamp(low, high)
        } else {
            x
        }
    }

    /// A term of a goal that no drive changes.
    fn of_the_design(&self, measure: &Measure, x: &[f64], order: Order) -> Option<Taylor> {
        let (value, place) = match measure {
            Measure::One => (1.0, None),
            Measure::Parameter(parameter) => {
                let place = self.vary.iter().position(|vary| vary == parameter);
                (
                    place.map_or_else(
                        || {
                            self.setup
                                .value(parameter)
                                .or(parameter.unset)
                                .unwrap_or(f64::NAN)
                        },
                        |place| x[place],
                    ),
                    place,
                )
            }
            _ => return None,
        };
        let slope = |i: usize| f64::from(u8::from(place == Some(i)));
        let n = if order > Order::Value { x.len() } else { 0 };
        let rows = if order == Order::Second { n } else { 0 };
        Some(Taylor {
            value,
            gradient: (0..n).map(slope).collect(),
            ..Taylor::zero(n, rows)
        })
    }

    /// Each goal at `x` from the outcomes of the scenarios, with its edges smoothed.
    fn measured(
        &self,
        x: &[f64],
        flown: &[Vec<Taylor>],
        weights: &[f64],
        order: Order,
    ) -> Vec<Taylor> {
        let goal = |goal: &Goal| {
            let terms = goal.terms.iter().map(|(weight, measure)| {
                if let Some(term) = self.of_the_design(measure, x, order) {
                    return (term, *weight);
                }
                let outcomes = measure.outcomes();
                let places: Vec<usize> = outcomes
                    .iter()
                    .filter_map(|of| self.of.iter().position(|it| it == of))
                    .collect();
                let drives: Vec<Vec<&Taylor>> = flown
                    .iter()
                    .map(|outcomes| places.iter().map(|place| &outcomes[*place]).collect())
                    .collect();
                (measure.smoothed(&drives, weights, order), *weight)
            });
            let terms: Vec<_> = terms.collect();
            Taylor::sum(terms.iter().map(|(term, weight)| (term, *weight)))
        };
        self.goals.iter().map(goal).collect()
    }

    /// Each goal at `x` by its definition, from a column of values for each outcome.
    fn exact(&self, x: &[f64], columns: &[Vec<f64>], weights: &[f64]) -> Vec<f64> {
        let term = |(weight, measure): &(f64, Measure)| {
            let value = self
                .of_the_design(measure, x, Order::Value)
                .map(|term| term.value);
            weight
                * value.unwrap_or_else(|| {
                    measure.exact(&self.columns_of(&measure.outcomes(), columns), weights)
                })
        };
        self.goals
            .iter()
            .map(|goal| goal.terms.iter().map(term).sum())
            .collect()
    }

    fn columns_of<'a>(&self, outcomes: &[Outcome], columns: &'a [Vec<f64>]) -> Vec<&'a [f64]> {
        let places = outcomes
            .iter()
            .filter_map(|of| self.of.iter().position(|it| it == of));
        places.map(|place| &columns[place][..]).collect()
    }

    /// The goals by their definitions at `x`: the objective, then what is limited. Goals with an
    /// edge are told over the swings of [`sequences`](Scenarios::sequences), where all of these
    /// fly; any other goal over the scenarios.
    ///
    /// # Errors
    /// Where a scenario does not fly, or the work is stopped.
    pub fn values(&self, x: &[f64]) -> Result<Vec<f64>> {
        self.values_until(x, &self.stop)
    }

    /// The same until this flag is true.
    ///
    /// # Errors
    /// As [`values`](Self::values).
    pub fn values_until(&self, x: &[f64], stop: &AtomicBool) -> Result<Vec<f64>> {
        self.told(&self.moved(x)?, x, stop)
    }

    /// The same with the design as set up, in which a parameter that has no value is left without.
    ///
    /// # Errors
    /// As [`values`](Self::values).
    pub fn as_set_up(&self) -> Result<Vec<f64>> {
        self.told(&self.set_up, &self.own(), &self.stop)
    }

    /// The same over the scenarios alone, with other weights.
    ///
    /// # Errors
    /// As [`values`](Self::values).
    pub fn weighted_values(&self, x: &[f64], weights: &[f64]) -> Result<Vec<f64>> {
        Ok(self.exact(
            x,
            &columns(&self.moved(x)?, &self.of, &self.scenarios, &self.stop)?,
            weights,
        ))
    }

    /// The same with the design as set up.
    ///
    /// # Errors
    /// As [`values`](Self::values).
    pub fn weighted_as_set_up(&self, weights: &[f64]) -> Result<Vec<f64>> {
        Ok(self.exact(
            &self.own(),
            &columns(&self.set_up, &self.of, &self.scenarios, &self.stop)?,
            weights,
        ))
    }

    /// The goals at `x` over each of the [`sequences`](Scenarios::sequences) by itself.
    ///
    /// # Errors
    /// Where a swing of them does not fly, or the work is stopped.
    pub fn replications(&self, x: &[f64]) -> Result<Vec<Vec<f64>>> {
        let setup = self.moved(x)?;
        let one = |sequence: Result<Scenarios>| {
            let sequence = sequence?;
            Ok(self.exact(
                x,
                &columns(&setup, &self.of, &sequence, &self.stop)?,
                &sequence.weights,
            ))
        };
        self.scenarios.sequences().into_iter().map(one).collect()
    }

    /// What the design as set up has of what is varied.
    fn own(&self) -> Vec<f64> {
        let own = |parameter: &&'static Parameter| {
            self.set_up
                .value(parameter)
                .or(parameter.unset)
                .unwrap_or(f64::NAN)
        };
        self.vary.iter().map(own).collect()
    }

    fn told(&self, setup: &Setup<f64>, design: &[f64], stop: &AtomicBool) -> Result<Vec<f64>> {
        let flown = columns(setup, &self.of, &self.scenarios, stop)?;
        let mut values = self.exact(design, &flown, &self.scenarios.weights);
        if !self.goals.iter().any(Goal::has_edge) {
            return Ok(values);
        }
        let mut all: Vec<Vec<f64>> = vec![vec![]; self.of.len()];
        for sequence in self.scenarios.sequences() {
            let more = match columns(setup, &self.of, &sequence?, stop) {
                Err(Error::NoFlight { .. }) => return Ok(values),
                more => more?,
            };
            all.iter_mut()
                .zip(more)
                .for_each(|(column, more)| column.extend(more));
        }
        let count = all[0].len();
        if count > 0 {
            let over_all = self.exact(design, &all, &vec![1.0 / count as f64; count]);
            let told = values
                .iter_mut()
                .zip(over_all)
                .zip(&self.goals)
                .filter(|(_, goal)| goal.has_edge());
            told.for_each(|((value, over_all), _)| *value = over_all);
        }
        Ok(values)
    }

    /// The goals at `x` with smoothed edges, other weights of the scenarios, and derivatives to an
    /// order: the objective, then what is limited.
    ///
    /// # Errors
    /// Where a swing does not fly, or `stop` is true.
    pub fn goals_until(
        &self,
        x: &[f64],
        weights: &[f64],
        order: Order,
        stop: &AtomicBool,
    ) -> Result<Vec<Taylor>> {
        let all: Vec<usize> = (0..self.drives.len()).collect();
        let flown = self.flown(&all, x, order, stop);
        let flown = flown.map_err(|reason| match stop.load(Ordering::Relaxed) {
            true => stopped("all swings were flown"),
            false => Error::NoFlight {
                reason: reason.into(),
            },
        })?;
        Ok(self.measured(x, &flown, weights, order))
    }

    /// The share of scenarios with which a ball ends where a table of strokes does not reach;
    /// `None` without such a table.
    ///
    /// # Errors
    /// Where a swing does not fly.
    pub fn beyond_strokes(&self, x: &[f64]) -> Result<Option<f64>> {
        let tables: Vec<_> = self.goals.iter().flat_map(Goal::strokes).collect();
        if tables.is_empty() {
            return Ok(None);
        }
        let flown = columns(&self.moved(x)?, &self.of, &self.scenarios, &self.stop)?;
        let ends: Vec<_> = tables
            .iter()
            .map(|(strokes, _)| self.columns_of(strokes.outcomes(), &flown))
            .collect();
        let is_beyond = |k: usize| {
            let mut all = tables.iter().zip(&ends);
            all.any(|((strokes, hole), end)| !strokes.reaches((hole - end[0][k]).hypot(end[1][k])))
        };
        let weights = self.scenarios.weights.iter().enumerate();
        Ok(Some(
            weights
                .filter(|(k, _)| is_beyond(*k))
                .map(|(_, weight)| weight)
                .sum(),
        ))
    }

    /// The same with other weights.
    pub fn weighted(&self, weights: Vec<f64>) -> Weighted<'_> {
        Weighted {
            problem: self,
            weights,
        }
    }

    pub fn scenarios(&self) -> &Scenarios {
        &self.scenarios
    }

    /// The goals with exact values and gradients. In the Hessians, what the gradients of drives
    /// contribute is exact too; the second derivatives of drives are those of the part.
    fn evaluated(&self, x: &[f64], weights: &[f64]) -> std::result::Result<Evaluation, String> {
        let all: Vec<usize> = (0..self.drives.len()).collect();
        let flown = if self.part.len() == all.len() {
            self.flown(&all, x, Order::Second, &self.stop)?
        } else {
            let mut flown = self.flown(&all, x, Order::First, &self.stop)?;
            let seconds = self.second_derivatives(x)?;
            for (k, of_drive) in self.part.iter().zip(&seconds.of_drives) {
                flown[*k]
                    .iter_mut()
                    .zip(of_drive)
                    .for_each(|(outcome, hessian)| outcome.hessian.clone_from(hessian));
            }
            flown
        };
        let mut goals = self.measured(x, &flown, weights, Order::Second);
        let constraints = goals.split_off(1);
        let objective = goals.pop().unwrap_or_default();
        let objective = if self.sense == Sense::Maximize {
            objective.negated()
        } else {
            objective
        };
        Ok(Evaluation {
            objective,
            constraints,
        })
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
