//! Swings that vary: measures of a golfer's drives (their mean, their deviation, the mean of the
//! lowest share, …) as smooth functions of a design. Gradients are exact. Hessians are exact too,
//! but in a search over many swings they are approximated from a subset of the drives.
//!
//! ```text
//!   distributions, recorded swings ──▶ scenarios with weights, independent of the design
//!   design ──▶ each scenario's drive, with exact derivatives ──▶ smoothed measures ──▶ optimizer
//!   best design ──▶ each scenario's drive, or many more drives ──▶ exact measures ──▶ answer
//! ```

mod analysis;
mod bootstrap_optimum;
mod file;
pub(super) mod flown;
mod function;
mod golfer;
mod measure;
mod pareto;
mod quadrature;
mod robust;
mod scenarios;
mod strokes;
pub(super) mod subset;
mod warnings;

pub use analysis::{GoalError, Nominal, SamplingError, SwingsAnalysis, analyse_over_swings};
pub use bootstrap_optimum::{BootstrapOptimum, bootstrap_optimum};
pub use function::GoalFunction;
pub use golfer::{Correlation, Swings};
pub use measure::Measure;
pub use pareto::{Pareto, ParetoPoint, ParetoSearch, pareto};
pub use robust::{Model, ModelResult, Robust, robust};
pub use scenarios::{Rule, Scenarios};
pub use strokes::Strokes;
