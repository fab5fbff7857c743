use crate::error::{Error, Result};

/// A function to minimise: one method, giving value, gradient and Hessian together.
pub trait Problem {
    /// f and its derivatives at `x`; where f is not defined, the reason.
    ///
    /// # Errors
    /// A sentence saying why f has no value at `x`. The search then steps back.
    fn evaluate(&self, x: &[f64]) -> std::result::Result<Evaluation, String>;
}

impl<F: Fn(&[f64]) -> std::result::Result<Evaluation, String>> Problem for F {
    fn evaluate(&self, x: &[f64]) -> std::result::Result<Evaluation, String> {
        self(x)
    }
}

/// A function's value with its exact first and second derivatives.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluation {
    /// f.
    pub value: f64,
    /// ∂f/∂xᵢ.
    pub gradient: Vec<f64>,
    /// ∂²f/∂xᵢ∂xⱼ, row by row, symmetric.
    pub hessian: Vec<Vec<f64>>,
}

impl Evaluation {
    /// The evaluation, if it is of `n` variables and finite.
    pub(super) fn checked(self, n: usize) -> std::result::Result<Self, String> {
        let rows = self.hessian.len();
        if self.gradient.len() != n || rows != n || self.hessian.iter().any(|row| row.len() != n) {
            return Err(format!(
                "of {n} variables it has a gradient of {} and a Hessian of {rows} rows; both must have {n}",
                self.gradient.len()
            ));
        }
        let mut numbers = self.gradient.iter().chain(self.hessian.iter().flatten());
        if self.value.is_finite() && numbers.all(|number| number.is_finite()) {
            Ok(self)
        } else {
            Err("its value or a derivative is not finite".into())
        }
    }
}

/// The box low ≤ x ≤ high. An end may be infinite; a variable with low = high is fixed.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    /// Lower ends.
    pub low: Vec<f64>,
    /// Upper ends.
    pub high: Vec<f64>,
}

impl Bounds {
    /// A box.
    ///
    /// # Errors
    /// [`Error::Optimizer`] for ends that are NaN, reversed, infinite on the wrong side, or of different number.
    pub fn new(low: Vec<f64>, high: Vec<f64>) -> Result<Self> {
        if low.len() != high.len() || low.is_empty() {
            return Err(Error::Optimizer(format!(
                "{} lower and {} upper bounds; give one of each per variable, at least one",
                low.len(),
                high.len()
            )));
        }
        for (i, (low, high)) in low.iter().zip(&high).enumerate() {
            let is_range = low <= high && *low < f64::INFINITY && *high > f64::NEG_INFINITY;
            if !is_range {
                return Err(Error::Optimizer(format!(
                    "the bounds of variable {i} are {low} .. {high}; the lower must not exceed the upper"
                )));
            }
        }
        Ok(Self { low, high })
    }

    /// Number of variables.
    pub fn dimension(&self) -> usize {
        self.low.len()
    }

    /// The nearest point of the box.
    pub fn project(&self, x: &[f64]) -> Vec<f64> {
        x.iter().zip(self.low.iter().zip(&self.high)).map(|(x, (low, high))| x.clamp(*low, *high)).collect()
    }

    /// What a sensible change of each variable is: the width of the box, or, where that is infinite, the
    /// variable's own size at `x` and at least 1.
    pub fn scale(&self, x: &[f64]) -> Vec<f64> {
        let width = |i: usize| self.high[i] - self.low[i];
        let scale = |i: usize| match width(i) {
            0.0 => 1.0,
            width if width.is_finite() => width,
            _ => x[i].abs().max(1.0),
        };
        (0..self.dimension()).map(scale).collect()
    }
}

/// Settings of the search, each with its default.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Most iterations (100).
    pub max_iterations: u64,
    /// Largest projected gradient at which the search has converged, relative (1e-10): see
    /// [`status`](super::status).
    pub kkt_tolerance: f64,
    /// First size of the trust region, in units of [`Bounds::scale`] (0.5): half the box to each side.
    pub initial_radius: f64,
    /// Points tried for a start where f is not defined at the one given (64).
    pub start_trials: u32,
}

impl Default for Options {
    fn default() -> Self {
        Self { max_iterations: 100, kkt_tolerance: 1e-10, initial_radius: 0.5, start_trials: 64 }
    }
}

impl Options {
    pub(super) fn validate(&self) -> Result<()> {
        let refuse = |what: &str, value: f64, range: &str| {
            Err(Error::Optimizer(format!("{what} = {value} is outside its range {range}")))
        };
        if !(self.kkt_tolerance > 0.0 && self.kkt_tolerance < 1.0) {
            return refuse("kkt_tolerance", self.kkt_tolerance, "0 < … < 1");
        }
        if !(self.initial_radius > 0.0 && self.initial_radius <= 1e6) {
            return refuse("initial_radius", self.initial_radius, "0 < … ≤ 1e6");
        }
        Ok(())
    }
}
