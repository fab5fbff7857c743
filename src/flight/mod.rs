//! The ball in the air: equation of motion, fixed-step integration, a smooth landing.

mod divergence;

mod ending;
mod fading;
mod fly;
mod inputs;
mod landing;
mod motion;
mod result;
mod septic;
mod step;
mod tableau;
mod trajectory;

pub use ending::{Apex, Flight, Landed, NoFlight};
pub use fly::fly;
pub(crate) use inputs::Inputs;
pub(crate) use result::RequestedOutputs;
pub use trajectory::{Trajectory, TrajectoryPoint, trajectory};
