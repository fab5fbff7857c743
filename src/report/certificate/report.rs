use super::text::{ending, lines, rows_table};
use super::{stopped, verdict_of};
use crate::derivative::check::{Check, Point};
use crate::drive::Outcome;
use crate::report::document::{Document, Line};
use crate::report::json::Number;
use crate::report::lines::by_reason;
use crate::report::reply::{Ending, Report};
use crate::reproduce::LoopRow;
use crate::study::certificate::{
    Agreement, AtLanding, Certificate, Continuity, Convergence, DetectionTest, NotExamined, Row,
    StepError,
};
use crate::units::{Message, System};
use serde::Serialize;

/// A certificate of derivatives, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct CertificateReport<'a> {
    #[serde(skip)]
    certificate: &'a Certificate,
    #[serde(skip)]
    loops: &'a [LoopRow],
    /// True if nothing failed, every injected error was detected and the command was not
    /// interrupted.
    pub passed: bool,
    /// The derivative of each outcome by each parameter, the largest error first.
    pub rows: Vec<CertificateRow>,
    /// The detection of injected errors.
    pub negative_control: NegativeControl,
    /// Derivatives at the landing, compared with differences at a fixed time.
    pub landing: Vec<LandingCheck>,
    /// The outcomes at parameter values where the number of steps changes.
    pub continuity: Vec<ContinuityCheck>,
    /// The convergence of the outcomes with the time step.
    pub convergence: Vec<ConvergenceCheck>,
    /// The error of the time step in outcomes and derivatives. It has no verdict.
    pub step_errors: Vec<StepErrorReport>,
    /// Omitted checks, with the reasons.
    pub not_examined: Vec<NotExamined>,
    /// The finite differences of carry in the while-loop of the MAE 494 report, for each parameter
    /// by which the derivative of carry is certified.
    pub while_loop: Vec<LoopCheck>,
    /// Outcomes without derivatives at this drive, with the reasons.
    pub missing: Vec<MissingOutcome>,
}

/// A derivative compared with finite differences.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct CertificateRow {
    /// The outcome.
    pub of: Outcome,
    /// The parameter.
    pub parameter: &'static str,
    /// `pass`, `fail` or `corner`.
    #[cfg_attr(test, schemars(with = "crate::derivative::check::Verdict"))]
    pub verdict: &'static str,
    /// The exact derivative, SI.
    pub exact: Number,
    /// The best numerical derivative, SI.
    pub best_difference: Number,
    /// The difference between the two, SI.
    pub error: Number,
    /// The largest allowed difference, SI.
    pub tolerance: Number,
    /// The derivative from `num_dual::Dual64`.
    pub num_dual: AgreementReport,
    /// The one-sided derivatives below and above a corner, SI; `null` on a side outside of the
    /// parameter's range.
    pub sides: Option<[Option<f64>; 2]>,
    /// The step at which the plain central difference has the smallest error, SI.
    pub best_step: Number,
    /// The error of the central difference at `best_step`, SI.
    pub best_step_error: Number,
    /// The slopes of the Taylor remainders of degree 0, 1 and 2 over the step; `null` if the
    /// remainder is dominated by rounding.
    pub taylor_slopes: [Number; 3],
    /// The second derivative by the parameter.
    pub second: Option<CheckReport>,
    /// The V-curve: the error of plain central differences over the step.
    pub curve: Curve,
}

/// A derivative compared with its numerical value.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct CheckReport {
    /// `pass`, `fail` or `corner`.
    #[cfg_attr(test, schemars(with = "crate::derivative::check::Verdict"))]
    pub verdict: &'static str,
    /// The exact derivative, SI.
    pub exact: Number,
    /// The best numerical derivative, SI.
    pub best_difference: Number,
    /// The difference between the two, SI.
    pub error: Number,
    /// The largest allowed difference, SI.
    pub tolerance: Number,
    /// The one-sided derivatives below and above a corner, SI; `null` on a side outside of the
    /// parameter's range.
    pub sides: Option<[Option<f64>; 2]>,
}

/// A derivative compared with the derivative from `num_dual::Dual64`.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct AgreementReport {
    /// `pass` or `fail`.
    #[cfg_attr(test, schemars(with = "crate::derivative::check::Verdict"))]
    pub verdict: &'static str,
    /// The derivative from `num_dual::Dual64`, SI.
    pub derivative: Number,
    /// The difference from the exact derivative, SI.
    pub difference: Number,
    /// The largest allowed difference, SI.
    pub tolerance: Number,
}

/// The errors of central differences over the step.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Curve {
    /// The steps, SI.
    pub steps: Vec<f64>,
    /// The error at each step, SI.
    pub errors: Vec<f64>,
}

/// The detection of injected errors.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct NegativeControl {
    /// True if every injected error was detected.
    pub caught: bool,
    /// The injected errors.
    pub planted: Vec<DetectionTest>,
}

/// A derivative at the landing compared with finite differences at a fixed time.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct LandingCheck {
    /// The comparison.
    #[serde(flatten)]
    pub check: CheckReport,
    /// The outcome.
    pub of: Outcome,
    /// The parameter.
    pub parameter: &'static str,
    /// The contribution of the landing time to the derivative, SI.
    pub landing_term: Number,
}

/// An outcome at a parameter value where the number of steps changes.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ContinuityCheck {
    /// The jumps of the outcome.
    #[serde(flatten)]
    pub found: Continuity,
    /// `pass` or `fail`.
    #[cfg_attr(test, schemars(with = "crate::derivative::check::Verdict"))]
    pub verdict: &'static str,
}

/// The convergence of an outcome with the time step.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ConvergenceCheck {
    /// The outcome.
    pub of: Outcome,
    /// The steps, s.
    pub steps: Vec<f64>,
    /// The relative error of the value at each step.
    pub value_errors: Vec<f64>,
    /// The relative error of the gradient at each step.
    pub gradient_errors: Vec<f64>,
    /// The measured orders for value and gradient; `null` if the errors are dominated by rounding.
    pub orders: [Option<f64>; 2],
    /// The expected orders.
    pub expected: [u32; 2],
    /// The number of continuous derivatives of drag and lift, if joins of the law limit an expected
    /// order; otherwise `null`.
    pub limited_by_law: Option<u32>,
    /// `pass` or `fail`.
    #[cfg_attr(test, schemars(with = "crate::derivative::check::Verdict"))]
    pub verdict: &'static str,
}

/// The error of the time step in an outcome.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct StepErrorReport {
    /// The outcome.
    pub of: Outcome,
    /// The time step and the shorter step for comparison, s.
    pub steps: [f64; 2],
    /// The error of the value, relative to the numbers from which the outcome is computed.
    pub value_error: Number,
    /// The parameter whose derivative has the largest error.
    pub parameter: Option<&'static str>,
    /// The relative error of that derivative.
    pub derivative_error: Number,
    /// The error of the derivative relative to the outcome, for a change of the parameter by its
    /// typical size.
    pub derivative_error_of_outcome: Number,
}

/// A finite difference of the while-loop's carry.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct LoopCheck {
    /// The comparison with the exact derivative.
    #[serde(flatten)]
    pub check: CheckReport,
    /// The parameter.
    pub parameter: &'static str,
    /// The finite difference with a step of 1e-8, SI.
    pub difference: Number,
    /// True if the sign differs from the sign of the derivative.
    pub sign_is_wrong: bool,
    /// The errors over the step.
    pub curve: Curve,
}

/// An outcome without derivatives.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct MissingOutcome {
    /// The outcome.
    pub of: Outcome,
    /// The reason.
    pub message: Message,
}

impl<'a> CertificateReport<'a> {
    /// The report of a certificate, with the while-loop for comparison.
    pub fn new(certificate: &'a Certificate, loops: &'a [LoopRow]) -> Self {
        let missing = certificate.missing.iter().map(|(of, why)| MissingOutcome {
            of: *of,
            message: why.clone(),
        });
        Self {
            certificate,
            loops,
            passed: certificate.passed(),
            rows: certificate.rows.iter().map(CertificateRow::new).collect(),
            negative_control: NegativeControl {
                caught: certificate.caught(),
                planted: certificate.planted.to_vec(),
            },
            landing: certificate.landing.iter().map(LandingCheck::new).collect(),
            continuity: certificate
                .continuity
                .iter()
                .map(ContinuityCheck::new)
                .collect(),
            convergence: certificate
                .convergence
                .iter()
                .map(ConvergenceCheck::new)
                .collect(),
            step_errors: certificate.step.iter().map(StepErrorReport::new).collect(),
            not_examined: certificate.not_examined.clone(),
            while_loop: loops.iter().map(LoopCheck::new).collect(),
            missing: missing.collect(),
        }
    }
}

impl Report for CertificateReport<'_> {
    const COMMAND: &'static str = "verify";

    #[cfg(test)]
    fn statuses() -> Vec<&'static str> {
        vec!["passed", "failed", "interrupted"]
    }

    /// The status is `passed`, `failed` or `interrupted`.
    fn ending(&self) -> Ending {
        let certificate = self.certificate;
        let missing = by_reason(
            certificate
                .missing
                .iter()
                .map(|(of, why)| (of.name(), why.to_string())),
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

    /// The verdict on each derivative, the largest error first, then the other checks, and the
    /// while-loop for comparison.
    fn document(&self, system: System) -> Document {
        let mut document = Document::default();
        document.add(rows_table(&self.certificate.rows));
        document.list([Line::item(
            "errors are the differences from numerical derivatives, and under num-dual from the \
             derivative over num_dual::Dual64, relative to the exact derivative; absolute where it \
             is 0",
        )]);
        let lines = lines(self.certificate, self.loops, system);
        document.list(lines.into_iter().map(Line::item));
        document.paragraph(ending(self.certificate));
        document
    }
}

impl CertificateRow {
    fn new(row: &Row) -> Self {
        let check = &row.first;
        let best = check.best_step();
        Self {
            of: row.of,
            parameter: row.parameter.name,
            verdict: row.verdict().name(),
            exact: check.exact.into(),
            best_difference: check.best.map(|best| best.value).into(),
            error: check.error.into(),
            tolerance: check.bar.into(),
            num_dual: AgreementReport::new(&row.num_dual),
            sides: check.sides,
            best_step: best.map(|best| best.step).into(),
            best_step_error: best.map(|best| best.error).into(),
            taylor_slopes: row.slopes.map(Number::from),
            second: row.second.as_ref().map(CheckReport::new),
            curve: Curve::new(&check.curve),
        }
    }
}

impl CheckReport {
    fn new(check: &Check) -> Self {
        Self {
            verdict: check.verdict.name(),
            exact: check.exact.into(),
            best_difference: check.best.map(|best| best.value).into(),
            error: check.error.into(),
            tolerance: check.bar.into(),
            sides: check.sides,
        }
    }
}

impl AgreementReport {
    fn new(agreement: &Agreement) -> Self {
        Self {
            verdict: verdict_of(agreement.holds()),
            derivative: agreement.num_dual.into(),
            difference: agreement.difference.into(),
            tolerance: agreement.tolerance.into(),
        }
    }
}

impl Curve {
    fn new(points: &[Point]) -> Self {
        Self {
            steps: points.iter().map(|point| point.step).collect(),
            errors: points.iter().map(|point| point.error).collect(),
        }
    }
}

impl LandingCheck {
    fn new(row: &AtLanding) -> Self {
        Self {
            check: CheckReport::new(&row.check),
            of: row.of,
            parameter: row.parameter.name,
            landing_term: row.landing_term.into(),
        }
    }
}

impl ContinuityCheck {
    fn new(found: &Continuity) -> Self {
        Self {
            found: found.clone(),
            verdict: verdict_of(found.passed()),
        }
    }
}

impl ConvergenceCheck {
    fn new(found: &Convergence) -> Self {
        let errors = |which: usize| found.errors.iter().map(|(_, pair)| pair[which]).collect();
        Self {
            of: found.of,
            steps: found.errors.iter().map(|(step, _)| *step).collect(),
            value_errors: errors(0),
            gradient_errors: errors(1),
            orders: found.orders,
            expected: found.expected,
            limited_by_law: found.limited_by_law,
            verdict: verdict_of(found.passed()),
        }
    }
}

impl StepErrorReport {
    fn new(found: &StepError) -> Self {
        Self {
            of: found.of,
            steps: found.steps,
            value_error: found.value.into(),
            parameter: found.derivative.map(|(parameter, _)| parameter.name),
            derivative_error: found.derivative.map(|(_, error)| error).into(),
            derivative_error_of_outcome: found.of_outcome.into(),
        }
    }
}

impl LoopCheck {
    fn new(row: &LoopRow) -> Self {
        Self {
            check: CheckReport::new(&row.check),
            parameter: row.parameter.name,
            difference: row.small_difference().into(),
            sign_is_wrong: row.has_wrong_sign(),
            curve: Curve::new(&row.check.curve),
        }
    }
}
