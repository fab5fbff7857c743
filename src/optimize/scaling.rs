use super::domain::{Domain, scaled_distance};
use super::problem::Evaluation;
use crate::number::Taylor;
use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};
use std::borrow::{Borrow, Cow};

/// A point with the functions and their derivatives there.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct EvaluatedPoint {
    pub x: Vec<f64>,
    pub f: Evaluation,
}

impl EvaluatedPoint {
    /// True if the dimensions fit `n` variables and `m` constraints.
    pub fn has_dimensions(&self, n: usize, m: usize) -> bool {
        self.x.len() == n && self.f.check_dimensions(n, m).is_ok()
    }

    /// Gradient of the Lagrangian; borrowed from the objective if there are no constraints.
    pub fn lagrangian_gradient(&self, multipliers: &[f64]) -> Cow<'_, [f64]> {
        if multipliers.is_empty() {
            return Cow::Borrowed(&self.f.objective.gradient);
        }
        let mut sum = self.f.objective.gradient.clone();
        for (constraint, m) in self.f.constraints.iter().zip(multipliers) {
            sum.iter_mut()
                .zip(&constraint.gradient)
                .for_each(|(sum, slope)| *sum += m * slope);
        }
        Cow::Owned(sum)
    }
}

/// Domain of a search, with the scales of variables, objective and constraints.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Scaling {
    #[serde(skip)]
    pub domain: Domain,
    /// Scale sᵢ of each variable ([`Bounds::scale`](super::Bounds::scale)).
    pub scale: Vec<f64>,
    /// Scale γⱼ of each constraint: the larger of its violation and its largest scaled derivative,
    /// at the start; 1 if both are 0.
    pub gamma: Vec<f64>,
    /// Size φ₀ of the objective at the start: the larger of |f| and the largest scaled derivative
    /// of f.
    pub initial_size: f64,
}

/// Relative residuals of the KKT conditions. [`status`](super::status) defines the scales sᵢ, γⱼ
/// and φ.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct KktResidual {
    /// Stationarity maxᵢ sᵢ |pᵢ|/φ, with p the gradient of the Lagrangian projected on the bounds.
    pub stationarity: f64,
    /// Feasibility maxⱼ |vⱼ|/γⱼ, with vⱼ the violation of constraint j.
    pub feasibility: f64,
    /// Complementarity maxⱼ |λⱼ| dⱼ/φ, with dⱼ the distance of cⱼ from the limit with multiplier
    /// λⱼ.
    pub complementarity: f64,
}

impl KktResidual {
    /// The largest of the three residuals.
    pub fn largest(self) -> f64 {
        self.stationarity
            .max(self.feasibility)
            .max(self.complementarity)
    }
}

/// The variable with the largest [rate](Outward::rate). If this variable is far from 0 and its rate
/// is large, it diverges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Outward {
    /// Index of the variable.
    pub variable: usize,
    /// Value of the variable.
    pub at: f64,
    /// Distance from 0, in units of the variable's scale.
    pub distance: f64,
    /// First-order reduction of the Lagrangian if the variable moves by |x|, or to a nearer bound,
    /// divided by the size φ of the objective.
    pub rate: f64,
    /// True if the Lagrangian falls as the variable moves away from 0, and no bound lies ahead.
    pub is_open: bool,
}

/// Largest scaled component |gᵢ sᵢ| of a gradient.
pub(super) fn largest_scaled(
    gradient: impl IntoIterator<Item = impl Borrow<f64>>,
    scale: &[f64],
) -> f64 {
    gradient
        .into_iter()
        .zip(scale)
        .map(|(g, s)| (g.borrow() * s).abs())
        .fold(0.0, f64::max)
}

/// Threshold for multipliers, relative to the size of the objective. Smaller multipliers count as
/// zero.
pub(super) const ZERO_MULTIPLIER: f64 = 1e-9;

/// Size of the objective and its slopes: the larger of |f| and the largest scaled derivative.
pub(super) fn objective_size(value: f64, gradient: &[f64], scale: &[f64]) -> f64 {
    largest_scaled(gradient, scale).max(value.abs())
}

/// Second derivatives by the scaled variables.
pub(super) fn scaled_hessian(hessian: &[Vec<f64>], scale: &[f64]) -> DMatrix<f64> {
    DMatrix::from_fn(scale.len(), scale.len(), |i, k| {
        hessian[i][k] * scale[i] * scale[k]
    })
}

impl Scaling {
    /// Scaling of a search that starts at `first`.
    pub fn new(domain: Domain, scale: Vec<f64>, first: &EvaluatedPoint) -> Self {
        let objective = &first.f.objective;
        let initial_size = objective_size(objective.value, &objective.gradient, &scale);
        let gamma = |j: usize| {
            let constraint = &first.f.constraints[j];
            let change = largest_scaled(&constraint.gradient, &scale)
                .max(domain.constraints.excess(j, constraint.value).abs());
            if change > 0.0 { change } else { 1.0 }
        };
        let gamma = (0..first.f.constraints.len()).map(gamma).collect();
        Self {
            scale,
            gamma,
            initial_size: initial_size.max(f64::MIN_POSITIVE),
            domain,
        }
    }

    /// Gradient of constraint j by the scaled variables, divided by the constraint's scale γⱼ.
    pub fn normal(&self, at: &EvaluatedPoint, j: usize) -> impl Iterator<Item = f64> {
        let slopes = at.f.constraints[j].gradient.iter().zip(&self.scale);
        slopes.map(move |(slope, scale)| slope * scale / self.gamma[j])
    }

    /// Converts second derivatives by the variables to second derivatives by the scaled variables.
    pub fn scale_hessian(&self, hessian: &mut DMatrix<f64>) {
        let columns = hessian.as_mut_slice().chunks_exact_mut(self.scale.len());
        for (column, own) in columns.zip(&self.scale) {
            column
                .iter_mut()
                .zip(&self.scale)
                .for_each(|(entry, scale)| *entry *= scale * own);
        }
    }

    /// Size φ of the objective at a point: |f|, but at least min(1, φ₀).
    pub fn size(&self, at: &EvaluatedPoint) -> f64 {
        at.f.objective.value.abs().max(self.initial_size.min(1.0))
    }

    /// The derivative `slope` of the Lagrangian by variable i, projected on the bounds: 0 if a
    /// bound blocks descent.
    fn projected(&self, at: &EvaluatedPoint, slope: f64, i: usize) -> f64 {
        let bounds = &self.domain.variables;
        match slope {
            _ if bounds.is_fixed(i) => 0.0,
            slope if slope > 0.0 && at.x[i] <= bounds.low[i] => 0.0,
            slope if slope < 0.0 && at.x[i] >= bounds.high[i] => 0.0,
            slope => slope,
        }
    }

    /// The variable with the largest [rate](Outward::rate), given the gradient of the Lagrangian.
    /// `None` if all rates are 0, as at a stationary point.
    pub fn outward(&self, at: &EvaluatedPoint, gradient: &[f64]) -> Option<Outward> {
        let bounds = &self.domain.variables;
        let of = |variable: usize| {
            let (x, slope) = (
                at.x[variable],
                self.projected(at, gradient[variable], variable),
            );
            let distance_to_bound = if slope > 0.0 {
                x - bounds.low[variable]
            } else {
                bounds.high[variable] - x
            };
            let rate = slope.abs() * x.abs().min(distance_to_bound) / self.size(at);
            let distance = x.abs() / self.scale[variable];
            Outward {
                variable,
                at: x,
                distance,
                rate,
                is_open: slope * x < 0.0 && distance_to_bound.is_infinite(),
            }
        };
        (0..at.x.len())
            .map(of)
            .filter(|far| far.rate > 0.0)
            .max_by(|a, b| a.rate.total_cmp(&b.rate))
    }

    /// KKT residual at a point with these multipliers.
    pub fn residual(&self, at: &EvaluatedPoint, multipliers: &[f64]) -> KktResidual {
        self.residual_from_gradient(at, multipliers, &at.lagrangian_gradient(multipliers))
    }

    /// KKT residual from a known gradient of the Lagrangian.
    pub fn residual_from_gradient(
        &self,
        at: &EvaluatedPoint,
        multipliers: &[f64],
        gradient: &[f64],
    ) -> KktResidual {
        let size = self.size(at);
        let limits = &self.domain.constraints;
        let distance = |(j, multiplier): (usize, &f64)| {
            let value = at.f.constraints[j].value;
            let limit = if *multiplier > 0.0 {
                limits.high[j]
            } else {
                limits.low[j]
            };
            match multiplier {
                _ if *multiplier == 0.0 => 0.0,
                // an infinite limit is never active: a nonzero multiplier is an error
                _ if limit.is_infinite() => f64::INFINITY,
                // a violated constraint counts in `feasibility` only
                _ => {
                    (multiplier * (value - limit)).abs() / size
                        * f64::from(limits.excess(j, value) == 0.0)
                }
            }
        };
        let projected = gradient
            .iter()
            .enumerate()
            .map(|(i, slope)| self.projected(at, *slope, i));
        KktResidual {
            stationarity: largest_scaled(projected, &self.scale) / size,
            feasibility: self
                .violations(&at.f)
                .fold(0.0, |most, v| v.abs().max(most)),
            complementarity: multipliers
                .iter()
                .enumerate()
                .map(distance)
                .fold(0.0, f64::max),
        }
    }

    /// True if a constraint has a finite limit ahead, to first order, for a point that moves from x
    /// away from 0, along the ray from 0 through x.
    pub fn has_limit_ahead(&self, at: &EvaluatedPoint) -> bool {
        /// Rounding error of a constraint's change, relative to the sum of the absolute values of
        /// its terms.
        const ROUNDING: f64 = 1e-9;
        let limits = &self.domain.constraints;
        at.f.constraints.iter().enumerate().any(|(j, constraint)| {
            let terms = constraint
                .gradient
                .iter()
                .zip(&at.x)
                .map(|(slope, x)| slope * x);
            let (change, size) = terms.fold((0.0, 0.0), |(sum, size), term| {
                (sum + term, size + term.abs())
            });
            change.abs() > ROUNDING * size
                && (change > 0.0 && limits.high[j].is_finite()
                    || change < 0.0 && limits.low[j].is_finite())
        })
    }

    /// Sets φ₀ at a later point if the value and the gradient of f were 0 at the start.
    pub fn floor_size(&mut self, at: &EvaluatedPoint) {
        if self.initial_size <= f64::MIN_POSITIVE {
            let objective = &at.f.objective;
            let size = objective_size(objective.value, &objective.gradient, &self.scale);
            self.initial_size = size.max(f64::MIN_POSITIVE);
        }
    }

    /// Returns the bound of variable i if `x` differs from it by rounding only; otherwise `x`.
    pub fn on_bound(&self, i: usize, x: f64) -> f64 {
        let (low, high) = (self.domain.variables.low[i], self.domain.variables.high[i]);
        let rounding = 4.0 * f64::EPSILON * self.scale[i].min(high - low);
        if x - low <= rounding {
            low
        } else if high - x <= rounding {
            high
        } else {
            x
        }
    }

    /// Signed violation of each constraint, in units of γⱼ: > 0 above the upper limit, < 0 below
    /// the lower limit.
    pub fn violations<'a>(&'a self, f: &'a Evaluation) -> impl Iterator<Item = f64> + 'a {
        let limits = &self.domain.constraints;
        let excess =
            |(j, constraint): (usize, &Taylor)| limits.excess(j, constraint.value) / self.gamma[j];
        f.constraints.iter().enumerate().map(excess)
    }

    /// Distance of two points in the maximum norm, in units of the scale.
    pub fn distance(&self, a: &EvaluatedPoint, b: &EvaluatedPoint) -> f64 {
        scaled_distance(&a.x, &b.x, &self.scale)
    }

    /// Variables on a bound that blocks descent of the Lagrangian.
    pub fn active_bounds<'a>(
        &'a self,
        at: &'a EvaluatedPoint,
        multipliers: &[f64],
    ) -> impl Iterator<Item = usize> + 'a {
        let gradient = at.lagrangian_gradient(multipliers);
        let is_active = move |i: &usize| {
            self.is_at_a_bound(at, *i) && self.projected(at, gradient[*i], *i) == 0.0
        };
        (0..at.x.len()).filter(is_active)
    }

    /// Equality constraints, and constraints with nonzero multipliers. No threshold is needed: the
    /// exact step of a working set has multipliers 0 for its inactive rows.
    pub fn active_rows<'a>(&'a self, multipliers: &'a [f64]) -> impl Iterator<Item = usize> + 'a {
        let is_active = |j: &usize| multipliers[*j] != 0.0 || self.domain.constraints.is_fixed(*j);
        (0..multipliers.len()).filter(is_active)
    }

    /// True if variable i lies on one of its bounds.
    pub fn is_at_a_bound(&self, at: &EvaluatedPoint, i: usize) -> bool {
        let bounds = &self.domain.variables;
        at.x[i] <= bounds.low[i] || at.x[i] >= bounds.high[i]
    }
}

pub(super) fn norm(a: impl IntoIterator<Item = f64>) -> f64 {
    a.into_iter().map(|a| a * a).sum::<f64>().sqrt()
}
