use crate::drive::{ExceededCount, ExceededLimits, Outcome, OutcomeGroup};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt;

/// How a drive of a batch ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Status {
    /// On the ground: it has every outcome.
    Landed,
    /// It left the face and did not fly: launched down, or below the ground all the way. Outcomes
    /// of the launch only.
    NoFlight,
    /// Still in the air at `flight.time_limit`. Outcomes of the launch only.
    Aloft,
    /// `flight.step` is too coarse: drag and lift change the airspeed too much within a step,
    /// numbers overflow, or the defect stays above the largest one also in the shortest step. No
    /// outcomes.
    Diverged,
    /// The club does not strike the ball: off the face, moving away, or jammed. No outcomes.
    NoStrike,
    /// A value of the point is outside its parameter's range, or the inertia tensor is one that no
    /// body can have. No outcomes.
    OutOfRange,
}

impl Status {
    /// Every status.
    pub const ALL: [Self; 6] = [
        Self::Landed,
        Self::NoFlight,
        Self::Aloft,
        Self::Diverged,
        Self::NoStrike,
        Self::OutOfRange,
    ];

    /// Its name in files: `landed`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Landed => "landed",
            Self::NoFlight => "no-flight",
            Self::Aloft => "aloft",
            Self::Diverged => "diverged",
            Self::NoStrike => "no-strike",
            Self::OutOfRange => "out-of-range",
        }
    }
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// How many drives ended in which way, and how many of those that landed are outside of what the
/// model is made for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    statuses: [u64; Status::ALL.len()],
    beyond: ExceededCount,
}

impl Tally {
    /// Counts the drives of a block.
    pub fn add(&mut self, block: &Block) {
        for (status, beyond) in block.status.iter().zip(&block.beyond) {
            self.statuses[*status as usize] += 1;
            if *status == Status::Landed {
                self.beyond.add(*beyond);
            }
        }
    }

    /// Adds another tally.
    pub fn merge(&mut self, other: Self) {
        for (ours, theirs) in self.statuses.iter_mut().zip(other.statuses) {
            *ours += theirs;
        }
        self.beyond.merge(other.beyond);
    }

    /// The tally of these counts, and of the landed drives outside of what the model is made for.
    pub fn of(counts: &BTreeMap<Status, u64>, beyond: ExceededCount) -> Self {
        Self {
            statuses: Status::ALL.map(|status| counts.get(&status).copied().unwrap_or_default()),
            beyond,
        }
    }

    /// How many of the landed drives are outside of what the model is made for.
    pub fn beyond(&self) -> ExceededCount {
        self.beyond
    }

    /// Whether any drive has one of these outcomes, or there are no drives: those of the launch are
    /// there also where the ball does not land.
    pub fn has_any(&self, of: &[Outcome]) -> bool {
        let is_of_the_launch = of
            .iter()
            .any(|outcome| outcome.group() != OutcomeGroup::Flight);
        let has = |status| match status {
            Status::Landed => true,
            Status::NoFlight | Status::Aloft => is_of_the_launch,
            _ => false,
        };
        let all: u64 = self.statuses.iter().sum();
        all == 0
            || self
                .counts()
                .any(|(status, count)| count > 0 && has(status))
    }

    /// Each status with its number of drives.
    pub fn counts(&self) -> impl Iterator<Item = (Status, u64)> {
        Status::ALL
            .into_iter()
            .map(|status| (status, self.statuses[status as usize]))
    }
}

/// Drives of consecutive points. A value that does not exist is `None`, and never a NaN. To ask for
/// a row, or an outcome, that the block does not have is a panic.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    pub(super) first_row: u64,
    /// The points, one after the other.
    pub(super) points: Vec<f64>,
    pub(super) parameters: usize,
    pub(super) status: Vec<Status>,
    /// What each drive that landed lies beyond.
    pub(super) beyond: Vec<ExceededLimits>,
    /// What tells of the error of the integration, of each drive that landed.
    pub(super) defect: Vec<f64>,
    /// A column for each outcome; a number that is not finite stands for a value that does not
    /// exist.
    pub(super) outcomes: Vec<Vec<f64>>,
    /// A column for each outcome and parameter, the parameters of the first outcome first;
    /// likewise.
    pub(super) derivatives: Vec<Vec<f64>>,
}

impl Block {
    /// How many columns it has: parameters, outcomes, derivatives.
    pub(crate) fn columns(&self) -> [usize; 3] {
        [self.parameters, self.outcomes.len(), self.derivatives.len()]
    }

    /// The row of its first point, from 0.
    pub fn first_row(&self) -> u64 {
        self.first_row
    }

    /// How many drives it holds.
    pub fn rows(&self) -> usize {
        self.status.len()
    }

    /// The values of the swept parameters, SI.
    pub fn point(&self, row: usize) -> &[f64] {
        &self.points[row * self.parameters..][..self.parameters]
    }

    /// How the drive ended.
    pub fn status(&self, row: usize) -> Status {
        self.status[row]
    }

    /// In what a drive that landed is, by its launch, outside of what the model is made for.
    pub fn beyond(&self, row: usize) -> ExceededLimits {
        self.beyond[row]
    }

    /// What tells of the error of the integration, of each drive that landed: its defect, m.
    pub(crate) fn defects(&self) -> impl Iterator<Item = f64> {
        self.status
            .iter()
            .zip(&self.defect)
            .filter(|(status, _)| **status == Status::Landed)
            .map(|(_, defect)| *defect)
    }

    /// The outcome of this number, SI.
    pub fn outcome(&self, row: usize, outcome: usize) -> Option<f64> {
        Some(self.outcomes[outcome][row]).filter(|value| value.is_finite())
    }

    /// The derivatives of all outcomes by all parameters, SI, the parameters of the first outcome
    /// first.
    pub fn derivatives(&self, row: usize) -> impl Iterator<Item = Option<f64>> {
        self.derivatives
            .iter()
            .map(move |column| Some(column[row]).filter(|value| value.is_finite()))
    }

    /// The outcomes, SI.
    pub fn outcomes(&self, row: usize) -> impl Iterator<Item = Option<f64>> {
        (0..self.outcomes.len()).map(move |outcome| self.outcome(row, outcome))
    }

    /// A column of results: the outcomes, then the derivatives. Empty where there is no such
    /// column.
    pub fn result(&self, column: usize) -> impl Iterator<Item = Option<f64>> + Clone {
        let column = self.outcomes.iter().chain(&self.derivatives).nth(column);
        column
            .into_iter()
            .flatten()
            .map(|value| Some(*value).filter(|value| value.is_finite()))
    }
}
