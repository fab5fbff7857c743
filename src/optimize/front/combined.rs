use crate::number::Taylor;
use crate::optimize::problem::{Evaluation, Problem};

/// Problem made of weighted sums of two functions: the objective and the last constraint function
/// of another problem. One sum is the objective; a second sum replaces the last constraint.
pub(super) struct Combined<'a> {
    pub problem: &'a dyn Problem,
    /// Value subtracted from each function before the weighting.
    pub zero: [f64; 2],
    /// Weights in the objective.
    pub objective: [f64; 2],
    /// Weights in the constraint; `None` without a constraint.
    pub constraint: Option<[f64; 2]>,
}

impl<'a> Combined<'a> {
    /// Problem with the weights `objective` in its objective, without a constraint on a second sum.
    pub fn minimized(problem: &'a dyn Problem, objective: [f64; 2]) -> Self {
        Self {
            problem,
            zero: [0.0; 2],
            objective,
            constraint: None,
        }
    }
}

impl Problem for Combined<'_> {
    fn evaluate(&self, x: &[f64]) -> Result<Evaluation, String> {
        let functions = self.problem.evaluate(x)?;
        let count = functions.constraints.len();
        let Evaluation {
            objective,
            mut constraints,
        } = functions.checked(x.len(), count)?;
        let second = constraints.pop().ok_or("it has no second function")?;
        if objective.hessian.is_empty() != second.hessian.is_empty() {
            return Err(
                "one of its two functions has a Hessian and the other has none; give both, or none"
                    .into(),
            );
        }
        let sum = |weights: [f64; 2]| {
            let mut sum = Taylor::sum([(&objective, weights[0]), (&second, weights[1])]);
            // subtract the zero points first, so that no digits are lost
            sum.value = weights[0] * (objective.value - self.zero[0])
                + weights[1] * (second.value - self.zero[1]);
            sum
        };
        constraints.extend(self.constraint.map(sum));
        Ok(Evaluation {
            objective: sum(self.objective),
            constraints,
        })
    }
}
