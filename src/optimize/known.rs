use super::problem::Evaluation;
use super::sparse::{SparseEvaluation, SparseTaylor};
use crate::number::Taylor;
use serde::{Deserialize, Serialize};

/// What a search knows of the functions at a point.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Known {
    pub objective: Taylor,
    /// Of a sparse problem the values alone.
    pub constraints: Vec<Taylor>,
    /// The derivatives of a sparse problem, but for the gradient of the objective.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sparse: Option<SparseDerivatives>,
}

/// The derivatives of a sparse problem's functions.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct SparseDerivatives {
    /// ∂²f/∂xᵢ∂xⱼ.
    pub bend: Vec<(usize, usize, f64)>,
    /// c₁ … cₘ.
    pub constraints: Vec<SparseTaylor>,
}

impl From<Evaluation> for Known {
    fn from(Evaluation { objective, constraints }: Evaluation) -> Self {
        Self { objective, constraints, sparse: None }
    }
}

impl Known {
    /// Whether these are functions of `n` variables, an objective and `m` constraints, as a problem of this kind gives them.
    pub fn is_of(&self, n: usize, m: usize, is_sparse: bool) -> bool {
        let Self { objective, constraints, sparse } = self.clone();
        let Some(SparseDerivatives { bend, constraints: slopes }) = sparse else {
            return !is_sparse && Evaluation { objective, constraints }.checked(n, m).is_ok();
        };
        let is_whole = objective.gradient.len() == n && constraints.len() == m;
        let objective = SparseTaylor { value: objective.value, gradient: vec![], hessian: bend };
        is_sparse && is_whole && SparseEvaluation { objective, constraints: slopes }.checked(n, m).is_ok()
    }

    /// What a sparse problem of `n` variables says of a point.
    pub fn from_sparse(SparseEvaluation { objective, constraints }: SparseEvaluation, n: usize) -> Self {
        let mut gradient = vec![0.0; n];
        objective.gradient.iter().for_each(|(i, slope)| gradient[*i] += slope);
        let plain = |value: f64, gradient: Vec<f64>| Taylor { value, gradient, hessian: vec![] };
        Self {
            objective: plain(objective.value, gradient),
            constraints: constraints.iter().map(|constraint| plain(constraint.value, vec![])).collect(),
            sparse: Some(SparseDerivatives { bend: objective.hessian, constraints }),
        }
    }
}
