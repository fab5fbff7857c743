//! What a design changes, in numbers that people know.

use crate::error::Result;
use crate::parameters::Setup;
use crate::study::{Goal, Optimum, goals_of};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A number over all swings, with the design as set up and with the best one.
#[derive(Clone, Debug)]
pub struct Part {
    /// What it is.
    pub goal: Goal,
    /// With the design as set up, SI; `None` where a swing does not fly.
    pub as_set_up: Option<f64>,
    /// With the best design, SI; `None` where a swing does not fly.
    pub best: Option<f64>,
}

const PARTS: [&str; 3] = ["mean(carry)", "std(carry)", "rms(lateral)"];

/// The mean carry, how carries scatter, and how far balls miss the target line; nothing once `stop`
/// is true.
///
/// # Errors
/// As [`goals_of`].
pub fn parts(setup: &Setup<f64>, best: &Optimum, stop: &Arc<AtomicBool>) -> Result<Vec<Part>> {
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
    let part = |(k, goal)| Part {
        goal,
        as_set_up: value(&before, k),
        best: value(&after, k),
    };
    Ok(goals.into_iter().enumerate().map(part).collect())
}
