//! The delivery behind a measured launch.

use crate::command_line::{file_with, json, longdrive, number, on_one_line};
use crate::common::close;
use longdrive::derivative::gradient;
use longdrive::parameters::SetupFile;
use longdrive::study::calibrate::Measurement;
use longdrive::study::delivery::{Delivered, Unknown, delivery, unknowns};
use longdrive::study::{Sigma, Vary};
use longdrive::{Drive, Outcome, Setup};

const MEASURED: [Outcome; 5] = [
    Outcome::BallSpeed,
    Outcome::LaunchAngle,
    Outcome::LaunchDirection,
    Outcome::Backspin,
    Outcome::Sidespin,
];

fn struck(settings: &[(&str, &str)]) -> Setup<f64> {
    let mut setup = Setup::preset("modern-driver").unwrap();
    setup.set_all(settings.iter().copied()).unwrap();
    setup
}

fn launch_of(setup: &Setup<f64>) -> Vec<Measurement> {
    let drive = Drive::new(setup).unwrap();
    let one = |outcome: Outcome| {
        let (value, sigma) = (
            outcome.value(&drive).unwrap(),
            outcome.measurement_uncertainty().unwrap(),
        );
        Measurement {
            outcome,
            value,
            sigma,
        }
    };
    MEASURED.into_iter().map(one).collect()
}

const OFF_CENTRE: [(&str, &str); 7] = [
    ("swing.speed", "104 mph"),
    ("swing.attack_angle", "2 deg"),
    ("swing.shaft_lean", "-1.5 deg"),
    ("swing.path", "3 deg"),
    ("swing.face_angle", "1 deg"),
    ("strike.toe", "9 mm"),
    ("strike.high", "-4 mm"),
];

fn value(found: &Delivered, name: &str) -> f64 {
    found
        .posteriors
        .iter()
        .find(|known| known.unknown.parameter.name == name)
        .unwrap()
        .value
}

#[test]
fn exact_delivery_recovered_from_its_own_prior() {
    let setup = struck(&OFF_CENTRE);
    let found = delivery(
        &setup,
        &launch_of(&setup),
        &unknowns(&setup, &[], &[]).unwrap(),
    )
    .unwrap();
    for known in &found.posteriors {
        close(
            known.value,
            known.unknown.prior,
            known.unknown.sigma,
            1e-9,
            known.unknown.parameter.name,
        );
    }
    assert!(
        found
            .explained
            .iter()
            .all(|explained| explained.residual.abs() < 1e-9),
        "{found:?}"
    );
    // the five numbers of a launch identify at most five parameters
    let identified: f64 = found
        .posteriors
        .iter()
        .filter_map(|known| known.variance_removed)
        .sum();
    assert!((4.0..5.0).contains(&identified), "{identified}");
}

#[test]
fn exact_delivery_recovered_from_far_starts() {
    let truth = struck(&OFF_CENTRE[..5]);
    let start = struck(&[]);
    let ranges = [
        "swing.speed=60mph..150mph",
        "swing.attack_angle=-20deg..20deg",
        "swing.shaft_lean=-20deg..20deg",
        "swing.path=-20deg..20deg",
        "swing.face_angle=-20deg..20deg",
    ];
    let vary: Vec<_> = ranges
        .iter()
        .map(|range| Vary::read(&start, range).unwrap())
        .collect();
    // the prior has nearly no weight
    let sigma = |vary: &Vary| Sigma {
        parameter: vary.parameter,
        value: 1e6 * (vary.high - vary.low),
        source: None,
    };
    let sigmas: Vec<_> = vary.iter().map(sigma).collect();
    let found = delivery(
        &start,
        &launch_of(&truth),
        &unknowns(&start, &vary, &sigmas).unwrap(),
    )
    .unwrap();
    for vary in &vary {
        let name = vary.parameter.name;
        close(
            value(&found, name),
            truth.value(vary.parameter).unwrap(),
            vary.high,
            1e-9,
            name,
        );
    }
    assert!(
        found
            .posteriors
            .iter()
            .all(|known| known.variance_removed.unwrap() > 1.0 - 1e-9)
    );
    assert!(found.unidentified.is_empty());
}

/// Changes each measured value and each prior value by its standard uncertainty. The squares of the
/// changes of the answer add up to the stated variance. The changes are finite differences, so they
/// do not use the formula of the program.
#[test]
fn differences_of_the_answer_add_up_to_its_stated_uncertainty() {
    let setup = struck(&OFF_CENTRE);
    let (launch, sought) = (launch_of(&setup), unknowns(&setup, &[], &[]).unwrap());
    let stated = delivery(&setup, &launch, &sought).unwrap();
    let part = 1e-3;
    let moved =
        |launch: &[Measurement], sought: &[Unknown]| delivery(&setup, launch, sought).unwrap();
    let mut variances = vec![0.0; sought.len()];
    let mut add = |above: Delivered, below: Delivered| {
        for (variance, (above, below)) in variances
            .iter_mut()
            .zip(above.posteriors.iter().zip(&below.posteriors))
        {
            let movement = (above.value - below.value) / (2.0 * part);
            *variance += movement * movement;
        }
    };
    for i in 0..launch.len() {
        let at = |by: f64| {
            let mut launch = launch.clone();
            launch[i].value += by * launch[i].sigma;
            moved(&launch, &sought)
        };
        add(at(part), at(-part));
    }
    for i in 0..sought.len() {
        let at = |by: f64| {
            let mut sought = sought.clone();
            sought[i].prior += by * sought[i].sigma;
            moved(&launch, &sought)
        };
        add(at(part), at(-part));
    }
    for (known, variance) in stated.posteriors.iter().zip(variances) {
        let name = known.unknown.parameter.name;
        close(
            known.sigma.unwrap(),
            variance.sqrt(),
            known.unknown.sigma,
            1e-5,
            name,
        );
        close(
            known.variance_removed.unwrap(),
            1.0 - variance / known.unknown.sigma.powi(2),
            1.0,
            1e-4,
            name,
        );
    }
}

/// A printed change moves the launch as far as its whole direction does: by √(told/(1 − told))
/// standard uncertainties. The tolerance 0.05 is for the omitted components.
#[test]
fn an_unidentified_change_does_not_change_the_launch() {
    let setup = struck(&OFF_CENTRE);
    let evenly = [
        "club.loft=4deg..20deg",
        "swing.speed=80mph..120mph",
        "swing.attack_angle=-5deg..5deg",
        "swing.shaft_lean=-10deg..10deg",
        "strike.high=-20mm..20mm",
    ];
    for (vary, sigmas) in [
        (&[][..], &[][..]),
        (&[], &["strike.high=1mm", "strike.toe=1mm"]),
        (&[], &["swing.path=0.2deg", "swing.speed=1.5mph"]),
        (&evenly, &[]),
    ] {
        let vary: Vec<_> = vary
            .iter()
            .map(|text| Vary::read(&setup, text).unwrap())
            .collect();
        let sigmas: Vec<_> = sigmas
            .iter()
            .map(|text| Sigma::read(&setup, text).unwrap())
            .collect();
        let unknowns = unknowns(&setup, &vary, &sigmas).unwrap();
        let found = delivery(&setup, &launch_of(&setup), &unknowns).unwrap();
        assert!(found.unidentified.len() >= 2, "{:?}", found.unidentified);
        let wrt: Vec<_> = unknowns.iter().map(|unknown| unknown.parameter).collect();
        let slopes = MEASURED.map(|of| gradient(&found.setup, of, &wrt).unwrap().gradient);
        for untold in &found.unidentified {
            let moved = MEASURED.iter().zip(&slopes).map(|(outcome, slopes)| {
                let changes = untold.changes.iter().map(|(parameter, change)| {
                    slopes[wrt.iter().position(|row| row == parameter).unwrap()] * change
                });
                changes.sum::<f64>() / outcome.measurement_uncertainty().unwrap()
            });
            let moved = moved.map(|moved| moved * moved).sum::<f64>().sqrt();
            let told = untold.variance_removed;
            let whole = (told / (1.0 - told)).sqrt();
            assert!((moved - whole).abs() < 0.0501, "{moved} {untold:?}");
        }
    }
}

/// A prior that the user stated is not called assumed.
#[test]
fn the_text_on_unidentified_changes_names_the_prior_as_it_is_stated() {
    let launch = "ball_speed=150mph,launch_angle=12deg,spin=2600rpm";
    let request = [
        "delivery",
        "--launch",
        launch,
        "--sigma",
        "swing.path=0.2deg",
    ];
    let text = on_one_line(&longdrive(&request).out);
    let says = "The launch does not determine their sizes; the column \"± before\" does:";
    assert!(text.contains(says), "{text}");
}

/// The prior of a varied parameter is normal about the value of the setup, not uniform.
#[test]
fn the_prior_of_a_varied_parameter_is_named_as_it_is_computed() {
    let launch = "ball_speed=150mph,launch_angle=12deg,spin=2600rpm";
    let vary = "club.loft=4deg..20deg";
    let output = longdrive(&["delivery", "--launch", launch, "--vary", vary]);
    let says = "± 4.6188°; assumed: normal, with the standard deviation of an even spread over the";
    assert!(on_one_line(&output.err).contains(says), "{}", output.err);
}

/// Remarks on the priors are about all rows of a table, in any order of the rows.
#[test]
fn remarks_on_priors_include_rows_that_do_not_state_a_club_value() {
    let folder = tempfile::tempdir().unwrap();
    let head = "Club Speed [mph],Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm]\n";
    let remarks = |rows: [&str; 2]| {
        let text = format!("{head}{}", rows.concat());
        let file = file_with(folder.path(), "shots.csv", &text);
        let request = ["delivery", "--shots", &file, "modern-driver"];
        let output = longdrive(&[&request[..], &["--set", "club.loft=10.5deg"]].concat());
        (on_one_line(&output.err), on_one_line(&output.out))
    };
    let (empty, stated) = (",150,12,2600\n", "104,150,12,2600\n");
    for rows in [[empty, stated], [stated, empty]] {
        let (err, out) = remarks(rows);
        let in_others = "In the other rows: swing.speed = 110 mph ± 15 mph; assumed: how golfers";
        assert!(
            err.contains("prior: swing.speed as in the rows that state it ± 1.5 mph")
                && err.contains(in_others),
            "{err}"
        );
        let assumed = "assumed errors of the given club values: swing.speed ± 1.50 mph;";
        assert!(out.contains(assumed), "{out}");
    }
    let (err, _) = remarks([stated, stated]);
    assert!(
        err.contains("prior: swing.speed as in each row ± 1.5 mph") && !err.contains("other rows"),
        "{err}"
    );
}

/// A value that is set is the mean of the prior in rows that do not state it. It is refused only if
/// every row states it.
#[test]
fn a_club_speed_is_set_for_the_rows_whose_cell_is_empty() {
    let folder = tempfile::tempdir().unwrap();
    let head = "Club Speed [mph],Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm]\n";
    let said = |rows: &str| {
        let file = file_with(folder.path(), "shots.csv", &format!("{head}{rows}"));
        let output = longdrive(&["delivery", "--shots", &file, "--speed", "100mph"]);
        (output.status, on_one_line(&output.err))
    };
    let (status, err) = said(",150,12,2600\n104,150,12,2600\n");
    assert!(
        status != 2 && err.contains("In the other rows: swing.speed = 100 mph"),
        "{status} {err}"
    );
    let (status, err) = said("103,150,12,2600\n104,150,12,2600\n");
    assert!(
        status == 2 && err.contains("--speed: every row of"),
        "{status} {err}"
    );
}

#[test]
fn a_parameter_at_its_bound_is_unidentified_and_has_no_uncertainty() {
    let setup = struck(&[]);
    let faster = struck(&[("swing.speed", "125 mph")]);
    let vary = [Vary::read(&setup, "swing.speed=100mph..112mph").unwrap()];
    let found = delivery(
        &setup,
        &launch_of(&faster),
        &unknowns(&setup, &vary, &[]).unwrap(),
    )
    .unwrap();
    let known = &found.posteriors[0];
    assert_eq!(
        (known.value, known.sigma, known.variance_removed),
        (vary[0].high, None, None)
    );
    assert!(found.unidentified.is_empty());
}

#[test]
fn a_launch_on_the_command_line_becomes_a_setup_for_a_search() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("my golfer.toml");
    let file = file.to_str().unwrap();
    let launch = [
        "delivery",
        "--ball-speed",
        "150mph",
        "--launch-angle",
        "12deg",
        "--spin",
        "2600rpm",
        "-o",
        file,
    ];
    let ran = longdrive(&launch);
    assert_eq!(ran.status, 0, "{}", ran.err);
    let remark = ran.err.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        ran.out.contains("most probable delivery") && remark.contains("how golfers differ"),
        "{}",
        ran.err
    );
    let command = format!("longdrive optimize '{file}' --vary club.loft=4deg..20deg");
    assert!(remark.contains(&command), "{remark}");
    let golfer = SetupFile::open(std::path::Path::new(file)).unwrap().setup;
    let drive = Drive::new(&golfer).unwrap();
    for (outcome, measured) in [
        (Outcome::BallSpeed, "150 mph"),
        (Outcome::LaunchAngle, "12 deg"),
        (Outcome::Spin, "2600 rpm"),
    ] {
        let (value, sigma) = (
            outcome.quantity().read(measured).unwrap(),
            outcome.measurement_uncertainty().unwrap(),
        );
        close(outcome.value(&drive).unwrap(), value, sigma, 1.0, measured);
    }
    assert_eq!(
        longdrive(&["optimize", file, "--vary", "club.loft=4deg..20deg"]).status,
        0
    );
    // the launch as an option, and the answer as JSON
    let (status, answer) = json(&[
        "delivery",
        "--launch",
        "ball_speed=150mph,launch_angle=12deg,spin=2600rpm",
    ]);
    assert_eq!(
        (
            status,
            answer["status"].as_str(),
            answer["rows"].as_array().unwrap().len()
        ),
        (0, Some("done"), 1)
    );
    close(
        number(&answer["rows"][0]["known"][0]["value"]),
        golfer.swing.speed,
        50.0,
        1e-12,
        "speed",
    );
}

/// A smash factor moves the club speed towards the ball speed over the smash factor: 150 mph over
/// 1.45 and over 1.5. A delivery does not read the total, so its unit does not matter.
#[test]
fn independent_club_speeds_by_a_smash_factor_and_unused_totals() {
    let folder = tempfile::tempdir().unwrap();
    let speeds = |head: &str, rows: [&str; 2]| {
        let launch = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Total [shots]";
        let rows = rows.map(|row| format!("150,12,2600,3{row}\n"));
        let table = format!("{launch}{head}\n{}", rows.concat());
        let file = file_with(folder.path(), "shots.csv", &table);
        let (status, answer) = json(&["delivery", "--shots", &file]);
        assert_eq!(status, 0, "{answer}");
        let remarks = on_one_line(&longdrive(&["delivery", "--shots", &file]).err);
        assert!(remarks.contains("not used: Total"), "{remarks}");
        [0, 1].map(|row| number(&answer["rows"][row]["known"][0]["value"]) / 0.44704)
    };
    let (without, with) = (
        speeds("", ["", ""]),
        speeds(",Smash Factor", [",1.45", ",1.5"]),
    );
    for (row, smash_factor) in [(0, 1.45), (1, 1.5)] {
        let distance = |speeds: [f64; 2]| (speeds[row] - 150.0 / smash_factor).abs();
        assert!(
            distance(with) < 0.8 * distance(without),
            "{with:?} {without:?}"
        );
    }
}

#[test]
fn shots_of_a_launch_monitor_have_deliveries_with_measured_club_values() {
    let table = "Club Speed [mph],Ball Speed [mph],Launch Angle [deg],Launch Direction [deg],Spin \
                 Rate [rpm],Spin Axis [deg]\n\
                 106,155,10,0.5 R,2500,3 R\n104,153,11,1 L,2400,2 L\n";
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("shots.csv");
    std::fs::write(&file, table).unwrap();
    let (status, answer) = json(&["delivery", "--shots", file.to_str().unwrap()]);
    let rows = answer["rows"].as_array().unwrap();
    assert_eq!(
        (status, answer["status"].as_str(), rows.len()),
        (0, Some("done"), 2)
    );
    for (row, speed) in rows.iter().zip([106.0, 104.0]) {
        let known = &row["known"][0];
        let mph = 0.44704;
        close(
            number(&known["before"]),
            speed * mph,
            50.0,
            1e-12,
            "the measured speed is known before",
        );
        close(
            number(&known["standard_uncertainty_before"]),
            1.5 * mph,
            1.0,
            1e-12,
            "as well as a monitor measures it",
        );
        assert!(number(&known["standard_uncertainty"]) < 1.5 * mph);
        close(
            number(&known["value"]),
            speed * mph,
            3.0 * mph,
            1.0,
            "speed",
        );
    }
    let mean =
        0.5 * (number(&rows[0]["known"][0]["value"]) + number(&rows[1]["known"][0]["value"]));
    close(
        number(&answer["spread"][0]["mean"]),
        mean,
        mean,
        1e-14,
        "mean",
    );
}

/// Launch monitors state no error for the place of a strike, so a stated place has the uncertainty
/// of an unmeasured place.
#[test]
fn the_assumed_error_of_a_stated_strike_is_printed() {
    let launch = "ball_speed=160mph,launch_angle=12deg,spin=2500rpm";
    let request = ["delivery", "--launch", launch, "--set", "strike.toe=5mm"];
    let text = on_one_line(&longdrive(&request).out);
    let list = text
        .split("assumed errors of the given club values: ")
        .nth(1);
    assert!(
        list.is_some_and(|list| list.starts_with("strike.toe ± 10.00 mm;")),
        "{text}"
    );
    let (_, answer) = json(&request);
    let known = answer["rows"][0]["known"].as_array().unwrap();
    let toe = known.iter().find(|one| one["parameter"] == "strike.toe");
    let source = toe.unwrap()["source"].as_str().unwrap();
    assert!(
        source.contains("the error of its measurement is not known"),
        "{source}"
    );
}

#[test]
fn missing_columns_of_a_table_are_not_measured() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("shots.csv");
    let table = "Ball Speed [mph],Launch Angle [deg],Launch Direction [deg],Spin Rate [rpm],Carry \
                 [yd]\n171,10.4,,2545,400\n";
    std::fs::write(&file, table).unwrap();
    let (status, answer) = json(&["delivery", "--shots", file.to_str().unwrap()]);
    let (_, alone) = json(&[
        "delivery",
        "--launch",
        "ball_speed=171mph,launch_angle=10.4deg,spin=2545rpm",
    ]);
    assert_eq!(status, 0);
    let of: Vec<_> = answer["rows"][0]["explained"]
        .as_array()
        .unwrap()
        .iter()
        .map(|one| &one["of"])
        .collect();
    assert_eq!(of, ["ball_speed", "launch_angle", "spin"]);
    for (here, there) in answer["rows"][0]["known"]
        .as_array()
        .unwrap()
        .iter()
        .zip(alone["rows"][0]["known"].as_array().unwrap())
    {
        close(
            number(&here["value"]),
            number(&there["value"]),
            1.0,
            1e-9,
            "as on the command line",
        );
        if here["parameter"] == "swing.path" {
            assert_eq!(number(&here["told"]), 0.0);
        }
    }
}

/// A launch without a direction does not determine path, face angle and strike towards the toe.
#[test]
fn same_part_determined_in_the_answer_and_in_its_setup_file() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("golfer.toml");
    let launch = "ball_speed=150mph,launch_angle=12deg,spin=2600rpm";
    let (status, answer) = json(&["delivery", "--launch", launch, "-o", file.to_str().unwrap()]);
    assert_eq!(status, 0, "{answer}");
    let setup = std::fs::read_to_string(&file).unwrap();
    let remark_of = |name: &str| {
        let line = setup.lines().find(|line| line.starts_with(name)).unwrap();
        line.split(" # ").nth(1).unwrap()
    };
    for name in ["path", "face_angle", "toe"] {
        let remark = "assumed: 1 shot of a measured launch cannot determine it";
        assert_eq!(remark_of(name), remark, "{name}");
    }
    let known = answer["rows"][0]["known"].as_array().unwrap();
    for name in ["swing.speed", "swing.attack_angle", "strike.high"] {
        let one = known.iter().find(|one| one["parameter"] == name).unwrap();
        let determined = 100.0 * number(&one["told"]);
        let remark =
            format!("recovered from 1 shot of a measured launch, {determined:.0} % determined");
        assert_eq!(remark_of(name.split('.').nth(1).unwrap()), remark, "{name}");
    }
}

#[test]
fn same_comments_of_unchanged_values_in_a_file_written_from_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    let (golfer, best, point) = (path("golfer.toml"), path("best.toml"), path("point.toml"));
    let answered = |words: &[&str]| {
        let output = longdrive(words);
        assert_eq!(output.status, 0, "{words:?}: {}", output.err);
    };
    let launch = "ball_speed=150mph,launch_angle=12deg,spin=2600rpm";
    answered(&["delivery", "--launch", launch, "-o", &golfer]);
    let vary = ["--vary", "club.loft=6deg..14deg"];
    answered(&[&["optimize", &golfer, "-o", &best], &vary[..]].concat());
    let goals = ["--maximize", "carry", "--minimize", "spin", "--at", "2"];
    answered(&[&["pareto", &golfer, "-o", &point], &vary[..], &goals[..]].concat());
    let lines = |file: &str| -> Vec<String> {
        let text = std::fs::read_to_string(file).unwrap();
        text.lines().map(str::to_owned).collect()
    };
    let of_golfer = lines(&golfer);
    for file in [&best, &point] {
        let written = lines(file);
        assert!(
            written[0].starts_with(&format!("# {golfer}, ")),
            "{}",
            written[0]
        );
        let added: Vec<_> = written
            .iter()
            .filter(|line| !of_golfer.contains(line))
            .collect();
        let is_loft = |line: &&&String| line.starts_with("loft = ");
        let about = added.iter().filter(|line| line.starts_with("# ")).count();
        assert_eq!(added.iter().filter(is_loft).count(), 1, "{added:?}");
        assert_eq!(added.len(), about + 1, "{added:?}");
    }
}

/// A smash factor of 1.58 or 1.88 is impossible, so the stated club speed is wrong. The message
/// names this speed, and no setup is written.
#[test]
fn a_stated_speed_that_contradicts_the_launch_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("golfer.toml");
    let launch = "ball_speed=150mph,launch_angle=12deg,spin=2600rpm";
    for speed in ["95mph", "80mph"] {
        let file = file.to_str().unwrap();
        let (status, answer) =
            json(&["delivery", "--launch", launch, "--speed", speed, "-o", file]);
        assert_eq!(
            (status, &answer["rows"][0]["status"]),
            (1, &"unexplained".into()),
            "{speed}"
        );
        let message = answer["message"].as_str().unwrap();
        let given = speed.replace("mph", " mph");
        assert!(
            message.contains("has swing.speed")
                && message.contains(&format!("in place of {given}")),
            "{message}"
        );
    }
    assert!(!file.exists());
    let (status, _) = json(&["delivery", "--launch", launch, "--speed", "102mph"]);
    assert_eq!(status, 0, "a smash factor of 1.47");
}

#[test]
fn a_launch_without_a_delivery_is_unexplained_and_not_written() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("golfer.toml");
    let launch = "ball_speed=300mph,launch_angle=12deg,spin=2600rpm";
    let (status, answer) = json(&["delivery", "--launch", launch, "-o", file.to_str().unwrap()]);
    assert_eq!(
        (status, &answer["status"], &answer["rows"][0]["status"]),
        (1, &"no-answer".into(), &"unexplained".into())
    );
    assert!(
        answer["message"]
            .as_str()
            .unwrap()
            .contains("in place of 300 mph"),
        "{}",
        answer["message"]
    );
    assert!(!file.exists() && answer["spread"].as_array().unwrap().is_empty());
}

/// No club of the ranges gives a ball 269 mph.
#[test]
fn the_written_setup_is_the_mean_of_the_explained_deliveries() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name).display().to_string();
    let heads = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Spin Axis [deg]";
    let written = |rows: &str| {
        let [table, file] = ["shots.csv", "golfer.toml"].map(place);
        std::fs::write(&table, format!("{heads}\n{rows}\n")).unwrap();
        let output = longdrive(&["delivery", "--shots", &table, "-o", &file, "--overwrite"]);
        let toml = std::fs::read_to_string(&file).ok();
        let _ = std::fs::remove_file(&file);
        (output.status, on_one_line(&output.err), toml)
    };
    let (status, told, alone) = written("150,12,2600,1");
    assert!(
        status == 0 && told.contains("wrote the setup with this delivery into"),
        "{told}"
    );
    let (status, told, of_both) = written("150,12,2600,1\n269,12,2600,1");
    let says = "wrote the setup with the mean of 1 of 2 deliveries into";
    assert!(status == 1 && told.contains(says), "{told}");
    assert!(alone.is_some() && alone == of_both);
    let (status, told, none) = written("269,12,2600,1");
    assert!(
        status == 1 && none.is_none() && told.contains("is not written"),
        "{told}"
    );
}

/// The speed of a junior is more than four standard deviations below the speed of the preset.
#[test]
fn parameters_limited_by_their_range_have_a_warning() {
    let folder = tempfile::tempdir().unwrap();
    let table = folder.path().join("slow.csv").display().to_string();
    let head = "Ball Speed [mph],Launch Angle [deg],Launch Direction [deg],Spin Rate [rpm],Spin \
                Axis [deg]";
    std::fs::write(
        &table,
        format!("{head}\n72,13,1,2500,2\n71,15,-1,2700,-3\n"),
    )
    .unwrap();
    let at_ends = |arguments: &[&str]| {
        let (_, answer) = json(&[&["delivery", "--shots", &table], arguments].concat());
        let warnings = answer["warnings"]
            .as_array()
            .unwrap()
            .iter()
            .map(|it| it.as_str().unwrap().to_owned());
        warnings
            .filter(|it| it.contains("end of its search range"))
            .collect::<Vec<_>>()
    };
    let found = at_ends(&[]);
    let says = "swing.speed of 2 of 2 launches lies at the lower end of its search range, 55";
    assert!(found.iter().any(|it| it.starts_with(says)), "{found:?}");
    let nearer = at_ends(&["--set", "swing.speed=50mph"]);
    assert!(
        !nearer.iter().any(|it| it.starts_with("swing.speed")),
        "{nearer:?}"
    );
}

#[test]
fn bad_arguments_of_delivery_are_refused_with_advice() {
    let launch = [
        "--ball-speed",
        "150mph",
        "--launch-angle",
        "12deg",
        "--spin",
        "2600rpm",
    ];
    let given = |more: &[&str]| {
        [&["delivery"], &launch[..], more]
            .concat()
            .into_iter()
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    for (args, says) in [
        (
            vec!["delivery".to_owned()],
            "add --ball-speed, --launch-angle and --spin",
        ),
        (
            given(&["--vary", "aero.cd0=0.1..0.2"]),
            "no launch depends on",
        ),
        (
            given(&["--sigma", "club.loft=1deg"]),
            "it is not an unknown",
        ),
        (
            given(&["--vary", "club.loft=20deg..30deg"]),
            "outside of its search range",
        ),
        (
            given(&[
                "--vary",
                "club.loft=8deg..12deg",
                "--vary",
                "club.loft=8deg..13deg",
            ]),
            "name it once",
        ),
        (given(&["--backspin", "2000rpm"]), "the spin is given twice"),
        (
            given(&["--shots", "none.csv"]),
            "give the shots or a launch, not both",
        ),
        (
            [
                "delivery",
                "--shots",
                "none.csv",
                "--set",
                "launch.launch_direction=2deg",
            ]
            .map(String::from)
            .to_vec(),
            "--set launch.…: each shot has its own launch",
        ),
        (
            given(&["--own-step"]),
            "this command has no option '--own-step'",
        ),
        (given(&["--launch-direction", "3"]), "has no unit"),
    ] {
        let args: Vec<&str> = args.iter().map(String::as_str).collect();
        let ran = longdrive(&args);
        assert!(
            ran.status == 2 && ran.err.contains(says),
            "{args:?}: {}",
            ran.err
        );
    }
}

/// A delivery is found from the launch and the club of a setup file, so it uses both.
#[test]
fn a_delivery_uses_the_club_and_the_launch_of_a_file_but_no_launch_beside_shots() {
    let folder = tempfile::tempdir().unwrap();
    let text = "[swing]\nspeed = \"95 mph\"\n[launch]\nball_speed = \"140 mph\"\n\
                launch_angle = \"12 deg\"\nspin = \"2600 rpm\"\n";
    let file = file_with(folder.path(), "both.toml", text);
    let found = longdrive(&["delivery", &file]);
    assert_eq!(found.status, 0, "{}", found.err);
    assert!(found.err.contains("swing.speed = 95 mph"), "{}", found.err);
    assert!(!found.err.contains("not used"), "{}", found.err);
    let drive = longdrive(&["simulate", &file]);
    assert!(drive.err.contains("not used"), "{}", drive.err);
    let both = longdrive(&["delivery", &file, "--shots", "none.csv"]);
    let says = "both.toml: each shot has its own launch";
    assert!(both.status == 2 && both.err.contains(says), "{}", both.err);
}

/// Air, wind, ground and law have no effect on the impact. A file has the whole setup.
#[test]
fn settings_without_effect_on_a_delivery_have_a_warning_unless_a_file_gets_them() {
    let launch = "ball_speed=150mph,launch_angle=12deg,spin=2600rpm";
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("mine.toml").display().to_string();
    let warnings = |more: &[&str]| {
        let (status, found) = json(&[&["delivery", "--launch", launch], more].concat());
        assert_eq!(status, 0, "{found}");
        found["warnings"].to_string()
    };
    let idle = [
        "--set",
        "air.density=1.1 kg/m^3",
        "--set",
        "aero.law=ferguson",
        "--set",
        "ground.turf=firm",
        "--set",
        "club.loft=9deg",
    ];
    let says = "air.density, aero.law, ground.turf: no effect on the delivery";
    assert!(warnings(&idle).contains(says), "{}", warnings(&idle));
    let is_silent = |more: &[&str]| !warnings(more).contains("no effect on the delivery");
    assert!(is_silent(&[
        "--set",
        "club.loft=9deg",
        "--set",
        "ball.mass=45 g"
    ]));
    assert!(is_silent(&[&idle[..], &["-o", &file]].concat()));
}

/// A launch whose spin is stated twice: a second statement that agrees changes nothing, and one that
/// differs is named and not used, also if it is 0.
#[test]
fn same_delivery_with_the_spin_stated_twice() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("shots.csv").display().to_string();
    let launch = "Ball Speed [mph],Launch Angle [deg],Launch Direction [deg],Spin Rate [rpm],Spin \
                  Axis [deg]";
    let found = |second: Option<&str>| {
        let text = match second {
            Some(cells) => {
                format!("{launch},Back Spin [rpm],Side Spin [rpm]\n160,12,1.5,2500,-8,{cells}\n")
            }
            None => format!("{launch}\n160,12,1.5,2500,-8\n"),
        };
        std::fs::write(&file, text).unwrap();
        let (status, answer) = json(&["delivery", "--shots", &file]);
        let said = on_one_line(&longdrive(&["delivery", "--shots", &file]).err);
        (status, answer["rows"][0].clone(), said)
    };
    let (_, once, _) = found(None);
    for (cells, is_contradiction) in [
        ("2475.67,-347.93", false),
        ("2700,-375", true),
        ("0,0", true),
        (",", false),
    ] {
        let (status, twice, said) = found(Some(cells));
        assert_eq!((status, &twice), (0, &once), "{cells}");
        let says = "the spins contradict each other: Spin Rate and Spin Axis are used";
        assert_eq!(said.contains(says), is_contradiction, "{cells}: {said}");
    }
}
