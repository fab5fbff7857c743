use crate::drive::Outcome;
use crate::flight::Flight;
use crate::parameters::{Preset, Setup};
use crate::report::figures::Flown;
use crate::reproduce::LoopRow;
use crate::study::certificate::Row;
use crate::study::{
    Chart, Constraint, Effects, Face, Flatness, Landing, Launches, Map, Optimum, Region,
};
use crate::units::{Message, System};

/// The setup file of a report: the best drive, or the drive as set up where there is no best one.
pub const SETUP_FILE: &str = "setup.toml";

/// What a report tells of. What is not there is left out of the page, and `remarks` says why.
pub struct Findings<'a> {
    /// What the setup is called.
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
    pub flown: &'a [Flown],
    /// Where those of them land that fly.
    pub landings: &'a [Landing],
    /// The carry over the launch, with their launches.
    pub launches: Option<&'a Launches>,
    /// The carry over the strike, of the club as set up.
    pub face: Option<&'a Face>,
    /// That of the optimum.
    pub best_face: Option<&'a Face>,
    /// What the search found, whether it is an optimum or not.
    pub found: Option<&'a Optimum>,
    /// The optimum.
    pub best: Option<&'a Optimum>,
    /// Why there is none.
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
    /// What stated uncertainties of parameters do to outcomes.
    pub effects: &'a [Effects],
    /// The same of the outcome that the report is about, at the optimum.
    pub at_best: Option<&'a Effects>,
    /// Differences beside exact derivatives.
    pub rows: &'a [Row],
    /// The same of the MAE 494 report's while-loop.
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
    /// What stated uncertainties do to an outcome of the drive as set up.
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

    /// Whether the setup is a file, and not a preset with what was changed in it.
    pub(super) fn is_of_a_file(&self) -> bool {
        self.name != self.preset.name
    }
}
