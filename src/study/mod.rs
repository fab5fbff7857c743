//! Questions asked of a drive.

mod accuracy;
pub mod calibrate;
pub mod certificate;
mod chart;
mod compare;
mod comparison;
mod constraint;
pub mod delivery;
mod effects;
mod flatness;
mod map;
mod optimum;
mod problem;
mod search;
mod sensitivity;
mod sigma;
pub mod swings;
pub mod uncertainty;
pub mod validation;

pub use crate::parameters::Vary;
pub use accuracy::{Accuracy, accuracy};
pub use chart::{Chart, ChartObserver, ChartPoint, chart, chart_at};
pub use compare::{Cause, Comparison, Difference, Share, Shares};
pub use constraint::Constraint;
pub use effects::{Bar, Effect, Effects, effects};
pub use flatness::{Direction, Ellipse, Flatness, Limit, Window, flatness, usual_loss};
pub use map::{Fineness, Map, Slope, map};
pub use optimum::{Active, Optima, Optimum, optima, optimum};
pub use search::{Search, Sense};
pub use sensitivity::{Change, Changed, Sensitivity, change, refuse_varied, sensitivities, sensitivity};
pub use sigma::{Sigma, given_twice, with_defaults};
