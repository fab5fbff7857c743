//! The design of a head and its face for swings that vary, under the Rules of Golf and what a rigid
//! body can be.
//!
//! A design is a search over many swings ([`swings`](super::swings)) with more limits: rules about
//! a parameter become bounds of it where it is varied and are checked where it is not; rules about
//! the head become limits of its outcomes.

mod golfer;
mod held;
mod parts;
mod pose;
mod rules;

pub use golfer::{GOLFER, golfer};
pub use held::{By, Held, Standing};
pub use parts::{Part, parts};
pub use pose::{Design, usual_vary};
pub use rules::{Limited, RULES, Rule};
