//! Calibration: parameters of a setup fitted to measured shots by least squares with exact
//! Jacobians, with what the data say of them and what they do not.

mod beyond;
mod calibration;
mod data;
mod doubts;
mod estimate;
mod folds;
mod instrument;
mod one_drive;
mod ranges;
mod reading;
mod refusal;
mod residuals;
mod rows;
mod shot;
mod shot_table;
mod statistics;
mod verdict;

pub use beyond::beyond;
pub use calibration::{Calibration, Estimate, Remainder};
pub use estimate::{Plan, calibrate};
pub use folds::{HeldOut, check_folds, held_out};
pub use instrument::{Instrument, instrument};
pub use ranges::ranges;
pub use shot::{Measurement, Shot, Stationary};
pub use shot_table::ShotTable;
pub use statistics::{Fitted, Statistics, Uncertainties, Undetermined};
