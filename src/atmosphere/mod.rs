//! The air the ball flies through. Density and viscosity are parameters; what varies along a flight is the
//! wind.

mod wind;

pub use wind::WindField;
