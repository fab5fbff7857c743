use crate::drive::Outcome;
use crate::error::{Error, Result};
use serde::{Deserialize, Serialize};

/// Default number of bins.
const DEFAULT_BINS: usize = 64;
/// Maximum number of bins. A sweep is computed in parts, and each part stores all bins.
const MOST_BINS: usize = 100_000;

/// Histogram of an outcome.
///
/// ```
/// use longdrive::statistics::Histogram;
/// let mut histogram = Histogram::read("carry=200m..300m:4").unwrap();
/// assert_eq!((0..=4).map(|i| histogram.edge(i)).collect::<Vec<_>>(), [200.0, 225.0, 250.0, 275.0, 300.0]);
/// [199.9, 200.0, 224.9, 225.0, 300.0, 300.1].into_iter().for_each(|carry| histogram.add(carry));
/// assert_eq!((histogram.below, &histogram.counts[..], histogram.above), (1, &[2, 1, 0, 1][..], 1));
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Histogram {
    /// The outcome.
    pub of: String,
    /// Lower and upper edge, SI; all bins have equal width.
    pub range: [f64; 2],
    /// Number of values below the first bin.
    pub below: u64,
    /// Number of values in each bin; the upper edge belongs to the last bin.
    pub counts: Vec<u64>,
    /// Number of values above the last bin.
    pub above: u64,
}

impl Histogram {
    /// Reads `OUTCOME=LOW..HIGH:COUNT`, for example `carry=200m..300m:64`, as an empty histogram.
    /// The default COUNT is 64 bins. A lower edge without unit takes the unit of the upper edge.
    ///
    /// ```
    /// use longdrive::statistics::Histogram;
    /// let histogram = Histogram::read("carry=200..300m:4").unwrap();
    /// assert_eq!((histogram.range, histogram.counts.len()), ([200.0, 300.0], 4));
    /// assert!(Histogram::read("carry=300m..200m").is_err());
    /// ```
    ///
    /// # Errors
    /// [`Error::SearchRange`] for an invalid range or count; [`Error::Unknown`] for an unknown
    /// outcome; [`Error::Unreadable`] for edges that are not values of the outcome.
    pub fn read(text: &str) -> Result<Self> {
        let refuse = |reason: String| Error::SearchRange {
            name: format!("of the histogram {}", text.trim()),
            reason,
        };
        let example = "write for example carry=200m..300m:64";
        let (name, rest) = text.split_once('=').ok_or_else(|| refuse(example.into()))?;
        let of = Outcome::named(name.trim())?;
        let (range, count) = match rest.rsplit_once(':') {
            None => (rest, DEFAULT_BINS),
            Some((range, count)) => match count.trim().parse() {
                Ok(count) if (1..=MOST_BINS).contains(&count) => (range, count),
                _ => {
                    return Err(refuse(format!(
                        "'{count}' is not a number of bins from 1 to {MOST_BINS}; {example}"
                    )));
                }
            },
        };
        let (low, high) = range
            .split_once("..")
            .ok_or_else(|| refuse(format!("'{range}' is not LOW..HIGH; {example}")))?;
        let unreadable = |error| Error::unreadable(format!("the histogram {}", text.trim()), error);
        let quantity = of.quantity();
        let low = quantity.with_unit_of(low, high).map_err(unreadable)?;
        let high = quantity.read(high).map_err(unreadable)?;
        let low = quantity.read(&low).map_err(unreadable)?;
        if !(low.is_finite() && high.is_finite() && low < high) {
            return Err(refuse(format!(
                "both edges must be finite, and the lower edge below the upper edge; {example}"
            )));
        }
        Ok(Self {
            of: of.name().into(),
            range: [low, high],
            below: 0,
            counts: vec![0; count],
            above: 0,
        })
    }

    /// Lower edge of bin `i`, SI: low + (high − low) i/count. For `i` = count, the upper edge of
    /// the last bin.
    pub fn edge(&self, i: usize) -> f64 {
        let ([low, high], count) = (self.range, self.counts.len());
        if i >= count {
            high
        } else {
            low + (high - low) * i as f64 / count as f64
        }
    }

    /// Counts a finite value.
    pub fn add(&mut self, value: f64) {
        match value {
            value if value < self.range[0] => self.below += 1,
            value if value > self.range[1] => self.above += 1,
            value => {
                let bin = self.bin(value);
                self.counts[bin] += 1;
            }
        }
    }

    /// Bin i of a value within the range: edge(i) ≤ value < edge(i + 1). The upper edge of the
    /// range belongs to the last bin.
    fn bin(&self, value: f64) -> usize {
        let ([low, high], last) = (self.range, self.counts.len() - 1);
        let mut at = (((value - low) / (high - low) * self.counts.len() as f64) as usize).min(last);
        // compare with the edges, because the quotient is rounded
        while at > 0 && value < self.edge(at) {
            at -= 1;
        }
        while at < last && value >= self.edge(at + 1) {
            at += 1;
        }
        at
    }

    /// Adds another histogram with the same bins.
    pub fn merge(&mut self, other: &Self) {
        self.below += other.below;
        self.above += other.above;
        self.counts
            .iter_mut()
            .zip(&other.counts)
            .for_each(|(ours, theirs)| *ours += theirs);
    }
}
