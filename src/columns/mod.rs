//! The columns of tables that people, launch monitors and this program write: shots to calibrate with or to fly, points to sweep over. All
//! read the same heads.

mod air;
mod column;
mod conditions;
mod encoding;
mod head;
mod heads;
mod launch_monitor;
mod left_out;
mod marks;
mod plausible;
mod unstated;
mod wrong;

pub(crate) use crate::cells::separated;
pub(crate) use air::{air_as_given, air_of_rows, air_of_setup};
pub(crate) use column::{Column, Format, Holds, OF_FLOWN};
pub(crate) use conditions::{Fault, Stated, conditions, contradiction, is_sideways, is_straight_by_assumption};
pub(crate) use encoding::{decoded, is_utf_16};
pub(crate) use head::Head;
pub(crate) use launch_monitor::{has_thousands, is_export, nearest_head, split_unit, summary, without_side, words};
pub(crate) use left_out::{Club, Spin, given_air, near_known};
pub(crate) use marks::Marks;
pub(crate) use plausible::{implausible, implausible_launch, impossible, outside};
#[cfg(feature = "cli")]
pub(crate) use unstated::UNSTATED;
pub(crate) use unstated::unstated;

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
