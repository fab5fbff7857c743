//! The columns of tables that people, launch monitors and this program write: shots to calibrate with, points to sweep over. Both read
//! the same heads.

mod column;
mod head;
mod launch_monitor;
mod left_out;
mod marks;

pub(crate) use crate::cells::separated;
pub(crate) use column::{Column, Holds};
pub(crate) use head::Head;
pub(crate) use launch_monitor::summary;
pub(crate) use left_out::Club;
pub(crate) use marks::Marks;

use crate::drive::Outcome;

/// Outcomes that, all together, are a launch.
pub(crate) const CONDITIONS: [Outcome; 7] = [
    Outcome::BallSpeed,
    Outcome::LaunchAngle,
    Outcome::LaunchDirection,
    Outcome::Spin,
    Outcome::Backspin,
    Outcome::Sidespin,
    Outcome::SpinAxis,
];
