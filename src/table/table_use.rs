//! Uses of a table.

use super::column::SHOTS_ADVICE;

/// The use of the rows of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TableUse {
    /// Shots to fly from their launch.
    Launches,
    /// Shots with measurements, for a calibration.
    Measurements,
    /// Measured launches whose deliveries are to be found. Club values help to find them.
    Deliveries,
    /// Points of a sweep, or swings.
    Points,
}

/// Advice for tables of points or swings.
const POINTS_ADVICE: &str = "give each a name that is known, or take it out: a column is a \
                             parameter, with its unit as in 'swing.speed [mph]', or a result that \
                             a sweep has written, which is ignored";

/// Advice for tables of shots to fly.
const LAUNCHES_ADVICE: &str = "name the columns of the launch by known heads, as in 'Ball Speed \
                               [mph]', 'Launch Angle [deg]', 'Spin Rate [rpm]', and take the \
                               others out; the heads must be in one of the first lines";

impl TableUse {
    /// Choice of the spin values if several columns state the spin. True: each row chooses among
    /// its own values ([`without_redundant_spins`](super::without_redundant_spins)). False: all
    /// rows use the same columns.
    pub fn selects_spin_by_row(self) -> bool {
        self != Self::Points
    }

    /// True if each row may state its own air. This holds only for shots: a sweep needs a value in
    /// every row, and a delivery does not depend on the air.
    pub fn has_air_of_rows(self) -> bool {
        matches!(self, Self::Launches | Self::Measurements)
    }

    /// True if columns of the club are read beside a measured launch.
    pub fn reads_club(self) -> bool {
        matches!(self, Self::Launches | Self::Deliveries)
    }

    /// Advice for unknown column heads.
    pub fn advice(self) -> &'static str {
        match self {
            Self::Launches => LAUNCHES_ADVICE,
            Self::Measurements | Self::Deliveries => SHOTS_ADVICE,
            Self::Points => POINTS_ADVICE,
        }
    }
}
