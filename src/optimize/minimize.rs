//! Runs one search with its observer, through argmin's `Executor`.

use super::domain::Domain;
use super::iteration::Iteration;
use super::kink::Kink;
use super::observer::{Observer, SaveSnapshot, Snapshot};
use super::options::Options;
use super::problem::Problem;
use super::solution::Solution;
use super::sqp::{SearchProgress, Sqp, SqpState};
use super::status::{SearchVerdict, Status};
use crate::error::{Error, Result};
use argmin::core::checkpointing::{Checkpoint, CheckpointingFrequency};
use argmin::core::observers::{Observe, ObserverMode};
use argmin::core::{Executor, KV, State};
use std::cell::RefCell;
use std::rc::Rc;

/// Minimizes a function within a domain from a start, which is first projected on the bounds.
///
/// # Errors
/// [`Error::Optimizer`] if the domain, the start or an option is invalid, or if the number of
/// derivatives or of constraint functions does not fit the domain. A search that does not converge
/// is not an error; the [`Status`] of its solution reports it.
pub fn minimize(
    problem: &dyn Problem,
    domain: &Domain,
    start: &[f64],
    options: &Options,
) -> Result<Solution> {
    minimize_observed(problem, domain, start, options, Observer::default())
}

/// Like [`minimize`], with an observer.
///
/// # Errors
/// Errors of [`minimize`] and of the observer's `save`, and [`Error::Optimizer`] if the snapshot to
/// resume belongs to another problem.
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
        .is_some_and(|snapshot| !snapshot.progress.fits(domain))
    {
        return Err(other_problem());
    }
    let (interrupt, models) = (observer.interrupt.clone(), observer.models);
    let show = Rc::new(RefCell::new(observer.iteration));
    let shown = show.clone();
    let first_run = Observer {
        iteration: Box::new(move |iteration| (shown.borrow_mut())(iteration)),
        ..observer
    };
    let found = run(problem, domain, start, options, first_run)?;
    match found.kink {
        Some(kink) if found.status == Status::StalledAtKink => {
            let completed = found.iterations;
            let continued = move |iteration: &Iteration| {
                // iteration 0 of the second run is the last iterate of the first run, which was
                // shown already
                if iteration.number > 0 {
                    (show.borrow_mut())(&Iteration {
                        number: completed + iteration.number,
                        ..iteration.clone()
                    });
                }
            };
            // the second run is not saved: a resumed search repeats it once the first run has ended
            let observer = Observer {
                iteration: Box::new(continued),
                interrupt,
                models,
                ..Observer::default()
            };
            fix_at_kink(problem, domain, options, observer, found, kink)
        }
        _ => Ok(found),
    }
}

/// Error for a snapshot of a problem with other dimensions.
pub(super) fn other_problem() -> Error {
    Error::Optimizer(
        "the saved search belongs to another problem: the numbers of variables or constraints \
         differ; start without it"
            .into(),
    )
}

/// One run of argmin's executor.
fn run(
    problem: &dyn Problem,
    domain: &Domain,
    start: &[f64],
    options: &Options,
    observer: Observer,
) -> Result<Solution> {
    let mut solver = Sqp {
        domain: domain.clone(),
        options: options.clone(),
        interrupt: observer.interrupt.clone(),
        has_models: observer.models,
        progress: SearchProgress::default(),
    };
    let mut state = SqpState::new()
        .param(start.to_vec())
        .max_iters(options.max_iterations);
    if let Some(snapshot) = observer.resume {
        // argmin calls `init` only at iteration 0
        state.iter = snapshot.iterations;
        solver.progress = snapshot.progress;
        if let Some(search) = &mut solver.progress.state {
            search.scaling.domain = domain.clone();
        }
    }
    let mut executor = Executor::new(problem, solver)
        .configure(|_| state)
        .add_observer(IterationObserver(observer.iteration), ObserverMode::Always)
        .timer(false);
    if let Some(save) = observer.save {
        executor = executor.checkpointing(SnapshotSaver(RefCell::new(save)));
    }
    let result = executor.run().map_err(|error| {
        error
            .downcast()
            .unwrap_or_else(|error| Error::Optimizer(error.to_string()))
    })?;
    let iterations =
        result.state.get_iter() - u64::from(result.solver.progress.is_interrupted_within);
    let start = result.state.param.unwrap_or_default();
    Ok(Solution::new(
        domain,
        result.solver.progress,
        start,
        iterations,
    ))
}

/// Fixes the variable of a kink, on its bound if the kink lies there. Then minimizes over the other
/// variables, with the remaining iterations. Returns the new point if this search converges, and
/// the Lagrangian falls towards the kink from each side within the bounds: the point is then a
/// local minimum. On a bound, the one-sided derivative is the multiplier. Otherwise returns the
/// point `found`.
fn fix_at_kink(
    problem: &dyn Problem,
    domain: &Domain,
    options: &Options,
    observer: Observer,
    found: Solution,
    kink: Kink,
) -> Result<Solution> {
    let (i, mut fixed) = (kink.variable, domain.clone());
    let at = match (kink.slope_below, kink.slope_above) {
        (None, _) => domain.variables.low[i],
        (_, None) => domain.variables.high[i],
        _ => found.x[i],
    };
    (fixed.variables.low[i], fixed.variables.high[i]) = (at, at);
    let remaining = Options {
        max_iterations: options.max_iterations.saturating_sub(found.iterations),
        ..options.clone()
    };
    let mut end = run(problem, &fixed, &found.x, &remaining, observer)?;
    end.iterations += found.iterations;
    end.effort += found.effort;
    let of_constraints = end.constraints.iter().zip(&end.jacobian);
    let of_constraints = of_constraints.map(|(constraint, row)| constraint.multiplier * row[i]);
    let smooth: f64 = of_constraints.sum();
    // one-sided derivatives of the Lagrangian; `None` for a side beyond a bound
    let below = kink.slope_below.map(|slope| slope + smooth);
    let above = kink.slope_above.map(|slope| slope + smooth);
    let is_minimum =
        below.is_none_or(|below| below <= 0.0) && above.is_none_or(|above| above >= 0.0);
    if end.status != Status::Converged || !is_minimum {
        let (iterations, residual) = (end.iterations, Some(found.residual.largest()));
        let SearchVerdict { status, message } = match end.status {
            Status::Interrupted => SearchVerdict::interrupted(iterations, residual),
            Status::IterationLimit => SearchVerdict::iteration_limit(iterations, residual),
            _ => SearchVerdict {
                status: found.status,
                message: found.message,
            },
        };
        return Ok(Solution {
            status,
            message,
            iterations,
            effort: end.effort,
            ..found
        });
    }
    let on_bound = |side: Option<f64>, slope: Option<f64>| match side {
        None => slope.unwrap_or_default().abs(),
        Some(_) => 0.0,
    };
    end.lower_multipliers[i] = on_bound(below, above);
    end.upper_multipliers[i] = on_bound(above, below);
    if let (Some(slope), None) | (None, Some(slope)) = (kink.slope_below, kink.slope_above) {
        end.gradient[i] = slope;
    }
    end.message += &format!("; variable x[{i}] is at a kink: the objective's derivative is {kink}");
    Ok(Solution {
        kink: Some(kink),
        initial_point: found.initial_point,
        undefined_at_start: found.undefined_at_start,
        ..end
    })
}

/// Connects the observer's `save` to argmin's checkpointing.
struct SnapshotSaver(RefCell<Box<SaveSnapshot>>);

impl Checkpoint<Sqp, SqpState> for SnapshotSaver {
    fn save(&self, solver: &Sqp, state: &SqpState) -> std::result::Result<(), argmin::core::Error> {
        // do not save an interrupted iteration: the resumed search repeats it
        if solver.progress.is_interrupted_within {
            return Ok(());
        }
        let snapshot = Snapshot {
            iterations: state.get_iter(),
            progress: solver.progress.clone(),
        };
        (self.0.borrow_mut())(&snapshot).map_err(argmin::core::Error::new)
    }

    fn load(&self) -> std::result::Result<Option<(Sqp, SqpState)>, argmin::core::Error> {
        // `run` resumes a search itself
        Ok(None)
    }

    fn frequency(&self) -> CheckpointingFrequency {
        CheckpointingFrequency::Always
    }
}

struct IterationObserver(Box<dyn FnMut(&Iteration)>);

impl Observe<SqpState> for IterationObserver {
    fn observe_init(
        &mut self,
        _: &str,
        state: &SqpState,
        kv: &KV,
    ) -> std::result::Result<(), argmin::core::Error> {
        self.observe_iter(state, kv)
    }

    fn observe_iter(
        &mut self,
        state: &SqpState,
        _: &KV,
    ) -> std::result::Result<(), argmin::core::Error> {
        // an interrupted iteration has no data to show
        if let Some(iteration) = state.get_residuals() {
            (self.0)(iteration);
        }
        Ok(())
    }
}
