use crate::report::json::number;
use crate::reproduce::{Delivery, Mae494, Peak, Row};
use serde_json::{Map, Value, json};

/// The report, reproduced, as JSON: SI and radians.
pub fn mae494_json(found: &Mae494) -> Value {
    let regression = &found.regression;
    let mut slipped = delivery(&found.slipped);
    slipped.insert(
        "regression".into(),
        json!({
            "slipped": peak(regression.slipped),
            "as_fitted": peak(regression.as_fitted),
            "ordinary": peak(regression.ordinary),
        }),
    );
    let mut optimum = delivery(&found.optimum.exact());
    optimum.extend(held(&found.optimum));
    let rows = |rows: &[Row]| rows.iter().map(row).collect::<Vec<_>>();
    let printed = |rows: &[Row]| rows.iter().map(|row| short(&row.printed)).collect::<Vec<_>>();
    json!({
        "slipped_optimum": slipped,
        "optimum": optimum,
        "table1": rows(&found.table1),
        "table2": rows(&found.table2),
        "printed": {
            "slipped_optimum": found.table1.last().map(|row| delivery(&row.printed)),
            "optimum": delivery(&found.optimum.printed),
            "table1": printed(&found.table1),
            "table2": printed(&found.table2),
        },
    })
}

/// A row of a table: the exact optimum, and what becomes of the printed one.
fn row(row: &Row) -> Value {
    let mut entries = short(&row.exact());
    entries.extend(held(row));
    entries.insert("carry_at_printed".into(), number(row.at_printed));
    entries.insert("cost".into(), number(Some(row.cost())));
    Value::Object(entries)
}

fn held(row: &Row) -> Map<String, Value> {
    let solution = &row.best.solution;
    let multipliers = row.best.search.vary.iter().enumerate().map(|(i, vary)| {
        let prices = json!({ "lower": solution.lower_multipliers[i], "upper": solution.upper_multipliers[i] });
        (vary.parameter.name.to_owned(), prices)
    });
    let active = row.active.iter().map(|active| (active.name.clone(), json!(active.end)));
    Map::from_iter([
        ("multipliers".to_owned(), Value::Object(multipliers.collect())),
        ("active".to_owned(), Value::Object(active.collect())),
    ])
}

/// A delivery under the names of the parameters.
fn delivery(delivery: &Delivery) -> Map<String, Value> {
    named(["club.loft", "swing.attack_angle", "carry"], delivery)
}

/// A delivery under the names of a table's columns.
fn short(delivery: &Delivery) -> Map<String, Value> {
    named(["loft", "attack_angle", "carry"], delivery)
}

fn named(names: [&str; 3], delivery: &Delivery) -> Map<String, Value> {
    let values = [delivery.loft, delivery.attack_angle, delivery.carry];
    crate::report::json::named(names.into_iter().zip(values.map(Some)))
}

fn peak(peak: Peak) -> Value {
    json!({ "loft": peak.loft, "distance": peak.distance })
}
