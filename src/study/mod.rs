//! Studies: optimum, chart, calibration, delivery, design, sensitivity, uncertainty, certificate
//! and comparison of drives.

pub mod calibrate;
mod cancellable;
pub mod certificate;
mod chart;
mod compare;
pub mod delivery;
pub mod design;
mod effects;
mod expression;
mod face;
mod flatness;
mod gain;
mod gauss;
mod goal;
mod landing;
mod launches;
mod lofts;
mod map;
mod named_drive;
mod optimum;
mod optimum_analysis;
mod plane;
mod problem;
mod region;
mod sample;
mod search;
mod sensitivity;
mod sigma;
pub mod swings;
pub mod uncertainty;
pub mod validation;
mod verdict;

pub use crate::parameters::Vary;
pub use chart::{Chart, ChartEvent, ChartObserver, ChartPoint, chart};
pub use compare::{Cause, CauseValue, Comparison, Difference, Share, Shares, causes};
pub use effects::{Effect, Effects, SigmaEffect, effects, flown_off};
pub use face::Face;
pub use flatness::{
    Direction, Ellipse, Flatness, Window, WindowLimit, default_loss, flatness, short_drive, windows,
};
pub use gain::{ClubAlone, improve_from_club_alone};
pub use goal::{Constraint, ConstraintAtEnd, Goal};
pub use landing::Landing;
pub use launches::{Launches, NamedLaunch};
pub use lofts::{LOFT_OUTCOMES, lofts};
pub use map::{Fineness, Map, Slope, map};
pub use named_drive::{DriveRole, NamedDrive};
pub use optimum::{LocalOptimum, Optima, Optimum, optima, optimum};
pub use optimum_analysis::{OptimumAnalysis, OptimumWindows};
pub use plane::Plane;
pub use region::Region;
pub use sample::Sample;
pub use search::{Search, Sense};
pub use sensitivity::{
    Change, Changed, PredictedEvent, Sensitivity, change, refuse_varied, sensitivities, sensitivity,
};
pub use sigma::{Sigma, refuse_given_twice, with_defaults};
pub use verdict::{Active, BoundSide};
