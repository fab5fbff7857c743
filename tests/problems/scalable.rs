//! Problems of any number of variables, each function of which depends on few: sums of terms, written once over the number.

use longdrive::number::Number;
use longdrive::optimize::sparse::{Function, Term, Terms};
use longdrive::optimize::{Domain, Functions, Values};

/// A problem with its domain and start.
pub struct Scalable {
    pub name: &'static str,
    pub domain: Domain,
    pub start: Vec<f64>,
    terms: Vec<Term>,
    kind: Kind,
    /// The step of a discretisation.
    h: f64,
}

#[derive(Clone, Copy)]
enum Kind {
    Rosenbrock,
    Chain,
    Membrane,
    Control,
    Wells,
}

impl Terms for Scalable {
    fn terms(&self) -> &[Term] {
        &self.terms
    }

    fn evaluate<T: Number>(&self, term: usize, x: &[T]) -> Result<T, String> {
        let h = self.h;
        Ok(match (self.kind, self.terms[term].of) {
            (Kind::Rosenbrock, Function::Objective) => (x[0] * x[0] - x[1]).powi(2) * 100.0 + (x[0] - 1.0).powi(2),
            (Kind::Rosenbrock, Function::Constraint(_)) => {
                x[1].powi(3) * 3.0 + x[2] * 2.0 - 5.0 + (x[1] - x[2]).sin() * (x[1] + x[2]).sin() + x[1] * 4.0
                    - x[0] * (x[0] - x[1]).exp()
                    - 3.0
            }
            (Kind::Chain, Function::Objective) => (x[0] + x[1]) * (0.5 * h),
            (Kind::Chain, Function::Constraint(_)) => ((x[2] - x[0]).powi(2) + (x[3] - x[1]).powi(2)) / (h * h),
            (Kind::Membrane, _) => (x[1] - x[0]).powi(2) * (0.5 / h) + (x[0] + x[1]) * (4.0 * h),
            (Kind::Control, Function::Objective) => x[0] * x[0] * (0.5 * h),
            // the place, and then the speed
            (Kind::Control, Function::Constraint(_)) => match x {
                [from, speed, pull, to] => *to - *from - *speed * h - *pull * (0.5 * h * h),
                _ => x[2] - x[0] - x[1] * h,
            },
            (Kind::Wells, _) => match x {
                [x] => (*x * *x - 1.0).powi(2) * 0.25,
                _ => ((x[1] - x[0]) / h).powi(2),
            },
        })
    }
}

/// The same with dense derivatives.
impl Functions for Scalable {
    fn evaluate<T: Number>(&self, x: &[T]) -> Result<Values<T>, String> {
        let mut all = Values { objective: T::constant(0.0), constraints: vec![T::constant(0.0); self.constraints()] };
        for (k, Term { of, variables }) in self.terms.iter().enumerate() {
            let of_its_own: Vec<T> = variables.iter().map(|i| x[*i]).collect();
            let sum = match of {
                Function::Objective => &mut all.objective,
                Function::Constraint(j) => &mut all.constraints[*j],
            };
            *sum = *sum + Terms::evaluate(self, k, &of_its_own)?;
        }
        Ok(all)
    }
}

fn objective(variables: Vec<usize>) -> Term {
    Term { of: Function::Objective, variables }
}

fn constraint(j: usize, variables: Vec<usize>) -> Term {
    Term { of: Function::Constraint(j), variables }
}

/// The chained Rosenbrock function with trigonometric-exponential constraints (Lukšan & Vlček 1999, problem 5.1): c(x) = 0, or
/// c(x) ≤ 0 as CUTEst's LUKVLI1 has it.
pub fn chained_rosenbrock(n: usize, are_equations: bool) -> Scalable {
    let mut terms: Vec<Term> = (0..n - 1).map(|i| objective(vec![i, i + 1])).collect();
    terms.extend((0..n - 2).map(|k| constraint(k, vec![k, k + 1, k + 2])));
    let least = if are_equations { 0.0 } else { f64::NEG_INFINITY };
    let domain = Domain::new(vec![f64::NEG_INFINITY; n], vec![f64::INFINITY; n])
        .and_then(|domain| domain.subject_to(vec![least; n - 2], vec![0.0; n - 2]))
        .unwrap();
    let start = (0..n).map(|i| if i % 2 == 0 { -1.2 } else { 1.0 }).collect();
    let name = if are_equations { "chained Rosenbrock, c = 0" } else { "chained Rosenbrock, c <= 0" };
    Scalable { name, domain, start, terms, kind: Kind::Rosenbrock, h: 1.0 }
}

/// A chain of equal links, of length 2 together, that hangs from (0, 0) and (1, 0): its potential energy, over places x₀ y₀ x₁ y₁ … of the
/// joints. The start is a parabola.
pub fn hanging_chain(links: usize) -> Scalable {
    let n = 2 * links + 2;
    let mut terms: Vec<Term> = (0..links).map(|k| objective(vec![2 * k + 1, 2 * k + 3])).collect();
    terms.extend((0..links).map(|k| constraint(k, (2 * k..2 * k + 4).collect())));
    let (mut low, mut high) = (vec![-10.0; n], vec![10.0; n]);
    for (i, at) in [(0, 0.0), (1, 0.0), (n - 2, 1.0), (n - 1, 0.0)] {
        (low[i], high[i]) = (at, at);
    }
    let domain = Domain::new(low, high).and_then(|d| d.subject_to(vec![1.0; links], vec![1.0; links])).unwrap();
    let along = |k: usize| k as f64 / links as f64;
    let start = (0..=links).flat_map(|k| [along(k), -2.0 * along(k) * (1.0 - along(k))]).collect();
    Scalable { name: "hanging chain", domain, start, terms, kind: Kind::Chain, h: 2.0 / links as f64 }
}

/// A membrane over (0, 1) under the load 8 that rests on a floor at −1/4: ∫ ½ u′² + 8 u by linear elements.
pub fn membrane(elements: usize) -> Scalable {
    let n = elements + 1;
    let (mut low, mut high) = (vec![-0.25; n], vec![1.0; n]);
    for i in [0, elements] {
        (low[i], high[i]) = (0.0, 0.0);
    }
    Scalable {
        name: "membrane on a floor",
        domain: Domain::new(low, high).unwrap(),
        start: vec![0.0; n],
        terms: (0..elements).map(|i| objective(vec![i, i + 1])).collect(),
        kind: Kind::Membrane,
        h: 1.0 / elements as f64,
    }
}

/// The problem of Bryson & Denham (Bryson & Ho 1975, section 3.11): a cart of mass 1 leaves 0 at speed 1 and is back after the time 1 at
/// speed −1, pulled with the least ∫ ½ u², and never beyond 1/9. The pull is constant over each step, so that places and speeds are exact.
pub fn bryson_denham(steps: usize) -> Scalable {
    // places, speeds, pulls
    let (speed, pull) = (steps + 1, 2 * steps + 2);
    let n = pull + steps;
    let mut terms: Vec<Term> = (0..steps).map(|k| objective(vec![pull + k])).collect();
    for k in 0..steps {
        terms.push(constraint(2 * k, vec![k, speed + k, pull + k, k + 1]));
        terms.push(constraint(2 * k + 1, vec![speed + k, pull + k, speed + k + 1]));
    }
    let (mut low, mut high) = (vec![-100.0; n], vec![100.0; n]);
    high[..=steps].fill(1.0 / 9.0);
    for (i, at) in [(0, 0.0), (steps, 0.0), (speed, 1.0), (speed + steps, -1.0)] {
        (low[i], high[i]) = (at, at);
    }
    let rows = 2 * steps;
    let domain = Domain::new(low, high).and_then(|d| d.subject_to(vec![0.0; rows], vec![0.0; rows])).unwrap();
    Scalable {
        name: "Bryson & Denham's cart",
        domain,
        start: vec![0.0; n],
        terms,
        kind: Kind::Control,
        h: 1.0 / steps as f64,
    }
}

/// Double wells ¼ (xᵢ² − 1)², coupled by n² (xᵢ₊₁ − xᵢ)², from the saddle at 0. Least where all are 1, or all −1: 0. With a coupling as strong
/// as this no wall between the two is at rest.
pub fn double_wells(n: usize) -> Scalable {
    let mut terms: Vec<Term> = (0..n).map(|i| objective(vec![i])).collect();
    terms.extend((0..n - 1).map(|i| objective(vec![i, i + 1])));
    let domain = Domain::new(vec![-3.0; n], vec![3.0; n]).unwrap();
    Scalable { name: "double wells", domain, start: vec![0.0; n], terms, kind: Kind::Wells, h: 1.0 / n as f64 }
}
