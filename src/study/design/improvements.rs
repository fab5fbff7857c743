//! Main numbers of a design before and after the search.

use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::Setup;
use crate::study::problem::SearchProblem;
use crate::study::{Goal, Optimum, Search};
use serde::Serialize;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A statistic over all swings, for the initial and for the best design.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Improvement {
    /// The statistic.
    pub goal: Goal,
    /// Value for the initial design, SI; missing if a swing does not fly.
    pub as_set_up: Option<f64>,
    /// Value for the best design, SI; missing if a swing does not fly.
    pub best: Option<f64>,
}

const PARTS: [&str; 3] = ["mean(carry)", "std(carry)", "rms(lateral)"];

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
    let part = |text: &&str| {
        let goal = Goal::read(text, None)?;
        let value = |setup: &Setup<f64>| value(setup, &goal, &best.search, stop);
        Ok(Improvement {
            as_set_up: value(setup)?,
            best: value(&best.setup)?,
            goal,
        })
    };
    let found = PARTS.iter().map(part).collect::<Result<Vec<_>>>();
    if stop.load(Ordering::Relaxed) {
        return Ok(vec![]);
    }
    found
}

/// Value of a goal over the swings at a setup's own design, SI. `None` if the ball does not fly in
/// one of the swings, and once `stop` is true.
fn value(
    setup: &Setup<f64>,
    goal: &Goal,
    search: &Search,
    stop: &Arc<AtomicBool>,
) -> Result<Option<f64>> {
    let search = Search {
        of: goal.clone(),
        vary: search.vary.clone(),
        scenarios: search.scenarios.clone(),
        ..Search::largest(Outcome::Carry)
    };
    let problem = SearchProblem::of_goals(setup, search, stop)?;
    Ok(problem.as_set_up().ok().map(|values| values[0]))
}
