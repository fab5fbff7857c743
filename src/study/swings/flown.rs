//! The outcomes of very many swings without derivatives, side by side.

use super::scenarios::Scenarios;
use crate::batch::Batch;
use crate::derivative::{Evaluator, Order};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup};
use crate::study::problem::moved;
use crate::study::stoppable::{each_until, stopped};
use std::sync::atomic::AtomicBool;

/// Swings that a thread flies at a time.
const BLOCK: usize = 512;

/// A column of values for each outcome: those of a setup with each swing.
///
/// # Errors
/// [`Error::NoFlight`], which names the first swing that does not fly; [`Error::NotConverged`] once
/// `stop` is true.
pub(super) fn columns(
    setup: &Setup<f64>,
    of: &[Outcome],
    scenarios: &Scenarios,
    stop: &AtomicBool,
) -> Result<Vec<Vec<f64>>> {
    let blocks: Vec<&[Vec<f64>]> = scenarios.points.chunks(BLOCK).collect();
    // a batch has parameters; one drive alone has none
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
            found.map_or_else(|| alone(setup, of, scenarios, point), Ok)
        };
        points.iter().enumerate().map(row).collect()
    };
    let flown = each_until(&blocks, stop, rows).ok_or_else(|| stopped("all swings were flown"))?;
    let flown = flown.into_iter().collect::<Result<Vec<_>>>()?.concat();
    Ok((0..of.len())
        .map(|i| flown.iter().map(|row| row[i]).collect())
        .collect())
}

/// The outcomes of one swing by itself, or why it does not fly.
fn alone(
    setup: &Setup<f64>,
    of: &[Outcome],
    scenarios: &Scenarios,
    point: &[f64],
) -> Result<Vec<f64>> {
    let swung = moved(setup, &scenarios.parameters, point)?;
    let found = Evaluator::new(&swung, of, &[], Order::Value)?.at(&[]);
    let found = found.map_err(|error| Error::NoFlight {
        reason: no_flight(scenarios, point, &error).into(),
    })?;
    Ok(found.into_iter().map(|outcome| outcome.value).collect())
}

/// Why a scenario does not fly, with its values; one drive alone has none.
pub(super) fn no_flight(scenarios: &Scenarios, point: &[f64], error: &Error) -> String {
    if scenarios.is_one_drive() {
        return error.to_string();
    }
    let value = |(parameter, value): (&&'static Parameter, &f64)| {
        format!("{} = {}", parameter.name, parameter.show(Some(*value)))
    };
    let values: Vec<_> = scenarios.parameters.iter().zip(point).map(value).collect();
    format!("the swing with {}: {error}", values.join(", "))
}
