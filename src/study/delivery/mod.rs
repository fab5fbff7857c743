//! Inverse impact: the delivery and strike that explain a measured launch, by bounded least squares
//! with exact Jacobians.
//!
//! A launch has five numbers; a delivery with its strike has more. Prior knowledge of the golfer (a
//! value and a standard uncertainty for each parameter) enters as additional measurements, so that
//! the solution is unique: the most probable delivery.

mod expectation_maximization;
mod linearized;
mod population;
mod result;
mod shots;
mod solve;
mod unknown;

pub use population::{LEAST_SHOTS, MeanAndDeviation, Population, PredictedOutcome, Recovered};
pub use result::{Delivered, Explained, Posterior, Unidentified};
pub use shots::{ShotDelivery, Spread, deliveries, launches, setup_of_shots};
pub use solve::delivery;
pub use unknown::{Unknown, unknowns};
