use crate::error::{Error, Result};

/// Options of a search, with their defaults.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Maximum number of iterations (500).
    pub max_iterations: u64,
    /// Largest relative KKT residual of a converged search (1e-10): see [`status`](super::status).
    pub kkt_tolerance: f64,
    /// Initial trust-region radius, in units of [`Bounds::scale`](super::Bounds::scale) (0.5: half
    /// the box to each side).
    pub initial_radius: f64,
    /// Maximum number of other points that are tried if f is undefined at the start (64).
    pub start_trials: u32,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            max_iterations: 500,
            kkt_tolerance: 1e-10,
            initial_radius: 0.5,
            start_trials: 64,
        }
    }
}

impl Options {
    pub(super) fn validate(&self) -> Result<()> {
        let refuse = |what: &str, value: f64, range: &str| {
            Err(Error::Optimizer(format!(
                "{what} = {value} is outside its range {range}"
            )))
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
