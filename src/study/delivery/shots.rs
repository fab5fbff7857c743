use super::result::Delivered;
use super::solve::delivery;
use super::unknown::Unknown;
use crate::drive::{Outcome, OutcomeGroup};
use crate::error::{Error, Result};
use crate::optimize::least_squares::FitStatus;
use crate::parameters::{Parameter, Setup};
use crate::statistics::Moments;
use crate::study::calibrate::{MeasuredShot, Measurement, ShotTable};
use rayon::prelude::*;
use serde::Serialize;
use std::sync::atomic::{AtomicBool, Ordering};

/// The delivery of one row, or its error.
#[derive(Debug)]
pub struct ShotDelivery {
    /// The row of the table, from 1.
    pub row: usize,
    /// The result for this row.
    pub found: Result<Delivered>,
}

impl ShotDelivery {
    /// The delivery, if the search converged and the delivery explains the launch.
    pub fn explained(&self) -> Option<&Delivered> {
        let delivered = self.found.as_ref().ok()?;
        let is_found =
            delivered.status == FitStatus::Converged && delivered.unexplained().is_none();
        is_found.then_some(delivered)
    }
}

/// Distribution of a parameter's estimates over all shots, SI.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Spread {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// Mean of the most probable values.
    pub mean: f64,
    /// Standard deviation of the most probable values; `null` for a single shot.
    pub deviation: Option<f64>,
}

/// The given launch conditions of a setup as measurements, with the uncertainties of instruments.
/// Empty if no launch is given.
pub fn launches(setup: &Setup<f64>) -> Vec<Measurement> {
    let given = setup.given_launch_conditions();
    given
        .into_iter()
        .filter_map(|condition| measured(condition, setup.value(condition)?))
        .collect()
}

/// A launch condition as a measured outcome; `None` if it is no outcome, or if its measurement
/// uncertainty is unknown.
fn measured(condition: &Parameter, value: f64) -> Option<Measurement> {
    let outcome = Outcome::named(condition.name.strip_prefix("launch.")?).ok()?;
    Some(Measurement {
        outcome,
        value,
        sigma: outcome.measurement_uncertainty()?,
    })
}

/// The delivery of each shot of a table. After an interrupt, the remaining rows are omitted.
pub fn deliveries(
    setup: &Setup<f64>,
    table: &ShotTable,
    unknowns: &[Unknown],
    interrupt: &AtomicBool,
) -> Vec<ShotDelivery> {
    let of = |shot: &MeasuredShot| {
        if interrupt.load(Ordering::Relaxed) {
            return None;
        }
        Some(ShotDelivery {
            row: shot.row,
            found: shot_delivery(setup, shot, unknowns),
        })
    };
    table.shots.par_iter().filter_map(of).collect()
}

fn shot_delivery(
    setup: &Setup<f64>,
    shot: &MeasuredShot,
    unknowns: &[Unknown],
) -> Result<Delivered> {
    let (mut own, mut unknowns) = (*setup, unknowns.to_vec());
    let (mut measured_unknowns, mut given) = (vec![], vec![]);
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
        match unknowns
            .iter_mut()
            .find(|unknown| unknown.parameter == parameter)
        {
            // a measured club value is uncertain: it becomes the prior
            Some(unknown) => {
                *unknown = unknown.with_measured_prior(value);
                measured_unknowns.push(parameter);
            }
            None => {
                own.set_value(parameter, Some(value))?;
                given.push(parameter);
            }
        }
    }
    if launch.is_empty() {
        let reason =
            "the row has no measured outcome of the launch, such as ball_speed or launch_angle"
                .into();
        return Err(Error::Delivery { reason });
    }
    Ok(Delivered {
        measured: measured_unknowns,
        given,
        ..delivery(&own, &launch, &unknowns)?
    })
}

impl Spread {
    /// The distribution of each unknown over the shots whose launch is explained. Empty if there is
    /// no such shot.
    pub fn of(all: &[ShotDelivery]) -> Vec<Self> {
        let found: Vec<&Delivered> = all.iter().filter_map(ShotDelivery::explained).collect();
        let first = found.first().map_or(&[][..], |first| &first.posteriors);
        let unknowns = first.iter().map(|posterior| posterior.unknown.parameter);
        unknowns
            .map(|parameter| Self::over(&found, parameter))
            .collect()
    }

    /// The distribution, over the shots whose launch is explained, of each parameter that a row of
    /// the table gives and that is not an unknown.
    pub fn of_given(all: &[ShotDelivery]) -> Vec<Self> {
        let found: Vec<&Delivered> = all.iter().filter_map(ShotDelivery::explained).collect();
        let mut given: Vec<&'static Parameter> = vec![];
        for parameter in found.iter().flat_map(|delivered| &delivered.given) {
            if !given.contains(parameter) {
                given.push(parameter);
            }
        }
        given
            .into_iter()
            .map(|parameter| Self::over(&found, parameter))
            .collect()
    }

    fn over(shots: &[&Delivered], parameter: &'static Parameter) -> Self {
        let values = shots.iter().filter_map(|shot| shot.setup.value(parameter));
        let moments = Moments::of(values);
        Self {
            parameter,
            mean: moments.mean.unwrap_or(f64::NAN),
            deviation: moments.deviation(),
        }
    }

    /// True if the shots have different values.
    pub fn differs(&self) -> bool {
        self.deviation.is_some_and(|deviation| deviation > 0.0)
    }
}

/// The setup of the shots in a table: each parameter that a row gives and that is not an unknown
/// has its mean over the shots whose launch is explained.
///
/// # Errors
/// The errors of [`Setup::set_value`].
pub fn setup_of_shots(setup: &Setup<f64>, all: &[ShotDelivery]) -> Result<Setup<f64>> {
    let mut own = *setup;
    for given in Spread::of_given(all) {
        own.set_value(given.parameter, Some(given.mean))?;
    }
    Ok(own)
}
