//! The ball in the air: equation of motion, fixed-step integration, a smooth landing.

mod fast;
mod hermite;
mod landing;
mod lanes;
mod motion;
mod node;
mod pace;
mod rk4;
mod shot;
mod space;
mod surroundings;
mod tableau;
mod trajectory;

pub(crate) use fast::Over;
pub(crate) use landing::Wanted;
pub use landing::{Apex, Flight, Landed, NoFlight, fly};
pub(crate) use pace::Pace;
pub(crate) use shot::Shot;
pub use trajectory::{Trajectory, TrajectoryPoint, trajectory};
