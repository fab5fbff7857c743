//! Hints of messages name the probable intention.

use crate::command_line::{longdrive, on_one_line};
use crate::program;
use longdrive::{Error, Setup};
use std::fs;
use std::process::Stdio;

#[test]
fn an_option_of_other_commands_is_not_taken_for_one_that_begins_alike() {
    for (words, says) in [
        (
            &["plot", "contour", "--over", "club.loft", "-o", "x.svg"][..],
            "no option '--over'; it is an option of plot laws, sweep",
        ),
        (&["optimize", "--spd", "95mph"], "no option '--spd'; --help"),
        (&["gradient", "--vary=x"], "no option '--vary'"),
        (
            &["sweep", "--threds", "3"],
            "a similar argument exists: '--threads'",
        ),
        (
            &["simulate", "--temprature", "50F"],
            "a similar argument exists: '--temperature'",
        ),
    ] {
        let printed = longdrive(words);
        assert_eq!(printed.status, 2);
        assert!(
            on_one_line(&printed.err).contains(says),
            "{words:?}: {}",
            printed.err
        );
        assert!(
            !printed.err.contains("--overwrite") && !printed.err.contains("--seed"),
            "{}",
            printed.err
        );
    }
}

#[test]
fn a_word_for_a_number_gets_the_meaning_of_the_parameter() {
    let printed = longdrive(&["simulate", "--wind", "10mph", "--set", "wind.from=headwind"]);
    assert_eq!(printed.status, 2);
    let says = "Direction that the wind comes from, clockwise from the target line: 0° is a head \
                wind, 90° from the right, 180° a tail wind";
    assert!(on_one_line(&printed.err).contains(says), "{}", printed.err);
}

/// A shell reads an unquoted `>` as a redirection to a file.
#[test]
fn pieces_of_a_constraint_without_quotes_get_the_advice_on_quotes() {
    for words in [
        &["optimize", "--subject-to", "descent_angle", "38deg"][..],
        &["optimize", "--subject-to", "lateral", "==", "0m"],
        &["optimize", "--subject-to", "descent_angle", "="],
        &["optimize", "--subject-to=descent_angle"],
        &["optimize", "--subject-to=descent_angle", "38", "deg"],
    ] {
        let printed = longdrive(words);
        assert_eq!(printed.status, 2);
        let says = "put a constraint in quotes, as in --subject-to \"descent_angle >= 38 deg\"";
        assert!(
            on_one_line(&printed.err).contains(says),
            "{words:?}: {}",
            printed.err
        );
    }
    let quoted = [
        "optimize",
        "--subject-to=carry > 200yd",
        "tour-average",
        "extra",
    ];
    let printed = longdrive(&quoted);
    assert!(
        printed.status == 2 && !printed.err.contains("in quotes"),
        "{}",
        printed.err
    );
    for words in [
        &["simulate", "--speed", "95", "mph"][..],
        &["simulate", "--attack", "-2", "deg"],
    ] {
        let printed = longdrive(words);
        let says = format!("{} \"{} {}\"", words[1], words[2], words[3]);
        assert!(
            on_one_line(&printed.err).contains(&says),
            "{words:?}: {}",
            printed.err
        );
    }
}

#[test]
#[cfg(unix)]
fn a_file_whose_name_is_not_utf_8_is_named() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let output = program::command()
        .arg("simulate")
        .arg(OsStr::from_bytes(b"mine\xff.toml"))
        .output()
        .unwrap();
    let err = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(
        on_one_line(&err).contains("mine\u{fffd}.toml: its name is not UTF-8"),
        "{err}"
    );
}

#[test]
#[cfg(target_os = "linux")]
fn help_that_cannot_be_written_is_an_error() {
    for words in [&["--help"][..], &["simulate", "--help"], &["--version"]] {
        let full = fs::OpenOptions::new()
            .write(true)
            .open("/dev/full")
            .unwrap();
        let mut command = program::command();
        let output = command
            .args(words)
            .stdout(Stdio::from(full))
            .stderr(Stdio::piped())
            .output()
            .unwrap();
        let err = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{words:?}: {err}");
        assert!(err.contains("the disk is full"), "{err}");
        assert_eq!(longdrive(words).status, 0);
    }
}

/// The shell limits the size of a file. A write beyond this limit fails, as on a full disk.
#[test]
#[cfg(target_os = "linux")]
fn a_report_that_cannot_be_written_leaves_no_folder() {
    let folder = tempfile::tempdir().unwrap();
    let to = folder.path().join("study");
    let output = std::process::Command::new("sh")
        .args(["-c", "trap '' XFSZ; ulimit -f 1; exec \"$0\" \"$@\""])
        .arg(program::path())
        .args(["report", "--loft=10deg", "--attack=-1deg", "-q", "-o"])
        .arg(&to)
        .output()
        .unwrap();
    let err = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{err}");
    assert!(err.contains("cannot be written"), "{err}");
    assert!(!to.exists());
}

#[test]
fn nearest_name_is_suggested() {
    let names = [
        "club.loft",
        "club.mass",
        "swing.attack_angle",
        "club.weight_1.toe",
        "club.weight_2.toe",
    ];
    for (given, meant) in [
        ("club.weight_2.toex", "club.weight_2.toe"),
        ("clubs.loft", "club.loft"),
        ("club.loft.x", "club.loft"),
        ("club.lofft", "club.loft"),
        ("loft", "club.loft"),
        ("atack_angle", "swing.attack_angle"),
    ] {
        let message = Error::unknown("parameter", given, names, "list").to_string();
        assert!(
            message.contains(&format!("did you mean '{meant}'?")),
            "{message}"
        );
    }
    let coefficients = ["aero.cd0", "aero.cd1", "aero.cd2"];
    let message = Error::unknown("parameter", "aero.cdo", coefficients, "list").to_string();
    assert!(message.contains("did you mean 'aero.cd0'?"), "{message}");
    let speeds = ["swing.speed", "wind.speed"];
    let message = Error::unknown("parameter", "speed", speeds, "list").to_string();
    assert!(message.contains("did you mean 'swing.speed'?"), "{message}");
    let message = Error::unknown("parameter", "swing", speeds, "list").to_string();
    assert!(
        message.ends_with("it is a group: swing.speed; list"),
        "{message}"
    );
    for strange in ["xyzzy", "sw", "swing.club_path"] {
        let message = Error::unknown("parameter", strange, names, "list").to_string();
        assert!(!message.contains("did you mean"), "{message}");
    }
}

/// A value with `+` may be meant as a change, as `--change club.cg_depth=+5mm` is. Angles of a swing
/// and temperatures usually have signs.
#[test]
fn a_value_that_may_be_meant_as_a_change_is_refused() {
    let mut setup = Setup::modern_driver();
    for (name, value) in [
        ("club.cg_depth", "+5 mm"),
        ("swing.speed", "+5 mph"),
        ("club.mass", " +5g"),
    ] {
        let message = setup.set(name, value).unwrap_err().to_string();
        assert!(message.contains("may be meant as a change"), "{message}");
    }
    for (name, value) in [
        ("swing.attack_angle", "+3 deg"),
        ("strike.toe", "+5 mm"),
        ("air.temperature", "+10 degC"),
    ] {
        setup.set(name, value).unwrap();
    }
    assert_eq!(setup, {
        let mut same = Setup::modern_driver();
        same.set("swing.attack_angle", "3 deg").unwrap();
        same.set("strike.toe", "5 mm").unwrap();
        same.set("air.temperature", "10 degC").unwrap();
        same
    });
}
