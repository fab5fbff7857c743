//! The outcomes of many swings without derivatives, in batches.

use super::scenarios::Scenarios;
use crate::batch::Batch;
use crate::derivative::{Evaluator, Order};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup};
use crate::study::cancellable::{each_until, stopped_before};
use std::sync::atomic::AtomicBool;

/// Number of swings in a batch, the unit of work of one thread.
const BLOCK: usize = 512;

/// Outcomes of a setup for each swing: a column of values for each outcome.
///
/// # Errors
/// [`Error::NoFlight`], which names the first swing in which the ball does not fly;
/// [`Error::NotConverged`] once `stop` is true.
pub(in crate::study) fn columns(
    setup: &Setup<f64>,
    of: &[Outcome],
    scenarios: &Scenarios,
    stop: &AtomicBool,
) -> Result<Vec<Vec<f64>>> {
    let blocks: Vec<&[Vec<f64>]> = scenarios.points.chunks(BLOCK).collect();
    // a batch needs a parameter that varies, and the scenario of one drive has none
    let batch = match scenarios.is_one_drive() {
        true => None,
        false => Some(Batch::new(setup, &scenarios.parameters, of, &[])?),
    };
    let rows = |points: &&[Vec<f64>]| -> Result<Vec<Vec<f64>>> {
        let block = batch
            .as_ref()
            .map(|batch| batch.evaluate(0, points.concat()));
        let row = |(k, point): (usize, &Vec<f64>)| {
            let found = block
                .as_ref()
                .and_then(|block| block.outcomes(k).collect::<Option<Vec<f64>>>());
            found.map_or_else(|| of_swing(setup, of, scenarios, point), Ok)
        };
        points.iter().enumerate().map(row).collect()
    };
    let flown =
        each_until(&blocks, stop, rows).ok_or_else(|| stopped_before("all swings were flown"))?;
    let flown = flown.into_iter().collect::<Result<Vec<_>>>()?.concat();
    Ok((0..of.len())
        .map(|i| flown.iter().map(|row| row[i]).collect())
        .collect())
}

/// The outcomes of one swing, computed without a batch. This is necessary for a search over one
/// drive, and for a swing that has no outcomes in its batch.
///
/// # Errors
/// [`Error::NoFlight`] if the ball does not fly.
fn of_swing(
    setup: &Setup<f64>,
    of: &[Outcome],
    scenarios: &Scenarios,
    point: &[f64],
) -> Result<Vec<f64>> {
    let swung = setup.with_values(&scenarios.parameters, point)?;
    let found = Evaluator::new(&swung, of, &[], Order::Value)?.at(&[]);
    let found = found.map_err(|error| Error::NoFlight {
        status: "no-flight",
        reason: no_flight(scenarios, point, &error).into(),
    })?;
    Ok(found.into_iter().map(|outcome| outcome.value).collect())
}

/// Message that the ball does not fly in a scenario. It names the values of the scenario's
/// parameters.
pub(in crate::study) fn no_flight(scenarios: &Scenarios, point: &[f64], error: &Error) -> String {
    if scenarios.is_one_drive() {
        return error.to_string();
    }
    let value = |(parameter, value): (&&'static Parameter, &f64)| {
        format!("{} = {}", parameter.name, parameter.show(Some(*value)))
    };
    let values: Vec<_> = scenarios.parameters.iter().zip(point).map(value).collect();
    format!("the swing with {}: {error}", values.join(", "))
}
