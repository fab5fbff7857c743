//! The integration of a session: the longest step with which the drives of some ranges are
//! accurate.

use crate::message;
use crate::refusal::Refusal;
use crate::request::{RangeText, SetupText, Units};
use longdrive::Outcome;
use longdrive::drive::OutcomeGroup;
use longdrive::study::accuracy;
use serde::{Deserialize, Serialize};

/// The request.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    #[serde(default)]
    setup: SetupText,
    #[serde(default)]
    units: Units,
    #[serde(default)]
    of: Vec<String>,
    #[serde(default)]
    ranges: Vec<RangeText>,
    tolerance: f64,
}

/// The head of the answer.
#[derive(Serialize)]
struct Head {
    status: &'static str,
    method: &'static str,
    step: f64,
    error: f64,
}

/// The answer.
///
/// # Errors
/// The message of the program, if no step meets the tolerance.
pub fn answer(request: &Request) -> Result<Vec<u8>, Refusal> {
    let asked = request.setup.read(request.units)?;
    let of = match request.of.as_slice() {
        [] => of_the_flight(),
        names => asked.outcomes(names)?,
    };
    let ranges = request.ranges.iter().map(|range| asked.range(range));
    let ranges = ranges.collect::<Result<Vec<_>, _>>()?;
    let found = accuracy(&asked.setup, &ranges, &of, request.tolerance);
    let found = found.map_err(|error| asked.refused(&error))?;
    let head = Head {
        status: "done",
        method: found.method.name(),
        step: found.step,
        error: found.error,
    };
    Ok(message::written(&head, &[]))
}

fn of_the_flight() -> Vec<Outcome> {
    let all = Outcome::ALL.iter().copied();
    all.filter(|of| of.group() == OutcomeGroup::Flight)
        .collect()
}
