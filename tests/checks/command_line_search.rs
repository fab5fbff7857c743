//! Commands that search: constraints, many starts, sensitivities, charts, and bad input.

use crate::command_line::{json, longdrive, number, on_one_line};
use crate::common::{SET_RIGID, close};
use crate::program;
use serde_json::Value;

/// A search that ends on a bound with a kink counts the evaluations of its two searches. A search
/// that finds no start counts the evaluations at every point that it tried.
#[test]
fn all_evaluations_of_a_search_are_counted() {
    let (_, on_a_kink) = json(&[
        "optimize",
        "mae494",
        "--vary",
        "club.loft=0deg..20deg",
        "--vary",
        "swing.attack_angle=20deg..60deg",
    ]);
    let (_, without_start) = json(&[
        "optimize",
        "--set",
        "swing.attack_angle=-30deg",
        "--vary",
        "club.loft=4deg..6deg",
    ]);
    assert_eq!(without_start["status"], "no-flight");
    for (found, least) in [(on_a_kink, 6.0), (without_start, 65.0)] {
        let evaluations = number(&found["evaluations"]);
        assert_eq!(evaluations, number(&found["steps"]["evaluations"]));
        assert!(evaluations >= least, "{evaluations}");
    }
}

#[test]
fn constraints_and_starts_as_json() {
    let (status, found) = json(&[
        "optimize",
        "--subject-to",
        "descent_angle >= 38 deg",
        "--subject-to",
        "apex_height <= 35 yd",
        "--starts",
        "32",
    ]);
    assert_eq!((status, &found["status"]), (0, &Value::from("converged")));
    let constraints = found["constraints"].as_array().unwrap();
    assert_eq!(constraints[0]["expression"], "descent_angle >= 38 deg");
    close(
        number(&constraints[0]["value"]),
        38.0_f64.to_radians(),
        1.0,
        1e-9,
        "descent angle",
    );
    close(
        number(&constraints[1]["value"]),
        35.0 * 0.9144,
        1.0,
        1e-9,
        "apex",
    );
    assert!(
        constraints
            .iter()
            .all(|constraint| number(&constraint["multiplier"]) > 0.0)
    );
    let optima = found["optima"].as_array().unwrap();
    assert_eq!(
        optima
            .iter()
            .map(|local| number(&local["starts"]))
            .sum::<f64>(),
        32.0
    );
    let one_thread = program::command()
        .args([
            "optimize",
            "--starts",
            "32",
            "--json",
            "--subject-to",
            "descent_angle >= 38 deg",
        ])
        .args(["--subject-to", "apex_height <= 35 yd"])
        .env("RAYON_NUM_THREADS", "1")
        .output()
        .unwrap();
    assert_eq!(
        serde_json::from_slice::<Value>(&one_thread.stdout).unwrap(),
        found,
        "whatever the number of threads"
    );
}

/// If a parameter is set and varied, the search starts from the set value, moved into the range.
#[test]
fn a_set_value_of_a_variable_is_reported_as_its_start() {
    let notes = |args: &[&str]| -> Vec<String> {
        let printed = longdrive(args);
        assert!([0, 1].contains(&printed.status), "{}", printed.err);
        printed
            .err
            .lines()
            .filter(|line| line.contains("begins at"))
            .map(str::to_owned)
            .collect()
    };
    let of_sensitivity = [
        "optimum-sensitivity",
        "--set",
        "club.loft=10deg",
        "--vary",
        "club.loft=4deg..20deg",
        "--wrt",
        "air.density",
    ];
    assert_eq!(
        notes(&of_sensitivity),
        ["note: club.loft is varied; the search from the setup begins at 10°"]
    );
    for (set, start, moved) in [
        ("club.loft=10deg", "10°", ""),
        ("club.loft=25deg", "20°", ", the end of its range"),
    ] {
        let vary = "club.loft=4deg..20deg";
        let args = [
            "optimize",
            "--set",
            set,
            "--vary",
            vary,
            "--max-iterations",
            "1",
        ];
        assert_eq!(
            notes(&args),
            [format!(
                "note: club.loft is varied; the search from the setup begins at {start}{moved}"
            )]
        );
        // the first line of the progress has the start point
        let first = format!("club.loft {}.000000°", start.trim_end_matches('°'));
        let verbose = longdrive(&[&args[..], &["--verbose"]].concat());
        assert!(verbose.err.contains(&first), "{set}");
    }
    assert_eq!(
        notes(&[
            "optimize",
            "--set",
            "swing.speed=100mph",
            "--max-iterations",
            "1"
        ]),
        [""; 0]
    );
    // other searches print this note, too
    let loft = "--vary=club.loft=4deg..20deg";
    for args in [
        &[
            "robust",
            "--set=club.loft=10deg",
            loft,
            "--model=ball.mass=44g",
        ][..],
        &[
            "pareto",
            "--set=club.loft=10deg",
            loft,
            "--maximize=carry",
            "--minimize=apex_height",
            "--points=3",
        ],
        &[
            "design",
            "--set=club.loft=10deg",
            loft,
            "--scenarios=4",
            "--max-iterations=1",
        ],
        &[
            "optimize",
            "--set=club.loft=10deg",
            loft,
            "--distribution=swing.speed=normal(110mph,3mph)",
            "--max-iterations=1",
        ],
    ] {
        assert_eq!(
            notes(args),
            ["note: club.loft is varied; the search from the setup begins at 10°"],
            "{args:?}"
        );
    }
}

/// The wind direction is varied, and the wind speed, which belongs to it, is set.
#[test]
fn a_varied_wind_direction_keeps_the_wind_speed() {
    let range = "--vary=wind.from=0deg..180deg";
    let (status, found) = json(&["optimize", range, "--set=wind.speed=10mph"]);
    // a tail wind carries farthest
    assert_eq!(
        (status, found["status"].as_str()),
        (0, Some("converged")),
        "{found}"
    );
    close(
        number(&found["optimum"]["wind.from"]),
        std::f64::consts::PI,
        1.0,
        1e-9,
        "direction",
    );
    let printed = longdrive(&["optimize", "--set=wind.speed=10mph"]);
    assert!(
        printed.status == 2
            && printed
                .err
                .contains("wind.speed is given without wind.from"),
        "{}",
        printed.err
    );
}

/// No variable changes the equation lateral = 0, because every drive is straight. The equation then
/// has no multiplier.
#[test]
fn an_equation_is_reported_with_its_violation_and_never_as_inactive() {
    let output =
        |limit: &str| on_one_line(&longdrive(&["optimize", "-q", "--subject-to", limit]).out);
    let free = output("lateral == 0 yd");
    let words =
        "lateral = 0 yd 0.0 yd equality: off by 0.00 yd, and no varied parameter changes it";
    assert!(free.contains(words), "{free}");
    let held = output("apex_height == 30 yd");
    assert!(
        held.contains("equality: off by 0.00 yd, +")
            && held.contains("yd for each yard that the value is raised"),
        "{held}"
    );
    let idle = output("apex_height <= 60 yd");
    assert!(
        idle.contains("apex height ≤ 60 yd") && idle.contains("not active"),
        "{idle}"
    );
}

#[test]
fn exact_multiplier_of_an_equation_that_holds_at_the_start() {
    for of in ["carry", "flight_time", "apex_height", "landing_speed"] {
        let (_, drive) = json(&["simulate"]);
        let unit = if of == "flight_time" {
            "s"
        } else if of == "landing_speed" {
            "m/s"
        } else {
            "m"
        };
        let equation = format!("{of} == {:?} {unit}", number(&drive["flight"][of]));
        let (status, found) = json(&["optimize", "--maximize", of, "--subject-to", &equation]);
        assert_eq!(
            (status, &found["status"]),
            (0, &Value::from("converged")),
            "{equation}: {found}"
        );
        close(
            number(&found["constraints"][0]["multiplier"]),
            1.0,
            1.0,
            1e-9,
            &equation,
        );
    }
}

#[test]
fn infeasible_is_an_answer_with_status_1_and_the_violation() {
    let limits = [
        "--subject-to",
        "descent_angle >= 60 deg",
        "--subject-to",
        "apex_height <= 35 yd",
    ];
    let (status, found) = json(&[&["optimize"], limits.as_slice()].concat());
    assert_eq!((status, &found["status"]), (1, &Value::from("infeasible")));
    let message = found["message"].as_str().unwrap();
    assert!(
        message.contains("descent_angle >= 60 deg (its value is ")
            && message.contains(", outside by "),
        "{message}"
    );
    // without an optimum, `optimum-sensitivity` has no answer
    let (status, found) = json(&[&["optimum-sensitivity"], limits.as_slice()].concat());
    assert_eq!((status, &found["status"]), (1, &Value::from("infeasible")));
    // and the text of `optimize` has no prices
    assert!(
        !longdrive(&[&["optimize"], limits.as_slice()].concat())
            .out
            .contains("relaxed")
    );
}

#[test]
fn a_change_says_where_the_parameter_goes() {
    for (change, title) in [
        ("120mph", "swing.speed +120 mph to 235 mph"),
        ("-10mph", "swing.speed -10 mph to 105 mph"),
    ] {
        let change = format!("--change=swing.speed={change}");
        let printed = longdrive(&[
            "optimum-sensitivity",
            "tour-average",
            "--wrt",
            "gravity",
            &change,
        ]);
        assert!(
            printed.status == 0 && printed.out.contains(title),
            "{}",
            printed.out
        );
    }
}

#[test]
fn differences_confirm_sensitivity_and_windows_as_json() {
    let (status, found) = json(&[
        "optimum-sensitivity",
        "modern-driver",
        "--own-step",
        "--wrt",
        "swing.speed,gravity",
        "--change",
        "swing.speed=+1mph",
    ]);
    assert_eq!((status, &found["status"]), (0, &Value::from("converged")));
    let names: Vec<&String> = found["sensitivity"].as_object().unwrap().keys().collect();
    assert_eq!(names, ["swing.speed", "gravity"]);
    let speed = &found["sensitivity"]["swing.speed"];
    let best =
        |speed: &str| number(&json(&["optimize", "modern-driver", "--set", speed]).1["value"]);
    let slope = (best("swing.speed=49.2744m/s") - best("swing.speed=49.0744m/s")) / 0.2;
    close(number(&speed["value"]), slope, 1.0, 1e-4, "d f*/d speed");
    assert_eq!(number(&speed["optimum"]["swing.attack_angle"]), 0.0);
    let window = &found["window"]["club.loft"];
    let x = number(&found["optimum"]["club.loft"]);
    assert!(number(&window["low"]) < x && x < number(&window["high"]));
    for end in ["low", "high"] {
        let loft = format!("club.loft={:?}rad", number(&window[end]));
        let drive = json(&[
            "simulate",
            "modern-driver",
            "--set",
            &loft,
            "--set",
            "swing.attack_angle=5deg",
        ])
        .1;
        close(
            number(&found["value"]) - number(&drive["flight"]["carry"]),
            0.9144,
            1.0,
            1e-9,
            "a yard",
        );
    }
    assert_eq!(found["window"]["swing.attack_angle"]["high_limit"], "bound");
    let change = &found["changes"][0];
    let (predicted, anew) = (
        number(&change["predicted"]["value"]),
        number(&change["resolved"]["value"]),
    );
    assert!((predicted - anew).abs() < 1e-2, "{change}");
    let text = longdrive(&["optimum-sensitivity"]);
    assert_eq!(text.status, 0);
    for words in [
        "swing.speed [mph]",
        "within 1.00 yd of the best if one parameter alone",
        "(or the opposite way) loses",
        "by the quadratic",
    ] {
        assert!(text.out.contains(words), "{words}: {}", text.out);
    }
}

#[test]
fn a_chart_has_a_column_of_active_bounds_only_if_one_is_active() {
    let attack = ["chart", "--along", "swing.attack_angle=-5deg..5deg"];
    for (loft, is_active) in [
        ("club.loft=4deg..20deg", false),
        ("club.loft=8deg..20deg", true),
    ] {
        let printed = longdrive(&[&attack[..], &["--vary", loft]].concat());
        let has_column = printed.out.lines().any(|line| line.ends_with(" active"));
        assert_eq!(has_column, is_active, "{loft}: {}", printed.out);
    }
}

#[test]
fn chart_as_json_csv_and_table() {
    let args = [
        "chart",
        "--along",
        "swing.speed=80mph..130mph",
        "--subject-to",
        "apex_height <= 35 yd",
    ];
    let (status, chart) = json(&args);
    let points = chart["points"].as_array().unwrap();
    assert_eq!(status, 0);
    assert_eq!(number(&points[0]["at"]), 80.0 * 0.44704);
    assert_eq!(number(&points.last().unwrap()["at"]), 130.0 * 0.44704);
    assert_eq!(
        points[0]["active"],
        serde_json::json!(["swing.attack_angle"])
    );
    assert!(
        points.last().unwrap()["active"]
            .as_array()
            .unwrap()
            .contains(&Value::from("apex_height <= 35 yd"))
    );
    let csv = longdrive(&[&args, ["--csv"].as_slice()].concat());
    assert!(
        csv.out.starts_with(
            "swing.speed [m/s],carry [m],club.loft [rad],swing.attack_angle [rad],ball_speed \
             [m/s],launch_angle [rad],\
             backspin [rad/s],active,event\n"
        ),
        "{}",
        csv.out
    );
    assert_eq!(csv.out.lines().count(), points.len() + 1);
    let text = longdrive(&args).out;
    assert!(
        text.contains("<- apex height ≤ 35 yd from here on") && text.contains("launch_angle"),
        "{text}"
    );
    // the launch of a point of the chart is the launch of the drive with the optimum's values
    let [loft, attack] =
        ["club.loft", "swing.attack_angle"].map(|name| number(&points[0]["optimum"][name]));
    let set = [
        format!("club.loft={loft} rad"),
        format!("swing.attack_angle={attack} rad"),
    ];
    let (_, drive) = json(&[
        "simulate",
        "--set",
        "swing.speed=80mph",
        "--set",
        &set[0],
        "--set",
        &set[1],
    ]);
    for of in ["ball_speed", "launch_angle", "backspin"] {
        let (ours, theirs) = (
            number(&points[0]["launch"][of]),
            number(&drive["launch"][of]),
        );
        assert!(
            (ours - theirs).abs() < 1e-9 * theirs,
            "{of}: {ours}, {theirs}"
        );
    }

    // if part of the range has no optimum, the other points are printed, with status 1
    let low = [
        "chart",
        "--along",
        "swing.speed=80mph..130mph",
        "--subject-to",
        "apex_height >= 36 yd",
    ];
    let (status, chart) = json(&low);
    assert_eq!(status, 1);
    assert!(chart["points"].as_array().unwrap().len() > 5);
    assert!(
        chart["begun"]
            .as_str()
            .unwrap()
            .contains("no optimum was found at 80 mph"),
        "{}",
        chart["begun"]
    );
    // up to 120 mph the optimum is not at a corner of the ranges, where a search needs no iteration
    let (status, chart) = json(&[
        "chart",
        "--along",
        "swing.speed=80mph..120mph",
        "--max-iterations",
        "0",
    ]);
    assert_eq!((status, chart["points"].as_array().unwrap().len()), (1, 0));
    assert!(chart["ended"].as_str().unwrap().contains("iteration-limit"));
}

const VARYING: [&str; 2] = ["--distribution", "swing.attack_angle=normal(-1deg,2deg)"];

/// The optimum after a change equals the optimum of a new search with the changed setup. Both use
/// the step that is chosen for the changed setup: the step of the original drive would be too long
/// for a speed that is more than three times as high.
#[test]
fn same_changed_optimum_and_search_of_the_changed_setup() {
    for (change, set) in [
        ("swing.speed=+300mph", "swing.speed=415mph"),
        ("air.density=-20%", "air.density=0.98kg/m^3"),
    ] {
        let requested = [
            "optimum-sensitivity",
            "--set",
            "air.density=1.225kg/m^3",
            "--wrt",
            "swing.speed",
            "--change",
            change,
        ];
        let (_, found) = json(&requested);
        let resolved = &found["changes"][0]["resolved"];
        let anew = ["optimize", "--set", "air.density=1.225kg/m^3", "--set", set];
        let anew = if set.starts_with("air") {
            [&anew[..1], &anew[3..]].concat()
        } else {
            anew.to_vec()
        };
        let (_, best) = json(&anew);
        assert_eq!(
            (&resolved["status"], &best["status"]),
            (&"converged".into(), &"converged".into()),
            "{resolved} {best}"
        );
        // both carries are within a micrometre of the exact carry
        close(
            number(&resolved["value"]),
            number(&best["value"]),
            1.0,
            1e-5,
            change,
        );
    }
}

#[test]
fn refusals_of_variables_do_not_contradict_each_other() {
    let printed = longdrive(&[
        "optimum-sensitivity",
        "--change",
        "swing.attack_angle=+1deg",
    ]);
    let sentence = on_one_line(&printed.err);
    let words = "the sensitivity of the optimum to swing.attack_angle: swing.attack_angle is a varied \
                 parameter, so the search chooses it; choose another parameter";
    assert!(
        printed.status == 2 && sentence.contains(words) && !sentence.contains("cannot be varied"),
        "{sentence}"
    );
}

#[test]
fn bad_input_to_a_search_is_status_2_with_advice() {
    for (args, says) in [
        (
            vec!["optimize", "--subject-to", "descent_angel >= 38 deg"],
            "did you mean 'descent_angle'?",
        ),
        (
            vec!["optimize", "--subject-to", "descent_angle >= 38"],
            "has no unit",
        ),
        (
            vec!["optimize", "--subject-to", "descent_angle"],
            "no comparison",
        ),
        (vec!["optimize", "--starts", "0"], "--starts"),
        (vec!["optimize", "--starts", "70000"], "at most 65536"),
        (
            vec!["optimize", "--checkpoint", "/nowhere/at/all.json"],
            "cannot be written",
        ),
        (vec!["optimize", "--checkpoint", "."], "it is not a file"),
        (
            vec!["optimum-sensitivity", "--wrt", "club.loft"],
            "is a varied parameter",
        ),
        (
            vec!["optimum-sensitivity", "--wrt", "swing.sped"],
            "did you mean 'swing.speed'?",
        ),
        (
            vec!["optimum-sensitivity", "--change", "club.loft=+1deg"],
            "is a varied parameter, so the search chooses it; choose another parameter, or give \
             --vary without club.loft",
        ),
        (
            vec!["optimum-sensitivity", "--change", "swing.speed=+5kg"],
            "not a speed",
        ),
        (
            vec!["optimum-sensitivity", "--change", "swing.speed"],
            "write NAME=AMOUNT",
        ),
        (
            vec!["optimum-sensitivity", "--change", "air.density=-5 kg/m^3"],
            "outside its range",
        ),
        (
            vec!["optimum-sensitivity", "--change", "swing.path=+20%"],
            "a percentage is relative to the value, and swing.path is 0",
        ),
        (vec!["optimum-sensitivity", "--loss", "0 yd"], "above 0"),
        (
            vec!["optimum-sensitivity", "--loss", "-5yd"],
            "--loss -5yd: it must be above 0",
        ),
        (
            vec!["optimize", "--subject-to", "weights: club.mass <= 200 g"],
            "a relation of parameters limits a search over many",
        ),
        (
            vec!["optimize", "--subject-to", "club.loft <= 8deg"],
            "--vary club.loft=LOW..HIGH",
        ),
        (
            vec!["optimize", "--subject-to", "aero.cd0 <= 0.3"],
            "--vary aero.cd0=LOW..HIGH",
        ),
        (
            [
                &["optimize", "--subject-to", "club.loft <= 8deg"],
                &VARYING[..],
            ]
            .concat(),
            "--vary club.loft=LOW..HIGH",
        ),
        (
            [
                &["optimize", "--maximize", "mean(carry) - 0.5 std(carry)"],
                &VARYING[..],
            ]
            .concat(),
            "write 0.5*std(carry)",
        ),
        (
            vec!["optimize", "--swings", "nofile.toml"],
            "the swings in nofile.toml: it cannot be read (there is no such file)",
        ),
        (
            vec!["optimize", "-o", "best.json"],
            "a setup file is written in TOML, and .json is the extension of another format",
        ),
        (
            vec!["robust", "-o", "best.csv"],
            "a setup file is written in TOML",
        ),
        (
            vec!["optimum-sensitivity", "--loss", "1 kg"],
            "not a length",
        ),
        (
            vec!["chart", "--along", "swing.speed=130mph..80mph"],
            "the range is reversed",
        ),
        (
            vec![
                "chart",
                "--along",
                "club.loft=5deg..6deg",
                "--vary",
                "club.loft=4deg..20deg",
            ],
            "is a varied parameter",
        ),
        (
            vec!["chart", "--along", "swing.speed=80mph.."],
            "upper end is missing",
        ),
        (vec!["chart"], "--along"),
        (
            vec!["simulate", "--set", "flight.step=1e-9s"],
            "it must be at least 6e-6 s",
        ),
        (
            vec![
                "simulate",
                "--set",
                "flight.step=6e-6s",
                "--set",
                "flight.time_limit=1e3s",
            ],
            "at most 1e8 steps",
        ),
    ] {
        let printed = longdrive(&args);
        assert_eq!(
            (printed.status, printed.out.as_str()),
            (2, ""),
            "{args:?}: {}",
            printed.err
        );
        assert!(printed.err.contains(says), "{args:?}: {}", printed.err);
    }
}

#[test]
fn each_outcome_of_a_gradient_has_its_own_error() {
    let requested = [
        "gradient",
        "modern-driver",
        "--of",
        "launch_angle,carry",
        "--set",
        "club.loft=-20deg",
    ];
    let (status, rows) = json(&[&requested[..], &SET_RIGID].concat());
    assert_eq!(status, 1);
    close(
        number(&rows["outcomes"][0]["value"]).to_degrees(),
        -17.87,
        1.0,
        1e-2,
        "launch angle",
    );
    assert!(
        rows["outcomes"][1]["value"].is_null()
            && rows["outcomes"][1]["message"]
                .as_str()
                .unwrap()
                .contains("no flight")
    );
    let (status, rows) = json(&[
        "gradient",
        "modern-driver",
        "--of",
        "spin_axis,carry,carry",
        "--set",
        "club.loft=0rad",
        "--wrt",
        "all,gravity",
    ]);
    assert_eq!((status, rows["outcomes"].as_array().unwrap().len()), (1, 2));
    assert!(rows["outcomes"][0]["value"].is_null() && rows["outcomes"][1]["value"].is_null());
}

#[test]
fn a_full_disk_is_an_error() {
    if let Ok(full) = std::fs::OpenOptions::new().write(true).open("/dev/full") {
        let mut program = program::command();
        let output = program.arg("simulate").stdout(full).output().unwrap();
        assert_eq!(output.status.code(), Some(2));
        assert!(String::from_utf8_lossy(&output.stderr).contains("cannot write the answer"));
    }
}

#[test]
fn exact_price_of_the_bound_of_a_minimum() {
    // ball speed decreases with loft: the minimum is at the upper bound, and its multiplier is the
    // derivative there
    let vary = ["--vary", "club.loft=4deg..20deg"];
    let (status, found) = json(
        &[
            &["optimize", "modern-driver", "--minimize", "ball_speed"],
            &vary[..],
        ]
        .concat(),
    );
    assert_eq!(
        (status, found["status"].as_str()),
        (0, Some("converged")),
        "{found}"
    );
    assert_eq!(
        number(&found["optimum"]["club.loft"]),
        20.0_f64.to_radians()
    );
    let at = [
        "--of",
        "ball_speed",
        "--wrt",
        "club.loft",
        "--set",
        "club.loft=20deg",
    ];
    let mut setup = longdrive::Setup::modern_driver();
    setup.set("club.loft", "20 deg").unwrap();
    let loft = setup.variable("club.loft").unwrap();
    let slope =
        longdrive::derivative::gradient(&setup, longdrive::Outcome::BallSpeed, &[loft]).unwrap();
    assert!(slope.gradient[0] < 0.0, "{at:?}");
    close(
        number(&found["value"]),
        slope.value,
        slope.value,
        1e-14,
        "value",
    );
    close(
        number(&found["gradient"]["club.loft"]),
        slope.gradient[0],
        1.0,
        1e-9,
        "gradient",
    );
    close(
        number(&found["multipliers"]["club.loft"]["upper"]),
        -slope.gradient[0],
        1.0,
        1e-9,
        "price",
    );
    let printed = longdrive(
        &[
            &["optimize", "modern-driver", "--minimize", "ball_speed"],
            &vary[..],
        ]
        .concat(),
    );
    assert!(
        printed.out.contains("at its upper bound: -"),
        "{}",
        printed.out
    );
    let both = longdrive(&["optimize", "--minimize", "carry", "--maximize", "carry"]);
    assert_eq!(both.status, 2, "{}", both.err);
}

#[test]
fn differences_of_minima_are_their_sensitivities() {
    // the landing speed has its minimum between a flat and a steep descent
    let requested = [
        "--minimize",
        "landing_speed",
        "--vary",
        "club.loft=4deg..25deg",
        "--own-step",
    ];
    let (status, found) = json(
        &[
            &[
                "optimum-sensitivity",
                "modern-driver",
                "--wrt",
                "air.density",
            ],
            &requested[..],
        ]
        .concat(),
    );
    assert_eq!(status, 0, "{found}");
    let best = |density: &str| {
        let (_, found) = json(
            &[
                &["optimize", "modern-driver", "--set", density],
                &requested[..],
            ]
            .concat(),
        );
        number(&found["value"])
    };
    let slope = (best("air.density=1.185 kg/m^3") - best("air.density=1.183 kg/m^3")) / 0.002;
    let exact = number(&found["sensitivity"]["air.density"]["value"]);
    close(slope, exact, exact.abs(), 1e-5, "d f*/d density");
    let loss = |end: &str| {
        let loft = format!(
            "club.loft={:?}rad",
            number(&found["window"]["club.loft"][end])
        );
        let (_, drive) = json(&["simulate", "modern-driver", "--set", &loft]);
        number(&drive["flight"]["landing_speed"]) - number(&found["value"])
    };
    // the upper end of the interval is the bound, and the optimum is there: the loss is 0, except
    // for rounding
    assert!(
        loss("low") > 0.1 && found["window"]["club.loft"]["high_limit"] == "bound",
        "{found}"
    );
    close(
        loss("high"),
        0.0,
        number(&found["value"]),
        1e-14,
        "loss at the optimum",
    );
}

#[test]
fn same_drive_from_the_setup_written_at_an_optimum() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("best.toml").display().to_string();
    let requested = [
        "optimize",
        "modern-driver",
        "--set",
        "swing.speed=100mph",
        "-o",
        &file,
        "--overwrite",
    ];
    let (status, found) = json(&requested);
    assert_eq!(status, 0);
    let text = std::fs::read_to_string(&file).unwrap();
    for words in [
        "preset = \"modern-driver\"",
        "speed = \"100 mph\" # as given",
        "# optimum: 1",
        "mass = \"204 g\" # Caldwell",
    ] {
        assert!(text.contains(words), "no '{words}' in {text}");
    }
    // method and step were chosen for the search, so they are not in the file: a command that reads
    // the file may choose others, and its carry differs by less than a micrometre
    assert!(
        !text.contains("\nmethod = ") && !text.contains("\nstep = "),
        "{text}"
    );
    let carry = || number(&json(&["simulate", &file]).1["flight"]["carry"]);
    close(carry(), number(&found["value"]), 1.0, 1e-6, "carry");
    // a stated method or step is in the file, and the file gives the same drive to the last digits
    for stated in [&["--own-step"][..], &["--set", "flight.step=0.02s"]] {
        let (_, found) = json(&[&requested[..], stated].concat());
        close(
            carry(),
            number(&found["value"]),
            number(&found["value"]),
            1e-14,
            "carry",
        );
    }
    // a step that was chosen for a tolerance is not in the file; the file has the step of the
    // setup, if one is stated
    let within = |setup: &str, file: &str| {
        let requested = [
            "optimize",
            setup,
            "--tolerance=1mm",
            "-o",
            file,
            "--overwrite",
        ];
        assert_eq!(longdrive(&requested).status, 0);
        let text = std::fs::read_to_string(file).unwrap();
        text.lines()
            .filter(|line| line.starts_with("step = "))
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    assert_eq!(
        within(&file, &format!("{file}.2")),
        ["step = \"0.02 s\" # as given, instead of 0.01 s"]
    );
    assert!(within("modern-driver", &file).is_empty());
    let printed = longdrive(&["optimize", "-o", &file]);
    assert!(
        printed.status == 2 && printed.err.contains("--overwrite to replace it"),
        "{}",
        printed.err
    );
}

#[test]
fn options_of_another_search_are_refused() {
    for option in [
        &["--maximize", "carry"][..],
        &["--vary", "club.loft=4deg..20deg"],
        &["--max-iterations", "9"],
    ] {
        let printed = longdrive(&[&["sensitivity"], option].concat());
        assert_eq!(
            (printed.status, printed.out.as_str()),
            (2, ""),
            "{option:?}: {}",
            printed.err
        );
        assert!(
            printed.err.contains(option[0]) && printed.err.contains("--at-optimum"),
            "{}",
            printed.err
        );
    }
}

#[test]
fn same_optima_at_chosen_points_as_in_single_searches() {
    let (status, chart) = json(&[
        "chart",
        "modern-driver",
        "--along",
        "swing.speed",
        "--at",
        "110mph,90mph,100mph",
    ]);
    assert_eq!(status, 0, "{chart}");
    let points = chart["points"].as_array().unwrap();
    let speeds: Vec<f64> = points.iter().map(|point| number(&point["at"])).collect();
    assert_eq!(speeds, [90.0 * 0.44704, 100.0 * 0.44704, 110.0 * 0.44704]);
    for (point, speed) in points.iter().zip(["90mph", "100mph", "110mph"]) {
        let (_, alone) = json(&[
            "optimize",
            "modern-driver",
            "--set",
            &format!("swing.speed={speed}"),
        ]);
        close(
            number(&point["value"]),
            number(&alone["value"]),
            1.0,
            1e-9,
            speed,
        );
    }
    let printed = longdrive(&["chart", "--along", "swing.speed", "--at", "90"]);
    assert_eq!(printed.status, 2, "{}", printed.err);
    assert!(printed.err.contains("has no unit"), "{}", printed.err);
}

#[test]
fn unordered_and_duplicate_values_of_a_chart_are_reported() {
    const TOLD: &str = "the values of --at are used in ascending order, each once";
    for (at, is_told) in [
        ("90mph,100mph", false),
        ("100mph,90mph", true),
        ("90mph,90mph,100mph", true),
    ] {
        let printed = longdrive(&["chart", "--along", "swing.speed", "--at", at, "--csv"]);
        assert_eq!(
            (printed.status, printed.out.lines().count()),
            (0, 3),
            "{at}: {}",
            printed.out
        );
        assert_eq!(printed.err.contains(TOLD), is_told, "{at}: {}", printed.err);
    }
}

#[test]
fn progress_of_a_chart_shows_the_given_points() {
    let printed = longdrive(&[
        "chart",
        "--along",
        "swing.speed",
        "--at",
        "100mph,120mph",
        "--verbose",
    ]);
    let shown: Vec<&str> = printed
        .err
        .lines()
        .filter(|line| line.starts_with("swing.speed "))
        .collect();
    assert!(printed.status == 0 && shown.len() == 2, "{}", printed.err);
    assert!(
        shown[0].starts_with("swing.speed 100 mph: carry")
            && shown[1].starts_with("swing.speed 120 mph: carry"),
        "{shown:?}"
    );
}

#[test]
fn an_unwritten_setup_is_reported_even_with_quiet() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("best.toml");
    let requested = [
        "optimize",
        "-q",
        "--max-iterations",
        "1",
        "-o",
        file.to_str().unwrap(),
    ];
    let printed = longdrive(&requested);
    let unwritten = "is not written: there is no optimum";
    assert!(
        printed.status == 1 && printed.err.contains(unwritten),
        "{}",
        printed.err
    );
    let (_, answer) = json(&requested);
    let warnings = answer["warnings"].as_array().unwrap().iter();
    let mut warnings = warnings.map(|warning| warning.as_str().unwrap());
    assert!(
        warnings.any(|warning| warning.contains(unwritten)),
        "{answer}"
    );
    assert!(!file.exists());
}

/// A setting is refused if another option gives the value of this parameter in every drive. A
/// setting that is a start value or a mean is accepted.
#[test]
fn a_setting_that_has_no_effect_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let plot = folder.path().join("a.svg").to_str().unwrap().to_owned();
    let along = ["--along", "swing.speed=100mph..101mph"];
    for (args, why) in [
        (
            [&["chart", "--set", "swing.speed=90mph"], &along[..]].concat(),
            "--along gives its values",
        ),
        (
            [
                &["plot", "chart", "-o", &plot, "--set", "swing.speed=90mph"],
                &along[..],
            ]
            .concat(),
            "--along gives its values",
        ),
        (
            vec![
                "uncertainty",
                "--set",
                "swing.speed=90mph",
                "--distribution",
                "swing.speed=normal(100mph,1mph)",
            ],
            "--distribution gives its values",
        ),
    ] {
        let printed = longdrive(&args);
        let sentence = format!("--set swing.speed: {why}, so this one is not used; leave it out");
        assert!(
            printed.status == 2 && printed.err.contains(&sentence),
            "{args:?}: {}",
            printed.err
        );
    }
    // friction has no value in this preset
    let along = ["chart", "--along", "impact.friction=0.4..0.41"];
    let stated = ["--set", "impact.friction=0.3"];
    assert_eq!(longdrive(&along).status, 0);
    assert_eq!(longdrive(&[&along[..], &stated].concat()).status, 2);
    let start = |loft: &str| {
        let printed = longdrive(&[
            "optimize",
            "--verbose",
            "--set",
            loft,
            "--vary",
            "club.loft=4deg..20deg",
            "--max-iterations",
            "0",
        ]);
        printed
            .err
            .lines()
            .find(|line| line.starts_with("  0 "))
            .unwrap()
            .to_owned()
    };
    assert!(
        start("club.loft=8deg").ends_with("club.loft 8.000000°"),
        "{}",
        start("club.loft=8deg")
    );
    let requested = [
        "uncertainty",
        "--set",
        "swing.speed=90mph",
        "--sigma",
        "swing.speed=1mph",
        "--samples",
        "16",
    ];
    let printed = longdrive(&[&requested[..], &["--all"]].concat());
    assert!(printed.out.contains("normal: 90 mph ± 1 mph"));
}

#[test]
fn exact_order_of_multipliers_is_that_of_the_parameters() {
    let (_, found) = json(&[
        "optimize",
        "mae494",
        "--vary",
        "swing.attack_angle=-10deg..10deg",
        "--vary",
        "club.loft=0deg..20deg",
    ]);
    for object in ["optimum", "multipliers"] {
        let names: Vec<&String> = found[object].as_object().unwrap().keys().collect();
        assert_eq!(names, ["swing.attack_angle", "club.loft"], "{object}");
    }
}

/// Ferguson's cd0 is the published one of table.rs; the preset's cd0 belongs to another law.
#[test]
fn published_coefficient_of_a_stated_law_is_not_as_given() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("x.toml").display().to_string();
    let asked = ["optimize", "--set", "aero.law=ferguson", "-o", &file];
    assert_eq!(longdrive(&asked).status, 0);
    let text = std::fs::read_to_string(&file).unwrap();
    let line = text
        .lines()
        .find(|line| line.starts_with("cd0 = "))
        .unwrap();
    assert_eq!(line, "cd0 = \"0.1304\" # Ferguson, McNally & McPhee (2022)");
}
