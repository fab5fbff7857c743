//! Statistics of predictions: bias and mean absolute error by ball speed, and refused rows.

use super::flown::Flown;
use super::shot::Origin;
use super::source::Shots;
use super::unit_checks::UnitChecks;
use crate::batch::Status;
use crate::drive::{ExceededCount, Outcome};
use crate::statistics::Moments;
use crate::table::Refusal;
use crate::units::{MPH, Message};
use serde::Serialize;
use std::collections::BTreeMap;

/// Limits of the ball speed bands, mph.
pub const BANDS: [f64; 6] = [80.0, 100.0, 120.0, 140.0, 160.0, 180.0];

/// Standard deviation of the difference between two instruments on the same drives, with its unit:
/// a TrackMan 4 and a FlightScope Mevo+ on 58 drives (Bliss & Langdown 2026).
const INSTRUMENTS: [(Outcome, f64, &str); 5] = [
    (Outcome::CarryDistance, 6.72, "yd"),
    (Outcome::Lateral, 10.7, "yd"),
    (Outcome::ApexHeight, 12.3, "ft"),
    (Outcome::DescentAngle, 3.9, "deg"),
    (Outcome::Spin, 513.0, "rpm"),
];

/// Standard deviation of the difference between two instruments on the same drives, SI; `None` for
/// an outcome without a published value.
pub fn instrument_deviation(of: Outcome) -> Option<f64> {
    let (_, deviation, unit) = INSTRUMENTS.iter().find(|(outcome, ..)| *outcome == of)?;
    Some(deviation * of.quantity().size_of(unit)?)
}

/// Moments of residuals or of predictions, SI, and the sum of their absolute values.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sums {
    /// Number, mean and standard deviation of the values.
    pub moments: Moments,
    absolute: f64,
}

impl Sums {
    fn add(&mut self, residual: f64) {
        self.merge(Self {
            moments: Moments::of([residual]),
            absolute: residual.abs(),
        });
    }

    fn merge(&mut self, other: Self) {
        self.moments.merge(&other.moments);
        self.absolute += other.absolute;
    }

    /// Mean absolute value, SI; `None` without values.
    pub fn mean_absolute(&self) -> Option<f64> {
        let count = self.moments.count;
        (count > 0).then(|| self.absolute / count as f64)
    }
}

/// Residuals of the shots in a band of ball speed.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    /// Lower limit, m/s; `None` for the first band.
    pub from: Option<f64>,
    /// Upper limit, m/s; `None` for the last band.
    pub to: Option<f64>,
    /// Sums of the residuals, in the order of the outcomes.
    pub sums: Vec<Sums>,
}

/// Maximum number of clubs with statistics of their own in merged statistics.
const MOST_CLUBS: usize = 40;

/// Statistics of the shots with one club: the sums of each outcome.
#[derive(Clone, Debug, PartialEq)]
pub struct ClubShots {
    /// Number of rows.
    pub rows: u64,
    /// Number of rows whose ball landed.
    pub flown: u64,
    /// Sums of the predictions, in the order of the outcomes.
    pub predicted: Vec<Sums>,
    /// Sums of the residuals, in the order of the outcomes.
    pub residuals: Vec<Sums>,
}

impl ClubShots {
    fn add(&mut self, flown: &Flown, row: usize) {
        self.rows += 1;
        self.flown += u64::from(flown.status(row) == Some(Status::Landed));
        for outcome in 0..self.predicted.len() {
            if let Some(predicted) = flown.predicted(row, outcome) {
                self.predicted[outcome].add(predicted);
            }
            if let Some(residual) = flown.residual(row, outcome) {
                self.residuals[outcome].add(residual);
            }
        }
    }

    fn merge(&mut self, other: &Self) {
        self.rows += other.rows;
        self.flown += other.flown;
        let sums = self.predicted.iter_mut().chain(&mut self.residuals);
        let others = other.predicted.iter().chain(&other.residuals);
        sums.zip(others)
            .for_each(|(ours, theirs)| ours.merge(*theirs));
    }
}

/// Rows refused for one kind of reason.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "RefusedRows"))]
pub struct Refused {
    /// The kind of reason.
    pub kind: &'static str,
    /// Number of rows.
    #[serde(rename = "rows")]
    pub count: u64,
    /// Line of the first of these rows.
    #[serde(rename = "first_line")]
    pub line: u64,
    /// Reason of the first of these rows.
    #[serde(rename = "first_reason")]
    pub reason: String,
}

/// Statistics of flown shots.
#[derive(Clone, Debug, PartialEq)]
pub struct ShotStatistics {
    /// The outcomes.
    pub of: Vec<Outcome>,
    /// Number of rows.
    pub rows: u64,
    /// False if an interruption came before the end of the source was read.
    pub is_complete: bool,
    /// Number of rows whose ball landed.
    pub flown: u64,
    /// Rows that were refused, and rows whose ball did not land, by kind of reason.
    pub refused: BTreeMap<&'static str, Refused>,
    /// Residuals by ball speed.
    pub bands: Vec<Band>,
    /// Residuals of all rows.
    pub all: Vec<Sums>,
    /// Shots by the name of the club; empty if the table has no such column. Merged statistics
    /// have at most 40 clubs, each with all its rows.
    pub clubs: BTreeMap<String, ClubShots>,
    /// Number of rows of further clubs, which are not in `clubs`.
    pub rows_of_further_clubs: u64,
    /// Number of rows whose spin is estimated or modelled, as the export states.
    pub spin_not_measured: u64,
    /// Number of rows whose values are normalized, as the export states.
    pub normalized: u64,
    /// Number of rows with notes on assumed or unused values.
    pub noted: u64,
    /// Number of landed drives that exceed each validity limit of the model.
    pub exceeded: ExceededCount,
    /// Predicted and measured values, for checks of units and signs.
    unit_checks: UnitChecks,
}

impl ShotStatistics {
    /// Empty statistics.
    pub fn new(of: &[Outcome]) -> Self {
        let ends = |at: usize| BANDS.get(at).map(|mph| mph * MPH);
        let none = vec![Sums::default(); of.len()];
        let band = |at: usize| Band {
            from: at.checked_sub(1).and_then(ends),
            to: ends(at),
            sums: none.clone(),
        };
        Self {
            of: of.to_vec(),
            rows: 0,
            is_complete: true,
            flown: 0,
            refused: BTreeMap::new(),
            bands: (0..=BANDS.len()).map(band).collect(),
            all: none.clone(),
            clubs: BTreeMap::new(),
            rows_of_further_clubs: 0,
            spin_not_measured: 0,
            normalized: 0,
            noted: 0,
            exceeded: ExceededCount::default(),
            unit_checks: UnitChecks::new(of.len()),
        }
    }

    /// Adds flown shots.
    pub fn add(&mut self, flown: &Flown) {
        for (row, shot) in flown.shots.iter().enumerate() {
            self.rows += 1;
            self.normalized += u64::from(shot.is_normalized);
            self.noted += u64::from(!shot.notes.is_empty());
            let is_measured = shot
                .spin_origin()
                .is_none_or(|origin| origin == Origin::Measured);
            self.spin_not_measured += u64::from(!is_measured);
            if let Some(reason) = flown.reason(row) {
                let kind = shot
                    .refusal()
                    .map_or_else(|| flown.flight(row), |refusal: &Refusal| refusal.kind);
                let new = || Refused {
                    kind,
                    count: 0,
                    line: shot.line,
                    reason: reason.into(),
                };
                self.refused.entry(kind).or_insert_with(new).count += 1;
            }
            if flown.status(row) == Some(Status::Landed) {
                self.flown += 1;
                self.exceeded.add(flown.exceeded(row));
            }
            self.unit_checks.add(flown, row);
            if let Some(name) = shot.club_name.as_deref() {
                // no limit here: a club that is new in these rows may have rows in an earlier block
                self.club(name).add(flown, row);
            }
            let Some(speed) = shot.launch().map(|launch| launch[0]) else {
                continue;
            };
            let band = BANDS.iter().filter(|end| speed >= **end * MPH).count();
            for outcome in 0..self.of.len() {
                if let Some(residual) = flown.residual(row, outcome) {
                    self.bands[band].sums[outcome].add(residual);
                    self.all[outcome].add(residual);
                }
            }
        }
    }

    /// The statistics of a club.
    fn club(&mut self, name: &str) -> &mut ClubShots {
        let sums = || vec![Sums::default(); self.of.len()];
        let new = || ClubShots {
            rows: 0,
            flown: 0,
            predicted: sums(),
            residuals: sums(),
        };
        self.clubs.entry(name.into()).or_insert_with(new)
    }

    /// Warnings about columns of `shots` with a likely wrong unit or sign.
    pub fn unit_warnings(&self, shots: &Shots) -> Vec<Message> {
        self.unit_checks.warnings(&self.of, shots)
    }

    /// Adds the statistics of later shots.
    pub fn merge(&mut self, other: Self) {
        self.rows += other.rows;
        self.is_complete &= other.is_complete;
        self.flown += other.flown;
        self.spin_not_measured += other.spin_not_measured;
        self.normalized += other.normalized;
        self.noted += other.noted;
        self.exceeded.merge(other.exceeded);
        self.unit_checks.merge(other.unit_checks);
        self.rows_of_further_clubs += other.rows_of_further_clubs;
        for (name, shots) in &other.clubs {
            if self.clubs.len() < MOST_CLUBS || self.clubs.contains_key(name) {
                self.club(name).merge(shots);
            } else {
                self.rows_of_further_clubs += shots.rows;
            }
        }
        for (kind, refused) in other.refused {
            match self.refused.get_mut(kind) {
                Some(found) => found.count += refused.count,
                None => {
                    self.refused.insert(kind, refused);
                }
            }
        }
        let bands = self.bands.iter_mut().flat_map(|band| &mut band.sums);
        let others = other
            .bands
            .into_iter()
            .flat_map(|band| band.sums)
            .chain(other.all);
        bands
            .chain(&mut self.all)
            .zip(others)
            .for_each(|(ours, theirs)| ours.merge(theirs));
    }
}
