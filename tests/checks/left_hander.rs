//! A left-hander's drive is the mirror image of a right-hander's with equal numbers; wind and
//! ground are not mirrored.

use crate::command_line::{json, longdrive, number, on_one_line};
use crate::common::{close, random_setups};
use longdrive::derivative::hessian;
use longdrive::optimize::Observer;
use longdrive::parameters::{Golfer, SetupFile};
use longdrive::study::swings::{Correlation, Rule, Scenarios, Swings};
use longdrive::study::uncertainty::Uncertain;
use longdrive::study::{Comparison, Goal, Search, Sense, Vary, optimum};
use longdrive::{Drive, Outcome, Setup};

/// The outcomes whose sign is a side: right or left.
const SIDED: [Outcome; 5] = [
    Outcome::Lateral,
    Outcome::LateralTotal,
    Outcome::LaunchDirection,
    Outcome::Sidespin,
    Outcome::SpinAxis,
];

/// The setup of a left-hander with equal numbers, in a mirrored wind over mirrored ground.
fn mirrored(setup: &Setup<f64>) -> Setup<f64> {
    let mut other = Setup {
        golfer: Golfer::Left,
        ..*setup
    };
    (other.wind.right, other.ground.side_slope) = (-setup.wind.right, -setup.ground.side_slope);
    other
}

#[test]
fn exact_mirror_image_of_the_other_hand() {
    let mut compared = 0;
    for setup in random_setups(40) {
        let other = mirrored(&setup);
        let (Ok(right), Ok(left)) = (Drive::new(&setup), Drive::new(&other)) else {
            continue;
        };
        for of in Outcome::OF_DRIVES {
            let (Some(right), Some(left)) = (of.value(&right), of.value(&left)) else {
                continue;
            };
            let sign = if SIDED.contains(of) { -1.0 } else { 1.0 };
            close(left, sign * right, right.abs().max(1e-6), 1e-11, of.name());
            compared += 1;
        }
    }
    assert!(compared > 300, "{compared}");
}

#[test]
fn exact_derivatives_of_the_mirror_image() {
    let mut setup = Setup::preset("tour-average").unwrap();
    setup
        .set_all([
            ("strike.toe", "8 mm"),
            ("swing.path", "2 deg"),
            ("wind.right", "3 m/s"),
        ])
        .unwrap();
    let names = [
        "strike.toe",
        "swing.face_angle",
        "club.bulge_radius",
        "wind.right",
    ];
    let wrt = names.map(|name| setup.variable(name).unwrap());
    for (of, sign) in [(Outcome::Carry, 1.0), (Outcome::Lateral, -1.0)] {
        let [right, left] =
            [setup, mirrored(&setup)].map(|setup| hessian(&setup, of, &wrt).unwrap());
        // a wind to the right is positive for right- and left-handed golfers
        let turned = |i: usize| {
            if names[i] == "wind.right" {
                -sign
            } else {
                sign
            }
        };
        let most = |row: &[f64]| {
            row.iter()
                .fold(0.0, |most: f64, entry| most.max(entry.abs()))
        };
        for i in 0..names.len() {
            close(
                left.gradient[i],
                turned(i) * right.gradient[i],
                most(&right.gradient),
                1e-11,
                names[i],
            );
            for (j, name) in names.iter().enumerate() {
                let sign = turned(i) * turned(j) * sign;
                close(
                    left.hessian[i][j],
                    sign * right.hessian[i][j],
                    most(&right.hessian[i]),
                    1e-10,
                    name,
                );
            }
        }
    }
}

fn searched(setup: &Setup<f64>, goal: &str, vary: &[&str]) -> (f64, Vec<f64>) {
    let inputs = [
        "swing.path=normal(0 deg, 2 deg)",
        "swing.face_angle=normal(0 deg, 2 deg)",
        "strike.toe=normal(0 mm, 8 mm)",
    ];
    let inputs: Vec<_> = inputs
        .iter()
        .map(|text| Uncertain::read(setup, text).unwrap())
        .collect();
    let correlation = Correlation::new([inputs[0].parameter, inputs[1].parameter], 0.5).unwrap();
    let swings = Swings::distributed(inputs, &[correlation]).unwrap();
    let search = Search {
        of: Goal::read(goal, None).unwrap(),
        sense: Sense::Maximize,
        vary: vary
            .iter()
            .map(|text| Vary::read(setup, text).unwrap())
            .collect(),
        scenarios: Scenarios::new(&swings, Rule::Quadrature(4)).unwrap(),
        ..Search::largest(Outcome::Carry)
    };
    let best = optimum(setup, search, Observer::default()).unwrap();
    (best.value().unwrap(), best.solution.x)
}

/// With a symmetric head and symmetric strikes, drives to the right and to the left cancel, for
/// right- and left-handed golfers.
#[test]
fn exact_zero_lateral_mean_of_a_symmetric_head_and_strikes() {
    for golfer in Golfer::ALL {
        let setup = Setup {
            golfer,
            ..Setup::modern_driver()
        };
        let (lateral, _) = searched(&setup, "mean(lateral)", &["club.loft=9deg..9.1deg"]);
        assert!(lateral.abs() < 1e-10, "{golfer:?}: {lateral}");
    }
}

/// The best head of a left-hander in a mirrored wind is the mirror image of the best head of a
/// right-hander.
#[test]
fn exact_mirror_image_of_the_best_design() {
    let mut setup = Setup::preset("tour-average").unwrap();
    setup
        .set_all([("wind.right", "2 m/s"), ("club.inertia.xy", "300 g cm^2")])
        .unwrap();
    let vary = ["club.bulge_radius=200mm..900mm", "club.cg_depth=25mm..50mm"];
    let goal = "mean(carry) - 0.2*rms(lateral)";
    let (right, left) = (
        searched(&setup, goal, &vary),
        searched(&mirrored(&setup), goal, &vary),
    );
    close(left.0, right.0, right.0, 1e-11, "goal");
    for (left, right) in left.1.iter().zip(&right.1) {
        close(*left, *right, *right, 1e-7, "design");
    }
    // in an unmirrored wind the designs are not mirror images
    let same_wind = searched(
        &Setup {
            golfer: Golfer::Left,
            ..setup
        },
        goal,
        &vary,
    );
    assert!(
        (same_wind.0 - right.0).abs() > 0.01,
        "{} {}",
        same_wind.0,
        right.0
    );
}

#[test]
fn the_hand_is_read_written_and_compared() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("lefty.toml").display().to_string();
    std::fs::write(
        &file,
        "golfer = 'left'\npreset = 'tour-average'\n[strike]\ntoe = '10 mm'\n",
    )
    .unwrap();
    let (_, own) = json(&["simulate", &file]);
    let (_, set) = json(&[
        "simulate",
        "tour-average",
        "--set",
        "strike.toe=10mm",
        "--set",
        "golfer=left",
    ]);
    let (_, right) = json(&["simulate", "tour-average", "--set", "strike.toe=10mm"]);
    assert_eq!(
        (&own["flight"], &own["setup"]["golfer"]),
        (&set["flight"], &"left".into())
    );
    close(
        number(&own["flight"]["lateral"]),
        -number(&right["flight"]["lateral"]),
        1.0,
        1e-9,
        "lateral",
    );
    assert!(number(&right["flight"]["lateral"]).abs() > 0.1 && right["setup"]["golfer"] == "right");
    // the design of a left-hander is written for a left-hander
    let best = folder.path().join("best.toml").display().to_string();
    assert_eq!(longdrive(&["optimize", &file, "-o", &best]).status, 0);
    assert_eq!(
        SetupFile::open(best.as_ref()).unwrap().setup.golfer,
        Golfer::Left
    );

    for (args, output) in [
        (
            &["simulate", "--set", "golfer=lefty"][..],
            "did you mean 'left'",
        ),
        (&["optimize", "--vary", "golfer=0..1"], "it is a choice"),
        (
            &["simulate", "tour-average", "--set", "golfr=left"],
            "did you mean 'golfer'",
        ),
        (
            &[
                "simulate",
                "--launch",
                "ball_speed=150mph,launch_angle=12deg,backspin=2500rpm",
                "--set",
                "golfer=left",
            ],
            "strike and impact are not used",
        ),
    ] {
        let message = longdrive(args);
        let words = on_one_line(&message.err);
        assert!(
            message.status == 2 && words.contains(output),
            "{args:?}: {words}"
        );
    }
    let setup = SetupFile::open(file.as_ref()).unwrap().setup;
    let there = Comparison::new(
        &setup,
        &Setup {
            golfer: Golfer::Right,
            ..setup
        },
    )
    .unwrap();
    let shares = there.of(Outcome::Lateral).unwrap().by_parameter.shares;
    assert!(
        shares.len() == 1 && shares[0].cause.name() == "golfer" && shares[0].at_once,
        "{shares:?}"
    );
    close(
        shares[0].amount,
        2.0 * number(&right["flight"]["lateral"]),
        1.0,
        1e-6,
        "share",
    );
}

/// A launch monitor counts path and face angle as positive to the right, for every golfer. The
/// recovered delivery counts a path from in to out and an open face as positive, and for a
/// left-hander both of these are to the left.
#[test]
fn the_delivery_of_a_left_hander_is_in_left_handed_terms() {
    let folder = tempfile::tempdir().unwrap();
    let written = |name: &str, text: &str| {
        let file = folder.path().join(name);
        std::fs::write(&file, text).unwrap();
        file.display().to_string()
    };
    let head = "Ball Speed [mph],Launch Angle [deg],Launch Direction [deg],Spin Rate [rpm],Spin \
                Axis [deg],Club Path [deg],Face Angle [deg]";
    let right = written("right.csv", &format!("{head}\n150,12,2,2600,6,3.0,2.5\n"));
    let left = written(
        "left.csv",
        &format!("{head}\n150,12,-2,2600,-6,-3.0,2.5 L\n"),
    );
    let known = |file: &str, golfer: &str| {
        json(&["delivery", "--shots", file, "--set", golfer]).1["rows"][0]["known"].clone()
    };
    let (right, left) = (known(&right, "golfer=right"), known(&left, "golfer=left"));
    let rows = right
        .as_array()
        .unwrap()
        .iter()
        .zip(left.as_array().unwrap());
    for (right, left) in rows {
        assert_eq!(right["parameter"], left["parameter"]);
        close(
            number(&left["value"]),
            number(&right["value"]),
            1.0,
            1e-7,
            right["parameter"].as_str().unwrap(),
        );
    }
    assert!(number(&right[3]["value"]) > 0.02, "{right}");
}

/// Path and face of the club of the first shot in JSON lines of `fly`, rad, + right.
fn flown_club(file: &str, setup: &str) -> [f64; 2] {
    let lines = longdrive(&["fly", file, setup, "--format", "jsonl", "-o", "-"]);
    assert_eq!(lines.status, 0, "{}", lines.err);
    let line = lines.out.lines().next().unwrap();
    let shot: serde_json::Value = serde_json::from_str(line).unwrap();
    ["swing.path", "swing.face_angle"].map(|name| number(&shot["club"][name]))
}

/// Path and face that `delivery` reads for the first shot of a left-hander, rad, + in to out and
/// + open.
fn read_for_delivery(file: &str) -> [f64; 2] {
    let (_, answer) = json(&["delivery", "--shots", file, "--set", "golfer=left"]);
    let known = answer["rows"][0]["known"].as_array().unwrap().clone();
    ["swing.path", "swing.face_angle"].map(|name| {
        let own = known.iter().find(|own| own["parameter"] == name);
        number(&own.unwrap()["before"])
    })
}

/// All files state one shot of a left-hander: a path of 3° to the right (out to in) and a face of
/// 1° to the right (closed).
#[test]
fn exact_club_of_a_left_hander_from_every_format() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    let written = |name: &str, text: &str| {
        std::fs::write(path(name), text).unwrap();
        path(name)
    };
    let setup = written("left.toml", "golfer = 'left'\n");
    let heads = |club: [&str; 2], direction: &str| {
        let [path, face] = club;
        format!(
            "Club Speed (mph),Angle of Attack (deg),Club Path (deg{path}),Face to Target \
             (deg{face}),Ball Speed (mph),Launch Angle (deg),Push/Pull (deg{direction}),Spin Axis \
             (deg),Total Spin (rpm)\n"
        )
    };
    let file = |name: &str, club: [&str; 2], direction: &str, cells: [&str; 3]| {
        let [path, face, degrees] = cells;
        let row = format!("108.5,-1.2,{path},{face},160.0,12.0,{degrees},-8,2500\n");
        written(name, &(heads(club, direction) + &row))
    };
    let golfer_signs = [" out-in-/in-out+", " closed-/open+"];
    let right = file("right.csv", ["", ""], "", ["3.0", "1.0", "1.5"]);
    let mut files = vec![
        right.clone(),
        file(
            "stated.csv",
            golfer_signs,
            " L-/R+",
            ["-3.0", "-1.0", "1.5"],
        ),
        file("sides.csv", ["", ""], "", ["3.0 O-I", "1.0 C", "1.5 R"]),
        file(
            "left.csv",
            [" R-/L+", " L+/R-"],
            " R-/L+",
            ["-3.0", "-1.0", "-1.5"],
        ),
    ];
    for (name, format) in [
        ("shots.json", "open-connect"),
        ("shots.jsonl", "jsonl"),
        ("columns.csv", "launch-monitor"),
    ] {
        let output = longdrive(&["fly", &right, &setup, "--format", format, "-o", &path(name)]);
        assert_eq!(output.status, 0, "{}", output.err);
        files.push(path(name));
    }
    let right_of_target = [3.0_f64, 1.0].map(f64::to_radians);
    for file in files {
        for (own, expected) in flown_club(&file, &setup).iter().zip(right_of_target) {
            close(*own, expected, 1.0, 1e-8, &file);
        }
        for (own, expected) in read_for_delivery(&file).iter().zip(right_of_target) {
            close(*own, -expected, 1.0, 1e-8, &file);
        }
    }
}

#[test]
fn signs_that_no_column_has_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("shots.csv").display().to_string();
    for (signs, why) in [
        ("L-/X+", "[deg L-/X+] states signs that are not known"),
        ("closed-/open+", "states signs that do not fit the column"),
    ] {
        let text = format!(
            "Ball Speed (mph),Launch Angle (deg),Push/Pull (deg {signs}),Total Spin \
             (rpm)\n160,12,1.5,2500\n"
        );
        std::fs::write(&file, text).unwrap();
        let refused = longdrive(&["fly", &file]);
        let words = on_one_line(&refused.err);
        assert!(refused.status == 2 && words.contains(why), "{words}");
    }
}
