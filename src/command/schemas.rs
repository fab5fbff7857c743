//! The JSON schemas of docs/schema, from the types of the answers.
//!
//! `LONGDRIVE_WRITE_SCHEMAS=1 cargo test --features full schemas` writes them. The answers of
//! `sweep` about parts need the feature `parquet`; without it `sweep.json` is not compared.

use super::fly::listen::MessageCounts;
use super::picture::PlotFile;
use super::report::ReportFiles;
#[cfg(feature = "parquet")]
use super::sweep::{
    SweepSummary,
    parts::{CheckedParts, WrittenPart},
};
use crate::report::{
    CalibrationReport, CertificateReport, ChartReport, ComparisonReport, DeliveryReport,
    DriveReport, EffectsReport, Empty, FlyRow, GradientReport, LawsReport, Mae494Report,
    OptimumReport, ParametersReport, ParetoReport, PresetsReport, Reply, Report, RobustReport,
    SensitivityReport, ShotsReport, SweepRow, UncertaintyReport, ValidationReport,
    WinfieldTanReport,
};
use crate::study::Optimum;
use schemars::generate::{Contract, SchemaGenerator, SchemaSettings};
use schemars::transform::{RecursiveTransform, Transform};
use schemars::{JsonSchema, Schema, json_schema};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::Path;

const DIALECT: &str = "https://json-schema.org/draft/2020-12/schema";

/// Commands whose answer names the parameters that `all` leaves out.
const WITH_ALL: [&str; 5] = ["gradient", "optimum-sensitivity", "plot", "sweep", "verify"];

/// The schema of each command's answer and of the rows of files, by file name.
fn schemas() -> BTreeMap<&'static str, Schema> {
    let search = Optimum::statuses();
    let of_search = |more: &[&'static str]| [&search[..], more].concat();
    let found = of_search(&[]);
    let analysed = of_search(&["no-answer", "undefined"]);
    let mut schemas: BTreeMap<_, _> = [
        Answers::of::<CalibrationReport<'_>>(),
        Answers::of::<ChartReport<'_>>(),
        Answers::of::<ComparisonReport<'_>>(),
        Answers::of::<DeliveryReport<'_>>(),
        Answers::new("design").or::<OptimumReport>(&found),
        Answers::of::<ShotsReport<'_>>().or::<MessageCounts>(&["done"]),
        Answers::of::<GradientReport<'_>>(),
        Answers::of::<LawsReport>(),
        Answers::new("optimize").or::<OptimumReport>(&found),
        Answers::new("optimum-sensitivity").or::<SensitivityReport>(&analysed),
        Answers::of::<ParametersReport>(),
        Answers::of::<ParetoReport<'_>>(),
        Answers::new("plot").or::<PlotFile<'_>>(&["done"]),
        Answers::of::<PresetsReport>(),
        Answers::new("report").or::<ReportFiles<'_>>(&of_search(&["done", "aloft"])),
        Answers::of::<Mae494Report<'_>>().or::<WinfieldTanReport<'_>>(&["done"]),
        Answers::of::<RobustReport<'_>>(),
        Answers::of::<EffectsReport<'_>>(),
        Answers::of::<DriveReport<'_>>(),
        #[cfg(feature = "parquet")]
        Answers::new("sweep")
            .or::<SweepSummary>(&["done", "no-answer", "interrupted"])
            .or::<WrittenPart>(&["done"])
            .or::<CheckedParts>(&["done", "partial"]),
        Answers::of::<UncertaintyReport<'_>>(),
        Answers::of::<ValidationReport<'_>>(),
        Answers::of::<CertificateReport<'_>>(),
    ]
    .map(|answers| (answers.command, answers.schema()))
    .into();
    schemas.insert("fly-row", row::<FlyRow>("fly"));
    schemas.insert("sweep-row", row::<SweepRow>("sweep"));
    schemas
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

/// The answers of a command: with a result, in one of several shapes, or without.
struct Answers {
    command: &'static str,
    generator: SchemaGenerator,
    /// The answers with a result, by the name of the type.
    results: Vec<(String, Schema)>,
}

impl Answers {
    fn new(command: &'static str) -> Self {
        Self {
            command,
            generator: generator(),
            results: vec![],
        }
    }

    fn of<T: Report + JsonSchema>() -> Self {
        Self::new(T::COMMAND).or::<T>(&T::statuses())
    }

    /// Adds an answer with this body and these statuses.
    fn or<T: JsonSchema>(mut self, statuses: &[&str]) -> Self {
        let mut answer = Reply::<T>::json_schema(&mut self.generator);
        let keys = properties(&mut answer);
        keys["command"] = json!({ "description": "The command.", "const": self.command });
        keys["from"]["type"] = json!("string");
        keys["status"]["enum"] = json!(statuses);
        if WITH_ALL.contains(&self.command) {
            keys["left_out"] = json!({
                "description": "Parameters of `all` that are omitted, with the reason; omitted if \
                    there are none.",
                "type": "array",
                "items": { "type": "string" }
            });
        }
        if let Some(of) = T::json_schema(&mut self.generator).get("description") {
            answer.insert("description".into(), of.clone());
        }
        self.results.push((T::schema_name().into(), answer));
        self
    }

    fn schema(mut self) -> Schema {
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
        plain(json_schema!({
            "$schema": DIALECT,
            "title": format!("The answer of `longdrive {} --json`", self.command),
            "description": "Numbers are in SI units and radians.",
            "anyOf": shapes,
            "$defs": definitions
        }))
    }
}

fn properties(schema: &mut Schema) -> &mut Value {
    schema.get_mut("properties").unwrap()
}

/// The schema with closed objects, without names of Rust's number types, and with the first
/// paragraph of each doc comment as the description.
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
            let name = file.file_stem().unwrap().to_str().unwrap();
            let text = std::fs::read_to_string(file).unwrap();
            (name, serde_json::from_str(&text).unwrap())
        })
        .collect();
    let names: Vec<_> = schemas.keys().copied().collect();
    if is_complete {
        assert_eq!(written.keys().copied().collect::<Vec<_>>(), names);
    }
    for (name, schema) in schemas {
        assert!(
            written[name] == *schema.as_value(),
            "docs/schema/{name}.json differs from the types of the answer; \
             `LONGDRIVE_WRITE_SCHEMAS=1 cargo test --features full schemas` writes it"
        );
    }
}
