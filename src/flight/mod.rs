//! The ball in the air: equation of motion, fixed-step integration, a smooth landing.

mod divergence;
mod ending;
mod fading;
mod inputs;
mod landing;
mod motion;
mod septic;
mod step;
mod tableau;
mod trajectory;

pub use ending::{Apex, Flight, Landed, NoFlight};
pub(crate) use inputs::Inputs;
pub(crate) use landing::Asked;
pub use landing::fly;
pub use trajectory::{Trajectory, TrajectoryPoint, trajectory};
