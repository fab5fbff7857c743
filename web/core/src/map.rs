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
    #[serde(default)]
    gradients: bool,
}

#[derive(Serialize)]
struct Head<'a> {
    status: &'static str,
    columns: usize,
    rows: usize,
    of: &'a [String],
    gradients: bool,
}

/// Answers with the outcomes at the nodes, and their derivatives if the request asks for them.
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
    let order = match request.gradients {
        true => Order::First,
        false => Order::Value,
    };
    let plane = Plane::fly(&checked.setup, &of, across, up, nodes, order);
    let plane = plane.map_err(|error| checked.refused(&error))?;
    let mut numbers = Vec::with_capacity(columns * rows * of.len());
    for (of, values) in plane.values.iter().enumerate() {
        numbers.extend(values.iter().map(|value| value.unwrap_or(f64::NAN)));
        for axis in 0..if request.gradients { 2 } else { 0 } {
            let gradients = plane.gradients[of].iter();
            numbers.extend(gradients.map(|found| found.map_or(f64::NAN, |found| found[axis])));
        }
    }
    let head = Head {
        status: "done",
        columns,
        rows,
        of: &request.of,
        gradients: request.gradients,
    };
    Ok(message::with_numbers(&head, &numbers))
}
