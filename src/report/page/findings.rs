use crate::drive::Outcome;
use crate::flight::Flight;
use crate::parameters::{Preset, Setup};
use crate::reproduce::LoopRow;
use crate::study::certificate::Row;
use crate::study::{
    Chart, Constraint, Effects, Face, Flatness, Landing, Launches, Map, NamedDrive, Optimum, Region,
};
use crate::units::{Message, System};

/// The setup file of a report: the best drive, or the drive as set up where there is no best one.
pub const SETUP_FILE: &str = "setup.toml";

/// The contents of a page. Missing parts are omitted, and `remarks` says why.
pub struct Findings<'a> {
    /// The name of the setup.
    pub name: &'a str,
    /// The setup as it was stated.
    pub stated: &'a Setup<f64>,
    /// The setup as it was flown: with the method and the step that were chosen.
    pub setup: &'a Setup<f64>,
    /// The outcome that the report is about.
    pub of: Outcome,
    /// The preset that it started from.
    pub preset: &'static Preset,
    /// The drive as set up, and at the optimum.
    pub flown: &'a [NamedDrive],
    /// The landings of the drives that fly.
    pub landings: &'a [Landing],
    /// The carry over the launch, with their launches.
    pub launches: Option<&'a Launches>,
    /// The carry over the strike, of the club as set up.
    pub face: Option<&'a Face>,
    /// That of the optimum.
    pub best_face: Option<&'a Face>,
    /// The end of the search, optimum or not.
    pub found: Option<&'a Optimum>,
    /// The optimum.
    pub best: Option<&'a Optimum>,
    /// Why there is no optimum.
    pub why_none: Option<&'a Message>,
    /// How flat it is.
    pub flatness: Option<&'a Flatness>,
    /// The map around it.
    pub map: Option<&'a Map>,
    /// The constraints, each with the map of its outcome.
    pub limits: &'a [(Constraint, Map)],
    /// The part of the map that is nearly as good as the optimum.
    pub region: Option<&'a Region>,
    /// The optimum along a parameter.
    pub chart: Option<&'a Chart>,
    /// The effects of stated uncertainties on outcomes.
    pub effects: &'a [Effects],
    /// The effects on the outcome of the report, at the optimum.
    pub at_best: Option<&'a Effects>,
    /// Differences beside exact derivatives.
    pub rows: &'a [Row],
    /// Differences of the MAE 494 report's while-loop.
    pub loops: &'a [LoopRow],
    /// The units that the page is shown in at first.
    pub system: System,
    /// Warnings.
    pub remarks: &'a [Message],
    /// The command that made it.
    pub command: &'a str,
    /// The day on which it was made.
    pub date: &'a str,
}

impl Findings<'_> {
    /// The effects of stated uncertainties on an outcome of the drive as set up.
    pub(super) fn effects_of(&self, of: Outcome) -> Option<&Effects> {
        self.effects.iter().find(|effects| effects.of == of)
    }

    /// Why the drive as set up does not fly.
    pub(super) fn why_not_flown(&self) -> Option<Message> {
        match &self.flown.first()?.drive.flight {
            Flight::None(why) => Some(why.message()),
            Flight::Landed(_) => None,
        }
    }

    /// The setup is a file, and not a preset with changes.
    pub(super) fn is_of_a_file(&self) -> bool {
        self.name != self.preset.name
    }
}
