//! A calibration as a document, as JSON and as a setup file.

mod json;
mod plots;
mod setup_file;

pub use json::calibration_reply;
pub use setup_file::calibration_toml;

use super::document::Document;
use crate::study::calibrate::{Calibration, Estimate, HeldOut, Remainder, ShotTable, Undetermined};
use crate::units::significant;

/// All that a report of a calibration shows.
#[derive(Clone, Copy, Debug)]
pub struct CalibrationReport<'a> {
    /// The data.
    pub table: &'a ShotTable,
    /// The fit.
    pub found: &'a Calibration,
    /// Held-out errors, each with what was fitted.
    pub held_out: &'a [(String, HeldOut)],
}

/// The estimate as a person reads it, with its 95 % interval.
fn estimated(estimate: &Estimate, reach: f64) -> Vec<String> {
    let Estimate { parameter, value, standard_error, is_at_bound } = estimate;
    let show = |value: f64| parameter.show(Some(value));
    let (error, interval) = match standard_error {
        Some(error) => (
            significant(error / parameter.quantity.size_of(parameter.unit).unwrap_or(1.0), 2),
            format!("{} .. {}", show(value - reach * error), show(value + reach * error)),
        ),
        None if *is_at_bound => ("–".into(), "on the bound of its range".into()),
        None => ("–".into(), "not determined by the data".into()),
    };
    vec![parameter.name.into(), show(*value), error, interval]
}

/// The calibration as a document.
pub fn calibration_document(report: &CalibrationReport<'_>) -> Document {
    let CalibrationReport { table, found, held_out } = report;
    let (fit, statistics) = (&found.fit, &found.statistics);
    let mut document = Document::new(&format!("Calibration to {}", table.file));
    document.paragraph(format!(
        "{}: {} ({} iterations, {} evaluations)",
        fit.status, fit.message, fit.iterations, fit.evaluations
    ));
    let kind = if table.is_launched { "launch conditions, flown without an impact" } else { "club deliveries" };
    document.paragraph(format!(
        "{} shots, {} measured values; the rows are {kind}.",
        table.shots.len(),
        table.residuals()
    ));
    for remark in &table.remarks {
        document.paragraph(remark.clone());
    }
    if found.starts.0 > 1 {
        document.paragraph(format!("{} of {} starts ended at this sum.", found.starts.1, found.starts.0));
    }
    if let (1.., Some(why)) = (fit.refused, &fit.why_refused) {
        document.paragraph(format!("{} trial points were refused; the last because of {why}", fit.refused));
    }
    document.heading("Estimates");
    document.table(
        &["parameter", "estimate", "standard error", "95 % interval"],
        found.estimates.iter().map(|estimate| estimated(estimate, statistics.reach)),
    );
    let (chi, dof) = (significant(statistics.chi_square, 5), statistics.degrees_of_freedom);
    document.paragraph(match statistics.probability {
        Some(p) => format!(
            "χ² = {chi} with {dof} degrees of freedom; a sum as large is to be expected with probability {}.",
            significant(p, 3)
        ),
        None if statistics.scale.is_finite() => format!(
            "Sum of squares {chi} with {dof} degrees of freedom: standard errors are scaled by √(sum/{dof}) = {}, since not every \
             uncertainty is stated.",
            significant(statistics.scale, 4)
        ),
        None => "As many parameters as values: nothing is left to tell their uncertainty by.".into(),
    });
    for undetermined in &statistics.undetermined {
        document.paragraph(format!("The data do not determine {}.", said(found, undetermined)));
    }
    correlations(&mut document, found);
    document.heading("Residuals");
    document.table(&["row", "measured", "computed − measured", "in σ", "what"], found.remainders.iter().map(row));
    for figure in plots::figures(found) {
        document.figure(figure);
    }
    if !held_out.is_empty() {
        document.heading("Held-out error");
        let head = ["folds", "rms in σ", "rms by outcome", "law and fit"];
        document.table(&head, held_out.iter().map(|(name, held)| held_row(name, held)));
    }
    document
}

fn said(found: &Calibration, undetermined: &Undetermined) -> String {
    let name = |at: usize| found.estimates[at].parameter.name;
    match &undetermined.parts[..] {
        [(only, _)] => name(*only).into(),
        parts => {
            let one = |(at, part): &(usize, f64)| format!("{:+.3e} {}", part, name(*at));
            format!("{} together", parts.iter().map(one).collect::<Vec<_>>().join(" "))
        }
    }
}

fn correlations(document: &mut Document, found: &Calibration) {
    let n = found.estimates.len();
    if n < 2 {
        return;
    }
    document.heading("Correlations");
    let head: Vec<String> = (0..n).map(|i| format!("{}", i + 1)).chain(["parameter".into()]).collect();
    let head: Vec<&str> = head.iter().map(String::as_str).collect();
    let cell = |a: usize, b: usize| match found.statistics.correlation(a, b) {
        _ if b > a => String::new(),
        Some(r) => format!("{r:.2}"),
        None => "–".into(),
    };
    let rows = (0..n).map(|a| {
        let name = format!("{} {}", a + 1, found.estimates[a].parameter.name);
        (0..n).map(|b| cell(a, b)).chain([name]).collect()
    });
    document.table(&head, rows);
}

fn row(remainder: &Remainder) -> Vec<String> {
    let Remainder { row, outcome, stationary, measured, difference, residual } = remainder;
    let (what, measured, difference) = match stationary {
        Some(parameter) => {
            let difference = short(*difference, parameter.quantity.size_of(parameter.unit), parameter.unit);
            (format!("optimum in {}", parameter.name), String::new(), difference)
        }
        None => (
            outcome.name().into(),
            measured.map_or(String::new(), |value| outcome.show(value)),
            short(*difference, outcome.quantity().size_of(outcome.unit()), outcome.unit()),
        ),
    };
    vec![row.to_string(), measured, difference, format!("{residual:.2}"), what]
}

/// A difference to four decimals of its unit.
fn short(difference: f64, size: Option<f64>, unit: &str) -> String {
    format!("{:+.4} {unit}", difference / size.unwrap_or(1.0)).trim_end().to_owned()
}

/// Root mean squares of the held-out differences, outcome by outcome.
pub(super) fn by_outcome(held: &HeldOut) -> Vec<(String, f64, &'static str, f64)> {
    let mut all: Vec<(String, f64, &'static str, f64, usize)> = vec![];
    for remainder in &held.remainders {
        let (name, quantity, unit) = match remainder.stationary {
            Some(parameter) => (format!("optimum in {}", parameter.name), parameter.quantity, parameter.unit),
            None => (remainder.outcome.name().to_owned(), remainder.outcome.quantity(), remainder.outcome.unit()),
        };
        let size = quantity.size_of(unit).unwrap_or(1.0);
        let square = remainder.difference.powi(2);
        match all.iter_mut().find(|(other, ..)| *other == name) {
            Some((_, sum, _, _, count)) => {
                *sum += square;
                *count += 1;
            }
            None => all.push((name, square, unit, size, 1)),
        }
    }
    all.into_iter().map(|(name, sum, unit, size, count)| (name, (sum / count as f64).sqrt(), unit, size)).collect()
}

fn held_row(name: &str, held: &HeldOut) -> Vec<String> {
    let one =
        |(name, rms, unit, size): (String, f64, &str, f64)| format!("{name} {} {unit}", significant(rms / size, 4));
    let outcomes: Vec<_> = by_outcome(held).into_iter().map(one).collect();
    let folds = if held.folds == 0 { "as it stands".into() } else { held.folds.to_string() };
    vec![folds, format!("{:.3}", held.mean_square().sqrt()), outcomes.join(", "), name.into()]
}
