use super::printed;
use crate::error::{Error, Result};
use crate::number::{Number, Numbers};
use crate::optimize::{
    Domain, Evaluation, Exact, Functions, Observers, Options, Status, minimize_from, starts,
};
use nalgebra::{SMatrix, SVector};
use serde::Serialize;

/// The report's regression: a polynomial in loft through five distances at one swing elevation.
///
/// The listing fits 1, λ², λ³, λ⁴, λ⁵, but evaluates the coefficients with 1, λ, λ², λ³, λ⁴.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Regression {
    /// Maximum of the polynomial with the fitted coefficients, but with the powers 1, λ, λ², λ³,
    /// λ⁴, as in the listing.
    #[serde(rename = "slipped")]
    pub with_wrong_powers: Peak,
    /// Maximum of the polynomial with the fitted coefficients and the fitted powers.
    pub as_fitted: Peak,
    /// Maximum of the polynomial with the powers 1, λ, λ², λ³, λ⁴ through the same points.
    pub ordinary: Peak,
}

/// Maximum of a polynomial within the report's range of loft.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Peak {
    /// The loft, rad.
    #[serde(rename = "club.loft")]
    pub loft: f64,
    /// Value of the polynomial, m.
    pub distance: f64,
}

impl Regression {
    /// The regression of the data in the program listing of the report.
    ///
    /// # Errors
    /// [`Error::Optimizer`] if the regression's matrix is singular, and [`Error::NotConverged`] if
    /// a search for a maximum fails.
    pub fn new() -> Result<Self> {
        let (fitted, evaluated) = ([0, 2, 3, 4, 5], [0, 1, 2, 3, 4]);
        let with_wrong_powers = RegressionPolynomial {
            coefficients: through_the_data(fitted)?,
            powers: evaluated,
        };
        let as_fitted = RegressionPolynomial {
            powers: fitted,
            ..with_wrong_powers
        };
        let ordinary = RegressionPolynomial {
            coefficients: through_the_data(evaluated)?,
            powers: evaluated,
        };
        Ok(Self {
            with_wrong_powers: with_wrong_powers.peak()?,
            as_fitted: as_fitted.peak()?,
            ordinary: ordinary.peak()?,
        })
    }
}

/// Σ βᵢ λ^pᵢ.
#[derive(Clone, Copy)]
struct RegressionPolynomial {
    coefficients: SVector<f64, 5>,
    powers: [u32; 5],
}

/// Coefficients of a polynomial with these powers through the five points.
fn through_the_data(powers: [u32; 5]) -> Result<SVector<f64, 5>> {
    let loft = |row: usize| printed::REGRESSION[row][0].to_radians();
    let basis = SMatrix::<f64, 5, 5>::from_fn(|row, column| {
        <f64 as Numbers>::powi(loft(row), powers[column])
    });
    let distances = SVector::<f64, 5>::from_fn(|row, _| printed::REGRESSION[row][1]);
    basis
        .lu()
        .solve(&distances)
        .ok_or_else(|| Error::Optimizer("the regression's matrix is singular".into()))
}

impl RegressionPolynomial {
    fn peak(self) -> Result<Peak> {
        let [low, high] = printed::RANGES.loft.map(f64::to_radians);
        let domain = Domain::new(vec![low], vec![high])?;
        // start at the report's start, 10°, and at other lofts: a quintic may have two maxima
        let starts = starts(&domain, &[10.0_f64.to_radians()], 8)?;
        let found = minimize_from(
            &Exact(self),
            &domain,
            &starts,
            &Options::default(),
            &Observers::default(),
        )?;
        match found.first().map(|local| &local.solution) {
            Some(best) if best.status == Status::Converged => Ok(Peak {
                loft: best.x[0],
                distance: -best.value.unwrap_or_default(),
            }),
            best => {
                let message = best.map(|best| best.message.clone()).unwrap_or_default();
                Err(Error::NotConverged {
                    status: "no peak",
                    message: message.into(),
                })
            }
        }
    }
}

impl Functions for RegressionPolynomial {
    fn evaluate<T: Number>(&self, x: &[T]) -> std::result::Result<Evaluation<T>, String> {
        let terms = self
            .coefficients
            .iter()
            .zip(self.powers)
            .map(|(beta, power)| x[0].powi(power) * *beta);
        let sum = terms.fold(T::zero(), |sum, term| sum + term);
        Ok(Evaluation::unconstrained(-sum))
    }
}
