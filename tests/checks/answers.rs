//! The text of a command begins with its result, fits the height and width of a screen, and names
//! the setup.

use crate::command_line::{Output, json, longdrive, number, on_one_line, widest};
use crate::common::close;
use crate::program;
use longdrive::{Drive, Outcome, Setup};
use serde_json::Value;

/// Number of lines of a screen.
const SCREEN: usize = 40;

/// Runs a command in a terminal with this number of columns; `None` for a pipe.
fn in_columns(columns: Option<usize>, words: &[&str]) -> Output {
    let mut command = program::command();
    command.args(words).env_remove("COLUMNS");
    if let Some(columns) = columns {
        command.env("COLUMNS", columns.to_string());
    }
    let output = command.output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    Output {
        status: output.status.code().unwrap(),
        out: text(output.stdout),
        err: text(output.stderr),
    }
}

#[test]
fn long_answers_fit_a_screen_and_all_prints_the_rest() {
    for words in [
        &["optimize"][..],
        &["optimum-sensitivity"],
        &["uncertainty", "--samples", "128"],
        &["design", "--scenarios", "64"],
        &["validate"],
        &["parameters"],
    ] {
        let short = in_columns(Some(80), words);
        assert_eq!(short.status, 0, "{words:?}: {}", short.err);
        let lines = short.out.lines().count();
        assert!(
            lines <= SCREEN,
            "{words:?} has {lines} lines:\n{}",
            short.out
        );
        let all = in_columns(Some(80), &[words, &["--all"]].concat());
        assert!(!all.out.contains("--all"), "{words:?}: {}", all.out);
        let is_whole = words[0] == "optimize";
        assert_eq!(short.out.contains("--all"), !is_whole, "{words:?}");
        assert_eq!(short.out == all.out, is_whole, "{words:?}");
    }
}

#[test]
fn text_and_help_wrap_to_the_terminal() {
    let answers = [
        &["simulate"][..],
        &["optimize"],
        &["optimum-sensitivity"],
        &["compare", "--set-b", "club.loft=12deg"],
        &["uncertainty", "--samples", "128"],
        &["parameters"],
        &["presets"],
        &["--help"],
        &["optimize", "--help"],
        &["delivery", "--help"],
    ];
    for words in answers {
        for (columns, most) in [(Some(60), 60), (Some(80), 80), (Some(120), 120), (None, 80)] {
            let printed = in_columns(columns, words);
            let text = printed.out + &printed.err;
            let wide: Vec<_> = text.lines().filter(|line| widest(line) > most).collect();
            // a table of two columns and a single word may be wider than the terminal
            let is_table = |line: &str| line.trim().split("  ").count() > 1;
            let is_word = |line: &str| line.split_whitespace().count() == 1;
            let wide: Vec<_> = wide
                .iter()
                .filter(|line| !is_table(line) && !is_word(line))
                .collect();
            assert!(wide.is_empty(), "{words:?} in {columns:?}: {wide:#?}");
        }
    }
}

#[test]
fn details_of_the_computation_are_for_verbose() {
    let words = ["optimum-sensitivity"];
    let plain = longdrive(&words);
    let verbose = longdrive(&[&words[..], &["--verbose"]].concat());
    for detail in [
        "KKT",
        "left out, because they have no value",
        "trust region",
    ] {
        let [plain, verbose] = [&plain, &verbose].map(|printed| printed.out.clone() + &printed.err);
        assert!(!plain.contains(detail), "{detail} in {plain}");
        assert!(verbose.contains(detail), "no {detail} in {verbose}");
    }
    let end = "evaluations\n\nthe rest of the answer: --all\n";
    assert!(plain.out.ends_with(end), "{}", plain.out);
    let (_, answer) = json(&words);
    let left_out = answer["left_out"][0].as_str().unwrap();
    assert!(left_out.contains("ball.inertia"), "{left_out}");
    // a search that ends without an optimum still prints its KKT residual
    let printed = longdrive(&["optimize", "--max-iterations", "1"]);
    assert_eq!(printed.status, 1);
    assert!(printed.out.contains("KKT residual"), "{}", printed.out);
    let printed = longdrive(&["optimize", "--verbose", "--quiet"]);
    assert_eq!(printed.status, 2);
}

#[test]
fn every_answer_names_its_setup_and_its_settings() {
    let set = ["--set", "swing.speed=95mph"];
    let title = "tour-average, swing.speed=95mph";
    for words in [
        &["simulate"][..],
        &["gradient"],
        &["sensitivity"],
        &["uncertainty", "--samples", "16"],
        &["optimize"],
        &["optimum-sensitivity", "--wrt", "club.mass"],
        &[
            "chart",
            "--along",
            "air.density",
            "--at",
            "1.1kg/m^3,1.2kg/m^3",
        ],
        &[
            "pareto",
            "--maximize",
            "carry",
            "--minimize",
            "apex_height",
            "--points",
            "3",
        ],
        &["robust", "--model", "aero.law=ferguson"],
        &["verify", "--of", "carry", "--wrt", "club.loft"],
        &["parameters"],
    ] {
        let printed = longdrive(&[words, &set[..]].concat());
        let first = printed.out.lines().next().unwrap_or_default();
        assert_eq!(first, format!("from {title}"), "{words:?}: {}", printed.err);
        let (_, answer) = json(&[words, &set[..]].concat());
        assert_eq!(answer["from"], title, "{words:?}");
    }
    let (_, design) = json(&[
        "design",
        "tour-average",
        "--rules",
        "none",
        "--scenarios",
        "64",
        set[0],
        set[1],
    ]);
    assert_eq!(design["from"], title);
    let compared = longdrive(&[&["compare"], &set[..], &["--set-b", "club.loft=12deg"]].concat());
    let names = format!("a: {title}\nb: {title}, club.loft=12deg\n");
    assert!(compared.out.starts_with(&names), "{}", compared.out);
}

/// The best loft depends on shaft and strike, which a measured launch determines. For an average
/// golfer, the answer advises to start from a measured launch.
#[test]
fn the_answer_for_an_average_names_the_command_for_an_own_loft() {
    let advice = "starts from your own launch";
    for (words, has_advice) in [
        (&["optimize"][..], true),
        (
            &["optimize", "--vary", "swing.attack_angle=-5deg..5deg"],
            false,
        ),
        (&["optimize", "modern-driver"], false),
        (&["chart", "--along", "swing.speed", "--at", "100mph"], true),
        (&["simulate"], false),
    ] {
        let printed = longdrive(words);
        let text = on_one_line(&printed.out);
        assert_eq!(text.contains(advice), has_advice, "{words:?}: {text}");
    }
}

/// `plot compare` has the advice on the loft in its JSON, and so has `compare`.
#[test]
fn a_comparison_in_json_has_the_advice_on_the_loft() {
    for (set_a, has_advice) in [("swing.speed=95mph", true), ("club.loft=10deg", false)] {
        let set_b = "air.density=1.1kg/m^3";
        let words = ["compare", "tour-average", "--set", set_a, "--set-b", set_b];
        let (_, answer) = json(&words);
        let advice = answer["advice"].as_str().unwrap_or_default();
        assert_eq!(advice.contains("state your loft"), has_advice, "{advice}");
    }
}

/// The bend of a shaft adds to the loft, so the best loft for a rigid shaft is some degrees too
/// high for others.
#[test]
fn the_best_loft_of_a_rigid_shaft_names_the_bend() {
    for (words, has_advice) in [
        (&["optimize", "modern-driver"][..], true),
        (&["design", "--vary", "club.loft=8deg..14deg"], true),
        (
            &[
                "optimize",
                "modern-driver",
                "--set",
                "swing.shaft_bend=0deg",
            ],
            false,
        ),
        (&["optimize"], false),
    ] {
        let text = on_one_line(&longdrive(words).out);
        let is_told = text.contains("the loft is for a rigid shaft");
        assert_eq!(is_told, has_advice, "{words:?}: {text}");
    }
}

/// The smallest lateral is farthest to the left, which hardly anybody asks for.
#[test]
fn a_search_for_the_best_side_says_how_to_search_for_the_target_line() {
    let vary = ["--vary", "swing.face_angle=-2deg..2deg"];
    for (goal, side) in [
        (["--minimize", "lateral"], Some("left")),
        (["--maximize", "sidespin"], Some("right")),
        (["--maximize", "carry"], None),
    ] {
        let output = longdrive(&[&["optimize"], &goal[..], &vary].concat());
        let says = on_one_line(&output.err);
        let of_side = ["left", "right"]
            .into_iter()
            .find(|side| says.contains(&format!("is farthest to the {side}")));
        assert_eq!(of_side, side, "{says}");
    }
}

fn carry_at(found: &Value, name: &str, value: f64) -> f64 {
    let mut setup = Setup::preset("tour-average").unwrap();
    for (varied, best) in found["optimum"].as_object().unwrap() {
        let value = if varied == name { value } else { number(best) };
        setup.set(varied, &format!("{value} rad")).unwrap();
    }
    Outcome::Carry.value(&Drive::new(&setup).unwrap()).unwrap()
}

/// At each end of a parameter's interval the carry is one yard shorter than the optimum, unless
/// this end is a bound.
#[test]
fn exact_loss_at_the_ends_of_the_intervals_of_an_optimum() {
    let (_, found) = json(&["optimize"]);
    let loss = number(&found["window_loss"]);
    assert!((loss - 0.9144).abs() < 1e-12);
    let best = number(&found["value"]);
    let mut ends = 0;
    for (name, window) in found["window"].as_object().unwrap() {
        for (end, limit) in [("low", "low_limit"), ("high", "high_limit")] {
            let lost = best - carry_at(&found, name, number(&window[end]));
            if window[limit] == "loss" {
                assert!((lost - loss).abs() < 1e-6, "{name} {end}: {lost}");
                ends += 1;
            } else {
                assert_eq!(window[limit], "bound");
                assert!(lost < loss, "{name} {end}: {lost}");
            }
        }
    }
    assert_eq!(ends, 3, "{}", found["window"]);
}

/// The gain of the club alone equals the gain of a search that varies only the loft. With a limit on
/// the total distance, a local search would not find this optimum.
#[test]
fn same_gain_of_the_club_as_a_search_over_the_loft_alone() {
    for (preset, limit) in [
        ("tour-average", "carry >= 0 yd"),
        ("modern-driver", "total <= 280 yd"),
    ] {
        same_gain_of_the_club(preset, limit);
    }
    let printed = longdrive(&["optimize", "-q"]).out;
    assert!(printed.contains("by the club alone: "));
}

fn same_gain_of_the_club(preset: &str, limit: &str) {
    let search = ["optimize", preset, "--subject-to", limit];
    let (_, both) = json(&search);
    let (_, loft) = json(&[&search[..], &["--vary", "club.loft=4deg..20deg"]].concat());
    let (_, start) = json(&["simulate", preset]);
    let before = number(&start["flight"]["carry"]);
    let [both_carry, loft_carry] = [&both, &loft].map(|found| number(&found["value"]));
    let club = &both["club_alone"];
    let is_close = |value: &Value, exact: f64| (number(value) - exact).abs() < 1e-6;
    assert!(is_close(&club["club_gain"], loft_carry - before), "{club}");
    assert!(
        is_close(&club["swing_gain"], both_carry - loft_carry),
        "{club}"
    );
    let best = number(&loft["optimum"]["club.loft"]);
    assert!(is_close(&club["optimum"]["club.loft"], best), "{club}");
    assert!(loft["club_alone"].is_null());
}

/// A gain is an improvement, as the multipliers of the same answer. The text has the change, which
/// is negative for a minimized objective. Expected: `simulate` and a search over the loft alone.
#[test]
fn a_smaller_minimized_objective_is_a_positive_gain_of_the_club() {
    let search = ["optimize", "--minimize", "descent_angle"];
    let (_, start) = json(&["simulate"]);
    let before = number(&start["flight"]["descent_angle"]);
    let (_, loft) = json(&[&search[..], &["--vary", "club.loft=4deg..20deg"]].concat());
    let fall = before - number(&loft["value"]);
    assert!(fall > 0.1, "{fall}");
    let (_, both) = json(&search);
    let further = number(&loft["value"]) - number(&both["value"]);
    let club = &both["club_alone"];
    close(number(&club["club_gain"]), fall, 1.0, 1e-6, "club");
    close(number(&club["swing_gain"]), further, 1.0, 1e-6, "swing");
    let text = on_one_line(&longdrive(&search).out);
    let falls = format!("by the club alone: -{:.2}°", fall.to_degrees());
    assert!(text.contains(&falls), "no {falls:?} in {text}");
}

/// Without a value, the shaft droop counts as 0 in the drive as set up. The search starts in the
/// middle of its range, which is no value of this drive. Expected: `simulate`, a search over the
/// loft alone, and the same models with a stated droop of 0.
#[test]
fn a_varied_parameter_without_a_value_has_none_as_set_up() {
    let vary = [
        "--vary",
        "club.loft=4deg..20deg",
        "--vary",
        "swing.shaft_droop=0deg..5deg",
    ];
    let (_, flown) = json(&["simulate"]);
    let carry = number(&flown["flight"]["carry"]);
    let (_, loft) = json(&["optimize", "--vary", "club.loft=4deg..20deg"]);
    let (_, found) = json(&[&["optimize"], &vary[..]].concat());
    let gain = number(&found["club_alone"]["club_gain"]);
    close(gain, number(&loft["value"]) - carry, 1.0, 1e-5, "club gain");

    let analysis = ["optimum-sensitivity", "--wrt", "swing.speed"];
    let (_, found) = json(&[&analysis, &vary[..]].concat());
    close(
        number(&found["as_set_up"]["carry"]),
        carry,
        1.0,
        1e-5,
        "carry",
    );
    let droop = &found["as_set_up"]["parameters"]["swing.shaft_droop"];
    assert!(droop.is_null(), "{droop}");

    let models = [
        "--model",
        "impact.gear_scale=0.5",
        "--model",
        "aero.law=ferguson",
    ];
    let robust = [&["robust"], &models[..], &vary].concat();
    let (_, unset) = json(&robust);
    let (_, stated) = json(&[&robust[..], &["--set", "swing.shaft_droop=0deg"]].concat());
    for k in 0..3 {
        let [unset, stated] =
            [&unset, &stated].map(|found| number(&found["models"][k]["loss_as_set_up"]));
        close(unset, stated, 1.0, 1e-5, "loss as set up");
    }
}

/// The optimum of the club alone lies within the ranges of the search, so the search must not end at
/// a worse one. Here its first end is worse and no point of the sample is better; the search from
/// the optimum of the club alone then finds the better optimum.
#[test]
fn an_optimum_is_at_least_as_good_as_the_club_alone() {
    let spin = [
        "amateur-average --set aero.law=lyu --minimize spin --vary club.loft=0deg..30deg",
        "--vary club.cg_depth=20mm..50mm --vary swing.attack_angle=-10deg..10deg",
        "--vary swing.face_angle=-2deg..1deg",
    ];
    let total = [
        "modern-driver --wind 7m/s --set wind.from=340deg --maximize total",
        "--vary club.cg_depth=20mm..50mm --vary club.loft=5deg..8deg",
        "--vary club.roll_radius=200mm..600mm --vary swing.face_angle=-5deg..5deg",
        "--vary swing.path=-5deg..5deg",
    ];
    // the club alone, as `simulate` prints it: 1336 rpm and 266.8 yd
    let least_spin = 1336.5 * std::f64::consts::PI / 30.0;
    let longest_total = 266.75 * 0.9144;
    for (words, sign, alone) in [
        (&spin[..], -1.0, least_spin),
        (&total[..], 1.0, longest_total),
    ] {
        let words = words.join(" ");
        let searched = |command: &str| {
            let words = format!("{command} {words}");
            json(&words.split_whitespace().collect::<Vec<_>>())
        };
        let (status, found) = searched("optimize");
        // the search began at the club alone, which is no point of the sample
        assert_eq!((status, &found["sample"]["improved"]), (0, &false.into()));
        assert!(sign * number(&found["value"]) >= sign * alone, "{found}");
        let club = &found["club_alone"];
        assert!(number(&club["swing_gain"]) >= -1e-9, "{club}");
        let (_, analysed) = searched("optimum-sensitivity --wrt swing.speed");
        assert!(sign * number(&analysed["value"]) >= sign * alone);
        let (_, effects) = searched("sensitivity --at-optimum --no-defaults");
        assert!(sign * number(&effects["at_optimum"]["value"]) >= sign * alone);
    }
}

/// The descent angle of the drive as set up is 39.8°, as `simulate` prints it.
#[test]
fn a_gain_from_a_drive_that_violates_a_constraint_says_so() {
    let search = |limit| on_one_line(&longdrive(&["optimize", "-q", "--subject-to", limit]).out);
    let text = search("descent_angle >= 43 deg");
    for says in [
        "the drive as set up violates descent angle ≥ 43°, so it is no alternative to the best",
        "from a drive that violates a limit; by varying the swing too:",
        "39.8° (broken) 43.0°",
    ] {
        assert!(text.contains(says), "no {says:?} in {text}");
    }
    let text = search("descent_angle >= 38 deg");
    assert!(
        !text.contains("violates") && !text.contains("(broken)"),
        "{text}"
    );
}

/// From bulge radius 200 mm to 600 mm the carry of a strike on the centre changes by 31 µm and the
/// landing speed by 2 µm/s, as `sweep` prints them.
#[test]
fn a_parameter_with_an_effect_below_1_mm_has_no_effect_in_optimize_and_in_a_front() {
    let vary = ["--vary", "club.bulge_radius=200mm..600mm", "--vary"];
    let attack = ["swing.attack_angle=2deg..3deg"];
    let longest = [
        "optimize",
        "amateur-average",
        "--maximize",
        "carry_distance",
    ];
    let (_, found) = json(&[&longest[..], &vary, &attack].concat());
    let text = on_one_line(&longdrive(&[&longest[..], &vary, &attack].concat()).out);
    assert!(
        text.contains("club.bulge_radius has a negligible effect: within its range"),
        "{text}"
    );
    assert!(
        text.contains("no effect") && found["club_alone"].is_null(),
        "{text}"
    );

    let front = [&["pareto"], &longest[1..], &["--minimize", "landing_speed"]].concat();
    let (status, found) = json(&[&front[..], &vary, &attack].concat());
    assert_eq!((status, &found["status"]), (0, &"done".into()), "{found}");
    let points = found["points"].as_array().unwrap();
    let bulge = |point: &Value| number(&point["design"]["club.bulge_radius"]);
    assert!(points.iter().all(|point| bulge(point) == bulge(&points[0])));
    let attacks = [&points[0], &points[points.len() - 1]]
        .map(|point| number(&point["design"]["swing.attack_angle"]).to_degrees());
    assert!(
        (attacks[0] - 3.0).abs() < 1e-6 && (attacks[1] - 2.0).abs() < 1e-6,
        "{attacks:?}"
    );
    let text = on_one_line(&longdrive(&[&front[..], &vary, &attack].concat()).out);
    let says = "fixed, because the effect on the goals is negligible: club.bulge_radius";
    assert!(text.contains(says), "{text}");
}

/// The carry is an even function of the face angle: it is equal at both ends of a symmetric range,
/// and largest near its middle.
#[test]
fn a_parameter_with_an_even_effect_is_varied_along_a_front() {
    let open = ["pareto", "--set", "swing.face_angle=3deg", "--points", "4"];
    let goals = [
        "--maximize",
        "carry_distance",
        "--minimize",
        "landing_speed",
    ];
    let vary = [
        "--vary",
        "swing.face_angle=-5deg..5deg",
        "--vary",
        "club.loft=6deg..14deg",
    ];
    let (_, front) = json(&[&open[..], &goals, &vary].concat());
    let (_, longest) = json(&[&["optimize", "--maximize", "carry_distance"], &vary[..]].concat());
    let end = number(&front["points"][0]["values"][0]);
    assert!(
        end >= number(&longest["value"]) - 1e-3,
        "{end}: {}",
        longest["value"]
    );
}

/// The mean carry with bulge radius 200 mm and 600 mm differs by 1 µm (two searches that fix it).
#[test]
fn a_parameter_with_an_effect_below_1_mm_on_all_goals_over_swings_has_no_effect() {
    let mut words = vec!["optimize", "--maximize", "mean(carry)"];
    for distributed in [
        "swing.face_angle=normal(0deg,2deg)",
        "swing.path=normal(0deg,2deg)",
    ] {
        words.extend(["--distribution", distributed]);
    }
    for varied in ["club.loft=5deg..20deg", "club.bulge_radius=200mm..600mm"] {
        words.extend(["--vary", varied]);
    }
    words.extend(["--subject-to", "mean(descent_angle) == 42 deg"]);
    let text = on_one_line(&longdrive(&words).out);
    assert!(
        text.contains("club.bulge_radius has a negligible effect: within its range"),
        "{text}"
    );
    assert!(text.contains("200 mm .. 600 mm no effect"), "{text}");
}

/// Loft and shaft lean replace each other, so that the optimum is not isolated.
#[test]
fn a_search_over_parameters_that_replace_each_other_advises_to_vary_fewer() {
    let words = [
        "optimize --wind 7m/s --set wind.from=340deg --vary club.loft=10deg..12deg",
        "--vary swing.face_angle=-2deg..1deg --vary swing.shaft_lean=-5deg..5deg",
        "--vary club.bulge_radius=200mm..600mm --vary strike.high=0mm..12mm",
        "--maximize carry_distance",
    ];
    let words = words.join(" ");
    let limit = ["--subject-to", "-3 yd <= lateral <= 3 yd"];
    let words = words.split_whitespace().chain(limit);
    let (_, found) = json(&words.collect::<Vec<_>>());
    let message = found["message"].as_str().unwrap();
    let says = "if some of the variables can replace each other, vary fewer of them";
    assert!(
        found["status"] != "iteration-limit" || message.contains(says),
        "{found}"
    );
}

/// Near the landing, the Reynolds number of an amateur's ball is below the range of the law. This
/// changes the carry little, so there is no warning. The extrapolated lift of a ball with little
/// spin changes the carry enough for a warning.
#[test]
fn a_law_outside_its_range_is_a_warning_where_it_changes_the_carry() {
    for preset in ["amateur-average", "tour-average", "lpga-average"] {
        let (_, drive) = json(&["simulate", preset]);
        assert_eq!(drive["warnings"], serde_json::json!([]), "{preset}");
    }
    let low_spin = [
        "--launch",
        "ball_speed=170mph,launch_angle=12deg,backspin=1200rpm",
    ];
    let (_, drive) = json(&[&["simulate"], &low_spin[..]].concat());
    let warning = drive["warnings"][0].as_str().unwrap();
    let says = "with the law held at the end of its range the carry would be ";
    assert!(warning.contains(says), "{warning}");
    let printed = longdrive(&[&["simulate", "-q"], &low_spin[..]].concat());
    let text = on_one_line(&printed.out);
    assert!(
        text.contains(&warning[warning.find(says).unwrap()..]),
        "{text}"
    );
    // without loft, the carry is less than half of the carry with the law held
    let printed = longdrive(&["simulate", "-q", "--loft", "0deg"]);
    let text = on_one_line(&printed.out);
    assert!(text.contains(&format!("{says}110 yd longer")), "{text}");
}

#[test]
fn a_stated_temperature_says_that_the_ball_is_not_colder() {
    let (_, cold) = json(&["simulate", "--set", "air.temperature=40F"]);
    let warning = cold["warnings"][0].as_str().unwrap();
    assert!(
        warning.contains("a cold ball is slower too, which is not modelled")
            && warning.contains("the carry changes by 1.3 yd to 2 yd per 10 °F (5.6 °C)"),
        "{warning}"
    );
    let (_, hot) = json(&["simulate", "--set", "air.temperature=40degC"]);
    let of_hot = hot["warnings"][0].as_str().unwrap();
    assert!(of_hot.contains("a warm ball is faster too"), "{of_hot}");
    let (_, warm) = json(&["simulate", "--set", "air.temperature=25degC"]);
    assert_eq!(warm["warnings"], serde_json::json!([]));
}
