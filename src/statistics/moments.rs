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
/// assert_eq!((all.count, all.mean(), all.squares()), (3, Some(3.0), Some(14.0)));
/// assert_eq!((all.least(), all.greatest(), all.deviation()), (Some(1.0), Some(6.0), Some(7.0_f64.sqrt())));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(from = "MomentsRecord", into = "MomentsRecord")]
pub struct Moments {
    /// Number of rows with a value.
    pub count: u64,
    mean: f64,
    squares: f64,
    least: f64,
    greatest: f64,
}

impl Moments {
    /// Moments of some finite numbers.
    pub fn of(values: impl IntoIterator<Item = f64, IntoIter: Clone>) -> Self {
        let values = values.into_iter();
        let count = values.clone().count() as u64;
        if count == 0 {
            return Self::default();
        }
        // subtract the first value, so that nearly equal numbers lose no digits
        let first = values.clone().next().unwrap_or_default();
        let mean = first + values.clone().map(|value| value - first).sum::<f64>() / count as f64;
        let squares = values
            .clone()
            .map(|value| (value - mean) * (value - mean))
            .sum();
        let [least, greatest] = extent(values);
        Self {
            count,
            mean,
            squares,
            least,
            greatest,
        }
    }

    /// Merges the moments of later rows into these.
    pub fn merge(&mut self, after: &Self) {
        if self.count == 0 || after.count == 0 {
            if self.count == 0 {
                *self = *after;
            }
            return;
        }
        let (ours, theirs) = (self.count as f64, after.count as f64);
        let (all, change) = (ours + theirs, after.mean - self.mean);
        self.mean += change * (theirs / all);
        self.squares += after.squares + change * change * (ours * (theirs / all));
        self.count += after.count;
        self.least = self.least.min(after.least);
        self.greatest = self.greatest.max(after.greatest);
    }

    /// Mean; `None` without values, or if it overflows.
    pub fn mean(&self) -> Option<f64> {
        self.finite(self.mean)
    }

    /// Sum of squared deviations from the mean, M₂; `None` without values, or if it overflows.
    pub fn squares(&self) -> Option<f64> {
        self.finite(self.squares)
    }

    /// Standard deviation √(M₂/(n − 1)) of a sample; `None` for fewer than two rows.
    pub fn deviation(&self) -> Option<f64> {
        self.squares()
            .filter(|_| self.count > 1)
            .map(|squares| (squares / (self.count - 1) as f64).sqrt())
    }

    /// Smallest value; `None` without values.
    pub fn least(&self) -> Option<f64> {
        self.finite(self.least)
    }

    /// Largest value; `None` without values.
    pub fn greatest(&self) -> Option<f64> {
        self.finite(self.greatest)
    }

    fn finite(&self, number: f64) -> Option<f64> {
        Some(number).filter(|number| self.count > 0 && number.is_finite())
    }
}

/// Moments in files; missing numbers are null.
#[derive(Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
struct MomentsRecord {
    /// Number of rows with a value.
    count: u64,
    /// The mean, SI.
    mean: Option<f64>,
    /// The sum of squared deviations from the mean, SI.
    m2: Option<f64>,
    /// The smallest value, SI.
    min: Option<f64>,
    /// The largest value, SI.
    max: Option<f64>,
}

impl From<Moments> for MomentsRecord {
    fn from(of: Moments) -> Self {
        Self {
            count: of.count,
            mean: of.mean(),
            m2: of.squares(),
            min: of.least(),
            max: of.greatest(),
        }
    }
}

impl From<MomentsRecord> for Moments {
    fn from(record: MomentsRecord) -> Self {
        let number =
            |number: Option<f64>| number.unwrap_or(if record.count == 0 { 0.0 } else { f64::NAN });
        Self {
            count: record.count,
            mean: number(record.mean),
            squares: number(record.m2),
            least: number(record.min),
            greatest: number(record.max),
        }
    }
}
