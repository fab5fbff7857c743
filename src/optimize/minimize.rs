//! A search from its start to its end, with its observer.

use super::domain::Domain;
use super::kink::Kink;
use super::observer::{Keep, Observer, Snapshot};
use super::options::Options;
use super::problem::Problem;
use super::solution::{Iteration, Solution};
use super::sqp::{IterationInfo, ProblemRef, Progress, Sqp, SqpState};
use super::status::Status;
use crate::error::{Error, Result};
use argmin::core::checkpointing::{Checkpoint, CheckpointingFrequency};
use argmin::core::observers::{Observe, ObserverMode};
use argmin::core::{Executor, KV, State};
use std::cell::RefCell;
use std::sync::Arc;

/// Minimises a function within a domain from a start, which is moved into the bounds first.
///
/// # Errors
/// [`Error::Optimizer`] for a domain, a start or options that make no sense. Not converging is a
/// [`Status`], not an error.
pub fn minimize(
    problem: &dyn Problem,
    domain: &Domain,
    start: &[f64],
    options: &Options,
) -> Result<Solution> {
    minimize_observed(problem, domain, start, options, Observer::default())
}

/// As [`minimize`], with an observer.
///
/// # Errors
/// As [`minimize`]; [`Error::Optimizer`] for a kept search of another problem; whatever keeping the
/// search fails with.
pub fn minimize_observed(
    problem: &dyn Problem,
    domain: &Domain,
    start: &[f64],
    options: &Options,
    observer: Observer,
) -> Result<Solution> {
    options.validate()?;
    domain.check(start)?;
    if observer
        .resume
        .as_ref()
        .is_some_and(|kept| !kept.is_of(domain))
    {
        return Err(other_problem());
    }
    let (failure, interrupt) = (Arc::default(), observer.interrupt.clone());
    let problem = ProblemRef(problem);
    let found = run(problem, domain, start, options, observer, &failure)?;
    match found
        .kink
        .and_then(|kink| Some((kink, kink.slope_towards_bound()?)))
    {
        Some((kink, (price, is_lower))) if found.status == Status::StalledAtKink => {
            let observer = Observer {
                interrupt,
                ..Observer::default()
            };
            Ok(held_at_corner(
                problem,
                domain,
                options,
                observer,
                found,
                (kink, price, is_lower),
            ))
        }
        _ => Ok(found),
    }
}

/// A search that was kept belongs to a problem of another shape.
pub(super) fn other_problem() -> Error {
    Error::Optimizer(
        "the search that was kept is of another problem: its numbers of variables or \
                      constraints differ; begin without it"
            .into(),
    )
}

/// One run of argmin's executor.
fn run(
    problem: ProblemRef<'_>,
    domain: &Domain,
    start: &[f64],
    options: &Options,
    observer: Observer,
    failure: &Arc<std::sync::Mutex<Option<Error>>>,
) -> Result<Solution> {
    let solver = Sqp {
        domain: domain.clone(),
        options: options.clone(),
        interrupt: observer.interrupt.clone(),
        progress: Progress::default(),
    };
    let fresh = SqpState::new()
        .param(start.to_vec())
        .max_iters(options.max_iterations);
    let keeper = Keeper {
        keep: observer.keep.map(RefCell::new),
        resumed: observer.resume.map(|snapshot| {
            (
                resumed(&solver, snapshot.clone()),
                at_iteration(&fresh, &snapshot),
            )
        }),
        failure: failure.clone(),
    };
    let mut executor = Executor::new(problem, solver)
        .configure(|_| fresh)
        .add_observer(
            IterationObserver::new(observer.iteration),
            ObserverMode::Always,
        )
        .timer(false);
    if keeper.keep.is_some() || keeper.resumed.is_some() {
        executor = executor.checkpointing(keeper);
    }
    let result = executor.run().map_err(|e| {
        let own = failure.lock().ok().and_then(|mut failure| failure.take());
        own.unwrap_or_else(|| Error::Optimizer(e.to_string()))
    })?;
    let iterations = result.state.get_iter() - u64::from(result.solver.progress.is_stopped_within);
    let start = result.state.param.unwrap_or_default();
    Ok(Solution::new(
        domain,
        result.solver.progress,
        start,
        iterations,
    ))
}

/// Where a corner of the objective lies on a bound that it falls towards, that variable stays on
/// the bound, at the price of the slope inside, and the others are searched on.
fn held_at_corner(
    problem: ProblemRef<'_>,
    domain: &Domain,
    options: &Options,
    observer: Observer,
    found: Solution,
    (kink, price, is_lower): (Kink, f64, bool),
) -> Solution {
    let (i, mut held) = (kink.variable, domain.clone());
    let bound = if is_lower {
        domain.variables.low[i]
    } else {
        domain.variables.high[i]
    };
    (held.variables.low[i], held.variables.high[i]) = (bound, bound);
    let Ok(mut end) = run(problem, &held, &found.x, options, observer, &Arc::default()) else {
        return found;
    };
    if end.status != Status::Converged {
        return found;
    }
    let (lower, upper) = if is_lower { (price, 0.0) } else { (0.0, price) };
    (end.lower_multipliers[i], end.upper_multipliers[i]) = (lower, upper);
    end.gradient[i] = lower - upper;
    end.message += &format!("; variable {i} lies on its bound, where the objective has a corner");
    end.iterations += found.iterations;
    end.evaluations += found.evaluations;
    Solution {
        kink: Some(kink),
        begun_at: found.begun_at,
        undefined_at_start: found.undefined_at_start,
        ..end
    }
}

fn resumed(solver: &Sqp, snapshot: Snapshot) -> Sqp {
    let mut solver = Sqp {
        progress: snapshot.progress,
        ..solver.clone()
    };
    if let Some(search) = &mut solver.progress.state {
        search.scaling.domain = solver.domain.clone();
    }
    solver
}

fn at_iteration(fresh: &SqpState, snapshot: &Snapshot) -> SqpState {
    let mut state = fresh.clone();
    if let Some(search) = &snapshot.progress.state {
        state = state
            .param(search.point.x.clone())
            .cost(search.point.f.objective.value);
    }
    state.iter = snapshot.iterations;
    state
}

/// argmin's checkpointing, by whoever keeps the search.
struct Keeper {
    keep: Option<RefCell<Box<Keep>>>,
    resumed: Option<(Sqp, SqpState)>,
    failure: Arc<std::sync::Mutex<Option<Error>>>,
}

impl Checkpoint<Sqp, SqpState> for Keeper {
    fn save(&self, solver: &Sqp, state: &SqpState) -> std::result::Result<(), argmin::core::Error> {
        // an iteration that was stopped within is done anew by whoever goes on
        let Some(keep) = self
            .keep
            .as_ref()
            .filter(|_| !solver.progress.is_stopped_within)
        else {
            return Ok(());
        };
        let snapshot = Snapshot {
            iterations: state.get_iter(),
            progress: solver.progress.clone(),
        };
        (keep.borrow_mut())(&snapshot).map_err(|error| {
            let message = error.to_string();
            if let Ok(mut failure) = self.failure.lock() {
                *failure = Some(error);
            }
            argmin::core::Error::msg(message)
        })
    }

    fn load(&self) -> std::result::Result<Option<(Sqp, SqpState)>, argmin::core::Error> {
        Ok(self.resumed.clone())
    }

    fn frequency(&self) -> CheckpointingFrequency {
        CheckpointingFrequency::Always
    }
}

/// Passes argmin's observations on.
struct IterationObserver {
    show: Box<dyn FnMut(&Iteration)>,
    /// What was shown last; it is filled anew each time.
    shown: Iteration,
}

impl IterationObserver {
    fn new(show: Box<dyn FnMut(&Iteration)>) -> Self {
        Self {
            show,
            shown: Iteration::default(),
        }
    }

    fn show(&mut self, number: u64, state: &SqpState) {
        let (Some(at), Some(info)) = (state.get_param(), state.get_residuals()) else {
            return;
        };
        let mut x = std::mem::take(&mut self.shown.x);
        x.clone_from(at);
        let &IterationInfo {
            kkt_residual,
            violation,
            radius,
            accepted,
        } = info;
        self.shown = Iteration {
            number,
            value: state.get_cost(),
            x,
            kkt_residual,
            violation,
            radius,
            kept: accepted,
        };
        (self.show)(&self.shown);
    }
}

impl Observe<SqpState> for IterationObserver {
    fn observe_init(
        &mut self,
        _: &str,
        state: &SqpState,
        _: &KV,
    ) -> std::result::Result<(), argmin::core::Error> {
        self.show(0, state);
        Ok(())
    }

    fn observe_iter(
        &mut self,
        state: &SqpState,
        _: &KV,
    ) -> std::result::Result<(), argmin::core::Error> {
        self.show(state.get_iter() + 1, state);
        Ok(())
    }
}
