//! The SQP loop: sequential quadratic programming with a trust region, as an argmin `Solver`.

use super::domain::Domain;
use super::iteration::Iteration;
use super::kink::Kink;
use super::options::Options;
use super::problem::{Evaluation, Problem};
use super::quadratic_model::QuadraticModel;
use super::scaling::Scaling;
use super::start::first_point;
use super::state::{Evaluate, SearchState};
use super::status::{SearchVerdict, Status};
use argmin::core::{
    Error, IterState, KV, Problem as Counted, Solver, TerminationReason, TerminationStatus,
};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// State that argmin keeps for this solver: the start, the objective, and the [`Iteration`] for
/// observers. The current point is in the `Iteration` only, because argmin would copy a point of
/// its state.
pub type SqpState = IterState<Vec<f64>, (), (), (), Iteration, f64>;

/// The SQP solver. [`minimize`](super::minimize()) builds and runs it.
#[derive(Clone)]
pub struct Sqp {
    pub(super) domain: Domain,
    pub(super) options: Options,
    pub(super) interrupt: Arc<AtomicBool>,
    /// True if observers receive the quadratic model at each iterate.
    pub(super) has_models: bool,
    pub(super) progress: SearchProgress,
}

/// Serializable progress of a search. A search resumed from it gives the same bits as an
/// uninterrupted search.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct SearchProgress {
    pub state: Option<SearchState>,
    pub verdict: Option<SearchVerdict>,
    /// True if an interrupt ended the last iteration early. argmin counts this iteration, but the
    /// reported number of iterations does not include it.
    pub is_interrupted_within: bool,
    /// Reason why f is undefined at the start; `None` if f is defined there.
    pub undefined_at_start: Option<String>,
    /// First iterate: the start, or another point if f is undefined at the start.
    pub initial_point: Vec<f64>,
    /// Kink of f at which the search ended.
    pub kink: Option<Kink>,
    /// Number of evaluations of a search that found no point where f is defined; 0 for any other
    /// search.
    #[serde(skip)]
    pub undefined_evaluations: u64,
}

impl SearchProgress {
    /// True if the dimensions fit this domain.
    pub fn fits(&self, domain: &Domain) -> bool {
        let (n, m) = (domain.variables.dimension(), domain.constraints.dimension());
        let has_state = self
            .state
            .as_ref()
            .is_none_or(|state| state.has_dimensions(n, m));
        has_state
            && [0, n].contains(&self.initial_point.len())
            && self.kink.is_none_or(|kink| kink.variable < n)
    }
}

impl Sqp {
    /// Iteration `number`: Nocedal & Wright (2006), algorithm 18.4, with second-order corrections
    /// and the trust-region update of Conn, Gould & Toint (2000), algorithm 6.1.1. The merit
    /// function is φ = f + ν‖v‖₂ with the constraint violations v.
    fn iterate(
        &mut self,
        state: &mut SearchState,
        number: u64,
        evaluate: &mut Evaluate<'_>,
    ) -> Result<Iteration, Error> {
        // linearize the constraints, convexify the Hessian, solve the quadratic program: minimize
        // ½ dᵀB d + ∇f·d with c + ∇c·d within limits, x + d within bounds, ‖d‖∞ ≤ Δ
        let mut step = state.trial_step();
        // choose ν ≥ ‖λ‖₂, and so large that the model predicts a reduction of φ (eq. 18.36)
        state.update_penalty(&step);
        state.limit_multipliers(&mut step);

        // evaluate f and c at x + d, and the actual and predicted reduction of φ
        let mut trial = state.evaluate_step(step, evaluate)?;
        if !trial.reduction.is_acceptable() {
            // a step can fail because of the constraints' curvature (Maratos effect)
            trial = state.correct_step(trial, evaluate)?;
        }

        let is_reduced = trial.reduction.is_acceptable();
        let is_accepted = is_reduced || state.halves_the_residual(&trial);
        if is_reduced || !is_accepted {
            // set Δ from the ratio of the actual to the predicted reduction
            state.update_radius(&trial.step, &trial.reduction);
        }
        // take the multipliers of the quadratic program as λ, also after a rejected step: the next
        // model then contains the curvature of newly active constraints
        state.multipliers.clone_from(&trial.step.multipliers);
        let reduction = trial.reduction;
        // x ← x + d
        let other = match trial.point {
            Some(point) if is_accepted => Some(state.move_to(point)),
            rejected => rejected,
        };
        // a point on the other side of a kink of f adds a term to the next model
        state.kink_sides.update(&state.scaling, &state.point, other);

        self.apply_stopping_tests(state, Some(&trial.step), evaluate)?;
        Ok(Iteration {
            number,
            accepted: is_accepted,
            predicted_reduction: reduction.predicted,
            actual_reduction: reduction.actual,
            ..self.iteration(state)
        })
    }

    /// Data of the iterate in `state`. The fields about a step have their values of iteration 0.
    fn iteration(&self, state: &SearchState) -> Iteration {
        Iteration {
            number: 0,
            value: state.point.f.objective.value,
            x: state.point.x.clone(),
            kkt_residual: state.residual.largest(),
            violation: state.residual.feasibility,
            radius: state.radius,
            accepted: true,
            predicted_reduction: 0.0,
            actual_reduction: 0.0,
            model: self.has_models.then(|| QuadraticModel::of(state)),
        }
    }

    pub(super) fn is_interrupted(&self) -> bool {
        self.interrupt.load(Ordering::Relaxed)
    }

    /// Sets the verdict of a search that was interrupted during an evaluation. The result is the
    /// last completed iterate.
    ///
    /// # Errors
    /// `error`, if the search was not interrupted.
    fn interrupted_by(
        &mut self,
        error: Error,
        state: &SearchState,
        iterations: u64,
    ) -> Result<(), Error> {
        if !self.is_interrupted() {
            return Err(error);
        }
        self.progress.verdict = Some(SearchVerdict::interrupted(
            iterations,
            Some(state.residual.largest()),
        ));
        Ok(())
    }
}

impl<'a> Solver<&'a dyn Problem, SqpState> for Sqp {
    fn name(&self) -> &str {
        "SQP"
    }

    fn init(
        &mut self,
        problem: &mut Counted<&'a dyn Problem>,
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
        let (mut count, mut failure) = (0, None);
        let (first, why) = first_point(&self.domain.variables, &start, trials, |x| {
            let found = evaluate(x).map_err(|error| failure = Some(error)).ok()?;
            count += 1;
            Some(found)
        });
        if let Some(error) = failure.filter(|_| !self.is_interrupted()) {
            return Err(error);
        }
        self.progress.undefined_at_start.clone_from(&why);
        let Some(point) = first else {
            self.progress.verdict = Some(match why {
                Some(why) if !self.is_interrupted() => SearchVerdict::undefined(trials, &why),
                _ => SearchVerdict::without_start(count),
            });
            self.progress.undefined_evaluations = count;
            return Ok((info.param(start), None));
        };
        self.progress.initial_point.clone_from(&point.x);
        let scaling = Scaling::new(
            self.domain.clone(),
            self.domain.variables.scale(&start),
            &point,
        );
        let mut state = SearchState::new(scaling, point, self.options.initial_radius);
        state.effort.evaluations = count;
        if let Err(error) = self.apply_stopping_tests(&mut state, None, &mut evaluate) {
            self.interrupted_by(error, &state, 0)?;
        }
        let iteration = self.iteration(&state);
        let info = info.cost(iteration.value).residuals(iteration);
        self.progress.state = Some(state);
        Ok((info, None))
    }

    fn next_iter(
        &mut self,
        problem: &mut Counted<&'a dyn Problem>,
        info: SqpState,
    ) -> Result<(SqpState, Option<KV>), Error> {
        let Some(mut state) = self.progress.state.take() else {
            return Ok((info, None));
        };
        let (m, interrupt) = (self.domain.constraints.dimension(), self.interrupt.clone());
        let mut evaluate = |x: &[f64]| evaluate(problem, &interrupt, x, m);
        let info = match self.iterate(&mut state, info.iter + 1, &mut evaluate) {
            Ok(iteration) => info.cost(iteration.value).residuals(iteration),
            Err(error) => {
                self.interrupted_by(error, &state, info.iter)?;
                self.progress.is_interrupted_within = true;
                // observers see completed iterations only
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
            self.progress.verdict = Some(SearchVerdict::interrupted(info.iter, residual));
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

/// Evaluates the functions at x.
///
/// # Errors
/// The inner error means that the functions are undefined at x; a value that is not finite counts
/// as undefined. The outer error ends the search, because of wrong dimensions or an interrupt; an
/// evaluation that fails after an interrupt counts as interrupted.
fn evaluate(
    problem: &mut Counted<&dyn Problem>,
    interrupt: &AtomicBool,
    x: &[f64],
    constraints: usize,
) -> Result<Result<Evaluation, String>, Error> {
    let is_interrupted = || interrupt.load(Ordering::Relaxed);
    if !is_interrupted() {
        let found = problem.problem("evaluations", |p| Ok(p.evaluate(x)))?;
        if let Ok(evaluation) = &found {
            evaluation
                .check_dimensions(x.len(), constraints)
                .map_err(crate::Error::Optimizer)?;
        }
        let found = found.and_then(Evaluation::finite);
        if found.is_ok() || !is_interrupted() {
            return Ok(found);
        }
    }
    Err(Error::msg("the search is stopped"))
}
