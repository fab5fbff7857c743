use super::domain::Domain;
use super::problem::Evaluation;
use crate::number::Taylor;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// A point with what is known of the functions there.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Point {
    pub x: Vec<f64>,
    pub f: Evaluation,
}

impl Point {
    /// Whether it is one of `n` variables, with `m` constraints.
    pub fn is_of(&self, n: usize, m: usize) -> bool {
        self.x.len() == n && self.f.is_of(n, m)
    }

    /// The gradient of the Lagrangian; without constraints that of the objective, as it is.
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

/// What a search measures with: the domain, what a sensible change of each variable is, and what
/// sensible sizes of the functions are.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Scaling {
    #[serde(skip)]
    pub domain: Domain,
    /// sᵢ.
    pub scale: Vec<f64>,
    /// γⱼ: what constraint j changes by for a sensible change of the variables, at the start.
    pub gamma: Vec<f64>,
    /// φ at the start.
    pub first_size: f64,
}

/// How far a point is from meeting the KKT conditions, relative.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Residual {
    /// maxᵢ sᵢ |pᵢ|/φ with p the gradient of the Lagrangian, projected on the bounds.
    pub stationarity: f64,
    /// maxⱼ vⱼ/γⱼ with vⱼ what constraint j is violated by.
    pub feasibility: f64,
    /// maxⱼ |λⱼ| × the distance from the limit that λⱼ belongs to, /φ.
    pub complementarity: f64,
}

impl Residual {
    /// The largest of the three.
    pub fn largest(self) -> f64 {
        self.stationarity
            .max(self.feasibility)
            .max(self.complementarity)
    }
}

/// The variable in which, measured by how far it has come, the Lagrangian falls most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Outward {
    /// The variable.
    pub variable: usize,
    /// Where it is.
    pub at: f64,
    /// Its distance from 0, in units of its scale.
    pub reach: f64,
    /// What the Lagrangian would fall by, to first order and relative to φ, if it moved by its
    /// distance from 0 (or to its bound, if that is nearer).
    pub rate: f64,
    /// Whether that leads further out, with no bound ahead.
    pub is_open: bool,
}

impl Scaling {
    /// The scaling of a search that begins at `first`.
    pub fn new(domain: Domain, scale: Vec<f64>, first: &Point) -> Self {
        let largest = |gradient: &[f64]| {
            gradient
                .iter()
                .zip(&scale)
                .map(|(g, s)| (g * s).abs())
                .fold(0.0, f64::max)
        };
        let first_size = first
            .f
            .objective
            .value
            .abs()
            .max(largest(&first.f.objective.gradient));
        let gamma = |j: usize| {
            let constraint = &first.f.constraints[j];
            let change = largest(&constraint.gradient)
                .max(domain.constraints.excess(j, constraint.value).abs());
            if change > 0.0 { change } else { 1.0 }
        };
        let gamma = (0..first.f.constraints.len()).map(gamma).collect();
        Self {
            scale,
            gamma,
            first_size: first_size.max(f64::MIN_POSITIVE),
            domain,
        }
    }

    /// φ: what the objective is measured by at a point. |f|, or, where that vanishes, 1 or the size
    /// it had at the start if that was less.
    pub fn size(&self, at: &Point) -> f64 {
        at.f.objective.value.abs().max(self.first_size.min(1.0))
    }

    /// A slope of the Lagrangian as projected: its component where a move inside the bounds can use
    /// it, 0 elsewhere.
    fn projected(&self, at: &Point, slope: f64, i: usize) -> f64 {
        let bounds = &self.domain.variables;
        match slope {
            _ if bounds.is_fixed(i) => 0.0,
            slope if slope > 0.0 && at.x[i] <= bounds.low[i] => 0.0,
            slope if slope < 0.0 && at.x[i] >= bounds.high[i] => 0.0,
            slope => slope,
        }
    }

    /// The variable with the largest [rate](Outward::rate), with these slopes of the Lagrangian;
    /// `None` where nothing falls.
    pub fn outward(&self, at: &Point, slopes: &[f64]) -> Option<Outward> {
        let bounds = &self.domain.variables;
        let of = |variable: usize| {
            let (x, slope) = (
                at.x[variable],
                self.projected(at, slopes[variable], variable),
            );
            let room = if slope > 0.0 {
                x - bounds.low[variable]
            } else {
                bounds.high[variable] - x
            };
            let rate = slope.abs() * x.abs().min(room) / self.size(at);
            let reach = x.abs() / self.scale[variable];
            Outward {
                variable,
                at: x,
                reach,
                rate,
                is_open: slope * x < 0.0 && room.is_infinite(),
            }
        };
        (0..at.x.len())
            .map(of)
            .filter(|far| far.rate > 0.0)
            .max_by(|a, b| a.rate.total_cmp(&b.rate))
    }

    /// How far a point is from optimal with these multipliers.
    pub fn residual(&self, at: &Point, multipliers: &[f64]) -> Residual {
        self.residual_of_slopes(at, multipliers, &at.lagrangian_gradient(multipliers))
    }

    /// As [`residual`](Self::residual), where the slopes of the Lagrangian are known.
    pub fn residual_of_slopes(&self, at: &Point, multipliers: &[f64], slopes: &[f64]) -> Residual {
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
                // at a rounding's distance from an infinite limit there is no such multiplier
                _ if *multiplier == 0.0 => 0.0,
                _ if limit.is_infinite() => f64::INFINITY,
                // what is violated counts as that, not twice
                _ => {
                    (multiplier * (value - limit)).abs() / size
                        * f64::from(limits.excess(j, value) == 0.0)
                }
            }
        };
        let projected = slopes
            .iter()
            .enumerate()
            .map(|(i, slope)| self.projected(at, *slope, i));
        Residual {
            stationarity: self.largest(projected) / size,
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

    /// Whether a constraint would reach a limit if the point moved on along its direction from 0.
    pub fn has_limit_ahead(&self, at: &Point) -> bool {
        /// A change of a constraint smaller than this part of its terms is rounding.
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

    /// Takes the size of a point as φ₀ where value and slopes vanished at the start.
    pub fn floor_size(&mut self, at: &Point) {
        if self.first_size <= f64::MIN_POSITIVE {
            let slope = self.largest(at.f.objective.gradient.iter().copied());
            self.first_size = at.f.objective.value.abs().max(slope).max(f64::MIN_POSITIVE);
        }
    }

    /// A value of variable i, on its bound where only rounding separates them.
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

    /// What each constraint is violated by, in units of γⱼ; below the lower limit < 0.
    pub fn violations<'a>(&'a self, f: &'a Evaluation) -> impl Iterator<Item = f64> + 'a {
        let limits = &self.domain.constraints;
        let excess =
            |(j, constraint): (usize, &Taylor)| limits.excess(j, constraint.value) / self.gamma[j];
        f.constraints.iter().enumerate().map(excess)
    }

    /// The largest component of a gradient, in units of the scale.
    pub fn largest(&self, gradient: impl IntoIterator<Item = f64>) -> f64 {
        gradient
            .into_iter()
            .zip(&self.scale)
            .map(|(p, s)| (p * s).abs())
            .fold(0.0, f64::max)
    }

    /// The distance of two points, in units of the scale.
    pub fn distance(&self, a: &Point, b: &Point) -> f64 {
        let apart =
            a.x.iter()
                .zip(&b.x)
                .zip(&self.scale)
                .map(|((a, b), s)| ((a - b) / s).abs());
        apart.fold(0.0, f64::max)
    }

    /// Variables on a bound towards whose outside the Lagrangian falls.
    pub fn active_bounds<'a>(
        &'a self,
        at: &'a Point,
        multipliers: &[f64],
    ) -> impl Iterator<Item = usize> + 'a {
        let slopes = at.lagrangian_gradient(multipliers);
        let is_active = move |i: &usize| {
            self.is_at_a_bound(at, *i) && self.projected(at, slopes[*i], *i) == 0.0
        };
        (0..at.x.len()).filter(is_active)
    }

    /// Equations, and constraints with multipliers.
    pub fn active_rows<'a>(&'a self, multipliers: &'a [f64]) -> impl Iterator<Item = usize> + 'a {
        let is_active = |j: &usize| multipliers[*j] != 0.0 || self.domain.constraints.is_fixed(*j);
        (0..multipliers.len()).filter(is_active)
    }

    /// Whether a variable lies on one of its bounds.
    pub fn is_at_a_bound(&self, at: &Point, i: usize) -> bool {
        let bounds = &self.domain.variables;
        at.x[i] <= bounds.low[i] || at.x[i] >= bounds.high[i]
    }
}

pub(super) fn norm(a: impl IntoIterator<Item = f64>) -> f64 {
    a.into_iter().map(|a| a * a).sum::<f64>().sqrt()
}
