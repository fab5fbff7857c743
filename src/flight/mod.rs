//! The ball in the air: equation of motion, fixed-step RK4, a smooth landing.

mod hermite;
mod landing;
mod motion;
mod rk4;
mod trajectory;

pub use landing::{Flight, Landed, NoFlight, fly};
pub use trajectory::{Trajectory, TrajectoryPoint, trajectory};
