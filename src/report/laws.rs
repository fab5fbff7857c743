use super::document::{Document, Line};
use super::reply::Report;
use crate::aerodynamics::{AerodynamicLaw, Fitted, Published};
use crate::parameters::Law;
use crate::units::{Message, System};
use serde::Serialize;

/// The laws of drag and lift: their authors, formulas and fitted ranges.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct LawsReport {
    /// Each law with its published coefficients, then the user's table, if one is given.
    pub laws: Vec<LawReport>,
}

/// A law of drag and lift.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct LawReport {
    /// The name of the law, as the value of `aero.law`.
    pub name: &'static str,
    /// True for the default law.
    pub is_default: bool,
    /// The publication.
    #[serde(flatten)]
    pub published: Published,
    /// The formulas of C_D and C_L.
    pub formula: &'static str,
    /// The fitted ranges.
    pub fitted: Fitted,
}

impl LawsReport {
    /// The report of all laws and of the user's table.
    pub fn new(own: Option<Law<f64>>) -> Self {
        let known = Law::NAMES.iter().filter_map(|name| Law::named(name));
        let laws = known.chain(own).map(LawReport::new).collect();
        Self { laws }
    }
}

impl Report for LawsReport {
    const COMMAND: &'static str = "laws";

    fn document(&self, system: System) -> Document {
        let mut document = Document::default();
        for law in &self.laws {
            document.list(law.lines(system));
        }
        document.list([
            Line::item(
                "choose one with `set aero.law=NAME`; `parameters()` lists the coefficients",
            ),
            Line::item(
                "or your own table with `set aero.table=mine.csv`; `plot laws()` draws them",
            ),
        ]);
        document
    }
}

impl LawReport {
    fn new(law: Law<f64>) -> Self {
        Self {
            name: law.name(),
            is_default: law.name() == Law::default().name(),
            published: law.properties().published,
            formula: law.formula(),
            fitted: law.properties().fitted,
        }
    }

    /// Authors and year; below them formula, fitted range, ball and source.
    fn lines(&self, system: System) -> [Line; 5] {
        let Published {
            authors,
            year,
            ball,
            source,
        } = self.published;
        let year = year.map_or(String::new(), |year| format!(" {year}"));
        let default = if self.is_default { " (default)" } else { "" };
        let range = if self.fitted == Fitted::UNKNOWN {
            "fitted to: not known".into()
        } else {
            let to = Message::from(format!("fitted to {}: ", self.fitted.to));
            self.fitted.in_words(to).in_units(system)
        };
        [
            Line::item(format!("{}{default}: {authors}{year}", self.name)),
            Line::note(self.formula.trim_end_matches('.')),
            Line::note(range),
            Line::note(format!("ball: {}", ball.unwrap_or("not stated"))),
            Line::note(format!("source: {source}")),
        ]
    }
}
