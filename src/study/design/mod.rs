//! Design of a driver head and its face for varying swings, under the Rules of Golf and the limits
//! of a rigid body.
//!
//! A design is an optimization over many swings ([`swings`](super::swings)) with further
//! constraints. A rule on a parameter becomes a bound if the parameter varies, and a check if it
//! does not. A rule on the head becomes a constraint on an outcome.

mod constraints;
mod golfer;
mod improvements;
mod problem;
mod rules;

pub use constraints::{ConstraintState, DesignConstraint, Enforcement};
pub use golfer::{GOLFER, golfer};
pub use improvements::{Improvement, improvements};
pub use problem::{Design, default_vary};
pub use rules::{GolfRule, LimitedQuantity, RULES};
