use crate::derivative::check::Verdict;
use crate::drive::Outcome;
use crate::report::by_reason::by_reason;
use crate::report::document::{Document, DocumentTable, Line};
use crate::report::shown;
use crate::reproduce::LoopRow;
use crate::study::certificate::{
    Certificate, Continuity, Convergence, DerivativeRow, DetectionTest, StepError,
};
use crate::units::{System, counted, counted_of, fixed, significant};

/// Number of rows with the verdict `pass` in a plain text without the option `all`.
const FIRST_ROWS: usize = 6;

/// The progress of an interrupted certificate; `None` for a complete certificate.
pub(super) fn stopped(certificate: &Certificate) -> Option<String> {
    let [done, all] = certificate.stopped?;
    Some(format!(
        "the rows are complete for {done} of {}",
        counted(all as u64, "parameter")
    ))
}

/// The lines below the table of derivatives: corners, failures, then each of the other checks.
pub(super) fn lines(certificate: &Certificate, loops: &[LoopRow], system: System) -> Vec<String> {
    let rows = &certificate.rows;
    let corners = rows.iter().filter(|row| row.verdict() == Verdict::Corner);
    let mut lines: Vec<String> = corners.map(corner).collect();
    for row in rows {
        lines.extend(disagreement(row));
        lines.extend(failure_of_second(row));
    }
    lines.extend(agreement(rows));
    lines.extend(landing(certificate));
    lines.extend(
        certificate
            .continuity
            .iter()
            .map(|found| continuity(found, system)),
    );
    lines.extend(certificate.convergence.iter().map(convergence));
    lines.extend(certificate.planted.iter().map(planted));
    lines.extend(step_error(&certificate.step));
    let not_examined = certificate
        .not_examined
        .iter()
        .map(|it| (it.check.as_str(), it.reason.to_owned()));
    let not_examined = by_reason(not_examined);
    lines.extend(
        not_examined
            .iter()
            .map(|line| format!("not checked: {line}")),
    );
    lines.extend(while_loop(loops));
    let missing = certificate
        .missing
        .iter()
        .map(|missing| (missing.of.name(), missing.reason.in_units(system)));
    let missing = by_reason(missing);
    lines.extend(missing.iter().map(|line| format!("left out: {line}")));
    lines
}

/// The verdict in a sentence, with the number of derivatives by verdict.
pub(super) fn ending(certificate: &Certificate) -> String {
    let rows = &certificate.rows;
    let count = |verdict| rows.iter().filter(|row| row.verdict() == verdict).count();
    let counts = [Verdict::Fail, Verdict::Corner, Verdict::Pass]
        .map(|verdict| format!("{} {}", count(verdict), verdict.name()));
    let counts = counts.join(", ");
    match (stopped(certificate), certificate.passed()) {
        (Some(stopped), _) => format!("interrupted: {stopped}: {counts}"),
        (None, true) => format!("passed: {counts}"),
        (None, false) if rows.is_empty() => "FAILED: there is no derivative to verify".into(),
        (None, false) => format!(
            "FAILED: {}; derivatives: {counts}",
            certificate.failures().join("; ")
        ),
    }
}

/// The text about a parameter value where the number of time steps changes. It states by how much
/// an outcome, its gradient and its Hessian jump there.
fn continuity(found: &Continuity, system: System) -> String {
    let show = |values: [f64; 3]| values.map(one_digit).join(", ");
    let unit = system.unit(found.parameter.unit);
    format!(
        "{}: at {} = {}, where the number of steps changes from {} to {}, {}, its gradient and its \
         Hessian jump by {} (allowed: {})",
        found.verdict.name(),
        found.parameter.name,
        found.parameter.quantity.show(found.at, unit),
        found.steps[0],
        found.steps[1],
        found.of.name(),
        show(found.jumps),
        show(found.tolerances),
    )
}

/// An error with one digit: "4e-16", or "0".
fn one_digit(error: f64) -> String {
    if error == 0.0 {
        return "0".into();
    }
    format!("{error:.0e}")
}

/// The number of rows in which a planted error is detected, as text.
fn planted(planted: &DetectionTest) -> String {
    let name = planted.error.name();
    if planted.rows == 0 {
        return format!(
            "not checked: the planted error \"{name}\" changes none of the derivatives that passed"
        );
    }
    let of_rows = |caught: usize| {
        let rows = planted.rows as u64;
        counted_of(caught as u64, rows, ["row", "rows"])
    };
    format!(
        "{}: the planted error \"{name}\" is found in {} by finite differences, in {} by num-dual",
        Verdict::of(planted.is_caught()).name(),
        of_rows(planted.caught),
        of_rows(planted.caught_by_num_dual)
    )
}

/// The one-sided derivatives at a corner.
fn corner(row: &DerivativeRow) -> String {
    let sides = row
        .first
        .sides
        .unwrap_or_default()
        .map(|side| side.map(|slope| significant(slope, 7)));
    let (of, parameter) = (row.of.name(), row.parameter.name);
    let slopes = match sides {
        [Some(below), Some(above)] => format!("its slope changes from {below} to {above} (SI)"),
        [below, above] => {
            let (slope, side) = if below.is_some() {
                (below, "below")
            } else {
                (above, "above")
            };
            let slope = slope.unwrap_or(shown::NONE.into());
            format!(
                "its slope {side} the value is {slope} (SI); the other side is out of the range \
                 of {parameter}"
            )
        }
    };
    format!("{of} has a corner in {parameter}: {slopes}")
}

/// The text about a second derivative that fails. The table shows only the first derivative. `None`
/// if the second derivative does not fail, or if the first derivative does not pass.
fn failure_of_second(row: &DerivativeRow) -> Option<String> {
    let second = row
        .second
        .as_ref()
        .filter(|it| it.failed() && row.first.verdict == Verdict::Pass)?;
    Some(format!(
        "fail: the second derivative of {} by {} is {} (SI); its difference from the numerical \
         derivative is {:.0e} (allowed: {:.0e}). The first passes.",
        row.of.name(),
        row.parameter.name,
        significant(second.exact, 8),
        second.error,
        second.tolerance,
    ))
}

/// The text about a first derivative for which jets and num-dual disagree; `None` if they agree.
fn disagreement(row: &DerivativeRow) -> Option<String> {
    let found = &row.num_dual;
    if found.verdict == Verdict::Pass {
        return None;
    }
    Some(format!(
        "fail: d {}/d {} is {} over the jets and {} over num-dual (SI); the difference is {:.0e} \
         (allowed: {:.0e})",
        row.of.name(),
        row.parameter.name,
        significant(row.first.exact, 16),
        significant(found.num_dual, 16),
        found.difference,
        found.tolerance,
    ))
}

/// The number of first derivatives that agree with num-dual, as text, with the difference that is
/// largest relative to its tolerance. `None` without derivatives.
fn agreement(rows: &[DerivativeRow]) -> Option<String> {
    let part = |row: &&DerivativeRow| {
        row.num_dual.difference / row.num_dual.tolerance.max(f64::MIN_POSITIVE)
    };
    let worst = rows.iter().max_by(|a, b| part(a).total_cmp(&part(b)))?;
    let agree = rows
        .iter()
        .filter(|row| row.num_dual.verdict == Verdict::Pass)
        .count();
    Some(format!(
        "{}: {} of {} first derivatives agree with those over num_dual::Dual64; the largest \
         difference, of d {}/d {}, is {:.0e} (allowed: {:.0e})",
        Verdict::of(agree == rows.len()).name(),
        agree,
        rows.len(),
        worst.of.name(),
        worst.parameter.name,
        worst.num_dual.difference,
        worst.num_dual.tolerance,
    ))
}

/// Adds the table of the derivatives with their verdicts to a document, and what its columns mean.
pub(in crate::report) fn add_derivatives(document: &mut Document, rows: &[DerivativeRow]) {
    let not_passed = rows
        .iter()
        .filter(|row| row.verdict() != Verdict::Pass)
        .count();
    let head = [
        "outcome",
        "by",
        "verdict",
        "exact (SI)",
        "error",
        "allowed",
        "num-dual",
        "Taylor slopes",
    ];
    let rows = rows.iter().map(|row| {
        let check = &row.first;
        let exact = shown::zero_if_rounding(check.exact, row.ladder.size, row.of, &[row.parameter]);
        let relative = |error: f64| {
            let error = if exact == 0.0 {
                error
            } else {
                error / exact.abs()
            };
            one_digit(error)
        };
        let slopes = row
            .slopes
            .map(|slope| slope.map_or(shown::NONE.into(), |slope| fixed(slope, 1)));
        vec![
            row.of.name().into(),
            row.parameter.name.into(),
            match (row.verdict(), check.verdict) {
                (Verdict::Fail, _) if row.num_dual_fails() => "fail (num-dual)".into(),
                (Verdict::Fail, Verdict::Pass) => "fail (second)".into(),
                (verdict, _) => verdict.name().into(),
            },
            significant(exact, 8),
            relative(check.error),
            relative(check.tolerance),
            relative(row.num_dual.difference),
            slopes.join(" "),
        ]
    });
    let mut table = DocumentTable::new(head, rows).right(3..=6);
    table.key_columns = 2;
    table.first_rows = not_passed + FIRST_ROWS;
    document.add(table);
    document.list([Line::item(
        "error: the difference from the numerical derivative; num-dual: the difference from the \
         derivative over num_dual::Dual64; both relative to the exact derivative, or absolute \
         if it is 0; Taylor slopes: the orders of the Taylor remainders of degree 0, 1 and 2 \
         in the step (expected: at least 1, 2 and 3; – where rounding dominates)",
    )]);
}

/// A sentence that compares the derivatives at the landing with finite differences. The differences
/// are taken at a fixed time and extrapolated to the ground. `None` if there is no derivative to
/// compare.
fn landing(certificate: &Certificate) -> Option<String> {
    let landing = &certificate.landing;
    let worst = landing
        .iter()
        .filter(|row| row.check.verdict != Verdict::Corner)
        .max_by(|a, b| {
            let [a, b] = [a, b].map(|row| {
                (
                    row.check.verdict != Verdict::Pass,
                    row.check.error / row.check.tolerance.max(f64::MIN_POSITIVE),
                )
            });
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        })?;
    let count = |verdict| {
        landing
            .iter()
            .filter(|row| row.check.verdict == verdict)
            .count()
    };
    let corners = match count(Verdict::Corner) {
        0 => String::new(),
        corners => format!(", and {corners} have a corner"),
    };
    Some(format!(
        "{}: {} of {} derivatives at the landing agree with finite differences of the path at \
         a fixed time, extrapolated to the ground{corners}; the largest error, of \
         d {}/d {}, is {:.0e} (allowed: {:.0e})",
        Verdict::of(count(Verdict::Fail) == 0).name(),
        count(Verdict::Pass),
        landing.len(),
        worst.of.name(),
        worst.parameter.name,
        worst.check.error,
        worst.check.tolerance,
    ))
}

/// The text about the finite differences that the while-loop computes for the carry: how many would
/// pass, and the largest error. `None` if no difference can be compared.
fn while_loop(loops: &[LoopRow]) -> Option<String> {
    let relative_error = |row: &&LoopRow| {
        row.difference.map_or(0.0, |it| {
            (it - row.check.exact).abs() / row.check.exact.abs()
        })
    };
    let is_rounding = |row: &LoopRow| {
        shown::zero_if_rounding(row.check.exact, 0.0, Outcome::Carry, &[row.parameter]) == 0.0
    };
    let comparable = loops
        .iter()
        .filter(|row| !is_rounding(row) && row.difference.is_some());
    let worst = comparable.max_by(|a, b| relative_error(a).total_cmp(&relative_error(b)))?;
    let passed = loops
        .iter()
        .filter(|row| row.check.verdict == Verdict::Pass)
        .count();
    Some(format!(
        "for comparison, the while-loop of the MAE 494 report, which stops at the first step below \
         the ground: {} of its carry would pass; {} the wrong sign. The largest error is that of \
         d carry/d {}: the finite difference at a step of 1e-8 of the parameter's scale is {}, the \
         exact derivative {} (SI).",
        counted_of(
            passed as u64,
            loops.len() as u64,
            ["finite difference", "finite differences"]
        ),
        match loops.iter().filter(|row| row.has_wrong_sign).count() {
            1 => "1 has".into(),
            wrong => format!("{wrong} have"),
        },
        worst.parameter.name,
        worst
            .difference
            .map_or(shown::NONE.into(), |it| significant(it, 4)),
        significant(worst.check.exact, 4),
    ))
}

/// The order of convergence of an outcome with the time step.
fn convergence(found: &Convergence) -> String {
    let order = |which: usize| match found.orders[which] {
        None => "not measurable (only rounding errors)".into(),
        Some(order)
            if order < f64::from(found.expected[which]) - 0.75 && !found.falls_short[which] =>
        {
            format!("{order:.2} (the error passes through 0 at these steps, or scatters)")
        }
        Some(order) => format!("{order:.2}"),
    };
    format!(
        "{}: order of convergence with the step: {} for {}, {} for its gradient (expected: {} and \
         {}{})",
        found.verdict.name(),
        order(0),
        found.of.name(),
        order(1),
        found.expected[0],
        found.expected[1],
        found.limited_by_law.map_or(String::new(), |k| format!(
            ", since drag and lift have {k} continuous derivatives"
        ))
    )
}

/// The text about the outcome and the derivative with the largest errors due to the time step;
/// `None` if `errors` is empty.
fn step_error(errors: &[StepError]) -> Option<String> {
    let value = errors
        .iter()
        .max_by(|a, b| a.value_error.total_cmp(&b.value_error))?;
    let mut text = format!(
        "compared with a flight in time steps of {} ms instead of {} ms, {} differs by {:.0e} \
         (relative)",
        1e3 * value.steps[1],
        1e3 * value.steps[0],
        value.of.name(),
        value.value_error
    );
    let worst = errors
        .iter()
        .filter_map(|it| Some((it, it.parameter?, it.derivative_error?)))
        .max_by(|a, b| a.2.total_cmp(&b.2));
    if let Some((found, parameter, error)) = worst {
        let (of, by) = (found.of.name(), parameter.name);
        let of_outcome = found.derivative_error_of_outcome;
        text += &format!(
            ", and d {of}/d {by} by {error:.0e} (relative; for a change of one parameter by its \
             typical size, {of} is wrong by at most {of_outcome:.0e} of its value); all other \
             outcomes and derivatives differ by less, and no verdict depends on these errors"
        );
    }
    Some(text)
}
