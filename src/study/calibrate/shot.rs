use crate::drive::Outcome;
use crate::parameters::Parameter;

/// One measured shot: how it was made, and what came of it.
#[derive(Clone, Debug)]
pub struct Shot {
    /// The row of the table it stands in, from 1.
    pub row: usize,
    /// Parameters of this shot, SI, of its launch where the row gives that and no club; all others
    /// are the setup's.
    pub inputs: Vec<(&'static Parameter, f64)>,
    /// What was measured.
    pub measured: Vec<Measurement>,
    /// Parameters in which carry is at its largest here.
    pub stationary: Vec<Stationary>,
}

/// A measured outcome, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measurement {
    /// What was measured.
    pub outcome: Outcome,
    /// The value.
    pub value: f64,
    /// Its standard uncertainty, or its weight where none is known.
    pub sigma: f64,
}

/// A parameter in which carry is stationary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stationary {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// The standard uncertainty of where in it the optimum lies, SI.
    pub sigma: f64,
}

impl Shot {
    /// How many residuals it has.
    pub fn residuals(&self) -> usize {
        self.measured.len() + self.stationary.len()
    }
}
