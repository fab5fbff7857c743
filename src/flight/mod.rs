//! The ball in the air: equation of motion, fixed-step integration, a smooth landing.

mod divergence;
mod ended;
mod ending;
mod fading;
mod fly;
mod inputs;
mod landing;
mod motion;
mod septic;
mod step;
mod tableau;
mod trajectory;

pub(crate) use ended::Asked;
pub use ending::{Apex, Flight, Landed, NoFlight};
pub use fly::fly;
pub(crate) use inputs::Inputs;
pub use trajectory::{Trajectory, TrajectoryPoint, trajectory};
