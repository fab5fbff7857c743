//! A certificate of derivatives, as text and as JSON.

mod report;
mod text;

pub use report::{CertificateReport, CertificateRow, Curve, LoopCheck, NegativeControl};
pub(super) use text::settled;

use crate::study::certificate::Certificate;
use crate::units::counted;

/// The progress of an interrupted certificate; `None` for a complete certificate.
fn stopped(certificate: &Certificate) -> Option<String> {
    let [done, all] = certificate.stopped?;
    Some(format!(
        "the rows are complete for {done} of {}",
        counted(all as u64, "parameter")
    ))
}
