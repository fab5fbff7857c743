//! The reproduction of the MAE 494 report, as a document and as JSON.

mod noise;
mod physics;
mod searches;
mod tables;

use super::document::Document;
use super::json::{ByName, JsonNumber};
use super::optimum::Multipliers;
use super::published::PaperUnits;
use super::reply::Report;
use crate::reproduce::{
    Average, DeliveryCarry, Energy, Mae494, Noise, Parametric, RecomputedOptimum, Regression,
    Subsystems,
};
use crate::units::System;
use serde::Serialize;

const STUDY: &str = "mae494";

/// The reproduction of the report, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Mae494Report<'a> {
    #[serde(skip)]
    found: &'a Mae494,
    /// `mae494`.
    #[cfg_attr(test, schemars(extend("const" = STUDY)))]
    pub study: &'static str,
    /// The optimum of the report's regression if the fitted polynomial is evaluated with the wrong
    /// powers, as the report does.
    pub slipped_optimum: DeliveryCarry,
    /// The optimum of the report's model.
    pub optimum: OptimumRow,
    /// The optimum at each attack angle of Table 1.
    pub table1: Vec<TableRow>,
    /// The optimum at each loft of Table 2.
    pub table2: Vec<TableRow>,
    /// The loft with the best average carry.
    pub average: &'a Average,
    /// The optimum of the report's regression.
    pub regression: &'a Regression,
    /// The energy of club and ball.
    pub energy: &'a Energy,
    /// Optima of impact and flight, separately.
    pub subsystems: &'a Subsystems,
    /// The sensitivity of the optimum to the constants of the report's model.
    pub parametric: &'a Parametric,
    /// The noise of the carry that the while-loop computes.
    pub noise: &'a Noise,
    /// The numbers that the report prints.
    pub printed: PrintedReport,
}

/// An optimum with the multipliers of its bounds.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct OptimumRow {
    /// The optimum.
    #[serde(flatten)]
    pub at: DeliveryCarry,
    /// The multipliers of the bounds, by parameter.
    pub multipliers: ByName<Multipliers>,
    /// The names of the active bounds and constraints, with `lower` or `upper` for a bound and
    /// `null` for a constraint.
    pub active: ByName<Option<crate::study::BoundSide>>,
}

/// A row of a table: the exact optimum, and the carry at the printed optimum.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct TableRow {
    /// The exact optimum.
    #[serde(flatten)]
    pub optimum: OptimumRow,
    /// The carry at the printed optimum, m.
    pub carry_at_printed: JsonNumber,
    /// The carry lost at the printed optimum, m.
    pub cost: JsonNumber,
}

/// The numbers in the printed report.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct PrintedReport {
    /// The optimum in the last row of Table 1, at the attack angle of the regression's optimum.
    pub slipped_optimum: Option<DeliveryCarry>,
    /// The optimum.
    pub optimum: DeliveryCarry,
    /// Table 1.
    pub table1: Vec<DeliveryCarry>,
    /// Table 2.
    pub table2: Vec<DeliveryCarry>,
    /// The loft with the best average carry.
    pub average: ByName<f64>,
}

impl<'a> Mae494Report<'a> {
    /// The report of this reproduction.
    pub fn new(found: &'a Mae494) -> Self {
        let rows = |rows: &[RecomputedOptimum]| rows.iter().map(TableRow::new).collect();
        let printed = |rows: &[RecomputedOptimum]| rows.iter().map(|row| row.printed).collect();
        let slipped = found.table1.last();
        Self {
            found,
            study: STUDY,
            slipped_optimum: found.with_wrong_powers,
            optimum: OptimumRow::new(&found.optimum),
            table1: rows(&found.table1),
            table2: rows(&found.table2),
            average: &found.average,
            regression: &found.regression,
            energy: &found.energy,
            subsystems: &found.subsystems,
            parametric: &found.parametric,
            noise: &found.noise,
            printed: PrintedReport {
                slipped_optimum: slipped.map(|row| row.printed),
                optimum: found.optimum.printed,
                table1: printed(&found.table1),
                table2: printed(&found.table2),
                average: [("club.loft", found.average.printed)].into_iter().collect(),
            },
        }
    }
}

impl Report for Mae494Report<'_> {
    const COMMAND: &'static str = "reproduce";

    /// Computed numbers are in the units of `system`. Printed numbers are in the units of the
    /// report and, in parentheses, in the units of `system`.
    fn document(&self, system: System) -> Document {
        let found = self.found;
        let units = PaperUnits {
            angle_decimals: 4,
            paper: Mae494::UNITS,
            system,
        };
        let mut document = Document::new("The MAE 494 report, reproduced");
        document.paragraph(
            "A student report of the course MAE 494, \"Optimization of a Golf Driver\", repeated \
             Winfield & Tan (1994). Here its constants are used in \
             Winfield & Tan's equations (the preset mae494), and each printed number is compared with \
             what that model gives. All numbers \
             except the printed ones are computed by this command.",
        );
        tables::optimum(&mut document, found, units);
        tables::tables(&mut document, found, units);
        tables::average(&mut document, found, units);
        tables::regression(&mut document, found, units);
        physics::energy(&mut document, found, units);
        physics::subsystems(&mut document, found, units);
        physics::parametric(&mut document, found, units);
        noise::noise(&mut document, &found.noise, units);
        searches::searches(&mut document, found, units);
        document
    }
}

impl OptimumRow {
    fn new(row: &RecomputedOptimum) -> Self {
        let solution = &row.best.solution;
        let vary = row.best.search.vary.iter().enumerate();
        let multipliers = vary.map(|(i, vary)| {
            let multipliers = Multipliers {
                lower: solution.lower_multipliers[i],
                upper: solution.upper_multipliers[i],
            };
            (vary.parameter.name, multipliers)
        });
        let active = row.best.active().into_iter();
        Self {
            at: row.exact(),
            multipliers: multipliers.collect(),
            active: active.map(|active| (active.name, active.end)).collect(),
        }
    }
}

impl TableRow {
    fn new(row: &RecomputedOptimum) -> Self {
        Self {
            optimum: OptimumRow::new(row),
            carry_at_printed: row.at_printed.into(),
            cost: row.cost().into(),
        }
    }
}
