//! The loop: sequential quadratic programming as an argmin `Solver`.

use super::bundle::Bundle;
use super::domain::Domain;
use super::kink::{self, Kink};
use super::options::Options;
use super::plan::Plan;
use super::problem::{Evaluation, Problem};
use super::saddle;
use super::scaling::{Residual, Scaling};
use super::search::{Evaluate, NOISE, Search};
use super::start::first_point;
use super::status::{
    Status, Verdict, corner_test, gradient_test, infeasible, infeasible_test, is_running_off, progress_test,
    radius_test, rounding_test, unbounded_test,
};
use argmin::core::{Error, IterState, KV, Problem as Counted, Solver, TerminationReason, TerminationStatus};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// argmin's state for this solver: the point, the objective, and for observers how the search stands; all else is the
/// solver's own.
pub type SqpState = IterState<Vec<f64>, (), (), (), Standing, f64>;

/// How a search stands after an iteration.
#[derive(Clone, Copy, Debug)]
pub struct Standing {
    /// The KKT residual, relative.
    pub kkt_residual: f64,
    /// The largest violation of a constraint, relative.
    pub violation: f64,
    /// The trust region's size for the next step.
    pub radius: f64,
    /// Whether the step was kept.
    pub kept: bool,
}

/// Whose functions are asked for. argmin owns its problem; several runs share one.
#[derive(Clone, Copy)]
pub(super) struct Asked<'a>(pub &'a dyn Problem);

impl Asked<'_> {
    /// What is not finite or not of the right shape counts as not defined.
    fn evaluate(&self, x: &[f64], constraints: usize) -> Result<Evaluation, String> {
        self.0.evaluate(x)?.checked(x.len(), constraints)
    }
}

/// The solver. [`minimize`](super::minimize()) builds and runs it.
#[derive(Clone)]
pub struct Sqp {
    pub(super) domain: Domain,
    pub(super) options: Options,
    pub(super) interrupt: Arc<AtomicBool>,
    pub(super) progress: Progress,
    /// Whether it was stopped within an iteration, which then does not count.
    pub(super) is_stopped_within: bool,
}

/// How far a search has come: all that a resumed one needs to end as if it had never stopped.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct Progress {
    pub search: Option<Search>,
    pub verdict: Option<Verdict>,
    /// Why f is not defined at the start, if so.
    pub undefined_at_start: Option<String>,
    /// Where the search began.
    pub begun_at: Vec<f64>,
    /// The corner it ended at, if it did.
    pub kink: Option<Kink>,
}

impl Progress {
    /// Whether it has the shape of a problem of `n` variables and `m` constraints.
    pub fn is_of(&self, n: usize, m: usize) -> bool {
        let of_search = self.search.as_ref().is_none_or(|search| search.is_of(n, m));
        of_search && [0, n].contains(&self.begun_at.len()) && self.kink.is_none_or(|kink| kink.variable < n)
    }
}

impl Sqp {
    fn is_interrupted(&self) -> bool {
        self.interrupt.load(Ordering::Relaxed)
    }

    /// The verdict where the evaluations of an iteration were stopped: the point is the last that was finished.
    fn stopped_by(&mut self, error: Error, search: &Search, iterations: u64) -> Result<(), Error> {
        if !self.is_interrupted() {
            return Err(error);
        }
        self.progress.verdict = Some(Verdict::interrupted(iterations, search.residual.largest()));
        Ok(())
    }

    /// Judges where the search stands by each of the stopping tests. A verdict of convergence is checked for a saddle,
    /// one that is not for a corner.
    fn judge(&mut self, search: &mut Search, plan: Option<&Plan>, evaluate: &mut Evaluate<'_>) -> Result<(), Error> {
        let tolerance = self.options.kkt_tolerance;
        let size = search.scaling.size(&search.at);
        let promised = plan.map_or(f64::INFINITY, |plan| search.promised(plan) / size);
        let slopes = search.at.lagrangian_gradient(&search.multipliers);
        let residual = search.scaling.residual_of_slopes(&search.at, &search.multipliers, &slopes);
        let is_idle = promised <= NOISE && residual.largest() > 0.5 * search.residual.largest();
        search.residual = residual;
        search.idle = if is_idle { search.idle + 1 } else { 0 };

        let (radius, largest, shrunk) = (search.radius, residual.largest(), search.scaling.first_size / size);
        let is_infeasible = plan
            .filter(|plan| plan.is_relaxed)
            .and_then(|plan| infeasible_test(plan.violation, plan.violation_left, radius, tolerance));
        let stuck = radius_test(radius, largest).or_else(|| progress_test(search.idle, promised, largest));
        let outward = search.scaling.outward(&search.at, &slopes);
        let is_there = |tolerance: f64| !is_running_off(outward, tolerance);
        let value = search.at.f.objective.value;
        let verdict = unbounded_test(outward, value, search.scaling.first_size, residual, search.multipliers.len())
            .or_else(|| gradient_test(residual, tolerance).filter(|_| is_there(tolerance)))
            .or(is_infeasible)
            .or_else(|| {
                stuck.map(|stuck| {
                    let rounding = rounding_test(residual, shrunk, tolerance);
                    rounding.filter(|_| is_there(tolerance.sqrt())).unwrap_or(stuck)
                })
            });
        let corner = corner_test(plan.map_or(1, |plan| plan.sides), promised, largest);
        let is_by_corner = verdict.is_none() && corner.is_some();
        let verdict = verdict.or(corner);
        let Some(verdict) = verdict else { return Ok(()) };
        let goal = match verdict.status {
            Status::Converged => Some(saddle::Goal::Merit),
            Status::Infeasible => Some(saddle::Goal::Feasibility),
            _ => None,
        };
        if let Some(goal) = goal
            && (search.leave_saddle(goal, evaluate)?
                || goal == saddle::Goal::Feasibility && search.restore(&self.options, evaluate)?)
        {
            return Ok(());
        }
        let verdict = match verdict.status {
            Status::Infeasible if search.settle(&self.progress.begun_at, evaluate)? => infeasible(search.violation()),
            _ => verdict,
        };
        let verdict = self.examined(search, verdict, evaluate)?;
        if is_by_corner && verdict.status != Status::StalledAtKink {
            // what looked like a corner's sides is a bend: the search goes on without them
            search.bundle = Bundle::default();
            return Ok(());
        }
        self.progress.verdict = Some(verdict);
        Ok(())
    }

    /// The verdict, with a corner found where there is one.
    fn examined(
        &mut self,
        search: &mut Search,
        verdict: Verdict,
        evaluate: &mut Evaluate<'_>,
    ) -> Result<Verdict, Error> {
        let is_worth_a_look = match verdict.status {
            Status::Converged => kink::is_suspected(&search.scaling, &search.at),
            Status::Stalled => true,
            _ => false,
        };
        if is_worth_a_look {
            let (scaling, at, effort) = (&search.scaling, &search.at, &mut search.effort);
            self.progress.kink = kink::find(scaling, at, |x| {
                effort.evaluations += 1;
                evaluate(x).map(Result::ok)
            })?;
        }
        let residual = search.residual.largest();
        Ok(match (&self.progress.kink, &search.edge) {
            (Some(kink), _) => Verdict::kink(kink, search.at.x[kink.variable], residual),
            (None, Some(why)) if verdict.status == Status::Stalled => {
                verdict.with(&format!("; beyond this point, {why}"))
            }
            (None, _) => verdict,
        })
    }
}

impl Solver<Asked<'_>, SqpState> for Sqp {
    fn name(&self) -> &str {
        "SQP"
    }

    fn init(&mut self, problem: &mut Counted<Asked<'_>>, mut state: SqpState) -> Result<(SqpState, Option<KV>), Error> {
        let start = self.domain.variables.project(&state.take_param().unwrap_or_default());
        let (trials, m) = (self.options.start_trials, self.domain.constraints.dimension());
        let interrupt = self.interrupt.clone();
        let mut evaluate = |x: &[f64]| evaluate(problem, &interrupt, x, m);
        let mut count = 0;
        let (first, why) = first_point(&self.domain.variables, &start, trials, |x| {
            let found = evaluate(x).ok()?;
            count += 1;
            Some(found)
        });
        self.progress.undefined_at_start.clone_from(&why);
        let Some(at) = first else {
            self.progress.verdict = Some(match why {
                Some(why) if !self.is_interrupted() => Verdict::undefined(trials, &why),
                _ => Verdict::without_start(count),
            });
            return Ok((state.param(start), None));
        };
        self.progress.begun_at.clone_from(&at.x);
        let scaling = Scaling::new(self.domain.clone(), self.domain.variables.scale(&start), &at);
        let mut search = Search::new(scaling, at, self.options.initial_radius);
        search.effort.evaluations = count;
        if let Err(error) = self.judge(&mut search, None, &mut evaluate) {
            self.stopped_by(error, &search, 0)?;
        }
        let state = stored(state, &search, true);
        self.progress.search = Some(search);
        Ok((state, None))
    }

    fn next_iter(
        &mut self,
        problem: &mut Counted<Asked<'_>>,
        state: SqpState,
    ) -> Result<(SqpState, Option<KV>), Error> {
        let Some(mut search) = self.progress.search.take() else { return Ok((state, None)) };
        let (m, interrupt) = (self.domain.constraints.dimension(), self.interrupt.clone());
        let mut evaluate = |x: &[f64]| evaluate(problem, &interrupt, x, m);
        let stepped = search.step(&mut evaluate).and_then(|(plan, kept)| {
            self.judge(&mut search, Some(&plan), &mut evaluate)?;
            Ok(kept)
        });
        let state = match stepped {
            Ok(kept) => stored(state, &search, kept),
            Err(error) => {
                self.stopped_by(error, &search, state.iter)?;
                self.is_stopped_within = true;
                // what is not finished is not shown
                let mut state = state;
                state.take_residuals();
                state
            }
        };
        self.progress.search = Some(search);
        Ok((state, None))
    }

    fn terminate(&mut self, state: &SqpState) -> TerminationStatus {
        if self.progress.verdict.is_none() && self.is_interrupted() {
            let residual = self.progress.search.as_ref().map_or(f64::INFINITY, |search| search.residual.largest());
            self.progress.verdict = Some(Verdict::interrupted(state.iter, residual));
        }
        match &self.progress.verdict {
            None => TerminationStatus::NotTerminated,
            Some(verdict) if verdict.status == Status::Converged => {
                TerminationStatus::Terminated(TerminationReason::SolverConverged)
            }
            Some(verdict) => TerminationStatus::Terminated(TerminationReason::SolverExit(verdict.message.clone())),
        }
    }
}

fn stored(mut state: SqpState, search: &Search, kept: bool) -> SqpState {
    // the point before makes room
    let mut x = state.take_param().unwrap_or_default();
    x.clone_from(&search.at.x);
    let Residual { feasibility: violation, .. } = search.residual;
    let standing = Standing { kkt_residual: search.residual.largest(), violation, radius: search.radius, kept };
    state.param(x).cost(search.at.f.objective.value).residuals(standing)
}

/// Evaluates. The outer error is argmin's: it ends the iteration, once the search is to stop. What fails then may fail for that alone, and is
/// not told as undefined.
fn evaluate(
    problem: &mut Counted<Asked<'_>>,
    interrupt: &AtomicBool,
    x: &[f64],
    constraints: usize,
) -> Result<Result<Evaluation, String>, Error> {
    let is_interrupted = || interrupt.load(Ordering::Relaxed);
    if !is_interrupted() {
        let found = problem.problem("evaluations", |p| Ok(p.evaluate(x, constraints)))?;
        if found.is_ok() || !is_interrupted() {
            return Ok(found);
        }
    }
    Err(Error::msg("the search is stopped"))
}
