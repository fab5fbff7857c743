//! Values that rows of shots state: several forms of spin, missing values, and columns that are
//! known but not used.

use crate::common::close;
use crate::shots::fly_shots;
use longdrive::report::ShotWriter;
use longdrive::shots::{Flown, Refusal};
use longdrive::study::calibrate::ShotTable;
use longdrive::units::System;
use longdrive::{Outcome, Setup};
use std::io::Cursor;

/// The flown shots of these rows.
fn rows(text: &str) -> Flown {
    fly_shots(Cursor::new(text.to_owned())).1.remove(0)
}

/// Backspin and sidespin of a row, rpm.
fn spins(flown: &Flown, row: usize) -> [f64; 2] {
    let launch = flown.shots[row]
        .launch()
        .unwrap_or_else(|| panic!("{:?}", flown.reason(row)));
    [launch[3], launch[4]].map(|spin| spin * 30.0 / std::f64::consts::PI)
}

fn is_near(found: [f64; 2], expected: [f64; 2], what: &str) {
    for (found, expected) in found.into_iter().zip(expected) {
        close(found, expected, 2500.0, 1e-9, what);
    }
}

/// A message whose ball data have `ball` in addition to speed and launch angles.
fn message(ball: &str) -> String {
    format!("{{\"BallData\":{{\"Speed\":150,\"VLA\":12,\"HLA\":0,{ball}}}}}\n")
}

#[test]
fn exact_sidespin_from_spin_axis_and_backspin() {
    let side = 2500.0 * 10.0_f64.to_radians().tan();
    let sent = rows(
        &(message(r#""BackSpin":2500,"SpinAxis":10"#)
            + &message(r#""BackSpin":2500,"SpinAxis":95"#)),
    );
    let table = rows(
        "Ball Speed [mph],Launch Angle [deg],Launch Direction [deg],Backspin [rpm],Spin Axis \
         [deg],Side [yd]\n\
         150,12,0,2500,10,5\n150,12,0,2500,95,5\n150,12,0,2500,89.9,5\n",
    );
    for flown in [&sent, &table] {
        is_near(spins(flown, 0), [2500.0, side], "axis of 10°");
        assert_eq!(flown.shots[0].notes, [""; 0]);
        let reason = flown.reason(1).unwrap();
        assert!(
            reason.contains("the axis must be between −90° and 90°"),
            "{reason}"
        );
        assert_eq!(
            flown.shots[1].refusal().map(|refusal| refusal.kind),
            Some("out of range")
        );
    }
    assert!(table.residual(0, 1).is_some(), "the tilt is stated");
    let reason = table.reason(2).unwrap();
    assert!(
        reason.contains("Spin Axis (sidespin = backspin · tan(axis)): ")
            && reason.contains("20000"),
        "{reason}"
    );
}

#[test]
fn contradictory_spins_are_reported_with_the_used_one() {
    let sent = rows(
        &[
            r#""TotalSpin":2500,"SpinAxis":5,"BackSpin":1000,"SideSpin":-500"#,
            r#""TotalSpin":2500,"SpinAxis":5,"BackSpin":2490,"SideSpin":218"#,
            r#""TotalSpin":2500,"SpinAxis":5,"BackSpin":0,"SideSpin":0"#,
            r#""TotalSpin":0,"SpinAxis":0,"BackSpin":2400,"SideSpin":-500"#,
            r#""TotalSpin":2500,"BackSpin":0,"SideSpin":-700"#,
        ]
        .map(message)
        .concat(),
    );
    let (sin, cos) = 5.0_f64.to_radians().sin_cos();
    let total = [2500.0 * cos, 2500.0 * sin];
    for (row, expected) in [total, total, total, [2400.0, -500.0], [2400.0, -700.0]]
        .into_iter()
        .enumerate()
    {
        is_near(spins(&sent, row), expected, &format!("message {row}"));
        assert_eq!(
            sent.shots[row].notes.len(),
            usize::from(row == 0),
            "{row}: {:?}",
            sent.shots[row].notes
        );
    }
    let note = &sent.shots[0].notes[0];
    for says in [
        "BallData.TotalSpin and BallData.SpinAxis are used, not BallData.BackSpin (1000 rpm)",
        "SideSpin (-500 rpm)",
    ] {
        assert!(
            note.replace('−', "-").contains(says),
            "no '{says}' in {note}"
        );
    }
    let text = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Spin Axis [deg],Backspin \
                [rpm],Carry [yd]\n\
                150,12,2500,5,1000,240\n150,12,2500,5,2490,240\n";
    let table = ShotTable::read(&Setup::modern_driver(), "a.csv", text.as_bytes()).unwrap();
    let remarks: Vec<String> = table
        .remarks
        .iter()
        .map(ToString::to_string)
        .filter(|remarks| remarks.contains("contradict"))
        .collect();
    assert!(
        remarks.len() == 1
            && remarks[0].starts_with("row 1: ")
            && remarks[0].contains("not Backspin (1000 rpm)"),
        "{remarks:?}"
    );
}

#[test]
fn the_spin_is_taken_from_the_cells_of_each_row() {
    let text = "Ball Speed,Launch Angle,Launch Direction,Backspin,Sidespin,Spin Rate,Spin \
                Axis,Carry Distance,Carry Deviation Distance\n\
                [mph],[deg],[deg],[rpm],[rpm],[rpm],[deg],[yds],[yds]\n\
                150,12,0,2400,-700,,,240,1\n150,12,0,,,2500,0,240,1\n150,12,0,,-700,2500,,240,1\n150,12,0,2500,,,,240,1\n150,12,0,,,,3,240,1\n";
    let flown = rows(text);
    let expected = [
        [2400.0, -700.0],
        [2500.0, 0.0],
        [2400.0, -700.0],
        [2500.0, 0.0],
    ];
    for (row, expected) in expected.into_iter().enumerate() {
        is_near(spins(&flown, row), expected, &format!("row {row}"));
    }
    assert_eq!(
        flown.shots[4].refusal().map(|Refusal { kind, .. }| *kind),
        Some("missing value")
    );
    let table = ShotTable::read(&Setup::modern_driver(), "a.csv", text.as_bytes()).unwrap();
    assert_eq!(
        table.shots.iter().map(|shot| shot.row).collect::<Vec<_>>(),
        [1, 2, 3, 4]
    );
    let rpm = |shot: usize, name: &str| {
        let input = table.shots[shot]
            .inputs
            .iter()
            .find(|(parameter, _)| parameter.name == name)
            .unwrap();
        input.1 * 30.0 / std::f64::consts::PI
    };
    for (shot, expected) in expected.into_iter().enumerate() {
        is_near(
            [rpm(shot, "launch.backspin"), rpm(shot, "launch.sidespin")],
            expected,
            "calibrate",
        );
    }
}

#[test]
fn lateral_is_not_fitted_where_the_direction_or_the_tilt_is_not_measured() {
    let read = |text: &str| ShotTable::read(&Setup::modern_driver(), "a.csv", text.as_bytes());
    let text = "ball_speed [mph],launch_angle [deg],launch_direction [deg],spin [rpm],spin_axis \
                [deg],carry [yd],lateral [yd]\n\
                150,12,1,2500,2,240,5\n150,12,,2500,2,240,5\n150,12,1,2500,,240,5\n";
    let table = read(text).unwrap();
    let measured = |shot: usize| {
        table.shots[shot]
            .measured
            .iter()
            .map(|one| one.outcome)
            .collect::<Vec<_>>()
    };
    assert_eq!(measured(0), [Outcome::CarryDistance, Outcome::Lateral]);
    assert_eq!(
        (measured(1), measured(2)),
        (vec![Outcome::CarryDistance], vec![Outcome::CarryDistance])
    );
    let remarks = table
        .remarks
        .iter()
        .map(ToString::to_string)
        .collect::<Vec<_>>()
        .join("\n");
    assert!(
        remarks.contains("lateral is not compared in rows without")
            && remarks.contains(": row 2, row 3"),
        "{remarks}"
    );
    // without direction and spin axis, lateral is not compared, and the answer does not mention its
    // uncertainty
    let table = read(
        "ball_speed [mph],launch_angle [deg],spin [rpm],carry [yd],lateral \
              [yd]\n150,12,2500,240,5\n",
    )
    .unwrap();
    let remarks = table
        .remarks
        .iter()
        .map(ToString::to_string)
        .collect::<Vec<_>>()
        .join("\n");
    assert!(
        remarks.contains("lateral is not compared") && !remarks.contains("sigma lateral"),
        "{remarks}"
    );
    let error =
        read("ball_speed [mph],launch_angle [deg],spin [rpm],lateral [yd]\n150,12,2500,5\n")
            .unwrap_err()
            .to_string();
    assert!(
        error.contains("the only measured value is lateral"),
        "{error}"
    );
}

#[test]
fn assumed_uncertainties_of_every_section_are_reported() {
    let launch = "Ball Speed [mph],Launch Angle [deg],Launch Direction [deg],Spin Rate \
                  [rpm],Spin Axis [deg]";
    let text = format!(
        "{launch},Carry [yds]\n150,12,1,2500,3,240\n{launch},Hang Time [s],Offline \
         [yds]\n150,12,1,2500,3,6.1,5\n"
    );
    let table = ShotTable::read(&Setup::modern_driver(), "a.csv", text.as_bytes()).unwrap();
    let remarks: Vec<String> = table.remarks.iter().map(ToString::to_string).collect();
    let remarks = remarks.join("\n");
    let count = |of: &str| {
        remarks
            .matches(&format!("has no column 'sigma {of}'"))
            .count()
    };
    let counts = ["carry_distance", "flight_time", "lateral"].map(count);
    assert_eq!((table.shots.len(), counts), (2, [1; 3]), "{remarks}");
    assert!(
        remarks.contains("from line 3 on: Offline has no column 'sigma lateral'"),
        "{remarks}"
    );
}

/// Speeds without a unit are in mph and angles in degrees. This also holds for values of the club.
#[test]
fn assumed_units_of_the_club_are_reported() {
    let text = "Ball Speed,Launch Angle,Spin Rate,Club Speed,Attack Angle\n150,12,2500,103,-1\n";
    let (shots, all, _) = fly_shots(text.as_bytes());
    let remarks: Vec<String> = shots.remarks().iter().map(ToString::to_string).collect();
    let remarks = remarks.join("\n");
    for says in [
        "Club Speed in mph",
        "Launch Angle, Attack Angle are read in degrees",
    ] {
        assert!(remarks.contains(says), "no '{says}' in {remarks}");
    }
    let speed = all[0].shots[0].club.speed.unwrap();
    close(speed, 103.0 * 0.44704, 46.0, 1e-12, "mph");
    // cells with units
    let (shots, all, _) = fly_shots(text.replace("103", "46 m/s").leak().as_bytes());
    assert_eq!(all[0].shots[0].club.speed, Some(46.0));
    let remarks: Vec<String> = shots.remarks().iter().map(ToString::to_string).collect();
    assert!(!remarks.join("\n").contains("Club Speed"), "{remarks:?}");
}

#[test]
fn an_unreadable_value_of_the_club_has_a_note() {
    let heads =
        "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Club Speed [mph],Club Path [deg]";
    let text = format!("{heads}\n150,12,2500,fast,2\n");
    let (_, all, _) = fly_shots(Cursor::new(text));
    let message = r#"{"BallData": {"Speed": 150, "VLA": 12, "TotalSpin": 2500, "SpinAxis": 0},
        "ClubData": {"Speed": "fast", "Path": 2}}"#;
    let no_object = message.replace(r#"{"Speed": "fast", "Path": 2}"#, "[103]");
    let (_, messages, _) = fly_shots(Cursor::new(format!("{message}\n{no_object}")));
    let [row, message, no_object] = [
        &all[0].shots[0],
        &messages[0].shots[0],
        &messages[0].shots[1],
    ];
    for (shot, says) in [
        (row, "Club Speed: 'fast' is not a number"),
        (
            message,
            "ClubData.Speed: \"fast\" is not a number; it counts as not measured",
        ),
        (
            no_object,
            "ClubData is not an object; the club counts as not measured",
        ),
    ] {
        assert!(shot.club.speed.is_none() && shot.launch().is_some());
        assert!(shot.notes.join("\n").contains(says), "{:?}", shot.notes);
    }
    assert_eq!(row.club.path, message.club.path);
    assert!(row.club.path.is_some());
}

#[test]
fn every_lateral_value_that_is_not_compared_is_named() {
    let head = "ball_speed [mph],launch_angle [deg],spin [rpm],lateral [yd],lateral_total [yd]";
    let read = |head: &str, row: &str| {
        let text = format!("{head}\n{row}\n");
        ShotTable::read(&Setup::modern_driver(), "a.csv", text.as_bytes())
    };
    let error = read(head, "150,12,2500,5,6").unwrap_err().to_string();
    assert!(
        error.contains("the only measured values are lateral, lateral_total"),
        "{error}"
    );
    let table = read(&format!("{head},carry [yd]"), "150,12,2500,5,6,240").unwrap();
    let remarks: Vec<String> = table.remarks.iter().map(ToString::to_string).collect();
    for of in ["lateral", "lateral_total"] {
        let remark = format!("{of} is not compared in rows without a measured launch direction");
        assert!(
            remarks.iter().any(|said| said.starts_with(&remark)),
            "{remarks:?}"
        );
    }
}

#[test]
fn numbers_from_1e38_are_missing_values() {
    let head = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Spin Axis [deg],Carry [yds]\n";
    for cell in [
        "3.4e38",
        "3.4028235e+38",
        "-3.4E38",
        "1e38",
        "340282346638528859811704183484516925440",
    ] {
        let flown = rows(&format!(
            "{head}160,12,2500,3,{cell}\n160,12,{cell},3,262\n"
        ));
        assert_eq!(
            (flown.shots[0].notes.len(), flown.residual(0, 0)),
            (1, None),
            "{cell}: {:?}",
            flown.shots[0].notes
        );
        assert_eq!(
            flown.shots[1].refusal().map(|refusal| refusal.kind),
            Some("missing value"),
            "{cell}"
        );
    }
}

#[test]
fn the_condition_of_a_shot_is_written_and_known_heads_get_no_suggestion() {
    let head = "Club Name,Club Type,Face to Path,Lie Angle,Ball Speed [mph],Launch Angle \
                [deg],Spin Rate [rpm],Condition\n";
    let text = format!(
        "{head}Driver,d,1,2,160,12,2500,\"Normalized, no wind\"\nDriver,d,1,2,160,12,2500,Actual\n"
    );
    let (shots, all, tally) = fly_shots(Cursor::new(text));
    let remarks = shots
        .remarks()
        .iter()
        .map(ToString::to_string)
        .collect::<String>();
    assert!(
        remarks.contains("Club Name") && !remarks.contains("did you mean"),
        "{remarks}"
    );
    let writer = ShotWriter::launch_monitor(&shots, &[Outcome::CarryDistance], System::Us);
    let written = String::from_utf8([writer.head(), writer.rows(&all[0])].concat()).unwrap();
    for says in [
        "Spin Rate Type,Condition,Club,Line",
        "\"Normalized, no wind\"",
        ",Actual,",
    ] {
        assert!(written.contains(says), "no '{says}' in {written}");
    }
    let again = fly_shots(Cursor::new(written));
    assert_eq!((tally.normalized, again.2.normalized), (1, 1));
    assert_eq!(again.1[0].shots[1].condition.as_deref(), Some("Actual"));
}
