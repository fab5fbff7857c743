use serde::{Deserialize, Serialize};

/// Number, mean, spread and range of a column, which merge with those of other rows of it.
///
/// The sum of squared deviations is taken about the mean, and merged by
///
/// ```text
///   M₂ = M₂ₐ + M₂ᵦ + δ² nₐ nᵦ/n      δ = mean_b − mean_a      (Chan, Golub & LeVeque 1983, The American Statistician 37, eq. 2.1)
/// ```
///
/// so that no digits are lost where the spread is small beside the mean.
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
#[serde(from = "Written", into = "Written")]
pub struct Moments {
    /// How many rows have a value.
    pub count: u64,
    mean: f64,
    squares: f64,
    least: f64,
    greatest: f64,
}

impl Moments {
    /// The moments of some finite numbers.
    pub fn of(values: impl IntoIterator<Item = f64, IntoIter: Clone>) -> Self {
        let values = values.into_iter();
        let count = values.clone().count() as u64;
        if count == 0 {
            return Self::default();
        }
        // about one of them: sums of numbers that are nearly equal lose nothing
        let first = values.clone().next().unwrap_or_default();
        let mean = first + values.clone().map(|value| value - first).sum::<f64>() / count as f64;
        let squares = values
            .clone()
            .map(|value| (value - mean) * (value - mean))
            .sum();
        let least = values.clone().fold(f64::INFINITY, f64::min);
        Self {
            count,
            mean,
            squares,
            least,
            greatest: values.fold(f64::NEG_INFINITY, f64::max),
        }
    }

    /// Adds those of rows that come after.
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

    /// The mean; `None` of no values, and where it overflows.
    pub fn mean(&self) -> Option<f64> {
        self.shown(self.mean)
    }

    /// M₂, the sum of squared deviations from the mean; likewise.
    pub fn squares(&self) -> Option<f64> {
        self.shown(self.squares)
    }

    /// The standard deviation √(M₂/(n − 1)) of the rows as a sample; `None` of fewer than two.
    pub fn deviation(&self) -> Option<f64> {
        self.squares()
            .filter(|_| self.count > 1)
            .map(|squares| (squares / (self.count - 1) as f64).sqrt())
    }

    /// The least value.
    pub fn least(&self) -> Option<f64> {
        self.shown(self.least)
    }

    /// The greatest value.
    pub fn greatest(&self) -> Option<f64> {
        self.shown(self.greatest)
    }

    fn shown(&self, number: f64) -> Option<f64> {
        Some(number).filter(|number| self.count > 0 && number.is_finite())
    }
}

/// The moments in files: what does not exist is null.
#[derive(Serialize, Deserialize)]
struct Written {
    count: u64,
    mean: Option<f64>,
    m2: Option<f64>,
    min: Option<f64>,
    max: Option<f64>,
}

impl From<Moments> for Written {
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

impl From<Written> for Moments {
    fn from(written: Written) -> Self {
        let number =
            |number: Option<f64>| number.unwrap_or(if written.count == 0 { 0.0 } else { f64::NAN });
        Self {
            count: written.count,
            mean: number(written.mean),
            squares: number(written.m2),
            least: number(written.min),
            greatest: number(written.max),
        }
    }
}
