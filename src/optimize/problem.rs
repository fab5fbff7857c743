use crate::number::Taylor;
use crate::units::counted;

/// What is minimised, and what is held between limits: one method, giving every function with its
/// derivatives.
///
/// [`Exact`](super::Exact) makes one of [`Functions`](super::Functions) written over any number. A
/// problem may leave Hessians empty: the search then builds its own from gradients, and needs more
/// iterations.
pub trait Problem {
    /// The functions and their derivatives at `x`; where they are not defined, the reason.
    ///
    /// # Errors
    /// A sentence saying why there is no value at `x`. The search then steps back. Where its
    /// [`interrupt`](super::Observer::interrupt) is true by then, it ends instead, with the point
    /// before: an evaluation that takes long may look at the same flag, and fail once it is true.
    fn evaluate(&self, x: &[f64]) -> std::result::Result<Evaluation, String>;
}

impl<F: Fn(&[f64]) -> std::result::Result<Evaluation, String>> Problem for F {
    fn evaluate(&self, x: &[f64]) -> std::result::Result<Evaluation, String> {
        self(x)
    }
}

/// The functions of a problem at a point.
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Evaluation {
    /// f.
    pub objective: Taylor,
    /// c₁ … cₘ.
    pub constraints: Vec<Taylor>,
}

impl Evaluation {
    /// Whether its derivatives are those of `n` variables, with `m` constraints.
    pub(super) fn is_of(&self, n: usize, m: usize) -> bool {
        let is_square = |rows: &[Vec<f64>]| {
            rows.is_empty() || rows.len() == n && rows.iter().all(|row| row.len() == n)
        };
        self.constraints.len() == m
            && self
                .functions()
                .all(|function| function.gradient.len() == n && is_square(&function.hessian))
    }

    /// The evaluation, if it is of `n` variables and `m` constraints and finite.
    pub(super) fn checked(self, n: usize, m: usize) -> std::result::Result<Self, String> {
        if self.constraints.len() != m {
            let functions = counted(self.constraints.len() as u64, "constraint function");
            return Err(format!(
                "it has {functions}, but limits for {m}; give a limit for each function"
            ));
        }
        for function in self.functions() {
            let Taylor {
                gradient, hessian, ..
            } = function;
            let is_square = hessian.len() == n && hessian.iter().all(|row| row.len() == n);
            if gradient.len() != n || !(hessian.is_empty() || is_square) {
                return Err(format!(
                    "it has {}, a gradient of length {} and a Hessian of {}; gradient and Hessian \
                     must have {n}",
                    counted(n as u64, "variable"),
                    gradient.len(),
                    counted(hessian.len() as u64, "row")
                ));
            }
        }
        if self.functions().all(Taylor::is_finite) {
            Ok(self)
        } else {
            Err("a value or a derivative is not finite".into())
        }
    }

    /// f, c₁ … cₘ.
    fn functions(&self) -> impl Iterator<Item = &Taylor> {
        std::iter::once(&self.objective).chain(&self.constraints)
    }
}
