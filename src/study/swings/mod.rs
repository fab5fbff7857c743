//! Swings that vary: expectations over a golfer's drives as smooth functions of a design, with
//! exact gradients and Hessians.
//!
//! ```text
//!   distributions, recorded swings ──▶ scenarios with weights, independent of the design
//!   design ──▶ each scenario's drive with exact derivatives ──▶ mean, deviation, smoothed lowest
//!              part, smoothed hits ──▶ optimizer
//!   best design ──▶ values of the scenarios' drives, or of many more ──▶ mean, deviation, lowest
//!                   part, hits ──▶ answer
//! ```

mod analysis;
mod file;
pub(super) mod flown;
mod function;
mod golfer;
mod measure;
mod pareto;
pub(super) mod part;
mod quadrature;
mod resampled;
mod robust;
mod scenarios;
mod strokes;
mod warnings;

pub use analysis::{GoalError, Nominal, SamplingError, SwingsAnalysis, analyse_over_swings};
pub use function::GoalFunction;
pub use golfer::{Correlation, Swings};
pub use measure::Measure;
pub use pareto::{Pareto, ParetoPoint, ParetoSearch, pareto};
pub use resampled::{Resampled, resampled};
pub use robust::{Model, ModelLimit, Robust, robust};
pub use scenarios::{Rule, Scenarios};
pub use strokes::Strokes;
