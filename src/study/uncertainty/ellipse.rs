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

    /// Reports whether the ellipse contains a landing.
    pub fn contains(&self, landing: [f64; 2]) -> bool {
        let LandingPoint { lateral, carry } = self.centre;
        let off = [landing[0] - lateral, landing[1] - carry];
        let (mut squares, mut left) = (0.0, off);
        for axis in self.half_axes {
            let square = axis[0] * axis[0] + axis[1] * axis[1];
            if square > 0.0 {
                let part = (off[0] * axis[0] + off[1] * axis[1]) / square;
                squares += part * part;
                left = [left[0] - part * axis[0], left[1] - part * axis[1]];
            }
        }
        // a flat ellipse is a line, and contains only points on this line, up to rounding
        let rounding = 1e-12 * (off[0].hypot(off[1]) + lateral.hypot(carry));
        squares <= 1.0 && left[0].hypot(left[1]) <= rounding
    }
}
