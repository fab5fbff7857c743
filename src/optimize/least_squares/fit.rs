//! The loop: a step, the gain ratio, the damping, the verdict.

use super::super::domain::Domain;
use super::super::qp::QpSolver;
use super::step::Point;
use super::{Options, Residuals, Rows};
use crate::error::{Error, Result};
use crate::units::counted;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// First damping, relative to the scaled columns, whose length is 1 (Madsen, Nielsen & Tingleff
/// 2004, eq. 3.14: τ between 1e-6 for a start that is good and 1 for one that is not).
const FIRST_DAMPING: f64 = 1e-3;
/// A gain that the residuals' rounding hides, relative to F.
const NOISE: f64 = 1e-15;
/// Damping at which a step is no longer one.
const MOST_DAMPING: f64 = 1e20;
/// Least damping. The model's curvature JᵀJ is known to about 1e-16 of the scaled columns: with
/// less damping, directions in which the residuals do not change would be walked along by rounding
/// alone.
const LEAST_DAMPING: f64 = 1e-12;
/// A step without damping shorter than this, relative to the point and to the way there, is
/// rounding where no step lowers the sum (Moré 1978, MINPACK's `xtol`; near a sum of 0 the slope
/// says nothing, since the residuals themselves are rounding).
const SHORTEST: f64 = 1e-8;

/// What tells how near a fit is to the lowest sum, in words: 0 where no small change of a parameter
/// changes the sum.
const COSINE: &str = "cosine between the residuals and their slopes";

/// How a fit ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Status {
    /// No direction is left, within the bounds, in which the sum falls.
    Converged,
    /// The sum is at a minimum, but not at one point alone: along some direction the residuals do
    /// not change, or too little to tell. A fit does not look for that; whoever judges its Jacobian
    /// says so.
    Undetermined,
    /// The sum is at a minimum as far as can be told, but one residual is so large that the others
    /// have no say beside it. Said by whoever judges the residuals, as above.
    Outweighed,
    /// The sum is at a minimum, but the residuals are many times larger than they may be: the model
    /// does not describe the data. Said by whoever knows how large they may be.
    Misfit,
    /// No step makes the sum smaller, though the slope is not 0.
    Stalled,
    /// The iterations allowed were used up.
    IterationLimit,
    /// Stopped from outside; the point is the best so far.
    Interrupted,
    /// The residuals are not defined at the start.
    Undefined,
}

impl Status {
    /// The status in a word: `converged`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::Undetermined => "undetermined",
            Self::Outweighed => "outweighed",
            Self::Misfit => "misfit",
            Self::Stalled => "stalled",
            Self::IterationLimit => "iteration-limit",
            Self::Interrupted => "interrupted",
            Self::Undefined => "undefined",
        }
    }
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// What a fit found.
#[derive(Clone, Debug)]
pub struct Fit {
    /// How it ended.
    pub status: Status,
    /// The same in a sentence, with its numbers.
    pub message: String,
    /// The point.
    pub x: Vec<f64>,
    /// Residuals and Jacobian there; empty where they were never defined.
    pub rows: Rows,
    /// F = Σ ρ(rᵢ).
    pub cost: f64,
    /// Iterations taken.
    pub iterations: u64,
    /// Evaluations of the residuals.
    pub evaluations: u64,
    /// Trial points at which the residuals were not defined.
    pub refused: u64,
    /// Why the last of these was refused.
    pub why_refused: Option<String>,
}

/// Who follows a fit.
#[derive(Clone, Default)]
pub struct Follow {
    /// Is shown the number of each iteration and F.
    pub iteration: Option<Arc<dyn Fn(u64, f64) + Send + Sync>>,
    /// Ends the fit, with the best point so far, once it is true: after the evaluation under way,
    /// or within one that [looks at it](super::Residuals::evaluate).
    pub interrupt: Arc<AtomicBool>,
}

impl Follow {
    /// Whether the fit is to end.
    pub fn is_interrupted(&self) -> bool {
        self.interrupt.load(Ordering::Relaxed)
    }
}

/// Fits from a start, which is moved into the bounds first.
///
/// # Errors
/// [`Error::Optimizer`] for a start of the wrong length or that is not finite, for a tolerance or
/// loss that makes no sense, and for a domain with constraints.
pub fn fit(
    residuals: &impl Residuals,
    domain: &Domain,
    start: &[f64],
    options: &Options,
) -> Result<Fit> {
    fit_observed(residuals, domain, start, options, &Follow::default())
}

/// Fits from every start, side by side; what was found, the smallest sum first. The order does not
/// depend on the number of threads. [`starts`](super::super::starts) spreads starts.
///
/// # Errors
/// As [`fit`]; [`Error::Optimizer`] without starts.
pub fn fit_from(
    residuals: &(impl Residuals + Sync),
    domain: &Domain,
    starts: &[Vec<f64>],
    options: &Options,
    follow: &Follow,
) -> Result<Vec<Fit>> {
    if starts.is_empty() {
        return Err(Error::Optimizer("there are no starts to fit from".into()));
    }
    let one = |start: &Vec<f64>| fit_observed(residuals, domain, start, options, follow);
    let mut fits = starts.par_iter().map(one).collect::<Result<Vec<_>>>()?;
    let rank = |fit: &Fit| {
        if fit.rows.residuals.is_empty() {
            f64::INFINITY
        } else {
            fit.cost
        }
    };
    fits.sort_by(|a, b| rank(a).total_cmp(&rank(b)));
    Ok(fits)
}

/// As [`fit`], with those who follow it.
///
/// # Errors
/// As [`fit`].
pub fn fit_observed(
    residuals: &impl Residuals,
    domain: &Domain,
    start: &[f64],
    options: &Options,
    follow: &Follow,
) -> Result<Fit> {
    let bounds = &domain.variables;
    domain.check(start)?;
    if domain.constraints.dimension() > 0 {
        return Err(Error::Optimizer(
            "a fit has bounds alone; give a domain without constraints, or use minimize".into(),
        ));
    }
    if !(options.tolerance > 0.0 && options.tolerance < 1.0) {
        return Err(Error::Optimizer(format!(
            "tolerance = {} is outside its range 0 < … < 1",
            options.tolerance
        )));
    }
    if !(options.rounding >= 0.0 && options.rounding.is_finite()) {
        return Err(Error::Optimizer(format!(
            "rounding = {} is outside its range 0 ≤ … < inf",
            options.rounding
        )));
    }
    if let super::Loss::Huber(k) = options.loss
        && !(k > 0.0 && k.is_finite())
    {
        return Err(Error::Optimizer(format!(
            "Huber's k = {k} is outside its range 0 < … < inf"
        )));
    }
    let start = bounds.project(start);
    let evaluate = |x: Vec<f64>| {
        let rows = residuals.evaluate(&x)?;
        Point::new(x, rows, options.loss)
    };
    let at = match evaluate(start.clone()) {
        Ok(at) => at,
        Err(_) if follow.is_interrupted() => return Ok(not_begun(start)),
        Err(why) => return Ok(nowhere(start, why)),
    };
    let mut search = Search::new(at);
    let (status, message) = loop {
        if let Some(show) = &follow.iteration {
            show(search.iterations, search.at.cost);
        }
        let cosine = search.at.cosine(bounds);
        if let Some(verdict) = search.verdict(cosine, options, follow.is_interrupted()) {
            break verdict;
        }
        if let Some(verdict) =
            search.advance(domain, (cosine, options.tolerance), &evaluate, follow)
        {
            break verdict;
        }
    };
    let Search {
        at,
        iterations,
        evaluations,
        refused,
        why_refused,
        ..
    } = search;
    let Point { x, rows, cost, .. } = at;
    Ok(Fit {
        status,
        message,
        x,
        rows,
        cost,
        iterations,
        evaluations,
        refused,
        why_refused,
    })
}

/// What a fit knows between two iterations.
struct Search {
    at: Point,
    begun_at: Vec<f64>,
    scale: Vec<f64>,
    solver: QpSolver,
    damping: f64,
    growth: f64,
    iterations: u64,
    evaluations: u64,
    refused: u64,
    why_refused: Option<String>,
}

impl Search {
    fn new(at: Point) -> Self {
        let mut scale = vec![0.0; at.x.len()];
        at.lengthen(&mut scale);
        Self {
            begun_at: at.x.clone(),
            solver: QpSolver::from_no_active_bound(at.x.len()),
            at,
            scale,
            damping: FIRST_DAMPING,
            growth: 2.0,
            iterations: 0,
            evaluations: 1,
            refused: 0,
            why_refused: None,
        }
    }

    fn verdict(
        &self,
        cosine: f64,
        options: &Options,
        is_interrupted: bool,
    ) -> Option<(Status, String)> {
        let tolerance = options.tolerance;
        let largest = self
            .at
            .rows
            .residuals
            .iter()
            .fold(0.0, |most: f64, r| most.max(r.abs()));
        if largest <= options.rounding {
            let message =
                format!("every residual is a rounding error: the largest is {largest:.1e}");
            return Some((Status::Converged, message));
        }
        if cosine <= tolerance {
            return Some((
                Status::Converged,
                format!("no small change lowers the sum: {COSINE} {cosine:.1e} <= {tolerance:.0e}"),
            ));
        }
        if is_interrupted {
            return Some(interrupted(cosine, tolerance));
        }
        (self.iterations >= options.max_iterations).then(|| {
            let limit = counted(self.iterations, "iteration");
            let message =
                format!("stopped at the limit of {limit}: {COSINE} {cosine:.1e} > {tolerance:.0e}");
            (Status::IterationLimit, message)
        })
    }

    /// Tries steps until one is kept.
    fn advance(
        &mut self,
        domain: &Domain,
        (cosine, tolerance): (f64, f64),
        evaluate: &impl Fn(Vec<f64>) -> Result<Point, String>,
        follow: &Follow,
    ) -> Option<(Status, String)> {
        self.iterations += 1;
        loop {
            let stalled = |what: &str| {
                let message = format!(
                    "{what}; {COSINE} {cosine:.1e}. Start elsewhere, or fit fewer parameters"
                );
                Some((Status::Stalled, message))
            };
            if self.damping > MOST_DAMPING {
                if let Some(verdict) = self.rounding(domain) {
                    return Some(verdict);
                }
                let why = self
                    .why_refused
                    .as_ref()
                    .map_or(String::new(), |why| format!(" (last refused: {why})"));
                return stalled(&format!("no step makes the sum smaller{why}"));
            }
            let Some((to, promised)) = self.at.step(
                &domain.variables,
                &self.scale,
                self.damping,
                &mut self.solver,
            ) else {
                self.grow();
                continue;
            };
            if promised <= NOISE * self.at.cost || to == self.at.x {
                // what a step without damping could still gain is what tells the end from a
                // standstill
                let undamped = self
                    .at
                    .step(
                        &domain.variables,
                        &self.scale,
                        LEAST_DAMPING,
                        &mut self.solver,
                    )
                    .map_or(0.0, |(_, gain)| gain);
                if undamped <= 1e3 * NOISE * self.at.cost || self.damping <= FIRST_DAMPING {
                    let part = if self.at.cost > 0.0 {
                        undamped / self.at.cost
                    } else {
                        0.0
                    };
                    let message = format!(
                        "the sum of squares is at its smallest: a step could lower it by \
                         {part:.1e} of its value at most, which is less than \
                         its rounding error"
                    );
                    return Some((Status::Converged, message));
                }
                return self.rounding(domain).or_else(|| {
                    stalled(
                        "the next change of what is fitted is too small to tell whether the \
                             sum still falls",
                    )
                });
            }
            self.evaluations += 1;
            match evaluate(to) {
                Ok(next) => {
                    // the gain ratio and the damping that follows it: Nielsen (1999); Madsen,
                    // Nielsen & Tingleff (2004), alg. 3.16
                    let gain = (self.at.cost - next.cost) / promised;
                    if gain > 0.0 {
                        self.damping *= (1.0 - (2.0 * gain - 1.0).powi(3)).max(1.0 / 3.0);
                        self.damping = self.damping.max(LEAST_DAMPING);
                        self.growth = 2.0;
                        next.lengthen(&mut self.scale);
                        self.at = next;
                        return None;
                    }
                }
                Err(_) if follow.is_interrupted() => {
                    // what is not finished is not counted
                    self.iterations -= 1;
                    return Some(interrupted(cosine, tolerance));
                }
                Err(why) => {
                    self.refused += 1;
                    self.why_refused = Some(why);
                }
            }
            self.grow();
        }
    }

    /// Converged, where no step lowers the sum and a step without damping would hardly move the
    /// point.
    fn rounding(&mut self, domain: &Domain) -> Option<(Status, String)> {
        let (to, _) = self.at.step(
            &domain.variables,
            &self.scale,
            LEAST_DAMPING,
            &mut self.solver,
        )?;
        let length = |of: &dyn Fn(usize) -> f64| -> f64 {
            (0..self.scale.len())
                .map(|i| (self.scale[i] * of(i)).powi(2))
                .sum::<f64>()
                .sqrt()
        };
        let x = &self.at.x;
        let step = length(&|i| to[i] - x[i]);
        let way = length(&|i| x[i].abs().max((x[i] - self.begun_at[i]).abs()));
        (step <= SHORTEST * way).then(|| {
            let message = format!(
                "no step makes the sum smaller, and one without damping would move the point by \
                 {:.1e} of itself: because of \
                 rounding the sum can fall no further",
                if way > 0.0 { step / way } else { 0.0 }
            );
            (Status::Converged, message)
        })
    }

    fn grow(&mut self) {
        self.damping *= self.growth;
        self.growth *= 2.0;
    }
}

fn interrupted(cosine: f64, tolerance: f64) -> (Status, String) {
    (
        Status::Interrupted,
        format!("stopped before the lowest sum: {COSINE} {cosine:.1e} > {tolerance:.0e}"),
    )
}

/// The end of a fit that was stopped before its residuals were known once.
fn not_begun(x: Vec<f64>) -> Fit {
    let message = "stopped before the residuals were evaluated once".into();
    Fit {
        status: Status::Interrupted,
        message,
        refused: 0,
        why_refused: None,
        ..nowhere(x, String::new())
    }
}

fn nowhere(x: Vec<f64>, why: String) -> Fit {
    Fit {
        status: Status::Undefined,
        message: format!("the residuals are not defined at the start: {why}"),
        x,
        rows: Rows::default(),
        cost: f64::INFINITY,
        iterations: 0,
        evaluations: 1,
        refused: 1,
        why_refused: Some(why),
    }
}
