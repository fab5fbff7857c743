use super::problem::{Evaluation, Problem};
use crate::number::{Derivatives, Lanes, Mixed, Number, Numbers, Taylor};
use num_dual::Dual64;

/// The functions of a problem, written once over a generic number type. Dual numbers then give
/// exact derivatives.
///
/// ```
/// use longdrive::number::Number;
/// use longdrive::optimize::{Domain, Evaluation, Exact, Functions, Options, minimize};
///
/// /// The lightest can of a given volume: least surface 2πr² + 2πrh with πr²h = 1.
/// struct Can;
///
/// impl Functions for Can {
///     fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String> {
///         let (pi, r, h) = (std::f64::consts::PI, x[0], x[1]);
///         Ok(Evaluation { objective: (r * r + r * h) * (2.0 * pi), constraints: vec![r * r * h * pi] })
///     }
/// }
///
/// let radius_and_height = Domain::new(vec![0.1, 0.1], vec![10.0, 10.0]).unwrap();
/// let domain = radius_and_height.with_constraints(vec![1.0], vec![1.0]).unwrap();
/// let can = minimize(&Exact(Can), &domain, &[1.0, 1.0], &Options::default()).unwrap();
/// // height = diameter: r = (1/2π)^⅓, h = 2 r
/// let r = (0.5 / std::f64::consts::PI).cbrt();
/// assert!((can.x[0] - r).abs() < 1e-12 && (can.x[1] - 2.0 * r).abs() < 1e-12);
/// ```
pub trait Functions {
    /// Values of f and c₁ … cₘ at `x`.
    ///
    /// # Errors
    /// The reason, in a sentence, why the functions have no value at `x`. The search then shortens
    /// its step.
    fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String>;
}

/// Functions with exact gradients and Hessians.
#[derive(Clone, Copy, Debug)]
pub struct Exact<F>(pub F);

impl<F: Functions> Problem for Exact<F> {
    fn evaluate(&self, x: &[f64]) -> Result<Evaluation, String> {
        let n = x.len();
        let mut evaluation = None;
        for (i, j) in (0..n).flat_map(|i| (0..=i).map(move |j| (i, j))) {
            let lifted: Vec<Mixed> = (0..n)
                .map(|k| Mixed::constant(x[k]).seeded(&|direction| k == [i, j][direction], 0))
                .collect();
            put(
                &mut evaluation,
                self.0.evaluate(&lifted)?,
                n,
                n,
                |taylor, number| {
                    (taylor.value, taylor.gradient[i]) = (number.re(), number.first(0));
                    let second = number.second();
                    (taylor.hessian[i][j], taylor.hessian[j][i]) = (second, second);
                },
            );
        }
        evaluation.ok_or_else(|| "there are no variables".into())
    }
}

/// Functions with exact gradients and without Hessians. The search builds a quasi-Newton Hessian.
#[derive(Clone, Copy, Debug)]
pub struct Gradients<F>(pub F);

impl<F: Functions> Problem for Gradients<F> {
    fn evaluate(&self, x: &[f64]) -> Result<Evaluation, String> {
        let n = x.len();
        let mut evaluation = None;
        for i in 0..n {
            let mut lifted: Vec<_> = x.iter().map(|value| Dual64::from_re(*value)).collect();
            lifted[i] = lifted[i].derivative();
            put(
                &mut evaluation,
                self.0.evaluate(&lifted)?,
                n,
                0,
                |taylor, number| {
                    (taylor.value, taylor.gradient[i]) = (number.re, number.eps);
                },
            );
        }
        evaluation.ok_or_else(|| "there are no variables".into())
    }
}

/// Writes `values`, the result of one evaluation with dual numbers, to `evaluation`. `write` copies
/// the value and derivatives of one function. The first call allocates `columns` gradient entries
/// and `rows` rows of the Hessian for each function.
fn put<T>(
    evaluation: &mut Option<Evaluation>,
    values: Evaluation<T>,
    columns: usize,
    rows: usize,
    write: impl Fn(&mut Taylor, &T),
) {
    let blank = || Taylor::zero(columns, rows);
    let Evaluation {
        objective,
        constraints,
    } = evaluation.get_or_insert_with(|| Evaluation {
        objective: blank(),
        constraints: values.constraints.iter().map(|_| blank()).collect(),
    });
    write(objective, &values.objective);
    for (taylor, number) in constraints.iter_mut().zip(&values.constraints) {
        write(taylor, number);
    }
}
