use crate::drive::Outcome;
use crate::number::Level;
use crate::parameters::{Parameter, Setup};

/// What is asked of every drive of a batch.
#[derive(Clone, Debug)]
pub(super) struct Kernel {
    pub setup: Setup<f64>,
    /// The parameters that have a value in each point.
    pub parameters: Vec<&'static Parameter>,
    pub of: Vec<Outcome>,
    /// What the outcomes are differentiated by; nothing for values alone.
    pub wrt: Vec<&'static Parameter>,
    /// Drives with a larger defect are flown again, in shorter steps; infinite where the setup's own step is kept.
    pub largest_defect: f64,
    /// The most that is used of what the processor can do.
    pub level: Level,
}

impl Kernel {
    /// Whether each value of a point is one its parameter may have.
    pub fn is_in_range(&self, point: &[f64]) -> bool {
        self.parameters.iter().zip(point).all(|(parameter, value)| parameter.range.contains(*value))
    }
}
