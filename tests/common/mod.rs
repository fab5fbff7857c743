//! Drives computed independently of this project, and how to hold ours against them.

use longdrive::Setup;
use serde_json::{Map, Value};

/// A file of `tests/data`.
pub fn data(name: &str) -> Value {
    let path = format!("{}/tests/data/{name}", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// A setup from its JSON form: every parameter by dotted name, `null` for unset, `"inf"` for a flat face.
/// What the file does not name is as in Winfield & Tan: rolling at exit, calm, no friction limit.
pub fn setup(json: &Map<String, Value>) -> Setup<f64> {
    let mut setup = Setup::preset("winfield-tan").unwrap();
    setup.set_law(json["aero.law"].as_str().unwrap()).unwrap();
    for (name, value) in json.iter().filter(|(name, _)| *name != "aero.law") {
        let parameter = setup.parameter(name).unwrap();
        let value = match value {
            Value::Null => None,
            Value::String(text) => Some(text.parse().unwrap()),
            number => number.as_f64(),
        };
        setup.set_value(parameter, value).unwrap();
    }
    setup.validate().unwrap();
    setup
}

/// Asserts |ours − theirs| ≤ tolerance · scale.
#[track_caller]
pub fn close(ours: f64, theirs: f64, scale: f64, tolerance: f64, what: &str) {
    let error = (ours - theirs).abs();
    assert!(error <= tolerance * scale, "{what}: {ours:e} against {theirs:e}, off by {:e} of {scale:e}", error / scale);
}
