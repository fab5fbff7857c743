use crate::reproduce::{Best, Point, SingleShot, WinfieldTan};
use serde_json::{Value, json};

/// The paper, reproduced, as JSON: SI and radians.
pub fn winfield_tan_json(found: &WinfieldTan) -> Value {
    let side = |of: fn(&Best) -> Point, shot: &SingleShot, average: (f64, f64)| {
        let optimum = of(&found.optimum);
        let loft_first = |best: &Best| {
            let Point { loft, attack_angle, carry } = of(best);
            json!({ "loft": loft, "attack_angle": attack_angle, "carry": carry })
        };
        let attack_first = |best: &Best| {
            let Point { loft, attack_angle, carry } = of(best);
            json!({ "attack_angle": attack_angle, "loft": loft, "carry": carry })
        };
        json!({
            "shot": {
                "carry": shot.carry,
                "flight_time": shot.flight_time,
                "apex_height": shot.apex_height,
                "apex_time": shot.apex_time,
            },
            "optimum": { "club.loft": optimum.loft, "swing.attack_angle": optimum.attack_angle, "carry": optimum.carry },
            "table1": found.table1.iter().map(loft_first).collect::<Vec<_>>(),
            "table2": found.table2.iter().map(attack_first).collect::<Vec<_>>(),
            "average": { "loft": average.0, "carry": average.1 },
        })
    };
    let mut answer = side(|best| best.computed, &found.shot.computed, found.average.best);
    answer["printed"] = side(|best| best.printed, &found.shot.printed, found.average.printed);
    let (rate, error) = found.fitted.decay;
    answer["spin_decay"] = json!({ "value": rate, "standard_error": error });
    answer
}
