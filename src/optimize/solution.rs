use super::kink::Kink;
use super::problem::{Bounds, Options, Problem};
use super::sqp::{Sqp, SqpState};
use super::status::Status;
use crate::error::{Error, Result};
use argmin::core::observers::{Observe, ObserverMode};
use argmin::core::{Executor, KV, State};

/// What a search found.
#[derive(Clone, Debug)]
pub struct Solution {
    /// How it ended.
    pub status: Status,
    /// The same in a sentence, with the numbers of the test that ended it.
    pub message: String,
    /// The point; a variable whose bound is active lies on it exactly.
    pub x: Vec<f64>,
    /// f there; `None` where the function was never defined.
    pub value: Option<f64>,
    /// Gradient of f there.
    pub gradient: Vec<f64>,
    /// Hessian of f there.
    pub hessian: Vec<Vec<f64>>,
    /// Multipliers of the lower bounds, ≥ 0: what f would fall by per unit that the bound is lowered.
    pub lower_multipliers: Vec<f64>,
    /// Multipliers of the upper bounds, ≥ 0: what f would fall by per unit that the bound is raised.
    pub upper_multipliers: Vec<f64>,
    /// The KKT residual, relative (see [`status`](super::status)).
    pub kkt_residual: f64,
    /// The corner that the search ended at, if it did.
    pub kink: Option<Kink>,
    /// Iterations taken.
    pub iterations: u64,
    /// Evaluations of f with its derivatives.
    pub evaluations: u64,
    /// Where the search began: the start, or, where f was not defined there, the best of some other points.
    pub begun_at: Vec<f64>,
    /// Why f was not defined at the start, if so.
    pub undefined_at_start: Option<String>,
}

/// One iteration, as an observer sees it.
#[derive(Clone, Debug)]
pub struct Iteration {
    /// 0 for the start.
    pub number: u64,
    /// f.
    pub value: f64,
    /// The point.
    pub x: Vec<f64>,
    /// The KKT residual, relative.
    pub kkt_residual: f64,
    /// The trust region's size for the next step, in units of the variables' scale.
    pub radius: f64,
    /// Whether the step was kept.
    pub kept: bool,
}

/// Minimises a function over a box from a start, which is moved into the box first.
///
/// # Errors
/// [`Error::Optimizer`] for a start or options that make no sense. Not converging is a [`Status`], not an error.
pub fn minimize(problem: impl Problem, bounds: &Bounds, start: &[f64], options: &Options) -> Result<Solution> {
    minimize_watched(problem, bounds, start, options, |_| ())
}

/// As [`minimize`], showing every iteration to `watch`.
///
/// # Errors
/// As [`minimize`].
pub fn minimize_watched(
    problem: impl Problem,
    bounds: &Bounds,
    start: &[f64],
    options: &Options,
    watch: impl FnMut(&Iteration) + 'static,
) -> Result<Solution> {
    options.validate()?;
    if start.len() != bounds.dimension() || !start.iter().all(|x| x.is_finite()) {
        return Err(Error::Optimizer(format!(
            "the start {start:?} must be {} finite numbers, one per variable",
            bounds.dimension()
        )));
    }
    let executor = Executor::new(problem, Sqp::new(bounds.clone(), options.clone()))
        .configure(|state| state.param(start.to_vec()).max_iters(options.max_iterations).counting(true))
        .add_observer(Watcher(watch), ObserverMode::Always);
    let mut result = executor.run().map_err(|e| Error::Optimizer(e.to_string()))?;

    let state = &mut result.state;
    let x = state.take_param().unwrap_or_default();
    let gradient = state.take_gradient().unwrap_or_default();
    let iterations = state.get_iter();
    let evaluations = result.problem.counts.get("evaluations").copied().unwrap_or_default();
    let multiplier = |i: usize, at_bound: bool, outward: f64| {
        if at_bound { gradient.get(i).map_or(0.0, |g| (g * outward).max(0.0)) } else { 0.0 }
    };
    let solver = result.solver;
    let (kkt_residual, kink) = (solver.residual(), solver.kink);
    let (begun_at, undefined_at_start) = (solver.begun_at.clone(), solver.undefined_at_start.clone());
    let verdict = solver.into_verdict(iterations);
    Ok(Solution {
        status: verdict.status,
        message: verdict.message,
        value: (verdict.status != Status::Undefined).then(|| state.get_cost()),
        lower_multipliers: (0..x.len()).map(|i| multiplier(i, x[i] <= bounds.low[i], 1.0)).collect(),
        upper_multipliers: (0..x.len()).map(|i| multiplier(i, x[i] >= bounds.high[i], -1.0)).collect(),
        hessian: state.take_hessian().unwrap_or_default(),
        gradient,
        x,
        kkt_residual,
        kink,
        iterations,
        evaluations,
        begun_at,
        undefined_at_start,
    })
}

/// Passes argmin's observations on.
struct Watcher<F>(F);

impl<F: FnMut(&Iteration)> Watcher<F> {
    fn show(&mut self, number: u64, state: &SqpState, kv: &KV) {
        let float = |key: &str| kv.get(key).and_then(argmin::core::KvValue::get_float);
        let Some((x, kkt_residual)) = state.get_param().cloned().zip(float("kkt_residual")) else { return };
        (self.0)(&Iteration {
            number,
            value: state.get_cost(),
            x,
            kkt_residual,
            radius: float("radius").unwrap_or_default(),
            kept: kv.get("kept").and_then(argmin::core::KvValue::get_bool).unwrap_or_default(),
        });
    }
}

impl<F: FnMut(&Iteration)> Observe<SqpState> for Watcher<F> {
    fn observe_init(&mut self, _: &str, state: &SqpState, kv: &KV) -> std::result::Result<(), argmin::core::Error> {
        self.show(0, state, kv);
        Ok(())
    }

    fn observe_iter(&mut self, state: &SqpState, kv: &KV) -> std::result::Result<(), argmin::core::Error> {
        self.show(state.get_iter() + 1, state, kv);
        Ok(())
    }
}
