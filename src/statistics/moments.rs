use super::extent::extent;
use serde::{Deserialize, Serialize};

/// Count, mean, variance and range of the values of a column. Moments of different rows can be
/// merged.
///
/// M₂ is the sum of squared deviations from the mean. For the rows a and b together it is
///
/// ```text
///   M₂ = M₂ₐ + M₂ᵦ + δ² nₐ nᵦ/n      δ = mean_b − mean_a
///   (Chan, Golub & LeVeque 1983, The American Statistician 37, eq. 2.1)
/// ```
///
/// This formula loses no digits if the standard deviation is small relative to the mean.
///
/// ```
/// use longdrive::statistics::Moments;
/// let mut all = Moments::of([1.0, 2.0]);
/// all.merge(&Moments::of([6.0]));
/// // mean 3, squared deviations 4 + 1 + 9
/// assert_eq!((all.count, all.mean, all.squares), (3, Some(3.0), Some(14.0)));
/// assert_eq!((all.least, all.greatest, all.deviation()), (Some(1.0), Some(6.0), Some(7.0_f64.sqrt())));
/// ```
// a number is `None` without values, or if it overflowed
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Moments {
    /// Number of rows with a value.
    pub count: u64,
    /// The mean, SI.
    pub mean: Option<f64>,
    /// The sum of squared deviations from the mean, SI.
    #[serde(rename = "m2")]
    pub squares: Option<f64>,
    /// The smallest value, SI.
    #[serde(rename = "min")]
    pub least: Option<f64>,
    /// The largest value, SI.
    #[serde(rename = "max")]
    pub greatest: Option<f64>,
}

impl Moments {
    /// Moments of some finite numbers.
    pub fn of(values: impl IntoIterator<Item = f64, IntoIter: Clone>) -> Self {
        let values = values.into_iter();
        let count = values.clone().count() as u64;
        // subtract the first value, so that nearly equal numbers lose no digits
        let Some(first) = values.clone().next() else {
            return Self::default();
        };
        let mean = first + values.clone().map(|value| value - first).sum::<f64>() / count as f64;
        let squares = values
            .clone()
            .map(|value| (value - mean) * (value - mean))
            .sum();
        let [least, greatest] = extent(values);
        Self {
            count,
            mean: finite(mean),
            squares: finite(squares),
            least: finite(least),
            greatest: finite(greatest),
        }
    }

    /// Adds the values of `after`, the moments of later rows.
    pub fn merge(&mut self, after: &Self) {
        if self.count == 0 {
            *self = *after;
            return;
        }
        if after.count == 0 {
            return;
        }
        let (ours, theirs) = (self.count as f64, after.count as f64);
        let part = theirs / (ours + theirs);
        let change = self.mean.zip(after.mean).map(|(own, other)| other - own);
        let squares = self.squares.zip(after.squares).zip(change);
        self.squares = squares.and_then(|((own, other), change)| {
            finite(own + (other + change * change * (ours * part)))
        });
        self.mean = self
            .mean
            .zip(change)
            .and_then(|(own, change)| finite(own + change * part));
        self.count += after.count;
        self.least = self.least.zip(after.least).map(|(a, b)| a.min(b));
        self.greatest = self.greatest.zip(after.greatest).map(|(a, b)| a.max(b));
    }

    /// Standard deviation √(M₂/(n − 1)) of a sample; `None` for fewer than two rows.
    pub fn deviation(&self) -> Option<f64> {
        self.squares
            .filter(|_| self.count > 1)
            .map(|squares| (squares / (self.count - 1) as f64).sqrt())
    }
}

fn finite(number: f64) -> Option<f64> {
    Some(number).filter(|number| number.is_finite())
}
