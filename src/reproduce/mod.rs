//! Published studies of the longest drive, computed anew beside what they print.
//!
//! It stands above [`study`](crate::study): a reproduction puts to the program the questions that a
//! user puts, so that its answers come from the very code that everyone runs.

mod mae494;
mod overlay;
mod winfield_tan;

pub use mae494::{
    Average, Constant, Delivery, End, Energy, Landing, Landings, Launched, Mae494, Method, Noise,
    Parametric, Peak, Regression, Row, Searches, Slopes, Subsystems, Teeth, mae494,
};
pub use overlay::{LoopRow, while_loop};
pub use winfield_tan::{
    Best, Decay, Fitted, MISPRINTS, Mean, Point, SingleShot, Struck, WinfieldTan, winfield_tan,
};
