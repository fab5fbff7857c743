use super::{CalibrationReport, by_outcome};
use crate::report::{Reply, json};
use crate::units::Message;
use serde_json::{Map, Value, json};

/// The answer of `calibrate`: the status and the message are the fit's, unless a fit for the
/// held-out error was interrupted.
pub fn calibration_reply(report: &CalibrationReport<'_>, warnings: Vec<Message>) -> Reply<Value> {
    Reply::done("calibrate", warnings, body(report))
        .ended(report.status().name(), Some(report.message()))
}

fn body(report: &CalibrationReport<'_>) -> Value {
    let CalibrationReport {
        table,
        found,
        held_out,
    } = report;
    let statistics = &found.statistics;
    let names: Vec<&str> = found
        .estimates
        .iter()
        .map(|estimate| estimate.parameter.name)
        .collect();
    let estimates: Map<String, Value> = found
        .estimates
        .iter()
        .map(|estimate| {
            let ends = estimate.standard_error.map(|error| {
                let reach = statistics.reach * error;
                [estimate.value - reach, estimate.value + reach]
            });
            let entry = json!({
                "value": json::number(Some(estimate.value)),
                "standard_uncertainty": json::number(estimate.standard_error),
                "interval_95": ends,
                "at_bound": estimate.is_at_bound,
                "determined": estimate.is_determined,
            });
            (estimate.parameter.name.to_owned(), entry)
        })
        .collect();
    let matrix = |entry: &dyn Fn(usize, usize) -> Option<f64>| {
        let row = |a: usize| {
            (0..names.len())
                .map(|b| json::number(entry(a, b)))
                .collect()
        };
        let values: Vec<Vec<Value>> = (0..names.len()).map(row).collect();
        json!({ "names": names, "values": values })
    };
    let undetermined: Vec<Value> = statistics
        .undetermined
        .iter()
        .map(|direction| {
            Value::Object(json::named(
                direction
                    .parts
                    .iter()
                    .map(|(at, part)| (names[*at], Some(*part))),
            ))
        })
        .collect();
    let residuals: Vec<Value> = found
        .remainders
        .iter()
        .map(|remainder| {
            json!({
                "row": remainder.row,
                "of": remainder.outcome.name(),
                "parameter": remainder.stationary.map(|parameter| parameter.name),
                "measured": json::number(remainder.measured),
                "difference": json::number(Some(remainder.difference)),
                "residual": json::number(Some(remainder.residual)),
            })
        })
        .collect();
    let held: Vec<Value> = held_out
        .iter()
        .map(|(name, held)| {
            let rms: Map<String, Value> = by_outcome(held)
                .into_iter()
                .map(|(name, rms, ..)| (name, json::number(Some(rms))))
                .collect();
            let mut fits = Map::new();
            for status in &held.ended {
                fits.insert(status.name().into(), json!(held.count(*status)));
            }
            json!({
                "fit": name,
                "folds": held.folds,
                "fits": fits,
                "rms_standardized": json::number(held.mean_square().map(f64::sqrt)),
                "rms": rms,
            })
        })
        .collect();
    let elsewhere: Map<String, Value> = found
        .elsewhere
        .iter()
        .map(|(status, count)| (status.name().into(), json!(count)))
        .collect();
    json!({
        "interrupted": report.is_interrupted(),
        "data": {
            "file": table.file,
            "shots": table.shots.len(),
            "values": table.residuals(),
            "launch_conditions": table.is_launched,
            "remarks": table.remarks,
        },
        "estimates": estimates,
        "covariance": matrix(&|a, b| statistics.covariance[a][b]),
        "correlation": matrix(&|a, b| statistics.correlation(a, b)),
        "undetermined": undetermined,
        "chi_square": json::number(Some(statistics.chi_square)),
        "degrees_of_freedom": statistics.degrees_of_freedom,
        "probability": json::number(statistics.probability),
        "uncertainty_scale": json::number(statistics.scale),
        "iterations": found.fit.iterations,
        "evaluations": found.fit.evaluations,
        "refused": { "count": found.fit.refused, "last": found.fit.why_refused },
        "starts": { "made": found.starts.0, "same": found.starts.1, "elsewhere": elsewhere },
        "residuals": residuals,
        "held_out": held,
        "setup": json::setup(&found.setup),
    })
}
