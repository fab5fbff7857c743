//! The MAE 494 report, reproduced, as a document and as JSON.

mod document;
mod json;

pub use document::mae494_document;
pub use json::mae494_json;

use crate::units::significant;

/// An angle in degrees, to four decimals as the report prints it.
fn degrees(radians: f64) -> String {
    format!("{:.4}°", radians.to_degrees())
}

/// A length in metres, to two decimals as the report prints it.
fn metres(length: f64) -> String {
    format!("{length:.2} m")
}

/// A slope by an angle: "+1.052 m per degree".
fn per_degree(slope: f64) -> String {
    format!("{} m per degree", significant(slope.to_radians(), 4))
}
