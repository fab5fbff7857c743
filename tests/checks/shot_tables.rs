//! Tables of shots in the formats of real exports: each shot equals the same shot in a plain table.

use crate::command_line::{file_with, longdrive, on_one_line};
use crate::common::close;
use crate::shots::fly_shots;
use longdrive::report::ShotWriter;
use longdrive::shots::{Flown, ShotStatistics, Shots};
use longdrive::study::calibrate::ShotTable;
use longdrive::table::{RowFilter, open_table};
use longdrive::units::System;
use longdrive::{Outcome, Setup};
use std::io::Cursor;

fn bytes(name: &str) -> Vec<u8> {
    std::fs::read(format!("{}/data/cases/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn case(name: &str) -> (Shots, Vec<Flown>, ShotStatistics) {
    fly_shots(Cursor::new(bytes(name)))
}

/// The predicted carries and lateral distances of the rows that land, m.
fn landed(flown: &[Flown]) -> Vec<[f64; 2]> {
    let of = |flown: &Flown| {
        let row = |row| Some([flown.predicted(row, 0)?, flown.predicted(row, 1)?]);
        (0..flown.shots.len()).filter_map(row).collect::<Vec<_>>()
    };
    flown.iter().flat_map(of).collect()
}

/// Results of launches in a plain table: ball speed in mph, launch angle, direction and axis in
/// degrees, spin in rpm.
fn plain(launches: &[[f64; 5]]) -> Vec<[f64; 2]> {
    let mut text = String::from(
        "Ball Speed [mph],Launch Angle [deg],Launch Direction [deg],Spin Rate [rpm],Spin Axis \
         [deg]\n",
    );
    for launch in launches {
        let cells: Vec<String> = launch.iter().map(f64::to_string).collect();
        text += &(cells.join(",") + "\n");
    }
    landed(&fly_shots(Cursor::new(text)).1)
}

fn same(name: &str, launches: &[[f64; 5]]) {
    same_within(name, launches, 1e-9);
}

fn same_within(name: &str, launches: &[[f64; 5]], tolerance: f64) {
    let (found, expected) = (landed(&case(name).1), plain(launches));
    assert_eq!(found.len(), expected.len(), "{name}");
    for (found, expected) in found.iter().zip(&expected) {
        close(found[0], expected[0], expected[0], tolerance, name);
        close(found[1], expected[1], expected[0], tolerance, name);
    }
}

const FIRST: [f64; 5] = [160.0, 12.0, -1.5, 2500.0, 3.0];
const SECOND: [f64; 5] = [157.1, 11.4, 0.3, 2650.0, -1.9];
const STRAIGHT: [f64; 5] = [160.0, 12.0, 0.0, 2500.0, 0.0];

#[test]
fn same_launches_in_number_formats_of_spreadsheets_and_countries() {
    same("apostrophe-negatives.csv", &[FIRST, SECOND]);
    same("excel-formula-cells.csv", &[FIRST, SECOND]);
    same("thousands-of-other-locales.csv", &[STRAIGHT; 6]);
}

#[test]
fn same_launches_with_heads_in_other_spellings() {
    same("heads-camel-case.csv", &[FIRST]);
    same("line-break-in-heads.csv", &[STRAIGHT]);
    // a table with German heads: the speed is in km/h (257.495), and a column has the density of
    // the air (1.184 kg/m³)
    let (shots, found, _) = case("garmin-german.csv");
    assert_eq!(shots.maker(), Some("Garmin"));
    close(
        landed(&found)[0][0],
        269.9 * 0.9144,
        247.0,
        5e-4,
        "garmin-german.csv",
    );
}

/// The table has decimal commas, because a dot in a head is not a decimal point: `61,468` is a
/// fraction.
#[test]
fn same_launches_with_decimal_commas_below_heads_with_dots() {
    let text = "Ball Speed [m/s];Launch Ang. [deg];Launch Dir. [deg];Spin Rate [rpm];Spin Axis \
                [deg]\n61,468;17,8;-3,3;2507;-12,2\n";
    let (_, found, _) = fly_shots(text.as_bytes());
    let expected = plain(&[[61.468 / 0.447_04, 17.8, -3.3, 2507.0, -12.2]]);
    close(
        landed(&found)[0][0],
        expected[0][0],
        expected[0][0],
        1e-9,
        "carry",
    );
}

#[test]
fn same_launches_with_units_in_cells() {
    same("units-in-cells.csv", &[STRAIGHT]);
    let launches = [[123.0, 17.1, 4.6, 0.0, 0.0], [126.4, 15.3, -2.0, 0.0, 0.0]];
    let spins = [[2878.0_f64, 422.0], [2650.0, -210.0]];
    // the file's spin is the total spin, 2909 rpm, which follows from its backspin and sidespin
    let launches = [0, 1].map(|row: usize| {
        let [back, side] = spins[row];
        let mut launch = launches[row];
        (launch[3], launch[4]) = (back.hypot(side), side.atan2(back).to_degrees());
        launch
    });
    same_within("foresight-units-in-cells-cp1252.csv", &launches, 2e-4);
    let (shots, ..) = case("foresight-units-in-cells-cp1252.csv");
    let remarks: Vec<String> = shots.remarks().iter().map(ToString::to_string).collect();
    assert!(
        remarks
            .iter()
            .any(|remarks| remarks.contains("Windows-1252")),
        "{remarks:?}"
    );
    // a cell without a unit in a column with units, and a cell that contradicts the unit of its
    // head
    for (text, says) in [
        (
            "Ball Speed,Launch Angle,Spin Rate\n160 mph,12,2500\n70,12,2500\n",
            "'70' has no unit",
        ),
        (
            "Ball Speed [km/h],Launch Angle,Spin Rate\n160 mph,12,2500\n",
            "'160 mph' states another unit than its head, [km/h]",
        ),
    ] {
        let (_, found, _) = fly_shots(text.as_bytes());
        let reasons: Vec<&str> = (0..found[0].shots.len())
            .filter_map(|row| found[0].reason(row))
            .collect();
        assert!(
            reasons.len() == 1 && reasons[0].contains(says),
            "{reasons:?}"
        );
    }
}

#[test]
fn same_launches_with_a_line_of_units_and_other_cells() {
    let (_, found, _) = case("units-row-with-a-pattern.csv");
    for (found, expected) in landed(&found).iter().zip([269.9, 261.6]) {
        close(
            found[0] / 0.9144,
            expected,
            expected,
            4e-4,
            "units-row-with-a-pattern.csv",
        );
    }
    let text = "Date,Ball Speed,Launch Angle,Spin Rate\nyyyy,furlongs,deg,rpm\n1,160,12,2500\n";
    let error = Shots::read(&Setup::modern_driver(), "a.csv", text.as_bytes())
        .err()
        .unwrap()
        .to_string();
    assert!(
        error.contains("column 2") && error.contains("furlongs"),
        "{error}"
    );
}

#[test]
fn same_launches_in_sections_with_their_own_heads_and_units() {
    let (_, found, _) = case("two-exports-mph-then-kmh.csv");
    let carries = landed(&found);
    assert_eq!(carries.len(), 2);
    close(
        carries[1][0],
        carries[0][0],
        carries[0][0],
        1e-6,
        "the same shot in km/h",
    );
    close(
        carries[0][0] / 0.9144,
        269.9,
        269.9,
        4e-4,
        "two-exports-mph-then-kmh.csv",
    );
    same(
        "sections-with-heads.csv",
        &[FIRST, SECOND, [148.0, 11.5, -0.8, 3305.0, -3.3]],
    );
    let (_, found, tally) = case("sections-with-heads.csv");
    let kinds: Vec<&str> = tally.refused.keys().copied().collect();
    assert_eq!(kinds, ["sums up other rows", "title"]);
    // the written file is read again, with equal carries
    let setup = Setup::modern_driver();
    for name in ["two-exports-mph-then-kmh.csv", "sections-with-heads.csv"] {
        let (shots, first, _) = case(name);
        let writer = ShotWriter::csv(&shots, &[Outcome::CarryDistance], System::Us);
        let mut text = writer.head();
        for flown in &first {
            text.extend(writer.rows(flown));
        }
        let again = landed(&fly_shots(Cursor::new(text.clone())).1);
        assert_eq!(
            again,
            landed(&first),
            "{name}: {}",
            String::from_utf8(text).unwrap()
        );
    }
    // calibration reads the same rows
    let table =
        ShotTable::read(&setup, "a.csv", &bytes("two-exports-mph-then-kmh.csv")[..]).unwrap();
    let speeds: Vec<f64> = table.shots.iter().map(|shot| shot.inputs[0].1).collect();
    assert!(
        table.shots.len() == 2 && (speeds[0] - speeds[1]).abs() < 1e-4,
        "{speeds:?}"
    );
    assert_eq!(
        found.iter().map(|flown| flown.shots.len()).sum::<usize>(),
        5
    );
}

#[test]
fn unmeasured_values_of_a_club_are_not_used() {
    let (_, found, _) = case("gcquad-unmeasured-club.csv");
    let shots: Vec<_> = found.iter().flat_map(|flown| &flown.shots).collect();
    let speeds: Vec<Option<f64>> = shots.iter().map(|shot| shot.club.speed).collect();
    assert_eq!(speeds[..2], [Some(48.5), None]);
    assert_eq!(shots[1].club.values(), [None; 4]);
    assert!(
        shots[1]
            .notes
            .iter()
            .any(|note| note.contains("counts as not measured")),
        "{:?}",
        shots[1].notes
    );
    let (_, found, _) = case("open-connect-zero-club.jsonl");
    assert_eq!(found[0].shots[0].club.values(), [None; 4]);
    assert!(found[0].shots[0].notes.is_empty());
    let message = "{\"BallData\": {\"Speed\": 150, \"VLA\": 12, \"HLA\": 1, \"TotalSpin\": 2700, \
                   \"SpinAxis\": 2}, \"ClubData\": {\"Speed\": 0, \"Path\": 1.5}}";
    let (_, found, _) = fly_shots(Cursor::new(message));
    let shot = &found[0].shots[0];
    assert!(shot.club.speed.is_none() && shot.club.path.is_some());
    assert_eq!(
        shot.notes,
        ["ClubData.Speed: a club speed of 0 counts as not measured"]
    );
}

#[test]
fn words_for_directions_have_signs() {
    let (_, found, _) = case("flightscope-up-down.csv");
    let club = |row: usize| {
        found[0].shots[row]
            .club
            .values()
            .map(|value| value.map(f64::to_degrees))
    };
    let near = |found: [Option<f64>; 4], expected: [f64; 3]| {
        for (found, expected) in found[1..].iter().zip(expected) {
            close(found.unwrap(), expected, 1.0, 1e-12, "degrees");
        }
    };
    near(club(0), [-1.2, 0.8, 0.4]);
    near(club(1), [0.9, -0.5, -0.1]);
    near(club(2), [0.9, -0.5, 0.1]);
}

#[test]
fn published_signs_of_garmin_are_turned() {
    let (shots, found, _) = case("garmin-sidespin-sign.csv");
    let sides: Vec<f64> = landed(&found).iter().map(|landed| landed[1]).collect();
    assert!(sides[0] > 0.0 && sides[1] < 0.0, "{sides:?}");
    let remarks: Vec<String> = shots.remarks().iter().map(ToString::to_string).collect();
    assert!(
        remarks
            .iter()
            .any(|remarks| remarks.contains("Sidespin is read with + to the left")),
        "{remarks:?}"
    );
    // sidespin is positive to the left here, so it has the opposite sign of the spin axis. The
    // measured side agrees with the spin axis, so there is no note
    let text = "Ball Speed [mph],Launch Angle [deg],Launch Direction [deg],Spin Rate [rpm],Spin \
                Axis [deg],Backspin [rpm],Sidespin [rpm],Carry Deviation \
                Distance [yd]\n150,12,0,2500,10,2462,-434,12\n";
    let (_, found, _) = fly_shots(text.as_bytes());
    assert!(
        found[0].shots[0].notes.is_empty() && landed(&found)[0][1] > 0.0,
        "{:?}",
        found[0].shots[0].notes
    );
    // spin axis and sidespin agree, but the measured sides are opposite
    let row = "150,12,0,2500,10,2462,434,240,-12\n";
    let heads = "Ball Speed [mph],Launch Angle [deg],Launch Direction [deg],Spin Rate [rpm],Spin \
                 Axis [deg],Backspin [rpm],Sidespin [rpm],Carry \
                 Distance [yd],Carry Deviation Distance [yd]\n";
    let (shots, found, _) = fly_shots(Cursor::new(format!("{heads}{row}{row}")));
    assert!(landed(&found).iter().all(|landed| landed[1] < 0.0));
    let remarks: Vec<String> = shots.remarks().iter().map(ToString::to_string).collect();
    assert!(
        remarks
            .iter()
            .any(|remarks| remarks.contains("Spin Axis and Sidespin are read with + to the left")),
        "{remarks:?}"
    );
}

/// The sidespin of Garmin is used if no row has a spin axis, even if the table has that column.
#[test]
fn exact_sidespin_of_garmin_beside_an_empty_spin_axis() {
    let heads = "Ball Speed [mph],Launch Angle [deg],Launch Direction [deg],Spin Rate [rpm],Spin \
                 Axis [deg],Backspin [rpm],Sidespin [rpm],Carry Distance [yd],Carry Deviation \
                 Distance [yd]\n";
    let rows = "150,12,0,2500,,2462,434,235,-25\n150,12,0,2500,,2462,-434,235,25\n";
    let (_, found, _) = fly_shots(Cursor::new(format!("{heads}{rows}")));
    let rpm = std::f64::consts::PI / 30.0;
    let spins = found[0].shots.iter().map(|shot| shot.launch().unwrap()[4]);
    for (spin, expected) in spins.zip([-434.0, 434.0]) {
        close(spin / rpm, expected, 434.0, 1e-12, "sidespin");
    }
}

/// `sweep --points` reads the signs of Garmin as `fly` does, and says so.
#[test]
fn same_signs_of_garmin_in_points_and_in_shots() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("garmin.csv");
    let heads = "Ball Speed [mph],Launch Angle [deg],Launch Direction [deg],Spin Rate [rpm],Spin \
                 Axis [deg],Backspin [rpm],Sidespin [rpm],Carry Distance [yd],Carry Deviation \
                 Distance [yd]\n";
    let row = "150,12,0,2500,10,2462,434,240,-12\n";
    for (text, name, says) in [
        (
            String::from_utf8(bytes("garmin-sidespin-sign.csv")).unwrap(),
            "launch.sidespin",
            "Sidespin is read with + to the left, as Garmin's exports have it",
        ),
        (
            format!("{heads}{row}{row}"),
            "launch.spin_axis",
            "Spin Axis is read with + to the left: the balls curve to the opposite side",
        ),
    ] {
        std::fs::write(&path, &text).unwrap();
        let mut points = open_table(&Setup::modern_driver(), &path).unwrap();
        let notes: Vec<String> = points.notes().iter().map(ToString::to_string).collect();
        assert!(notes.contains(&says.to_owned()), "{notes:?}");
        let at = points
            .parameters()
            .iter()
            .position(|parameter| parameter.name == name);
        let mut values = vec![];
        points.read(1, &mut values).unwrap();
        let (_, found, _) = fly_shots(Cursor::new(text));
        let flown = found[0].predicted(0, 1).unwrap();
        assert_eq!(
            values[at.unwrap()].is_sign_positive(),
            flown > 0.0,
            "{name}: {values:?}, {flown} m"
        );
    }
}

/// The second section has another order of columns: its signs and units come from its own rows.
#[test]
fn a_section_is_interpreted_by_its_own_rows() {
    let text = "Ball Speed,Launch Angle,Launch Direction,Spin Rate,Spin Axis,Sidespin,Carry \
                Deviation Distance\n\
                160 mph,12 deg,0 deg,2500 rpm,10 deg,-434 rpm,12 yd\n\
                Sidespin,Spin Axis,Ball Speed,Launch Angle,Launch Direction,Spin Rate,Carry \
                Deviation Distance\n\
                434,10,160,12,0,2500,12\n";
    let (_, found, tally) = fly_shots(text.as_bytes());
    let carries = landed(&found);
    assert_eq!(
        (tally.flown, carries[0]),
        (2, carries[1]),
        "{:?}",
        found[1].reason(0)
    );
    assert!(
        found
            .iter()
            .flat_map(|flown| &flown.shots)
            .all(|shot| shot.notes.is_empty())
    );
}

/// At 1135 ft and 77 °F the density is 1.1367 kg/m³, from the pressure of the standard atmosphere
/// and the gas law of dry air.
#[test]
fn independent_air_of_an_altitude_and_a_temperature() {
    let (shots, found, _) = case("trackman-short-heads.csv");
    assert_eq!(
        shots
            .other_parameters
            .iter()
            .map(|parameter| parameter.name)
            .collect::<Vec<_>>(),
        ["air.density"]
    );
    let kelvin = 273.15 + 25.0;
    let pressure = 101_325.0 * (1.0 - 0.0065 * (1135.0 * 0.3048) / 288.15_f64).powf(5.255_88);
    close(
        found[0].shots[0].other_parameters()[0],
        pressure / (287.05 * kelvin),
        1.1,
        2e-3,
        "density",
    );
}

/// One weather, in several spellings of its numbers: 346 m are 1135 ft, and 25 °C are 77 °F.
#[test]
fn same_air_of_weather_texts_with_marks_and_spaces_in_numbers() {
    let density = |weather: &str, separator: char| {
        let heads = "Ball Speed [mph];Launch Angle [deg];Spin Rate [rpm];Condition\n";
        let row = format!("160;12;2500;\"Normalized to {weather} and Premium ball\"\n");
        let text = (heads.to_owned() + &row).replace(';', &separator.to_string());
        let (_, found, _) = fly_shots(Cursor::new(text));
        let shot = &found[0].shots[0];
        let is_assumed = shot
            .notes
            .iter()
            .any(|note| note.contains("the air of the setup is assumed"));
        (!is_assumed).then(|| shot.other_parameters()[0])
    };
    let expected = density("1135 ft altitude, 77 °F", ',').unwrap();
    for (weather, separator) in [
        ("1,135 ft altitude, 77 °F", ','),
        ("1 135 ft altitude, 77 °F", ','),
        ("1\u{202f}135 ft altitude,77 °F", ';'),
        ("345,9480 m altitude; 25,0 °C", ';'),
        ("345.948 m altitude, 25.0 °C", ','),
        ("1135ft altitude, 77°F", ','),
    ] {
        let found = density(weather, separator).unwrap_or_default();
        close(found, expected, 1.0, 1e-9, weather);
    }
    // a comma marks no decimals between commas, and may mark thousands between semicolons
    assert_eq!(density("346 m altitude, 25,5 °C", ','), None);
    assert_eq!(density("1,135 ft altitude, 77 °F", ';'), None);
    // texts that cannot be read have a note even if no row can be read
    for weather in [
        "25 °C",
        "1830 m H\u{f6}he, 25 °C",
        "altitude 1135 ft, 77 °F",
    ] {
        assert_eq!(density(weather, ','), None, "{weather}");
    }
}

/// Texts without an altitude and a temperature state no air.
#[test]
fn a_condition_that_cannot_be_read_in_any_row_is_named_as_not_used() {
    let heads = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Carry [yd],Condition\n";
    let row = |condition: &str| format!("160,12,2500,262,\"{condition}\"\n");
    for condition in ["25 °C", "25°C", "Wet"] {
        let [of_fly, of_calibrate] = remarks(&(heads.to_owned() + &row(condition)));
        for (remarks, says) in [
            (&of_fly, "columns that are copied and not used: Condition"),
            (&of_calibrate, "columns that are not used: Condition"),
        ] {
            assert!(remarks.contains(says), "{condition}: {remarks}");
            assert!(
                !remarks.contains("each shot flies"),
                "{condition}: {remarks}"
            );
        }
    }
    let text = heads.to_owned() + &row("Wet") + &row("1135 ft altitude, 77 °F");
    for remarks in remarks(&text) {
        let says = "each shot flies in the air that the export states for its row: Condition";
        assert!(
            remarks.contains(says) && !remarks.contains("not used"),
            "{remarks}"
        );
    }
}

/// A `sweep` and a delivery do not use the air of the rows.
#[test]
fn a_condition_that_is_not_used_is_named() {
    let file = format!(
        "{}/data/cases/trackman-short-heads.csv",
        env!("CARGO_MANIFEST_DIR")
    );
    for words in [
        ["sweep", "--points", &file, "--outcomes", "carry"],
        ["delivery", "--shots", &file, "--all", "--verbose"],
    ] {
        let output = longdrive(&words);
        let said = on_one_line(&(output.err + &output.out));
        let list = said.split_once("columns that are not used: ").unwrap().1;
        assert!(
            list.split_whitespace()
                .take(3)
                .any(|head| head == "Condition"),
            "{words:?}: {said}"
        );
    }
}

#[test]
fn every_shot_is_explained_by_its_stated_values() {
    for (name, rows) in [
        ("blank-club-path.csv", 4),
        ("foresight-empty-club.csv", 2),
        ("gcquad-unmeasured-club.csv", 2),
        ("open-connect-zero-club.jsonl", 1),
    ] {
        let file = format!("{}/data/cases/{name}", env!("CARGO_MANIFEST_DIR"));
        let setup = Setup::modern_driver();
        let table =
            ShotTable::open_launches(&setup, std::path::Path::new(&file), RowFilter::default())
                .unwrap();
        assert_eq!(table.shots.len(), rows, "{name}");
    }
    let file = format!(
        "{}/data/cases/blank-club-path.csv",
        env!("CARGO_MANIFEST_DIR")
    );
    let table = ShotTable::open_launches(
        &Setup::modern_driver(),
        std::path::Path::new(&file),
        RowFilter::default(),
    )
    .unwrap();
    let remarks: Vec<String> = table.remarks.iter().map(ToString::to_string).collect();
    let says = "Club Path: not stated; the prior is used in its place: row 2, row 3, row 4";
    assert!(remarks.iter().any(|remarks| remarks == says), "{remarks:?}");
}

/// Twelve launches, written in tables with many heads, units, letters of sides and decimal marks.
#[test]
fn same_launches_in_generated_tables_and_in_a_plain_one() {
    let launches: Vec<[f64; 5]> = (0..12)
        .map(|k| {
            let part = |i: u32| (f64::from(k) * (0.754_877_666 + 0.1 * f64::from(i))).fract();
            // + 0.0 avoids −0
            let one = |low: f64, high: f64, i| {
                (10.0 * (low + (high - low) * part(i))).round() / 10.0 + 0.0
            };
            [
                one(120.0, 170.0, 1),
                one(8.0, 16.0, 2),
                one(-4.0, 4.0, 3),
                one(1800.0, 4000.0, 4).round(),
                one(-12.0, 12.0, 5),
            ]
        })
        .collect();
    let expected = plain(&launches);
    let speeds = [("mph", 1.0), ("km/h", 1.609_344), ("m/s", 0.447_04)];
    let styles = [
        "Ball Speed [U]|Launch Angle [deg]|Launch Direction [deg]|Spin Rate [rpm]|Spin Axis [deg]",
        "Ball Speed (U)|Launch V (\u{b0})|Launch H (\u{b0})|Spin (rpm)|Spin Axis (\u{b0})",
        "BallSpeed [U]|LaunchAngle [deg]|LaunchDirection [deg]|SpinRate [rpm]|SpinAxis [deg]",
    ];
    let mut tables = 0;
    for (unit, size) in speeds {
        for style in styles {
            for separator in [',', ';', '\t'] {
                for has_comma in [false, true] {
                    for has_sides in [false, true] {
                        for encoding in 0..3 {
                            if has_comma && separator == ',' {
                                continue;
                            }
                            let line =
                                |cells: Vec<String>| cells.join(&separator.to_string()) + "\r\n";
                            let heads = style.replace('U', unit);
                            let mut text = String::from("Session of May\r\n");
                            text += &line(heads.split('|').map(String::from).collect());
                            for launch in &launches {
                                let number = |value: f64| {
                                    let text = value.to_string();
                                    if has_comma {
                                        text.replace('.', ",")
                                    } else {
                                        text
                                    }
                                };
                                let sided = |value: f64| match has_sides {
                                    true if value < 0.0 => format!("{} L", number(-value)),
                                    true => format!("{}R", number(value)),
                                    false => number(value),
                                };
                                let [speed, angle, direction, spin, axis] = *launch;
                                text += &line(vec![
                                    number(speed * size),
                                    number(angle),
                                    sided(direction),
                                    number(spin),
                                    sided(axis),
                                ]);
                            }
                            let bytes: Vec<u8> = match encoding {
                                0 => text.clone().into_bytes(),
                                1 => text.encode_utf16().flat_map(u16::to_le_bytes).collect(),
                                // Latin-1, a subset of Windows-1252
                                _ => text
                                    .chars()
                                    .map(|c| u8::try_from(u32::from(c)).unwrap())
                                    .collect(),
                            };
                            let found = landed(&fly_shots(Cursor::new(bytes)).1);
                            assert_eq!(found.len(), expected.len(), "{text}");
                            for (found, expected) in found.iter().zip(&expected) {
                                close(found[0], expected[0], expected[0], 1e-9, &text);
                                close(found[1], expected[1], expected[0], 1e-9, &text);
                            }
                            tables += 1;
                        }
                    }
                }
            }
        }
    }
    assert_eq!(tables, 270);
}

/// A warning names the unit in which a column would agree with the prediction, if it is not the
/// unit in the head.
#[test]
fn implausible_units_are_warned_of() {
    let launches: Vec<[f64; 5]> = (0..6)
        .map(|k| [150.0 + 4.0 * f64::from(k), 12.0, 0.0, 2600.0, 2.0])
        .collect();
    let carries: Vec<f64> = plain(&launches).iter().map(|landed| landed[0]).collect();
    let text_with_head = |head: &str, speed: f64, carry: f64, side: f64| {
        let mut text = String::from(
            ",Launch Angle [deg],Launch Direction [deg],Spin Rate [rpm],Spin Axis \
             [deg],Carry [yd],Side [yd]\n",
        );
        for ([mph, angle, direction, spin, axis], metres) in launches.iter().zip(&carries) {
            let cells = [
                mph * speed,
                *angle,
                *direction,
                *spin,
                *axis,
                metres * carry,
                side,
            ];
            text += &(cells.map(|cell| cell.to_string()).join(",") + "\n");
        }
        head.to_owned() + &text
    };
    let text = |speed, carry, side| text_with_head("Ball Speed", speed, carry, side);
    let warned = |text: String| {
        let (shots, _, tally) = fly_shots(Cursor::new(text));
        let warnings = tally.unit_warnings(&shots);
        warnings.iter().map(ToString::to_string).collect::<Vec<_>>()
    };
    let yards = 1.0 / 0.9144;
    assert!(
        warned(text(1.0, yards, 7.0)).is_empty(),
        "{:?}",
        warned(text(1.0, yards, 7.0))
    );
    // measured carries of 1.09 times the prediction may be yards that are read as metres, but this
    // column is read in yards: no warning
    assert!(warned(text(1.0, yards / 0.9144, 7.0)).is_empty());
    for (warnings, words) in [
        (
            warned(text(1.0, 1.0, 7.0)),
            "Carry: predicted values are 1.09 times the measured values in the median, as if the \
             measured values were in m",
        ),
        (
            warned(text(0.447_04, yards, 7.0)),
            "Ball Speed: the balls carry farther than such speeds allow, as if the speeds were in \
             m/s",
        ),
        (
            warned(text(1.609_344, yards, 7.0)),
            "as if the speeds were in km/h and read in mph",
        ),
        // no unit of the ball speed would explain the carries, so the warning names no unit
        (
            warned(text_with_head("Ball Speed [m/s]", 0.719_435, yards, 7.0)),
            "Ball Speed: the balls carry less far than such speeds give; check the unit in \
             the head",
        ),
        (
            warned(text_with_head("Ball Speed [km/h]", 0.719_435, yards, 7.0)),
            "Ball Speed: the balls carry farther than such speeds allow; check the unit in \
             the head",
        ),
        (
            warned(text(1.0, yards, -7.0)),
            "Side: of 6 rows that end off the target line 6 end on the opposite side",
        ),
    ] {
        assert!(
            warnings.len() == 1 && warnings[0].contains(words),
            "{words}: {warnings:?}"
        );
    }
}

/// For irons, the carry of the default law is too short by about 9 %, the difference between a yard
/// and a metre. These are the tour averages of a 7 iron (TrackMan): 120 mph, 16.3°, 7097 rpm, 172
/// yd.
#[test]
fn the_unit_of_the_carries_of_irons_is_not_doubted() {
    let row = "193.1,16.3,7097,157.3\n";
    let heads = "Ball Speed (km/h),Launch Angle (deg),Spin Rate (rpm),Carry (m)\n";
    let (shots, _, tally) = fly_shots(Cursor::new(heads.to_owned() + &row.repeat(6)));
    let warnings = tally.unit_warnings(&shots);
    assert!(warnings.is_empty(), "{warnings:?}");
}

/// The laws are accurate enough for the carry of drives only. These are the averages of the LPGA
/// Tour (TrackMan): 140 mph, 13.2°, 2611 rpm, 218 yd, 25 yd high.
#[test]
fn the_unit_of_heights_in_yards_is_not_doubted() {
    let row = "140,13.2,2611,218,25\n";
    let heads =
        "Ball Speed (mph),Launch Angle (deg),Spin Rate (rpm),Carry (yds),Max Height (yds)\n";
    let (shots, _, tally) = fly_shots(Cursor::new(heads.to_owned() + &row.repeat(6)));
    let warnings = tally.unit_warnings(&shots);
    assert!(warnings.is_empty(), "{warnings:?}");
}

#[test]
fn a_line_of_units_that_contradicts_its_head_is_refused() {
    let text = |head: &str, below: &str| {
        format!(
            "Ball Speed [{head}],Launch Angle [deg],Spin Rate \
             [rpm]\n[{below}],[deg],[rpm]\n70,12,2600\n"
        )
    };
    let read =
        |text: String| Shots::read(&Setup::modern_driver(), "a.csv", Cursor::new(text)).map(drop);
    let error = read(text("mph", "m/s")).err().unwrap().to_string();
    assert!(
        error.contains("the head says [mph], and the line of units [m/s]; correct one of them"),
        "{error}"
    );
    for (head, below) in [("mph", "mph"), ("km/h", "kph")] {
        read(text(head, below)).unwrap();
    }
}

#[test]
fn same_shots_with_a_club_of_zeros_and_without_one() {
    let text = |club: &str| {
        format!(
            "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Club Speed [mph],Attack Angle \
             [deg],Club Path [deg],Face Angle [deg]\n\
             160,12,2600,110,-1.2,0.8,0.1\n160,12,2600,{club}\n"
        )
    };
    let inputs = |club: &str| {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.csv");
        std::fs::write(&path, text(club)).unwrap();
        let table =
            ShotTable::open_launches(&Setup::modern_driver(), &path, RowFilter::default()).unwrap();
        table
            .shots
            .iter()
            .map(|shot| shot.inputs.len())
            .collect::<Vec<_>>()
    };
    assert_eq!((inputs("0,0,0,0"), inputs(",,,")), (vec![4, 0], vec![4, 0]));
}

#[test]
fn summary_rows_are_recognised_in_german_too() {
    let rows = "A;257,5;12,0;2600\nDurchschnitt;257,5;12,0;2600\nStandardabweichung;2,5;1,0;200\n\u{d8};257,5;12,0;2600\n";
    let text =
        format!("Spieler;Ballgeschwindigkeit;Abflugwinkel;Drehrate\n;[km/h];[deg];[rpm]\n{rows}");
    let (_, _, tally) = fly_shots(Cursor::new(text));
    assert_eq!((tally.rows, tally.flown), (4, 1));
}

const LAUNCH: &str = "160.0,12.0,-1.5,2500,3.0,262.0";

/// A table with a row for each of `cells`, the values of the columns `heads`; every row has the
/// launch [`LAUNCH`].
fn with_first_cells(heads: &str, cells: &[&str]) -> String {
    let rows: String = cells
        .iter()
        .map(|cell| format!("{cell},{LAUNCH}\n"))
        .collect();
    format!(
        "{heads},Ball Speed [mph],Launch Angle [deg],Launch Direction [deg],Spin Rate [rpm],Spin \
         Axis [deg],Carry [yd]\n{rows}"
    )
}

/// The numbers of rows that `fly` reads and flies, and the number of shots that `calibrate` reads.
fn counts(text: &str) -> ([u64; 2], usize) {
    let (_, _, tally) = fly_shots(Cursor::new(text.to_owned()));
    let table = ShotTable::read(&Setup::modern_driver(), "a.csv", text.as_bytes()).unwrap();
    ([tally.rows, tally.flown], table.shots.len())
}

/// Only in a table with this program's names, a line that begins with `#` is a remark.
#[test]
fn rows_and_heads_that_begin_with_a_number_sign_are_read() {
    let rows = with_first_cells("Shot", &["#1", "#2", "3"]);
    let head = with_first_cells("#", &["1", "2", "3"]);
    for text in [rows, head.clone(), format!("# a remark\n{head}")] {
        assert_eq!(counts(&text), ([3, 3], 3), "{text}");
        let folder = tempfile::tempdir().unwrap();
        let file = file_with(folder.path(), "a.csv", &text);
        let mut points = open_table(&Setup::modern_driver(), file.as_ref()).unwrap();
        assert_eq!(points.read(9, &mut vec![]).unwrap(), 3, "{text}");
    }
    let semicolons = head.replace(',', ";");
    assert_eq!(counts(&semicolons), ([3, 3], 3));
    // in an export, a line that begins with `#` counts as a row
    let title = with_first_cells("Shot", &["1", "2"]) + "# the end\n";
    assert_eq!(counts(&title), ([3, 2], 2));
    let own = "# a remark\nball_speed [mph],launch_angle [deg],spin [rpm],carry [yd]\n# ball \
               speed, carry\n160,12,2500,262\n#170,12,2500,262\n";
    assert_eq!(counts(own), ([1, 1], 1));
}

#[test]
fn heads_whose_first_cell_begins_with_a_number_sign_are_read() {
    for head in ["#Shot", "# Shot", "#Nr", "#No"] {
        let text = with_first_cells(head, &["1", "2", "3"]);
        let (heads, rows) = text.split_once('\n').unwrap();
        let units = ",[mph],[deg],[deg],[rpm],[deg],[yd]";
        for text in [
            text.clone(),
            format!("# Ball Speed, Carry\nSession 1,,\n{text}"),
            format!("{heads}\n{units}\n{rows}"),
            text.replace(',', ";"),
        ] {
            assert_eq!(counts(&text), ([3, 3], 3), "{text}");
        }
    }
    // a remark above or below the heads may name the columns
    let (heads, row) = (
        "ball_speed [mph],launch_angle [deg],spin [rpm],carry [yd]\n",
        "160,12,2500,262\n",
    );
    let remark = "# Ball Speed, Launch Angle, Spin Rate, Carry\n";
    for text in [[remark, heads, row], [heads, remark, row]] {
        assert_eq!(counts(&text.concat()), ([1, 1], 1), "{text:?}");
    }
    let export = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Carry [yd]\n";
    assert_eq!(counts(&[remark, export, row].concat()), ([1, 1], 1));
}

/// The name of a statistic marks a summary only in a cell that says which shot the row is, and
/// `Dev` or `Max` may be a player or a club.
#[test]
fn names_and_ratings_that_are_words_of_statistics_are_shots() {
    for (head, cells) in [
        ("Player", &["Dev", "Amy", "Max"][..]),
        ("Club", &["G430 Max", "Driver", "Max"]),
        ("Quality", &["Average", "Good", "Best"]),
        ("Shot Quality", &["Average", "Good", "Best"]),
        ("Shot,Quality", &["1,Average", "2,Good", "3,Mean"]),
    ] {
        let text = with_first_cells(head, cells);
        assert_eq!(counts(&text), ([3, 3], 3), "{text}");
    }
}

#[test]
fn summary_rows_are_recognised_in_the_usual_words_and_languages() {
    let words = [
        "Average",
        "Averages:",
        "AVG",
        "Avg.",
        "Average (12)",
        "Club Average",
        "Driver Average",
        "Session Average",
        "Total Average",
        "Median",
        "Std. Dev.",
        "StDev",
        "Std",
        "SD",
        "Dev",
        "\u{3c3}",
        "Max",
        "Min",
        "Range",
        "Best",
        "Mittel",
        "Mittelwert",
        "Gesamtdurchschnitt",
        "Standardabw.",
        "Std.-Abw.",
        "Moyenne",
        "\u{c9}cart type",
        "Promedio",
        "Media",
        "Desviaci\u{f3}n est\u{e1}ndar",
        "\u{5e73}\u{5747}",
        "\u{6a19}\u{6e96}\u{504f}\u{5dee}",
    ];
    let of_statistics = words.len() as u64;
    for (head, first) in [("Shot", "7"), ("Jour", "Nov 26, 2025"), ("", "7")] {
        // a comma would need quotes
        let cells: Vec<String> = [first]
            .iter()
            .chain(&words)
            .map(|cell| format!("\"{cell}\""))
            .collect();
        let cells: Vec<&str> = cells.iter().map(String::as_str).collect();
        let text = with_first_cells(head, &cells);
        assert_eq!(counts(&text), ([1 + of_statistics, 1], 1), "{head}");
    }
    // in a column of clubs or players, `Dev` names a statistic only beside another such word
    let of_clubs = ["Driver", "Driver Average", "Std. Dev.", "Average"];
    for head in ["Club", "Player"] {
        assert_eq!(counts(&with_first_cells(head, &of_clubs)), ([4, 1], 1));
    }
    let text = with_first_cells("Club,Index", &["Driver,1", "Driver,Average", "Driver,Max"]);
    assert_eq!(counts(&text), ([3, 1], 1));
}

/// Left of the measured values, any head may stand above the labels of shots. Ratings and players
/// are words in the other rows too.
#[test]
fn summary_rows_are_recognised_below_any_head_left_of_the_values() {
    let heads = [
        "",
        "#",
        "Shots",
        "Stroke",
        "Swing #",
        "Ball #",
        "Type",
        "Shot Type",
        "Statistic",
        "Schlag",
        "Coup",
        "Golpe",
    ];
    let shots = [["", ""], ["Shot 1", "Shot 2"], ["Shot", "Shot"]];
    let of_heads = heads
        .iter()
        .flat_map(|head| shots.map(|shots| (*head, shots)));
    let of_clubs = [
        ("Clubs", ["Driver", "Driver"]),
        ("", ["Driver", "7 Iron"]),
        ("Equipment", ["Driver", "Driver"]),
    ];
    for (head, [first, second]) in of_heads.chain(of_clubs) {
        let text = with_first_cells(head, &[first, second, "Average", "Std. Dev."]);
        assert_eq!(counts(&text), ([4, 2], 2), "{text}");
    }
    let title = "Driver,,,,,,\n";
    let text = with_first_cells("", &["", "Average"]) + title + &format!(",{LAUNCH}\n");
    assert_eq!(counts(&text), ([4, 2], 2), "{text}");
    for (head, cells) in [
        ("Quality", ["Average", "Good", "Good"]),
        ("Contact", ["Average", "Average", "Average"]),
        ("Who", ["Dev", "Amy", "Max"]),
    ] {
        let text = with_first_cells(head, &cells);
        assert_eq!(counts(&text), ([3, 3], 3), "{text}");
    }
}

/// A row with a number alone lacks values, but it is no title. `60°` is the name of a wedge in the
/// column of the club.
#[test]
fn a_single_cell_with_a_number_in_the_format_of_its_column_is_no_title() {
    let kinds = |rows: &str| {
        let heads = "Club;Ball Speed [mph];Launch Angle [deg];Spin Rate [rpm]";
        let text = format!("{heads}\nDriver;153,5;12,5;2500\n{rows}");
        let (_, _, tally) = fly_shots(Cursor::new(text));
        let kinds = tally.refused.iter();
        let kinds = kinds.map(|(kind, refused)| (*kind, refused.count));
        kinds.collect::<Vec<_>>()
    };
    let values = ";153,5;;\n;153.5 mph;;\n;;12°;\n;;;2500 rpm\n";
    assert_eq!(kinds(values), [("missing value", 4)]);
    assert_eq!(kinds("60°;;;\n;Driver;;\n"), [("title", 2)]);
    let folder = tempfile::tempdir().unwrap();
    let text = "Club Speed [mph];Attack Angle [deg]\n105,5;1\n;1,5\n107 mph;\nDriver;\n";
    let points = file_with(folder.path(), "points.csv", text);
    let swept = longdrive(&["sweep", "--points", &points, "--outcomes", "carry"]);
    let rows = swept.out.lines().skip(1);
    let is_missing: Vec<bool> = rows.map(|row| row.contains("out-of-range")).collect();
    assert_eq!(is_missing, [false, true, true], "{}", swept.err);
}

#[test]
fn a_launch_that_is_set_beside_shots_is_refused() {
    let file = format!(
        "{}/data/cases/heads-camel-case.csv",
        env!("CARGO_MANIFEST_DIR")
    );
    for set in [
        "launch.backspin=4000rpm",
        "launch.launch_direction=5deg",
        "launch.spin_axis=3deg",
        "launch.ball_speed=150mph",
    ] {
        let output = longdrive(&["fly", &file, "--set", set]);
        assert!(
            output.status == 2 && output.err.contains("leave"),
            "{set}: {} {}",
            output.status,
            output.err
        );
    }
}

fn remarks(text: &str) -> [String; 2] {
    let joined = |remarks: Vec<String>| remarks.join("\n");
    let (shots, ..) = fly_shots(Cursor::new(text.to_owned()));
    let of_fly = shots.remarks().iter().map(ToString::to_string).collect();
    let table = ShotTable::read(&Setup::modern_driver(), "a.csv", text.as_bytes()).unwrap();
    let of_calibrate = table.remarks.iter().map(ToString::to_string).collect();
    [joined(of_fly), joined(of_calibrate)]
}

/// The columns that `fly` adds are recognised only side by side, in the order of `fly`.
#[test]
fn columns_with_the_names_of_those_of_fly_are_ordinary_columns() {
    let text = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Carry [yd],Flight (s),Notes,\
                Line,Predicted Carry (yd),Reason\n160,12,2500,262,6.5,good,1,270,x\n";
    let list = "Flight, Notes, Line, Predicted Carry, Reason";
    let [of_fly, of_calibrate] = remarks(text);
    let says = format!("columns that are copied and not used: {list}");
    assert!(of_fly.contains(&says), "{of_fly}");
    let says = format!("columns that are not used: {list}");
    assert!(of_calibrate.contains(&says), "{of_calibrate}");
    let (shots, found, _) = fly_shots(Cursor::new(text));
    let writer = ShotWriter::csv(&shots, &[Outcome::CarryDistance], System::Us);
    let again = [writer.head(), writer.rows(&found[0])].concat();
    let [of_fly, of_calibrate] = remarks(&String::from_utf8(again).unwrap());
    let says = "the column Line and all after it, which an earlier 'fly' added, are replaced";
    assert!(of_fly.contains(says), "{of_fly}");
    let says = "columns that an earlier 'sweep' or 'fly' wrote are not read: Line, Flight, \
                Reason, Notes, Predicted carry_distance";
    assert!(of_calibrate.contains(says), "{of_calibrate}");
}

/// Square writes `ClubSpeed` in a unit that it does not state.
#[test]
fn a_club_speed_of_square_is_not_used() {
    let heads = "Index,Ball Speed(mph),Launch Angle(deg),Launch Direction(deg),Backspin(rpm),\
                 Sidespin(rpm),Carry(yd),Offline(yd),Dynamic Loft(deg),ClubSpeed";
    let row = "1,150,12,R2.0,2500,L300,240,L5,12,103";
    let text = format!("{heads}\n{row}\n");
    let (_, found, _) = fly_shots(Cursor::new(text.clone()));
    assert_eq!(found[0].shots[0].club.values(), [None; 4]);
    for remarks in remarks(&text) {
        let (_, list) = remarks.split_once("not used: ").unwrap();
        assert!(list.contains("ClubSpeed"), "{remarks}");
    }
    let text = format!("{heads} [mph]\n{row}\n");
    let (_, found, _) = fly_shots(Cursor::new(text));
    assert_eq!(found[0].shots[0].club.speed, Some(103.0 * 0.447_04));
}

/// Every command reads only the first of two columns of one quantity or of one parameter.
#[test]
fn the_first_of_two_columns_of_one_quantity_is_read() {
    let folder = tempfile::tempdir().unwrap();
    for (heads, cells, says) in [
        (
            "Carry (m),Carry (yds)",
            "239.6,300",
            "'Carry (yds)' repeats 'Carry (m)'",
        ),
        (
            "air.density [kg/m^3],air.density [g/L],Carry (yds)",
            "1.1,1.3,262",
            "'air.density [g/L]' repeats 'air.density [kg/m^3]'",
        ),
        (
            "Air Density [kg/m^3],Air Density [g/L],Carry (yds)",
            "1.0,1.3,262",
            "'Air Density [g/L]' repeats 'Air Density [kg/m^3]'",
        ),
        (
            "ball speed [m/s],Carry (yds)",
            "30,262",
            "'ball speed [m/s]' repeats 'Ball Speed [mph]'",
        ),
    ] {
        let text = format!(
            "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],{heads}\n160,12,2500,{cells}\n"
        );
        let says = format!("columns given twice; only the first is used: {says}");
        for remarks in remarks(&text) {
            assert!(remarks.contains(&says), "{remarks}");
        }
        let (_, found, _) = fly_shots(Cursor::new(text.clone()));
        let shot = &found[0].shots[0];
        let table = ShotTable::read(&Setup::modern_driver(), "a.csv", text.as_bytes()).unwrap();
        assert_eq!(table.shots[0].measured.len(), 1);
        let measured = table.shots[0].measured[0].value;
        assert_eq!(
            shot.value(Outcome::CarryDistance).map(|carry| carry.value),
            Some(measured)
        );
        let first = [("air", 1.1), ("Air", 1.0)];
        let first = first.iter().find(|(head, _)| heads.starts_with(head));
        let values: Vec<f64> = first.iter().map(|(_, value)| *value).collect();
        assert_eq!(shot.other_parameters(), values);
        let file = file_with(folder.path(), "a.csv", &text);
        let launches =
            ShotTable::open_launches(&Setup::modern_driver(), file.as_ref(), RowFilter::default());
        assert_eq!(launches.unwrap().shots.len(), 1, "{heads}");
    }
}
