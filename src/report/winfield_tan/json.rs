use crate::report::Reply;
use crate::reproduce::{Best, Point, SingleShot, WinfieldTan};
use serde_json::{Value, json};

/// The paper, reproduced, as JSON: SI and radians.
pub fn winfield_tan_reply(found: &WinfieldTan) -> Reply<Value> {
    let side = |of: fn(&Best) -> Point, shot: &SingleShot, average: (f64, f64)| {
        let optimum = of(&found.optimum);
        let row = |best: &Best| {
            let Point {
                loft,
                attack_angle,
                carry,
            } = of(best);
            json!({ "club.loft": loft, "swing.attack_angle": attack_angle, "carry": carry })
        };
        json!({
            "shot": {
                "carry": shot.carry,
                "flight_time": shot.flight_time,
                "apex_height": shot.apex_height,
                "apex_time": shot.apex_time,
            },
            "optimum": { "club.loft": optimum.loft, "swing.attack_angle": optimum.attack_angle, "carry": optimum.carry },
            "table1": found.table1.iter().map(row).collect::<Vec<_>>(),
            "table2": found.table2.iter().map(row).collect::<Vec<_>>(),
            "average": { "club.loft": average.0, "carry": average.1 },
        })
    };
    let mut answer = side(
        |best| best.computed,
        &found.shot.computed,
        found.average.best,
    );
    answer["printed"] = side(
        |best| best.printed,
        &found.shot.printed,
        found.average.printed,
    );
    let (rate, error) = found.fitted.decay;
    answer["aero.spin_decay"] = json!({ "value": rate, "standard_uncertainty": error });
    answer["study"] = "winfield-tan".into();
    Reply::done("reproduce", vec![], answer)
}
