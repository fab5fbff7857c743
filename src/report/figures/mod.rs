//! What studies find, as plots.

mod chart;
mod map;
mod trajectory;

pub use chart::chart_figures;
pub use map::map_figure;
pub use trajectory::{Flown, View, trajectory_figure};
