//! Drives of a golfer whose swings vary: expectations over them as smooth functions of a design,
//! with exact gradients and Hessians, and the design that is best for all of them.
//!
//! ```text
//!   distributions, recorded swings ──▶ scenarios with weights, the same for every design
//!   design ──▶ each scenario's drive with exact derivatives ──▶ mean, deviation, smoothed lowest part, smoothed hits ──▶ optimizer
//!   best design ──▶ values of the scenarios' drives, or of many more ──▶ mean, deviation, lowest part, hits ──▶ answer
//! ```

mod apart;
mod beyond;
mod chained;
mod file;
mod flown;
mod function;
mod golfer;
mod measure;
mod optimum;
mod pareto;
mod part;
mod price;
mod problem;
mod quadrature;
mod read;
mod relation;
mod robust;
mod scenarios;
mod strokes;

pub use apart::{Apart, Resampled, resampled};
pub use beyond::beyond_share;
pub use function::GoalFunction;
pub use golfer::{Correlation, Swings};
pub use measure::Measure;
pub use optimum::{
    SwingsOptimum, SwingsSearch, goals_of, status_of, swings_optima, swings_optimum, swings_problem,
};
pub use pareto::{Pareto, ParetoPoint, ParetoSearch, pareto};
pub use price::{Doubt, Nominal, Price, price, price_until};
pub use read::{Goal, GoalLimit};
pub use robust::{Model, Robust, robust};
pub use scenarios::{Rule, Scenarios};
pub use strokes::Strokes;
