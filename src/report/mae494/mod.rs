//! The MAE 494 report, reproduced, as a document and as JSON.

mod angle;
mod json;
mod noise;
mod physics;
mod searches;
mod tables;

pub use json::mae494_reply;

use super::document::Document;
use super::published::Published;
use crate::reproduce::Mae494;
use crate::units::System;

/// The report, reproduced, as a document: computed numbers in the units of `system`, printed ones
/// as the report prints them, with those units beside.
pub fn mae494_document(found: &Mae494, system: System) -> Document {
    let shown = Published {
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
    tables::optimum(&mut document, found, shown);
    tables::tables(&mut document, found, shown);
    tables::average(&mut document, found, shown);
    tables::regression(&mut document, found, shown);
    physics::energy(&mut document, found, shown);
    physics::subsystems(&mut document, found, shown);
    physics::parametric(&mut document, found, shown);
    noise::noise(&mut document, &found.noise, shown);
    searches::searches(&mut document, found, shown);
    document
}
