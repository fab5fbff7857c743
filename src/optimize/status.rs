//! How a search ends. A status is a verdict with its numbers; bad input is an [`Error`](crate::Error) instead.
//!
//! Each stopping test is a function of its own. All sizes are relative: variables are measured by
//! [`Bounds::scale`](super::Bounds::scale) (s), the function by
//! φ = max(|f|, largest s-scaled gradient at the start), and the KKT residual is
//! maxᵢ sᵢ |pᵢ|/φ with p the gradient projected on the bounds: its component is 0 where a bound is active and
//! f falls only towards the outside.

use super::kink::Kink;
use std::fmt;

/// How a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// The projected gradient vanishes.
    Converged,
    /// The function has a corner here, and no way down from it was found.
    StalledAtKink,
    /// No further progress can be made out above the rounding of the function.
    Stalled,
    /// The iterations allowed were used up.
    IterationLimit,
    /// The function is not defined at the start, nor at any other point tried.
    Undefined,
}

impl Status {
    /// The status in a word: `converged`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::StalledAtKink => "stalled-at-kink",
            Self::Stalled => "stalled",
            Self::IterationLimit => "iteration-limit",
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
#[derive(Clone, Debug, PartialEq)]
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
                "{iterations} iterations used up with a KKT residual of {residual:.1e}; allow more, or start nearer"
            ),
        )
    }

    pub fn undefined(trials: u32, why: &str) -> Self {
        Self::new(
            Status::Undefined,
            format!("the function is not defined at the start nor at {trials} other points of the box: {why}"),
        )
    }

    pub fn kink(kink: &Kink, at: f64, residual: f64) -> Self {
        let Kink { variable, slope_below, slope_above } = kink;
        let message = format!(
            "the function has a corner in variable {variable} at {at:e}: its slope is {slope_below:.6} below and {slope_above:.6} above, \
             so that no gradient vanishes; KKT residual {residual:.1e}"
        );
        Self::new(Status::StalledAtKink, message)
    }
}

/// Converged: the projected gradient is small enough.
pub(super) fn gradient_test(residual: f64, tolerance: f64) -> Option<Verdict> {
    let passed = residual <= tolerance;
    passed.then(|| Verdict::new(Status::Converged, format!("KKT residual {residual:.1e} <= {tolerance:.0e}")))
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
            "{sides} sides of a corner hold the step and the model promises {promised:.1e} <= {LEAST:.0e} (relative); \
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
            "for {PATIENCE} iterations the model promised at most rounding (last {promised:.1e}, relative) and the KKT \
             residual stays at {residual:.1e}"
        );
        Verdict::new(Status::Stalled, message)
    })
}
