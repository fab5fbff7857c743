//! A search in the form that the optimizer needs: the goals as functions of the varied parameters.
//!
//! ```text
//!   x ──▶ each scenario's drive with exact derivatives ──▶ goals: smoothed measures of the drives
//! ```
//!
//! One drive is one scenario. If the goals are outcomes of one drive, they need no measures: the
//! derivatives of the outcomes are the derivatives of the goals.

use super::cancellable::{each_until, stopped_before};
use super::goal::Goal;
use super::search::{Search, Sense};
use super::swings::flown::{columns, no_flight};
use super::swings::subset::subset_of;
use super::swings::{Measure, Scenarios};
use crate::batch::Batch;
use crate::derivative::{self, Evaluator, Order, Taylor};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::lock::lock;
use crate::optimize::{Domain, Evaluation, Problem};
use crate::parameters::{Parameter, Setup, Vary};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};

/// The goals of a search as functions of the varied parameters.
///
/// The optimizer sees smooth goals with exact gradients. Their Hessians use the second derivatives
/// of a subset of the drives. Reported values follow the exact definitions of the goals
/// ([`goals_at`](Self::goals_at)).
pub(super) struct SearchProblem {
    /// The setup as given.
    pub as_given: Setup<f64>,
    /// The setup with a value for every varied parameter.
    initialized: Setup<f64>,
    pub search: Search,
    /// The varied parameters.
    pub parameters: Vec<&'static Parameter>,
    /// The outcomes of a drive that the goals need. If every goal is an outcome of one drive,
    /// outcome k is goal k.
    outcomes: Vec<Outcome>,
    /// An evaluator for each scenario.
    drives: Vec<Evaluator>,
    /// Indices of the scenarios for which second derivatives are computed, in ascending order.
    subset: Vec<usize>,
    /// Number of scenarios that each scenario in `subset` represents, usually not an integer.
    multiplicities: Vec<f64>,
    /// The last computed second derivatives of the drives in `subset`.
    second_derivatives: Mutex<Option<Arc<SecondDerivatives>>>,
    /// Interrupt flag: once true, no more drives are computed, and evaluations that need them fail.
    pub stop: Arc<AtomicBool>,
    /// Ranges of the varied parameters, and limits of the constraints.
    pub domain: Domain,
}

/// Second derivatives of the drives in [`SearchProblem::subset`].
struct SecondDerivatives {
    /// Values of the varied parameters.
    at: Vec<f64>,
    /// For each drive and outcome, the Hessian times the multiplicity of the drive.
    of_drives: Vec<Vec<Vec<Vec<f64>>>>,
}

impl SearchProblem {
    /// The problem of a search over swings or one drive.
    ///
    /// # Errors
    /// [`Error::Nothing`] and [`Error::SearchRange`] for invalid ranges and limits;
    /// [`Error::Unreadable`] for a parameter that is both varied and distributed; the errors of
    /// [`Setup::validate`]; [`Error::NotConverged`] once `stop` is true.
    pub fn new(setup: &Setup<f64>, search: Search, stop: &Arc<AtomicBool>) -> Result<Self> {
        search.check()?;
        let problem = Self::of_goals(setup, search, stop)?;
        if problem.search.scenarios.is_one_drive() {
            let start = problem.domain.variables.project(&problem.start());
            problem.setup_at(&start)?.validate()?;
        }
        Ok(problem)
    }

    /// Like [`new`](Self::new), but the search may have no varied parameter. Such a problem only
    /// computes values of goals.
    ///
    /// # Errors
    /// The errors of [`new`](Self::new).
    pub fn of_goals(setup: &Setup<f64>, search: Search, stop: &Arc<AtomicBool>) -> Result<Self> {
        let domain = search.domain()?;
        let parameters: Vec<_> = search.parameters().collect();
        let scenarios = &search.scenarios;
        refuse_distributed(&search)?;
        let is_of_outcomes = search.is_of_outcomes();
        let mut outcomes: Vec<Outcome> = vec![];
        for outcome in search.outcomes() {
            if is_of_outcomes || !outcomes.contains(&outcome) {
                outcomes.push(outcome);
            }
        }
        let initialized = Vary::initialized(setup, &search.vary)?;
        // if a goal has a kink or jump, all scenarios are used: the second derivatives depend on
        // the few drives near the kink or jump, which a subset does not represent
        let (subset, multiplicities) = if search.goals().any(Goal::has_edge) {
            let count = scenarios.points.len();
            ((0..count).collect(), vec![1.0; count])
        } else {
            subset_of(scenarios)
        };
        let evaluator = |point: &Vec<f64>| {
            let setup = initialized.with_values(&scenarios.parameters, point)?;
            Evaluator::new(&setup, &outcomes, &parameters, Order::Second)
        };
        // report the error of the first scenario, independently of the threads
        let drives = each_until(&scenarios.points, stop, evaluator)
            .ok_or_else(|| stopped_before("all swings were set up"))?
            .into_iter()
            .collect::<Result<Vec<_>>>()?;
        Ok(Self {
            as_given: *setup,
            initialized,
            search,
            parameters,
            outcomes,
            drives,
            subset,
            multiplicities,
            second_derivatives: Mutex::default(),
            stop: Arc::clone(stop),
            domain,
        })
    }

    /// The problem with a limit for the defect of a drive (estimate of its integration error), m. A
    /// drive with a larger defect is repeated with shorter steps.
    pub fn with_largest_defect(mut self, largest_defect: f64) -> Self {
        let limited = |drive: Evaluator| drive.with_largest_defect(largest_defect);
        self.drives = self.drives.into_iter().map(limited).collect();
        self
    }

    pub fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// Start of the search: the setup's own values of the varied parameters. A parameter without a
    /// value starts in the middle of its range.
    pub fn start(&self) -> Vec<f64> {
        let own = |parameter: &&'static Parameter| self.initialized.value(parameter);
        self.parameters.iter().filter_map(own).collect()
    }

    /// The setup with the varied parameters set to `x`. The swing is the setup's own, not the swing
    /// of a scenario.
    pub fn setup_at(&self, x: &[f64]) -> Result<Setup<f64>> {
        self.initialized.with_values(&self.parameters, x)
    }

    /// Evaluator of the goals' outcomes without derivatives, for a search over one drive.
    pub fn evaluator(&self) -> Result<Evaluator> {
        Evaluator::new(
            &self.initialized,
            &self.outcomes,
            &self.parameters,
            Order::Value,
        )
    }

    /// Batch of the goals' outcomes, for a search over one drive.
    pub fn batch(&self) -> Result<Batch> {
        Batch::new(&self.initialized, &self.parameters, &self.outcomes, &[])
    }

    /// Values of the goals at `x`, for a search over one drive. `outcomes` are those of the drive.
    pub fn goals_of(&self, x: &[f64], outcomes: Vec<f64>) -> Vec<f64> {
        if self.search.is_of_outcomes() {
            return outcomes;
        }
        let columns: Vec<Vec<f64>> = outcomes.into_iter().map(|value| vec![value]).collect();
        self.exact_goals(x, &columns, &[1.0])
    }

    /// The objective and the constraint functions at `x`, with derivatives by the varied parameters
    /// and by one more parameter, for a search over one drive. Of the second derivatives, only
    /// those that involve the additional parameter are computed; the others are 0.
    pub fn evaluate_with(&self, x: &[f64], parameter: &'static Parameter) -> Result<Evaluation> {
        let wrt: Vec<_> = self.parameters.iter().copied().chain([parameter]).collect();
        let goals = derivative::last_hessian_row(&self.setup_at(x)?, &self.outcomes, &wrt)?;
        Ok(self.as_functions(goals))
    }

    /// Converts the goals to the objective, which is minimized, and the constraint functions.
    fn as_functions(&self, mut goals: Vec<Taylor>) -> Evaluation {
        let constraints = goals.split_off(1);
        let objective = goals.pop().unwrap_or_default();
        let objective = match self.search.sense {
            Sense::Maximize => objective.negated(),
            Sense::Minimize => objective,
        };
        Evaluation {
            objective,
            constraints,
        }
    }

    /// The outcomes of the scenarios with these indices, with derivatives up to an order.
    ///
    /// # Errors
    /// The first reason why the ball does not fly in a scenario; a message that the work was
    /// stopped, if `stop` is true.
    fn outcomes_at(
        &self,
        scenarios: &[usize],
        x: &[f64],
        order: Order,
        stop: &AtomicBool,
    ) -> std::result::Result<Vec<Vec<Taylor>>, String> {
        // keep the order of the scenarios: sums and the first error then do not depend on the
        // threads
        let flown = each_until(scenarios, stop, |k| {
            self.drives[*k].at_order(x, order, Some(stop))
        });
        let flown = flown
            .ok_or_else(|| "stopped before all swings were flown".to_owned())?
            .into_iter()
            .zip(scenarios);
        let scenarios_of_search = &self.search.scenarios;
        let named = |k: usize, error| {
            no_flight(scenarios_of_search, &scenarios_of_search.points[k], &error)
        };
        flown
            .map(|(drive, k)| drive.map_err(|error| named(*k, error)))
            .collect()
    }

    /// Second derivatives of the drives in `subset`, each times the number of scenarios that the
    /// drive represents. They are computed at the point nearest to `x` on a grid over the ranges.
    /// So they are computed only once near an optimum, and do not depend on the points evaluated
    /// before.
    fn second_derivatives(&self, x: &[f64]) -> std::result::Result<Arc<SecondDerivatives>, String> {
        let nearest: Vec<f64> = (0..x.len()).map(|i| self.on_the_grid(i, x[i])).collect();
        let cached = lock(&self.second_derivatives)
            .clone()
            .filter(|known| known.at == nearest);
        if let Some(known) = cached {
            return Ok(known);
        }
        let computed = |at: &[f64]| {
            let mut flown = self.outcomes_at(&self.subset, at, Order::Second, &self.stop)?;
            for (outcomes, factor) in flown.iter_mut().zip(&self.multiplicities) {
                let entries = outcomes
                    .iter_mut()
                    .flat_map(|outcome| outcome.hessian.iter_mut().flatten());
                entries.for_each(|entry| *entry *= factor);
            }
            let hessians = |outcomes: Vec<Taylor>| {
                outcomes
                    .into_iter()
                    .map(|outcome| outcome.hessian)
                    .collect()
            };
            Ok(Arc::new(SecondDerivatives {
                at: at.to_vec(),
                of_drives: flown.into_iter().map(hessians).collect(),
            }))
        };
        // a swing that does not fly at the nearest point of the grid may fly at `x`
        let found = computed(&nearest).or_else(|_: String| computed(x))?;
        *lock(&self.second_derivatives) = Some(Arc::clone(&found));
        Ok(found)
    }

    /// Value of parameter i nearest to `x` on the grid for second derivatives.
    fn on_the_grid(&self, i: usize, x: f64) -> f64 {
        /// Number of grid cells over the range of a parameter. A drive's second derivatives change
        /// by about 1 % from one cell to the next.
        const CELLS: f64 = 64.0;
        let [low, high] = [self.domain.variables.low[i], self.domain.variables.high[i]];
        let place = (CELLS * (x - low) / (high - low)).round() / CELLS;
        if place.is_finite() {
            (low + place * (high - low)).clamp(low, high)
        } else {
            x
        }
    }

    /// Value and derivatives of a measure that depends only on the design; `None` for a measure of
    /// drives.
    fn of_the_design(&self, measure: &Measure, x: &[f64], order: Order) -> Option<Taylor> {
        let (value, place) = match measure {
            Measure::One => (1.0, None),
            Measure::Parameter(parameter) => {
                let place = self.parameters.iter().position(|vary| vary == parameter);
                let own = self.initialized.value_or_unset(parameter);
                let value = place.map_or(own.unwrap_or(f64::NAN), |place| x[place]);
                (value, place)
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

    /// The goals at `x` with smoothed kinks and jumps, and their derivatives up to an order.
    /// `flown` has the outcomes of each scenario.
    fn smoothed_goals(
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
                    .filter_map(|of| self.outcomes.iter().position(|it| it == of))
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
        self.search.goals().map(goal).collect()
    }

    /// Exact values of the goals at `x`, without smoothing. `columns` has, for each outcome, its
    /// values in all scenarios.
    fn exact_goals(&self, x: &[f64], columns: &[Vec<f64>], weights: &[f64]) -> Vec<f64> {
        let term = |(weight, measure): &(f64, Measure)| {
            let value = self
                .of_the_design(measure, x, Order::Value)
                .map(|term| term.value);
            weight
                * value.unwrap_or_else(|| {
                    measure.exact(&self.columns_of(&measure.outcomes(), columns), weights)
                })
        };
        self.search
            .goals()
            .map(|goal| goal.terms.iter().map(term).sum())
            .collect()
    }

    fn columns_of<'a>(&self, outcomes: &[Outcome], columns: &'a [Vec<f64>]) -> Vec<&'a [f64]> {
        let places = outcomes
            .iter()
            .filter_map(|of| self.outcomes.iter().position(|it| it == of));
        places.map(|place| &columns[place][..]).collect()
    }

    /// Exact values of the goals at `x` over the scenarios: first the objective, then the limited
    /// goals. For a goal with a kink or jump, the swings of [`sequences`](Scenarios::sequences)
    /// replace the scenarios, if there are sequences and the ball flies in all their swings.
    ///
    /// # Errors
    /// [`Error::NoFlight`] if the ball does not fly in one of the scenarios;
    /// [`Error::NotConverged`] once `stop` is true.
    pub fn goals_at(&self, x: &[f64], stop: &AtomicBool) -> Result<Vec<f64>> {
        self.goals_of_setup(&self.setup_at(x)?, x, stop)
    }

    /// Values of the goals at the setup's own design. A varied parameter without a value in the
    /// setup remains unset.
    ///
    /// # Errors
    /// The errors of [`goals_at`](Self::goals_at).
    pub fn goals_as_set_up(&self) -> Result<Vec<f64>> {
        self.goals_of_setup(&self.as_given, &self.design_as_set_up(), &self.stop)
    }

    /// Exact values of the goals of a setup with the design `x`, with `weights` for the scenarios.
    ///
    /// # Errors
    /// The errors of [`goals_at`](Self::goals_at).
    pub fn goals_with_weights(
        &self,
        setup: &Setup<f64>,
        x: &[f64],
        weights: &[f64],
    ) -> Result<Vec<f64>> {
        let flown = columns(setup, &self.outcomes, &self.search.scenarios, &self.stop)?;
        Ok(self.exact_goals(x, &flown, weights))
    }

    /// Values of the goals at `x`, over each of the [`sequences`](Scenarios::sequences).
    ///
    /// # Errors
    /// The errors of [`goals_at`](Self::goals_at).
    pub fn replications(&self, x: &[f64]) -> Result<Vec<Vec<f64>>> {
        let setup = self.setup_at(x)?;
        let one = |sequence: Result<Scenarios>| {
            let sequence = sequence?;
            Ok(self.exact_goals(
                x,
                &columns(&setup, &self.outcomes, &sequence, &self.stop)?,
                &sequence.weights,
            ))
        };
        let sequences = self.search.scenarios.sequences().into_iter();
        sequences.map(one).collect()
    }

    /// Values of the varied parameters in the setup as given. A parameter without a value has the
    /// value of [`Parameter::unset`], or NaN if that is `None`.
    pub fn design_as_set_up(&self) -> Vec<f64> {
        let own = |parameter: &&'static Parameter| self.as_given.value_or_unset(parameter);
        let values = self.parameters.iter().map(own);
        values.map(|value| value.unwrap_or(f64::NAN)).collect()
    }

    /// Values of the goals of a setup with this design, as [`goals_at`](Self::goals_at) defines
    /// them.
    fn goals_of_setup(
        &self,
        setup: &Setup<f64>,
        design: &[f64],
        stop: &AtomicBool,
    ) -> Result<Vec<f64>> {
        let scenarios = &self.search.scenarios;
        let flown = columns(setup, &self.outcomes, scenarios, stop)?;
        let mut values = self.exact_goals(design, &flown, &scenarios.weights);
        if !self.search.goals().any(Goal::has_edge) {
            return Ok(values);
        }
        let mut all: Vec<Vec<f64>> = vec![vec![]; self.outcomes.len()];
        for sequence in scenarios.sequences() {
            let more = match columns(setup, &self.outcomes, &sequence?, stop) {
                Err(Error::NoFlight { .. }) => return Ok(values),
                more => more?,
            };
            all.iter_mut()
                .zip(more)
                .for_each(|(column, more)| column.extend(more));
        }
        let count = all[0].len();
        if count > 0 {
            let over_all = self.exact_goals(design, &all, &vec![1.0 / count as f64; count]);
            let with_edge = values
                .iter_mut()
                .zip(over_all)
                .zip(self.search.goals())
                .filter(|(_, goal)| goal.has_edge());
            with_edge.for_each(|((value, over_all), _)| *value = over_all);
        }
        Ok(values)
    }

    /// Values of the goals at `x` with smoothed kinks and jumps, with derivatives up to an order:
    /// first the objective, then the limited goals.
    ///
    /// # Errors
    /// [`Error::NoFlight`] if the ball does not fly in one of the swings; [`Error::NotConverged`]
    /// once `stop` is true.
    pub fn goals_until(&self, x: &[f64], order: Order, stop: &AtomicBool) -> Result<Vec<Taylor>> {
        let all: Vec<usize> = (0..self.drives.len()).collect();
        let flown = self.outcomes_at(&all, x, order, stop);
        let flown = flown.map_err(|reason| match stop.load(Ordering::Relaxed) {
            true => stopped_before("all swings were flown"),
            false => Error::NoFlight {
                status: "no-flight",
                reason: reason.into(),
            },
        })?;
        Ok(self.smoothed_goals(x, &flown, &self.search.scenarios.weights, order))
    }

    /// True if the varied parameter i has a negligible effect: at each of these points, no goal
    /// changes by more than [`Goal::negligible`] from one place of its range to another. False if
    /// the ball does not fly in one of the swings.
    pub fn is_idle(&self, i: usize, points: &[Vec<f64>]) -> bool {
        /// Places in the range, from 0 to 1. They are not symmetric, because the effect of a face
        /// angle is equal at both ends of a symmetric range.
        const PLACES: [f64; 5] = [0.0, 0.3, 0.5, 0.8, 1.0];
        let Domain { variables, .. } = &self.domain;
        let [low, high] = [variables.low[i], variables.high[i]];
        let goals_at = |point: &[f64], place: f64| {
            let mut x = point.to_vec();
            x[i] = low + place * (high - low);
            self.goals_until(&x, Order::Value, &self.stop).ok()
        };
        let is_unchanged = |point: &Vec<f64>| {
            let own = goals_at(point, PLACES[0])?;
            for place in &PLACES[1..] {
                let pairs = own.iter().zip(goals_at(point, *place)?);
                let is_equal = |((own, there), goal): ((&Taylor, Taylor), &Goal)| {
                    (there.value - own.value).abs() <= goal.negligible(own.value)
                };
                if !pairs.zip(self.search.goals()).all(is_equal) {
                    return Some(false);
                }
            }
            Some(true)
        };
        points.iter().all(|point| is_unchanged(point) == Some(true))
    }

    /// Share of the scenarios in which the ball ends at a distance to the hole outside the range of
    /// a table of strokes; `None` if no goal uses such a table.
    ///
    /// # Errors
    /// The errors of [`goals_at`](Self::goals_at).
    pub fn beyond_strokes(&self, x: &[f64]) -> Result<Option<f64>> {
        let tables: Vec<_> = self.search.goals().flat_map(Goal::strokes).collect();
        if tables.is_empty() {
            return Ok(None);
        }
        let scenarios = &self.search.scenarios;
        let flown = columns(&self.setup_at(x)?, &self.outcomes, scenarios, &self.stop)?;
        let ends: Vec<_> = tables
            .iter()
            .map(|(strokes, _)| self.columns_of(&strokes.outcomes, &flown))
            .collect();
        let is_beyond = |k: usize| {
            let mut all = tables.iter().zip(&ends);
            all.any(|((strokes, hole), end)| !strokes.reaches((hole - end[0][k]).hypot(end[1][k])))
        };
        let weights = scenarios.weights.iter().enumerate();
        Ok(Some(
            weights
                .filter(|(k, _)| is_beyond(*k))
                .map(|(_, weight)| weight)
                .sum(),
        ))
    }

    /// The objective and the constraint functions over the scenarios with these weights, with
    /// smoothed kinks and jumps. Values and gradients use all drives. A Hessian has terms with
    /// products of gradients, which use all drives, and terms with second derivatives, which use
    /// only the drives in `subset`.
    pub fn weighted(&self, x: &[f64], weights: &[f64]) -> std::result::Result<Evaluation, String> {
        if let ([drive], true) = (self.drives.as_slice(), self.search.is_of_outcomes()) {
            let goals = drive.at(x).map_err(|error| error.to_string())?;
            return Ok(self.as_functions(goals));
        }
        let all: Vec<usize> = (0..self.drives.len()).collect();
        let flown = if self.subset.len() == all.len() {
            self.outcomes_at(&all, x, Order::Second, &self.stop)?
        } else {
            let mut flown = self.outcomes_at(&all, x, Order::First, &self.stop)?;
            let known = self.second_derivatives(x)?;
            for (k, of_drive) in self.subset.iter().zip(&known.of_drives) {
                flown[*k]
                    .iter_mut()
                    .zip(of_drive)
                    .for_each(|(outcome, hessian)| outcome.hessian.clone_from(hessian));
            }
            flown
        };
        Ok(self.as_functions(self.smoothed_goals(x, &flown, weights, Order::Second)))
    }
}

/// Refuses a parameter of the swings if the search varies it too, or if a relation of the design
/// contains it.
fn refuse_distributed(search: &Search) -> Result<()> {
    let distributed = &search.scenarios.parameters;
    let refuse =
        |parameter: &Parameter, reason: &str| Err(Error::unreadable(parameter.name, reason));
    let mut varied = search.parameters();
    if let Some(parameter) = varied.find(|parameter| distributed.contains(parameter)) {
        return refuse(
            parameter,
            "it is varied, and the swings have values of it; vary another parameter, or remove it \
             from the swings",
        );
    }
    for (_, measure) in search.goals().flat_map(|goal| &goal.terms) {
        if let Measure::Parameter(parameter) = measure
            && distributed.contains(parameter)
        {
            return refuse(
                parameter,
                "a relation of the design contains it, and the swings have values of it; remove \
                 it from the relation or from the swings",
            );
        }
    }
    Ok(())
}

impl Problem for SearchProblem {
    fn evaluate(&self, x: &[f64]) -> std::result::Result<Evaluation, String> {
        self.weighted(x, &self.search.scenarios.weights)
    }
}
