//! The search for the optimum: of one drive, or of a design over swings that vary.
//!
//! ```text
//!   setup, Search ──▶ SearchProblem ──▶ local searches from starts ──▶ best end
//!   one drive:  best end ──▶ compared with drives at sample points, searches from better points
//!   swings:     ends ──▶ goals without smoothing
//! ```

use super::cancellable::stopped_before;
use super::goal::{Constraint, ConstraintAtEnd};
use super::problem::SearchProblem;
use super::sample::{Sample, compare_with_sample};
use super::search::Search;
use crate::drive::{Drive, Outcome};
use crate::error::{Error, Result};
use crate::optimize::{
    LocalMinimum, Observer, Observers, Solution, Status, minimize_from, minimize_observed, starts,
};
use crate::parameters::Setup;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// The best drive, or the best design over swings, that a search found.
#[derive(Clone, Debug, PartialEq)]
pub struct Optimum {
    /// The search.
    pub search: Search,
    /// Result of the local search. Its objective is the goal times
    /// [`Sense::sign`](super::Sense::sign). For a search over swings, kinks and jumps of the goal
    /// are smoothed.
    pub solution: Solution,
    /// Exact values of the goals at the optimum, without smoothing, SI: first the objective, then
    /// the limited goals. `None` if the ball does not fly in one of the drives.
    pub goals: Option<Vec<f64>>,
    /// The setup at the optimum.
    pub setup: Setup<f64>,
    /// The drive at the optimum, for a search over one drive; `None` if no drive of the search
    /// flies.
    pub drive: Option<Drive<f64>>,
    /// The setup as given to the search. A varied parameter may have no value.
    pub start: Setup<f64>,
    /// The drive of `start`, for a search over one drive; `None` if it cannot be computed, for
    /// example because the club does not strike the ball, or because a varied parameter that the
    /// drive needs has no value.
    pub drive_as_set_up: Option<Drive<f64>>,
    /// Comparison of the optimum of one drive with points sampled from the ranges; `None` after a
    /// local search, and after an interrupted search.
    pub sample: Option<Sample>,
    /// The values of the goals over the swings at the setup's own design. `None` if the ball does
    /// not fly in one of the swings, and for a search over one drive.
    pub as_set_up: Option<Vec<f64>>,
    /// The fraction of the swings that end at a distance to the hole outside the range of the table
    /// of strokes. `None` without a table, and after an interrupted search.
    pub beyond_strokes: Option<f64>,
}

impl Optimum {
    /// True if reports compare both carry and total before and after the search. This is the case
    /// if the objective is carry or total, and the ball runs after it lands.
    pub fn compares_totals(&self) -> bool {
        let is_distance = [Outcome::Carry, Outcome::Total].map(Some);
        let run = self
            .drive
            .as_ref()
            .and_then(|drive| Outcome::Run.value(drive));
        is_distance.contains(&self.search.of.outcome()) && run.is_some_and(|run| run != 0.0)
    }

    /// The constraints that the drive as set up violates, for a search over one drive.
    pub fn violated_as_set_up(&self) -> Vec<&Constraint> {
        let is_violated = |constraint: &&Constraint| {
            let value = self.as_set_up_by_drive(constraint);
            value.is_some_and(|value| !constraint.is_met(value))
        };
        self.search.subject_to.iter().filter(is_violated).collect()
    }

    /// The limited outcome of the drive as set up, SI; `None` if it has no value.
    pub fn as_set_up_by_drive(&self, constraint: &Constraint) -> Option<f64> {
        let drive = self.drive_as_set_up.as_ref()?;
        constraint.goal.outcome()?.value(drive)
    }

    /// True if the search converged, so that the result is an optimum.
    pub fn is_converged(&self) -> bool {
        self.solution.status == Status::Converged
    }

    pub(crate) fn check_converged(&self) -> Result<()> {
        if self.is_converged() {
            return Ok(());
        }
        Err(Error::NotConverged {
            status: self.status(),
            message: self.message(),
        })
    }

    /// The problem of a search over one drive, with the setup at the optimum.
    ///
    /// # Errors
    /// [`Error::NotConverged`] without a converged optimum; [`Error::Unreadable`] for a search over
    /// swings.
    pub(super) fn problem(&self) -> Result<SearchProblem> {
        self.check_converged()?;
        self.search.refuse_swings()?;
        SearchProblem::new(&self.setup, self.search.clone(), &Arc::default())
    }

    /// The objective at the optimum, SI; `None` if the ball does not fly in one of the drives.
    pub fn value(&self) -> Option<f64> {
        Some(self.goals.as_ref()?[0])
    }

    /// The gradient of the objective by the varied parameters, SI.
    pub fn gradient(&self) -> Vec<f64> {
        let sign = self.search.sense.sign();
        let slopes = self.solution.gradient.iter();
        slopes.map(|slope| sign * slope).collect()
    }

    /// The constraints at the optimum. Value and violation follow the exact definition of the goal;
    /// the multiplier comes from the search.
    pub fn constraints(&self) -> Vec<ConstraintAtEnd<'_>> {
        let exact_values = match &self.goals {
            Some(goals) if !self.search.is_of_outcomes() => &goals[1..],
            _ => &[],
        };
        let limits = self.search.subject_to.iter().enumerate();
        limits
            .zip(&self.solution.constraints)
            .map(|((j, constraint), at)| {
                let exact = exact_values.get(j);
                let at = exact.map_or(*at, |value| constraint.exactly(*value, at));
                ConstraintAtEnd {
                    constraint,
                    at,
                    slopes: self.solution.jacobian.get(j).map_or(&[], Vec::as_slice),
                    // a multiplier is the gain for each unit by which the limit is raised; it is
                    // negative at a lower limit
                    gain: if constraint.is_equation() {
                        at.multiplier
                    } else {
                        at.multiplier.abs()
                    },
                }
            })
            .collect()
    }
}

/// A local optimum at which one or more searches ended.
#[derive(Clone, Debug)]
pub struct LocalOptimum {
    /// Result of the search.
    pub solution: Solution,
    /// Exact objective at the optimum, SI; `None` if a drive does not fly.
    pub value: Option<f64>,
    /// Indices, from 0, of the starts whose searches ended at the optimum.
    pub starts: Vec<usize>,
}

/// The optimum of searches from several starts.
#[derive(Clone, Debug)]
pub struct Optima {
    /// The best optimum.
    pub best: Optimum,
    /// All local optima, best first.
    pub locals: Vec<LocalOptimum>,
    /// The number of starts that were requested.
    pub requested: usize,
    /// True if a start that was not requested led to the best optimum: a point of the [`Sample`],
    /// or the optimum of the club alone with the swing as set up. Its index in
    /// [`LocalOptimum::starts`] follows those of the requested starts.
    pub has_extra_start: bool,
}

impl Optima {
    /// True if several starts were requested.
    pub fn has_several_starts(&self) -> bool {
        self.requested > 1
    }

    /// The number of starts, with the further one.
    pub fn starts(&self) -> usize {
        self.requested + usize::from(self.has_extra_start)
    }

    /// True if no search was interrupted and the best one converged.
    pub fn is_found(&self) -> bool {
        self.best.is_converged() && self.stopped() == 0
    }

    /// Local optima of the searches that were not interrupted, best first.
    pub fn ended(&self) -> impl Iterator<Item = &LocalOptimum> {
        self.locals
            .iter()
            .filter(|local| local.solution.status != Status::Interrupted)
    }

    /// The number of interrupted searches.
    pub fn stopped(&self) -> usize {
        let ended = self.ended().map(|local| local.starts.len());
        self.starts() - ended.sum::<usize>()
    }

    /// Message on the progress of the searches, if any was interrupted.
    pub fn interrupted(&self) -> Option<String> {
        stopped_of(self.stopped(), self.starts(), || {
            self.best.message().to_string()
        })
    }
}

/// Message on the progress of searches; `None` if none was interrupted. If there is only one
/// search, `only` returns the message.
pub(super) fn stopped_of(
    stopped: usize,
    all: usize,
    only: impl FnOnce() -> String,
) -> Option<String> {
    (stopped > 0).then(|| match all {
        1 => only(),
        _ => format!(
            "{} of {all} searches ended, and {stopped} were stopped before their end",
            all - stopped
        ),
    })
}

/// Finds the parameters that maximize or minimize the objective. A local search starts from the
/// setup's own values, moved into the ranges. A parameter without a value starts in the middle of
/// its range.
///
/// For one drive, further searches start at points of a [`Sample`] of the ranges that are better
/// than the local optimum. For swings, every design has the same scenarios, so that the objective
/// is a smooth function of the design, with exact gradients and Hessians.
///
/// ```
/// use longdrive::{Setup, optimize::Observer, study::{Search, Vary, optimum}};
/// let setup = Setup::preset("mae494").unwrap();
/// let vary = ["club.loft=0deg..20deg", "swing.attack_angle=-10deg..10deg"];
/// let search = Search {
///     vary: vary.map(|text| Vary::read(&setup, text).unwrap()).to_vec(),
///     ..Search::longest_drive(&setup).unwrap()
/// };
/// let best = optimum(&setup, search, Observer::default()).unwrap();
/// assert!((best.value().unwrap() - 153.333552731).abs() < 1e-8);
/// assert!((best.solution.upper_multipliers[1] - 60.2924949).abs() < 1e-6); // m per radian of attack angle
/// ```
///
/// Over swings:
///
/// ```
/// use longdrive::Setup;
/// use longdrive::optimize::Observer;
/// use longdrive::study::swings::{Rule, Scenarios, Swings};
/// use longdrive::study::{Goal, Search, Vary, optimum, uncertainty::Uncertain};
///
/// let setup = Setup::preset("mae494").unwrap();
/// let attack = Uncertain::read(&setup, "swing.attack_angle=uniform(0deg, 10deg)").unwrap();
/// let swings = Swings::distributed(vec![attack], &[]).unwrap();
/// let of = Goal::read("mean(carry)", None).unwrap();
/// let rule = Rule::of(&swings, [&of], None, 0).unwrap();
/// let search = Search {
///     of,
///     vary: vec![Vary::read(&setup, "club.loft=4deg..20deg").unwrap()],
///     scenarios: Scenarios::new(&swings, rule).unwrap(),
///     ..Search::longest_drive(&setup).unwrap()
/// };
/// let best = optimum(&setup, search, Observer::default()).unwrap();
/// assert_eq!(best.status(), "converged");
/// ```
///
/// # Errors
/// [`Error::Nothing`] without parameters to vary, or if every range is a single value;
/// [`Error::SearchRange`] for a parameter that is varied twice; [`Error::Unreadable`] for a
/// parameter that both the search and the swings vary; the errors of [`Setup::validate`];
/// [`Error::NotConverged`] if the search is interrupted before it begins.
pub fn optimum(setup: &Setup<f64>, search: Search, observer: Observer) -> Result<Optimum> {
    let search = OptimumSearch::new(setup, search, &observer.interrupt)?;
    let mut best = search.minimized(&search.problem.start(), observer)?;
    let sample = search.improved(&mut best, Observer::default)?;
    let goals = search.goals(&best);
    search.optimum(best, goals, sample)
}

/// Searches in parallel from the setup's own values and from starts spread evenly over the ranges.
/// For one drive, further searches start at better points of a [`Sample`], as in [`optimum`].
///
/// # Errors
/// The errors of [`optimum`]; [`Error::Nothing`] if `count` is 0; [`Error::Optimizer`] for more
/// starts than the sequence of starting points has.
pub fn optima(
    setup: &Setup<f64>,
    search: &Search,
    count: usize,
    follow: &Observers,
) -> Result<Optima> {
    OptimumSearch::new(setup, search.clone(), &follow.interrupt)?.optima(count, follow)
}

/// A search, with the problem that the optimizer solves for it.
pub(super) struct OptimumSearch {
    pub problem: SearchProblem,
    /// The values of the goals over the swings at the setup's own design; `None` as in
    /// [`Optimum::as_set_up`].
    as_set_up: Option<Vec<f64>>,
    /// True if the goals of one drive are evaluated again, without derivatives, at the end of a
    /// search. The rounding of a goal depends on the order of the derivatives that are computed
    /// with it.
    is_evaluated_again: bool,
}

impl OptimumSearch {
    /// Prepares a search, and computes its goals as set up over swings.
    ///
    /// # Errors
    /// The errors of [`optimum`].
    pub fn new(setup: &Setup<f64>, search: Search, interrupt: &Arc<AtomicBool>) -> Result<Self> {
        let problem = SearchProblem::new(setup, search, interrupt)?;
        let mut as_set_up = None;
        if !problem.search.scenarios.is_one_drive() {
            as_set_up = problem.goals_as_set_up().ok();
            if as_set_up.is_none() && problem.is_stopped() {
                return Err(stopped_before("the search began"));
            }
        }
        Ok(Self {
            problem,
            as_set_up,
            is_evaluated_again: false,
        })
    }

    /// A search at whose ends the goals are evaluated again, so that they are bitwise comparable
    /// with the goals of other designs.
    ///
    /// # Errors
    /// The errors of [`optimum`].
    pub fn comparable(setup: &Setup<f64>, search: &Search, follow: &Observers) -> Result<Self> {
        Ok(Self {
            is_evaluated_again: true,
            ..Self::new(setup, search.clone(), &follow.interrupt)?
        })
    }

    /// The optima of searches from `count` starts and from points of the sample, as in [`optima`].
    ///
    /// # Errors
    /// The errors of [`optima`].
    pub fn optima(self, count: usize, follow: &Observers) -> Result<Optima> {
        if count == 0 {
            return Err(Error::Nothing {
                doing: "search from",
                what: "start",
            });
        }
        let SearchProblem { domain, search, .. } = &self.problem;
        let from = starts(domain, &self.problem.start(), count)?;
        let mut locals = minimize_from(&self.problem, domain, &from, &search.options, follow)?;
        let mut sample = None;
        let mut has_extra_start = false;
        let is_interrupted = |local: &LocalMinimum| local.solution.status == Status::Interrupted;
        if !locals.iter().any(is_interrupted)
            && let Some(mut best) = locals.first().map(|local| local.solution.clone())
        {
            sample = self.improved(&mut best, || follow.of_search(count))?;
            if sample.is_some_and(|sample| sample.improved) {
                let improved = LocalMinimum {
                    solution: best,
                    starts: vec![count],
                };
                locals.insert(0, improved);
                has_extra_start = true;
            }
        }
        let (best, locals) = self.best_and_locals(locals, sample)?;
        Ok(Optima {
            best,
            locals,
            requested: count,
            has_extra_start,
        })
    }

    /// The local optimum of a search from `start`. `sample` is the comparison of an earlier optimum
    /// of this search, if there is one.
    ///
    /// # Errors
    /// The errors of [`optimum`].
    pub fn local_optimum(
        self,
        start: &[f64],
        observer: Observer,
        sample: Option<Sample>,
    ) -> Result<Optimum> {
        let end = self.minimized(start, observer)?;
        let goals = self.goals(&end);
        self.optimum(end, goals, sample)
    }

    fn minimized(&self, start: &[f64], observer: Observer) -> Result<Solution> {
        let SearchProblem { domain, search, .. } = &self.problem;
        minimize_observed(&self.problem, domain, start, &search.options, observer)
    }

    /// Compares `end` with a sample of the ranges. Replaces `end` if a search from a point of the
    /// sample finds a better solution. `None` for a search over swings, and after an interrupt.
    fn improved(
        &self,
        end: &mut Solution,
        observer: impl Fn() -> Observer,
    ) -> Result<Option<Sample>> {
        let is_one_drive = self.problem.search.scenarios.is_one_drive();
        if !is_one_drive || end.status == Status::Interrupted {
            return Ok(None);
        }
        let again = |start: &[f64]| {
            let observer = Observer {
                interrupt: self.problem.stop.clone(),
                ..observer()
            };
            self.minimized(start, observer)
        };
        compare_with_sample(&self.problem, end, again)
    }

    /// The best of the ends `locals` of searches, and all of them with the values of the goals.
    fn best_and_locals(
        self,
        locals: Vec<LocalMinimum>,
        sample: Option<Sample>,
    ) -> Result<(Optimum, Vec<LocalOptimum>)> {
        let goals: Vec<_> = locals
            .iter()
            .map(|local| self.goals(&local.solution))
            .collect();
        let locals: Vec<_> = locals
            .into_iter()
            .zip(&goals)
            .map(|(LocalMinimum { solution, starts }, goals)| LocalOptimum {
                solution,
                value: goals.as_ref().map(|goals| goals[0]),
                starts,
            })
            .collect();
        let best = locals.first().map(|local| local.solution.clone());
        let best = best.ok_or(Error::Nothing {
            doing: "search from",
            what: "start",
        })?;
        let goals = goals.into_iter().next().flatten();
        Ok((self.optimum(best, goals, sample)?, locals))
    }

    /// Goals without smoothing at the end of a search. They are computed even after an interrupt.
    /// `None` if the ball does not fly in one of the drives.
    fn goals(&self, solution: &Solution) -> Option<Vec<f64>> {
        let value = solution.value?;
        let search = &self.problem.search;
        if search.is_of_outcomes() && !self.is_evaluated_again {
            let limited = solution.constraints.iter().map(|at| at.value);
            let objective = search.sense.sign() * value;
            return Some(std::iter::once(objective).chain(limited).collect());
        }
        let never = AtomicBool::new(false);
        self.problem.goals_at(&solution.x, &never).ok()
    }

    fn optimum(
        self,
        solution: Solution,
        goals: Option<Vec<f64>>,
        sample: Option<Sample>,
    ) -> Result<Optimum> {
        let setup = self.problem.setup_at(&solution.x)?;
        let mut drive = None;
        let mut beyond_strokes = None;
        let start = self.problem.as_given;
        let mut drive_as_set_up = None;
        if solution.value.is_some() {
            if self.problem.search.scenarios.is_one_drive() {
                drive = Some(Drive::new(&setup)?);
                drive_as_set_up = start.validate().and_then(|()| Drive::new(&start)).ok();
            }
            beyond_strokes = match self.problem.beyond_strokes(&solution.x) {
                Err(_) if self.problem.is_stopped() => None,
                found => found?,
            };
        }
        Ok(Optimum {
            search: self.problem.search,
            solution,
            goals,
            setup,
            drive,
            start,
            drive_as_set_up,
            sample,
            as_set_up: self.as_set_up,
            beyond_strokes,
        })
    }
}
