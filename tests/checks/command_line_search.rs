//! The commands that search, as a user meets them: constraints, many starts, sensitivities, charts, and bad input.

use crate::command_line::{json, longdrive, number};
use crate::common::close;
use serde_json::Value;

#[test]
fn exact_constraints_and_starts_as_json() {
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
    close(number(&constraints[0]["value"]), 38.0_f64.to_radians(), 1.0, 1e-9, "descent angle");
    close(number(&constraints[1]["value"]), 35.0 * 0.9144, 1.0, 1e-9, "apex");
    assert!(constraints.iter().all(|constraint| number(&constraint["multiplier"]) > 0.0));
    let optima = found["optima"].as_array().unwrap();
    assert_eq!(optima.iter().map(|local| number(&local["starts"])).sum::<f64>(), 32.0);
    let one_thread = assert_cmd::Command::cargo_bin("longdrive")
        .unwrap()
        .args(["optimize", "--starts", "32", "--json", "--subject-to", "descent_angle >= 38 deg"])
        .args(["--subject-to", "apex_height <= 35 yd"])
        .env("RAYON_NUM_THREADS", "1")
        .output()
        .unwrap();
    assert_eq!(serde_json::from_slice::<Value>(&one_thread.stdout).unwrap(), found, "whatever the number of threads");
}

#[test]
fn exact_equation_that_holds_already_converges_with_its_multiplier() {
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
        assert_eq!((status, &found["status"]), (0, &Value::from("converged")), "{equation}: {found}");
        close(number(&found["constraints"][0]["multiplier"]), 1.0, 1.0, 1e-9, &equation);
    }
}

#[test]
fn infeasible_is_an_answer_with_status_1_and_says_by_what() {
    let limits = ["--subject-to", "descent_angle >= 60 deg", "--subject-to", "apex_height <= 35 yd"];
    let (status, found) = json(&[&["optimize"], limits.as_slice()].concat());
    assert_eq!((status, &found["status"]), (1, &Value::from("infeasible")));
    let message = found["message"].as_str().unwrap();
    assert!(message.contains("descent_angle >= 60 deg (it is ") && message.contains("away)"), "{message}");
    // no optimum, no sensitivity
    let (status, found) = json(&[&["optimum-sensitivity"], limits.as_slice()].concat());
    assert_eq!((status, &found["status"]), (1, &Value::from("infeasible")));
    // nor a price in the text
    assert!(!longdrive(&[&["optimize"], limits.as_slice()].concat()).out.contains("relaxed"));
}

#[test]
fn exact_sensitivity_and_windows_as_json() {
    let (status, found) =
        json(&["optimum-sensitivity", "--wrt", "swing.speed,gravity", "--change", "swing.speed=+1mph"]);
    assert_eq!((status, &found["status"]), (0, &Value::from("converged")));
    let names: Vec<&String> = found["sensitivity"].as_object().unwrap().keys().collect();
    assert_eq!(names, ["swing.speed", "gravity"]);
    let speed = &found["sensitivity"]["swing.speed"];
    let best = |speed: &str| number(&json(&["optimize", "--set", speed]).1["value"]);
    let slope = (best("swing.speed=49.2744m/s") - best("swing.speed=49.0744m/s")) / 0.2;
    close(number(&speed["value"]), slope, 1.0, 1e-4, "d f*/d speed");
    assert_eq!(number(&speed["optimum"]["swing.attack_angle"]), 0.0);
    let window = &found["window"]["club.loft"];
    let x = number(&found["optimum"]["club.loft"]);
    assert!(number(&window["low"]) < x && x < number(&window["high"]));
    for end in ["low", "high"] {
        let loft = format!("club.loft={:?}rad", number(&window[end]));
        let drive = json(&["simulate", "--set", &loft, "--set", "swing.attack_angle=5deg"]).1;
        close(number(&found["value"]) - number(&drive["flight"]["carry"]), 0.9144, 1.0, 1e-9, "a yard");
    }
    assert_eq!(found["window"]["swing.attack_angle"]["high_limit"], "bound");
    let change = &found["changes"][0];
    let (predicted, anew) = (number(&change["predicted"]["value"]), number(&change["resolved"]["value"]));
    assert!((predicted - anew).abs() < 1e-2, "{change}");
    let text = longdrive(&["optimum-sensitivity"]);
    assert_eq!(text.status, 0);
    for words in ["swing.speed [mph]", "alone, for 1 yd", "together", "by the quadratic"] {
        assert!(text.out.contains(words), "{words}: {}", text.out);
    }
}

#[test]
fn exact_chart_as_json_csv_and_table() {
    let args = ["chart", "--along", "swing.speed=80mph..130mph", "--subject-to", "apex_height <= 35 yd"];
    let (status, chart) = json(&args);
    let points = chart["points"].as_array().unwrap();
    assert_eq!(status, 0);
    assert_eq!(number(&points[0]["at"]), 80.0 * 0.44704);
    assert_eq!(number(&points.last().unwrap()["at"]), 130.0 * 0.44704);
    assert_eq!(points[0]["active"], serde_json::json!(["swing.attack_angle"]));
    assert!(points.last().unwrap()["active"].as_array().unwrap().contains(&Value::from("apex_height <= 35 yd")));
    let csv = longdrive(&[&args, ["--csv"].as_slice()].concat());
    assert!(csv.out.starts_with("swing.speed,carry,club.loft,swing.attack_angle,active,event\n"), "{}", csv.out);
    assert_eq!(csv.out.lines().count(), points.len() + 1);
    assert!(longdrive(&args).out.contains("<- apex_height <= 35 yd begins"));

    // part of the range without an optimum: what there is, and status 1
    let low = ["chart", "--along", "swing.speed=80mph..130mph", "--subject-to", "apex_height >= 36 yd"];
    let (status, chart) = json(&low);
    assert_eq!(status, 1);
    assert!(chart["points"].as_array().unwrap().len() > 5);
    assert!(chart["begun"].as_str().unwrap().contains("no optimum at 80 mph"), "{}", chart["begun"]);
    let (status, chart) = json(&["chart", "--along", "swing.speed=80mph..130mph", "--max-iterations", "0"]);
    assert_eq!((status, chart["points"].as_array().unwrap().len()), (1, 0));
    assert!(chart["ended"].as_str().unwrap().contains("iteration-limit"));
}

#[test]
fn bad_input_to_a_search_is_status_2_and_says_what_to_write() {
    for (args, says) in [
        (vec!["optimize", "--subject-to", "descent_angel >= 38 deg"], "did you mean 'descent_angle'?"),
        (vec!["optimize", "--subject-to", "descent_angle >= 38"], "has no unit"),
        (vec!["optimize", "--subject-to", "descent_angle"], "no sign"),
        (vec!["optimize", "--starts", "0"], "--starts"),
        (vec!["optimize", "--starts", "70000"], "at most 65536"),
        (vec!["optimize", "--checkpoint", "/nowhere/at/all.json"], "cannot be written"),
        (vec!["optimize", "--checkpoint", "."], "it is no file"),
        (vec!["optimum-sensitivity", "--wrt", "club.loft"], "varied itself"),
        (vec!["optimum-sensitivity", "--wrt", "swing.sped"], "did you mean 'swing.speed'?"),
        (vec!["optimum-sensitivity", "--change", "club.loft=+1deg"], "varied itself"),
        (vec!["optimum-sensitivity", "--change", "swing.speed=+5kg"], "not a speed"),
        (vec!["optimum-sensitivity", "--change", "swing.speed"], "write NAME=AMOUNT"),
        (vec!["optimum-sensitivity", "--change", "air.density=-5 kg/m^3"], "outside its range"),
        (vec!["optimum-sensitivity", "--loss", "0 yd"], "above 0"),
        (vec!["optimum-sensitivity", "--loss", "1 kg"], "not a length"),
        (vec!["chart", "--along", "swing.speed=130mph..80mph"], "the range is reversed"),
        (vec!["chart", "--along", "club.loft=5deg..6deg"], "varied itself"),
        (vec!["chart", "--along", "swing.speed=80mph.."], "upper end is missing"),
        (vec!["chart"], "--along"),
        (vec!["simulate", "--set", "flight.step=1e-9s"], "at most"),
    ] {
        let said = longdrive(&args);
        assert_eq!((said.status, said.out.as_str()), (2, ""), "{args:?}: {}", said.err);
        assert!(said.err.contains(says), "{args:?}: {}", said.err);
    }
}

#[test]
fn each_outcome_of_a_gradient_answers_for_itself() {
    let (status, rows) = json(&["gradient", "--of", "launch_angle,carry", "--set", "club.loft=-20deg"]);
    assert_eq!(status, 1);
    close(number(&rows["outcomes"][0]["value"]).to_degrees(), -17.87, 1.0, 1e-2, "launch angle");
    assert!(
        rows["outcomes"][1]["value"].is_null()
            && rows["outcomes"][1]["message"].as_str().unwrap().contains("no flight")
    );
    let (status, rows) =
        json(&["gradient", "--of", "spin_axis,carry,carry", "--set", "club.loft=0rad", "--wrt", "all,gravity"]);
    assert_eq!((status, rows["outcomes"].as_array().unwrap().len()), (1, 2));
    assert!(rows["outcomes"][0]["value"].is_null() && rows["outcomes"][1]["value"].is_null());
}

#[test]
fn a_full_disk_is_an_error() {
    if let Ok(full) = std::fs::OpenOptions::new().write(true).open("/dev/full") {
        let mut program = std::process::Command::new(assert_cmd::cargo::cargo_bin!("longdrive"));
        let output = program.arg("simulate").stdout(full).output().unwrap();
        assert_eq!(output.status.code(), Some(2));
        assert!(String::from_utf8_lossy(&output.stderr).contains("cannot write the answer"));
    }
}
