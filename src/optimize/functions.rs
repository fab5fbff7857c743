use super::problem::{Evaluation, Problem};
use crate::number::{Number, Pairs, Seedable, Seeded, Taylor, first, second};

/// The functions of a problem, written once over the number: their derivatives are then exact by themselves.
///
/// ```
/// use longdrive::number::Number;
/// use longdrive::optimize::{Domain, Exact, Functions, Options, Values, minimize};
///
/// /// The lightest can of a given volume: least surface 2πr² + 2πrh with πr²h = 1.
/// struct Can;
///
/// impl Functions for Can {
///     fn evaluate<T: Number>(&self, x: &[T]) -> Result<Values<T>, String> {
///         let (pi, r, h) = (std::f64::consts::PI, x[0], x[1]);
///         Ok(Values { objective: (r * r + r * h) * (2.0 * pi), constraints: vec![r * r * h * pi] })
///     }
/// }
///
/// let domain = Domain::new(vec![0.1, 0.1], vec![10.0, 10.0]).unwrap().subject_to(vec![1.0], vec![1.0]).unwrap();
/// let can = minimize(&Exact(Can), &domain, &[1.0, 1.0], &Options::default()).unwrap();
/// // as tall as it is wide: r = (1/2π)^⅓, h = 2 r
/// let r = (0.5 / std::f64::consts::PI).cbrt();
/// assert!((can.x[0] - r).abs() < 1e-12 && (can.x[1] - 2.0 * r).abs() < 1e-12);
/// ```
pub trait Functions {
    /// f and c₁ … cₘ at `x`.
    ///
    /// # Errors
    /// A sentence saying why there is no value at `x`. The search then steps back.
    fn evaluate<T: Number>(&self, x: &[T]) -> Result<Values<T>, String>;
}

/// The values of a problem's functions.
#[derive(Clone, Debug)]
pub struct Values<T> {
    /// f.
    pub objective: T,
    /// c₁ … cₘ.
    pub constraints: Vec<T>,
}

/// Functions with exact gradients and Hessians.
#[derive(Clone, Copy, Debug)]
pub struct Exact<F>(pub F);

impl<F: Functions> Problem for Exact<F> {
    fn evaluate(&self, x: &[f64]) -> Result<Evaluation, String> {
        second(&At { functions: &self.0, x }, x.len(), Pairs::All, |_, _| ()).map(split)
    }
}

/// Functions with exact gradients; the search builds its own Hessian.
#[derive(Clone, Copy, Debug)]
pub struct Gradients<F>(pub F);

impl<F: Functions> Problem for Gradients<F> {
    fn evaluate(&self, x: &[f64]) -> Result<Evaluation, String> {
        first(&At { functions: &self.0, x }, x.len(), |_, _| ()).map(split)
    }
}

/// f and c from all outputs in a row.
fn split(mut all: Vec<Taylor>) -> Evaluation {
    let constraints = all.split_off(1);
    Evaluation { objective: all.swap_remove(0), constraints }
}

struct At<'a, F> {
    functions: &'a F,
    x: &'a [f64],
}

impl<F: Functions> Seedable for At<'_, F> {
    type Error = String;

    fn outputs<D: Seeded>(&self, seeds: &[usize]) -> Result<Vec<D>, String> {
        let lift = |i: usize| match seeds.iter().position(|&seed| seed == i) {
            Some(direction) => D::seeded(self.x[i], direction),
            None => D::constant(self.x[i]),
        };
        let x: Vec<D> = (0..self.x.len()).map(lift).collect();
        let values = self.functions.evaluate(&x)?;
        Ok(std::iter::once(values.objective).chain(values.constraints).collect())
    }
}
