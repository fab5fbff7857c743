//! The air of each shot, if an export states it.

use crate::command_line::{json, longdrive, number, on_one_line};
use crate::common::close;
use crate::shots::fly_shots;
use longdrive::report::ShotWriter;
use longdrive::shots::Flown;
use longdrive::study::calibrate::{MeasuredShot, ShotTable};
use longdrive::table::RowFilter;
use longdrive::{Drive, Outcome, Setup};
use serde_json::Value;
use std::fs;
use std::io::Cursor;

/// A table with the shot of Garmin's sample, once for each item of `air`. An item replaces the last
/// four cells of the shot, which describe the air.
fn garmin_with_air(air: &[&str]) -> String {
    let text = include_str!("../data/shots/garmin.csv");
    let (heads, row) = text.trim_end().rsplit_once('\n').unwrap();
    let shot = row.strip_suffix("1.184,77,101.3,50").unwrap();
    air.iter().fold(format!("{heads}\n"), |text, air| {
        format!("{text}{shot}{air}\n")
    })
}

/// Two sections with the shot of Garmin's sample. In the first one, the head of the air density is
/// not recognized; in the second one, the air density is 0.9 kg/m³.
fn air_in_second_section() -> String {
    let with_air = garmin_with_air(&["0.9,77,77.0,50"]);
    let without_air = with_air.replace("Air Density", "Note 2");
    format!("{without_air}{with_air}").replace('\u{feff}', "")
}

/// The shots of a table: in the air that the table states, and in the air of the setup.
fn read_both_ways(text: &str) -> [ShotTable; 2] {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.csv");
    fs::write(&file, text).unwrap();
    [false, true].map(|is_air_given| {
        let filter = RowFilter::default();
        ShotTable::open(&Setup::modern_driver(), &file, filter, is_air_given).unwrap()
    })
}

/// The carry of the shot of Garmin's sample at an air density, m.
fn carry(density: f64) -> f64 {
    let mut setup = Setup::modern_driver();
    setup.air.density = density;
    for (name, value) in [
        ("launch.ball_speed", "160 mph"),
        ("launch.launch_angle", "12 deg"),
        ("launch.launch_direction", "-1.5 deg"),
        ("launch.spin", "2500 rpm"),
        ("launch.spin_axis", "3 deg"),
    ] {
        setup.set(name, value).unwrap();
    }
    Outcome::CarryDistance
        .of(&Drive::new(&setup).unwrap())
        .unwrap()
}

#[test]
fn same_flight_in_the_air_of_an_export_and_in_that_air_set() {
    let text = garmin_with_air(&[
        "0.997,77,85.3,50",
        ",,,",
        "15,77,101.3,50",
        "1.1,77,101.3,50",
    ]);
    let (shots, all, _) = fly_shots(Cursor::new(text.clone()));
    for (row, density) in [0.997, 1.184, 1.184, 1.1].into_iter().enumerate() {
        close(
            all[0].predicted(row, 0).unwrap(),
            carry(density),
            250.0,
            1e-6,
            &format!("row {row}"),
        );
    }
    let remarks = shots
        .remarks()
        .iter()
        .map(ToString::to_string)
        .collect::<Vec<_>>()
        .join("\n");
    assert!(
        remarks
            .contains("each shot flies in the air that the export states for its row: Air Density"),
        "{remarks}"
    );
    let notes = |row: usize| all[0].shots[row].notes.join("\n");
    assert_eq!((notes(0), notes(3)), (String::new(), String::new()));
    assert!(
        notes(1).contains("the air of the setup is assumed; Air Density: the cell is empty"),
        "{}",
        notes(1)
    );
    assert!(
        notes(2).contains("15 kg/m^3 is outside of the range on golf courses"),
        "{}",
        notes(2)
    );
    // without its unit the column is not read, because it may be in any unit: the shot flies in the
    // air of the setup
    let (shots, all, _) = fly_shots(Cursor::new(text.replace("[g/L]", "")));
    close(
        all[0].predicted(0, 0).unwrap(),
        carry(1.184),
        250.0,
        1e-6,
        "without a unit",
    );
    assert!(
        shots
            .remarks()
            .last()
            .unwrap()
            .to_string()
            .contains("not used: ")
            && shots.other_parameters.is_empty()
    );
}

#[test]
fn same_air_of_each_row_in_calibrate_and_fly() {
    let text = garmin_with_air(&["0.997,77,85.3,50", ",,,"]);
    let [table, given] = read_both_ways(&text);
    let air = |table: &ShotTable, shot: usize| {
        table.shots[shot]
            .inputs
            .iter()
            .find(|(row, _)| row.name == "air.density")
            .map(|(_, value)| *value)
    };
    let remarks = |table: &ShotTable| {
        table
            .remarks
            .iter()
            .map(ToString::to_string)
            .collect::<Vec<_>>()
            .join("\n")
    };
    assert_eq!((air(&table, 0), air(&table, 1)), (Some(0.997), None));
    for says in [
        "each shot flies in the air",
        "row 2: the air of the setup is assumed",
    ] {
        assert!(
            remarks(&table).contains(says),
            "no '{says}' in {}",
            remarks(&table)
        );
    }
    assert!(
        air(&given, 0).is_none()
            && remarks(&given)
                .contains("the given air replaces the air that the export states for each row"),
        "{}",
        remarks(&given)
    );
}

#[test]
fn the_air_that_only_a_second_section_states_is_reported_and_overridden() {
    let [table, given] = read_both_ways(&air_in_second_section());
    let has_air = |table: &ShotTable| -> Vec<bool> {
        let is_air = |shot: &MeasuredShot| {
            let mut inputs = shot.inputs.iter();
            inputs.any(|(parameter, _)| parameter.name == "air.density")
        };
        table.shots.iter().map(is_air).collect()
    };
    let remarks = |table: &ShotTable| {
        let texts: Vec<String> = table.remarks.iter().map(ToString::to_string).collect();
        texts.join("\n")
    };
    assert_eq!(has_air(&table), [false, true]);
    let stated = "from line 4 on: each shot flies in the air that the export states for its row: \
                  Air Density";
    assert!(remarks(&table).contains(stated), "{}", remarks(&table));
    assert_eq!(has_air(&given), [false, false]);
    let says = "the given air replaces the air that the export states for each row: Air Density";
    assert!(remarks(&given).contains(says), "{}", remarks(&given));
}

/// The first section has no column of the air, so its shot flies in the air of the setup.
#[test]
fn same_flight_in_the_air_of_a_second_section_and_in_that_air_set() {
    let (shots, all, _) = fly_shots(Cursor::new(air_in_second_section()));
    for (section, density) in [1.184, 0.9].into_iter().enumerate() {
        let found = all[section].predicted(0, 0).unwrap();
        close(found, carry(density), 250.0, 1e-6, &format!("{density}"));
    }
    let writer = ShotWriter::json_lines(&shots, &[Outcome::CarryDistance]);
    let lines: String = all
        .iter()
        .map(|flown| String::from_utf8(writer.rows(flown)).unwrap())
        .collect();
    let densities: Vec<Option<f64>> = lines
        .lines()
        .map(|line| serde_json::from_str::<Value>(line).unwrap())
        .map(|line| line["parameters"]["air.density"].as_f64())
        .collect();
    assert_eq!(densities, [None, Some(0.9)]);
}

/// The second section begins after the first 64 KiB, and states its air by the weather.
#[test]
fn same_air_in_a_section_far_from_the_beginning() {
    let text = include_str!("../data/cases/trackman-short-heads.csv");
    let (heads, rows) = text.trim_end().split_once('\n').unwrap();
    let first = format!("{heads}\n{}", format!("{rows}\n").repeat(500));
    assert!(first.len() > 1 << 16);
    let second = text.replace("Club,", "Club Name,");
    let (_, all, tally) = fly_shots(Cursor::new(first + &second));
    assert!(tally.refused.is_empty(), "{:?}", tally.refused);
    let air = |flown: &Flown| flown.shots[0].other_parameters()[0];
    assert_eq!(air(&all[0]), air(all.last().unwrap()));
}

#[test]
fn given_air_overrides_that_of_the_export() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let file = place("r50.csv");
    fs::write(&file, garmin_with_air(&["0.997,77,85.3,50"])).unwrap();
    let fly = |args: &[&str]| {
        let output = place("flown.jsonl");
        let printed = longdrive(&[&["fly", &file, "-o", &output, "--overwrite"], args].concat());
        assert_eq!(printed.status, 0, "{}", printed.err);
        let line: Value =
            serde_json::from_str(fs::read_to_string(&output).unwrap().trim()).unwrap();
        (number(&line["predicted"]["carry_distance"]), printed.err)
    };
    let (own, remarks) = fly(&[]);
    close(own, carry(0.997), 250.0, 1e-5, "the row's");
    assert!(remarks.contains("each shot flies in the air"), "{remarks}");
    let (given, remarks) = fly(&["--set", "air.density=1.3kg/m^3"]);
    close(given, carry(1.3), 250.0, 1e-5, "given");
    assert!(
        on_one_line(&remarks)
            .contains("the given air replaces the air that the export states for each row"),
        "{remarks}"
    );
    let (cold, remarks) = fly(&["--set", "air.temperature=0degC"]);
    let says = "the given air replaces the air that the export states for each row: Air Density";
    let words = on_one_line(&remarks);
    assert!(
        cold < own - 10.0 && words.matches("Air Density").count() == 1 && words.contains(says),
        "{cold} {remarks}"
    );
    let weather = [
        "calibrate",
        &file,
        "--fit",
        "aero.cd0",
        "--set",
        "air.temperature=0degC",
    ];
    let printed = longdrive(&weather);
    let words = on_one_line(&(printed.out + &printed.err));
    assert!(
        words.matches("Air Density").count() == 1 && words.contains(says),
        "{words}"
    );
    // calibrate reads the air, too
    let (status, answer) = json(&[
        "calibrate",
        &file,
        "--fit",
        "aero.cd0",
        "--set",
        "air.density=1.3kg/m^3",
    ]);
    assert!(status != 2, "{answer}");
}

/// The lines that `fly` wrote state the air of each row, as the table did.
#[test]
fn same_flight_of_a_table_and_of_its_json_lines_in_the_given_air() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let [table, lines, setup] = ["r50.csv", "r50.jsonl", "cold.toml"].map(place);
    fs::write(&table, garmin_with_air(&["0.997,77,85.3,50"])).unwrap();
    fs::write(&setup, "[air]\ndensity = \"1.3 kg/m^3\"\n").unwrap();
    let printed = longdrive(&["fly", &table, "-o", &lines]);
    assert_eq!(printed.status, 0, "{}", printed.err);
    let says = "the given air replaces the air that the export states for each row";
    for args in [
        vec![],
        vec![setup.as_str()],
        vec!["--set", "air.density=1.3kg/m^3"],
        vec!["--set", "air.temperature=0degC"],
    ] {
        let fly = |file: &str| {
            let (status, answer) = json(&[&["fly", file], &args[..]].concat());
            assert_eq!(status, 0, "{answer}");
            let is_told = answer["remarks"].to_string().contains(says);
            (number(&answer["residuals"][0]["bias"]), is_told)
        };
        let (of_table, of_lines) = (fly(&table), fly(&lines));
        assert_eq!(of_table, of_lines, "{args:?}");
        assert_eq!(of_lines.1, !args.is_empty(), "{args:?}");
        let fit = |file: &str| {
            let command = ["calibrate", file, "--fit", "aero.cd0"];
            let (_, answer) = json(&[&command[..], &args].concat());
            let is_told = answer["data"]["remarks"].to_string().contains(says);
            (number(&answer["estimates"]["aero.cd0"]["value"]), is_told)
        };
        let (of_table, of_lines) = (fit(&table), fit(&lines));
        close(of_lines.0, of_table.0, 0.2, 1e-6, &format!("{args:?}"));
        assert_eq!(of_table.1, of_lines.1, "{args:?}");
    }
}
