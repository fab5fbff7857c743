//! First derivatives over `num_dual::Dual64`, one flight per parameter. They are independent of the
//! jets: they use no common differentiation rule, no lanes and no chain rule.

use crate::derivative::check::Ladder;
use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::parameters::{Parameter, Setup};
use num_dual::Dual64;

/// Tolerance of [`Agreement::difference`], relative to the derivative.
const RELATIVE: f64 = 1e-9;

/// Rounding tolerance, relative to the magnitude of the outcome's terms over the parameter's scale.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A first derivative over jets, compared with the derivative over num-dual.
#[derive(Clone, Copy, Debug)]
pub struct Agreement {
    /// The derivative over `num_dual::Dual64`.
    pub num_dual: f64,
    /// |jet − num-dual|.
    pub difference: f64,
    /// Largest difference that rounding explains.
    pub tolerance: f64,
}

impl Agreement {
    /// Compares a derivative over jets with the derivative over num-dual.
    pub(super) fn new(jet: f64, num_dual: f64, ladder: &Ladder) -> Self {
        let size = num_dual.abs().max(ladder.next_to_nothing());
        let tolerance = RELATIVE * size + ROUNDING * ladder.rounded / ladder.scale;
        Self {
            num_dual,
            difference: (jet - num_dual).abs(),
            tolerance,
        }
    }

    /// True if the difference is within the tolerance; false for NaN.
    pub fn holds(&self) -> bool {
        self.difference <= self.tolerance
    }
}

/// Derivatives of several outcomes by one parameter, over num-dual.
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
