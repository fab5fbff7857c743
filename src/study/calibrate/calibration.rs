//! What a calibration finds.

use super::statistics::Statistics;
use crate::drive::Outcome;
use crate::optimize::least_squares::{Fit, Status};
use crate::parameters::{Parameter, Setup};

/// A fitted parameter, SI.
#[derive(Clone, Copy, Debug)]
pub struct Estimate {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// Its value.
    pub value: f64,
    /// Standard error; `None` where the data do not determine it or a bound holds it.
    pub standard_error: Option<f64>,
    /// Whether it ended on a bound of its range.
    pub is_at_bound: bool,
    /// Whether the data determine it; where not, its value is one of many.
    pub is_determined: bool,
}

/// A residual.
#[derive(Clone, Debug)]
pub struct Remainder {
    /// The row of the table.
    pub row: usize,
    /// What was measured; carry where a parameter was stationary.
    pub outcome: Outcome,
    /// The parameter in which carry is stationary, if it is that.
    pub stationary: Option<&'static Parameter>,
    /// What was measured, SI; `None` for a parameter that is stationary.
    pub measured: Option<f64>,
    /// Computed − measured, SI. For a stationary parameter how far its optimum lies from where the
    /// row has it, to first order.
    pub difference: f64,
    /// The same in units of its standard uncertainty.
    pub residual: f64,
}

/// Parameters fitted to shots.
#[derive(Clone, Debug)]
pub struct Calibration {
    /// The setup with the fitted values.
    pub setup: Setup<f64>,
    /// How the search ended.
    pub fit: Fit,
    /// Searches made, and how many of them ended at this sum (within 1e-6 of it).
    pub starts: (usize, usize),
    /// How the others ended, with how many of them; nothing where curvatures of optima were renewed
    /// more than once, and the best search alone went on.
    pub elsewhere: Vec<(Status, usize)>,
    /// Searches that were stopped from outside before their end.
    pub stopped: usize,
    /// Whether the search that is shown had ended at a minimum, whatever became of the others.
    pub is_minimum: bool,
    /// The parameters.
    pub estimates: Vec<Estimate>,
    /// What the data say of them.
    pub statistics: Statistics,
    /// What is left over, row by row.
    pub remainders: Vec<Remainder>,
    /// Times that the curvatures of the optima were renewed.
    pub renewals: usize,
}
