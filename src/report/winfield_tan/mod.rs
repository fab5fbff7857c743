//! The reproduction of Winfield & Tan (1994), as a document and as JSON.

mod law;
mod tables;

use super::document::Document;
use super::published::PaperUnits;
use super::reply::Report;
use crate::reproduce::{
    DeliveryCarry, FittedNumber, LoftCarry, RecomputedOptimum, SingleShot, WinfieldTan,
};
use crate::units::System;
use serde::Serialize;

const STUDY: &str = "winfield-tan";

/// The reproduction of the paper, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct WinfieldTanReport<'a> {
    #[serde(skip)]
    found: &'a WinfieldTan,
    /// The computed numbers.
    #[serde(flatten)]
    pub computed: PaperNumbers,
    /// The numbers in the paper.
    pub printed: PaperNumbers,
    /// The spin decay rate fitted to the paper's data.
    #[serde(rename = "aero.spin_decay")]
    pub spin_decay: FittedNumber,
    /// The name of the study, `winfield-tan`.
    #[cfg_attr(test, schemars(extend("const" = STUDY)))]
    pub study: &'static str,
}

/// The numbers of the paper, either computed or printed.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct PaperNumbers {
    /// The single shot.
    pub shot: SingleShot,
    /// The optimum.
    pub optimum: DeliveryCarry,
    /// Table 1.
    pub table1: Vec<DeliveryCarry>,
    /// Table 2.
    pub table2: Vec<DeliveryCarry>,
    /// The loft with the best average carry.
    pub average: LoftCarry,
}

impl<'a> WinfieldTanReport<'a> {
    /// The report of this reproduction.
    pub fn new(found: &'a WinfieldTan) -> Self {
        Self {
            found,
            computed: PaperNumbers::new(
                found,
                RecomputedOptimum::exact,
                found.shot.computed,
                found.average.best,
            ),
            printed: PaperNumbers::new(
                found,
                |best| best.printed,
                found.shot.printed,
                found.average.printed,
            ),
            spin_decay: found.fitted.decay,
            study: STUDY,
        }
    }
}

impl PaperNumbers {
    fn new(
        found: &WinfieldTan,
        of: fn(&RecomputedOptimum) -> DeliveryCarry,
        shot: SingleShot,
        average: LoftCarry,
    ) -> Self {
        Self {
            shot,
            optimum: of(&found.optimum),
            table1: found.table1.iter().map(of).collect(),
            table2: found.table2.iter().map(of).collect(),
            average,
        }
    }
}

impl Report for WinfieldTanReport<'_> {
    const COMMAND: &'static str = "reproduce";

    /// Computed numbers in the units of `system`. Printed numbers are in the units of the paper,
    /// with the units of `system` in parentheses.
    fn document(&self, system: System) -> Document {
        let found = self.found;
        let units = PaperUnits {
            angle_decimals: 2,
            paper: WinfieldTan::UNITS,
            system,
        };
        let mut document = Document::new("Winfield & Tan (1994), reproduced");
        document.paragraph(
            "\"Optimization of clubhead loft and swing elevation angles for maximum distance of a golf \
             drive\" finds the loft and the \
             attack angle of the longest drive. Here every drive of which the paper prints a number is \
             computed with the preset winfield-tan. The paper does \
             not print its curves of drag and lift: the law of the preset is calibrated to its tables, \
             so distances agree by design, and the test is \
             how closely one smooth law can meet all of them. The impact has no fitted parameter.",
        );
        tables::shot(&mut document, found, units);
        tables::optimum(&mut document, found, units);
        tables::tables(&mut document, found, units);
        tables::average(&mut document, found, units);
        law::law(&mut document, found, units);
        law::decay(&mut document, found, system);
        document
    }
}
