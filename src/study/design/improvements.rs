//! Main numbers of a design before and after the search.

use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::Setup;
use crate::study::problem::SearchProblem;
use crate::study::{Constraint, Goal, Optimum, Search};
use serde::Serialize;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A statistic over all swings, for the initial and for the best design.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Improvement {
    /// The statistic.
    pub goal: Goal,
    /// Value for the initial design, SI; `null` if a swing does not fly.
    pub as_set_up: Option<f64>,
    /// Value for the best design, SI; `null` if a swing does not fly.
    pub best: Option<f64>,
}

const STATISTICS: [&str; 3] = ["mean(carry)", "std(carry)", "rms(lateral)"];

/// Mean carry, standard deviation of carry, and root mean square distance from the target line;
/// empty once `stop` is true.
///
/// # Errors
/// The errors of [`optimum`](crate::study::optimum).
pub fn improvements(
    setup: &Setup<f64>,
    best: &Optimum,
    stop: &Arc<AtomicBool>,
) -> Result<Vec<Improvement>> {
    let goals = STATISTICS.iter().map(|text| Goal::read(text, None));
    let goals = goals.collect::<Result<Vec<_>>>()?;
    let found = [setup, &best.setup].map(|setup| values(setup, &goals, &best.search, stop));
    if stop.load(Ordering::Relaxed) {
        return Ok(vec![]);
    }
    let [as_set_up, at_best] = found;
    let (as_set_up, at_best) = (as_set_up?, at_best?);
    let value = |values: &Option<Vec<f64>>, k: usize| Some(values.as_ref()?[k]);
    let goals = goals.into_iter().enumerate();
    let improvement = |(k, goal): (usize, Goal)| Improvement {
        goal,
        as_set_up: value(&as_set_up, k),
        best: value(&at_best, k),
    };
    Ok(goals.map(improvement).collect())
}

/// Values of goals over the swings for the design of `setup`, SI. `None` if the ball does not fly
/// in one of the swings, and once `stop` is true.
fn values(
    setup: &Setup<f64>,
    goals: &[Goal],
    search: &Search,
    stop: &Arc<AtomicBool>,
) -> Result<Option<Vec<f64>>> {
    let search = Search {
        of: goals[0].clone(),
        vary: search.vary.clone(),
        subject_to: goals[1..]
            .iter()
            .cloned()
            .map(Constraint::unlimited)
            .collect(),
        scenarios: search.scenarios.clone(),
        ..Search::largest(Outcome::Carry)
    };
    Ok(SearchProblem::of_goals(setup, search, stop)?
        .goals_as_set_up()
        .ok())
}
