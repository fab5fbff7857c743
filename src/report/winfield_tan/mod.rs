//! The reproduction of Winfield & Tan (1994), as a document and as JSON.

mod law;
mod tables;

use super::document::Document;
use super::published::{DeliveryPoint, LoftCarry, Published};
use super::reply::Report;
use crate::reproduce::{Best, Point, SingleShot, WinfieldTan};
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
    /// `winfield-tan`.
    #[cfg_attr(test, schemars(extend("const" = STUDY)))]
    pub study: &'static str,
}

/// The numbers of the paper, either computed or printed.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct PaperNumbers {
    /// The single shot.
    pub shot: ShotNumbers,
    /// The optimum.
    pub optimum: DeliveryPoint,
    /// Table 1.
    pub table1: Vec<DeliveryPoint>,
    /// Table 2.
    pub table2: Vec<DeliveryPoint>,
    /// The loft with the best average carry.
    pub average: LoftCarry,
}

/// The numbers of a shot.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ShotNumbers {
    /// The carry, m.
    pub carry: f64,
    /// The time of flight, s.
    pub flight_time: f64,
    /// The height of the apex, m.
    pub apex_height: f64,
    /// The time of the apex, s.
    pub apex_time: f64,
}

/// A fitted number.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct FittedNumber {
    /// The estimate, SI.
    pub value: f64,
    /// The standard uncertainty of the estimate, SI.
    pub standard_uncertainty: f64,
}

impl<'a> WinfieldTanReport<'a> {
    /// The report of this reproduction.
    pub fn new(found: &'a WinfieldTan) -> Self {
        let (value, standard_uncertainty) = found.fitted.decay;
        Self {
            found,
            computed: PaperNumbers::new(
                found,
                |best| best.computed,
                &found.shot.computed,
                found.average.best,
            ),
            printed: PaperNumbers::new(
                found,
                |best| best.printed,
                &found.shot.printed,
                found.average.printed,
            ),
            spin_decay: FittedNumber {
                value,
                standard_uncertainty,
            },
            study: STUDY,
        }
    }
}

impl PaperNumbers {
    fn new(
        found: &WinfieldTan,
        of: fn(&Best) -> Point,
        shot: &SingleShot,
        (loft, carry): (f64, f64),
    ) -> Self {
        let row = |best: &Best| of(best).into();
        Self {
            shot: ShotNumbers {
                carry: shot.carry,
                flight_time: shot.flight_time,
                apex_height: shot.apex_height,
                apex_time: shot.apex_time,
            },
            optimum: of(&found.optimum).into(),
            table1: found.table1.iter().map(row).collect(),
            table2: found.table2.iter().map(row).collect(),
            average: LoftCarry { loft, carry },
        }
    }
}

impl From<Point> for DeliveryPoint {
    fn from(point: Point) -> Self {
        Self {
            loft: point.loft.into(),
            attack_angle: point.attack_angle.into(),
            carry: point.carry.into(),
        }
    }
}

impl Report for WinfieldTanReport<'_> {
    const COMMAND: &'static str = "reproduce";

    /// Computed numbers in the units of `system`. Printed numbers are in the units of the paper,
    /// with the units of `system` in parentheses.
    fn document(&self, system: System) -> Document {
        let found = self.found;
        let shown = Published {
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
        tables::shot(&mut document, found, shown);
        tables::optimum(&mut document, found, shown);
        tables::tables(&mut document, found, shown);
        tables::average(&mut document, found, shown);
        law::law(&mut document, found, shown);
        law::decay(&mut document, found);
        document
    }
}
