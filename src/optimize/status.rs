//! How a search ends. A status is a verdict with its numbers; bad input is an
//! [`Error`](crate::Error) instead.
//!
//! Each stopping test is a function of its own. All sizes are relative: variables are measured by
//! [`Bounds::scale`](super::Bounds::scale) (s), the objective by φ = max(|f|, min(1, φ₀)) with φ₀
//! the larger of |f| and its largest s-scaled slope at the start, constraint j by γⱼ, its largest
//! s-scaled slope at the start. The KKT residual is the largest of maxᵢ sᵢ |pᵢ|/φ, with p the
//! Lagrangian's gradient projected on the bounds (its component is 0 where a bound is active and f
//! falls only towards the outside), of the constraints' violations over γ, and of the multipliers
//! times the distance from their limits over φ.

use super::kink::Kink;
use super::reduction::NOISE;
use super::redundant::RedundantBound;
use super::scaling::{Outward, Residual};
use super::state::State;
use super::trial_step::TrialStep;
use crate::units::counted;
use serde::{Deserialize, Serialize};
use std::fmt;

/// How a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Status {
    /// The KKT conditions hold, and no direction of negative curvature is left.
    Converged,
    /// The objective has a corner here, and the model of its sides predicts no reduction.
    StalledAtKink,
    /// No step reduces the objective by more than rounding, though the KKT conditions do not hold.
    Stalled,
    /// No point was found that meets the constraints: their violation is at a minimum that is not
    /// zero.
    Infeasible,
    /// The objective falls without end: far out, with the constraints met, it still falls, and no
    /// bound lies ahead.
    Unbounded,
    /// The iterations allowed were used up.
    IterationLimit,
    /// Stopped from outside; the point is the best so far.
    Interrupted,
    /// The functions are not defined at the start, nor at any other point tried.
    Undefined,
}

impl Status {
    /// The status in a word: `converged`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::StalledAtKink => "stalled-at-kink",
            Self::Stalled => "stalled",
            Self::Infeasible => "infeasible",
            Self::Unbounded => "unbounded",
            Self::IterationLimit => "iteration-limit",
            Self::Interrupted => "interrupted",
            Self::Undefined => "undefined",
        }
    }
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A status with the sentence that goes with it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Verdict {
    pub status: Status,
    pub message: String,
}

impl Verdict {
    fn new(status: Status, message: String) -> Self {
        Self { status, message }
    }

    pub fn iteration_limit(iterations: u64, residual: Option<f64>) -> Self {
        Self::new(
            Status::IterationLimit,
            format!(
                "stopped at the limit of {}{}; allow more iterations, or start nearer",
                counted(iterations, "iteration"),
                with_residual(residual)
            ),
        )
    }

    pub fn without_start(tried: u64) -> Self {
        let message = match tried {
            0 => "stopped before the functions were evaluated once".into(),
            _ => format!(
                "stopped before a start was found: the functions are defined at none of the points \
                 tried so far ({tried})"
            ),
        };
        Self::new(Status::Interrupted, message)
    }

    pub fn interrupted(iterations: u64, residual: Option<f64>) -> Self {
        let after = counted(iterations, "iteration");
        let message = format!("stopped after {after}{}", with_residual(residual));
        Self::new(Status::Interrupted, message)
    }

    pub fn undefined(trials: u32, why: &str) -> Self {
        Self::new(
            Status::Undefined,
            format!(
                "the functions are defined neither at the start nor at the other points of the box \
                 that were tried ({trials}): {why}"
            ),
        )
    }

    pub fn kink(kink: &Kink, at: f64, residual: f64) -> Self {
        let Kink {
            variable,
            slope_below,
            slope_above,
        } = kink;
        let side = |slope: &Option<f64>| {
            slope.map_or("out of bounds".into(), |slope| format!("{slope:.6}"))
        };
        let message = format!(
            "the objective has a corner in variable {variable} at {at:e}: its slope is {} below \
             and {} above, \
             so that no gradient vanishes; KKT residual {residual:.1e}",
            side(slope_below),
            side(slope_above)
        );
        Self::new(Status::StalledAtKink, message)
    }

    /// A point that meets the KKT conditions only by a multiplier that compensates a bound.
    pub fn degenerate(pair: &RedundantBound, residual: f64) -> Self {
        let RedundantBound {
            variable,
            constraint,
            multiplier,
        } = pair;
        let message = format!(
            "constraint {constraint} and the bound of variable {variable} have parallel gradients \
             here, and only a multiplier of \
             {multiplier:.1e} balances them: no KKT point; KKT residual {residual:.1e}. Leave out \
             that bound or start elsewhere"
        );
        Self::new(Status::Stalled, message)
    }

    /// The verdict, with more to say of the place.
    pub fn with(mut self, more: &str) -> Self {
        self.message += more;
        self
    }
}

fn with_residual(residual: Option<f64>) -> String {
    residual.map_or(String::new(), |residual| {
        format!(" with a KKT residual of {residual:.1e}")
    })
}

/// Converged: the KKT residual is small enough.
pub(super) fn gradient_test(residual: Residual, tolerance: f64) -> Option<Verdict> {
    let largest = residual.largest();
    let passed = largest <= tolerance;
    passed.then(|| {
        Verdict::new(
            Status::Converged,
            format!("KKT residual {largest:.1e} <= {tolerance:.0e}"),
        )
    })
}

/// Whether the model predicts a reduction within the rounding of the merit: relative to a large
/// constant in f any slope is small.
pub(super) fn gain_test(state: &mut State) -> bool {
    let step = state.trial_step();
    state.predicted_reduction(&step) <= NOISE * state.merit_size()
}

/// Converged as far as can be told: nothing more can be gained, and measured by the size that the
/// objective had at the start, `shrunk` times what it has here, the residual is small enough.
pub(super) fn rounding_test(residual: Residual, shrunk: f64, tolerance: f64) -> Option<Verdict> {
    let largest = residual.stationarity.max(residual.complementarity) / shrunk;
    (largest <= tolerance && residual.feasibility <= tolerance).then(|| {
        let message = format!(
            "KKT residual {largest:.1e} <= {tolerance:.0e}, relative to the objective at the \
             start: because of rounding it can \
             fall no further"
        );
        Verdict::new(Status::Converged, message)
    })
}

/// Whether a variable has come so far that its slope by itself says little: far from 0 the slope
/// times that distance must be a small part of φ too (the slope of −x³ is 3/x of its size, and
/// falls below any tolerance).
pub(super) fn is_running_off(outward: Option<&Outward>, tolerance: f64) -> bool {
    /// Variables this many scales from 0 are far.
    const FAR: f64 = 1e4;
    outward.is_some_and(|outward| outward.reach >= FAR && outward.rate > tolerance)
}

/// Unbounded: with the constraints met and no bound or constraint ahead, a variable is at 1e15
/// scales and a doubling of it would still lower the objective by a part of its size (one that has
/// a lower bound cannot keep that up: its slope falls faster than 1/x); or the objective is below
/// −1e60 times its size at the start (with constraints, which may still bend, −1e200), and still
/// falls.
pub(super) fn unbounded_test(outward: Option<&Outward>, state: &State) -> Option<Verdict> {
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
    let is_far = outward.reach >= FARTHEST && outward.rate >= RATE;
    let is_deep =
        value <= -deepest * state.scaling.first_size && state.residual.stationarity >= RATE;
    if state.residual.feasibility > MET
        || !(is_far || is_deep)
        || state.scaling.has_limit_ahead(&state.point)
    {
        return None;
    }
    let message = format!(
        "the objective falls without end: it is {value:.1e} with variable {} at {:.1e}, still \
         falls there, and no bound \
         or constraint lies ahead; give that variable a bound",
        outward.variable, outward.at
    );
    Some(Verdict {
        status: Status::Unbounded,
        message,
    })
}

/// Infeasible: the constraints are violated, and no step reduces the violation of the linearised
/// ones.
pub(super) fn infeasible_test(step: &TrialStep, radius: f64, tolerance: f64) -> Option<Verdict> {
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

/// No point was found that meets the constraints; the least violation found.
pub(super) fn infeasible(violation: f64) -> Verdict {
    let message = format!(
        "no point was found that meets the constraints: their violation {violation:.3e} (relative) \
         is the least found, from here and \
         from other points of the box"
    );
    Verdict::new(Status::Infeasible, message)
}

/// The trust region has shrunk to nothing: no step that can be told from none makes the function
/// smaller.
pub(super) fn radius_test(radius: f64, residual: f64) -> Option<Verdict> {
    const LEAST: f64 = 1e-14;
    (radius <= LEAST).then(|| {
        let message = format!(
            "trust region {radius:.1e} <= {LEAST:.0e} with a KKT residual of {residual:.1e}"
        );
        Verdict::new(Status::Stalled, message)
    })
}

/// A corner of f: terms of more than one of its sides are active, and the model predicts no
/// reduction.
pub(super) fn corner_test(active_terms: usize, predicted: f64, residual: f64) -> Option<Verdict> {
    const LEAST: f64 = 1e-13;
    (active_terms > 1 && predicted <= LEAST).then(|| {
        let message = format!(
            "the objective has a corner here: the model of {active_terms} of its sides predicts a \
             reduction of {predicted:.1e} <= \
             {LEAST:.0e} (relative); KKT residual {residual:.1e}"
        );
        Verdict::new(Status::StalledAtKink, message)
    })
}

/// No progress: for some iterations the predicted reduction was within the rounding of f, and the
/// residual has not fallen.
pub(super) fn progress_test(iterations: u32, predicted: f64, residual: f64) -> Option<Verdict> {
    const PATIENCE: u32 = 4;
    (iterations >= PATIENCE).then(|| {
        let message = format!(
            "for {PATIENCE} iterations the model predicted a reduction no larger than rounding \
             (last {predicted:.1e}, relative) and the KKT \
             residual stays at {residual:.1e}"
        );
        Verdict::new(Status::Stalled, message)
    })
}
