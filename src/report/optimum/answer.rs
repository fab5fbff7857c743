//! The answer of `optimize`, as JSON and for readers.

use super::super::document::{Document, Line};
use super::super::json::{ByName, JsonNumber};
use super::super::reply::{Ending, Report};
use super::super::swings::StudiesReport;
use super::report::{LocalReport, OptimumReport};
use super::text::{optima_document, optimum_document};
use crate::study::swings::SwingsAnalysis;
use crate::study::{ClubAlone, Optima, OptimumWindows, Window};
use crate::units::System;
use serde::Serialize;

/// An optimum as JSON, SI and radians.
///
/// The answer of `optimize`: the best optimum, with the results of all searches.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct OptimizeReport<'a> {
    #[serde(skip)]
    pub(in crate::report) found: &'a Optima,
    #[serde(skip)]
    pub(in crate::report) analysis: Option<&'a SwingsAnalysis>,
    #[serde(skip)]
    around: Option<OptimumWindows<'a>>,
    /// The best optimum.
    #[serde(flatten)]
    pub optimum: OptimumReport,
    /// The local optima of a search from several starts, best first; `null` if one start was
    /// requested.
    pub optima: Option<Vec<LocalReport>>,
    /// For each varied parameter: the range in which the drive loses at most `window_loss` if only
    /// this parameter varies; `null` for swings, and without an optimum.
    pub window: Option<ByName<Window>>,
    /// The loss allowed in each window, SI; `null` without windows.
    pub window_loss: JsonNumber,
    /// The gain of the optimum in two parts: from the club with the swing as set up, and from the
    /// swing; `null` if the search does not vary both, or if the first part is unknown.
    pub club_alone: Option<ClubAlone>,
    /// The setup file that was written; `null` without one.
    pub file: Option<String>,
    /// Results over swings; omitted for a single drive.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub swings: Option<StudiesReport>,
}

impl<'a> OptimizeReport<'a> {
    /// The report of a search. `analysis` is that of a search over swings. `around`
    /// contains the windows of the optimum, and the gain of the club alone. `file` is the setup
    /// file that was written.
    pub fn new(
        found: &'a Optima,
        analysis: Option<&'a SwingsAnalysis>,
        around: Option<OptimumWindows<'a>>,
        file: Option<String>,
    ) -> Self {
        let best = &found.best;
        let windows = around.map(|around| {
            let windows = best.search.vary.iter().zip(around.windows);
            windows
                .map(|(vary, window)| (vary.parameter.name, window.clone()))
                .collect()
        });
        let several = found.has_several_starts();
        let is_over_swings = !best.search.scenarios.is_one_drive();
        Self {
            found,
            analysis,
            around,
            optimum: OptimumReport::new(best),
            optima: several.then(|| LocalReport::all(found)),
            window: windows,
            window_loss: around.map(|around| around.loss).into(),
            club_alone: around.and_then(|around| around.club_alone.cloned()),
            file,
            swings: is_over_swings.then(|| StudiesReport::new(best, analysis)),
        }
    }
}

impl Report for OptimizeReport<'_> {
    const COMMAND: &'static str = "optimize";

    #[cfg(test)]
    const STATUSES: &'static [&'static str] = &crate::study::Optimum::STATUSES;

    fn ending(&self) -> Ending {
        let best = &self.found.best;
        match self.found.interrupted() {
            None => Ending {
                status: best.status(),
                message: Some(best.message().to_string()),
            },
            interrupted => Ending {
                status: "interrupted",
                message: interrupted,
            },
        }
    }

    /// The varied parameters with the gains of their bounds, the constraints, and the drive or the
    /// goals over the swings. After several starts, the results of all searches follow.
    fn document(&self, system: System) -> Document {
        let optima = self.found;
        // with one start, `optimum_document` already reports an interruption
        let several = optima.has_several_starts();
        let mut document = Document::default();
        if let Some(stopped) = optima.interrupted().filter(|_| several) {
            let stopped = format!("interrupted: {stopped}; the best so far:");
            document.list([Line::flush(stopped)]);
        }
        document.append(optimum_document(
            &optima.best,
            self.analysis,
            self.around.as_ref(),
            system,
        ));
        if several {
            document.append(optima_document(optima, system));
        }
        document
    }
}
