use crate::error::Error;
use crate::optimize::sensitivity::ActiveSet;
use crate::optimize::solution::Solution;

/// Pareto front: nondominated compromises from the minimum of the first function to the minimum of
/// the second.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Front {
    /// Points in order.
    pub points: Vec<FrontPoint>,
    /// Index of the knee: the point farthest from the straight line between the ends, towards
    /// smaller values, with both functions scaled from 0 to 1 (Das 1999). `None` if the front is
    /// nearly straight, or curves towards larger values.
    pub knee: Option<usize>,
    /// Largest distance of the front from the straight line between its ends, towards smaller
    /// values, divided by the length of that line. Both functions are scaled from 0 to 1.
    pub relative_bulge: f64,
    /// Number of dominated points that were removed.
    pub dominated: usize,
    /// Reason why a part of the front is missing; `None` if the front is complete.
    pub ended: Option<String>,
    /// True if the computation was interrupted.
    pub interrupted: bool,
}

/// A point of the front.
#[derive(Clone, Debug, PartialEq)]
pub struct FrontPoint {
    /// Variables.
    pub x: Vec<f64>,
    /// Values of the two functions.
    pub values: [f64; 2],
    /// Derivative of the first function by the second along the front; `None` where it is infinite,
    /// not unique or unknown.
    pub slope: Option<f64>,
    /// Derivative dx/ds of each variable. s is the position along the front, from −1 to 1. The
    /// derivative is 0 where it is unknown.
    pub rates: Vec<f64>,
    /// Active set.
    pub active_set: ActiveSet,
    /// Event at this point.
    pub event: Option<FrontEvent>,
}

/// Event at a point of a front.
#[derive(Clone, Debug, PartialEq)]
pub enum FrontEvent {
    /// The active set changes.
    Changed {
        /// Active set before this point.
        before: ActiveSet,
    },
    /// The front jumps to another branch of minima, which is better from this point on.
    Jump,
}

/// Reason why there is no front.
#[derive(Debug)]
pub enum FrontError {
    /// The search for the minimum of one function did not converge.
    NoEnd {
        /// Index of the function, 0 or 1.
        function: usize,
        /// Result of the search.
        found: Box<Solution>,
    },
    /// Invalid input, or an undefined function.
    Refused(Error),
}

impl From<Error> for FrontError {
    fn from(error: Error) -> Self {
        Self::Refused(error)
    }
}
