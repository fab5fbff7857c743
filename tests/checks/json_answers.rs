//! Answers in JSON: always one object, as in docs/json.md and the schemas of docs/schema.

use crate::command_line::{commands, json, longdrive, number};
use crate::common::close;
use crate::program;
use crate::schema::faults;
use crate::validation::ANSWERED;
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;

/// A table of three drives with the law of the default preset. The carry is rounded to a tenth of a
/// metre.
fn shots() -> String {
    let mut table = "club.loft [deg],carry [m]\n".to_owned();
    for loft in ["9", "11", "13"] {
        let (_, drive) = json(&["simulate", "--set", &format!("club.loft={loft}deg")]);
        table += &format!("{loft},{:.1}\n", number(&drive["flight"]["carry"]));
    }
    table
}

#[test]
fn every_command_answers_with_one_object_that_its_schema_describes() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    fs::write(file("shots.csv"), shots()).unwrap();
    let (shots, picture, page, rows) = (
        file("shots.csv"),
        file("a.svg"),
        file("page"),
        file("rows.jsonl"),
    );
    let flown = file("flown.jsonl");
    // `reproduce`, which takes long, has its own tests
    let mut answered = BTreeSet::from(["reproduce".to_owned()]);
    // `json` checks each answer against its schema
    for (args, ends) in [
        (vec!["simulate"], "landed"),
        (
            vec!["gradient", "--of", "carry,lateral", "--hessian"],
            "done",
        ),
        (
            vec![
                "compare",
                "mae494",
                "winfield-tan",
                "--of",
                "carry,ball_speed",
            ],
            "done",
        ),
        (
            vec![
                "optimize",
                "--starts",
                "3",
                "--subject-to",
                "apex_height <= 35 yd",
            ],
            "converged",
        ),
        (
            vec![
                "optimum-sensitivity",
                "--wrt",
                "gravity",
                "--change",
                "swing.speed=+5mph",
            ],
            "converged",
        ),
        (vec!["design", "--scenarios", "16"], "converged"),
        (
            vec![
                "calibrate",
                &shots,
                "--fit",
                "aero.spin_decay",
                "--folds",
                "3",
            ],
            "converged",
        ),
        (
            vec![
                "delivery",
                "--launch",
                "ball_speed=160mph,launch_angle=11deg,spin=2600rpm,spin_axis=3deg",
            ],
            "done",
        ),
        (
            vec![
                "delivery",
                "--shots",
                concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/shots.csv"),
            ],
            "done",
        ),
        (
            vec!["chart", "--along", "swing.speed=100mph..104mph"],
            "done",
        ),
        (
            vec![
                "pareto",
                "--maximize",
                "carry",
                "--minimize",
                "apex_height",
                "--points",
                "4",
            ],
            "done",
        ),
        (vec!["robust", "--model", "aero.law=ferguson"], "converged"),
        (vec!["plot", "trajectory", "-o", &picture], "done"),
        (
            vec![
                "report",
                "-o",
                &page,
                "--along",
                "swing.speed=100mph..104mph",
            ],
            "done",
        ),
        (
            vec![
                "sweep",
                "--over",
                "club.loft=-30deg..12deg:3",
                "-o",
                &rows,
                "--gradient",
            ],
            "done",
        ),
        (vec!["validate"], "done"),
        (
            vec!["fly", "tests/data/shots/trackman.csv", "-o", &flown],
            "done",
        ),
        (
            vec!["verify", "--of", "carry", "--wrt", "club.loft"],
            "passed",
        ),
        (
            vec!["sensitivity", "--at-optimum", "--of", "carry,backspin"],
            "done",
        ),
        (vec!["uncertainty", "--samples", "20"], "done"),
        (vec!["parameters"], "done"),
        (vec!["presets"], "done"),
        (vec!["presets", "mae494"], "done"),
        (vec!["laws"], "done"),
    ] {
        let (status, answer) = if args == ["validate"] {
            ANSWERED.clone()
        } else {
            json(&args)
        };
        assert_eq!(
            (status, answer["status"].as_str()),
            (0, Some(ends)),
            "{args:?}: {}",
            answer["message"]
        );
        assert_eq!(answer["command"], args[0]);
        answered.insert(args[0].to_owned());
    }
    assert_eq!(answered, commands(), "the commands here, and all commands");
    for (file, schema) in [(rows, "sweep-row"), (flown, "fly-row")] {
        for row in fs::read_to_string(file).unwrap().lines() {
            assert_eq!(
                faults(schema, &serde_json::from_str(row).unwrap()),
                [""; 0],
                "{row}"
            );
        }
    }
}

#[test]
fn no_answer_is_an_object_with_the_reason_and_status_1() {
    let folder = tempfile::tempdir().unwrap();
    let picture = folder.path().join("a.svg").to_str().unwrap().to_owned();
    let page = folder.path().join("page").to_str().unwrap().to_owned();
    let down = ["--set", "swing.attack_angle=-20deg"];
    let contradiction = [
        "--subject-to",
        "apex_height <= 30 m",
        "--subject-to",
        "apex_height >= 31 m",
    ];
    let with = |command: &[&'static str], more: &[&'static str]| [command, more].concat();
    for (args, ends) in [
        (with(&["simulate"], &down), "no-flight"),
        (with(&["gradient"], &down), "no-flight"),
        (
            with(&["gradient", "--of", "ball_speed,carry"], &down),
            "partial",
        ),
        (
            with(&["compare", "mae494", "--set-b", "club.loft=11deg"], &down),
            "no-flight",
        ),
        (
            vec!["compare", "--set-b", down[1], "--of", "ball_speed,carry"],
            "partial",
        ),
        (with(&["optimize"], &contradiction), "infeasible"),
        (with(&["optimum-sensitivity"], &contradiction), "infeasible"),
        (
            vec![
                "design",
                "--scenarios",
                "16",
                "--subject-to",
                "mean(carry) >= 400yd",
            ],
            "infeasible",
        ),
        (
            with(
                &["chart", "--along", "swing.speed=100mph..104mph"],
                &contradiction,
            ),
            "no-answer",
        ),
        (
            with(
                &["pareto", "--maximize", "carry", "--minimize", "lateral"],
                &contradiction,
            ),
            "infeasible",
        ),
        (with(&["robust"], &contradiction), "infeasible"),
        (
            vec!["plot", "trajectory", "-o", &picture, down[0], down[1]],
            "no-flight",
        ),
        (
            vec![
                "report",
                "-o",
                &page,
                down[0],
                down[1],
                "--vary",
                "swing.attack_angle=-40deg..-30deg",
            ],
            "no-flight",
        ),
        (with(&["verify", "--of", "carry"], &down), "no-flight"),
        (with(&["sensitivity"], &down), "no-flight"),
        (
            with(&["sensitivity", "--at-optimum"], &contradiction),
            "infeasible",
        ),
        (
            with(
                &[
                    "uncertainty",
                    "--samples",
                    "20",
                    "--sigma",
                    "club.loft=0.1deg",
                ],
                &down,
            ),
            "no-answer",
        ),
    ] {
        let (status, answer) = json(&args);
        assert_eq!(
            (status, answer["status"].as_str()),
            (1, Some(ends)),
            "{args:?}: {answer}"
        );
        assert!(
            !answer["message"].as_str().unwrap().is_empty(),
            "{args:?}: {answer}"
        );
    }
}

#[test]
fn bad_input_is_an_object_with_the_message_of_standard_error_and_status_2() {
    for (args, command) in [
        (vec!["simulate", "--set", "club.lofft=10deg"], "simulate"),
        (vec!["simulate", "nowhere.toml"], "simulate"),
        (vec!["simulate", "--hessian"], "simulate"),
        (vec!["gradient", "--of", "cary"], "gradient"),
        (vec!["compare"], "compare"),
        (vec!["compare", "--set-b", "club.lofft=10deg"], "compare"),
        (vec!["optimize", "--starts", "0"], "optimize"),
        (
            vec!["optimum-sensitivity", "--loss", "0 yd"],
            "optimum-sensitivity",
        ),
        (vec!["design", "--rules", "mine"], "design"),
        (
            vec!["calibrate", "nowhere.csv", "--fit", "aero.cd0"],
            "calibrate",
        ),
        (vec!["calibrate"], "calibrate"),
        (vec!["delivery"], "delivery"),
        (vec!["chart"], "chart"),
        (vec!["pareto", "--maximize", "carry"], "pareto"),
        (vec!["robust", "--model", "aero.law"], "robust"),
        (vec!["plot", "trajectory", "-o", "a.jpg"], "plot"),
        (vec!["plot", "pie", "-o", "a.svg"], "plot"),
        (vec!["report"], "report"),
        (vec!["sweep"], "sweep"),
        (vec!["sweep", "--over", "club.loft=5deg..15deg:3"], "sweep"),
        (vec!["fly"], "fly"),
        (vec!["fly", "nowhere.csv"], "fly"),
        (vec!["reproduce", "mae495"], "reproduce"),
        (vec!["validate", "lyu"], "validate"),
        (vec!["verify", "--of", "cary"], "verify"),
        (vec!["sensitivity", "--sigma", "swing.speed"], "sensitivity"),
        (vec!["uncertainty", "--samples", "1"], "uncertainty"),
        (vec!["parameters", "mae49"], "parameters"),
        (vec!["presets", "mae49"], "presets"),
        (vec!["laws", "lyu"], "laws"),
    ] {
        let (status, answer) = json(&args);
        assert_eq!(
            (status, &answer["status"], &answer["command"]),
            (2, &"error".into(), &command.into()),
            "{args:?}"
        );
        let messages = longdrive(&[&args[..], &["--json"]].concat());
        let message = answer["message"].as_str().unwrap();
        assert!(
            messages.err.contains(message) && !message.starts_with("error"),
            "{args:?}: {message} in {}",
            messages.err
        );
        assert_eq!(answer.as_object().unwrap().len(), 4);
    }
    let messages = longdrive(&["soar", "--json"]);
    let answer: Value = serde_json::from_str(&messages.out).unwrap();
    assert_eq!((messages.status, &answer["command"]), (2, &Value::Null));
    assert!(
        answer["message"]
            .as_str()
            .unwrap()
            .contains("unrecognized subcommand"),
        "{answer}"
    );
}

#[test]
fn same_setup_launch_and_flight_with_an_optimum_and_by_simulate() {
    let (_, best) = json(&["optimize", "mae494", "--vary", "club.loft=0deg..20deg"]);
    let loft = format!(
        "club.loft={:?}",
        best["optimum"]["club.loft"].as_f64().unwrap()
    );
    let (_, drive) = json(&["simulate", "mae494", "--set", &format!("{loft} rad")]);
    for key in ["setup", "launch", "flight"] {
        assert_eq!(best[key], drive[key], "{key}");
    }
    // the search computed the value together with its derivatives, which rounds differently
    close(
        number(&best["value"]),
        number(&best["flight"]["carry"]),
        140.0,
        1e-13,
        "carry",
    );
}

#[test]
fn open_ranges_are_marked_in_the_list_of_parameters() {
    let (_, listing) = json(&["parameters"]);
    let rows = listing["parameters"].as_array().unwrap();
    let range = |name: &str| &rows.iter().find(|row| row["parameter"] == name).unwrap()["range"];
    assert_eq!(
        (&range("aero.cd1")["low"], &range("aero.cd1")["high"]),
        (&"-inf".into(), &"inf".into())
    );
    assert!(
        rows.iter()
            .all(|row| !row["range"]["low"].is_null() && !row["range"]["high"].is_null())
    );
}

#[cfg(feature = "full")]
#[test]
fn a_schema_refuses_an_answer_with_another_key_word_or_type() {
    let (_, answer) = json(&["simulate"]);
    let carry = |value: Value| {
        let mut changed = answer.clone();
        changed["flight"]["carry"] = value;
        faults("simulate", &changed)
    };
    assert_eq!(carry(1.0.into()), [""; 0]);
    assert!(carry("far".into())[0].contains("/flight/carry"));
    for (place, value) in [
        ("/flight/extra", Value::from(1.0)),
        ("/extra", Value::from(1.0)),
        ("/status", Value::from("done")),
        ("/command", Value::from("optimize")),
        ("/setup", Value::Null),
    ] {
        let mut changed = answer.clone();
        let (object, key) = place.rsplit_once('/').unwrap();
        let object = changed.pointer_mut(object).unwrap().as_object_mut();
        object.unwrap().insert(key.into(), value);
        assert_ne!(faults("simulate", &changed), [""; 0], "{place}");
    }
    for key in answer.as_object().unwrap().keys() {
        let mut changed = answer.clone();
        changed.as_object_mut().unwrap().remove(key);
        let is_refused = !faults("simulate", &changed).is_empty();
        assert_eq!(is_refused, key != "from", "{key}");
    }
}

#[test]
fn the_program_prints_every_example_of_the_documentation() {
    let file = format!("{}/../docs/json.md", env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(file).unwrap();
    let mut shown = 0;
    for block in text.split("```console\n$ longdrive ").skip(1) {
        let (block, _) = block.split_once("```").unwrap();
        let (question, answer) = block.split_once('\n').unwrap();
        let args: Vec<&str> = question.split_whitespace().collect();
        // parts are Parquet files
        if args.contains(&"--part") && !program::FORMATS.contains(&"parquet") {
            continue;
        }
        let folder = tempfile::tempdir().unwrap();
        let shots = format!("{}/data/shots/trackman.csv", env!("CARGO_MANIFEST_DIR"));
        fs::copy(shots, folder.path().join("shots.csv")).unwrap();
        let printed: Value = if args == ["validate", "--json"] {
            ANSWERED.1.clone()
        } else {
            let mut program = program::command();
            let output = program
                .current_dir(folder.path())
                .args(&args)
                .output()
                .unwrap();
            serde_json::from_slice(&output.stdout).unwrap()
        };
        let expected: Value =
            serde_json::from_str(answer).unwrap_or_else(|error| panic!("{question}: {error}"));
        assert!(
            is_part(&expected, &printed),
            "{question}: {expected:#} is not part of {printed:#}"
        );
        shown += 1;
    }
    assert!(shown >= 5, "{shown} examples");
}

/// True if an answer has the values of an example of docs/json.md. Numbers agree to the digits of
/// the example; "…" stands for omitted parts.
fn is_part(shown: &Value, printed: &Value) -> bool {
    match (shown, printed) {
        (Value::Object(shown), Value::Object(printed)) => shown.iter().all(|(key, value)| {
            if key == "…" {
                true
            } else {
                printed
                    .get(key)
                    .is_some_and(|printed| is_part(value, printed))
            }
        }),
        (Value::Array(shown), Value::Array(printed)) => {
            let has_more = shown.last().is_some_and(|last| last == "…");
            let shown = &shown[..shown.len() - usize::from(has_more)];
            (has_more || shown.len() == printed.len())
                && shown
                    .iter()
                    .zip(printed)
                    .all(|(shown, printed)| is_part(shown, printed))
        }
        (Value::Number(shown), Value::Number(printed)) => {
            let digits = shown.to_string();
            let decimals = digits
                .split_once('.')
                .map_or(0, |(_, decimals)| decimals.len());
            let (shown, printed) = (shown.as_f64().unwrap(), printed.as_f64().unwrap());
            (shown - printed).abs() <= 0.501 * 0.1_f64.powi(i32::try_from(decimals).unwrap())
        }
        (Value::String(shown), _) if shown == "…" => true,
        (shown, printed) => shown == printed,
    }
}

#[test]
fn a_ball_in_the_air_at_the_time_limit_has_one_status_in_all_commands() {
    let folder = tempfile::tempdir().unwrap();
    let page = folder.path().join("page").display().to_string();
    for args in [
        &["simulate"][..],
        &["gradient"],
        &["report", "-o", &page],
        &["sensitivity"],
    ] {
        let args = [args, &["--set", "flight.time_limit=2s"]].concat();
        let (_, answer) = json(&args);
        assert_eq!(answer["status"], "aloft", "{args:?}: {answer}");
    }
}
