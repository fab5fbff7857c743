//! What a fit's Jacobian says of its parameters.

use crate::error::{Error, Result};
use crate::optimize::least_squares::{Loss, Rows};
use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ChiSquared, ContinuousCDF, Normal, StudentsT};

/// Singular values below this part of the largest, of the Jacobian with columns of length 1, are none: what the data then say
/// of that direction is rounding.
const SINGULAR: f64 = 1e-8;
/// Parts of a direction below this are rounding.
const PART: f64 = 1e-6;

/// What the data say of the parameters, all in SI and in their order.
#[derive(Clone, Debug)]
pub struct Statistics {
    /// Covariance; `None` where a parameter is not determined or is held by a bound.
    pub covariance: Vec<Vec<Option<f64>>>,
    /// Directions that the data do not determine.
    pub undetermined: Vec<Undetermined>,
    /// Σ rᵢ², with Huber's loss Σ wᵢ rᵢ².
    pub chi_square: f64,
    /// Residuals less parameters that were free and determined.
    pub degrees_of_freedom: usize,
    /// How likely a sum this large or larger is if the standard uncertainties are right; `None` where they are not stated.
    pub probability: Option<f64>,
    /// What standard errors were multiplied by: 1 where the data's uncertainties are stated, else √(χ²/ν).
    pub scale: f64,
    /// How many standard errors a 95 % interval reaches to each side.
    pub reach: f64,
}

/// A combination of parameters that can change without the data noticing.
#[derive(Clone, Debug, PartialEq)]
pub struct Undetermined {
    /// Places of the parameters, and how much each changes, SI.
    pub parts: Vec<(usize, f64)>,
}

impl Statistics {
    /// Of residuals and their Jacobian at the end of a fit; `is_free` tells which parameters no bound holds, and
    /// `has_sigmas` whether residuals are in units of stated standard uncertainties.
    ///
    /// # Errors
    /// [`Error::Calibration`] where the singular values do not come out.
    pub fn new(rows: &Rows, is_free: &[bool], has_sigmas: bool, loss: Loss) -> Result<Self> {
        let free: Vec<usize> = (0..is_free.len()).filter(|&i| is_free[i]).collect();
        let m = rows.residuals.len();
        let weights: Vec<f64> = rows.residuals.iter().map(|r| loss.weight(*r)).collect();
        let j = DMatrix::from_fn(m, free.len(), |i, k| weights[i].sqrt() * rows.jacobian[i][free[k]]);
        let lengths: Vec<f64> = j.column_iter().map(|column| column.norm()).collect();
        let size = |k: usize| if lengths[k] > 0.0 { lengths[k] } else { 1.0 };
        let scaled =
            DMatrix::from_fn(m.max(free.len()), free.len(), |i, k| if i < m { j[(i, k)] / size(k) } else { 0.0 });
        let chi_square: f64 = rows.residuals.iter().zip(&weights).map(|(r, w)| w * r * r).sum();
        let broken = || Error::Calibration { reason: "the Jacobian's singular values cannot be computed".into() };
        let (values, directions) = if free.is_empty() {
            (DVector::zeros(0), DMatrix::zeros(0, 0))
        } else {
            let svd = scaled.try_svd(false, true, f64::EPSILON, 10_000).ok_or_else(broken)?;
            (svd.singular_values, svd.v_t.ok_or_else(broken)?)
        };
        let largest = values.iter().copied().fold(0.0, f64::max);
        let is_singular = |k: usize| values[k] <= SINGULAR * largest;
        let rank = (0..free.len()).filter(|&k| !is_singular(k)).count();
        let degrees_of_freedom = m.saturating_sub(rank);
        let scale = match degrees_of_freedom {
            _ if has_sigmas => 1.0,
            0 => f64::NAN,
            dof => (chi_square / dof as f64).sqrt(),
        };
        let undetermined: Vec<_> = (0..free.len())
            .filter(|&k| is_singular(k))
            .map(|k| Undetermined {
                parts: (0..free.len())
                    .filter(|&i| directions[(k, i)].abs() > PART.sqrt())
                    .map(|i| (free[i], directions[(k, i)] / size(i)))
                    .collect(),
            })
            .collect();
        let is_determined =
            |i: usize| (0..free.len()).all(|k| !is_singular(k) || directions[(k, i)].abs() <= PART.sqrt());
        let mut covariance = vec![vec![None; is_free.len()]; is_free.len()];
        for a in (0..free.len()).filter(|&a| is_determined(a) && scale.is_finite()) {
            for b in (0..free.len()).filter(|&b| is_determined(b)) {
                let part = |k: usize| directions[(k, a)] * directions[(k, b)] / values[k].powi(2);
                let sum: f64 = (0..free.len()).filter(|&k| !is_singular(k)).map(part).sum();
                covariance[free[a]][free[b]] = Some(scale * scale * sum / (size(a) * size(b)));
            }
        }
        Ok(Self {
            covariance,
            undetermined,
            chi_square,
            degrees_of_freedom,
            probability: if has_sigmas { upper_tail(chi_square, degrees_of_freedom) } else { None },
            scale,
            reach: reach(degrees_of_freedom, has_sigmas),
        })
    }

    /// Standard error of the parameter at a place.
    pub fn standard_error(&self, at: usize) -> Option<f64> {
        self.covariance[at][at].map(f64::sqrt)
    }

    /// Correlation of two parameters.
    pub fn correlation(&self, a: usize, b: usize) -> Option<f64> {
        Some(self.covariance[a][b]? / (self.standard_error(a)? * self.standard_error(b)?))
    }
}

fn upper_tail(chi_square: f64, degrees_of_freedom: usize) -> Option<f64> {
    ChiSquared::new(degrees_of_freedom as f64).ok().map(|distribution| distribution.sf(chi_square))
}

/// The 97.5 % point of the normal distribution, or of Student's where the scale is itself estimated.
fn reach(degrees_of_freedom: usize, has_sigmas: bool) -> f64 {
    let normal = Normal::standard().inverse_cdf(0.975);
    if has_sigmas {
        return normal;
    }
    StudentsT::new(0.0, 1.0, degrees_of_freedom.max(1) as f64).map_or(normal, |student| student.inverse_cdf(0.975))
}

#[cfg(test)]
mod tests {
    use super::Statistics;
    use crate::optimize::least_squares::{Loss, Rows};

    /// A line through 0, 1, 2 with unit uncertainties: (JᵀJ)⁻¹ of the normal equations, by hand; a third column that repeats
    /// the second cannot be told from it, and spoils neither the first nor the sum.
    #[test]
    fn exact_covariance_of_a_line_and_confounded_columns_named() {
        let jacobian: Vec<Vec<f64>> = [0.0, 1.0, 2.0].iter().map(|t| vec![1.0, *t]).collect();
        let rows = Rows { residuals: vec![0.5, -1.0, 0.5], jacobian };
        let line = Statistics::new(&rows, &[true, true], true, Loss::Squares).unwrap();
        let expected = [(0, 0, 5.0 / 6.0), (0, 1, -0.5), (1, 0, -0.5), (1, 1, 0.5)];
        for (a, b, exact) in expected {
            assert!((line.covariance[a][b].unwrap() - exact).abs() < 1e-12);
        }
        assert_eq!((line.degrees_of_freedom, line.chi_square), (1, 1.5));
        // P(χ²₁ > 1.5) = erfc(√0.75)
        assert!((line.probability.unwrap() - 0.220_671_361_916_928_7).abs() < 1e-9);
        let scaled = Statistics::new(&rows, &[true, true], false, Loss::Squares).unwrap();
        assert!((scaled.covariance[1][1].unwrap() - 0.75).abs() < 1e-12);
        assert!((scaled.reach - 12.706_204_736).abs() < 1e-6); // Student's t, one degree of freedom

        let doubled = rows.jacobian.iter().map(|row| vec![row[0], row[1], 3.0 * row[1]]).collect();
        let rows = Rows { jacobian: doubled, ..rows };
        let both = Statistics::new(&rows, &[true, true, true], true, Loss::Squares).unwrap();
        assert_eq!(both.undetermined.len(), 1);
        let places: Vec<usize> = both.undetermined[0].parts.iter().map(|(at, _)| *at).collect();
        assert_eq!(places, [1, 2]);
        assert!((both.undetermined[0].parts[0].1 / both.undetermined[0].parts[1].1 + 3.0).abs() < 1e-9);
        assert!((both.standard_error(0).unwrap() - (5.0_f64 / 6.0).sqrt()).abs() < 1e-9);
        assert_eq!((both.standard_error(1), both.degrees_of_freedom), (None, 1));
    }
}
