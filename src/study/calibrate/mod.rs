//! Calibration: fits parameters of a setup to measured shots by least squares with exact Jacobians,
//! and reports which parameters the data determine.

mod calibration;
mod data;
mod diagnostics;
mod estimate;
mod folds;
mod reading;
mod refusal;
mod residuals;
mod rows;
mod shot_table;
mod statistics;
mod verdict;

pub use calibration::{
    Calibration, CalibrationStatus, CalibrationVerdict, Estimate, FitResidual, Starts,
};
pub use diagnostics::validity_warnings;
pub use estimate::{FitPlan, calibrate};
pub use folds::{HeldOut, check_folds, held_out};
pub use shot_table::{MeasuredShot, Measurement, ShotTable, Stationary, ranges};
pub use statistics::{FitRange, FitStatistics, SigmaOrigin, Undetermined};
