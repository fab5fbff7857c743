//! Files in memory: inputs that a host gives to a command, and outputs that it keeps.

use longdrive::command::{ArgumentValue, Call, Host, MemoryFiles, MessageKind, call, run};
use serde_json::Value as Json;
use std::collections::HashMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

const SHOTS: &str = "ball_speed [mph],launch_angle [deg],spin [rpm],carry [yd]\n\
                     165,11.2,2500,275\n168.1,10.4,2380,281\n162,11.5,2450,270.5\n";

/// A host without a disk.
#[derive(Default)]
struct InMemory {
    inputs: MemoryFiles,
    outputs: Mutex<HashMap<PathBuf, Vec<u8>>>,
    answer: Mutex<String>,
    rows: Mutex<Vec<u8>>,
}

impl InMemory {
    fn new(inputs: &[(&str, &[u8])], outputs: &[&str]) -> Arc<Self> {
        let inputs = inputs
            .iter()
            .map(|(name, content)| (name.into(), Arc::from(*content)));
        let outputs = outputs.iter().map(|name| (name.into(), vec![]));
        Arc::new(Self {
            inputs: inputs.collect(),
            outputs: Mutex::new(outputs.collect()),
            ..Self::default()
        })
    }

    fn answer(&self) -> Json {
        serde_json::from_str(&self.answer.lock().unwrap()).unwrap()
    }
}

impl Host for InMemory {
    fn print(&self, text: &str) -> io::Result<()> {
        self.answer.lock().unwrap().push_str(text);
        Ok(())
    }

    fn write(&self, rows: &[u8]) -> io::Result<()> {
        self.rows.lock().unwrap().extend(rows);
        Ok(())
    }

    fn say(&self, _: MessageKind, _: &str) {}

    fn files(&self) -> MemoryFiles {
        self.inputs.clone()
    }

    fn keeps(&self, name: &Path) -> bool {
        self.outputs.lock().unwrap().contains_key(name)
    }

    fn keep(&self, name: &Path, content: Vec<u8>) {
        self.outputs.lock().unwrap().insert(name.into(), content);
    }
}

fn text(text: &str) -> ArgumentValue {
    ArgumentValue::Text(text.into())
}

fn ask(command: &str, arguments: &[(&str, ArgumentValue)], host: &Arc<InMemory>) -> Json {
    let arguments = arguments
        .iter()
        .map(|(name, value)| ((*name).to_owned(), value.clone()));
    let call_of = Call {
        command: command.into(),
        arguments: arguments
            .chain([("json".to_owned(), ArgumentValue::Switch(true))])
            .collect(),
    };
    call(&call_of, host.clone());
    host.answer()
}

/// An answer to an unknown command has `null` as its `command`.
#[test]
fn exact_command_of_an_answer_to_an_unknown_request() {
    let host = InMemory::new(&[], &[]);
    let answer = ask("simulation", &[], &host);
    assert_eq!(
        (&answer["command"], &answer["status"]),
        (&Json::Null, &"error".into())
    );
}

#[test]
fn same_fit_of_shots_in_memory_and_on_disk() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("shots.csv");
    std::fs::write(&file, SHOTS).unwrap();
    let fit = |data: &str, host: &Arc<InMemory>| {
        let arguments = [
            ("data", text(data)),
            ("setup", text("mine.toml")),
            ("fit", text("aero.cd0")),
        ];
        ask("calibrate", &arguments, host)["estimates"].clone()
    };
    let setup: &[u8] = b"preset = 'modern-driver'\n[club]\nloft = '10 deg'\n";
    let in_memory = InMemory::new(&[("shots", SHOTS.as_bytes()), ("mine.toml", setup)], &[]);
    let on_disk = InMemory::new(&[("mine.toml", setup)], &[]);
    let found = fit("shots", &in_memory);
    assert!(found["aero.cd0"]["value"].is_f64());
    assert_eq!(found, fit(file.to_str().unwrap(), &on_disk));
}

#[test]
fn same_folder_in_memory_and_on_disk() {
    let folder = tempfile::tempdir().unwrap();
    let on_disk = folder.path().join("manual-pages");
    let host = InMemory::new(&[], &["manual-pages"]);
    for output in [Path::new("manual-pages"), &on_disk] {
        let words = ["longdrive", "man", "-o", output.to_str().unwrap()];
        assert_eq!(run(words.map(Into::into).to_vec(), host.clone()), 0);
    }
    let mut kept = host.outputs.lock().unwrap();
    kept.remove(Path::new("manual-pages"));
    assert_eq!(kept.len(), std::fs::read_dir(&on_disk).unwrap().count());
    for (name, content) in kept.iter() {
        let page = folder.path().join(name);
        assert_eq!(&std::fs::read(page).unwrap(), content, "{}", name.display());
    }
    assert!(!Path::new("manual-pages").exists());
}

#[test]
fn same_rows_for_a_host_and_in_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("rows.csv");
    let host = InMemory::new(&[("shots", SHOTS.as_bytes())], &[]);
    for output in ["-", file.to_str().unwrap()] {
        let words = ["longdrive", "fly", "shots", "-o", output];
        assert_eq!(run(words.map(Into::into).to_vec(), host.clone()), 0);
    }
    let rows = host.rows.lock().unwrap();
    assert_eq!(*rows, std::fs::read(file).unwrap());
    assert_eq!(String::from_utf8_lossy(&rows).lines().count(), 4);
}

#[cfg(feature = "full")]
fn parquet_of(name: &str, values: &[f64]) -> Vec<u8> {
    use parquet::data_type::DoubleType;
    use parquet::file::writer::SerializedFileWriter;
    use parquet::schema::parser::parse_message_type;
    let schema = format!("message points {{ required double {name}; }}");
    let schema = Arc::new(parse_message_type(&schema).unwrap());
    let mut bytes = vec![];
    let mut writer = SerializedFileWriter::new(&mut bytes, schema, Arc::default()).unwrap();
    let mut group = writer.next_row_group().unwrap();
    let mut column = group.next_column().unwrap().unwrap();
    let typed = column.typed::<DoubleType>();
    typed.write_batch(values, None, None).unwrap();
    column.close().unwrap();
    group.close().unwrap();
    writer.close().unwrap();
    bytes
}

#[cfg(feature = "full")]
#[test]
fn same_sweep_of_parquet_in_memory_and_on_disk() {
    let folder = tempfile::tempdir().unwrap();
    let points = folder.path().join("points.parquet");
    let content = parquet_of("club.loft", &[0.15, 0.16, 0.17]);
    std::fs::write(&points, &content).unwrap();
    let sweep = |points: &str, rows: &str, host: &Arc<InMemory>| {
        let rows = folder.path().join(rows);
        let output = text(rows.to_str().unwrap());
        let answer = ask(
            "sweep",
            &[("points", text(points)), ("output", output)],
            host,
        );
        assert_eq!(answer["status"], "done", "{answer}");
        std::fs::read_to_string(rows).unwrap()
    };
    let in_memory = InMemory::new(&[("mine.parquet", &content)], &[]);
    let rows = sweep("mine.parquet", "memory.csv", &in_memory);
    assert_eq!(rows.lines().count(), 4);
    let on_disk = sweep(
        points.to_str().unwrap(),
        "disk.csv",
        &InMemory::new(&[], &[]),
    );
    assert_eq!(rows, on_disk);
}

#[test]
fn an_output_in_memory_is_no_file_on_disk() {
    let host = InMemory::new(&[], &["drive.svg"]);
    let answer = ask("plot trajectory", &[("output", text("drive.svg"))], &host);
    let outputs = host.outputs.lock().unwrap();
    let picture = &outputs[Path::new("drive.svg")];
    assert!(picture.starts_with(b"<svg"));
    assert_eq!(answer["bytes"], picture.len());
    assert!(!Path::new("drive.svg").exists());
}

#[test]
fn rows_of_shots_are_kept_in_memory() {
    let host = InMemory::new(&[("shots", SHOTS.as_bytes())], &["rows.jsonl"]);
    let arguments = [("shots", text("shots")), ("output", text("rows.jsonl"))];
    let answer = ask("fly", &arguments, &host);
    let outputs = host.outputs.lock().unwrap();
    let rows = std::str::from_utf8(&outputs[Path::new("rows.jsonl")]).unwrap();
    assert_eq!(rows.lines().count(), 3);
    assert_eq!(
        (answer["rows"].as_u64(), &answer["file"]),
        (Some(3), &Json::Null)
    );
}

#[test]
fn an_angle_without_a_unit_out_of_range_suggests_degrees() {
    let range = ArgumentValue::Range {
        low: Box::new(ArgumentValue::Number(4.0)),
        high: Box::new(ArgumentValue::Number(20.0)),
        count: None,
    };
    let vary = ArgumentValue::Named("club.loft".into(), Box::new(range));
    let answer = ask("optimize", &[("vary", vary)], &InMemory::new(&[], &[]));
    let message = answer["message"].as_str().unwrap();
    assert!(message.ends_with("did you mean \"20 deg\"?"), "{message}");
}
