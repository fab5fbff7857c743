use super::printed;
use crate::error::{Error, Result};
use crate::parameters::Setup;
use crate::reproduce::Average;
use crate::units::Quantity;
use nalgebra::{DMatrix, DVector};

/// Carry averaged over attack angles of 0, 1 … 10°: its best loft.
#[derive(Clone, Debug)]
pub struct Mean {
    /// The lofts 7, 8 … 12°, rad, with the average carry, m.
    pub rows: Vec<(f64, f64)>,
    /// The top of the polynomial of fifth order through them, as the paper takes it: loft, rad, and average carry, m.
    pub by_polynomial: (f64, f64),
    /// The exact optimum of the average.
    pub best: (f64, f64),
    /// What the paper prints.
    pub printed: (f64, f64),
}

impl Mean {
    pub(super) fn new(setup: &Setup<f64>) -> Result<Self> {
        let [loft, carry] = printed::AVERAGE;
        let average = Average::at(setup, &printed::AVERAGED_LOFTS, loft)?;
        let printed = (loft.to_radians(), carry * Quantity::LENGTH.size_of("yd").unwrap_or(f64::NAN));
        let by_polynomial = top(&average.rows, average.best.0)?;
        Ok(Self { rows: average.rows, by_polynomial, best: average.best, printed })
    }
}

/// The top, near `near`, of the polynomial through points.
fn top(rows: &[(f64, f64)], near: f64) -> Result<(f64, f64)> {
    let n = rows.len();
    let refused = || Error::Optimizer("the polynomial through the averages has no top near the best loft".into());
    // in loft from the middle, in degrees, so that the powers stay of one size
    let middle = rows.iter().map(|(loft, _)| loft).sum::<f64>() / n as f64;
    let scaled = |loft: f64| (loft - middle).to_degrees();
    let powers = DMatrix::from_fn(n, n, |row, power| scaled(rows[row].0).powi(power as i32));
    let values = DVector::from_iterator(n, rows.iter().map(|(_, carry)| *carry));
    let c = powers.lu().solve(&values).ok_or_else(refused)?;
    // value, slope and curvature by Horner's scheme
    let at = |x: f64| c.iter().rev().fold((0.0, 0.0, 0.0), |(v, d, dd), c| (v * x + c, d * x + v, dd * x + 2.0 * d));
    let mut x = scaled(near);
    for _ in 0..50 {
        let (_, slope, curvature) = at(x);
        if curvature >= 0.0 {
            return Err(refused());
        }
        x -= slope / curvature;
    }
    let (value, slope, _) = at(x);
    if slope.abs() < 1e-9 { Ok((middle + x.to_radians(), value)) } else { Err(refused()) }
}
