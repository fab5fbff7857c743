//! What the model itself says to the report's claims.

use super::{degrees, metres};
use crate::report::document::Document;
use crate::reproduce::{Launched, Mae494};
use crate::units::significant;

pub(super) fn energy(document: &mut Document, found: &Mae494) {
    let energy = &found.energy;
    let longest = found.optimum.printed.carry;
    document.heading("Its distances cannot be");
    document.paragraph(format!(
        "No ball leaves this club faster than (1 + e)/(1 + m/M) V = {:.2} m/s, with {:.1} J of the club's {:.1} J. No ball that slow carries \
         farther than {}, whatever its launch angle and spin: the best is {} above horizontal with {} rad/s, and a m/s more would bring {} m. \
         The report's longest distance, {}, needs at least {:.2} m/s, and with it {:.1} J: {:.1} % of all that the club has.",
        energy.fastest,
        energy.ball,
        energy.club,
        metres(energy.farthest.carry),
        degrees(energy.farthest.angle),
        spin(&energy.farthest),
        significant(energy.price_of_speed, 4),
        metres(longest),
        energy.needed.speed,
        energy.ball_needed,
        100.0 * energy.ball_needed / energy.club,
    ));
}

pub(super) fn subsystems(document: &mut Document, found: &Mae494) {
    let parts = &found.subsystems;
    document.heading("Its subsystems");
    document.paragraph(
        "The report says that the optimum of its two subsystems, combined, is that of the whole. But each by itself wants something else, and the impact \
         does not let the flight choose: the loft that raises the launch also slows the ball and spins it.",
    );
    let row = |what: &str, launched: &Launched| {
        vec![
            format!("{:.3} m/s", launched.speed),
            degrees(launched.angle),
            format!("{} rad/s", spin(launched)),
            metres(launched.carry),
            what.into(),
        ]
    };
    document.table(
        &["ball speed", "launch angle", "backspin", "carry", ""],
        [
            row("the optimum of the whole", &parts.whole),
            row("what the flight alone would have at that ball speed", &parts.flight),
            row("what it would have at the fastest ball", &found.energy.farthest),
        ],
    );
    document.paragraph(format!(
        "The impact alone would have the fastest ball, from a face without loft: at attack angle {} it carries {}. The launch that the flight alone \
         would have is without spin, and only a face without loft gives that: at an attack angle of {}, out of every golfer's range. Within the \
         ranges the impact cannot give it, and the optimum of the whole is neither's, {} short of the flight's own.",
        degrees(parts.impact.attack_angle),
        metres(parts.impact.carry),
        degrees(found.energy.farthest.angle),
        metres(parts.flight.carry - parts.whole.carry),
    ));
    let through = |parts: &[f64; 3]| {
        let [speed, angle, spin] = parts.map(|part| format!("{:+.4}", part.to_radians()));
        let sum: f64 = parts.iter().sum();
        let sum = if sum.abs() < 1e-9 { 0.0 } else { sum.to_radians() };
        vec![speed, angle, spin, format!("{sum:+.4}")]
    };
    document.paragraph("What a degree changes of carry there, m, by way of each part of the launch (exact):");
    let rows = [("loft", &parts.by_loft), ("attack angle", &parts.by_attack_angle)];
    document.table(
        &["ball speed", "launch angle", "backspin", "in sum", "by a degree of"],
        rows.map(|(name, parts)| through(parts).into_iter().chain([name.into()]).collect()),
    );
}

pub(super) fn parametric(document: &mut Document, found: &Mae494) {
    let study = &found.parametric;
    document.heading("Its parametric study");
    document.paragraph(
        "The report calls for one and does not make it. These are the exact sensitivities of the optimum to the constants of its model, the one \
         that matters most first: what one per cent more of each does to the best carry and to the best loft. (The best attack angle stays on its \
         bound.)",
    );
    let rows = study.sensitivities.iter().map(|constant| {
        let parameter = constant.sensitivity.parameter;
        vec![
            format!("{:+.4} m", constant.carry_per_cent() + 0.0),
            format!("{:+.4}°", constant.loft_per_cent().to_degrees() + 0.0),
            parameter.show(Some(constant.value)),
            parameter.name.into(),
        ]
    });
    document.table(&["best carry", "best loft", "value", "one per cent more of"], rows);
    document.paragraph(
        "Of the inertia dyadic, of which it says that the shape of the head has a large impact, only the moment about the heel–toe axis takes part in a strike on the \
         sweet spot. What it asks about, by ten per cent, predicted to second order in carry and to first in loft, and searched anew:",
    );
    let rows = study.changes.iter().map(|changed| {
        let value = found.optimum.best.setup.value(changed.change.parameter);
        let part = changed.change.delta / value.unwrap_or(f64::NAN);
        vec![
            metres(changed.second_order),
            changed.resolved.value().map_or("–".into(), metres),
            degrees(changed.predicted[0]),
            degrees(changed.resolved.solution.x[0]),
            format!("{} {:+.0} %", changed.change.parameter.name, 100.0 * part),
        ]
    });
    document.table(&["carry predicted", "carry", "loft predicted", "loft", "change"], rows);
}

/// A spin without the trace that a search leaves of none.
fn spin(launched: &Launched) -> String {
    format!("{:.1}", if launched.spin.abs() < 1e-3 { 0.0 } else { launched.spin })
}
