//! The part of an optimum's gain that a change of the club alone achieves.

use super::optimum::{LocalOptimum, Optima, Optimum, optimum};
use super::search::Search;
use crate::error::Result;
use crate::json::numbers_by_name;
use crate::optimize::Observer;
use crate::parameters::{ParameterGroup, Setup, Vary};
use serde::{Serialize, Serializer};

/// The gain of the optimum in two parts: from the club with the swing as set up, and from the
/// swing.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "ClubAloneReport"))]
pub struct ClubAlone {
    /// The improvement of the objective by the best club, with the swing as set up, SI. It is
    /// positive if a minimized objective falls.
    pub club_gain: f64,
    /// The further improvement if the swing changes too, SI.
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

/// If the club alone is better than an optimum by more than this fraction of the value, a search
/// starts there. Smaller differences count as rounding.
const ROUNDING: f64 = 1e-9;

impl Optima {
    /// Replaces [`best`](Self::best) as [`improve_from_club_alone`] does. A better optimum has an
    /// [extra start](Self::has_extra_start).
    ///
    /// # Errors
    /// The errors of [`improve_from_club_alone`].
    pub fn improve_from_club_alone(&mut self) -> Result<Option<ClubAlone>> {
        let value = self.best.value();
        let club = improve_from_club_alone(&mut self.best)?;
        if self.best.value() == value {
            return Ok(club);
        }
        if self.has_extra_start {
            // the earlier extra start no longer leads to the best optimum
            self.locals.remove(0);
        }
        self.has_extra_start = true;
        let local = LocalOptimum {
            solution: self.best.solution.clone(),
            value: self.best.value(),
            starts: vec![self.requested],
        };
        self.locals.insert(0, local);
        Ok(club)
    }
}

/// Searches again from the optimum of the club alone (club and ball, with the swing as set up), if
/// that optimum is better than `best` and within the ranges of the search. A better result replaces
/// `best`. Returns the value that club and ball achieve alone; `None` in these cases:
///
/// - `best` has not converged;
/// - the search is over swings;
/// - the search does not vary both club (or ball) and swing (or strike);
/// - the search varies a parameter of another group;
/// - the objective has no value at the start;
/// - the search over club and ball does not converge, or their parameters have a negligible effect.
///
/// # Errors
/// The errors of [`optimum`](crate::study::optimum).
pub fn improve_from_club_alone(best: &mut Optimum) -> Result<Option<ClubAlone>> {
    let is_of_swing = |vary: &Vary| {
        let group = vary.parameter.group;
        matches!(group, ParameterGroup::Swing | ParameterGroup::Strike)
    };
    let vary = best.search.vary.iter().copied();
    let (club, swing): (Vec<_>, Vec<_>) = vary.partition(|vary| {
        let group = vary.parameter.group;
        matches!(group, ParameterGroup::Club | ParameterGroup::Ball)
    });
    if club.is_empty()
        || swing.is_empty()
        || !swing.iter().all(is_of_swing)
        || !best.search.scenarios.is_one_drive()
        || !best.is_converged()
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
    let club = optimum(&best.start, search, Observer::default())?;
    let value = club
        .value()
        .filter(|_| club.is_converged())
        .filter(|_| !(0..club.search.vary.len()).all(|i| club.is_idle(i)));
    let Some(value) = value else {
        return Ok(None);
    };
    let is_within = |vary: &Vary| {
        let own = best.start.value_or_unset(vary.parameter);
        own.is_some_and(|own| (vary.low..=vary.high).contains(&own))
    };
    if swing.iter().all(is_within) && is_better(value, best) {
        let start = with_own_swing(club.setup, &swing)?;
        let found = optimum(&start, best.search.clone(), Observer::default())?;
        if found.is_converged() && found.value().is_some_and(|value| is_better(value, best)) {
            *best = Optimum {
                start: best.start,
                drive_as_set_up: best.drive_as_set_up,
                ..found
            };
        }
    }
    let improvement = |before: f64, after: f64| -best.search.sense.sign() * (after - before);
    Ok(best.value().map(|best| ClubAlone {
        club_gain: improvement(as_set_up, value),
        swing_gain: improvement(value, best),
        optimum: club,
    }))
}

/// The setup in which each parameter of `swing` without a value has the value that it counts as. A
/// search then starts at the swing as set up, and not in the middle of the range.
fn with_own_swing(setup: Setup<f64>, swing: &[Vary]) -> Result<Setup<f64>> {
    let mut own = setup;
    for vary in swing {
        own.set_value(vary.parameter, setup.value_or_unset(vary.parameter))?;
    }
    Ok(own)
}

/// True if a value of the objective is better than that of `best`, by more than rounding.
fn is_better(value: f64, best: &Optimum) -> bool {
    best.value()
        .is_some_and(|least| best.search.sense.sign() * (value - least) < -ROUNDING * least.abs())
}
