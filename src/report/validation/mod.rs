//! The errors of every law of drag and lift on published drives, as a document, JSON and CSV.

mod figures;
mod text;

use super::csv_text::csv_text;
use super::document::Document;
use super::json::{ByName, Number};
use super::reply::Report;
use crate::error::Result;
use crate::study::validation::{Case, Compared, LawScores, Residual, Score, SetScores};
use crate::units::System;
use serde::Serialize;

/// The errors of every law on every set of published drives, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ValidationReport<'a> {
    #[serde(skip)]
    found: &'a [SetScores],
    /// The sets.
    pub sets: Vec<SetReport>,
}

/// The errors of every law on a set of published drives.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct SetReport {
    /// The name of the set.
    pub name: &'static str,
    /// The title of the set.
    pub title: &'static str,
    /// A description of the set.
    pub about: &'static str,
    /// The air of the drives.
    pub air: &'static str,
    /// Limits of the data, and effects that no law can reproduce.
    pub misses: &'static str,
    /// The drives.
    pub cases: Vec<CaseReport>,
    /// The laws.
    pub laws: Vec<LawScoresReport>,
}

/// A published drive.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct CaseReport {
    /// The name of the drive.
    pub name: String,
    /// The publication.
    pub source: String,
    /// The published quantities, SI.
    #[cfg_attr(test, schemars(with = "std::collections::BTreeMap<Compared, Number>"))]
    pub published: ByName<Number>,
}

/// The errors of a law on a set.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct LawScoresReport {
    /// The law.
    pub law: &'static str,
    /// The errors of each quantity.
    #[cfg_attr(
        test,
        schemars(with = "std::collections::BTreeMap<Compared, ScoreReport>")
    )]
    pub scores: ByName<ScoreReport>,
    /// The bias of the first quantity in colder and warmer air; `null` if the source states the
    /// air, and for optima.
    pub bias_in_other_air: Option<BiasInOtherAir>,
    /// The bias of carry, m, if the drive with the average launch is replaced by the mean over
    /// drives with scattered launches; `null` if the published drives are no averages.
    pub bias_averaged: Number,
}

/// The bias of a quantity for another air than the default.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct BiasInOtherAir {
    /// The bias at 15 °C, SI.
    #[serde(rename = "at_15_degC")]
    pub at_15_deg_c: Number,
    /// The bias at 35 °C, SI.
    #[serde(rename = "at_35_degC")]
    pub at_35_deg_c: Number,
}

/// The errors of a quantity.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ScoreReport {
    /// Number of drives that have the quantity and fly.
    pub count: usize,
    /// The mean difference, computed minus published, SI.
    pub bias: Number,
    /// The mean absolute difference, SI.
    pub mean_absolute_error: Number,
    /// The error of each drive.
    pub residuals: Vec<ResidualReport>,
}

/// The error of a quantity for one drive.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ResidualReport {
    /// The values.
    #[serde(flatten)]
    pub values: Residual,
    /// The computed minus the published value, SI.
    pub difference: f64,
}

impl<'a> ValidationReport<'a> {
    /// The report of these errors.
    pub fn new(found: &'a [SetScores]) -> Self {
        Self {
            found,
            sets: found.iter().map(SetReport::new).collect(),
        }
    }

    /// The errors as CSV: a row for each quantity of each drive, in SI.
    ///
    /// # Errors
    /// [`Error::Output`](crate::Error::Output).
    pub fn csv(&self) -> Result<String> {
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
        for set in self.found {
            for law in &set.laws {
                for score in &law.scores {
                    for one in &score.residuals {
                        let case = &set.cases[one.case];
                        let numbers = [one.predicted, one.published, one.difference()]
                            .map(|number| number.to_string());
                        let words = [
                            set.set.name,
                            &case.name,
                            law.law,
                            score.of.name(),
                            score.of.unit().0.si,
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
        text::document(self.found, system)
    }
}

impl SetReport {
    fn new(scores: &SetScores) -> Self {
        let set = scores.set;
        Self {
            name: set.name,
            title: set.title,
            about: set.about,
            air: set.air,
            misses: set.misses,
            cases: scores.cases.iter().map(CaseReport::new).collect(),
            laws: scores.laws.iter().map(LawScoresReport::new).collect(),
        }
    }
}

impl CaseReport {
    fn new(case: &Case) -> Self {
        let published = Compared::ALL
            .iter()
            .filter_map(|of| Some((of.name(), case.published(*of)?)));
        Self {
            name: case.name.clone(),
            source: case.source.clone(),
            published: published.collect(),
        }
    }
}

impl LawScoresReport {
    fn new(scores: &LawScores) -> Self {
        Self {
            law: scores.law,
            scores: scores
                .scores
                .iter()
                .map(|score| (score.of.name(), ScoreReport::new(score)))
                .collect(),
            bias_in_other_air: scores.swept.map(|[cold, warm]| BiasInOtherAir {
                at_15_deg_c: cold.into(),
                at_35_deg_c: warm.into(),
            }),
            bias_averaged: scores.averaged.into(),
        }
    }
}

impl ScoreReport {
    fn new(score: &Score) -> Self {
        let residual = |one: &Residual| ResidualReport {
            values: *one,
            difference: one.difference(),
        };
        Self {
            count: score.residuals.len(),
            bias: score.bias().into(),
            mean_absolute_error: score.mean_absolute().into(),
            residuals: score.residuals.iter().map(residual).collect(),
        }
    }
}
