//! Finds values of two parameters with which the ball lands at a target, by Newton's method with
//! exact first and second derivatives. Each step goes to the point within the ranges where the
//! quadratic model of the landing is nearest to the target. Second derivatives are needed, because
//! carry has a maximum over loft. If the setup's landing is far from the target, the search begins
//! at points of a grid whose landings are near to the target.

use crate::message;
use crate::refusal::Refusal;
use crate::request::{CheckedSetup, RangeRequest, SetupRequest};
use longdrive::derivative::{Evaluator, Order, Taylor};
use longdrive::number::Number;
use longdrive::optimize::{Domain, Evaluation, Exact, Functions, Options, minimize};
use longdrive::parameters::Vary;
use longdrive::study::Plane;
use longdrive::units::{Digits, Message, Quantity, System};
use longdrive::{Error, Outcome, Setup};
use serde::{Deserialize, Serialize};
use std::cell::Cell;

/// Distance between landing and target, m, that ends the search.
const REACHED: f64 = 1e-3;

/// Distance between landing and target, m, that a few steps of Newton's method can close.
const NEAR: f64 = 10.0;

/// Smallest step of the search, as a fraction of each range. A smaller step ends the search.
const SHORTEST: f64 = 1e-7;

/// Largest number of drives of the last search, which continues from the best point so far.
const MOST_DRIVES: u64 = 20;
/// Largest number of drives of the first search from each start. A few drives are enough, unless a
/// maximum of carry lies between start and target.
const FIRST_DRIVES: u64 = 3;

/// The largest number of halvings of a step.
const MOST_HALVINGS: usize = 3;

/// The nodes of the grid along both parameters.
const NODES: [usize; 2] = [13, 9];

/// The coordinates of the landing.
const LANDING: [Outcome; 2] = [Outcome::Carry, Outcome::Lateral];

/// The head of a request: the setup, two ranges, and the target, m.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    #[serde(default)]
    setup: SetupRequest,
    #[serde(default)]
    units: System,
    vary: [RangeRequest; 2],
    carry: f64,
    lateral: f64,
}

#[derive(Serialize)]
struct Head {
    status: &'static str,
    message: Option<String>,
    drives: u64,
    parameters: [&'static str; 2],
}

/// Answers with the values of both parameters, the landing, and its distance from the target.
///
/// # Errors
/// The message of the program, if the ball does not land at the start.
pub fn answer(request: &Request) -> Result<Vec<u8>, Refusal> {
    let checked = request.setup.read(request.units)?;
    let [first, second] = &request.vary;
    let vary = [checked.range(first)?, checked.range(second)?];
    let target = [request.carry, request.lateral];
    let best = Aim::new(&checked, vary, target).and_then(|aim| {
        let best = aim.best()?;
        Ok((best, aim.drives.get()))
    });
    let (best, drives) = best.map_err(|error| checked.refused(&error))?;
    let distance = best.distance();
    let is_reached = distance <= REACHED;
    let head = Head {
        status: if is_reached { "reached" } else { "nearest" },
        message: (!is_reached).then(|| unreached(&checked, &vary, distance)),
        drives,
        parameters: vary.map(|range| range.parameter.name),
    };
    let [first, second] = best.x;
    let [carry, lateral] = [0, 1].map(|axis| best.landing[axis].value);
    let numbers = [first, second, carry, lateral, distance];
    Ok(message::with_numbers(&head, &numbers))
}

/// The search for a target.
struct Aim {
    setup: Setup<f64>,
    evaluator: Evaluator,
    domain: Domain,
    vary: [Vary; 2],
    target: [f64; 2],
    /// Number of drives with derivatives so far.
    drives: Cell<u64>,
}

/// A drive of the search.
struct Point {
    x: [f64; 2],
    landing: Vec<Taylor>,
    target: [f64; 2],
}

impl Aim {
    fn new(checked: &CheckedSetup<'_>, vary: [Vary; 2], target: [f64; 2]) -> Result<Self, Error> {
        let wrt = vary.map(|range| range.parameter);
        let ends = |end: fn(&Vary) -> f64| vary.iter().map(end).collect();
        Ok(Self {
            setup: checked.setup,
            evaluator: Evaluator::new(&checked.setup, &LANDING, &wrt, Order::Second)?,
            domain: Domain::new(ends(|range| range.low), ends(|range| range.high))?,
            vary,
            target,
            drives: Cell::new(0),
        })
    }

    /// The drive that lands nearest to the target.
    fn best(&self) -> Result<Point, Error> {
        let setup = self.setup;
        let start = self
            .vary
            .map(|range| range.start(&setup).clamp(range.low, range.high));
        let mut best = self.fly(start)?;
        if best.distance() <= NEAR {
            best = self.search(best, FIRST_DRIVES)?;
        }
        if best.distance() <= REACHED {
            return Ok(best);
        }
        for start in self.starts(start)? {
            let Ok(first) = self.fly(start) else {
                continue;
            };
            let other = self.search(first, FIRST_DRIVES)?;
            if other.distance() < best.distance() {
                best = other;
            }
            if best.distance() <= REACHED {
                break;
            }
        }
        self.search(best, MOST_DRIVES)
    }

    /// Starts of the search. In each triangle of a grid, the landing is interpolated linearly: its
    /// start is the point that lands on the target, if there is one. The last start is the node
    /// that lands nearest to the target.
    fn starts(&self, from: [f64; 2]) -> Result<Vec<[f64; 2]>, Error> {
        let [across, up] = self.vary;
        let plane = Plane::fly(&self.setup, &LANDING, across, up, NODES, Order::Value)?;
        let misses = plane.values[0].iter().zip(&plane.values[1]);
        // the components of a miss are NaN for a drive that does not land
        let misses: Vec<[f64; 2]> = misses
            .map(|(along, right)| {
                let miss = |value: &Option<f64>, axis: usize| {
                    value.map_or(f64::NAN, |value| value - self.target[axis])
                };
                [miss(along, 0), miss(right, 1)]
            })
            .collect();
        let mut starts = vec![];
        for [corner, side, above] in triangles() {
            let Some([s, t]) = zero([misses[corner], misses[side], misses[above]]) else {
                continue;
            };
            let is_outside = s < 0.0 || t < 0.0 || s + t > 1.0;
            let [corner, side, above] = [corner, side, above].map(|node| plane.node(node));
            let [s, t] = [s, t].map(|part| part.clamp(0.0, 1.0));
            let x = corner[0] + s * (side[0] - corner[0]);
            let y = corner[1] + t * (above[1] - corner[1]);
            starts.push((is_outside, self.change(from, [x, y]), [x, y]));
        }
        // starts inside of their triangles come first; among these, the start nearest to `from`
        starts.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        let mut starts: Vec<_> = starts.into_iter().map(|(.., start)| start).collect();
        let distance = |node: &usize| misses[*node][0].hypot(misses[*node][1]);
        let nearest = (0..misses.len())
            .filter(|node| !distance(node).is_nan())
            .min_by(|a, b| distance(a).total_cmp(&distance(b)));
        starts.extend(nearest.map(|node| plane.node(node)));
        Ok(starts)
    }

    /// Continues a search: until the ball lands within half of [`REACHED`], until no step lands
    /// nearer to the target, or for `drives` drives.
    fn search(&self, mut best: Point, drives: u64) -> Result<Point, Error> {
        let last = self.drives.get() + drives;
        while best.distance() > 0.5 * REACHED && self.drives.get() < last {
            match self.step(&best)? {
                Some(next) => best = next,
                None => break,
            }
        }
        Ok(best)
    }

    /// The drive after a step. A step that does not land nearer to the target is halved; `None` if
    /// no halved step lands nearer either.
    fn step(&self, best: &Point) -> Result<Option<Point>, Error> {
        let mut to = self.nearest(best)?;
        for _ in 0..=MOST_HALVINGS {
            if self.change(best.x, to) <= SHORTEST {
                break;
            }
            match self.fly(to) {
                Ok(next) if next.distance() < best.distance() => return Ok(Some(next)),
                _ => to = [0, 1].map(|k| 0.5 * (best.x[k] + to[k])),
            }
        }
        Ok(None)
    }

    fn fly(&self, x: [f64; 2]) -> Result<Point, Error> {
        self.drives.set(self.drives.get() + 1);
        Ok(Point {
            x,
            landing: self.evaluator.at(&x)?,
            target: self.target,
        })
    }

    /// The point within the ranges where the quadratic model of the landing, expanded at `here`, is
    /// nearest to the target. The minimization starts at `here`, at both low ends, and at both high
    /// ends. At a maximum of carry, `here` alone could be a saddle point of the distance.
    fn nearest(&self, here: &Point) -> Result<[f64; 2], Error> {
        let model = Exact(Model(here));
        let bounds = &self.domain.variables;
        let (mut to, mut least) = (here.x, f64::INFINITY);
        for start in [&here.x[..], &bounds.low, &bounds.high] {
            let found = minimize(&model, &self.domain, start, &Options::default())?;
            let value = found.value.unwrap_or(f64::INFINITY);
            if value < least {
                (to, least) = ([found.x[0], found.x[1]], value);
            }
            if least <= REACHED * REACHED {
                break;
            }
        }
        Ok(to)
    }

    /// The largest change of a parameter between two points, as a fraction of its range.
    fn change(&self, from: [f64; 2], to: [f64; 2]) -> f64 {
        let parts = [0, 1].map(|k| (to[k] - from[k]) / (self.vary[k].high - self.vary[k].low));
        // in a range of one value the quotient is NaN, which `max` ignores
        parts
            .into_iter()
            .fold(0.0, |most, part| most.max(part.abs()))
    }
}

impl Point {
    /// The distance of the landing from the target, m.
    fn distance(&self) -> f64 {
        let [along, across] = [0, 1].map(|axis| self.landing[axis].value - self.target[axis]);
        along.hypot(across)
    }
}

/// Half of the squared distance between the target and the quadratic model of the landing, m².
struct Model<'a>(&'a Point);

impl Functions for Model<'_> {
    fn evaluate<T: Number>(&self, x: &[T]) -> Result<Evaluation<T>, String> {
        let d = [x[0] - self.0.x[0], x[1] - self.0.x[1]];
        let misses = self.0.landing.iter().zip(self.0.target);
        let objective = misses.fold(T::constant(0.0), |sum, (taylor, target)| {
            let [by, second] = [&taylor.gradient, &taylor.hessian[1]];
            let first = taylor.hessian[0][0];
            let bend = (d[0] * first + d[1] * second[0] * 2.0) * d[0] + d[1] * d[1] * second[1];
            let miss = d[0] * by[0] + d[1] * by[1] + bend * 0.5 + (taylor.value - target);
            sum + miss * miss * 0.5
        });
        Ok(Evaluation::unconstrained(objective))
    }
}

/// The triangles of the grid, two in each cell. A triangle lists its corner with the right angle,
/// the node beside this corner, and the node above or below this corner.
fn triangles() -> impl Iterator<Item = [usize; 3]> {
    let [columns, rows] = NODES;
    let cells = (0..rows - 1).flat_map(move |row| (0..columns - 1).map(move |k| row * columns + k));
    cells.flat_map(move |low| {
        let high = low + columns + 1;
        [[low, low + 1, high - 1], [high, high - 1, low + 1]]
    })
}

/// The point of a triangle at which a linear interpolation of the miss is 0 in both components, from
/// the misses at the corners. The answer is the position along the two sides that meet in the first
/// corner, as fractions of their lengths; `None` if it is farther from the triangle than `SLACK`.
/// Positions slightly outside count, because the miss is not exactly linear.
fn zero([corner, side, above]: [[f64; 2]; 3]) -> Option<[f64; 2]> {
    const SLACK: f64 = 0.1;
    let [a, b] = [side, above].map(|end| [end[0] - corner[0], end[1] - corner[1]]);
    let area = a[0] * b[1] - a[1] * b[0];
    let s = (b[0] * corner[1] - b[1] * corner[0]) / area;
    let t = (a[1] * corner[0] - a[0] * corner[1]) / area;
    let outside = (-s).max(-t).max(s + t - 1.0);
    (s.is_finite() && outside <= SLACK).then_some([s, t])
}

/// The message for a target that no drive within the ranges reaches.
fn unreached(checked: &CheckedSetup<'_>, vary: &[Vary; 2], distance: f64) -> String {
    let [first, second] = vary.map(|range| {
        let [low, high] = [range.low, range.high].map(|end| range.parameter.show(Some(end)));
        format!("{} {low} to {high}", range.parameter.name)
    });
    let message = Message::from(format!(
        "no ball lands there with {first} and {second}: the nearest landing is "
    ))
    .quantity(Quantity::LENGTH, "yd", distance, Digits::Significant(3))
    .words(" away");
    checked.text(&message)
}
