use super::document::{Document, Line};
use super::json::Range;
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
    #[serde(skip)]
    fitted_in_si: Fitted,
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
    pub fitted: FittedReport,
}

/// The measurements to which a law was fitted, and the range of each quantity; `null` for an
/// unknown range.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct FittedReport {
    /// The measurements.
    pub to: Option<&'static str>,
    /// Spin ratio r ω/v.
    pub spin_ratio: Option<Range>,
    /// Spin, rad/s.
    pub spin: Option<Range>,
    /// Reynolds number.
    pub reynolds: Option<Range>,
    /// Speed through the air, m/s.
    pub speed: Option<Range>,
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
        document
    }
}

impl LawReport {
    fn new(law: Law<f64>) -> Self {
        let fitted = law.fitted();
        let range = |range: Option<[f64; 2]>| range.map(Range::from);
        Self {
            fitted_in_si: fitted,
            name: law.name(),
            is_default: law.name() == Law::default().name(),
            published: law.published(),
            formula: law.formula(),
            fitted: FittedReport {
                to: Some(fitted.to).filter(|to| !to.is_empty()),
                spin_ratio: range(fitted.spin_ratio),
                spin: range(fitted.spin),
                reynolds: range(fitted.reynolds),
                speed: range(fitted.speed),
            },
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
        let range = if self.fitted_in_si == Fitted::UNKNOWN {
            "fitted to: not known".into()
        } else {
            let to = Message::from(format!("fitted to {}: ", self.fitted_in_si.to));
            self.fitted_in_si.in_words(to).in_units(system)
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
