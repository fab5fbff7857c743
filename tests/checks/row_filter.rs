//! `--only COLUMN=VALUE` selects rows of a table of shots, and residuals are also listed by club.

use crate::command_line::{json, longdrive, number, on_one_line};
use serde_json::Value;
use std::path::PathBuf;
use tempfile::TempDir;

const TABLE: &str = "\
Club,Player,Club Speed [mph],Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Carry [yds]
Driver,A,105,152,12,2500,250
3 Wood,A,100,141,13,3400,222
Driver,B,104,151,11,2600,247
Driver,A,106,153,12.5,2450,252
3 Wood,B,99,140,13.5,3500,219
";

/// The table in a folder of its own.
fn table() -> (TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let file: PathBuf = folder.path().join("shots.csv");
    std::fs::write(&file, TABLE).unwrap();
    let name = file.display().to_string();
    (folder, name)
}

fn warnings(found: &Value) -> String {
    found["warnings"].to_string()
}

#[test]
fn several_clubs_are_a_warning_with_their_counts() {
    let (_folder, file) = table();
    let counts = "several clubs, which are fitted together: Driver (3), 3 Wood (2)";
    let calibrate = ["calibrate", &file, "--fit", "aero.cd0"];
    let delivery = ["delivery", "--shots", &file];
    for words in [&calibrate[..], &delivery] {
        let (_, found) = json(words);
        assert!(warnings(&found).contains(counts), "{}", warnings(&found));
        let output = longdrive(&[words, &["-q"]].concat());
        assert!(
            on_one_line(&output.err).contains("--only Club=Driver"),
            "{}",
            output.err
        );
        let (_, found) = json(&[words, &["--only", "club=driver"]].concat());
        assert!(!warnings(&found).contains("clubs"), "{}", warnings(&found));
    }
}

/// Titles above the shots name the clubs of a table without a column of clubs.
#[test]
fn shots_below_several_titles_are_a_warning_with_their_counts() {
    let file = format!(
        "{}/data/cases/sections-with-heads.csv",
        env!("CARGO_MANIFEST_DIR")
    );
    let says = "sections-with-heads.csv has shots below several titles, such as clubs, which are \
                fitted together: Driver (2), 3 Wood (1)";
    for words in [
        ["calibrate", &file, "--fit", "aero.cd0"],
        ["delivery", "--shots", &file, "--all"],
    ] {
        let (_, found) = json(&words);
        assert!(warnings(&found).contains(says), "{}", warnings(&found));
    }
}

#[test]
fn the_rows_of_a_delivery_keep_their_numbers() {
    let (_folder, file) = table();
    let rows = |only: &[&str]| -> Vec<u64> {
        let (_, found) = json(&[&["delivery", "--shots", &file], only].concat());
        let rows = found["rows"].as_array().unwrap().iter();
        rows.map(|row| row["row"].as_u64().unwrap()).collect()
    };
    assert_eq!(rows(&["--only", "Club=3 wood"]), [2, 5]);
    assert_eq!(
        rows(&["--only", "Club=Driver", "--only", "Player=A"]),
        [1, 4]
    );
    assert_eq!(
        rows(&["--only", "Player=A", "--only", "player=b"]),
        [1, 2, 3, 4, 5]
    );
}

/// A table that contains only the rows of one club gives the same fit as `--only` with this club.
#[test]
fn same_fit_as_of_a_table_of_one_club() {
    let (folder, file) = table();
    let own = folder.path().join("drivers.csv");
    let drivers = TABLE.lines().filter(|line| !line.starts_with("3 Wood"));
    std::fs::write(&own, drivers.collect::<Vec<_>>().join("\n")).unwrap();
    let own = own.display().to_string();
    let fit = ["--fit", "aero.cd0"];
    let (_, selected) = json(&[&["calibrate", &file, "--only", "Club=Driver"], &fit[..]].concat());
    let (_, alone) = json(&[&["calibrate", &own], &fit[..]].concat());
    assert_eq!(selected["estimates"], alone["estimates"]);
    let only = ["calibrate", &file, "--only", "Club=Driver"];
    let text = longdrive(&[&only, &fit[..]].concat()).out;
    assert!(text.contains("Club = Driver: 3 of 5 rows"), "{text}");
}

#[test]
fn shots_are_summarized_by_club() {
    let (_folder, file) = table();
    let (status, found) = json(&["fly", &file]);
    assert_eq!(status, 0);
    let clubs = found["clubs"].as_array().unwrap();
    let counts: Vec<_> = clubs
        .iter()
        .map(|club| {
            (
                club["club"].as_str().unwrap(),
                club["rows"].as_u64().unwrap(),
            )
        })
        .collect();
    assert_eq!(counts, [("3 Wood", 2), ("Driver", 3)]);
    // the club is used
    let remarks = found["remarks"].to_string();
    let says = "columns that are copied and not used: Player\"";
    assert!(remarks.contains(says), "{remarks}");
    // the biases of the clubs, weighted by their rows, give the bias of all rows
    let all = &found["residuals"][0];
    let of = |club: &Value, key: &str| number(&club["outcomes"][0][key]);
    let sum: f64 = clubs
        .iter()
        .map(|club| of(club, "rows") * of(club, "bias"))
        .sum();
    assert!((sum / 5.0 - number(&all["bias"])).abs() < 1e-12);
    let (_, one) = json(&["fly", &file, "--only", "Club=Driver"]);
    assert_eq!(one["rows"], 3);
    assert_eq!(one["clubs"], Value::from(Vec::<Value>::new()));
    let driver = clubs.iter().find(|club| club["club"] == "Driver").unwrap();
    assert!((of(driver, "bias") - number(&one["residuals"][0]["bias"])).abs() < 1e-12);
    let text = longdrive(&[
        "fly",
        &file,
        "-o",
        "/dev/null",
        "--overwrite",
        "--format",
        "csv",
    ])
    .out;
    assert!(text.contains("carry_distance [yd] by club:"), "{text}");
    // the table by club prints two decimals
    let timed = TABLE.replace("Carry [yds]", "Hang Time [s]");
    let timed = [",250", ",222", ",247", ",252", ",219"]
        .iter()
        .fold(timed, |table, carry| {
            table.replace(&format!("{carry}\n"), ",6.50\n")
        });
    std::fs::write(&file, timed).unwrap();
    let text = longdrive(&["fly", &file, "--of", "flight_time"]).err;
    let (_, by_club) = text.split_once("flight_time [s] by club:").unwrap();
    let driver = by_club.lines().find(|line| line.contains("Driver"));
    let numbers = driver.unwrap().split_whitespace().skip(2);
    assert!(
        numbers
            .clone()
            .all(|number| number.split_once('.').is_some_and(|(_, d)| d.len() == 2))
            && numbers.count() == 3,
        "{text}"
    );
}

#[test]
fn a_column_or_a_value_that_is_not_there_is_refused_with_those_that_are() {
    let (_folder, file) = table();
    let fit: &[&str] = &["calibrate", &file, "--fit", "aero.cd0"];
    let delivery: &[&str] = &["delivery", "--shots", &file];
    for command in [fit, delivery, &["fly", &file]] {
        for (only, says) in [
            (
                "Klub=Driver",
                "its columns are Club, Player, Club Speed [mph]",
            ),
            (
                "Club=Putter",
                "no row has Club = Putter; Club is Driver (3), 3 Wood (2)",
            ),
            (
                "Driver",
                "--only Driver: write COLUMN=VALUE, for example Club=Driver",
            ),
        ] {
            let output = longdrive(&[command, &["--only", only]].concat());
            assert_eq!(output.status, 2, "{command:?} {only}");
            assert!(on_one_line(&output.err).contains(says), "{}", output.err);
        }
    }
}

#[test]
fn dots_follow_the_values_of_a_column_only_if_there_are_more() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("clubs.csv");
    for (clubs, has_dots) in [(12, false), (13, true)] {
        let rows: String = (0..clubs)
            .map(|k| format!("Club {k},150,12,2500\n"))
            .collect();
        let heads = "Club,Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm]";
        std::fs::write(&file, format!("{heads}\n{rows}")).unwrap();
        let output = longdrive(&["fly", file.to_str().unwrap(), "--only", "Club=Putter"]);
        assert_eq!(output.status, 2);
        assert_eq!(output.err.contains('…'), has_dots, "{}", output.err);
    }
}

/// A club value on the command line has the uncertainty of an instrument, as the values in a table
/// do.
#[test]
fn a_stated_club_value_of_a_delivery_has_the_uncertainty_of_an_instrument() {
    let launch = [
        "delivery",
        "--ball-speed",
        "150mph",
        "--launch-angle",
        "12deg",
        "--spin",
        "2600rpm",
    ];
    let before = |found: &Value, name: &str| {
        let known = found["rows"][0]["known"].as_array().unwrap();
        let one = known.iter().find(|one| one["parameter"] == name).unwrap();
        number(&one["standard_uncertainty_before"])
    };
    let mph = 0.44704;
    let (_, plain) = json(&launch);
    assert!((before(&plain, "swing.speed") - 15.0 * mph).abs() < 1e-12);
    for stated in [["--speed", "103mph"], ["--set", "swing.speed=103mph"]] {
        let (_, found) = json(&[&launch[..], &stated, &["--attack=-2deg"]].concat());
        assert!((before(&found, "swing.speed") - 1.5 * mph).abs() < 1e-12);
        assert!((before(&found, "swing.attack_angle").to_degrees() - 1.0).abs() < 1e-12);
        assert!((before(&found, "swing.path").to_degrees() - 4.0).abs() < 1e-12);
        let output = longdrive(&[&launch[..], &stated, &["-q"]].concat()).out;
        let says = "assumed errors of the given club values: swing.speed ± 1.50 mph; use --sigma to state other errors";
        assert!(on_one_line(&output).contains(says), "{output}");
    }
    let own = ["--speed", "103mph", "--sigma", "swing.speed=3mph"];
    let (_, found) = json(&[&launch[..], &own].concat());
    assert!((before(&found, "swing.speed") - 3.0 * mph).abs() < 1e-12);
}
