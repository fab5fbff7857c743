//! `longdrive sweep` in parts: equal bytes from any process, killed processes, full disks, and
//! `--check` of a folder.

use crate::command_line::{json, longdrive, number, wait_until};
use crate::program;
use longdrive::batch::SweepDefinition;
use longdrive::number::Level;
use longdrive::parts::{Manifest, check, file_name, merge};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::LazyLock;

const PARTS: u64 = 4;
const NAMES: [&str; 4] = [
    "part-00001.parquet",
    "part-00002.parquet",
    "part-00003.parquet",
    "part-00004.parquet",
];

/// Eight thousand drives in coarse steps, which are fast; some do not fly.
const DRIVES: [&str; 10] = [
    "sweep",
    "--set",
    "flight.step=0.5s",
    "--over",
    "club.loft=-4deg..15deg:41",
    "--over",
    "swing.attack_angle=-5deg..5deg:200",
    "--outcomes",
    "carry,launch_angle",
    "--gradient",
];
const SUMMARY: [&str; 6] = [
    "--histogram",
    "carry=150..290m:7",
    "--highest",
    "carry:5",
    "--lowest",
    "launch_angle:3",
];

fn question() -> Vec<&'static str> {
    [&DRIVES[..], &SUMMARY[..]].concat()
}

fn write(question: &[&str], part: u64, parts: u64, folder: &Path, more: &[&str]) -> (i32, Value) {
    let part = format!("{part}/{parts}");
    json(
        &[
            question,
            &["-o", folder.to_str().unwrap(), "--part", &part],
            more,
        ]
        .concat(),
    )
}

/// All parts, written in order by one thread.
struct Set {
    folder: tempfile::TempDir,
    answers: Vec<Value>,
}

impl Set {
    fn new(question: &[&str]) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let of = |part| write(question, part, PARTS, folder.path(), &["--threads", "1"]);
        let answers = (1..=PARTS).map(of).map(|(status, answer)| {
            assert_eq!((status, &answer["status"]), (0, &"done".into()), "{answer}");
            answer
        });
        Self {
            answers: answers.collect(),
            folder,
        }
    }

    fn path(&self) -> &Path {
        self.folder.path()
    }

    /// A copy that a test may damage.
    fn copy(&self) -> tempfile::TempDir {
        let copy = tempfile::tempdir().unwrap();
        for name in NAMES {
            fs::copy(self.path().join(name), copy.path().join(name)).unwrap();
        }
        copy
    }
}

static SET: LazyLock<Set> = LazyLock::new(|| Set::new(&question()));

fn bytes(folder: &Path) -> Vec<Vec<u8>> {
    NAMES
        .iter()
        .map(|name| fs::read(folder.join(name)).unwrap())
        .collect()
}

/// The rows of a file. Numbers are written as their bits.
fn rows(path: &Path) -> Vec<Vec<Option<String>>> {
    let file = SerializedFileReader::new(fs::File::open(path).unwrap()).unwrap();
    let cell = |field: &Field| match field {
        Field::Null => None,
        Field::Double(value) => Some(format!("{:x}", value.to_bits())),
        other => Some(other.to_string()),
    };
    let rows = file.get_row_iter(None).unwrap();
    rows.map(|row| {
        row.unwrap()
            .get_column_iter()
            .map(|(_, field)| cell(field))
            .collect()
    })
    .collect()
}

fn checked(folder: &Path, more: &[&str]) -> (i32, Value) {
    json(&[&["sweep", "--check", folder.to_str().unwrap()], more].concat())
}

#[test]
fn same_bytes_of_a_part_from_any_process_and_in_any_order() {
    let folder = tempfile::tempdir().unwrap();
    for (part, threads) in [(3, "3"), (1, "2"), (4, "1"), (2, "2")] {
        let (status, answer) = write(
            &question(),
            part,
            PARTS,
            folder.path(),
            &["--threads", threads],
        );
        assert_eq!(
            (status, &answer["file"]),
            (0, &NAMES[part as usize - 1].into())
        );
        let mut before = SET.answers[part as usize - 1].clone();
        before["folder"] = answer["folder"].clone();
        assert_eq!(answer, before);
    }
    assert!(bytes(folder.path()) == bytes(SET.path()));
    // several processes at the same time, two of them for each part
    let folder = tempfile::tempdir().unwrap();
    let program = |part: u64| {
        let mut program = program::command();
        program
            .args(question())
            .arg("-o")
            .arg(folder.path().join("made"))
            .args(["--part", &format!("{part}/{PARTS}")]);
        program
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap()
    };
    let programs: Vec<_> = (1..=PARTS).chain(1..=PARTS).map(program).collect();
    assert!(
        programs
            .into_iter()
            .all(|mut program| program.wait().unwrap().success())
    );
    assert!(bytes(&folder.path().join("made")) == bytes(SET.path()));
    assert_eq!(
        fs::read_dir(folder.path().join("made")).unwrap().count(),
        NAMES.len()
    );
}

#[test]
fn same_rows_of_all_parts_and_of_one_file() {
    let folder = tempfile::tempdir().unwrap();
    let whole = folder.path().join("whole.parquet");
    let printed = longdrive(&[&DRIVES[..], &["-o", whole.to_str().unwrap()]].concat());
    assert_eq!(printed.status, 0, "{}", printed.err);
    let parts: Vec<_> = NAMES
        .iter()
        .flat_map(|name| rows(&SET.path().join(name)))
        .collect();
    assert_eq!(parts.len(), 41 * 200);
    assert!(parts == rows(&whole));
}

/// Mean, and sum of squared deviations from the mean.
fn mean_and_squares(values: &[f64]) -> (f64, f64) {
    // pairwise summation in another order than the program's
    fn sum(values: &[f64]) -> f64 {
        match values {
            [] => 0.0,
            [one] => *one,
            values => sum(&values[..values.len() / 2]) + sum(&values[values.len() / 2..]),
        }
    }
    let mean = sum(values) / values.len() as f64;
    (
        mean,
        sum(&values
            .iter()
            .map(|value| (value - mean) * (value - mean))
            .collect::<Vec<_>>()),
    )
}

#[test]
fn independent_summary_of_a_set_by_its_rows() {
    let (status, answer) = checked(SET.path(), &[]);
    assert_eq!(
        (status, &answer["status"], &answer["message"]),
        (0, &"done".into(), &Value::Null)
    );
    let all: Vec<_> = NAMES
        .iter()
        .flat_map(|name| rows(&SET.path().join(name)))
        .collect();
    let columns = [
        "carry",
        "launch_angle",
        "d_carry/d_club.loft",
        "d_carry/d_swing.attack_angle",
    ];
    let value = |text: &String| f64::from_bits(u64::from_str_radix(text, 16).unwrap());
    let column = |at: usize| {
        all.iter()
            .filter_map(|row| row[3 + at].as_ref().map(value))
            .collect::<Vec<_>>()
    };
    for (at, name) in columns.iter().enumerate() {
        let (values, found) = (column(at), &answer["moments"][name]);
        let (mean, squares) = mean_and_squares(&values);
        assert_eq!(found["count"], values.len(), "{name}");
        assert!(
            (number(&found["mean"]) / mean - 1.0).abs() < 1e-13,
            "{name}: {found}, {mean}"
        );
        assert!(
            (number(&found["m2"]) / squares - 1.0).abs() < 1e-12,
            "{name}: {found}, {squares}"
        );
        assert_eq!(
            number(&found["min"]),
            values.iter().copied().fold(f64::INFINITY, f64::min)
        );
        assert_eq!(
            number(&found["max"]),
            values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
        );
    }
    let mut statuses = BTreeMap::new();
    all.iter().for_each(|row| {
        *statuses
            .entry(row[2].clone().unwrap().replace('"', ""))
            .or_insert(0) += 1
    });
    assert!(statuses.len() > 1, "{statuses:?}");
    for (status, count) in statuses {
        assert_eq!(answer["statuses"][&status], count, "{status}");
    }
    let carries = column(0);
    let histogram = &answer["histograms"][0];
    let within = |low: f64, high: f64| {
        carries
            .iter()
            .filter(|carry| (low..high).contains(*carry))
            .count()
    };
    assert_eq!(histogram["below"], within(f64::NEG_INFINITY, 150.0));
    assert_eq!(histogram["above"], within(290.0, f64::INFINITY));
    for bin in 0..7 {
        // the edges 150, 170, … are exact floating-point numbers, and no carry lies on an edge
        let low = 150.0 + 20.0 * f64::from(bin);
        assert_eq!(
            histogram["counts"][bin as usize],
            within(low, low + 20.0),
            "{bin}"
        );
    }
    for (which, (at, sign, most)) in [(0, -1.0, 5), (1, 1.0, 3)].into_iter().enumerate() {
        let mut ranked: Vec<_> = all
            .iter()
            .enumerate()
            .filter_map(|(row, cells)| Some((value(cells[3 + at].as_ref()?), row)))
            .collect();
        ranked.sort_by(|a, b| (sign * a.0).total_cmp(&(sign * b.0)).then(a.1.cmp(&b.1)));
        let best = &answer["best"][which]["rows"];
        assert_eq!(best.as_array().unwrap().len(), most);
        for (found, (value_of, row)) in best.as_array().unwrap().iter().zip(ranked) {
            assert_eq!(
                (number(&found["value"]), &found["row"]),
                (value_of, &row.into())
            );
            assert_eq!(
                number(&found["point"]["club.loft"]),
                value(all[row][0].as_ref().unwrap())
            );
        }
    }
    // statistics are merged from the answers of the parts, in any order and with one answer twice
    let mut manifests: Vec<Manifest> = SET
        .answers
        .iter()
        .map(|answer| serde_json::from_value(answer.clone()).unwrap())
        .collect();
    manifests.reverse();
    manifests.push(manifests[2].clone());
    let merged = serde_json::to_value(merge(&manifests).unwrap()).unwrap();
    for key in ["statuses", "beyond", "moments", "histograms", "best"] {
        assert_eq!(merged[key], answer[key], "{key}");
    }
}

#[cfg(unix)]
#[test]
fn independent_sha256sum_of_the_set_by_its_files() {
    let (status, answer) = checked(SET.path(), &["--hash"]);
    assert_eq!(status, 0, "{answer}");
    let mut program = Command::new("bash");
    program
        .args([
            "-c",
            "sha256sum part-*.parquet | tee /dev/stderr | sha256sum",
        ])
        .current_dir(SET.path());
    let output = program.output().unwrap();
    let set = String::from_utf8(output.stdout).unwrap();
    assert_eq!(answer["sha256"].as_str(), set.split(' ').next());
    let files = String::from_utf8(output.stderr).unwrap();
    for (line, answer) in files.lines().zip(&SET.answers) {
        assert_eq!(
            line,
            format!(
                "{}  {}",
                answer["sha256"].as_str().unwrap(),
                answer["file"].as_str().unwrap()
            )
        );
    }
    assert_eq!(checked(SET.path(), &[]).1["sha256"], Value::Null);
}

#[test]
fn a_foreign_file_among_all_parts_is_reported() {
    let copy = SET.copy();
    fs::write(copy.path().join("part-00005.parquet"), "notes").unwrap();
    let printed = longdrive(&["sweep", "--check", copy.path().to_str().unwrap()]);
    assert!(
        printed.status == 1
            && printed
                .out
                .contains("4 parts are present and valid, but the folder has other files too"),
        "{} {}",
        printed.out,
        printed.err
    );
}

#[test]
fn an_existing_part_is_kept_and_one_of_other_arguments_is_refused() {
    let copy = SET.copy();
    let before = fs::metadata(copy.path().join(NAMES[1]))
        .unwrap()
        .modified()
        .unwrap();
    let (status, answer) = write(&question(), 2, PARTS, copy.path(), &[]);
    assert_eq!(status, 0);
    assert!(
        answer["message"]
            .as_str()
            .unwrap()
            .contains("existed already"),
        "{answer}"
    );
    assert_eq!(answer["sha256"], SET.answers[1]["sha256"]);
    assert_eq!(
        fs::metadata(copy.path().join(NAMES[1]))
            .unwrap()
            .modified()
            .unwrap(),
        before
    );

    let refused = |more: &[&str], why: &str| {
        let (status, answer) = write(&question(), 2, PARTS, copy.path(), more);
        let message = answer["message"].as_str().unwrap();
        assert!(status == 2 && message.contains(why), "{more:?}: {message}");
    };
    refused(&["--set", "swing.speed=100mph"], "different setups");
    refused(&["--wrt", "air.density"], "different derivatives");
    refused(
        &["--highest", "launch_angle:2"],
        "different histograms or best rows",
    );
    // no part is written into the folder of another sweep
    fs::remove_file(copy.path().join(NAMES[1])).unwrap();
    refused(
        &["--set", "swing.speed=100mph"],
        "a folder holds the parts of one",
    );
    let (status, answer) = write(&question(), 2, 5, copy.path(), &[]);
    assert!(
        status == 2
            && answer["message"]
                .as_str()
                .unwrap()
                .contains("numbers of parts 5 and 4"),
        "{answer}"
    );
    assert!(!copy.path().join(NAMES[1]).exists());
    // a part with an unreadable footer does not hide the others
    let apart = SET.copy();
    for name in &NAMES[..3] {
        fs::write(apart.path().join(name), "PAR1").unwrap();
    }
    fs::remove_file(apart.path().join(NAMES[1])).unwrap();
    let other = [&question()[..], &["--set", "swing.speed=100mph"]].concat();
    let (status, answer) = write(&other, 2, PARTS, apart.path(), &[]);
    let message = answer["message"].as_str().unwrap();
    assert!(
        status == 2 && message.contains("a folder holds the parts of one"),
        "{message}"
    );
    assert_eq!(write(&question(), 2, PARTS, copy.path(), &[]).0, 0);
    assert!(bytes(copy.path()) == bytes(SET.path()));
}

/// Changes a file into the file that another version of longdrive would write.
fn of_other_version(path: &Path) {
    let text = fs::read(path).unwrap();
    let find = |text: &[u8], part: &str| {
        text.windows(part.len())
            .position(|window| window == part.as_bytes())
    };
    let at = find(&text, "{\"version\"").unwrap();
    let mut questions =
        serde_json::Deserializer::from_slice(&text[at..]).into_iter::<SweepDefinition>();
    let question = questions.next().unwrap().unwrap();
    let length = questions.byte_offset();
    let other = SweepDefinition {
        version: "0.0.9".into(),
        ..question.clone()
    };
    let mut text = text;
    text[at..at + length].copy_from_slice(serde_json::to_string(&other).unwrap().as_bytes());
    let hash = question.hash();
    let at = find(&text, &hash).unwrap();
    text[at..at + hash.len()].copy_from_slice(other.hash().as_bytes());
    fs::write(path, text).unwrap();
}

#[test]
fn a_check_names_missing_double_damaged_and_foreign_parts() {
    let checked_copy = |spoil: &dyn Fn(&Path), more: &[&str]| {
        let copy = SET.copy();
        spoil(copy.path());
        let (status, answer) = checked(copy.path(), more);
        assert_eq!(
            (status, &answer["status"]),
            (1, &"partial".into()),
            "{answer}"
        );
        let faults = answer["faults"].as_array().unwrap().iter();
        let faults: Vec<_> = faults
            .map(|fault| (fault["file"].clone(), fault["kind"].clone()))
            .collect();
        (answer["missing"].clone(), faults, answer)
    };
    let none: Vec<(Value, Value)> = vec![];
    let fault = |file: &str, kind: &str| vec![(Value::from(file), Value::from(kind))];
    let place = |folder: &Path| folder.join(NAMES[2]);
    let (missing, faults, answer) = checked_copy(
        &|folder| {
            fs::remove_file(folder.join(NAMES[0])).unwrap();
            fs::remove_file(folder.join(NAMES[2])).unwrap();
            fs::remove_file(folder.join(NAMES[3])).unwrap();
        },
        &[],
    );
    assert_eq!((missing, faults), (serde_json::json!([1, 3, 4]), none));
    assert!(
        answer["message"]
            .as_str()
            .unwrap()
            .contains("missing: 1,3-4"),
        "{answer}"
    );
    assert_eq!(answer["rows"], 2048);

    let cut = |folder: &Path| {
        let file = fs::OpenOptions::new()
            .write(true)
            .open(place(folder))
            .unwrap();
        file.set_len(file.metadata().unwrap().len() - 9).unwrap();
    };
    assert_eq!(checked_copy(&cut, &[]).0, serde_json::json!([3]));
    assert_eq!(checked_copy(&cut, &[]).1, fault(NAMES[2], "damaged"));
    let doubled = |folder: &Path| {
        fs::copy(place(folder), folder.join("part-00003 (1).parquet")).unwrap();
    };
    assert_eq!(checked_copy(&doubled, &[]).0, serde_json::json!([]));
    assert_eq!(
        checked_copy(&doubled, &[]).1,
        fault("part-00003 (1).parquet", "doubled")
    );
    let swapped =
        |folder: &Path| fs::rename(place(folder), folder.join("part-00007.parquet")).unwrap();
    assert_eq!(
        checked_copy(&swapped, &[]).1,
        fault("part-00007.parquet", "foreign")
    );
    let twice_misnamed = |folder: &Path| {
        fs::rename(place(folder), folder.join("a.parquet")).unwrap();
        fs::copy(folder.join("a.parquet"), folder.join("b.parquet")).unwrap();
    };
    let (missing, faults, answer) = checked_copy(&twice_misnamed, &[]);
    assert_eq!(missing, serde_json::json!([3]));
    assert_eq!(
        faults,
        [fault("a.parquet", "foreign"), fault("b.parquet", "doubled")].concat()
    );
    let reason = answer["faults"][1]["reason"].as_str().unwrap();
    assert!(reason.ends_with("the first is a.parquet"), "{reason}");
    let strange = |folder: &Path| fs::write(folder.join("mine.parquet"), "PAR1").unwrap();
    assert_eq!(
        checked_copy(&strange, &[]).1,
        fault("mine.parquet", "foreign")
    );
    let other = |folder: &Path| {
        fs::remove_file(place(folder)).unwrap();
        let apart = tempfile::tempdir().unwrap();
        let question = [&question()[..], &["--set", "swing.speed=100mph"]].concat();
        assert_eq!(write(&question, 3, PARTS, apart.path(), &[]).0, 0);
        fs::copy(place(apart.path()), place(folder)).unwrap();
    };
    assert_eq!(
        checked_copy(&other, &[]).1,
        fault(NAMES[2], "other-question")
    );
    let (missing, faults, answer) = checked_copy(&|folder| of_other_version(&place(folder)), &[]);
    assert_eq!(
        (missing, faults),
        (serde_json::json!([3]), fault(NAMES[2], "other-version"))
    );
    let versions = concat!(
        "versions of longdrive ",
        env!("CARGO_PKG_VERSION"),
        " and 0.0.9"
    );
    assert!(
        answer["message"].as_str().unwrap().contains(versions),
        "{answer}"
    );
    // one bit of a row is wrong; the check finds it only with `--hash`, which reads the rows
    let flipped = |folder: &Path| {
        let mut bytes = fs::read(place(folder)).unwrap();
        bytes[5000] ^= 1;
        fs::write(place(folder), bytes).unwrap();
    };
    let copy = SET.copy();
    flipped(copy.path());
    assert_eq!(checked(copy.path(), &[]).0, 0);
    assert_eq!(
        checked_copy(&flipped, &["--hash"]).1,
        fault(NAMES[2], "damaged")
    );

    // the check compares the parts with the arguments of a sweep
    let folder = SET.path().to_str().unwrap();
    let (status, answer) = json(&[&question()[..], &["--check", folder]].concat());
    assert_eq!((status, &answer["rows"]), (0, &8200.into()), "{answer}");
    let (status, answer) = json(
        &[
            &question()[..],
            &["--check", folder, "--set", "gravity=9.8 m/s^2"],
        ]
        .concat(),
    );
    assert_eq!(
        (status, answer["missing"].as_array().unwrap().len()),
        (1, 4),
        "{answer}"
    );
    // without `--over` the check cannot compare the other options
    for (more, option) in [
        (&["--set", "gravity=9.8 m/s^2"][..], "set"),
        (&["--speed", "90mph"], "speed"),
        (&["--outcomes", "lateral"], "outcomes"),
        (&["--gradient"], "gradient"),
        (&["--wrt", "gravity"], "wrt"),
        (&["--highest", "carry:5"], "highest"),
        (&["--instructions", "baseline"], "instructions"),
        (&["mae494"], "the setup mae494"),
    ] {
        let (status, answer) = checked(SET.path(), more);
        let message = answer["message"].as_str().unwrap();
        assert!(
            status == 2 && message.contains(option) && message.contains("--over"),
            "{answer}"
        );
    }
    let empty = tempfile::tempdir().unwrap();
    let (status, answer) = checked(empty.path(), &[]);
    assert!(
        status == 2
            && answer["message"]
                .as_str()
                .unwrap()
                .contains("it has no part of a sweep"),
        "{answer}"
    );
    assert_eq!(checked(Path::new("/nowhere/at/all"), &[]).0, 2);
}

#[cfg(unix)]
#[test]
fn a_kill_and_a_full_disk_leave_no_part_and_the_same_command_writes_it() {
    let copy = SET.copy();
    let place = copy.path().join(NAMES[2]);
    fs::remove_file(&place).unwrap();
    let part = ["-o", copy.path().to_str().unwrap(), "--part", "3/4"];
    let most = fs::metadata(SET.path().join(NAMES[2])).unwrap().len() / 1024 / 2;
    let limited = format!("trap '' XFSZ; ulimit -f {most}; exec \"$@\"");
    let mut program = Command::new("bash");
    program
        .args(["-c", &limited, "bash"])
        .arg(program::path())
        .args(question())
        .args(part);
    let output = program.output().unwrap();
    let printed = String::from_utf8(output.stderr).unwrap();
    assert!(
        output.status.code() == Some(2) && printed.contains("then repeat part 3"),
        "{printed}"
    );
    assert_eq!(fs::read_dir(copy.path()).unwrap().count(), 3);

    // the process is killed while its temporary file is empty, has its first bytes, or has rows
    for least in [0, 1, 1000] {
        let unfinished = || {
            let entries = fs::read_dir(copy.path()).unwrap().map(Result::unwrap);
            let mut files = entries.filter(|entry| {
                let name = entry.file_name();
                name.to_string_lossy().starts_with(".longdrive-")
            });
            files.next()
        };
        let has_bytes = |entry: fs::DirEntry| entry.metadata().is_ok_and(|it| it.len() >= least);
        let mut program = program::command();
        let quiet = program
            .args(question())
            .args(part)
            .stdout(Stdio::null())
            .stderr(Stdio::null());
        let mut child = quiet.spawn().unwrap();
        wait_until(&mut child, || unfinished().is_some_and(has_bytes));
        let _ = child.kill();
        let _ = child.wait();
        if let Some(file) = unfinished() {
            fs::remove_file(file.path()).unwrap();
        }
        if place.exists() {
            assert!(fs::read(&place).unwrap() == bytes(SET.path())[2]);
        }
    }
    assert_eq!(write(&question(), 3, PARTS, copy.path(), &[]).0, 0);
    assert!(bytes(copy.path()) == bytes(SET.path()));
    // the temporary files of a killed process do not count, and are reported
    fs::write(copy.path().join(".longdrive-abc"), "PAR1").unwrap();
    let (status, answer) = checked(copy.path(), &[]);
    assert_eq!(status, 0, "{answer}");
    assert!(
        answer["unfinished"]
            .as_array()
            .unwrap()
            .contains(&".longdrive-abc".into())
    );
}

#[test]
fn instructions_are_named_in_each_part_kept_apart_and_the_same_when_repeated() {
    let most = Level::here();
    let mut sets: Vec<Vec<Vec<Vec<Option<String>>>>> = vec![];
    for instructions in Level::ALL.into_iter().filter(|known| known.is_here()) {
        let requested = [&question()[..], &["--instructions", instructions.name()]].concat();
        let (set, again) = (Set::new(&requested), Set::new(&requested));
        assert!(bytes(set.path()) == bytes(again.path()), "{instructions}");
        let named = format!("{} {instructions}", std::env::consts::ARCH);
        let (_, answer) = checked(set.path(), &[]);
        assert_eq!(answer["question"]["instructions"], named.as_str());
        assert_eq!(
            bytes(set.path()) == bytes(SET.path()),
            instructions == most,
            "the default is the highest level"
        );
        sets.push(
            NAMES
                .iter()
                .map(|name| rows(&set.path().join(name)))
                .collect(),
        );
        // parts computed with different instruction sets do not belong together: the program
        // refuses to write such a part, and `--check` reports it
        if instructions < most {
            fs::remove_file(set.path().join(NAMES[3])).unwrap();
            let (status, answer) = write(&question(), 4, PARTS, set.path(), &[]);
            assert!(
                status == 2 && answer["message"].as_str().unwrap().contains("instructions"),
                "{answer}"
            );
            fs::copy(SET.path().join(NAMES[3]), set.path().join(NAMES[3])).unwrap();
            let (status, answer) = checked(set.path(), &[]);
            assert_eq!(
                (status, &answer["faults"][0]["kind"]),
                (1, &"other-instructions".into()),
                "{answer}"
            );
            let more = [
                "--check",
                set.path().to_str().unwrap(),
                "--instructions",
                most.name(),
            ];
            assert_eq!(json(&[&question()[..], &more].concat()).0, 2);
        }
    }
    // rows computed with different instruction sets agree to rounding
    let value = |cell: &Option<String>| {
        f64::from_bits(u64::from_str_radix(cell.as_ref().unwrap(), 16).unwrap())
    };
    for set in &sets[1..] {
        for (row, first) in set.iter().flatten().zip(sets[0].iter().flatten()) {
            assert_eq!(row[2], first[2]);
            if row[2].as_deref() == Some("\"landed\"") {
                assert!(
                    (value(&row[3]) - value(&first[3])).abs() < 1e-9,
                    "{row:?} {first:?}"
                );
            }
        }
    }
    for lacking in Level::ALL.into_iter().filter(|known| !known.is_here()) {
        let printed = longdrive(&[&DRIVES[..], &["--instructions", lacking.name()]].concat());
        assert_eq!(printed.status, 2);
        assert!(
            printed
                .err
                .contains(&format!("its widest instruction set is {most}")),
            "{}",
            printed.err
        );
    }
}

/// The C library has variants of its functions for processors with FMA, which round differently.
/// Machines that use different variants compute different rows, even with the same
/// `--instructions`.
#[cfg(all(target_os = "linux", target_arch = "x86_64", target_env = "gnu"))]
#[test]
fn a_part_with_other_sines_of_the_c_library_is_refused_and_the_same_sweep_has_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    // angles far beyond 46°, whose sines come from the C library
    let requested = [
        "sweep",
        "--over",
        "club.loft=5deg..70deg:64",
        "--over",
        "swing.face_angle=-60deg..60deg:64",
        "--outcomes",
        "carry,lateral",
        "--gradient",
        "--instructions",
        "baseline",
        "--json",
    ];
    let of = |tunables: &str, part: &str, to: &str| {
        let mut program = program::command();
        program
            .args(requested)
            .args(["--part", part, "-o"])
            .arg(folder.path().join(to))
            .env("GLIBC_TUNABLES", tunables);
        let output = program.output().unwrap();
        let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
        (output.status.code().unwrap(), answer)
    };
    let without = "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX512F";
    let ((_, here), (_, there)) = (of("", "1/2", "here"), of(without, "1/2", "there"));
    if here["question"] == there["question"] {
        // only one variant exists for this C library and this processor
        assert_eq!(here["sha256"], there["sha256"]);
        return;
    }
    assert_ne!(
        here["data"], there["data"],
        "the rows do not differ: the fingerprint is stricter than necessary here"
    );
    let (status, answer) = of(without, "2/2", "here");
    assert!(
        status == 2 && answer["message"].as_str().unwrap().contains("C libraries"),
        "{answer}"
    );
    // the same variant gives the same bytes
    let again = of(without, "1/2", "again").1;
    assert_eq!(
        (&again["question"], &again["sha256"]),
        (&there["question"], &there["sha256"])
    );
}

#[test]
fn a_sweep_that_cannot_be_divided_is_refused_with_advice() {
    let folder = tempfile::tempdir().unwrap();
    let into = folder.path().join("parts");
    let refused = |more: &[&str], why: &str| {
        let printed = longdrive(&[&DRIVES[..], &["-o", into.to_str().unwrap()], more].concat());
        assert!(
            printed.status == 2 && printed.err.contains(why),
            "{more:?}: {}",
            printed.err
        );
        assert!(!into.exists());
    };
    // 8200 rows are eight blocks and a remainder
    refused(
        &["--part", "1/10"],
        "error: 10 parts: the sweep has 8200 rows, in blocks of 1024",
    );
    refused(&["--part", "1/10"], "divide it into at most 9 parts");
    refused(&["--part", "0/4"], "from 1");
    refused(&["--part", "5/4"], "give one from 1/4 to 4/4");
    refused(&["--part", "x"], "--part 17/1000");
    refused(
        &["--part", "1/4", "--histogram", "carry=3m..2m"],
        "the lower edge below the upper edge",
    );
    refused(
        &["--part", "1/4", "--histogram", "apex_height=3m..20m"],
        "add it to --outcomes",
    );
    refused(
        &["--part", "1/4", "--highest", "carry:0"],
        "error: --highest carry:0: the number of rows must be from 1 to 10000",
    );
    refused(
        &[
            "--part",
            "1/4",
            "--highest",
            "carry:1",
            "--highest",
            "carry:2",
        ],
        "requested twice",
    );
    refused(&["--highest", "carry:3"], "add --part 1/1");
    refused(&["--part", "1/4", "--resume"], "--resume");
    let printed = longdrive(
        &[
            &DRIVES[..],
            &[
                "--part",
                "1/4",
                "-o",
                folder.path().join("no/parts").to_str().unwrap(),
            ],
        ]
        .concat(),
    );
    assert!(
        printed.status == 2 && printed.err.contains("no/parts"),
        "{}",
        printed.err
    );
    // the file names sort in the order of the parts
    let names: Vec<_> = [9, 10, 99_999]
        .map(|part| file_name(part, 123_456))
        .to_vec();
    assert!(names.is_sorted(), "{names:?}");
    assert!(check(SET.path(), None, false).unwrap().is_complete());
}

/// The summary of a set has derivatives in the unit of its column head: the mean slope in yd/deg is
/// the one in m/rad times the sizes of the units. A standard deviation has no side.
#[test]
fn exact_units_of_derivatives_and_deviations_in_a_summary() {
    let folder = tempfile::tempdir().unwrap();
    let name = folder.path().to_str().unwrap();
    let sweep = [
        "sweep",
        "--over",
        "swing.face_angle=-3deg..3deg:50",
        "--outcomes",
        "lateral",
        "--gradient",
        "--part",
        "1/1",
        "-o",
        name,
    ];
    assert_eq!(longdrive(&sweep).status, 0);
    let (_, answer) = json(&["sweep", "--check", name]);
    let column = "d_lateral/d_swing.face_angle";
    let moments = answer["moments"].as_object().unwrap();
    let mean = number(&moments[column]["mean"]);
    let text = longdrive(&["sweep", "--check", name]).out;
    let row = |start: &str| {
        text.lines()
            .find(|line| line.trim_start().starts_with(start))
    };
    let slopes = row(column).unwrap();
    assert!(slopes.contains("[yd/deg]"), "{slopes}");
    let shown: f64 = slopes.split_whitespace().nth(3).unwrap().parse().unwrap();
    let expected = mean / 0.9144 * 1f64.to_radians();
    assert!(
        (shown - expected).abs() < 1e-5 * expected.abs(),
        "{shown} {expected}"
    );
    let lateral: Vec<_> = row("lateral").unwrap().split("  ").collect();
    let cells: Vec<_> = lateral
        .iter()
        .filter(|cell| !cell.trim().is_empty())
        .collect();
    assert!(cells[3].trim().ends_with(" yd"), "{cells:?}");
}

/// Without a stated step, the step and the largest defect follow from the setup: the message names
/// the setup all the same.
#[test]
fn a_part_of_another_setup_with_a_step_of_its_own_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let question = [
        "sweep",
        "--over",
        "club.loft=5deg..15deg:2000",
        "--outcomes",
        "carry",
    ];
    assert_eq!(write(&question, 1, 2, folder.path(), &[]).0, 0);
    for (other, differs) in [
        (["--set", "swing.attack_angle=3deg"], "different setups"),
        (["--outcomes", "total"], "different outcomes"),
    ] {
        let mut question = question.to_vec();
        if other[0] == "--outcomes" {
            question.truncate(3);
        }
        let (status, answer) = write(&question, 2, 2, folder.path(), &other);
        let message = answer["message"].as_str().unwrap_or_default();
        assert!(status == 2 && message.contains(differs), "{message}");
    }
}
