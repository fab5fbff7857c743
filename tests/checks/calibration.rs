//! Calibration: known truths found again, honest intervals, exact Jacobians, Winfield & Tan's paper, and bad input.

use crate::command_line::{json, longdrive, number};
use longdrive::derivative::{Evaluator, Order};
use longdrive::launch::Launch;
use longdrive::optimize::least_squares::{Follow, Loss};
use longdrive::study::calibrate::{Calibration, Plan, ShotTable, calibrate};
use longdrive::{Outcome, Setup};
use std::fmt::Write;
use std::io::Write as _;

/// Random numbers with a fixed seed (Steele, Lea & Flood 2014), and normal ones by Box & Muller's transform.
struct Noise(u64);

impl Noise {
    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn normal(&mut self) -> f64 {
        let (u, v) = (1.0 - self.uniform(), self.uniform());
        (-2.0 * u.ln()).sqrt() * (std::f64::consts::TAU * v).cos()
    }
}

/// A setup whose law is known.
fn truth() -> Setup<f64> {
    let mut setup = Setup::default();
    setup
        .set_all([("aero.law", "linear"), ("aero.cd", "0.27"), ("aero.cl_slope", "1.3"), ("flight.step", "0.02")])
        .unwrap();
    setup
}

const SIGMA: [f64; 2] = [2.0, 0.5];

/// Shots of the truth from a launch monitor, with noise of known size in carry and apex, as a table.
fn shots(noise: &mut Noise, size: f64) -> String {
    let setup = truth();
    let mut text =
        "ball_speed,launch_angle [deg],backspin [rpm],carry,sigma carry,apex_height,sigma apex_height\n".to_owned();
    for k in 0..12 {
        let (speed, angle, spin) =
            (55.0 + 1.7 * f64::from(k), 9.0 + f64::from(k * 5 % 7), 1800.0 + 150.0 * f64::from(k * 7 % 12));
        let launch = Launch::with_conditions(speed, angle.to_radians(), 0.0, spin * std::f64::consts::TAU / 60.0, 0.0);
        let outcomes = Evaluator::new(&setup, &[Outcome::Carry, Outcome::ApexHeight], &[], Order::Value).unwrap();
        let values = outcomes.launched(launch).at(&[]).unwrap();
        let [carry, apex] = [0, 1].map(|i| values[i].value + size * SIGMA[i] * noise.normal());
        writeln!(text, "{speed},{angle},{spin},{carry},{},{apex},{}", SIGMA[0], SIGMA[1]).unwrap();
    }
    text
}

fn fitted(text: &str, setup: &Setup<f64>, names: &[&str], loss: Loss) -> Calibration {
    let table = ShotTable::read(setup, "shots.csv", text.as_bytes()).unwrap();
    assert!(table.is_launched && table.has_sigmas);
    let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
    let mut plan = Plan::read(setup, &names).unwrap();
    plan.options.loss = loss;
    calibrate(setup, &table, &plan, &Follow::default()).unwrap()
}

const LAW: [&str; 2] = ["aero.cd", "aero.cl_slope"];

fn elsewhere() -> Setup<f64> {
    let mut setup = truth();
    setup.set_all([("aero.cd", "0.2"), ("aero.cl_slope", "2")]).unwrap();
    setup
}

#[test]
fn exact_truth_is_found_again_from_shots_without_noise() {
    let found = fitted(&shots(&mut Noise(1), 0.0), &elsewhere(), &LAW, Loss::Squares);
    assert!((found.estimates[0].value - 0.27).abs() < 1e-9, "{:?}", found.estimates);
    assert!((found.estimates[1].value - 1.3).abs() < 1e-9, "{:?}", found.estimates);
}

#[test]
fn exact_coverage_of_intervals_over_200_draws_of_noise() {
    let (mut noise, mut covered, mut chi_square) = (Noise(20_261_121), [0; 2], 0.0);
    for _ in 0..200 {
        let found = fitted(&shots(&mut noise, 1.0), &truth(), &LAW, Loss::Squares);
        for (i, truth) in [0.27, 1.3].into_iter().enumerate() {
            let estimate = found.estimates[i];
            let reach = found.statistics.reach * estimate.standard_error.unwrap();
            covered[i] += usize::from((estimate.value - truth).abs() <= reach);
        }
        assert_eq!(found.statistics.degrees_of_freedom, 22);
        chi_square += found.statistics.chi_square / 200.0;
    }
    // 95 % of 400 intervals, and the mean of χ² with 22 degrees of freedom within four of its standard errors
    let share = (covered[0] + covered[1]) as f64 / 400.0;
    println!("coverage {covered:?} of 200 each, mean chi-square {chi_square}");
    assert!((0.93..=0.97).contains(&share), "{covered:?}");
    assert!((chi_square - 22.0).abs() < 4.0 * (44.0_f64 / 200.0).sqrt(), "{chi_square}");
}

#[test]
fn exact_outlier_is_borne_by_hubers_loss() {
    let text = shots(&mut Noise(7), 0.3);
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    // a carry misread by 60 m
    let mut cells: Vec<String> = lines[6].split(',').map(str::to_owned).collect();
    cells[3] = format!("{}", cells[3].parse::<f64>().unwrap() + 60.0);
    lines[6] = cells.join(",");
    let text = lines.join("\n");
    let [squares, huber] =
        [Loss::Squares, Loss::HUBER].map(|loss| fitted(&text, &elsewhere(), &LAW, loss).estimates[0].value);
    assert!((huber - 0.27).abs() < 0.2 * (squares - 0.27).abs(), "{squares} {huber}");
}

#[test]
fn exact_parameters_that_cannot_be_told_apart_are_named() {
    // density and viscosity: the law knows no Reynolds number; drag and lift go with density, so that it trades with both
    let names = ["aero.cd", "aero.cl_slope", "air.density", "air.viscosity"];
    let found = fitted(&shots(&mut Noise(3), 1.0), &truth(), &names, Loss::Squares);
    let named: Vec<Vec<usize>> =
        found.statistics.undetermined.iter().map(|u| u.parts.iter().map(|(at, _)| *at).collect()).collect();
    assert_eq!(named.len(), 2, "{named:?}");
    assert!(named.contains(&vec![0, 1, 2]) || named.iter().flatten().any(|at| *at == 2), "{named:?}");
    assert!(named.iter().flatten().any(|at| *at == 3), "{named:?}");
    assert!(found.estimates.iter().all(|estimate| estimate.standard_error.is_none()), "{:?}", found.estimates);
}

fn yards(metres: f64) -> f64 {
    metres / 0.9144
}

/// Every printed number, within what one smooth law can do.
#[test]
fn paper_winfield_tan_comes_out_of_the_preset() {
    let (status, found) = json(&["reproduce", "winfield-tan"]);
    assert_eq!(status, 0);
    let printed = &found["printed"];
    let off = |part: &str, key: &str| number(&found[part][key]) - number(&printed[part][key]);
    assert!(yards(off("shot", "carry")).abs() <= 0.3 && off("shot", "flight_time").abs() <= 0.02);
    assert!(yards(off("shot", "apex_height")).abs() <= 0.2 && off("shot", "apex_time").abs() <= 0.1);
    assert!(yards(off("optimum", "carry")).abs() <= 0.3);
    assert_eq!(number(&printed["optimum"]["club.loft"]), 2.74_f64.to_radians());
    assert_eq!(number(&printed["table2"][3]["club.loft"]), 13.55_f64.to_radians());
    let (mut carries, mut angles) = (vec![], vec![]);
    for (table, angle) in [("table1", "swing.attack_angle"), ("table2", "club.loft")] {
        let rows = found[table].as_array().unwrap().iter().zip(printed[table].as_array().unwrap());
        for (row, print) in rows {
            carries.push(yards(number(&row["carry"]) - number(&print["carry"])));
            angles.push((number(&row[angle]) - number(&print[angle])).to_degrees());
        }
    }
    assert_eq!(carries.len(), 22);
    let rms = |all: &[f64]| (all.iter().map(|x| x * x).sum::<f64>() / all.len() as f64).sqrt();
    let worst = |all: &[f64]| all.iter().copied().map(f64::abs).fold(0.0, f64::max);
    assert!(rms(&carries) <= 0.2 && worst(&carries) <= 0.5, "{carries:?}");
    assert!(rms(&angles) <= 0.05 && worst(&angles) <= 0.2, "{angles:?}");
    // the average had no part in the fit: it tells how well the law carries over
    assert!(yards(off("average", "carry")).abs() <= 0.5, "{}", yards(off("average", "carry")));
    assert!(off("average", "club.loft").to_degrees().abs() <= 0.35, "{}", off("average", "club.loft").to_degrees());
    let decay = &found["aero.spin_decay"];
    assert!(number(&decay["value"]) < 0.3 && number(&decay["standard_uncertainty"]) > 0.0, "{decay}");
}

fn table(text: &str) -> tempfile::NamedTempFile {
    let mut file = tempfile::Builder::new().suffix(".csv").tempfile().unwrap();
    file.write_all(text.as_bytes()).unwrap();
    file
}

#[test]
fn exact_truth_from_the_command_line_with_missing_cells_and_a_setup_file() {
    let text = shots(&mut Noise(5), 0.0);
    // the apex of one shot was not seen
    let mut lines: Vec<&str> = text.lines().collect();
    let cells: Vec<&str> = lines[4].split(',').collect();
    let without = [&cells[..5], &["", ""]].concat().join(",");
    lines[4] = &without;
    let (data, output) = (table(&lines.join("\n")), tempfile::Builder::new().suffix(".toml").tempfile().unwrap());
    let (data, output) = (data.path().to_str().unwrap(), output.path().to_str().unwrap());
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
    let (status, found) =
        json(&[&["calibrate", data, "-o", output, "--folds", "3", "--starts", "3"], law.as_slice()].concat());
    assert_eq!((status, found["status"].as_str()), (0, Some("converged")), "{found}");
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
        ("carry [yd],club.loft [deg]\n200,ten\n", &fit[..], vec!["row 1", "column club.loft", "'ten' is not a number"]),
        ("cary [yd]\n200\n", &fit, vec!["column 1", "did you mean 'carry'"]),
        ("carry [kg]\n200\n", &fit, vec!["column 1", "carry", "200"].into_iter().take(2).collect()),
        ("carry [yd],carry [m]\n200,180\n", &fit, vec!["column 2", "two columns"]),
        ("carry [yd]\n200\n", &fit, vec!["1 measured values, fewer than the 2 parameters"]),
        ("carry [yd],club.loft [deg]\n200,10\n210,95\n", &fit, vec!["row 2", "column club.loft", "outside its range"]),
        ("carry [yd],club.loft [deg]\n200,10\n,11\n", &fit, vec!["row 2", "nothing is measured"]),
        ("carry [yd],club.loft [deg]\n200,10\n201,\n", &fit, vec!["row 2", "column club.loft", "empty"]),
        ("carry [yd],sigma carry [yd]\n200,0\n201,1\n", &fit, vec!["row 1", "sigma carry", "above 0"]),
        ("carry [yd]\n", &fit, vec!["no rows"]),
        ("carry [yd],aero.cd0\n200,0.2\n210,0.2\n", &fit, vec!["aero.cd0", "cannot be fitted"]),
        ("carry [yd]\n200\n", &["--fit", "aero.cd00"], vec!["did you mean 'aero.cd0'"]),
        ("carry [yd],swing.attack_angle [deg]\n200,2\n10,-60\n", &fit, vec!["row 2", "row 2: no flight"]),
    ] {
        let file = table(text);
        let said = longdrive(&[&["calibrate", file.path().to_str().unwrap()], fit].concat());
        assert_eq!((said.status, said.out.as_str()), (2, ""), "{text}: {}", said.err);
        for word in words {
            assert!(said.err.contains(word), "{text}: '{word}' is not in {}", said.err);
        }
    }
}
