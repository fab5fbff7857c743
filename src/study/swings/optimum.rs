use super::problem::SwingsProblem;
use super::read::{Goal, GoalLimit};
use super::scenarios::Scenarios;
use crate::error::{Error, Result};
use crate::optimize::{
    Constrained, Domain, Follow, Local, Options, Problem, Solution, Status, minimize_from, starts,
};
use crate::parameters::{Setup, Vary};
use crate::study::Sense;
use crate::study::optimum::stopped_of;
use crate::study::stoppable::stopped;
use crate::units::Quantity;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// What to look for over many swings.
#[derive(Clone, Debug)]
pub struct SwingsSearch {
    /// The goal to make as large or as small as possible.
    pub of: Goal,
    /// Which of the two.
    pub sense: Sense,
    /// The parameters of the design to vary.
    pub vary: Vec<Vary>,
    /// Goals to hold between limits.
    pub subject_to: Vec<GoalLimit>,
    /// The optimizer's settings.
    pub options: Options,
}

/// The design that is best for all swings.
#[derive(Clone, Debug)]
pub struct SwingsOptimum {
    /// What was asked.
    pub search: SwingsSearch,
    /// The swings.
    pub scenarios: Scenarios,
    /// How the best search ended; its objective is the goal times [`Sense::sign`], with smoothed
    /// edges.
    pub solution: Solution,
    /// Where the searches from all starts ended, the best first.
    pub locals: Vec<Local>,
    /// The goals by their definitions where each of them ended: the objective, then what is
    /// limited; `None` where a swing does not fly.
    pub local_goals: Vec<Option<Vec<f64>>>,
    /// The setup with the best design.
    pub setup: Setup<f64>,
    /// The goals over the swings with the setup's own design: the objective, then what is limited;
    /// `None` where a swing does not fly.
    pub as_set_up: Option<Vec<f64>>,
    /// The share of the swings whose ball ends at the optimum where the table of strokes does not
    /// reach, and is continued straight; `None` too where the search was stopped.
    pub beyond_strokes: Option<f64>,
}

impl SwingsOptimum {
    /// The goal at the optimum, SI.
    pub fn value(&self) -> Option<f64> {
        Some(self.goals()?[0])
    }

    /// How many searches there were.
    pub fn starts(&self) -> usize {
        self.locals.iter().map(|local| local.starts.len()).sum()
    }

    /// The ends of the searches that came to one, the best first, each with the goal there, SI.
    pub fn ended(&self) -> impl Iterator<Item = (&Local, Option<f64>)> {
        let goals = self
            .local_goals
            .iter()
            .map(|goals| Some(goals.as_ref()?[0]));
        self.locals
            .iter()
            .zip(goals)
            .filter(|(local, _)| local.solution.status != Status::Interrupted)
    }

    /// How many searches were stopped from outside before they ended.
    pub fn stopped(&self) -> usize {
        self.starts()
            - self
                .ended()
                .map(|(local, _)| local.starts.len())
                .sum::<usize>()
    }

    /// How far the searches came, if any was stopped from outside before it ended.
    pub fn interrupted(&self) -> Option<String> {
        stopped_of(self.stopped(), self.starts(), || self.message())
    }

    /// The goal's gradient at the optimum by what is varied, SI.
    pub fn gradient(&self) -> Vec<f64> {
        self.solution
            .gradient
            .iter()
            .map(|slope| self.search.sense.sign() * slope)
            .collect()
    }

    /// The goals at the optimum: the objective, then what is limited.
    pub fn goals(&self) -> Option<&[f64]> {
        self.local_goals.first()?.as_deref()
    }

    /// Each limit at the optimum: its value and violation by the goal's definition, its multiplier
    /// by the search.
    pub fn limits(&self) -> impl Iterator<Item = (&GoalLimit, Constrained)> {
        let values = self.goals().map_or(&[][..], |goals| &goals[1..]);
        let all = self
            .search
            .subject_to
            .iter()
            .zip(values)
            .zip(&self.solution.constraints);
        all.map(|((limit, value), at)| {
            (
                limit,
                Constrained {
                    value: *value,
                    violation: limit.violation(*value),
                    ..*at
                },
            )
        })
    }

    /// How the search ended, in a sentence.
    pub fn message(&self) -> String {
        match self.solution.status {
            Status::Undefined => {
                let why = self
                    .solution
                    .undefined_at_start
                    .as_deref()
                    .unwrap_or("no drive flies");
                format!("no design was found with which every swing flies; at the start: {why}")
            }
            Status::Infeasible => violated(&self.search.subject_to, &self.solution, self.goals()),
            Status::Interrupted if self.solution.value.is_none() => {
                "stopped before a design was found with which every swing flies".into()
            }
            Status::Converged if self.is_flat() => {
                format!(
                    "{} does not depend on what is varied here: every design is equally good",
                    self.search.of.expression
                )
            }
            Status::Converged => {
                let idle = (0..self.search.vary.len()).filter(|i| self.is_idle(*i));
                let idle: Vec<_> = idle.map(|i| self.search.vary[i].parameter.name).collect();
                let little = match self.search.of.quantity {
                    Quantity::LENGTH => "1 mm",
                    _ => "a millionth of it",
                };
                let (goal, found) = (&self.search.of.expression, &self.solution.message);
                match idle.as_slice() {
                    [] => found.clone(),
                    [one] => format!(
                        "{found}; {one} has no effect worth telling: within its range it changes \
                         {goal} by less than {little}"
                    ),
                    all => format!(
                        "{found}; {} have no effect worth telling: within its range each changes \
                         {goal} by less than {little}",
                        all.join(" and ")
                    ),
                }
            }
            _ => self.solution.message.clone(),
        }
    }

    /// Whether a varied parameter changes the goal within its range, to second order, by less than
    /// a millimetre, or a millionth of what is no length. Such a goal has its optimum at a bound or
    /// anywhere by chance.
    pub fn is_idle(&self, i: usize) -> bool {
        let width = |i: usize| self.search.vary[i].high - self.search.vary[i].low;
        let little = match self.search.of.quantity {
            Quantity::LENGTH => 1e-3,
            _ => 1e-6 * self.value().unwrap_or_default().abs(),
        };
        let Some(slope) = self.solution.gradient.get(i).filter(|_| width(i) > 0.0) else {
            return false;
        };
        let bends = self
            .solution
            .hessian
            .get(i)
            .into_iter()
            .flatten()
            .enumerate();
        let bends: f64 = bends
            .map(|(j, bend)| (bend * width(i) * width(j)).abs())
            .sum();
        (slope * width(i)).abs() + bends < little
    }

    /// Whether the goal does not change within the ranges, to second order, by more than rounding.
    fn is_flat(&self) -> bool {
        const ROUNDING: f64 = 1e-10;
        let width = |i: usize| self.search.vary[i].high - self.search.vary[i].low;
        let n = self.search.vary.len();
        let slopes = self
            .solution
            .gradient
            .iter()
            .enumerate()
            .map(|(i, slope)| slope * width(i));
        let bends = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
        let bends =
            bends.filter_map(|(i, j)| Some(self.solution.hessian.get(i)?[j] * width(i) * width(j)));
        slopes.chain(bends).all(|change| change.abs() < ROUNDING)
    }

    /// The status in a word.
    pub fn status(&self) -> &'static str {
        status_of(&self.solution)
    }
}

/// How a search over swings ended, in a word.
pub fn status_of(solution: &Solution) -> &'static str {
    match solution.status {
        Status::Undefined => "no-flight",
        status => status.name(),
    }
}

/// Which limits the nearest design found violates, with its goals.
pub(super) fn violated(limits: &[GoalLimit], found: &Solution, goals: Option<&[f64]>) -> String {
    let all = limits.iter().zip(&found.constraints).enumerate();
    let missed = all.filter(|(_, (_, constrained))| constrained.violation != 0.0);
    let missed = missed.map(|(j, (limit, constrained))| {
        let value = goals.map_or(constrained.value, |goals| goals[1 + j]);
        let [value, outside] = [value, limit.violation(value).abs()]
            .map(|value| limit.goal.quantity.show(value, limit.goal.unit));
        let is_fixed = found.jacobian[j].iter().all(|slope| *slope == 0.0);
        let fixed = if is_fixed {
            "nothing that is varied changes it at this design: "
        } else {
            ""
        };
        format!(
            "{} ({fixed}it is {value}, outside by {outside})",
            limit.expression
        )
    });
    let missed: Vec<_> = missed.collect();
    format!(
        "no design was found that meets the limits; the nearest one violates {}",
        missed.join(" and ")
    )
}

/// Finds the design that makes a goal over many swings largest or smallest, from the setup's own
/// values; a varied parameter that has none begins in the middle of its range. The scenarios are
/// the same for every design, so that the goal is a smooth function of it, with exact gradients and
/// Hessians.
///
/// ```
/// use longdrive::Setup;
/// use longdrive::optimize::{Follow, Options};
/// use longdrive::study::swings::{Goal, Rule, Scenarios, Swings, SwingsSearch, swings_optimum};
/// use longdrive::study::{Sense, Vary, uncertainty::Uncertain};
///
/// let setup = Setup::preset("mae494").unwrap();
/// let attack = Uncertain::read(&setup, "swing.attack_angle=uniform(0deg, 10deg)").unwrap();
/// let swings = Swings::distributed(vec![attack], &[]).unwrap();
/// let search = SwingsSearch {
///     of: Goal::read("mean(carry)", None).unwrap(),
///     sense: Sense::Maximize,
///     vary: vec![Vary::read(&setup, "club.loft=4deg..20deg").unwrap()],
///     subject_to: vec![],
///     options: Options::default(),
/// };
/// let scenarios = Scenarios::new(&swings, Rule::of(&swings, None, 0).unwrap()).unwrap();
/// let best = swings_optimum(&setup, search, scenarios, &Follow::default()).unwrap();
/// assert_eq!(best.status(), "converged");
/// ```
///
/// # Errors
/// [`Error::Nothing`] where nothing is varied; [`Error::SearchRange`] for a parameter that is
/// varied twice, or that the swings have values of; what [`Setup::validate`] refuses;
/// [`Error::NotConverged`] where it is stopped before the search begins.
pub fn swings_optimum(
    setup: &Setup<f64>,
    search: SwingsSearch,
    scenarios: Scenarios,
    follow: &Follow,
) -> Result<SwingsOptimum> {
    swings_optima(setup, search, scenarios, 1, follow)
}

/// The same from `count` starts side by side: the setup's own values, and others spread evenly over
/// the ranges.
///
/// # Errors
/// As [`swings_optimum`]; more starts than can be spread.
pub fn swings_optima(
    setup: &Setup<f64>,
    search: SwingsSearch,
    scenarios: Scenarios,
    count: usize,
    follow: &Follow,
) -> Result<SwingsOptimum> {
    let problem = posed(setup, &search, scenarios, &follow.interrupt)?;
    let starts = starts(&problem.domain, &problem.start(), count.max(1))?;
    let is_stopped = || follow.interrupt.load(Ordering::Relaxed);
    let as_set_up = problem.as_set_up().ok();
    if as_set_up.is_none() && is_stopped() {
        return Err(stopped("the search began"));
    }
    let locals = minimize_from(&problem, &problem.domain, &starts, &search.options, follow)?;
    // also after a stop: what was found until then is told
    let never = AtomicBool::new(false);
    let goals = |local: &Local| {
        problem
            .values_until(local.solution.value.map(|_| &local.solution.x)?, &never)
            .ok()
    };
    let local_goals = locals.iter().map(goals).collect();
    let best = locals.first().ok_or(Error::Nothing {
        doing: "search from",
        what: "start",
    })?;
    let solution = best.solution.clone();
    let beyond_strokes = match solution.value {
        Some(_) => problem
            .beyond_strokes(&solution.x)
            .or_else(|error| if is_stopped() { Ok(None) } else { Err(error) })?,
        None => None,
    };
    let setup = problem.moved(&solution.x)?;
    let scenarios = problem.scenarios().clone();
    Ok(SwingsOptimum {
        search,
        scenarios,
        solution,
        locals,
        local_goals,
        setup,
        as_set_up,
        beyond_strokes,
    })
}

/// What a search minimizes, with where it begins: the goal times [`Sense::sign`], and what is
/// limited, with exact derivatives, over the ranges of what is varied. For a look at the objective,
/// or for another optimizer.
///
/// # Errors
/// As [`swings_optimum`].
pub fn swings_problem(
    setup: &Setup<f64>,
    search: &SwingsSearch,
    scenarios: Scenarios,
) -> Result<(impl Problem + use<>, Domain, Vec<f64>)> {
    let problem = posed(setup, search, scenarios, &Arc::default())?;
    let (domain, start) = (problem.domain.clone(), problem.start());
    let start = domain.variables.project(&start);
    Ok((problem, domain, start))
}

/// The search as a problem, if it makes sense; it fails once `stop` is true.
pub(super) fn posed(
    setup: &Setup<f64>,
    search: &SwingsSearch,
    scenarios: Scenarios,
    stop: &Arc<AtomicBool>,
) -> Result<SwingsProblem> {
    if search.vary.iter().all(|vary| vary.low == vary.high) {
        return Err(Error::Nothing {
            doing: "vary",
            what: "parameter with a range wider than a single value",
        });
    }
    for (i, vary) in search.vary.iter().enumerate() {
        if search.vary[..i]
            .iter()
            .any(|before| before.parameter == vary.parameter)
        {
            let reason = "it is varied twice; give it one range".into();
            return Err(Error::SearchRange {
                name: vary.parameter.name.into(),
                reason,
            });
        }
    }
    SwingsProblem::new(
        setup,
        (&search.of, search.sense),
        &search.subject_to,
        &search.vary,
        scenarios,
        stop,
    )
}

/// Some goals over the swings with a setup's own design, each SI; `None` where a swing does not
/// fly, or once `stop` is true.
///
/// # Errors
/// As [`swings_optimum`].
pub fn goals_of(
    setup: &Setup<f64>,
    goals: &[Goal],
    vary: &[Vary],
    scenarios: &Scenarios,
    stop: &Arc<AtomicBool>,
) -> Result<Option<Vec<f64>>> {
    let one = |goal: &Goal| {
        let problem = SwingsProblem::new(
            setup,
            (goal, Sense::Maximize),
            &[],
            vary,
            scenarios.clone(),
            stop,
        )?;
        Ok(problem.as_set_up().ok().map(|values| values[0]))
    };
    let found = goals.iter().map(one).collect::<Result<Vec<_>>>()?;
    Ok(found.into_iter().collect())
}
