//! `calibrate` on the command line: tolerance, rows that do not fly or that dominate, and options
//! that are refused before the work.

use crate::command_line::{json, longdrive, on_one_line};

const SHOTS: [&str; 4] = ["calibrate", "examples/shots.csv", "--fit", "aero.cd0"];

#[test]
fn a_tolerance_is_honoured() {
    let with = |more: &[&str]| longdrive(&[&SHOTS[..], more].concat());
    let output = with(&["--tolerance=1m"]);
    assert!(
        output.status == 0
            && output.err.contains("method ")
            && output.err.contains("lengths are within"),
        "{}",
        output.err
    );
    // the default tolerance is a micrometre; a tolerance of a metre shows in the residuals
    let sum = |more: &[&str]| json(&[&SHOTS[..], more].concat()).1["chi_square"].clone();
    assert_eq!(sum(&["--tolerance=1um"]), sum(&[]));
    assert!(sum(&[]) != sum(&["--tolerance=1m"]) && sum(&[]) != sum(&["--own-step"]));
    let (status, fine) = json(&[&SHOTS[..], &["--tolerance=1um"]].concat());
    let setup = &fine["setup"];
    assert!(status == 0 && setup["flight.method"] == "dp8", "{setup}");
    let output = with(&["--tolerance=0m"]);
    assert!(
        output.status == 2
            && output
                .err
                .contains("--tolerance: \"0m\" is no tolerance; give a length above 0"),
        "{}",
        output.err
    );
    // drives at the ends of a fitted range are flown to choose the step
    assert_eq!(
        with(&["--fit", "aero.cl_max=0.2..1", "--tolerance=1mm"]).status,
        0
    );
    let deliveries = "club.loft [deg],swing.speed [mph],carry [yd]\n9,100,240\n11,110,270\n";
    let (_folder, path) = crate::sweep::table("deliveries.csv", deliveries);
    let output = longdrive(&[
        "calibrate",
        path.to_str().unwrap(),
        "--fit",
        "aero.cd0",
        "--tolerance",
    ]);
    assert!(
        output.status == 0 && output.err.contains("lengths are within"),
        "{}",
        output.err
    );
}

#[test]
fn diverging_rows_are_listed_once_with_their_advice() {
    let output = longdrive(&[&SHOTS[..], &["--set", "flight.step=2s"]].concat());
    assert_eq!(output.status, 1);
    assert_eq!(output.err.matches("diverge").count(), 1, "{}", output.err);
    assert!(
        output
            .err
            .contains("rows 1 to 12: the flight diverges; the step is long; reduce flight.step"),
        "{}",
        output.err
    );
    assert!(
        !output.err.contains("out"),
        "the message names a row: {}",
        output.err
    );
    let output = longdrive(
        &[
            &SHOTS[..],
            &["--own-step", "--set", "air.density=900kg/m^3"],
        ]
        .concat(),
    );
    assert!(
        output.err.contains("air.density") && !output.err.contains("flight.step"),
        "{}",
        output.err
    );
}

#[test]
fn a_range_of_one_value_is_refused() {
    let output = longdrive(&[
        "calibrate",
        "examples/shots.csv",
        "--fit",
        "aero.cd0=0.2..0.2",
    ]);
    assert!(
        output.status == 2 && output.err.contains("aero.cd0 is the single value 0.2"),
        "{}",
        output.err
    );
}

/// A table of deliveries with stated uncertainties; the carry of the last row is an argument.
fn deliveries(carry: &str) -> (tempfile::TempDir, std::path::PathBuf) {
    let head = "swing.speed [mph],club.loft [deg],carry [yd],sigma carry [yd]";
    crate::sweep::table(
        "deliveries.csv",
        format!("{head}\n100,10.5,240,3\n105,10.5,251,3\n110,10.5,{carry},3\n"),
    )
}

#[test]
fn rows_that_do_not_fly_are_no_answer_and_not_bad_input() {
    let (_folder, path) = deliveries("262");
    let requested = ["calibrate", path.to_str().unwrap(), "--fit", "aero.cd0"];
    for (set, status) in [
        ("flight.step=2s", "diverged"),
        ("swing.attack_angle=-60deg", "no-flight"),
    ] {
        let (code, answer) = json(&[&requested[..], &["--set", set]].concat());
        assert_eq!(
            (code, answer["status"].as_str()),
            (1, Some(status)),
            "{answer}"
        );
        assert!(
            answer["message"].as_str().unwrap().contains("rows 1 to 3"),
            "{answer}"
        );
    }
    // a row that does not fly is named by its number
    let (_folder, path) = crate::sweep::table(
        "one.csv",
        "carry [yd],swing.attack_angle [deg]\n200,2\n10,-60\n",
    );
    let output = longdrive(&["calibrate", path.to_str().unwrap(), "--fit", "aero.cd0"]);
    assert!(
        output.status == 1 && output.err.contains("row 2: no flight"),
        "{}",
        output.err
    );
}

/// Wind and ball size change the carries of three deliveries in the same way, so the data do not
/// determine both. The search stalls in this direction.
#[test]
fn a_search_that_stalls_where_the_data_determine_nothing_ends_undetermined() {
    let (_folder, path) = deliveries("262");
    let (status, answer) = json(&[
        "calibrate",
        path.to_str().unwrap(),
        "--fit",
        "wind.downrange",
        "--fit",
        "ball.radius",
    ]);
    assert_eq!(
        (status, answer["status"].as_str()),
        (1, Some("undetermined")),
        "{}",
        answer["message"]
    );
    let warning = answer["warnings"]
        .as_array()
        .unwrap()
        .last()
        .unwrap()
        .as_str()
        .unwrap();
    assert!(
        warning.starts_with("the fit ended as 'undetermined': the data do not determine"),
        "{warning}"
    );
    let message = answer["message"].as_str().unwrap();
    assert!(
        message.contains("the data do not determine wind.downrange and ball.radius separately"),
        "{message}"
    );
}

/// The change of the density of air, kg/m³, in the first direction that one shot does not
/// determine. The direction begins with a wind of `one`.
fn density_change(system: &str, one: &str) -> f64 {
    let fit = [
        "wind.downrange=-2m/s..2m/s",
        "wind.up=-2m/s..2m/s",
        "ball.mass=45g..46g",
        "air.density=1.0kg/m^3..1.4kg/m^3",
    ];
    let fit = fit.iter().flat_map(|range| ["--fit", range]);
    let mut arguments = vec!["calibrate", "examples/shots.csv", "--only", "Shot=1"];
    arguments.extend(["--units", system]);
    arguments.extend(fit);
    let text = on_one_line(&longdrive(&arguments).out);
    let begin = format!("do not determine a change of wind.downrange by {one} with wind.up by ");
    let (_, direction) = text.split_once(&begin).expect(&text);
    let (_, density) = direction.split_once("air.density by ").unwrap();
    let (number, _) = density.split_once(" kg/m³").unwrap();
    number.parse().unwrap()
}

/// 1 mph is 0.44704 m/s, and both systems measure the density in kg/m³.
#[test]
fn exact_units_of_directions_that_the_data_do_not_determine() {
    let metric = density_change("metric", "+1.00 m/s");
    let us = density_change("us", "+1.00 mph");
    assert!((us / metric - 0.44704).abs() < 1e-3, "{us} {metric}");
}

#[test]
fn a_row_that_decides_alone_outweighs_the_others() {
    let apexes = |last: &str| {
        let head =
            "swing.speed [mph],club.loft [deg],apex_downrange [yd],sigma apex_downrange [yd]";
        crate::sweep::table(
            "apexes.csv",
            format!("{head}\n100,10.5,153,1\n105,10.5,166,1\n110,10.5,{last},3\n"),
        )
    };
    for (apex, huber, ends) in [("1e9", false, "outweighed"), ("1e9", true, "converged")] {
        let (_folder, path) = apexes(apex);
        let loss = if huber { &["--huber"][..] } else { &[] };
        let (_, answer) = json(
            &[
                &["calibrate", path.to_str().unwrap(), "--fit", "aero.cd0"],
                loss,
            ]
            .concat(),
        );
        assert_eq!(
            answer["status"], ends,
            "{apex} {huber}: {}",
            answer["message"]
        );
        assert_eq!(
            answer["message"]
                .as_str()
                .unwrap()
                .contains("row 3: apex_downrange is 3.3e8"),
            !huber
        );
    }
    // an ordinary outlier increases χ², and the other rows keep their weight
    for (_folder, path) in [deliveries("290"), apexes("187")] {
        assert_eq!(
            json(&["calibrate", path.to_str().unwrap(), "--fit", "aero.cd0"]).1["status"],
            "converged"
        );
    }
}

#[test]
fn options_of_the_cross_validation_are_refused_before_any_fit() {
    let (_folder, path) = deliveries("262");
    let few = ["calibrate", path.to_str().unwrap(), "--fit", "aero.cd0"];
    for (requested, more, message) in [
        (
            &SHOTS[..],
            &["--folds", "5", "--compare", "nosuch"][..],
            "unknown aerodynamic law 'nosuch'",
        ),
        (
            &SHOTS,
            &["--folds", "13"],
            "13 folds cannot be made of 12 rows; cross-validation needs 2 folds or more",
        ),
        (
            &SHOTS,
            &["--folds", "1"],
            "1 fold cannot be made of 12 rows",
        ),
        (
            &few,
            &["--compare", "smits-smith"],
            "--compare smits-smith: calibration: ",
        ),
        (
            &few,
            &["--fit", "aero.cd1", "--fit", "aero.cd2", "--folds", "3"],
            "fewer than the 3 parameters to fit; use more folds",
        ),
    ] {
        let output = longdrive(&[requested, more].concat());
        assert!(
            output.status == 2 && output.err.contains(message),
            "{more:?}: {}",
            output.err
        );
        assert!(
            !output.err.contains("iteration"),
            "{more:?}: {}",
            output.err
        );
    }
}

#[test]
fn a_parameter_that_every_row_gives_is_not_set() {
    let (_folder, path) = deliveries("262");
    let requested = ["calibrate", path.to_str().unwrap(), "--fit", "aero.cd0"];
    let output = longdrive(&[&requested[..], &["--set", "swing.speed=80mph"]].concat());
    let message = "has a value of its own, so this one is not used";
    assert!(
        output.status == 2
            && output.err.contains("--set swing.speed: ")
            && output.err.contains(message),
        "{}",
        output.err
    );
    // a set value of a fitted parameter is the start of the fit
    assert_eq!(
        longdrive(&[&requested[..], &["--set", "aero.cd0=0.3"]].concat()).status,
        0
    );
}

#[test]
fn the_ends_of_any_interval_print_differently() {
    let head = "ball_speed [m/s],launch_angle [rad],backspin [rad/s],carry [m]";
    let text = format!("{head}\n70,0.17,260,234.2245103735799\n60,0.2,300,191.61067820714257\n");
    let (_folder, path) = crate::sweep::table("exact.csv", text);
    let output = longdrive(&[
        "calibrate",
        path.to_str().unwrap(),
        "--fit",
        "air.viscosity",
    ]);
    let row = output
        .out
        .lines()
        .find(|line| line.contains("air.viscosity  "))
        .unwrap();
    let (before, after) = row.split_once(" .. ").unwrap();
    let low = before.rsplit("  ").next().unwrap();
    assert!(output.status == 0 && low.trim() != after.trim(), "{row}");
}

#[test]
fn rows_that_do_not_fly_are_reported_by_an_example_without_a_missing_club() {
    let head = "ball_speed [mph],launch_angle [deg],backspin [rpm],carry [yd]";
    let text =
        format!("{head}\n160,10,2500,250\n150,11,2500,240\n160,-3,2500,250\n150,-4,2500,240\n");
    let (_folder, path) = crate::sweep::table("down.csv", text);
    let output = longdrive(&["calibrate", path.to_str().unwrap(), "--fit", "aero.cd0"]);
    let words = on_one_line(&output.err);
    assert!(
        words.contains("rows 3, 4, for example row 3: no flight"),
        "{words}"
    );
    assert!(
        words.contains("increase the launch angle (with a club: by more loft or attack angle)"),
        "{words}"
    );
}

/// A table of launches with an additional column `head`: three rows with the value `usual`, and the
/// row `last`.
fn launches(head: &str, usual: &str, last: &str) -> (tempfile::TempDir, std::path::PathBuf) {
    let rows = format!("150,12,2500,{usual}\n155,12,2500,{usual}\n160,12,2500,{usual}\n{last}\n");
    crate::sweep::table(
        "launches.csv",
        format!("ball_speed [mph],launch_angle [deg],spin [rpm],{head}\n{rows}"),
    )
}

#[test]
fn impossible_values_are_refused_with_row_column_value_and_range() {
    let carry = ["carry [yd]", "246"];
    for ([head, usual], last, says) in [
        (
            carry,
            "160,12,2500,825",
            "row 4, column carry: 825 yd is outside of the range of drives, above 0 to 600 yd",
        ),
        (
            ["descent_angle [deg]", "38"],
            "160,12,2500,195",
            "row 4, column descent_angle: 195 deg is outside of the range of drives, above 0 to 90 \
             deg",
        ),
        (
            ["flight_time [s]", "6"],
            "160,12,2500,65",
            "row 4, column flight_time: 65 s is outside",
        ),
        (
            ["carry [yd],spin_axis [deg]", "246,1"],
            "160,12,2500,250,195",
            "row 4: spin_axis: 195 deg is outside of the range of drives, -180 to 180 deg",
        ),
        (
            carry,
            "160,195,2500,250",
            "row 4: launch_angle: 195 deg is outside of the range of drives, -90 to 90 deg",
        ),
        (
            carry,
            "420,12,2500,250",
            "row 4: ball_speed: 420 mph is outside of the range of drives, above 0 to 270 mph",
        ),
        (
            carry,
            "160,12,25000,250",
            "row 4: spin: 25000 rpm is outside",
        ),
    ] {
        let (_folder, path) = launches(head, usual, last);
        let output = longdrive(&["calibrate", path.to_str().unwrap(), "--fit", "aero.cd0"]);
        assert!(
            output.status == 2 && output.err.contains(says),
            "{says}: {}",
            output.err
        );
        assert!(
            output.err.contains("check the value and its unit"),
            "{}",
            output.err
        );
    }
    // exports write 0 for a missing spin, but 0 may also be measured: such a row is no error
    let (_folder, path) = launches("carry [yd]", "246", "160,20,0,200");
    let output = longdrive(&["calibrate", path.to_str().unwrap(), "--fit", "aero.cd0"]);
    assert!(output.status == 0, "{}", output.err);
}

#[test]
fn a_table_without_a_swing_says_which_swing_all_its_rows_are_compared_with() {
    let (_folder, path) = crate::sweep::table(
        "carries.csv",
        "carry [yd],apex_height [yd]\n280,33\n285,34\n282,32\n",
    );
    let file = path.to_str().unwrap();
    let (_, found) = json(&["calibrate", file, "--fit", "aero.cd0"]);
    let message = found["warnings"][0].as_str().unwrap();
    for says in [
        "has neither a whole launch (ball_speed, launch_angle, and spin or backspin) nor a column \
         of swing, club",
        "all 3 rows are compared with one drive, that of the setup: swing.speed 115 mph, \
         swing.attack_angle -0.9 deg, club.loft 8.8 deg",
    ] {
        assert!(message.contains(says), "{says}: {message}");
    }
    let output = longdrive(&[
        "calibrate",
        file,
        "--fit",
        "aero.cd0",
        "--fit",
        "swing.speed=100mph..120mph",
    ]);
    assert!(
        output
            .err
            .contains("swing.speed as it is fitted, swing.attack_angle"),
        "{}",
        output.err
    );
    // a row without spin has no launch: it is compared with the launch of the setup's swing
    let (_folder, path) = crate::sweep::table(
        "shots.csv",
        "ball_speed [mph],launch_angle [deg],carry [yd]\n165,12,270\n170,11,280\n",
    );
    let (_, found) = json(&["calibrate", path.to_str().unwrap(), "--fit", "aero.cd0"]);
    assert!(
        found["warnings"]
            .to_string()
            .contains("all 2 rows are compared with one drive"),
        "{found}"
    );
    for whole in [
        launches("carry [yd]", "246", "160,12,2500,255"),
        deliveries("262"),
    ] {
        let (_, found) = json(&["calibrate", whole.1.to_str().unwrap(), "--fit", "aero.cd0"]);
        assert!(
            !found["warnings"].to_string().contains("one drive"),
            "{found}"
        );
    }
}
