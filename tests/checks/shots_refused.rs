//! Rows of an export that are no drives, and exports without units: `calibrate` and `delivery
//! --shots` read them as `fly` does.

use crate::command_line::{file_with, json};
use crate::shots::fly_shots;
use longdrive::study::calibrate::ShotTable;
use longdrive::table::RowFilter;
use longdrive::{Outcome, Setup};
use std::io::Cursor;
use std::path::Path;

const HEAD: &str = "Ball Speed [mph],Launch Angle [deg],Launch Direction [deg],Total Spin \
                    [rpm],Spin Axis [deg],Carry [yd],Side [yd]\n";

const GOOD: &str = "150,12,0,2600,3,245,5\n";

fn read(text: &str) -> ShotTable {
    ShotTable::read(&Setup::modern_driver(), "shots.csv", text.as_bytes()).unwrap()
}

fn remarks(table: &ShotTable) -> String {
    table
        .remarks
        .iter()
        .map(ToString::to_string)
        .collect::<Vec<_>>()
        .join("\n")
}

fn rows(table: &ShotTable) -> Vec<usize> {
    table.shots.iter().map(|shot| shot.row).collect()
}

/// The rows that `fly` flies, counted from 1, and the reasons for refusing the others.
fn of_fly(text: &str) -> (Vec<usize>, Vec<String>) {
    let (_, all, _) = fly_shots(Cursor::new(text.to_owned()));
    let (mut rows, mut reasons) = (vec![], vec![]);
    for (at, shot) in all.iter().flat_map(|flown| &flown.shots).enumerate() {
        match shot.refusal() {
            None => rows.push(at + 1),
            Some(refusal) => reasons.push(refusal.reason.clone()),
        }
    }
    (rows, reasons)
}

#[test]
fn calibrate_and_delivery_omit_the_rows_that_fly_refuses() {
    let bad = [
        "150,12,0,0,3,245,5",
        "350,12,0,2600,3,245,5",
        "150,95,0,2600,3,245,5",
        "150,12,0,2600,170,245,5",
    ];
    let text = bad
        .iter()
        .fold(HEAD.to_owned(), |text, row| text + GOOD + row + "\n")
        + GOOD;
    let (flies, reasons) = of_fly(&text);
    assert_eq!((&flies, reasons.len()), (&vec![1, 3, 5, 7, 9], bad.len()));
    let table = read(&text);
    assert_eq!(rows(&table), flies);
    let folder = tempfile::tempdir().unwrap();
    let file = file_with(folder.path(), "shots.csv", &text);
    let launches = ShotTable::open_launches(
        &Setup::modern_driver(),
        Path::new(&file),
        RowFilter::default(),
    )
    .unwrap();
    let with_club = text
        .replace("Side [yd]\n", "Side [yd],Club Speed [mph]\n")
        .replace(",5\n", ",5,103\n");
    let file = file_with(folder.path(), "club.csv", &with_club);
    let clubs = ShotTable::open_launches(
        &Setup::modern_driver(),
        Path::new(&file),
        RowFilter::default(),
    )
    .unwrap();
    for (table, of) in [
        (&table, "calibrate"),
        (&launches, "delivery"),
        (&clubs, "delivery with a club"),
    ] {
        assert_eq!(rows(table), flies, "{of}");
        for reason in &reasons {
            assert!(
                remarks(table).contains(reason),
                "{of}: no '{reason}' in {}",
                remarks(table)
            );
        }
    }
}

/// Without a speed of ball or club, the estimated speed would only be the assumed one.
#[test]
fn delivery_refuses_a_table_without_a_speed_and_names_other_missing_columns() {
    let folder = tempfile::tempdir().unwrap();
    let open = |name: &str, text: &str| {
        let file = file_with(folder.path(), name, text);
        ShotTable::open_launches(
            &Setup::modern_driver(),
            Path::new(&file),
            RowFilter::default(),
        )
    };
    let refused = open("no_speed.csv", "BallSpd,Launch Angle,Spin\n138,11.2,3100\n");
    let reason = refused.unwrap_err().to_string();
    assert!(
        reason.contains("no column has the ball speed or the club speed"),
        "{reason}"
    );
    let no_spin = open(
        "no_spin.csv",
        "Ball Speed [mph],Launch Angle [deg]\n138,11.2\n",
    )
    .unwrap();
    assert!(
        remarks(&no_spin).contains(
            "no column has the spin (spin rate, total spin or backspin): the deliveries are \
             estimated without it"
        ),
        "{}",
        remarks(&no_spin)
    );
    let with_club = open(
        "club.csv",
        "Swing Speed [mph],Launch Angle [deg],Spin [rpm]\n93,11.2,3100\n",
    )
    .unwrap();
    assert_eq!(rows(&with_club), [1]);
    assert!(remarks(&with_club).contains("no column has the ball speed: "));
}

#[test]
fn delivery_omits_the_incomplete_launches_that_fly_refuses() {
    let bad = [
        ",12,0,2600,3,245,5",
        "150,,0,2600,3,245,5",
        "150,12,0,,3,245,5",
    ];
    let text = bad
        .iter()
        .fold(HEAD.to_owned(), |text, row| text + GOOD + row + "\n")
        + GOOD;
    let (flies, reasons) = of_fly(&text);
    assert_eq!((&flies, reasons.len()), (&vec![1, 3, 5, 7], bad.len()));
    let folder = tempfile::tempdir().unwrap();
    let with_club = text
        .replace("Side [yd]\n", "Side [yd],Club Speed [mph]\n")
        .replace(",5\n", ",5,103\n");
    for (name, text) in [("shots.csv", &text), ("club.csv", &with_club)] {
        let file = file_with(folder.path(), name, text);
        let table = ShotTable::open_launches(
            &Setup::modern_driver(),
            Path::new(&file),
            RowFilter::default(),
        )
        .unwrap();
        assert_eq!(rows(&table), flies, "{name}");
        let sentence = "rows left out, since they lack a value that every shot needs: row 2 (Ball \
                    Speed), row 4 (Launch Angle), row 6 (Total Spin)";
        assert!(
            remarks(&table).contains(sentence),
            "{name}: {}",
            remarks(&table)
        );
    }
    // without a column of spin no launch is complete, so no row is refused for its launch
    let file = file_with(
        folder.path(),
        "slow.csv",
        "Ball Speed [mph],Launch Angle [deg],Club Speed [mph]\n150,12,103\n150,,103\n",
    );
    let table = ShotTable::open_launches(
        &Setup::modern_driver(),
        Path::new(&file),
        RowFilter::default(),
    )
    .unwrap();
    assert_eq!(rows(&table), [1, 2]);
}

#[test]
fn an_impossible_measured_value_is_not_compared() {
    let table = read(&format!(
        "{HEAD}{GOOD}150,12,0,2600,3,-10,5\n150,12,0,2600,3,9999,5\n150,12,0,2600,3,0,5\n"
    ));
    assert_eq!(rows(&table), [1, 2, 3, 4]);
    for shot in &table.shots[1..] {
        let of: Vec<Outcome> = shot
            .measured
            .iter()
            .map(|measured| measured.outcome)
            .collect();
        assert_eq!(of, [Outcome::Lateral], "row {}", shot.row);
    }
    for sentence in [
        "row 2: not compared: Carry: ",
        "row 3: not compared: Carry: 9999 yd is outside of the range of drives",
    ] {
        assert!(
            remarks(&table).contains(sentence),
            "no '{sentence}' in {}",
            remarks(&table)
        );
    }
    let table = read(&format!("{HEAD}{GOOD}150,12,0,2600,3,far,5\n"));
    assert_eq!(
        rows(&table),
        [1, 2],
        "an unreadable cell suppresses its own comparison alone"
    );
    assert!(
        remarks(&table).contains("row 2: not compared: Carry: "),
        "{}",
        remarks(&table)
    );
    // this table has no column of the club, so a row whose carry is refused has no other value to
    // fit
    let alone = read(
        "Ball Speed [mph],Launch Angle [deg],Total Spin [rpm],Carry \
         [yd]\n150,12,2600,245\n150,12,2600,9999\n",
    );
    assert_eq!(rows(&alone), [1]);
    assert!(
        remarks(&alone).contains("row 2 (Carry: 9999 yd is outside"),
        "{}",
        remarks(&alone)
    );
}

#[test]
fn an_unclosed_quote_affects_its_row_alone() {
    let head = "Ball Speed [mph],Launch Angle [deg],Total Spin [rpm],Carry [yd],Club Name\n";
    let text = format!(
        "{head}150,12,2600,245,A\n151,12,2600,246,\"C\n152,12,2600,247,D\n153,12,2600,248,E\n"
    );
    let (flies, reasons) = of_fly(&text);
    assert_eq!(flies, [1, 3, 4]);
    let table = read(&text);
    assert_eq!(rows(&table), flies);
    assert!(
        remarks(&table).contains(&format!("row 2 ({})", reasons[0])),
        "{}",
        remarks(&table)
    );
}

#[test]
fn no_spin_and_topspin_are_out_of_range_in_every_format() {
    let of_cells = |heads: &str, cells: &str| {
        format!(
            "Ball Speed [mph],Launch Angle [deg],Carry \
             [yd],{heads}\n150,12,240,{cells}\n150,12,240,{cells}\n"
        )
    };
    let message =
        |ball: &str| format!("{{\"BallData\":{{\"Speed\":150,\"VLA\":12,\"HLA\":0,{ball}}}}}\n");
    let none = "0 rpm is outside of the range of drives, above 0 to 20000 rpm";
    let top = "2500 rpm is outside of the range of drives, 0 to 20000 rpm";
    for (text, says) in [
        (of_cells("Total Spin [rpm]", "0"), none),
        (of_cells("Back Spin [rpm]", "0"), none),
        (of_cells("Back Spin [rpm],Side Spin [rpm]", "0,0"), none),
        (of_cells("Back Spin [rpm]", "-2500"), top),
        (
            of_cells("Total Spin [rpm],Spin Axis [deg]", "2500,180"),
            top,
        ),
        (
            of_cells("Back Spin [rpm],Side Spin [rpm]", "19000,19000"),
            "Back Spin (spin = √(backspin² + sidespin²)): 26",
        ),
        (message("\"BackSpin\":0,\"SideSpin\":0"), none),
        (
            message("\"TotalSpin\":0,\"BackSpin\":0,\"SideSpin\":0"),
            none,
        ),
        (message("\"BackSpin\":-2500,\"SideSpin\":0"), top),
    ] {
        let (_, all, _) = fly_shots(Cursor::new(text.clone()));
        let refusal = all[0].shots[0]
            .refusal()
            .unwrap_or_else(|| panic!("{text} is flown"));
        assert!(
            refusal.kind == "out of range" && refusal.reason.contains(says),
            "{text}: {refusal:?}"
        );
    }
    // a ball that spins only about the vertical axis has no backspin
    assert_eq!(
        of_fly(&of_cells("Back Spin [rpm],Side Spin [rpm]", "0,800")).0,
        [1, 2]
    );
}

#[test]
fn exports_without_units_are_read_as_in_fly() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/data/shots/rapsodo.csv");
    let table = ShotTable::open(
        &Setup::modern_driver(),
        Path::new(file),
        RowFilter::default(),
        false,
    )
    .unwrap();
    let with_units = read(
        "Ball Speed [mph],Launch Angle [deg],Launch Direction [deg],Spin Rate [rpm],Spin Axis \
         [deg],Apex [ft],Carry Distance [yd],\
         Side Carry [yd],Descent Angle [deg]\n160,12,-1.5,2500,3,99,262,-4,37.5\n",
    );
    assert_eq!(table.shots[0].measured, with_units.shots[0].measured);
    assert_eq!(table.shots[0].inputs, with_units.shots[0].inputs);
    let sentence = "heads without a unit are read as Ball Speed in mph, Spin Rate in rpm, Apex in ft, \
                Carry Distance in yd, Side Carry in yd";
    assert!(remarks(&table).contains(sentence), "{}", remarks(&table));
    let (status, found) = json(&["delivery", "--shots", file]);
    assert!(
        status == 0 && found["rows"].as_array().unwrap().len() == 1,
        "{found}"
    );
}

#[test]
fn a_format_of_rows_that_a_json_answer_has_no_place_for_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let file = file_with(folder.path(), "shots.csv", &(HEAD.to_owned() + GOOD));
    for format in ["csv", "jsonl", "open-connect"] {
        let (status, answer) = json(&["fly", &file, "--format", format]);
        assert_eq!(
            (status, &answer["status"]),
            (2, &"error".into()),
            "{answer}"
        );
        let message = answer["message"].as_str().unwrap();
        assert!(message.starts_with("--format with --json"), "{message}");
    }
    let rows = folder.path().join("rows.txt").display().to_string();
    let (status, _) = json(&["fly", &file, "--format", "jsonl", "-o", &rows]);
    assert_eq!(status, 0);
}

/// A launch monitor that loses the ball writes zeros: neither the carry nor the side is measured. A
/// side of 0 beside a carry is measured.
#[test]
fn the_side_of_a_ball_without_a_carry_is_not_compared() {
    let text = format!("{HEAD}{GOOD}150,12,0,2600,3,0,0\n150,12,0,2600,3,245,0\n");
    let (_, all, _) = fly_shots(Cursor::new(text.clone()));
    let sides = all[0].shots.iter().map(|shot| shot.value(Outcome::Lateral));
    let sides: Vec<_> = sides.map(|side| side.map(|side| side.value)).collect();
    assert_eq!(sides, [Some(5.0 * 0.9144), None, Some(0.0)]);
    let note = "not compared: Side: 0 was not measured, since the carry of the row is 0 too";
    assert!(
        all[0].shots[1].notes.contains(&note.to_owned()),
        "{:?}",
        all[0].shots[1].notes
    );
    let table = read(&text);
    assert_eq!(rows(&table), [1, 3]);
    assert!(
        remarks(&table).contains("Side: 0 was not measured"),
        "{}",
        remarks(&table)
    );
}
