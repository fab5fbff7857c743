//! Sensitivity of an optimum to a parameter of the problem, from the KKT system (Fiacco 1976).

use super::domain::{Bounds, Domain};
use super::kink::Kink;
use super::null_space::tangent_basis;
use super::problem::Evaluation;
use super::qp::SymmetricSystem;
use super::scaling::{largest_scaled, objective_size, scaled_hessian};
use super::solution::Solution;
use super::status::Status;
use crate::error::{Error, Result};
use crate::number::Taylor;
use nalgebra::{DMatrix, DVector};

/// Derivatives of an optimum by a parameter p.
#[derive(Clone, Debug, PartialEq)]
pub struct OptimumResponse {
    /// df*/dp. By the envelope theorem, this is the partial derivative of the Lagrangian by p.
    pub value: f64,
    /// d²f*/dp².
    pub curvature: f64,
    /// dx*/dp.
    pub x: Vec<f64>,
    /// dλ*/dp of the constraints.
    pub multipliers: Vec<f64>,
    /// dc/dp of the constraint functions along the optimum.
    pub constraints: Vec<f64>,
    /// Derivative by p of the Lagrangian's gradient along the optimum. For a variable at its lower
    /// bound, the component is the derivative of the bound's multiplier. For a variable at its
    /// upper bound, it is minus the derivative of the bound's multiplier.
    pub slopes: Vec<f64>,
}

/// Change of the active set as the optimum moves with the parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    /// Variable i reaches its lower bound (`true`) or its upper bound (`false`).
    BoundReached(usize, bool),
    /// Variable i leaves its lower bound (`true`) or its upper bound (`false`).
    BoundLeft(usize, bool),
    /// Constraint j reaches its lower limit (`true`) or its upper limit (`false`).
    LimitReached(usize, bool),
    /// Constraint j leaves its lower limit (`true`) or its upper limit (`false`).
    LimitLeft(usize, bool),
}

/// Threshold for curvature in scaled variables, relative to the size of the objective. Smaller
/// curvature counts as rounding.
const ROUNDING: f64 = 1e-12;

/// Active set at a solution: variables on an active bound, and active constraints. The set does not
/// contain a variable at a kink of the objective between its bounds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ActiveSet {
    /// True for each variable on an active bound.
    pub variables: Vec<bool>,
    /// True for each active constraint.
    pub constraints: Vec<bool>,
}

impl ActiveSet {
    /// Active set of a solution: fixed variables, equality constraints, and all bounds and
    /// constraints with a multiplier other than 0.
    ///
    /// # Panics
    /// If the domain has fewer variables or constraints than the solution.
    pub fn new(solution: &Solution, domain: &Domain) -> Self {
        let variable = |i: usize| {
            let multiplier = solution.lower_multipliers[i] + solution.upper_multipliers[i];
            domain.variables.is_fixed(i) || multiplier != 0.0
        };
        let constraint =
            |j: usize| domain.constraints.is_fixed(j) || solution.constraints[j].multiplier != 0.0;
        Self {
            variables: (0..solution.x.len()).map(variable).collect(),
            constraints: (0..solution.constraints.len()).map(constraint).collect(),
        }
    }

    /// Indices of the variables without an active bound.
    pub fn free_variables(&self) -> Vec<usize> {
        (0..self.variables.len())
            .filter(|&i| !self.variables[i])
            .collect()
    }

    /// Indices of the active constraints.
    pub fn active_constraints(&self) -> Vec<usize> {
        (0..self.constraints.len())
            .filter(|&j| self.constraints[j])
            .collect()
    }
}

/// Hessian of the Lagrangian in scaled variables. Rounding errors are set to 0, because they would
/// make the optimum look isolated along a variable without effect.
fn curvatures(solution: &Solution, scale: &[f64]) -> DMatrix<f64> {
    let value = solution.value.unwrap_or_default();
    let least = ROUNDING * objective_size(value, &solution.gradient, scale);
    scaled_hessian(&solution.hessian, scale).map(|curvature| {
        if curvature.abs() > least {
            curvature
        } else {
            0.0
        }
    })
}

/// Indices of the variables that have no active bound and are not at a kink of the objective.
///
/// # Panics
/// If the domain does not belong to the solution.
pub fn smooth_variables(solution: &Solution, domain: &Domain) -> Vec<usize> {
    let mut free = ActiveSet::new(solution, domain).free_variables();
    free.retain(|i| solution.kink.is_none_or(|kink| kink.variable != *i));
    free
}

/// Reduced Hessian: the Hessian of the Lagrangian on the tangents of the active set, in variables
/// scaled by [`Bounds::scale`]. A variable at a kink of the objective is fixed. Returns a basis of
/// the tangents, one in each column, and the reduced Hessian.
///
/// # Panics
/// If the domain does not belong to the solution, or the solution has no Hessian.
pub fn reduced_hessian(solution: &Solution, domain: &Domain) -> (DMatrix<f64>, DMatrix<f64>) {
    let active_set = ActiveSet::new(solution, domain);
    let scale = domain.variables.scale(&solution.x);
    let free = smooth_variables(solution, domain);
    let active = active_set.active_constraints();
    let rows = DMatrix::from_fn(active.len(), free.len(), |r, c| {
        solution.jacobian[active[r]][free[c]] * scale[free[c]]
    });
    let basis = tangent_basis(solution.x.len(), &free, rows);
    let reduced = basis.transpose() * curvatures(solution, &scale) * &basis;
    (basis, reduced)
}

fn check_input(solution: &Solution, domain: &Domain, at: &Evaluation) -> Result<()> {
    let (n, m) = (solution.x.len(), solution.constraints.len());
    if solution.status != Status::Converged {
        return Err(Error::NotConverged {
            status: solution.status.name(),
            message: solution.message.clone().into(),
        });
    }
    if solution.kink.is_some_and(Kink::is_between_bounds) {
        return Err(Error::Optimizer(
            "the optimum lies at a kink of the objective, which may move with the parameter, so \
             the optimum has no sensitivity; fix the variable of the kink"
                .into(),
        ));
    }
    if solution.hessian.len() != n {
        return Err(Error::Optimizer(
            "the sensitivity of an optimum needs exact Hessians".into(),
        ));
    }
    if !solution.fits(domain) {
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

/// Derivatives of a converged optimum by a parameter. `at` holds the functions at the optimum with
/// their derivatives by (x, p), the parameter last; only the last row of each Hessian is used.
///
/// # Errors
/// [`Error::NotConverged`] if the solution did not converge. [`Error::Optimizer`] if the solution
/// has no Hessians, if dimensions differ, if the solution lies at a kink of the objective between
/// the bounds, or if the KKT system is singular, because an optimum that is not isolated has no
/// derivative.
pub fn response(solution: &Solution, domain: &Domain, at: &Evaluation) -> Result<OptimumResponse> {
    check_input(solution, domain, at)?;
    let active_set = ActiveSet::new(solution, domain);
    let system = KktSystem {
        solution,
        at,
        scale: domain.variables.scale(&solution.x),
        free: active_set.free_variables(),
        active: active_set.active_constraints(),
    };
    let n = solution.x.len();
    let [x, multipliers] = system.solve()?;
    let direct = system.lagrangian_sum(at.objective.hessian[n][n], |j| {
        at.constraints[j].hessian[n][n]
    });
    let by_x: f64 = (0..n).map(|i| system.mixed(i) * x[i]).sum();
    let by_multipliers: f64 = multipliers
        .iter()
        .zip(&at.constraints)
        .map(|(change, c)| change * c.gradient[n])
        .sum();
    Ok(OptimumResponse {
        value: system.lagrangian_sum(at.objective.gradient[n], |j| at.constraints[j].gradient[n]),
        curvature: direct + by_x + by_multipliers,
        constraints: solution
            .jacobian
            .iter()
            .zip(&at.constraints)
            .map(|(row, c)| dot(row, &x) + c.gradient[n])
            .collect(),
        slopes: (0..n)
            .map(|i| system.gradient_derivative(i, &x, &multipliers))
            .collect(),
        multipliers,
        x,
    })
}

/// The KKT system of a converged optimum, differentiated by the parameter p.
struct KktSystem<'a> {
    solution: &'a Solution,
    /// The functions with their derivatives by (x, p).
    at: &'a Evaluation,
    scale: Vec<f64>,
    /// Variables without an active bound.
    free: Vec<usize>,
    /// Active constraints.
    active: Vec<usize>,
}

impl KktSystem<'_> {
    /// Solves the differentiated KKT conditions for dx*/dp and dλ*/dp.
    fn solve(&self) -> Result<[Vec<f64>; 2]> {
        let Self {
            solution,
            scale,
            free,
            active,
            ..
        } = self;
        let n = solution.x.len();
        let (f, size) = (free.len(), free.len() + active.len());
        let curvatures = curvatures(solution, scale);
        let curvatures = curvatures.select_rows(free).select_columns(free);
        let largest = curvatures.amax();
        let unit = if largest > 0.0 { largest } else { 1.0 };
        let mut matrix = DMatrix::zeros(size, size);
        let mut right = DVector::zeros(size);
        matrix
            .view_mut((0, 0), (f, f))
            .copy_from(&(curvatures / unit));
        for (row, &i) in free.iter().enumerate() {
            right[row] = -self.mixed(i) * scale[i] / unit;
        }
        for (k, &j) in active.iter().enumerate() {
            for (row, &i) in free.iter().enumerate() {
                let derivative =
                    solution.jacobian[j][i] * scale[i] / self.largest_scaled_derivative(j);
                (matrix[(row, f + k)], matrix[(f + k, row)]) = (derivative, derivative);
            }
            right[f + k] = -self.at.constraints[j].gradient[n] / self.largest_scaled_derivative(j);
        }
        let change = solve_regular(SymmetricSystem { matrix, right })?;

        let mut x = vec![0.0; n];
        for (row, &i) in free.iter().enumerate() {
            x[i] = change[row] * scale[i];
        }
        let mut multipliers = vec![0.0; solution.constraints.len()];
        for (k, &j) in active.iter().enumerate() {
            multipliers[j] = change[f + k] * unit / self.largest_scaled_derivative(j);
        }
        Ok([x, multipliers])
    }

    /// Largest scaled derivative of constraint j. Dividing the row of each constraint by it makes
    /// the rows comparable in size, so that a small singular value shows a singular system.
    fn largest_scaled_derivative(&self, j: usize) -> f64 {
        largest_scaled(&self.solution.jacobian[j], &self.scale).max(f64::MIN_POSITIVE)
    }

    /// Mixed derivative ∂²L/∂xᵢ∂p of the Lagrangian.
    fn mixed(&self, i: usize) -> f64 {
        let (n, at) = (self.solution.x.len(), self.at);
        self.lagrangian_sum(at.objective.hessian[n][i], |j| {
            at.constraints[j].hessian[n][i]
        })
    }

    /// d/dp of component i of the Lagrangian's gradient along the optimum.
    fn gradient_derivative(&self, i: usize, x: &[f64], multipliers: &[f64]) -> f64 {
        let by_multipliers = self
            .solution
            .jacobian
            .iter()
            .zip(multipliers)
            .map(|(row, change)| row[i] * change);
        dot(&self.solution.hessian[i], x) + by_multipliers.sum::<f64>() + self.mixed(i)
    }

    /// objective + Σ λⱼ constraint(j).
    fn lagrangian_sum(&self, objective: f64, constraint: impl Fn(usize) -> f64) -> f64 {
        let values = self.solution.constraints.iter().enumerate();
        objective
            + values
                .map(|(j, value)| value.multiplier * constraint(j))
                .sum::<f64>()
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>()
}

fn solve_regular(system: SymmetricSystem) -> Result<DVector<f64>> {
    let is_singular = |matrix: &DMatrix<f64>| {
        let values = matrix.singular_values();
        values.min() <= 1e-12 * values.max()
    };
    let solution = if system.matrix.is_empty() || !is_singular(&system.matrix) {
        system.solve()
    } else {
        None
    };
    solution.ok_or_else(|| {
        Error::Optimizer(
            "the optimum is not isolated (its KKT system is singular): other values of the \
             variables are equally good, so the optimum has no sensitivity; vary fewer parameters"
                .into(),
        )
    })
}

/// First change of the active set if the parameter changes by `delta`, to first order. Returns the
/// fraction of `delta` at which the set changes, and the change; `None` if the set does not change.
pub fn first_event(
    solution: &Solution,
    domain: &Domain,
    response: &OptimumResponse,
    delta: f64,
) -> Option<(f64, Event)> {
    let active_set = ActiveSet::new(solution, domain);
    variable_margins(solution, domain, response, &active_set)
        .into_iter()
        .chain(constraint_margins(solution, domain, response, &active_set))
        .filter_map(|margin| Some((margin.fraction_to_zero(delta)?, margin.event)))
        .min_by(|a, b| a.0.total_cmp(&b.0))
}

/// A quantity that changes the active set when it falls to 0: the distance of a value from its
/// limit, or the absolute value of a multiplier.
struct Margin {
    distance: f64,
    /// Derivative of the distance by the parameter.
    rate: f64,
    event: Event,
}

impl Margin {
    /// Fraction of the parameter change `delta` after which `distance` is 0, to first order; `None`
    /// if `distance` stays positive.
    fn fraction_to_zero(&self, delta: f64) -> Option<f64> {
        let reduction = -self.rate * delta;
        let is_used_up = reduction > 0.0 && self.distance.is_finite() && self.distance <= reduction;
        is_used_up.then(|| self.distance.max(0.0) / reduction)
    }
}

/// Margins of the variables: the multiplier of an active bound; for any other variable, the
/// distances from its two bounds.
fn variable_margins(
    solution: &Solution,
    domain: &Domain,
    response: &OptimumResponse,
    active_set: &ActiveSet,
) -> Vec<Margin> {
    let mut margins = vec![];
    for i in (0..solution.x.len()).filter(|&i| !domain.variables.is_fixed(i)) {
        if active_set.variables[i] {
            let (lower, upper) = (solution.lower_multipliers[i], solution.upper_multipliers[i]);
            let (distance, rate) = if lower > 0.0 {
                (lower, response.slopes[i])
            } else {
                (upper, -response.slopes[i])
            };
            margins.push(Margin {
                distance,
                rate,
                event: Event::BoundLeft(i, lower > 0.0),
            });
        } else {
            let reached = |is_lower| Event::BoundReached(i, is_lower);
            let value = (solution.x[i], response.x[i]);
            margins.extend(limit_margins(&domain.variables, i, value, reached));
        }
    }
    margins
}

/// Margins of the constraints: the multiplier of an active constraint; for any other constraint,
/// the distances from its two limits.
fn constraint_margins(
    solution: &Solution,
    domain: &Domain,
    response: &OptimumResponse,
    active_set: &ActiveSet,
) -> Vec<Margin> {
    let mut margins = vec![];
    for (j, constraint) in solution.constraints.iter().enumerate() {
        if domain.constraints.is_fixed(j) {
            continue;
        }
        if active_set.constraints[j] {
            let sign = constraint.multiplier.signum();
            margins.push(Margin {
                distance: constraint.multiplier.abs(),
                rate: sign * response.multipliers[j],
                event: Event::LimitLeft(j, sign < 0.0),
            });
        } else {
            let reached = |is_lower| Event::LimitReached(j, is_lower);
            let value = (constraint.value, response.constraints[j]);
            margins.extend(limit_margins(&domain.constraints, j, value, reached));
        }
    }
    margins
}

/// Margins between a value and its two limits, from the value and its derivative.
fn limit_margins(
    limits: &Bounds,
    i: usize,
    (value, derivative): (f64, f64),
    event: impl Fn(bool) -> Event,
) -> [Margin; 2] {
    [
        Margin {
            distance: value - limits.low[i],
            rate: derivative,
            event: event(true),
        },
        Margin {
            distance: limits.high[i] - value,
            rate: -derivative,
            event: event(false),
        },
    ]
}
