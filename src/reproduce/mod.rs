//! Reproduction of published studies of the longest drive.
//!
//! This module is above [`study`](crate::study), because a reproduction uses the same public
//! functions as a user.

mod average;
mod delivery;
mod mae494;
mod recomputed;
mod winfield_tan;

pub use average::Average;
pub use delivery::{DeliveryCarry, LoftCarry};
pub use mae494::{
    ByLaunch, ChangedOptimum, Constant, ConstantChange, End, Energy, LandingDefinition, Landings,
    Launched, LongerDifference, LoopLanding, LoopRow, Mae494, Noise, Parametric, Peak, Regression,
    Sawtooth, SearchMethod, Searches, ShorterStep, Slopes, Subsystems, loop_landing, mae494,
    while_loop,
};
pub use recomputed::RecomputedOptimum;
pub use winfield_tan::{
    Decay, FittedNumber, InterpolatedAverage, MISPRINTS, RefittedLaw, ShotComparison, SingleShot,
    WinfieldTan, winfield_tan,
};
