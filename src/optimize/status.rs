//! Stopping tests and verdicts of a search. A [`Status`] is the outcome of a search; bad input is
//! an [`Error`](crate::Error) instead.
//!
//! Each stopping test is one function. All quantities are relative to a scale:
//!
//! - variable i to sᵢ: [`Bounds::scale`](super::Bounds::scale)
//! - the objective to φ = max(|f|, min(1, φ₀)), with φ₀ the larger of |f| and the largest s-scaled
//!   derivative of f at the start
//! - constraint j to γⱼ: the larger of its violation and its largest s-scaled derivative at the
//!   start.
//!
//! The KKT residual is the largest of three components:
//!
//! - stationarity: maxᵢ sᵢ |pᵢ|/φ, with p the gradient of the Lagrangian projected on the bounds
//! - feasibility: the largest constraint violation over γ
//! - complementarity: the largest product of a multiplier and the distance from its limit, over φ.

use super::kink::Kink;
use super::redundant::RedundantBound;
use super::scaling::{KktResidual, Outward};
use super::state::SearchState;
use super::trial_step::{NOISE, TrialStep};
use crate::units::counted;
use serde::{Deserialize, Serialize};

/// Outcome of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// The KKT conditions hold, and the Lagrangian has no direction of negative curvature. At a
    /// kink of the objective this holds for the other variables, and the Lagrangian falls towards
    /// the kink from both sides.
    Converged,
    /// The objective has a kink at this point, which was not shown to be a minimum, and no step
    /// reduces the objective.
    StalledAtKink,
    /// No step reduces the objective by more than rounding, though the KKT conditions do not hold.
    Stalled,
    /// No feasible point was found: the violation has a nonzero minimum.
    Infeasible,
    /// The objective is unbounded below: it still falls far from the start, with the constraints
    /// satisfied and no bound ahead.
    Unbounded,
    /// The limit of iterations was reached.
    IterationLimit,
    /// Interrupted by the caller. The result is the best point so far.
    Interrupted,
    /// The functions are undefined at the start and at all other points tried.
    Undefined,
}

variant_names! {
    /// Name in reports, for example `converged`.
    Status as "SearchStatus" {
        Converged = "converged",
        StalledAtKink = "stalled-at-kink",
        Stalled = "stalled",
        Infeasible = "infeasible",
        Unbounded = "unbounded",
        IterationLimit = "iteration-limit",
        Interrupted = "interrupted",
        Undefined = "undefined",
    }
}

/// A status, of a search or of a fit, with its message.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct SearchVerdict<S = Status> {
    pub status: S,
    pub message: String,
}

impl SearchVerdict {
    pub fn iteration_limit(iterations: u64, residual: Option<f64>) -> Self {
        /// Largest KKT residual of a point that counts as optimal without convergence.
        const SMALL: f64 = 1e-8;
        let advice = match residual.is_some_and(|residual| residual <= SMALL) {
            true => {
                "the point is optimal within this residual; if some of the variables can replace \
                 each other, vary fewer of them"
            }
            false => "allow more iterations, or start nearer",
        };
        let message = format!(
            "stopped at the limit of {}{}; {advice}",
            counted(iterations, "iteration"),
            with_residual(residual)
        );
        Self {
            status: Status::IterationLimit,
            message,
        }
    }

    pub fn without_start(tried: u64) -> Self {
        let message = match tried {
            0 => "stopped before the functions were evaluated once".into(),
            _ => format!(
                "stopped before a start was found: the functions are undefined at the {tried} points \
                 tried so far"
            ),
        };
        Self {
            status: Status::Interrupted,
            message,
        }
    }

    pub fn interrupted(iterations: u64, residual: Option<f64>) -> Self {
        let after = counted(iterations, "iteration");
        let message = format!("stopped after {after}{}", with_residual(residual));
        Self {
            status: Status::Interrupted,
            message,
        }
    }

    pub fn undefined(trials: u32, why: &str) -> Self {
        let message = format!(
            "the functions are undefined at the start and at {trials} other points of the box: {why}"
        );
        Self {
            status: Status::Undefined,
            message,
        }
    }

    pub fn kink(kink: &Kink, at: f64, residual: f64) -> Self {
        let message = format!(
            "the objective has a kink in variable x[{}] at {at:e}: its derivative is {kink}; KKT \
             residual {residual:.1e}",
            kink.variable
        );
        Self {
            status: Status::StalledAtKink,
            message,
        }
    }

    /// Verdict for a point where the KKT conditions hold only with a huge multiplier, because a
    /// constraint makes an active bound redundant.
    pub fn degenerate(pair: &RedundantBound, residual: f64) -> Self {
        let RedundantBound {
            variable,
            constraint,
            multiplier,
        } = pair;
        let message = format!(
            "the gradient of constraint c[{constraint}] is almost parallel to the axis of variable \
             x[{variable}], which lies on its bound: the KKT conditions hold only with a multiplier of \
             {multiplier:.1e}, and so do not prove an optimum; KKT residual {residual:.1e}. Remove \
             that bound or start elsewhere"
        );
        Self {
            status: Status::Stalled,
            message,
        }
    }
}

fn with_residual(residual: Option<f64>) -> String {
    residual.map_or(String::new(), |residual| {
        format!(" with a KKT residual of {residual:.1e}")
    })
}

/// Verdict `Converged`, if the KKT residual is within the tolerance.
pub(super) fn gradient_test(residual: KktResidual, tolerance: f64) -> Option<SearchVerdict> {
    let largest = residual.largest();
    (largest <= tolerance).then(|| {
        let message = format!("KKT residual {largest:.1e} <= {tolerance:.0e}");
        SearchVerdict {
            status: Status::Converged,
            message,
        }
    })
}

/// True if the predicted reduction is within the rounding of the merit function. A small KKT
/// residual alone does not end a search: if f contains a large constant, any derivative is small
/// relative to f.
pub(super) fn model_predicts_no_gain(state: &mut SearchState) -> bool {
    let step = state.trial_step();
    state.predicted_reduction(&step) <= NOISE * state.merit_size()
}

/// Verdict `Converged` of a stalled search, if the KKT residual relative to the initial size of the
/// objective is within the tolerance. `size_ratio` is the initial size divided by the current size.
pub(super) fn rounding_test(
    residual: KktResidual,
    size_ratio: f64,
    tolerance: f64,
) -> Option<SearchVerdict> {
    let largest = residual.stationarity.max(residual.complementarity) / size_ratio;
    (largest <= tolerance && residual.feasibility <= tolerance).then(|| {
        let message = format!(
            "KKT residual {largest:.1e} <= {tolerance:.0e}, relative to the objective at the start; \
             rounding prevents a smaller one"
        );
        SearchVerdict { status: Status::Converged, message }
    })
}

/// True if a variable diverges. Far from 0 a small derivative alone does not prove stationarity:
/// the derivative of −x³ is only 3/x times the value of −x³. So the derivative times the distance
/// from 0 must also be a small fraction of φ.
pub(super) fn is_diverging(outward: Option<&Outward>, tolerance: f64) -> bool {
    /// Smallest distance from 0 at which a variable counts as far, in units of the scale.
    const FAR: f64 = 1e4;
    outward.is_some_and(|outward| outward.distance >= FAR && outward.rate > tolerance)
}

/// Verdict `Unbounded`, if the constraints are satisfied, no bound or constraint lies in the
/// direction in which the objective falls, and one of these holds:
///
/// - A variable is at least 1e15 times its scale away from 0, and the objective would fall by at
///   least 1e-3 of its size if the variable doubled. A function with a lower bound does not fall so
///   fast there.
/// - The objective falls, and is below −1e60 times its initial size. With constraints the factor is
///   −1e200, because a curved constraint may still stop the fall.
pub(super) fn unbounded_test(
    outward: Option<&Outward>,
    state: &SearchState,
) -> Option<SearchVerdict> {
    const FARTHEST: f64 = 1e15;
    const RATE: f64 = 1e-3;
    const MET: f64 = 1e-6;
    let outward = outward.filter(|outward| outward.is_open)?;
    let value = state.point.f.objective.value;
    let deepest = if state.multipliers.is_empty() {
        1e60
    } else {
        1e200
    };
    let is_far = outward.distance >= FARTHEST && outward.rate >= RATE;
    let is_deep =
        value <= -deepest * state.scaling.initial_size && state.residual.stationarity >= RATE;
    if state.residual.feasibility > MET
        || !(is_far || is_deep)
        || state.scaling.has_limit_ahead(&state.point)
    {
        return None;
    }
    let message = format!(
        "the objective is unbounded below: it is {value:.1e} with variable x[{}] at {:.1e}, still \
         falls there, and no bound or constraint lies ahead; give that variable a bound",
        outward.variable, outward.at
    );
    Some(SearchVerdict {
        status: Status::Unbounded,
        message,
    })
}

/// Verdict `Infeasible`, if no step reduces the violation of the linearized constraints.
pub(super) fn infeasible_test(
    step: &TrialStep,
    radius: f64,
    tolerance: f64,
) -> Option<SearchVerdict> {
    const LEAST_GAIN: f64 = 1e-6;
    let TrialStep {
        violation,
        linear_violation,
        is_relaxed,
        ..
    } = *step;
    let is_least = violation - linear_violation <= LEAST_GAIN * violation * radius.min(1.0);
    (is_relaxed && violation > tolerance && is_least).then(|| infeasible(violation))
}

/// Verdict `Infeasible`, with the smallest violation found.
pub(super) fn infeasible(violation: f64) -> SearchVerdict {
    let message = format!(
        "no point was found that meets the constraints: the smallest violation found, from this \
         point and from other points of the box, is {violation:.3e} (relative)"
    );
    SearchVerdict {
        status: Status::Infeasible,
        message,
    }
}

/// Verdict `Stalled`, if the trust region is so small that every step is rounding.
pub(super) fn radius_test(radius: f64, residual: f64) -> Option<SearchVerdict> {
    const LEAST: f64 = 1e-14;
    (radius <= LEAST).then(|| {
        let message = format!(
            "the trust region has shrunk to {radius:.1e} <= {LEAST:.0e} with a KKT residual of \
             {residual:.1e}: no step gains what the derivatives predict. Probable causes: a jump or \
             a corner of a function, rounding, or wrong derivatives"
        );
        SearchVerdict {
            status: Status::Stalled,
            message,
        }
    })
}

/// Verdict `StalledAtKink`, if several terms of the piecewise model are active, and the model
/// predicts no reduction.
pub(super) fn kink_test(
    active_terms: usize,
    predicted: f64,
    residual: f64,
) -> Option<SearchVerdict> {
    const LEAST: f64 = 1e-13;
    (active_terms > 1 && predicted <= LEAST).then(|| {
        let message = format!(
            "the objective has a kink here: the model of {active_terms} of its sides predicts a \
             reduction of {predicted:.1e} <= {LEAST:.0e} (relative); KKT residual {residual:.1e}"
        );
        SearchVerdict {
            status: Status::StalledAtKink,
            message,
        }
    })
}

/// Verdict `Stalled`, if in several iterations the predicted reduction was within the rounding of
/// f, and the KKT residual did not fall.
pub(super) fn progress_test(
    iterations: u32,
    predicted: f64,
    residual: f64,
) -> Option<SearchVerdict> {
    const PATIENCE: u32 = 4;
    (iterations >= PATIENCE).then(|| {
        let message = format!(
            "for {PATIENCE} iterations the model predicted a reduction no larger than rounding (last \
             {predicted:.1e}, relative) and the KKT residual stays at {residual:.1e}"
        );
        SearchVerdict { status: Status::Stalled, message }
    })
}
