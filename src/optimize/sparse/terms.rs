use super::problem::{SparseEvaluation, SparseProblem, SparseTaylor};
use crate::number::{Derivatives, Lanes, Mixed, Number, Numbers};
use crate::optimize::Exact;

/// Functions that are sums of terms of few variables each (partially separable; Griewank & Toint 1982), written once over the
/// number: derivatives are then exact by themselves. A term of k variables is computed k (k + 1)/2 times.
///
/// ```
/// use longdrive::number::Number;
/// use longdrive::optimize::{Domain, Exact, Observer, Options, Status, minimize_sparse};
/// use longdrive::optimize::sparse::{Function, Term, Terms};
///
/// /// The shortest way over 1000 points at a distance of 1 along the floor, from height 0 to height 1: Σ (xᵢ₊₁ − xᵢ)².
/// struct Way(Vec<Term>);
///
/// impl Terms for Way {
///     fn terms(&self) -> &[Term] {
///         &self.0
///     }
///     fn evaluate<T: Number>(&self, _: usize, x: &[T]) -> Result<T, String> {
///         Ok((x[1] - x[0]).powi(2))
///     }
/// }
///
/// let n = 1000;
/// let way = Way((0..n - 1).map(|i| Term { of: Function::Objective, variables: vec![i, i + 1] }).collect());
/// let mut domain = Domain::new(vec![-1e3; n], vec![1e3; n]).unwrap();
/// (domain.variables.high[0], domain.variables.low[0]) = (0.0, 0.0);
/// (domain.variables.high[n - 1], domain.variables.low[n - 1]) = (1.0, 1.0);
/// let found = minimize_sparse(&Exact(way), &domain, &vec![0.5; n], &Options::default(), Observer::default()).unwrap();
/// // a straight line
/// assert_eq!(found.status, Status::Converged);
/// assert!((found.x[333] - 333.0 / 999.0).abs() < 1e-9);
/// ```
pub trait Terms {
    /// The terms: what each is added to, and which variables it depends on. The same at every call.
    fn terms(&self) -> &[Term];

    /// The value of a term, counted from 0, at the values of its own variables in its own order.
    ///
    /// # Errors
    /// A sentence saying why there is no value at `x`. The search then steps back.
    fn evaluate<T: Number>(&self, term: usize, x: &[T]) -> Result<T, String>;

    /// Number of constraint functions: as many as the terms name. To be written where one of the last has no term.
    fn constraints(&self) -> usize {
        let of = |term: &Term| if let Function::Constraint(j) = term.of { j + 1 } else { 0 };
        self.terms().iter().map(of).max().unwrap_or(0)
    }
}

/// A term of a function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Term {
    /// What it is added to.
    pub of: Function,
    /// The variables that it depends on.
    pub variables: Vec<usize>,
}

/// A function of a problem.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// f.
    Objective,
    /// A constraint function, counted from 0.
    Constraint(usize),
}

impl<F: Terms> SparseProblem for Exact<F> {
    fn evaluate(&self, x: &[f64]) -> Result<SparseEvaluation, String> {
        let constraints = vec![SparseTaylor::default(); self.0.constraints()];
        let mut all = SparseEvaluation { objective: SparseTaylor::default(), constraints };
        let count = all.constraints.len();
        for (k, Term { of, variables }) in self.0.terms().iter().enumerate() {
            let sum = match of {
                Function::Objective => &mut all.objective,
                Function::Constraint(j) => all
                    .constraints
                    .get_mut(*j)
                    .ok_or_else(|| format!("term {k} is of constraint {j}, but there are {count}, counted from 0"))?,
            };
            let missing = variables.iter().find(|i| **i >= x.len());
            if let Some(i) = missing {
                return Err(format!("term {k} names variable {i}, but there are {}, counted from 0", x.len()));
            }
            let of_its_own: Vec<f64> = variables.iter().map(|i| x[*i]).collect();
            add(&self.0, k, variables, &of_its_own, sum)?;
        }
        Ok(all)
    }
}

/// Adds a term with its derivatives.
fn add(terms: &impl Terms, term: usize, variables: &[usize], x: &[f64], sum: &mut SparseTaylor) -> Result<(), String> {
    let count = x.len();
    if count == 0 {
        sum.value += terms.evaluate::<f64>(term, x)?;
    }
    for (i, j) in (0..count).flat_map(|i| (0..=i).map(move |j| (i, j))) {
        let lifted: Vec<Mixed> =
            (0..count).map(|k| Mixed::constant(x[k]).seeded(&|direction| k == [i, j][direction], 0)).collect();
        let number = terms.evaluate(term, &lifted)?;
        let second = number.second();
        if second != 0.0 {
            // a pair stands for both orders, unless a variable is named twice
            let times = if i != j && variables[i] == variables[j] { 2.0 } else { 1.0 };
            sum.hessian.push((variables[i], variables[j], times * second));
        }
        if j == 0 {
            sum.gradient.push((variables[i], number.first(0)));
            sum.value += if i == 0 { number.re() } else { 0.0 };
        }
    }
    Ok(())
}
