//! Lines of a report on the optimum of a single drive (not over swings): gain, launch and flight of
//! the optimal drive.

use super::super::document::Line;
use super::super::drive::{total_uncertainty, with_law_held};
use super::super::shown;
use crate::drive::{Drive, Outcome};
use crate::study::Optimum;
use crate::units::System;

/// A line such as "carry 286.0 yd → 300.4 yd: +14.4 yd". If the drive as set up violates
/// constraints, a further line names them.
///
/// If [`Optimum::compares_totals`], the line also has the change of the total (or of the carry, if
/// the total is the objective). A further line states the change of the carry with the law held at
/// the end of its range. If the carry grows and the total falls, a further line advises to maximize
/// the total.
pub(in crate::report) fn gain_lines(
    optimum: &Optimum,
    drive: &Drive<f64>,
    system: System,
) -> Vec<Line> {
    let objective = optimum.search.of.outcome().unwrap_or(Outcome::Carry);
    let start = optimum.drive_as_set_up.as_ref();
    let before = |of: Outcome| start.and_then(|start| of.value(start));
    let change = |of: Outcome| Some(of.value(drive)? - before(of)?);
    let line = |of: Outcome| {
        let best = of.value(drive)?;
        let name = shown::words(of.name());
        let show = |value: f64| shown::outcome(of, value, system);
        let Some(before) = before(of) else {
            return Some(format!("{name} {}", show(best)));
        };
        let change = shown::change_as_displayed(of, before, best, system);
        Some(format!(
            "{name} {} → {}: {change}",
            show(before),
            show(best)
        ))
    };
    let no_alternative = no_alternative(optimum, system);
    if !optimum.compares_totals() {
        let gain = line(objective).map(Line::flush).into_iter();
        return gain.chain(no_alternative).collect();
    }
    let other = match objective {
        Outcome::Total => Outcome::Carry,
        _ => Outcome::Total,
    };
    let lines: Vec<_> = [objective, other].into_iter().filter_map(line).collect();
    let text = format!(
        "{} (totals ± {} at best)",
        lines.join("; "),
        total_uncertainty().in_units(system)
    );
    let falls = |of: Outcome| change(of).is_some_and(|change| change < 0.0);
    let grows_and_falls = !falls(Outcome::Carry) && falls(Outcome::Total);
    let is_advised = objective == Outcome::Carry && grows_and_falls && totals_are_known(optimum);
    let advice = is_advised.then(|| {
        Line::flush("the carry grows and the total falls: `maximize total` finds the longest total")
    });
    let beyond = with_law_held(drive, &optimum.setup, system);
    [Line::flush(text)]
        .into_iter()
        .chain(no_alternative)
        .chain(beyond.map(Line::flush))
        .chain(advice)
        .collect()
}

/// False if the drive as set up or the best drive lands flatter than any measured bounce.
fn totals_are_known(optimum: &Optimum) -> bool {
    let drives = [
        (&optimum.drive_as_set_up, &optimum.start),
        (&optimum.drive, &optimum.setup),
    ];
    drives.into_iter().all(|(drive, setup)| {
        let drive = drive.as_ref();
        drive.is_none_or(|drive| drive.flat_landing_warning(setup).is_none())
    })
}

/// A line with the constraints that the drive as set up violates; `None` if it meets all.
fn no_alternative(optimum: &Optimum, system: System) -> Option<Line> {
    let violated = optimum.violated_as_set_up().into_iter();
    let violated: Vec<_> = violated
        .map(|constraint| shown::constraint(constraint, system))
        .collect();
    (!violated.is_empty()).then(|| {
        Line::flush(format!(
            "the drive as set up violates {}, so it is no alternative to the best drive",
            violated.join(" and ")
        ))
    })
}

/// The optimal drive: objective, carry, roll-out, launch and flight.
pub(in crate::report) fn drive_lines(
    optimum: &Optimum,
    value: f64,
    drive: &Drive<f64>,
    system: System,
) -> Vec<Line> {
    const LAUNCH: [Outcome; 4] = [
        Outcome::BallSpeed,
        Outcome::LaunchAngle,
        Outcome::Backspin,
        Outcome::SmashFactor,
    ];
    const FLIGHT: [Outcome; 4] = [
        Outcome::ApexHeight,
        Outcome::DescentAngle,
        Outcome::FlightTime,
        Outcome::Lateral,
    ];
    let of = optimum.search.of.outcome();
    let line = |outcomes: [Outcome; 4]| {
        let one = |outcome: Outcome| {
            let value = shown::outcome_or_dash(outcome, outcome.value(drive), system);
            format!("{} {value}", shown::words(outcome.name()))
        };
        outcomes.map(one).join(", ")
    };
    let row = |name: &str, text: &str| Line::item(format!("{name:<8}{text}"));
    let both = |of: Outcome| {
        let value = of.value(drive)?;
        Some(row(of.name(), &shown::both(of, value, system)))
    };
    let objective = match of {
        Some(Outcome::Carry) => None,
        Some(of) => Some(row(
            &format!("{} ", shown::words(of.name())),
            &shown::both(of, value, system),
        )),
        None => Some(row(
            &format!("{} ", optimum.search.of.expression),
            &shown::goal(&optimum.search.of, value, system),
        )),
    };
    // if the objective depends on the roll-out, also show total and run; the objective itself is
    // already shown
    let run = [Outcome::Total, Outcome::Run]
        .into_iter()
        .filter(|other| of.is_some_and(|of| of.needs_run() && *other != of))
        .filter_map(both);
    objective
        .into_iter()
        .chain(both(Outcome::Carry))
        .chain(run)
        .chain([row("launch", &line(LAUNCH)), row("flight", &line(FLIGHT))])
        .collect()
}
