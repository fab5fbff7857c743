//! The number types that impact and flight are compiled for.
//!
//! Only this file names these types, and a test compares it with docs/architecture.md. Each number
//! type below is compiled once for each [`Level`](super::Level). On x86-64, five number types are
//! compiled for the baseline level, five for AVX2, and four for AVX-512, which only sweeps use.
//!
//! The public generic functions are used with two number types. `f64`
//! ([`Drive::new`](crate::Drive::new)) is also a number type of the baseline level. For
//! `num_dual::Dual64` (`study::certificate`), impact and flight are compiled once more.

use super::{Jet, Lanes, Mixed};

/// Largest number of directions in a lane. Single drives and sweeps have the same limit, so that
/// both use the same compiled code of a flight.
pub(crate) const MOST_PER_LANE: usize = 3;

/// Work that [`over_directions`] or [`over_drives`] runs. It is compiled for each of their number
/// types. `over` and all functions of numbers that it calls must be inlined, as for
/// [`Task`](super::Task).
pub(crate) trait OverNumbers {
    /// Result of the work.
    type Output;
    /// Runs the work over a number type.
    fn over<J: Lanes>(&mut self) -> Self::Output;
}

/// Runs `work` for one drive. Each lane differentiates by other variables. The number type has
/// first derivatives; it has none if there are no variables. If `are_pairs` is true, each lane has
/// the second derivative by a pair of variables.
#[inline(always)]
pub(crate) fn over_directions<V: Lanes<Lane = f64>, W: OverNumbers>(
    work: &mut W,
    variables: usize,
    are_pairs: bool,
) -> W::Output {
    match (variables, are_pairs) {
        (0, _) => work.over::<V>(),
        (_, true) => work.over::<Mixed<V>>(),
        (count, false) if count <= V::WIDTH => work.over::<Jet<1, V>>(),
        _ => work.over::<Jet<MOST_PER_LANE, V>>(),
    }
}

/// Runs `work` for a sweep. Each lane is a drive, with derivatives by up to [`MOST_PER_LANE`]
/// parameters.
#[inline(always)]
pub(crate) fn over_drives<V: Lanes<Lane = f64>, W: OverNumbers>(
    work: &mut W,
    parameters: usize,
) -> W::Output {
    match parameters {
        0 => work.over::<V>(),
        1 => work.over::<Jet<1, V>>(),
        2 => work.over::<Jet<2, V>>(),
        _ => work.over::<Jet<MOST_PER_LANE, V>>(),
    }
}
