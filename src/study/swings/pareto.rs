use super::scenarios::Scenarios;
use crate::error::{Error, Result};
use crate::optimize::front::{Front, FrontError, FrontEvent, FrontPoint, front};
use crate::optimize::sensitivity::ActiveSet;
use crate::optimize::{Observers, Options, Problem, Status, starts};
use crate::parameters::{Parameter, Setup, Vary};
use crate::study::cancellable::stopped_before;
use crate::study::optimum::optimum;
use crate::study::problem::SearchProblem;
use crate::study::verdict::{Active, active, solver_message, status_name, violated_by_design};
use crate::study::{ChartEvent, Constraint, Goal, Search, Sense};
use crate::units::Message;
use std::sync::atomic::{AtomicBool, Ordering};

/// A search for the best compromises between two goals.
#[derive(Clone, Debug)]
pub struct ParetoSearch {
    /// The two goals, each with its direction.
    pub goals: [(Goal, Sense); 2],
    /// The varied parameters, with their ranges.
    pub vary: Vec<Vary>,
    /// The constraints.
    pub subject_to: Vec<Constraint>,
    /// The swings, or [one drive](Scenarios::one_drive).
    pub scenarios: Scenarios,
    /// Number of points, spread evenly along the front and including its ends.
    pub points: usize,
    /// Settings of the optimizer.
    pub options: Options,
}

/// The best compromises between two goals, from the optimum of the first goal to the optimum of the
/// second.
#[derive(Clone, Debug)]
pub struct Pareto {
    /// The search.
    pub search: ParetoSearch,
    /// The compromises, in order.
    pub points: Vec<ParetoPoint>,
    /// Index of the knee (see [`Front::knee`]); `None` if the front has no knee.
    pub knee: Option<usize>,
    /// The largest distance of the front from the straight line between its ends, towards better
    /// values, divided by the length of the line. Both goals are scaled to run from 0 to 1 between
    /// the ends.
    pub relative_bulge: f64,
    /// Varied parameters with a negligible effect on both goals and all limited goals. Their range in
    /// `search` is their own value.
    pub idle: Vec<&'static Parameter>,
    /// Values of the goals at the setup's own design; `None` if the ball does not fly in one of the
    /// swings.
    pub as_set_up: Option<[f64; 2]>,
    /// The number of dominated points, which `points` does not contain.
    pub dominated: usize,
    /// The reason why a part of the front is missing, if any.
    pub ended: Option<String>,
    /// True if the computation was interrupted.
    pub interrupted: bool,
}

/// A point of the front: no other design is better in both goals.
#[derive(Clone, Debug)]
pub struct ParetoPoint {
    /// The varied parameters, SI.
    pub design: Vec<f64>,
    /// The two goals, SI.
    pub goals: [f64; 2],
    /// Slope d first/d second along the front: the change of the first goal per unit of the second.
    /// `None` at a kink of the front.
    pub slope: Option<f64>,
    /// The active bounds and constraints.
    pub active: Vec<Active>,
    /// Text on a change of the active set, or a jump to another branch of designs, at this point.
    /// `None` if there is neither.
    pub event_text: Option<String>,
    /// True if the front is disconnected between the previous point and this one.
    pub is_after_gap: bool,
    /// The setup with this design.
    pub setup: Setup<f64>,
}

impl Pareto {
    /// The status in a word.
    pub fn status(&self) -> &'static str {
        match &self.ended {
            _ if self.interrupted => "interrupted",
            Some(_) => "partial",
            None => "done",
        }
    }

    /// The reason why the front has no knee; `None` if it has a knee, or after an interrupt.
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
                "no knee: the front is nearly straight, or bends away from the better values"
                    .into(),
            ),
        }
    }
}

/// The best compromises between two goals over swings, or between two outcomes of one drive.
///
/// # Errors
/// [`Error::NotConverged`] if the search for the best value of one goal does not converge; the
/// errors of [`optimum`](crate::study::optimum).
pub fn pareto(setup: &Setup<f64>, mut search: ParetoSearch, follow: &Observers) -> Result<Pareto> {
    let [(_, sense), (_, against)] = search.goals;
    let mut problem = SearchProblem::new(setup, search.first_goal(), &follow.interrupt)?;
    let idle = search.fix_idle(&problem)?;
    if !idle.is_empty() {
        problem = SearchProblem::new(setup, search.first_goal(), &follow.interrupt)?;
    }
    let own = problem.goals_as_set_up();
    if own.is_err() && follow.interrupt.load(Ordering::Relaxed) {
        return Err(stopped_before("the search began"));
    }
    let minimized = |x: &[f64]| {
        let mut functions = problem.evaluate(x)?;
        if against == Sense::Maximize {
            let second = functions.constraints.pop().unwrap_or_default();
            functions.constraints.push(second.negated());
        }
        Ok(functions)
    };
    let starts_of = |function: usize| search.starts_of_end(function, &problem, follow);
    let found = front(
        &minimized,
        &problem.domain,
        starts_of,
        &search.options,
        search.points,
        follow,
    );
    let Front {
        points,
        knee,
        relative_bulge,
        dominated,
        ended,
        interrupted,
    } = found.map_err(|error| named(error, &search, &problem))?;
    // convert the slope of the minimized functions to the slope of the goals
    let sign = sense.sign() * against.sign();
    let point = |point: FrontPoint| search.point(&problem, point, sign);
    let points = points.into_iter().map(point).collect::<Result<Vec<_>>>()?;
    let as_set_up = own
        .ok()
        .and_then(|values| Some([*values.first()?, *values.last()?]));
    Ok(Pareto {
        search,
        points,
        knee,
        relative_bulge,
        idle,
        as_set_up,
        dominated,
        ended,
        interrupted,
    })
}

impl ParetoSearch {
    /// The two goals, then the limited goals.
    pub fn all_goals(&self) -> impl Iterator<Item = &Goal> {
        let limited = self.subject_to.iter().map(|constraint| &constraint.goal);
        self.goals.iter().map(|(goal, _)| goal).chain(limited)
    }

    /// The search for the best value of the first goal. The second goal is a constraint without
    /// limits, so that its values are computed too.
    fn first_goal(&self) -> Search {
        let [(first, sense), (second, _)] = self.goals.clone();
        let mut subject_to = self.subject_to.clone();
        subject_to.push(Constraint::unlimited(second));
        Search {
            of: first,
            sense,
            vary: self.vary.clone(),
            subject_to,
            scenarios: self.scenarios.clone(),
            options: self.options.clone(),
        }
    }

    /// Fixes the varied parameters with a negligible effect on all goals at their own values, and
    /// returns these parameters. If varied, such a parameter may jump from one bound to the other
    /// along the front. Fixes none if all have a negligible effect.
    fn fix_idle(&mut self, problem: &SearchProblem) -> Result<Vec<&'static Parameter>> {
        /// Number of points of the ranges at which the effect of a parameter is computed.
        const POINTS: usize = 4;
        let own = problem.domain.variables.project(&problem.start());
        let points = starts(&problem.domain, &own, POINTS)?;
        let is_idle = |vary: &Vary, i: usize| vary.low < vary.high && problem.is_idle(i, &points);
        let varied = self.vary.iter().zip(0..);
        let idle: Vec<_> = varied
            .filter(|(vary, i)| is_idle(vary, *i))
            .map(|(_, i)| i)
            .collect();
        let varied = self.vary.iter().filter(|vary| vary.low < vary.high);
        if idle.len() == varied.count() {
            return Ok(vec![]);
        }
        for &i in &idle {
            (self.vary[i].low, self.vary[i].high) = (own[i], own[i]);
        }
        Ok(idle.into_iter().map(|i| self.vary[i].parameter).collect())
    }

    /// The starts of the searches for an end of the front: the setup's own design, and the optimum
    /// of the goal with the index `function`, if there is one.
    fn starts_of_end(
        &self,
        function: usize,
        problem: &SearchProblem,
        follow: &Observers,
    ) -> Result<Vec<Vec<f64>>> {
        let (of, sense) = self.goals[function].clone();
        let search = Search {
            of,
            sense,
            subject_to: self.subject_to.clone(),
            ..problem.search.clone()
        };
        let own = problem.domain.variables.project(&problem.start());
        match optimum(&problem.as_given, search, follow.of_search(function)) {
            Ok(best) if best.is_converged() => Ok(vec![own, best.solution.x]),
            Ok(_) | Err(Error::NotConverged { .. }) => Ok(vec![own]),
            Err(error) => Err(error),
        }
    }

    /// Converts a point of the optimizer's front. Its goals are computed even after an interrupt.
    /// `sign` converts the slope of the minimized functions to the slope of the goals.
    fn point(&self, problem: &SearchProblem, point: FrontPoint, sign: f64) -> Result<ParetoPoint> {
        let values = problem.goals_at(&point.x, &AtomicBool::new(false))?;
        let active = self.active(&point.x, &point.active_set);
        let event_text = point.event.as_ref().map(|event| match event {
            FrontEvent::Jump => "from here on another branch of designs is better".to_owned(),
            FrontEvent::Changed { before } => {
                ChartEvent::between(&self.active(&point.x, before), &active).to_string()
            }
        });
        Ok(ParetoPoint {
            setup: problem.setup_at(&point.x)?,
            goals: [values[0], values[values.len() - 1]],
            slope: point.slope.map(|slope| sign * slope),
            is_after_gap: point.event == Some(FrontEvent::Jump),
            design: point.x,
            active,
            event_text,
        })
    }

    fn active(&self, x: &[f64], held: &ActiveSet) -> Vec<Active> {
        let is_lower = |i: usize| x[i] - self.vary[i].low <= self.vary[i].high - x[i];
        active(&self.vary, &self.subject_to, held, is_lower)
    }
}

/// The error for an end of the front that was not found. It names the goal whose best value lies at
/// this end.
fn named(none: FrontError, search: &ParetoSearch, problem: &SearchProblem) -> Error {
    let (function, found) = match none {
        FrontError::NoEnd { function, found } => (function, found),
        FrontError::Refused(error) => return error,
    };
    let (goal, sense) = &search.goals[function];
    let why = match (&found.undefined_at_start, found.status) {
        (Some(why), Status::Undefined) => why.as_str().into(),
        (_, Status::Infeasible) => violated_by_design(
            &search.subject_to,
            &found,
            problem.goals_at(&found.x, &problem.stop).ok().as_deref(),
        ),
        _ => solver_message(&found, (goal, *sense), &search.vary),
    };
    Error::NotConverged {
        status: status_name(found.status),
        message: Message::from(format!("for the {}: ", sense.best_of(goal))).message(why),
    }
}
