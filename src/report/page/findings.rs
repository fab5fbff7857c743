use crate::drive::Outcome;
use crate::flight::Flight;
use crate::parameters::{Setup, SetupFile};
use crate::reproduce::LoopRow;
use crate::study::certificate::DerivativeRow;
use crate::study::{
    Chart, ClubAlone, Constraint, Effects, Face, Flatness, Landing, Launches, Map, NamedDrive,
    Optimum, Plane, Region,
};
use crate::units::{Message, System};

/// The setup file of a report. It contains the optimal drive or, without an optimum, the drive as
/// set up.
pub const SETUP_FILE: &str = "setup.toml";

/// Name of the explorer's file in the folder of a report.
pub const EXPLORER_FILE: &str = "explorer.html";

/// The contents of a page. The page omits missing sections; `remarks` has the reasons.
pub struct Findings {
    /// The name of the setup.
    pub name: String,
    /// The setup as the request states it.
    pub stated: Setup<f64>,
    /// The setup of the computed drives, with the chosen method and step.
    pub setup: Setup<f64>,
    /// The outcome that the report is about.
    pub of: Outcome,
    /// The file or preset of the setup.
    pub file: SetupFile,
    /// The drive as set up, and the drive at the optimum if there is one.
    pub flown: Vec<NamedDrive>,
    /// The landings of the drives that fly.
    pub landings: Vec<Landing>,
    /// The carry as a function of launch angle and backspin, with the launches of the drives.
    pub launches: Option<Launches>,
    /// The carry by impact point on the face, for the club as set up.
    pub face: Option<Face>,
    /// The carry by impact point on the face, for the optimal club.
    pub best_face: Option<Face>,
    /// The result of the search, converged or not.
    pub found: Option<Optimum>,
    /// The reason why there is no optimum.
    pub why_none: Option<Message>,
    /// The flatness of the objective around the optimum.
    pub flatness: Option<Flatness>,
    /// The optimum of the club with the swing as set up.
    pub club_alone: Option<ClubAlone>,
    /// Carry and total over attack angle and loft.
    pub lofts: Option<Plane>,
    /// A map of the outcome that contains the optimum or, without an optimum, the drive as set up.
    pub map: Option<Map>,
    /// The constraints, each with the map of its outcome.
    pub limits: Vec<(Constraint, Map)>,
    /// The region of the map in which drives lose little compared with the optimum.
    pub region: Option<Region>,
    /// The optima for several values of a parameter.
    pub chart: Option<Chart>,
    /// The effects of uncertainties, stated or default, on outcomes of the drive as set up.
    pub effects: Vec<Effects>,
    /// The effects of uncertainties on the outcome of the report, at the optimum.
    pub at_best: Option<Effects>,
    /// Finite differences compared with exact derivatives.
    pub rows: Vec<DerivativeRow>,
    /// Finite differences of the MAE 494 report's while-loop.
    pub loops: Vec<LoopRow>,
    /// The text after `#` in the address of the explorer, for the drive as set up. `None` without
    /// [`EXPLORER_FILE`], or if the explorer cannot represent the setup.
    pub explorer: Option<String>,
    /// The units shown when the page opens.
    pub system: System,
    /// Warnings, and the reasons for missing sections.
    pub remarks: Vec<Message>,
    /// Advice on the setup; empty if there is none.
    pub advice: String,
    /// The command that made the page.
    pub command: String,
    /// The date of the page.
    pub date: String,
}

impl Findings {
    /// Findings about a setup, with all sections empty.
    pub fn new(
        name: String,
        stated: Setup<f64>,
        setup: Setup<f64>,
        of: Outcome,
        file: SetupFile,
    ) -> Self {
        Self {
            name,
            stated,
            setup,
            of,
            file,
            flown: vec![],
            landings: vec![],
            launches: None,
            face: None,
            best_face: None,
            found: None,
            why_none: None,
            flatness: None,
            club_alone: None,
            lofts: None,
            map: None,
            limits: vec![],
            region: None,
            chart: None,
            effects: vec![],
            at_best: None,
            rows: vec![],
            loops: vec![],
            explorer: None,
            system: System::default(),
            remarks: vec![],
            advice: String::new(),
            command: String::new(),
            date: String::new(),
        }
    }

    /// The optimum, if the search has converged.
    pub fn best(&self) -> Option<&Optimum> {
        let found = self.found.as_ref();
        found.filter(|found| found.is_converged())
    }

    /// The effects of uncertainties on an outcome of the drive as set up.
    pub(super) fn effects_of(&self, of: Outcome) -> Option<&Effects> {
        self.effects.iter().find(|effects| effects.of == of)
    }

    /// The reason why the drive as set up does not fly.
    pub(super) fn why_not_flown(&self) -> Option<Message> {
        match &self.flown.first()?.drive.flight {
            Flight::None(why) => Some(why.message()),
            Flight::Landed(_) => None,
        }
    }
}
