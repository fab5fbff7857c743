//! Checks answers against the schemas of docs/schema.

use jsonschema::{Registry, Validator};
use serde_json::Value;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// Every schema except the common one, by its command.
static SCHEMAS: LazyLock<BTreeMap<String, Validator>> = LazyLock::new(|| {
    let folder = format!("{}/../docs/schema", env!("CARGO_MANIFEST_DIR"));
    let read = |name: &str| -> Value {
        serde_json::from_str(&std::fs::read_to_string(format!("{folder}/{name}")).unwrap()).unwrap()
    };
    let registry = Registry::new()
        .add("json-schema:///common.json", read("common.json"))
        .unwrap()
        .prepare()
        .unwrap();
    let names = std::fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap());
    names
        .filter(|name| name != "common.json")
        .map(|name| {
            let schema = read(&name);
            jsonschema::draft202012::meta::validate(&schema)
                .unwrap_or_else(|error| panic!("{name}: {error}"));
            let validator = jsonschema::options()
                .with_registry(&registry)
                .build(&schema);
            (
                name.trim_end_matches(".json").to_owned(),
                validator.unwrap_or_else(|error| panic!("{name}: {error}")),
            )
        })
        .collect()
});

/// Violations of the command's schema in an answer.
pub fn faults(command: &str, answer: &Value) -> Vec<String> {
    let Some(schema) = SCHEMAS.get(command) else {
        return vec![format!("{command} has no schema")];
    };
    let faults = schema.iter_errors(answer);
    faults
        .map(|fault| format!("{command}{}: {fault}", fault.instance_path()))
        .collect()
}
