use crate::number::Taylor;
use crate::optimize::problem::{Evaluation, Problem};

/// Sums of two functions of a problem, its objective and its last constraint function: one to
/// minimise, and one that takes the place of the last constraint.
pub(super) struct Combined<'a> {
    pub problem: &'a dyn Problem,
    /// What is 0 of each.
    pub zero: [f64; 2],
    /// The weights in what is minimised.
    pub of: [f64; 2],
    /// The weights in what is held, if anything is.
    pub held: Option<[f64; 2]>,
}

impl<'a> Combined<'a> {
    /// A sum alone.
    pub fn of(problem: &'a dyn Problem, of: [f64; 2]) -> Self {
        Self {
            problem,
            zero: [0.0; 2],
            of,
            held: None,
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
            // each from its own zero, so that no digits are lost
            sum.value = weights[0] * (objective.value - self.zero[0])
                + weights[1] * (second.value - self.zero[1]);
            sum
        };
        constraints.extend(self.held.map(sum));
        Ok(Evaluation {
            objective: sum(self.of),
            constraints,
        })
    }
}
