//! The MAE 494 report, reproduced, as a document and as JSON.

mod json;
mod noise;
mod physics;
mod searches;
mod tables;

pub use json::mae494_reply;

use super::document::Document;
use crate::reproduce::Mae494;
use crate::units::significant;

/// The report, reproduced, as a document.
pub fn mae494_document(found: &Mae494) -> Document {
    let mut document = Document::new("The MAE 494 report, reproduced");
    document.paragraph(
        "A student report of the course MAE 494, \"Optimization of a Golf Driver\", repeated Winfield & Tan (1994). Here its constants are used in \
         Winfield & Tan's equations (the preset mae494), and each printed number is compared with what that model gives. All numbers \
         except the printed ones are computed by this command.",
    );
    tables::optimum(&mut document, found);
    tables::tables(&mut document, found);
    tables::average(&mut document, found);
    tables::regression(&mut document, found);
    physics::energy(&mut document, found);
    physics::subsystems(&mut document, found);
    physics::parametric(&mut document, found);
    noise::noise(&mut document, &found.noise);
    searches::searches(&mut document, found);
    document
}

/// An angle in degrees, to four decimals as the report prints it.
fn degrees(radians: f64) -> String {
    format!("{:.4}°", radians.to_degrees())
}

/// A length in metres, to two decimals as the report prints it.
fn metres(length: f64) -> String {
    // a loss of nothing is not one of minus nothing
    format!("{:.2} m", if length.abs() < 0.005 { 0.0 } else { length })
}

/// A slope by an angle: "1.052 m per degree".
fn per_degree(slope: f64) -> String {
    format!("{} m per degree", significant(slope.to_radians(), 4))
}

/// A slope in SI: "-65.4 m/rad".
fn per_radian(slope: f64) -> String {
    format!("{slope:+.1} m/rad")
}
