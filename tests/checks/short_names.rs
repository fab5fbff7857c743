//! Options such as `--speed`, which set one parameter each, as `--set` does, and words that select
//! the listed parameters, as in `parameters wind`.

use crate::command_line::{json, longdrive, number, on_one_line};
use serde_json::Value;

const SHORT_NAMES: [[&str; 3]; 6] = [
    ["--speed", "swing.speed", "95mph"],
    ["--attack", "swing.attack_angle", "-2deg"],
    ["--loft", "club.loft", "12deg"],
    ["--temperature", "air.temperature", "50F"],
    ["--altitude", "air.altitude", "5000ft"],
    ["--wind", "wind.speed", "10mph"],
];

#[test]
fn same_drive_by_short_names_and_by_set() {
    let from = ["--set", "wind.from=0deg"];
    let short = SHORT_NAMES
        .iter()
        .flat_map(|[option, _, value]| [*option, value]);
    let short: Vec<_> = ["simulate"].into_iter().chain(short).chain(from).collect();
    let settings: Vec<_> = SHORT_NAMES
        .iter()
        .map(|[_, name, value]| format!("{name}={value}"))
        .collect();
    let set = settings.iter().flat_map(|setting| ["--set", setting]);
    let set: Vec<_> = ["simulate"].into_iter().chain(set).chain(from).collect();
    let (status, by_short) = json(&short);
    assert_eq!(status, 0);
    assert_eq!(by_short["flight"], json(&set).1["flight"]);
    let speed = number(&by_short["setup"]["swing.speed"]) / 0.44704;
    assert!((speed - 95.0).abs() < 1e-12, "{speed}");
}

#[test]
fn a_short_name_states_its_parameter_so_that_searches_hold_it() {
    let (status, found) = json(&["optimize", "--speed", "95mph", "--attack", "-2deg"]);
    assert_eq!(status, 0);
    assert_eq!(found["held"], Value::from(vec!["swing.attack_angle"]));
    let (_, set) = json(&[
        "optimize",
        "--set",
        "swing.speed=95mph",
        "--set",
        "swing.attack_angle=-2deg",
    ]);
    assert_eq!(found["optimum"], set["optimum"]);
}

#[test]
fn a_short_name_is_refused_without_a_unit_and_beside_a_setting() {
    for (words, says) in [
        (
            vec!["--speed", "95"],
            "swing.speed: \"95\" has no unit; a speed takes mph",
        ),
        (
            vec!["--speed", "95mph", "--set", "swing.speed=90mph"],
            "--speed 95mph: --set swing.speed=90mph gives swing.speed too; keep one of the two",
        ),
        (
            vec!["--wind", "10mph"],
            "--set wind.from=0deg is a head wind",
        ),
        (
            vec![
                "--loft",
                "9deg",
                "--launch",
                "ball_speed=150mph,launch_angle=12deg,spin=2600rpm",
            ],
            "--loft: the drive is given by its launch",
        ),
    ] {
        let output = longdrive(&[&["simulate"], words.as_slice()].concat());
        assert_eq!(output.status, 2, "{words:?}");
        assert!(on_one_line(&output.err).contains(says), "{}", output.err);
    }
}

/// The help lists the short names in one group, each in its own line.
#[test]
fn every_command_with_a_setup_lists_the_short_names_together() {
    for command in [
        "simulate",
        "optimize",
        "fly",
        "delivery",
        "parameters",
        "sweep",
    ] {
        let help = longdrive(&[command, "-h"]).out;
        let (_, group) = help.split_once("Your drive:\n").unwrap();
        let group = group.split("\n\n").next().unwrap();
        for [option, name, _] in SHORT_NAMES {
            let is_its_line = |line: &str| line.contains(option) && line.contains(name);
            assert!(group.lines().any(is_its_line), "{command} {option}: {help}");
        }
    }
}

#[test]
fn a_word_selects_parameters_by_name_and_else_by_meaning() {
    let names = |words: &[&str]| -> Vec<String> {
        let (status, found) = json(&[&["parameters"], words].concat());
        assert_eq!(status, 0);
        let parameters = found["parameters"].as_array().unwrap().iter();
        parameters
            .map(|one| one["parameter"].as_str().unwrap().to_owned())
            .collect()
    };
    let swing = names(&["swing"]);
    assert!(swing.contains(&"swing.speed".into()) && swing.len() > 5);
    assert!(swing.iter().all(|name| name.contains("swing")));
    assert_eq!(names(&["winfield-tan", "Loft"]), ["club.loft"]);
    assert_eq!(names(&["club.loft"]), ["club.loft"]);
    assert_eq!(names(&["MOI"]), ["club.inertia.xx"]);
    assert_eq!(names(&["moi"]), ["club.inertia.xx"]);
    let text = longdrive(&["parameters", "loft"]).out;
    assert!(
        text.contains("club.loft") && text.lines().count() < 10,
        "{text}"
    );
    let law = longdrive(&["parameters", "law"]).out;
    assert!(law.contains("aero.law = launch-monitor here"), "{law}");
}

#[test]
fn a_word_of_no_parameter_is_refused_with_the_nearest() {
    for (word, near) in [
        ("swng", "swing"),
        ("lofft", "loft"),
        ("modern-drver", "modern-driver"),
    ] {
        let output = longdrive(&["parameters", word]);
        assert_eq!(output.status, 2);
        let says = format!("'{word}'");
        assert!(
            output.err.contains(&says) && output.err.contains(&format!("'{near}'")),
            "{}",
            output.err
        );
    }
}
