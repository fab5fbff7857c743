//! Tables that compare the numbers of the paper with computed numbers.

use crate::report::document::{Document, DocumentTable};
use crate::report::plot::{Axis, Figure, Hue, Layer, NamedQuantity, Shape};
use crate::report::published::{ANGLE, LENGTH, PaperUnits, SPEED, angles};
use crate::reproduce::{LoftCarry, MISPRINTS, RecomputedOptimum, WinfieldTan};
use crate::statistics::largest_magnitude;
use crate::units::{DisplayUnit, Quantity, System, fixed};

pub(super) fn shot(document: &mut Document, found: &WinfieldTan, units: PaperUnits) {
    let (ours, theirs) = (&found.shot.computed, &found.shot.printed);
    let row = |what: &str, of: DisplayUnit, ours: f64, theirs: f64| {
        vec![
            units.printed(of, theirs),
            units.computed(of, ours),
            units.difference(of, ours - theirs),
            what.into(),
        ]
    };
    document.heading("The single shot");
    let [at, in_other] = [units.paper, units.paper.other()]
        .map(|system| Quantity::SPEED.read_off(found.shot.club_speed, system.unit(SPEED.unit)));
    document.paragraph(format!("Loft 10°, attack angle 0°, {at} ({in_other})."));
    let rate = DisplayUnit {
        quantity: Quantity::ANGULAR_VELOCITY,
        unit: "rev/s",
    };
    let time = DisplayUnit {
        quantity: Quantity::TIME,
        unit: "s",
    };
    let table = DocumentTable::new(
        ["printed", "computed", "difference", "what"],
        [
            row("ball upwards", SPEED, ours.up, theirs.up),
            row("ball downrange", SPEED, ours.downrange, theirs.downrange),
            row("backspin", rate, ours.backspin, theirs.backspin),
            row(
                "club downrange after impact",
                SPEED,
                ours.club_after,
                theirs.club_after,
            ),
            row(
                "launch angle",
                ANGLE,
                ours.launch_angle,
                theirs.launch_angle,
            ),
            row("carry", LENGTH, ours.carry, theirs.carry),
            row("flight time", time, ours.flight_time, theirs.flight_time),
            row("apex", LENGTH, ours.apex_height, theirs.apex_height),
            row("time of the apex", time, ours.apex_time, theirs.apex_time),
        ],
    );
    document.add(table.right(0..3));
    document.paragraph(format!(
        "The printed launch angle is a misprint: the printed components of the ball's velocity \
         give {}. The robot Iron Byron, with the same \
         delivery, hit {} ± {}: the computed carry lies {:.2} standard deviations from its mean.",
        units.degrees(theirs.up.atan2(theirs.downrange)),
        units.printed(LENGTH, found.shot.robot.0),
        units.printed(LENGTH, found.shot.robot.1),
        (ours.carry - found.shot.robot.0).abs() / found.shot.robot.1,
    ));
}

pub(super) fn optimum(document: &mut Document, found: &WinfieldTan, units: PaperUnits) {
    let (computed, printed) = (found.optimum.exact(), &found.optimum.printed);
    let at_printed = units.carry_if_flown(found.optimum.at_printed);
    let less = |by: f64| {
        format!(
            "{} {}",
            fixed(units.length_number(by), 3),
            units.length_unit()
        )
    };
    document.heading("The optimum");
    let table = DocumentTable::new(
        ["loft", "attack angle", "carry", ""],
        [
            vec![
                units.degrees(printed.loft),
                units.degrees(printed.attack_angle),
                units.printed(LENGTH, printed.carry),
                "printed".into(),
            ],
            vec![
                units.degrees(printed.loft),
                units.degrees(printed.attack_angle),
                at_printed,
                "printed delivery, computed".into(),
            ],
            vec![
                units.degrees(computed.loft),
                units.degrees(computed.attack_angle),
                units.length(computed.carry),
                "exact".into(),
            ],
        ],
    );
    document.add(table.right(0..3));
    document.paragraph(format!(
        "The optimum lies on a ridge: as the attack angle rises, the best loft falls, and carry \
         hardly changes. The printed delivery \
         carries only {} less than the exact best, so the place on the ridge where a search ends \
         has little meaning. Along the ridge:",
        less(found.optimum.cost())
    ));
    let table = DocumentTable::new(
        ["attack angle", "best loft", "carry", "loss"],
        found.ridge.iter().map(|point| {
            let loss = less((computed.carry - point.carry).max(0.0));
            vec![
                units.degrees(point.attack_angle),
                units.degrees(point.loft),
                units.length(point.carry),
                loss,
            ]
        }),
    );
    document.add(table.right(0..4));
}

pub(super) fn tables(document: &mut Document, found: &WinfieldTan, units: PaperUnits) {
    document.heading("Its tables");
    let all = || found.table1.iter().chain(&found.table2);
    let (carry_rms, carry_worst) = rms_and_largest(
        all().map(|row| units.length_number(row.exact().carry - row.printed.carry)),
    );
    let angles = found
        .table1
        .iter()
        .map(|row| row.exact().attack_angle - row.printed.attack_angle);
    let angles = angles
        .chain(
            found
                .table2
                .iter()
                .map(|row| row.exact().loft - row.printed.loft),
        )
        .map(f64::to_degrees);
    let (angle_rms, angle_worst) = rms_and_largest(angles);
    document.paragraph(format!(
        "Over all {} rows distances differ by {carry_rms:.3} {} rms (at most {carry_worst:.2}), \
         optimum angles by {angle_rms:.3}° rms (at \
         most {angle_worst:.2}°).",
        all().count(),
        units.length_unit(),
    ));
    document.paragraph("Table 1: the best attack angle at each loft.");
    let table = DocumentTable::new(
        [
            "loft",
            "attack printed",
            "attack",
            "carry printed",
            "carry",
            "difference",
        ],
        found.table1.iter().map(|row| line(row, true, units)),
    );
    document.add(table.right(0..6));
    document.paragraph("Table 2: the best loft at each attack angle.");
    let table = DocumentTable::new(
        [
            "attack angle",
            "loft printed",
            "loft",
            "carry printed",
            "carry",
            "difference",
        ],
        found.table2.iter().map(|row| line(row, false, units)),
    );
    document.add(table.right(0..6));
    let slips = MISPRINTS.map(|(table, row, scanned, taken)| {
        format!("Table {table} at {row}° prints {scanned}; {taken} is used instead")
    });
    document.paragraph(format!(
        "Three numbers of the scanned paper do not fit their otherwise smooth columns: {}.",
        slips.join("; ")
    ));
    document.figure(ridges(found, units.system));
    document.figure(left_over(found, units.system));
}

fn line(row: &RecomputedOptimum, is_by_loft: bool, units: PaperUnits) -> Vec<String> {
    let (computed, printed) = (row.exact(), &row.printed);
    let (given, theirs, ours) = match is_by_loft {
        true => (printed.loft, printed.attack_angle, computed.attack_angle),
        false => (printed.attack_angle, printed.loft, computed.loft),
    };
    vec![
        format!("{:.0}°", given.to_degrees()),
        units.degrees(theirs),
        units.degrees(ours),
        units.printed(LENGTH, printed.carry),
        units.length(computed.carry),
        units.difference(LENGTH, computed.carry - printed.carry),
    ]
}

fn ridges(found: &WinfieldTan, system: System) -> Figure {
    let points = |rows: &[RecomputedOptimum], is_printed: bool| {
        let of = |row: &RecomputedOptimum| {
            if is_printed { row.printed } else { row.exact() }
        };
        rows.iter()
            .map(|row| [of(row).attack_angle, of(row).loft])
            .collect::<Vec<_>>()
    };
    Figure::new(
        system,
        "optima",
        "The best attack angle at each loft, and the best loft at each attack angle",
        angles("attack angle"),
        angles("loft"),
    )
    .with(Layer::line(
        "best attack angle",
        0,
        points(&found.table1, false),
    ))
    .with(Layer::line("best loft", 1, points(&found.table2, false)))
    .with(Layer::dots(
        "Table 1, printed",
        0,
        points(&found.table1, true),
    ))
    .with(Layer::dots(
        "Table 2, printed",
        1,
        points(&found.table2, true),
    ))
}

fn left_over(found: &WinfieldTan, system: System) -> Figure {
    let points = |rows: &[RecomputedOptimum]| {
        rows.iter()
            .map(|row| [row.printed.carry, row.exact().carry - row.printed.carry])
            .collect::<Vec<_>>()
    };
    let carry = |label: &str| Axis::linear(NamedQuantity::new(label, Quantity::LENGTH, "yd"));
    Figure::new(
        system,
        "tables-left-over",
        "Residuals of the tables",
        carry("carry printed"),
        carry("computed − printed"),
    )
    .with(Layer::dots("Table 1", 0, points(&found.table1)))
    .with(Layer::dots("Table 2", 1, points(&found.table2)))
}

pub(super) fn average(document: &mut Document, found: &WinfieldTan, units: PaperUnits) {
    let mean = &found.average;
    document.heading("The average over attack angles");
    document.paragraph("Carry averaged over attack angles of 0, 1 … 10°, at each loft.");
    let table = DocumentTable::new(
        ["loft", "average carry"],
        mean.rows.iter().map(|row| {
            vec![
                format!("{:.0}°", row.loft.to_degrees()),
                units.length(row.carry),
            ]
        }),
    );
    document.add(table.right(0..2));
    let row =
        |loft: f64, carry: String, what: &str| vec![units.degrees(loft), carry, what.to_owned()];
    let computed = |best: LoftCarry, what: &str| row(best.loft, units.length(best.carry), what);
    let table = DocumentTable::new(
        ["best loft", "average carry", "how"],
        [
            row(
                mean.printed.loft,
                units.printed(LENGTH, mean.printed.carry),
                "printed: maximum of a polynomial of fifth order",
            ),
            computed(
                mean.by_polynomial,
                "maximum of the polynomial of fifth order through these rows",
            ),
            computed(mean.best, "exact optimum of the average, no polynomial"),
        ],
    );
    document.add(table.right(0..2));
    let carry = Axis::linear(NamedQuantity::new("average carry", Quantity::LENGTH, "yd"));
    let points = |rows: &[LoftCarry]| rows.iter().map(|row| [row.loft, row.carry]).collect();
    let best = mean.by_polynomial;
    let best = Layer::new(
        units.degrees(best.loft),
        Hue::Series(0),
        Shape::Mark([best.loft, best.carry]),
    );
    document.figure(
        Figure::new(
            units.system,
            "average",
            "Average carry over attack angles of 0–10°",
            angles("loft"),
            carry,
        )
        .with(Layer::line(
            "polynomial of fifth order",
            0,
            points(&mean.polynomial),
        ))
        .with(Layer::dots("computed", 0, points(&mean.rows)))
        .with(Layer::dots(
            "printed optimum",
            1,
            vec![[mean.printed.loft, mean.printed.carry]],
        ))
        .with(best),
    );
}

/// Root mean square and largest absolute value of some numbers.
fn rms_and_largest(numbers: impl Iterator<Item = f64> + Clone) -> (f64, f64) {
    let n = numbers.clone().count() as f64;
    let square: f64 = numbers.clone().map(|number| number * number).sum();
    ((square / n).sqrt(), largest_magnitude(numbers))
}
