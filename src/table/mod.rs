//! Tables that people, launch monitors and this program write, read once for all: encoding, records, heads with their units, sections, and
//! the values of cells. Shots, calibration and sweeps ask for the columns that they want.
//!
//! Points that stand in a file, as [`Points`](crate::batch::Points) of a batch: [`open_table`] reads CSV, Parquet and Arrow.

mod air;
mod cells;
mod column;
mod conditions;
mod decimals;
mod encoding;
mod head;
mod heads;
mod launch_monitor;
mod left_out;
mod lines;
mod marks;
mod no_shot;
mod numbers;
mod plausible;
mod points;
mod refusal;
mod stated;
mod text;
mod unstated;
mod wrong;

pub(crate) use air::{air_as_given, air_of_rows, air_of_setup, states_weather};
pub(crate) use cells::{cells, quoted};
pub(crate) use column::{Column, Format, Holds, OF_FLOWN};
pub(crate) use conditions::{Fault, Stated, conditions, contradiction, is_sideways, is_straight_by_assumption};
pub(crate) use decimals::Decimals;
pub(crate) use head::{Head, Wanted};
pub(crate) use launch_monitor::{nearest_head, split_unit, words};
pub(crate) use left_out::{Club, given_air, in_degrees, near_known};
pub(crate) use lines::Record;
pub(crate) use marks::Marks;
pub(crate) use no_shot::{NoShot, NoShots};
pub(crate) use plausible::{implausible, implausible_club, implausible_launch, impossible, outside};
pub use points::open_table;
pub use refusal::Refusal;
pub(crate) use text::{Entry, SourceName, Text, TextTable, miscounted};
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
