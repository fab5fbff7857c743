//! Flatness of an optimum: how far each varied parameter can move within a stated loss.

use super::goal::Constraint;
use super::optimum::Optimum;
use crate::derivative::Evaluator;
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::json::{number, numbers_by_name};
use crate::optimize::Domain;
use crate::optimize::sensitivity::{ActiveSet, reduced_hessian, smooth_variables};
use crate::parameters::Parameter;
use crate::statistics::extent;
use crate::units::{DisplayUnit, Quantity, YARD};
use argmin::core::{CostFunction, Executor, State};
use argmin::solver::brent::BrentRoot;
use nalgebra::DMatrix;
use serde::{Serialize, Serializer};

/// Ranges of the varied parameters around an optimum, within a stated loss.
#[derive(Clone, Debug)]
pub struct Flatness {
    /// The allowed loss of the outcome, SI.
    pub loss: f64,
    /// Window of each varied parameter: its interval within the allowed loss, with all other
    /// parameters fixed at the optimum.
    pub windows: Vec<Window>,
    /// Directions in the space of the free parameters, in ascending order of curvature.
    pub directions: Vec<Direction>,
    /// Ellipse of the allowed loss for each pair of free parameters, by the quadratic model of the
    /// outcome. Empty if a constraint is active: the gradient of the outcome is then not 0, and a
    /// contour of the loss is not an ellipse.
    pub ellipses: Vec<Ellipse>,
}

/// The range in which a parameter can vary alone and lose at most the stated loss.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "WindowReport"))]
pub struct Window {
    /// Lower end, SI.
    pub low: f64,
    /// Upper end, SI.
    pub high: f64,
    /// The reason for the lower end: `loss`, `bound`, `no flight`, or a constraint.
    #[cfg_attr(test, schemars(with = "String"))]
    pub low_limit: WindowLimit,
    /// The reason for the upper end.
    #[cfg_attr(test, schemars(with = "String"))]
    pub high_limit: WindowLimit,
}

/// The reason for the end of a window.
#[derive(Clone, Debug, PartialEq)]
pub enum WindowLimit {
    /// The allowed loss.
    Loss,
    /// A bound of the search.
    Bound,
    /// A constraint of the search.
    Constraint(Box<Constraint>),
    /// The ball does not fly beyond this end.
    NoFlight,
}

impl WindowLimit {
    /// The name in JSON: `loss`, `bound`, `no flight`, or the text of the constraint.
    pub fn name(&self) -> &str {
        match self {
            Self::Loss => "loss",
            Self::Bound => "bound",
            Self::Constraint(constraint) => &constraint.expression,
            Self::NoFlight => "no flight",
        }
    }
}

/// Serialized as its name.
impl Serialize for WindowLimit {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// A direction in the space of the free parameters.
// an eigenvector of the reduced Hessian, of length 1 if parameters are in units of their ranges
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "DirectionReport"))]
pub struct Direction {
    /// The components of the direction, by parameter.
    #[serde(serialize_with = "numbers_by_name")]
    #[cfg_attr(
        test,
        schemars(with = "std::collections::BTreeMap<String, crate::json::JsonNumber>")
    )]
    pub along: Vec<(&'static Parameter, f64)>,
    /// The size of the step along the direction at which the quadratic model has the stated loss.
    /// It is a multiple of the direction.
    #[serde(serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub reach: f64,
    /// The losses of drives computed at plus and minus `reach` times the direction, SI.
    // `None` outside of the ranges, and for a drive that does not fly
    pub losses: [Option<f64>; 2],
}

/// The ellipse in two parameters on which the quadratic model has the stated loss.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "FlatEllipseReport"))]
pub struct Ellipse {
    /// The parameters.
    pub parameters: [&'static Parameter; 2],
    /// The half-axes, each as changes of the two parameters, SI; the longer half-axis comes first.
    // lengths are compared in units of the parameters' ranges
    pub half_axes: [[f64; 2]; 2],
    /// The smallest and the largest loss of drives computed on the ellipse, SI.
    // only drives that meet the ranges and constraints count
    pub losses: Option<(f64, f64)>,
}

/// Note on the allowed loss of a [short drive](short_drive).
const OF_SHORT_DRIVE: &str = "1 yd is more than a tenth of the carry of the best drive, so the \
                              loss that is allowed is 1 % of this carry";

/// Carry of the best drive, SI, with a note, if this drive is short: its carry is below 10 yd. Its
/// [`default_loss`] is then 1 % of the carry. `None` for any other drive, and if the goal is no
/// length.
pub fn short_drive(best: &Optimum) -> Option<(f64, &'static str)> {
    let carry = best
        .drive
        .as_ref()
        .and_then(|drive| Outcome::CarryDistance.value(drive))?;
    let is_short = best.search.of.quantity == Quantity::LENGTH && YARD > 0.1 * carry && carry > 0.0;
    is_short.then_some((carry, OF_SHORT_DRIVE))
}

/// The default allowed loss, SI. For a distance: 1 yd, or 1 % of the carry for a [short
/// drive](short_drive). For any other quantity: 1 % of the value.
pub fn default_loss(best: &Optimum) -> f64 {
    match best.search.of.quantity {
        Quantity::LENGTH => short_drive(best).map_or(YARD, |(carry, _)| 0.01 * carry),
        _ => {
            0.01 * best
                .value()
                .unwrap_or_default()
                .abs()
                .max(f64::MIN_POSITIVE)
        }
    }
}

/// Number of drives computed on each ellipse.
const AROUND: usize = 24;

/// The flatness of an optimum for a stated loss of the outcome, SI.
///
/// # Errors
/// The errors of [`windows`].
pub fn flatness(best: &Optimum, loss: f64) -> Result<Flatness> {
    let around = LossAround::new(best, loss)?;
    Ok(Flatness {
        loss,
        windows: around.windows()?,
        directions: around.directions(),
        ellipses: around.ellipses(),
    })
}

/// The window of each varied parameter for a stated loss of the outcome, SI.
///
/// # Errors
/// [`Error::NotConverged`] without a converged optimum; [`Error::Optimizer`] for a loss that is not
/// above 0 and finite; [`Error::Unreadable`] for a search over swings.
pub fn windows(best: &Optimum, loss: f64) -> Result<Vec<Window>> {
    LossAround::new(best, loss)?.windows()
}

/// # Errors
/// [`Error::Optimizer`] for a loss that is not above 0 and finite.
pub(super) fn check_loss(best: &Optimum, loss: f64) -> Result<()> {
    if loss > 0.0 && loss.is_finite() {
        return Ok(());
    }
    let shown = DisplayUnit::from(&best.search.of).show(loss);
    Err(Error::Optimizer(format!(
        "the allowed loss is {shown}; it must be finite and above 0"
    )))
}

/// Computes the losses of drives around an optimum.
struct LossAround<'a> {
    domain: Domain,
    values: Evaluator,
    best: &'a Optimum,
    loss: f64,
}

impl<'a> LossAround<'a> {
    fn new(best: &'a Optimum, loss: f64) -> Result<Self> {
        check_loss(best, loss)?;
        let problem = best.problem()?;
        Ok(Self {
            values: problem.evaluator()?,
            domain: problem.domain,
            best,
            loss,
        })
    }

    fn windows(&self) -> Result<Vec<Window>> {
        let bounds = &self.domain.variables;
        let mut windows = vec![];
        for i in 0..self.best.search.vary.len() {
            let (low, low_limit) = self.end(i, bounds.low[i])?;
            let (high, high_limit) = self.end(i, bounds.high[i])?;
            windows.push(Window {
                low,
                high,
                low_limit,
                high_limit,
            });
        }
        Ok(windows)
    }

    /// The loss at a point, or the index of a constraint that the point violates; `None` for a
    /// drive that does not fly.
    fn lost_at(&self, x: &[f64]) -> Option<Result<f64, usize>> {
        let values: Vec<f64> = self
            .values
            .at(x)
            .ok()?
            .into_iter()
            .map(|taylor| taylor.value)
            .collect();
        let limits = &self.domain.constraints;
        let excess = |j: usize| limits.excess(j, values[j + 1]).abs();
        // an active constraint is satisfied at the optimum only up to rounding
        let rounding = |j: usize| 1e-9 * (1.0 + self.best.solution.constraints[j].value.abs());
        let broken = (0..limits.dimension()).find(|&j| excess(j) > rounding(j));
        Some(match broken {
            Some(j) => Err(j),
            None => {
                Ok(self.best.search.sense.sign()
                    * (values[0] - self.best.value().unwrap_or_default()))
            }
        })
    }

    fn moved(&self, i: usize, to: f64) -> Vec<f64> {
        let mut x = self.best.solution.x.clone();
        x[i] = to;
        x
    }

    /// The end of the window of variable i towards a bound.
    fn end(&self, i: usize, bound: f64) -> Result<(f64, WindowLimit)> {
        let from = self.best.solution.x[i];
        let width = bound - from;
        if width == 0.0 {
            return Ok((from, WindowLimit::Bound));
        }
        let is_within = |part: f64| match self.lost_at(&self.moved(i, from + part * width)) {
            None => Err(WindowLimit::NoFlight),
            Some(Err(j)) => {
                let constraint = self.best.search.subject_to[j].clone();
                Err(WindowLimit::Constraint(Box::new(constraint)))
            }
            Some(Ok(lost)) if lost > self.loss => Err(WindowLimit::Loss),
            Some(Ok(_)) => Ok(()),
        };
        // search outward from a small step, to find the end next to the optimum
        let mut inside = 0.0;
        let mut part: f64 = 1.0 / 1024.0;
        let (mut outside, mut limit) = loop {
            match is_within(part) {
                Err(limit) => break (part, limit),
                Ok(()) if part >= 1.0 => return Ok((bound, WindowLimit::Bound)),
                Ok(()) => inside = part,
            }
            part = (part * 1.25).min(1.0);
        };
        // bisect: at a constraint, or where the ball no longer flies, there is no root of a smooth
        // function
        while limit != WindowLimit::Loss && outside - inside > 1e-12 {
            let middle = 0.5 * (inside + outside);
            match is_within(middle) {
                Ok(()) => inside = middle,
                Err(other) => (outside, limit) = (middle, other),
            }
        }
        if limit != WindowLimit::Loss {
            return Ok((from + inside * width, limit));
        }
        let part = self.crossing(i, from, width, inside, outside)?;
        Ok((from + part * width, WindowLimit::Loss))
    }

    /// The point at which the loss equals the allowed loss, as a fraction of the distance to a
    /// bound.
    fn crossing(&self, i: usize, from: f64, width: f64, inside: f64, outside: f64) -> Result<f64> {
        let search = BrentRoot::new(inside, outside, 1e-13);
        let found = Executor::new(
            Excess {
                around: self,
                i,
                from,
                width,
            },
            search,
        )
        .configure(|state| state.max_iters(200))
        .run()
        .map_err(|e| Error::Optimizer(e.to_string()))?;
        Ok(found.state.get_best_param().copied().unwrap_or(inside))
    }

    fn directions(&self) -> Vec<Direction> {
        let solution = &self.best.solution;
        let scale = self.domain.variables.scale(&solution.x);
        let (basis, reduced) = reduced_hessian(solution, &self.domain);
        if basis.ncols() == 0 {
            return vec![];
        }
        let reduced = reduced.symmetric_eigen();
        let mut order: Vec<usize> = (0..basis.ncols()).collect();
        order.sort_by(|a, b| reduced.eigenvalues[*a].total_cmp(&reduced.eigenvalues[*b]));
        let one = |k: usize| {
            let unit = &basis * reduced.eigenvectors.column(k);
            let along: Vec<f64> = unit.iter().zip(&scale).map(|(u, s)| u * s).collect();
            let curvature = reduced.eigenvalues[k];
            let reach = if curvature > 0.0 {
                (2.0 * self.loss / curvature).sqrt()
            } else {
                f64::INFINITY
            };
            let losses = [reach, -reach].map(|reach| {
                let x: Vec<f64> = solution
                    .x
                    .iter()
                    .zip(&along)
                    .map(|(x, a)| x + reach * a)
                    .collect();
                self.lost_within(&x)
            });
            Direction {
                along: self.best.search.parameters().zip(along).collect(),
                reach,
                losses,
            }
        };
        order.into_iter().map(one).collect()
    }

    /// The loss at a point. `None` if the point violates a range or constraint, or if its drive
    /// does not fly.
    fn lost_within(&self, x: &[f64]) -> Option<f64> {
        let bounds = &self.domain.variables;
        let is_within = x
            .iter()
            .enumerate()
            .all(|(i, x)| x.is_finite() && bounds.excess(i, *x) == 0.0);
        if is_within {
            self.lost_at(x)?.ok()
        } else {
            None
        }
    }

    fn ellipses(&self) -> Vec<Ellipse> {
        let held = ActiveSet::new(&self.best.solution, &self.domain);
        if !held.active_constraints().is_empty() {
            return vec![];
        }
        let free = smooth_variables(&self.best.solution, &self.domain);
        let pairs = (0..free.len()).flat_map(|b| (0..b).map(move |a| (a, b)));
        pairs
            .filter_map(|(a, b)| self.ellipse([free[a], free[b]]))
            .collect()
    }

    /// The ellipse of the two parameters `pair`. `None` if the outcome does not become worse along
    /// every direction of the two parameters, or on overflow.
    fn ellipse(&self, pair: [usize; 2]) -> Option<Ellipse> {
        let solution = &self.best.solution;
        let scale = self.domain.variables.scale(&solution.x);
        let block = DMatrix::from_fn(2, 2, |r, c| {
            solution.hessian[pair[r]][pair[c]] * scale[pair[r]] * scale[pair[c]]
        });
        let block = block.symmetric_eigen();
        let mut order = [0, 1];
        order.sort_by(|x, y| block.eigenvalues[*x].total_cmp(&block.eigenvalues[*y]));
        if block.eigenvalues.min() <= 0.0 {
            return None;
        }
        let half_axes = order.map(|k| {
            let reach = (2.0 * self.loss / block.eigenvalues[k]).sqrt();
            [0, 1].map(|row| reach * block.eigenvectors[(row, k)] * scale[pair[row]])
        });
        // the half-axes overflow for a very large loss or a very small curvature
        if !half_axes.as_flattened().iter().all(|part| part.is_finite()) {
            return None;
        }
        let around = (0..AROUND).filter_map(|step| {
            let (sin, cos) = (std::f64::consts::TAU * step as f64 / AROUND as f64).sin_cos();
            let mut x = solution.x.clone();
            for row in 0..2 {
                x[pair[row]] += cos * half_axes[0][row] + sin * half_axes[1][row];
            }
            self.lost_within(&x)
        });
        let losses: Vec<f64> = around.collect();
        let losses = (!losses.is_empty()).then(|| extent(losses).into());
        Some(Ellipse {
            parameters: pair.map(|i| self.best.search.vary[i].parameter),
            half_axes,
            losses,
        })
    }
}

/// Loss minus allowed loss. The variable is the fraction of the distance to a bound.
struct Excess<'a> {
    around: &'a LossAround<'a>,
    i: usize,
    from: f64,
    width: f64,
}

impl CostFunction for Excess<'_> {
    type Param = f64;
    type Output = f64;

    fn cost(&self, part: &f64) -> std::result::Result<f64, argmin::core::Error> {
        match self
            .around
            .lost_at(&self.around.moved(self.i, self.from + part * self.width))
        {
            Some(Ok(lost)) => Ok(lost - self.around.loss),
            _ => Err(argmin::core::Error::msg(
                "no flight between two drives that fly",
            )),
        }
    }
}
