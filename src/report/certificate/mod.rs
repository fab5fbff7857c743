//! A certificate of derivatives, as text and as JSON.

mod report;
mod text;

pub use report::{
    AgreementReport, CertificateReport, CertificateRow, CheckReport, ContinuityCheck,
    ConvergenceCheck, Curve, LandingCheck, LoopCheck, MissingOutcome, NegativeControl,
    StepErrorReport,
};
pub(super) use text::settled;

use crate::derivative::check::Verdict;
use crate::study::certificate::Certificate;
use crate::units::counted;

/// `pass` or `fail`.
fn verdict_of(passed: bool) -> &'static str {
    if passed {
        Verdict::Pass.name()
    } else {
        Verdict::Fail.name()
    }
}

/// The progress of an interrupted certificate.
fn stopped(certificate: &Certificate) -> Option<String> {
    let [done, all] = certificate.stopped?;
    Some(format!(
        "the rows are complete for {done} of {}",
        counted(all as u64, "parameter")
    ))
}
