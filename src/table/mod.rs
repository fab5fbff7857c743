//! Tables written by people, launch monitors and this program: encoding, records, column heads with
//! units, sections, and cell values. Shots, calibration and sweeps ask for the columns they need.
//!
//! [`open_table`] reads the points of a batch ([`Points`](crate::batch::Points)) from CSV, Parquet
//! and Arrow, and [`sweep_points`] also takes them from a grid or a sequence.

mod air;
mod column;
mod conditions;
mod decimal_mark;
mod encoding;
mod export_columns;
mod head;
mod heads;
mod label;
mod launch_monitor;
mod maker;
mod numbers;
mod plausible;
mod points;
mod records;
mod refusal;
mod row_fault;
mod row_filter;
mod sign_conventions;
mod table_use;
mod text;

pub(crate) use air::{air_of_rows, air_of_setup, air_replaced};
pub(crate) use column::{Column, Content, TableFormat};
pub(crate) use conditions::{
    LAUNCH_PARAMETERS, StatedConditions, conditions, contradiction, is_straight_by_assumption,
    without_redundant_spins,
};
pub(crate) use decimal_mark::DecimalMark;
#[cfg(feature = "commands")]
pub(crate) use export_columns::ASSUMED_UNITS;
pub(crate) use export_columns::{
    assume_unit, columns_remark, has_whole_launch, heads_of, ignore_columns, missing_launch_remark,
    missing_of_launch, near_known, redundant_spins_remark, with_nearest,
};
pub(crate) use head::{OF_FLOWN, TableHead, remark_from_line};
pub(crate) use heads::is_condition_head;
pub(crate) use launch_monitor::{split_unit, words};
pub(crate) use plausible::{
    NOT_MEASURED, implausible_club, implausible_launch, impossible, not_compared, outside,
};
pub use points::{open_table, sweep_points};
pub use records::Record;
pub(crate) use records::{cells, quoted};
pub use refusal::Refusal;
pub(crate) use row_fault::{NonShotRows, RowFault};
pub use row_filter::RowFilter;
pub(crate) use row_filter::{club_column, counted_values};
pub(crate) use table_use::TableUse;
pub(crate) use text::{TableEntry, Text, TextTable, unreadable_text};

use crate::drive::Outcome;

/// Launch conditions: the outcomes that together determine a launch.
pub(crate) const CONDITIONS: [Outcome; 7] = [
    Outcome::BallSpeed,
    Outcome::LaunchAngle,
    Outcome::LaunchDirection,
    Outcome::Spin,
    Outcome::Backspin,
    Outcome::Sidespin,
    Outcome::SpinAxis,
];
