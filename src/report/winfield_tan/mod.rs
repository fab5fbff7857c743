//! Winfield & Tan (1994), reproduced, as a document and as JSON.

mod json;
mod law;
mod numbers;
mod tables;

pub use json::winfield_tan_reply;

use super::document::Document;
use super::published::Published;
use crate::reproduce::WinfieldTan;
use crate::units::System;

/// The paper, reproduced, as a document: computed numbers in the units of `system`, printed ones as
/// the paper prints them, with those units beside.
pub fn winfield_tan_document(found: &WinfieldTan, system: System) -> Document {
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
