use super::{stopped, verdict_of};
use crate::derivative::check::{Check, Point};
use crate::report::lines::by_reason;
use crate::report::{Reply, json};
use crate::reproduce::LoopRow;
use crate::study::certificate::{Agreement, Certificate, Row};
use crate::units::Message;
use serde::Serialize;
use serde_json::{Value, json};

/// A certificate of derivatives as JSON, SI and radians.
#[derive(Clone, Debug, Serialize)]
pub struct CertificateReport {
    /// Whether nothing failed and every planted error was caught.
    pub passed: bool,
    /// Each outcome by each parameter, the worst first.
    pub rows: Vec<CertificateRow>,
    /// What became of the planted errors.
    pub negative_control: Value,
    /// Derivatives at the landing beside differences at a fixed time.
    pub landing: Value,
    /// The outcomes where the number of steps changes.
    pub continuity: Value,
    /// How the outcomes converge with the time step.
    pub convergence: Value,
    /// What the time step leaves of an error in the outcomes and their derivatives: measured, and
    /// not judged.
    pub step_errors: Value,
    /// Checks that were not made, with the reason.
    pub not_examined: Value,
    /// What differences make of the MAE 494 report's while-loop, by each parameter that carry was
    /// certified by.
    pub while_loop: Value,
    /// Outcomes that the drive has no derivatives of, with the reason.
    pub missing: Value,
}

/// A derivative beside differences.
#[derive(Clone, Debug, Serialize)]
pub struct CertificateRow {
    /// The outcome.
    pub of: &'static str,
    /// The parameter.
    pub parameter: &'static str,
    /// `pass`, `fail` or `corner`.
    pub verdict: &'static str,
    /// The exact derivative.
    pub exact: Value,
    /// The best that differences make of it.
    pub best_difference: Value,
    /// How far apart they are.
    pub error: Value,
    /// How far they may be.
    pub tolerance: Value,
    /// The derivative over `num_dual::Dual64`, and how far it is from the exact one.
    pub num_dual: Value,
    /// The slopes below and above a corner; `None` for a side that is out of the parameter's range.
    pub sides: Option<[Option<f64>; 2]>,
    /// The step at which a plain central difference comes nearest.
    pub best_step: Value,
    /// How near.
    pub best_step_error: Value,
    /// The slopes of the remainders of Taylor's polynomials of degree 0, 1, 2; `null` where little
    /// but rounding is left.
    pub taylor_slopes: [Value; 3],
    /// The second derivative by the parameter, likewise.
    pub second: Value,
    /// The V-curve: steps of plain central differences, and their errors.
    pub curve: Value,
}

impl CertificateReport {
    /// The answer of `verify`: `passed`, `failed` or `interrupted`.
    pub fn reply(
        certificate: &Certificate,
        loops: &[LoopRow],
        warnings: Vec<Message>,
    ) -> Reply<Self> {
        let missing = by_reason(
            certificate
                .missing
                .iter()
                .map(|(of, why)| (of.name(), why.to_string())),
        );
        let missing = missing.iter().map(|line| format!("left out: {line}"));
        let failed = certificate.failures();
        let failed = (!failed.is_empty()).then(|| format!("failed: {}", failed.join("; ")));
        let message = stopped(certificate)
            .into_iter()
            .chain(failed)
            .chain(missing)
            .collect::<Vec<_>>()
            .join("; ");
        let message = (!message.is_empty()).then_some(message);
        let status = match (certificate.stopped, certificate.passed()) {
            (Some(_), _) => "interrupted",
            (None, true) => "passed",
            (None, false) => "failed",
        };
        Reply::done("verify", warnings, Self::new(certificate, loops)).ended(status, message)
    }

    fn new(certificate: &Certificate, loops: &[LoopRow]) -> Self {
        let planted = certificate
            .planted
            .iter()
            .map(|planted| json!({ "error": planted.plant.name(), "rows": planted.rows, "caught": planted.caught, "caught_by_num_dual": planted.caught_by_num_dual }));
        let landing = certificate.landing.iter().map(|row| {
            let mut entry = check_json(&row.check);
            entry["of"] = row.of.name().into();
            entry["parameter"] = row.parameter.name.into();
            entry["landing_term"] = json::number(Some(row.landing_term));
            entry
        });
        let continuity = certificate.continuity.iter().map(|found| {
            json!({
                "of": found.of.name(),
                "parameter": found.parameter.name,
                "at": found.at,
                "steps": found.steps,
                "jumps": found.jumps,
                "tolerances": found.bars,
                "verdict": verdict_of(found.passed()),
            })
        });
        let convergence = certificate.convergence.iter().map(|found| {
            let errors = |which: usize| {
                found
                    .errors
                    .iter()
                    .map(|(_, pair)| pair[which])
                    .collect::<Vec<_>>()
            };
            json!({
                "of": found.of.name(),
                "steps": found.errors.iter().map(|(step, _)| *step).collect::<Vec<_>>(),
                "value_errors": errors(0),
                "gradient_errors": errors(1),
                "orders": found.orders,
                "expected": found.expected,
                "limited_by_law": found.limited_by_law,
                "verdict": verdict_of(found.passed()),
            })
        });
        let step_errors = certificate.step.iter().map(|found| {
            json!({
                "of": found.of.name(),
                "steps": found.steps,
                "value_error": json::number(Some(found.value)),
                "parameter": found.derivative.map(|(parameter, _)| parameter.name),
                "derivative_error": json::number(found.derivative.map(|(_, error)| error)),
                "derivative_error_of_outcome": json::number(Some(found.of_outcome)),
            })
        });
        let not_examined = certificate
            .not_examined
            .iter()
            .map(|it| json!({ "check": it.check, "message": it.reason }));
        let missing = certificate
            .missing
            .iter()
            .map(|(of, why)| json!({ "of": of.name(), "message": why }));
        Self {
            passed: certificate.passed(),
            rows: certificate.rows.iter().map(CertificateRow::new).collect(),
            negative_control: json!({ "caught": certificate.caught(), "planted": planted.collect::<Vec<_>>() }),
            landing: landing.collect(),
            continuity: continuity.collect(),
            convergence: convergence.collect(),
            step_errors: step_errors.collect(),
            not_examined: not_examined.collect(),
            while_loop: loops.iter().map(loop_json).collect(),
            missing: missing.collect(),
        }
    }
}

impl CertificateRow {
    fn new(row: &Row) -> Self {
        let check = &row.first;
        let best = check.best_step();
        Self {
            of: row.of.name(),
            parameter: row.parameter.name,
            verdict: row.verdict().name(),
            exact: json::number(Some(check.exact)),
            best_difference: json::number(check.best.map(|best| best.value)),
            error: json::number(Some(check.error)),
            tolerance: json::number(Some(check.bar)),
            num_dual: agreement_json(&row.num_dual),
            sides: check.sides,
            best_step: json::number(best.map(|best| best.step)),
            best_step_error: json::number(best.map(|best| best.error)),
            taylor_slopes: row.slopes.map(json::number),
            second: row.second.as_ref().map(check_json).unwrap_or_default(),
            curve: curve_json(&check.curve),
        }
    }
}

fn agreement_json(agreement: &Agreement) -> Value {
    json!({
        "verdict": verdict_of(agreement.holds()),
        "derivative": json::number(Some(agreement.num_dual)),
        "difference": json::number(Some(agreement.difference)),
        "tolerance": json::number(Some(agreement.tolerance)),
    })
}

fn check_json(check: &Check) -> Value {
    json!({
        "verdict": check.verdict.name(),
        "exact": json::number(Some(check.exact)),
        "best_difference": json::number(check.best.map(|best| best.value)),
        "error": json::number(Some(check.error)),
        "tolerance": json::number(Some(check.bar)),
        "sides": check.sides,
    })
}

fn loop_json(row: &LoopRow) -> Value {
    let mut entry = check_json(&row.check);
    entry["parameter"] = row.parameter.name.into();
    entry["difference"] = json::number(row.small_difference());
    entry["sign_is_wrong"] = row.has_wrong_sign().into();
    entry["curve"] = curve_json(&row.check.curve);
    entry
}

fn curve_json(curve: &[Point]) -> Value {
    let (steps, errors): (Vec<f64>, Vec<f64>) =
        curve.iter().map(|point| (point.step, point.error)).unzip();
    json!({ "steps": steps, "errors": errors })
}
