//! The answer of `optimize`, as JSON and for readers.

use super::super::document::{Document, Line};
use super::super::reply::{Ending, Report};
use super::super::swings::StudiesReport;
use super::report::{LocalReport, OptimumReport};
use super::text::{optima_document, optimum_document};
use crate::study::swings::OverSwings;
use crate::study::{Optima, OptimumWindows};
use crate::units::System;
use serde::Serialize;

/// An optimum as JSON, SI and radians.
///
/// The answer of `optimize`: the best optimum, with the results of all searches.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema), schemars(rename = "OptimumReport"))]
pub struct OptimizeReport<'a> {
    #[serde(skip)]
    pub(in crate::report) optima: &'a Optima,
    #[serde(skip)]
    pub(in crate::report) over: &'a OverSwings,
    #[serde(skip)]
    around: Option<OptimumWindows<'a>>,
    /// The best optimum.
    #[serde(flatten)]
    pub optimum: OptimumReport,
}

impl<'a> OptimizeReport<'a> {
    /// The report of a search. `around` contains the windows of the optimum, and the gain of the
    /// club alone. `file` is the setup file that was written.
    pub fn new(
        optima: &'a Optima,
        over: &'a OverSwings,
        around: Option<OptimumWindows<'a>>,
        file: Option<String>,
    ) -> Self {
        let best = &optima.best;
        let windows = around.map(|around| {
            let windows = best.search.vary.iter().zip(around.windows);
            windows
                .map(|(vary, window)| (vary.parameter.name, window.clone()))
                .collect()
        });
        let optimum = OptimumReport {
            optima: optima
                .has_several_starts()
                .then(|| LocalReport::all(optima)),
            window: windows,
            window_loss: around.map(|around| around.loss).into(),
            club_alone: around.and_then(|around| around.club_alone.cloned()),
            file,
            swings: StudiesReport::new(best, over),
            ..OptimumReport::new(best)
        };
        Self {
            optima,
            over,
            around,
            optimum,
        }
    }
}

impl Report for OptimizeReport<'_> {
    const COMMAND: &'static str = "optimize";

    #[cfg(test)]
    const STATUSES: &'static [&'static str] = &crate::study::Optimum::STATUSES;

    fn ending(&self) -> Ending {
        let best = &self.optima.best;
        match self.optima.interrupted() {
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
        let optima = self.optima;
        // with one start, `optimum_document` already reports an interruption
        let several = optima.has_several_starts();
        let mut document = Document::default();
        if let Some(stopped) = optima.interrupted().filter(|_| several) {
            let stopped = format!("interrupted: {stopped}; the best so far:");
            document.list([Line::flush(stopped)]);
        }
        document.append(optimum_document(
            &optima.best,
            self.over,
            self.around.as_ref(),
            system,
        ));
        if several {
            document.append(optima_document(optima, system));
        }
        document
    }
}
