//! The best compromises between two functions (Pareto), from the minimum of one to that of the
//! other, by continuation.
//!
//! With a and b, the two counted from 0 at their own minimum to 1 at that of the other, the front
//! is followed along s = a − b, from −1 to 1: at each s, a + b is minimised while a − b = s (after
//! the normal-boundary intersection of Das & Dennis 1998). The multiplier μ of that equation is the
//! front's slope, da/db = −(1 − μ)/(1 + μ), and dx/ds comes from the KKT system. A bound ε on b
//! alone, moved from one end to the other, gives the same points, but at an end that lies within
//! all bounds dx/dε is infinite; dx/ds is not.

mod combined;
mod context;
mod follow;
mod found;
mod places;

use super::domain::Domain;
use super::multistart::Follow;
use super::options::Options;
use super::problem::Problem;
use super::status::Status;
use crate::error::{Error, Result};
use combined::Combined;
use context::{FrontContext, of};
pub use found::{Front, FrontEvent, FrontPoint, NoFront};
use std::cell::Cell;

/// The front of two functions: the problem's objective, and the last of its constraint functions,
/// whose limits are not looked at. Both are minimised, in the domain of all others. `count` points
/// are spread evenly over the plane of the two, with the ends; where other bounds or limits begin
/// to hold, and at the knee, there are points besides.
///
/// `follow` is shown every search, with its number, and stops the work.
///
/// # Errors
/// [`NoFront::NoEnd`] where one of the two has no minimum that is found; else as
/// [`minimize`](super::minimize()).
pub fn front(
    problem: &dyn Problem,
    domain: &Domain,
    start: &[f64],
    (options, count): (&Options, usize),
    follow: &Follow,
) -> Result<Front, NoFront> {
    let others = domain.constraints.dimension().checked_sub(1);
    let others = others.ok_or_else(|| {
        Error::Optimizer("a front needs a second function; give a constraint".into())
    })?;
    let mut limits = domain.constraints.clone();
    limits.low.truncate(others);
    limits.high.truncate(others);
    let domain = Domain {
        variables: domain.variables.clone(),
        constraints: limits,
    };
    let context = FrontContext {
        problem,
        domain,
        options,
        follow,
        searches: Cell::new(0),
    };
    let alone = |k: usize, from: &[f64]| {
        let found = context.search(
            &Combined::of(problem, of(k)),
            &context.domain,
            from,
            options,
        )?;
        match found.status {
            Status::Converged => Ok(found),
            _ => Err(NoFront::NoEnd {
                function: k,
                found: Box::new(found),
            }),
        }
    };
    let first = alone(0, start)?;
    let at_first = context.values(&first.x)?;
    // what it is stopped after is an end alone, or both
    let second = alone(1, start).and_then(|second| Ok((context.values(&second.x)?, second)));
    let (at_second, second) = match second {
        Err(_) if context.is_interrupted() => return Ok(context.ends_alone([(first, at_first)])),
        second => second?,
    };
    let (values, ends) = ([at_first, at_second], [first, second]);
    if let Some(best) = context.best_for_both(&ends, values) {
        return Ok(best);
    }
    let [first, second] = ends.clone();
    let sharper = context.one_point(0, first, values).and_then(|first| {
        let ends = [first, context.one_point(1, second, values)?];
        Ok((context.ends(&ends)?, ends))
    });
    let (values, ends) = match sharper {
        Err(_) if context.is_interrupted() => {
            return Ok(context.ends_alone(ends.into_iter().zip(values)));
        }
        sharper => sharper?,
    };
    match context.best_for_both(&ends, values) {
        Some(best) => Ok(best),
        None => Ok(follow::followed(&context, ends, values, count)?),
    }
}
