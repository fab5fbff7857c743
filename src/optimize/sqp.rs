//! The loop: sequential quadratic programming as an argmin `Solver`.

use super::domain::Domain;
use super::frame::{Frame, Point};
use super::kink::{self, Kink};
use super::model::Plan;
use super::options::Options;
use super::problem::{Evaluation, Problem};
use super::saddle;
use super::search::{NOISE, Search};
use super::start::first_point;
use super::status::{
    Status, Verdict, corner_test, gradient_test, infeasible_test, progress_test, radius_test, rounding_test,
};
use argmin::core::{Error, IterState, KV, Problem as Counted, Solver, TerminationReason, TerminationStatus};
use argmin::kv;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// argmin's state for this solver: the point and the objective; all else is the solver's own.
pub type SqpState = IterState<Vec<f64>, (), (), (), (), f64>;

/// Saddles left before the search gives up on finding anything else.
const MOST_ESCAPES: u32 = 20;

/// The solver. [`minimize`](super::minimize) builds and runs it.
#[derive(Clone)]
pub struct Sqp {
    pub(super) domain: Domain,
    pub(super) options: Options,
    pub(super) interrupt: Arc<AtomicBool>,
    pub(super) progress: Progress,
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

impl Sqp {
    /// Judges where the search stands by each of the stopping tests. A verdict that is not of plain convergence is
    /// checked for a corner, one that is for a saddle.
    fn judge<P: Problem>(&mut self, problem: &mut Counted<P>, plan: Option<&Plan>) -> Result<(), Error> {
        let Some(search) = &mut self.progress.search else { return Ok(()) };
        let tolerance = self.options.kkt_tolerance;
        let size = search.frame.size(&search.at);
        let promised = plan.map_or(f64::INFINITY, |plan| search.promised(plan) / size);
        let residual = search.frame.residual(&search.at, &search.multipliers);
        let is_idle = promised <= NOISE && residual.largest() > 0.5 * search.residual.largest();
        search.residual = residual;
        search.idle = if is_idle { search.idle + 1 } else { 0 };

        let (radius, largest, shrunk) = (search.radius, residual.largest(), search.frame.first_size / size);
        let is_infeasible = plan.filter(|plan| plan.is_relaxed).and_then(|plan| {
            infeasible_test(search.violation(), plan.violation_left, plan.length.max(radius), tolerance)
        });
        let stuck = radius_test(radius, largest).or_else(|| progress_test(search.idle, promised, largest));
        let verdict = gradient_test(residual, tolerance)
            .or(is_infeasible)
            .or_else(|| stuck.map(|stuck| rounding_test(residual, shrunk, tolerance).unwrap_or(stuck)))
            .or_else(|| corner_test(plan.map_or(1, |plan| plan.sides), promised, largest));
        let Some(verdict) = verdict else { return Ok(()) };
        if verdict.status == Status::Converged && self.left_saddle(problem)? {
            return Ok(());
        }
        self.progress.verdict = Some(self.examined(problem, verdict)?);
        Ok(())
    }

    /// The verdict, with a corner found where there is one.
    fn examined<P: Problem>(&mut self, problem: &mut Counted<P>, verdict: Verdict) -> Result<Verdict, Error> {
        let Some(search) = &mut self.progress.search else { return Ok(verdict) };
        let is_converged = verdict.status == Status::Converged;
        let is_worth_a_look = match verdict.status {
            Status::Converged => kink::is_suspected(&search.frame, &search.at),
            Status::Stalled => true,
            _ => false,
        };
        if is_worth_a_look {
            let (mut failure, mut count) = (None, 0);
            self.progress.kink = kink::find(&search.frame, &search.at, |x| {
                count += 1;
                evaluate(problem, x, search.frame.gamma.len()).unwrap_or_else(|error| {
                    failure = Some(error);
                    Err(String::new())
                }).ok()
            });
            search.effort.evaluations += count;
            if let Some(error) = failure {
                return Err(error);
            }
        }
        let residual = search.residual.largest();
        Ok(match (&self.progress.kink, &search.edge) {
            (Some(kink), _) => Verdict::kink(kink, search.at.x[kink.variable], residual),
            (None, Some(why)) if !is_converged => verdict.with(&format!("; beyond this point, {why}")),
            (None, _) => verdict,
        })
    }

    /// Where the point is a saddle of the Lagrangian, goes down from it; whether it did.
    fn left_saddle<P: Problem>(&mut self, problem: &mut Counted<P>) -> Result<bool, Error> {
        let Some(search) = &mut self.progress.search else { return Ok(false) };
        let way = saddle::downward(&search.frame, &search.at, &search.multipliers);
        let Some((direction, curvature)) = way.filter(|_| search.escapes < MOST_ESCAPES) else { return Ok(false) };
        search.escapes += 1;
        let before = search.merit(&search.at);
        let mut reach = search.radius.clamp(1e-3, 0.25);
        for _ in 0..6 {
            let expected = -0.5 * curvature * reach * reach;
            let mut best: Option<Point> = None;
            for sign in [1.0, -1.0] {
                let frame = &search.frame;
                let moved = (0..search.at.x.len())
                    .map(|i| search.at.x[i] + sign * reach * direction[i] * frame.scale[i])
                    .collect::<Vec<_>>();
                let x = frame.domain.variables.project(&moved);
                search.effort.evaluations += 1;
                if let Ok(f) = evaluate(problem, &x, search.frame.gamma.len())? {
                    let point = Point { x, f };
                    let so_far = best.as_ref().map_or(before - 0.1 * expected, |best| search.merit(best));
                    if search.merit(&point) < so_far {
                        best = Some(point);
                    }
                }
            }
            if let Some(best) = best {
                let multipliers = search.multipliers.clone();
                search.move_to(best, multipliers);
                search.radius = reach;
                search.residual = search.frame.residual(&search.at, &search.multipliers);
                return Ok(true);
            }
            reach *= 0.1;
        }
        Ok(false)
    }

    /// Tries a plan; what its step made of the functions.
    fn tried<P: Problem>(&mut self, problem: &mut Counted<P>, plan: &Plan) -> Result<Option<Point>, Error> {
        let Some(search) = &mut self.progress.search else { return Ok(None) };
        search.effort.evaluations += 1;
        Ok(match evaluate(problem, &plan.x, search.frame.gamma.len())? {
            Ok(f) => Some(Point { x: plan.x.clone(), f }),
            Err(why) => {
                search.edge = Some(why);
                None
            }
        })
    }

    fn report(&self, kept: bool) -> Option<KV> {
        let search = self.progress.search.as_ref()?;
        let violation = search.residual.feasibility;
        let residual = search.residual.largest();
        Some(kv!("kkt_residual" => residual; "radius" => search.radius; "kept" => kept; "violation" => violation;))
    }

    fn stored(&self, state: SqpState) -> SqpState {
        match &self.progress.search {
            Some(search) => state.param(search.at.x.clone()).cost(search.at.f.objective.value),
            None => state,
        }
    }
}

impl<P: Problem> Solver<P, SqpState> for Sqp {
    fn name(&self) -> &str {
        "SQP"
    }

    fn init(&mut self, problem: &mut Counted<P>, mut state: SqpState) -> Result<(SqpState, Option<KV>), Error> {
        let start = self.domain.variables.project(&state.take_param().unwrap_or_default());
        let (trials, m) = (self.options.start_trials, self.domain.constraints.dimension());
        let mut count = 0;
        let (first, why) = first_point(&self.domain.variables, &start, trials, |x| {
            count += 1;
            evaluate(problem, x, m)
        })?;
        self.progress.undefined_at_start.clone_from(&why);
        let Some(at) = first else {
            self.progress.verdict = why.map(|why| Verdict::undefined(trials, &why));
            return Ok((state.param(start), None));
        };
        self.progress.begun_at.clone_from(&at.x);
        let frame = Frame::new(self.domain.clone(), self.domain.variables.scale(&start), &at);
        let mut search = Search::new(frame, at, self.options.initial_radius);
        search.effort.evaluations = count;
        self.progress.search = Some(search);
        self.judge(problem, None)?;
        Ok((self.stored(state), self.report(true)))
    }

    fn next_iter(&mut self, problem: &mut Counted<P>, state: SqpState) -> Result<(SqpState, Option<KV>), Error> {
        let Some(search) = &mut self.progress.search else { return Ok((state, None)) };
        let mut plan = search.plan();
        search.raise_penalty(&plan);
        let mut tried = self.tried(problem, &plan)?;
        let Some(search) = &mut self.progress.search else { return Ok((state, None)) };
        let mut outcome = search.outcome(&plan, tried.as_ref());

        if !outcome.is_kept()
            && let Some(first) = &tried
            && let Some(corrected) = search.corrected(&plan, first)
        {
            let again = self.tried(problem, &corrected)?;
            let Some(search) = &mut self.progress.search else { return Ok((state, None)) };
            let second = search.outcome(&plan, again.as_ref());
            if second.is_kept() {
                (tried, outcome) = (again, second);
                plan.multipliers = corrected.multipliers;
            }
        }

        let Some(search) = &mut self.progress.search else { return Ok((state, None)) };
        let kept = outcome.is_kept();
        search.resize(&plan, &outcome);
        let other = match tried {
            Some(tried) if kept => Some(search.move_to(tried, plan.multipliers.clone())),
            tried => tried,
        };
        // another side of a corner is left behind by a step that crossed it, or met by one that failed at it
        search.sides.keep(&search.frame, &search.at, other);

        self.judge(problem, Some(&plan))?;
        Ok((self.stored(state), self.report(kept)))
    }

    fn terminate(&mut self, state: &SqpState) -> TerminationStatus {
        if self.progress.verdict.is_none() && self.interrupt.load(Ordering::Relaxed) {
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

/// Evaluates. What is not finite or not of the right shape counts as not defined. The outer error is argmin's.
fn evaluate<P: Problem>(
    problem: &mut Counted<P>,
    x: &[f64],
    constraints: usize,
) -> Result<Result<Evaluation, String>, Error> {
    problem.problem("evaluations", |p| Ok(p.evaluate(x).and_then(|f| f.checked(x.len(), constraints))))
}
