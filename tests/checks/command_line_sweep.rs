//! `longdrive sweep`: files, kills and resumes, full disks, closed pipes, and bad input.

use crate::command_line::{interrupt, json, longdrive, wait_until};
use crate::program::{self, FORMATS};
use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
#[cfg(feature = "full")]
use std::sync::Arc;
use std::sync::OnceLock;

/// Some sixty thousand drives in coarse steps. Their many columns fill three row groups. Some
/// drives do not fly.
fn many() -> Vec<&'static str> {
    let over = [
        "--over",
        "club.loft=1deg..15deg:64",
        "--over",
        "swing.attack_angle=-5deg..5deg:1024",
    ];
    [
        &[
            "sweep",
            "--set",
            "flight.step=1s",
            "--outcomes",
            "all",
            "--gradient",
        ],
        &over[..],
    ]
    .concat()
}

fn start(args: &[&str], file: &Path, more: &[&str]) -> Child {
    let mut program = program::command();
    program
        .args(args)
        .arg("-o")
        .arg(file)
        .args(more)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// Waits for the end of the program; returns its exit status and its standard error.
fn finish(child: Child) -> (Option<i32>, String) {
    let output = child.wait_with_output().unwrap();
    (
        output.status.code(),
        String::from_utf8(output.stderr).unwrap(),
    )
}

fn journal(file: &Path) -> PathBuf {
    PathBuf::from(format!("{}.resume", file.display()))
}

/// The file that has the rows until the sweep is finished.
fn unfinished_file(file: &Path) -> PathBuf {
    PathBuf::from(format!("{}.part", file.display()))
}

/// Waits until some rows are written, or the program ends.
fn wait_for_rows(child: &mut Child, file: &Path) {
    wait_until(child, || journal_lines(file) > 1);
}

/// Number of complete lines of the journal file. Each line after the first announces written rows.
fn journal_lines(file: &Path) -> usize {
    fs::read_to_string(journal(file)).map_or(0, |text| text.matches('\n').count())
}

/// The sweep over the points of a table.
#[cfg(feature = "full")]
fn many_of(table: &str) -> Vec<&str> {
    vec![
        "sweep",
        "--set",
        "flight.step=1s",
        "--outcomes",
        "all",
        "--gradient",
        "--points",
        table,
    ]
}

/// An uninterrupted sweep: its file, and its number of drives beyond the fitted range of the law.
struct Uninterrupted {
    bytes: Vec<u8>,
    beyond: String,
}

impl Uninterrupted {
    fn new(many: &[&str], format: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join(format!("whole.{format}"));
        let (status, printed) = finish(start(many, &file, &["--threads", "1"]));
        assert_eq!(status, Some(0), "{printed}");
        assert!(!journal(&file).exists());
        Self {
            bytes: fs::read(file).unwrap(),
            beyond: beyond(&printed).unwrap_or_else(|| panic!("{printed}")),
        }
    }

    /// The result of `many`, computed once for all tests.
    fn of_many(format: &'static str) -> &'static Self {
        static WHOLE: [OnceLock<Uninterrupted>; FORMATS.len()] =
            [const { OnceLock::new() }; FORMATS.len()];
        let at = FORMATS.iter().position(|known| *known == format).unwrap();
        WHOLE[at].get_or_init(|| Self::new(&many(), format))
    }
}

fn beyond(printed: &str) -> Option<String> {
    printed
        .lines()
        .find(|line| line.contains("drives that landed: "))
        .map(str::to_owned)
}

fn killed_and_resumed(many: &[&str], format: &str, whole: &Uninterrupted) {
    let folder = tempfile::tempdir().unwrap();
    let part = folder.path().join(format!("part.{format}"));
    let mut child = start(many, &part, &["--threads", "2"]);
    wait_for_rows(&mut child, &part);
    child.kill().unwrap();
    child.wait().unwrap();
    let mut announced_row = None;
    if journal(&part).exists() {
        // a kill may truncate a row, a row group or a line of the journal
        let append = |path: &Path, bytes: &[u8]| {
            fs::OpenOptions::new()
                .append(true)
                .open(path)
                .unwrap()
                .write_all(bytes)
                .unwrap();
        };
        assert!(
            !part.exists(),
            "an incomplete file has the name of a complete one"
        );
        append(&unfinished_file(&part), b"0.1,0.2,lan");
        append(&journal(&part), b"{\"rows\":99");

        // a started sweep is refused without --resume, and with --resume if other arguments differ
        let (status, printed) = finish(start(many, &part, &[]));
        assert_eq!(status, Some(2));
        assert!(printed.contains("--resume continues it"), "{printed}");
        let (status, printed) = finish(start(
            many,
            &part,
            &["--resume", "--set", "swing.speed=100mph"],
        ));
        assert_eq!(status, Some(2));
        assert!(
            printed.contains("another command (different setups)"),
            "{printed}"
        );
        let (status, printed) = finish(start(many, &part, &["--resume", "--wrt", "air.density"]));
        assert_eq!(status, Some(2));
        assert!(printed.contains("(different derivatives)"), "{printed}");
        refused_with_another_c_library(many, &part);

        // Ctrl-C after more rows are written, unless the sweep has ended
        let before = journal_lines(&part);
        let mut child = start(many, &part, &["--resume"]);
        wait_until(&mut child, || journal_lines(&part) > before);
        if child.try_wait().unwrap().is_none() {
            interrupt(&child);
        }
        let (status, printed) = finish(child);
        assert!(
            status == Some(0) || status == Some(1),
            "{status:?} {printed}"
        );
        if status == Some(1) {
            assert!(
                printed.contains("--resume") && printed.contains("stopped: "),
                "{printed}"
            );
            // the sweep continues after the announced rows
            announced_row = printed
                .split("continues after ")
                .nth(1)
                .map(|rest| rest.trim().to_owned());
            readable(&unfinished_file(&part), format);
        }
    }
    if journal(&part).exists() {
        let (status, printed) = finish(start(many, &part, &["--resume", "--threads", "3"]));
        assert_eq!(status, Some(0), "{printed}");
        assert!(printed.contains("resuming after "), "{printed}");
        assert_eq!(
            beyond(&printed).as_ref(),
            Some(&whole.beyond),
            "the count differs from an uninterrupted run"
        );
        if let Some(announced_row) = announced_row {
            let rows = announced_row.split(' ').next().unwrap_or_default();
            assert!(
                printed.contains(&format!("resuming after {rows} ")),
                "{announced_row}: {printed}"
            );
        }
    }
    assert!(!journal(&part).exists() && !unfinished_file(&part).exists());
    assert!(
        fs::read(&part).unwrap() == whole.bytes,
        "the file differs from an uninterrupted run"
    );
    let (status, printed) = finish(start(many, &part, &["--resume"]));
    assert_eq!(status, Some(2));
    assert!(printed.contains("nothing to resume"), "{printed}");
}

/// Checks that an unfinished sweep is refused on a machine whose C library rounds differently. The
/// journal stays as it was.
fn refused_with_another_c_library(many: &[&str], part: &Path) {
    let own = fs::read_to_string(journal(part)).unwrap();
    let (first, entries) = own.split_once('\n').unwrap();
    let mut header: serde_json::Value = serde_json::from_str(first).unwrap();
    header["functions"] = "0123456789abcdef".into();
    fs::write(journal(part), format!("{header}\n{entries}")).unwrap();
    let (status, printed) = finish(start(many, part, &["--resume"]));
    assert_eq!(status, Some(2), "{printed}");
    assert!(printed.contains("C libraries or processors"), "{printed}");
    fs::write(journal(part), own).unwrap();
}

/// Number of rows of a file, all of them complete. Of JSON lines every thousandth is parsed.
fn readable(path: &Path, format: &str) -> usize {
    match format {
        "csv" => {
            let mut reader = csv::Reader::from_path(path).unwrap();
            reader
                .records()
                .map(|row| {
                    assert_eq!(
                        row.unwrap().len(),
                        3 + 3 * longdrive::Outcome::OF_DRIVES.len()
                    )
                })
                .count()
        }
        "jsonl" => {
            let text = fs::read_to_string(path).unwrap();
            assert!(text.is_empty() || text.ends_with('\n'));
            let lines: Vec<&str> = text.lines().collect();
            let is_object = |line: &&str| line.starts_with('{') && line.ends_with('}');
            assert!(lines.iter().all(is_object));
            // parsing all of them without optimization would take most of the test's time
            for line in lines.iter().step_by(1000).chain(lines.last()) {
                serde_json::from_str::<serde_json::Value>(line).unwrap();
            }
            lines.len()
        }
        #[cfg(feature = "full")]
        "parquet" => {
            use parquet::file::reader::{FileReader, SerializedFileReader};
            let file = SerializedFileReader::new(fs::File::open(path).unwrap()).unwrap();
            file.get_row_iter(None)
                .unwrap()
                .filter(Result::is_ok)
                .count()
        }
        other => panic!("{other} is no format of these tests"),
    }
}

#[test]
fn same_csv_of_a_killed_and_resumed_sweep() {
    killed_and_resumed(&many(), "csv", Uninterrupted::of_many("csv"));
}

#[test]
fn same_json_lines_of_a_killed_and_resumed_sweep() {
    killed_and_resumed(&many(), "jsonl", Uninterrupted::of_many("jsonl"));
}

#[cfg(feature = "full")]
#[test]
fn same_parquet_of_a_killed_and_resumed_sweep() {
    killed_and_resumed(&many(), "parquet", Uninterrupted::of_many("parquet"));
}

#[cfg(feature = "full")]
#[test]
fn same_rows_of_an_arrow_table_killed_and_resumed() {
    use arrow_array::{ArrayRef, Float64Array, RecordBatch};
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("points.arrow");
    // the record batches and the computed chunks have different sizes
    let batches: Vec<_> = (0..64)
        .map(|loft| {
            let lofts: Float64Array = (0..1024).map(|_| 0.01 + 0.0045 * f64::from(loft)).collect();
            let angles: Float64Array = (0..1024)
                .map(|angle| -0.09 + 0.00017 * f64::from(angle))
                .collect();
            let columns = [
                ("club.loft", Arc::new(lofts) as ArrayRef),
                ("swing.attack_angle", Arc::new(angles)),
            ];
            RecordBatch::try_from_iter(columns).unwrap()
        })
        .collect();
    let target = fs::File::create(&path).unwrap();
    let mut writer = arrow_ipc::writer::FileWriter::try_new(target, &batches[0].schema()).unwrap();
    batches
        .iter()
        .for_each(|batch| writer.write(batch).unwrap());
    writer.finish().unwrap();
    let many = many_of(path.to_str().unwrap());
    killed_and_resumed(&many, "csv", &Uninterrupted::new(&many, "csv"));
}

#[cfg(not(feature = "full"))]
#[test]
fn a_format_that_is_not_compiled_in_names_its_feature() {
    let table = |name: &str| format!("{}/data/tables/{name}", env!("CARGO_MANIFEST_DIR"));
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("a.png").display().to_string();
    for (args, feature) in [
        (["sweep", "--points", &table("points.parquet")], "parquet"),
        (["sweep", "--points", &table("points.arrow")], "arrow"),
        (
            ["plot", "trajectory", &format!("--output={picture}")],
            "png",
        ),
    ] {
        let printed = longdrive(&args);
        let sentence = crate::command_line::on_one_line(&printed.err);
        let says = format!("cargo install --path . --features {feature}");
        assert_eq!(printed.status, 2, "{sentence}");
        assert!(sentence.contains(&says), "{sentence}");
    }
}

/// Tables of the same points, written by pyarrow in each format and by Python in CSV.
#[cfg(feature = "full")]
#[test]
fn independent_tables_in_every_format_give_the_same_bytes() {
    let table = |name: &str| format!("{}/data/tables/{name}", env!("CARGO_MANIFEST_DIR"));
    let sweep = |name: &str| {
        longdrive(&[
            "sweep",
            "--gradient",
            "--outcomes",
            "all",
            "--points",
            &table(name),
        ])
    };
    let csv = sweep("points.csv");
    assert_eq!(
        (csv.status, csv.out.lines().count()),
        (0, 12),
        "{}",
        csv.err
    );
    assert!(
        csv.out
            .lines()
            .skip(1)
            .all(|row| row.split(',').nth(3) == Some("landed")),
        "{}",
        csv.out
    );
    for name in [
        "points.parquet",
        "points.arrow",
        "points.arrows",
        "zstd.feather",
        "lz4.feather",
        "gaps.arrows",
    ] {
        let other = sweep(name);
        assert_eq!(
            (other.status, &other.out),
            (0, &csv.out),
            "{name}: {}",
            other.err
        );
    }
    let none = sweep("no_rows.arrow");
    assert_eq!((none.status, none.out.as_str()), (2, ""), "{}", none.err);
    assert!(
        none.err
            .contains("no_rows.arrow: it has a head and no rows"),
        "{}",
        none.err
    );
    let printed = sweep("text.arrow");
    assert_eq!(
        (printed.status, printed.out.as_str()),
        (2, ""),
        "{}",
        printed.err
    );
    assert!(
        printed.err.contains("column air.density: its type is Utf8"),
        "{}",
        printed.err
    );
    // a row without a value does not affect the others
    let printed = longdrive(&[
        "sweep",
        "--points",
        &table("null.arrow"),
        "--units",
        "metric",
    ]);
    assert_eq!(printed.status, 0, "{}", printed.err);
    assert!(
        printed.err.contains("row 3: air.density is missing"),
        "{}",
        printed.err
    );
    assert_eq!(
        printed
            .out
            .lines()
            .filter(|row| row.contains(",out-of-range,"))
            .count(),
        1,
        "{}",
        printed.out
    );
}

#[cfg(unix)]
#[test]
fn a_full_disk_leaves_complete_rows_that_can_be_resumed() {
    let folder = tempfile::tempdir().unwrap();
    for &format in FORMATS {
        let (whole, part) = (
            &Uninterrupted::of_many(format).bytes,
            folder.path().join(format!("part.{format}")),
        );
        // `ulimit` limits the size of a file, in KiB. The signal XFSZ is ignored, so that a write
        // beyond the limit returns an error
        let most = whole.len() / 1024 * 3 / 5;
        let limited = format!("trap '' XFSZ; ulimit -f {most}; exec \"$@\"");
        let mut program = Command::new("bash");
        program
            .args(["-c", &limited, "bash"])
            .arg(program::path())
            .args(many())
            .arg("-o")
            .arg(&part);
        let output = program.output().unwrap();
        let printed = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{printed}");
        let rows: usize = printed
            .split("its first ")
            .nth(1)
            .unwrap()
            .split(' ')
            .next()
            .unwrap()
            .parse()
            .unwrap();
        assert!(
            rows > 10_000 && printed.contains("complete rows; make room"),
            "{printed}"
        );
        assert_eq!(readable(&unfinished_file(&part), format), rows);
        assert!(!part.exists());
        assert_eq!(finish(start(&many(), &part, &["--resume"])).0, Some(0));
        assert!(fs::read(&part).unwrap() == *whole, "{format}");
    }
}

#[test]
fn diverging_drives_are_reported_with_advice() {
    let printed = longdrive(&[
        "sweep",
        "--set",
        "flight.step=2s",
        "--over",
        "club.loft=5deg..15deg:3",
    ]);
    assert_eq!(printed.status, 1, "{}", printed.err);
    let sentence = printed.err.replace("\n  ", " ");
    assert!(
        sentence.contains("3 diverged; simulate one of the diverged drives to see what to change"),
        "{sentence}"
    );
}

#[test]
fn a_full_device_and_a_closed_pipe() {
    let rows = [
        "sweep",
        "--set",
        "flight.step=1s",
        "--over",
        "club.loft=5deg..15deg:20000",
    ];
    if Path::new("/dev/full").exists() {
        let printed = longdrive(&[&rows[..], &["-o", "/dev/full", "--format", "csv"]].concat());
        assert_eq!(printed.status, 2);
        assert!(
            printed
                .err
                .contains("cannot write the answer: the disk is full; written before: "),
            "{}",
            printed.err
        );
        assert!(!Path::new("/dev/full.resume").exists());
    }
    let mut program = program::command();
    let mut child = program
        .args(rows)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut line = String::new();
    BufReader::new(child.stdout.take().unwrap())
        .read_line(&mut line)
        .unwrap();
    assert_eq!(line, "club.loft [rad],status,carry [m]\n");
    let output = child.wait_with_output().unwrap();
    assert_eq!(
        (
            output.status.code(),
            String::from_utf8(output.stderr).unwrap().as_str()
        ),
        (Some(0), "")
    );
}

#[test]
fn a_pipe_that_is_closed_before_the_first_row_is_no_failure() {
    let shots = concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/shots.csv");
    for args in [
        &["fly", shots, "-q"][..],
        &["sweep", "--over", "club.loft=5deg..15deg:100", "-q"],
    ] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let mut program = program::command();
        let child = program
            .args(args)
            .stdout(writer)
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let (status, printed) = finish(child);
        assert!(
            status == Some(0) && !printed.contains("error"),
            "{args:?}: {printed}"
        );
    }
}

#[test]
fn of_two_sweeps_at_once_into_one_file_one_is_refused_and_the_other_is_whole() {
    let folder = tempfile::tempdir().unwrap();
    let over = ["sweep", "--over", "club.loft=5deg..15deg:3000", "-q"];
    let questions = [
        over.to_vec(),
        [&over[..], &["--outcomes", "carry,spin"]].concat(),
    ];
    let whole = |question: &Vec<&str>, name: &str| {
        let path = folder.path().join(name);
        assert_eq!(finish(start(question, &path, &[])).0, Some(0));
        fs::read(&path).unwrap()
    };
    let wholes = [
        whole(&questions[0], "first.csv"),
        whole(&questions[1], "second.csv"),
    ];
    for round in 0..8 {
        let file = folder.path().join(format!("{round}.csv"));
        let sweeps = questions
            .each_ref()
            .map(|question| start(question, &file, &[]));
        let [first, second] = sweeps.map(finish);
        let (winner, (_, printed)) = if first.0 == Some(0) {
            (0, second.clone())
        } else {
            (1, first.clone())
        };
        assert_eq!(
            [first.0, second.0]
                .iter()
                .filter(|status| **status == Some(2))
                .count(),
            1,
            "{first:?} {second:?}"
        );
        // the second process finds the first one at work, or its finished file
        assert!(
            printed.contains("another sweep is writing it") || printed.contains("already exists"),
            "{printed}"
        );
        assert!(fs::read(&file).unwrap() == wholes[winner]);
        assert!(!unfinished_file(&file).exists() && !journal(&file).exists());
    }
}

#[test]
fn a_file_that_is_made_while_a_sweep_runs_stays_and_so_do_the_rows() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("rows.csv");
    let mut child = start(&many(), &file, &[]);
    wait_until(&mut child, || unfinished_file(&file).exists());
    fs::write(&file, "theirs").unwrap();
    // a later sweep reports the running one
    let (status, printed) = finish(start(
        &["sweep", "--over", "club.loft=5deg..15deg:3"],
        &file,
        &["--overwrite"],
    ));
    assert!(
        status == Some(2) && printed.contains("another sweep is writing it"),
        "{printed}"
    );
    let (status, printed) = finish(child);
    assert_eq!(status, Some(2), "{printed}");
    assert!(
        printed.contains("move the other file away, then repeat the same command with --resume"),
        "{printed}"
    );
    let (status, printed) = finish(start(&many(), &file, &["--resume"]));
    assert!(
        status == Some(2) && printed.contains("was begun without --overwrite"),
        "{printed}"
    );
    assert_eq!(fs::read_to_string(&file).unwrap(), "theirs");
    fs::remove_file(&file).unwrap();
    let other: Vec<_> = many()
        .into_iter()
        .map(|word| if word == "all" { "carry" } else { word })
        .collect();
    let (status, printed) = finish(start(&other, &file, &["--resume"]));
    assert!(
        status == Some(2) && printed.contains("(different outcomes)"),
        "{printed}"
    );
    assert_eq!(finish(start(&many(), &file, &["--resume"])).0, Some(0));
    assert!(fs::read(&file).unwrap() == Uninterrupted::of_many("csv").bytes);
}

#[test]
fn a_batch_without_room_is_refused_with_its_size() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("grid.csv");
    let rows = [
        "sweep",
        "--over",
        "club.loft=5deg..15deg:1000001",
        "--over",
        "swing.path=-5deg..5deg:1000001",
    ];
    let printed = longdrive(&[&rows[..], &["-o", file.to_str().unwrap()]].concat());
    assert_eq!(printed.status, 2);
    for words in [
        "1000002000001 drives would take ",
        " TB and about ",
        "that are free in",
        "--sample",
    ] {
        assert!(printed.err.contains(words), "{words}: {}", printed.err);
    }
    let printed = longdrive(&[
        "sweep",
        "--over",
        "club.loft=5deg..15deg:1001",
        "--max-size",
        "10kB",
    ]);
    assert_eq!(printed.status, 2);
    assert!(
        printed.err.contains("more than --max-size 10kB"),
        "{}",
        printed.err
    );
    assert_eq!(
        fs::read_dir(folder.path()).unwrap().count(),
        0,
        "nothing was begun"
    );
}

/// In the file of a grid, the values of the swept parameters repeat from row to row. In the file of
/// a sample they do not.
#[cfg(feature = "full")]
#[test]
fn measured_size_of_a_parquet_file_of_a_sample_is_near_the_estimate() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("sample.parquet");
    let sweep = [
        "sweep",
        "--over=club.loft=5deg..15deg",
        "--over=swing.path=-5deg..5deg",
        "--over=swing.speed=90mph..110mph",
        "--sample=20000",
        "--outcomes=carry",
        "-o",
        file.to_str().unwrap(),
    ];
    let printed = longdrive(&[&sweep[..], &["--max-size=1kB"]].concat());
    assert_eq!(printed.status, 2, "{}", printed.err);
    let message = printed.err.replace("\n  ", " ");
    let after = message.split("would take ").nth(1).unwrap();
    let estimate: f64 = after.split(" kB").next().unwrap().parse().unwrap();
    assert_eq!(longdrive(&sweep).status, 0);
    let measured = fs::metadata(&file).unwrap().len() as f64 / 1000.0;
    assert!(
        (0.8..1.25).contains(&(measured / estimate)),
        "{measured} kB measured, {estimate} kB estimated"
    );
}

#[test]
fn same_table_and_sample_on_the_command_line() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    fs::write(
        file("points.csv"),
        "club.loft [deg],swing.speed [mph]\n10,110\n-20,100\n",
    )
    .unwrap();
    let out = file("out.jsonl");
    let (status, summary) = json(&[
        "sweep",
        "--own-step",
        "--points",
        &file("points.csv"),
        "-o",
        &out,
        "--gradient",
    ]);
    assert_eq!(
        (status, &summary["rows"], &summary["written"]),
        (0, &2.into(), &2.into())
    );
    assert_eq!(
        (
            &summary["statuses"]["landed"],
            &summary["statuses"]["no-flight"]
        ),
        (&1.into(), &1.into())
    );
    let text = fs::read_to_string(&out).unwrap();
    let rows: Vec<serde_json::Value> = text
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    let at = ["--set", "club.loft=10deg", "--set", "swing.speed=110mph"];
    let (_, drive) = json(&[&["gradient", "--wrt", "club.loft,swing.speed"], &at[..]].concat());
    let drive = &drive["outcomes"][0];
    // drives in lanes and single drives round differently
    for (ours, theirs) in [
        (&rows[0]["carry"], &drive["value"]),
        (
            &rows[0]["d_carry/d_swing.speed"],
            &drive["gradient"]["swing.speed"],
        ),
    ] {
        let (ours, theirs) = (ours.as_f64().unwrap(), theirs.as_f64().unwrap());
        assert!((ours / theirs - 1.0).abs() < 1e-12, "{ours} {theirs}");
    }
    assert!(rows[1]["carry"].is_null() && rows[1]["status"] == "no-flight");

    // rows on standard output are counted on standard error
    let printed = longdrive(&["sweep", "--own-step", "--points", &file("points.csv")]);
    assert!(
        printed.status == 0 && printed.err.ends_with("2 drives: 1 landed, 1 no-flight\n"),
        "{}",
        printed.err
    );

    let sample = [
        "sweep",
        "--sample",
        "8",
        "--over",
        "club.loft=5deg..15deg",
        "--wrt",
        "air.density",
    ];
    let printed = longdrive(&sample);
    assert_eq!(
        (printed.status, printed.out.lines().count()),
        (0, 9),
        "{}",
        printed.err
    );
    assert!(
        !printed.err.contains("8 landed"),
        "all landed: {}",
        printed.err
    );
    assert!(
        printed
            .out
            .starts_with("club.loft [rad],status,carry [m],d_carry/d_air.density [m/(kg/m^3)]\n")
    );
    assert_eq!(
        printed.out,
        longdrive(&[&sample[..], &["--threads", "1"]].concat()).out
    );
    assert_ne!(
        printed.out,
        longdrive(&[&sample[..], &["--seed", "1"]].concat()).out
    );
}

#[test]
fn bad_input_to_a_sweep_is_status_2_with_advice() {
    let over = ["--over", "club.loft=5deg..15deg:3"];
    let with = |more: &[&'static str]| [&over[..], more].concat();
    for (args, says) in [
        (vec![], "--over club.loft=5deg..15deg:101"),
        (
            vec!["--over", "club.loft=15deg..5deg:3"],
            "the range is reversed",
        ),
        (
            vec!["--over", "club.loft=5deg..15deg:0"],
            "the number of values must be at least 1",
        ),
        (
            vec!["--over", "club.loft=5deg..15deg"],
            "the number of values is missing",
        ),
        (
            vec!["--over", "club.lofft=5deg..15deg:3"],
            "did you mean 'club.loft'?",
        ),
        (with(&over), "club.loft: it is given twice"),
        (with(&["--outcomes", "cary"]), "did you mean 'carry'?"),
        (with(&["--outcomes", ","]), "name at least one outcome"),
        (
            with(&["--wrt", "swing.sped"]),
            "did you mean 'swing.speed'?",
        ),
        (
            with(&["-o", "grid.xlsx"]),
            "must end in .csv, .jsonl or .parquet",
        ),
        (
            with(&["-o", "grid"]),
            "must end in .csv, .jsonl or .parquet",
        ),
        (with(&["-o", "/nowhere/at/all.csv"]), "cannot be written"),
        (with(&["-o", "src", "--format", "csv"]), "it is a folder"),
        (
            with(&["-o", "Cargo.toml", "--format", "csv"]),
            "it already exists; use --overwrite to replace it",
        ),
        (
            with(&["-o", "Cargo.toml", "--format", "csv", "--resume"]),
            "nothing to resume, because Cargo.toml.resume does not exist",
        ),
        (with(&["--resume"]), "only a file can be resumed"),
        (with(&["--max-size", "much"]), "write a size like"),
        (with(&["--sample", "0"]), "--sample"),
        (
            with(&["--sample", "5"]),
            "--sample says how many points there are",
        ),
        (with(&["--points", "points.csv"]), "--points"),
        (
            vec!["--points", "points.csv"],
            "points.csv: it cannot be read",
        ),
    ] {
        let printed = longdrive(&[&["sweep"], args.as_slice()].concat());
        assert_eq!(
            (printed.status, printed.out.as_str()),
            (2, ""),
            "{args:?}: {}",
            printed.err
        );
        assert!(printed.err.contains(says), "{args:?}: {}", printed.err);
    }
}

#[cfg(feature = "full")]
#[test]
fn parquet_on_standard_output_is_refused() {
    let printed = longdrive(&[
        "sweep",
        "--over",
        "club.loft=5deg..15deg:3",
        "--format",
        "parquet",
    ]);
    assert_eq!((printed.status, printed.out.as_str()), (2, ""));
    assert!(
        printed.err.contains("Parquet needs a file"),
        "{}",
        printed.err
    );
}

#[test]
fn a_sweep_without_any_answer_says_so_with_status_one() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("none.csv");
    let command = [
        "sweep",
        "--over",
        "club.loft=-40deg..-30deg:3",
        "-o",
        file.to_str().unwrap(),
        "--overwrite",
    ];
    let printed = longdrive(&command);
    let sentence = "no drive has the requested outcome: 3 drives: 3 no-flight";
    assert!(
        printed.status == 1 && printed.err.contains(sentence),
        "{} {}",
        printed.status,
        printed.err
    );
    assert_eq!(
        fs::read_to_string(&file).unwrap().lines().count(),
        4,
        "the rows exist and have reasons"
    );
    let (status, answer) = json(&command);
    assert_eq!(
        (status, &answer["status"], &answer["statuses"]["no-flight"]),
        (1, &"no-answer".into(), &3.into())
    );
    assert!(
        answer["message"].as_str().unwrap().contains(sentence),
        "{answer}"
    );
    // the ball speed exists though the ball does not fly, and one drive that lands is an answer
    assert_eq!(
        longdrive(&[&command[..], &["--outcomes", "ball_speed"]].concat()).status,
        0
    );
    let some = ["sweep", "--over", "club.loft=-40deg..10deg:2"];
    assert_eq!(longdrive(&some).status, 0);
}

/// A tolerance holds in every row of a table, also in rows far from the setup. The reference is
/// `dp8` in steps of 20 ms.
#[test]
fn same_rows_of_a_table_in_shorter_steps_within_the_tolerance() {
    let carries = |more: &[&str]| {
        let requested = [
            "sweep",
            "--points",
            "examples/launches.csv",
            "--outcomes",
            "carry",
        ];
        let printed = longdrive(&[&requested[..], more].concat());
        assert_eq!(printed.status, 0, "{}", printed.err);
        let rows: Vec<f64> = printed
            .out
            .lines()
            .skip(1)
            .map(|row| row.rsplit(',').next().unwrap().parse().unwrap())
            .collect();
        (rows, printed.err)
    };
    let (exact, _) = carries(&["--set", "flight.method=dp8", "--set", "flight.step=0.02s"]);
    assert!(
        exact.len() == 6 && exact.iter().all(|carry| *carry > 100.0),
        "{exact:?}"
    );
    for (text, tolerance) in [("1m", 1.0), ("1cm", 1e-2), ("1mm", 1e-3), ("1um", 1e-6)] {
        let (rows, sentence) = carries(&[&format!("--tolerance={text}")]);
        assert!(
            sentence.contains("in the 81"),
            "own, 16 corners, 64 within: {sentence}"
        );
        for (carry, exact) in rows.iter().zip(&exact) {
            assert!(
                (carry - exact).abs() <= tolerance,
                "{carry} beside {exact}, within {text}: {sentence}"
            );
        }
    }
}
