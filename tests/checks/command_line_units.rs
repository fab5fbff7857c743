//! Chosen units in every text (studies, messages, warnings, notes), and remarks that fit a
//! terminal.

use crate::command_line::{WHOLE, longdrive, on_one_line, widest};
use crate::reproduce::{FOUND, PAPER, PAPER_WRITTEN};
use longdrive::report::{Mae494Report, Report, WinfieldTanReport};
use longdrive::units::System;

/// Numbers with one of these units that no parentheses follow. In parentheses is the number in the
/// other system.
fn numbers_in_one_system<'a>(text: &'a str, units: &[&str]) -> Vec<&'a str> {
    let all: Vec<&str> = text.split_whitespace().collect();
    let is_number =
        |word: &str| word.starts_with(|c: char| c.is_ascii_digit() || ['+', '-'].contains(&c));
    let is_unit = |word: &str| units.contains(&word.trim_end_matches([',', '.', ';', ':']));
    let is_beside = |word: Option<&&str>| word.is_some_and(|word| word.starts_with('('));
    let found = (1..all.len())
        .filter(|&i| is_unit(all[i]) && is_number(all[i - 1]) && !is_beside(all.get(i + 1)));
    found.map(|i| all[i - 1]).collect()
}

#[test]
fn published_numbers_of_mae494_keep_their_units_and_computed_ones_have_the_chosen_units() {
    let [metric, us] =
        System::ALL.map(|system| Mae494Report::new(&FOUND).document(system).text(&WHOLE));
    for (text, system) in [(&metric, "metric"), (&us, "us")] {
        assert!(widest(text) <= 100, "{system}: {} columns", widest(text));
    }
    let (in_metres, in_yards) = (on_one_line(&metric), on_one_line(&us));
    // the report prints 248.48 m; a yard is 0.9144 m, a mile per hour 0.44704 m/s
    assert!(
        in_metres.contains("prints 248.48 m;") && in_yards.contains("prints 248.48 m (271.74 yd);"),
        "{us}"
    );
    let yards = |metres: f64| format!("{:.2} yd", metres / 0.9144);
    let best = FOUND.optimum.exact().carry;
    assert!(
        in_metres.contains(&format!("{best:.2} m (")) && in_yards.contains(&yards(best)),
        "{us}"
    );
    let fastest = FOUND.energy.fastest;
    assert!(
        in_metres.contains(&format!("V = {fastest:.2} m/s")),
        "{metric}"
    );
    assert!(
        in_yards.contains(&format!("V = {:.2} mph", fastest / 0.44704)),
        "{us}"
    );
    let slope = FOUND.noise.slopes[0].exact;
    assert!(
        in_metres.contains(&format!("{slope:+.1} m/rad")),
        "{metric}"
    );
    assert!(
        in_yards.contains(&format!("{:+.1} yd/rad", slope / 0.9144)),
        "{us}"
    );
    assert_eq!(
        numbers_in_one_system(&metric, &["yd", "mph", "yd/rad"]),
        [""; 0],
        "{metric}"
    );
    assert_eq!(
        numbers_in_one_system(&us, &["m", "m/s", "m/rad"]),
        [""; 0],
        "{us}"
    );
}

#[test]
fn published_numbers_of_winfield_and_tan_keep_their_units_and_computed_ones_have_the_chosen_units()
{
    let [metric, us] =
        System::ALL.map(|system| WinfieldTanReport::new(&PAPER).document(system).text(&WHOLE));
    assert!(
        widest(&metric) <= 100 && widest(&us) <= 100,
        "{metric}\n{us}"
    );
    let (in_metres, in_yards) = (on_one_line(&metric), on_one_line(&us));
    let carry = PAPER.shot.computed.carry;
    // the paper prints 197.31 yd and 139.16 mph
    assert!(
        in_yards.contains(&format!("197.31 yd {:.2} yd", carry / 0.9144)),
        "{us}"
    );
    assert!(
        in_metres.contains(&format!("197.31 yd (180.42 m) {carry:.2} m")),
        "{metric}"
    );
    assert!(
        in_yards.contains("139.16 mph 1") && in_metres.contains("139.16 mph (62.21 m/s) 6"),
        "{metric}"
    );
    assert!(
        in_yards.contains("C_D at 70 mph") && in_metres.contains("C_D at 30 m/s"),
        "{metric}"
    );
    assert!(!metric.contains("NaN") && !us.contains("NaN"), "{us}");
    assert_eq!(
        numbers_in_one_system(&metric, &["yd", "mph"]),
        [""; 0],
        "{metric}"
    );
    assert_eq!(numbers_in_one_system(&us, &["m"]), [""; 0], "{us}");
}

#[test]
fn a_study_has_its_own_units_by_default() {
    let [metric, us] =
        System::ALL.map(|system| WinfieldTanReport::new(&PAPER).document(system).text(&WHOLE));
    let output = &PAPER_WRITTEN.output;
    assert!(
        us.contains("250.09 yd") && output.out == us,
        "{}",
        output.out
    );
    assert!(metric.contains("250.09 yd (228.68 m)"), "{metric}");
    let help = longdrive(&["reproduce", "--help"]).out;
    assert!(
        on_one_line(&help).contains("reproduce: the units of the study"),
        "{help}"
    );
}

#[test]
fn heights_in_messages_have_the_chosen_units() {
    // 40 m = 43.745 yd, 200 m = 218.72 yd
    let high = ["--set", "ground.height=40m"];
    let higher = ["--set", "ground.height=200m"];
    let chart = [
        "chart",
        "modern-driver",
        "--along",
        "ground.height=40m..61m",
    ];
    for (args, in_us, in_metric) in [
        (
            [&["simulate"][..], &high].concat(),
            "not above the ground at 43.745 yd",
            "not above the ground at 40 m",
        ),
        (
            [&["gradient"][..], &high].concat(),
            "not above the ground at 43.745 yd",
            "not above the ground at 40 m",
        ),
        (
            [&["optimize"][..], &higher].concat(),
            "the ground at 218.72 yd",
            "the ground at 200 m",
        ),
        (
            chart.to_vec(),
            "no optimum was found beyond 65.2",
            "no optimum was found beyond 59.6",
        ),
    ] {
        for (units, shown) in [("us", in_us), ("metric", in_metric)] {
            let output = longdrive(&[&args[..], &["--units", units]].concat());
            let text = on_one_line(&(output.out + &output.err));
            assert!(text.contains(shown), "{args:?} {units}: {text}");
            let others: &[&str] = if units == "us" { &["m"] } else { &["yd"] };
            assert_eq!(
                numbers_in_one_system(&text, others),
                [""; 0],
                "{args:?} {units}: {text}"
            );
        }
    }
}

#[test]
fn speeds_and_limits_in_messages_have_the_chosen_units() {
    let slow = [
        "simulate",
        "--set",
        "aero.law=winfield-tan",
        "--set",
        "swing.speed=30mph",
        "--set",
        "club.loft=14deg",
    ];
    let limits = [
        "--subject-to",
        "apex_height <= 5 yd",
        "--subject-to",
        "apex_height >= 60 yd",
    ];
    let impossible = [&["optimize"], &limits[..]].concat();
    let verify = [
        "verify",
        "modern-driver",
        "--of",
        "carry",
        "--wrt",
        "swing.speed",
    ];
    let sample = concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/shots.csv");
    let calibrate = ["calibrate", sample, "modern-driver", "--fit", "aero.cd0"];
    for (args, in_us, in_metric) in [
        // 25 m/s = 55.9 mph, 68 m/s = 152 mph
        (
            &slow[..],
            "speed through the air of 55.9 mph to 152 mph",
            "speed through the air of 25 m/s to 68 m/s",
        ),
        (&impossible, " yd, outside by ", " m, outside by "),
        (&verify, "at swing.speed = 110", "at swing.speed = 49.1"),
        // 3 yd = 2.7432 m
        (
            &calibrate,
            ": 3 yd is taken for each",
            ": 2.74 m is taken for each",
        ),
    ] {
        for (units, shown, other) in [("us", in_us, in_metric), ("metric", in_metric, in_us)] {
            let output = longdrive(&[args, &["--units", units]].concat());
            let text = on_one_line(&(output.out + &output.err));
            assert!(text.contains(shown), "{args:?} {units}: {text}");
            assert!(!text.contains(other), "{args:?} {units}: {text}");
        }
    }
}

#[test]
fn violated_limits_over_swings_have_the_chosen_units() {
    let limited = [
        "optimize",
        "modern-driver",
        "--distribution=swing.speed=normal(100mph,2mph)",
        "--vary=club.loft=8deg..14deg",
        "--subject-to=mean(carry) >= 400 yd",
        "--subject-to=head_moi <= 3000 g cm^2",
    ];
    for (units, unit, limit) in [("us", " yd", "400 yd"), ("metric", " m", "365.76 m")] {
        let output = longdrive(&[&limited[..], &["--units", units]].concat());
        let text = on_one_line(&output.out);
        let (_, message) = text
            .split_once(&format!("mean(carry) >= {limit} (its value is "))
            .unwrap();
        let (carry, rest) = message
            .split_once(") and head_moi <= 3000 g cm² (")
            .unwrap();
        let (value, outside) = carry.split_once(", outside by ").unwrap();
        assert!(value.ends_with(unit) && outside.ends_with(unit), "{carry}");
        assert!(
            rest.starts_with("no varied parameter changes it here: its value is "),
            "{rest}"
        );
    }
}

#[test]
fn notes_of_plots_are_in_the_chosen_system() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.svg").display().to_string();
    let along = [
        "chart",
        "modern-driver",
        "--along",
        "swing.speed=90mph..100mph",
        "--subject-to",
        "apex_height <= 30 yd",
    ];
    for (plot, us, metric) in [
        (
            &["contour"][..],
            "lose at most 1.00 yd and",
            "lose at most 0.91 m and",
        ),
        (&["tornado"], " yd.", " m."),
        (&along, " mph apex", "1: at 41."),
    ] {
        for (units, first) in [("us", us), ("metric", metric)] {
            let output = longdrive(
                &[
                    &["plot"],
                    plot,
                    &["-o", &file, "--overwrite", "--units", units],
                ]
                .concat(),
            );
            assert!(
                output.status == 0 && on_one_line(&output.err).contains(first),
                "{plot:?} {units}: {}",
                output.err
            );
            let other = if units == "us" {
                [" m ", " m.", " m/s"]
            } else {
                [" yd ", " yd.", " mph"]
            };
            // a limit is printed as it was typed
            let message = on_one_line(&output.err).replace("apex_height <= 30 yd", "");
            assert!(
                !other.iter().any(|unit| message.contains(unit)),
                "{plot:?} {units}: {}",
                output.err
            );
            assert!(widest(&output.err) <= 100, "{}", output.err);
            if plot[0] == "tornado" {
                let picture = std::fs::read_to_string(&file).unwrap();
                // 0.5 mph = 0.224 m/s
                let name = if units == "us" {
                    "club speed ± 0.5 mph"
                } else {
                    "club speed ± 0.224 m/s"
                };
                assert!(picture.contains(name), "{units}: {picture}");
            }
        }
    }
}

#[test]
fn remarks_and_warnings_fit_a_terminal() {
    for (args, begin) in [
        (
            &["gradient", "--wrt", "all", "--verbose"][..],
            "left out, because they have no value",
        ),
        (
            &["uncertainty", "--samples", "8", "--verbose"],
            "default uncertainty: ",
        ),
        (
            &["simulate", "--set", "strike.toe=90mm"],
            "warning: strike.toe",
        ),
        (
            &[
                "simulate",
                "--set",
                "aero.law=smits-smith",
                "--set",
                "swing.speed=140mph",
            ],
            "warning: the law ",
        ),
    ] {
        let output = longdrive(args);
        let lines: Vec<&str> = output.err.lines().collect();
        assert!(
            output.status == 0 && widest(&output.err) <= 100,
            "{args:?}: {}",
            output.err
        );
        let at = lines
            .iter()
            .position(|line| line.starts_with(begin))
            .unwrap_or_else(|| panic!("{}", output.err));
        // the rest of a long line is on an indented line
        assert!(lines[at + 1].starts_with("  "), "{args:?}: {}", output.err);
    }
}

/// The value and the remark of the line of a setup file that begins with `begin`.
fn remark<'a>(file: &'a str, begin: &str) -> (&'a str, &'a str) {
    let line = file
        .lines()
        .find(|line| line.starts_with(begin))
        .unwrap_or_else(|| panic!("no {begin} in {file}"));
    let (value, remark) = line.split_once(" # ").unwrap();
    (value.split('"').nth(1).unwrap(), remark)
}

#[test]
fn remarks_in_setup_files_have_the_digits_of_the_text_and_values_all_of_them() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.toml").display().to_string();
    let done = longdrive(&[
        "optimize",
        "-q",
        "-o",
        &file,
        "--subject-to",
        "apex_height <= 36 yd",
    ]);
    assert_eq!(done.status, 0, "{}", done.err);
    let text = std::fs::read_to_string(&file).unwrap();
    let (loft, about) = remark(&text, "loft = ");
    // the file has the loft in degrees if this text is exact, else in radians; the remark is always
    // in degrees
    let degrees = loft
        .strip_suffix(" deg")
        .map_or_else(
            || loft.trim_end_matches(" rad").parse().map(f64::to_degrees),
            str::parse,
        )
        .unwrap();
    assert_eq!(
        about,
        format!("optimum: {degrees:.2} deg in 4 deg .. 20 deg")
    );
    assert!(loft.len() > "8.80634 deg".len(), "{text}");
    let head = text.lines().next().unwrap();
    assert!(
        done.out.contains(head.split_once("carry: ").unwrap().1),
        "'{head}' is not as in {}",
        done.out
    );

    let sample = concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/shots.csv");
    let done = longdrive(&[
        "calibrate",
        sample,
        "-q",
        "--fit",
        "aero.cd0",
        "-o",
        &file,
        "--overwrite",
    ]);
    assert_eq!(done.status, 0, "{}", done.err);
    let text = std::fs::read_to_string(&file).unwrap();
    let (drag, about) = remark(&text, "cd0 = ");
    let (value, error) = about
        .rsplit_once(": ")
        .unwrap()
        .1
        .split_once(" ± ")
        .unwrap();
    // an estimate is rounded to the second digit of its standard error
    let decimals = error.len() - "0.".len();
    assert_eq!(
        value,
        format!("{:.decimals$}", drag.parse::<f64>().unwrap()),
        "{text}"
    );
    assert!(
        error.trim_start_matches(['0', '.']).len() == 2 && drag.len() > value.len(),
        "{text}"
    );
}

/// Remarks of a calibration about instruments have the chosen units too.
#[test]
fn remarks_of_a_calibration_have_the_chosen_units() {
    let table = "club.loft [deg],carry [yd],ball_speed [mph],lateral [yd],apex_height \
                 [yd],smash_factor\n\
                 9,240,160,1,30,1.47\n11,250,160,1,33,1.46\n";
    let (_folder, path) = crate::sweep::table("shots.csv", table);
    let output = |units: &str| {
        let output = longdrive(&[
            "calibrate",
            path.to_str().unwrap(),
            "--fit",
            "aero.cd0",
            "--units",
            units,
        ]);
        on_one_line(&output.out)
    };
    let (metric, us) = (output("metric"), output("us"));
    let remarks = |text: &str| text.split("Estimates").next().unwrap().to_owned();
    for unit in [" yd", " mph", "yard"] {
        assert!(!remarks(&metric).contains(unit), "{unit}: {metric}");
    }
    for (metric_says, us_says) in [
        ("within about 2.7 m", "within about 3 yd"),
        ("at 230 m", "at 250 yd"),
    ] {
        assert!(
            metric.contains(metric_says) && us.contains(us_says),
            "{metric_says}: {metric} {us}"
        );
    }
}

#[test]
fn a_wrong_unit_is_refused_with_a_list_of_units() {
    for (value, message) in [
        ("1kg", "a length takes"),
        ("1", "a length takes"),
        ("1fox", "a length takes"),
    ] {
        let output = longdrive(&["simulate", "--set", &format!("strike.high={value}")]);
        let units = "m, mm, yd, in, um, cm, km, ft, mi";
        assert!(
            output.status == 2 && output.err.contains(&format!("{message} {units}")),
            "{}",
            output.err
        );
    }
    for unit in ["m", "mm", "yd", "in", "um", "cm", "km", "ft", "mi"] {
        assert_eq!(
            longdrive(&["simulate", "--set", &format!("ground.height=0{unit}")]).status,
            0,
            "{unit}"
        );
    }
}
