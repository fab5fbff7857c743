//! Reproduction of published studies of the longest drive.
//!
//! This module is above [`study`](crate::study), because a reproduction uses the same public
//! functions as a user.

mod delivery;
mod mae494;
mod winfield_tan;

pub use delivery::{Delivery, LoftCarry};
pub use mae494::{
    Average, ByLaunch, ChangedOptimum, Constant, ConstantChange, End, Energy, Landing, Landings,
    Launched, LongerDifference, LoopLanding, LoopRow, Mae494, Method, Noise, Parametric, Peak,
    Regression, Row, Sawtooth, Searches, ShorterStep, Slopes, Subsystems, loop_landing, mae494,
    while_loop,
};
pub use winfield_tan::{
    Best, Decay, Fitted, FittedNumber, MISPRINTS, Mean, ShotComparison, SingleShot, WinfieldTan,
    winfield_tan,
};
