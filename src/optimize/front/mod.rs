//! Pareto front of two functions, by continuation from the minimum of one function to the minimum
//! of the other function.
//!
//! Let a and b be the two functions, scaled to 0 at their own minimum and 1 at the other function's
//! minimum. The front is followed along s = a − b from −1 to 1: at each s, a + b is minimized
//! subject to a − b = s (normal-boundary intersection, Das & Dennis 1998). The multiplier μ of this
//! equality gives the slope of the front, da/db = −(1 − μ)/(1 + μ), and the KKT system gives dx/ds.
//! The ε-constraint method, a bound ε on b, finds the same points, but dx/dε is infinite at an end
//! of the front that lies inside the bounds of x; dx/ds is finite there.

mod compromise;
mod context;
mod result;
mod trace;

use super::domain::{Bounds, Domain};
use super::multistart::Observers;
use super::options::Options;
use super::problem::Problem;
use crate::error::{Error, Result};
use context::FrontContext;
pub use result::{Front, FrontError, FrontEvent, FrontPoint};
use std::cell::Cell;

/// Pareto front of two functions of a problem: the objective and the last constraint function. Both
/// are minimized subject to the other constraints; the limits of the last constraint are ignored.
/// The front has `count` points, including the ends, spread evenly in the plane of the two
/// functions. Points at changes of the active set and at the knee are added.
///
/// `starts_of` returns the starts of the searches for the minimum of a function: of the objective
/// for 0, of the last constraint function for 1. The best of their ends is the end of the front.
///
/// `observers` receive every search, with its number, and can interrupt the work.
///
/// # Errors
/// [`FrontError::NoEnd`] if the minimization of one function does not converge, and
/// [`FrontError::Refused`] with the errors of `starts_of` and of [`minimize`](super::minimize()).
pub fn front(
    problem: &dyn Problem,
    domain: &Domain,
    starts_of: impl Fn(usize) -> Result<Vec<Vec<f64>>>,
    options: &Options,
    count: usize,
    observers: &Observers,
) -> Result<Front, FrontError> {
    let context = FrontContext {
        problem,
        domain: without_last_constraint(domain)?,
        options,
        observers,
        searches: Cell::new(0),
    };
    let first = context.minimum_of(0, &starts_of(0)?)?;
    let at_first = context.values(&first.x)?;
    // after an interrupt the front consists of the ends found so far
    let second = starts_of(1)
        .map_err(FrontError::from)
        .and_then(|starts| context.minimum_of(1, &starts))
        .and_then(|second| Ok((context.values(&second.x)?, second)));
    let (at_second, second) = match second {
        Err(_) if context.is_interrupted() => return Ok(context.ends_only([(first, at_first)])),
        second => second?,
    };
    let (values, ends) = ([at_first, at_second], [first, second]);
    if let Some(best) = context.common_minimum(&ends, values) {
        return Ok(best);
    }
    let [first, second] = ends.clone();
    let isolated = context
        .isolated_minimum(0, first, values)
        .and_then(|first| {
            let second = context.isolated_minimum(1, second, values)?;
            let values = [context.values(&first.x)?, context.values(&second.x)?];
            Ok((values, [first, second]))
        });
    let (values, ends) = match isolated {
        Err(_) if context.is_interrupted() => {
            return Ok(context.ends_only(ends.into_iter().zip(values)));
        }
        isolated => isolated?,
    };
    match context.common_minimum(&ends, values) {
        Some(best) => Ok(best),
        None => Ok(trace::trace_front(&context, ends, values, count)?),
    }
}

/// The domain of all constraints but the last, which is the second function.
fn without_last_constraint(domain: &Domain) -> Result<Domain> {
    let mut others = domain.clone();
    let Bounds { low, high } = &mut others.constraints;
    if low.pop().is_none() || high.pop().is_none() {
        return Err(Error::Optimizer(
            "a front needs a second function; give a constraint".into(),
        ));
    }
    Ok(others)
}
