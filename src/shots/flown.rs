//! Shots with what was found of their flights.

use super::section::Section;
use super::shot::Shot;
use crate::batch::{Block, Status};
use crate::drive::{ExceededLimits, Outcome};
use crate::table::is_sideways;

/// How the flight of a row ended that was not flown.
pub(super) const REFUSED: &str = "refused";

/// Shots that were flown, or that could not be.
#[derive(Clone, Debug)]
pub struct Flown {
    of: Vec<Outcome>,
    shots: Vec<Shot>,
    /// The row of each in the block.
    flights: Vec<Option<usize>>,
    block: Block,
    is_on_their_ground: bool,
    section: Option<Section>,
}

impl Flown {
    /// The shots with what was found of them; `flights` has the row of each in the block.
    pub(super) fn new(
        of: &[Outcome],
        shots: Vec<Shot>,
        flights: Vec<Option<usize>>,
        block: Block,
        is_on_their_ground: bool,
    ) -> Self {
        Self {
            of: of.to_vec(),
            shots,
            flights,
            block,
            is_on_their_ground,
            section: None,
        }
    }

    /// Sets the section.
    pub(super) fn of_section(self, section: Option<Section>) -> Self {
        Self { section, ..self }
    }

    /// The section of the table that they stand in; messages have none.
    pub fn section(&self) -> Option<&Section> {
        self.section.as_ref()
    }

    /// How many there are.
    pub fn rows(&self) -> usize {
        self.shots.len()
    }

    /// The shots.
    pub fn shots(&self) -> &[Shot] {
        &self.shots
    }

    /// The outcomes that are predicted.
    pub fn outcomes(&self) -> &[Outcome] {
        &self.of
    }

    /// How the flight of a row ended; `None` for one that is refused.
    pub fn status(&self, row: usize) -> Option<Status> {
        self.flights[row].map(|flight| self.block.status(flight))
    }

    /// How the flight of a row ended, in a word: `refused` for one without.
    pub fn flight(&self, row: usize) -> &'static str {
        self.status(row).map_or(REFUSED, Status::name)
    }

    /// In what the drive of a row that landed is outside of what the model is made for.
    pub fn beyond(&self, row: usize) -> ExceededLimits {
        self.flights[row]
            .map(|flight| self.block.beyond(flight))
            .unwrap_or_default()
    }

    /// Reason for a missing outcome.
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
            Some(Status::NoStrike | Status::OutOfRange) => {
                Some("a value is outside of the range of its parameter")
            }
        }
    }

    /// The predicted outcome of this number, SI.
    pub fn predicted(&self, row: usize, outcome: usize) -> Option<f64> {
        self.block.outcome(self.flights[row]?, outcome)
    }

    /// Predicted − measured, SI, where the row has a value to compare with. Nothing sideways is
    /// compared where the direction or the spin axis is assumed, and nothing of the run on ground
    /// that is not said to be that of the shots.
    pub fn residual(&self, row: usize, outcome: usize) -> Option<f64> {
        let (of, shot) = (self.of[outcome], &self.shots[row]);
        let has_no_ground = of.needs_run() && !self.is_on_their_ground;
        if has_no_ground || is_sideways(of) && shot.is_straight_by_assumption {
            return None;
        }
        Some(self.predicted(row, outcome)? - shot.value(of)?.value)
    }
}
