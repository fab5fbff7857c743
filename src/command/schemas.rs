//! The JSON schemas of docs/schema, from the types of the answers.
//!
//! `LONGDRIVE_WRITE_SCHEMAS=1 cargo test --features full schemas` writes the schemas. The answers
//! of `sweep` about parts need the feature `parquet`; without it `sweep.json` is not compared.

use super::fly::listen::MessageCounts;
use super::picture::PlotFile;
use super::report::ReportFiles;
use super::sweep::SweepSummary;
#[cfg(feature = "parquet")]
use super::sweep::parts::WrittenPart;
#[cfg(feature = "parquet")]
use crate::parts::Checked;
use crate::report::{Empty, Reply, Report};
use crate::study::Optimum;
use schemars::generate::{Contract, SchemaGenerator, SchemaSettings};
use schemars::transform::{RecursiveTransform, Transform};
use schemars::{JsonSchema, Schema, json_schema};
use serde_json::{Value, json};

const DIALECT: &str = "https://json-schema.org/draft/2020-12/schema";

/// The body of an answer in JSON.
pub trait Body: JsonSchema {
    /// The status words of answers with this body.
    fn statuses() -> Vec<&'static str>;
}

impl<T: Report + JsonSchema> Body for T {
    fn statuses() -> Vec<&'static str> {
        T::STATUSES.to_vec()
    }
}

/// Implements [`Body`] for types that are no [`Report`].
macro_rules! bodies {
    ($($(#[cfg($condition:meta)])? $Body:ty: $statuses:expr;)*) => {
        $(
            $(#[cfg($condition)])?
            impl Body for $Body {
                fn statuses() -> Vec<&'static str> {
                    $statuses.to_vec()
                }
            }
        )*
    };
}

bodies! {
    ReportFiles<'_>: [&Optimum::STATUSES[..], &["done", "aloft"]].concat();
    PlotFile<'_>: [&Optimum::STATUSES[..], &["done"]].concat();
    MessageCounts: ["done"];
    SweepSummary: ["done", "no-answer", "interrupted"];
    #[cfg(feature = "parquet")]
    WrittenPart: ["done"];
    #[cfg(feature = "parquet")]
    Checked: ["done", "partial"];
}

fn generator() -> SchemaGenerator {
    let settings = SchemaSettings::draft2020_12().with(|settings| {
        settings.contract = Contract::Serialize;
    });
    settings.into_generator()
}

/// The schema of a line of a command's `jsonl` file.
fn row<T: JsonSchema>(command: &str) -> Schema {
    let mut schema = generator().into_root_schema_for::<T>();
    let title = format!("A line of `longdrive {command} --format jsonl`");
    schema.insert("title".into(), title.into());
    plain(schema)
}

/// The schemas of a command's answers: answers with a result, in one of several shapes, and answers
/// without a result.
pub struct Answers {
    pub command: String,
    generator: SchemaGenerator,
    /// The answers with a result, by the name of the type.
    results: Vec<(String, Schema)>,
}

impl Answers {
    /// The answers of the command whose module has this name.
    pub fn new(module: &str) -> Self {
        Self {
            command: module.replace('_', "-"),
            generator: generator(),
            results: vec![],
        }
    }

    /// Adds an answer with this body.
    pub fn or<T: Body>(mut self) -> Self {
        let mut answer = Reply::<T>::json_schema(&mut self.generator);
        let keys = properties(&mut answer);
        keys["command"] = json!({ "description": "The command.", "const": self.command });
        keys["from"]["type"] = json!("string");
        keys["status"]["enum"] = json!(T::statuses());
        if let Some(of) = T::json_schema(&mut self.generator).get("description") {
            answer.insert("description".into(), of.clone());
        }
        self.results.push((T::schema_name().into(), answer));
        self
    }

    /// Adds the key `left_out`: the parameters that `--wrt all` omits.
    fn with_left_out(mut self) -> Self {
        for (_, answer) in &mut self.results {
            properties(answer)["left_out"] = json!({
                "description": "Parameters that `all` leaves out, with the reason. The key is \
                    omitted if there are none.",
                "type": "array",
                "items": { "type": "string" }
            });
        }
        self
    }

    /// The schema; `None` for a command without answers in JSON.
    fn schema(mut self) -> Option<Schema> {
        if self.results.is_empty() {
            return None;
        }
        let mut none = Reply::<Empty>::json_schema(&mut self.generator);
        none.insert(
            "description".into(),
            "An answer without a result: the message says why, and what to do.".into(),
        );
        let keys = properties(&mut none);
        keys["command"]["enum"] = json!([self.command, null]);
        keys["message"] = json!({ "description": "The reason.", "type": "string" });
        keys["status"]["enum"] = json!(Reply::<Empty>::statuses());
        keys.as_object_mut().unwrap().remove("from");

        let mut definitions = serde_json::Map::new();
        let answers = self.results.into_iter();
        for (name, answer) in answers.chain([("NoAnswer".into(), none)]) {
            definitions.insert(name, answer.into());
        }
        let shapes: Vec<_> = definitions
            .keys()
            .map(|name| json!({ "$ref": format!("#/$defs/{name}") }))
            .collect();
        for (name, definition) in self.generator.take_definitions(true) {
            let before = definitions.insert(name.clone(), definition);
            assert!(before.is_none(), "two types are named {name}");
        }
        Some(plain(json_schema!({
            "$schema": DIALECT,
            "title": format!("The answer of `longdrive {} --json`", self.command),
            "description": "Numbers are in SI units and radians.",
            "anyOf": shapes,
            "$defs": definitions
        })))
    }
}

fn properties(schema: &mut Schema) -> &mut Value {
    schema.get_mut("properties").unwrap()
}

/// The schema without additional properties of objects, and without names of Rust's number types. A
/// description is the first paragraph of a doc comment.
fn plain(mut schema: Schema) -> Schema {
    RecursiveTransform(|schema: &mut Schema| {
        schema.remove("format");
        if schema.get("properties").is_some() && schema.get("additionalProperties").is_none() {
            schema.insert("additionalProperties".into(), false.into());
        }
        if let Some(Value::String(text)) = schema.get_mut("description") {
            let first = text.split("\n\n").next().unwrap();
            *text = first.replace('\n', " ");
        }
    })
    .transform(&mut schema);
    schema
}

#[cfg(test)]
mod tests {
    use super::{Answers, row};
    use crate::command::mention::commands_with;
    use crate::command::{answers, program};
    use crate::report::{FlyRow, SweepRow};
    use schemars::Schema;
    use serde_json::Value;
    use std::collections::BTreeMap;
    use std::path::Path;

    /// The schema of each command's answer and of the rows of files, by file name.
    fn schemas() -> BTreeMap<String, Schema> {
        // answers of commands with `--wrt` name the parameters that `--wrt all` leaves out
        let with_all = commands_with(program(), "wrt");
        let schema = |answers: Answers| {
            let name = answers.command.clone();
            let has_all = with_all
                .iter()
                .any(|other| other.split(' ').next() == Some(&name));
            let answers = if has_all {
                answers.with_left_out()
            } else {
                answers
            };
            Some((name, answers.schema()?))
        };
        let mut schemas: BTreeMap<_, _> = answers().into_iter().filter_map(schema).collect();
        schemas.insert("fly-row".into(), row::<FlyRow>("fly"));
        schemas.insert("sweep-row".into(), row::<SweepRow>("sweep"));
        schemas
    }

    #[test]
    fn the_schemas_of_docs_are_those_of_the_types() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/schema");
        let schemas = schemas();
        let is_complete = cfg!(feature = "parquet");
        if is_complete && std::env::var_os("LONGDRIVE_WRITE_SCHEMAS").is_some() {
            std::fs::remove_dir_all(&folder).unwrap();
            std::fs::create_dir(&folder).unwrap();
            for (name, schema) in &schemas {
                let text = serde_json::to_string_pretty(schema).unwrap() + "\n";
                std::fs::write(folder.join(name).with_extension("json"), text).unwrap();
            }
        }
        let mut files: Vec<_> = std::fs::read_dir(&folder)
            .unwrap()
            .map(|entry| entry.unwrap().path())
            .collect();
        files.sort();
        let written: BTreeMap<_, Value> = files
            .iter()
            .map(|file| {
                let name = file.file_stem().unwrap().to_str().unwrap().to_owned();
                let text = std::fs::read_to_string(file).unwrap();
                (name, serde_json::from_str(&text).unwrap())
            })
            .collect();
        let names: Vec<_> = schemas.keys().cloned().collect();
        assert_eq!(
            written.keys().cloned().collect::<Vec<_>>(),
            names,
            "docs/schema is out of date; `LONGDRIVE_WRITE_SCHEMAS=1 cargo test --features full schemas` \
             writes it again"
        );
        for (name, schema) in schemas {
            if name == "sweep" && !is_complete {
                continue;
            }
            assert!(
                written[&name] == *schema.as_value(),
                "docs/schema/{name}.json differs from the types of the answer; \
                 `LONGDRIVE_WRITE_SCHEMAS=1 cargo test --features full schemas` writes it"
            );
        }
    }
}
