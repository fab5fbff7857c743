use crate::drive::{CheckScope, ExceededCount, ExceededLimits, Outcome, OutcomeGroup};
use crate::parameters::Law;
use crate::units::Message;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt::{self, Display, Formatter};

/// Status of a drive in a batch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Status {
    /// The ball landed; all outcomes exist.
    Landed,
    /// The ball left the face but did not fly: it was launched downwards, or its highest point is
    /// not above the ground. Only outcomes of the launch exist.
    NoFlight,
    /// The ball is still in the air at `flight.time_limit`. Only outcomes of the launch exist.
    Aloft,
    /// The integration failed. Drag and lift change the airspeed too much within a step
    /// (`flight.step` is too long), or numbers overflow, or the defect exceeds its limit even with
    /// the shortest step. No outcomes exist.
    Diverged,
    /// The club does not strike the ball: the strike is off the face, or the face moves away from
    /// the ball, or the bodies jam. No outcomes exist.
    NoStrike,
    /// A value is outside its parameter's range, or the inertia tensor is not positive definite. No
    /// outcomes exist.
    OutOfRange,
}

variant_names! {
    /// Name in files: `landed`.
    Status as "DriveStatus" {
        Landed = "landed",
        NoFlight = "no-flight",
        Aloft = "aloft",
        Diverged = "diverged",
        NoStrike = "no-strike",
        OutOfRange = "out-of-range",
    }
}

/// Number of drives by status, and number of landed drives that exceed each validity limit of the
/// model.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct StatusCounts {
    /// Number of drives by status.
    statuses: BTreeMap<Status, u64>,
    /// Number of landed drives beyond each validity limit, in this order: launch outside the ranges
    /// that the law was fitted to, strike outside the largest face that the Rules of Golf allow,
    /// and landing flatter than any measured bounce.
    #[serde(rename = "beyond")]
    #[cfg_attr(test, schemars(with = "[u64; 3]"))]
    exceeded: ExceededLimits<u64>,
}

impl StatusCounts {
    /// Counts the drives of a block.
    pub fn add(&mut self, block: &Block) {
        for status in Status::ALL {
            let drives = block.status.iter().filter(|own| **own == status).count();
            *self.statuses.entry(status).or_default() += drives as u64;
        }
        for (status, limits) in block.status.iter().zip(&block.exceeded) {
            if *status == Status::Landed {
                self.exceeded.add(*limits);
            }
        }
    }

    /// Adds other counts.
    pub fn merge(&mut self, other: &Self) {
        for (status, count) in &other.statuses {
            *self.statuses.entry(*status).or_default() += count;
        }
        self.exceeded.merge(other.exceeded);
    }

    /// Number of landed drives, and how many of them exceed each validity limit.
    pub fn exceeded(&self) -> ExceededCount {
        ExceededCount {
            all: self.count(Status::Landed),
            limits: self.exceeded,
        }
    }

    /// A warning for each validity limit that a landed drive exceeds.
    pub fn warnings(&self, law: &Law<f64>) -> Vec<Message> {
        let noun = ["drive that landed", "drives that landed"];
        self.exceeded().warnings(law, noun, CheckScope::Launch)
    }

    /// True if some drive has an outcome in `of`, or if there are no drives. A ball that does not
    /// land also has the outcomes of the launch.
    pub fn has_any(&self, of: &[Outcome]) -> bool {
        let is_of_the_launch = of
            .iter()
            .any(|outcome| outcome.group() != OutcomeGroup::Flight);
        let has = |status| match status {
            Status::Landed => true,
            Status::NoFlight | Status::Aloft => is_of_the_launch,
            _ => false,
        };
        self.total() == 0
            || self
                .counts()
                .any(|(status, count)| count > 0 && has(status))
    }

    /// Number of drives with a status.
    pub fn count(&self, status: Status) -> u64 {
        self.statuses.get(&status).copied().unwrap_or_default()
    }

    /// Each status with its number of drives.
    pub fn counts(&self) -> impl Iterator<Item = (Status, u64)> {
        Status::ALL
            .into_iter()
            .map(|status| (status, self.count(status)))
    }

    /// Number of all drives.
    pub fn total(&self) -> u64 {
        self.statuses.values().sum()
    }
}

/// The statuses that occur: `812 landed, 3 aloft`.
impl Display for StatusCounts {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let counts = self.counts().filter(|(_, count)| *count > 0);
        let counts: Vec<_> = counts
            .map(|(status, count)| format!("{count} {status}"))
            .collect();
        f.write_str(&counts.join(", "))
    }
}

/// Drives at consecutive points of a batch. A missing value is `None`, never NaN. Access to a row
/// or an outcome outside the block panics.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    pub(super) first_row: u64,
    /// Values of the swept parameters, SI, row by row.
    pub(super) points: Vec<f64>,
    pub(super) parameters: usize,
    pub(super) status: Vec<Status>,
    /// Validity limits that each landed drive exceeds.
    pub(super) exceeded: Vec<ExceededLimits>,
    /// Defect of the integration of each landed drive, m (docs/model.md, eq. 16a).
    pub(super) defect: Vec<f64>,
    /// A column for each outcome; a number that is not finite marks a missing value.
    pub(super) outcomes: Vec<Vec<f64>>,
    /// A column for each outcome and parameter, sorted by outcome, then by parameter. A number that
    /// is not finite marks a missing value.
    pub(super) derivatives: Vec<Vec<f64>>,
}

impl Block {
    /// Numbers of columns: parameters, outcomes, derivatives.
    pub(crate) fn columns(&self) -> [usize; 3] {
        [self.parameters, self.outcomes.len(), self.derivatives.len()]
    }

    /// Row number of the first point, from 0.
    pub fn first_row(&self) -> u64 {
        self.first_row
    }

    /// Number of drives.
    pub fn rows(&self) -> usize {
        self.status.len()
    }

    /// The values of the swept parameters, SI.
    pub fn point(&self, row: usize) -> &[f64] {
        &self.points[row * self.parameters..][..self.parameters]
    }

    /// Status of the drive.
    pub fn status(&self, row: usize) -> Status {
        self.status[row]
    }

    /// Validity limits of the model that a landed drive exceeds. The ranges of the law are checked
    /// at launch only.
    pub fn exceeded(&self, row: usize) -> ExceededLimits {
        self.exceeded[row]
    }

    /// Defects of the integration of all landed drives, m (docs/model.md, eq. 16a).
    pub(crate) fn defects(&self) -> impl Iterator<Item = f64> {
        self.status
            .iter()
            .zip(&self.defect)
            .filter(|(status, _)| **status == Status::Landed)
            .map(|(_, defect)| *defect)
    }

    /// Value of an outcome, SI; `None` if the drive does not have the outcome. `outcome` is its
    /// index in the batch.
    pub fn outcome(&self, row: usize, outcome: usize) -> Option<f64> {
        Some(self.outcomes[outcome][row]).filter(|value| value.is_finite())
    }

    /// Derivatives of a row, SI, of all outcomes by all parameters of differentiation: sorted by
    /// outcome, then by parameter. `None` for a missing derivative.
    pub fn derivatives(&self, row: usize) -> impl Iterator<Item = Option<f64>> {
        self.derivatives
            .iter()
            .map(move |column| Some(column[row]).filter(|value| value.is_finite()))
    }

    /// Outcomes of a row, SI, in the order of the batch; `None` for a missing outcome.
    pub fn outcomes(&self, row: usize) -> impl Iterator<Item = Option<f64>> {
        (0..self.outcomes.len()).map(move |outcome| self.outcome(row, outcome))
    }

    /// A result column by index: outcomes come first, then derivatives. The iterator is empty if
    /// the index is too large.
    pub fn result(&self, column: usize) -> impl Iterator<Item = Option<f64>> + Clone {
        let column = self.outcomes.iter().chain(&self.derivatives).nth(column);
        column
            .into_iter()
            .flatten()
            .map(|value| Some(*value).filter(|value| value.is_finite()))
    }
}
