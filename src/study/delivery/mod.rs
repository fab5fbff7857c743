//! Which delivery and strike explain a measured launch: bounded least squares with exact Jacobians
//! of the impact, with what the launch tells of each parameter, and what it does not.
//!
//! A launch has five numbers, a delivery and its strike more. What is known of the golfer before,
//! each parameter's value with a standard uncertainty, enters as measurements do: the answer is the
//! most probable delivery, and never one of many by chance.

mod found;
mod launches;
mod likely;
mod population;
mod shots;
mod solve;
mod unknown;
mod untold;

pub use found::{Delivered, Explained, Known};
pub use population::{LEAST_SHOTS, Population, Recovered, Returned};
pub use shots::{Delivery, Spread, deliveries, launches};
pub use solve::delivery;
pub use unknown::{Unknown, unknowns};
pub use untold::Untold;
