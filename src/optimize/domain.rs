use crate::error::{Error, Result};

/// Limits low ≤ v ≤ high of several numbers. An end may be infinite; with low = high a number is
/// fixed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bounds {
    /// Lower ends.
    pub low: Vec<f64>,
    /// Upper ends.
    pub high: Vec<f64>,
}

impl Bounds {
    /// Limits.
    ///
    /// # Errors
    /// [`Error::Optimizer`] for ends that are NaN, reversed, infinite on the wrong side, or of
    /// different number.
    pub fn new(low: Vec<f64>, high: Vec<f64>) -> Result<Self> {
        let bounds = Self { low, high };
        bounds.check()?;
        Ok(bounds)
    }

    /// What [`new`](Self::new) refuses: the ends may have been changed since.
    fn check(&self) -> Result<()> {
        let Self { low, high } = self;
        if low.len() != high.len() {
            return Err(Error::Optimizer(format!(
                "the numbers of lower limits ({}) and of upper limits ({}) differ; give one of \
                 each for every number",
                low.len(),
                high.len()
            )));
        }
        for (i, (low, high)) in low.iter().zip(high).enumerate() {
            let is_range = low <= high && *low < f64::INFINITY && *high > f64::NEG_INFINITY;
            if !is_range {
                return Err(Error::Optimizer(format!(
                    "the limits of number {i} are {low} .. {high}; the lower must not exceed the \
                     upper"
                )));
            }
        }
        Ok(())
    }

    /// How many numbers they limit.
    pub fn dimension(&self) -> usize {
        self.low.len()
    }

    /// The nearest point within.
    ///
    /// # Panics
    /// Where ends were made NaN or reversed.
    pub fn project(&self, x: &[f64]) -> Vec<f64> {
        x.iter()
            .zip(self.low.iter().zip(&self.high))
            .map(|(x, (low, high))| x.clamp(*low, *high))
            .collect()
    }

    /// What a sensible change of each number is: the width of its range, but no more than ten times
    /// its own size at `x` or 1, whichever is larger; where the range is infinite, that size
    /// itself.
    ///
    /// # Panics
    /// Where `x` has fewer numbers.
    pub fn scale(&self, x: &[f64]) -> Vec<f64> {
        let scale = |i: usize| match self.high[i] - self.low[i] {
            0.0 => 1.0,
            width if width.is_finite() => width.min(10.0 * x[i].abs().max(1.0)),
            _ => x[i].abs().max(1.0),
        };
        (0..self.dimension()).map(scale).collect()
    }

    /// Whether the two ends of a number are one.
    ///
    /// # Panics
    /// Where there is no such number.
    pub fn is_fixed(&self, i: usize) -> bool {
        self.low[i] == self.high[i]
    }

    /// How far a number is beyond its limits: above the upper > 0, below the lower < 0, within 0.
    ///
    /// # Panics
    /// Where there is no such number, or its ends were made NaN or reversed.
    pub fn excess(&self, i: usize, value: f64) -> f64 {
        value - value.clamp(self.low[i], self.high[i])
    }
}

/// Where a solution is looked for: bounds of the variables and limits of the constraint functions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Domain {
    /// low ≤ x ≤ high.
    pub variables: Bounds,
    /// low ≤ c(x) ≤ high; an equality where both are one number.
    pub constraints: Bounds,
}

impl Domain {
    /// A box, without constraints.
    ///
    /// # Errors
    /// [`Error::Optimizer`] as [`Bounds::new`], and for a box of no variables.
    pub fn new(low: Vec<f64>, high: Vec<f64>) -> Result<Self> {
        if low.is_empty() {
            return Err(Error::Optimizer(
                "there are no variables; give bounds of at least one".into(),
            ));
        }
        Ok(Self {
            variables: Bounds::new(low, high)?,
            constraints: Bounds::default(),
        })
    }

    /// The same box with limits for the problem's constraint functions c₁ … cₘ.
    ///
    /// # Errors
    /// [`Error::Optimizer`] as [`Bounds::new`].
    pub fn subject_to(self, low: Vec<f64>, high: Vec<f64>) -> Result<Self> {
        Ok(Self {
            constraints: Bounds::new(low, high)?,
            ..self
        })
    }

    /// Refuses what [`new`](Self::new) and [`subject_to`](Self::subject_to) refuse, and a start of
    /// another length or that is not finite.
    pub(super) fn check(&self, start: &[f64]) -> Result<()> {
        self.variables.check()?;
        self.constraints.check()?;
        let n = self.variables.dimension();
        if start.len() != n || !start.iter().all(|x| x.is_finite()) {
            return Err(Error::Optimizer(format!(
                "the start {start:?} must be {n} finite numbers, one per variable"
            )));
        }
        Ok(())
    }
}
