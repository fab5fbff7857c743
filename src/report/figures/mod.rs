//! Plots of the results of studies.

mod chart;
mod constants;
mod difference;
mod face;
mod fairway;
mod launches;
mod laws;
mod map;
mod pareto;
mod scale;
mod strikes;
mod style;
mod tornado;
mod trajectory;
mod vcurve;

pub use chart::{ChartFigures, chart_figures};
pub use difference::difference_figure;
pub use face::face_figure;
pub use fairway::fairway_figure;
pub use launches::launches_figure;
pub use laws::{Coefficient, Over, laws_figure};
pub use map::{OnMap, map_figure};
pub use pareto::pareto_figure;
pub use strikes::strikes_figure;
pub use tornado::{Causes, tornado_figure};
pub use trajectory::{View, trajectory_figure};
pub use vcurve::vcurve_figure;
