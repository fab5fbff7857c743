//! Drives of a golfer whose swings vary: expectations over them as smooth functions of a design, with exact gradients and Hessians,
//! and the design that is best for all of them.
//!
//! ```text
//!   distributions, recorded swings ──▶ scenarios with weights, the same for every design
//!   design ──▶ each scenario's drive with exact derivatives ──▶ mean, deviation, lowest part, hits ──▶ optimizer
//! ```

mod apart;
mod chained;
mod file;
mod golfer;
mod measure;
mod optimum;
mod price;
mod problem;
mod quadrature;
mod read;
mod scenarios;
mod strokes;

pub use apart::{Apart, Resampled, resampled};
pub use golfer::{Correlation, Swings};
pub use measure::Measure;
pub use optimum::{SwingsOptimum, SwingsSearch, swings_optimum};
pub use price::{Doubt, Price, price};
pub use read::{Goal, GoalLimit};
pub use scenarios::{Rule, Scenarios};
pub use strokes::Strokes;
