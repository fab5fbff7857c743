//! The air the ball flies through: density and viscosity, which are the same along a flight, and
//! the wind.

mod weather;
mod wind;

pub use weather::AirState;
pub use wind::WindField;

use crate::parameters::Setup;

/// The setup with density, viscosity and the wind's components as the drive has them, also where
/// they follow from the weather and from the wind's speed and direction.
pub fn in_effect(setup: &Setup<f64>) -> Setup<f64> {
    let mut shown = *setup;
    AirState {
        density: shown.air.density,
        viscosity: shown.air.viscosity,
    } = AirState::of(&setup.air);
    [shown.wind.right, shown.wind.downrange] = wind::along_the_ground(&setup.wind);
    shown
}
