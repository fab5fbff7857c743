//! The sensitivity of an optimum: how it moves with a parameter of the problem, from the KKT system
//! (Fiacco 1976).

use super::domain::{Bounds, Domain};
use super::null_space::free_moves;
use super::problem::Evaluation;
use super::solution::Solution;
use super::status::Status;
use crate::error::{Error, Result};
use crate::number::Taylor;
use nalgebra::{DMatrix, DVector};

/// How an optimum answers to a parameter p.
#[derive(Clone, Debug, PartialEq)]
pub struct Response {
    /// df*/dp: by the envelope theorem, the Lagrangian's own derivative.
    pub value: f64,
    /// d²f*/dp².
    pub curvature: f64,
    /// dx*/dp.
    pub x: Vec<f64>,
    /// dλ*/dp of the constraints.
    pub multipliers: Vec<f64>,
    /// dc/dp of the constraint functions along the optimum.
    pub constraints: Vec<f64>,
    /// d/dp of the Lagrangian's gradient: what the multiplier of an active bound changes by (a
    /// lower bound's by this, an upper one's by its negative).
    pub slopes: Vec<f64>,
}

/// A bound or a limit that a moving optimum reaches or leaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    /// Variable i comes to its bound; the lower one if true.
    BoundReached(usize, bool),
    /// Variable i leaves its bound.
    BoundLeft(usize, bool),
    /// Constraint j comes to its limit; the lower one if true.
    LimitReached(usize, bool),
    /// Constraint j leaves its limit.
    LimitLeft(usize, bool),
}

/// Multipliers below this part of the largest slope hold nothing.
const IDLE: f64 = 1e-9;
/// Curvature below this part of what is minimised, over the scales of the variables, is rounding.
const ROUNDING: f64 = 1e-12;

/// Which variables lie on a bound that holds them, and which constraints on a limit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Held {
    /// Of each variable, whether a bound holds it.
    pub variables: Vec<bool>,
    /// Of each constraint, whether it holds the solution.
    pub constraints: Vec<bool>,
}

impl Held {
    /// What holds a solution: fixed variables and equations, and whatever has a multiplier above
    /// rounding.
    ///
    /// # Panics
    /// Where the domain has fewer variables or constraints than the solution.
    pub fn new(solution: &Solution, domain: &Domain) -> Self {
        let scale = domain.variables.scale(&solution.x);
        let size = size(solution, &scale);
        let variable = |i: usize| {
            let price = solution.lower_multipliers[i] + solution.upper_multipliers[i];
            domain.variables.is_fixed(i) || price * scale[i] > IDLE * size
        };
        let constraint = |j: usize| {
            let price =
                solution.constraints[j].multiplier.abs() * largest(&solution.jacobian[j], &scale);
            domain.constraints.is_fixed(j) || price > IDLE * size
        };
        Self {
            variables: (0..solution.x.len()).map(variable).collect(),
            constraints: (0..solution.constraints.len()).map(constraint).collect(),
        }
    }

    /// The variables that no bound holds.
    pub fn free(&self) -> Vec<usize> {
        (0..self.variables.len())
            .filter(|&i| !self.variables[i])
            .collect()
    }

    /// The constraints that hold.
    pub fn tight(&self) -> Vec<usize> {
        (0..self.constraints.len())
            .filter(|&j| self.constraints[j])
            .collect()
    }
}

/// The largest of slopes, over the scales of the variables.
fn largest(slopes: &[f64], scale: &[f64]) -> f64 {
    slopes
        .iter()
        .zip(scale)
        .map(|(slope, scale)| (slope * scale).abs())
        .fold(0.0, f64::max)
}

/// How large what is minimised is, with its slopes.
fn size(solution: &Solution, scale: &[f64]) -> f64 {
    largest(&solution.gradient, scale).max(solution.value.unwrap_or_default().abs())
}

/// The Hessian of the Lagrangian over the scales of the variables, with 0 for what is rounding:
/// where nothing depends on a variable, its row must not look like the curvature of an optimum.
fn curvatures(solution: &Solution, scale: &[f64]) -> DMatrix<f64> {
    let least = ROUNDING * size(solution, scale);
    DMatrix::from_fn(scale.len(), scale.len(), |i, k| {
        let curvature = solution.hessian[i][k] * scale[i] * scale[k];
        if curvature.abs() > least {
            curvature
        } else {
            0.0
        }
    })
}

/// The Hessian of the Lagrangian along what holds a solution: a basis of the moves that keep it, a
/// column each, and the curvature of each with each; both in units of [`Bounds::scale`].
///
/// # Panics
/// Where the domain is not that of the solution, or the solution has no Hessian.
pub fn reduced_hessian(solution: &Solution, domain: &Domain) -> (DMatrix<f64>, DMatrix<f64>) {
    let (n, held) = (solution.x.len(), Held::new(solution, domain));
    let scale = domain.variables.scale(&solution.x);
    let (free, tight) = (held.free(), held.tight());
    let rows = DMatrix::from_fn(tight.len(), free.len(), |r, c| {
        solution.jacobian[tight[r]][free[c]] * scale[free[c]]
    });
    let basis = free_moves(n, &free, &rows);
    let reduced = basis.transpose() * curvatures(solution, &scale) * &basis;
    (basis, reduced)
}

/// Refuses a domain of another solution, and functions without the derivatives that are used.
fn check_shape(solution: &Solution, domain: &Domain, at: &Evaluation) -> Result<()> {
    let (n, m) = (solution.x.len(), solution.constraints.len());
    if !solution.is_of(domain) {
        return Err(Error::Optimizer(
            "the domain is not that of the solution: variables or constraints differ in number"
                .into(),
        ));
    }
    let has_last = |of: &Taylor| {
        of.gradient.len() == n + 1 && of.hessian.len() == n + 1 && of.hessian[n].len() == n + 1
    };
    if at.constraints.len() != m
        || !std::iter::once(&at.objective)
            .chain(&at.constraints)
            .all(has_last)
    {
        let what = format!(
            "the functions at the optimum must be the objective and {m} constraints with \
             derivatives by {n} variables and the parameter"
        );
        return Err(Error::Optimizer(what));
    }
    Ok(())
}

/// How a converged optimum answers to a parameter. `at` holds the functions at the optimum with
/// their derivatives by (x, p), the parameter last; of their Hessians only the last row is used.
///
/// # Errors
/// [`Error::NotConverged`] of anything but an optimum; [`Error::Optimizer`] for a problem without
/// Hessians, for numbers of variables or constraints that differ, and where the KKT system is
/// singular: the optimum is then not isolated, and moves by more than any multiple of the
/// parameter's change.
pub fn response(solution: &Solution, domain: &Domain, at: &Evaluation) -> Result<Response> {
    let n = solution.x.len();
    if solution.status != Status::Converged {
        return Err(Error::NotConverged {
            status: solution.status.name(),
            message: solution.message.clone().into(),
        });
    }
    if solution.hessian.len() != n {
        return Err(Error::Optimizer(
            "the sensitivity of an optimum needs exact Hessians".into(),
        ));
    }
    check_shape(solution, domain, at)?;
    let held = Held::new(solution, domain);
    let (free, tight) = (held.free(), held.tight());
    let scale = domain.variables.scale(&solution.x);
    let (f, size) = (free.len(), free.len() + tight.len());
    let weights = || {
        solution
            .constraints
            .iter()
            .map(|constraint| constraint.multiplier)
    };
    let mixed = |i: usize| {
        let own = at.objective.hessian[n][i];
        own + at
            .constraints
            .iter()
            .zip(weights())
            .map(|(c, weight)| weight * c.hessian[n][i])
            .sum::<f64>()
    };

    // rows of length about 1, so that "singular" means something
    let length = |j: usize| largest(&solution.jacobian[j], &scale).max(f64::MIN_POSITIVE);
    let bends = curvatures(solution, &scale);
    let bends = bends.select_rows(&free).select_columns(&free);
    let most = bends.amax();
    let unit = if most > 0.0 { most } else { 1.0 };
    let mut matrix = DMatrix::zeros(size, size);
    let mut right = DVector::zeros(size);
    matrix.view_mut((0, 0), (f, f)).copy_from(&(bends / unit));
    for (row, &i) in free.iter().enumerate() {
        right[row] = -mixed(i) * scale[i] / unit;
    }
    for (at_row, &j) in tight.iter().enumerate() {
        for (row, &i) in free.iter().enumerate() {
            let slope = solution.jacobian[j][i] * scale[i] / length(j);
            (matrix[(row, f + at_row)], matrix[(f + at_row, row)]) = (slope, slope);
        }
        right[f + at_row] = -at.constraints[j].gradient[n] / length(j);
    }
    let moved = solved(matrix, &right)?;

    let mut x = vec![0.0; n];
    for (row, &i) in free.iter().enumerate() {
        x[i] = moved[row] * scale[i];
    }
    let mut multipliers = vec![0.0; solution.constraints.len()];
    for (row, &j) in tight.iter().enumerate() {
        multipliers[j] = moved[f + row] * unit / length(j);
    }
    let along = |slopes: &[f64]| {
        slopes
            .iter()
            .zip(&x)
            .map(|(slope, x)| slope * x)
            .sum::<f64>()
    };
    let slope = |i: usize| {
        let pulls = solution
            .jacobian
            .iter()
            .zip(&multipliers)
            .map(|(row, change)| row[i] * change);
        along(&solution.hessian[i]) + pulls.sum::<f64>() + mixed(i)
    };
    let sum = |own: f64, of: &dyn Fn(usize) -> f64| {
        own + weights().enumerate().map(|(j, w)| w * of(j)).sum::<f64>()
    };
    let direct = sum(at.objective.hessian[n][n], &|j| {
        at.constraints[j].hessian[n][n]
    });
    let by_x: f64 = (0..n).map(|i| mixed(i) * x[i]).sum();
    let by_price: f64 = multipliers
        .iter()
        .zip(&at.constraints)
        .map(|(change, c)| change * c.gradient[n])
        .sum();
    Ok(Response {
        value: sum(at.objective.gradient[n], &|j| at.constraints[j].gradient[n]),
        curvature: direct + by_x + by_price,
        constraints: solution
            .jacobian
            .iter()
            .zip(&at.constraints)
            .map(|(row, c)| along(row) + c.gradient[n])
            .collect(),
        slopes: (0..n).map(slope).collect(),
        multipliers,
        x,
    })
}

fn solved(matrix: DMatrix<f64>, right: &DVector<f64>) -> Result<DVector<f64>> {
    if matrix.is_empty() {
        return Ok(right.clone());
    }
    let values = matrix.singular_values();
    if values.min() <= 1e-12 * values.max() {
        return Err(Error::Optimizer(
            "the optimum is not isolated (its KKT system is singular): other values of the \
             variables are as good, so that it has no \
             sensitivity; vary fewer parameters"
                .into(),
        ));
    }
    let lu = matrix.clone().lu();
    let first = lu.solve(right).unwrap_or_else(|| right.clone() * 0.0);
    let refined = lu
        .solve(&(right - &matrix * &first))
        .map_or(first.clone(), |change| &first + change);
    Ok(refined)
}

/// The first bound or limit that the optimum reaches or leaves, to first order, on a change of the
/// parameter by `delta`; and after which part of the change.
pub fn first_event(
    solution: &Solution,
    domain: &Domain,
    response: &Response,
    delta: f64,
) -> Option<(f64, Event)> {
    let held = Held::new(solution, domain);
    let mut events = vec![];
    // the part of the change after which `room` is used up
    let mut note = |room: f64, rate: f64, event: Event| {
        let used = -rate * delta;
        if used > 0.0 && room.is_finite() && room <= used {
            events.push((room.max(0.0) / used, event));
        }
    };
    let to_ends = |bounds: &Bounds, i: usize, at: f64| {
        [
            (at - bounds.low[i], 1.0, true),
            (bounds.high[i] - at, -1.0, false),
        ]
    };
    for i in (0..solution.x.len()).filter(|&i| !domain.variables.is_fixed(i)) {
        if held.variables[i] {
            let (lower, upper) = (solution.lower_multipliers[i], solution.upper_multipliers[i]);
            let (room, rate) = if lower > 0.0 {
                (lower, response.slopes[i])
            } else {
                (upper, -response.slopes[i])
            };
            note(room, rate, Event::BoundLeft(i, lower > 0.0));
        } else {
            for (room, sign, is_lower) in to_ends(&domain.variables, i, solution.x[i]) {
                note(room, sign * response.x[i], Event::BoundReached(i, is_lower));
            }
        }
    }
    for (j, constraint) in solution
        .constraints
        .iter()
        .enumerate()
        .filter(|(j, _)| !domain.constraints.is_fixed(*j))
    {
        if held.constraints[j] {
            let sign = constraint.multiplier.signum();
            note(
                constraint.multiplier.abs(),
                sign * response.multipliers[j],
                Event::LimitLeft(j, sign < 0.0),
            );
        } else {
            for (room, sign, is_lower) in to_ends(&domain.constraints, j, constraint.value) {
                note(
                    room,
                    sign * response.constraints[j],
                    Event::LimitReached(j, is_lower),
                );
            }
        }
    }
    events.into_iter().min_by(|a, b| a.0.total_cmp(&b.0))
}
