//! Termination: the stopping tests after each iteration, and the checks before a verdict is
//! returned.

use super::bundle::Bundle;
use super::kink::{self, Kink};
use super::saddle::ReducedFunction;
use super::sqp::Sqp;
use super::state::{Evaluate, SearchState};
use super::status::{
    SearchVerdict, Status, gradient_test, infeasible, infeasible_test, is_diverging, kink_test,
    model_predicts_no_gain, progress_test, radius_test, rounding_test, unbounded_test,
};
use super::trial_step::{NOISE, TrialStep};
use argmin::core::Error;

impl Sqp {
    /// Applies the stopping tests. A converged point is checked for negative curvature, a redundant
    /// bound and a kink. From an infeasible point, a feasibility restoration is tried. The search
    /// continues if a check or the restoration finds a better point.
    pub(super) fn apply_stopping_tests(
        &mut self,
        state: &mut SearchState,
        step: Option<&TrialStep>,
        evaluate: &mut Evaluate<'_>,
    ) -> Result<(), Error> {
        let Some(mut verdict) = self.stopping_verdict(state, step) else {
            return Ok(());
        };
        match verdict.status {
            Status::Converged => {
                if state.leave_saddle(ReducedFunction::Merit, evaluate)? {
                    return Ok(());
                }
                if let Some(pair) = state.redundant_bound() {
                    if state.step_across_bound(&pair, evaluate)? {
                        return Ok(());
                    }
                    verdict = SearchVerdict::degenerate(&pair, state.residual.largest());
                }
            }
            Status::Infeasible => {
                let has_moved = state.leave_saddle(ReducedFunction::Feasibility, evaluate)?
                    || state.restore(&self.options, evaluate)?;
                if has_moved {
                    return Ok(());
                }
                if state.move_to_least_violation(&self.progress.initial_point, evaluate)? {
                    verdict = infeasible(state.violation());
                }
            }
            _ => {}
        }
        let is_suspected_kink = verdict.status == Status::StalledAtKink;
        let kink = self.find_kink(state, &verdict, evaluate)?;
        if is_suspected_kink && kink.is_none() {
            // there is no kink, so the points in `kink_sides` differ by curvature only: drop them
            state.kink_sides = Bundle::default();
            return Ok(());
        }
        self.progress.verdict = Some(with_context(state, verdict, kink.as_ref()));
        self.progress.kink = kink;
        Ok(())
    }

    /// Verdict of the first stopping test that applies.
    fn stopping_verdict(
        &self,
        state: &mut SearchState,
        step: Option<&TrialStep>,
    ) -> Option<SearchVerdict> {
        let tolerance = self.options.kkt_tolerance;
        let size = state.scaling.size(&state.point);
        let predicted = step.map_or(f64::INFINITY, |step| state.predicted_reduction(step) / size);
        let gradient = state.point.lagrangian_gradient(&state.multipliers);
        let residual =
            state
                .scaling
                .residual_from_gradient(&state.point, &state.multipliers, &gradient);
        let is_stalled = predicted <= NOISE && residual.largest() > 0.5 * state.residual.largest();
        let outward = state.scaling.outward(&state.point, &gradient);
        state.residual = residual;
        state.counters.stalled = if is_stalled {
            state.counters.stalled + 1
        } else {
            0
        };

        let is_bounded = |tolerance: f64| !is_diverging(outward.as_ref(), tolerance);
        if let Some(verdict) = unbounded_test(outward.as_ref(), state) {
            return Some(verdict);
        }
        if let Some(verdict) = gradient_test(residual, tolerance).filter(|_| is_bounded(tolerance))
            && model_predicts_no_gain(state)
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
            // the constraints are inconsistent: no step reduces the merit function further, which
            // balances objective and violation
            if step.is_some_and(|step| step.is_relaxed) && residual.feasibility > tolerance {
                return Some(infeasible(state.violation()));
            }
            let size_ratio = state.scaling.initial_size / size;
            let rounding = rounding_test(residual, size_ratio, tolerance)
                .filter(|_| is_bounded(tolerance.sqrt()));
            return Some(rounding.unwrap_or(stalled));
        }
        kink_test(step?.active_terms, predicted, largest)
    }

    /// Looks for a kink of f at a point where a search would end.
    fn find_kink(
        &self,
        state: &mut SearchState,
        verdict: &SearchVerdict,
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

/// Adds to the message the kink, the reason why a trial point was undefined, or the note that
/// second derivatives are missing.
fn with_context(
    state: &SearchState,
    mut verdict: SearchVerdict,
    kink: Option<&Kink>,
) -> SearchVerdict {
    let residual = state.residual.largest();
    if let Some(kink) = kink {
        return SearchVerdict::kink(kink, state.point.x[kink.variable], residual);
    }
    match (verdict.status, &state.undefined_reason) {
        (Status::Stalled, Some(why)) => verdict.message += &format!("; beyond this point, {why}"),
        (Status::Converged, _) if state.point.f.objective.hessian.is_empty() => {
            verdict.message += "; without second derivatives a saddle point or a maximum cannot be \
                                distinguished from a minimum";
        }
        _ => {}
    }
    verdict
}
