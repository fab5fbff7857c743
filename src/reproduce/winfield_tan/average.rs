use super::{RANGES, printed};
use crate::error::{Error, Result};
use crate::parameters::Setup;
use crate::reproduce::Average;
use crate::reproduce::delivery::LoftCarry;
use crate::units::YARD;
use nalgebra::{DMatrix, DVector};

/// Mean carry over attack angles of 0, 1 … 10° for several lofts, the polynomial through these
/// means, and the best loft.
#[derive(Clone, Debug)]
pub struct InterpolatedAverage {
    /// Mean carries of the lofts 7, 8 … 12°.
    pub rows: Vec<LoftCarry>,
    /// Maximum of the quintic polynomial through these means, computed as in the paper.
    pub by_polynomial: LoftCarry,
    /// Points of the polynomial between the first and last loft.
    pub polynomial: Vec<LoftCarry>,
    /// Exact optimum of the mean carry.
    pub best: LoftCarry,
    /// Printed optimum.
    pub printed: LoftCarry,
}

impl InterpolatedAverage {
    pub(super) fn new(setup: &Setup<f64>) -> Result<Self> {
        let [loft, carry] = printed::AVERAGE;
        let average = Average::new(setup, &printed::AVERAGED_LOFTS, loft, RANGES.loft)?;
        let printed = LoftCarry {
            loft: loft.to_radians(),
            carry: carry * YARD,
        };
        let through = InterpolatingPolynomial::through(&average.rows).ok_or_else(refused)?;
        let by_polynomial = through.maximum_near(average.best.loft)?;
        let [from, to] =
            [average.rows.first(), average.rows.last()].map(|row| row.map_or(0.0, |row| row.loft));
        let along = |i: usize| from + (to - from) * i as f64 / (CURVE - 1) as f64;
        let polynomial = (0..CURVE)
            .map(along)
            .map(|loft| LoftCarry {
                loft,
                carry: through.at(loft)[0],
            })
            .collect();
        Ok(Self {
            rows: average.rows,
            by_polynomial,
            polynomial,
            best: average.best,
            printed,
        })
    }
}

/// Number of points of [`InterpolatedAverage::polynomial`].
const CURVE: usize = 101;

/// Interpolating polynomial of the carry, m, in x = loft − `middle`, deg. Powers of x are better
/// scaled than powers of the loft.
struct InterpolatingPolynomial {
    /// The mean loft, rad.
    middle: f64,
    coefficients: DVector<f64>,
}

impl InterpolatingPolynomial {
    fn through(rows: &[LoftCarry]) -> Option<Self> {
        let n = rows.len();
        let middle = rows.iter().map(|row| row.loft).sum::<f64>() / n as f64;
        let powers = DMatrix::from_fn(n, n, |row, power| {
            (rows[row].loft - middle).to_degrees().powi(power as i32)
        });
        let values = DVector::from_iterator(n, rows.iter().map(|row| row.carry));
        Some(Self {
            middle,
            coefficients: powers.lu().solve(&values)?,
        })
    }

    /// Horner's scheme at a loft, rad: carry, m, and its first and second derivative by x, m/° and
    /// m/°².
    fn at(&self, loft: f64) -> [f64; 3] {
        let x = (loft - self.middle).to_degrees();
        let further = |[v, d, dd]: [f64; 3], c: &f64| [v * x + c, d * x + v, dd * x + 2.0 * d];
        self.coefficients
            .as_slice()
            .iter()
            .rev()
            .fold([0.0; 3], further)
    }

    /// Maximum near a loft, rad, by Newton's method.
    fn maximum_near(&self, near: f64) -> Result<LoftCarry> {
        let mut loft = near;
        for _ in 0..50 {
            let [_, slope, curvature] = self.at(loft);
            if curvature >= 0.0 {
                return Err(refused());
            }
            loft -= (slope / curvature).to_radians();
        }
        let [carry, slope, _] = self.at(loft);
        if slope.abs() < 1e-9 {
            Ok(LoftCarry { loft, carry })
        } else {
            Err(refused())
        }
    }
}

fn refused() -> Error {
    Error::Optimizer("the polynomial through the averages has no maximum near the best loft".into())
}
