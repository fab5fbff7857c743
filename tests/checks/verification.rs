//! The text of `docs/verification.md`: measured errors of the derivatives.

use longdrive::derivative::check::Verdict;
use longdrive::parameters::PRESETS;
use longdrive::report::figures::vcurve_figure;
use longdrive::report::plot::{Look, figure_svg};
use longdrive::reproduce::{LoopRow, while_loop};
use longdrive::study::certificate::{Certificate, DerivativeRow, certify};
use longdrive::units::System;
use longdrive::{Outcome, Setup};
use std::fmt::Write;
use std::path::Path;

/// The beginning of the page.
pub const HEAD: &str = include_str!("verification_head.md");

/// Writes `docs/verification.md` and its picture if `LONGDRIVE_WRITE_VERIFICATION` is set. The
/// errors are measured, so they may differ on another processor.
pub fn write_on_request() {
    if std::env::var_os("LONGDRIVE_WRITE_VERIFICATION").is_none() {
        return;
    }
    let certificate_of = |name| {
        let setup = Setup::preset(name).unwrap();
        certify(&setup, Outcome::OF_DRIVES, &setup.variables(), &|_, _| true).unwrap()
    };
    let certificates: Vec<_> = PRESETS
        .iter()
        .map(|preset| (preset.name, certificate_of(preset.name)))
        .collect();
    let setup = Setup::preset("mae494").unwrap();
    let loft = [setup.variable("club.loft").unwrap()];
    let carry = certify(&setup, &[Outcome::Carry], &loft, &|_, _| true).unwrap();
    let loops = while_loop(&setup, &carry.rows);
    let sections = [
        HEAD.into(),
        every_outcome(&certificates),
        v_curve(&carry),
        the_loop(&loops),
        smoothness(&certificates),
    ];
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs");
    std::fs::write(docs.join("verification.md"), sections.join("\n")).unwrap();
    let of_loft = carry.rows.iter().filter(|row| row.of == Outcome::Carry);
    let picture = figure_svg(
        &vcurve_figure(of_loft, &loops, System::Us),
        &Look::default(),
    )
    .unwrap();
    std::fs::write(docs.join("pictures/vcurve.svg"), picture).unwrap();
}

fn every_outcome(certificates: &[(&str, Certificate)]) -> String {
    let rows: Vec<_> = certificates
        .iter()
        .map(|(name, certificate)| row(name, certificate))
        .collect();
    format!(
        "## Every outcome by every parameter\n\n\
         | preset | not passed | worst error, relative | largest difference from num-dual, \
         relative | worst error of a second derivative, relative to its tolerance | landing, held \
         at a fixed time: not passed | planted errors missed |\n\
         |---|---|---|---|---|---|---|\n\
         {}\n\n\
         Errors are relative to the derivative, over rows whose derivative is not nearly 0; \
         the tolerance is the largest error that a derivative may have.\n",
        rows.join("\n")
    )
}

fn row(name: &str, certificate: &Certificate) -> String {
    let rows = &certificate.rows;
    let is_something = |row: &&DerivativeRow| row.first.exact.abs() > row.ladder.negligible_size();
    let first = rows
        .iter()
        .filter(is_something)
        .map(|row| row.first.error / row.first.exact.abs());
    let num_dual = rows
        .iter()
        .filter(is_something)
        .map(|row| row.num_dual.difference / row.first.exact.abs());
    let second = rows
        .iter()
        .filter(is_something)
        .filter_map(|row| row.second.as_ref());
    let second = second
        .filter(|check| check.error > 0.0)
        .map(|check| check.error / check.tolerance);
    let not_passed = rows
        .iter()
        .filter(|row| row.verdict() != Verdict::Pass)
        .count();
    let landing_not_passed = certificate
        .landing
        .iter()
        .filter(|row| row.check.verdict != Verdict::Pass)
        .count();
    let missed: usize = certificate
        .planted
        .iter()
        .map(|planted| planted.rows - planted.caught)
        .sum();
    format!(
        "| `{name}` | {not_passed} | {:.0e} | {:.0e} | {:.2} | {landing_not_passed} | {missed} |",
        first.fold(0.0, f64::max),
        num_dual.fold(0.0, f64::max),
        second.fold(0.0, f64::max),
    )
}

fn v_curve(carry: &Certificate) -> String {
    let mut text = String::from(
        "## The V-curve\n\nCarry of `mae494` by loft: the error of plain central differences \
         relative to the derivative, by the step relative to the loft.\n\n\
         | step | error |\n|---|---|\n",
    );
    for row in carry.rows.iter().filter(|row| row.of == Outcome::Carry) {
        for point in row.first.curve.iter().step_by(2) {
            writeln!(
                text,
                "| {:.0e} | {:.0e} |",
                point.step / row.ladder.scale,
                point.error / row.first.exact.abs()
            )
            .unwrap();
        }
        let best = row
            .first
            .best_difference
            .map_or(f64::NAN, |found| found.value);
        writeln!(
            text,
            "\nExact {:.10} m/rad, extrapolated from differences {best:.10}.",
            row.first.exact
        )
        .unwrap();
    }
    for row in carry.landing.iter().filter(|row| row.of == Outcome::Carry) {
        writeln!(
            text,
            "\nWithout the landing term, {:.2} m/rad, it would be {:.2}: a loop that stops at a \
             fixed step has the wrong sign here.",
            row.landing_term,
            row.check.exact - row.landing_term
        )
        .unwrap();
    }
    text
}

fn the_loop(loops: &[LoopRow]) -> String {
    let sentences: String = loops
        .iter()
        .map(|row| {
            format!(
                "A while-loop that stops at the first step below the ground, as the MAE 494 \
                 report's does, gets {:.2} m/rad from a difference at a step of 1e-8 of the \
                 parameter's scale. No step is right: large ones reach over several of its jumps \
                 and have an error from the curvature, small ones lie between two jumps.\n\n",
                row.difference.unwrap_or(f64::NAN)
            )
        })
        .collect();
    format!("{sentences}![V-curves of the smooth landing and of the loop](pictures/vcurve.svg)\n")
}

/// The table of jumps, orders of convergence and errors from the time step: the worst over all
/// outcomes of a preset.
fn smoothness(certificates: &[(&str, Certificate)]) -> String {
    let rows: String = certificates
        .iter()
        .map(|(name, certificate)| smoothness_row(name, certificate))
        .collect();
    format!(
        "## Steps\n\nThe worst of all outcomes of each preset, in the step of the preset.\n\n\
         | preset | largest jump where the number of steps changes: value, gradient, Hessian | \
         lowest order in the step: value, gradient | largest error from the time step: value, \
         worst derivative |\n|---|---|---|---|\n{rows}"
    )
}

fn smoothness_row(name: &str, certificate: &Certificate) -> String {
    let largest = |errors: &mut dyn Iterator<Item = f64>| errors.fold(0.0, f64::max);
    let jumps = [0, 1, 2].map(|i| {
        let jump = largest(&mut certificate.continuity.iter().map(|found| found.jumps[i]));
        format!("{jump:.0e}")
    });
    let orders = [0, 1].map(|i| {
        let orders = certificate.convergence.iter();
        let lowest = orders
            .filter_map(|found| found.orders[i])
            .fold(f64::INFINITY, f64::min);
        format!("{lowest:.2}")
    });
    let value = largest(&mut certificate.step.iter().map(|found| found.value_error));
    let derivatives = certificate.step.iter();
    let derivative = largest(&mut derivatives.map(|found| found.derivative_error.unwrap_or(0.0)));
    format!(
        "| `{name}` | {} | {} | {value:.0e}, {derivative:.0e} |\n",
        jumps.join(", "),
        orders.join(", ")
    )
}
