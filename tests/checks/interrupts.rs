//! Ctrl-C, under one rule for every command.

#![cfg(unix)]

use crate::command_line::Said;
use crate::schema::faults;
use longdrive::optimize::Follow;
use longdrive::parameters::Preset;
use longdrive::report::{optima_text, optimum_toml};
use longdrive::study::{Search, optima};
use longdrive::units::System;
use longdrive::{Result, Setup};
use serde_json::Value;
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// Computed before the interruption, in hundredths of a second: enough that work is under way.
const UNDER_WAY: u64 = 50;

/// What a command says that is interrupted after a while.
fn interrupted(args: &[&str]) -> Said {
    let mut program = Command::new(assert_cmd::cargo::cargo_bin!("longdrive"));
    let child = program.args(args).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    wait_for_work(child.id());
    let asked = Instant::now();
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    assert!(asked.elapsed() < Duration::from_secs(20), "{args:?}: {:?}", asked.elapsed());
    let text = |bytes| String::from_utf8(bytes).unwrap();
    let (out, err) = (text(output.stdout), text(output.stderr));
    Said { status: output.status.code().unwrap_or_else(|| panic!("{args:?} died: {err}")), out, err }
}

/// Waits until a program has computed for so long, however busy the machine is; where no /proc tells that, for as long.
pub fn wait_for_work(id: u32) {
    let begun = Instant::now();
    while begun.elapsed() < Duration::from_secs(20) {
        std::thread::sleep(Duration::from_millis(20));
        let Ok(stat) = std::fs::read_to_string(format!("/proc/{id}/stat")) else {
            return std::thread::sleep(Duration::from_millis(10 * UNDER_WAY));
        };
        // behind the name: the state, ten numbers, and the time in the program and in the system, in hundredths of a second
        let fields: Vec<&str> = stat.rsplit(')').next().unwrap().split_whitespace().collect();
        let used: u64 = fields[11..13].iter().map(|ticks| ticks.parse::<u64>().unwrap()).sum();
        if fields[0] == "Z" || used >= UNDER_WAY {
            return;
        }
    }
}

/// The same in JSON, as docs/schema describes it.
fn interrupted_json(args: &[&str]) -> Value {
    let said = interrupted(&[args, &["--json"]].concat());
    let answer: Value = serde_json::from_str(&said.out).unwrap_or_else(|e| panic!("{e}: {} {}", said.out, said.err));
    let faults = faults(args[0], &answer);
    assert!(faults.is_empty(), "{args:?}: {faults:#?} in {answer:#}");
    assert_eq!((said.status, answer["status"].as_str()), (1, Some("interrupted")), "{args:?}: {answer:#} {}", said.err);
    answer
}

#[test]
fn work_without_a_part_of_an_answer_ends_with_nothing_printed_or_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (page, plot, study) = (path("page"), path("map.svg"), path("study"));
    let slow = ["--set", "flight.step=0.02ms"];
    for args in [
        vec!["uncertainty", "--samples", "1000000"],
        vec!["sensitivity", "--at-optimum", slow[0], slow[1]],
        vec!["plot", "contour", "-o", &plot, slow[0], slow[1]],
        vec!["report", "-o", &page, slow[0], slow[1]],
        vec!["reproduce", "mae494", "-o", &study],
    ] {
        let message = interrupted_json(&args)["message"].as_str().unwrap().to_owned();
        assert_eq!(message, "interrupted before there was an answer; nothing was printed or written", "{args:?}");
        let left = std::fs::read_dir(folder.path()).unwrap().count();
        assert_eq!(left, 0, "{args:?} left something behind");
    }
    let said = interrupted(&["uncertainty", "-q", "--samples", "1000000"]);
    assert!(said.status == 1 && said.out.is_empty(), "{}", said.out);
    assert!(said.err.contains("error: interrupted before there was an answer"), "{}", said.err);
}

#[test]
fn what_is_done_of_a_certificate_and_of_a_chart_is_told_as_interrupted() {
    let found = interrupted_json(&["verify", "--set", "flight.step=0.05ms"]);
    let rows = found["rows"].as_array().unwrap().len();
    let message = found["message"].as_str().unwrap();
    assert!(message.starts_with(&format!("the rows are complete for {} of ", rows / 2)), "{message}, {rows} rows");
    assert_eq!(found["passed"], false);
    let chart = interrupted_json(&["chart", "--along", "swing.speed=60mph..140mph", "--set", "flight.step=0.1ms"]);
    assert!(chart["ended"].as_str().is_some(), "{chart:#}");
    let goals = ["pareto", "--maximize", "carry", "--minimize", "apex_height", "--points", "1000"];
    let front = interrupted_json(&[&goals[..], &["--set", "flight.step=0.5ms"]].concat());
    assert!(front["points"].as_array().is_some_and(|points| points.len() > 1), "{front:#}");
}

#[test]
fn exact_what_was_stopped_writes_no_fit_lists_no_optimum_and_names_the_file_of_its_rows() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (fitted, rows) = (path("fitted.toml"), path("rows.csv"));
    let shots = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/shots.csv");
    let slow = ["--set", "flight.step=0.01ms"];
    let step = "flight.step=0.1ms";
    let found = interrupted_json(&["calibrate", shots, "--fit", "aero.cd0", "-o", &fitted, "--set", step]);
    assert!(found["file"].is_null() && found["warnings"].to_string().contains("is not written"), "{found:#}");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    let found = interrupted_json(&["sweep", "--over", "club.loft=5deg..15deg:3000000", "-o", &rows]);
    assert_eq!(found["file"].as_str(), Some(&format!("{rows}.part")[..]));
    assert!(std::path::Path::new(found["file"].as_str().unwrap()).exists());
    let said = interrupted(&["optimize", "--starts", "5000", slow[0], slow[1]]);
    assert!(said.out.contains("\nnot listed: 5000 of 5000 searches stopped before the end\n"), "{}", said.out);
    assert!(!said.out.contains(" of 5000  interrupted"), "{}", said.out);
}

/// The best of the searches that ended may have converged: that the others did not end is told beside it.
#[test]
fn a_setup_file_of_the_best_so_far_says_that_searches_were_stopped() -> Result<()> {
    let setup = Setup::default();
    let search = Search::longest_drive(&setup)?;
    let (stop, ended) = (Arc::new(AtomicBool::new(false)), AtomicUsize::new(0));
    let flag = stop.clone();
    let end = move |_: usize, _: &_| flag.store(ended.fetch_add(1, Ordering::Relaxed) >= 3, Ordering::Relaxed);
    let follow = Follow { interrupt: stop, end: Some(Arc::new(end)), ..Follow::default() };
    let found = optima(&setup, &search, 400, &follow)?;
    let (stopped, preset) = (found.stopped(), Preset::named("modern-driver").unwrap());
    assert!(stopped > 0 && found.best()?.status() == "converged", "{stopped}");
    let listed = optima_text(&found, System::Metric);
    assert!(listed.contains(&format!("\nnot listed: {stopped} of 400 searches stopped before the end\n")), "{listed}");
    assert!(!listed.contains("interrupted") && listed.contains("converged"), "{listed}");
    let text = optimum_toml(&found, preset)?;
    let ended = 400 - stopped;
    let line = format!(
        "\n# interrupted: {ended} of 400 searches ended, and {stopped} were stopped before their end; the best so far:\n# converged: "
    );
    assert!(text.contains(&line), "{text}");
    let whole = optimum_toml(&optima(&setup, &search, 4, &Follow::default())?, preset)?;
    assert!(!whole.contains("interrupted") && whole.contains("\n# converged: "), "{whole}");
    Ok(())
}

#[test]
fn shots_that_are_flown_before_are_counted_and_no_file_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let row = |at: usize| format!("{},12,{}\n", 140 + at % 40, 2000 + at % 1000);
    let rows: String = (0..200_000).map(row).collect();
    std::fs::write(path("shots.csv"), format!("ball_speed [mph],launch_angle [deg],backspin [rpm]\n{rows}")).unwrap();
    let found = interrupted_json(&["fly", &path("shots.csv"), "-o", &path("flown.csv"), "--set", "flight.step=2ms"]);
    let flown = found["rows"].as_u64().unwrap();
    assert!((1..200_000).contains(&flown), "{flown}");
    assert_eq!(found["message"], format!("stopped after {flown} rows; {} is not written", path("flown.csv")));
    let left: Vec<_> = std::fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left, ["shots.csv"]);
}

/// An evaluation over so many swings takes seconds: it stops between any two of them.
#[test]
fn searches_over_very_many_swings_are_told_as_interrupted_within_an_evaluation() {
    let swings = ["--scenarios", "50000", "--distribution", "swing.speed=normal(110mph,3mph)"];
    let swings = [&swings[..], &["--distribution", "swing.path=normal(0deg,2deg)"]].concat();
    let goals = ["--maximize", "mean(carry)", "--minimize", "std(lateral)"];
    for args in [vec!["optimize"], vec!["design"], vec!["robust"], [&["pareto"], &goals[..]].concat()] {
        let found = interrupted_json(&[&args[..], &swings].concat());
        assert!(found["message"].as_str().is_some_and(|message| message.contains("stopped")), "{found:#}");
        // a point that was not finished is none
        assert_eq!(found["optimum"].is_object(), found["value"].is_number(), "{found:#}");
    }
}

#[test]
fn exact_same_answer_over_swings_when_ctrl_c_stops_it_within_iterations_again_and_again() {
    let folder = tempfile::tempdir().unwrap();
    let program = |checkpoint: &std::path::Path| {
        let mut program = Command::new(assert_cmd::cargo::cargo_bin!("longdrive"));
        program.args(["optimize", "--json", "--scenarios", "4000", "--distribution", "swing.path=normal(0deg,2deg)"]);
        program.args(["--distribution", "swing.speed=normal(110mph,3mph)", "--vary", "club.loft=4deg..20deg"]);
        program.args(["--vary", "club.bulge_radius=200mm..600mm", "--maximize", "mean(carry) - 0.5*std(lateral)"]);
        program.arg("--checkpoint").arg(checkpoint);
        program
    };
    let alone = program(&folder.path().join("alone.json")).output().unwrap();
    assert!(alone.status.success(), "{}", String::from_utf8_lossy(&alone.stderr));
    let stopped = folder.path().join("stopped.json");
    for wait in [75, 150, 225, 300] {
        let child = program(&stopped).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        std::thread::sleep(Duration::from_millis(wait));
        Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
        let output = child.wait_with_output().unwrap();
        assert!(output.status.code().is_some(), "{}", String::from_utf8_lossy(&output.stderr));
    }
    let resumed = program(&stopped).output().unwrap();
    assert_eq!(String::from_utf8_lossy(&resumed.stdout), String::from_utf8_lossy(&alone.stdout));
}
