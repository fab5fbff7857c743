//! The errors of every law of drag and lift on published drives, as a document, JSON and CSV.

mod figures;
mod text;

use super::csv_text::{csv_text, number};
use super::document::{Detail, Document};
use super::reply::Report;
use crate::error::Result;
use crate::study::validation::SetScores;
use crate::units::{System, TableUnits};
use serde::Serialize;

/// The errors of every law on every set of published drives, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ValidationReport<'a> {
    /// The sets.
    pub sets: &'a [SetScores],
}

impl ValidationReport<'_> {
    /// The errors as CSV: a row for each quantity of each drive.
    ///
    /// # Errors
    /// [`Error::Output`](crate::Error::Output).
    pub fn csv(&self, units: TableUnits) -> Result<String> {
        let head = [
            "set",
            "case",
            "law",
            "quantity",
            "unit",
            "computed",
            "published",
            "difference",
            "source",
        ];
        let mut rows = vec![];
        for set in self.sets {
            for law in &set.laws {
                for score in &law.scores {
                    let of = score.of.unit();
                    for one in &score.residuals {
                        let case = &set.cases[one.case];
                        let numbers = [one.predicted, one.published, one.difference]
                            .map(|value| number(units.number(value, of)));
                        let words = [
                            set.set.name,
                            &case.name,
                            law.law,
                            score.of.name(),
                            units.unit(of),
                        ];
                        let row = words
                            .into_iter()
                            .chain(numbers.iter().map(String::as_str))
                            .chain([case.source.as_str()]);
                        rows.push(row.map(str::to_owned).collect());
                    }
                }
            }
        }
        csv_text(head.map(str::to_owned).to_vec(), rows)
    }
}

impl Report for ValidationReport<'_> {
    const COMMAND: &'static str = "validate";

    /// The errors of the best law, the default law and the law `ALTERNATIVE` on every set, then
    /// figures, then each set with every law.
    fn document(&self, system: System) -> Document {
        let mut document = Document::new("Laws of drag and lift beside published drives");
        let length = system.unit("yd");
        let mut about = Document::default();
        about.paragraph(format!(
            "For each law the bias, which is the mean of computed less published, and MAE, the \
             mean of its size; lengths in {length}, angles in °, spin in rpm. Where the air is not \
             stated, drives fly at 25 °C at sea level in calm; the columns \"15 °C\" and \"35 °C\" \
             are the bias of the first quantity at these temperatures. \"averaged\" is the bias of \
             the mean carry of drives that scatter about the average launch, in place of the carry \
             of the average launch: standard deviations of 5.5 mph, 2° of launch angle, 400 rpm \
             and 9° of spin axis, in wind of 4 m/s from any direction, by exact second \
             derivatives; this scatter is assumed. No law is fitted to these numbers here. The \
             sets of TrackMan's charts, the curves and the simulations are output of models, and \
             no set of the {} has measured launch, air and landing together: laws that agree \
             within 3 % of carry cannot be told apart by these numbers.",
            self.sets.len()
        ));
        document.append_detail(about, Detail::WithAll);
        text::summary(&mut document, self.sets, system);
        let mut sets = Document::default();
        sets.heading("In pictures");
        for figure in figures::figures(self.sets, system) {
            sets.figure(figure);
        }
        for set in self.sets {
            text::one(&mut sets, set, system);
        }
        document.append_detail(sets, Detail::WithAll);
        document
    }
}
