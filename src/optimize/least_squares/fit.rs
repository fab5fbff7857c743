//! Levenberg–Marquardt loop: step, gain ratio, damping, stopping tests.

use super::super::domain::{Bounds, Domain};
use super::super::qp::QpSolver;
use super::super::status::SearchVerdict;
use super::step::{GaussNewtonPoint, ModelStep};
use super::{FitOptions, Rows};
use crate::error::{Error, Result};
use crate::units::counted;
use rayon::prelude::*;
use serde::Serialize;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Initial damping. The scaled Jacobian columns have length 1, so that this is τ of Madsen, Nielsen
/// & Tingleff (2004), eq. 3.14: between 1e-6 for a good start and 1 for a poor start.
const FIRST_DAMPING: f64 = 1e-3;
/// Rounding error of F, relative to F.
const SUM_ROUNDING: f64 = 1e-15;
/// Largest damping. A larger damping would make every step smaller than rounding.
const MOST_DAMPING: f64 = 1e20;
/// Smallest damping. JᵀJ of the scaled columns is accurate to about 1e-16; with less damping,
/// rounding would drive steps along directions in which the residuals do not change.
const LEAST_DAMPING: f64 = 1e-12;
/// Convergence limit for a fit in which no step lowers the sum: the largest step without damping,
/// relative to the size of the point (Moré 1978, MINPACK's `xtol`). The size of each variable is
/// the larger of |x| and its distance from the start. Near a sum of 0 the gradient is no criterion,
/// because the residuals are rounding errors.
const SHORTEST: f64 = 1e-8;

/// Name of the convergence measure in messages. The measure is 0 at a stationary point.
const COSINE: &str = "cosine between the residuals and their slopes";

/// Outcome of a fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FitStatus {
    /// The sum is stationary within the bounds.
    Converged,
    /// No step lowers the sum, although the gradient is not 0.
    Stalled,
    /// The limit of iterations was reached.
    IterationLimit,
    /// Interrupted by the caller. The result is the best point so far.
    Interrupted,
    /// The residuals are undefined at the start.
    Undefined,
}

variant_names! {
    /// Name in reports, such as `converged`.
    FitStatus as "FitStatus" {
        Converged = "converged",
        Stalled = "stalled",
        IterationLimit = "iteration-limit",
        Interrupted = "interrupted",
        Undefined = "undefined",
    }
}

/// Result of a fit.
#[derive(Clone, Debug)]
pub struct Fit {
    /// Outcome of the fit.
    pub status: FitStatus,
    /// Outcome in a sentence, with the numbers of the stopping test.
    pub message: String,
    /// Final point.
    pub x: Vec<f64>,
    /// Residuals and Jacobian at the point; empty if they were never defined.
    pub rows: Rows,
    /// Sum of losses F = Σ ρ(rᵢ); ∞ if the residuals were never defined.
    pub cost: f64,
    /// Number of iterations.
    pub iterations: u64,
    /// Number of evaluations of the residuals.
    pub evaluations: u64,
    /// Rejected trial points.
    pub rejected: RejectedPoints,
}

/// Trial points that a fit rejected, because the residuals are undefined there.
#[derive(Clone, Debug, Default, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "RefusedReport"))]
pub struct RejectedPoints {
    /// Number of these points.
    pub count: u64,
    /// The reason why the fit rejected the last of these points; `null` without such points.
    pub last: Option<String>,
}

/// Callback and interrupt flag of a fit.
#[derive(Clone, Default)]
pub struct FitObserver {
    /// Called at every iteration with its number and F.
    pub iteration: Option<Arc<dyn Fn(u64, f64) + Send + Sync>>,
    /// Interrupt flag: once true, the fit ends with the best point so far. It ends after the
    /// current evaluation, or during an evaluation that checks the flag.
    pub interrupt: Arc<AtomicBool>,
}

impl FitObserver {
    /// True if the interrupt flag is set.
    pub fn is_interrupted(&self) -> bool {
        self.interrupt.load(Ordering::Relaxed)
    }
}

/// Fits from a start, which is first projected on the bounds.
///
/// `residuals` returns the rows at a point, or a sentence that says why they are undefined there.
/// The fit then shortens its step, or, if the [`interrupt`](FitObserver::interrupt) flag is set,
/// ends at the previous iterate.
///
/// # Errors
/// [`Error::Optimizer`] if the start, the tolerance or the loss is invalid, if the domain has
/// constraints, or if at the start there are no residuals or the Jacobian has a wrong shape.
pub fn fit(
    residuals: &impl Fn(&[f64]) -> Result<Rows, String>,
    domain: &Domain,
    start: &[f64],
    options: &FitOptions,
) -> Result<Fit> {
    fit_observed(residuals, domain, start, options, &FitObserver::default())
}

/// Fits from every start in parallel. Returns the fits by increasing sum; their order does not
/// depend on the number of threads. [`starts`](super::super::starts) creates starts.
///
/// # Errors
/// Errors of [`fit`], and [`Error::Optimizer`] if there are no starts.
pub fn fit_from(
    residuals: &(impl Fn(&[f64]) -> Result<Rows, String> + Sync),
    domain: &Domain,
    starts: &[Vec<f64>],
    options: &FitOptions,
    observer: &FitObserver,
) -> Result<Vec<Fit>> {
    if starts.is_empty() {
        return Err(Error::Optimizer("there are no starts to fit from".into()));
    }
    let one = |start: &Vec<f64>| fit_observed(residuals, domain, start, options, observer);
    let mut fits = starts.par_iter().map(one).collect::<Result<Vec<_>>>()?;
    fits.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    Ok(fits)
}

/// Like [`fit`], with an observer.
///
/// # Errors
/// Errors of [`fit`].
pub fn fit_observed(
    residuals: &impl Fn(&[f64]) -> Result<Rows, String>,
    domain: &Domain,
    start: &[f64],
    options: &FitOptions,
    observer: &FitObserver,
) -> Result<Fit> {
    check_input(domain, start, options)?;
    let bounds = &domain.variables;
    let start = bounds.project(start);
    let evaluate = |x: Vec<f64>| {
        let rows = residuals(&x)?;
        GaussNewtonPoint::new(x, rows, options.loss)
    };
    let rows = residuals(&start);
    if let Ok(rows) = &rows {
        rows.check_shape(start.len()).map_err(Error::Optimizer)?;
    }
    let at = rows.and_then(|rows| GaussNewtonPoint::new(start.clone(), rows, options.loss));
    let at = match at {
        Ok(at) => at,
        Err(why) => {
            let undefined = (!observer.is_interrupted()).then_some(why);
            return Ok(without_residuals(start, undefined));
        }
    };
    let mut state = FitState::new(at, bounds);
    let SearchVerdict { status, message } = loop {
        if let Some(show) = &observer.iteration {
            show(state.iterations, state.at.cost);
        }
        if let Some(verdict) = state.stopping_verdict(options, observer.is_interrupted()) {
            break verdict;
        }
        if let Some(verdict) = state.iterate(bounds, options, &evaluate, observer) {
            break verdict;
        }
    };
    let FitState {
        at,
        iterations,
        evaluations,
        rejected,
        ..
    } = state;
    let GaussNewtonPoint { x, rows, cost, .. } = at;
    Ok(Fit {
        status,
        message,
        x,
        rows,
        cost,
        iterations,
        evaluations,
        rejected,
    })
}

fn check_input(domain: &Domain, start: &[f64], options: &FitOptions) -> Result<()> {
    domain.check(start)?;
    if domain.constraints.dimension() > 0 {
        return Err(Error::Optimizer(
            "a fit allows bounds only; give a domain without constraints, or use minimize".into(),
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
    Ok(())
}

fn stalled(reason: &str, cosine: f64) -> SearchVerdict<FitStatus> {
    let message =
        format!("{reason}; {COSINE} {cosine:.1e}. Start elsewhere, or fit fewer parameters");
    SearchVerdict {
        status: FitStatus::Stalled,
        message,
    }
}

fn interrupted(cosine: f64, tolerance: f64) -> SearchVerdict<FitStatus> {
    let message = format!("stopped before the lowest sum: {COSINE} {cosine:.1e} > {tolerance:.0e}");
    SearchVerdict {
        status: FitStatus::Interrupted,
        message,
    }
}

/// State of a fit between two iterations.
struct FitState {
    at: GaussNewtonPoint,
    /// Convergence measure at the point ([`GaussNewtonPoint::cosine`]).
    cosine: f64,
    initial_point: Vec<f64>,
    /// Length of each column of the Jacobian: the largest length so far.
    scale: Vec<f64>,
    solver: QpSolver,
    damping: f64,
    /// Factor by which the damping grows after the next rejected step.
    growth: f64,
    iterations: u64,
    evaluations: u64,
    rejected: RejectedPoints,
}

impl FitState {
    fn new(at: GaussNewtonPoint, bounds: &Bounds) -> Self {
        let mut scale = vec![0.0; at.x.len()];
        at.raise_scale(&mut scale);
        Self {
            cosine: at.cosine(bounds),
            initial_point: at.x.clone(),
            solver: QpSolver::from_no_active_bound(at.x.len()),
            at,
            scale,
            damping: FIRST_DAMPING,
            growth: 2.0,
            iterations: 0,
            evaluations: 1,
            rejected: RejectedPoints::default(),
        }
    }

    fn stopping_verdict(
        &self,
        options: &FitOptions,
        is_interrupted: bool,
    ) -> Option<SearchVerdict<FitStatus>> {
        let (cosine, tolerance) = (self.cosine, options.tolerance);
        let residuals = self.at.rows.residuals.iter();
        let largest = residuals.map(|r| r.abs()).fold(0.0, f64::max);
        if largest <= options.rounding {
            let message =
                format!("every residual is a rounding error: the largest is {largest:.1e}");
            return Some(SearchVerdict {
                status: FitStatus::Converged,
                message,
            });
        }
        if cosine <= tolerance {
            let message =
                format!("no small change lowers the sum: {COSINE} {cosine:.1e} <= {tolerance:.0e}");
            return Some(SearchVerdict {
                status: FitStatus::Converged,
                message,
            });
        }
        if is_interrupted {
            return Some(interrupted(cosine, tolerance));
        }
        (self.iterations >= options.max_iterations).then(|| {
            let limit = counted(self.iterations, "iteration");
            let message =
                format!("stopped at the limit of {limit}: {COSINE} {cosine:.1e} > {tolerance:.0e}");
            SearchVerdict {
                status: FitStatus::IterationLimit,
                message,
            }
        })
    }

    /// One iteration: tries steps with growing damping until one is accepted. Returns a verdict if
    /// the fit ends.
    fn iterate(
        &mut self,
        bounds: &Bounds,
        options: &FitOptions,
        evaluate: &impl Fn(Vec<f64>) -> Result<GaussNewtonPoint, String>,
        observer: &FitObserver,
    ) -> Option<SearchVerdict<FitStatus>> {
        self.iterations += 1;
        loop {
            if self.damping > MOST_DAMPING {
                return Some(self.no_step_verdict(bounds));
            }
            let Some(step) = self.step(bounds, self.damping) else {
                self.grow_damping();
                continue;
            };
            if step.predicted_reduction <= SUM_ROUNDING * self.at.cost || step.to == self.at.x {
                return Some(self.no_gain_verdict(bounds));
            }
            match self.try_step(step, bounds, options, evaluate, observer) {
                Ok(true) => return None,
                Ok(false) => self.grow_damping(),
                Err(verdict) => return Some(verdict),
            }
        }
    }

    /// Step that minimizes the model with this damping; `None` if the step is too long or not
    /// found.
    fn step(&mut self, bounds: &Bounds, damping: f64) -> Option<ModelStep> {
        self.at.step(bounds, &self.scale, damping, &mut self.solver)
    }

    /// Evaluates a trial point, and moves there if the sum falls. Returns true if it moved.
    ///
    /// # Errors
    /// The verdict of the fit, if it was interrupted and has not moved.
    fn try_step(
        &mut self,
        step: ModelStep,
        bounds: &Bounds,
        options: &FitOptions,
        evaluate: &impl Fn(Vec<f64>) -> Result<GaussNewtonPoint, String>,
        observer: &FitObserver,
    ) -> Result<bool, SearchVerdict<FitStatus>> {
        self.evaluations += 1;
        match evaluate(step.to) {
            Ok(next) => {
                // gain ratio and damping update: Nielsen (1999); Madsen, Nielsen & Tingleff (2004),
                // alg. 3.16
                let gain = (self.at.cost - next.cost) / step.predicted_reduction;
                if gain > 0.0 {
                    self.damping *= (1.0 - (2.0 * gain - 1.0).powi(3)).max(1.0 / 3.0);
                    self.damping = self.damping.max(LEAST_DAMPING);
                    self.growth = 2.0;
                    next.raise_scale(&mut self.scale);
                    self.cosine = next.cosine(bounds);
                    self.at = next;
                    return Ok(true);
                }
            }
            // the evaluation may have failed because of the interrupt
            Err(_) if observer.is_interrupted() => {}
            Err(why) => {
                self.rejected.count += 1;
                self.rejected.last = Some(why);
            }
        }
        if observer.is_interrupted() {
            // do not count the interrupted iteration
            self.iterations -= 1;
            return Err(interrupted(self.cosine, options.tolerance));
        }
        Ok(false)
    }

    /// Verdict if even the largest damping gives no acceptable step.
    fn no_step_verdict(&mut self, bounds: &Bounds) -> SearchVerdict<FitStatus> {
        self.rounding_verdict(bounds).unwrap_or_else(|| {
            let why = self.rejected.last.as_ref().map_or(String::new(), |why| {
                format!(" (last undefined trial point: {why})")
            });
            stalled(
                &format!("no step makes the minimized sum smaller{why}"),
                self.cosine,
            )
        })
    }

    /// Verdict if the predicted reduction of a step is within rounding. Either the fit has
    /// converged, or the damping makes the step short; the predicted reduction of a step without
    /// damping shows which.
    fn no_gain_verdict(&mut self, bounds: &Bounds) -> SearchVerdict<FitStatus> {
        let undamped = self
            .step(bounds, LEAST_DAMPING)
            .map_or(0.0, |step| step.predicted_reduction);
        let is_rounding = undamped <= 1e3 * SUM_ROUNDING * self.at.cost;
        if is_rounding || self.damping <= FIRST_DAMPING {
            let message = match is_rounding {
                true => {
                    let part = if self.at.cost > 0.0 {
                        undamped / self.at.cost
                    } else {
                        0.0
                    };
                    format!(
                        "the minimized sum is at its smallest: a step could lower it by {part:.1e} \
                         of its value at most, which is less than its rounding error"
                    )
                }
                false => {
                    "the next step changes the minimized sum by less than its rounding error".into()
                }
            };
            return SearchVerdict {
                status: FitStatus::Converged,
                message,
            };
        }
        self.rounding_verdict(bounds).unwrap_or_else(|| {
            stalled(
                "the next step of the fit is too small to show whether the minimized sum \
                 still falls",
                self.cosine,
            )
        })
    }

    /// Verdict `Converged`, if a step without damping would hardly move the point (see
    /// [`SHORTEST`]).
    fn rounding_verdict(&mut self, bounds: &Bounds) -> Option<SearchVerdict<FitStatus>> {
        let to = self.step(bounds, LEAST_DAMPING)?.to;
        let length = |of: &dyn Fn(usize) -> f64| -> f64 {
            (0..self.scale.len())
                .map(|i| (self.scale[i] * of(i)).powi(2))
                .sum::<f64>()
                .sqrt()
        };
        let x = &self.at.x;
        let step = length(&|i| to[i] - x[i]);
        let distance = length(&|i| x[i].abs().max((x[i] - self.initial_point[i]).abs()));
        (step <= SHORTEST * distance).then(|| {
            let message = format!(
                "no step makes the minimized sum smaller, and a step without damping would move the \
                 point by only {:.1e} of its size: because of rounding the minimized sum can fall no \
                 further",
                if distance > 0.0 { step / distance } else { 0.0 }
            );
            SearchVerdict { status: FitStatus::Converged, message }
        })
    }

    fn grow_damping(&mut self) {
        self.damping *= self.growth;
        self.growth *= 2.0;
    }
}

/// Result of a fit whose first evaluation failed. `undefined` is the reason why the residuals are
/// undefined at the start; `None` if the evaluation was interrupted.
fn without_residuals(x: Vec<f64>, undefined: Option<String>) -> Fit {
    let (status, message) = match &undefined {
        Some(why) => (
            FitStatus::Undefined,
            format!("the residuals are not defined at the start: {why}"),
        ),
        None => (
            FitStatus::Interrupted,
            "stopped during the first evaluation of the residuals".into(),
        ),
    };
    Fit {
        status,
        message,
        x,
        rows: Rows::default(),
        cost: f64::INFINITY,
        iterations: 0,
        evaluations: 1,
        rejected: RejectedPoints {
            count: u64::from(undefined.is_some()),
            last: undefined,
        },
    }
}
