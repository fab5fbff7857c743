//! When a search ends: the tests after every iteration, and what is examined before each verdict.

use super::bundle::Bundle;
use super::kink::{self, Kink};
use super::reduction::NOISE;
use super::saddle::Goal;
use super::sqp::Sqp;
use super::state::{Evaluate, State};
use super::status::{
    Status, Verdict, corner_test, gain_test, gradient_test, infeasible, infeasible_test,
    is_running_off, progress_test, radius_test, rounding_test, unbounded_test,
};
use super::trial_step::TrialStep;
use argmin::core::Error;

impl Sqp {
    /// Tests whether the search ends. A converged point is examined for a saddle, for a redundant
    /// bound and for a corner; an infeasible one for points elsewhere that meet the constraints.
    /// Where that leads on, the search goes on.
    pub(super) fn terminate_or_go_on(
        &mut self,
        state: &mut State,
        step: Option<&TrialStep>,
        evaluate: &mut Evaluate<'_>,
    ) -> Result<(), Error> {
        let Some(mut verdict) = self.tested(state, step) else {
            return Ok(());
        };
        match verdict.status {
            Status::Converged => {
                if state.leave_saddle(Goal::Merit, evaluate)? {
                    return Ok(());
                }
                if let Some(pair) = state.redundant_bound() {
                    if state.cross_redundant_bound(&pair, evaluate)? {
                        return Ok(());
                    }
                    verdict = Verdict::degenerate(&pair, state.residual.largest());
                }
            }
            Status::Infeasible => {
                let goes_on = state.leave_saddle(Goal::Feasibility, evaluate)?
                    || state.restore(&self.options, evaluate)?;
                if goes_on {
                    return Ok(());
                }
                if state.settle(&self.progress.begun_at, evaluate)? {
                    verdict = infeasible(state.violation());
                }
            }
            _ => {}
        }
        let looks_like_a_corner = verdict.status == Status::StalledAtKink;
        let kink = self.corner(state, &verdict, evaluate)?;
        if looks_like_a_corner && kink.is_none() {
            // the terms of the model are those of a bend: the search goes on without them
            state.corners = Bundle::default();
            return Ok(());
        }
        self.progress.verdict = Some(described(state, verdict, kink.as_ref()));
        self.progress.kink = kink;
        Ok(())
    }

    /// The verdict of the stopping tests, in the order of their strength.
    fn tested(&self, state: &mut State, step: Option<&TrialStep>) -> Option<Verdict> {
        let tolerance = self.options.kkt_tolerance;
        let size = state.scaling.size(&state.point);
        let predicted = step.map_or(f64::INFINITY, |step| state.predicted_reduction(step) / size);
        let slopes = state.point.lagrangian_gradient(&state.multipliers);
        let residual = state
            .scaling
            .residual_of_slopes(&state.point, &state.multipliers, &slopes);
        let is_idle = predicted <= NOISE && residual.largest() > 0.5 * state.residual.largest();
        let outward = state.scaling.outward(&state.point, &slopes);
        state.residual = residual;
        state.counters.stalled = if is_idle {
            state.counters.stalled + 1
        } else {
            0
        };

        let is_there = |tolerance: f64| !is_running_off(outward.as_ref(), tolerance);
        if let Some(verdict) = unbounded_test(outward.as_ref(), state) {
            return Some(verdict);
        }
        if let Some(verdict) = gradient_test(residual, tolerance).filter(|_| is_there(tolerance))
            && gain_test(state)
        {
            return Some(verdict);
        }
        if let Some(verdict) = step.and_then(|step| infeasible_test(step, state.radius, tolerance))
        {
            return Some(verdict);
        }
        let largest = residual.largest();
        let stalled = radius_test(state.radius, largest)
            .or_else(|| progress_test(state.counters.stalled, predicted, largest));
        if let Some(stalled) = stalled {
            // the objective and the violation balance in the merit: no step reduces either further
            if step.is_some_and(|step| step.is_relaxed) && residual.feasibility > tolerance {
                return Some(infeasible(state.violation()));
            }
            let shrunk = state.scaling.first_size / size;
            let rounding =
                rounding_test(residual, shrunk, tolerance).filter(|_| is_there(tolerance.sqrt()));
            return Some(rounding.unwrap_or(stalled));
        }
        corner_test(step?.active_terms, predicted, largest)
    }

    /// The corner of f at a point where a search would end, if there is one.
    fn corner(
        &self,
        state: &mut State,
        verdict: &Verdict,
        evaluate: &mut Evaluate<'_>,
    ) -> Result<Option<Kink>, Error> {
        let is_examined = match verdict.status {
            Status::Converged => kink::is_suspected(&state.scaling, &state.point),
            Status::Stalled | Status::StalledAtKink => true,
            _ => false,
        };
        if !is_examined {
            return Ok(None);
        }
        let effort = &mut state.effort;
        kink::find(&state.scaling, &state.point, |x| {
            effort.evaluations += 1;
            evaluate(x).map(Result::ok)
        })
    }
}

/// A verdict with what is known of the place.
fn described(state: &State, verdict: Verdict, kink: Option<&Kink>) -> Verdict {
    let residual = state.residual.largest();
    if let Some(kink) = kink {
        return Verdict::kink(kink, state.point.x[kink.variable], residual);
    }
    match (verdict.status, &state.undefined_reason) {
        (Status::Stalled, Some(why)) => verdict.with(&format!("; beyond this point, {why}")),
        (Status::Converged, _) if state.point.f.objective.hessian.is_empty() => verdict.with(
            "; no second derivatives were given, so that a saddle or a maximum is not \
                          told from a minimum",
        ),
        _ => verdict,
    }
}
