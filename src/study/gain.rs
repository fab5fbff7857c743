//! The part of an optimum's gain that a change of the club alone achieves.

use super::optimum::{Optimum, local_optimum};
use super::search::Search;
use crate::error::Result;
use crate::optimize::{Observer, Status};
use crate::parameters::Parameter;

/// The best value that changes of club and ball achieve with the swing as set up. The rest of the
/// optimum's gain needs a changed swing.
#[derive(Clone, Debug, PartialEq)]
pub struct ClubAlone {
    /// The value of the objective as set up, SI.
    pub as_set_up: f64,
    /// The optimum over the varied parameters of club and ball.
    pub optimum: Optimum,
    /// The value of the objective at `optimum`, SI.
    pub value: f64,
    /// The change of the objective from `optimum` to the optimum over club and swing, SI.
    pub rest: f64,
}

/// The best value that club and ball achieve with the swing as set up. `None` in these cases:
///
/// - the search is over swings;
/// - the search does not vary both club (or ball) and swing (or strike);
/// - the search varies a parameter of another group;
/// - the objective has no value at the start;
/// - the search over club and ball does not converge.
///
/// # Errors
/// The errors of [`optimum`](crate::study::optimum).
pub fn club_alone(best: &Optimum) -> Result<Option<ClubAlone>> {
    let is_of = |groups: [&str; 2], parameter: &Parameter| {
        groups.iter().any(|group| parameter.name.starts_with(group))
    };
    let vary = best.search.vary.iter().copied();
    let (club, swing): (Vec<_>, Vec<_>) =
        vary.partition(|vary| is_of(["club.", "ball."], vary.parameter));
    if club.is_empty()
        || swing.is_empty()
        || !swing
            .iter()
            .all(|vary| is_of(["swing.", "strike."], vary.parameter))
        || !best.search.scenarios.is_one_drive()
    {
        return Ok(None);
    }
    let start = best.start_drive.as_ref();
    let of = best.search.outcome();
    let Some(as_set_up) = start.and_then(|start| of.value(start)) else {
        return Ok(None);
    };
    let search = Search {
        vary: club,
        ..best.search.clone()
    };
    let optimum = local_optimum(&best.start, search, Observer::default())?;
    let value = optimum
        .value()
        .filter(|_| optimum.solution.status == Status::Converged);
    Ok(value.zip(best.value()).map(|(value, best)| ClubAlone {
        as_set_up,
        optimum,
        value,
        rest: best - value,
    }))
}
