use crate::report::Reply;
use crate::report::json::{named, number};
use crate::reproduce::{
    Average, Delivery, Energy, Launched, Mae494, Noise, Parametric, Peak, Regression, Row,
    Searches, Subsystems,
};
use serde_json::{Map, Value, json};

/// The report, reproduced, as JSON: SI and radians.
pub fn mae494_reply(found: &Mae494) -> Reply<Value> {
    let mut optimum = delivery(&found.optimum.exact());
    optimum.extend(held(&found.optimum));
    let rows = |rows: &[Row]| rows.iter().map(row).collect::<Vec<_>>();
    let printed = |rows: &[Row]| {
        rows.iter()
            .map(|row| delivery(&row.printed))
            .collect::<Vec<_>>()
    };
    let body = json!({
        "study": "mae494",
        "slipped_optimum": delivery(&found.slipped),
        "optimum": optimum,
        "table1": rows(&found.table1),
        "table2": rows(&found.table2),
        "average": average(&found.average),
        "regression": regression(&found.regression),
        "energy": energy(&found.energy),
        "subsystems": subsystems(&found.subsystems),
        "parametric": parametric(&found.parametric),
        "noise": noise(&found.noise, &found.searches),
        "printed": {
            "slipped_optimum": found.table1.last().map(|row| delivery(&row.printed)),
            "optimum": delivery(&found.optimum.printed),
            "table1": printed(&found.table1),
            "table2": printed(&found.table2),
            "average": { "club.loft": found.average.printed },
        },
    });
    Reply::done("reproduce", vec![], body)
}

/// A row of a table: the exact optimum, and what becomes of the printed one.
fn row(row: &Row) -> Value {
    let mut entries = delivery(&row.exact());
    entries.extend(held(row));
    entries.insert("carry_at_printed".into(), number(row.at_printed));
    entries.insert("cost".into(), number(Some(row.cost())));
    Value::Object(entries)
}

/// What holds an optimum, at what price.
fn held(row: &Row) -> Map<String, Value> {
    let solution = &row.best.solution;
    let multipliers = row.best.search.vary.iter().enumerate().map(|(i, vary)| {
        let prices = json!({ "lower": solution.lower_multipliers[i], "upper": solution.upper_multipliers[i] });
        (vary.parameter.name.to_owned(), prices)
    });
    let active = row
        .active
        .iter()
        .map(|active| (active.name.clone(), json!(active.end)));
    Map::from_iter([
        (
            "multipliers".to_owned(),
            Value::Object(multipliers.collect()),
        ),
        ("active".to_owned(), Value::Object(active.collect())),
    ])
}

/// A delivery under the names of the parameters.
fn delivery(delivery: &Delivery) -> Map<String, Value> {
    let Delivery {
        loft,
        attack_angle,
        carry,
    } = *delivery;
    named([
        ("club.loft", Some(loft)),
        ("swing.attack_angle", Some(attack_angle)),
        ("carry", Some(carry)),
    ])
}

fn average(average: &Average) -> Value {
    let rows = average
        .rows
        .iter()
        .map(|(loft, carry)| json!({ "club.loft": loft, "carry": carry }));
    json!({ "club.loft": average.best.0, "carry": average.best.1, "rows": rows.collect::<Vec<_>>() })
}

fn regression(regression: &Regression) -> Value {
    let peak = |peak: Peak| json!({ "club.loft": peak.loft, "distance": peak.distance });
    json!({
        "slipped": peak(regression.slipped),
        "as_fitted": peak(regression.as_fitted),
        "ordinary": peak(regression.ordinary),
    })
}

fn launched(launched: &Launched) -> Value {
    json!({
        "ball_speed": launched.speed,
        "launch_angle": launched.angle,
        "backspin": launched.spin,
        "carry": launched.carry,
    })
}

fn energy(energy: &Energy) -> Value {
    json!({
        "fastest_ball_speed": energy.fastest,
        "farthest": launched(&energy.farthest),
        "carry_per_ball_speed": energy.price_of_speed,
        "needed": launched(&energy.needed),
        "club_energy": energy.club,
        "ball_energy": energy.ball,
        "ball_energy_needed": energy.ball_needed,
    })
}

fn subsystems(subsystems: &Subsystems) -> Value {
    let by_quantity = |parts: &[f64; 3]| {
        named(
            ["ball_speed", "launch_angle", "backspin"]
                .into_iter()
                .zip(parts.map(Some)),
        )
    };
    json!({
        "whole": launched(&subsystems.whole),
        "flight": launched(&subsystems.flight),
        "impact": delivery(&subsystems.impact),
        "carry_by": by_quantity(&subsystems.slopes),
        "carry_by_loft_through": by_quantity(&subsystems.by_loft),
        "carry_by_attack_angle_through": by_quantity(&subsystems.by_attack_angle),
    })
}

fn parametric(study: &Parametric) -> Value {
    let constants = study.sensitivities.iter().map(|constant| {
        let sensitivity = &constant.sensitivity;
        json!({
            "parameter": sensitivity.parameter.name,
            "at": constant.value,
            "value": sensitivity.value,
            "optimum": { "club.loft": sensitivity.optimum[0], "swing.attack_angle": sensitivity.optimum[1] },
        })
    });
    let changes = study.changes.iter().map(|changed| {
        json!({
            "parameter": changed.change.parameter.name,
            "change": changed.change.delta,
            "predicted": { "value": changed.second_order, "optimum": { "club.loft": changed.predicted[0] } },
            "resolved": {
                "value": number(changed.resolved.value()),
                "optimum": { "club.loft": changed.resolved.solution.x[0] },
            },
        })
    });
    json!({ "sensitivity": constants.collect::<Vec<_>>(), "changes": changes.collect::<Vec<_>>() })
}

fn noise(noise: &Noise, searches: &[Searches]) -> Value {
    let zoom = noise.zoom.iter().map(
        |at| json!({ "club.loft": at.loft, "loop": at.overshot, "interpolated": at.interpolated, "smooth": at.smooth }),
    );
    let slopes = noise.slopes.iter().map(|at| {
        json!({
            "club.loft": at.loft,
            "exact": at.exact,
            "at_fixed_time": at.at_fixed_time,
            "loop": at.overshot,
            "interpolated": at.interpolated,
            "sign_is_wrong": at.overshot * at.exact < 0.0,
        })
    });
    let shorter = noise
        .shorter_steps
        .iter()
        .map(|(step, slope)| json!({ "step": step, "loop": slope }));
    let longer = noise.longer_differences.iter().map(|(difference, [overshot, interpolated, smooth])| {
        json!({ "difference": difference, "loop": overshot, "interpolated": interpolated, "smooth": smooth })
    });
    let kinds = searches.iter().map(|searches| {
        let ends = searches.ends.iter().map(|end| {
            json!({
                "start": delivery(&end.start),
                "end": delivery(&end.at),
                "flights": end.flights,
                "message": end.message,
            })
        });
        json!({
            "landing": searches.landing.name(),
            "method": searches.method.name(),
            "ends": ends.collect::<Vec<_>>(),
        })
    });
    json!({
        "swing.attack_angle": 0.0,
        "step": noise.step,
        "difference": noise.difference,
        "teeth": { "count": noise.teeth.count, "width": noise.teeth.width, "height": noise.teeth.height },
        "slopes": slopes.collect::<Vec<_>>(),
        "wrong_signs": noise.wrong_signs(),
        "shorter_steps": shorter.collect::<Vec<_>>(),
        "longer_differences": longer.collect::<Vec<_>>(),
        "zoom": zoom.collect::<Vec<_>>(),
        "searches": kinds.collect::<Vec<_>>(),
    })
}
