//! `sweep --points` and `calibrate` read tables with the same heads, and note the columns that they
//! ignore.

use crate::command_line::{json, longdrive, on_one_line};
use crate::common::close;
use crate::program::FORMATS;
use crate::sweep::table;
use longdrive::Setup;
use longdrive::table::open_table;

#[test]
fn a_table_of_a_head_alone_is_refused() {
    let (_folder, path) = table("empty.csv", "club.loft [deg]\n");
    let output = longdrive(&["sweep", "--points", path.to_str().unwrap()]);
    assert_eq!((output.status, output.out.as_str()), (2, ""));
    assert!(
        output.err.contains("empty.csv: it has a head and no rows"),
        "{}",
        output.err
    );
    let output = longdrive(&["calibrate", path.to_str().unwrap(), "--fit", "aero.cd0"]);
    assert!(
        output.status == 2 && output.err.contains("empty.csv"),
        "{}",
        output.err
    );
}

/// One launch in several spellings, with and without measured values.
#[test]
fn same_points_for_every_spelling_of_the_head() {
    let setup = Setup::modern_driver();
    let values = |text: &str| {
        let (_folder, path) = table("a.csv", text);
        let mut points =
            open_table(&setup, &path).unwrap_or_else(|error| panic!("{text}: {error}"));
        let names: Vec<_> = points
            .parameters()
            .iter()
            .map(|parameter| parameter.name)
            .collect();
        let notes: Vec<_> = points.notes().iter().map(ToString::to_string).collect();
        (
            names.join(" "),
            crate::sweep::all(points.as_mut()),
            notes.join("; "),
        )
    };
    let plain = values(
        "ball_speed [mph],launch_angle [deg],backspin [rpm]\n160.5,11.25,2686\n150,12,2500\n",
    );
    assert_eq!(
        (plain.0.as_str(), plain.2.as_str()),
        ("launch.ball_speed launch.launch_angle launch.backspin", "")
    );
    for text in [
        "ball_speed [mph];launch_angle [deg];backspin [rpm]\n160,5;11,25;2686\n150;12;2500\n",
        "ball_speed [mph]\tlaunch_angle [deg]\tbackspin [rpm]\n160.5\t11.25\t2686\n150\t12\t2500\n",
        "sep=;\r\nBall Speed [mph];Launch Angle [deg];Backspin \
         [rpm]\r\n160,5;11,25;2686\r\n150;12;2500\r\n",
        "\u{feff}# a remark\nBall Speed (mph),Launch V (deg),Back Spin \
         (rpm)\n160.5,11.25,\"2,686\"\n150,12,2500\n",
        "Ball Speed,Launch Angle,Backspin\n[mph],[deg],[rpm]\n160.5,11.25,2686\n150,12,2500\n",
        "launch.ball_speed [mph],launch.launch_angle [deg],launch.backspin \
         [rpm]\n160.5,11.25,2686\n150,12,2500\n",
    ] {
        let found = values(text);
        assert_eq!((&found.0, &found.2), (&plain.0, &plain.2), "{text}");
        for (ours, theirs) in found.1.iter().zip(&plain.1) {
            close(*ours, *theirs, theirs.abs(), 1e-15, text);
        }
        assert_eq!(found.1.len(), 6);
    }
    let export = "Player,Club Speed [mph],Ball Speed [mph],Launch Angle [deg],Backspin [rpm],Carry \
                  [yds]\n\
                  A,110,160.5,11.25,2686,270\nA,108,150,12,2500,265\nAverage,109,155,11.6,2600,267\n";
    let found = values(export);
    assert_eq!((&found.0, &found.1), (&plain.0, &plain.1));
    for says in [
        "Player",
        "Club Speed",
        "Carry",
        "rows left out, since they sum up other rows: row 3 (Average)",
    ] {
        assert!(found.2.contains(says), "{says}: {}", found.2);
    }
    // rows of an export are numbered as in the file, also where a row is invalid
    let (_folder, path) = table(
        "a.csv",
        "Shot,Ball Speed [mph],Launch Angle [deg],Backspin [rpm]\n\
         1,150,12,2500\nAverage,150,12,2500\n2,,12,2500\n",
    );
    let notes = open_table(&setup, &path).unwrap().notes();
    let notes: Vec<String> = notes.iter().map(ToString::to_string).collect();
    let notes = notes.concat();
    for says in ["row 2 (Average)", "row 3: launch.ball_speed is missing"] {
        assert!(notes.contains(says), "{says}: {notes}");
    }
    let (_folder, path) = table(
        "a.csv",
        "Ball Speed [mph],Launch Angle [deg],Backspin [rpm]\nAverage,1,2\n150,x,2500\n",
    );
    let message = open_table(&setup, &path).err().unwrap().to_string();
    assert!(
        message.contains("row 2, column Launch Angle: 'x' is not a number"),
        "{message}"
    );
}

#[test]
fn written_columns_are_read_again_and_ignored_ones_listed() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let launched = ["--points", "examples/launches.csv"];
    for (name, of) in [
        (
            "struck",
            &[
                "--over",
                "club.loft=8deg..12deg:3",
                "--over",
                "swing.speed=90mph..110mph:2",
            ][..],
        ),
        ("launched", &launched),
    ] {
        let all = ["--outcomes", "all", "--gradient"];
        for ending in FORMATS.iter().filter(|ending| **ending != "jsonl") {
            let (first, second) = (
                file(&format!("{name}-1.{ending}")),
                file(&format!("{name}-of-{ending}.csv")),
            );
            assert_eq!(
                longdrive(&[&["sweep", "-o", &first], of, &all].concat()).status,
                0
            );
            let output =
                longdrive(&[&["sweep", "-o", &second, "--points", &first], &all[..]].concat());
            assert_eq!(output.status, 0, "{name}.{ending}: {}", output.err);
            let sentence = on_one_line(&output.err);
            for says in [
                "columns not read, since they are results",
                "status",
                "carry",
                "d_carry/d_",
            ] {
                assert!(sentence.contains(says), "{says}: {sentence}");
            }
            let csv = std::fs::read(file(&format!("{name}-1.csv"))).unwrap();
            assert!(csv == std::fs::read(&second).unwrap(), "{name}.{ending}");
        }
        // calibrate reads computed values as measured values
        let args = [
            "calibrate",
            &file(&format!("{name}-1.csv")),
            "--fit",
            "aero.cd0",
        ];
        let output = longdrive(&args);
        let sentence = "columns that an earlier 'sweep' or 'fly' wrote are not read: status";
        assert!(
            output.status == 0 && on_one_line(&output.out).contains(sentence),
            "{}{}",
            output.out,
            output.err
        );
    }
    let (_folder, results) = table("results.csv", "status,carry [m]\nlanded,200\n");
    let output = longdrive(&["sweep", "--points", results.to_str().unwrap()]);
    assert!(
        output.status == 2 && output.err.contains("none of its columns is a parameter"),
        "{}",
        output.err
    );
    assert!(output.err.contains("status, carry"), "{}", output.err);
    let (_folder, both) = table(
        "both.csv",
        "club.loft [deg],swing.speed [mph],ball_speed [mph]\n10,100,150\n",
    );
    let (status, answer) = json(&[
        "sweep",
        "--points",
        both.to_str().unwrap(),
        "-o",
        &file("both.jsonl"),
    ]);
    assert_eq!((status, &answer["statuses"]["landed"]), (0, &1.into()));
}

#[test]
fn a_parameter_of_every_drive_is_not_set_beside_them() {
    let launch = [
        "--launch",
        "ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm",
    ];
    let cases = [
        &["--points", "examples/launches.csv", launch[0], launch[1]][..],
        &[
            "--points",
            "examples/deliveries.csv",
            "--set",
            "swing.speed=100mph",
        ],
        &[
            "--over",
            "club.loft=5deg..15deg:3",
            "--set",
            "club.loft=9deg",
        ],
    ];
    for case in cases {
        let output = longdrive(&[&["sweep"], case].concat());
        assert!(
            output.status == 2 && output.err.contains("of its own, so this one is not used"),
            "{case:?}: {}",
            output.err
        );
    }
}

/// A table that may have decimal commas: `2.500` is clear only if the other numbers of the table
/// show the decimal mark.
#[test]
fn numbers_of_two_meanings_are_refused_by_every_reader() {
    let table = |cells: [&str; 4]| {
        let [speed, angle, spin, carry] = cells;
        let head = "ball_speed [mph];launch_angle [deg];spin [rpm];carry [yd]";
        crate::sweep::table(
            "shots.csv",
            format!("{head}\n{speed};{angle};{spin};{carry}\n158;12;2600;245\n"),
        )
    };
    for (cells, sentence) in [
        // no other number has a mark of decimals or thousands
        (["160", "11", "2.500", "250"], Some(("spin", "2.500"))),
        (["160", "11", "2,500", "250"], Some(("spin", "2,500"))),
        // the mark of decimals, a mark of thousands beside decimal points, and marks that cannot
        // separate thousands
        (["160.5", "11", "2,500", "250"], None),
        (["160,5", "11", "2.500", "250"], None),
        (["160,5", "11", "2.500,5", "250"], None),
        (["160.5", "11.2", "2500.125", "250"], None),
        (["160,5", "11,2", "2500", "250,3"], None),
        (["160,5", "11.25", "2500", "0.250"], None),
    ] {
        let (folder, path) = table(cells);
        let path = path.to_str().unwrap();
        let flown = folder.path().join("flown.csv").display().to_string();
        for requested in [
            vec!["calibrate", path, "--fit", "aero.cd0"],
            vec!["delivery", "--shots", path],
            vec!["sweep", "--points", path, "--outcomes", "carry"],
            vec!["fly", path, "-o", &flown],
        ] {
            let output = longdrive(&requested);
            let mut said = on_one_line(&output.err);
            if requested[0] == "fly" {
                said = std::fs::read_to_string(&flown).unwrap_or(said);
            }
            let says = "may separate decimals or thousands";
            assert_eq!(
                said.contains(says),
                sentence.is_some(),
                "{requested:?}: {said}"
            );
            if let Some((column, cell)) = sentence {
                let place = format!("column {column}");
                let is_named = requested[0] == "fly"
                    || output.status == 2 && said.contains("row 1") && said.contains(&place);
                let mark = format!("the mark in '{cell}'");
                assert!(is_named && said.contains(&mark), "{requested:?}: {said}");
            }
        }
    }
}

#[test]
fn columns_that_only_a_later_section_has_are_named() {
    let launch = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm]";
    let text = format!("{launch}\n150,12,2500\n{launch},Launch Direction [deg]\n150,12,2500,3\n");
    let (_folder, path) = table("sections.csv", &text);
    let points = open_table(&Setup::modern_driver(), &path).unwrap();
    let notes: Vec<String> = points.notes().iter().map(ToString::to_string).collect();
    let says = "from line 3 on: columns not read, since the first column heads lack them: Launch \
                Direction";
    assert!(notes.contains(&says.to_owned()), "{notes:?}");
}

#[test]
fn ignored_columns_of_a_sweep_are_in_json_too() {
    let (folder, path) =
        crate::sweep::table("points.csv", "club.loft [deg],carry [yd],note\n10,240,x\n");
    let rows = folder.path().join("rows.csv");
    let requested = [
        "sweep",
        "--points",
        path.to_str().unwrap(),
        "-o",
        rows.to_str().unwrap(),
    ];
    let (status, answer) = json(&requested);
    let sentence = "columns not read, since they are results or remarks and not parameters of the \
                club: carry, note";
    assert_eq!(
        (status, &answer["remarks"]),
        (0, &serde_json::json!([sentence]))
    );
    let (_, answer) = json(&[
        "sweep",
        "--over",
        "club.loft=9deg..10deg:2",
        "-o",
        rows.to_str().unwrap(),
        "--overwrite",
    ]);
    assert_eq!(answer["remarks"], serde_json::json!([]));
}
