//! Shots of launch monitors: the exports of each maker, kept and refused rows, predictions and
//! comparisons, and output formats.

use crate::command_line::{json, longdrive, number, on_one_line};
use crate::common::close;
use crate::schema::faults;
use longdrive::batch::{CHUNK, Run};
use longdrive::report::ShotWriter;
use longdrive::shots::{Flown, Flying, Origin, ShotStatistics, Shots};
use longdrive::units::System;
use longdrive::{Drive, Outcome, Setup};
use serde_json::Value;
use std::fmt::Write;
use std::fs;
use std::io::{self, Read};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

const OF: [Outcome; 5] = [
    Outcome::CarryDistance,
    Outcome::Lateral,
    Outcome::ApexHeight,
    Outcome::FlightTime,
    Outcome::DescentAngle,
];

fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("data/shots")
        .join(name)
}

pub fn fly_shots(text: impl Read + Send + 'static) -> (Shots, Vec<Flown>, ShotStatistics) {
    let setup = Setup::modern_driver();
    let mut shots = Shots::read(&setup, "shots.csv", text).unwrap();
    let flying = Flying::new(&setup, &shots.other_parameters, &OF).unwrap();
    let mut all = vec![];
    let tally = flying.fly(
        &mut shots,
        &Run::default(),
        |flown| flown,
        |flown| {
            all.push(flown);
            Ok(())
        },
    );
    (shots, all, tally.unwrap())
}

fn file(name: &str) -> (Shots, Flown, ShotStatistics) {
    let (shots, mut all, tally) = fly_shots(fs::File::open(path(name)).unwrap());
    assert_eq!(all.len(), 1, "{name}");
    (shots, all.remove(0), tally)
}

/// The shot of the samples (160 mph, 12°, 2500 rpm) with this launch direction and spin axis,
/// degrees.
fn sample(direction: f64, axis: f64) -> Drive<f64> {
    let mut setup = Setup::modern_driver();
    for (name, value) in [
        ("launch.ball_speed", "160 mph".to_owned()),
        ("launch.launch_angle", "12 deg".into()),
        ("launch.launch_direction", format!("{direction} deg")),
        ("launch.spin", "2500 rpm".into()),
        ("launch.spin_axis", format!("{axis} deg")),
    ] {
        setup.set(name, &value).unwrap();
    }
    Drive::new(&setup).unwrap()
}

#[test]
fn same_flight_of_a_shot_in_every_makers_export() {
    let full = sample(-1.5, 3.0);
    let yard = 0.9144;
    for (name, maker, rows, landed) in [
        ("trackman.csv", Some("TrackMan"), 2, 2),
        ("garmin.csv", Some("Garmin"), 1, 1),
        ("flightscope.csv", Some("FlightScope"), 4, 1),
        ("foresight.csv", Some("Foresight"), 1, 1),
        ("foresight-app.csv", Some("Foresight"), 3, 1),
        ("rapsodo.csv", Some("Rapsodo"), 2, 1),
        ("uneekor.csv", Some("Uneekor"), 1, 1),
        ("awesome-golf.csv", Some("Awesome Golf"), 1, 1),
        ("square.csv", Some("Square"), 3, 1),
        ("decimal-commas.csv", None, 2, 2),
        ("open-connect.json", Some("GSPro Open Connect"), 2, 1),
        ("open-connect.jsonl", Some("GSPro Open Connect"), 5, 1),
    ] {
        let (shots, flown, tally) = file(name);
        assert_eq!(
            (shots.maker(), flown.shots.len(), tally.flown),
            (maker, rows, landed),
            "{name}: {:?}",
            tally.refused
        );
        for (at, of) in OF.iter().enumerate() {
            let expected = of.of(&full).unwrap();
            // the tables state sidespin and backspin to a thousandth
            close(
                flown.predicted(0, at).unwrap(),
                expected,
                expected.abs(),
                1e-4,
                &format!("{name}: {}", of.name()),
            );
        }
        let carry = flown.shots[0].value(Outcome::CarryDistance).unwrap().value;
        close(carry, 262.0 * yard, 262.0, 1e-9, name);
        let residual = flown.residual(0, 0).unwrap();
        close(
            residual,
            flown.predicted(0, 0).unwrap() - carry,
            1.0,
            1e-12,
            name,
        );
    }
    // without a launch direction no lateral outcome is compared, and a note of the row states the
    // assumed direction
    let (_, flown, _) = file("mevo.csv");
    let straight = Outcome::CarryDistance.of(&sample(0.0, 0.0)).unwrap();
    close(
        flown.predicted(0, 0).unwrap(),
        straight,
        straight,
        1e-9,
        "mevo",
    );
    assert_eq!(
        flown.shots[0].notes,
        [
            "launch direction is missing: 0 deg is assumed",
            "spin axis is missing: 0 deg is assumed"
        ]
    );
    let (_, flown, _) = file("trackman.csv");
    assert!(
        flown.predicted(1, 1).is_some() && flown.residual(1, 1).is_none(),
        "the axis is assumed"
    );
}

#[test]
fn marks_measured_estimated_and_normalized_of_an_export_are_kept() {
    let origin =
        |name: &str, row: usize| file(name).1.shots[row].value(Outcome::Spin).unwrap().origin;
    assert_eq!(origin("trackman.csv", 0), Some(Origin::Measured));
    assert_eq!(origin("trackman.csv", 1), Some(Origin::Estimated));
    assert_eq!(
        (origin("garmin.csv", 0), origin("awesome-golf.csv", 0)),
        (Some(Origin::Estimated), Some(Origin::Estimated))
    );
    assert_eq!(
        (origin("rapsodo.csv", 0), origin("foresight-app.csv", 0)),
        (None, None)
    );
    let (shots, flown, tally) = file("trackman.csv");
    assert_eq!((tally.spin_not_measured, tally.normalized), (1, 2));
    assert!(flown.shots[0].is_normalized);
    assert!(!file("garmin.csv").1.shots[0].is_normalized, "not said");
    // the spin axis has one value: the column that TrackMan's own flight model predicted is ignored
    assert_eq!(
        flown.shots[0]
            .values
            .iter()
            .filter(|value| value.of == Outcome::SpinAxis)
            .count(),
        1
    );
    let remarks = shots
        .remarks()
        .iter()
        .map(ToString::to_string)
        .collect::<String>();
    assert!(
        remarks.contains("Carry (Sim)")
            && remarks.contains("TMD No")
            && !remarks.contains("did you mean"),
        "{remarks}"
    );
    let remarks = file("rapsodo.csv")
        .0
        .remarks()
        .iter()
        .map(ToString::to_string)
        .collect::<String>();
    for says in [
        "Ball Speed in mph",
        "Carry Distance in yd",
        "Apex in ft",
        "are read in degrees: the heads have no unit",
    ] {
        assert!(remarks.contains(says), "no '{says}' in {remarks}");
    }
}

#[test]
fn same_table_in_every_encoding() {
    let text = fs::read_to_string(path("trackman.csv")).unwrap();
    let wide: Vec<u8> = format!("\u{feff}{text}")
        .encode_utf16()
        .flat_map(u16::to_le_bytes)
        .collect();
    let expected = fly_shots(io::Cursor::new(text.clone())).1.remove(0);
    for bytes in [
        format!("\u{feff}\u{feff}{text}").into_bytes(),
        wide,
        text.replace('\n', "\r\n").into_bytes(),
    ] {
        let found = fly_shots(io::Cursor::new(bytes)).1.remove(0);
        assert_eq!(found.shots.len(), 2);
        for row in 0..2 {
            assert_eq!(found.predicted(row, 0), expected.predicted(row, 0));
            assert_eq!(found.shots[row].line, expected.shots[row].line);
        }
    }
    // calibrations read these encodings too
    let table = |bytes: Vec<u8>| {
        longdrive::study::calibrate::ShotTable::read(&Setup::modern_driver(), "a.csv", &bytes[..])
    };
    let own = "ball_speed [mph],launch_angle [deg],backspin [rpm],carry [yd]\n160,12,2500,262\n";
    let wide: Vec<u8> = format!("\u{feff}{own}")
        .encode_utf16()
        .flat_map(u16::to_le_bytes)
        .collect();
    assert_eq!(
        table(wide).unwrap().shots[0].measured,
        table(own.into()).unwrap().shots[0].measured
    );
}

#[test]
fn same_table_in_windows_1252_whose_first_other_character_is_far_from_the_beginning() {
    let heads = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Player,Carry [yd]\n";
    let rows = "160,12,2500,A,262\n".repeat(6000);
    let text = format!("{heads}{rows}160,12\u{b0},2500,B,262\n");
    assert!(text.len() > 1 << 16);
    let bytes: Vec<u8> = text.chars().map(|c| u8::try_from(c).unwrap()).collect();
    let (shots, all, tally) = fly_shots(io::Cursor::new(bytes.clone()));
    let (.., of_utf_8) = fly_shots(io::Cursor::new(text));
    assert_eq!((tally.rows, tally.flown), (6001, 6001));
    assert_eq!(tally.all, of_utf_8.all);
    let last = all.last().unwrap().shots.last().unwrap();
    assert_eq!(last.text, "160,12\u{b0},2500,B,262");
    let says = "its text is not in UTF-8, and is read as Windows-1252";
    let remarks = shots.final_remarks();
    assert!(remarks.iter().any(|remark| remark.to_string() == says));
    let table =
        longdrive::study::calibrate::ShotTable::read(&Setup::modern_driver(), "a", &bytes[..]);
    let table = table.unwrap();
    assert_eq!(table.shots.len(), 6001);
    assert!(
        table
            .remarks
            .iter()
            .any(|remark| remark.to_string() == says)
    );
}

/// Rows that cannot be flown: the row, the kind of the reason, and words of the reason.
const BAD: [(&str, &str, &str); 13] = [
    (
        ",12,2500,3,262",
        "missing value",
        "Ball Speed: the cell is empty",
    ),
    (
        "160,,2500,3,262",
        "missing value",
        "Launch Angle: the cell is empty",
    ),
    (
        "160,12,,3,262",
        "missing value",
        "Spin Rate: the cells of the spin are empty",
    ),
    (
        "N/A,12,2500,3,262",
        "missing value",
        "Ball Speed: the cell is empty",
    ),
    (
        "fast,12,2500,3,262",
        "not a number",
        "Ball Speed: 'fast' is not a number",
    ),
    (
        "nan,12,2500,3,262",
        "missing value",
        "Ball Speed: the cell is empty",
    ),
    (
        "500,12,2500,3,262",
        "out of range",
        "500 mph is outside of the range of drives, above 0 to 270 mph",
    ),
    ("0,12,2500,3,262", "out of range", "Ball Speed: 0 mph"),
    ("160,95,2500,3,262", "out of range", "Launch Angle: 95 deg"),
    ("160,12,90000,3,262", "out of range", "Spin Rate: 90000 rpm"),
    (
        "160,12,2500",
        "number of cells",
        "the row has 3 cells, but the head has 5 cells",
    ),
    (
        "160,12,2500,3,262,7",
        "number of cells",
        "the row has 6 cells",
    ),
    ("Average,12,2500,3,262", "sums up other rows", "(Average)"),
];

const HEAD: &str =
    "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Spin Axis [deg],Carry [yds]\n";

#[test]
fn every_row_is_kept_with_its_line_and_its_reason() {
    let good = "160,12,2500,3,262\n";
    let text = BAD
        .iter()
        .fold(HEAD.to_owned(), |text, (row, ..)| text + row + "\n" + good);
    let text = text + "160,12,2500,\"3,262\n" + good;
    let rows = 2 * BAD.len() + 2;
    let (shots, all, tally) = fly_shots(io::Cursor::new(text.clone()));
    let flown = &all[0];
    assert_eq!(
        (flown.shots.len(), tally.rows, tally.flown),
        (rows, rows as u64, rows as u64 / 2)
    );
    for (at, (row, kind, says)) in BAD.iter().enumerate() {
        let refusal = flown.shots[2 * at]
            .refusal()
            .unwrap_or_else(|| panic!("{row} is flown"));
        assert!(
            refusal.kind == *kind && refusal.reason.contains(says),
            "{row}: {refusal:?}"
        );
        assert_eq!(flown.shots[2 * at].line, 2 * at as u64 + 2);
        assert!(
            flown.shots[2 * at + 1].refusal().is_none(),
            "the row after {row}"
        );
    }
    assert_eq!(
        flown.shots[rows - 2].refusal().unwrap().kind,
        "quote not closed"
    );
    let counted: u64 = tally.refused.values().map(|refused| refused.count).sum();
    assert_eq!(counted, rows as u64 / 2);
    // every format has a line for every row, and the table can be read again
    for (format, writer) in [
        ("csv", ShotWriter::csv(&shots, &OF, System::Us)),
        (
            "launch-monitor",
            ShotWriter::launch_monitor(&shots, &OF, System::Us),
        ),
        ("jsonl", ShotWriter::json_lines(&shots, &OF)),
        ("open-connect", ShotWriter::open_connect()),
    ] {
        let written = String::from_utf8([writer.head(), writer.rows(flown)].concat()).unwrap();
        let heads = written.lines().count() - rows;
        assert_eq!(
            heads,
            usize::from(["csv", "launch-monitor"].contains(&format)),
            "{format}"
        );
        if format == "jsonl" {
            for line in written.lines() {
                let row: Value =
                    serde_json::from_str(line).unwrap_or_else(|error| panic!("{error}: {line}"));
                assert_eq!(faults("fly-row", &row), [""; 0], "{line}");
            }
            continue;
        }
        let again = crate::shots::fly_shots(io::Cursor::new(written));
        assert_eq!(
            (again.2.rows, again.2.flown),
            (rows as u64, rows as u64 / 2),
            "{format:?}: {:?}",
            again.2.refused
        );
        for row in 0..rows {
            let (first, second) = (flown.predicted(row, 0), again.1[0].predicted(row, 0));
            assert_eq!(first.is_some(), second.is_some(), "{format:?}");
            if let (Some(first), Some(second)) = (first, second) {
                close(second, first, first, 1e-6, &format!("{format:?}"));
            }
            assert_eq!(
                flown.residual(row, 0).is_some(),
                again.1[0].residual(row, 0).is_some(),
                "{format:?}"
            );
        }
    }
    // an impossible measured value does not prevent the flight
    let odd = format!("{HEAD}160,12,2500,3,5000\n160,12,2500,3,far\n160,12,2500,3,0\n");
    let (_, all, tally) = crate::shots::fly_shots(io::Cursor::new(odd));
    assert_eq!(
        (tally.flown, tally.noted, tally.all[0].moments.count),
        (3, 3, 0)
    );
    assert!(
        all[0].shots[0].notes[0].starts_with("not compared: Carry: 5000 yd is outside"),
        "{:?}",
        all[0].shots[0].notes
    );
}

#[test]
fn messages_that_cannot_be_flown_give_the_reason() {
    let (_, flown, _) = file("open-connect.jsonl");
    for (row, kind, says) in [
        (
            1,
            "missing value",
            "BallData.Speed (did you mean 'Speed' instead of 'Sped'?): the cell is empty",
        ),
        (2, "not JSON", "the JSON object does not end"),
        (
            3,
            "not a number",
            "Units: 'Furlongs' is unknown; write \"Yards\" or \"Meters\"",
        ),
        (
            4,
            "not a number",
            "BallData.Speed: \"fast\" is not a number",
        ),
    ] {
        let refusal = flown.shots[row].refusal().unwrap();
        assert!(
            refusal.kind == kind && refusal.reason.contains(says),
            "{row}: {refusal:?}"
        );
        assert_eq!(flown.shots[row].line, row as u64 + 1);
    }
    let metric = "{\"Units\": \"Meters\", \"BallData\": {\"Speed\": 71.5264, \"TotalSpin\": 2500, \"SpinAxis\": 3, \"HLA\": -1.5, \"VLA\": 12}}";
    let found = crate::shots::fly_shots(io::Cursor::new(metric));
    close(
        found.1[0].predicted(0, 0).unwrap(),
        flown.predicted(0, 0).unwrap(),
        240.0,
        1e-5,
        "metric",
    );
}

/// The carries, 246, are meant in metres and read in yards. The messages have no heads that could
/// state a unit, so the advice names their field `Units`.
#[test]
fn the_advice_on_a_wrong_unit_of_messages_names_their_units() {
    let message = r#"{"BallData": {"Speed": 160, "VLA": 12, "HLA": 0, "TotalSpin": 2500, "SpinAxis": 0,
        "CarryDistance": 246}}"#;
    let (shots, _, tally) = fly_shots(io::Cursor::new(message.repeat(8)));
    let warnings: Vec<String> = tally
        .unit_warnings(&shots)
        .iter()
        .map(ToString::to_string)
        .collect();
    assert!(
        warnings[0].contains("check Units in the messages") && !warnings[0].contains("head"),
        "{warnings:?}"
    );
}

#[test]
fn tables_without_a_launch_name_the_nearest_head() {
    let misspelt = "Club,Ball Sped (mph),Launch Angl (deg),Spin (rpm)\nDriver,160,12,2500\n";
    let error = Shots::read(&Setup::modern_driver(), "a.csv", misspelt.as_bytes())
        .map(drop)
        .unwrap_err()
        .to_string();
    for says in [
        "no column has the ball speed or the launch angle",
        "'Ball Sped' (did you mean 'ball speed'?)",
        "'Launch Angl'",
    ] {
        assert!(error.contains(says), "no '{says}' in {error}");
    }
    let refused = |text: &'static str| {
        Shots::read(&Setup::modern_driver(), "a.csv", text.as_bytes())
            .err()
            .unwrap()
            .to_string()
    };
    for (text, says) in [
        ("", "a.csv: it is empty"),
        (
            "Ball Sped [mph],Launch Angle [deg],Spin Rate [rpm]\n1,2,3\n",
            "no column has the ball speed; near a known head: 'Ball Sped' (did you mean 'ball \
             speed'?)",
        ),
        // `Launch` may be `Launch V` or `Launch H`
        (
            "Ball Speed [mph],Launch [deg],Back Spin [rpm]\n1,2,3\n",
            "no column has the launch angle; give each a head that is known",
        ),
        // advice on heads of other quantities does not help
        (
            "Ball Speed [mph],Back Spin [rpm],Descent [deg],Carri [yd]\n1,2,3,4\n",
            "no column has the launch angle; give each a head that is known",
        ),
        (
            "Ball Speed [mph],Launch Angle [deg],Carry [yds]\n1,2,3\n",
            "no column has the spin (spin rate, total spin or backspin)",
        ),
        (
            "Foo,Bar,Baz\n1,2,3\n",
            "unknown columns 'Foo', 'Bar', 'Baz'; name the columns of the launch by known heads, \
             as in 'Ball Speed [mph]', 'Launch Angle [deg]', 'Spin Rate [rpm]', and take the others \
             out",
        ),
        (
            "Ballgeschwindigkeit;Abflugwinkel;Spinrate\n165;11,2;2600\n",
            "as in 'Ball Speed [mph]'",
        ),
        (
            "ball_sped [mph],launch_angle [deg],backspin [rpm]\n1,2,3\n",
            "did you mean 'ball_speed'?",
        ),
        (
            "Ball Speed [kg],Launch Angle [deg],Spin Rate [rpm]\n1,2,3\n",
            "[kg] is not the unit of a speed",
        ),
        (
            "ball_speed,launch_angle [deg],backspin [rpm]\n1,2,3\n",
            "it has no unit",
        ),
    ] {
        assert!(refused(text).contains(says), "{text}: {}", refused(text));
    }
    // `calibrate` and `delivery` also refuse misspelt heads
    let read = |text: &str| {
        longdrive::study::calibrate::ShotTable::read(
            &Setup::modern_driver(),
            "a.csv",
            text.as_bytes(),
        )
    };
    let error =
        read("Ball Sped (mph),Lanch Angle (deg),Backspin (rpm),Carry (yd)\n150,12,2600,240\n")
            .err()
            .unwrap();
    let error = error.to_string();
    for says in [
        "neither a whole launch",
        "'Ball Sped' (did you mean 'ball speed'?)",
        "'Lanch Angle' (did you mean",
    ] {
        assert!(error.contains(says), "no '{says}' in {error}");
    }
    let error = read("swing.sped [mph],club.lft [deg],carry [yd]\n100,10,200\n")
        .err()
        .unwrap()
        .to_string();
    assert!(
        error.contains(
            "unknown columns 'swing.sped' (did you mean 'swing.speed'?), 'club.lft' (did you mean \
             'club.loft'?)"
        ),
        "{error}"
    );
    // if two columns have the same meaning, the first is used, and a remark names the second
    let text =
        "Ball Speed [mph],Ball Speed [m/s],Launch Angle [deg],Spin Rate [rpm]\n165,73.8,11,2500\n";
    let (shots, ..) = fly_shots(text.as_bytes());
    let remarks: Vec<String> = shots.remarks().iter().map(ToString::to_string).collect();
    assert_eq!(
        remarks,
        [
            "columns given twice; only the first is used: 'Ball Speed [m/s]' repeats \
          'Ball Speed [mph]'"
        ]
    );
    // unused columns are listed, with the nearest known head
    let text = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Carri [yds]\n160,12,2500,262\n";
    let (shots, ..) = fly_shots(text.as_bytes());
    assert!(
        shots.remarks()[0]
            .to_string()
            .contains("Carri [yds] (did you mean 'carry'?)")
            || shots.remarks()[0]
                .to_string()
                .contains("Carri (did you mean 'carry'?)"),
        "{:?}",
        shots.remarks()
    );
}

#[test]
fn ambiguous_decimal_and_thousands_marks_are_refused() {
    // in a table with commas between the cells, a comma in a number can only separate thousands
    let quoted =
        "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm]\n\"165,5\",\"11,2\",\"2,600\"\n";
    let (_, all, _) = fly_shots(quoted.as_bytes());
    let reason = &all[0].shots[0].refusal().unwrap().reason;
    let says = "Ball Speed: '165,5' is not a number: a comma marks decimals only in tables \
                whose cells are separated by semicolons or \
                tabs; write 165.5, or separate the cells by one of these";
    assert_eq!(reason, says);
    // commas are decimals here, so that a point separates thousands
    let (_, flown, _) = file("decimal-commas.csv");
    assert_eq!(flown.predicted(0, 0), flown.predicted(1, 0));
    let rows = |text: &'static str| crate::shots::fly_shots(text.as_bytes());
    // the point separates decimals in this table, so that a comma separates thousands
    let (_, all, _) = rows(
        "Ball Speed [mph];Launch Angle [deg];Spin Rate [rpm]\n160.5;12.1;2,500\n160.5;12.1;2500\n",
    );
    assert_eq!(all[0].predicted(0, 0), all[0].predicted(1, 0));
    let (_, all, _) = rows("Ball Speed [mph];Launch Angle [deg];Spin Rate [rpm]\n160;12;2,500\n");
    assert!(all[0].shots[0].refusal().is_some(), "nothing tells");
}

/// Decimal commas of other numbers show that a point separates thousands.
#[test]
fn exact_thousands_beside_decimal_commas() {
    let text = "Ball Speed (km/h);Launch Angle (deg);Spin Rate (rpm);Carry (m)\n\
                257,5;12,0;2.500;239,6\n257,5;12,0;2.500,5;239,6\n";
    let (_, all, _) = fly_shots(text.as_bytes());
    let rpm = std::f64::consts::PI / 30.0;
    for (shot, expected) in all[0].shots.iter().zip([2500.0, 2500.5]) {
        let spin = shot.value(Outcome::Spin).unwrap().value / rpm;
        close(spin, expected, expected, 1e-12, "spin");
    }
}

#[test]
fn marks_of_parameters_and_of_the_club_are_read_as_those_of_the_launch() {
    let heads = "Ball Speed [mph];Launch Angle [deg];Spin Rate [rpm];ball.mass [mg];Club Speed \
                 [mm/s]\n";
    let rows = |cells: &str| {
        let text = format!("{heads}{cells}\n");
        fly_shots(io::Cursor::new(text)).1.remove(0)
    };
    // this table has decimal points, so a comma separates thousands
    let found = rows("160.5;12.1;2500;45,930;46,000");
    let expected = rows("160.5;12.1;2500;45930;46000");
    assert_eq!(found.predicted(0, 0), expected.predicted(0, 0));
    assert!(found.predicted(0, 0).is_some());
    assert_eq!(found.shots[0].club, expected.shots[0].club);
    assert_eq!(found.shots[0].club.speed, Some(46.0));
    let unclear = rows("160;12;2500;45,930;46,000");
    let reason = &unclear.shots[0].refusal().unwrap().reason;
    let says = "the mark in '45,930' may separate decimals or thousands";
    assert!(reason.contains(says), "{reason}");
    assert_eq!(unclear.shots[0].club.speed, None);
}

#[test]
fn exact_bias_and_errors_by_ball_speed() {
    // measured carries with known errors
    let speeds = [110.0, 150.0, 155.0, 165.0, 190.0];
    let off = [-1.0, 2.0, -4.0, 3.0, 0.5];
    let row = |speed: f64, carry: f64| format!("{speed},12,2500,3,{carry:?}\n");
    let carries = fly_shots(io::Cursor::new(
        speeds
            .iter()
            .fold(HEAD.to_owned(), |text, speed| text + &row(*speed, 100.0)),
    ))
    .1;
    let carry = |at: usize| carries[0].predicted(at, 0).unwrap() / 0.9144;
    let text = (0..5).fold(HEAD.to_owned(), |text, at| {
        text + &row(speeds[at], carry(at) - off[at])
    });
    let tally = fly_shots(io::Cursor::new(text)).2;
    let yards = |value: Option<f64>| value.unwrap() / 0.9144;
    close(yards(tally.all[0].moments.mean), 0.1, 1.0, 1e-9, "bias");
    close(
        yards(tally.all[0].mean_absolute()),
        2.1,
        1.0,
        1e-9,
        "mean of the sizes",
    );
    let variance = off.iter().map(|off| (off - 0.1_f64).powi(2)).sum::<f64>() / 4.0;
    close(
        yards(tally.all[0].moments.deviation()),
        variance.sqrt(),
        1.0,
        1e-9,
        "deviation",
    );
    let bands: Vec<(u64, f64)> = tally
        .bands
        .iter()
        .filter(|band| band.sums[0].moments.count > 0)
        .map(|band| (band.sums[0].moments.count, yards(band.sums[0].moments.mean)))
        .collect();
    for ((count, bias), (expected, of)) in
        bands.iter().zip([(1, -1.0), (2, -1.0), (1, 3.0), (1, 0.5)])
    {
        assert_eq!(*count, expected);
        close(*bias, of, 1.0, 1e-9, "bias of a band");
    }
    assert_eq!(bands.len(), 4);
}

/// A text of `rows` lines that counts the lines read from it.
struct Many {
    rows: usize,
    given: Arc<AtomicUsize>,
    line: Vec<u8>,
    at: usize,
}

impl Read for Many {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        if self.at == self.line.len() {
            let row = self.given.fetch_add(1, Ordering::Relaxed);
            if row >= self.rows {
                return Ok(0);
            }
            let mut line = String::new();
            let _ = writeln!(
                line,
                "{:.1},{:.1},{},{:.1},250",
                140 + row % 50,
                8 + row % 9,
                2000 + row % 1500,
                row % 7
            );
            (self.line, self.at) = (line.into_bytes(), 0);
        }
        let count = into.len().min(self.line.len() - self.at);
        into[..count].copy_from_slice(&self.line[self.at..self.at + count]);
        self.at += count;
        Ok(count)
    }
}

#[test]
fn same_streamed_rows_for_any_number_of_threads() {
    let mut setup = Setup::modern_driver();
    // few steps a flight, so that most of the time is reading and writing
    setup.set_all(crate::common::LARGE_STEPS).unwrap();
    let rows = 60_000;
    let written = [1, 3].map(|threads| {
        let given = Arc::new(AtomicUsize::new(0));
        let source = Many {
            rows,
            given: given.clone(),
            line: HEAD.into(),
            at: 0,
        };
        let mut shots = Shots::read(&setup, "many.csv", source).unwrap();
        let writer = ShotWriter::csv(&shots, &OF, System::Us);
        let flying = Flying::new(&setup, &shots.other_parameters, &OF).unwrap();
        let (mut bytes, mut taken, mut most) = (vec![], 0, 0);
        let run = Run {
            threads,
            ..Run::default()
        };
        flying
            .fly(
                &mut shots,
                &run,
                |flown| (flown.shots.len(), writer.rows(&flown)),
                |(count, more): (usize, Vec<u8>)| {
                    most = most.max(given.load(Ordering::Relaxed) - taken);
                    taken += count;
                    bytes.extend(more);
                    Ok(())
                },
            )
            .unwrap();
        assert_eq!(taken, rows);
        // only the beginning of the file and a few chunks of rows that are read but not yet written
        // are in memory
        assert!(
            most < 24_000,
            "{most} rows at a time with {threads} threads"
        );
        bytes
    });
    assert!(written[0] == written[1]);
}

/// Statistics of a chunk and 6 rows, flown in small steps. `work` is called after the flights of
/// each chunk, before the flights of the next; `sink` when the source has ended.
fn fly_two_chunks(
    stop: &AtomicBool,
    work: impl Fn() + Sync,
    sink: impl Fn(),
) -> longdrive::Result<ShotStatistics> {
    let mut setup = Setup::modern_driver();
    setup.set_all([("flight.step", "0.5ms")])?;
    let source = Many {
        rows: CHUNK + 6,
        given: Arc::default(),
        line: HEAD.into(),
        at: 0,
    };
    let mut shots = Shots::read(&setup, "many.csv", source)?;
    let flying = Flying::new(&setup, &shots.other_parameters, &OF)?;
    let run = Run {
        threads: 1,
        stop: Some(stop),
        ..Run::default()
    };
    let sink = |()| {
        sink();
        Ok(())
    };
    flying.fly(&mut shots, &run, |_| work(), sink)
}

#[test]
fn an_interruption_cuts_the_flights_of_a_chunk() {
    let stop = AtomicBool::new(false);
    let set = || stop.store(true, Ordering::Relaxed);
    let flown = fly_two_chunks(&stop, set, || {}).unwrap();
    assert_eq!((flown.rows, flown.is_complete), (CHUNK as u64, false));
}

#[test]
fn rows_are_complete_if_all_were_flown_before_the_interruption() {
    let stop = AtomicBool::new(false);
    let chunks = AtomicUsize::new(0);
    let set_after_last = || {
        let before = chunks.fetch_add(1, Ordering::Relaxed);
        stop.store(before == 1, Ordering::Relaxed);
    };
    let flown = fly_two_chunks(&stop, || {}, set_after_last).unwrap();
    assert_eq!((flown.rows, flown.is_complete), (CHUNK as u64 + 6, true));
}

#[test]
fn the_command_writes_rows_and_their_prediction_errors() {
    let folder = tempfile::tempdir().unwrap();
    let to = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let shots = path("trackman.csv").display().to_string();
    let (status, answer) = json(&["fly", &shots]);
    assert_eq!(
        (status, answer["status"].as_str(), answer["source"].as_str()),
        (0, Some("done"), Some("TrackMan"))
    );
    assert_eq!(
        (
            number(&answer["rows"]),
            number(&answer["flown"]),
            &answer["file"]
        ),
        (2.0, 2.0, &Value::Null)
    );
    close(
        number(&answer["residuals"][0]["instruments"]),
        6.72 * 0.9144,
        1.0,
        1e-12,
        "Bliss & Langdown",
    );
    for (name, lines) in [("a.csv", 4), ("a.jsonl", 2), ("a.json", 2)] {
        let output = longdrive(&["fly", &shots, "-o", &to(name)]);
        assert_eq!(output.status, 0, "{}", output.err);
        let out = on_one_line(&output.out);
        assert!(
            out.contains("predicted − measured") && out.contains("Bliss & Langdown 2026"),
            "{out}"
        );
        assert!(
            output.out.lines().all(|line| line.chars().count() <= 100),
            "{}",
            output.out
        );
        assert_eq!(
            fs::read_to_string(to(name)).unwrap().lines().count(),
            lines,
            "{name}"
        );
    }
    // the written rows begin with the rows of the export
    let (own, written) = (
        fs::read_to_string(&shots).unwrap(),
        fs::read_to_string(to("a.csv")).unwrap(),
    );
    for (own, written) in own.lines().skip(3).zip(written.lines().skip(2)) {
        assert!(written.starts_with(own), "{written}");
    }
    let standard = longdrive(&["fly", &shots, "--units", "metric"]);
    assert!(
        standard.out.contains("[m]")
            && standard
                .err
                .contains("2 rows (TrackMan): 2 flown, 0 not flown"),
        "{}",
        standard.err
    );
    // `--of carry` warns that the measured carry is a distance from the tee
    let carry = on_one_line(&longdrive(&["fly", &shots, "--of", "carry"]).err);
    assert!(
        carry.contains("the measured carry is not compared: it is the distance from the tee"),
        "{carry}"
    );
    assert!(
        !standard.err.contains("is not compared"),
        "{}",
        standard.err
    );
    let (_, thin) = json(&["fly", &shots, "--set", "air.density=1.0kg/m^3"]);
    assert!(number(&thin["residuals"][0]["bias"]) > number(&answer["residuals"][0]["bias"]) + 3.0);
    let only = to("own.csv");
    fs::write(
        &only,
        "ball_speed [mph],launch_angle [deg],backspin [rpm],air.density \
         [kg/m^3]\n160,12,2500,1.0\n160,12,2500,1.2\n",
    )
    .unwrap();
    let output = longdrive(&["fly", &only, "-q", "--of", "carry"]);
    let carries: Vec<f64> = output
        .out
        .lines()
        .skip(1)
        .map(|line| line.split(',').nth(8).unwrap().parse().unwrap())
        .collect();
    assert!(carries[0] > carries[1] + 5.0, "{}", output.out);
    let none = to("none.csv");
    fs::write(&none, format!("{HEAD},12,2500,3,262\n")).unwrap();
    let (status, answer) = json(&["fly", &none]);
    assert_eq!((status, answer["status"].as_str()), (1, Some("no-answer")));
    assert!(
        answer["message"]
            .as_str()
            .unwrap()
            .contains("line 2: Ball Speed"),
        "{answer}"
    );
    let warning = answer["warnings"][0].as_str().unwrap();
    for word in ["the only row could not be flown", "line 2: Ball Speed"] {
        assert!(warning.contains(word), "'{word}' is not in {warning}");
    }
    fs::write(to("head.csv"), HEAD).unwrap();
    for (args, says) in [
        (
            vec!["fly", "none.csv"],
            "none.csv: it cannot be read (there is no such file)",
        ),
        (
            vec!["fly", &to("head.csv")],
            "it has no rows; give a row for each shot",
        ),
        (
            vec!["fly", &shots, "-o", &to("a.csv")],
            "it already exists; use --overwrite to replace it",
        ),
        (
            vec!["fly", &shots, "-o", &shots, "--overwrite"],
            "it is also an input",
        ),
        (
            vec!["fly", &shots, "-o", &to("a.txt")],
            "must end in .csv, .jsonl, .json or .parquet",
        ),
        (
            vec!["fly", &shots, "--overwrite"],
            "--overwrite replaces a file",
        ),
        (
            vec!["fly", &shots, "--of", "ball_speed"],
            "it is a launch condition, which each row states already",
        ),
        (
            vec!["fly", &shots, "--of", "all,ball_speed"],
            "ball_speed: it is a launch condition, which each row states already",
        ),
        (vec!["fly", &shots, "--of", "cary"], "did you mean 'carry'?"),
        (
            vec!["fly", &shots, "--set", "club.loft=10deg"],
            "trackman.csv are launches",
        ),
        (
            vec![
                "fly",
                &shots,
                "--launch",
                "ball_speed=160mph,launch_angle=12deg,spin=2500rpm",
            ],
            "give the launch of each ball",
        ),
        (vec!["fly", &shots, "--address", "0.0.0.0"], "--listen"),
        (
            vec!["fly", &shots, "--listen", "0"],
            "trackman.csv are both given: with --listen the file is the setup of all \
             messages",
        ),
        (
            vec!["fly", &shots, "mae494", "--listen", "0"],
            "a setup is given after it); to fly the shots",
        ),
        (
            vec!["fly", "--listen", "0", "--threads", "2"],
            "'--listen [<PORT>]' cannot be used with '--threads <N>'",
        ),
        (
            vec!["fly", "--listen", "x"],
            "it must be a whole number from 0 to 65535",
        ),
    ] {
        let output = longdrive(&args);
        let err = on_one_line(&output.err);
        assert!(
            output.status == 2 && err.contains(says),
            "{args:?}: no '{says}' in {err}"
        );
    }
}
