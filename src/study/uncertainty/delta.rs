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
    #[serde(rename = "standard_uncertainty")]
    pub deviation: f64,
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
        deviation,
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
            deviation: variance.max(0.0).sqrt(),
        }),
    )
}

#[cfg(test)]
mod tests {
    use super::super::Distribution::{Normal, Triangular, Uniform};
    use super::{Taylor, delta_method};

    #[test]
    fn exact_moments_of_a_linear_function_of_any_distributions() {
        // 3 x − 2 y + z: variances 9·4 + 4·6²/12 + 3²/18
        let inputs = [
            Normal {
                mean: 1.0,
                deviation: 2.0,
            },
            Uniform {
                low: -3.0,
                high: 3.0,
            },
            Triangular {
                low: 0.0,
                mode: 0.0,
                high: 3.0,
            },
        ];
        let value = 3.0 * 1.0 - 0.0 + 1.0;
        let hessian = vec![vec![0.0; 3]; 3];
        let (first, second) = delta_method(
            &Taylor {
                value,
                gradient: vec![3.0, -2.0, 1.0],
                hessian,
            },
            &inputs,
        );
        assert!((first.mean - 4.0).abs() < 1e-15);
        assert!((first.deviation - (36.0_f64 + 12.0 + 0.5).sqrt()).abs() < 1e-15);
        assert_eq!(second, Some(first));
    }

    #[test]
    fn exact_moments_of_squares_and_products() {
        // x², x normal (0, 1): mean 1, variance 2; x y: mean 0, variance 1
        let normal = Normal {
            mean: 0.0,
            deviation: 1.0,
        };
        let square = Taylor {
            value: 0.0,
            gradient: vec![0.0],
            hessian: vec![vec![2.0]],
        };
        let second = delta_method(&square, &[normal]).1.unwrap();
        assert!(
            (second.mean - 1.0).abs() < 1e-15 && (second.deviation - 2.0_f64.sqrt()).abs() < 1e-15
        );
        let product = Taylor {
            value: 0.0,
            gradient: vec![0.0; 2],
            hessian: vec![vec![0.0, 1.0], vec![1.0, 0.0]],
        };
        let second = delta_method(&product, &[normal, normal]).1.unwrap();
        assert_eq!((second.mean, second.deviation), (0.0, 1.0));
        // (x + 1)² for x uniform on [0, 1], expanded about ½: mean 7/3, variance ∫(x+1)⁴ − (7/3)² =
        // 31/5 − 49/9
        let uniform = Uniform {
            low: 0.0,
            high: 1.0,
        };
        let shifted = Taylor {
            value: 2.25,
            gradient: vec![3.0],
            hessian: vec![vec![2.0]],
        };
        let second = delta_method(&shifted, &[uniform]).1.unwrap();
        assert!((second.mean - 7.0 / 3.0).abs() < 1e-15);
        assert!((second.deviation.powi(2) - (31.0 / 5.0 - 49.0 / 9.0)).abs() < 1e-14);
        // x² of a skew triangle on [0, 1] with its mode at 0, density 2 (1 − x): E x² = 1/6, E x⁴ =
        // 1/15
        let triangle = Triangular {
            low: 0.0,
            mode: 0.0,
            high: 1.0,
        };
        let square = Taylor {
            value: 1.0 / 9.0,
            gradient: vec![2.0 / 3.0],
            hessian: vec![vec![2.0]],
        };
        let second = delta_method(&square, &[triangle]).1.unwrap();
        assert!((second.mean - 1.0 / 6.0).abs() < 1e-15);
        assert!((second.deviation.powi(2) - (1.0 / 15.0 - 1.0 / 36.0)).abs() < 1e-15);
    }
}
