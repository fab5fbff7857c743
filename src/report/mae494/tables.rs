//! Printed optima of the report, compared with the exact optima.

use crate::report::document::{Document, DocumentTable};
use crate::report::plot::{Figure, Layer};
use crate::report::published::{ANGLE, LENGTH, PaperUnits, angles};
use crate::report::shown::ratio;
use crate::reproduce::{Mae494, RecomputedOptimum};
use crate::units::System;

pub(super) fn optimum(document: &mut Document, found: &Mae494, units: PaperUnits) {
    let RecomputedOptimum { printed, best, .. } = &found.optimum;
    let exact = found.optimum.exact();
    document.heading("The optimum");
    document.paragraph(format!(
        "Within loft 0–20° and attack angle −10…+10° the report's own model carries farthest at \
         loft {}, attack angle {}: {} ({}). The \
         report recommends {} and {} and prints {}; in its model that delivery carries {}, which \
         is {} less than the best.",
        units.degrees(exact.loft),
        units.degrees(exact.attack_angle),
        units.length(exact.carry),
        active_bounds(&found.optimum, units),
        units.degrees(printed.loft),
        units.degrees(printed.attack_angle),
        units.printed(LENGTH, printed.carry),
        units.carry_if_flown(found.optimum.at_printed),
        units.length(found.optimum.cost()),
    ));
    document.paragraph(format!("The search {}: {}.", best.status(), best.message()));
}

pub(super) fn tables(document: &mut Document, found: &Mae494, units: PaperUnits) {
    let active = |rows: &[RecomputedOptimum]| {
        let is_at_a_bound = |row: &&RecomputedOptimum| !row.best.active().is_empty();
        rows.iter().filter(is_at_a_bound).count()
    };
    document.heading("Its tables");
    document.paragraph(format!(
        "The report says that no constraint was active. In its model the bound of loft is active \
         at {} of {} attack angles, and that of the \
         attack angle at {} of {} lofts. The cost is the carry of the exact optimum less that of \
         the printed delivery; a printed delivery that does not fly counts with a carry of 0.",
        active(&found.table1),
        found.table1.len(),
        active(&found.table2),
        found.table2.len(),
    ));
    let row = |row: &RecomputedOptimum, given: f64, printed: f64, exact: f64| {
        vec![
            format!("{:.0}°", given.to_degrees()),
            units.degrees(printed),
            units.printed(LENGTH, row.printed.carry),
            units.carry_if_flown(row.at_printed),
            units.degrees(exact),
            units.length(row.exact().carry),
            units.length(row.cost()),
            active_bounds(row, units),
        ]
    };
    let head = |given: &'static str, best: &'static str, exact: &'static str| {
        [
            given,
            best,
            "distance printed",
            "its carry",
            exact,
            "carry",
            "cost",
            "active bounds",
        ]
    };
    document.paragraph("Table 1: the best loft at each attack angle.");
    let table = DocumentTable::new(
        head("attack angle", "loft printed", "exact best loft"),
        found
            .table1
            .iter()
            .map(|r| row(r, r.printed.attack_angle, r.printed.loft, r.exact().loft)),
    );
    document.add(table.right(0..7));
    document.figure(best_lofts(&found.table1, units.system));
    document.paragraph("Table 2: the best attack angle at each loft.");
    let table = DocumentTable::new(
        head("loft", "attack angle printed", "exact best attack angle"),
        found.table2.iter().map(|r| {
            row(
                r,
                r.printed.loft,
                r.printed.attack_angle,
                r.exact().attack_angle,
            )
        }),
    );
    document.add(table.right(0..7));
}

fn best_lofts(rows: &[RecomputedOptimum], system: System) -> Figure {
    let points = |loft: fn(&RecomputedOptimum) -> f64| {
        rows.iter()
            .map(|row| [row.printed.attack_angle, loft(row)])
            .collect()
    };
    Figure::new(
        system,
        "table-1",
        "The best loft at each attack angle",
        angles("attack angle"),
        angles("loft"),
    )
    .with(Layer::dots(
        "as the report prints it",
        1,
        points(|row| row.printed.loft),
    ))
    .with(Layer::line(
        "exact, within 0–20°",
        0,
        points(|row| row.exact().loft),
    ))
}

/// The active bounds in words, such as "club.loft at its upper bound, 0.52 m per deg beyond it".
fn active_bounds(row: &RecomputedOptimum, units: PaperUnits) -> String {
    let solution = &row.best.solution;
    let bounds = row.best.active().into_iter().filter_map(|active| {
        let i = row
            .best
            .search
            .vary
            .iter()
            .position(|vary| vary.parameter.name == active.name)?;
        let price = solution.lower_multipliers[i] + solution.upper_multipliers[i];
        Some(format!(
            "{active}, {} beyond it",
            ratio(LENGTH, ANGLE, price, units.system, 4)
        ))
    });
    let bounds: Vec<_> = bounds.collect();
    if bounds.is_empty() {
        "free".into()
    } else {
        bounds.join(", ")
    }
}

pub(super) fn average(document: &mut Document, found: &Mae494, units: PaperUnits) {
    let average = &found.average;
    document.heading("The average over attack angles");
    let longest = average
        .rows
        .iter()
        .max_by(|a, b| a.carry.total_cmp(&b.carry));
    let whole = longest.map_or(String::new(), |longest| {
        format!(
            "Of the computed lofts, {:.0}° has the longest average carry ({}). ",
            longest.loft.to_degrees(),
            units.length(longest.carry)
        )
    });
    document.paragraph(format!(
        "Carry averaged over the attack angles 0, 1 … 10° is longest at {:.0}° by the report. \
         {whole}The exact best is {}, with {}.",
        average.printed.to_degrees(),
        units.degrees(average.best.loft),
        units.length(average.best.carry),
    ));
}

pub(super) fn regression(document: &mut Document, found: &Mae494, units: PaperUnits) {
    let fit = &found.regression;
    document.heading("The regression");
    document.paragraph(format!(
        "The listing fits 1, λ², λ³, λ⁴, λ⁵ to five distances at attack angle 10° and evaluates \
         the coefficients against 1, λ, λ², λ³, λ⁴. So its \
         maximum is at {}, the optimum that Table 1 prints there, where it predicts {}. The same \
         coefficients, evaluated as they were fitted, \
         have their maximum at {} ({}); the ordinary polynomial 1 … λ⁴ through the same points has \
         it at {} ({}). In the report's model a ball struck with loft \
         {} at attack angle 10° carries {}.",
        units.degrees(fit.with_wrong_powers.loft),
        units.length(fit.with_wrong_powers.distance),
        units.degrees(fit.as_fitted.loft),
        units.length(fit.as_fitted.distance),
        units.degrees(fit.ordinary.loft),
        units.length(fit.ordinary.distance),
        units.degrees(found.with_wrong_powers.loft),
        units.length(found.with_wrong_powers.carry),
    ));
}
