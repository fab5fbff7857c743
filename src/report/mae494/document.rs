use super::{degrees, metres, per_degree};
use crate::report::document::Document;
use crate::reproduce::{Mae494, Row};

/// The report, reproduced, as a document.
pub fn mae494_document(found: &Mae494) -> Document {
    let mut document = Document::new("The MAE 494 report, reproduced");
    optimum(&mut document, found);
    tables(&mut document, found);
    regression(&mut document, found);
    document
}

fn optimum(document: &mut Document, found: &Mae494) {
    let Row { printed, best, .. } = &found.optimum;
    let exact = found.optimum.exact();
    document.heading("The optimum");
    document.paragraph(format!(
        "Within loft 0–20° and attack angle −10…+10° the report's own model carries farthest at loft {}, attack angle {}: {}. {}. The \
         report recommends {} and {} and prints {}; in its model that delivery carries {}, {} less than the best.",
        degrees(exact.loft),
        degrees(exact.attack_angle),
        metres(exact.carry),
        held(&found.optimum),
        degrees(printed.loft),
        degrees(printed.attack_angle),
        metres(printed.carry),
        carried(&found.optimum),
        metres(found.optimum.cost()),
    ));
    document.paragraph(format!("The search {}: {}.", best.status(), best.message()));
}

fn tables(document: &mut Document, found: &Mae494) {
    let active = |rows: &[Row]| rows.iter().filter(|row| !row.active.is_empty()).count();
    document.heading("Its tables");
    document.paragraph(format!(
        "The report says that no constraint was active. In its model the bound of loft is active at {} of {} attack angles, and that of the \
         attack angle at {} of {} lofts.",
        active(&found.table1),
        found.table1.len(),
        active(&found.table2),
        found.table2.len(),
    ));
    let row = |row: &Row, given: f64, printed: f64, exact: f64| {
        vec![
            format!("{:.0}°", given.to_degrees()),
            degrees(printed),
            metres(row.printed.carry),
            carried(row),
            degrees(exact),
            metres(row.exact().carry),
            metres(row.cost()),
            held(row),
        ]
    };
    let head = |given: &'static str, best: &'static str, exact: &'static str| {
        [given, best, "distance printed", "carries in fact", exact, "carry", "cost", "what holds it"]
    };
    document.table(
        &head("attack angle", "loft printed", "exact best loft"),
        found.table1.iter().map(|r| row(r, r.printed.attack_angle, r.printed.loft, r.exact().loft)),
    );
    document.table(
        &head("loft", "attack angle printed", "exact best attack angle"),
        found.table2.iter().map(|r| row(r, r.printed.loft, r.printed.attack_angle, r.exact().attack_angle)),
    );
}

/// How far the printed optimum carries.
fn carried(row: &Row) -> String {
    row.at_printed.map_or("does not fly".into(), metres)
}

/// "club.loft at its upper bound, +0.52 m per degree beyond it".
fn held(row: &Row) -> String {
    let solution = &row.best.solution;
    let bounds = row.active.iter().filter_map(|active| {
        let i = row.best.search.vary.iter().position(|vary| vary.parameter.name == active.name)?;
        let price = solution.lower_multipliers[i] + solution.upper_multipliers[i];
        Some(format!("{active}, {} beyond it", per_degree(price)))
    });
    let bounds: Vec<_> = bounds.collect();
    if bounds.is_empty() { "free".into() } else { bounds.join(", ") }
}

fn regression(document: &mut Document, found: &Mae494) {
    let fit = &found.regression;
    document.heading("The regression");
    document.paragraph(format!(
        "The listing fits 1, λ², λ³, λ⁴, λ⁵ to five distances at attack angle 10° and evaluates the coefficients against 1, λ, λ², λ³, λ⁴. So it \
         peaks at {}, the optimum that Table 1 prints there. The same coefficients evaluated as they were fitted peak at {} ({}); the \
         ordinary polynomial 1 … λ⁴ through the same points at {} ({}).",
        degrees(fit.slipped.loft),
        degrees(fit.as_fitted.loft),
        metres(fit.as_fitted.distance),
        degrees(fit.ordinary.loft),
        metres(fit.ordinary.distance),
    ));
}
