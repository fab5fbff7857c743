use crate::error::Error;
use crate::optimize::sensitivity::Held;
use crate::optimize::solution::Solution;
use crate::optimize::status::Status;

/// Compromises of which none is better than another in both functions, from the minimum of the
/// first to that of the second.
#[derive(Clone, Debug, PartialEq)]
pub struct Front {
    /// The points, in order.
    pub points: Vec<FrontPoint>,
    /// Which of them is the knee: the point that lies farthest, on the better side, from the
    /// straight line between the ends in the plane of the two functions, each scaled from 0 to 1
    /// (Das 1999). A front that is nearly straight, or bends the other way, has none.
    pub knee: Option<usize>,
    /// How far the front bends off that line, as a part of its length.
    pub bend: f64,
    /// Points found that another one is better than in both functions, and that are left out.
    pub dominated: usize,
    /// Why a part of it is missing, if it is.
    pub ended: Option<String>,
    /// Whether it was stopped from outside before its end.
    pub interrupted: bool,
}

/// A compromise.
#[derive(Clone, Debug, PartialEq)]
pub struct FrontPoint {
    /// Where it is.
    pub x: Vec<f64>,
    /// The two functions there.
    pub values: [f64; 2],
    /// What the first changes by for each unit that the second changes by, along the front; `None`
    /// where the front has no one slope.
    pub slope: Option<f64>,
    /// What each variable changes by for each unit of s.
    pub rates: Vec<f64>,
    /// What holds it.
    pub held: Held,
    /// What happens here.
    pub event: Option<FrontEvent>,
}

/// What happens at a point of a front.
#[derive(Clone, Debug, PartialEq)]
pub enum FrontEvent {
    /// Other bounds and limits hold from here on than before.
    Changed {
        /// What held before.
        before: Held,
    },
    /// The compromises before and after are not connected: from here on others are better.
    Jump,
}

/// Why there is no front.
#[derive(Debug)]
pub enum NoFront {
    /// One of the two functions has no minimum that was found.
    NoEnd {
        /// Which of them, 0 or 1.
        function: usize,
        /// How its search ended.
        found: Box<Solution>,
    },
    /// The question makes no sense, or has no value where one is needed.
    Refused(Error),
}

impl From<Error> for NoFront {
    fn from(error: Error) -> Self {
        Self::Refused(error)
    }
}

impl NoFront {
    /// The same as an error.
    pub fn into_error(self) -> Error {
        match self {
            Self::NoEnd { function, found } => {
                let which = ["first", "second"][function];
                let why = match (&found.undefined_at_start, found.status) {
                    (Some(why), Status::Undefined) => why,
                    _ => &found.message,
                };
                let message = format!("{which} function alone: {why}").into();
                Error::NotConverged {
                    status: found.status.name(),
                    message,
                }
            }
            Self::Refused(error) => error,
        }
    }
}
