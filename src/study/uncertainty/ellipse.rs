use super::bootstrap::quantile;
use serde::Serialize;
use statrs::distribution::{ContinuousCDF, Normal};

/// Smallest ratio of the variances along the two axes of an ellipse. If the ratio is smaller, the
/// ellipse is a line, up to rounding.
const FLAT: f64 = 1e-14;

/// An ellipse that contains a given share of the landings.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct LandingEllipse {
    /// The nominal fraction of the drives inside the ellipse, 0 to 1.
    // the fraction if the landings are normally distributed
    pub share: f64,
    /// The centre.
    pub centre: LandingPoint,
    /// The half-axes as vectors of lateral distance and carry, the longer one first, m.
    pub half_axes: [[f64; 2]; 2],
}

/// A point on the ground, m.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct LandingPoint {
    /// The distance to the right, m.
    pub lateral: f64,
    /// The distance downrange, m.
    pub carry: f64,
}

/// Mean and covariance of landings.
#[derive(Clone, Copy, Debug)]
pub(super) struct LandingMoments {
    /// Mean of lateral and carry, m.
    pub mean: [f64; 2],
    /// Covariance of lateral and carry, m².
    pub covariance: [[f64; 2]; 2],
}

impl LandingMoments {
    /// Moments of a sample of landings [lateral, carry], m; they are NaN for fewer than two
    /// landings.
    pub(super) fn of_sample(landings: &[[f64; 2]]) -> Self {
        let n = landings.len() as f64;
        let mean = [0, 1].map(|row| landings.iter().map(|landing| landing[row]).sum::<f64>() / n);
        let product = |i: usize, j: usize| {
            landings
                .iter()
                .map(|landing| (landing[i] - mean[i]) * (landing[j] - mean[j]))
                .sum::<f64>()
                / (n - 1.0)
        };
        let covariance = [
            [product(0, 0), product(0, 1)],
            [product(1, 0), product(1, 1)],
        ];
        Self { mean, covariance }
    }
}

/// An ellipse of the landings.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "EllipseReport"))]
pub struct SampledEllipse {
    /// The ellipse.
    #[serde(flatten)]
    pub ellipse: LandingEllipse,
    /// The source of the covariance.
    pub by: EllipseSource,
    /// The fraction of the sample's drives inside the ellipse, 0 to 1.
    pub holds: f64,
}

/// The source of the covariance of an ellipse.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum EllipseSource {
    /// The gradients at the means of the parameters.
    Gradient,
    /// The whole sample.
    Sample,
}

impl LandingEllipse {
    /// The ellipse around the mean that contains the share p of a bivariate normal distribution of
    /// lateral and carry, m, with this covariance, m². In the ellipse, the squared Mahalanobis
    /// distance is at most −2 ln(1 − p). If the landings lie on a line, they have a univariate
    /// normal distribution, and the ellipse ends at the quantiles (1 ± p)/2.
    pub fn new(share: f64, [lateral, carry]: [f64; 2], covariance: [[f64; 2]; 2]) -> Self {
        let [[xx, xy], [_, yy]] = covariance;
        let eigen = nalgebra::Matrix2::new(xx, xy, xy, yy).symmetric_eigen();
        let is_flat = eigen.eigenvalues.min() <= FLAT * eigen.eigenvalues.max();
        let of_a_line = || Normal::standard().inverse_cdf(0.5 + 0.5 * share);
        let radius = if is_flat {
            of_a_line()
        } else {
            (-2.0 * (1.0 - share).ln()).sqrt()
        };
        let axis = |k: usize| {
            // clamp: rounding may make the variance negative
            let length = radius * eigen.eigenvalues[k].max(0.0).sqrt();
            [0, 1].map(|row| length * eigen.eigenvectors[(row, k)])
        };
        let (long, short) = if eigen.eigenvalues[0] >= eigen.eigenvalues[1] {
            (0, 1)
        } else {
            (1, 0)
        };
        Self {
            share,
            centre: LandingPoint { lateral, carry },
            half_axes: [axis(long), axis(short)],
        }
    }

    /// The ellipse that contains the share p of a sample of two or more landings [lateral, carry],
    /// m, however they are distributed. Centre and shape are from the mean and the covariance of
    /// the sample; the size is the p-quantile of the Mahalanobis distances.
    pub(in crate::study) fn of_sample(share: f64, landings: &[[f64; 2]]) -> Self {
        let LandingMoments { mean, covariance } = LandingMoments::of_sample(landings);
        let normal = Self::new(share, mean, covariance);
        let mut distances: Vec<f64> = landings
            .iter()
            .map(|landing| normal.relative_distance(*landing))
            .collect();
        distances.sort_by(f64::total_cmp);
        let scale = quantile(&distances, share);
        Self {
            half_axes: normal.half_axes.map(|axis| axis.map(|part| scale * part)),
            ..normal
        }
    }

    /// Mahalanobis distance of a landing from the centre, relative to that of the boundary. For a
    /// flat ellipse, the distance along its line.
    fn relative_distance(&self, landing: [f64; 2]) -> f64 {
        let off = self.offset(landing);
        self.half_axes
            .iter()
            .map(|axis| part_along(off, axis))
            .fold(0.0, f64::hypot)
    }

    /// Reports whether the ellipse contains a landing.
    pub fn contains(&self, landing: [f64; 2]) -> bool {
        let LandingPoint { lateral, carry } = self.centre;
        let off = self.offset(landing);
        let left = self.half_axes.iter().fold(off, |left, axis| {
            let part = part_along(off, axis);
            [left[0] - part * axis[0], left[1] - part * axis[1]]
        });
        // a flat ellipse is a line, and contains only points on this line, up to rounding
        let rounding = 1e-12 * (off[0].hypot(off[1]) + lateral.hypot(carry));
        self.relative_distance(landing) <= 1.0 && left[0].hypot(left[1]) <= rounding
    }

    /// Vector from the centre to a landing, m.
    fn offset(&self, [lateral, carry]: [f64; 2]) -> [f64; 2] {
        [lateral - self.centre.lateral, carry - self.centre.carry]
    }
}

/// Component of `off` along a half-axis, in lengths of this half-axis; 0 for a half-axis of length
/// 0.
fn part_along(off: [f64; 2], axis: &[f64; 2]) -> f64 {
    let square = axis[0] * axis[0] + axis[1] * axis[1];
    if square > 0.0 {
        (off[0] * axis[0] + off[1] * axis[1]) / square
    } else {
        0.0
    }
}
