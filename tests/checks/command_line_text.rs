//! Printed text: units, digits, widths, colours and manual pages.

use crate::command_line::{Output, longdrive};
use crate::program;
use crate::reproduce::REPORT;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The line of `simulate` for an outcome, with single spaces: its value in the chosen units, and in
/// parentheses in the other units.
fn line(out: &str, name: &str) -> String {
    let line = out.lines().find(|line| line.trim_start().starts_with(name));
    let words: Vec<_> = line
        .unwrap_or_else(|| panic!("no {name} in {out}"))
        .split_whitespace()
        .collect();
    words.join(" ")
}

#[test]
fn a_drive_has_the_units_of_launch_monitors_in_both_systems() {
    let args = ["simulate", "modern-driver", "--set", "swing.path=-2deg"];
    let us = longdrive(&args).out;
    let metric = longdrive(&[args.as_slice(), &["--units", "metric"]].concat()).out;
    for (name, in_us, in_metric) in [
        (
            "ball speed",
            "ball speed 161.9 mph (72.4 m/s)",
            "ball speed 72.4 m/s (161.9 mph)",
        ),
        ("launch angle", "launch angle 7.4°", "launch angle 7.4°"),
        ("smash factor", "smash factor 1.47", "smash factor 1.47"),
        (
            "lateral",
            "lateral 16.5 yd R (15.1 m R)",
            "lateral 15.1 m R (16.5 yd R)",
        ),
        (
            "launch direction",
            "launch direction 0.3° L",
            "launch direction 0.3° L",
        ),
    ] {
        assert_eq!(
            (line(&us, name).as_str(), line(&metric, name).as_str()),
            (in_us, in_metric)
        );
    }
    // a straight drive has a lateral distance of 0 up to rounding: the text has no sign, no power
    // of ten and no side
    let straight = longdrive(&["simulate"]).out;
    assert_eq!(line(&straight, "lateral"), "lateral 0.0 yd (0.0 m)");
    assert!(
        !straight.contains("-0.0") && !straight.contains("e-"),
        "{straight}"
    );
}

#[test]
fn every_command_prints_the_chosen_units() {
    for (args, in_us, in_metric) in [
        (
            vec!["optimize", "modern-driver", "-q"],
            "carry   278.6 yd (254.7 m)",
            "carry   254.7 m (278.6 yd)",
        ),
        (
            vec!["gradient", "modern-driver"],
            "carry = 253.6 yd (231.9 m)",
            "carry = 231.9 m (253.6 yd)",
        ),
        (
            vec!["gradient", "modern-driver"],
            " yd per degree",
            " m per degree",
        ),
        (
            vec!["compare", "modern-driver", "--set-b", "swing.speed=112mph"],
            "110 mph → 112 mph",
            "49.174 m/s → 50.068 m/s",
        ),
        (vec!["sensitivity"], " yd per mph", " m per m/s"),
        (
            vec!["optimum-sensitivity", "-q", "--wrt", "swing.speed"],
            "swing.speed [mph]",
            "swing.speed [m/s]",
        ),
        (
            vec!["uncertainty", "modern-driver", "-q", "--samples", "16"],
            "normal: 110 mph ± 0.5 mph",
            "normal: 49.174 m/s ± 0.22352 m/s",
        ),
        (
            vec![
                "uncertainty",
                "-q",
                "--samples",
                "16",
                "--distribution",
                "swing.speed=truncated(110mph, 4mph, 105mph, 115mph)",
            ],
            "truncated normal: 110 mph ± 4 mph, cut at 105 mph and 115 mph",
            "truncated normal: 49.174 m/s ± 1.7882 m/s, cut at 46.939 m/s and 51.41 m/s",
        ),
        (
            vec!["chart", "-q", "--along", "swing.speed=100mph..101mph"],
            "100.00 mph",
            "44.70 m/s",
        ),
        (
            vec!["parameters", "modern-driver"],
            "110 mph",
            "49.1744 m/s",
        ),
    ] {
        let out = |extra: &[&str]| longdrive(&[args.as_slice(), extra, &["--all"]].concat()).out;
        for (out, words, others) in [
            (out(&[]), in_us, in_metric),
            (out(&["--units", "us"]), in_us, in_metric),
            (out(&["--units", "metric"]), in_metric, in_us),
        ] {
            assert!(
                out.contains(words) && !out.contains(others),
                "{args:?}: no '{words}', or '{others}', in {out}"
            );
        }
    }
}

#[test]
fn no_line_of_an_answer_is_wider_than_a_terminal() {
    let set = ["--set", "swing.path=-2deg", "--set", "wind.right=10mph"];
    // large steps save time, and do not change the width of a table
    let large = ["--set", "flight.method=dp8", "--set", "flight.step=400ms"];
    for args in [
        vec!["simulate"],
        vec![
            "gradient",
            "--hessian",
            "--of",
            "carry,lateral",
            "--wrt",
            "all",
        ],
        vec!["optimize", "--starts", "4"],
        vec!["optimize", "--vary", "swing.attack_angle=-40deg..-30deg"],
        vec![
            "optimum-sensitivity",
            "--change",
            "swing.speed=+5mph",
            "--subject-to",
            "apex_height <= 35 yd",
        ],
        vec![
            "chart",
            "--along",
            "swing.speed=95mph..105mph",
            "--subject-to",
            "apex_height <= 35 yd",
        ],
        vec![
            "pareto",
            "--maximize",
            "carry",
            "--minimize",
            "apex_height",
            "--subject-to",
            "lateral >= -20 yd",
        ],
        vec![
            "compare",
            "mae494",
            "winfield-tan",
            "--of",
            "all",
            large[0],
            large[1],
            large[2],
            large[3],
        ],
        vec!["sensitivity", "--at-optimum"],
        vec!["uncertainty", "--samples", "16"],
        vec![
            "verify",
            "--of",
            "carry,landing_speed",
            "--wrt",
            "swing.speed,club.loft,aero.cd0",
        ],
        vec!["parameters"],
    ] {
        for units in ["us", "metric"] {
            let printed =
                longdrive(&[args.as_slice(), set.as_slice(), &["--units", units]].concat());
            assert!(
                printed.status < 2 && !printed.out.is_empty(),
                "{args:?}: {}",
                printed.err
            );
            for line in printed.out.lines() {
                assert!(
                    line.chars().count() <= 100,
                    "{args:?}: {} columns: {line}",
                    line.chars().count()
                );
            }
        }
    }
    for listing in ["presets", "laws"] {
        for line in longdrive(&[listing]).out.lines() {
            assert!(line.chars().count() <= 100, "{line}");
        }
    }
}

#[test]
fn quiet_keeps_only_warnings_and_errors_on_standard_error() {
    assert!(!longdrive(&["optimize", "--verbose"]).err.is_empty());
    assert_eq!(longdrive(&["optimize", "--quiet"]).err, "");
    let warned = longdrive(&[
        "simulate",
        "modern-driver",
        "-q",
        "--set",
        "club.inertia.yy=20000 g cm^2",
    ]);
    assert!(
        warned.err.starts_with("warning: club.inertia")
            && warned
                .err
                .lines()
                .skip(1)
                .all(|line| line.starts_with("  ")),
        "{}",
        warned.err
    );
    let wrong = longdrive(&["simulate", "-q", "--set", "club.lofft=10deg"]);
    assert!(
        wrong.status == 2 && wrong.err.starts_with("error: "),
        "{}",
        wrong.err
    );
}

#[test]
fn colours_are_for_terminals_and_no_color_turns_them_off() {
    let program = program::path();
    let out = |variables: &[(&str, &str)], args: &[&str]| {
        let variables: BTreeMap<_, _> = variables.iter().copied().collect();
        let output = Command::new(program)
            .args(args)
            .env_remove("NO_COLOR")
            .envs(variables)
            .output()
            .unwrap();
        String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned()
    };
    for args in [
        &["optimize"][..],
        &["simulate", "--set", "club.lofft=10deg"],
    ] {
        assert!(
            !out(&[], args).contains('\u{1b}'),
            "a pipe is not a terminal"
        );
        // colours as in a terminal
        assert!(
            out(&[("CLICOLOR_FORCE", "1")], args).contains("\u{1b}["),
            "{args:?}"
        );
        assert!(
            !out(&[("CLICOLOR_FORCE", "1"), ("NO_COLOR", "1")], args).contains('\u{1b}'),
            "{args:?}"
        );
    }
    assert!(
        !out(&[("CLICOLOR_FORCE", "1")], &["simulate", "--json"]).contains('\u{1b}'),
        "JSON stays JSON"
    );
}

#[test]
fn completions_and_manual_pages_name_every_command() {
    let commands = [
        "simulate",
        "optimum-sensitivity",
        "calibrate",
        "sweep",
        "uncertainty",
        "completions",
    ];
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = longdrive(&["completions", shell]);
        assert!(
            script.status == 0 && commands.iter().all(|command| script.out.contains(command)),
            "{shell}"
        );
    }
    assert_eq!(longdrive(&["completions", "nush"]).status, 2);

    let folder = tempfile::tempdir().unwrap();
    let pages = folder.path().join("pages").display().to_string();
    assert_eq!(longdrive(&["man", "-o", &pages]).status, 0);
    for command in commands
        .map(|command| format!("-{command}"))
        .iter()
        .map(String::as_str)
        .chain(["", "-plot-contour"])
    {
        let page = std::fs::read_to_string(Path::new(&pages).join(format!("longdrive{command}.1")))
            .unwrap();
        assert!(
            page.contains(".TH longdrive") && page.contains("quiet"),
            "{command}"
        );
    }
    let page = longdrive(&["man", "plot contour"]).out;
    assert!(
        page.contains(concat!("\"longdrive ", env!("CARGO_PKG_VERSION"), "\"")),
        "{page}"
    );
    let again = longdrive(&["man", "-o", &pages]);
    assert!(
        again.status == 2 && again.err.contains("--overwrite"),
        "{}",
        again.err
    );
    assert_eq!(longdrive(&["man", "-o", &pages, "--overwrite"]).status, 0);
    let one = longdrive(&["man", "plot contour"]);
    assert!(
        one.status == 0 && one.out == longdrive(&["man", "plot", "contour"]).out,
        "{}",
        one.err
    );
    assert!(
        one.out.contains("longdrive\\-plot\\-contour"),
        "{}",
        one.out
    );
    let none = longdrive(&["man", "optimise"]);
    assert!(
        none.status == 2 && none.err.contains("did you mean 'optimize'?"),
        "{}",
        none.err
    );
}

#[test]
fn same_points_from_written_columns() {
    let folder = tempfile::tempdir().unwrap();
    let [first, points, second] =
        ["first.csv", "points.csv", "second.csv"].map(|name| folder.path().join(name));
    let name = |path: &PathBuf| path.display().to_string();
    let over = [
        "--over",
        "club.loft=8deg..12deg:3",
        "--over",
        "air.density=1.1kg/m^3..1.2kg/m^3:2",
    ];
    let outcomes = ["--outcomes", "carry,smash_factor", "--gradient"];
    let done = longdrive(&[&["sweep", "-o", &name(&first)], over.as_slice(), &outcomes].concat());
    assert_eq!(done.status, 0, "{}", done.err);
    let text = std::fs::read_to_string(&first).unwrap();
    let head = "club.loft [rad],air.density [kg/m^3],status,carry \
                [m],smash_factor,d_carry/d_club.loft [m/rad],\
                d_carry/d_air.density [m/(kg/m^3)],d_smash_factor/d_club.loft \
                [1/rad],d_smash_factor/d_air.density [1/(kg/m^3)]\n";
    assert!(text.starts_with(head), "{text}");
    // keep the columns of the parameters, unchanged
    let columns = text
        .lines()
        .map(|line| line.split(',').take(2).collect::<Vec<_>>().join(","));
    std::fs::write(&points, columns.collect::<Vec<_>>().join("\n")).unwrap();
    let again = ["sweep", "--points", &name(&points), "-o", &name(&second)];
    let done = longdrive(&[again.as_slice(), &outcomes].concat());
    assert_eq!(done.status, 0, "{}", done.err);
    assert_eq!(
        std::fs::read_to_string(&second).unwrap(),
        text,
        "to the last bit"
    );
}

/// Numbers and units in sentences, and suggestions for mistyped options.
#[test]
fn messages_have_plain_numbers_chosen_units_and_suggestions() {
    /// Exit status and all output, with single spaces.
    fn answer(args: &[&str]) -> (i32, String) {
        let own: Output;
        let printed = if args == ["reproduce", "mae494"] {
            &REPORT.output
        } else {
            own = longdrive(args);
            &own
        };
        let text = format!("{}{}", printed.out, printed.err);
        let words: Vec<&str> = text.split_whitespace().collect();
        (printed.status, words.join(" "))
    }
    let still = ["--set", "launch.spin=0 rpm"];
    let no_spin = [
        "verify",
        "--launch",
        "ball_speed=60m/s,launch_angle=12deg",
        "--wrt",
        "gravity",
        "--of",
        "carry",
        "--set",
        "aero.law=ferguson",
    ];
    for (args, status, says, says_not) in [
        (
            vec!["simulate", "--tolerance=-1m"],
            2,
            "--tolerance: \"-1m\" is no tolerance; give a length above 0",
            "e0",
        ),
        (
            [&no_spin[..], &still].concat(),
            0,
            "the spin is 0 rad/s",
            "0.0e0",
        ),
        (
            vec!["reproduce", "mae494", "--units", "us"],
            0,
            "end within 0.39 in of the best carry",
            "centimetre",
        ),
        // without `--units`: the units of the study
        (
            vec!["reproduce", "mae494"],
            0,
            "end within 10.0 mm of the best carry",
            "centimetre",
        ),
        (
            vec!["simulate", "--threads", "3"],
            2,
            "this command has no option '--threads'; it is an option of sweep, fly; --help lists",
            "'-- ",
        ),
        (
            vec!["--quiet", "plot", "me.toml", "-o", "a.svg"],
            2,
            "one of these comes after 'plot': trajectory, contour, chart,",
            "after 'longdrive'",
        ),
        (
            vec!["chart", "-o", "a.svg", "--along", "club.loft=8deg..12deg"],
            2,
            "this command has no option '-o'; --help lists those that it has",
            "joined to its option",
        ),
        (
            vec!["simulate", "--set", "-5"],
            2,
            "joined to its option by '=', as in --set=NAME=-5",
            "'-- ",
        ),
        (
            vec!["simulate", "--sett", "a=1"],
            2,
            "a similar argument exists: '--set'",
            "this command has no",
        ),
    ] {
        let (found, text) = answer(&args);
        assert_eq!(found, status, "{args:?}: {text}");
        assert!(text.contains(says), "{args:?}: no '{says}': {text}");
        assert!(!text.contains(says_not), "{args:?}: '{says_not}': {text}");
    }
}

/// Errors in a file have file, line, reason and advice.
#[test]
fn broken_files_have_plain_messages() {
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes, says) in [
        (
            "a.toml",
            &b"[club]\nloft = \"10 deg\n"[..],
            "a.toml: line 2, column 15 is not valid TOML: invalid basic string, expected `\"`",
        ),
        (
            "a.toml",
            b"[club]\nloft = '10 deg\n",
            "invalid literal string, expected `'`",
        ),
        (
            "a.toml",
            b"[club]\nloft = 10 deg\n",
            "its value is a number, or text in quotes, as in loft = \"10.5 deg\"",
        ),
        (
            "a.toml",
            b"[club]\nloft = 10deg\n",
            "its value is a number, or text in quotes, as in loft = \"10.5 deg\"",
        ),
        (
            "a.toml",
            b"[club]\nloft =\n",
            "its value is a number, or text in quotes, as in loft = \"10.5 deg\"",
        ),
        (
            "a.toml",
            b"[club]\nloft = True\n",
            "its value is a number, or text in quotes, as in loft = \"10.5 deg\"",
        ),
        (
            "a.toml",
            b"[club]\nloft = 1\nloft = 2\n",
            "line 3, column 1 is not valid TOML: duplicate key",
        ),
        (
            "a.toml",
            b"[club\nloft = 1\n",
            "unclosed table, expected `]`",
        ),
        (
            "a.toml",
            b"[club]\nloft: 1\n",
            "key with no value, expected `=`",
        ),
        (
            "a.toml",
            b"[club]\nloft = true\n",
            "'club.loft' is a boolean; expected a string with its unit, like \"9.8 deg\"",
        ),
        (
            "a.toml",
            b"[club]\nlofft = 1\n",
            "did you mean 'club.loft'?",
        ),
        (
            "a.toml",
            b"[club]\nloft = \"\x01\"\n",
            "line 2, column 9 is not valid TOML: ",
        ),
        (
            "a.toml",
            b"[club]\nloft = '\xff'\n",
            "it holds bytes that are not text in UTF-8; save it as text in UTF-8",
        ),
        (
            "none.toml",
            b"",
            "it cannot be read (there is no such file)",
        ),
        (
            "a.csv",
            b"club.loft [deg],swing.speed [mph]\n9,100\n\"10,100\n11,100\n",
            "line 3 opens a quote (\") and does not close it",
        ),
        (
            "a.csv",
            b"club.loft [deg]\n\"9\n10\n",
            "row 1: line 2 opens a quote (\") and does not close it",
        ),
        (
            "a.csv",
            b"\"club.loft [deg]\n9\n",
            "a.csv: line 1 opens a quote (\") and does not close it",
        ),
        (
            "a.csv",
            b"club.loft [deg]\n1\x002\n",
            "row 1, column club.loft: '1\\u{0}2' is not a number",
        ),
        (
            "a.csv",
            b"club.loft [deg],swing.speed [mph]\n9,100,1\n",
            "row 1: the row has 3 cells, but the head has 2 cells",
        ),
        (
            "a.csv",
            b"club.loft [deg]\n\xff\n",
            "row 1, column club.loft: '\u{ff}' is not a number",
        ),
        ("none.csv", b"", "it cannot be read (there is no such file)"),
    ] {
        let path = folder.path().join(name);
        if !name.starts_with("none") {
            std::fs::write(&path, bytes).unwrap();
        }
        let file = path.to_str().unwrap();
        let args = if name.ends_with("toml") {
            vec!["simulate", file]
        } else {
            vec!["sweep", "--points", file]
        };
        let printed = longdrive(&args);
        let text = String::from_utf8_lossy(bytes);
        assert!(
            printed.status == 2 && printed.err.contains(says),
            "{text}: no '{says}' in {}",
            printed.err
        );
        assert!(printed.err.contains(name), "{text}: {}", printed.err);
    }
}
