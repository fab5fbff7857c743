use crate::optimize::least_squares::{FitStatus, Loss};
use crate::report::document::{Document, DocumentTable};
use crate::report::shown;
use crate::study::calibrate::{
    Calibration, CalibrationStatus, Estimate, FitResidual, FitStatistics, HeldOut, ShotTable,
    SigmaOrigin, Starts, Undetermined,
};
use crate::units::{
    DisplayUnit, Quantity, System, counted, counted_of, fixed, significant, with_unit,
};

/// Adds a description of the data to a document.
pub(super) fn data(document: &mut Document, table: &ShotTable, system: System) {
    let kind = if table.is_launched {
        "launch conditions, flown without an impact"
    } else {
        "club deliveries"
    };
    document.paragraph(format!(
        "{}, {}; the rows are {kind}.",
        counted(table.shots.len() as u64, "shot"),
        counted(table.residuals() as u64, "measured value")
    ));
    for remark in &table.remarks {
        document.paragraph(remark.in_units(system));
    }
}

/// Adds the results of the searches to a document, if there are several searches.
pub(super) fn starts(document: &mut Document, found: &Calibration) {
    let Starts {
        made,
        at_best,
        others,
    } = &found.starts;
    if *made <= 1 {
        return;
    }
    let of = match found.stopped {
        0 => counted(*made as u64, "start"),
        stopped => format!(
            "the {} with a complete search",
            counted((made - stopped) as u64, "start")
        ),
    };
    let mut text = format!("{at_best} of {of} ended at the sum of squares of this fit");
    for (status, count) in others {
        text += &match status {
            FitStatus::Undefined => {
                format!(
                    "; {count} could not begin, because in some rows the ball does not fly with the \
                     parameters of the start"
                )
            }
            _ => format!("; {count} ended at a larger sum ({status})"),
        };
    }
    document.paragraph(text + ".");
    let mut others = others.iter();
    if others.any(|(status, _)| *status != FitStatus::Converged) {
        document.paragraph(
            "Starts are spread over the ranges of the parameters: with narrower ranges more of the \
             starts reach a minimum.",
        );
    }
}

/// Adds the estimates to a document, with χ² and the combinations of parameters that the data do
/// not determine.
pub(super) fn estimates(
    document: &mut Document,
    table: &ShotTable,
    found: &Calibration,
    system: System,
) {
    let statistics = &found.statistics;
    document.heading("Estimates");
    if found.verdict.status == CalibrationStatus::INTERRUPTED {
        document.paragraph(if found.is_minimum {
            "The fit was interrupted: these values are a minimum, but the stopped searches might \
             have found a lower minimum."
        } else {
            "The fit was interrupted: these values are its last point, not a minimum."
        });
    }
    let head = ["parameter", "estimate", "standard error", "95 % interval"];
    let rows = found
        .estimates
        .iter()
        .map(|estimate| estimated(estimate, system));
    document.add(DocumentTable::new(head, rows).right(1..4));
    document.paragraph(chi_square(statistics, table.sigma_origin));
    for undetermined in &statistics.undetermined {
        document.paragraph(format!(
            "The data do not determine {}.",
            direction(found, undetermined, system)
        ));
    }
}

/// Adds each residual to a document.
pub(super) fn residuals(document: &mut Document, found: &Calibration, system: System) {
    let head = ["row", "measured", "computed − measured", "in σ", "what"];
    let rows = found.residuals.iter().map(|residual| row(residual, system));
    document.add(DocumentTable::new(head, rows).right(0..4));
}

/// Adds the prediction errors on held-out data to a document, if there are any.
pub(super) fn held_out(document: &mut Document, held_out: &[(String, HeldOut)], system: System) {
    if held_out.is_empty() {
        return;
    }
    document.heading("Held-out error");
    let head = ["folds", "rms in σ", "rms by outcome", "law and fit"];
    let rows = held_out
        .iter()
        .map(|(name, held)| held_row(name, held, system));
    document.add(DocumentTable::new(head, rows).right([1]));
}

/// A value in a unit, rounded at the second significant digit of its standard error. Without a
/// standard error, the value has seven significant digits.
pub(super) fn rounded_to_error(
    quantity: Quantity,
    unit: &str,
    value: f64,
    standard_error: Option<f64>,
) -> String {
    let size = quantity.size_of(unit).unwrap_or(1.0);
    let number = quantity.number_in(value, unit);
    let decimals = standard_error
        .filter(|error| *error > 0.0)
        .map(|error| 1.0 - (error / size).log10().floor());
    match decimals {
        Some(decimals @ 0.0..=9.0) => fixed(number, decimals as usize),
        // the number of decimals is below 0 or above 9: round to significant digits
        Some(decimals) if value != 0.0 => {
            let digits = number.abs().log10().floor() + decimals + 1.0;
            significant(number, digits.clamp(4.0, 17.0) as usize)
        }
        _ => significant(number, 7),
    }
}

/// The table row of an estimate. Value and 95 % interval are rounded to the second significant
/// digit of the standard error.
fn estimated(estimate: &Estimate, system: System) -> Vec<String> {
    let Estimate {
        parameter,
        value,
        standard_error,
        interval_95,
        is_at_bound,
        is_determined,
    } = estimate;
    let (quantity, unit) = (parameter.quantity, system.unit(parameter.unit));
    let size = DisplayUnit::from(*parameter).size_in(system);
    let show = |value: f64| {
        with_unit(
            &rounded_to_error(quantity, unit, value, *standard_error),
            unit,
        )
    };
    let (error, interval) = match standard_error.zip(*interval_95) {
        Some((error, ends)) => (significant(error / size, 2), ends.map(&show).join(" .. ")),
        None if !is_determined => (shown::NONE.into(), "not determined by the data".into()),
        None if *is_at_bound => (shown::NONE.into(), "on the bound of its range".into()),
        None => (
            shown::NONE.into(),
            "not known: no scale of the residuals".into(),
        ),
    };
    vec![parameter.name.into(), show(*value), error, interval]
}

/// χ², its degrees of freedom and probability, and the origin of the standard errors, in words.
fn chi_square(statistics: &FitStatistics, stated: SigmaOrigin) -> String {
    let chi = significant(statistics.chi_square, 5);
    let dof = statistics.degrees_of_freedom;
    let freedom = match dof {
        0 => "no degrees of freedom are left: there are at least as many parameters as values"
            .to_owned(),
        _ => counted(dof as u64, "degree") + " of freedom",
    };
    let is_robust = statistics.loss != Loss::Squares;
    let errors = match (statistics.scale, stated) {
        (Some(scale), _) if statistics.is_scaled && is_robust => format!(
            "Standard errors are scaled by √(Σψ²/{dof})/mean ψ′ = {}, where ψ is the derivative of \
             Huber's loss",
            significant(scale, 4)
        ),
        (None, _) if statistics.is_scaled => {
            "Every residual exceeds the limit of Huber's loss: there are no standard errors".into()
        }
        (Some(scale), _) if statistics.is_scaled => format!(
            "Standard errors are scaled by √(χ²/{dof}) = {}, since not every uncertainty is stated",
            significant(scale, 4)
        ),
        (Some(_), SigmaOrigin::Stated) => {
            "Standard errors follow from the stated uncertainties".into()
        }
        (Some(_), _) => {
            "Standard errors follow from the instruments' uncertainties and are not scaled, since \
             the residuals give no \
                         scale"
                .into()
        }
        (None, _) => {
            "No uncertainty is stated and no degree of freedom is left to estimate one: there are \
             no standard errors"
                .into()
        }
    };
    let exact = if statistics.is_exact {
        "; the fit is exact to rounding"
    } else {
        ""
    };
    let probability = match statistics.probability {
        Some(p) => format!(
            " The probability of a χ² at least this large is {}.",
            significant(p, 3)
        ),
        None if is_robust => {
            " It has no probability, since Huber's loss gives large residuals a smaller weight."
                .into()
        }
        None => String::new(),
    };
    format!("χ² = {chi} with {freedom}{exact}.{probability} {errors}.")
}

/// A combination of parameters that the data do not determine, in words. Its components are changes
/// of the parameters in the units of a system; the first component is a change by 1.
fn direction(found: &Calibration, undetermined: &Undetermined, system: System) -> String {
    let parameter = |at: usize| found.estimates[at].parameter;
    let [(first, part), others @ ..] = &undetermined.parts[..] else {
        return "any parameter".into();
    };
    if others.is_empty() && undetermined.standard_error.is_none() {
        return format!(
            "{}: no measured value depends on it",
            parameter(*first).name
        );
    }
    let unit = part / DisplayUnit::from(parameter(*first)).size_in(system);
    let one = |(at, part): &(usize, f64)| {
        let change = shown::component(parameter(*at), part / unit, system);
        format!("{} by {change}", parameter(*at).name)
    };
    let all: Vec<String> = undetermined.parts.iter().map(one).collect();
    match undetermined.standard_error {
        None => format!(
            "a change of {}: no measured value depends on it",
            all.join(" with ")
        ),
        Some(error) => format!(
            "a change of {}: one standard error is {} times this change, more than the range of a \
             parameter",
            all.join(" with "),
            significant((error * unit).abs(), 2)
        ),
    }
}

/// Adds the correlations of the estimates to a document, if there are several.
pub(super) fn correlations(document: &mut Document, found: &Calibration) {
    let n = found.estimates.len();
    if n < 2 {
        return;
    }
    document.heading("Correlations");
    let head: Vec<String> = (0..n)
        .map(|i| format!("{}", i + 1))
        .chain(["parameter".into()])
        .collect();
    let head: Vec<&str> = head.iter().map(String::as_str).collect();
    let cell = |a: usize, b: usize| match found.statistics.correlation(a, b) {
        _ if b > a => String::new(),
        Some(r) => fixed(r, 2),
        None => shown::NONE.into(),
    };
    let rows = (0..n).map(|a| {
        let name = format!("{} {}", a + 1, found.estimates[a].parameter.name);
        (0..n).map(|b| cell(a, b)).chain([name]).collect()
    });
    document.add(DocumentTable::new(head, rows).right(0..n));
}

fn row(residual: &FitResidual, system: System) -> Vec<String> {
    let FitResidual {
        row,
        outcome,
        stationary,
        measured,
        difference,
        residual,
    } = residual;
    let (what, measured, difference) = match stationary {
        Some(parameter) => (
            format!("optimum in {}", parameter.name),
            String::new(),
            shown::change(*parameter, *difference, system),
        ),
        None => (
            outcome.name().into(),
            measured.map_or(String::new(), |value| {
                shown::outcome(*outcome, value, system)
            }),
            shown::change(*outcome, *difference, system),
        ),
    };
    vec![
        row.to_string(),
        measured,
        difference,
        fixed(*residual, 2),
        what,
    ]
}

/// The root mean square of the prediction errors of an outcome on held-out data.
pub(super) struct OutcomeError {
    pub name: String,
    pub rms: f64,
    of: DisplayUnit,
}

/// The root mean square of the prediction errors on held-out data. Each outcome has an entry, and
/// so has each parameter for which a row states that the carry is maximal.
pub(super) fn by_outcome(held: &HeldOut) -> Vec<OutcomeError> {
    // `rms` is the sum of squares until `mean` is applied
    let mut all: Vec<(OutcomeError, usize)> = vec![];
    for residual in &held.residuals {
        let of = residual.outcome;
        let (name, of) = match residual.stationary {
            Some(parameter) => (
                format!("optimum in {}", parameter.name),
                DisplayUnit::from(parameter),
            ),
            None => (of.name().to_owned(), of.into()),
        };
        let square = residual.difference.powi(2);
        if let Some((other, count)) = all.iter_mut().find(|(other, _)| other.name == name) {
            other.rms += square;
            *count += 1;
        } else {
            let error = OutcomeError {
                name,
                rms: square,
                of,
            };
            all.push((error, 1));
        }
    }
    let mean = |(error, count): (OutcomeError, usize)| OutcomeError {
        rms: (error.rms / count as f64).sqrt(),
        ..error
    };
    all.into_iter().map(mean).collect()
}

fn held_row(name: &str, held: &HeldOut, system: System) -> Vec<String> {
    let one = |error: OutcomeError| {
        let rms = shown::difference(error.of, error.rms, system);
        format!("{} {rms}", error.name)
    };
    let outcomes: Vec<_> = by_outcome(held).into_iter().map(one).collect();
    let folds = if held.folds == 0 {
        "not fitted".into()
    } else {
        held.folds.to_string()
    };
    let rms = held
        .mean_square()
        .map_or(shown::NONE.into(), |mean| format!("{:.3}", mean.sqrt()));
    let interrupted = held.count(CalibrationStatus::INTERRUPTED);
    let others = held.statuses.len() - interrupted - held.count(CalibrationStatus::CONVERGED);
    let mut what = match (interrupted, held.statuses.len()) {
        (0, _) => name.to_owned(),
        (stopped, all) if stopped == all => format!("{name}: interrupted, nothing was fitted"),
        (stopped, all) => format!("{name}: interrupted, {stopped} of {all} fits left out"),
    };
    if others > 0 {
        what += &format!(
            "; not converged: {}",
            counted_of(others as u64, held.statuses.len() as u64, ["fit", "fits"])
        );
    }
    vec![folds, rms, outcomes.join(", "), what]
}
