//! A certificate of derivatives, as text and as JSON.

mod text;

pub(super) use text::add_derivatives;

use crate::derivative::check::{Check, Curve, Verdict};
use crate::drive::Outcome;
use crate::report::by_reason::by_reason;
use crate::report::document::{Document, Line};
use crate::report::json::JsonNumber;
use crate::report::reply::{Ending, Report};
use crate::reproduce::LoopRow;
use crate::study::certificate::{
    Agreement, AtLanding, Certificate, Continuity, Convergence, DerivativeRow, DetectionTest,
    Missing, NotExamined, StepError,
};
use crate::units::System;
use serde::Serialize;
use text::{ending, lines, stopped};

/// A certificate of derivatives, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct CertificateReport<'a> {
    #[serde(skip)]
    certificate: &'a Certificate,
    /// True if nothing failed, every planted error was detected and the command was not
    /// interrupted.
    pub passed: bool,
    /// The derivative of each outcome by each parameter, the largest error first.
    pub rows: Vec<CertificateRow<'a>>,
    /// The negative control: the detection of planted errors.
    pub negative_control: NegativeControl,
    /// Derivatives at the landing, compared with differences at a fixed time.
    pub landing: &'a [AtLanding],
    /// The outcomes at parameter values where the number of time steps changes.
    pub continuity: &'a [Continuity],
    /// The convergence of the outcomes with the time step.
    pub convergence: &'a [Convergence],
    /// The errors of outcomes and derivatives that the time step causes. They do not affect
    /// `passed`.
    pub step_errors: &'a [StepError],
    /// Omitted checks, with the reasons.
    pub not_examined: &'a [NotExamined],
    /// For comparison: finite differences of the carry that the while-loop of the MAE 494 report
    /// computes. The while-loop does not interpolate the landing. Each parameter with a certified
    /// derivative of carry has a row.
    pub while_loop: &'a [LoopRow],
    /// Outcomes without derivatives at this drive, with the reasons.
    pub missing: &'a [Missing],
}

/// A derivative compared with finite differences.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct CertificateRow<'a> {
    /// The outcome.
    pub of: Outcome,
    /// The parameter.
    pub parameter: &'static str,
    /// `pass`, `fail` or `corner`.
    pub verdict: Verdict,
    /// The exact derivative, SI.
    pub exact: JsonNumber,
    /// The best numerical derivative, SI.
    pub best_difference: JsonNumber,
    /// The difference between `exact` and `best_difference`, SI.
    pub error: JsonNumber,
    /// The largest allowed `error`, SI.
    pub tolerance: JsonNumber,
    /// The comparison with the derivative from `num_dual::Dual64`.
    pub num_dual: Agreement,
    /// The one-sided derivatives below and above a corner, SI: `null` without a corner, and on a
    /// side outside of the parameter's range.
    pub sides: Option<[Option<f64>; 2]>,
    /// The step at which the plain central difference has the smallest error, SI.
    pub best_step: JsonNumber,
    /// The error of the central difference at `best_step`, SI.
    pub best_step_error: JsonNumber,
    /// The slopes, on logarithmic scales, of the Taylor remainders of degree 0, 1 and 2 over the
    /// step; `null` if rounding dominates the remainder.
    pub taylor_slopes: [JsonNumber; 3],
    /// The check of the second derivative by the parameter; `null` if this derivative does not
    /// exist or is discontinuous.
    pub second: Option<&'a Check>,
    /// The error of plain central differences at each step: the V-curve.
    pub curve: Curve,
}

/// The negative control: the detection of planted errors.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct NegativeControl {
    /// True if every planted error was detected.
    pub caught: bool,
    /// The planted errors.
    pub planted: Vec<DetectionTest>,
}

impl<'a> CertificateReport<'a> {
    /// The report of a certificate. `loops` has finite differences of the carry that the while-loop
    /// of the MAE 494 report computes.
    pub fn new(certificate: &'a Certificate, loops: &'a [LoopRow]) -> Self {
        Self {
            certificate,
            passed: certificate.passed(),
            rows: certificate.rows.iter().map(CertificateRow::new).collect(),
            negative_control: NegativeControl {
                caught: certificate.caught(),
                planted: certificate.planted.to_vec(),
            },
            landing: &certificate.landing,
            continuity: &certificate.continuity,
            convergence: &certificate.convergence,
            step_errors: &certificate.step,
            not_examined: &certificate.not_examined,
            while_loop: loops,
            missing: &certificate.missing,
        }
    }
}

impl Report for CertificateReport<'_> {
    const COMMAND: &'static str = "verify";

    #[cfg(test)]
    const STATUSES: &'static [&'static str] = &["passed", "failed", "interrupted"];

    fn ending(&self) -> Ending {
        let certificate = self.certificate;
        let missing = by_reason(
            certificate
                .missing
                .iter()
                .map(|missing| (missing.of.name(), missing.reason.to_string())),
        );
        let missing = missing.iter().map(|line| format!("left out: {line}"));
        let failures = certificate.failures();
        let failures = (!failures.is_empty()).then(|| format!("failed: {}", failures.join("; ")));
        let message = stopped(certificate)
            .into_iter()
            .chain(failures)
            .chain(missing)
            .collect::<Vec<_>>()
            .join("; ");
        Ending {
            status: match (certificate.stopped, certificate.passed()) {
                (Some(_), _) => "interrupted",
                (None, true) => "passed",
                (None, false) => "failed",
            },
            message: (!message.is_empty()).then_some(message),
        }
    }

    /// The table of derivatives and verdicts, the largest error first. Below it, a list describes
    /// the other checks and the while-loop.
    fn document(&self, system: System) -> Document {
        let mut document = Document::default();
        add_derivatives(&mut document, &self.certificate.rows);
        let lines = lines(self.certificate, self.while_loop, system);
        document.list(lines.into_iter().map(Line::item));
        document.paragraph(ending(self.certificate));
        document
    }
}

impl<'a> CertificateRow<'a> {
    fn new(row: &'a DerivativeRow) -> Self {
        let check = &row.first;
        let best = check.best_step();
        Self {
            of: row.of,
            parameter: row.parameter.name,
            verdict: row.verdict(),
            exact: check.exact.into(),
            best_difference: check.best_difference.map(|found| found.value).into(),
            error: check.error.into(),
            tolerance: check.tolerance.into(),
            num_dual: row.num_dual,
            sides: check.sides,
            best_step: best.map(|best| best.step).into(),
            best_step_error: best.map(|best| best.error).into(),
            taylor_slopes: row.slopes.map(JsonNumber::from),
            second: row.second.as_ref(),
            curve: Curve::of(&check.curve),
        }
    }
}
