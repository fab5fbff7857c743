//! Outcomes at the nodes of a grid over two parameters.

use crate::message;
use crate::refusal::Refusal;
use crate::request::{RangeRequest, SetupRequest};
use longdrive::derivative::Order;
use longdrive::study::Plane;
use longdrive::units::System;
use serde::{Deserialize, Serialize};

/// The largest number of nodes.
const MOST_NODES: usize = 250_000;

/// The head of a request: the setup, the outcomes, and the ranges of both parameters.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    #[serde(default)]
    setup: SetupRequest,
    #[serde(default)]
    units: System,
    of: Vec<String>,
    across: RangeRequest,
    up: RangeRequest,
    nodes: [usize; 2],
}

#[derive(Serialize)]
struct Head<'a> {
    status: &'static str,
    columns: usize,
    rows: usize,
    of: &'a [String],
}

/// Answers with the outcomes at the nodes.
///
/// # Errors
/// The message of the program, if there is no map.
pub fn answer(request: &Request) -> Result<Vec<u8>, Refusal> {
    let checked = request.setup.read(request.units)?;
    let of = checked.outcomes(&request.of)?;
    let across = checked.range(&request.across)?;
    let up = checked.range(&request.up)?;
    let nodes @ [columns, rows] = request.nodes;
    let is_small = columns
        .checked_mul(rows)
        .is_some_and(|all| all <= MOST_NODES);
    if columns < 2 || rows < 2 || !is_small {
        let why = format!(
            "a map of {columns} x {rows} nodes; expected 2 or more along each side, and at most \
             {MOST_NODES} in all"
        );
        return Err(Refusal::of_request(&why));
    }
    let plane = Plane::fly(&checked.setup, &of, across, up, nodes, Order::Value);
    let plane = plane.map_err(|error| checked.refused(&error))?;
    let values = plane.values.iter().flatten();
    let numbers: Vec<f64> = values.map(|value| value.unwrap_or(f64::NAN)).collect();
    let head = Head {
        status: "done",
        columns,
        rows,
        of: &request.of,
    };
    Ok(message::with_numbers(&head, &numbers))
}
