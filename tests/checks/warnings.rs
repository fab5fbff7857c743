//! Warnings about a drive beyond the fitted range of its law or with a strike beside the face.
//! Usual drives have no warning.

use crate::command_line::{json, longdrive, on_one_line};
use crate::common::{RIGID, SET_RIGID_TOUR};
use longdrive::atmosphere::WindField;
use longdrive::batch::{Batch, Status, StatusCounts};
use longdrive::optimize::Observer;
use longdrive::parameters::PRESETS;
use longdrive::study::{Optimum, Search, optimum};
use longdrive::{Drive, Outcome, Setup};
use std::sync::atomic::AtomicBool;

fn warnings(preset: &str, settings: &[(&str, &str)]) -> Vec<String> {
    let mut setup = Setup::preset(preset).unwrap();
    setup.set_all(settings.iter().copied()).unwrap();
    Drive::new(&setup)
        .unwrap()
        .warnings_about(&setup, &[])
        .iter()
        .map(ToString::to_string)
        .collect()
}

/// The expected changes are from another integration of the equation of motion, which holds the
/// airspeed or the spin of `bearman-harvey` at the end of its range. The law is stated in airspeed
/// and spin, so the held airspeed keeps the spin. Below the least spin the law is not held: its
/// lift falls to 0.
#[test]
fn independent_change_of_the_carry_with_a_law_of_airspeed_and_spin_held() {
    let law = ("aero.law", "bearman-harvey");
    let fast = [
        law,
        ("launch.ball_speed", "185 mph"),
        ("launch.launch_angle", "10 deg"),
        ("launch.spin", "4500 rpm"),
        ("wind.downrange", "-20 m/s"),
    ];
    let slow_spin = [
        law,
        ("launch.ball_speed", "170 mph"),
        ("launch.launch_angle", "12 deg"),
        ("launch.spin", "300 rpm"),
    ];
    for (settings, change) in [
        (&fast[..], "the carry would be 1.9 yd shorter"),
        (&slow_spin, "the carry would be 72 yd longer"),
    ] {
        let said = warnings("tour-average", settings);
        assert!(said.iter().any(|text| text.contains(change)), "{said:?}");
    }
}

#[test]
fn a_wind_profile_without_effect_has_a_warning() {
    let warnings_of_wind = |set: &[&str]| {
        let args: Vec<&str> = set.iter().flat_map(|text| ["--set", text]).collect();
        longdrive(&[&["simulate"], &args[..]].concat())
            .err
            .replace("\n  ", " ")
    };
    let blows = "wind.downrange=5m/s";
    for (set, message) in [
        (
            &["wind.roughness=30mm"][..],
            "wind.roughness has no effect: there is no wind",
        ),
        (
            &["wind.reference_height=3m", blows],
            "wind.reference_height has no effect: without wind.roughness",
        ),
        (
            &["wind.reference_height=1m", "wind.roughness=5m", blows],
            "is not above wind.roughness",
        ),
    ] {
        assert!(
            warnings_of_wind(set).contains(message),
            "{set:?}: {}",
            warnings_of_wind(set)
        );
    }
    let sound = warnings_of_wind(&["wind.roughness=30mm", blows]);
    assert!(!sound.contains("wind."), "{sound}");
    // no warning: a wind is swept, so the roughness has an effect; a roughness is swept, so the
    // reference height has an effect
    let (rough, high) = ("wind.roughness=30mm", "wind.reference_height=3m");
    for args in [
        &[
            "sweep",
            "--set",
            rough,
            "--over",
            "wind.downrange=-5m/s..5m/s:3",
        ][..],
        &[
            "sweep",
            "--set",
            high,
            "--set",
            blows,
            "--over",
            "wind.roughness=1mm..30mm:3",
        ],
        &[
            "chart",
            "--set",
            rough,
            "--along",
            "wind.downrange",
            "--at",
            "-3m/s,3m/s",
        ],
        &[
            "uncertainty",
            "--set",
            rough,
            "--sigma",
            "wind.downrange=2m/s",
            "--samples",
            "64",
        ],
        &[
            "optimize",
            "--set",
            rough,
            "--distribution",
            "wind.downrange=normal(0m/s,2m/s)",
        ],
        &["compare", "--set", rough, "--set-b", blows],
    ] {
        let output = longdrive(args);
        assert!(
            output.status == 0 && !output.err.contains("has no effect"),
            "{args:?}: {}",
            output.err
        );
    }
}

/// The printed shift is the difference between two drives, one in steps of half the length.
#[test]
fn a_step_that_changes_the_landing_has_a_warning_with_the_shift() {
    let carry = |step: &str| {
        let mut setup = Setup::preset("modern-driver").unwrap();
        setup.set("flight.step", step).unwrap();
        Outcome::Carry.of(&Drive::new(&setup).unwrap()).unwrap()
    };
    let shift = 1e3 * (carry("1s") - carry("0.5s")).abs();
    let message = &warnings("modern-driver", &[("flight.step", "1s")])[0];
    let stated: f64 = message
        .split("the landing shifts by ")
        .nth(1)
        .and_then(|rest| rest.split(" mm").next())
        .unwrap()
        .parse()
        .unwrap();
    assert!(
        message.contains("flight.step = 1 s is long for the method rk4"),
        "{message}"
    );
    assert!(
        (stated - shift).abs() <= 0.05 * shift && shift > 1.5,
        "{message}: {shift}"
    );
    for settings in [
        &[("flight.step", "0.2s")][..],
        &[("flight.step", "1s"), ("flight.method", "dp8")],
    ] {
        assert_eq!(warnings("modern-driver", settings), [""; 0], "{settings:?}");
    }
}

#[test]
fn presets_and_their_longest_drives_have_no_warning() {
    for preset in PRESETS {
        let setup = Setup::preset(preset.name).unwrap();
        let best = optimum(
            &setup,
            Search::longest_drive(&setup).unwrap(),
            Observer::default(),
        )
        .unwrap();
        let at_best = best
            .drive
            .unwrap()
            .warnings_about(&best.setup, &[])
            .iter()
            .map(ToString::to_string)
            .collect();
        for found in [warnings(preset.name, &[]), at_best] {
            // an amateur's ball is slower than the fitted range of the law
            let of_the_law =
                found.len() == 1 && found[0].contains("fitted to a Reynolds number of 70000");
            assert!(
                found.is_empty() || preset.name == "amateur-average" && of_the_law,
                "{}: {found:?}",
                preset.name
            );
        }
    }
}

/// With nearly no air and no spin decay, the path is a parabola. The spin ratio s = Rω/v is below
/// 0.02 while v > v* = Rω/0.02. That is the fraction 1 − √(v*² − v_h²)/v_v of the flight time,
/// where v_h and v_v are the horizontal and the vertical velocity at launch.
#[test]
fn share_of_the_flight_outside_the_fitted_range_of_the_law() {
    let (ahead, up, at_edge) = (50.0_f64, 30.0_f64, 53.0_f64);
    let mut setup = Setup::modern_driver();
    setup
        .set_all([
            ("aero.law", "ferguson"),
            ("air.density", "1e-9 kg/m^3"),
            ("aero.spin_decay", "0 1/s"),
        ])
        .unwrap();
    setup.launch.ball_speed = Some(ahead.hypot(up));
    setup.launch.launch_angle = Some(up.atan2(ahead));
    setup.launch.backspin = Some(0.02 * at_edge / setup.ball.radius);
    let drive = Drive::new(&setup).unwrap();
    let share = 1.0 - (at_edge * at_edge - ahead * ahead).sqrt() / up;
    let [low, high] = [ahead.hypot(up), ahead].map(|speed| 0.02 * at_edge / speed);
    let spin_ratio = drive.flown_ranges(&setup, &AtomicBool::new(false))[0].unwrap();
    assert!((spin_ratio.outside - share).abs() < 0.01, "{spin_ratio:?}");
    for (flown, exact) in spin_ratio.flown.into_iter().zip([low, high]) {
        assert!((flown - exact).abs() < 1e-4 * exact, "{spin_ratio:?}");
    }
    // in such thin air the law hardly changes the carry, so there is no warning about its range
    assert!(drive.warnings_about(&setup, &[]).is_empty());
    assert!(drive.extrapolated_carry(&setup).is_none());
}

/// The law `lyu` is extrapolated below its fitted range of the spin ratio. Above the range, the
/// spin ratio is held at its end.
#[test]
fn a_range_exceeded_at_both_ends_has_the_carry_from_its_extrapolated_end() {
    let found = warnings(
        "modern-driver",
        &[
            ("aero.law", "lyu"),
            ("launch.ball_speed", "80 m/s"),
            ("launch.launch_angle", "80 deg"),
            ("launch.backspin", "573 rpm"),
        ],
    );
    let of_spin_ratio = found.iter().find(|it| it.contains("a spin ratio of 0.045"));
    assert!(
        of_spin_ratio.is_some_and(|it| it.contains(
            "where the law is extrapolated or held; with the law held at the end of its range the \
             carry would be "
        )),
        "{found:?}"
    );
}

#[test]
fn each_law_names_its_fitted_range() {
    let slow = [
        ("aero.law", "winfield-tan"),
        ("swing.speed", "30 mph"),
        ("club.loft", "14 deg"),
    ];
    let found = warnings("modern-driver", &slow);
    assert!(
        found
            .iter()
            .any(|it| it.contains("speed through the air of 25 m/s to 68 m/s")),
        "{found:?}"
    );
    let low_spin = [
        ("launch.ball_speed", "170 mph"),
        ("launch.launch_angle", "12 deg"),
        ("launch.backspin", "1200 rpm"),
    ];
    let found = warnings("modern-driver", &low_spin);
    assert!(
        found
            .iter()
            .any(|it| it.contains("spin ratio of 0.06 to 0.33")),
        "{found:?}"
    );
    let found = warnings(
        "modern-driver",
        &[("aero.law", "smits-smith"), ("swing.speed", "140 mph")],
    );
    assert!(
        found.iter().any(|it| it.contains("the law smits-smith")),
        "{found:?}"
    );
    // without air no law applies; a law without a known fitted range gives no warning
    assert!(
        warnings(
            "modern-driver",
            &[
                ("swing.speed", "30 mph"),
                ("club.loft", "14 deg"),
                ("air.density", "0 kg/m^3")
            ]
        )
        .is_empty()
    );
    assert!(
        warnings(
            "modern-driver",
            &[
                ("swing.speed", "30 mph"),
                ("club.loft", "14 deg"),
                ("aero.law", "linear")
            ]
        )
        .is_empty()
    );
}

#[test]
fn a_strike_beside_the_face_has_a_warning_on_standard_error_and_in_json() {
    let on_the_face = [("strike.toe", "30 mm"), ("strike.high", "-20 mm")];
    assert!(
        warnings("modern-driver", &on_the_face)
            .iter()
            .all(|it| !it.contains("strike.toe"))
    );
    let command = ["simulate", "modern-driver", "--set", "strike.toe=70mm"];
    let text = longdrive(&command);
    let message = "strike.toe = 70 mm and strike.high = 0 mm lie outside the face";
    assert!(
        text.status == 0 && text.err.contains(message),
        "{}",
        text.err
    );
    for command in [
        command.to_vec(),
        vec![
            "gradient",
            "modern-driver",
            "--set",
            "strike.toe=70mm",
            "--of",
            "carry",
            "--wrt",
            "club.loft",
        ],
    ] {
        let (_, answer) = json(&command);
        let warnings = answer["warnings"].as_array().unwrap();
        assert!(
            warnings
                .iter()
                .any(|it| it.as_str().unwrap().contains(message)),
            "{answer}"
        );
    }
}

/// The spin ratio at launch is s = Rω/v. Faster balls than v = Rω/0.06 have an s below 0.06, the
/// lower end of the fitted range of the law.
#[test]
fn same_count_of_a_sweep_for_any_threads() {
    let folder = tempfile::tempdir().unwrap();
    let setup = Setup::modern_driver();
    let edge = setup.ball.radius * 2500.0 * std::f64::consts::TAU / 60.0 / 0.06;
    let points: Vec<f64> = (0..5000).map(|k| 60.0 + 0.01 * f64::from(k)).collect();
    let outside = points.iter().filter(|speed| **speed > edge).count();
    assert!((1000..4000).contains(&outside), "{outside}");
    let table = folder.path().join("points.csv");
    let rows: String = points
        .iter()
        .map(|speed| format!("{speed},12,2500\n"))
        .collect();
    std::fs::write(
        &table,
        format!("ball_speed [m/s],launch_angle [deg],backspin [rpm]\n{rows}"),
    )
    .unwrap();
    let message = format!(
        "{outside} of 5000 drives that landed: the launch is outside of the ranges that the law \
         launch-monitor"
    );
    for threads in ["1", "2"] {
        let output = folder.path().join(format!("{threads}.csv"));
        let (table, output) = (table.to_str().unwrap(), output.to_str().unwrap());
        // this air is so viscous that all Reynolds numbers are within the range of the law
        let thick = [
            "--set",
            "air.viscosity=3e-5 Pa.s",
            "--threads",
            threads,
            "-o",
            output,
        ];
        let (status, answer) = json(&[&["sweep", "--points", table][..], &thick].concat());
        let warnings = answer["warnings"].as_array().unwrap();
        assert!(status == 0 && warnings.len() == 1, "{answer}");
        assert!(
            warnings[0].as_str().unwrap().contains(&message),
            "{message}: {answer}"
        );
    }
}

/// Compares the validity limits (spin ratio, Reynolds number, speed) that a row of a batch exceeds
/// with values from its launch: in wind, with and without gradients.
#[test]
fn exact_validity_limits_of_a_batch_by_their_definitions() {
    let mut setup = Setup::modern_driver();
    setup
        .set_all([
            ("wind.downrange", "5 m/s"),
            ("wind.right", "-3 m/s"),
            ("wind.roughness", "10 mm"),
        ])
        .unwrap();
    for law in ["launch-monitor", "smits-smith", "winfield-tan", "linear"] {
        setup.set_law(law).unwrap();
        let swept =
            ["swing.speed", "club.loft", "strike.toe"].map(|name| setup.variable(name).unwrap());
        let ranges = [(8.0, 60.0), (0.02, 0.5), (-0.08, 0.08)];
        let at = |k: u32| {
            ranges.map(|(low, high): (f64, f64)| {
                low + (high - low) * (f64::from(k) * low.abs().sqrt()).fract()
            })
        };
        let points: Vec<f64> = (1..400).flat_map(at).collect();
        for wrt in [&swept[..0], &swept[..2]] {
            let batch = Batch::new(&setup, &swept, &[Outcome::Carry], wrt).unwrap();
            let block = batch.evaluate(0, points.clone());
            let (mut status_counts, mut outside, mut landed) = (StatusCounts::default(), 0, 0);
            status_counts.add(&block);
            for row in 0..block.rows() {
                let [speed, loft, toe] = block.point(row) else {
                    panic!()
                };
                if block.status(row) != Status::Landed {
                    continue;
                }
                landed += 1;
                let mut one = setup;
                (one.swing.speed, one.club.loft, one.strike.toe) = (*speed, *loft, *toe);
                let launch = Drive::new(&one).unwrap().launch;
                let wind = WindField::new(&one.wind, &one.ground).at(0.0);
                let v = [
                    launch.velocity.x - wind.x,
                    launch.velocity.y - wind.y,
                    launch.velocity.z - wind.z,
                ];
                let v = v.iter().map(|v| v * v).sum::<f64>().sqrt();
                let stream = [
                    one.ball.radius * launch.total_spin() / v,
                    one.air.density * 2.0 * one.ball.radius * v / one.air.viscosity,
                    v,
                ];
                let is_within = |[low, high]: [f64; 2], value: f64| low <= value && value <= high;
                let within = match law {
                    "launch-monitor" => {
                        is_within([0.06, 0.33], stream[0]) && is_within([7e4, 2.3e5], stream[1])
                    }
                    "smits-smith" => {
                        is_within([0.08, 0.2], stream[0]) && is_within([7e4, 2.1e5], stream[1])
                    }
                    "winfield-tan" => {
                        is_within([0.02, 0.35], stream[0]) && is_within([25.0, 68.0], stream[2])
                    }
                    _ => true,
                };
                let found = block.exceeded(row);
                assert_eq!(
                    (found.law, found.face),
                    (!within, toe.abs() > 0.0635),
                    "{law}, row {row}: {stream:?}"
                );
                outside += u64::from(!within);
            }
            assert!(
                landed > 100 && (outside > 20 || law == "linear"),
                "{law}: {outside} of {landed}"
            );
            let exceeded = status_counts.exceeded();
            assert_eq!((exceeded.all, exceeded.limits.law), (landed, outside));
        }
    }
}

#[test]
fn charts_and_calibrations_count_drives_beyond_the_law() {
    let (status, chart) = json(&[
        "chart",
        "--set",
        "aero.law=smits-smith",
        "--along",
        "swing.speed=140mph..145mph",
    ]);
    let points = chart["points"].as_array().unwrap().len();
    let message = format!(
        "{points} of {points} optima: the flight leaves the ranges that the law smits-smith"
    );
    assert!(
        status == 0 && chart["warnings"][0].as_str().unwrap().starts_with(&message),
        "{message}: {chart}"
    );
    let (_, usual) = json(&["chart", "--along", "swing.speed", "--at", "105mph,110mph"]);
    assert_eq!(usual["warnings"].as_array().unwrap().len(), 0, "{usual}");

    let mut table = tempfile::Builder::new().suffix(".csv").tempfile().unwrap();
    let rows = "160,12,2600,250\n150,12,2500,240\n170,12,1200,260\n";
    std::io::Write::write_all(
        &mut table,
        format!("ball_speed [mph],launch_angle [deg],backspin [rpm],carry [yd]\n{rows}").as_bytes(),
    )
    .unwrap();
    let (_, found) = json(&[
        "calibrate",
        table.path().to_str().unwrap(),
        "--fit",
        "aero.cd0",
    ]);
    assert!(
        found["warnings"][0]
            .as_str()
            .unwrap()
            .starts_with("1 of 3 shots: the flight leaves the ranges"),
        "{found}"
    );
}

/// Drives that are launched downwards have a ball speed, but no carry.
#[test]
fn drives_without_a_landing_have_a_warning_if_the_flight_is_requested() {
    let spread = [
        "uncertainty",
        "--distribution",
        "swing.attack_angle=normal(-8deg,6deg)",
        "--samples",
        "400",
        "--of",
    ];
    let says = "% of the drives do not land";
    for (of, is_told) in [("carry", true), ("ball_speed", false)] {
        let printed = longdrive(&[&spread[..], &[of]].concat());
        assert_eq!(
            (printed.status, printed.err.contains(says)),
            (0, is_told),
            "{of}: {}",
            printed.err
        );
        assert_eq!(
            printed.out.contains(", if the ball lands; median"),
            is_told,
            "{of}: {}",
            printed.out
        );
    }
}

/// Slow drives and fast drives leave the range of the law, and the drives between them do not.
#[test]
fn a_warning_of_a_chart_names_each_part() {
    let printed = longdrive(&[
        "chart",
        "--set",
        "aero.law=winfield-tan",
        "--along",
        "swing.speed",
        "--at",
        "50mph,90mph,100mph,140mph",
    ]);
    let err = on_one_line(&printed.err);
    assert!(err.contains("; swing.speed = 50 mph, and 140 mph"), "{err}");
}

/// The optima in plots and pages are checked as in `chart`: each kind of warning appears once, with
/// its positions.
#[test]
fn plots_and_reports_of_optima_warn_once_for_each_kind() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str| folder.path().join(name).display().to_string();
    let (svg, page) = (file("a.svg"), file("page"));
    let fast = [
        "--set",
        "aero.law=smits-smith",
        "--along",
        "swing.speed=140mph..145mph",
    ];
    let says = [
        "optima: the flight leaves the ranges that the law",
        "; swing.speed = 140 mph to 145 mph",
    ];
    let of_optima = |answer: &serde_json::Value| {
        let warnings = answer["warnings"]
            .as_array()
            .unwrap()
            .iter()
            .map(|it| it.as_str().unwrap().to_owned());
        warnings
            .filter(|it| it.contains("optima: "))
            .collect::<Vec<_>>()
    };
    for command in [
        vec!["chart"],
        vec!["plot", "chart", "-o", &svg],
        vec!["report", "-o", &page],
    ] {
        let (_, answer) = json(&[&command[..], &fast].concat());
        let found = of_optima(&answer);
        assert!(
            found.len() == 1 && says.iter().all(|says| found[0].contains(says)),
            "{command:?}: {answer}"
        );
    }
    let (_, usual) = json(&[
        "plot",
        "chart",
        "-o",
        &svg,
        "--overwrite",
        "--along",
        "swing.speed=105mph..110mph",
    ]);
    assert_eq!(of_optima(&usual), Vec::<String>::new());
    // the setup's own drive is usual, the optimum is not
    let vary = [
        "--vary",
        "club.loft=2deg..60deg",
        "--vary",
        "swing.speed=155mph..165mph",
        "--maximize",
        "carry",
    ];
    let (_, map) = json(&[&["plot", "contour", "-o", &svg, "--overwrite"], &vary[..]].concat());
    let warnings = map["warnings"].as_array().unwrap();
    assert!(
        warnings
            .iter()
            .any(|it| it.as_str().unwrap().starts_with("at the optimum: the law")),
        "{map}"
    );
}

/// The answer has the numbers of a warning: the fitted range, the extremes in the flight, and the
/// share of the flight outside of the range. The answer about an optimum has them, too.
#[test]
fn share_outside_the_range_of_a_law_is_in_the_answer() {
    let slow = ["--set", "swing.speed=30mph"];
    let low_spin = [
        "--launch",
        "ball_speed=170mph,launch_angle=12deg,backspin=1200rpm",
    ];
    let (_, answer) = json(&[&["simulate"], &low_spin[..]].concat());
    let spin_ratio = &answer["law_range"]["spin_ratio"];
    assert_eq!(
        spin_ratio["fitted"],
        serde_json::json!({ "low": 0.06, "high": 0.33 })
    );
    let share = spin_ratio["share_outside"].as_f64().unwrap();
    assert!(
        answer["warnings"]
            .to_string()
            .contains(&format!("for {:.0} % of the time", 100.0 * share)),
        "{answer}"
    );
    assert!(answer["law_range"]["speed"].is_null() && answer["law_range"]["spin"].is_null());
    let usual = json(&["simulate"]).1;
    assert_eq!(usual["law_range"]["spin_ratio"]["share_outside"], 0.0);
    let best = json(
        &[
            &["optimize"],
            &slow[..],
            &["--vary", "club.loft=8deg..20deg"],
        ]
        .concat(),
    )
    .1;
    assert!(
        best["law_range"]["reynolds"]["share_outside"]
            .as_f64()
            .unwrap()
            > 0.5,
        "{best}"
    );
    for none in [
        &["--set", "air.density=0 kg/m^3"][..],
        &["--set", "swing.attack_angle=-20deg"],
    ] {
        assert!(
            json(&[&["simulate"], none].concat()).1["law_range"].is_null(),
            "{none:?}"
        );
    }
}

/// Without air a ball lands at its launch angle, and 4° steeper on ground that rises by 4°.
#[test]
fn exact_angle_of_a_landing_flatter_than_measured_bounces() {
    let notes = |settings: &[&str], of: &str| {
        let mut command = vec!["gradient", "--of", of, "--wrt", "launch.ball_speed"];
        command.extend([
            "--set",
            "air.density=0 kg/m^3",
            "--launch",
            "ball_speed=40m/s,launch_angle=23deg,backspin=2000rpm",
        ]);
        command.extend(settings.iter().flat_map(|setting| ["--set", setting]));
        let (_, answer) = json(&command);
        let warnings = answer["warnings"]
            .as_array()
            .unwrap_or_else(|| panic!("{answer}"))
            .clone();
        assert_ne!(answer["status"], "error", "{answer}");
        warnings
            .iter()
            .filter_map(|it| it.as_str())
            .filter(|it| it.contains("lands at"))
            .map(str::to_owned)
            .collect()
    };
    for of in ["total", "run", "lateral_total", "carry,total"] {
        let found: Vec<String> = notes(&[], of);
        assert!(
            found.len() == 1 && found[0].contains("lands at 23 deg to the ground, below 25 deg"),
            "{of}: {found:?}"
        );
    }
    let found: Vec<String> = notes(&["ground.slope=1deg"], "total");
    assert!(
        found.len() == 1 && found[0].contains("lands at 24 deg"),
        "{found:?}"
    );
    for (settings, of) in [
        (&[][..], "carry"),
        (&["ground.slope=4deg"], "total"),
        // the ball embeds: there is no run
        (&["ground.restitution=none"], "total"),
    ] {
        let found: Vec<String> = notes(settings, of);
        assert!(found.is_empty(), "{settings:?} {of}: {found:?}");
    }
}

#[test]
fn a_flat_landing_has_a_warning_with_the_total_and_at_an_optimum() {
    let flat = [
        "--launch",
        "ball_speed=160mph,launch_angle=4deg,backspin=1500rpm",
    ];
    let text = longdrive(&[&["simulate"], &flat[..]].concat());
    assert!(
        text.err.contains("the ball lands at 9.081°"),
        "{}",
        text.err
    );
    // a search for carry also shows the total of both drives
    let is_told = |of, range, set: &[&str]| {
        let search = ["optimize", "--maximize", of, "--vary", range];
        let (_, answer) = json(&[&search[..], set].concat());
        let warnings = answer["warnings"].as_array().unwrap();
        warnings
            .iter()
            .any(|it| it.as_str().unwrap().contains("the ball lands at"))
    };
    let high = [
        "--launch",
        "ball_speed=160mph,launch_angle=12deg,backspin=2600rpm",
    ];
    for of in ["carry", "total"] {
        assert!(is_told(of, "launch.launch_angle=3deg..6deg", &flat), "{of}");
    }
    assert!(!is_told("carry", "launch.launch_angle=10deg..16deg", &high));
    // the total of the drive as set up is shown beside the total of the best drive
    assert!(is_told("carry", "launch.launch_angle=3deg..16deg", &flat));
    assert!(!is_told(
        "apex_height",
        "launch.launch_angle=3deg..6deg",
        &flat
    ));
}

/// The temperature is that of the drive as set up and of the optimum.
#[test]
fn a_picture_of_two_drives_warns_once_of_what_both_share() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.svg").display().to_string();
    for kind in ["contour", "fairway", "launch", "strike"] {
        let command = [
            "plot",
            kind,
            "-o",
            &file,
            "--overwrite",
            "--temperature",
            "5C",
        ];
        let output = longdrive(&command);
        assert_eq!(output.status, 0, "{kind}: {}", output.err);
        let messages = on_one_line(&output.err);
        let warnings = messages.matches("air.temperature changes the air alone");
        assert_eq!(warnings.count(), 1, "{kind}: {messages}");
    }
}

/// Only a picture of a total depends on how flat the ball lands.
#[test]
fn pictures_of_a_total_warn_of_a_flat_landing_and_others_do_not() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("a.svg").display().to_string();
    let flat = ["--speed", "92mph", "--attack", "-3deg", "--loft", "10.5deg"];
    let other = ["--set-b", "club.loft=10deg"];
    let compare_totals = [&other[..], &["--of", "total"]].concat();
    for (kind, more, is_warned) in [
        ("trajectory", &[][..], true),
        ("fairway", &[], true),
        ("tornado", &["--of", "total"], true),
        ("tornado", &[], false),
        ("compare", &compare_totals, true),
        ("compare", &other, false),
        ("launch", &[], false),
    ] {
        let command = ["plot", kind, "-o", &file, "--overwrite"];
        let output = longdrive(&[&command[..], &flat, more].concat());
        assert_eq!(output.status, 0, "{kind}: {}", output.err);
        let messages = on_one_line(&output.err);
        let warned = messages.contains("to the ground, below 25°");
        assert_eq!(warned, is_warned, "{kind} {more:?}: {messages}");
        let is_known = messages.contains("known within 10 yd at best");
        let is_drawn = ["trajectory", "fairway"].contains(&kind);
        assert_eq!(is_known, is_drawn, "{kind}: {messages}");
    }
}

/// The drive before the search lands on a slope that falls half as steeply as the ball.
#[test]
fn a_flat_landing_of_the_compared_drive_is_on_its_own_ground() {
    let setup = Setup::modern_driver();
    let search = Search::longest_drive(&setup).unwrap();
    let best = optimum(&setup, search, Observer::default()).unwrap();
    let mut downhill = setup;
    downhill.set("ground.slope", "-20 deg").unwrap();
    let compared = Optimum {
        start: downhill,
        drive_as_set_up: Drive::new(&downhill).ok(),
        ..best
    };
    let warnings = compared.warnings(&AtomicBool::new(false));
    let is_told = warnings.iter().any(|it| {
        it.to_string()
            .starts_with("the drive as set up: the ball lands at")
    });
    assert!(is_told, "{warnings:?}");
}

/// Club speeds are normally distributed. The expected share is the share above the speed from which
/// a drive with the best loft leaves the range of the law. The mean swing is well within the range.
#[test]
fn independent_share_of_the_swings_beyond_the_law_at_the_best_design() {
    let swings = "swing.speed=truncated(100mph,10mph,85mph,130mph)";
    let requested = [
        "--distribution",
        swings,
        "--vary",
        "club.loft=4deg..20deg",
        "--scenarios",
        "2000",
        "--set",
        "aero.law=winfield-tan",
    ];
    let (status, found) = json(&[&["optimize"], &requested[..], &SET_RIGID_TOUR].concat());
    assert_eq!(status, 0, "{found}");
    let message = warning_of(
        &found,
        " % of the swings: the flight leaves the ranges that the law winfield-tan",
    );
    let share: f64 = message.split(' ').next().unwrap().parse().unwrap();
    let mut setup = Setup::preset("tour-average").unwrap();
    setup.set_all(RIGID).unwrap();
    setup
        .set_all([("strike.high", "3 mm"), ("aero.law", "winfield-tan")])
        .unwrap();
    setup
        .set(
            "club.loft",
            &format!("{} rad", found["optimum"]["club.loft"]),
        )
        .unwrap();
    let is_outside = |mph: f64| {
        let mut setup = setup;
        setup.set("swing.speed", &format!("{mph} mph")).unwrap();
        Drive::new(&setup)
            .unwrap()
            .warnings_about(&setup, &[])
            .iter()
            .any(|it| it.to_string().contains("fitted to"))
    };
    assert!(!is_outside(100.0) && !is_outside(85.0) && is_outside(130.0));
    let (mut within, mut outside) = (100.0, 130.0);
    while outside - within > 1e-3 {
        let middle = 0.5 * (within + outside);
        *(if is_outside(middle) {
            &mut outside
        } else {
            &mut within
        }) = middle;
    }
    let normal = statrs::distribution::Normal::standard();
    let below = |mph: f64| statrs::distribution::ContinuousCDF::cdf(&normal, (mph - 100.0) / 10.0);
    let expected = 100.0 * (below(130.0) - below(outside)) / (below(130.0) - below(85.0));
    assert!(
        expected > 2.0 && (share - expected).abs() < 1.0,
        "{share} beside {expected}"
    );
    // swings within the range of the law give no warning
    let slower = [
        "--distribution",
        "swing.speed=truncated(110mph,2mph,105mph,115mph)",
        "--vary",
        "club.loft=4deg..20deg",
    ];
    assert_eq!(
        json(&[&["optimize"], &slower[..]].concat()).1["warnings"],
        serde_json::json!([])
    );
}

fn warning_of(found: &serde_json::Value, says: &str) -> String {
    let all = found["warnings"]
        .as_array()
        .unwrap()
        .iter()
        .map(|it| it.as_str().unwrap());
    let message: Vec<_> = all.filter(|it| it.contains(says)).collect();
    assert_eq!(message.len(), 1, "{says}: {found}");
    message[0].to_owned()
}

#[test]
fn designs_models_and_fronts_beyond_the_law_have_warnings() {
    let fast = ["--set", "swing.speed=160mph"];
    let says = "the flight leaves the ranges that the law";
    let (_, found) = json(
        &[
            &[
                "design",
                "--scenarios",
                "64",
                "--vary",
                "club.loft=6deg..16deg",
            ],
            &fast[..],
        ]
        .concat(),
    );
    assert!(
        warning_of(&found, says).contains(" % of the swings: the flight leaves the ranges"),
        "{found}"
    );
    let models = [
        "robust",
        "--model",
        "aero.law=ferguson",
        "--vary",
        "club.loft=4deg..20deg",
    ];
    let low = ["--vary", "club.loft=2deg..20deg"];
    let (_, found) = json(&[&models[..3], &low, &fast].concat());
    let message = warning_of(
        &found,
        "with the model 'as set up': the law launch-monitor was fitted to",
    );
    assert!(message.contains("and outside of that range for"), "{found}");
    let front = [
        "pareto",
        "--maximize",
        "carry",
        "--minimize",
        "apex_height",
        "--points",
        "5",
    ];
    let law = ["--set", "aero.law=smits-smith"];
    let (_, found) = json(&[&front, &fast[..], &law].concat());
    let points = found["points"].as_array().unwrap().len();
    let message = warning_of(&found, says);
    assert!(
        message.starts_with(&format!(
            "{points} of {points} points of the front: the flight leaves the ranges"
        )),
        "{message}"
    );
    let swings = [
        "--distribution",
        "swing.attack_angle=truncated(0deg,1deg,-3deg,3deg)",
        "--vary",
        "club.loft=1deg..16deg",
    ];
    let goals = [
        "pareto",
        "--maximize",
        "mean(carry)",
        "--minimize",
        "mean(apex_height)",
        "--points",
        "4",
    ];
    let (_, found) = json(&[&goals[..], &swings, &fast, &law, &SET_RIGID_TOUR].concat());
    let message = warning_of(&found, says);
    assert!(
        message
            .contains(" points of the front, for at least 1 % of their swings: the flight leaves"),
        "{message}"
    );
    // usual speeds give no warning
    let usual = json(&[&front[..], &["--vary", "club.loft=8deg..11deg"]].concat()).1;
    assert_eq!(usual["warnings"], serde_json::json!([]));
    assert_eq!(json(&models).1["warnings"], serde_json::json!([]));
}

/// `swing.shaft_growth` describes how the bend of the shaft grows with the head speed: without a
/// bend it has no effect.
#[test]
fn a_growth_of_a_rigid_shaft_is_warned_of() {
    let warned = |settings: &[&str]| {
        let output = longdrive(&[&["simulate", "winfield-tan"], settings].concat());
        output.err.contains("swing.shaft_growth has no effect")
    };
    let growth = ["--set", "swing.shaft_growth=2"];
    assert!(warned(&growth));
    assert!(!warned(
        &[&growth[..], &["--set", "swing.shaft_bend=2deg"]].concat()
    ));
    assert!(!warned(&[]));
}

/// Some laws are extrapolated beyond their range, others are held at its end. The warning about
/// many drives names the criterion for each kind.
#[test]
fn a_warning_about_many_drives_names_the_criterion_of_laws_that_hold_a_variable() {
    let mut table = tempfile::Builder::new().suffix(".csv").tempfile().unwrap();
    let text = b"speed [m/s],cd,cl\n50,0.25,0.15\n60,0.25,0.15\n";
    std::io::Write::write_all(&mut table, text).unwrap();
    let table = format!("aero.table={}", table.path().display());
    for (law, says) in [
        (
            table.as_str(),
            "where it is held, for at least 1 % of the flight time",
        ),
        (
            "aero.law=lyu",
            "where it is extrapolated or held, which changes carry by more than 0.3 yd or lasts at \
             least 1 % of the flight time",
        ),
    ] {
        let along = ["--along", "swing.speed", "--at", "140mph"];
        let (_, chart) = json(&[&["chart", "--set", law][..], &along].concat());
        let warning = warning_of(&chart, "optim");
        let start = "the only optimum: the flight leaves the ranges";
        assert!(
            warning.starts_with(start) && warning.contains(says),
            "{law}: {warning}"
        );
    }
}
