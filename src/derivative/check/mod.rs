//! Verification of exact derivatives by finite differences, for any function.
//!
//! Three checks use the values at x ± h, with h from 1e-1 to 1e-13 of the variable's scale:
//!
//! - the **V-curve** of central differences: with smaller steps their error falls as h², until the
//!   rounding error, which rises as 1/h, dominates;
//! - the **verdict**: the derivative is compared with differences extrapolated to step 0; the
//!   tolerance is a multiple of their error estimate;
//! - **Taylor remainders**: with exact gradient and Hessian they fall as h, h², h³.
//!
//! ```
//! use longdrive::derivative::check::{Verdict, check};
//! use longdrive::derivative::Taylor;
//!
//! // x² y³ at (2, 1), and with a derivative that is wrong by a millionth
//! let f = |x: &[f64], slip: f64| Taylor {
//!     value: x[0] * x[0] * x[1].powi(3),
//!     gradient: vec![2.0 * x[0] * x[1].powi(3) * slip, 3.0 * x[0] * x[0] * x[1] * x[1]],
//!     hessian: vec![],
//! };
//! let right = check(&|x| Some(f(x, 1.0)), &[2.0, 1.0], &[2.0, 1.0]);
//! assert!(right.gradient.iter().all(|check| check.verdict == Verdict::Pass));
//! let wrong = check(&|x| Some(f(x, 1.0 + 1e-6)), &[2.0, 1.0], &[2.0, 1.0]);
//! assert_eq!(wrong.gradient[0].verdict, Verdict::Fail);
//! ```

mod estimate;
mod ladder;
mod remainder;
mod verdict;

pub use estimate::{DerivativeEstimate, Side};
pub use ladder::{FEW_STEP_EXPONENTS, Ladder, Rung, STEP_EXPONENTS};
pub(crate) use remainder::line_slope;
pub use remainder::taylor_slopes;
pub use verdict::{Check, Curve, CurvePoint, Demand, NEGLIGIBLE, TOLERANCE_FACTOR, Verdict};

use super::Taylor;

/// Derivatives of a function, compared with differences.
#[derive(Clone, Debug)]
pub struct CheckedDerivatives {
    /// Each ∂f/∂xᵢ, compared with differences of values.
    pub gradient: Vec<Check>,
    /// Each ∂²f/∂xᵢ∂xⱼ, compared with differences of ∂f/∂xⱼ along xᵢ; empty without a Hessian.
    pub hessian: Vec<Vec<Check>>,
    /// Orders of the Taylor remainders along each xᵢ. Exact derivatives give 1, 2 and 3; without a
    /// Hessian they give 1, 2 and 2. `None` if too few remainders exceed the rounding error.
    pub slopes: Vec<[Option<f64>; 3]>,
}

impl CheckedDerivatives {
    /// True if no check failed.
    pub fn passed(&self) -> bool {
        self.gradient
            .iter()
            .chain(self.hessian.iter().flatten())
            .all(|check| check.verdict != Verdict::Fail)
    }
}

/// Checks the derivatives of `f` at `x` against differences of its values and gradients. `scale` is
/// the scale of each variable, the unit of the steps. `f` returns `None` where it has no value.
///
/// # Panics
/// If the numbers of scales and variables differ, or a scale is not positive.
pub fn check(f: &dyn Fn(&[f64]) -> Option<Taylor>, x: &[f64], scale: &[f64]) -> CheckedDerivatives {
    assert_eq!(x.len(), scale.len(), "a scale for each variable");
    assert!(
        scale.iter().all(|scale| *scale > 0.0),
        "scales above 0: {scale:?}"
    );
    let exact = f(x).unwrap_or(Taylor {
        value: f64::NAN,
        gradient: vec![f64::NAN; x.len()],
        hessian: vec![],
    });
    let along = |i: usize, value: f64| {
        let mut moved = x.to_vec();
        moved[i] = value;
        f(&moved)
    };
    let mut checked = CheckedDerivatives {
        gradient: vec![],
        hessian: vec![],
        slopes: vec![],
    };
    for i in 0..x.len() {
        let mut values = |value: f64| vec![along(i, value).map_or(f64::NAN, |taylor| taylor.value)];
        for ladder in Ladder::sample(x[i], scale[i], STEP_EXPONENTS, &mut values) {
            let second = exact.hessian.get(i).map_or(0.0, |row| row[i]);
            checked
                .gradient
                .push(ladder.judge(exact.gradient[i], Demand::FIRST));
            checked
                .slopes
                .push(taylor_slopes(&ladder, exact.gradient[i], second));
        }
        if let Some(row) = exact.hessian.get(i) {
            let mut gradients =
                |value: f64| along(i, value).map_or(vec![], |taylor| taylor.gradient);
            let ladders = Ladder::sample(x[i], scale[i], FEW_STEP_EXPONENTS, &mut gradients);
            let judged = |(j, ladder): (usize, Ladder)| {
                ladder
                    .with_least_size(exact.value.abs() / scale[j])
                    .judge(row[j], Demand::SECOND)
            };
            checked
                .hessian
                .push(ladders.into_iter().enumerate().map(judged).collect());
        }
    }
    checked
}
