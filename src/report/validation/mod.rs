//! The errors of every law of drag and lift on published drives, as a document, JSON and CSV.

mod figures;
mod text;

use super::csv_text::csv_text;
use super::document::Document;
use super::reply::Report;
use crate::error::Result;
use crate::study::validation::SetScores;
use crate::units::{DisplayUnit, System, TableUnits};
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
                    let DisplayUnit { quantity, unit } = score.of.unit();
                    for one in &score.residuals {
                        let case = &set.cases[one.case];
                        let numbers = [one.predicted, one.published, one.difference]
                            .map(|value| units.number(value, quantity, unit).to_string());
                        let words = [
                            set.set.name,
                            &case.name,
                            law.law,
                            score.of.name(),
                            units.unit(quantity, unit),
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

    fn document(&self, system: System) -> Document {
        text::document(self.sets, system)
    }
}
