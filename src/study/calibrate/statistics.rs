//! Covariance and identifiability of fitted parameters from the Jacobian.

use crate::error::{Error, Result};
use crate::optimize::least_squares::{Loss, Rows};
use nalgebra::{DMatrix, DVector};
use statrs::distribution::{ChiSquared, ContinuousCDF, Normal, StudentsT};

/// A singular value counts as 0 if it is at most this fraction of the largest one, because rounding
/// dominates it. The columns of the Jacobian are first scaled to unit length.
const SINGULAR: f64 = 1e-8;
/// A parameter is part of a direction (of unit length) if its component exceeds this size.
const PART: f64 = 1e-3;

/// Origin of the standard uncertainties of the measured values, from the best known to the least
/// known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum SigmaOrigin {
    /// The table states all standard uncertainties.
    Stated,
    /// The table lacks some standard uncertainties; the known uncertainties of instruments replace
    /// them ([`Outcome::measurement_uncertainty`](crate::Outcome::measurement_uncertainty)).
    Instruments,
    /// Some standard uncertainties are unknown: one unit of the column serves as a weight.
    Weights,
}

/// Position of a fitted parameter in its range, and width of the range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitRange {
    /// True if the value lies inside its range, false if it lies on a bound.
    pub is_free: bool,
    /// Width of the parameter's range, SI. If the standard error is larger, the data do not
    /// determine the parameter.
    pub width: f64,
}

/// Statistics of the fitted parameters, SI, in the order of the parameters.
#[derive(Clone, Debug)]
pub struct FitStatistics {
    /// Covariance. An entry is `None` if one of its parameters is undetermined or lies on a bound;
    /// all entries are `None` without a [`scale`](Self::scale).
    pub covariance: Vec<Vec<Option<f64>>>,
    /// Directions that the data do not determine.
    pub undetermined: Vec<Undetermined>,
    /// χ² = Σ rᵢ² over the residuals rᵢ. With Huber's loss, χ² = Σ wᵢ rᵢ² with the weights wᵢ of
    /// the loss.
    pub chi_square: f64,
    /// Number of residuals minus the rank of the free parameters' Jacobian.
    pub degrees_of_freedom: usize,
    /// Probability of a χ² at least this large if the standard uncertainties are right. `None` if
    /// the table does not state all of them, if there are no degrees of freedom, and with Huber's
    /// loss: its weighted χ² does not have the χ² distribution.
    pub probability: Option<f64>,
    /// True if all residuals are rounding errors.
    pub is_exact: bool,
    /// Factor applied to standard errors. χ² has ν degrees of freedom.
    ///
    /// - 1 for squares if the table states every uncertainty;
    /// - else, if ν > 0 and some residuals exceed rounding: √(χ²/ν) for squares, and
    ///   √(Σ ψ²/ν)/mean ψ′ for Huber's loss ρ with ψ = ρ′ (Huber 1981, section 7.6). `None` if
    ///   ψ′ = 0 for every residual;
    /// - else 1 if the uncertainties of all instruments are known, and `None` if one is unknown
    ///   ([`SigmaOrigin::Weights`]).
    pub scale: Option<f64>,
    /// True if the scale is computed from the residuals.
    pub is_scaled: bool,
    /// The loss of the fit.
    pub loss: Loss,
    /// Half-width of a 95 % interval, in multiples of the standard error.
    pub coverage_factor: f64,
}

/// A combination of parameters that the data do not determine. A change along this direction does
/// not change the residuals, or one standard error along it exceeds the range of a parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Undetermined {
    /// Index and change (SI) of each parameter in the combination.
    pub parts: Vec<(usize, f64)>,
    /// Standard error along the direction, in multiples of `parts`; `None` if the residuals do not
    /// change at all.
    pub standard_error: Option<f64>,
}

impl Undetermined {
    /// True if a change along the direction changes the parameter with index `at`.
    fn contains(&self, at: usize) -> bool {
        self.parts.iter().any(|(part, _)| *part == at)
    }
}

/// Singular value decomposition of some columns of the Jacobian, each scaled to unit length.
struct ScaledColumns {
    at: Vec<usize>,
    lengths: Vec<f64>,
    values: DVector<f64>,
    directions: DMatrix<f64>,
}

impl ScaledColumns {
    fn new(jacobian: &DMatrix<f64>, at: Vec<usize>) -> Result<Self> {
        let (m, n) = (jacobian.nrows(), at.len());
        let length = |i: &usize| {
            Some(jacobian.column(*i).norm())
                .filter(|length| *length > 0.0)
                .unwrap_or(1.0)
        };
        let lengths: Vec<f64> = at.iter().map(length).collect();
        if n == 0 {
            return Ok(Self {
                at,
                lengths,
                values: DVector::zeros(0),
                directions: DMatrix::zeros(0, 0),
            });
        }
        let scaled = DMatrix::from_fn(m.max(n), n, |i, k| {
            if i < m {
                jacobian[(i, at[k])] / lengths[k]
            } else {
                0.0
            }
        });
        let broken = || Error::Calibration {
            reason: "the Jacobian's singular values cannot be computed".into(),
        };
        let svd = scaled
            .try_svd(false, true, f64::EPSILON, 10_000)
            .ok_or_else(broken)?;
        Ok(Self {
            at,
            lengths,
            values: svd.singular_values,
            directions: svd.v_t.ok_or_else(broken)?,
        })
    }

    fn is_singular(&self, k: usize) -> bool {
        self.values[k] <= SINGULAR * self.values.iter().copied().fold(0.0, f64::max)
    }

    /// Returns direction `k` if the data do not determine it, for one of three reasons:
    ///
    /// - its singular value is 0;
    /// - one standard error along it changes a parameter by more than the width of its range;
    /// - the standard error of a parameter exceeds the width of its range, and this direction
    ///   contributes most to the error.
    fn undetermined(
        &self,
        k: usize,
        scale: Option<f64>,
        fitted: &[FitRange],
    ) -> Option<Undetermined> {
        let is_part = |i: &usize| self.directions[(k, *i)].abs() > PART;
        // the change of each parameter, SI
        let change = |i: usize| (self.at[i], self.directions[(k, i)] / self.lengths[i]);
        let parts = (0..self.at.len()).filter(is_part).map(change).collect();
        if self.is_singular(k) {
            return Some(Undetermined {
                parts,
                standard_error: None,
            });
        }
        let scale = scale?;
        let error = scale / self.values[k];
        let is_beyond = |i: usize| {
            let width = fitted[self.at[i]].width;
            let along = |k: usize| (self.directions[(k, i)] / self.values[k]).abs();
            let is_largest =
                (0..self.at.len()).all(|other| self.is_singular(other) || along(other) <= along(k));
            let along = scale * along(k) / self.lengths[i];
            along > width || is_largest && scale * self.covariance(i, i).sqrt() > width
        };
        (0..self.at.len())
            .any(|i| is_part(&i) && is_beyond(i))
            .then_some(Undetermined {
                parts,
                standard_error: Some(error),
            })
    }

    /// The covariance of two parameters (indices into `at`) for residuals of unit variance.
    fn covariance(&self, a: usize, b: usize) -> f64 {
        let part =
            |k: usize| self.directions[(k, a)] * self.directions[(k, b)] / self.values[k].powi(2);
        let sum: f64 = (0..self.at.len())
            .filter(|&k| !self.is_singular(k))
            .map(part)
            .sum();
        sum / (self.lengths[a] * self.lengths[b])
    }
}

impl FitStatistics {
    /// Statistics from the residuals and their Jacobian at the end of a fit. Residuals up to
    /// `rounding` count as rounding.
    ///
    /// # Errors
    /// [`Error::Calibration`] for a residual or derivative that is not finite, and if the singular
    /// value decomposition fails.
    ///
    /// # Panics
    /// If the Jacobian does not have one row for each residual and one column for each parameter.
    pub fn new(
        rows: &Rows,
        fitted: &[FitRange],
        origin: SigmaOrigin,
        rounding: f64,
        loss: Loss,
    ) -> Result<Self> {
        check(rows, fitted.len())?;
        let (m, n) = (rows.residuals.len(), fitted.len());
        let weights: Vec<f64> = rows.residuals.iter().map(|r| loss.weight(*r)).collect();
        let jacobian = DMatrix::from_fn(m, n, |i, k| rows.jacobian[i][k]);
        let chi_square: f64 = rows
            .residuals
            .iter()
            .zip(&weights)
            .map(|(r, w)| w * r * r)
            .sum::<f64>()
            + 0.0;
        let is_exact = rows.residuals.iter().all(|r| r.abs() <= rounding);
        let free = ScaledColumns::new(&jacobian, (0..n).filter(|&i| fitted[i].is_free).collect())?;
        let rank = (0..free.at.len()).filter(|&k| !free.is_singular(k)).count();
        let degrees_of_freedom = m.saturating_sub(rank);
        // stated uncertainties give the scale of squares only: outliers are larger than these
        let is_known = origin == SigmaOrigin::Stated && loss == Loss::Squares;
        let is_scaled = !is_known && degrees_of_freedom > 0 && !is_exact;
        let scale = match origin {
            _ if is_scaled => estimated_scale(&rows.residuals, loss, degrees_of_freedom),
            SigmaOrigin::Weights => None,
            _ => Some(1.0),
        };
        let is_loose = |i: usize| fitted[i].is_free || !is_pressed(rows, &weights, fitted[i], i);
        let loose = ScaledColumns::new(&jacobian, (0..n).filter(|&i| is_loose(i)).collect())?;
        let undetermined: Vec<_> = (0..loose.at.len())
            .filter_map(|k| loose.undetermined(k, scale, fitted))
            .collect();
        let covariance = covariance(&free, n, &undetermined, scale);
        let chi_squared = ChiSquared::new(degrees_of_freedom as f64).ok();
        let chi_squared = chi_squared.filter(|_| is_known);
        Ok(Self {
            covariance,
            undetermined,
            chi_square,
            degrees_of_freedom,
            probability: chi_squared.map(|distribution| distribution.sf(chi_square)),
            is_exact,
            scale,
            is_scaled,
            loss,
            coverage_factor: coverage_factor(degrees_of_freedom, is_scaled),
        })
    }

    /// True if no undetermined direction changes the parameter with index `at`.
    pub fn determines(&self, at: usize) -> bool {
        !self
            .undetermined
            .iter()
            .any(|direction| direction.contains(at))
    }

    /// Standard error of a parameter; `None` if its covariance is `None`.
    ///
    /// # Panics
    /// If the index is out of range.
    pub fn standard_error(&self, at: usize) -> Option<f64> {
        self.covariance[at][at].map(f64::sqrt)
    }

    /// Correlation of two parameters; `None` if their covariance is `None`.
    ///
    /// # Panics
    /// If an index is out of range.
    pub fn correlation(&self, a: usize, b: usize) -> Option<f64> {
        Some(self.covariance[a][b]? / (self.standard_error(a)? * self.standard_error(b)?))
    }
}

/// The factor s of the covariance s² (JᵀJ)⁻¹: √(Σ ψ²/ν)/mean ψ′, where ψ is the derivative of the
/// loss and ν is the number of degrees of freedom (Huber 1981, Robust Statistics, section 7.6). For
/// squares it is √(χ²/ν). `None` if ψ′ = 0 for every residual.
fn estimated_scale(residuals: &[f64], loss: Loss, degrees_of_freedom: usize) -> Option<f64> {
    let squares: f64 = residuals
        .iter()
        .map(|r| (loss.weight(*r) * r).powi(2))
        .sum();
    let slopes: f64 = residuals.iter().map(|r| loss.second_derivative(*r)).sum();
    let mean_slope = slopes / residuals.len() as f64;
    (mean_slope > 0.0).then(|| (squares / degrees_of_freedom as f64).sqrt() / mean_slope)
}

/// True if the data push parameter `at` against its bound: |gradient of χ²/2| times the width of
/// the range exceeds 1. A parameter without influence on the residuals may be at its bound by
/// chance.
fn is_pressed(rows: &Rows, weights: &[f64], fitted: FitRange, at: usize) -> bool {
    let residuals = rows.residuals.iter().zip(&rows.jacobian);
    let gradient: f64 = residuals
        .zip(weights)
        .map(|((residual, slopes), weight)| weight * residual * slopes[at])
        .sum();
    gradient.abs() * fitted.width > 1.0
}

/// Checks the size of the Jacobian, and that all numbers are finite.
fn check(rows: &Rows, n: usize) -> Result<()> {
    let m = rows.residuals.len();
    let columns: Vec<usize> = rows.jacobian.iter().map(Vec::len).collect();
    assert!(
        columns.len() == m && columns.iter().all(|length| *length == n),
        "{m} residuals of {n} parameters need a Jacobian of {m} rows of {n}; its rows have \
         {columns:?}"
    );
    if let Some(number) = rows
        .residuals
        .iter()
        .chain(rows.jacobian.iter().flatten())
        .find(|d| !d.is_finite())
    {
        let reason =
            format!("a residual or one of its derivatives is {number}; all must be finite");
        return Err(Error::Calibration { reason });
    }
    Ok(())
}

/// Covariance of all `n` parameters. The entries of an undetermined parameter, and of a parameter
/// that is not in `free`, are `None`. Without a `scale`, all entries are `None`.
fn covariance(
    free: &ScaledColumns,
    n: usize,
    undetermined: &[Undetermined],
    scale: Option<f64>,
) -> Vec<Vec<Option<f64>>> {
    let is_determined = |at: usize| !undetermined.iter().any(|direction| direction.contains(at));
    let mut covariance = vec![vec![None; n]; n];
    for a in (0..free.at.len()).filter(|&a| is_determined(free.at[a])) {
        for b in (0..free.at.len()).filter(|&b| is_determined(free.at[b])) {
            covariance[free.at[a]][free.at[b]] =
                scale.map(|scale| scale * scale * free.covariance(a, b));
        }
    }
    covariance
}

/// The 97.5 % quantile of the normal distribution, or of Student's t if `is_scaled`.
fn coverage_factor(degrees_of_freedom: usize, is_scaled: bool) -> f64 {
    let normal = Normal::standard().inverse_cdf(0.975);
    if !is_scaled {
        return normal;
    }
    StudentsT::new(0.0, 1.0, degrees_of_freedom as f64)
        .map_or(normal, |student| student.inverse_cdf(0.975))
}
