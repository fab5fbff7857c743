//! Messages with name, value, allowed range and advice; singular and plural.

use crate::command_line::{json, longdrive, on_one_line};
use longdrive::command::{mark_options, with_mentions};
use longdrive::{Error, Setup};
use std::fs;

/// Both output streams of the program, in one line.
fn both_streams(args: &[&str]) -> (i32, String) {
    let output = longdrive(args);
    (output.status, on_one_line(&(output.out + &output.err)))
}

#[test]
fn one_thing_is_in_the_singular() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fs::write(&path, text).unwrap();
        path.display().to_string()
    };
    let one = file("one.csv", "club.loft [deg],carry [yd]\n10,250\n");
    let three = file(
        "three.csv",
        "club.loft [deg],carry [yd]\n10,250\n11,255\n12,260\n",
    );
    let rows = folder.path().join("rows.csv").display().to_string();
    let fast = [
        "sweep",
        "--over",
        "swing.speed=170mph..170mph:1",
        "-o",
        &rows,
    ];
    for (args, status, says) in [
        (
            &["calibrate", &one, "--fit", "aero.cd0", "--fit", "aero.cd1"][..],
            2,
            "has 1 measured value, fewer than the 2 parameters",
        ),
        (
            &["calibrate", &three, "--fit", "aero.cd0", "--folds", "1"],
            2,
            "1 fold cannot be made of 3 rows",
        ),
        (
            &["calibrate", &one, "--fit", "aero.cd0", "--folds", "2"],
            2,
            "2 folds cannot be made of 1 row;",
        ),
        (
            &["optimize", "--max-iterations", "1"],
            1,
            "stopped at the limit of 1 iteration with",
        ),
        (
            &["verify", "--of", "carry", "--wrt", "club.loft"],
            0,
            "0 of 1 finite difference of its carry would pass",
        ),
        (
            &fast,
            0,
            "warning: the only drive that landed: the launch is outside",
        ),
    ] {
        let (ended, text) = both_streams(args);
        assert_eq!(ended, status, "{args:?}: {text}");
        assert!(text.contains(says), "{args:?}: no '{says}': {text}");
        // "1 rows" and other plurals after 1 are wrong
        let words: Vec<_> = text.split(' ').collect();
        let wrong = words.windows(2).find(|pair| {
            pair[0] == "1"
                && [
                    "rows",
                    "values",
                    "parameters",
                    "iterations",
                    "drives",
                    "points",
                    "folds",
                ]
                .contains(&pair[1])
        });
        assert_eq!(wrong, None, "{text}");
    }
}

#[test]
fn a_text_that_is_no_number_is_refused_as_such() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fs::write(&path, text).unwrap();
        path.display().to_string()
    };
    let bare = file("bare.toml", "[club]\nloft = nan\n");
    let quoted = file("quoted.toml", "[club]\nloft = \"nan deg\"\n");
    let table = file("table.csv", "club.loft [deg]\nN/A\n");
    let infinite = file("infinite.csv", "club.loft [deg]\n-inf\n");
    for (args, says) in [
        (
            &["simulate", "--set", "club.loft=NaN"][..],
            "club.loft: \"NaN\" is not a number; write for example",
        ),
        (
            &["simulate", "--set", "club.loft=nan deg"],
            "club.loft: \"nan deg\" is not a number",
        ),
        (
            &["simulate", &bare],
            "club.loft: \"nan\" is not a number; write for example",
        ),
        (
            &["simulate", &quoted],
            "club.loft: \"nan deg\" is not a number",
        ),
        (
            &["sweep", "--points", &table],
            "row 1, column club.loft: 'N/A' is not a number; a unit is written in the head",
        ),
        (
            &["sweep", "--points", &infinite],
            "row 1, column club.loft: '-inf' is not finite",
        ),
        (
            &["optimize", "--subject-to", "carry >= nan yd"],
            "\"nan yd\" is not a number",
        ),
        (
            &["optimum-sensitivity", "--loss", "nan yd"],
            "\"nan yd\" is not a number",
        ),
        (
            &["sensitivity", "--sigma", "swing.speed=nan%"],
            "\"nan%\" is not a number",
        ),
        (&["simulate", "--tolerance=nan"], "\"nan\" is not a number"),
    ] {
        let (status, text) = both_streams(args);
        assert!(
            status == 2 && text.contains(says) && !text.contains("outside its range"),
            "{args:?}: no '{says}': {text}"
        );
    }
    let mut setup = Setup::modern_driver();
    let loft = setup.parameter("club.loft").unwrap();
    assert!(matches!(
        setup.set_value(loft, Some(f64::NAN)),
        Err(Error::NotANumber { .. })
    ));
}

#[test]
fn a_standard_uncertainty_must_be_above_zero() {
    for (sigma, says) in [
        (
            "air.density=0%",
            "the standard uncertainty of air.density would be 0 kg/m^3, but it must be above 0 and \
             finite; write for example air.density=1 kg/m^3",
        ),
        (
            "swing.path=1%",
            "a percentage is relative to the value, and swing.path is 0; write an amount, for \
             example 1 deg",
        ),
        (
            "swing.speed=-1mph",
            "would be -1 mph, but it must be above 0",
        ),
        (
            "impact.restitution=0",
            "write for example impact.restitution=1",
        ),
    ] {
        for command in ["sensitivity", "uncertainty"] {
            let (status, text) = both_streams(&[command, "--sigma", sigma]);
            assert!(
                status == 2 && text.contains(says),
                "{sigma}: no '{says}': {text}"
            );
        }
    }
    let (status, text) = both_streams(&[
        "sensitivity",
        "--sigma",
        "swing.speed=1mph",
        "--sigma",
        "swing.speed=2mph",
    ]);
    assert!(
        status == 2 && text.contains("the uncertainty of swing.speed: it is given twice; keep one"),
        "{text}"
    );
}

#[test]
fn a_drive_without_a_landing_names_its_end() {
    for (set, says) in [
        (
            "flight.time_limit=1s",
            "no landing: the flight was stopped at flight.time_limit = 1 s with the ball at a \
             height of 9.6249 yd; increase flight.time_limit",
        ),
        (
            "swing.speed=1e-300mph",
            "no flight: the highest point of the ball is 0 yd, which is not above the ground at 0 \
             yd; increase the speed",
        ),
        (
            "club.loft=-10deg",
            "which is not above the horizontal, and the ground is not below the ball (a ball that \
             rises by lift alone is not computed); increase the launch angle",
        ),
    ] {
        for command in ["simulate", "gradient"] {
            let (status, text) = both_streams(&[command, "modern-driver", "--set", set]);
            assert!(
                status == 1 && text.contains(says),
                "{command} {set}: no '{says}': {text}"
            );
        }
    }
}

#[test]
fn a_launch_on_the_command_line_replaces_that_of_the_setup_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("launch.toml");
    fs::write(
        &path,
        "[launch]\nball_speed = \"167 mph\"\nlaunch_angle = \"10.9 deg\"\nbackspin = \
                      \"2686 rpm\"\nsidespin = \"100 rpm\"\n",
    )
    .unwrap();
    let file = path.to_str().unwrap();
    let launch = |more: &[&str]| {
        let (status, found) = json(&[&["simulate", file], more].concat());
        assert_eq!(status, 0, "{more:?}: {found}");
        found["launch"].clone()
    };
    let faster = launch(&["--launch", "ball_speed=70m/s"]);
    assert!((faster["ball_speed"].as_f64().unwrap() - 70.0).abs() < 1e-12);
    assert!((faster["launch_angle"].as_f64().unwrap() - 10.9_f64.to_radians()).abs() < 1e-12);
    // total spin replaces backspin and sidespin of the file
    let other = launch(&["--launch", "spin=200rad/s"]);
    assert!(
        (other["spin"].as_f64().unwrap() - 200.0).abs() < 1e-9
            && other["sidespin"].as_f64().unwrap().abs() < 1e-9
    );
    for (args, says) in [
        (
            &["simulate", "--launch", "ball_speed=60m/s,ball_speed=70m/s"][..],
            "--launch ball_speed=70m/s: --launch ball_speed=60m/s gives the ball_speed too; keep \
             one of the two",
        ),
        (
            &[
                "simulate",
                "--launch",
                "ball_speed=60m/s",
                "--set",
                "launch.ball_speed=70m/s",
            ],
            "--launch ball_speed=60m/s: --set launch.ball_speed=70m/s gives the ball_speed too",
        ),
        (
            &["simulate", file, "--set", "launch.spin=2000rpm"],
            "unset the one of a setup file (--set launch.backspin=none or",
        ),
        (
            &["calibrate", "examples/shots.csv", file, "--fit", "aero.cd0"],
            "the launch in",
        ),
    ] {
        let (status, text) = both_streams(args);
        assert!(
            status == 2 && text.contains(says),
            "{args:?}: no '{says}': {text}"
        );
    }
}

#[test]
fn a_unit_for_a_plain_number_is_refused() {
    for (value, says) in [
        (
            "abc",
            "\"abc\" does not start with a number; write for example \"0.5\"",
        ),
        (
            "1 kg",
            "\"1 kg\" is not a plain number; a plain number takes no unit, or %",
        ),
        (
            "1 foo",
            "unknown unit 'foo'; a plain number takes no unit, or %",
        ),
    ] {
        let (status, text) =
            both_streams(&["simulate", "--set", &format!("impact.restitution={value}")]);
        assert!(
            status == 2 && text.contains(says),
            "{value}: no '{says}': {text}"
        );
    }
}

/// Loft and shaft lean change the face in the same way, so many pairs of them are optima.
#[test]
fn a_reason_is_given_once_with_the_parameters_that_it_holds_for() {
    let ridge = [
        "--vary",
        "club.loft=4deg..20deg",
        "--vary",
        "swing.shaft_lean=-5deg..5deg",
    ];
    for command in [
        &[
            "optimum-sensitivity",
            "--wrt",
            "swing.speed,gravity,ball.mass",
        ][..],
        &["sensitivity", "--at-optimum"],
    ] {
        let (_, text) = both_streams(&[command, &ridge].concat());
        assert_eq!(
            text.matches("the optimum is not isolated").count(),
            1,
            "{text}"
        );
        assert!(text.contains("gravity"), "{text}");
    }
    let (_, found) = json(&[&["sensitivity", "--at-optimum"], &ridge[..]].concat());
    let warnings = found["warnings"].to_string();
    assert!(
        warnings.contains("no slope of the optimum by swing.speed, ")
            && warnings.contains("gravity"),
        "{warnings}"
    );
    // the source of two default uncertainties is printed once
    let (_, text) = both_streams(&["sensitivity", "--all"]);
    assert!(
        text.contains("default of wind.downrange, wind.right: assumed"),
        "{text}"
    );
}

#[test]
fn a_plot_names_a_launch_condition_without_saying_launch_twice() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.csv").display().to_string();
    let launch = "ball_speed=150mph,launch_angle=10deg,backspin=2000rpm";
    let vary = [
        "--vary",
        "launch.launch_angle=5deg..20deg",
        "--vary",
        "launch.ball_speed=150mph..160mph",
    ];
    let (_, text) = both_streams(
        &[
            &["plot", "contour", "-o", &path, "--launch", launch],
            &vary[..],
        ]
        .concat(),
    );
    assert!(
        text.contains("Carry over launch angle and ball speed"),
        "{text}"
    );
}

#[test]
fn an_ellipse_that_reaches_to_infinity_is_not_shown() {
    let vary = [
        "--vary",
        "air.density=0.98kg/m^3..1.47kg/m^3",
        "--vary",
        "swing.closure.x=-5e-4rad/s..-3.3e-4rad/s",
    ];
    let more = [
        "--wrt",
        "club.loft",
        "--loss",
        "1e300 m",
        "--set",
        "flight.step=48ms",
        "--max-iterations",
        "15",
    ];
    let (_, text) = both_streams(&[&["optimum-sensitivity"], &vary[..], &more].concat());
    assert!(
        text.contains("within 1.0936e300 yd of the best") && !text.contains("inf "),
        "{text}"
    );
}

/// Prints the note on the uncertainty of the run once, also if the run is only in a constraint.
#[test]
fn a_front_has_one_note_on_the_run() {
    let distribution = "swing.attack_angle=normal(0deg,1deg)";
    let one_drive = ["--maximize", "total", "--subject-to", "run <= 60 yd"];
    let swings = [
        "--maximize",
        "mean(carry)",
        "--subject-to",
        "mean(total) >= 150 m",
        "--distribution",
        distribution,
        "--scenarios",
        "4",
    ];
    for (minimize, args) in [("apex_height", &one_drive[..]), ("std(carry)", &swings[..])] {
        let command = ["pareto", "--points", "2", "--minimize", minimize];
        let (_, text) = both_streams(&[&command[..], args].concat());
        assert_eq!(text.matches("are known within").count(), 1, "{text}");
    }
    let (_, text) = both_streams(&[&["optimize"], &swings[..]].concat());
    assert_eq!(text.matches("are known within").count(), 1, "{text}");
}

#[test]
fn a_missed_ball_says_what_the_bend_of_the_shaft_grows_with() {
    let message = Error::NoStrike { approach: -1.0 }.to_string();
    let growth = "swing.shaft_bend, which grows with the head speed as swing.shaft_growth says";
    assert!(message.contains(growth), "{message}");
}

/// The message in the syntax of the command line.
fn in_program(message: &str) -> String {
    with_mentions(message, |mention| mention.in_command_line_syntax())
}

#[test]
fn exact_arguments_and_commands_are_written_as_on_the_command_line() {
    for (message, words) in [
        ("`subject_to`: expected", "--subject-to: expected"),
        ("add `set club.loft=11deg`", "add --set club.loft=11deg"),
        (
            "with `subject_to \"head_mass <= 205 g\"`",
            "with --subject-to \"head_mass <= 205 g\"",
        ),
        ("as in `output mine.toml`", "as in -o mine.toml"),
        ("write `tolerance 1um`", "write --tolerance=1um"),
        (
            "`parameters()` lists them",
            "'longdrive parameters' lists them",
        ),
        ("`plot laws()` draws", "'longdrive plot laws' draws"),
    ] {
        assert_eq!(in_program(message), words);
    }
}

#[test]
fn exact_other_backquotes_stay() {
    for message in [
        "expected `=`",
        "the file 'a`b.csv'",
        "`nonsense 3`",
        "a ` b ` c",
    ] {
        assert_eq!(in_program(message), message);
    }
}

#[test]
fn exact_options_of_a_help_are_marked() {
    let help = "--set and --max-size (--sigma); 1--2 -- a";
    let marked = "`set` and `max_size` (`sigma`); 1--2 -- a";
    assert_eq!(mark_options(help), marked);
}
