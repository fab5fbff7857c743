use super::found::Delivered;
use super::solve::delivery;
use super::unknown::Unknown;
use crate::drive::{Outcome, OutcomeGroup};
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup};
use crate::study::calibrate::{Measurement, Shot, ShotTable, instrument};
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};

/// The delivery of a row of shots, or why there is none.
#[derive(Debug)]
pub struct Delivery {
    /// The row of the table, from 1.
    pub row: usize,
    /// What was found.
    pub found: Result<Delivered>,
}

impl Delivery {
    /// What was found, where the search converged and explains the launch.
    pub fn explained(&self) -> Option<&Delivered> {
        self.found
            .as_ref()
            .ok()
            .filter(|delivered| delivered.is_found())
    }
}

/// A parameter over all shots, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// The mean of the most probable values.
    pub mean: f64,
    /// Their standard deviation; `None` of a single shot.
    pub deviation: Option<f64>,
}

/// The measured launch that a setup gives as its launch conditions, with the uncertainties of
/// instruments; none where no launch is given.
pub fn launches(setup: &Setup<f64>) -> Vec<Measurement> {
    let given = setup.given_launch_conditions();
    given
        .into_iter()
        .filter_map(|condition| measured(condition, setup.value(condition)?))
        .collect()
}

/// A launch condition as a measured outcome.
fn measured(condition: &Parameter, value: f64) -> Option<Measurement> {
    let outcome = Outcome::named(condition.name.strip_prefix("launch.")?).ok()?;
    Some(Measurement {
        outcome,
        value,
        sigma: instrument(outcome)?.1,
    })
}

/// The delivery of each shot of a table; rows that were not reached before `interrupt` are left
/// out.
pub fn deliveries(
    setup: &Setup<f64>,
    table: &ShotTable,
    unknowns: &[Unknown],
    interrupt: &AtomicBool,
) -> Vec<Delivery> {
    let of = |shot: &Shot| {
        if interrupt.load(Ordering::Relaxed) {
            return None;
        }
        Some(Delivery {
            row: shot.row,
            found: of_shot(setup, shot, unknowns),
        })
    };
    table.shots.par_iter().filter_map(of).collect()
}

fn of_shot(setup: &Setup<f64>, shot: &Shot, unknowns: &[Unknown]) -> Result<Delivered> {
    let (mut own, mut sought) = (*setup, unknowns.to_vec());
    let mut launch: Vec<Measurement> = shot
        .measured
        .iter()
        .filter(|measured| measured.outcome.group() == OutcomeGroup::Launch)
        .copied()
        .collect();
    for &(parameter, value) in &shot.inputs {
        if parameter.is_of_launch() {
            launch.extend(measured(parameter, value));
            continue;
        }
        match sought
            .iter_mut()
            .find(|unknown| unknown.parameter == parameter)
        {
            // a measured delivery is known before, and not exactly
            Some(unknown) => *unknown = unknown.measured_as(value),
            None => own.set_value(parameter, Some(value))?,
        }
    }
    if launch.is_empty() {
        let reason =
            "no outcome of the launch is measured in the row, such as ball_speed or launch_angle"
                .into();
        return Err(Error::Delivery { reason });
    }
    delivery(&own, &launch, &sought)
}

impl Spread {
    /// Each parameter sought over the shots whose delivery was found.
    pub fn of(all: &[Delivery]) -> Vec<Self> {
        let found: Vec<&Delivered> = all.iter().filter_map(Delivery::explained).collect();
        let Some(first) = found.first() else {
            return vec![];
        };
        let count = found.len() as f64;
        let one = |i: usize| {
            let values = || found.iter().map(|delivered| delivered.known[i].value);
            let mean = values().sum::<f64>() / count;
            let squares: f64 = values().map(|value| (value - mean) * (value - mean)).sum();
            let deviation = (found.len() > 1).then(|| (squares / (count - 1.0)).sqrt());
            Self {
                parameter: first.known[i].unknown.parameter,
                mean,
                deviation,
            }
        };
        (0..first.known.len()).map(one).collect()
    }
}
