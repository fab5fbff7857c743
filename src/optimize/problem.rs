use crate::number::Taylor;
use crate::units::counted;

/// Objective and constraint functions of an optimization problem. One method evaluates all
/// functions with their derivatives.
///
/// [`Exact`](super::Exact) implements this trait for [`Functions`](super::Functions) written over a
/// generic number type. Hessians may be empty: the search then builds a quasi-Newton Hessian from
/// gradients, and needs more iterations.
pub trait Problem {
    /// The functions and their derivatives at `x`.
    ///
    /// # Errors
    /// The reason, in a sentence, why the functions have no value at `x`. The search then shortens
    /// its step, or, if its [`interrupt`](super::Observer::interrupt) flag is set, ends at the
    /// previous iterate. A long evaluation may therefore check this flag, and return an error once
    /// it is set.
    fn evaluate(&self, x: &[f64]) -> std::result::Result<Evaluation, String>;
}

impl<F: Fn(&[f64]) -> std::result::Result<Evaluation, String>> Problem for F {
    fn evaluate(&self, x: &[f64]) -> std::result::Result<Evaluation, String> {
        self(x)
    }
}

/// All functions of a problem at a point, as numbers or with their derivatives.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Evaluation<T = Taylor> {
    /// Objective f.
    pub objective: T,
    /// Constraint functions c₁ … cₘ.
    pub constraints: Vec<T>,
}

impl<T> Evaluation<T> {
    /// Evaluation of a problem without constraint functions.
    pub fn unconstrained(objective: T) -> Self {
        Self {
            objective,
            constraints: vec![],
        }
    }
}

impl Evaluation {
    /// Checks that the dimensions fit `n` variables and `m` constraints.
    pub(super) fn check_dimensions(&self, n: usize, m: usize) -> std::result::Result<(), String> {
        if self.constraints.len() != m {
            let functions = counted(self.constraints.len() as u64, "constraint function");
            return Err(format!(
                "the problem has {functions}, but the domain has limits for {m}; give limits \
                 for each function"
            ));
        }
        for function in self.functions() {
            let Taylor {
                gradient, hessian, ..
            } = function;
            let is_square = hessian.len() == n && hessian.iter().all(|row| row.len() == n);
            if gradient.len() != n || !(hessian.is_empty() || is_square) {
                return Err(format!(
                    "a function has a gradient of length {} and a Hessian of {}, but the domain \
                     has {}; the gradient must have {n} entries, the Hessian {n} rows of {n} \
                     entries or none",
                    gradient.len(),
                    counted(hessian.len() as u64, "row"),
                    counted(n as u64, "variable")
                ));
            }
        }
        Ok(())
    }

    /// The evaluation, if all values and derivatives are finite.
    pub(super) fn finite(self) -> std::result::Result<Self, String> {
        if self.functions().all(Taylor::is_finite) {
            Ok(self)
        } else {
            Err("a value or a derivative is not finite".into())
        }
    }

    /// The objective, then the constraint functions.
    fn functions(&self) -> impl Iterator<Item = &Taylor> {
        std::iter::once(&self.objective).chain(&self.constraints)
    }
}
