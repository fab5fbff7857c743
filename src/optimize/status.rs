//! How a search ends. A status is a verdict with its numbers; bad input is an [`Error`](crate::Error) instead.
//!
//! Each stopping test is a function of its own. All sizes are relative: variables are measured by
//! [`Bounds::scale`](super::Bounds::scale) (s), the objective by φ = max(|f|, min(1, φ₀)) with φ₀ the larger of |f| and
//! its largest s-scaled slope at the start, constraint j by γⱼ, its largest s-scaled slope at the start. The KKT residual
//! is the largest of maxᵢ sᵢ |pᵢ|/φ, with p the Lagrangian's gradient projected on the bounds (its component is 0 where
//! a bound is active and f falls only towards the outside), of the constraints' violations over γ, and of the
//! multipliers times the distance from their limits over φ.

use super::kink::Kink;
use super::scaling::{Outward, Residual};
use crate::units::counted;
use serde::{Deserialize, Serialize};
use std::fmt;

/// How a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Status {
    /// The KKT conditions hold, and no direction of negative curvature is left.
    Converged,
    /// The objective has a corner here, and no way down from it was found.
    StalledAtKink,
    /// No further progress can be made out above the rounding of the functions.
    Stalled,
    /// The constraints cannot all be met near here: their violation is at a minimum that is not zero.
    Infeasible,
    /// The objective falls without end: far out, with the constraints met, it still falls, and no bound lies ahead.
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

    pub fn iteration_limit(iterations: u64, residual: f64) -> Self {
        Self::new(
            Status::IterationLimit,
            format!(
                "stopped at the limit of {} with a KKT residual of {residual:.1e}; allow more iterations, or start nearer",
                counted(iterations, "iteration")
            ),
        )
    }

    pub fn without_start(tried: u64) -> Self {
        let message = match tried {
            0 => "stopped before the functions were evaluated once".into(),
            _ => format!(
                "stopped before a start was found: the functions are defined at none of the points tried so far ({tried})"
            ),
        };
        Self::new(Status::Interrupted, message)
    }

    pub fn interrupted(iterations: u64, residual: f64) -> Self {
        let after = counted(iterations, "iteration");
        let message = format!("stopped after {after} with a KKT residual of {residual:.1e}");
        Self::new(Status::Interrupted, message)
    }

    pub fn undefined(trials: u32, why: &str) -> Self {
        Self::new(
            Status::Undefined,
            format!(
                "the functions are defined neither at the start nor at the other points of the box that were tried ({trials}): {why}"
            ),
        )
    }

    pub fn kink(kink: &Kink, at: f64, residual: f64) -> Self {
        let Kink { variable, slope_below, slope_above } = kink;
        let side = |slope: &Option<f64>| slope.map_or("out of bounds".into(), |slope| format!("{slope:.6}"));
        let message = format!(
            "the objective has a corner in variable {variable} at {at:e}: its slope is {} below and {} above, \
             so that no gradient vanishes; KKT residual {residual:.1e}",
            side(slope_below),
            side(slope_above)
        );
        Self::new(Status::StalledAtKink, message)
    }

    /// The verdict, with what is known of the place.
    pub fn with(mut self, more: &str) -> Self {
        self.message += more;
        self
    }
}

/// Converged: the KKT residual is small enough.
pub(super) fn gradient_test(residual: Residual, tolerance: f64) -> Option<Verdict> {
    let largest = residual.largest();
    let passed = largest <= tolerance;
    passed.then(|| Verdict::new(Status::Converged, format!("KKT residual {largest:.1e} <= {tolerance:.0e}")))
}

/// Converged as far as can be told: nothing more can be gained, and measured by the size that the objective had at the
/// start, `shrunk` times what it has here, the residual is small enough.
pub(super) fn rounding_test(residual: Residual, shrunk: f64, tolerance: f64) -> Option<Verdict> {
    let largest = residual.stationarity.max(residual.complementarity) / shrunk;
    (largest <= tolerance && residual.feasibility <= tolerance).then(|| {
        let message = format!(
            "KKT residual {largest:.1e} <= {tolerance:.0e}, relative to the objective at the start: because of rounding it can \
             fall no further"
        );
        Verdict::new(Status::Converged, message)
    })
}

/// Whether a variable has come so far that its slope by itself says little: far from 0 the slope times that distance must be a
/// small part of φ too (the slope of −x³ is 3/x of its size, and falls below any tolerance).
pub(super) fn is_running_off(outward: Option<Outward>, tolerance: f64) -> bool {
    /// Variables this many scales from 0 are far.
    const FAR: f64 = 1e4;
    outward.is_some_and(|outward| outward.reach >= FAR && outward.rate > tolerance)
}

/// Unbounded: with the constraints met, a variable without a bound ahead is at 1e15 scales and a doubling of it would still lower
/// the objective by a part of its size (one that has a lower bound cannot keep that up: its slope falls faster than 1/x); or the
/// objective is below −1e60 times its size at the start (with constraints, which may still bend, −1e200), and still falls.
pub(super) fn unbounded_test(
    outward: Option<Outward>,
    value: f64,
    first_size: f64,
    residual: Residual,
    constraints: usize,
) -> Option<Verdict> {
    const FARTHEST: f64 = 1e15;
    const RATE: f64 = 1e-3;
    const MET: f64 = 1e-6;
    let deepest = if constraints == 0 { 1e60 } else { 1e200 };
    let outward = outward.filter(|outward| outward.is_open)?;
    let is_far = outward.reach >= FARTHEST && outward.rate >= RATE;
    let is_deep = value <= -deepest * first_size && residual.stationarity >= RATE;
    (residual.feasibility <= MET && (is_far || is_deep)).then(|| {
        let message = format!(
            "the objective falls without end: it is {value:.1e} with variable {} at {:.1e}, still falls there, and no bound \
             or constraint lies ahead; give that variable a bound",
            outward.variable, outward.at
        );
        Verdict { status: Status::Unbounded, message }
    })
}

/// Infeasible: the constraints are violated, and the linearised ones say that no step makes it less.
pub(super) fn infeasible_test(violation: f64, least: f64, radius: f64, tolerance: f64) -> Option<Verdict> {
    const LEAST_GAIN: f64 = 1e-6;
    let is_least = violation - least <= LEAST_GAIN * violation * radius.min(1.0);
    (violation > tolerance && is_least).then(|| infeasible(violation))
}

/// The constraints cannot all be met: this is the least that they were violated by.
pub(super) fn infeasible(violation: f64) -> Verdict {
    let message = format!(
        "the constraints cannot all be met: their violation {violation:.3e} (relative) is the least found, from here and from other points \
         of the box"
    );
    Verdict::new(Status::Infeasible, message)
}

/// The trust region has shrunk to nothing: no step that can be told from none makes the function smaller.
pub(super) fn radius_test(radius: f64, residual: f64) -> Option<Verdict> {
    const LEAST: f64 = 1e-14;
    (radius <= LEAST).then(|| {
        let message = format!("trust region {radius:.1e} <= {LEAST:.0e} with a KKT residual of {residual:.1e}");
        Verdict::new(Status::Stalled, message)
    })
}

/// The search sits in a corner: pieces of more than one of its sides hold the step, and the model promises
/// nothing more.
pub(super) fn corner_test(sides: usize, promised: f64, residual: f64) -> Option<Verdict> {
    const LEAST: f64 = 1e-13;
    (sides > 1 && promised <= LEAST).then(|| {
        let message = format!(
            "the search is in a corner of {sides} sides, and the model predicts a gain of {promised:.1e} <= {LEAST:.0e} (relative); \
             KKT residual {residual:.1e}"
        );
        Verdict::new(Status::Stalled, message)
    })
}

/// Nothing is left to gain: for some iterations the model has promised less than the function's rounding,
/// and the residual has not fallen.
pub(super) fn progress_test(idle: u32, promised: f64, residual: f64) -> Option<Verdict> {
    const PATIENCE: u32 = 4;
    (idle >= PATIENCE).then(|| {
        let message = format!(
            "for {PATIENCE} iterations the model predicted a gain no larger than rounding (last {promised:.1e}, relative) and the KKT \
             residual stays at {residual:.1e}"
        );
        Verdict::new(Status::Stalled, message)
    })
}
