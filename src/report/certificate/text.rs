use super::{stopped, verdict_of};
use crate::derivative::check::Verdict;
use crate::drive::Outcome;
use crate::report::lines::{broken, by_reason, item, paragraph};
use crate::report::shown;
use crate::report::table::table;
use crate::reproduce::LoopRow;
use crate::study::certificate::{Certificate, Convergence, Row, StepError};
use crate::units::{System, counted, counted_of, fixed, significant};

/// A certificate as text: a verdict for each derivative, the worst first, then the other checks,
/// and the while-loop for comparison.
pub fn certificate_text(certificate: &Certificate, loops: &[LoopRow], system: System) -> String {
    let mut text = rows_text(&certificate.rows) + "\n";
    for row in certificate
        .rows
        .iter()
        .filter(|row| row.verdict() == Verdict::Corner)
    {
        text += &corner_text(row);
    }
    for row in &certificate.rows {
        text += &disagreement_text(row);
        text += &second_text(row);
    }
    text += &agreement_text(&certificate.rows);
    text += &landing_text(certificate);
    for found in &certificate.continuity {
        let show = |values: [f64; 3]| values.map(|value| format!("{value:.0e}")).join(", ");
        text += &format!(
            "  {}: at {} = {}, where the number of steps changes from {} to {}, {}, its gradient \
             and its Hessian jump by {} (allowed: {})\n",
            verdict_of(found.passed()),
            found.parameter.name,
            found
                .parameter
                .quantity
                .show(found.at, system.unit(found.parameter.unit)),
            found.steps[0],
            found.steps[1],
            found.of.name(),
            show(found.jumps),
            show(found.bars),
        );
    }
    for found in &certificate.convergence {
        text += &convergence_text(found);
    }
    for planted in &certificate.planted {
        let (name, caught, rows) = (planted.plant.name(), planted.caught, planted.rows);
        let of_rows = counted_of(caught as u64, rows as u64, ["row", "rows"]);
        text += &match rows {
            0 => format!(
                "  not checked: the planted error \"{name}\": there is no row that passed and that \
                 it changes\n"
            ),
            _ => {
                let by_num_dual = counted_of(
                    planted.caught_by_num_dual as u64,
                    rows as u64,
                    ["row", "rows"],
                );
                let verdict = verdict_of(planted.is_caught());
                format!(
                    "  {verdict}: the planted error \"{name}\" is found in {of_rows} by \
                     differences, in {by_num_dual} by num-dual\n"
                )
            }
        };
    }
    text += &step_text(&certificate.step);
    for line in by_reason(
        certificate
            .not_examined
            .iter()
            .map(|it| (it.check.as_str(), it.reason.to_owned())),
    ) {
        text += &format!("  not checked: {line}\n");
    }
    text += &loops_text(loops);
    for line in by_reason(
        certificate
            .missing
            .iter()
            .map(|(of, why)| (of.name(), why.in_units(system))),
    ) {
        text += &format!("  left out: {line}\n");
    }
    let count = |verdict| {
        certificate
            .rows
            .iter()
            .filter(|row| row.verdict() == verdict)
            .count()
    };
    let counts = [Verdict::Fail, Verdict::Corner, Verdict::Pass]
        .map(|verdict| format!("{} {}", count(verdict), verdict.name()));
    let counts = counts.join(", ");
    let ending = match (stopped(certificate), certificate.passed()) {
        (Some(stopped), _) => format!("interrupted: {stopped}: {counts}"),
        (None, true) => format!("passed: {counts}"),
        (None, false) if certificate.rows.is_empty() => {
            "FAILED: there is no derivative to verify".into()
        }
        (None, false) => format!(
            "FAILED: {}; derivatives: {counts}",
            certificate.failures().join("; ")
        ),
    };
    format!("{}\n{}", broken(&text), paragraph(&ending))
}

/// The slopes to the sides of a corner.
fn corner_text(row: &Row) -> String {
    let sides = row
        .first
        .sides
        .unwrap_or_default()
        .map(|side| side.map(|slope| significant(slope, 7)));
    let (of, parameter) = (row.of.name(), row.parameter.name);
    let slopes = match sides {
        [Some(below), Some(above)] => format!("its slope is {below} below and {above} above (SI)"),
        [below, above] => {
            let (slope, side) = if below.is_some() {
                (below, "below")
            } else {
                (above, "above")
            };
            let slope = slope.unwrap_or_else(|| "–".into());
            format!(
                "its slope is {slope} {side} (SI); the other side is out of the range of \
                 {parameter}"
            )
        }
    };
    format!("  {of} has a corner in {parameter}: {slopes}\n")
}

/// What a second derivative fails by where the first passes, which is what the table shows.
fn second_text(row: &Row) -> String {
    let Some(second) = row
        .second
        .as_ref()
        .filter(|it| it.failed() && row.first.verdict == Verdict::Pass)
    else {
        return String::new();
    };
    format!(
        "  fail: the second derivative of {} by {} is {} (SI); its difference from the numerical \
         derivative is {:.0e} (allowed: {:.0e}). The first passes.\n",
        row.of.name(),
        row.parameter.name,
        significant(second.exact, 8),
        second.error,
        second.bar,
    )
}

/// A first derivative that differs from num-dual's.
fn disagreement_text(row: &Row) -> String {
    let found = &row.num_dual;
    if found.holds() {
        return String::new();
    }
    format!(
        "  fail: d {}/d {} is {} over the jets and {} over num-dual (SI); the difference is {:.0e} \
         (allowed: {:.0e})\n",
        row.of.name(),
        row.parameter.name,
        significant(row.first.exact, 16),
        significant(found.num_dual, 16),
        found.difference,
        found.tolerance,
    )
}

/// The first derivatives over the jets beside those over num-dual: the one that differs most of
/// what it may.
fn agreement_text(rows: &[Row]) -> String {
    let part = |row: &&Row| row.num_dual.difference / row.num_dual.tolerance.max(f64::MIN_POSITIVE);
    let Some(worst) = rows.iter().max_by(|a, b| part(a).total_cmp(&part(b))) else {
        return String::new();
    };
    let agree = rows.iter().filter(|row| row.num_dual.holds()).count();
    format!(
        "  {}: {} of {} first derivatives agree with those over num_dual::Dual64; the largest \
         difference, of d {}/d {}, is {:.0e} (allowed: {:.0e})\n",
        verdict_of(agree == rows.len()),
        agree,
        rows.len(),
        worst.of.name(),
        worst.parameter.name,
        worst.num_dual.difference,
        worst.num_dual.tolerance,
    )
}

fn rows_text(rows: &[Row]) -> String {
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
        let (check, exact) = (&row.first, settled(row));
        let relative = |error: f64| {
            let error = if exact == 0.0 {
                error
            } else {
                error / exact.abs()
            };
            if error == 0.0 {
                "0".into()
            } else {
                format!("{error:.0e}")
            }
        };
        let slopes = row
            .slopes
            .map(|slope| slope.map_or("–".into(), |slope| fixed(slope, 1)));
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
            relative(check.bar),
            relative(row.num_dual.difference),
            slopes.join(" "),
        ]
    });
    let words = "errors are the differences from numerical derivatives, and under num-dual from \
                 the derivative over num_dual::Dual64, relative to the exact derivative; absolute \
                 where it is 0";
    table(&head, &[3, 4, 5, 6], rows) + "\n" + &item(words)
}

/// The exact derivative of a row as texts show it.
pub(in crate::report) fn settled(row: &Row) -> f64 {
    shown::settled(
        row.first.exact,
        row.ladder.size,
        (row.of.quantity(), row.of.unit()),
        &[row.parameter],
    )
}

fn landing_text(certificate: &Certificate) -> String {
    let landing = &certificate.landing;
    let Some(worst) = landing
        .iter()
        .filter(|row| row.check.verdict != Verdict::Corner)
        .max_by(|a, b| {
            let [a, b] = [a, b].map(|row| {
                (
                    row.check.verdict != Verdict::Pass,
                    row.check.error / row.check.bar.max(f64::MIN_POSITIVE),
                )
            });
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        })
    else {
        return String::new();
    };
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
    format!(
        "  {}: {} of {} derivatives at the landing agree with differences at a fixed time, moved \
         to the ground{corners}; the largest error, of \
         d {}/d {}, is {:.0e} (allowed: {:.0e})\n",
        verdict_of(count(Verdict::Fail) == 0),
        count(Verdict::Pass),
        landing.len(),
        worst.of.name(),
        worst.parameter.name,
        worst.check.error,
        worst.check.bar,
    )
}

fn loops_text(loops: &[LoopRow]) -> String {
    let off = |row: &&LoopRow| {
        row.small_difference().map_or(0.0, |it| {
            (it - row.check.exact).abs() / row.check.exact.abs()
        })
    };
    let carry = (Outcome::Carry.quantity(), Outcome::Carry.unit());
    let is_rounding =
        |row: &LoopRow| shown::settled(row.check.exact, 0.0, carry, &[row.parameter]) == 0.0;
    let telling = loops
        .iter()
        .filter(|row| !is_rounding(row) && row.small_difference().is_some());
    let Some(worst) = telling.max_by(|a, b| off(a).total_cmp(&off(b))) else {
        return String::new();
    };
    let passed = loops
        .iter()
        .filter(|row| row.check.verdict == Verdict::Pass)
        .count();
    format!(
        "  for comparison, a while-loop that stops at the first step below the ground (the MAE 494 \
         report's): of the differences of its carry by \
         {}, {passed} would pass, and of {} the sign is wrong; the largest error is by {}: {} at a \
         step of 1e-8 instead of {} (SI)\n",
        counted(loops.len() as u64, "parameter"),
        loops.iter().filter(|row| row.has_wrong_sign()).count(),
        worst.parameter.name,
        worst
            .small_difference()
            .map_or("–".into(), |it| significant(it, 4)),
        significant(worst.check.exact, 4),
    )
}

fn convergence_text(found: &Convergence) -> String {
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
        "  {}: {} converges with the step to order {}, its gradient to order {} (expected: {} and \
         {}{})\n",
        verdict_of(found.passed()),
        found.of.name(),
        order(0),
        order(1),
        found.expected[0],
        found.expected[1],
        found.limited_by_law.map_or(String::new(), |k| format!(
            ", since drag and lift have {k} continuous derivatives"
        ))
    )
}

/// The error of the time step, in one line: the outcome whose value is farthest off, and the
/// derivative that is.
fn step_text(errors: &[StepError]) -> String {
    let Some(value) = errors.iter().max_by(|a, b| a.value.total_cmp(&b.value)) else {
        return String::new();
    };
    let mut text = format!(
        "  compared with a flight in time steps of {} ms instead of {} ms, {} differs by {:.0e} \
         (relative)",
        1e3 * value.steps[1],
        1e3 * value.steps[0],
        value.of.name(),
        value.value
    );
    let worst = errors
        .iter()
        .filter_map(|it| Some((it, it.derivative?)))
        .max_by(|a, b| a.1.1.total_cmp(&b.1.1));
    if let Some((found, (parameter, error))) = worst {
        let (of, by, of_outcome) = (found.of.name(), parameter.name, found.of_outcome);
        text += &format!(
            ", and d {of}/d {by} by {error:.0e} ({of_outcome:.0e} of {of} per size of the \
             parameter); all others differ by less, and no verdict depends on it"
        );
    }
    text + "\n"
}
