//! Results as text and JSON: pure functions, which write nowhere. Text is in units a golfer reads, JSON in SI
//! and radians.

mod drive;
mod gradient;
mod json;
mod optimum;
mod parameters;
mod presets;
mod table;

pub use drive::{drive_json, drive_text};
pub use gradient::{gradient_json, gradient_text, no_gradient_json};
pub use optimum::{iteration_line, optimum_json, optimum_text};
pub use parameters::{parameters_json, parameters_text};
pub use presets::{preset_toml, presets_json, presets_text};
