//! First derivatives computed with `num_dual::Dual64`, one flight per parameter. They are an
//! independent check of the derivatives computed with jets: the two have no differentiation rule,
//! SIMD lane or chain rule in common.

use crate::derivative::check::{Ladder, Verdict};
use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::json::number;
use crate::parameters::{Parameter, Setup};
use num_dual::Dual64;
use serde::Serialize;

/// Tolerance of [`Agreement::difference`], relative to the derivative.
const RELATIVE: f64 = 1e-9;

/// Rounding tolerance of a derivative, as a multiple of `rounding_size` / `scale` of its
/// [`Ladder`].
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A derivative compared with the derivative from `num_dual::Dual64`.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "AgreementReport"))]
pub struct Agreement {
    /// `pass` or `fail`.
    pub verdict: Verdict,
    /// The derivative from `num_dual::Dual64`, SI.
    #[serde(rename = "derivative", serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub num_dual: f64,
    /// The difference from the exact derivative, SI.
    #[serde(serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub difference: f64,
    /// The largest allowed difference, SI.
    #[serde(serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub tolerance: f64,
}

impl Agreement {
    /// Compares the derivative `jet`, computed with jets, with the derivative computed with
    /// num-dual. The magnitudes in `ladder` determine the tolerance.
    pub fn new(jet: f64, num_dual: f64, ladder: &Ladder) -> Self {
        let size = num_dual.abs().max(ladder.negligible_size());
        let tolerance = RELATIVE * size + ROUNDING * ladder.rounding_size / ladder.scale;
        let difference = (jet - num_dual).abs();
        Self {
            // a difference that is NaN fails
            verdict: Verdict::of(difference <= tolerance),
            num_dual,
            difference,
            tolerance,
        }
    }
}

/// Derivatives of several outcomes by one parameter, computed with num-dual.
///
/// # Errors
/// The errors of [`Drive::new`] and [`Outcome::of`].
pub(super) fn by_num_dual(
    setup: &Setup<f64>,
    of: &[Outcome],
    parameter: &'static Parameter,
) -> Result<Vec<f64>> {
    let variable = Dual64::from_re(setup.value(parameter).unwrap_or_default()).derivative();
    let mut lifted = setup.constant::<Dual64>();
    lifted.put(&[parameter], |_| variable);
    let drive = Drive::without_step_check(&lifted, None)?;
    of.iter().map(|of| Ok(of.of(&drive)?.eps)).collect()
}
