//! Published studies of the longest drive, computed anew beside what they print.
//!
//! It stands above [`study`](crate::study): a reproduction puts to the program the questions that a user puts, so that its answers
//! come from the very code that everyone runs.

mod mae494;

pub use mae494::{Delivery, Mae494, Peak, Regression, Row, mae494};
