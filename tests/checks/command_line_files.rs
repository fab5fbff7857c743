//! Files: existing files are replaced only on request, no input is an output, and every written
//! file is complete.

use crate::command_line::{json, longdrive, wait_until};
use crate::program;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::Stdio;

const SHOTS: &str =
    "club.loft [deg],swing.speed [mph],carry [yd]\n9,100,220\n10,105,235\n11,110,250\n";
const POINTS: &str = "club.loft [deg],swing.speed [mph]\n9,100\n10,105\n";

/// Every file of a folder, with its bytes.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let read = |entry: std::io::Result<fs::DirEntry>| {
        let entry = entry.unwrap();
        let bytes = if entry.path().is_dir() {
            vec![]
        } else {
            fs::read(entry.path()).unwrap()
        };
        (entry.file_name().into_string().unwrap(), bytes)
    };
    fs::read_dir(folder).unwrap().map(read).collect()
}

/// A folder with input files, and a function that returns the path of a name in this folder.
fn folder() -> (tempfile::TempDir, impl Fn(&str) -> String) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("shots.csv"), SHOTS).unwrap();
    fs::write(folder.path().join("points.csv"), POINTS).unwrap();
    fs::write(folder.path().join("mine.toml"), "preset = 'mae494'\n").unwrap();
    let path = folder.path().to_owned();
    let name = move |name: &str| path.join(name).display().to_string();
    (folder, name)
}

#[test]
fn no_command_replaces_its_own_input_even_with_overwrite() {
    let (folder, name) = folder();
    #[cfg(unix)]
    for (target, link) in [
        ("points.csv", "link.csv"),
        ("shots.csv", "link.toml"),
        ("mine.toml", "mine.svg"),
    ] {
        std::os::unix::fs::symlink(name(target), name(link)).unwrap();
    }
    let (swings, played, law) = (name("swings.toml"), name("played.csv"), name("law.csv"));
    fs::write(
        &swings,
        "[distributions]\nswing.speed = \"normal(97 mph, 2 mph)\"\n",
    )
    .unwrap();
    fs::write(
        &played,
        "swing.speed [mph],swing.face_angle [deg]\n95,1\n97,-1\n98,0\n",
    )
    .unwrap();
    fs::write(&law, "speed [mph],cd,cl\n100,0.25,0.15\n150,0.24,0.16\n").unwrap();
    let own_law = format!("aero.table={law}");
    let goals = ["--maximize", "mean(carry)", "--minimize", "std(carry)"];
    let before = files(folder.path());
    let (points, shots, mine) = (name("points.csv"), name("shots.csv"), name("mine.toml"));
    let (link, link_toml, picture) = (name("link.csv"), name("link.toml"), name("mine.svg"));
    let calibrate = ["calibrate", &shots, "--fit", "aero.cd0"];
    for args in [
        vec!["sweep", "--points", &points, "-o", &points],
        #[cfg(unix)]
        vec!["sweep", "--points", &points, "-o", &link],
        #[cfg(unix)]
        vec!["sweep", "--points", &link, "-o", &points],
        vec![
            "sweep",
            &mine,
            "--over",
            "club.loft=5deg..15deg:3",
            "--format",
            "csv",
            "-o",
            &mine,
        ],
        [&calibrate[..], &["-o", &shots]].concat(),
        vec!["optimize", "--swings", &swings, "-o", &swings],
        vec!["design", "--swings", &swings, "-o", &swings],
        vec!["robust", "--swings", &swings, "-o", &swings],
        [
            &["plot", "pareto", "--swings", &played][..],
            &goals,
            &["-o", &played],
        ]
        .concat(),
        vec!["validate", "--set", &own_law, "-o", &law],
        #[cfg(unix)]
        [&calibrate[..], &["-o", &link_toml]].concat(),
        #[cfg(unix)]
        vec!["plot", "trajectory", &mine, "-o", &picture],
    ] {
        let printed = longdrive(&[&args[..], &["--overwrite"]].concat());
        assert_eq!(
            (printed.status, printed.out.as_str()),
            (2, ""),
            "{args:?}: {}",
            printed.err
        );
        assert!(
            printed
                .err
                .contains("it is also an input or another output of this command"),
            "{args:?}: {}",
            printed.err
        );
        assert_eq!(files(folder.path()), before, "{args:?}");
    }
}

#[test]
fn an_existing_file_is_replaced_only_on_request() {
    let (folder, name) = folder();
    for file in [
        "theirs.svg",
        "theirs.toml",
        "theirs.csv",
        "index.html",
        "report.md",
    ] {
        fs::write(folder.path().join(file), "not ours").unwrap();
    }
    let (shots, here) = (name("shots.csv"), folder.path().display().to_string());
    let (svg, toml, csv) = (name("theirs.svg"), name("theirs.toml"), name("theirs.csv"));
    let calibrate = ["calibrate", &shots, "--fit", "aero.cd0"];
    for (args, written) in [
        (vec!["plot", "trajectory", "-o", &svg], "theirs.svg"),
        (vec!["plot", "trajectory", "-o", &csv], "theirs.csv"),
        (
            vec!["sweep", "--over", "club.loft=5deg..15deg:3", "-o", &csv],
            "theirs.csv",
        ),
        ([&calibrate[..], &["-o", &toml]].concat(), "theirs.toml"),
        ([&calibrate[..], &["--plot", &here]].concat(), "report.md"),
    ] {
        let before = files(folder.path());
        let printed = longdrive(&args);
        assert_eq!(
            (printed.status, printed.out.as_str()),
            (2, ""),
            "{args:?}: {}",
            printed.err
        );
        assert!(
            printed
                .err
                .contains("it already exists; use --overwrite to replace it"),
            "{args:?}: {}",
            printed.err
        );
        assert_eq!(files(folder.path()), before, "{args:?}");
        let printed = longdrive(&[&args[..], &["--overwrite"]].concat());
        assert_ne!(printed.status, 2, "{args:?}: {}", printed.err);
        assert_ne!(files(folder.path())[written], before[written], "{args:?}");
        fs::write(folder.path().join(written), "not ours").unwrap();
    }
    let before = files(folder.path());
    for args in [
        vec!["report", "-o", &here],
        vec!["reproduce", "mae494", "-o", &here],
    ] {
        let printed = longdrive(&args);
        assert_eq!(printed.status, 2, "{args:?}: {}", printed.err);
        assert!(
            printed
                .err
                .contains("it already exists; use --overwrite to replace it"),
            "{args:?}: {}",
            printed.err
        );
        assert_eq!(files(folder.path()), before, "{args:?}");
    }
}

#[test]
fn an_unwritable_path_is_reported_before_the_work() {
    let (_folder, name) = folder();
    let shots = name("shots.csv");
    let calibrate = ["calibrate", &shots, "--fit", "aero.cd0"];
    for args in [
        [&calibrate[..], &["-o", "/nowhere/at/all.toml"]].concat(),
        [&calibrate[..], &["--plot", "/dev/null/folder"]].concat(),
        vec!["plot", "contour", "-o", "/nowhere/at/all.svg"],
        vec!["report", "-o", "/dev/null/folder"],
        vec!["reproduce", "mae494", "-o", "/dev/null/folder"],
        vec![
            "sweep",
            "--over",
            "club.loft=5deg..15deg:3",
            "-o",
            "/nowhere/at/all.csv",
        ],
    ] {
        let printed = longdrive(&args);
        assert_eq!(
            (printed.status, printed.out.as_str()),
            (2, ""),
            "{args:?}: {}",
            printed.err
        );
        assert!(
            printed.err.contains("it cannot be written"),
            "{args:?}: {}",
            printed.err
        );
        // the error is the only line, so no iteration came before it
        assert_eq!(printed.err.lines().count(), 1, "{args:?}: {}", printed.err);
    }
}

#[test]
fn two_outputs_of_one_command_are_kept_apart() {
    let (folder, name) = folder();
    fs::create_dir(folder.path().join("plots")).unwrap();
    let (shots, plots, page, kept) = (
        name("shots.csv"),
        name("plots"),
        name("plots/index.html"),
        name("kept.json"),
    );
    for args in [
        vec![
            "calibrate",
            &shots,
            "--fit",
            "aero.cd0",
            "--plot",
            &plots,
            "-o",
            &page,
        ],
        vec!["optimize", "--checkpoint", &kept, "-o", &kept],
    ] {
        let before = files(folder.path());
        let printed = longdrive(&args);
        assert_eq!(
            (printed.status, printed.out.as_str()),
            (2, ""),
            "{args:?}: {}",
            printed.err
        );
        assert!(
            printed.err.contains("another output of this command"),
            "{args:?}: {}",
            printed.err
        );
        assert_eq!(files(folder.path()), before, "{args:?}");
    }
}

#[test]
fn foreign_files_beside_a_sweep_are_not_changed() {
    let (folder, name) = folder();
    let out = name("out.csv");
    for beside in ["out.csv.part", "out.csv.resume"] {
        fs::write(folder.path().join(beside), "mine").unwrap();
        for more in [&[][..], &["--overwrite"], &["--resume"]] {
            let args = [
                &["sweep", "--over", "club.loft=5deg..15deg:3", "-o", &out],
                more,
            ]
            .concat();
            let printed = longdrive(&args);
            assert_eq!(printed.status, 2, "{beside} {more:?}: {}", printed.err);
            assert!(
                printed.err.contains(beside) && printed.err.contains("move it away"),
                "{beside} {more:?}: {}",
                printed.err
            );
            assert_eq!(
                fs::read_to_string(folder.path().join(beside)).unwrap(),
                "mine"
            );
        }
        fs::remove_file(folder.path().join(beside)).unwrap();
    }
}

#[test]
fn a_whole_file_stays_until_the_one_that_replaces_it_is_whole() {
    let (folder, name) = folder();
    let out = name("out.csv");
    fs::write(&out, "the old one").unwrap();
    // the last row has a cell without a number: the good rows before it do not reach the file
    let bad = format!("{POINTS}ten,100\n");
    fs::write(folder.path().join("bad.csv"), bad).unwrap();
    let printed = longdrive(&[
        "sweep",
        "--points",
        &name("bad.csv"),
        "-o",
        &out,
        "--overwrite",
    ]);
    assert_eq!(printed.status, 2, "{}", printed.err);
    assert_eq!(fs::read_to_string(&out).unwrap(), "the old one");
    let printed = longdrive(&[
        "sweep",
        "--points",
        &name("points.csv"),
        "-o",
        &out,
        "--overwrite",
    ]);
    assert_eq!(printed.status, 0, "{}", printed.err);
    assert_eq!(fs::read_to_string(&out).unwrap().lines().count(), 3);
    assert_eq!(
        files(folder.path())
            .keys()
            .filter(|name| name.starts_with("out.csv"))
            .count(),
        1
    );
}

#[cfg(unix)]
#[test]
fn a_file_that_is_made_while_a_command_runs_stays() {
    let (folder, name) = folder();
    let out = name("out.csv");
    let mut program = program::command();
    program.args(["fly", "-", "-o", &out, "-q"]);
    let mut child = program
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut input = child.stdin.take().unwrap();
    // so many rows that the program reads the column heads before the input ends
    let rows = "150,12,2700\n".repeat(20_000);
    input
        .write_all(
            format!("Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm]\n{rows}").as_bytes(),
        )
        .unwrap();
    // once its temporary file exists, the program has checked that it may write the output
    let is_begun = || {
        files(folder.path())
            .keys()
            .any(|name| name.starts_with(".longdrive-"))
    };
    wait_until(&mut child, is_begun);
    fs::write(&out, "theirs").unwrap();
    drop(input);
    let output = child.wait_with_output().unwrap();
    let printed = String::from_utf8(output.stderr).unwrap();
    assert!(
        output.status.code() == Some(2) && printed.contains("made by another program while"),
        "{printed}"
    );
    assert_eq!(fs::read_to_string(&out).unwrap(), "theirs");
    assert!(!is_begun());
}

#[test]
fn of_two_searches_at_once_with_one_checkpoint_one_is_refused() {
    let (_folder, name) = folder();
    for round in 0..8 {
        let kept = name(&format!("{round}.json"));
        let start = |preset: &str| {
            let mut program = program::command();
            program.args(["optimize", preset, "--checkpoint", &kept, "-q"]);
            program
                .stdout(Stdio::null())
                .stderr(Stdio::piped())
                .spawn()
                .unwrap()
        };
        let outputs = ["mae494", "modern-driver"]
            .map(start)
            .map(|child| child.wait_with_output().unwrap());
        let refused: Vec<_> = outputs
            .iter()
            .filter(|output| output.status.code() == Some(2))
            .collect();
        assert_eq!(refused.len(), 1, "{outputs:?}");
        let printed = String::from_utf8_lossy(&refused[0].stderr);
        assert!(
            printed.contains("another search has just created this file")
                || printed.contains("its setup, search or options differ"),
            "{printed}"
        );
    }
}

#[test]
fn a_file_through_a_link_is_replaced_and_keeps_its_permissions() {
    use std::os::unix::fs::PermissionsExt;
    let (folder, name) = folder();
    let (real, link) = (name("real.svg"), name("link.svg"));
    fs::write(&real, "old").unwrap();
    fs::set_permissions(&real, fs::Permissions::from_mode(0o640)).unwrap();
    std::os::unix::fs::symlink(&real, &link).unwrap();
    let printed = longdrive(&["plot", "trajectory", "-o", &link, "--overwrite"]);
    assert_eq!(printed.status, 0, "{}", printed.err);
    assert!(folder.path().join("link.svg").is_symlink());
    assert!(fs::read_to_string(&real).unwrap().starts_with("<svg"));
    assert_eq!(
        fs::metadata(&real).unwrap().permissions().mode() & 0o777,
        0o640
    );
}

/// A misspelt path is reported, and no command creates the folder of an output.
#[test]
fn the_folder_that_an_output_is_in_must_exist() {
    let (folder, name) = folder();
    let before = files(folder.path());
    let (shots, output) = (name("shots.csv"), name("missing/a.csv"));
    for args in [
        vec!["report", "-o", &output],
        vec!["reproduce", "winfield-tan", "-o", &output],
        vec!["calibrate", &shots, "--fit", "aero.cd0", "--plot", &output],
        vec!["calibrate", &shots, "--fit", "aero.cd0", "-o", &output],
        vec!["man", "-o", &output],
        vec!["plot", "trajectory", "-o", &output],
        vec!["optimize", "-o", &output],
        vec!["sweep", "--over", "club.loft=5deg..15deg:3", "-o", &output],
    ] {
        let printed = longdrive(&args);
        let text = format!("there is no folder '{}'", name("missing"));
        assert!(
            printed.status == 2 && printed.err.contains(&text),
            "{args:?}: {}",
            printed.err
        );
        assert_eq!(files(folder.path()), before, "{args:?}");
    }
    // the folder that the option names is created
    assert_eq!(longdrive(&["man", "-o", &name("pages")]).status, 0);
}

#[test]
fn an_unwritable_path_is_reported_in_plain_words() {
    let (folder, name) = folder();
    let (shots, points, mine) = (name("shots.csv"), name("points.csv"), name("mine.toml"));
    let nowhere = "it cannot be written: there is no folder '/nowhere'";
    let sweep = [
        "sweep",
        "--over",
        "club.loft=5deg..15deg:3",
        "--format",
        "csv",
    ];
    for (args, words) in [
        (vec!["optimize", "--checkpoint", "/nowhere/c.json"], nowhere),
        #[cfg(target_os = "linux")]
        (
            vec!["optimize", "--checkpoint", "/proc/c.json"],
            "it cannot be written (no file can be made there)",
        ),
        #[cfg(target_os = "linux")]
        (
            vec!["plot", "trajectory", "-o", "/proc/x.svg"],
            "it cannot be written (no file can be made there)",
        ),
        (
            vec!["optimize", &mine, "--checkpoint", &mine],
            "it is not a checkpoint of a search",
        ),
        (
            vec!["optimize", "--checkpoint", &shots],
            "it is not a checkpoint of a search",
        ),
        (
            vec!["optimize", "-o", "-"],
            "does not write to standard output; name a file, as in -o mine.toml",
        ),
        (
            vec!["calibrate", &shots, "--fit", "aero.cd0", "-o", "-"],
            "does not write to standard output; name a file",
        ),
        (
            vec!["report", "-o", "-"],
            "does not write to standard output; name a folder",
        ),
        (
            [&sweep[..], &["-o", "/dev/stdout"]].concat(),
            "it is standard output; write -o -",
        ),
        (
            vec!["fly", &shots, "-o", "/dev/stdout"],
            "it is standard output; write -o -",
        ),
        (
            [&sweep[..], &["--overwrite"]].concat(),
            "--overwrite replaces a file, and the rows go to standard output",
        ),
        (
            vec!["calibrate", &shots, "--fit", "aero.cd0", "--overwrite"],
            "--output <FILE>|--plot <DIR>",
        ),
        (
            vec!["man", "optimize", "--overwrite"],
            "cannot be used with '--overwrite'",
        ),
        (
            vec!["sweep", "--points", &points, "--seed", "7"],
            "'--points <FILE>' cannot be used with '--seed <SEED>'",
        ),
    ] {
        let before = files(folder.path());
        let printed = longdrive(&args);
        assert_eq!(
            (printed.status, printed.out.as_str()),
            (2, ""),
            "{args:?}: {}",
            printed.err
        );
        assert!(printed.err.contains(words), "{args:?}: {}", printed.err);
        for foreign in ["os error", "entity not found", "expected value", "at path"] {
            assert!(!printed.err.contains(foreign), "{args:?}: {}", printed.err);
        }
        assert_eq!(files(folder.path()), before, "{args:?}");
    }
    assert!(!Path::new("-").exists());
}

#[test]
fn values_without_a_finished_fit_are_not_written_as_fitted() {
    let (_folder, name) = folder();
    let (shots, fitted) = (name("shots.csv"), name("fitted.toml"));
    let args = ["calibrate", &shots, "--fit", "aero.cd0", "-o", &fitted];
    let (status, stopped) = json(&[&args[..], &["--max-iterations", "0"]].concat());
    assert_eq!(
        (status, &stopped["status"], &stopped["file"]),
        (1, &"iteration-limit".into(), &Value::Null)
    );
    let warnings = stopped["warnings"].to_string();
    assert!(
        warnings.contains("fitted.toml is not written: the fit ended before it came to a minimum"),
        "{warnings}"
    );
    assert!(!Path::new(&fitted).exists());
    assert_eq!(json(&args).1["file"], Value::from(fitted.as_str()));
    assert!(Path::new(&fitted).exists());
}

#[test]
fn no_setup_file_has_the_extension_of_a_table() {
    let (folder, name) = folder();
    for extension in [
        "arrow", "arrows", "csv", "feather", "jsonl", "ndjson", "parquet",
    ] {
        let file = name(&format!("best.{extension}"));
        let written = longdrive(&["optimize", "-o", &file]);
        let says = format!(".{extension} is the extension of another format; use .toml");
        assert!(
            written.status == 2 && written.err.contains(&says),
            "{extension}: {}",
            written.err
        );
        fs::write(&file, "").unwrap();
        let read = longdrive(&["simulate", &file]);
        assert!(
            read.status == 2 && read.err.contains("a table is no setup"),
            "{extension}: {}",
            read.err
        );
    }
    assert!(!folder.path().join("best.toml").exists());
}

#[test]
fn messages_and_answers_name_a_replaced_file_as_it_was_given() {
    let (folder, _) = folder();
    let shown = |name: &str| format!("{}/./{name}", folder.path().display());
    let (setup, front, swings) = (shown("mine.toml"), shown("front.csv"), shown("swings.csv"));
    let (shots, rows) = (shown("launches.csv"), shown("rows.csv"));
    let points = "swing.speed=100mph..110mph:3";
    let launch = "ball_speed [mph],launch_angle [deg],spin [rpm],spin_axis [deg]\n";
    fs::write(&shots, format!("{launch}150,12,2600,0\n155,11,2500,1\n")).unwrap();
    fs::write(&front, "").unwrap();
    fs::write(&swings, "").unwrap();
    let goals = ["--maximize", "carry", "--minimize", "apex_height"];
    let front_args = [&["pareto", "--points", "2", "-o", &front][..], &goals].concat();
    fs::write(&rows, "").unwrap();
    let resolved = folder.path().canonicalize().unwrap();
    let resolved = format!("{}{}", resolved.display(), std::path::MAIN_SEPARATOR);
    for args in [
        vec!["optimize", "-o", &setup],
        front_args,
        vec!["fly", &shots, "-o", &rows],
        vec!["sweep", "--over", points, "-o", &rows],
        vec![
            "delivery", "--shots", &shots, "--swings", &swings, "-o", &setup,
        ],
    ] {
        let args = [&args[..], &["--overwrite"]].concat();
        let printed = longdrive(&args);
        let messages = printed.out + &printed.err;
        let others = messages.replace("/./", "");
        assert!(
            printed.status < 2 && others != messages && !others.contains(&resolved),
            "{args:?}: {messages}"
        );
    }
    let (_, answer) = json(&["optimize", "-o", &setup, "--overwrite"]);
    assert_eq!(answer["file"], setup);
}
