//! One compromise, and the next beside it.

use super::combined::Combined;
use super::context::{FrontContext, with_limit};
use crate::error::{Error, Result};
use crate::number::Taylor;
use crate::optimize::continuation::predicted;
use crate::optimize::domain::Domain;
use crate::optimize::problem::Evaluation;
use crate::optimize::sensitivity::{Held, Response, first_event, response};
use crate::optimize::solution::Solution;
use crate::optimize::status::Status;

/// A front that is steeper than this in the plane, or flatter than its inverse, is upright or
/// level: the rest is rounding.
const STEEPEST: f64 = 1e8;

/// A compromise, with what is known of its neighbours.
#[derive(Clone)]
pub(super) struct Place {
    /// s = a − b.
    pub at: f64,
    /// a + b.
    pub sum: f64,
    pub x: Vec<f64>,
    pub values: [f64; 2],
    pub slope: Option<f64>,
    /// dx/ds; zeros where it is not known, and staying is the best guess.
    pub rates: Vec<f64>,
    pub held: Held,
    pub known: Option<(Solution, Response)>,
}

/// The plane of the two functions, each from 0 at its minimum to 1 at that of the other.
pub(super) struct Plane<'a> {
    pub context: &'a FrontContext<'a>,
    pub zero: [f64; 2],
    pub span: [f64; 2],
}

impl Plane<'_> {
    /// The sum of the two in the plane, and, held, their difference.
    fn combined(&self, is_held: bool) -> Combined<'_> {
        let [a, b] = self.span.map(|span| 1.0 / span);
        Combined {
            problem: self.context.problem,
            zero: self.zero,
            of: [a, b],
            held: is_held.then_some([a, -b]),
        }
    }

    /// Where a function's own minimum lies.
    pub fn end(&self, k: usize, end: Solution, values: [f64; 2]) -> Place {
        let at = if k == 0 { -1.0 } else { 1.0 };
        let context = self.context;
        let bare = Place {
            at,
            sum: 1.0,
            x: end.x.clone(),
            values,
            slope: None,
            rates: vec![0.0; end.x.len()],
            held: self.held(&end),
            known: None,
        };
        // the same point as a compromise, which says how the front leaves it
        match self.found(at, &end.x) {
            Ok(place) if context.apart(&place.x, &end.x) < 1e-4 => Place {
                x: end.x,
                values,
                at,
                sum: 1.0,
                ..place
            },
            _ => bare,
        }
    }

    /// What holds a function's own minimum.
    pub fn held(&self, end: &Solution) -> Held {
        let domain = &self.context.domain;
        let mut held = Held::new(end, domain);
        held.constraints.truncate(domain.constraints.dimension());
        held
    }

    /// The compromise at s, searched for from a point nearby.
    pub fn found(&self, at: f64, from: &[f64]) -> Result<Place> {
        let domain = self.domain(at);
        let solution =
            self.context
                .search(&self.combined(true), &domain, from, &self.context.near())?;
        if solution.status != Status::Converged {
            let message = solution.message.clone().into();
            return Err(Error::NotConverged {
                status: solution.status.name(),
                message,
            });
        }
        let mut held = Held::new(&solution, &domain);
        held.constraints.pop();
        let known = response(&solution, &domain, &by_limit(&solution)).ok();
        let sum = solution.value.unwrap_or(f64::NAN);
        let (difference, price) = solution
            .constraints
            .last()
            .map_or((at, 0.0), |last| (last.value, last.multiplier));
        let [a, b] = [0.5 * (sum + difference), 0.5 * (sum - difference)];
        let slope = match (1.0 - price) / (1.0 + price) {
            slope if slope.abs() < STEEPEST.recip() => Some(0.0),
            slope => Some(-slope).filter(|slope| slope.abs() < STEEPEST),
        };
        Ok(Place {
            at,
            sum,
            x: solution.x.clone(),
            values: [
                self.zero[0] + a * self.span[0],
                self.zero[1] + b * self.span[1],
            ],
            // where the optimum is not isolated, its multipliers are not either
            slope: known
                .as_ref()
                .and(slope)
                .map(|slope| slope * self.span[0] / self.span[1]),
            rates: known
                .as_ref()
                .map_or_else(|| vec![0.0; solution.x.len()], |known| known.x.clone()),
            held,
            known: known.map(|known| (solution, known)),
        })
    }

    /// The compromise at another s, and how far it is from where it was predicted, in units of the
    /// ranges.
    pub fn next(&self, here: &Place, to: f64) -> Result<(Place, f64)> {
        let bounds = &self.context.domain.variables;
        let predicted = predicted(&here.x, &here.rates, to - here.at, bounds);
        let found = self.found(to, &predicted)?;
        let apart = self.context.apart(&found.x, &predicted);
        Ok((found, apart))
    }

    /// Where other bounds or limits begin to hold on the way to another s, to first order.
    pub fn expected(&self, here: &Place, to: f64) -> Option<f64> {
        let (solution, response) = here.known.as_ref()?;
        let (part, _) = first_event(solution, &self.domain(here.at), response, to - here.at)?;
        Some(here.at + part * (to - here.at))
    }

    /// The point of the front that lies farthest from the straight line between its ends, near one:
    /// the least a + b.
    pub fn knee(&self, near: &Place) -> Result<Place> {
        let context = self.context;
        let found = context.search(
            &self.combined(false),
            &context.domain,
            &near.x,
            &context.near(),
        )?;
        let values = context.values(&found.x)?;
        let [a, b]: [f64; 2] = std::array::from_fn(|k| (values[k] - self.zero[k]) / self.span[k]);
        self.found(a - b, &found.x)
    }

    fn domain(&self, at: f64) -> Domain {
        with_limit(&self.context.domain, at, at)
    }
}

/// The functions by (x, s): the last limit alone moves with s.
fn by_limit(solution: &Solution) -> Evaluation {
    let n = solution.x.len();
    let mut hessian = vec![vec![]; n];
    hessian.push(vec![0.0; n + 1]);
    let still = Taylor {
        value: 0.0,
        gradient: vec![0.0; n + 1],
        hessian,
    };
    let mut constraints = vec![still.clone(); solution.constraints.len()];
    if let Some(last) = constraints.last_mut() {
        last.gradient[n] = -1.0;
    }
    Evaluation {
        objective: still,
        constraints,
    }
}
