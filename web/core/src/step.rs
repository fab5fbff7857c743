//! The longest integration step in which all drives within the ranges of a request are accurate.

use crate::message;
use crate::refusal::Refusal;
use crate::request::{RangeRequest, SetupRequest};
use longdrive::Outcome;
use longdrive::drive::OutcomeGroup;
use longdrive::integration::accuracy;
use longdrive::units::System;
use serde::{Deserialize, Serialize};

/// The head of a request: the setup, the ranges, and the outcomes with their tolerance.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    #[serde(default)]
    setup: SetupRequest,
    #[serde(default)]
    units: System,
    #[serde(default)]
    of: Vec<String>,
    #[serde(default)]
    ranges: Vec<RangeRequest>,
    tolerance: f64,
}

#[derive(Serialize)]
struct Head {
    status: &'static str,
    method: &'static str,
    step: f64,
    error: f64,
}

/// Answers with method and step, and with the largest error found.
///
/// # Errors
/// The message of the program, if no step meets the tolerance.
pub fn answer(request: &Request) -> Result<Vec<u8>, Refusal> {
    let checked = request.setup.read(request.units)?;
    let of = match request.of.as_slice() {
        [] => Outcome::in_group(OutcomeGroup::Flight).collect(),
        names => checked.outcomes(names)?,
    };
    let ranges = request.ranges.iter().map(|range| checked.range(range));
    let ranges = ranges.collect::<Result<Vec<_>, _>>()?;
    let found = accuracy(&checked.setup, &ranges, &of, request.tolerance);
    let found = found.map_err(|error| checked.refused(&error))?;
    let head = Head {
        status: "done",
        method: found.method.name(),
        step: found.step,
        error: found.error,
    };
    Ok(message::written(&head, &[]))
}
