//! Air of a flight: density and viscosity, which are constant, and the wind (docs/model.md,
//! eqs. 12a–12d, 15).

mod weather;
mod wind;

pub use weather::AirState;
pub use wind::WindField;

use crate::parameters::Setup;

/// The setup with the density, viscosity and wind components that its drive uses. The setup gives
/// these values, or they are computed from the weather and from the speed and direction of the
/// wind.
pub fn in_effect(setup: &Setup<f64>) -> Setup<f64> {
    let mut effective = *setup;
    AirState {
        density: effective.air.density,
        viscosity: effective.air.viscosity,
    } = AirState::of(&setup.air);
    [effective.wind.right, effective.wind.downrange] = wind::horizontal_components(&setup.wind);
    effective
}
