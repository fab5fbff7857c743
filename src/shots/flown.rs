//! Shots with the results of their flights.

use super::shot::{REFUSED, Shot};
use super::source::Section;
use crate::batch::{Block, Status};
use crate::drive::{ExceededLimits, Outcome};

/// A chunk of shots with their flights.
#[derive(Clone, Debug)]
pub struct Flown {
    /// The predicted outcomes.
    pub of: Vec<Outcome>,
    /// The shots.
    pub shots: Vec<Shot>,
    /// Row of each shot in `block`; `None` for a refused shot.
    pub(super) flights: Vec<Option<usize>>,
    pub(super) block: Block,
    /// True if the predicted and measured roll-outs are compared.
    pub(super) compares_roll_out: bool,
    /// The section of the table; `None` for JSON.
    pub section: Option<Section>,
}

impl Flown {
    /// Status of a flight; `None` for a refused row.
    pub fn status(&self, row: usize) -> Option<Status> {
        self.flights[row].map(|flight| self.block.status(flight))
    }

    /// Name of the flight status; `refused` for a row that was not flown.
    pub fn flight(&self, row: usize) -> &'static str {
        self.status(row).map_or(REFUSED, Status::name)
    }

    /// Validity limits of the model that a landed drive exceeds.
    pub fn exceeded(&self, row: usize) -> ExceededLimits {
        self.flights[row]
            .map(|flight| self.block.exceeded(flight))
            .unwrap_or_default()
    }

    /// Reason why a row has no predicted outcomes; `None` if the ball landed.
    pub fn reason(&self, row: usize) -> Option<&str> {
        match self.status(row) {
            None => self.shots[row]
                .refusal()
                .map(|refusal| refusal.reason.as_str()),
            Some(Status::Landed) => None,
            Some(Status::NoFlight) => Some(
                "the ball does not fly: it is launched downwards, or its highest point is below \
                 the ground",
            ),
            Some(Status::Aloft) => Some("the ball is still in the air at flight.time_limit"),
            Some(Status::Diverged) => {
                Some("the numbers of the flight overflow; take a smaller flight.step")
            }
            // not reached: a value outside of its range refuses the row when it is read, by name
            Some(Status::NoStrike | Status::OutOfRange) => {
                Some("a parameter of the flight is outside of its range")
            }
        }
    }

    /// Predicted value of an outcome (by index), SI; `None` for a refused row, and if the ball did
    /// not land.
    pub fn predicted(&self, row: usize, outcome: usize) -> Option<f64> {
        self.block.outcome(self.flights[row]?, outcome)
    }

    /// Predicted − measured, SI; `None` if the outcome is not predicted, not measured or not
    /// compared. Lateral outcomes are not compared if the launch direction or the spin axis is
    /// assumed. Outcomes of the roll-out are compared only if
    /// [`Flying::compares_roll_out`](super::Flying::compares_roll_out) is true.
    pub fn residual(&self, row: usize, outcome: usize) -> Option<f64> {
        let (of, shot) = (self.of[outcome], &self.shots[row]);
        let has_no_ground = of.needs_run() && !self.compares_roll_out;
        let has_no_side = shot.is_direction_assumed() || shot.is_axis_assumed();
        if has_no_ground || of.is_lateral() && has_no_side {
            return None;
        }
        Some(self.predicted(row, outcome)? - shot.value(of)?.value)
    }
}
