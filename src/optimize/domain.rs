use crate::error::{Error, Result};

/// Limits low ≤ v ≤ high of several numbers. Limits may be infinite; low = high fixes a number.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bounds {
    /// Lower limits.
    pub low: Vec<f64>,
    /// Upper limits.
    pub high: Vec<f64>,
}

impl Bounds {
    /// Creates the limits and checks them.
    ///
    /// # Errors
    /// [`Error::Optimizer`] if a limit is NaN, if a lower limit is ∞ or an upper limit is −∞, if
    /// limits are reversed, or if the vectors differ in length.
    pub fn new(low: Vec<f64>, high: Vec<f64>) -> Result<Self> {
        let bounds = Self { low, high };
        bounds.check()?;
        Ok(bounds)
    }

    /// Checks the limits. A search repeats the checks of [`new`](Self::new), because the fields are
    /// public.
    fn check(&self) -> Result<()> {
        let Self { low, high } = self;
        if low.len() != high.len() {
            return Err(Error::Optimizer(format!(
                "there are {} lower limits, but {} upper limits; give one lower and one upper \
                 limit for each number",
                low.len(),
                high.len()
            )));
        }
        for (i, (low, high)) in low.iter().zip(high).enumerate() {
            let is_range = low <= high && *low < f64::INFINITY && *high > f64::NEG_INFINITY;
            if !is_range {
                return Err(Error::Optimizer(format!(
                    "the limits [{i}] are {low} .. {high}; the lower limit must be below \
                     inf, the upper limit above -inf, and the lower must not exceed the upper"
                )));
            }
        }
        Ok(())
    }

    /// Number of limited values.
    pub fn dimension(&self) -> usize {
        self.low.len()
    }

    /// Projection of a point on the limits.
    ///
    /// # Panics
    /// If a limit is NaN or limits are reversed, because a field was changed.
    pub fn project(&self, x: &[f64]) -> Vec<f64> {
        x.iter()
            .zip(self.low.iter().zip(&self.high))
            .map(|(x, (low, high))| x.clamp(*low, *high))
            .collect()
    }

    /// Scale of each number: the width of its range, but at most ten times max(|x|, 1). For an
    /// infinite range the scale is max(|x|, 1), for a fixed number 1.
    ///
    /// # Panics
    /// If `x` has fewer numbers than the limits.
    pub fn scale(&self, x: &[f64]) -> Vec<f64> {
        let scale = |i: usize| match self.high[i] - self.low[i] {
            0.0 => 1.0,
            width if width.is_finite() => width.min(10.0 * x[i].abs().max(1.0)),
            _ => x[i].abs().max(1.0),
        };
        (0..self.dimension()).map(scale).collect()
    }

    /// True if both limits of number `i` are equal.
    ///
    /// # Panics
    /// If `i` is out of range.
    pub fn is_fixed(&self, i: usize) -> bool {
        self.low[i] == self.high[i]
    }

    /// Signed violation of the limits of number `i` by `value`: > 0 above the upper limit, < 0
    /// below the lower, 0 within.
    ///
    /// # Panics
    /// If `i` is out of range, or the limits are NaN or reversed.
    pub fn excess(&self, i: usize, value: f64) -> f64 {
        value - value.clamp(self.low[i], self.high[i])
    }
}

/// Distance of two points in the maximum norm, in units of the scale of each variable.
pub(super) fn scaled_distance(a: &[f64], b: &[f64], scale: &[f64]) -> f64 {
    let pairs = a.iter().zip(b).zip(scale);
    pairs
        .map(|((a, b), scale)| ((a - b) / scale).abs())
        .fold(0.0, f64::max)
}

/// Feasible set: bounds of the variables and limits of the constraint functions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Domain {
    /// Bounds low ≤ x ≤ high.
    pub variables: Bounds,
    /// Limits low ≤ c(x) ≤ high; low = high is an equality constraint.
    pub constraints: Bounds,
}

impl Domain {
    /// A box, without constraints.
    ///
    /// # Errors
    /// Errors of [`Bounds::new`], and [`Error::Optimizer`] if there are no variables.
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

    /// Sets the limits of the problem's constraint functions c₁ … cₘ. Earlier limits are replaced.
    ///
    /// # Errors
    /// Errors of [`Bounds::new`].
    pub fn with_constraints(self, low: Vec<f64>, high: Vec<f64>) -> Result<Self> {
        Ok(Self {
            constraints: Bounds::new(low, high)?,
            ..self
        })
    }

    /// Checks all limits again, because the fields are public. Also checks that the start has a
    /// finite number for each variable.
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
