//! Balls launched with the values of a launch monitor, without a club.

use crate::command_line::{json, longdrive, number, on_one_line};
use crate::common::{all_blocks, close};
use longdrive::batch::{Batch, Status};
use longdrive::table::open_table;
use longdrive::{Drive, Error, Outcome, Setup, derivative};

/// The default setup with a launch of these conditions.
fn launched(settings: &[(&str, &str)]) -> Setup<f64> {
    let mut setup = Setup::modern_driver();
    for (name, text) in settings {
        setup.set(&format!("launch.{name}"), text).unwrap();
    }
    setup
}

const TOUR: [(&str, &str); 3] = [
    ("ball_speed", "167 mph"),
    ("launch_angle", "10.9 deg"),
    ("backspin", "2686 rpm"),
];

#[test]
fn exact_parabola_and_its_derivatives_by_the_launch() {
    let mut setup = launched(&[
        ("ball_speed", "60 m/s"),
        ("launch_angle", "0.3 rad"),
        ("backspin", "250 rad/s"),
    ]);
    setup.set("air.density", "0 kg/m^3").unwrap();
    setup.set("gravity", "9.8 m/s^2").unwrap();
    let wrt = [
        "launch.ball_speed",
        "launch.launch_angle",
        "launch.backspin",
    ];
    let wrt = wrt.map(|name| setup.variable(name).unwrap());
    // carry = v² sin 2θ/g
    let carry = derivative::gradient(&setup, Outcome::Carry, &wrt).unwrap();
    let exact = 3600.0 * 0.6_f64.sin() / 9.8;
    close(carry.value, exact, exact, 1e-12, "carry");
    close(
        carry.gradient[0],
        exact / 30.0,
        1.0,
        1e-11,
        "by ball speed: 2 carry/v",
    );
    close(
        carry.gradient[1],
        7200.0 * 0.6_f64.cos() / 9.8,
        1.0,
        1e-9,
        "by launch angle",
    );
    // without air a spin has no effect
    assert!(carry.gradient[2].abs() < 1e-12);
    assert!(
        setup
            .variable("swing.speed")
            .unwrap_err()
            .to_string()
            .contains("no club strikes the ball")
    );
    let second = derivative::hessian(&setup, Outcome::Carry, &wrt[..2]).unwrap();
    close(
        second.hessian[0][1],
        240.0 * 0.6_f64.cos() / 9.8,
        1.0,
        1e-9,
        "mixed",
    );
}

#[test]
fn same_flight_of_a_launch_and_of_the_club_that_makes_it() {
    let mut club = Setup::modern_driver();
    for (name, text) in [
        ("swing.path", "3 deg"),
        ("strike.toe", "8 mm"),
        ("wind.right", "4 m/s"),
    ] {
        club.set(name, text).unwrap();
    }
    let struck = Drive::new(&club).unwrap();
    let mut given = club;
    for of in [
        Outcome::BallSpeed,
        Outcome::LaunchAngle,
        Outcome::LaunchDirection,
        Outcome::Spin,
        Outcome::SpinAxis,
    ] {
        let condition = given.launch_condition(of.name()).unwrap();
        given.set_value(condition, of.value(&struck)).unwrap();
    }
    let flown = Drive::new(&given).unwrap();
    assert!(flown.impact.is_none());
    for of in Outcome::OF_DRIVES {
        let Some(value) = of.value(&flown) else {
            assert_eq!(*of, Outcome::SmashFactor, "without a club there is none");
            continue;
        };
        let exact = of.value(&struck).unwrap();
        close(value, exact, exact.abs().max(1.0), 1e-11, of.name());
    }
    let wrt = ["ball.mass", "air.density", "gravity"].map(|name| given.variable(name).unwrap());
    for wrt in [&wrt[..1], &wrt] {
        let error = derivative::gradient(&given, Outcome::SmashFactor, wrt).unwrap_err();
        assert!(
            error.to_string().contains("no club strikes the ball"),
            "{error}"
        );
    }
}

#[test]
fn an_incomplete_or_double_launch_is_refused() {
    for (settings, says) in [
        (&[("launch_angle", "10 deg")][..], "ball_speed is missing"),
        (&[("ball_speed", "160 mph")], "launch_angle is missing"),
        (&TOUR[..2], "the spin is missing"),
        (
            &[TOUR[0], TOUR[1], TOUR[2], ("spin", "2700 rpm")],
            "the spin is given twice: leave backspin or spin out, or unset the one of a setup file",
        ),
        (
            &[TOUR[0], TOUR[1], TOUR[2], ("spin_axis", "2 deg")],
            "with backspin, give sidespin",
        ),
        (
            &[
                TOUR[0],
                TOUR[1],
                ("spin", "2700 rpm"),
                ("sidespin", "9 rpm"),
            ],
            "with spin, give spin_axis",
        ),
    ] {
        let error = launched(settings).validate().unwrap_err();
        assert!(
            matches!(&error, Error::Launch { .. }) && error.to_string().contains(says),
            "{error}"
        );
    }
    launched(&TOUR).validate().unwrap();
}

#[test]
fn a_launch_on_the_command_line_and_in_a_table_is_the_same() {
    let launch = "ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm";
    let (status, found) = json(&["simulate", "--launch", launch]);
    assert_eq!((status, found["status"].as_str()), (0, Some("landed")));
    assert!(found["club_after"].is_null() && found["launch"]["smash_factor"].is_null());
    close(
        number(&found["launch"]["ball_speed"]),
        167.0 * 0.44704,
        1.0,
        1e-12,
        "ball speed",
    );
    let exact = Outcome::Carry
        .value(&Drive::new(&launched(&TOUR)).unwrap())
        .unwrap();
    assert_eq!(number(&found["flight"]["carry"]), exact);
    let (_, slopes) = json(&["gradient", "--launch", launch]);
    let by: Vec<_> = slopes["outcomes"][0]["gradient"]
        .as_object()
        .unwrap()
        .keys()
        .cloned()
        .collect();
    assert_eq!(
        by,
        [
            "launch.ball_speed",
            "launch.launch_angle",
            "launch.backspin"
        ]
    );
    let printed = longdrive(&["uncertainty", "--launch", launch, "--samples", "20"]);
    assert!(
        printed.out.contains("launch.ball_speed") && !printed.out.contains("swing.speed"),
        "{}",
        printed.out
    );
    let vary = [
        "--vary",
        "launch.launch_angle=5deg..30deg",
        "--vary",
        "launch.backspin=1000rpm..5000rpm",
    ];
    let (status, best) = json(&[&["optimize", "--launch", launch], &vary[..]].concat());
    assert_eq!((status, best["status"].as_str()), (0, Some("converged")));
    let printed = longdrive(&["simulate", "--launch", launch]);
    assert!(
        printed.status == 0 && !printed.out.contains("club"),
        "{}",
        printed.out
    );

    let text = "ball_speed [mph],launch_angle [deg],spin [rpm],spin_axis \
                [deg]\n167,10.9,2686,0\n150,12,3000,-10\n";
    let (_folder, path) = crate::sweep::table("monitor.csv", text);
    let setup = Setup::modern_driver();
    let mut points = open_table(&setup, &path).unwrap();
    let batch = Batch::new(
        &setup,
        points.parameters(),
        &[Outcome::Carry, Outcome::Lateral],
        &[],
    )
    .unwrap();
    let mut rows = vec![];
    for block in all_blocks(&batch, points.as_mut()) {
        rows.extend((0..block.rows()).map(|row| {
            (
                block.status(row),
                block.outcome(row, 0),
                block.outcome(row, 1),
            )
        }));
    }
    assert_eq!((rows[0].0, rows[1].0), (Status::Landed, Status::Landed));
    close(
        rows[0].1.unwrap(),
        exact,
        exact,
        1e-13,
        "carry of the same launch",
    );
    // a spin axis tilted to the left curves left
    assert!(rows[1].2.unwrap() < -5.0);

    let out = longdrive(&[
        "sweep",
        "--points",
        path.to_str().unwrap(),
        "--outcomes",
        "carry",
        "--gradient",
    ]);
    assert_eq!((out.status, out.out.lines().count()), (0, 3), "{}", out.err);
    let head = out.out.lines().next().unwrap();
    assert!(
        head.contains("launch.ball_speed") && head.contains("d_carry/d_launch.spin_axis"),
        "{head}"
    );

    let (_folder, part) =
        crate::sweep::table("part.csv", "ball_speed [mph],spin [rpm]\n167,2686\n");
    for (args, says) in [
        (
            vec!["sweep", "--points", part.to_str().unwrap()],
            "launch_angle is missing",
        ),
        (
            vec!["simulate", "--launch", "ball_sped=167mph"],
            "did you mean 'ball_speed'?",
        ),
        (
            vec!["simulate", "--launch", "ball_speed=167"],
            "has no unit",
        ),
        (
            vec!["simulate", "--launch", "ball_speed"],
            "write NAME=VALUE",
        ),
        (
            vec!["simulate", "--launch", "ball_speed=60m/s,ball_speed=70m/s"],
            "keep one of the two",
        ),
        (
            vec!["optimize", "--launch", launch],
            "--vary launch.launch_angle=5deg..20deg",
        ),
        (
            vec![
                "calibrate",
                "examples/shots.csv",
                "--fit",
                "aero.cd0",
                "--launch",
                launch,
            ],
            "from columns of the table",
        ),
    ] {
        let printed = longdrive(&args);
        assert_eq!(printed.status, 2, "{args:?} {}", printed.err);
        assert!(printed.err.contains(says), "{args:?}: {}", printed.err);
    }
}

/// Club settings would have no effect on a given launch, and are refused by name.
#[test]
fn a_club_beside_a_launch_is_refused_by_name() {
    let launch = "ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm";
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (plot, points, mine) = (file("a.svg"), file("points.csv"), file("mine.toml"));
    std::fs::write(
        &points,
        "ball_speed [mph],launch_angle [deg],backspin [rpm]\n167,10.9,2686\n",
    )
    .unwrap();
    let given = ["--launch", launch];
    for (command, is_given) in [
        (vec!["simulate"], true),
        (vec!["gradient"], true),
        (vec!["uncertainty", "--samples", "8"], true),
        (vec!["plot", "trajectory", "-o", &plot], true),
        (vec!["sweep", "--over", "gravity=9m/s^2..10m/s^2:2"], true),
        (vec!["sweep", "--points", &points], false),
        (
            vec![
                "sweep",
                "--over",
                "launch.ball_speed=60m/s..70m/s:2",
                "--set",
                "launch.launch_angle=9deg",
            ],
            false,
        ),
        (
            vec!["calibrate", "examples/shots.csv", "--fit", "aero.cd0"],
            false,
        ),
    ] {
        let given = if is_given { &given[..] } else { &[] };
        for name in [
            "club.loft=9deg",
            "swing.speed=90mph",
            "strike.toe=5mm",
            "impact.restitution=0.8",
        ] {
            let printed = longdrive(&[&command[..], given, &["--set", name]].concat());
            let parameter = name.split('=').next().unwrap();
            let message = format!("--set {parameter}: ");
            let is_partial = command.contains(&"launch.launch_angle=9deg");
            assert!(
                printed.status == 2 && (is_partial || printed.err.contains(&message)),
                "{command:?} {name}: {}",
                printed.err
            );
            assert!(
                is_partial
                    || printed
                        .err
                        .contains("swing, club, strike and impact are not used"),
                "{}",
                printed.err
            );
        }
        if !command.contains(&"launch.launch_angle=9deg") {
            let printed =
                longdrive(&[&command[..], given, &["--set", "air.density=1.1 kg/m^3"]].concat());
            assert_eq!(printed.status, 0, "{command:?}: {}", printed.err);
        }
    }
    // also refused: a table with two forms of the spin, and swept or fitted club parameters. If a
    // setup file has club settings, a note says that they are not used
    let both =
        "ball_speed [mph],launch_angle [deg],backspin [rpm],launch.spin [rpm]\n167,10.9,2686,1\n";
    std::fs::write(&points, both).unwrap();
    assert_eq!(longdrive(&["sweep", "--points", &points]).status, 2);
    let printed = longdrive(&[
        "sweep",
        "--points",
        "examples/deliveries.csv",
        "--launch",
        launch,
    ]);
    assert!(
        printed.status == 2 && printed.err.contains("no club strikes the ball"),
        "{}",
        printed.err
    );
    let printed = longdrive(&["calibrate", "examples/shots.csv", "--fit", "club.loft"]);
    assert!(
        printed.status == 2 && printed.err.contains("club.loft cannot be fitted"),
        "{}",
        printed.err
    );
    assert!(
        printed
            .err
            .replace("\n  ", " ")
            .contains("fit parameters of the flight"),
        "{}",
        printed.err
    );
    std::fs::write(
        &mine,
        "[club]\nloft = '9 deg'\n[air]\ndensity = '1.1 kg/m^3'\n",
    )
    .unwrap();
    let printed = longdrive(&["simulate", &mine, "--launch", launch]);
    let message = "not used, since the drive is given by its launch: club.loft";
    assert!(
        printed.status == 0 && printed.err.replace("\n  ", " ").contains(message),
        "{}",
        printed.err
    );
    assert!(!longdrive(&["simulate", &mine]).err.contains("not used"));
}

/// A report of a launch does not describe a club. It has an optimum only if a parameter is varied.
#[test]
fn a_report_of_a_launch_names_omitted_parts() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let launch = "ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm";
    let report = |output: &str, more: &[&str]| {
        let printed = json(&[&["report", "--launch", launch, "-o", output], more].concat());
        let files: Vec<_> = printed.1["files"]
            .as_array()
            .into_iter()
            .flatten()
            .cloned()
            .collect();
        let text = std::fs::read_to_string(format!("{output}/index.html")).unwrap_or_default();
        (printed.0, files, printed.1["warnings"].to_string(), text)
    };
    let (status, files, warnings, page) = report(&file("alone"), &[]);
    assert_eq!(status, 0, "{warnings}");
    for name in [
        "trajectory-side.csv",
        "tornado-carry-control.csv",
        "tornado-carry-model.csv",
        "vcurve.csv",
    ] {
        assert!(files.contains(&name.into()), "{name}: {files:?}");
    }
    let message =
        "the optimum, its map and its chart are left out: the drive is given by its launch";
    assert!(
        warnings.contains(message) && page.contains(message),
        "{warnings}"
    );
    assert!(page.contains("d carry/d launch.backspin") && !page.contains("swing.speed"));

    let vary = [
        "--vary",
        "launch.launch_angle=5deg..20deg",
        "--vary",
        "launch.backspin=1500rpm..4000rpm",
    ];
    let along = ["--along", "launch.ball_speed=160mph..162mph"];
    let (status, files, warnings, page) = report(&file("varied"), &[&vary[..], &along].concat());
    assert!(status == 0 && !warnings.contains("left out"), "{warnings}");
    assert!(
        files.contains(&"chart-carry-by-launch-ball_speed.csv".into())
            && page.contains("The optimum"),
        "{files:?}"
    );

    for more in [&["--subject-to", "apex_height <= 30 yd"][..], &along] {
        let printed =
            longdrive(&[&["report", "--launch", launch, "-o", &file("none")], more].concat());
        assert!(
            printed.status == 2
                && printed.err.contains(more[0])
                && printed.err.contains("give --vary"),
            "{}",
            printed.err
        );
    }
}

/// The launch of [`TOUR`] as an option.
const CONDITIONS: [&str; 2] = [
    "--launch",
    "ball_speed=167mph,launch_angle=10.9deg,backspin=2686rpm",
];

#[test]
fn values_replaced_by_another_form_of_the_spin_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("ax.toml").display().to_string();
    let launch =
        "ball_speed = '160 mph'\nlaunch_angle = '11 deg'\nspin = '2600 rpm'\nspin_axis = '5 deg'\n";
    std::fs::write(&file, format!("[launch]\n{launch}")).unwrap();
    let message = |more: &[&str]| {
        let printed = longdrive(&[&["simulate", &file], more].concat());
        assert_eq!(printed.status, 0, "{}", printed.err);
        on_one_line(&printed.err)
    };
    let err = message(&["--launch", "backspin=2400rpm"]);
    assert!(
        err.contains("ax.toml are replaced by --launch backspin=2400rpm")
            && err.contains("spin and spin_axis of ")
    );
    assert!(!message(&["--launch", "spin=2400rpm"]).contains("replaced"));
    assert!(!message(&[]).contains("replaced"));
    // the gradient has a derivative by every given condition, including the tilt of the spin axis
    let by = json(&["gradient", &file]).1.to_string();
    for name in ["ball_speed", "launch_angle", "spin", "spin_axis"] {
        assert!(by.contains(&format!("launch.{name}\"")), "{name}: {by}");
    }
}

#[test]
fn without_a_club_the_defaults_are_launch_conditions_or_the_message_suggests_variables() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).display().to_string();
    let (curves, map, chart) = (file("v.csv"), file("map.svg"), file("chart.svg"));
    let printed = longdrive(&[&["plot", "vcurve", "-o", &curves], &CONDITIONS[..]].concat());
    assert_eq!(printed.status, 0, "{}", printed.err);
    let curves = std::fs::read_to_string(&curves).unwrap();
    assert!(
        curves.contains("launch.launch_angle") && curves.contains("launch.backspin"),
        "{curves}"
    );
    let along = ["--along", "launch.ball_speed=150mph..170mph"];
    for args in [
        vec!["optimize"],
        vec!["optimum-sensitivity"],
        vec!["sensitivity", "--at-optimum"],
        vec!["chart", along[0], along[1]],
        vec!["plot", "contour", "-o", &map],
        vec!["plot", "chart", along[0], along[1], "-o", &chart],
    ] {
        let printed = longdrive(&[&args[..], &CONDITIONS[..]].concat());
        let err = on_one_line(&printed.err);
        assert_eq!(
            (printed.status, printed.out.as_str()),
            (2, ""),
            "{args:?}: {err}"
        );
        for words in [
            "the drive is given by its launch",
            "--vary launch.launch_angle=5deg..20deg",
        ] {
            assert!(err.contains(words), "{args:?}: {err}");
        }
        assert!(!err.contains("club.loft"), "{args:?}: {err}");
    }
    // `calibrate` reads the launches from its table, and refuses `--launch`
    let printed = longdrive(
        &[
            &["calibrate", "shots.csv", "--fit", "aero.cd0"],
            &CONDITIONS[..],
        ]
        .concat(),
    );
    for words in [
        "from columns of the table",
        "add the columns to shots.csv",
        "ball_speed, launch_angle",
    ] {
        assert!(
            printed.status == 2 && printed.err.contains(words),
            "{}",
            printed.err
        );
    }
    // the page does not describe the club of the preset
    let page = file("page");
    let printed = longdrive(&[&["report", "-o", &page], &CONDITIONS[..]].concat());
    assert_eq!(printed.status, 0, "{}", printed.err);
    let page = std::fs::read_to_string(folder.path().join("page/index.html")).unwrap();
    assert!(
        page.contains("The ball leaves as its launch says, without a club")
            && !page.contains("at 110 mph")
    );
}

#[test]
fn a_parameter_that_is_set_twice_is_refused() {
    for [first, second] in [
        ["club.loft=10deg", "club.loft=11deg"],
        ["aero.law=linear", "aero.law = robinson"],
    ] {
        let printed = longdrive(&["simulate", "--set", first, "--set", second]);
        assert_eq!(
            (printed.status, printed.out.as_str()),
            (2, ""),
            "{}",
            printed.err
        );
        assert!(
            printed.err.contains(&format!("--set {first} gives "))
                && printed.err.contains("keep one of the two")
        );
    }
}

/// A sweep over one launch condition, with the other conditions on the command line or in a file.
/// Each row equals a single drive with the same launch.
#[test]
fn same_drives_of_a_swept_launch_condition_and_alone() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("angles.csv").display().to_string();
    std::fs::write(&file, "launch_angle [deg]\n8\n12\n").unwrap();
    let launch = [
        "--launch",
        "ball_speed=160mph,backspin=2500rpm",
        "--outcomes",
        "carry",
        "--own-step",
    ];
    let carries = |points: &[&str]| -> Vec<f64> {
        let printed = longdrive(&[&["sweep"], points, &launch].concat());
        assert_eq!(printed.status, 0, "{points:?}: {}", printed.err);
        printed
            .out
            .lines()
            .skip(1)
            .map(|row| row.rsplit(',').next().unwrap().parse().unwrap())
            .collect()
    };
    let exact = ["8deg", "12deg"].map(|angle| {
        let whole = format!("ball_speed=160mph,backspin=2500rpm,launch_angle={angle}");
        json(&["simulate", "--launch", &whole]).1["flight"]["carry"]
            .as_f64()
            .unwrap()
    });
    for points in [
        &["--over", "launch.launch_angle=8deg..12deg:2"][..],
        &["--points", &file],
    ] {
        for (ours, theirs) in carries(points).iter().zip(exact) {
            close(*ours, theirs, theirs, 1e-12, "carry");
        }
    }
    // missing conditions are named, and so are duplicate ones
    for (args, says) in [
        (
            ["--over", "launch.spin_axis=0deg..5deg:2"],
            "launch_angle is missing",
        ),
        (
            ["--over", "launch.ball_speed=60m/s..70m/s:2"],
            "a value of its own",
        ),
    ] {
        let printed = longdrive(&[&["sweep"], &args[..], &launch].concat());
        assert!(
            printed.status == 2 && printed.err.contains(says),
            "{args:?}: {}",
            printed.err
        );
    }
}

/// A ball without spin has no spin axis: an error, not a NaN.
#[test]
fn an_outcome_without_a_finite_value_is_an_error() {
    let mut setup = Setup::preset("tour-average").unwrap();
    setup
        .set_all([
            ("launch.ball_speed", "70 m/s"),
            ("launch.launch_angle", "12 deg"),
            ("launch.spin", "0 rpm"),
        ])
        .unwrap();
    let drive = Drive::new(&setup).unwrap();
    let error = Outcome::SpinAxis.of(&drive).unwrap_err();
    assert!(
        error.to_string().contains("the ball does not spin"),
        "{error}"
    );
    assert_eq!(Outcome::SpinAxis.value(&drive), None);
    assert!(Outcome::Spin.of(&drive).unwrap() == 0.0);
}

/// A launch direction or spin axis that the launch does not give counts as 0, with the uncertainty
/// of a measured one: who measures less is not less uncertain.
#[test]
fn same_uncertainty_of_an_unset_direction_and_of_a_direction_of_zero() {
    let spins = [("backspin", "sidespin=0rpm"), ("spin", "spin_axis=0deg")];
    for (spin, axis) in spins {
        let given = format!("ball_speed=167mph,launch_angle=10.9deg,{spin}=2686rpm");
        let whole = format!("{given},launch_direction=0deg,{axis}");
        let name = axis.split('=').next().unwrap();
        let commands: [&[&str]; 2] = [
            &["uncertainty", "--samples", "64"],
            &["sensitivity", "--of", "lateral"],
        ];
        for command in commands {
            let of = |launch: &str| json(&[command, &["--launch", launch]].concat()).1;
            let (assumed, stated) = (of(&given), of(&whole));
            assert_eq!(assumed["outcomes"], stated["outcomes"], "{command:?}");
            let err = longdrive(&[command, &["--launch", &given]].concat()).err;
            let note = on_one_line(&err);
            assert!(
                note.contains("launch.launch_direction is missing: 0° is assumed")
                    && note.contains(&format!("launch.{name} is missing: 0")),
                "{note}"
            );
        }
    }
}
