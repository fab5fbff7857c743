//! Two parameters for a landing point: a least-squares fit of the landing with exact Jacobians,
//! within the ranges of the parameters.

use crate::message;
use crate::refusal::Refusal;
use crate::request::{Asked, RangeText, SetupText, Units};
use longdrive::derivative::{Evaluator, Order};
use longdrive::optimize::Domain;
use longdrive::optimize::least_squares::{Fit, Options, Rows, fit};
use longdrive::parameters::Vary;
use longdrive::units::{Digits, Message, Quantity};
use longdrive::{Error, Outcome};
use serde::{Deserialize, Serialize};

/// A landing this near to the target has reached it, m.
const REACHED: f64 = 1e-3;

/// The coordinates of the landing.
const LANDING: [Outcome; 2] = [Outcome::Carry, Outcome::Lateral];

/// The request.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    #[serde(default)]
    setup: SetupText,
    #[serde(default)]
    units: Units,
    vary: [RangeText; 2],
    carry: f64,
    lateral: f64,
}

/// The head of the answer.
#[derive(Serialize)]
struct Head {
    status: &'static str,
    message: Option<String>,
    drives: u64,
    parameters: [&'static str; 2],
}

/// The answer.
///
/// # Errors
/// The message of the program, if the ball does not land at the start.
pub fn answer(request: &Request) -> Result<Vec<u8>, Refusal> {
    let asked = request.setup.read(request.units)?;
    let [first, second] = &request.vary;
    let vary = [asked.range(first)?, asked.range(second)?];
    let target = [request.carry, request.lateral];
    let found = aimed(&asked, &vary, target).map_err(|error| asked.refused(&error))?;
    let [carry, lateral] = [0, 1].map(|axis| target[axis] + found.rows.residuals[axis]);
    let distance = found.rows.residuals[0].hypot(found.rows.residuals[1]);
    let is_reached = distance <= REACHED;
    let head = Head {
        status: if is_reached { "reached" } else { "nearest" },
        message: (!is_reached).then(|| unreached(&asked, &vary, distance)),
        drives: found.evaluations,
        parameters: vary.map(|range| range.parameter.name),
    };
    let numbers = [found.x[0], found.x[1], carry, lateral, distance];
    Ok(message::with_numbers(&head, &numbers))
}

/// The fit of the landing to the target.
fn aimed(asked: &Asked<'_>, vary: &[Vary; 2], target: [f64; 2]) -> Result<Fit, Error> {
    let wrt = vary.map(|range| range.parameter);
    let evaluator = Evaluator::new(&asked.setup, &LANDING, &wrt, Order::First)?;
    let residuals = |x: &[f64]| {
        let landing = evaluator.at(x).map_err(|error| error.to_string())?;
        let misses = landing.iter().zip(target);
        Ok(Rows {
            residuals: misses.map(|(found, target)| found.value - target).collect(),
            jacobian: landing.into_iter().map(|found| found.gradient).collect(),
        })
    };
    let ends = |end: fn(&Vary) -> f64| vary.iter().map(end).collect();
    let domain = Domain::new(ends(|range| range.low), ends(|range| range.high))?;
    let start = vary.map(|range| range.start(&asked.setup));
    let options = Options {
        // the two coordinates of a landing within the tolerance
        rounding: 0.5 * REACHED,
        ..Options::default()
    };
    let found = fit(&residuals, &domain, &start, &options)?;
    if found.rows.residuals.is_empty() {
        // the drive at the start has the reason
        evaluator.at(&found.x)?;
    }
    Ok(found)
}

/// The message of a target that the ranges do not reach.
fn unreached(asked: &Asked<'_>, vary: &[Vary; 2], distance: f64) -> String {
    let [first, second] = vary.map(|range| {
        let [low, high] = [range.low, range.high].map(|end| range.parameter.show(Some(end)));
        format!("{} {low} to {high}", range.parameter.name)
    });
    let message = Message::from(format!(
        "no ball lands there with {first} and {second}: the nearest landing is "
    ))
    .quantity(Quantity::LENGTH, "yd", distance, Digits::Significant(3))
    .words(" away");
    asked.text(&message)
}
