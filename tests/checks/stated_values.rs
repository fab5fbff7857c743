//! Answers follow the request: stated values are held, all commands have one default preset, and a
//! number needs a unit.

use crate::command_line::{file_with, json, longdrive, number, on_one_line};
use crate::common::close;
use crate::program;
use serde_json::Value;
use std::fs;

const GOLFER: [&str; 4] = [
    "--set",
    "swing.speed=95mph",
    "--set",
    "swing.attack_angle=-2deg",
];

fn names(map: &Value) -> Vec<&str> {
    map.as_object()
        .unwrap()
        .keys()
        .map(String::as_str)
        .collect()
}

#[test]
fn a_stated_attack_angle_is_held_and_the_answer_says_so() {
    let (status, found) = json(&[&["optimize"], &GOLFER[..]].concat());
    assert_eq!(status, 0);
    assert_eq!(names(&found["optimum"]), ["club.loft"]);
    assert_eq!(found["held"], Value::from(vec!["swing.attack_angle"]));
    let title = "tour-average, swing.speed=95mph, swing.attack_angle=-2deg";
    assert_eq!(found["from"], title);
    let attack = number(&found["setup"]["swing.attack_angle"]);
    assert!((attack.to_degrees() + 2.0).abs() < 1e-12, "{attack}");

    let output = longdrive(&[&["optimize"], &GOLFER[..]].concat());
    assert_eq!(output.status, 0);
    let head = format!("from {title}\nheld, as stated: swing.attack_angle -2°\n");
    assert!(output.out.starts_with(&head), "{}", output.out);
}

/// With a held attack angle, the best loft equals the best loft of a search over the loft only.
#[test]
fn same_loft_as_a_search_over_the_loft_alone() {
    let (_, held) = json(&[&["optimize"], &GOLFER[..]].concat());
    let vary = ["--vary", "club.loft=4deg..20deg"];
    let (_, varied) = json(&[&["optimize"], &GOLFER[..], &vary].concat());
    let loft = |found: &Value| number(&found["optimum"]["club.loft"]);
    assert!((loft(&held) - loft(&varied)).abs() < 1e-12);
    assert!(varied.get("held").is_none());
}

#[test]
fn a_stated_value_is_held_in_every_search() {
    let loft = ["--set", "club.loft=10deg"];
    let attack = ["--set", "swing.attack_angle=-2deg"];
    let (_, chart) = json(
        &[
            &["chart", "--along", "swing.speed", "--at", "100mph,110mph"],
            &attack[..],
        ]
        .concat(),
    );
    for point in chart["points"].as_array().unwrap() {
        assert_eq!(names(&point["optimum"]), ["club.loft"]);
    }
    let is_held = Value::from(vec!["swing.attack_angle"]);
    assert_eq!(chart["held"], is_held);
    let goals = ["--maximize", "carry", "--minimize", "apex_height"];
    let pareto = [&["pareto", "--points", "2"], &goals[..], &attack].concat();
    let (_, front) = json(&pareto);
    assert_eq!(names(&front["points"][0]["design"]), ["club.loft"]);
    assert_eq!(front["held"], is_held);
    let output = longdrive(&pareto).out;
    let line = "\nheld, as stated: swing.attack_angle -2°\n";
    assert!(output.contains(line), "{output}");
    let robust = ["robust", "--model", "impact.friction=0.3"];
    let (_, robust) = json(&[&robust, &attack[..]].concat());
    assert_eq!(names(&robust["optimum"]), ["club.loft"]);
    assert_eq!(robust["held"], is_held);
    let (_, sensitivity) =
        json(&[&["optimum-sensitivity", "--wrt", "swing.speed"], &loft[..]].concat());
    assert_eq!(names(&sensitivity["optimum"]), ["swing.attack_angle"]);
    assert_eq!(sensitivity["held"], Value::from(vec!["club.loft"]));
    let (_, effects) = json(&[&["sensitivity", "--at-optimum"], &attack[..]].concat());
    assert_eq!(effects["held"], is_held);
    let folder = tempfile::tempdir().unwrap();
    let pages = folder.path().join("report").display().to_string();
    let (_, report) = json(&[&["report", "-o", &pages], &attack[..]].concat());
    assert_eq!(report["held"], is_held);
    // by default a chart does not vary its own parameter
    let (status, chart) = json(&["chart", "--along", "swing.attack_angle", "--at=-2deg,0deg"]);
    assert_eq!(status, 0);
    assert_eq!(names(&chart["points"][0]["optimum"]), ["club.loft"]);
}

/// A search over swings varies only the loft by default. A stated attack angle is therefore not
/// listed in `held`.
#[test]
fn over_swings_a_stated_attack_angle_is_no_held_parameter() {
    let words = [
        "robust",
        "--maximize",
        "mean(carry)",
        "--distribution",
        "swing.face_angle=normal(0deg,1deg)",
        "--scenarios",
        "16",
        "--model",
        "impact.friction=0.3",
        "--set",
        "swing.attack_angle=-2deg",
    ];
    let (_, robust) = json(&words);
    assert_eq!(names(&robust["optimum"]), ["club.loft"]);
    assert!(robust.get("held").is_none());
}

/// The first line names the swings, as it names settings.
#[test]
fn the_first_line_of_a_search_over_swings_names_them() {
    let swing = "swing.speed=normal(92mph,2mph)";
    for words in [
        &["optimize"][..],
        &["robust", "--model", "impact.friction=0.3"],
        &[
            "pareto",
            "--maximize",
            "lowest(carry, 10%)",
            "--points",
            "3",
        ],
        &["design", "tour-average", "--rules", "none"],
    ] {
        let more = [
            "--maximize",
            "mean(carry)",
            "--loft",
            "11deg",
            "--vary",
            "club.loft=9deg..13deg",
            "--distribution",
            swing,
            "--scenarios",
            "16",
        ];
        let (_, found) = json(&[words, &more[..]].concat());
        let from = found["from"].as_str().unwrap();
        assert_eq!(from, format!("tour-average, club.loft=11deg, {swing}"));
    }
}

/// The longest total is no advice if the ball lands flatter than any measured bounce: the totals
/// are not known then.
#[test]
fn no_advice_rests_on_totals_of_flat_landings() {
    let says = |words: &[&str]| {
        let text = on_one_line(&longdrive(words).out);
        text.contains("--maximize total finds the longest total")
    };
    let steep = ["optimize", "--attack=-3deg"];
    let flat = [
        "optimize",
        "--speed",
        "92mph",
        "--attack=-3deg",
        "--loft",
        "10.5deg",
        "--vary",
        "club.loft=4deg..20deg",
    ];
    assert!(says(&steep) && !says(&flat));
}

/// By default a design varies the loft, unless the loft is stated.
#[test]
fn a_design_holds_a_stated_loft() {
    let words = ["design", "--set", "club.loft=12deg", "--scenarios", "64"];
    let (_, found) = json(&words);
    assert_eq!(
        names(&found["optimum"]),
        ["club.bulge_radius", "club.roll_radius"]
    );
    assert_eq!(found["held"], Value::from(vec!["club.loft"]));
    let loft = number(&found["setup"]["club.loft"]);
    assert!((loft.to_degrees() - 12.0).abs() < 1e-12, "{loft}");
}

/// A drive whose loft and attack angle are stated is drawn without an optimum.
#[test]
fn a_report_of_a_stated_drive_leaves_the_optimum_out() {
    let folder = tempfile::tempdir().unwrap();
    let page = folder.path().join("page").display().to_string();
    let loft = ["--set", "club.loft=10deg"];
    let output = longdrive(&[&["report", "-o", &page], &GOLFER[..], &loft].concat());
    assert_eq!(output.status, 0, "{}", output.err);
    let html = std::fs::read_to_string(folder.path().join("page/index.html")).unwrap();
    assert!(html.contains("its map and its chart are left out"));
}

#[test]
fn a_search_with_nothing_to_vary_is_refused_with_advice() {
    let loft = ["--set", "club.loft=10deg"];
    let output = longdrive(&[&["optimize"], &GOLFER[..], &loft].concat());
    assert_eq!(output.status, 2);
    let message = "nothing is left to vary: club.loft and swing.attack_angle are stated";
    assert!(
        output.err.replace("\n  ", " ").contains(message),
        "{}",
        output.err
    );
    let goals = ["pareto", "--maximize", "carry", "--minimize", "apex_height"];
    let output = longdrive(&[&goals[..], &GOLFER, &loft].concat());
    assert_eq!(output.status, 2);
    assert!(
        output.err.contains("--vary club.loft=4deg..20deg"),
        "{}",
        output.err
    );
}

/// The arguments of the ranges in an error's example: "--vary", "club.loft=4deg..20deg", ….
fn ranges_of_advice(message: &str) -> Vec<String> {
    let (_, example) = message.split_once("for example ").unwrap();
    let words = example.split([' ', ';']);
    let is_of_ranges = |word: &&str| *word == "--vary" || word.contains("..");
    words.take_while(is_of_ranges).map(String::from).collect()
}

#[test]
fn the_ranges_of_an_advice_give_the_answer_if_typed() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.svg").display().to_string();
    let club = ["--speed", "92mph", "--attack", "-3deg", "--loft", "10.5deg"];
    let attack_is_free = ["--loft", "10.5deg"];
    let launch = [
        "--launch",
        "ball_speed=140mph,launch_angle=12deg,spin=3000rpm",
    ];
    let contour = ["plot", "contour", "-o", &file, "--overwrite"];
    let optimum = "'longdrive simulate' flies the drive as stated";
    let slopes = "'longdrive sensitivity' is about the drive as stated";
    let without = "without --at-optimum, the answer is about the drive as stated";
    for (command, stated, instead) in [
        (&contour[..], &club[..], None),
        (&contour, &attack_is_free, None),
        (&contour, &launch, None),
        (&["optimize"], &club, Some(optimum)),
        (&["optimum-sensitivity"], &club, Some(slopes)),
        (&["sensitivity", "--at-optimum"], &club, Some(without)),
    ] {
        let asked = [command, stated].concat();
        let output = longdrive(&asked);
        let message = on_one_line(&output.err);
        assert_eq!(output.status, 2, "{asked:?}: {message}");
        for other in [optimum, slopes, without] {
            assert_eq!(
                message.contains(other),
                Some(other) == instead,
                "{asked:?}: {message}"
            );
        }
        let ranges = ranges_of_advice(&message);
        let typed: Vec<&str> = ranges.iter().map(String::as_str).collect();
        assert_eq!(typed.len(), 4, "{asked:?}: {message}");
        let output = longdrive(&[&asked[..], &typed].concat());
        assert_eq!(output.status, 0, "{asked:?} {typed:?}: {}", output.err);
    }
}

#[test]
fn a_picture_has_the_advice_of_the_command_about_its_drive() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.svg").display().to_string();
    let stated = ["--speed", "92mph", "--attack", "-3deg"];
    let loft = "club.loft 8.8° is the loft of tour-average at 115 mph";
    let shaft = "the loft is for the shaft and strike of tour-average";
    let vary = ["--vary", "club.loft=4deg..20deg"];
    let with_attack = ["--vary", "swing.attack_angle=-5deg..5deg"];
    let along = ["--along", "club.mass=180g..220g"];
    let contour = [&vary[..], &with_attack].concat();
    let chart = [&vary[..], &along].concat();
    for (kind, more, advice) in [
        ("trajectory", &[][..], loft),
        ("tornado", &[], loft),
        ("face", &[], loft),
        ("vcurve", &[], loft),
        ("compare", &["--set-b", "club.loft=10deg"], loft),
        ("launch", &vary, shaft),
        ("fairway", &vary, shaft),
        ("strike", &vary, shaft),
        ("contour", &contour, shaft),
        ("chart", &chart, shaft),
    ] {
        let command = ["plot", kind, "-o", &file, "--overwrite"];
        let command = [&command[..], &stated, more].concat();
        let output = longdrive(&command);
        assert_eq!(output.status, 0, "{kind}: {}", output.err);
        let messages = on_one_line(&output.err);
        assert_eq!(messages.matches(advice).count(), 1, "{kind}: {messages}");
        let (_, answer) = json(&command);
        let told = answer["advice"].as_str().unwrap_or_default();
        assert!(told.contains(advice), "{kind}: {answer}");
    }
}

/// A setup file gives the start of a search, and does not hold its values.
#[test]
fn a_setup_file_states_the_start_and_holds_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.toml");
    std::fs::write(
        &file,
        "preset = \"tour-average\"\n[swing]\nattack_angle = \"-2 deg\"\n",
    )
    .unwrap();
    let (status, found) = json(&["optimize", file.to_str().unwrap()]);
    assert_eq!(status, 0);
    assert_eq!(
        names(&found["optimum"]),
        ["club.loft", "swing.attack_angle"]
    );
    assert!(found.get("held").is_none());
}

#[test]
fn a_file_without_a_preset_begins_from_the_default_of_commands() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.toml");
    std::fs::write(&file, "[swing]\nspeed = \"95 mph\"\n").unwrap();
    let (_, by_file) = json(&["simulate", file.to_str().unwrap()]);
    let (_, by_setting) = json(&["simulate", "--set", "swing.speed=95mph"]);
    assert_eq!(by_file["setup"], by_setting["setup"]);
}

#[test]
fn a_number_without_a_unit_in_a_file_is_refused_with_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.toml");
    std::fs::write(&file, "preset = \"tour-average\"\n[swing]\nspeed = 95\n").unwrap();
    let output = longdrive(&["simulate", "-q", file.to_str().unwrap()]);
    assert_eq!(output.status, 2);
    let place = "mine.toml:3:9: swing.speed: \"95\" has no unit; a speed takes mph";
    assert!(
        output.err.replace("\n  ", " ").contains(place),
        "{}",
        output.err
    );
}

/// The printed carry and total are those of the drives before and after the search.
#[test]
fn carry_and_total_stand_side_by_side_with_the_drive_as_set_up() {
    let (_, before) = json(&["simulate"]);
    let (_, after) = json(&["optimize"]);
    let output = longdrive(&["optimize", "-q"]).out;
    for of in ["carry", "total"] {
        let yards = |drive: &Value| number(&drive["flight"][of]) / 0.9144;
        // the printed gain is the difference of the printed values
        let [before, after] = [&before, &after].map(|drive| (10.0 * yards(drive)).round() / 10.0);
        let text = format!(
            "{of} {before:.1} yd → {after:.1} yd: {:+.1} yd",
            after - before
        );
        assert!(output.contains(&text), "no '{text}' in {output}");
    }
}

#[test]
fn a_setting_of_drive_b_replaces_that_of_both() {
    let words = [
        "--set",
        "swing.speed=95mph",
        "--set-b",
        "swing.speed=100mph",
    ];
    let (status, found) = json(&[&["compare"], &words[..]].concat());
    assert_eq!(status, 0);
    let speed = |drive: &str| number(&found[drive]["setup"]["swing.speed"]) / 0.44704;
    assert!((speed("a") - 95.0).abs() < 1e-9 && (speed("b") - 100.0).abs() < 1e-9);
}

#[test]
fn conflicting_options_are_refused_with_advice() {
    for (words, says) in [
        (
            vec![
                "chart",
                "--along",
                "swing.speed=90mph..100mph",
                "--at",
                "95mph",
            ],
            "for the values write --along swing.speed",
        ),
        (
            vec![
                "optimize",
                "--maximize",
                "carry",
                "--minimize",
                "apex_height",
            ],
            "pareto",
        ),
    ] {
        let output = longdrive(&words);
        assert_eq!(output.status, 2, "{words:?}");
        assert!(
            output.err.replace("\n  ", " ").contains(says),
            "{}",
            output.err
        );
    }
}

#[test]
fn units_are_read_as_people_write_them() {
    let of = |setting: &str, name: &str| {
        let (status, found) = json(&["simulate", "--set", setting]);
        assert_eq!(status, 0, "{setting}");
        number(&found["setup"][name])
    };
    assert!((of("swing.speed=100MPH", "swing.speed") - 44.704).abs() < 1e-12);
    assert!((of("ground.height=-3Yards", "ground.height") + 2.7432).abs() < 1e-12);
    assert!((of("air.temperature=50F", "air.temperature") - 283.15).abs() < 1e-9);
    assert!((of("air.temperature=10 C", "air.temperature") - 283.15).abs() < 1e-9);
    let output = longdrive(&["simulate", "--set", "ground.height=3Mm"]);
    assert_eq!(output.status, 2);
}

/// `--gradient` requests derivatives by the swept parameters, `--wrt` by named ones; a sweep with
/// both options has both.
#[test]
fn a_sweep_has_the_derivatives_of_gradient_and_of_wrt() {
    let swept = longdrive(&[
        "sweep",
        "--over",
        "club.loft=8deg..10deg:2",
        "--gradient",
        "--wrt",
        "swing.speed",
    ]);
    assert_eq!(swept.status, 0, "{}", swept.err);
    for column in ["d_carry/d_club.loft", "d_carry/d_swing.speed"] {
        assert!(swept.out.contains(column), "{column}: {}", swept.out);
    }
}

/// A search may vary a weight that the setup does not have. In the drive as set up this weight is
/// unset.
#[test]
fn same_drive_as_set_up_by_a_search_and_by_simulate() {
    let (_, searched) = json(&["optimize", "--vary", "club.weight_1.mass=0g..40g"]);
    let (_, flown) = json(&["simulate"]);
    close(
        number(&searched["as_set_up"]["carry"]),
        number(&flown["flight"]["carry"]),
        1.0,
        1e-6,
        "carry as set up, within the tolerance of both",
    );
    let before = &searched["as_set_up"]["parameters"]["club.weight_1.mass"];
    assert!(before.is_null(), "{before}");
}

/// On a map at the best speed there is no mark of the setup's own drive, which has another speed.
#[test]
fn a_map_of_another_speed_has_no_mark_of_the_drive_as_set_up() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("map.csv");
    let vary = [
        "club.loft=4deg..20deg",
        "swing.attack_angle=-5deg..5deg",
        "swing.speed=80mph..130mph",
    ];
    let marks = |vary: &[&str]| {
        let vary = vary.iter().flat_map(|vary| ["--vary", vary]);
        let file = file.to_str().unwrap();
        let words = ["plot", "contour", "--overwrite", "-o", file];
        let drawn = longdrive(&words.into_iter().chain(vary).collect::<Vec<_>>());
        assert_eq!(drawn.status, 0, "{}", drawn.err);
        fs::read_to_string(file).unwrap().contains("as set up")
    };
    assert!(marks(&vary[..2]));
    assert!(!marks(&vary));
}

/// A note names the columns of a table of swings that are not read.
#[test]
fn columns_of_a_table_of_swings_that_are_not_read_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let table = file_with(
        folder.path(),
        "swings.csv",
        "swing.speed [mph],carry [yd]\n100,240\n104,250\n102,245\n",
    );
    let found = longdrive(&["optimize", "--swings", &table]);
    assert_eq!(found.status, 0, "{}", found.err);
    assert!(
        on_one_line(&found.err).contains("columns not read"),
        "{}",
        found.err
    );
}

/// A warning names a given value that a model replaces without naming it: a coefficient of the
/// setup's law, a density beside a temperature, the friction of another turf.
#[test]
fn given_values_that_a_model_replaces_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let text = "preset = \"modern-driver\"\nground.friction = 0.5\n";
    let file = &*file_with(folder.path(), "ground.toml", text);
    for (args, name, model) in [
        (
            ["--set", "aero.cd0=0.2"].as_slice(),
            "aero.cd0",
            "aero.law=ferguson",
        ),
        (
            &[
                "--set",
                "air.density=1.1kg/m^3",
                "--model",
                "air.temperature=10degC",
            ],
            "air.density",
            "air.temperature=10degC",
        ),
        (
            &[file, "--model", "ground.turf=firm"],
            "ground.friction",
            "ground.turf=firm",
        ),
    ] {
        let (status, found) = json(&[&["robust"], args].concat());
        let warnings = found["warnings"].to_string();
        assert_eq!(status, 0);
        assert!(
            warnings.contains(&format!(
                "{name} as given has no effect in the model '{model}', which replaces it"
            )),
            "{warnings}"
        );
    }
    let (_, found) = json(&["robust", "--set", "swing.speed=110mph"]);
    assert!(
        !found["warnings"]
            .to_string()
            .contains("has no effect in the model")
    );
}

/// A fit notes that it does not use the uncertainties of measured launches. If no ground is stated,
/// it notes that it compares totals on an assumed ground.
#[test]
fn what_a_fit_assumes_or_does_not_use_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let table = file_with(
        folder.path(),
        "shots.csv",
        "ball_speed [mph],launch_angle [deg],spin [rpm],carry [yd],total [yd],sigma spin [rpm]\n\
         150,12,2600,245,270,1\n151,12,2600,247,271,1\n153,12,2600,250,273,1\n",
    );
    let printed = |more: &[&str]| {
        let words = ["calibrate", &table, "--fit", "aero.cd0"];
        let printed = longdrive(&[&words[..], more].concat());
        on_one_line(&(printed.out + &printed.err))
    };
    let assumed = "compared on a ground that is assumed";
    let text = printed(&[]);
    assert!(
        text.contains("uncertainties of launches are not used"),
        "{text}"
    );
    assert!(text.contains(assumed), "{text}");
    let text = printed(&["--set", "ground.turf=firm"]);
    assert!(!text.contains(assumed), "{text}");
}

#[test]
fn local_optima_of_a_sensitivity_are_listed() {
    let words = ["optimum-sensitivity", "--wrt", "swing.speed"];
    let several = longdrive(&[&words[..], &["--starts", "3"]].concat());
    let one = longdrive(&words);
    assert_eq!((several.status, one.status), (0, 0));
    assert!(several.out.contains("of 3") && !one.out.contains("of 3"));
}

/// Settings of the wind profile have no effect without a roughness, whatever the command.
#[test]
fn a_reference_height_without_a_roughness_is_warned_of_once() {
    let set = ["--set", "wind.reference_height=2m"];
    for command in [
        &["optimize"][..],
        &["gradient"],
        &["robust"],
        &["sensitivity"],
    ] {
        let (_, found) = json(&[command, &set[..]].concat());
        let warnings = found["warnings"].to_string();
        let times = warnings
            .matches("wind.reference_height has no effect")
            .count();
        assert_eq!(times, 1, "{command:?}: {warnings}");
    }
    let varied = ["optimize", "--vary", "wind.roughness=1mm..30mm"];
    let (_, found) = json(&[&varied[..], &set[..]].concat());
    let warnings = found["warnings"].to_string();
    assert!(!warnings.contains("wind.reference_height"), "{warnings}");
    assert!(
        warnings.contains("wind.roughness has no effect: there is no wind"),
        "{warnings}"
    );
}

#[test]
fn a_stated_uncertainty_without_an_effect_has_a_row() {
    let (status, found) = json(&["sensitivity", "--sigma", "ground.friction=0.1"]);
    assert_eq!(status, 0);
    assert!(found.to_string().contains("ground.friction"));
}

/// A column `strokes gained` is not read as the column `strokes`. Two columns of this name are an
/// error.
#[test]
fn the_column_of_strokes_has_exactly_this_name() {
    let folder = tempfile::tempdir().unwrap();
    let found = |heads: &str| {
        let text = format!("{heads}\n5,0.1,2\n100,0.15,2.8\n300,0.18,3.7\n420,0.2,4\n");
        let table = file_with(folder.path(), "strokes.csv", &text);
        let distribution = "swing.speed=normal(100mph,3mph)";
        json(&[
            "optimize",
            "--distribution",
            distribution,
            "--minimize",
            "strokes(420yd)",
            "--strokes",
            &table,
        ])
    };
    let (status, answer) = found("distance [yd],strokes gained,strokes");
    assert_eq!(status, 0);
    assert!(number(&answer["value"]) > 2.0, "{}", answer["value"]);
    let (status, answer) = found("distance [yd],strokes,strokes");
    assert_eq!(status, 2);
    assert!(answer["message"].to_string().contains("is there twice"));
}

/// Sentences about an assumption, each with arguments whose answers have the sentence, and
/// arguments whose answers do not.
#[test]
fn answers_state_an_assumption_where_it_applies_alone() {
    let folder = tempfile::tempdir().unwrap();
    let golfer = folder.path().join("golfer.toml");
    fs::write(
        &golfer,
        "preset = \"tour-average\"\n[swing]\nspeed = \"95 mph\"\n",
    )
    .unwrap();
    let swings = folder.path().join("swings.csv");
    fs::write(&swings, "swing.speed [mph]\n104\n106\n108\n").unwrap();
    let [golfer, swings] = [&golfer, &swings].map(|file| file.to_str().unwrap());
    let is_said = |words: &[&str], line: &str| {
        let printed = longdrive(words);
        assert_eq!(printed.status, 0, "{words:?}: {}", printed.err);
        on_one_line(&(printed.out + &printed.err)).contains(line)
    };
    for (line, with, without) in [
        (
            "club.loft 8.8° is the loft of tour-average at 115 mph",
            &["simulate", "--speed", "95mph"][..],
            &["simulate", "--speed", "95mph", "--loft", "12deg"][..],
        ),
        (
            "club.loft 8.8° is the loft of tour-average at 115 mph",
            &[
                "compare",
                "--speed",
                "95mph",
                "--set-b",
                "swing.speed=100mph",
            ],
            &["compare", "--set-b", "club.loft=12deg"],
        ),
        (
            "club.loft 8.8° is the loft of tour-average at 115 mph",
            &["gradient", "--speed", "95mph", "--wrt", "swing.speed"],
            &["gradient", "--speed", "115mph", "--wrt", "swing.speed"],
        ),
        (
            "swing.speed of the only launch is more than 3 prior standard deviations from 115",
            &[
                "delivery",
                "--ball-speed",
                "240mph",
                "--launch-angle",
                "12deg",
                "--spin",
                "2600rpm",
            ],
            &[
                "delivery",
                "--ball-speed",
                "150mph",
                "--launch-angle",
                "12deg",
                "--spin",
                "2600rpm",
            ],
        ),
        (
            "wind from 0°: 10.00 mph tail wind",
            &["simulate", "--wind=-10mph", "--set", "wind.from=0deg"],
            &["simulate", "--wind=10mph", "--set", "wind.from=0deg"],
        ),
        (
            "gear effect of strikes off the centre is known to about 30 %",
            &["simulate", "--set", "strike.toe=15mm"],
            &["simulate", "--set", "strike.high=5mm"],
        ),
        (
            "lowest(carry, 10%): mean carry of the lowest 10 % of the swings",
            &[
                "optimize",
                "--swings",
                swings,
                "--maximize",
                "lowest(carry, 10%)",
            ],
            &["optimize", "--swings", swings, "--maximize", "mean(carry)"],
        ),
        (
            "their means: swing.speed 106.00 mph (in the setup 95.00 mph)",
            &["optimize", golfer, "--swings", swings],
            &["optimize", "--swings", swings],
        ),
    ] {
        assert!(is_said(with, line), "{with:?}");
        assert!(!is_said(without, line), "{without:?}");
    }
}

/// A value that a setup states, and that a range or a setting replaces, is refused from standard
/// input as from a file.
#[test]
fn same_refusal_of_a_setup_from_standard_input_and_from_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let text = "[air]\ndensity = \"1.1 kg/m^3\"\n";
    let file = file_with(folder.path(), "dense.toml", text);
    let says = "air.density and air.temperature are both given";
    for arguments in [
        &["simulate", "--temperature", "50F"][..],
        &["optimize", "--vary", "air.temperature=40F..60F"],
        &["sweep", "--over", "air.temperature=40F..60F:2"],
    ] {
        let command = |setup: &str| {
            let mut command = program::command();
            command.arg(arguments[0]).arg(setup).args(&arguments[1..]);
            command
        };
        let by_name = command(&file).output().unwrap();
        let input = fs::File::open(&file).unwrap();
        let by_input = command("-").stdin(input).output().unwrap();
        for output in [by_name, by_input] {
            let message = String::from_utf8(output.stderr).unwrap();
            assert!(
                output.status.code() == Some(2) && message.contains(says),
                "{arguments:?}: {message}"
            );
        }
    }
}

/// A law, a table or a turf of the command line replaces numbers of the setup file. A warning names
/// them.
#[test]
fn numbers_of_a_file_that_a_stated_law_or_turf_replaces_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let text =
        "preset = \"tour-average\"\n[aero]\ncd0 = 0.2\n[ground]\nfriction = 0.1\nrolling = 1.2\n";
    let file = &*file_with(folder.path(), "own.toml", text);
    for (setting, says) in [
        (
            "aero.law=ferguson",
            format!("aero.cd0 of {file} is replaced by --set aero.law=ferguson"),
        ),
        (
            "ground.turf=firm",
            format!(
                "ground.friction, ground.rolling of {file} are replaced by --set ground.turf=firm"
            ),
        ),
    ] {
        let (status, found) = json(&["simulate", file, "--set", setting]);
        assert_eq!(status, 0);
        assert!(
            found["warnings"].to_string().contains(&says),
            "{}",
            found["warnings"]
        );
    }
    let (_, found) = json(&[
        "simulate",
        file,
        "--set",
        "aero.law=ferguson",
        "--set",
        "aero.cd0=0.2",
    ]);
    assert!(!found["warnings"].to_string().contains("replaced"));
}

/// Every command warns of a stated value on which none of its drives depends. There is no warning
/// if a varied parameter or the other drive gives the value an effect.
#[test]
fn stated_values_without_an_effect_are_named_in_every_command() {
    let profile = ["--set", "wind.reference_height=3m"];
    let says = "wind.reference_height has no effect: without wind.roughness";
    let sweep = [
        "sweep",
        "--over",
        "wind.downrange=-5mph..5mph:2",
        "--outcomes",
        "carry",
    ];
    let compare = ["compare", "--set-b", "wind.downrange=5mph"];
    let shots = [
        "fly",
        concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/shots.csv"),
        "--quiet",
    ];
    for command in [&sweep[..], &compare, &shots] {
        let output = longdrive(&[command, &profile].concat());
        assert!(
            on_one_line(&output.err).contains(says),
            "{command:?}: {}",
            output.err
        );
    }
    let rough = ["--over", "wind.roughness=1mm..2mm:2"];
    let output = longdrive(&[&sweep[..], &rough, &profile].concat());
    assert!(!output.err.contains("no effect"), "{}", output.err);
    let rough = ["--set-b", "wind.roughness=1mm"];
    let output = longdrive(&[&compare[..], &rough, &profile].concat());
    assert!(!output.err.contains("no effect"), "{}", output.err);
    for (settings, says) in [
        (
            ["ground.turf=wet", "ground.slope=2deg"],
            "ground.slope has no effect: the ball stays",
        ),
        (
            ["swing.shaft_bend=0deg", "swing.shaft_growth=1"],
            "swing.shaft_growth has no effect",
        ),
        (
            ["impact.friction=0", "impact.tangential_restitution=0.1"],
            "impact.tangential_restitution has no effect: impact.friction is 0",
        ),
        (
            ["wind.speed=0mph", "wind.from=20deg"],
            "wind.from has no effect: wind.speed is 0",
        ),
    ] {
        let output = longdrive(&["simulate", "--set", settings[0], "--set", settings[1]]);
        assert!(
            on_one_line(&output.err).contains(says),
            "{settings:?}: {}",
            output.err
        );
    }
}

/// The plot of laws depends on law, air and ball only.
#[test]
fn a_stated_speed_without_an_effect_on_a_plot_of_laws_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("laws.csv").display().to_string();
    let plot = ["plot", "laws", "--overwrite", "-o", &file];
    let output = longdrive(&[&plot[..], &["--speed", "90mph"]].concat());
    let says = "swing.speed: no effect on this plot";
    assert!(on_one_line(&output.err).contains(says), "{}", output.err);
    let output = longdrive(&[&plot[..], &["--temperature", "30degC"]].concat());
    assert!(!output.err.contains("no effect"), "{}", output.err);
}

/// A note says where the search begins in every command that searches.
#[test]
fn every_search_says_where_a_stated_and_varied_parameter_begins() {
    let folder = tempfile::tempdir().unwrap();
    let vary = ["--vary", "club.loft=4deg..8deg", "--loft", "10deg"];
    let plot = folder.path().join("plot.csv").display().to_string();
    let page = folder.path().join("page").display().to_string();
    for command in [
        &["optimize"][..],
        &["sensitivity", "--at-optimum"],
        &["report", "-o", &page],
        &["plot", "fairway", "-o", &plot],
    ] {
        let output = longdrive(&[command, &vary].concat());
        let says = "the search from the setup begins at 8°, the end of its range";
        assert!(
            on_one_line(&output.err).contains(says),
            "{command:?}: {}",
            output.err
        );
    }
    let fit = ["--fit", "aero.cd0=0.2..0.3", "--set", "aero.cd0=0.1"];
    let output = longdrive(
        &[
            &[
                "calibrate",
                concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/shots.csv"),
                "modern-driver",
            ],
            &fit[..],
        ]
        .concat(),
    );
    assert!(
        on_one_line(&output.err)
            .contains("aero.cd0 is varied; the search from the setup begins at 0.2"),
        "{}",
        output.err
    );
}

/// Columns of a table may complete the wind of the setup.
#[test]
fn the_rows_of_shots_may_give_the_speed_of_a_stated_wind() {
    let folder = tempfile::tempdir().unwrap();
    let head = "ball_speed [mph],launch_angle [deg],backspin [rpm],wind.speed [mph]\n";
    let rows = "160,11,2500,3\n165,10,2600,0\n";
    let shots = &*file_with(folder.path(), "shots.csv", &format!("{head}{rows}"));
    let from = ["--set", "wind.from=0deg", "--of", "carry"];
    let windy = longdrive(&[&["fly", shots], &from[..]].concat());
    assert_eq!(windy.status, 0, "{}", windy.err);
    let own = longdrive(&[&["fly", shots, "--own-step"], &from[..]].concat());
    assert_eq!(windy.out, own.out);
    let measured = "160,11,2500,3,250\n165,10,2600,0,255\n";
    let head = head.replace('\n', ",carry [yd]\n");
    let table = &*file_with(folder.path(), "measured.csv", &format!("{head}{measured}"));
    let fit = ["--fit", "aero.cd0", "--set", "wind.from=0deg"];
    let fitted = longdrive(&[&["calibrate", table, "modern-driver"], &fit[..]].concat());
    assert_eq!(fitted.status, 0, "{}", fitted.err);
    // without the column the wind is incomplete
    let head = head.replace("wind.speed [mph]", "note");
    let table = &*file_with(folder.path(), "calm.csv", &format!("{head}{measured}"));
    let refused = longdrive(&[&["calibrate", table, "modern-driver"], &fit[..]].concat());
    assert_eq!(refused.status, 2);
    assert!(
        refused
            .err
            .contains("wind.from is given without wind.speed"),
        "{}",
        refused.err
    );
}

/// The advice on an average loft does not depend on how the preset is named. JSON has the advice
/// too.
#[test]
fn advice_on_the_loft_of_an_average_preset_reaches_files_and_json() {
    let folder = tempfile::tempdir().unwrap();
    let slow = "preset = \"tour-average\"\n[swing]\nspeed = \"95 mph\"\n";
    let file = &*file_with(folder.path(), "slow.toml", slow);
    let (_, by_name) = json(&["simulate", "--speed", "95mph"]);
    let (_, by_file) = json(&["simulate", file]);
    let advice = by_name["advice"].as_str().unwrap();
    assert!(
        advice.contains("8.8° is the loft of tour-average at 115 mph"),
        "{advice}"
    );
    assert_eq!(by_file["advice"], by_name["advice"]);
    let lofted = &*file_with(
        folder.path(),
        "lofted.toml",
        &format!("{slow}[club]\nloft = \"12 deg\"\n"),
    );
    let (_, own) = json(&["simulate", lofted]);
    assert!(own["advice"].is_null());
    let (_, best) = json(&["optimize", file]);
    assert!(
        best["advice"]
            .as_str()
            .unwrap()
            .contains("the shaft and strike of tour-average")
    );
    let (_, best) = json(&["optimize", file, "--set", "swing.shaft_lean=1deg"]);
    assert!(best["advice"].is_null());
    let launch = [
        "--ball-speed",
        "140mph",
        "--launch-angle",
        "12deg",
        "--spin",
        "2600rpm",
    ];
    let output = longdrive(&[&["delivery", file], &launch[..]].concat());
    assert!(
        on_one_line(&output.err).contains("is the loft of tour-average"),
        "{}",
        output.err
    );
}

/// A measured ball has already left the cold club; the same temperature has a warning for a swing.
#[test]
fn a_cold_ball_has_a_warning_only_where_a_club_strikes_it() {
    let cold = ["--temperature", "40F"];
    let says = "a cold ball is slower too";
    let launch = [
        "--launch",
        "ball_speed=150mph,launch_angle=12deg,backspin=2600rpm",
    ];
    for command in [
        &["simulate"][..],
        &["chart", "--along", "swing.speed", "--at", "100mph,110mph"],
        &[
            "pareto",
            "--maximize",
            "carry",
            "--minimize",
            "apex_height",
            "--points",
            "2",
        ],
        &["sweep", "--over", "club.loft=8deg..9deg:2"],
    ] {
        let output = longdrive(&[command, &cold].concat());
        assert!(
            on_one_line(&output.err).contains(says),
            "{command:?}: {}",
            output.err
        );
    }
    for command in [
        &["simulate", launch[0], launch[1]][..],
        &[
            "fly",
            concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/shots.csv"),
        ],
    ] {
        let output = longdrive(&[command, &cold].concat());
        assert!(
            !on_one_line(&output.err).contains(says),
            "{command:?}: {}",
            output.err
        );
    }
}

/// A warning is given once, also where both ends of a range cause it.
#[test]
fn a_warning_of_a_range_is_given_once() {
    let cold = [
        "sweep",
        "--over",
        "air.temperature=50F..60F:2",
        "--outcomes",
        "carry",
    ];
    let output = longdrive(&cold);
    assert_eq!(
        output.err.matches("a cold ball is slower").count(),
        1,
        "{}",
        output.err
    );
    let high = [
        "sweep",
        "--over",
        "air.altitude=0m..1600m:2",
        "--outcomes",
        "carry",
    ];
    let output = longdrive(&[&high[..], &["--units", "metric"]].concat());
    let text = on_one_line(&output.err);
    assert_eq!(
        text.matches("is given without air.temperature").count(),
        1,
        "{text}"
    );
    assert!(text.contains("air.altitude = 1600 m"), "{text}");
    let idle = [
        "--set",
        "swing.shaft_bend=0deg",
        "--set",
        "swing.shaft_growth=2",
    ];
    let output = longdrive(&[&["compare", "--set-b", "club.loft=9deg"], &idle[..]].concat());
    assert_eq!(
        output
            .err
            .matches("swing.shaft_growth has no effect")
            .count(),
        1,
        "{}",
        output.err
    );
}

/// A value that one of the models uses has an effect.
#[test]
fn a_value_that_one_model_uses_has_no_warning() {
    let friction = ["--set", "impact.tangential_restitution=0.3"];
    let output = longdrive(&[&["robust", "--model", "impact.friction=0"], &friction[..]].concat());
    assert!(!output.err.contains("has no effect"), "{}", output.err);
}

/// A delivery depends on the impact only, and a launch has no loft.
#[test]
fn a_delivery_has_no_warning_of_the_air_and_a_launch_no_advice_on_the_loft() {
    let launch = [
        "--ball-speed",
        "140mph",
        "--launch-angle",
        "12deg",
        "--spin",
        "2600rpm",
    ];
    let output = longdrive(&[&["delivery", "--temperature", "50F"], &launch[..]].concat());
    assert!(
        !output.err.contains("changes the air alone"),
        "{}",
        output.err
    );
    let folder = tempfile::tempdir().unwrap();
    let slow = "preset = \"tour-average\"\n[swing]\nspeed = \"95 mph\"\n";
    let file = &*file_with(folder.path(), "slow.toml", slow);
    let launch = [
        "--launch",
        "ball_speed=150mph,launch_angle=12deg,spin=2600rpm",
    ];
    let (_, found) = json(&[&["simulate", file], &launch[..]].concat());
    assert!(found["advice"].is_null(), "{}", found["advice"]);
    let (_, found) = json(&[
        "fly",
        concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/shots.csv"),
        file,
    ]);
    assert!(found["advice"].is_null(), "{}", found["advice"]);
}
