//! Tables that people, launch monitors and this program write, read once for all: encoding,
//! records, heads with their units, sections, and the values of cells. Shots, calibration and
//! sweeps ask for the columns that they want.
//!
//! Points that stand in a file, as [`Points`](crate::batch::Points) of a batch: [`open_table`]
//! reads CSV, Parquet and Arrow.

mod air;
mod cell_number;
mod cells;
mod column;
mod column_errors;
mod conditions;
mod decimal_marks;
mod decimals;
mod encoding;
mod head;
mod heads;
mod ignored_columns;
mod launch_monitor;
mod lines;
mod missing_units;
mod non_shot_rows;
mod numbers;
mod plausible;
mod points;
mod refusal;
mod text;

pub(crate) use air::{air_as_given, air_of_rows, air_of_setup, states_weather};
pub(crate) use cells::{cells, quoted};
pub(crate) use column::{Column, Format, Holds, OF_FLOWN};
pub(crate) use conditions::{
    Fault, Stated, conditions, contradiction, is_sideways, is_straight_by_assumption,
};
pub(crate) use decimal_marks::DecimalMarks;
pub(crate) use decimals::Decimals;
pub(crate) use head::{Head, Wanted};
pub(crate) use ignored_columns::{ClubColumns, given_air, in_degrees, near_known};
pub(crate) use launch_monitor::{nearest_head, split_unit, words};
pub(crate) use lines::Record;
#[cfg(feature = "cli")]
pub(crate) use missing_units::ASSUMED_UNITS;
pub(crate) use missing_units::assume_units;
pub(crate) use non_shot_rows::{NonShot, NonShotRows};
pub(crate) use plausible::{
    implausible, implausible_club, implausible_launch, impossible, outside,
};
pub use points::open_table;
pub use refusal::Refusal;
pub(crate) use text::{Entry, SourceName, Text, TextTable, miscounted};

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
