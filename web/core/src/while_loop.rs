//! The while-loop of the MAE 494 report along a parameter, beside the exact drive.

use crate::message;
use crate::refusal::Refusal;
use crate::request::{RangeRequest, SetupRequest};
use longdrive::batch::Batch;
use longdrive::parameters::Parameter;
use longdrive::reproduce::{LoopLanding, loop_landing};
use longdrive::units::System;
use longdrive::{Error, Outcome, Setup};
use serde::{Deserialize, Serialize};

/// The largest number of nodes.
const MOST_NODES: usize = 10_000;

/// The head of a request: the setup, the range of a parameter, and both steps of the loop.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    #[serde(default)]
    setup: SetupRequest,
    #[serde(default)]
    units: System,
    along: RangeRequest,
    nodes: usize,
    step: f64,
    difference: f64,
}

#[derive(Serialize)]
struct Head {
    status: &'static str,
    parameter: &'static str,
    nodes: usize,
}

/// Answers with carry and derivative at each node, by the loop and exactly.
///
/// # Errors
/// The message of the program, if the loop does not model the setup.
pub fn answer(request: &Request) -> Result<Vec<u8>, Refusal> {
    let checked = request.setup.read(request.units)?;
    let along = checked.range(&request.along)?;
    let Request {
        nodes,
        step,
        difference,
        ..
    } = *request;
    if !(2..=MOST_NODES).contains(&nodes) || difference == 0.0 || !difference.is_finite() {
        let why = format!(
            "{nodes} nodes and differences over {difference}; expected 2 to {MOST_NODES} nodes, \
             and a difference other than 0"
        );
        return Err(Refusal::of_request(&why));
    }
    let refused = |error: Error| checked.refused(&error);
    loop_landing(&checked.setup, step).map_err(refused)?;
    let part = |node: usize| node as f64 / (nodes - 1) as f64;
    let at = |node: usize| along.low + part(node) * (along.high - along.low);
    let values: Vec<f64> = (0..nodes).map(at).collect();
    let parameter = along.parameter;
    let landings = values.iter().map(|x| {
        let [here, there] =
            [*x, x + difference].map(|x| landed(&checked.setup, parameter, x, step));
        let slope = (there.overshot - here.overshot) / difference;
        [here.overshot, here.interpolated, slope]
    });
    let landings: Vec<[f64; 3]> = landings.collect();
    let batch = Batch::new(
        &checked.setup,
        &[parameter],
        &[Outcome::Carry],
        &[parameter],
    );
    let exact = batch.map_err(refused)?.evaluate(0, values.clone());
    let mut numbers = values;
    for column in 0..3 {
        numbers.extend(landings.iter().map(|landing| landing[column]));
    }
    for column in 0..2 {
        numbers.extend(exact.result(column).map(|value| value.unwrap_or(f64::NAN)));
    }
    let head = Head {
        status: "done",
        parameter: parameter.name,
        nodes,
    };
    Ok(message::with_numbers(&head, &numbers))
}

/// The landing of the loop at another value of the parameter; NaN if the ball does not land.
fn landed(setup: &Setup<f64>, parameter: &Parameter, x: f64, step: f64) -> LoopLanding {
    let mut moved = *setup;
    let landing = moved
        .set_value(parameter, Some(x))
        .and_then(|()| loop_landing(&moved, step));
    landing.unwrap_or(LoopLanding {
        overshot: f64::NAN,
        interpolated: f64::NAN,
    })
}
