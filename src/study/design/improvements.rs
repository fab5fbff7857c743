//! Main numbers of a design before and after the search.

use crate::error::Result;
use crate::parameters::Setup;
use crate::study::{Goal, Optimum, goals_of};
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
/// `None` once `stop` is true.
///
/// # Errors
/// The errors of [`goals_of`].
pub fn improvements(
    setup: &Setup<f64>,
    best: &Optimum,
    stop: &Arc<AtomicBool>,
) -> Result<Vec<Improvement>> {
    let goals = PARTS
        .iter()
        .map(|text| Goal::read(text, None))
        .collect::<Result<Vec<_>>>()?;
    let of = |setup: &Setup<f64>| {
        goals_of(
            setup,
            &goals,
            &best.search.vary,
            &best.search.scenarios,
            stop,
        )
    };
    let found = of(setup).and_then(|before| Ok((before, of(&best.setup)?)));
    if stop.load(Ordering::Relaxed) {
        return Ok(vec![]);
    }
    let (before, after) = found?;
    let value = |of: &Option<Vec<f64>>, k: usize| of.as_ref().map(|values| values[k]);
    let part = |(k, goal)| Improvement {
        goal,
        as_set_up: value(&before, k),
        best: value(&after, k),
    };
    Ok(goals.into_iter().enumerate().map(part).collect())
}
