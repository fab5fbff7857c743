use crate::atmosphere::in_effect;
use crate::number::Vector;
use crate::parameters::{GOLFER, LAW, METHOD, SPEED_OF, Setup, TABLE};
use serde_json::{Map, Value, json};

/// A number, `null` for one that does not exist. JSON has no infinity: a flat face's radius is
/// `"inf"`, as setup files write it; a range without a lower end begins at `"-inf"`.
pub(super) fn number(value: Option<f64>) -> Value {
    match value {
        Some(f64::INFINITY) => json!("inf"),
        Some(f64::NEG_INFINITY) => json!("-inf"),
        Some(value) if value.is_finite() => json!(value + 0.0),
        _ => Value::Null,
    }
}

/// The components of a vector, up, right, downrange.
pub(super) fn vector(v: Vector<f64>) -> Value {
    Value::Array(
        v.to_array()
            .map(|component| number(Some(component)))
            .to_vec(),
    )
}

/// Names with their numbers, in order.
pub(super) fn named<'a>(
    pairs: impl IntoIterator<Item = (&'a str, Option<f64>)>,
) -> Map<String, Value> {
    pairs
        .into_iter()
        .map(|(name, value)| (name.to_owned(), number(value)))
        .collect()
}

/// Every parameter of a setup by its dotted name, as the drive has it, with the choices: hand,
/// point of the club speed, law, method.
pub(super) fn setup(setup: &Setup<f64>) -> Map<String, Value> {
    let setup = &in_effect(setup);
    let mut all = Map::new();
    all.insert(GOLFER.into(), json!(setup.golfer.name()));
    for parameter in setup.parameters() {
        if parameter.law.is_some() && !all.contains_key(LAW) {
            all.insert(LAW.into(), json!(setup.law.name()));
            all.extend(
                setup
                    .law
                    .table()
                    .map(|table| (TABLE.to_owned(), json!(table.file()))),
            );
        }
        all.insert(parameter.name.into(), number(setup.value(parameter)));
        if parameter.name == "swing.speed" {
            all.insert(SPEED_OF.into(), json!(setup.speed_of.name()));
        }
        if parameter.name == "flight.step" {
            all.insert(METHOD.into(), json!(setup.method.name()));
        }
    }
    all
}

/// The key of a range that a law was fitted to: `spin_ratio`, `spin`, `reynolds`, `speed`.
pub(super) fn range_key(name: &str) -> &str {
    match name {
        "spin ratio" => "spin_ratio",
        "Reynolds number" => "reynolds",
        "speed through the air" => "speed",
        other => other,
    }
}
