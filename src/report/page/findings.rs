use crate::parameters::{Preset, Setup};
use crate::report::figures::Flown;
use crate::reproduce::LoopRow;
use crate::study::certificate::Row;
use crate::study::{Chart, Constraint, Effects, Flatness, Map, Optimum, Region};
use crate::units::{Message, System};

/// What a report tells of. What is not there is left out of the page, and `remarks` says why.
pub struct Findings<'a> {
    /// What the setup is called.
    pub name: &'a str,
    /// The setup.
    pub setup: &'a Setup<f64>,
    /// The preset that it started from.
    pub preset: &'static Preset,
    /// The drive as set up, and at the optimum.
    pub flown: &'a [Flown],
    /// The optimum.
    pub best: Option<&'a Optimum>,
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
    /// Differences beside exact derivatives.
    pub rows: &'a [Row],
    /// The same of the MAE 494 report's while-loop.
    pub loops: &'a [LoopRow],
    /// The units that the page is shown in at first.
    pub system: System,
    /// What deserves a word.
    pub remarks: &'a [Message],
}
