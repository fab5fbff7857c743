//! The part of an optimum's gain that a change of the club alone achieves.

use super::optimum::{Optimum, optimum};
use super::search::Search;
use crate::error::Result;
use crate::json::numbers_by_name;
use crate::optimize::{Observer, Status};
use crate::parameters::Parameter;
use serde::{Serialize, Serializer};

/// The gain of the optimum in two parts: from the club with the swing as set up, and from the
/// swing.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "ClubAloneReport"))]
pub struct ClubAlone {
    /// The gain of the best club with the swing as set up, SI.
    pub club_gain: f64,
    /// The additional gain if the swing changes too, SI.
    pub swing_gain: f64,
    /// The best club with the swing as set up, SI.
    // the optimum over the varied parameters of club and ball
    #[serde(serialize_with = "varied")]
    #[cfg_attr(
        test,
        schemars(with = "std::collections::BTreeMap<String, crate::json::JsonNumber>")
    )]
    pub optimum: Optimum,
}

/// Serializes an optimum as its varied parameters with their values.
fn varied<S: Serializer>(optimum: &Optimum, serializer: S) -> std::result::Result<S::Ok, S::Error> {
    let values = optimum.solution.x.iter().copied();
    let values: Vec<_> = optimum.search.parameters().zip(values).collect();
    numbers_by_name(&values, serializer)
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
    let start = best.drive_as_set_up.as_ref();
    let of = best.search.outcome();
    let Some(as_set_up) = start.and_then(|start| of.value(start)) else {
        return Ok(None);
    };
    let search = Search {
        vary: club,
        ..best.search.clone()
    };
    let optimum = optimum(&best.start, search, Observer::default())?;
    let value = optimum
        .value()
        .filter(|_| optimum.solution.status == Status::Converged);
    Ok(value.zip(best.value()).map(|(value, best)| ClubAlone {
        club_gain: value - as_set_up,
        swing_gain: best - value,
        optimum,
    }))
}
