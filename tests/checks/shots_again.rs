//! Tables that `fly` wrote, read again by `fly`, `calibrate`, `delivery` and `sweep`. Also measured
//! totals, which are compared only on a named ground.

use crate::command_line::{file_with, json, longdrive, number, on_one_line};
use crate::shots::fly_shots;
use longdrive::Setup;
use longdrive::report::ShotWriter;
use longdrive::study::calibrate::ShotTable;
use longdrive::table::RowFilter;
use longdrive::units::Message;
use serde_json::Value;
use std::fs;
use std::io::Cursor;
use std::path::{Path, PathBuf};

fn shots(name: &str) -> String {
    format!("{}/data/shots/{name}", env!("CARGO_MANIFEST_DIR"))
}

fn lines(path: &str) -> Vec<Value> {
    fs::read_to_string(path)
        .unwrap()
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect()
}

#[test]
fn same_json_lines_after_reading_and_writing() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    for name in [
        "trackman.csv",
        "garmin.csv",
        "flightscope.csv",
        "uneekor.csv",
        "open-connect.jsonl",
    ] {
        let (first, second) = (
            place(&format!("{name}.1.jsonl")),
            place(&format!("{name}.2.jsonl")),
        );
        for (from, to) in [(&shots(name), &first), (&first, &second)] {
            let output = longdrive(&["fly", from, "-o", to]);
            assert_eq!(output.status, 0, "{name}: {}", output.err);
        }
        let (first, second) = (lines(&first), lines(&second));
        assert!(!first.is_empty() && first.len() == second.len(), "{name}");
        for (at, (mut one, mut other)) in first.into_iter().zip(second).enumerate() {
            // `line` is the line of the input file, which differs between the two
            assert_eq!(other["line"], at + 1);
            (one["line"], other["line"]) = (Value::Null, Value::Null);
            assert_eq!(one, other, "{name}");
        }
    }
}

#[test]
fn same_fit_of_a_table_and_of_the_lines_that_fly_made_of_it() {
    let folder = tempfile::tempdir().unwrap();
    let table = file_with(
        folder.path(),
        "shots.csv",
        "Ball Speed [mph],Launch Angle [deg],Back Spin [rpm],Side Spin [rpm],Launch Direction [deg],\
         Carry [yd],apex_downrange [yd],apex_time [s],Total [yd]\n\
         165,11,2500,0,0,275,170,3.2,300\n\
         166,11.5,2400,0,0,277,172,3.3,302\n",
    );
    let made = folder.path().join("shots.jsonl").display().to_string();
    assert_eq!(longdrive(&["fly", &table, "-o", &made]).status, 0);
    let fit = |data: &str| json(&["calibrate", data, "--fit", "aero.cd0"]).1;
    let [of_table, of_lines] = [&table, &made].map(|data| fit(data));
    let outcomes = |answer: &Value| -> Vec<String> {
        let residuals = answer["residuals"].as_array().unwrap();
        let names = residuals.iter().map(|row| row["of"].to_string());
        let mut names: Vec<String> = names.collect();
        names.sort();
        names
    };
    assert_eq!(outcomes(&of_table).len(), 6, "{of_table}");
    assert_eq!(outcomes(&of_table), outcomes(&of_lines));
    let value = |answer: &Value| number(&answer["estimates"]["aero.cd0"]["value"]);
    assert!((value(&of_table) - value(&of_lines)).abs() < 1e-9);
    let remarks = of_lines["data"]["remarks"].to_string();
    assert!(
        remarks.contains("the ground of the launch monitor is not known: total"),
        "{of_lines}"
    );
}

/// The file of JSON lines that `fly` makes of a table.
fn lines_of(folder: &Path, table: &str) -> PathBuf {
    let (shots, flown, _) = fly_shots(Cursor::new(table.to_owned()));
    let writer = ShotWriter::json_lines(&shots, &flown[0].of);
    let lines = folder.join("shots.jsonl");
    fs::write(&lines, writer.rows(&flown[0])).unwrap();
    lines
}

fn texts(messages: &[Message]) -> Vec<String> {
    messages.iter().map(ToString::to_string).collect()
}

#[test]
fn clubs_of_json_lines_are_told_apart() {
    let folder = tempfile::tempdir().unwrap();
    let table = "Club,Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Carry [yd]\n\
                 Driver,160,11,2600,262\nDriver,161,11,2600,263\n7 Iron,120,17,6500,170\n";
    let lines = lines_of(folder.path(), table);
    let setup = Setup::modern_driver();
    let measured = ShotTable::open(&setup, &lines, RowFilter::default(), false).unwrap();
    let warnings = texts(&measured.warnings);
    let says = "has shots of several clubs, which are fitted together: Driver (2), 7 Iron (1)";
    assert!(
        warnings.iter().any(|warning| warning.contains(says)),
        "{warnings:?}"
    );
    let (.., statistics) = fly_shots(fs::File::open(&lines).unwrap());
    let clubs = statistics.clubs.iter();
    let clubs: Vec<_> = clubs
        .map(|(name, shots)| (name.as_str(), shots.rows))
        .collect();
    assert_eq!(clubs, [("7 Iron", 1), ("Driver", 2)]);
}

/// A club speed of 300 mph and a carry of 900 yd are not used. The first messages are those of the
/// table.
#[test]
fn values_of_json_lines_that_are_not_used_have_remarks() {
    let folder = tempfile::tempdir().unwrap();
    let table = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Club Speed [mph],\
                 Attack Angle [deg],Carry [yd],Apex Height [ft]\n160,11,2600,300,1,900,100\n";
    let lines = lines_of(folder.path(), table);
    let setup = Setup::modern_driver();
    let filter = RowFilter::default;
    let launches = ShotTable::open_launches(&setup, &lines, filter()).unwrap();
    let remarks = texts(&launches.remarks);
    let of_club = |remark: &String| {
        remark.starts_with("Club Speed: 300 mph is outside of the range of clubs")
            && remark.ends_with("; the prior is used in its place: row 1")
    };
    assert!(remarks.iter().any(of_club), "{remarks:?}");
    let measured = ShotTable::open(&setup, &lines, filter(), false).unwrap();
    let remarks = texts(&measured.remarks);
    let of_carry = |remark: &String| remark.starts_with("row 1: not compared: Carry: ");
    assert!(remarks.iter().any(of_carry), "{remarks:?}");
}

#[test]
fn same_remark_on_the_club_in_calibrate_of_a_table_and_of_messages() {
    let remark = |file: &str| {
        let (_, answer) = json(&["calibrate", &shots(file), "--fit", "aero.cd0"]);
        let remarks = answer["data"]["remarks"].as_array().unwrap().iter();
        let says = "the ball flies from its measured launch; columns of the club are left out: ";
        let mut of_club = remarks.filter_map(|remark| remark.as_str()?.strip_prefix(says));
        of_club.next().map(str::to_owned)
    };
    let of_table = remark("garmin.csv").unwrap();
    assert!(
        of_table.starts_with("Club Speed, Attack Angle"),
        "{of_table}"
    );
    let of_messages = remark("open-connect.json").unwrap();
    assert!(
        of_messages.starts_with("swing.speed, swing.attack_angle"),
        "{of_messages}"
    );
}

#[test]
fn same_flights_of_json_lines_with_their_own_parameters() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let text = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],air.density \
                [kg/m^3]\n150,12,2700,1.1\n";
    let table = file_with(folder.path(), "shots.csv", text);
    assert_eq!(
        longdrive(&["fly", &table, "-o", &place("shots.jsonl")]).status,
        0
    );
    assert_eq!(
        lines(&place("shots.jsonl"))[0]["parameters"]["air.density"],
        1.1
    );
    let output = longdrive(&["fly", &place("shots.jsonl"), "-o", &place("again.jsonl")]);
    assert_eq!(output.status, 0, "{}", output.err);
    assert_eq!(
        lines(&place("shots.jsonl"))[0]["predicted"],
        lines(&place("again.jsonl"))[0]["predicted"]
    );
    // in a table every row must state the same parameters
    let first = fs::read_to_string(place("shots.jsonl")).unwrap();
    let other = first.replace("air.density", "ball.mass");
    let output = longdrive(&[
        "fly",
        &file_with(folder.path(), "mixed.jsonl", &format!("{first}{other}")),
        "--json",
    ]);
    assert!(
        output
            .out
            .contains("the line has a value of ball.mass, but the first line has none"),
        "{}",
        output.out
    );
}

#[test]
fn same_flights_of_json_lines_whose_first_flown_line_is_far_from_the_beginning() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let heads = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],air.density [kg/m^3]\n";
    let refused = "500,12,2700,1.1\n".repeat(400);
    let text = format!("{heads}{refused}150,12,2700,1.1\n150,12,2700,1.2\n");
    let table = file_with(folder.path(), "shots.csv", &text);
    for (from, to) in [(&table, "1.jsonl"), (&place("1.jsonl"), "2.jsonl")] {
        let output = longdrive(&["fly", from, "-o", &place(to)]);
        assert_eq!(output.status, 0, "{}", output.err);
    }
    assert!(fs::read(place("1.jsonl")).unwrap().len() > 1 << 17);
    let [first, second] = ["1.jsonl", "2.jsonl"].map(|name| lines(&place(name)));
    let predicted = |lines: &[Value]| -> Vec<Value> {
        lines.iter().map(|line| line["predicted"].clone()).collect()
    };
    assert!(first[400]["predicted"]["carry_distance"].is_number());
    assert_eq!(predicted(&first), predicted(&second));
}

#[test]
fn shots_without_the_parameters_of_the_first_flown_line_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let text = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],air.density \
                [kg/m^3]\n150,12,2700,1.1\n";
    let table = file_with(folder.path(), "shots.csv", text);
    assert_eq!(
        longdrive(&["fly", &table, "-o", &place("1.jsonl")]).status,
        0
    );
    let line = fs::read_to_string(place("1.jsonl")).unwrap();
    let without = line.replace("\"air.density\":1.1", "");
    let message = "{\"BallData\": {\"Speed\": 150, \"VLA\": 12, \"TotalSpin\": 2700}}\n";
    let mixed = file_with(
        folder.path(),
        "mixed.jsonl",
        &format!("{line}{without}{message}{line}"),
    );
    assert_eq!(
        longdrive(&["fly", &mixed, "-o", &place("2.jsonl")]).status,
        0
    );
    let found = lines(&place("2.jsonl"));
    let reasons = [&found[1], &found[2]].map(|line| line["reason"].as_str().unwrap());
    assert!(
        reasons[0].contains("parameters.air.density is missing")
            && reasons[1].contains("the message has no value of air.density"),
        "{reasons:?}"
    );
    assert_eq!(found[0]["predicted"], found[3]["predicted"]);
}

#[test]
fn a_changed_value_of_the_club_is_refused_as_one_of_the_ball_is() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path().join("1.jsonl").display().to_string();
    let text = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Club Speed \
                [mph]\n150,12,2700,103\n";
    let table = file_with(folder.path(), "shots.csv", text);
    assert_eq!(longdrive(&["fly", &table, "-o", &place]).status, 0);
    let mut line = lines(&place).remove(0);
    line["club"]["swing.speed"] = "fast".into();
    let changed = file_with(folder.path(), "changed.jsonl", &line.to_string());
    let (_, answer) = json(&["fly", &changed]);
    let reason = answer["refused"][0]["first_reason"].as_str().unwrap();
    assert!(
        reason.contains("club.swing.speed: \"fast\" is not a value that 'fly' writes here"),
        "{reason}"
    );
}

#[test]
fn same_measured_totals_in_the_columns_of_a_launch_monitor() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let table = file_with(
        folder.path(),
        "shots.csv",
        "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Total [yd],Total Side \
         [yd]\n150,12,2700,270,12\n",
    );
    let columns = place("1.csv");
    let output = longdrive(&["fly", &table, "--format", "launch-monitor", "-o", &columns]);
    assert_eq!(output.status, 0, "{}", output.err);
    for (from, to) in [(&table, "1.jsonl"), (&columns, "2.jsonl")] {
        assert_eq!(longdrive(&["fly", from, "-o", &place(to)]).status, 0);
    }
    let [first, second] = ["1.jsonl", "2.jsonl"].map(|name| lines(&place(name)).remove(0));
    for of in ["total", "lateral_total"] {
        let [stated, again] = [&first, &second].map(|line| number(&line["stated"][of]));
        assert!((stated - again).abs() < 1e-4, "{of}: {stated} {again}");
    }
}

/// A turf names the ground, by an option or in a setup file.
#[test]
fn totals_are_compared_only_on_a_named_ground() {
    let folder = tempfile::tempdir().unwrap();
    let firm = folder.path().join("firm.toml");
    std::fs::write(&firm, "ground.turf = \"firm\"\n").unwrap();
    let (_, answer) = json(&[
        "fly",
        &shots("trackman.csv"),
        firm.to_str().unwrap(),
        "--of",
        "total",
    ]);
    assert!(
        !answer["remarks"]
            .to_string()
            .contains("not compared: the ground")
    );
    let file = shots("trackman.csv");
    let (_, answer) = json(&["fly", &file, "--of", "total"]);
    let remarks = answer["remarks"].to_string();
    assert!(
        remarks.contains("the measured totals are not compared") && !remarks.contains("Est. Total"),
        "{remarks}"
    );
    let (_, answer) = json(&[
        "fly",
        &file,
        "--of",
        "total",
        "--set",
        "ground.turf=average",
    ]);
    assert!(
        !answer["remarks"].to_string().contains("totals"),
        "{answer}"
    );
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path().join("flown.jsonl").display().to_string();
    assert_eq!(
        longdrive(&[
            "fly",
            &file,
            "--of",
            "total",
            "--set",
            "ground.turf=average",
            "-o",
            &place
        ])
        .status,
        0
    );
    let first = &lines(&place)[0];
    // the total in the export, 283.0 yd, is an estimate according to its head
    let stated = number(&first["stated"]["total"]);
    assert!(
        (stated / 0.9144 - 283.0).abs() < 1e-9 && first["origins"]["total"] == "estimated",
        "{first}"
    );
    assert!(
        (number(&first["predicted"]["total"]) - stated - number(&first["residual"]["total"])).abs()
            < 1e-9
    );
}

#[test]
fn assumed_values_of_a_launch_are_not_measured_when_read_again() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let text = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Carry [yd],Side \
                [yd]\n150,12,2500,250,12 R\n";
    let table = file_with(folder.path(), "shots.csv", text);
    for (format, name) in [
        ("csv", "a.csv"),
        ("launch-monitor", "b.csv"),
        ("jsonl", "c.jsonl"),
        ("open-connect", "d.json"),
    ] {
        assert_eq!(
            longdrive(&["fly", &table, "--format", format, "-o", &place(name)]).status,
            0
        );
        assert_eq!(
            longdrive(&["fly", &place(name), "-o", &place(&format!("{name}.jsonl"))]).status,
            0
        );
        let again = &lines(&place(&format!("{name}.jsonl")))[0];
        assert!(again["residual"]["lateral"].is_null(), "{name}: {again}");
        assert!(
            again["stated"]["launch_direction"].is_null() && again["stated"]["spin_axis"].is_null(),
            "{again}"
        );
        let notes = [
            "launch direction is missing: 0 deg is assumed",
            "spin axis is missing: 0 deg is assumed",
        ];
        assert_eq!(again["notes"], serde_json::json!(notes), "{name}");
        // the message for a simulator has rounded numbers
        let predicted = |line: &Value| number(&line["predicted"]["carry_distance"]);
        assert!(
            (predicted(again) / predicted(&lines(&place("a.csv.jsonl"))[0]) - 1.0).abs() < 1e-9,
            "{name}"
        );
    }
    // the message for a simulator has the assumed direction and spin axis, too
    let message = &lines(&place("d.json"))[0];
    assert!(
        message["BallData"]["HLA"] == 0.0 && message["BallData"]["SpinAxis"] == 0.0,
        "{message}"
    );
}

#[test]
fn same_rows_of_a_table_flown_again() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let text = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Player\n150,12,2700,\"A, \
                B\"\n150,abc,2700,A\n150,12\n,12,2700,A\n";
    let table = file_with(folder.path(), "shots.csv", text);
    for format in ["csv", "launch-monitor"] {
        let (first, second) = (
            place(&format!("1.{format}.csv")),
            place(&format!("2.{format}.csv")),
        );
        assert_eq!(
            longdrive(&["fly", &table, "--format", format, "-o", &first]).status,
            0
        );
        let output = longdrive(&["fly", &first, "-o", &second]);
        assert_eq!(output.status, 0, "{}", output.err);
        assert!(
            on_one_line(&output.err).contains("an earlier 'fly' added"),
            "{}",
            output.err
        );
        assert_eq!(
            fs::read_to_string(&first).unwrap(),
            fs::read_to_string(&second).unwrap()
        );
    }
    // a corrected row is flown
    let mended = fs::read_to_string(place("1.csv.csv"))
        .unwrap()
        .replace("150,abc", "150,11");
    let (_, answer) = json(&["fly", &file_with(folder.path(), "mended.csv", &mended)]);
    assert_eq!(answer["flown"], 2, "{answer}");
    // the program has columns named Notes and Line, too; it keeps the user's columns with these
    // names
    let own =
        "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Notes,Line\n150,12,2700,windy,3\n";
    assert_eq!(
        longdrive(&[
            "fly",
            &file_with(folder.path(), "own.csv", own),
            "-o",
            &place("own2.csv")
        ])
        .status,
        0
    );
    assert!(
        fs::read_to_string(place("own2.csv"))
            .unwrap()
            .contains("\n150,12,2700,windy,3,2,landed,")
    );
}

#[test]
fn an_estimated_spin_stays_estimated_in_open_connect() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let text = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Spin Rate \
                Type\n150,12,2700,Estimated\n151,12,2700,Measured\n";
    let table = file_with(folder.path(), "shots.csv", text);
    assert_eq!(
        longdrive(&["fly", &table, "-o", &place("shots.json")]).status,
        0
    );
    assert_eq!(
        longdrive(&["fly", &place("shots.json"), "-o", &place("again.jsonl")]).status,
        0
    );
    let origins: Vec<Value> = lines(&place("again.jsonl"))
        .iter()
        .map(|line| line["origins"]["spin"].clone())
        .collect();
    assert_eq!(origins, ["estimated", "measured"]);
}

#[test]
fn messages_and_title_lines_are_read_by_calibrate_and_delivery_too() {
    let folder = tempfile::tempdir().unwrap();
    let head = "Ball Speed [mph],Launch Angle [deg],Launch Direction [deg],Spin Rate [rpm],Spin \
                Axis [deg],Carry [yd],Club Speed [mph]";
    let rows = "150,12,0,2700,0,240,102\n155,11,0,2600,0,250,105\n160,11,0,2500,0,262,108\n";
    let plain = file_with(folder.path(), "plain.csv", &format!("{head}\n{rows}"));
    let titled = file_with(
        folder.path(),
        "titled.csv",
        &format!("Session of May\nA. Player\n\n{head}\n{rows}"),
    );
    let messages = folder.path().join("messages.json").display().to_string();
    assert_eq!(longdrive(&["fly", &plain, "-o", &messages]).status, 0);
    let fit = |file: &str| {
        let (status, found) = json(&["calibrate", file, "modern-driver", "--fit", "aero.cd0"]);
        assert_eq!(status, 0, "{file}: {found}");
        number(&found["estimates"]["aero.cd0"]["value"])
    };
    let known = fit(&plain);
    for file in [&titled, &messages] {
        assert!((fit(file) / known - 1.0).abs() < 1e-6, "{file}");
    }
    for file in [&plain, &titled, &messages] {
        let (status, found) = json(&["delivery", "--shots", file]);
        assert!(
            status == 0 && found["rows"].as_array().unwrap().len() == 3,
            "{file}: {found}"
        );
    }
}

#[test]
fn a_bad_cell_of_an_export_affects_its_row_alone() {
    let folder = tempfile::tempdir().unwrap();
    let head = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Carry [yd]";
    let rows = "150,12,2700,240\n155,abc,2600,250\n160,11,2500,262\n161,11,2500\n165,11,2500,270\n";
    let table = file_with(folder.path(), "bad.csv", &format!("{head}\n{rows}"));
    let (status, found) = json(&["calibrate", &table, "modern-driver", "--fit", "aero.cd0"]);
    assert_eq!(status, 0, "{found}");
    let remarks = found["data"]["remarks"].to_string();
    for sentence in ["row 2 (Launch Angle: 'abc' is not a number", "row 4 ("] {
        assert!(remarks.contains(sentence), "{remarks}");
    }
}

#[test]
fn impossible_rows_of_points_are_reported_with_their_value() {
    let folder = tempfile::tempdir().unwrap();
    let text = "club.loft [deg],swing.speed [mph]\n9,100\n,101\n95,100\n9,-3\n";
    let table = file_with(folder.path(), "points.csv", text);
    let output = longdrive(&["sweep", "--points", &table]);
    assert_eq!(output.status, 0, "{}", output.err);
    let sentence = on_one_line(&output.err);
    for wrong in [
        "row 2: club.loft is missing",
        "row 3: club.loft = 95 deg is outside",
        "row 4: swing.speed = -3 mph is outside",
    ] {
        assert!(sentence.contains(wrong), "{sentence}");
    }
    let rows: Vec<&str> = output.out.lines().collect();
    assert!(
        rows.len() == 5 && rows[2].starts_with(',') && rows[2].contains(",out-of-range,"),
        "{rows:?}"
    );
}

#[test]
fn flat_landings_are_counted_if_the_run_is_requested() {
    let flat = "at less than 25 deg";
    let remarks = |args: &[&str]| {
        let (_, found) = json(args);
        found["warnings"].to_string()
    };
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let over = ["sweep", "--over", "club.loft=1deg..12deg:12"];
    let total = remarks(
        &[
            &over[..],
            &["--outcomes", "total", "-o", &place("total.csv")],
        ]
        .concat(),
    );
    assert!(
        total.contains(flat) && total.contains(" of 12 drives that landed: "),
        "{total}"
    );
    let carry = remarks(
        &[
            &over[..],
            &["--outcomes", "carry", "-o", &place("carry.csv")],
        ]
        .concat(),
    );
    assert!(!carry.contains(flat), "{carry}");
    let text = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm]\n160,4,1500\n160,12,2700\n";
    let table = file_with(folder.path(), "shots.csv", text);
    let flown = remarks(&["fly", &table, "--of", "total"]);
    assert!(
        flown.contains("1 of 2 shots that landed: the ball lands at less than 25 deg"),
        "{flown}"
    );
    let along = [
        "chart",
        "--maximize",
        "total",
        "--along",
        "swing.attack_angle",
        "--at=-5deg,5deg",
    ];
    let chart = remarks(&[&along[..], &["--vary", "club.loft=4deg..5deg"]].concat());
    assert!(
        chart.contains("1 of 2 optima: the ball lands at less than 25 deg"),
        "{chart}"
    );
}

#[test]
fn parameters_without_a_value_are_varied_as_they_are_swept() {
    let (status, swept) = json(&[
        "optimize",
        "modern-driver",
        "--vary",
        "swing.shaft_bend=0deg..3deg",
    ]);
    assert_eq!(status, 0, "{swept}");
    let (_, set) = json(&[
        "optimize",
        "modern-driver",
        "--set",
        "swing.shaft_bend=1.5deg",
        "--vary",
        "swing.shaft_bend=0deg..3deg",
    ]);
    assert_eq!(swept["value"], set["value"]);
    let output = longdrive(&[
        "chart",
        "modern-driver",
        "--along",
        "swing.shaft_bend",
        "--at",
        "0deg,1deg",
    ]);
    assert!(
        output.status == 0
            && output
                .err
                .contains("swing.shaft_bend has no value in modern-driver"),
        "{}",
        output.err
    );
}

#[test]
fn weather_without_a_value_is_uncertain_about_the_mean_of_its_distribution() {
    let given = ["--distribution", "air.humidity=uniform(0.2,0.8)"];
    for command in ["uncertainty", "optimize"] {
        let output = longdrive(&[command, given[0], given[1]]);
        assert_eq!(output.status, 0, "{command}: {}", output.err);
        assert!(
            output
                .err
                .contains("air.humidity has no value in tour-average; it varies about 0.5"),
            "{}",
            output.err
        );
    }
    let (_, alone) = json(&["uncertainty", given[0], given[1]]);
    let folder = tempfile::tempdir().unwrap();
    let humid = folder.path().join("humid.toml");
    std::fs::write(&humid, "[air]\nhumidity = 0.5\n").unwrap();
    let (_, set) = json(&["uncertainty", humid.to_str().unwrap(), given[0], given[1]]);
    assert_eq!(alone["outcomes"], set["outcomes"]);
}

#[test]
fn text_shows_the_run_beside_a_total_and_the_air_that_the_weather_gives() {
    let output = longdrive(&["optimize", "--maximize", "total"]);
    let rows: Vec<&str> = output.out.lines().map(str::trim).collect();
    assert!(
        rows.iter().any(|row| row.starts_with("run "))
            && rows.iter().any(|row| row.starts_with("carry ")),
        "{rows:?}"
    );
    let output = longdrive(&[
        "simulate",
        "--set",
        "air.temperature=10degC",
        "--set",
        "air.pressure=1013.25hPa",
        "--set",
        "air.humidity=0",
    ]);
    // CIPM-2007 for dry air at 10 °C and 101 325 Pa
    assert!(output.out.contains("air: density 1.247"), "{}", output.out);
    assert!(!longdrive(&["simulate"]).out.contains("weather"));
}

/// The file has more rows than a row group. Its numbers equal those of the JSON lines.
#[cfg(feature = "full")]
#[test]
fn same_shots_in_parquet_and_in_json_lines() {
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let head = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Spin Rate Type,Carry [yd],Club \
                Speed [mph]\n";
    let row = |i: u32| match i % 1000 {
        7 => "150,12,,Measured,240,102\n".to_owned(),
        i => format!(
            "{},12,{},Estimated,240,102\n",
            140.0 + 0.01 * f64::from(i),
            2500 + i
        ),
    };
    let table = file_with(
        folder.path(),
        "shots.csv",
        &(head.to_owned() + &(0..33_000).map(row).collect::<String>()),
    );
    for name in ["a.jsonl", "a.parquet"] {
        let output = longdrive(&["fly", &table, "--of", "carry_distance", "-o", &place(name)]);
        assert_eq!(output.status, 0, "{}", output.err);
    }
    let file = SerializedFileReader::new(fs::File::open(place("a.parquet")).unwrap()).unwrap();
    assert_eq!(
        (
            file.num_row_groups(),
            file.metadata().file_metadata().num_rows()
        ),
        (2, 33_000)
    );
    let json = lines(&place("a.jsonl"));
    for (row, line) in file.get_row_iter(None).unwrap().zip(&json) {
        let row = row.unwrap();
        let cell = |name: &str| match row
            .get_column_iter()
            .find(|(column, _)| *column == name)
            .unwrap()
            .1
        {
            Field::Double(value) => Value::from(*value),
            Field::Str(text) => Value::from(text.as_str()),
            _ => Value::Null,
        };
        assert_eq!(
            (number(&cell("line")), cell("flight")),
            (number(&line["line"]), line["flight"].clone())
        );
        assert_eq!(
            (cell("reason"), cell("spin_origin").is_null()),
            (line["reason"].clone(), line["stated"].get("spin").is_none())
        );
        assert_eq!(
            cell("predicted_carry_distance"),
            line["predicted"]["carry_distance"]
        );
        assert_eq!(
            cell("residual_carry_distance"),
            line["residual"]["carry_distance"]
        );
        assert_eq!(
            (cell("measured_carry_distance"), cell("swing.speed")),
            (
                line["stated"]["carry_distance"].clone(),
                line["club"]["swing.speed"].clone()
            )
        );
    }
    for stream in ["-", "/dev/null"] {
        let output = longdrive(&["fly", &table, "-o", stream, "--format", "parquet"]);
        assert!(
            output.status == 2 && output.err.contains("Parquet needs a file"),
            "{stream}: {}",
            output.err
        );
    }
}

#[cfg(feature = "full")]
#[test]
fn a_parameter_without_a_column_in_parquet_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let heads = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm]";
    let text = format!("{heads}\n150,12,2700\n{heads},ball.mass [g]\n150,12,2700,45.5\n");
    let table = file_with(folder.path(), "shots.csv", &text);
    for (name, is_named) in [("a.parquet", true), ("a.jsonl", false)] {
        let (_, answer) = json(&["fly", &table, "-o", &place(name)]);
        assert_eq!(answer["flown"], 2, "{answer}");
        let says = "which have no column in the Parquet file (JSON lines have them): ball.mass";
        let remarks = answer["remarks"].to_string();
        assert_eq!(remarks.contains(says), is_named, "{remarks}");
    }
}

#[test]
fn rows_of_clubs_without_statistics_of_their_own_are_counted() {
    let folder = tempfile::tempdir().unwrap();
    let row = |club: u32| format!("150,12,2700,club {}\n", club % 42);
    let rows: String = (0..84).map(row).collect();
    let text = format!("Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Club Type\n{rows}");
    let (_, answer) = json(&["fly", &file_with(folder.path(), "shots.csv", &text)]);
    assert_eq!(answer["clubs"].as_array().unwrap().len(), 40);
    let remarks = answer["remarks"].to_string();
    assert!(
        remarks.contains("the statistics by club lack 4 rows: they have at most 40 clubs"),
        "{remarks}"
    );
}

/// More than 40 clubs in a block of 1024 rows: the statistics of a club have all its rows.
#[test]
fn exact_number_of_rows_of_each_club_in_a_table_of_many_clubs() {
    let folder = tempfile::tempdir().unwrap();
    let row = |club: u32| format!("150,12,2700,club {club:02}\n");
    let first = (0..1040).map(|k| row(40 + k % 40));
    let both = (0..1200).map(|k| row(k % 80));
    let rows: String = first.chain(both).collect();
    let text = format!("Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Club Type\n{rows}");
    let (_, answer) = json(&["fly", &file_with(folder.path(), "shots.csv", &text)]);
    let clubs = answer["clubs"].as_array().unwrap();
    assert_eq!(clubs.len(), 40);
    for club in clubs {
        assert_eq!(club["rows"], 1040 / 40 + 1200 / 80, "{club}");
    }
    let says = "the statistics by club lack 600 rows";
    assert!(answer["remarks"].to_string().contains(says), "{answer}");
}

#[test]
fn json_lines_of_fly_have_all_measured_values() {
    let sample = concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/shots.csv");
    let folder = tempfile::tempdir().unwrap();
    let lines = folder.path().join("flown.jsonl").display().to_string();
    assert_eq!(longdrive(&["fly", sample, "-o", &lines]).status, 0);
    let open = |file: &str| {
        ShotTable::open(
            &Setup::modern_driver(),
            Path::new(file),
            RowFilter::default(),
            false,
        )
        .unwrap()
    };
    let (table, again) = (open(sample), open(&lines));
    assert_eq!((table.residuals(), again.residuals()), (48, 48));
    for (shot, other) in table.shots.iter().zip(&again.shots) {
        for one in &shot.measured {
            let mut of_lines = other.measured.iter();
            let two = of_lines.find(|two| two.outcome == one.outcome).unwrap();
            assert_eq!(one.sigma, two.sigma);
            assert!((one.value - two.value).abs() < 1e-9, "{one:?} {two:?}");
        }
    }
    let (status, found) = json(&["fly", &lines]);
    assert_eq!(
        (status, found["source"].as_str()),
        (0, Some("JSON lines of longdrive fly"))
    );
}

/// The wind of each row and its club, from a table through JSON lines into the columns of a launch
/// monitor, which are read again.
#[test]
fn same_flight_in_the_wind_of_each_row_in_every_format() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let text = "Club,Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],wind.speed \
                [mph],wind.from [deg],air.temperature [degC]\nDriver,150,12,2500,20,0,25\n3 \
                Wood,140,13,3000,5,90,-3\n,abc,13,3000,0,0,5\n";
    let table = file_with(folder.path(), "shots.csv", text);
    let fly = |from: &str, format: &str, to: &str| {
        let output = longdrive(&["fly", from, "--format", format, "-o", &place(to)]);
        assert_eq!(output.status, 0, "{}", output.err);
        on_one_line(&output.err)
    };
    let says = "parameters of the rows that a message of Open Connect cannot state";
    let of_messages = fly(&table, "open-connect", "messages.json");
    assert!(of_messages.contains(says) && of_messages.contains("wind.speed, wind.from"));
    fly(&table, "jsonl", "first.jsonl");
    fly(&place("first.jsonl"), "launch-monitor", "second.csv");
    fly(&table, "launch-monitor", "third.csv");
    let first = lines(&place("first.jsonl"));
    for name in ["second.csv", "third.csv"] {
        let again = format!("{name}.jsonl");
        let said = fly(&place(name), "jsonl", &again);
        assert!(!said.contains(says), "{said}");
        let again = lines(&place(&again));
        assert_eq!(again.len(), 3, "{name}");
        for (first, again) in first.iter().zip(&again).take(2) {
            let carry = |line: &Value| number(&line["predicted"]["carry_distance"]);
            let (first, again) = (carry(first), carry(again));
            assert!((first - again).abs() < 1e-3, "{name}: {first} {again}");
        }
        assert_eq!(again[2]["flight"], "refused", "{name}");
    }
    let third = std::fs::read_to_string(place("third.csv")).unwrap();
    assert!(
        third.contains("Driver") && third.contains("3 Wood"),
        "{third}"
    );
}
