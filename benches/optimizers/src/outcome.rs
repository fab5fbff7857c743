//! Outcome of a solver on a problem.

use serde::{Deserialize, Serialize};

#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Outcome {
    pub solver: String,
    pub problem: String,
    /// The status that the solver reports; the judge does not read it.
    pub status: String,
    /// The last point of the solver, `None` for a number that is not finite; empty if the solver
    /// failed.
    pub x: Vec<Option<f64>>,
    /// Number of points at which the problem was evaluated.
    pub evaluations: usize,
    pub iterations: Option<u64>,
    /// The solver's own time in seconds, without evaluations: the fastest of the repetitions.
    pub seconds: f64,
}

impl Outcome {
    pub fn failed(solver: &str, problem: &str, status: String) -> Self {
        let (solver, problem) = (solver.into(), problem.into());
        Self {
            solver,
            problem,
            status,
            x: vec![],
            evaluations: 0,
            iterations: None,
            seconds: f64::NAN,
        }
    }

    /// The last point of the solver, with NaN for each number that is not finite.
    pub fn point(&self) -> Vec<f64> {
        self.x.iter().map(|x| x.unwrap_or(f64::NAN)).collect()
    }
}
