use super::Distribution;
use crate::number::Taylor;
use serde::Serialize;

/// A mean and a standard deviation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "Moments"))]
pub struct DeltaMoments {
    /// The mean.
    pub mean: f64,
    /// The standard deviation.
    pub standard_uncertainty: f64,
}

/// Mean and standard deviation of a function of independent random variables by the delta method,
/// from derivatives at their means: first order (exact for linear functions) and second order
/// (exact for quadratic functions). The second-order result is `None` without a Hessian. Value,
/// gradient and Hessian at the means are f, g and H; μₖᵢ is the central moment k of variable i.
///
/// ```text
///   mean = f + ½ Σ H_ii μ₂ᵢ
///   variance = Σ (gᵢ² μ₂ᵢ + gᵢ H_ii μ₃ᵢ + ¼ H_ii² (μ₄ᵢ − μ₂ᵢ²)) + Σ_{i<j} H_ij² μ₂ᵢ μ₂ⱼ
/// ```
///
/// # Panics
/// If the number of derivatives differs from the number of distributions.
pub fn delta_method(
    at_means: &Taylor,
    inputs: &[Distribution],
) -> (DeltaMoments, Option<DeltaMoments>) {
    at_means.expect_derivatives_by(inputs.len(), "distributions");
    let moments: Vec<[f64; 3]> = inputs.iter().map(Distribution::central_moments).collect();
    let gradient = &at_means.gradient;
    let linear: f64 = gradient
        .iter()
        .zip(&moments)
        .map(|(g, [second, ..])| g * g * second)
        .sum();
    // squares may overflow even if the deviations do not
    let by_size = || {
        gradient
            .iter()
            .zip(inputs)
            .map(|(g, input)| (g * input.deviation()).abs())
            .fold(0.0, f64::hypot)
    };
    let deviation = if linear.is_finite() {
        linear.sqrt()
    } else {
        by_size()
    };
    let first = DeltaMoments {
        mean: at_means.value,
        standard_uncertainty: deviation,
    };
    if at_means.hessian.is_empty() {
        return (first, None);
    }
    let (mut mean, mut variance) = (at_means.value, linear);
    for (i, [second, third, fourth]) in moments.iter().enumerate() {
        let own = at_means.hessian[i][i];
        mean += 0.5 * own * second;
        variance += gradient[i] * own * third + 0.25 * own * own * (fourth - second * second);
        for (j, [other, ..]) in moments.iter().enumerate().take(i) {
            variance += at_means.hessian[i][j].powi(2) * second * other;
        }
    }
    // clamp: rounding may make the variance negative
    (
        first,
        Some(DeltaMoments {
            mean,
            standard_uncertainty: variance.max(0.0).sqrt(),
        }),
    )
}
