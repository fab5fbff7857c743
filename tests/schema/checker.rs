use jsonschema::error::ValidationErrorKind;
use jsonschema::{ValidationError, Validator};
use serde_json::Value;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// The schemas of docs/schema, by file name.
static SCHEMAS: LazyLock<BTreeMap<String, Validator>> = LazyLock::new(|| {
    let folder = format!("{}/../docs/schema", env!("CARGO_MANIFEST_DIR"));
    let files = std::fs::read_dir(folder).unwrap();
    files
        .map(|file| {
            let file = file.unwrap().path();
            let name = file.file_stem().unwrap().to_str().unwrap().to_owned();
            let schema = serde_json::from_str(&std::fs::read_to_string(&file).unwrap()).unwrap();
            jsonschema::draft202012::meta::validate(&schema)
                .unwrap_or_else(|error| panic!("{name}: {error}"));
            let validator = jsonschema::draft202012::new(&schema);
            let validator = validator.unwrap_or_else(|error| panic!("{name}: {error}"));
            (name, validator)
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
        .flat_map(|fault| causes(&fault))
        .map(|cause| format!("{command}{cause}"))
        .collect()
}

/// Place and text of a violation. If an object matches none of several alternatives of a schema,
/// these are the violations of the alternative with the fewest violations at the object itself.
fn causes(fault: &ValidationError<'_>) -> Vec<String> {
    let place = fault.instance_path();
    let wrong_keys = |shape: &&Vec<ValidationError<'_>>| {
        let here = shape.iter().filter(|cause| cause.instance_path() == place);
        here.count()
    };
    match fault.kind() {
        ValidationErrorKind::AnyOf { context } => {
            let nearest = context.iter().min_by_key(wrong_keys).unwrap();
            assert!(!nearest.is_empty(), "{fault}");
            nearest.iter().flat_map(causes).collect()
        }
        _ => vec![format!("{place}: {fault}")],
    }
}
