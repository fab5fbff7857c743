use crate::units::counted;
use serde::{Deserialize, Serialize};

/// What is minimised, and what is held between limits, where each function depends on few of the variables.
///
/// [`Exact`](crate::optimize::Exact) makes one of [`Terms`](super::Terms) written over any number.
pub trait SparseProblem {
    /// The functions and their first and second derivatives at `x`; where they are not defined, the reason.
    ///
    /// # Errors
    /// A sentence saying why there is no value at `x`. The search then steps back.
    fn evaluate(&self, x: &[f64]) -> Result<SparseEvaluation, String>;
}

impl<F: Fn(&[f64]) -> Result<SparseEvaluation, String>> SparseProblem for F {
    fn evaluate(&self, x: &[f64]) -> Result<SparseEvaluation, String> {
        self(x)
    }
}

/// The functions of a sparse problem at a point.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SparseEvaluation {
    /// f.
    pub objective: SparseTaylor,
    /// c₁ … cₘ.
    pub constraints: Vec<SparseTaylor>,
}

/// A function's value with those of its derivatives that are not 0 everywhere. Entries for the same place are added.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SparseTaylor {
    /// The value.
    pub value: f64,
    /// (i, ∂/∂xᵢ).
    pub gradient: Vec<(usize, f64)>,
    /// (i, j, ∂²/∂xᵢ∂xⱼ) for each pair once: (i, j) stands for (j, i) too.
    pub hessian: Vec<(usize, usize, f64)>,
}

impl SparseEvaluation {
    /// The evaluation, if it is of `n` variables and `m` constraints and finite.
    pub(in crate::optimize) fn checked(self, n: usize, m: usize) -> Result<Self, String> {
        if self.constraints.len() != m {
            let functions = counted(self.constraints.len() as u64, "constraint function");
            return Err(format!("it has {functions}, but limits for {m}; give a limit for each function"));
        }
        let mut is_finite = true;
        for SparseTaylor { value, gradient, hessian } in std::iter::once(&self.objective).chain(&self.constraints) {
            let variables = gradient.iter().map(|(i, _)| *i).chain(hessian.iter().map(|(i, j, _)| *i.max(j)));
            if let Some(beyond) = variables.max().filter(|last| *last >= n) {
                let variables = counted(n as u64, "variable");
                return Err(format!("it has a derivative by variable {beyond}, but {variables}, counted from 0"));
            }
            let mut derivatives = gradient.iter().map(|(_, d)| d).chain(hessian.iter().map(|(_, _, d)| d));
            is_finite &= value.is_finite() && derivatives.all(|d| d.is_finite());
        }
        if is_finite { Ok(self) } else { Err("a value or a derivative is not finite".into()) }
    }
}
