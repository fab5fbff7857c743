//! Checks of the report's claims with the report's own model.

use crate::report::document::{Document, DocumentTable};
use crate::report::published::{LENGTH, PaperUnits, SPEED};
use crate::report::shown::{NONE, ratio, stated};
use crate::reproduce::{ByLaunch, Launched, Mae494};
use crate::units::{fixed, signed};

pub(super) fn energy(document: &mut Document, found: &Mae494, units: PaperUnits) {
    let energy = &found.energy;
    let longest = found.optimum.printed.carry;
    document.heading("Its distances are not possible");
    document.paragraph(format!(
        "No ball leaves this club faster than (1 + e)/(1 + m/M) V = {}, with {:.1} J of the club's \
         {:.1} J. At this speed no ball carries \
         farther than {}, whatever its launch angle and spin: the best launch is {} above \
         horizontal with {} rad/s of spin, and more speed would \
         add {}. The report's longest distance, {}, needs at least {}, that is {:.1} J: {:.1} % of \
         the club's energy.",
        units.computed(SPEED, energy.fastest),
        energy.ball,
        energy.club,
        units.length(energy.farthest.carry),
        units.degrees(energy.farthest.angle),
        spin(&energy.farthest),
        ratio(LENGTH, SPEED, energy.carry_per_ball_speed, units.system, 4),
        units.printed(LENGTH, longest),
        units.computed(SPEED, energy.needed.speed),
        energy.ball_needed,
        100.0 * energy.ball_needed / energy.club,
    ));
}

pub(super) fn subsystems(document: &mut Document, found: &Mae494, units: PaperUnits) {
    let parts = &found.subsystems;
    document.heading("Its subsystems");
    document.paragraph(
        "The report says that the optimum of its two subsystems, combined, is that of the whole. \
         But the optimum of each subsystem is different, and the \
         flight cannot choose its launch freely: more loft raises the launch angle, but also \
         reduces the ball speed and adds spin.",
    );
    let row = |what: &str, launched: &Launched| {
        vec![
            units.computed(SPEED, launched.speed),
            units.degrees(launched.angle),
            format!("{} rad/s", spin(launched)),
            units.length(launched.carry),
            what.into(),
        ]
    };
    let table = DocumentTable::new(
        ["ball speed", "launch angle", "backspin", "carry", ""],
        [
            row("the optimum of the whole", &parts.whole),
            row(
                "the optimum of the flight alone at that ball speed",
                &parts.flight,
            ),
            row(
                "the optimum of the flight alone at the greatest ball speed",
                &found.energy.farthest,
            ),
        ],
    );
    document.add(table.right(0..4));
    document.paragraph(optima_of_subsystems(found, units));
    document.paragraph(format!(
        "At the optimum of the whole: the change of carry in {} for one degree, through each part \
         of the launch (exact):",
        units.length_unit()
    ));
    add_parts_of_slopes(document, found, units);
}

/// The optimum of the impact alone and the optimum of the flight alone, compared with the optimum
/// of the whole drive.
fn optima_of_subsystems(found: &Mae494, units: PaperUnits) -> String {
    let parts = &found.subsystems;
    format!(
        "The optimum of the impact alone is the greatest ball speed, which a face without loft \
         gives: at attack angle {} it carries {}. The optimum \
         of the flight alone has no spin. Only a face without loft gives a launch without spin, \
         and the launch angle of this optimum then needs an attack angle of {}, which no golfer \
         reaches. No impact within the ranges gives this launch. So the optimum of the whole is \
         not the optimum of a subsystem: it carries {} less than the optimum of the flight.",
        units.degrees(parts.impact.attack_angle),
        units.length(parts.impact.carry),
        units.degrees(found.energy.farthest.angle),
        units.length(parts.flight.carry - parts.whole.carry),
    )
}

/// Adds a table that splits the slopes of the carry into the parts due to ball speed, launch angle
/// and backspin.
fn add_parts_of_slopes(document: &mut Document, found: &Mae494, units: PaperUnits) {
    let parts = &found.subsystems;
    let through = |parts: ByLaunch| {
        let parts = parts.to_array();
        let for_a_degree = |part: f64| with_sign(units.length_number(part).to_radians());
        let [speed, angle, spin] = parts.map(for_a_degree);
        let sum: f64 = parts.iter().sum();
        vec![
            speed,
            angle,
            spin,
            for_a_degree(if sum.abs() < 1e-9 { 0.0 } else { sum }),
        ]
    };
    let rows = [
        ("loft", parts.by_loft),
        ("attack angle", parts.by_attack_angle),
    ];
    let table = DocumentTable::new(
        [
            "ball speed",
            "launch angle",
            "backspin",
            "total",
            "by one degree of",
        ],
        rows.map(|(name, parts)| through(parts).into_iter().chain([name.into()]).collect()),
    );
    document.add(table.right(0..4));
}

pub(super) fn parametric(document: &mut Document, found: &Mae494, units: PaperUnits) {
    let study = &found.parametric;
    document.heading("Its parametric study");
    document.paragraph(
        "The report proposes a parametric study but does not make one. These are the exact \
         sensitivities of the optimum to the constants of its model, \
         the largest first: the change of the best carry and of the best loft when a constant \
         grows by one per cent. (The best attack angle stays at \
         its bound.)",
    );
    let rows = study.sensitivities.iter().map(|constant| {
        let parameter = constant.parameter;
        vec![
            format!(
                "{} {}",
                with_sign(units.length_number(constant.carry_per_cent())),
                units.length_unit()
            ),
            format!("{}°", with_sign(constant.loft_per_cent().to_degrees())),
            stated(parameter, constant.at, units.system),
            parameter.name.into(),
        ]
    });
    let table = DocumentTable::new(
        ["best carry", "best loft", "value", "one per cent more of"],
        rows,
    );
    document.add(table.right(0..3));
    document.paragraph(
        "The report says that the shape of the head has a large effect through the inertia dyadic; \
         in a strike on the sweet spot only the moment about \
         the heel–toe axis has an effect. The constants it asks about, changed by ten per cent: \
         predicted to second order in carry and to first order in \
         loft, and found by a new search:",
    );
    let rows = study.changes.iter().map(|changed| {
        let value = found.optimum.best.setup.value(changed.parameter);
        let part = changed.change / value.unwrap_or(f64::NAN);
        let carry = |carry: Option<f64>| carry.map_or(NONE.into(), |carry| units.length(carry));
        vec![
            carry(changed.predicted.value),
            carry(changed.resolved.value),
            units.degrees(changed.predicted.loft()),
            units.degrees(changed.resolved.loft()),
            format!("{} {:+.0} %", changed.parameter.name, 100.0 * part),
        ]
    });
    let table = DocumentTable::new(
        [
            "carry predicted",
            "carry",
            "loft predicted",
            "loft",
            "change",
        ],
        rows,
    );
    document.add(table.right(0..4));
}

/// A change with four decimals and its sign.
fn with_sign(change: f64) -> String {
    signed(change, fixed(change, 4))
}

/// A spin, rad/s. Values below 1e-3 are rounding errors of a search and are displayed as 0.
fn spin(launched: &Launched) -> String {
    format!(
        "{:.1}",
        if launched.spin.abs() < 1e-3 {
            0.0
        } else {
            launched.spin
        }
    )
}
