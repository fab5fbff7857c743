use super::ladder::{LEAST_STEP, rounding_of};
use super::{DerivativeEstimate, Ladder, Side};
use crate::json::JsonNumber;
use serde::Serialize;

/// Result of comparing an exact derivative with differences.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// Differences contradict the derivative, or are too inaccurate to confirm it.
    Fail,
    /// The function has a kink here, and no unique derivative.
    Corner,
    /// Differences confirm the derivative.
    Pass,
}

variant_names! {
    /// Name in JSON, such as `pass`.
    Verdict as "Verdict" {
        Fail = "fail",
        Corner = "corner",
        Pass = "pass",
    }
}

impl Verdict {
    /// `Pass` for a check that passed, otherwise `Fail`.
    pub fn of(passed: bool) -> Self {
        if passed { Self::Pass } else { Self::Fail }
    }
}

/// Tolerance of a derivative, as a multiple of the error estimate of the differences. The estimates
/// are rough: a few of ten thousand correct derivatives deviate by more than four estimates.
pub const TOLERANCE_FACTOR: f64 = 5.0;

/// A derivative is negligible if a change of the variable by its scale changes the function by less
/// than this fraction of the function's size.
pub const NEGLIGIBLE: f64 = 1e-2;

/// Required accuracy of differences.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Demand {
    /// Smallest tolerance, relative to the derivative or to [`Ladder::negligible_size`], whichever
    /// is larger. Higher derivatives may jump, for example where the number of steps of a flight
    /// changes; the error of a difference is then larger than its estimate.
    pub least_tolerance: f64,
    /// Largest tolerance with which a derivative can pass, relative to the derivative or to
    /// [`Ladder::negligible_size`], whichever is larger; `None` for no limit.
    pub largest_tolerance: Option<f64>,
}

impl Demand {
    /// For differences of values. They detect relative errors above 1e-6, which is 100 times the
    /// smallest tolerance.
    pub const FIRST: Self = Self {
        least_tolerance: 1e-8,
        largest_tolerance: Some(1e-6),
    };
    /// For differences of gradients. The derivative of a gradient may jump, so the tolerance has no
    /// upper limit.
    pub const SECOND: Self = Self {
        least_tolerance: 1e-7,
        largest_tolerance: None,
    };
}

/// Rounding error of the exact derivative, as a multiple of [`Ladder::rounding_size`] divided by
/// the scale of the variable.
const OWN_ROUNDING: f64 = 64.0 * f64::EPSILON;

/// One step of a V-curve: error of the central difference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint {
    /// Step, in the variable's unit.
    pub step: f64,
    /// Central difference (f(x + h) − f(x − h))/2h.
    pub difference: f64,
    /// |exact derivative − central difference|.
    pub error: f64,
}

/// The errors of central differences at several steps.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Curve {
    /// The steps, SI.
    pub steps: Vec<f64>,
    /// The error at each step, SI.
    pub errors: Vec<f64>,
}

impl Curve {
    /// The errors at these points.
    pub fn of(points: &[CurvePoint]) -> Self {
        Self {
            steps: points.iter().map(|point| point.step).collect(),
            errors: points.iter().map(|point| point.error).collect(),
        }
    }
}

/// A derivative compared with its numerical value.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "CheckReport"))]
pub struct Check {
    /// `pass`, `fail` or `corner`.
    pub verdict: Verdict,
    /// The exact derivative, SI.
    #[serde(serialize_with = "crate::json::number")]
    #[cfg_attr(test, schemars(with = "JsonNumber"))]
    pub exact: f64,
    /// The best numerical derivative, SI.
    // `None` if no side has enough values
    #[serde(serialize_with = "crate::json::number")]
    #[cfg_attr(test, schemars(with = "JsonNumber"))]
    pub best_difference: Option<DerivativeEstimate>,
    /// The absolute difference between `exact` and `best_difference`, SI.
    #[serde(serialize_with = "crate::json::number")]
    #[cfg_attr(test, schemars(with = "JsonNumber"))]
    pub error: f64,
    /// The largest allowed difference, SI.
    // [`TOLERANCE_FACTOR`] times the error estimate of the differences, but at least
    // [`Demand::least_tolerance`] plus [`OWN_ROUNDING`]
    #[serde(serialize_with = "crate::json::number")]
    #[cfg_attr(test, schemars(with = "JsonNumber"))]
    pub tolerance: f64,
    /// The one-sided derivatives below and above a corner, SI; `null` without a corner. One of the
    /// two derivatives is `null` if its side is outside of the parameter's range.
    pub sides: Option<[Option<f64>; 2]>,
    /// V-curve of central differences, the largest step first.
    #[serde(skip)]
    pub curve: Vec<CurvePoint>,
}

impl From<Option<DerivativeEstimate>> for JsonNumber {
    fn from(estimate: Option<DerivativeEstimate>) -> Self {
        Self(estimate.map(|estimate| estimate.value))
    }
}

impl Check {
    /// True if the verdict is `Fail`.
    pub fn failed(&self) -> bool {
        self.verdict == Verdict::Fail
    }

    /// Step at which the central difference is most accurate.
    pub fn best_step(&self) -> Option<CurvePoint> {
        self.curve
            .iter()
            .copied()
            .min_by(|a, b| a.error.total_cmp(&b.error))
    }
}

impl Ladder {
    /// Compares a derivative with the differences of the samples.
    pub fn judge(&self, exact: f64, demand: Demand) -> Check {
        let plain = |rung: &super::Rung| {
            let difference = self.difference(rung, Side::Both)?;
            Some(CurvePoint {
                step: rung.step,
                difference,
                error: (exact - difference).abs(),
            })
        };
        let curve = self.rungs.iter().filter_map(plain).collect();
        let sides = self.corner();
        let size = exact.abs().max(self.negligible_size());
        let least = demand.least_tolerance * size + OWN_ROUNDING * self.rounding_size / self.scale;
        let tolerance_of =
            |found: &DerivativeEstimate| least.max(TOLERANCE_FACTOR * found.uncertainty);
        let is_resolved = |tolerance: f64| {
            demand
                .largest_tolerance
                .is_none_or(|largest| tolerance <= largest * size)
        };
        // if the derivative has a kink at this point, a one-sided difference is more accurate than
        // a central one
        let estimates = [Side::Both, Side::Above, Side::Below]
            .map(|side| self.slope(side, least / TOLERANCE_FACTOR));
        let estimates = || estimates.iter().flatten().copied();
        let best_difference = estimates()
            .find(|found| is_resolved(tolerance_of(found)))
            .or_else(|| estimates().min_by(|a, b| a.uncertainty.total_cmp(&b.uncertainty)));
        let error = best_difference.map_or(f64::INFINITY, |found| (exact - found.value).abs());
        let tolerance = best_difference.as_ref().map_or(0.0, tolerance_of);
        let verdict = if sides.is_some() {
            Verdict::Corner
        } else if error <= tolerance && is_resolved(tolerance) {
            Verdict::Pass
        } else {
            Verdict::Fail
        };
        Check {
            exact,
            best_difference,
            sides,
            error,
            tolerance,
            verdict,
            curve,
        }
    }

    /// Like [`judge`](Self::judge), for a function with a known kink at this point. At the end of
    /// the variable's range, differences exist on one side only, and the exact derivative may be
    /// that of the other side. The verdict is then `Corner` instead of `Fail`.
    pub fn judge_on_a_corner(&self, exact: f64, demand: Demand) -> Check {
        let check = self.judge(exact, demand);
        let sides =
            [Side::Below, Side::Above].map(|side| self.slope(side, 0.0).map(|slope| slope.value));
        if check.failed() && sides.iter().flatten().count() == 1 {
            Check {
                sides: Some(sides),
                verdict: Verdict::Corner,
                ..check
            }
        } else {
            check
        }
    }

    /// Size below which a derivative is negligible.
    pub fn negligible_size(&self) -> f64 {
        NEGLIGIBLE * self.size / self.scale
    }

    /// One-sided derivatives (below, above) at a corner; `None` without a corner. At a corner, the
    /// difference of the two derivatives exceeds three limits: ten times the sum of their error
    /// estimates, 1e-4 times the larger derivative, and the rounding error over the smallest step.
    fn corner(&self) -> Option<[Option<f64>; 2]> {
        let (below, above) = (self.slope(Side::Below, 0.0)?, self.slope(Side::Above, 0.0)?);
        let distance = (above.value - below.value).abs();
        let size = above.value.abs().max(below.value.abs());
        let rounding = rounding_of(self.rounding_size) / (LEAST_STEP * self.scale);
        let limit = (10.0 * (above.uncertainty + below.uncertainty))
            .max(1e-4 * size)
            .max(rounding);
        (distance > limit).then_some([Some(below.value), Some(above.value)])
    }
}
