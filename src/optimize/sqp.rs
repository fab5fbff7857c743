//! The loop: sequential quadratic programming with a trust region, as an argmin `Solver`.

use super::domain::Domain;
use super::kink::Kink;
use super::options::Options;
use super::problem::{Evaluation, Problem};
use super::scaling::{Residual, Scaling};
use super::start::first_point;
use super::state::{Evaluate, State};
use super::status::{Status, Verdict};
use argmin::core::{
    Error, IterState, KV, Problem as Counted, Solver, TerminationReason, TerminationStatus,
};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// argmin's state for this solver: the point, the objective, and what observers are shown of the
/// iteration.
pub type SqpState = IterState<Vec<f64>, (), (), (), IterationInfo, f64>;

/// An iteration in numbers.
#[derive(Clone, Copy, Debug)]
pub struct IterationInfo {
    /// The KKT residual, relative.
    pub kkt_residual: f64,
    /// The largest violation of a constraint, relative.
    pub violation: f64,
    /// The trust region of the next step.
    pub radius: f64,
    /// Whether the step was accepted.
    pub accepted: bool,
}

/// The problem of a run. argmin owns its problem; several runs share one.
#[derive(Clone, Copy)]
pub(super) struct ProblemRef<'a>(pub &'a dyn Problem);

/// The solver. [`minimize`](super::minimize()) builds and runs it.
#[derive(Clone)]
pub struct Sqp {
    pub(super) domain: Domain,
    pub(super) options: Options,
    pub(super) interrupt: Arc<AtomicBool>,
    pub(super) progress: Progress,
}

/// The progress of a search: all that a resumed one needs to end as if it had never stopped.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct Progress {
    pub state: Option<State>,
    pub verdict: Option<Verdict>,
    /// Whether the search was stopped within its last iteration, which then does not count: argmin
    /// counts every call.
    pub is_stopped_within: bool,
    /// Why f is undefined at the start, if so.
    pub undefined_at_start: Option<String>,
    /// The first point of the search.
    pub begun_at: Vec<f64>,
    /// The corner of f at which the search ended.
    pub kink: Option<Kink>,
}

impl Progress {
    /// Whether it has the shape of a problem of `n` variables and `m` constraints.
    pub fn is_of(&self, n: usize, m: usize) -> bool {
        let has_state = self.state.as_ref().is_none_or(|state| state.is_of(n, m));
        has_state
            && [0, n].contains(&self.begun_at.len())
            && self.kink.is_none_or(|kink| kink.variable < n)
    }
}

impl Sqp {
    /// One iteration: Nocedal & Wright (2006), algorithm 18.4, with the merit φ = f + ν‖v‖₂ of
    /// violations v and second-order corrections; trust region of Conn, Gould & Toint (2000),
    /// algorithm 6.1.1. Returns whether the step was accepted.
    fn iterate(&mut self, state: &mut State, evaluate: &mut Evaluate<'_>) -> Result<bool, Error> {
        // linearise the constraints, convexify the Hessian, solve the quadratic program: minimise ½
        // dᵀB d + ∇f·d subject to c + ∇c·d within limits, x + d within bounds, ‖d‖∞ ≤ Δ
        let mut step = state.trial_step();
        // ν ≥ ‖λ‖₂, and large enough for a predicted reduction of φ (eq. 18.36)
        state.update_penalty(&step);
        state.limit_multipliers(&mut step);

        // f, c at x + d; actual and predicted reduction of φ
        let mut trial = state.tried(step, evaluate)?;
        if !trial.reduction.is_acceptable() {
            // the curvature of the constraints may have spoilt the step
            trial = state.corrected(trial, evaluate)?;
        }

        let is_reduced = trial.reduction.is_acceptable();
        let is_accepted = is_reduced || state.halves_the_residual(&trial);
        if is_reduced || !is_accepted {
            // Δ from the ratio of actual to predicted reduction
            state.update_radius(&trial.step, &trial.reduction);
        }
        // λ ← multipliers of the quadratic program, also of a rejected step: with curvature of the
        // constraints that it ran into, the next model is nearer to the functions
        state.multipliers.clone_from(&trial.step.multipliers);
        // x ← x + d
        let other = match trial.point {
            Some(point) if is_accepted => Some(state.move_to(point)),
            rejected => rejected,
        };
        // a point on the other side of a corner of f becomes a term of the next model
        state.corners.update(&state.scaling, &state.point, other);

        self.terminate_or_go_on(state, Some(&trial.step), evaluate)?;
        Ok(is_accepted)
    }

    pub(super) fn is_interrupted(&self) -> bool {
        self.interrupt.load(Ordering::Relaxed)
    }

    /// The verdict of a search whose evaluation was stopped: the point is the last that was
    /// finished.
    fn stopped_by(&mut self, error: Error, state: &State, iterations: u64) -> Result<(), Error> {
        if !self.is_interrupted() {
            return Err(error);
        }
        self.progress.verdict = Some(Verdict::interrupted(
            iterations,
            Some(state.residual.largest()),
        ));
        Ok(())
    }
}

impl Solver<ProblemRef<'_>, SqpState> for Sqp {
    fn name(&self) -> &str {
        "SQP"
    }

    fn init(
        &mut self,
        problem: &mut Counted<ProblemRef<'_>>,
        mut info: SqpState,
    ) -> Result<(SqpState, Option<KV>), Error> {
        let start = self
            .domain
            .variables
            .project(&info.take_param().unwrap_or_default());
        let (trials, m) = (
            self.options.start_trials,
            self.domain.constraints.dimension(),
        );
        let interrupt = self.interrupt.clone();
        let mut evaluate = |x: &[f64]| evaluate(problem, &interrupt, x, m);
        let mut count = 0;
        let (first, why) = first_point(&self.domain.variables, &start, trials, |x| {
            let found = evaluate(x).ok()?;
            count += 1;
            Some(found)
        });
        self.progress.undefined_at_start.clone_from(&why);
        let Some(point) = first else {
            self.progress.verdict = Some(match why {
                Some(why) if !self.is_interrupted() => Verdict::undefined(trials, &why),
                _ => Verdict::without_start(count),
            });
            return Ok((info.param(start), None));
        };
        self.progress.begun_at.clone_from(&point.x);
        let scaling = Scaling::new(
            self.domain.clone(),
            self.domain.variables.scale(&start),
            &point,
        );
        let mut state = State::new(scaling, point, self.options.initial_radius);
        state.effort.evaluations = count;
        if let Err(error) = self.terminate_or_go_on(&mut state, None, &mut evaluate) {
            self.stopped_by(error, &state, 0)?;
        }
        let info = shown(info, &state, true);
        self.progress.state = Some(state);
        Ok((info, None))
    }

    fn next_iter(
        &mut self,
        problem: &mut Counted<ProblemRef<'_>>,
        info: SqpState,
    ) -> Result<(SqpState, Option<KV>), Error> {
        let Some(mut state) = self.progress.state.take() else {
            return Ok((info, None));
        };
        let (m, interrupt) = (self.domain.constraints.dimension(), self.interrupt.clone());
        let mut evaluate = |x: &[f64]| evaluate(problem, &interrupt, x, m);
        let info = match self.iterate(&mut state, &mut evaluate) {
            Ok(is_accepted) => shown(info, &state, is_accepted),
            Err(error) => {
                self.stopped_by(error, &state, info.iter)?;
                self.progress.is_stopped_within = true;
                // observers are shown finished iterations only
                let mut info = info;
                info.take_residuals();
                info
            }
        };
        self.progress.state = Some(state);
        Ok((info, None))
    }

    fn terminate(&mut self, info: &SqpState) -> TerminationStatus {
        if self.progress.verdict.is_none() && self.is_interrupted() {
            let residual = self
                .progress
                .state
                .as_ref()
                .map(|state| state.residual.largest());
            self.progress.verdict = Some(Verdict::interrupted(info.iter, residual));
        }
        match &self.progress.verdict {
            None => TerminationStatus::NotTerminated,
            Some(verdict) if verdict.status == Status::Converged => {
                TerminationStatus::Terminated(TerminationReason::SolverConverged)
            }
            Some(verdict) => TerminationStatus::Terminated(TerminationReason::SolverExit(
                verdict.message.clone(),
            )),
        }
    }
}

/// argmin's state, with what observers are shown.
fn shown(mut info: SqpState, state: &State, accepted: bool) -> SqpState {
    // the memory of the point before is used again
    let mut x = info.take_param().unwrap_or_default();
    x.clone_from(&state.point.x);
    let Residual {
        feasibility: violation,
        ..
    } = state.residual;
    let kkt_residual = state.residual.largest();
    let iteration = IterationInfo {
        kkt_residual,
        violation,
        radius: state.radius,
        accepted,
    };
    info.param(x)
        .cost(state.point.f.objective.value)
        .residuals(iteration)
}

/// Evaluates the functions; values that are not finite or not of the right shape count as
/// undefined. The outer error is argmin's: it ends the iteration once the search is interrupted. A
/// failure may then have no other reason, and does not count as undefined.
fn evaluate(
    problem: &mut Counted<ProblemRef<'_>>,
    interrupt: &AtomicBool,
    x: &[f64],
    constraints: usize,
) -> Result<Result<Evaluation, String>, Error> {
    let is_interrupted = || interrupt.load(Ordering::Relaxed);
    if !is_interrupted() {
        let checked = |evaluation: Evaluation| evaluation.checked(x.len(), constraints);
        let found = problem.problem("evaluations", |p| Ok(p.0.evaluate(x).and_then(checked)))?;
        if found.is_ok() || !is_interrupted() {
            return Ok(found);
        }
    }
    Err(Error::msg("the search is stopped"))
}
