//! A certificate of derivatives, as text and as JSON.

mod json;
mod text;

pub use json::{CertificateReport, CertificateRow};
pub use text::certificate_text;
pub(super) use text::settled;

use crate::derivative::check::Verdict;
use crate::study::certificate::Certificate;
use crate::units::counted;

fn verdict_of(passed: bool) -> &'static str {
    if passed {
        Verdict::Pass.name()
    } else {
        Verdict::Fail.name()
    }
}

/// How far a certificate came that was interrupted.
fn stopped(certificate: &Certificate) -> Option<String> {
    let [done, all] = certificate.stopped?;
    Some(format!(
        "the rows are complete for {done} of {}",
        counted(all as u64, "parameter")
    ))
}
