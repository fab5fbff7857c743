//! Two parameters for a landing point, by Newton's method with exact first and second derivatives:
//! each step goes to the point where the quadratic model of the landing comes nearest to the
//! target, within the ranges. The curvature matters, since carry has a maximum over loft.

use crate::message;
use crate::refusal::Refusal;
use crate::request::{Asked, RangeText, SetupText, Units};
use longdrive::derivative::{Evaluator, Order, Taylor};
use longdrive::optimize::Domain;
use longdrive::optimize::least_squares::{Fit, Options, Rows, fit};
use longdrive::parameters::Vary;
use longdrive::units::{Digits, Message, Quantity};
use longdrive::{Error, Outcome};
use serde::{Deserialize, Serialize};

/// A landing this near to the target has reached it, m.
const REACHED: f64 = 1e-3;

/// A step below this part of each range ends the search.
const SHORTEST: f64 = 1e-7;

/// The largest number of drives of a target.
const MOST_DRIVES: u64 = 40;

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
    let aim = Aim::new(&asked, vary, target).map_err(|error| asked.refused(&error))?;
    let found = aim.search().map_err(|error| asked.refused(&error))?;
    let distance = found.best.distance();
    let is_reached = distance <= REACHED;
    let head = Head {
        status: if is_reached { "reached" } else { "nearest" },
        message: (!is_reached).then(|| unreached(&asked, &vary, distance)),
        drives: found.drives,
        parameters: vary.map(|range| range.parameter.name),
    };
    let [first, second] = found.best.x;
    let [carry, lateral] = [0, 1].map(|axis| found.best.landing[axis].value);
    let numbers = [first, second, carry, lateral, distance];
    Ok(message::with_numbers(&head, &numbers))
}

/// The search for a target.
struct Aim {
    evaluator: Evaluator,
    domain: Domain,
    vary: [Vary; 2],
    start: [f64; 2],
    target: [f64; 2],
}

/// The end of a search.
struct Found {
    best: Point,
    drives: u64,
}

/// A drive of the search.
struct Point {
    x: [f64; 2],
    landing: Vec<Taylor>,
    target: [f64; 2],
}

impl Aim {
    fn new(asked: &Asked<'_>, vary: [Vary; 2], target: [f64; 2]) -> Result<Self, Error> {
        let wrt = vary.map(|range| range.parameter);
        let ends = |end: fn(&Vary) -> f64| vary.iter().map(end).collect();
        let start = vary.map(|range| range.start(&asked.setup).clamp(range.low, range.high));
        Ok(Self {
            evaluator: Evaluator::new(&asked.setup, &LANDING, &wrt, Order::Second)?,
            domain: Domain::new(ends(|range| range.low), ends(|range| range.high))?,
            vary,
            start,
            target,
        })
    }

    fn search(&self) -> Result<Found, Error> {
        let mut best = self.fly(self.start)?;
        let mut drives = 1;
        while best.distance() > 0.5 * REACHED {
            let mut to = self.nearest(&best)?;
            // a drive that does not land, or lands farther away, halves the step
            let next = loop {
                if drives == MOST_DRIVES || self.is_short(best.x, to) {
                    break None;
                }
                drives += 1;
                match self.fly(to) {
                    Ok(next) if next.distance() < best.distance() => break Some(next),
                    _ => to = [0, 1].map(|k| 0.5 * (best.x[k] + to[k])),
                }
            };
            match next {
                Some(next) => best = next,
                None => break,
            }
        }
        Ok(Found { best, drives })
    }

    fn fly(&self, x: [f64; 2]) -> Result<Point, Error> {
        Ok(Point {
            x,
            landing: self.evaluator.at(&x)?,
            target: self.target,
        })
    }

    /// The point in the ranges where the model of the landing at `here` is nearest to the target.
    /// The model may have several such points: the search for it begins at `here`, in the middle
    /// and at the corners of the ranges.
    fn nearest(&self, here: &Point) -> Result<[f64; 2], Error> {
        let options = Options {
            rounding: 1e-3 * REACHED,
            tolerance: 1e-8,
            ..Options::default()
        };
        let [a, b] = self.vary;
        let middle = [a, b].map(|range| 0.5 * (range.low + range.high));
        let corners = [
            [a.low, b.low],
            [a.high, b.high],
            [a.low, b.high],
            [a.high, b.low],
        ];
        let starts = [here.x, middle].into_iter().chain(corners);
        let model = |x: &[f64]| Ok(here.model(x));
        let mut best: Option<Fit> = None;
        for start in starts {
            let found = fit(&model, &self.domain, &start, &options)?;
            if best.as_ref().is_none_or(|best| found.cost < best.cost) {
                best = Some(found);
            }
            if best
                .as_ref()
                .is_some_and(|best| best.cost <= REACHED * REACHED)
            {
                break;
            }
        }
        Ok(best.map_or(here.x, |best| [best.x[0], best.x[1]]))
    }

    fn is_short(&self, from: [f64; 2], to: [f64; 2]) -> bool {
        let part = |k: usize| (to[k] - from[k]).abs() / (self.vary[k].high - self.vary[k].low);
        // NaN for a range of one value, in which there is no step
        [0, 1].iter().all(|k| !(part(*k) > SHORTEST))
    }
}

impl Point {
    /// The distance of the landing from the target, m.
    fn distance(&self) -> f64 {
        let [along, across] = [0, 1].map(|axis| self.landing[axis].value - self.target[axis]);
        along.hypot(across)
    }

    /// The misses of the quadratic model of the landing at `x`, with their derivatives.
    fn model(&self, x: &[f64]) -> Rows {
        let d = [x[0] - self.x[0], x[1] - self.x[1]];
        let mut rows = Rows::default();
        for (taylor, target) in self.landing.iter().zip(self.target) {
            let Taylor {
                value,
                gradient,
                hessian,
            } = taylor;
            let bend = [0, 1].map(|k| hessian[k][0] * d[0] + hessian[k][1] * d[1]);
            let change = |k: usize| (gradient[k] + 0.5 * bend[k]) * d[k];
            rows.residuals.push(value - target + change(0) + change(1));
            rows.jacobian
                .push(vec![gradient[0] + bend[0], gradient[1] + bend[1]]);
        }
        rows
    }
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
