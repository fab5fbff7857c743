//! Calibration: recovery of known truths, coverage of intervals, exact Jacobians, Winfield & Tan's
//! paper, bad input.

use crate::command_line::WHOLE;
use crate::command_line::{json, longdrive, number, on_one_line};
use crate::common::{LARGE_STEPS, panic_of};
use crate::random::Random;
use longdrive::derivative::{Order, evaluate};
use longdrive::launch::Launch;
use longdrive::optimize::least_squares::{FitObserver, Loss, Rows};
use longdrive::report::{CalibrationReport, Reply, Report};
use longdrive::study::calibrate::{
    Calibration, CalibrationStatus, FitPlan, FitRange, FitStatistics, MeasuredShot, ShotTable,
    SigmaOrigin, calibrate, held_out,
};
use longdrive::units::{Message, System};
use longdrive::{Drive, Outcome, Setup};
use std::fmt::Write;
use std::io::Write as _;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// A setup with a known law.
fn truth() -> Setup<f64> {
    let mut setup = Setup::modern_driver();
    setup
        .set_all([
            ("aero.law", "linear"),
            ("aero.cd", "0.27"),
            ("aero.cl_slope", "1.3"),
        ])
        .unwrap();
    // large steps save time; the shots are flown with them, too
    setup.set_all(LARGE_STEPS).unwrap();
    setup
}

const SIGMA: [f64; 2] = [2.0, 0.5];

/// A table of twelve shots with the law of [`truth`]. Carry and apex have normal errors of `size`
/// times their uncertainties [`SIGMA`].
fn shots(noise: &mut Random, size: f64) -> String {
    let mut text =
        "ball_speed [m/s],launch_angle [deg],backspin [rpm],carry [m],sigma carry [m],apex_height \
         [m],sigma apex_height [m]\n"
            .to_owned();
    for k in 0..12 {
        let (speed, angle, spin) = (
            55.0 + 1.7 * f64::from(k),
            9.0 + f64::from(k * 5 % 7),
            1800.0 + 150.0 * f64::from(k * 7 % 12),
        );
        let mut setup = truth();
        let given = &mut setup.launch;
        (given.ball_speed, given.launch_angle) = (Some(speed), Some(angle.to_radians()));
        given.backspin = Some(spin * std::f64::consts::TAU / 60.0);
        let values = evaluate(
            &setup,
            &[Outcome::Carry, Outcome::ApexHeight],
            &[],
            Order::Value,
        )
        .unwrap();
        let [carry, apex] = [0, 1].map(|i| values[i].value + size * SIGMA[i] * noise.normal());
        writeln!(
            text,
            "{speed},{angle},{spin},{carry},{},{apex},{}",
            SIGMA[0], SIGMA[1]
        )
        .unwrap();
    }
    text
}

fn fitted(text: &str, setup: &Setup<f64>, names: &[&str], loss: Loss) -> Calibration {
    let table = ShotTable::read(setup, "shots.csv", text.as_bytes()).unwrap();
    assert!(table.is_launched && table.sigma_origin == SigmaOrigin::Stated);
    let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
    let mut plan = FitPlan::read(setup, &names).unwrap();
    plan.options.loss = loss;
    calibrate(setup, &table, &plan, &FitObserver::default()).unwrap()
}

/// Launch of the ball of a shot.
fn launch(shot: &MeasuredShot) -> Launch<f64> {
    let mut setup = Setup::modern_driver();
    for (parameter, value) in &shot.inputs {
        setup.set_value(parameter, Some(*value)).unwrap();
    }
    Launch::given(&setup).unwrap()
}

const LAW: [&str; 2] = ["aero.cd", "aero.cl_slope"];

fn elsewhere() -> Setup<f64> {
    let mut setup = truth();
    setup
        .set_all([("aero.cd", "0.2"), ("aero.cl_slope", "2")])
        .unwrap();
    setup
}

#[test]
fn exact_truth_recovered_from_shots_without_noise() {
    let found = fitted(
        &shots(&mut Random::seeded(1), 0.0),
        &elsewhere(),
        &LAW,
        Loss::Squares,
    );
    assert!(
        (found.estimates[0].value - 0.27).abs() < 1e-9,
        "{:?}",
        found.estimates
    );
    assert!(
        (found.estimates[1].value - 1.3).abs() < 1e-9,
        "{:?}",
        found.estimates
    );
}

#[test]
fn sampled_coverage_of_intervals_over_200_draws_of_noise() {
    let (mut noise, mut covered, mut chi_square) = (Random::seeded(20_261_121), [0; 2], 0.0);
    for _ in 0..200 {
        let found = fitted(&shots(&mut noise, 1.0), &truth(), &LAW, Loss::Squares);
        for (i, truth) in [0.27, 1.3].into_iter().enumerate() {
            let estimate = found.estimates[i];
            let half_width = found.statistics.coverage_factor * estimate.standard_error.unwrap();
            covered[i] += usize::from((estimate.value - truth).abs() <= half_width);
        }
        assert_eq!(found.statistics.degrees_of_freedom, 22);
        chi_square += found.statistics.chi_square / 200.0;
    }
    // of 400 intervals at a level of 95 %, 93 to 97 % contain the truth. The mean of χ² with 22
    // degrees of freedom is within four standard errors of 22
    let share = (covered[0] + covered[1]) as f64 / 400.0;
    println!("coverage {covered:?} of 200 each, mean chi-square {chi_square}");
    assert!((0.93..=0.97).contains(&share), "{covered:?}");
    assert!(
        (chi_square - 22.0).abs() < 4.0 * (44.0_f64 / 200.0).sqrt(),
        "{chi_square}"
    );
}

#[test]
fn hubers_loss_limits_the_effect_of_an_outlier() {
    let text = shots(&mut Random::seeded(7), 0.3);
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    // a carry with an error of 60 m
    let mut cells: Vec<String> = lines[6].split(',').map(str::to_owned).collect();
    cells[3] = format!("{}", cells[3].parse::<f64>().unwrap() + 60.0);
    lines[6] = cells.join(",");
    let text = lines.join("\n");
    let [squares, huber] = [Loss::Squares, Loss::HUBER]
        .map(|loss| fitted(&text, &elsewhere(), &LAW, loss).estimates[0].value);
    assert!(
        (huber - 0.27).abs() < 0.2 * (squares - 0.27).abs(),
        "{squares} {huber}"
    );
}

#[test]
fn confounded_parameters_are_named() {
    // the law does not depend on the Reynolds number, so the data do not determine the viscosity.
    // Coefficients and density enter as products only, so the data do not determine the density
    let names = ["aero.cd", "aero.cl_slope", "air.density", "air.viscosity"];
    let found = fitted(
        &shots(&mut Random::seeded(3), 1.0),
        &truth(),
        &names,
        Loss::Squares,
    );
    let named: Vec<Vec<usize>> = found
        .statistics
        .undetermined
        .iter()
        .map(|u| u.parts.iter().map(|(at, _)| *at).collect())
        .collect();
    assert_eq!(named.len(), 2, "{named:?}");
    assert!(
        named.contains(&vec![0, 1, 2]) || named.iter().flatten().any(|at| *at == 2),
        "{named:?}"
    );
    assert!(named.iter().flatten().any(|at| *at == 3), "{named:?}");
    assert!(
        found
            .estimates
            .iter()
            .all(|estimate| estimate.standard_error.is_none()),
        "{:?}",
        found.estimates
    );
}

/// If there are as many data as parameters, the residuals vanish. A change of one datum by its
/// standard uncertainty then changes the fit by a column of J⁻¹. The covariance (JᵀJ)⁻¹ is the sum
/// of the outer products of these columns. The test avoids derivatives: it repeats the fit with
/// each datum changed.
#[test]
fn differences_of_fits_match_the_covariance_with_measured_and_stationary_rows() {
    let head = "club.loft [deg],swing.attack_angle [deg],stationary,sigma stationary [deg],carry \
                [yd],sigma carry [yd],\
                flight_time [s],sigma flight_time [s]";
    let (setup, names) = (
        Setup::preset("winfield-tan").unwrap(),
        ["aero.cd0", "aero.cl_hill", "aero.spin_decay"],
    );
    let fit = |[attack, carry, time]: [f64; 3]| {
        let rows =
            format!("12,{attack},swing.attack_angle,0.05,{carry},2,,\n9,13,,,,,{time},0.1\n");
        let table =
            ShotTable::read(&setup, "optima.csv", format!("{head}\n{rows}").as_bytes()).unwrap();
        let plan = FitPlan::read(&setup, &names.map(str::to_owned)).unwrap();
        let found = calibrate(&setup, &table, &plan, &FitObserver::default()).unwrap();
        assert!(
            found.statistics.is_exact,
            "{attack} {carry} {time}: {:?}",
            found.residuals
        );
        found
    };
    let computed = |outcome: Outcome, loft: f64, attack: f64| {
        let mut setup = setup;
        (setup.club.loft, setup.swing.attack_angle) = (loft.to_radians(), attack.to_radians());
        evaluate(&setup, &[outcome], &[], Order::Value).unwrap()[0].value
    };
    let carry = yards(computed(Outcome::CarryDistance, 12.0, 8.3));
    let (data, sigmas) = (
        [8.3, carry, computed(Outcome::FlightTime, 9.0, 13.0)],
        [0.05, 2.0, 0.1],
    );
    let part = 1e-3;
    let columns: Vec<Vec<f64>> = (0..3)
        .map(|k| {
            let at = |by: f64| {
                let mut moved = data;
                moved[k] += by * sigmas[k];
                fit(moved)
                    .estimates
                    .into_iter()
                    .map(|estimate| estimate.value)
            };
            at(part)
                .zip(at(-part))
                .map(|(above, below)| (above - below) / (2.0 * part))
                .collect()
        })
        .collect();
    let found = fit(data);
    for a in 0..3 {
        for b in 0..3 {
            let difference: f64 = columns.iter().map(|column| column[a] * column[b]).sum();
            let size = [a, b]
                .map(|i| found.statistics.standard_error(i).unwrap())
                .iter()
                .product::<f64>();
            let covariance = found.statistics.covariance[a][b].unwrap();
            assert!(
                (difference - covariance).abs() < 1e-5 * size,
                "{a} {b}: {difference} {covariance}"
            );
        }
    }
}

fn yards(metres: f64) -> f64 {
    metres / 0.9144
}

/// Compares every number of the paper's tables. The preset has a single smooth law, whose errors
/// are the tolerances.
#[test]
fn published_tables_of_winfield_and_tan_by_the_preset() {
    let (status, found) = json(&["reproduce", "winfield-tan"]);
    assert_eq!(status, 0);
    let printed = &found["printed"];
    let off = |part: &str, key: &str| number(&found[part][key]) - number(&printed[part][key]);
    assert!(yards(off("shot", "carry")).abs() <= 0.3 && off("shot", "flight_time").abs() <= 0.02);
    assert!(
        yards(off("shot", "apex_height")).abs() <= 0.2 && off("shot", "apex_time").abs() <= 0.1
    );
    assert!(yards(off("optimum", "carry")).abs() <= 0.3);
    assert_eq!(
        number(&printed["optimum"]["club.loft"]),
        2.74_f64.to_radians()
    );
    assert_eq!(
        number(&printed["table2"][3]["club.loft"]),
        13.55_f64.to_radians()
    );
    let (mut carries, mut angles) = (vec![], vec![]);
    for (table, angle) in [("table1", "swing.attack_angle"), ("table2", "club.loft")] {
        let rows = found[table]
            .as_array()
            .unwrap()
            .iter()
            .zip(printed[table].as_array().unwrap());
        for (row, print) in rows {
            carries.push(yards(number(&row["carry"]) - number(&print["carry"])));
            angles.push((number(&row[angle]) - number(&print[angle])).to_degrees());
        }
    }
    assert_eq!(carries.len(), 22);
    let rms = |all: &[f64]| (all.iter().map(|x| x * x).sum::<f64>() / all.len() as f64).sqrt();
    let worst = |all: &[f64]| all.iter().copied().map(f64::abs).fold(0.0, f64::max);
    assert!(
        rms(&carries) <= 0.2 && worst(&carries) <= 0.5,
        "{carries:?}"
    );
    assert!(rms(&angles) <= 0.05 && worst(&angles) <= 0.2, "{angles:?}");
    // the average was not fitted: it tests the law on new data
    assert!(
        yards(off("average", "carry")).abs() <= 0.5,
        "{}",
        yards(off("average", "carry"))
    );
    assert!(
        off("average", "club.loft").to_degrees().abs() <= 0.35,
        "{}",
        off("average", "club.loft").to_degrees()
    );
    let decay = &found["aero.spin_decay"];
    assert!(
        number(&decay["value"]) < 0.3 && number(&decay["standard_uncertainty"]) > 0.0,
        "{decay}"
    );
}

fn table(text: &str) -> tempfile::NamedTempFile {
    let mut file = tempfile::Builder::new().suffix(".csv").tempfile().unwrap();
    file.write_all(text.as_bytes()).unwrap();
    file
}

#[test]
fn exact_truth_recovered_on_the_command_line_with_missing_cells() {
    let text = shots(&mut Random::seeded(5), 0.0);
    // the apex of one shot is missing
    let mut lines: Vec<&str> = text.lines().collect();
    let cells: Vec<&str> = lines[4].split(',').collect();
    let without = [&cells[..5], &["", ""]].concat().join(",");
    lines[4] = &without;
    let (data, output) = (
        table(&lines.join("\n")),
        tempfile::Builder::new().suffix(".toml").tempfile().unwrap(),
    );
    let (data, output) = (
        data.path().to_str().unwrap(),
        output.path().to_str().unwrap(),
    );
    let law = [
        "--set",
        "aero.law=linear",
        "--set",
        "flight.step=0.02s",
        "--fit",
        "aero.cd=0.1..0.6",
        "--fit",
        "aero.cl_slope=0..5",
    ];
    let (status, found) = json(
        &[
            &[
                "calibrate",
                data,
                "--overwrite",
                "-o",
                output,
                "--folds",
                "3",
                "--starts",
                "3",
            ],
            law.as_slice(),
        ]
        .concat(),
    );
    assert_eq!(
        (status, found["status"].as_str()),
        (0, Some("converged")),
        "{found}"
    );
    let others = found["starts"]["elsewhere"]
        .as_object()
        .unwrap()
        .values()
        .map(|count| count.as_u64().unwrap());
    assert_eq!(
        found["starts"]["same"].as_u64().unwrap() + others.sum::<u64>(),
        3,
        "{}",
        found["starts"]
    );
    assert_eq!(found["data"]["values"], 23);
    assert!((number(&found["estimates"]["aero.cd"]["value"]) - 0.27).abs() < 1e-9);
    assert!(number(&found["held_out"][0]["rms_standardized"]) < 1e-6);
    let (status, drive) = json(&["simulate", output]);
    assert_eq!(status, 0);
    assert!((number(&drive["setup"]["aero.cd"]) - 0.27).abs() < 1e-9);
}

#[test]
fn bad_tables_and_plans_are_refused_with_row_and_column() {
    let fit = ["--fit", "aero.cd0", "--fit", "aero.cl_max"];
    for (text, fit, words) in [
        (
            "carry [yd],club.loft [deg]\n200,ten\n",
            &fit[..],
            vec!["row 1", "column club.loft", "'ten' is not a number"],
        ),
        (
            "cary [yd]\n200\n",
            &fit,
            vec!["column 1", "did you mean 'carry'"],
        ),
        (
            "carry [kg]\n200\n",
            &fit,
            vec!["column 1", "carry", "200"]
                .into_iter()
                .take(2)
                .collect(),
        ),
        (
            "carry [yd]\n200\n",
            &fit,
            vec!["1 measured value, fewer than the 2 parameters"],
        ),
        (
            "carry [yd],club.loft [deg]\n200,10\n210,95\n",
            &fit,
            vec!["row 2", "column club.loft", "outside its range"],
        ),
        (
            "club.loft [deg],carry [yd],swing.path [deg]\n10,200,0\n,210,95\n",
            &fit,
            vec!["row 2", "column swing.path", "outside its range"],
        ),
        (
            "carry [yd],club.loft [deg]\n200,10\n,11\n",
            &fit,
            vec!["row 2", "nothing is measured"],
        ),
        (
            "carry [yd],club.loft [deg]\n200,10\n201,\n",
            &fit,
            vec!["left out", "row 2 (club.loft)", "1 measured value, fewer"],
        ),
        (
            "carry [yd],club.loft [deg]\n201,\n",
            &fit,
            vec!["row 1", "column club.loft", "empty"],
        ),
        (
            "carry [yd],sigma carry [yd]\n200,0\n201,1\n",
            &fit,
            vec!["row 1", "sigma carry", "above 0"],
        ),
        (
            "carry [yd],sigma lateral [yd]\n200,3\n",
            &fit,
            vec![
                "column 2",
                "'sigma lateral' is the uncertainty of an outcome without",
            ],
        ),
        (
            "carry [yd]\n200\n-201\n",
            &fit,
            vec!["row 2", "column carry", "above 0", "check its sign"],
        ),
        (
            "flight_time [s]\n6\n0\n",
            &fit,
            vec!["row 2", "column flight_time", "leave the cell empty"],
        ),
        ("carry [yd]\n", &fit, vec!["no rows"]),
        (
            "carry [yd],aero.cd0\n200,0.2\n210,0.2\n",
            &fit,
            vec!["aero.cd0", "cannot be fitted"],
        ),
        (
            "carry [yd]\n200\n",
            &["--fit", "aero.cd00"],
            vec!["did you mean 'aero.cd0'"],
        ),
    ] {
        let file = table(text);
        let answered = longdrive(&[&["calibrate", file.path().to_str().unwrap()], fit].concat());
        assert_eq!(
            (answered.status, answered.out.as_str()),
            (2, ""),
            "{text}: {}",
            answered.err
        );
        for word in words {
            assert!(
                answered.err.contains(word),
                "{text}: '{word}' is not in {}",
                answered.err
            );
        }
    }
}

/// One launch column has a dotted name, and the others have plain names. A fit and a sweep read the
/// whole launch.
#[test]
fn a_launch_by_names_of_both_kinds_is_read_whole() {
    let rest = "launch_angle [deg],backspin [rpm],carry [yd]\n150,9,2500,230\n";
    let tables = ["launch.ball_speed [mph]", "ball_speed [mph]"]
        .map(|head| table(&format!("{head},{rest}")));
    let files = tables
        .each_ref()
        .map(|table| table.path().to_str().unwrap());
    let [mixed, plain] = files.map(|file| json(&["calibrate", file, "--fit", "aero.cd0"]).1);
    assert!(
        mixed["data"]["launch_conditions"] == true && mixed["estimates"] == plain["estimates"],
        "{mixed}"
    );
    let swept = files.map(|file| longdrive(&["sweep", "--points", file]).out);
    let rows = swept
        .each_ref()
        .map(|out| out.lines().nth(1).unwrap_or_default());
    assert!(
        rows[0] == rows[1] && rows[0].contains(",landed,"),
        "{swept:?}"
    );
}

/// `Offline` of a Foresight export is the lateral position at rest, in each column of this name.
#[test]
fn a_second_offline_column_of_foresight_is_a_rest_position_too() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/data/shots/foresight.csv");
    let text = std::fs::read_to_string(file).unwrap();
    let ends = [",Offline (yds L-/R+)", ",-4.0"]
        .into_iter()
        .chain(std::iter::repeat(""));
    let lines = text.lines().zip(ends);
    let text: String = lines.map(|(line, end)| format!("{line}{end}\n")).collect();
    let table = ShotTable::read(&Setup::modern_driver(), "foresight.csv", text.as_bytes()).unwrap();
    let remarks: Vec<String> = table.remarks.iter().map(ToString::to_string).collect();
    let is_named = remarks.iter().any(|remark| {
        remark.contains("the rest position is not compared") && remark.ends_with("Offline, Offline")
    });
    assert!(is_named, "{remarks:?}");
}

/// An export of Foresight: a spin axis without a unit but with its side, a summary at the end, and
/// a shot without ball data.
#[test]
fn exports_omit_summaries_and_incomplete_rows_by_name_and_have_angles_in_degrees() {
    let head =
        "Shot,Ball Speed (mph),Launch Angle,Side Angle,Total Spin (rpm),Spin Axis,Carry (yd)\n";
    let shots = "1,160,12.0,1.5 R,2500,6.8 L,262\n2,,11.0,0.5 L,2400,2.0 R,\n3,150,13.0,0.5 \
                 L,2600,2.0 R,240\n4,151,13.0,0,2600,0,\n";
    let below = "Average,155,12.5,0.5 R,2550,2.4 L,251\nStd. Dev.,5,0.5,1,50,4.4,11\n";
    let setup = Setup::modern_driver();
    let read = |text: &str| ShotTable::read(&setup, "export.csv", text.as_bytes());
    let table = read(&[head, shots, below].concat()).unwrap();
    let rows: Vec<usize> = table.shots.iter().map(|shot| shot.row).collect();
    assert_eq!(rows, [1, 3]);
    let (launch, degree) = (launch(&table.shots[0]), 1.0_f64.to_radians());
    for (angle, degrees) in [
        (launch.launch_angle(), 12.0),
        (launch.launch_direction(), 1.5),
        (launch.spin_axis(), -6.8),
    ] {
        assert!(
            (angle - degrees * degree).abs() < 1e-12,
            "{angle} {degrees}"
        );
    }
    for sentence in [
        "rows left out, since they sum up other rows: row 5 (Average), row 6 (Std. Dev.)",
        "rows left out, since they lack a value that every shot needs: row 2 (Ball Speed), row 4 \
         (nothing is measured)",
        "Launch Angle, Side Angle, Spin Axis are read in degrees",
    ] {
        assert!(
            table
                .remarks
                .iter()
                .any(|remark| remark.to_string().contains(sentence)),
            "{sentence}: {:?}",
            table.remarks
        );
    }
    // an export of summaries has no usable shot; if another table has no usable row, the message
    // gives the reason for its first row
    let error = read(&[head, below].concat()).unwrap_err().to_string();
    assert!(
        error.contains("it has no usable shot (rows left out, since they sum up other rows: "),
        "{error}"
    );
    let error =
        read("ball_speed [mph],launch_angle [deg],backspin [rpm],carry [yd]\n,12,2500,262\n")
            .unwrap_err();
    assert!(
        error
            .to_string()
            .contains("row 1, column ball_speed: the cell is empty"),
        "{error}"
    );
    let error = read(
        "ball_speed [mph],launch_angle [deg],backspin [rpm],carry [yd]\nAverage,12,2500,262\n",
    )
    .unwrap_err();
    assert!(
        error.to_string().contains("'Average' is not a number"),
        "{error}"
    );
    let error =
        read("ball_speed [mph],launch_angle [deg],backspin [rpm],carry [yd]\n3000,12,2500,262\n")
            .unwrap_err();
    assert!(
        error
            .to_string()
            .contains("row 1: ball_speed: 3000 mph is outside of the range of drives"),
        "{error}"
    );
}

/// A row without a speed, and two rows whose backspin and spin differ.
#[test]
fn a_reason_is_a_warning_or_a_remark() {
    let text = "ball_speed [mph],launch_angle [deg],spin [rpm],backspin [rpm],carry [yd]\n\
                160,11,2600,2600,262\n,11,2600,2600,262\n\
                160,11,2600,4000,262\n160,11,2600,4000,262\n";
    let table = ShotTable::read(&Setup::modern_driver(), "a", text.as_bytes()).unwrap();
    let texts = |messages: &[Message]| -> Vec<String> {
        messages.iter().map(ToString::to_string).collect()
    };
    let (warnings, remarks) = (texts(&table.warnings), texts(&table.remarks));
    assert_eq!(warnings.len(), 2, "{warnings:?}");
    for (warning, says) in warnings.iter().zip([
        "rows left out, since they lack a value that every shot needs: row 2 (ball_speed)",
        "row 3: ",
    ]) {
        assert!(warning.starts_with(says), "{warning}");
    }
    for remark in remarks {
        assert!(
            !remark.contains("row 2") && !remark.contains("row 3"),
            "{remark}"
        );
    }
}

#[test]
fn default_uncertainties_have_a_source_or_are_marked_as_assumed() {
    for outcome in Outcome::OF_DRIVES {
        let source = outcome.instrument().unwrap().source().to_string();
        let is_read = ["golflaunchlab.com", "docs/sources.md"]
            .iter()
            .any(|place| source.contains(place));
        assert!(
            is_read || source.starts_with("assumed: "),
            "{}: {source}",
            outcome.name()
        );
    }
}

/// A table of deliveries of the default setup at these club speeds, with the computed outcomes
/// `of`. If `sigma` is stated, it is the uncertainty of each outcome.
fn table_of_deliveries(speeds: &[f64], of: &[Outcome], sigma: Option<f64>) -> String {
    let sigmas = |outcome: &Outcome| {
        sigma.map_or(String::new(), |_| format!(",sigma {}", with_unit(*outcome)))
    };
    let heads: Vec<String> = of
        .iter()
        .map(|outcome| with_unit(*outcome) + &sigmas(outcome))
        .collect();
    let mut text = format!("swing.speed [m/s],{}\n", heads.join(","));
    for speed in speeds {
        let mut setup = Setup::modern_driver();
        setup.swing.speed = *speed;
        let drive = Drive::new(&setup).unwrap();
        let cell = |outcome: &Outcome| {
            let value = format!("{}", outcome.of(&drive).unwrap());
            value + &sigma.map_or(String::new(), |sigma| format!(",{sigma}"))
        };
        let cells: Vec<String> = of.iter().map(cell).collect();
        writeln!(text, "{speed},{}", cells.join(",")).unwrap();
    }
    text
}

fn with_unit(outcome: Outcome) -> String {
    match outcome.quantity().si {
        "" => outcome.name().to_owned(),
        si => format!("{} [{si}]", outcome.name()),
    }
}

/// Runs `calibrate` on a table: exit status, text on one line, and JSON.
fn text_and_json(text: &str, arguments: &[&str]) -> (i32, String, serde_json::Value) {
    let file = table(text);
    let question = [
        &["calibrate", file.path().to_str().unwrap(), "modern-driver"],
        arguments,
    ]
    .concat();
    let (status, found) = json(&question);
    let answered = longdrive(&question);
    assert_eq!(answered.status, status, "{}", answered.err);
    let out = on_one_line(&answered.out);
    for word in ["NaN", " inf"] {
        assert!(
            !out.contains(word) && !found.to_string().contains(word),
            "{out}"
        );
    }
    (status, out, found)
}

#[test]
fn exact_fits_without_residuals_are_converged() {
    // the rows were flown with the setup's own step; with another step the residuals would not
    // vanish
    let fit = [
        "--own-step",
        "--fit",
        "aero.cd0",
        "--fit",
        "aero.cl_max",
        "--set",
        "aero.cd0=0.2",
        "--set",
        "aero.cl_max=0.4",
    ];
    for (speeds, outcomes, sigma) in [
        // cases with as many data as parameters, and with more data
        (&[45.0, 50.0][..], &[Outcome::Carry][..], Some(0.5)),
        (&[45.0, 50.0], &[Outcome::Carry], None),
        (&[50.0], &[Outcome::Carry, Outcome::ApexHeight], None),
        (
            &[42.0, 45.0, 48.0, 52.0],
            &[Outcome::Carry, Outcome::ApexHeight],
            Some(1.0),
        ),
        (
            &[42.0, 45.0, 48.0, 52.0],
            &[Outcome::Carry, Outcome::ApexHeight],
            None,
        ),
    ] {
        let (status, text, found) =
            text_and_json(&table_of_deliveries(speeds, outcomes, sigma), &fit);
        assert_eq!(
            (status, found["status"].as_str()),
            (0, Some("converged")),
            "{text}"
        );
        for name in ["aero.cd0", "aero.cl_max"] {
            let estimate = &found["estimates"][name];
            let truth = Setup::modern_driver()
                .value(Setup::modern_driver().variable(name).unwrap())
                .unwrap();
            assert!(
                (number(&estimate["value"]) - truth).abs() < 1e-9,
                "{estimate} {truth}"
            );
            assert_eq!(estimate["determined"], true, "{text}");
        }
        assert_eq!(found["undetermined"].as_array().unwrap().len(), 0);
        assert!(
            !text.contains("not determined") && text.contains("exact to rounding"),
            "{text}"
        );
        assert!(
            !text.contains("since not every uncertainty is stated"),
            "{text}"
        );
        assert_eq!(
            text.contains("follow from the stated uncertainties"),
            sigma.is_some(),
            "{text}"
        );
    }
}

#[test]
fn confounded_parameters_are_no_answer() {
    // shaft lean and loft rotate the face by their sum: the launch hardly depends on their
    // difference
    let launch = [Outcome::BallSpeed, Outcome::LaunchAngle, Outcome::Spin];
    let text = table_of_deliveries(&[42.0, 46.0, 50.0, 54.0], &launch, Some(0.3));
    for start in ["0deg", "4deg"] {
        let lean = format!("swing.shaft_lean={start}");
        let (status, answered, found) = text_and_json(
            &text,
            &[
                "--fit",
                "swing.shaft_lean",
                "--fit",
                "club.loft",
                "--set",
                &lean,
            ],
        );
        assert_eq!(
            (status, found["status"].as_str()),
            (1, Some("undetermined")),
            "{answered}"
        );
        let message = found["message"].as_str().unwrap();
        assert!(
            message.contains("the data do not determine swing.shaft_lean and club.loft separately"),
            "{message}"
        );
        for name in ["swing.shaft_lean", "club.loft"] {
            let estimate = &found["estimates"][name];
            assert!(
                estimate["standard_uncertainty"].is_null() && estimate["determined"] == false,
                "{estimate}"
            );
            assert!(
                number(&estimate["value"]).abs() < 45.0_f64.to_radians(),
                "{name} ran off: {estimate}"
            );
        }
        assert!(
            answered.contains("not determined by the data"),
            "{answered}"
        );
    }
    // no measured value depends on the viscosity, because the law does not use the Reynolds number.
    // One fit starts inside the range of the viscosity, the other fit at a bound of the range
    for range in ["air.viscosity", "air.viscosity=1e-5Pas..1.837e-5Pas"] {
        let (status, answered, found) = text_and_json(
            &table_of_deliveries(&[45.0, 50.0], &[Outcome::Carry], None),
            &[
                "--set",
                "aero.law=linear",
                "--fit",
                "aero.cd",
                "--fit",
                &range.replace("Pas", " Pa s"),
            ],
        );
        assert_eq!(
            (status, found["status"].as_str()),
            (1, Some("undetermined")),
            "{answered}"
        );
        assert!(
            answered.contains("the data do not determine air.viscosity"),
            "{answered}"
        );
        assert!(
            number(&found["estimates"]["aero.cd"]["standard_uncertainty"]) > 0.0,
            "{answered}"
        );
    }
}

#[test]
fn one_datum_and_parameters_all_on_bounds_are_reported() {
    let text = table_of_deliveries(&[50.0], &[Outcome::Carry], None);
    let (status, answered, _) = text_and_json(&text, &["--fit", "aero.cd0"]);
    assert_eq!(status, 0, "{answered}");
    // even with the smallest drag of its range, the computed carry is shorter than the measured one
    let long = text.replace("\n50,2", "\n50,4");
    assert_ne!(long, text);
    let (status, answered, found) = text_and_json(&long, &["--fit", "aero.cd0=0.2..0.3"]);
    // the residual is 85 standard uncertainties
    assert_eq!(
        (status, found["status"].as_str()),
        (1, Some("misfit")),
        "{answered}"
    );
    assert_eq!(found["estimates"]["aero.cd0"]["at_bound"], true);
    assert!(answered.contains("on the bound of its range"), "{answered}");
}

#[test]
fn rows_whose_squares_overflow_are_named() {
    let row = |apex: &str, sigma: &str| {
        format!(
            "swing.speed [m/s],apex_downrange [m],sigma apex_downrange \
             [m]\n45,120,1\n50,{apex},{sigma}\n55,160,1\n"
        )
    };
    let fit = ["--fit", "aero.cd0"];
    for (text, words) in [
        (
            row("1e300", "1"),
            ["row 2", "apex_downrange", "outside its range"],
        ),
        (
            row("140", "1e-300"),
            [
                "row 2",
                "standard uncertainty",
                "correct the value or its sigma",
            ],
        ),
    ] {
        let file = table(&text);
        let answered =
            longdrive(&[&["calibrate", file.path().to_str().unwrap()], &fit[..]].concat());
        assert_eq!(
            (answered.status, answered.out.as_str()),
            (2, ""),
            "{}",
            answered.err
        );
        for word in words {
            assert!(
                answered.err.contains(word),
                "'{word}' is not in {}",
                answered.err
            );
        }
    }
    // the residual of row 2 is 9e10 standard uncertainties, so the other rows have no weight
    let (status, answered, found) =
        text_and_json(&row("9e8", "1e-2"), &["--fit", "aero.cd0=0.1..0.4"]);
    assert_eq!(
        (status, found["status"].as_str()),
        (1, Some("outweighed")),
        "{answered}"
    );
    assert!(
        found["message"]
            .as_str()
            .unwrap()
            .contains("row 2: apex_downrange is"),
        "{answered}"
    );
}

/// An observer that interrupts any fit after a number of iterations.
fn interrupting(after: u64) -> FitObserver {
    let (interrupt, seen) = (Arc::new(AtomicBool::new(false)), AtomicU64::new(0));
    let flag = interrupt.clone();
    let count = move |_, _| {
        if seen.fetch_add(1, Ordering::Relaxed) + 1 >= after {
            flag.store(true, Ordering::Relaxed);
        }
    };
    FitObserver {
        iteration: Some(Arc::new(count)),
        interrupt,
    }
}

#[test]
fn interrupted_folds_are_omitted_and_counted() {
    let text = shots(&mut Random::seeded(11), 1.0);
    let setup = elsewhere();
    let table = ShotTable::read(&setup, "shots.csv", text.as_bytes()).unwrap();
    let plan = FitPlan::read(&setup, &LAW.map(str::to_owned)).unwrap();
    let whole = held_out(&setup, &table, &plan, 4, &FitObserver::default()).unwrap();
    assert_eq!(
        (
            whole.count(CalibrationStatus::CONVERGED),
            whole.is_interrupted(),
            whole.residuals.len()
        ),
        (4, false, 24)
    );

    let at_once = held_out(&setup, &table, &plan, 4, &interrupting(1)).unwrap();
    assert_eq!(
        (
            at_once.count(CalibrationStatus::INTERRUPTED),
            at_once.mean_square()
        ),
        (4, None)
    );
    let mut partly = 0;
    for after in 2..40 {
        let part = held_out(&setup, &table, &plan, 4, &interrupting(after)).unwrap();
        let done = 4 - part.count(CalibrationStatus::INTERRUPTED);
        assert_eq!(part.residuals.len(), 6 * done, "after {after}");
        // the result equals the result of the uninterrupted fit
        for residual in &part.residuals {
            let same = whole
                .residuals
                .iter()
                .find(|r| (r.row, r.outcome) == (residual.row, residual.outcome));
            assert_eq!(same.unwrap().residual, residual.residual);
        }
        partly += usize::from(done > 0 && part.is_interrupted());
    }
    assert!(partly > 0);

    let found = calibrate(&setup, &table, &plan, &interrupting(2)).unwrap();
    assert_eq!(
        found.verdict.status,
        CalibrationStatus::INTERRUPTED,
        "{}",
        found.verdict.message
    );
}

/// Starts at which the fit cannot begin are counted by status, and the text advises what to do.
/// Here five of six starts cannot begin.
#[test]
fn starts_that_cannot_begin_are_counted() {
    let shots = concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/shots.csv");
    let fit = [
        "calibrate",
        shots,
        "modern-driver",
        "--fit",
        "aero.cd0",
        "--fit",
        "aero.cl_max",
        "--starts",
        "6",
    ];
    let (_, found) = json(&fit);
    let others: Vec<(&str, u64)> = found["starts"]["elsewhere"]
        .as_object()
        .unwrap()
        .iter()
        .map(|(status, count)| (status.as_str(), count.as_u64().unwrap()))
        .collect();
    let same = found["starts"]["same"].as_u64().unwrap();
    assert_eq!(
        same + others.iter().map(|(_, count)| count).sum::<u64>(),
        6,
        "{}",
        found["starts"]
    );
    let answered = on_one_line(&longdrive(&fit).out);
    assert_eq!(others, [("undefined", 5)], "{found}");
    let sentence = "1 of 6 starts ended at the sum of squares of this fit; 5 could not begin, because \
                in some rows the ball does not fly with the parameters of the start.";
    assert!(answered.contains(sentence), "{answered}");
    assert!(
        answered.contains("with narrower ranges more of the starts reach a minimum"),
        "{answered}"
    );
}

#[test]
fn iterations_of_several_searches_name_their_search() {
    let shots = concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/shots.csv");
    let sentence = |starts| {
        longdrive(&[
            "calibrate",
            shots,
            "--fit",
            "aero.cd0=0.2..0.25",
            "--starts",
            starts,
        ])
        .err
    };
    let first = |answered: &str| answered.lines().next().unwrap().to_owned();
    let (one, two) = (sentence("1"), sentence("2"));
    assert!(first(&one).starts_with("iteration   0  half"), "{one}");
    assert!(
        first(&two).starts_with("search 1  iteration   0  half"),
        "{two}"
    );
    assert_eq!(
        two.matches("search 2  iteration   0  half").count(),
        1,
        "{two}"
    );
}

/// A search that reached a minimum keeps its status if other searches are stopped. The stopped
/// searches do not count as ended.
#[test]
fn an_interrupted_calibration_from_many_starts_names_its_best_fit() {
    let mut setup = elsewhere();
    // small steps, so that the interrupt comes while some searches still run
    setup
        .set_all([("flight.method", "rk4"), ("flight.step", "20 ms")])
        .unwrap();
    let text = shots(&mut Random::seeded(11), 1.0);
    let table = ShotTable::read(&setup, "shots.csv", text.as_bytes()).unwrap();
    let plan = FitPlan {
        starts: 60,
        ..FitPlan::read(&setup, &LAW.map(str::to_owned)).unwrap()
    };
    let partly = (1..40).map(|k| calibrate(&setup, &table, &plan, &interrupting(25 * k)).unwrap());
    let found = partly
        .into_iter()
        .find(|found| found.is_minimum && found.stopped > 0)
        .unwrap();
    let ended = 60 - found.stopped;
    assert_eq!(found.verdict.status, CalibrationStatus::INTERRUPTED);
    assert!(
        found.starts.at_best <= ended,
        "{:?} of {ended}",
        found.starts.at_best
    );
    let report = CalibrationReport::new(&table, &found, &[]);
    let text = on_one_line(&report.document(System::Us).text(&WHOLE));
    let says = format!(
        "interrupted: {ended} of 60 searches ended, and {} were stopped",
        found.stopped
    );
    assert!(
        text.contains(&says) && text.contains("these values are a minimum"),
        "{text}"
    );
    assert!(
        text.contains("with a complete search ended at the sum") && !text.contains("not a minimum"),
        "{text}"
    );
    // if the best search was stopped, the calibration is interrupted
    let at_once = calibrate(&setup, &table, &plan, &interrupting(1)).unwrap();
    assert!(
        !at_once.is_minimum && at_once.verdict.status == CalibrationStatus::INTERRUPTED,
        "{}",
        at_once.verdict.message
    );
}

#[test]
fn an_interrupted_comparison_says_so_and_ends_with_status_1() {
    let setup = elsewhere();
    let text = shots(&mut Random::seeded(11), 1.0);
    let table = ShotTable::read(&setup, "shots.csv", text.as_bytes()).unwrap();
    let plan = FitPlan::read(&setup, &LAW.map(str::to_owned)).unwrap();
    let found = calibrate(&setup, &table, &plan, &FitObserver::default()).unwrap();
    let partly =
        (2..60).map(|after| held_out(&setup, &table, &plan, 4, &interrupting(after)).unwrap());
    let held = partly
        .into_iter()
        .find(|held| (1..4).contains(&held.count(CalibrationStatus::INTERRUPTED)))
        .unwrap();
    let stopped = held.count(CalibrationStatus::INTERRUPTED);
    let never = held_out(&setup, &table, &plan, 4, &interrupting(1)).unwrap();
    let held = [
        ("linear, fitted as above".to_owned(), held),
        ("robinson, all coefficients fitted".into(), never),
    ];
    let report = CalibrationReport::new(&table, &found, &held);
    assert!(report.interrupted && report.status() == CalibrationStatus::INTERRUPTED);
    let text = on_one_line(&report.document(System::Us).text(&WHOLE));
    assert!(
        text.contains(&format!(
            "linear, fitted as above: interrupted, {stopped} of 4 fits left out"
        )),
        "{text}"
    );
    assert!(
        text.contains("robinson, all coefficients fitted: interrupted, nothing was fitted"),
        "{text}"
    );
    let json = serde_json::to_value(Reply::of(&report, vec![])).unwrap();
    assert_eq!(json["status"], "interrupted");
    assert_eq!(
        (
            &json["interrupted"],
            &json["held_out"][1]["fits"]["interrupted"]
        ),
        (&true.into(), &4.into())
    );
    assert!(json["held_out"][1]["rms_in_sigma"].is_null());
}

#[test]
fn a_launch_monitors_export_is_read_as_it_is_written() {
    // the same three shots in the formats of four makers; the launch is flown, and unused columns
    // are listed
    let trackman = "sep=;\nDate;Club Speed;Ball Speed;Smash Factor;Launch Angle;Launch \
                    Direction;Spin Rate;Spin Axis;Carry Flat - Length;\
                    Carry Flat - Side;Est. Total Flat - Length\n\
                    ;[mph];[mph];;[deg];[deg];[rpm];[deg];[yds];[yds];[yds]\n\
                    1.1.;105,0;153,5;1,46;10,5;-1,2;2500;3,0;241,0;-2,0;260\n1.1.;104,0;152,0;1,46;11,5;0,5;2600;-2,0;238,0;1,0;255\n\
                    1.1.;106,0;155,0;1,46;9,5;0,0;2400;0,0;243,0;0,0;262\n";
    let garmin = "Club Type,Club Speed,Club Path,Ball Speed,Launch Angle,Launch \
                  Direction,Backspin,Sidespin,Spin Rate,Spin Axis,Carry Distance,\
                  Carry Deviation \
                  Distance,Note\n,[mph],[deg],[mph],[deg],[deg],[rpm],[rpm],[rpm],[deg],[yd],[yd],\n\
                  Driver,105,1,153.5,10.5,-1.2,2496,131,2500,3.0,241.0,-2.0,\nDriver,104,1,152,11.5,0.5,2598,-91,2600,-2.0,238.0,1.0,\n\
                  Driver,106,1,155,9.5,0,2400,0,2400,0,243.0,0,\n";
    let foresight = "Ball Speed (mph)\tLaunch Angle (deg)\tSide Angle (deg)\tTotal Spin \
                     (rpm)\tSpin Axis (deg)\tCarry (yds)\tOffline (yds)\n\
                     153.5\t10.5\t1.2 L\t2500\t3.0 R\t241.0\t2.0L\n152\t11.5\t0.5R\t2600\t2.0 \
                     L\t238.0\t1.0 R\n155\t9.5\t0\t2400\t0\t243.0\t0\n";
    let words = "Ball Speed MPH,Launch V (°),Launch H (°),Spin Rate rpm,Spin Axis (°),Carry \
                 Yards,Lateral Yards\n\
                 153.5,10.5,-1.2,2500,3,241,-2\n152,11.5,0.5,2600,-2,238,1\n155,9.5,0,2400,0,243,0\n";
    let own = "ball_speed [mph],launch_angle [deg],launch_direction [deg],spin [rpm],spin_axis \
               [deg],carry [yd],lateral [yd]\n\
               153.5,10.5,-1.2,2500,3,241,-2\n152,11.5,0.5,2600,-2,238,1\n155,9.5,0,2400,0,243,0\n";
    let setup = Setup::modern_driver();
    let read = |text: &str| ShotTable::read(&setup, "shots.csv", text.as_bytes()).unwrap();
    let expected = read(own);
    assert_eq!(expected.sigma_origin, SigmaOrigin::Instruments);
    for text in [trackman, garmin, foresight, words] {
        let table = read(text);
        assert!(table.is_launched && table.shots.len() == 3, "{table:?}");
        for (shot, other) in table.shots.iter().zip(&expected.shots) {
            assert_eq!(
                (&shot.measured, shot.inputs.len()),
                (&other.measured, other.inputs.len()),
                "{text}"
            );
            let (launch, same) = (launch(shot), launch(other));
            assert!(
                (launch.spin_axis() - same.spin_axis()).abs() < 1e-12
                    && launch.velocity == same.velocity,
                "{text}"
            );
        }
    }
    // a measured carry is the distance to the landing point, with the uncertainty of the instrument
    let carry = expected.shots[0].measured[0];
    assert_eq!(
        (carry.outcome, carry.sigma),
        (Outcome::CarryDistance, 3.0 * 0.9144)
    );
    let remarks = read(trackman)
        .remarks
        .iter()
        .map(ToString::to_string)
        .collect::<Vec<_>>()
        .join("\n");
    for words in [
        "not used: Date\n",
        "the ground of the launch monitor is not known: Est. Total Flat - Length",
        "left out: Club Speed, Smash Factor",
        "3 yd is taken for each",
    ] {
        assert!(remarks.contains(words), "'{words}' is not in {remarks}");
    }
    // without a launch the club columns are inputs
    let club = read(
        "Club Speed (mph),Club Path (deg),Face Angle (deg),Carry (yds)\n105,2.0 L,1 \
         R,240\n103,0,0,236\n",
    );
    let names: Vec<&str> = club.shots[0]
        .inputs
        .iter()
        .map(|(parameter, _)| parameter.name)
        .collect();
    assert_eq!(
        (club.is_launched, names),
        (false, vec!["swing.speed", "swing.path", "swing.face_angle"])
    );
    assert!((club.shots[0].inputs[1].1 + 2.0_f64.to_radians()).abs() < 1e-15);
    // errors: a misspelt name, a name of this program without its unit, and a number with both a
    // sign and a side
    for (text, words) in [
        (
            "Ball Speed (mph),Launch Angle (deg),Spin Rate (rpm),cary_distance \
             [yd]\n153,10,2500,240\n",
            "column 4",
        ),
        ("carry,club.loft [deg]\n220,10\n", "'carry [yd]'"),
        (
            "Ball Speed (mph),Launch Angle (deg),Spin Rate (rpm),Carry (yds)\n153,10,2500,-3 L\n",
            "'-3 L' is not a number",
        ),
    ] {
        let error = ShotTable::read(&setup, "shots.csv", text.as_bytes())
            .unwrap_err()
            .to_string();
        assert!(error.contains(words), "'{words}' is not in {error}");
    }
}

#[test]
fn the_sample_of_shots_is_fitted() {
    let sample = concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/shots.csv");
    let (status, found) = json(&[
        "calibrate",
        sample,
        "--fit",
        "aero.cd0",
        "--fit",
        "aero.cl_max",
    ]);
    assert_eq!(
        (status, found["status"].as_str()),
        (0, Some("converged")),
        "{found}"
    );
    // the shots were made with these coefficients, and with noise in launch and flight: the
    // estimates are within three standard errors
    for name in ["aero.cd0", "aero.cl_max"] {
        let truth = Setup::modern_driver()
            .value(Setup::modern_driver().variable(name).unwrap())
            .unwrap();
        let estimate = &found["estimates"][name];
        let error = number(&estimate["standard_uncertainty"]);
        assert!(
            (number(&estimate["value"]) - truth).abs() < 3.0 * error && error < 0.1,
            "{name}: {estimate} {truth}"
        );
    }
    assert_eq!(
        (&found["data"]["shots"], &found["data"]["launch_conditions"]),
        (&12.into(), &true.into())
    );
}

/// The first table has carries of a ball with a drag coefficient of 0.27. Carries 40 yd longer need
/// less drag than the range of the fit allows. The warning is on standard error and in JSON.
#[test]
fn a_fit_without_agreement_or_on_a_bound_has_a_warning() {
    let flown = |launch: [f64; 3]| {
        let [speed, angle, spin] = launch;
        let launch = format!("ball_speed={speed}m/s,launch_angle={angle}deg,backspin={spin}rpm");
        let law = ["--set", "aero.law=robinson", "--set", "aero.cd0=0.27"];
        let (_, drive) = json(
            &[
                &["simulate", "modern-driver", "--launch", &launch],
                &law[..],
            ]
            .concat(),
        );
        number(&drive["flight"]["carry"]) / 0.9144
    };
    let launches = [
        [66.0, 11.0, 2600.0],
        [70.0, 13.0, 2300.0],
        [73.0, 9.5, 3100.0],
        [75.0, 12.0, 2500.0],
    ];
    let rows = |more: f64| {
        let row = |launch: &[f64; 3]| {
            format!(
                "{},{},{},{},1\n",
                launch[0],
                launch[1],
                launch[2],
                flown(*launch) + more
            )
        };
        launches.iter().map(row).collect::<String>()
    };
    let head = "ball_speed [m/s],launch_angle [deg],backspin [rpm],carry [yd],sigma carry [yd]\n";
    let fitted = |rows: &str, fit: &str| {
        let file = table(&format!("{head}{rows}"));
        let requested = [
            "calibrate",
            file.path().to_str().unwrap(),
            "modern-driver",
            "--set",
            "aero.law=robinson",
            "--fit",
            fit,
        ];
        let (_, found) = json(&requested);
        let in_words = on_one_line(&longdrive(&requested).err);
        let warnings = found["warnings"]
            .as_array()
            .unwrap()
            .iter()
            .map(|one| one.as_str().unwrap().to_owned());
        let warnings: Vec<_> = warnings.collect();
        for warning in &warnings {
            assert!(
                in_words.contains(&format!("warning: {warning}")),
                "{warning}: {in_words}"
            );
        }
        (found, warnings.join("\n"))
    };
    let (found, warnings) = fitted(&rows(0.0), "aero.cd0");
    assert!(
        warnings.is_empty()
            && (number(&found["estimates"]["aero.cd0"]["value"]) - 0.27).abs() < 1e-6,
        "{warnings}"
    );
    let (found, warnings) = fitted(&rows(40.0), "aero.cd0=0.25..0.6");
    // carries 40 yd too long, at a standard uncertainty of 1 yd, are a misfit of 40. The smallest
    // drag of the range reduces the misfit. The warning prints √(χ²/ν)
    let off = (number(&found["chi_square"]) / number(&found["degrees_of_freedom"])).sqrt();
    assert!(
        off > 20.0
            && warnings.contains(&format!(
                "the values miss the fit by {off:.1} of their standard"
            )),
        "{off}: {warnings}"
    );
    assert!(
        warnings.contains("aero.cd0 ended at 0.25, the end of its range"),
        "{warnings}"
    );
}

/// With Huber's loss, outliers alone are no misfit: a fit is judged by the robust scale, which is
/// that of the standard errors.
#[test]
fn outliers_alone_are_no_misfit_with_hubers_loss() {
    let warnings = |carries: &[f64], sigma: f64| {
        let rows = carries.iter().map(|carry| format!("{carry},{sigma}\n"));
        let text = format!("carry [yd],sigma carry [yd]\n{}", rows.collect::<String>());
        let file = table(&text);
        let file = file.path().to_str().unwrap();
        let fit = ["calibrate", file, "tour-average", "--fit", "aero.cd0"];
        let (_, found) = json(&[&fit[..], &["--huber"]].concat());
        (found["warnings"].to_string(), found)
    };
    // normal scores of 20 values, and two outliers
    let noise = [0.06, 0.19, 0.32, 0.45, 0.59, 0.74, 0.92, 1.13, 1.4, 1.87];
    let mut carries: Vec<f64> = noise.iter().flat_map(|z| [270.0 + z, 270.0 - z]).collect();
    carries.extend([320.0, 310.0]);
    let (right, found) = warnings(&carries, 1.0);
    assert!(!right.contains("miss the fit"), "{right} {found}");
    let (small, found) = warnings(&carries, 0.2);
    let scale = number(&found["uncertainty_scale"]);
    let says = format!(
        "the values miss the fit by {} of their standard uncertainties (robust scale of Huber's \
         loss), where noise alone gives 1",
        longdrive::units::significant(scale, 3)
    );
    assert!(scale > 3.0 && small.contains(&says), "{scale}: {small}");
    // every residual is beyond Huber's threshold, where it has no influence on the scale
    let (none, found) = warnings(&[230.0, 260.0, 280.0, 310.0], 0.01);
    let says = "miss the fit by more than 1.345 of their standard uncertainties, without exception";
    assert!(
        none.contains(says) && found["uncertainty_scale"].is_null(),
        "{found}"
    );
}

/// Only the second section has columns for the wind: its speed and its direction.
#[test]
fn a_component_of_the_wind_is_not_fitted_to_shots_of_which_some_state_its_speed() {
    let launch = "Ball Speed [mph],Launch Angle [deg],Spin Rate [rpm],Carry [yd]";
    let row = "150,12,2500,240";
    let text = format!("{launch}\n{row}\n{launch},wind.speed [m/s],wind.from [deg]\n{row},3,0\n");
    let setup = Setup::modern_driver();
    let table = ShotTable::read(&setup, "a.csv", text.as_bytes()).unwrap();
    let plan = FitPlan::read(&setup, &["wind.downrange=-5m/s..5m/s".into()]).unwrap();
    let error = calibrate(&setup, &table, &plan, &FitObserver::default()).unwrap_err();
    let words = error.to_string();
    assert!(
        words.contains("wind.speed") && words.contains("leave out one of the two"),
        "{words}"
    );
}

#[test]
fn impossible_measured_values_are_refused_with_their_row() {
    let setup = Setup::modern_driver();
    let text = "ball_speed [m/s],launch_angle [deg],backspin [rpm],carry \
                [m]\n60,12,2500,180\n70,11,2500,220\n";
    let read = ShotTable::read(&setup, "shots.csv", text.as_bytes()).unwrap();
    let plan = FitPlan::read(&setup, &["aero.cd0".to_owned()]).unwrap();
    for (value, sigma, says) in [
        (f64::NAN, 1.0, "measured as NaN"),
        (180.0, 0.0, "uncertainty of 0"),
        (180.0, -1.0, "uncertainty of -1.09"),
    ] {
        let mut table = read.clone();
        (
            table.shots[1].measured[0].value,
            table.shots[1].measured[0].sigma,
        ) = (value, sigma);
        let error = calibrate(&setup, &table, &plan, &FitObserver::default())
            .unwrap_err()
            .to_string();
        assert!(
            error.contains("row 2: carry") && error.contains(says),
            "{error}"
        );
    }
}

/// Wrong lengths are programming errors: they panic with both lengths. Numbers that are not finite
/// return an error.
#[test]
fn statistics_of_a_ragged_jacobian_panic_and_of_nan_are_refused() {
    let fitted = [FitRange {
        is_free: true,
        width: 1.0,
    }; 2];
    let of = |residuals: &[f64], jacobian: &[&[f64]]| {
        let jacobian = jacobian.iter().map(|row| row.to_vec()).collect();
        let rows = Rows {
            residuals: residuals.to_vec(),
            jacobian,
        };
        FitStatistics::new(&rows, &fitted, SigmaOrigin::Stated, 0.0, Loss::Squares)
    };
    for (jacobian, rows) in [
        (&[&[1.0, 0.0][..]][..], "[2]"),
        (&[&[1.0, 0.0], &[1.0]], "[2, 1]"),
    ] {
        let answered = panic_of(|| of(&[1.0, 2.0], jacobian));
        assert!(
            answered.contains("2 residuals of 2 parameters") && answered.contains(rows),
            "{answered}"
        );
    }
    let found = of(&[1.0, 2.0], &[&[1.0, 0.0], &[0.0, 1.0]]).unwrap();
    assert!(found.standard_error(1).is_some());
    panic_of(|| found.standard_error(2));
    panic_of(|| found.correlation(0, 2));
    for (residuals, jacobian) in [
        ([f64::NAN, 1.0], [1.0, 0.0]),
        ([1.0, 1.0], [f64::INFINITY, 0.0]),
    ] {
        let error = of(&residuals, &[&jacobian, &[0.0, 1.0]])
            .unwrap_err()
            .to_string();
        assert!(error.contains("must be finite"), "{error}");
    }
}

/// 400 fits with Huber's loss to shots whose noise exceeds the stated uncertainties: the scatter of
/// the estimates is their standard error, and 95 % of the intervals contain the truth. χ² has no
/// probability.
#[test]
fn sampled_coverage_of_intervals_with_hubers_loss() {
    for noise_in_sigmas in [1.0, 2.0] {
        let mut noise = Random::seeded(20_261_130);
        let (mut covered, mut squares, mut errors) = (0, 0.0, 0.0);
        for _ in 0..400 {
            let text = shots(&mut noise, noise_in_sigmas);
            let found = fitted(&text, &truth(), &["aero.cd"], Loss::HUBER);
            assert_eq!(found.statistics.probability, None);
            let estimate = found.estimates[0];
            let (error, off) = (estimate.standard_error.unwrap(), estimate.value - 0.27);
            covered += usize::from(off.abs() <= found.statistics.coverage_factor * error);
            squares += off * off / 400.0;
            errors += error / 400.0;
        }
        let (share, ratio) = (f64::from(covered as u32) / 400.0, errors / squares.sqrt());
        println!("noise {noise_in_sigmas}: coverage {share}, error/scatter {ratio}");
        // within three standard errors: √(0.05·0.95/400) = 0.011, and 1/√800 = 0.035
        assert!((share - 0.95).abs() < 0.033, "{noise_in_sigmas}: {share}");
        assert!((ratio - 1.0).abs() < 0.106, "{noise_in_sigmas}: {ratio}");
    }
}
