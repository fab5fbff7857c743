//! Questions asked of a drive.

mod optimum;

pub use optimum::{Optimum, Search, Vary, optimum};
