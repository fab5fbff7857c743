//! Searches for goals over many swings.

use crate::command_line::{file_with, json, longdrive, number, on_one_line};
use crate::common::close;
use crate::random::Random;
use longdrive::derivative::{Order, Taylor, hessian};
use longdrive::optimize::Observer;
use longdrive::study::swings::{
    GoalError, GoalFunction, Rule, Scenarios, Strokes, Swings, analyse_over_swings,
    bootstrap_optimum,
};
use longdrive::study::uncertainty::{Distribution, Uncertain};
use longdrive::study::{Constraint, Goal, Optimum, Search, Sense, Vary, optimum};
use longdrive::{Drive, Error, Outcome, Setup};
use rayon::prelude::*;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Swings with these distributions, without correlations.
pub fn swings(setup: &Setup<f64>, distributions: &[&str]) -> Swings {
    Swings::distributed(
        distributions
            .iter()
            .map(|text| Uncertain::read(setup, text).unwrap())
            .collect(),
        &[],
    )
    .unwrap()
}

fn searched(setup: &Setup<f64>, goal: &str, vary: &[&str], scenarios: Scenarios) -> Optimum {
    let search = Search {
        of: Goal::read(goal, None).unwrap(),
        sense: Sense::Maximize,
        vary: vary
            .iter()
            .map(|text| Vary::read(setup, text).unwrap())
            .collect(),
        scenarios,
        ..Search::largest(Outcome::Carry)
    };
    optimum(setup, search, Observer::default()).unwrap()
}

/// Compares value, gradient and Hessian of mean(carry) at its optimum with weighted sums over
/// single drives.
#[test]
fn same_mean_and_derivatives_by_sums_over_single_drives() {
    let setup = Setup::preset("mae494").unwrap();
    let swings = swings(
        &setup,
        &[
            "swing.attack_angle=normal(1 deg, 2 deg)",
            "swing.speed=uniform(95 mph, 110 mph)",
        ],
    );
    let scenarios = Scenarios::new(&swings, Rule::Quadrature(5)).unwrap();
    let best = searched(
        &setup,
        "mean(carry)",
        &["club.loft=4deg..20deg", "club.mass=180g..210g"],
        scenarios.clone(),
    );
    assert_eq!(best.status(), "converged");
    let wrt = ["club.loft", "club.mass"].map(|name| setup.variable(name).unwrap());
    let (mut value, mut gradient, mut second) = (0.0, vec![0.0; 2], vec![0.0; 4]);
    let add = |sums: &mut [f64], weight: f64, terms: &[f64]| {
        sums.iter_mut()
            .zip(terms)
            .for_each(|(sum, term)| *sum += weight * term);
    };
    for (point, weight) in scenarios.points.iter().zip(&scenarios.weights) {
        let mut swung = best.setup;
        for (parameter, at) in scenarios.parameters.iter().zip(point) {
            swung.set_value(parameter, Some(*at)).unwrap();
        }
        let taylor = hessian(&swung, Outcome::Carry, &wrt).unwrap();
        value += weight * taylor.value;
        add(&mut gradient, *weight, &taylor.gradient);
        add(&mut second, *weight, &taylor.hessian.concat());
    }
    close(best.value().unwrap(), value, value, 1e-14, "mean");
    for (found, sum) in best.gradient().iter().zip(&gradient) {
        close(*found, *sum, 1e3, 1e-12, "gradient");
    }
    for (found, sum) in best.solution.hessian.concat().iter().zip(&second) {
        // the Hessian of the minimized function
        close(-found, *sum, sum.abs().max(1.0), 1e-11, "Hessian");
    }
}

/// Winfield & Tan's average over attack angles of 0 to 10° with equal weights: the mean over 2001
/// drives by Simpson's rule, whose best loft is the zero of the mean derivative.
#[test]
fn independent_best_loft_of_the_average_over_attack_angles_by_simpsons_rule() {
    let setup = Setup::preset("winfield-tan").unwrap();
    let all = swings(&setup, &["swing.attack_angle=uniform(0deg, 10deg)"]);
    let scenarios = Scenarios::new(&all, Rule::of(&all, [], None, 0).unwrap()).unwrap();
    let best = searched(&setup, "mean(carry)", &["club.loft=4deg..20deg"], scenarios);
    let mean = |loft: f64| {
        const PARTS: usize = 200;
        let carry = |k: usize| {
            let mut swung = setup;
            swung.club.loft = loft;
            swung.swing.attack_angle = (10.0 * k as f64 / PARTS as f64).to_radians();
            Outcome::Carry.of(&Drive::new(&swung).unwrap()).unwrap()
        };
        let weight = |k: usize| {
            if k == 0 || k == PARTS {
                1.0
            } else {
                2.0 + 2.0 * (k % 2) as f64
            }
        };
        (0..=PARTS).map(|k| weight(k) * carry(k)).sum::<f64>() / (3.0 * PARTS as f64)
    };
    let loft = best.solution.x[0];
    close(
        best.value().unwrap(),
        mean(loft),
        200.0,
        1e-10,
        "mean carry",
    );
    let h = 2e-4;
    let slope = (mean(loft + h) - mean(loft - h)) / (2.0 * h);
    let bend = (mean(loft + h) - 2.0 * mean(loft) + mean(loft - h)) / (h * h);
    assert!((slope / bend).abs() < 1e-6, "{} rad off", slope / bend);
    // the paper's polynomial through five lofts is largest at 10.68°; the average itself is largest
    // at 10.32°
    assert!(
        (loft.to_degrees() - 10.32).abs() < 0.01,
        "{}",
        loft.to_degrees()
    );
}

/// Gauss's rules converge faster than any power of the number of nodes, and a quasi-random sequence
/// faster than 1/√n.
#[test]
fn order_of_quadrature_and_of_sequences() {
    let mut setup = Setup::preset("mae494").unwrap();
    // large steps take less time, and change the mean only slightly: not its order of convergence
    setup.set_all(crate::common::LARGE_STEPS).unwrap();
    let all = swings(
        &setup,
        &[
            "swing.attack_angle=normal(1 deg, 0.7 deg)",
            "swing.speed=normal(105 mph, 3 mph)",
        ],
    );
    let mean = |rule: Rule| {
        let scenarios = Scenarios::new(&all, rule).unwrap();
        let best = searched(
            &setup,
            "mean(carry)",
            &["club.loft=9.99deg..10.01deg"],
            scenarios,
        );
        (best.value().unwrap(), best.solution.x[0])
    };
    let (exact, _) = mean(Rule::Quadrature(20));
    let errors = [2, 4, 8].map(|nodes| (mean(Rule::Quadrature(nodes)).0 - exact).abs());
    assert!(
        errors[1] < 1e-3 * errors[0] && errors[2] < 1e-8,
        "{errors:?}"
    );
    // root mean square error of four seeds, with 32 and with 512 points
    let off = |count: usize| {
        let squares = (0..4).map(|seed| (mean(Rule::Sequence { count, seed }).0 - exact).powi(2));
        (squares.sum::<f64>() / 4.0).sqrt()
    };
    let (few, many) = (off(32), off(512));
    assert!(many < few / 8.0, "{few} {many}: no better than 1/√n");
}

/// With a symmetric head and golfer, the mean lateral is 0 for every loft.
#[test]
fn exact_zero_lateral_mean_of_symmetric_swings() {
    let setup = Setup::preset("tour-average").unwrap();
    let mut straight = setup;
    straight
        .set_all([
            ("swing.shaft_droop", "none"),
            ("strike.toe", "0 mm"),
            ("swing.face_angle", "0 deg"),
        ])
        .unwrap();
    let all = swings(
        &straight,
        &[
            "swing.path=normal(0 deg, 2 deg)",
            "swing.face_angle=normal(0 deg, 2 deg)",
        ],
    );
    let scenarios = Scenarios::new(&all, Rule::Quadrature(6)).unwrap();
    let best = searched(
        &straight,
        "mean(lateral)",
        &["club.loft=9deg..9.1deg"],
        scenarios,
    );
    assert!(best.value().unwrap().abs() < 1e-9, "{:?}", best.value());
}

/// Correlated normal variables have the requested correlation, and their own means and deviations.
#[test]
fn exact_correlation_of_normal_swings() {
    let setup = Setup::modern_driver();
    let inputs = [
        "swing.path=normal(1 deg, 2 deg)",
        "swing.face_angle=normal(-1 deg, 3 deg)",
    ];
    let inputs: Vec<_> = inputs
        .iter()
        .map(|text| Uncertain::read(&setup, text).unwrap())
        .collect();
    let parameters = [inputs[0].parameter, inputs[1].parameter];
    let correlation = longdrive::study::swings::Correlation::new(parameters, 0.6).unwrap();
    let all = Swings::distributed(inputs, &[correlation]).unwrap();
    let scenarios = Scenarios::new(&all, Rule::Quadrature(12)).unwrap();
    let moment = |f: &dyn Fn(f64, f64) -> f64| {
        let terms = scenarios.points.iter().zip(&scenarios.weights);
        terms
            .map(|(point, weight)| weight * f(point[0].to_degrees(), point[1].to_degrees()))
            .sum::<f64>()
    };
    // variance over σ² of a normal distribution within ± 4 σ: 1 − 8 φ(4)/(2 Φ(4) − 1)
    let kept = 0.9989292903724738;
    close(moment(&|x, _| x), 1.0, 1.0, 1e-12, "mean path");
    close(
        moment(&|x, _| (x - 1.0).powi(2)),
        4.0 * kept,
        4.0,
        1e-10,
        "variance of path",
    );
    close(
        moment(&|_, y| (y + 1.0).powi(2)),
        9.0 * kept,
        9.0,
        1e-10,
        "variance of face",
    );
    close(
        moment(&|x, y| (x - 1.0) * (y + 1.0)),
        0.6 * 6.0 * kept,
        6.0,
        1e-10,
        "covariance",
    );
}

/// A truncated normal distribution: its quantiles agree with its moments, and with the sample of
/// `uncertainty`.
#[test]
fn independent_moments_of_a_truncated_distribution_by_its_quantiles() {
    let read = |text: &str| Uncertain::read(&Setup::modern_driver(), text);
    let input = read("swing.speed=truncated(110 mph, 5 mph, 100 mph, 112 mph)").unwrap();
    let Distribution::Truncated { low, high, .. } = input.distribution else {
        panic!("{input:?}")
    };
    let n = 20_000;
    let quantiles: Vec<f64> = (0..n)
        .map(|k| {
            input
                .distribution
                .quantile((f64::from(k) + 0.5) / f64::from(n))
        })
        .collect();
    assert!(
        quantiles.iter().all(|x| (low..=high).contains(x))
            && quantiles.windows(2).all(|pair| pair[0] < pair[1])
    );
    let mean = quantiles.iter().sum::<f64>() / f64::from(n);
    close(mean, input.distribution.mean(), mean, 1e-7, "mean");
    let variance = quantiles.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / f64::from(n);
    close(
        variance.sqrt(),
        input.distribution.deviation(),
        1.0,
        1e-4,
        "deviation",
    );
    assert!(read("swing.speed=truncated(110 mph, 5 mph, 112 mph, 100 mph)").is_err());
    assert!(read("swing.speed=truncated(110 mph, 1e-9 mph, 1 mph, 2 mph)").is_err());
}

/// The recorded swings are a sample of a known distribution. The interval of the best loft contains
/// the best loft for this distribution. More swings narrow the interval.
#[test]
fn sampled_interval_of_the_best_loft_from_recorded_swings() {
    let mut setup = Setup::preset("mae494").unwrap();
    // large steps take a tenth of the time, and have an error of carry of 1e-8 m
    setup.set_all(crate::common::LARGE_STEPS).unwrap();
    let all = swings(&setup, &["swing.attack_angle=uniform(-6deg, 6deg)"]);
    let truth = searched(
        &setup,
        "mean(carry)",
        &["club.loft=4deg..30deg"],
        Scenarios::new(&all, Rule::Quadrature(24)).unwrap(),
    );
    let parameter = setup.variable("swing.attack_angle").unwrap();
    let widths = [12, 108].map(|count| {
        // a fixed sequence, spread no more evenly than random numbers
        let rows = (0..count)
            .map(|k| vec![((f64::from(k * k) * 0.618_034).fract() * 12.0 - 6.0).to_radians()]);
        let recorded = Swings::recorded(vec![parameter], rows.collect()).unwrap();
        let scenarios = Scenarios::new(&recorded, Rule::Recorded).unwrap();
        let best = searched(&setup, "mean(carry)", &["club.loft=4deg..30deg"], scenarios);
        let found = bootstrap_optimum(&setup, &best, 40, 0, &Arc::default())
            .unwrap()
            .unwrap();
        let (_, design) = found.design[0];
        assert!(design.low < best.solution.x[0] && best.solution.x[0] < design.high);
        assert!(
            design.contains(truth.solution.x[0]),
            "{count}: {design:?} {}",
            truth.solution.x[0]
        );
        assert!(found.rounds == 40 && found.gain.is_some_and(|gain| gain.low > 0.0));
        design.high - design.low
    });
    assert!((widths[0] / widths[1] - 3.0).abs() < 1.5, "{widths:?}");
}

/// 100 tables of four swings are drawn from a known distribution. The intervals of the best loft
/// and of the mean carry each miss the truth in 5 % of the tables. By the binomial distribution, 16
/// or more misses have a probability below 1e-4. Percentiles of resamples alone miss the mean of
/// four normal numbers in 19 of 100 tables: P(|t₃| > 1.96 √(3/4)).
#[test]
fn sampled_coverage_of_intervals_from_four_recorded_swings() {
    const TABLES: u64 = 100;
    const SWINGS: usize = 4;
    let mut setup = Setup::preset("modern-driver").unwrap();
    setup.set_all(crate::common::LARGE_STEPS).unwrap();
    let [speed, speed_deviation] = [45.0, 1.3];
    let [attack, attack_deviation] = [-1.0_f64, 1.5].map(f64::to_radians);
    let golfer = swings(
        &setup,
        &[
            "swing.speed=normal(45 m/s, 1.3 m/s)",
            "swing.attack_angle=normal(-1 deg, 1.5 deg)",
        ],
    );
    let best = |scenarios| searched(&setup, "mean(carry)", &["club.loft=4deg..30deg"], scenarios);
    let truth = best(Scenarios::new(&golfer, Rule::Quadrature(12)).unwrap());
    let parameters =
        ["swing.speed", "swing.attack_angle"].map(|name| setup.variable(name).unwrap());
    let contains = |table: u64| {
        let mut random = Random::seeded(table);
        let mut swing = || {
            vec![
                speed + speed_deviation * random.normal(),
                attack + attack_deviation * random.normal(),
            ]
        };
        let rows = (0..SWINGS).map(|_| swing()).collect();
        let recorded = Swings::recorded(parameters.to_vec(), rows).unwrap();
        let best = best(Scenarios::new(&recorded, Rule::Recorded).unwrap());
        let found = bootstrap_optimum(&setup, &best, 60, table, &Arc::default())
            .unwrap()
            .unwrap();
        let (_, loft) = found.design[0];
        [
            loft.contains(truth.solution.x[0]),
            found.goal.contains(truth.value().unwrap()),
        ]
    };
    let all: Vec<[bool; 2]> = (0..TABLES).into_par_iter().map(contains).collect();
    for (i, of) in ["loft", "carry"].into_iter().enumerate() {
        let missed = all.iter().filter(|contains| !contains[i]).count();
        println!("{of}: {missed} of {TABLES}");
        // an interval that never misses would be too wide
        assert!((1..16).contains(&missed), "{of}: {missed} of {TABLES}");
    }
}

const GOLFER: [&str; 4] = [
    "--distribution",
    "swing.attack_angle=truncated(-1deg,2deg,-5deg,5deg)",
    "--distribution=swing.path=normal(0deg,2deg)",
    "--distribution=swing.face_angle=normal(0deg,2deg)",
];

#[test]
fn the_best_loft_over_swings_has_its_price_and_its_diagnostics() {
    let args = [
        &[
            "optimize",
            "--maximize",
            "mean(carry)",
            "--subject-to",
            "std(lateral) <= 60yd",
        ][..],
        &GOLFER,
    ]
    .concat();
    let text = longdrive(&args).out;
    for output in [
        "best for mean swing",
        "std(lateral) <= 60yd",
        "by Gauss's rules",
        "as set up",
    ] {
        assert!(text.contains(output), "{output}: {text}");
    }
    let (_, answer) = json(&args);
    let swings = &answer["swings"];
    assert_eq!(
        (&answer["status"], &answer["objective"]),
        (&"converged".into(), &"mean(carry)".into())
    );
    let (best, kept) = (
        number(&answer["value"]),
        number(&swings["nominal"]["kept"]["mean(carry)"]),
    );
    assert!(
        best >= kept && number(&swings["nominal"]["promised"]["mean(carry)"]) > best,
        "{answer}"
    );
    assert!(number(&swings["quadrature_error"]) < 1e-3);
    // repeated requests give the same answer, to the last bit
    let many = [&args[..], &["--scenarios", "64", "--seed", "7"]].concat();
    assert_eq!(json(&many), json(&many));
    let (_, sampled) = json(&many);
    assert!(
        number(&sampled["swings"]["sampling"]["interval"]["low"])
            < number(&sampled["swings"]["sampling"]["interval"]["high"])
    );
}

#[test]
fn same_bits_of_a_resumed_search_over_swings() {
    let folder = tempfile::tempdir().unwrap();
    let kept = folder.path().join("kept").display().to_string();
    let args = [
        &[
            "optimize",
            "--vary",
            "club.loft=6deg..16deg",
            "--vary",
            "club.cg_depth=20mm..45mm",
        ][..],
        &GOLFER,
    ]
    .concat();
    let whole = json(&args);
    let kept = ["--checkpoint", &kept];
    assert_eq!(
        longdrive(&[&args[..], &kept, &["--max-iterations", "2"]].concat()).status,
        1
    );
    assert_eq!(whole, json(&[&args[..], &kept].concat()));
}

/// The goal rms(lateral) has a local optimum at each end of the range. A search from a single start
/// finds the nearer one. If setup and range are mirrored, the optimum is mirrored, too.
#[test]
fn several_starts_find_both_ends_of_a_goal_that_grows_to_both_sides() {
    let requested = |set: &str, vary: &str, starts: &str| {
        let vary = format!("swing.face_angle={vary}");
        let args = [
            "optimize",
            "mae494",
            "--distribution",
            "swing.speed=normal(100mph,2mph)",
            "--maximize",
            "rms(lateral)",
        ];
        let (status, found) = json(
            &[
                &args[..],
                &[
                    "--set",
                    &format!("swing.face_angle={set}"),
                    "--vary",
                    &vary,
                    "--starts",
                    starts,
                ],
            ]
            .concat(),
        );
        assert_eq!(status, 0, "{found}");
        found
    };
    let face =
        |found: &serde_json::Value| number(&found["optimum"]["swing.face_angle"]).to_degrees();
    let one = requested("1deg", "-5deg..3deg", "1");
    close(face(&one), 3.0, 1.0, 1e-12, "the nearer end");
    assert!(one["optima"].is_null());
    let many = requested("1deg", "-5deg..3deg", "8");
    close(face(&many), -5.0, 1.0, 1e-12, "the better end");
    let optima = many["optima"].as_array().unwrap();
    assert_eq!(optima.len(), 2, "{optima:?}");
    assert_eq!(
        optima
            .iter()
            .map(|local| number(&local["starts"]))
            .sum::<f64>(),
        8.0
    );
    assert_eq!(
        (&optima[0]["value"], &optima[1]["value"]),
        (&many["value"], &one["value"])
    );
    let turned = requested("-1deg", "-3deg..5deg", "8");
    close(
        face(&turned),
        5.0,
        1.0,
        1e-12,
        "the better end, turned about",
    );
    close(
        number(&turned["value"]),
        number(&many["value"]),
        1.0,
        1e-9,
        "its mirror image",
    );
    let text = longdrive(&[
        "optimize",
        "mae494",
        "--distribution",
        "swing.speed=normal(100mph,2mph)",
        "--maximize",
        "rms(lateral)",
        "--set",
        "swing.face_angle=1deg",
        "--vary",
        "swing.face_angle=-5deg..3deg",
        "--starts",
        "8",
    ]);
    assert!(
        text.out.contains("of 8") && text.out.contains("-5.00°") && text.out.contains("3.00°"),
        "{}",
        text.out
    );
    let design = [
        "design",
        "--set",
        "club.loft=12deg",
        "--vary",
        "club.bulge_radius=150mm..1000mm",
        "--scenarios",
        "64",
    ];
    let (_, one) = json(&design);
    let (_, many) = json(&[&design[..], &["--starts", "4"]].concat());
    assert_eq!(
        many["optima"]
            .as_array()
            .unwrap()
            .iter()
            .map(|local| number(&local["starts"]))
            .sum::<f64>(),
        4.0
    );
    close(
        number(&many["value"]),
        number(&one["value"]),
        100.0,
        1e-9,
        "one bulge is best",
    );
}

/// Compares value, gradient and Hessian of a [`GoalFunction`] with the objective of a search and
/// with sums over single drives. Without random swings it equals the outcome of the drive.
#[test]
fn same_goals_by_sums_over_single_drives() {
    let setup = Setup::preset("mae494").unwrap();
    let swings = swings(
        &setup,
        &[
            "swing.attack_angle=normal(1 deg, 2 deg)",
            "swing.speed=uniform(95 mph, 110 mph)",
        ],
    );
    let scenarios = Scenarios::new(&swings, Rule::Quadrature(5)).unwrap();
    let wrt = ["club.loft", "club.mass"].map(|name| setup.variable(name).unwrap());
    let goal = Goal::read("2*mean(carry) - 3*std(flight_time)", None);
    assert!(goal.is_err(), "a length and a time cannot be added");
    let goal = Goal::read("2*mean(carry) - 0.5*std(carry)", None).unwrap();
    let function = GoalFunction::new(&setup, &goal, &wrt, scenarios.clone()).unwrap();
    let x = [12.0_f64.to_radians(), 0.195];
    let all: Vec<Taylor> = scenarios
        .points
        .iter()
        .map(|point| {
            let mut swung = setup;
            for (parameter, at) in scenarios
                .parameters
                .iter()
                .chain(&wrt)
                .zip(point.iter().chain(&x))
            {
                swung.set_value(parameter, Some(*at)).unwrap();
            }
            hessian(&swung, Outcome::Carry, &wrt).unwrap()
        })
        .collect();
    let mean = |f: &dyn Fn(&Taylor) -> f64| {
        all.iter()
            .zip(&scenarios.weights)
            .map(|(drive, w)| w * f(drive))
            .sum::<f64>()
    };
    let carry = mean(&|drive| drive.value);
    let slope = [0, 1].map(|i| mean(&|drive| drive.gradient[i]));
    let deviation = mean(&|drive| (drive.value - carry).powi(2)).sqrt();
    // derivatives of the variance σ² = E f² − (E f)², and of σ
    let of_variance =
        [0, 1].map(|i| 2.0 * mean(&|drive| (drive.value - carry) * (drive.gradient[i] - slope[i])));
    let bent = |i: usize, j: usize| {
        let variance = 2.0
            * mean(&|drive| {
                (drive.gradient[i] - slope[i]) * (drive.gradient[j] - slope[j])
                    + (drive.value - carry) * drive.hessian[i][j]
            });
        variance / (2.0 * deviation) - of_variance[i] * of_variance[j] / (4.0 * deviation.powi(3))
    };
    for order in [Order::Value, Order::First, Order::Second] {
        let found = function.at(&x, order).unwrap();
        close(
            found.value,
            2.0 * carry - 0.5 * deviation,
            carry,
            1e-14,
            "value",
        );
        assert_eq!(found.gradient.is_empty(), order == Order::Value);
        for (i, d) in found.gradient.iter().enumerate() {
            close(
                *d,
                2.0 * slope[i] - 0.5 * of_variance[i] / (2.0 * deviation),
                1e3,
                1e-11,
                "gradient",
            );
        }
        for (i, j) in [(0, 0), (0, 1), (1, 1)]
            .into_iter()
            .filter(|_| order == Order::Second)
        {
            let expected = 2.0 * mean(&|drive| drive.hessian[i][j]) - 0.5 * bent(i, j);
            close(
                found.hessian[i][j],
                expected,
                expected.abs().max(1.0),
                1e-9,
                "Hessian",
            );
        }
    }
    let refused = |goal: Option<f64>| {
        function
            .at(&[goal.unwrap_or(x[0]), 0.195], Order::Value)
            .unwrap_err()
            .to_string()
    };
    assert!(
        refused(Some(2.0)).contains("club.loft"),
        "{}",
        refused(Some(2.0))
    );
    let own = setup.variable("swing.speed").unwrap();
    assert!(
        GoalFunction::new(&setup, &goal, &[own], scenarios)
            .is_err_and(|e| e.to_string().contains("the swings have values of it"))
    );
}

#[test]
fn bad_swings_and_goals_are_refused_with_the_reason() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("swings.csv");
    std::fs::write(
        &file,
        "swing.path [deg],swing.face_angle [deg]\n1,0\n0,200\n",
    )
    .unwrap();
    let file = file.display().to_string();
    let written = |name: &str, text: &str| {
        let file = folder.path().join(name);
        std::fs::write(&file, text).unwrap();
        file.display().to_string()
    };
    let hole = written(
        "hole.csv",
        "swing.path [deg],swing.face_angle [deg]\n1,0\n0,\n",
    );
    let empty = written("empty.csv", "swing.path [deg]\n");
    let launches = written(
        "launches.csv",
        "Ball Speed [mph],Launch Angle [deg],Back Spin [rpm]\n150,12,2500\n",
    );
    let one = "--distribution=swing.path=normal(0deg,2deg)";
    let spin = "--distribution=launch.spin=normal(2500rpm,100rpm)";
    let cases: [(&[&str], &str); 20] = [
        (&[spin], "or give a whole launch with --launch"),
        (&["--scenarios", "9"], "give the swings too"),
        (&[one, "--scenarios", "1"], "from 2 to 100000"),
        (&[one, one], "two distributions"),
        (
            &[one, "--correlation", "swing.path,swing.face_angle=0.5"],
            "has no distribution",
        ),
        (
            &[one, "--correlation", "swing.path,swing.path=0.5"],
            "itself",
        ),
        (
            &[one, "--correlation", "swing.path,swing.face_angle=1.5"],
            "outside of -1 to 1",
        ),
        (&[one, "--maximize", "carry"], "mean(carry)"),
        (&[one, "--maximize", "mean(cary)"], "did you mean 'carry'"),
        (
            &[one, "--maximize", "mean(carry) + std(descent_angle)"],
            "an angle",
        ),
        (&[one, "--maximize", "lowest(carry, 0%)"], "share"),
        (&[one, "--maximize", "strokes(400yd)"], "--strokes FILE"),
        (
            &[one, "--vary", "swing.path=-2deg..2deg"],
            "the swings have values of it",
        ),
        (&["--swings", &file], "recorded swing 2: swing.face_angle"),
        (&["--swings", &file, one], "leave --swings out"),
        (
            &["--swings", &hole],
            "recorded swing 2: swing.face_angle is missing",
        ),
        (&["--swings", &empty], "it has no row"),
        (
            &["--swings", &launches],
            "'longdrive delivery' with --shots",
        ),
        (
            &[one, "--set", "swing.path=1deg"],
            "the swings have values of it",
        ),
        (
            &[one, "--maximize", "median(carry)"],
            "--maximize: 'median' is no measure",
        ),
    ];
    for (args, output) in cases {
        let failed = longdrive(&[&["optimize"], args].concat());
        let message = on_one_line(&failed.err);
        assert!(
            failed.status == 2 && message.contains(output),
            "{args:?}: {message}"
        );
    }
    let failed = longdrive(&["optimum-sensitivity", one]);
    assert!(
        failed.status == 2 && failed.err.contains("has no option '--distribution'"),
        "{}",
        failed.err
    );
}

#[test]
fn too_many_recorded_swings_are_refused_with_their_number() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("swings.csv");
    let rows = "100\n".repeat(100_001);
    std::fs::write(&file, format!("swing.speed [mph]\n{rows}")).unwrap();
    let error = Swings::open(&Setup::modern_driver(), &file).unwrap_err();
    let says = "it has 100001 rows, and at most 100000 recorded swings are allowed";
    assert!(
        matches!(error, Error::Table { .. }) && error.to_string().contains(says),
        "{error}"
    );
}

/// The mean swing alone has no scatter, so no design for it meets the limit on the deviation.
#[test]
fn a_search_for_the_mean_swing_that_does_not_converge_gives_no_nominal_design() {
    let limit = [
        "--maximize",
        "mean(carry)",
        "--subject-to",
        "std(lateral) >= 1yd",
    ];
    let args = [&["optimize"], &limit[..], &GOLFER].concat();
    let (_, answer) = json(&args);
    assert_eq!(answer["status"], "converged");
    assert!(
        answer["swings"]["nominal"].is_null(),
        "{}",
        answer["swings"]
    );
    let printed = longdrive(&args);
    assert!(
        on_one_line(&printed.out).contains(
            "no comparison with the best design for the mean swing: no design was found that meets \
             the limits"
        ),
        "{}",
        printed.out
    );
}

/// For one swing rms(lateral) is |lateral|, and its minimum 0 is a corner.
#[test]
fn a_search_for_the_mean_swing_that_stops_at_a_corner_has_one_sentence_after_the_result() {
    let args = [
        "optimize",
        "modern-driver",
        "--set",
        "club.loft=12deg",
        "--distribution",
        "strike.toe=truncated(3mm,8mm,-20mm,20mm)",
        "--maximize",
        "mean(carry) - 0.5*rms(lateral)",
        "--vary",
        "club.cg_high=-10mm..10mm",
        "--vary",
        "club.cg_toe=-10mm..10mm",
    ];
    let printed = longdrive(&args);
    let text = on_one_line(&printed.out);
    let sentence = "no comparison with the best design for the mean swing: for a single swing \
                    rms(lateral) is |lateral|, which has a corner at 0; the search stopped at a \
                    corner";
    assert!(text.contains(sentence), "{text}");
    assert!(
        text.find("by Gauss's rules") < text.find(sentence),
        "{text}"
    );
}

/// At the lowest attack angles of the range no ball flies. The nodes of the finer quadrature do not
/// reach these angles, but the points of the sequences do.
#[test]
fn the_error_of_a_smooth_goal_is_known_if_only_the_sequences_contain_a_swing_without_flight() {
    let setup = Setup::modern_driver();
    let flies = |attack: f64| {
        let mut swung = setup;
        swung.swing.attack_angle = attack;
        Drive::new(&swung).is_ok_and(|drive| Outcome::Carry.of(&drive).is_ok())
    };
    let (mut low, mut high) = (-0.7, 0.0);
    assert!(!flies(low) && flies(high));
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        *(if flies(middle) { &mut high } else { &mut low }) = middle;
    }
    // the outermost of 6 nodes is 3.4 % of the range from its end
    let end = 1.02 * low;
    let attack = format!("swing.attack_angle=uniform({end:?} rad, 0 rad)");
    let distributed = swings(&setup, &[&attack]);
    let search = Search {
        of: Goal::read("mean(carry)", None).unwrap(),
        vary: vec![Vary::read(&setup, "swing.path=-0.001deg..0.001deg").unwrap()],
        subject_to: vec![Constraint::read_over_swings("within(carry, 500m) >= 0", None).unwrap()],
        scenarios: Scenarios::new(&distributed, Rule::Quadrature(4)).unwrap(),
        ..Search::largest(Outcome::Carry)
    };
    let best = optimum(&setup, search, Observer::default()).unwrap();
    let analysis = analyse_over_swings(&setup, &distributed, &best, &Arc::default());
    let errors = analysis.unwrap().unwrap().errors;
    assert!(
        matches!(
            errors[..],
            [GoalError::Quadrature(_), GoalError::Unknown(_)]
        ),
        "{errors:?}"
    );
}

/// Expected strokes increase with the remaining distance. If the hole is straight ahead and out of
/// reach, the loft with the fewest strokes is the loft with the longest carry.
#[test]
fn fewest_strokes_are_the_longest_drive_if_only_distance_counts() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("strokes.csv");
    // strokes proportional to the remaining distance
    std::fs::write(&file, "distance [yd],strokes\n0,0\n1000,10\n").unwrap();
    let file = file.display().to_string();
    let speed = ["--distribution", "swing.speed=normal(100mph,2mph)"];
    let (_, strokes) = json(
        &[
            &[
                "optimize",
                "--minimize",
                "strokes(600yd)",
                "--strokes",
                &file,
            ][..],
            &speed,
        ]
        .concat(),
    );
    let (_, carry) = json(&[&["optimize"][..], &speed].concat());
    close(
        number(&strokes["optimum"]["club.loft"]),
        number(&carry["optimum"]["club.loft"]),
        1.0,
        1e-4,
        "best loft",
    );
    let left = 600.0 * 0.9144 - number(&carry["value"]);
    close(
        number(&strokes["value"]),
        left / 91.44,
        6.0,
        1e-4,
        "strokes",
    );
}

/// Searches over wide or dependent distributions converge: `lowest` over a normal distribution, and
/// correlations of ±1.
#[test]
fn swings_that_reach_far_have_an_answer() {
    let attack = ["--distribution", "swing.attack_angle=normal(-1deg,2deg)"];
    let (status, found) = json(
        &[
            &["optimize", "--maximize", "lowest(carry, 10%)"][..],
            &attack,
        ]
        .concat(),
    );
    assert_eq!((status, &found["status"]), (0, &"converged".into()));
    let both = [
        "--distribution=swing.path=normal(0deg,2deg)",
        "--distribution=swing.face_angle=normal(0deg,2deg)",
    ];
    for coefficient in ["1", "-1", "0.999"] {
        let correlation = format!("swing.path,swing.face_angle={coefficient}");
        let (status, found) =
            json(&[&["optimize"][..], &both, &["--correlation", &correlation]].concat());
        assert_eq!(status, 0, "{coefficient}: {found}");
    }
    // the value of a goal is within its interval; the interval of a share is within 0 and 1
    let goals = [
        "lowest(carry, 10%)",
        "within(lateral, 15m)",
        "within(carry, 15yd)",
    ];
    for goal in goals {
        let args = [
            &["optimize", "--scenarios", "64", "--maximize", goal][..],
            &attack,
            &both,
        ]
        .concat();
        let (_, found) = json(&args);
        let Some(interval) = found["swings"]["sampling"]["interval"].as_object() else {
            continue;
        };
        let [value, low, high] = ["value", "low", "high"].map(|name| number(&interval[name]));
        assert!(
            low <= value && value <= high && number(&found["value"]) == value,
            "{goal}: {found}"
        );
        assert!(
            !goal.starts_with("within")
                || (0.0..=1.0).contains(&low) && (0.0..=1.0).contains(&high),
            "{found}"
        );
    }
}

#[test]
fn a_table_of_strokes_is_read_in_any_dialect_and_its_errors_name_line_and_unit() {
    let folder = tempfile::tempdir().unwrap();
    let read = |text: &str| {
        let file = folder.path().join("strokes.csv");
        std::fs::write(&file, text).unwrap();
        Strokes::open(&file, false)
    };
    let expected = read("distance [yd],strokes\n10,2.2\n60,3\n").unwrap();
    for text in [
        "\u{feff}distance [yd];strokes\r\n10;2.2\r\n60;3\r\n",
        "sep=;\ndistance [yd];strokes\n10;2,2\n60;3\n",
        "distance [yd]\tstrokes\n10\t2.2\n60\t3\n",
        "distance [yd],strokes\n10,2.2\n\n60,3\n,\n",
        "# a remark\ndistance [yd],strokes\n10,2.2\n60,3\n",
    ] {
        assert_eq!(read(text).unwrap(), expected, "{text}");
    }
    for (text, says) in [
        (
            "distance [yd],strokes\n\n10,2.2\n60,x\n",
            "strokes.csv, line 4",
        ),
        (
            "distance [yd],hits\n10,2.2\n",
            "its columns are distance [yd], hits",
        ),
        (
            "distance,strokes\n10,2.2\n",
            "'distance' names no unit of length",
        ),
        ("distance [yd],strokes\n30,2.2\n20,3\n", "row 2: 20 yd"),
        ("distance [yd],strokes\n10,2.2\n60\n", "line 3"),
        // 1.000 is a thousand beside 2,2
        (
            "distance [yd];strokes\n10;2,2\n1.000;6\n",
            "line 3, column distance [yd]: '1.000' has a point, but '2,2' has a comma",
        ),
    ] {
        let error = read(text).unwrap_err().to_string();
        assert!(error.contains(says), "{text}: {error}");
    }
}

#[test]
fn parameters_without_swings_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let written = |name: &str, text: &str| {
        let file = folder.path().join(name);
        std::fs::write(&file, text).unwrap();
        file.display().to_string()
    };
    let alike = written("alike.csv", "swing.path [deg]\n1\n1\n");
    let output = longdrive(&["optimize", "--swings", &alike]);
    assert!(
        output.status == 0
            && on_one_line(&output.out).contains("best design: the swings are equal"),
        "{}",
        output.out
    );
    let table = written("strokes.csv", "distance [yd],strokes\n10,2.2\n60,3\n");
    let speed = ["--distribution", "swing.speed=normal(100mph,2mph)"];
    let strokes = [
        "optimize",
        "--minimize",
        "strokes(420yd)",
        "--strokes",
        &table,
    ];
    let output = longdrive(&[&strokes[..], &speed].concat());
    assert!(
        output
            .err
            .contains("100.0 % of the swings end outside of the table"),
        "{}",
        output.err
    );
    let says = "strokes to hole out after this drive, from where it lands (no run)";
    assert!(on_one_line(&output.out).contains(says), "{}", output.out);
    let stray = longdrive(&[&["optimize", "--strokes", &table][..], &speed].concat());
    assert!(
        stray.status == 2 && stray.err.contains("no goal uses strokes"),
        "{}",
        stray.err
    );
    let flat = longdrive(
        &[
            &["optimize", "--maximize", "within(carry, 15yd)"][..],
            &speed,
        ]
        .concat(),
    );
    assert!(
        flat.out.contains("depends on no varied parameter"),
        "{}",
        flat.out
    );
    let beside = [
        "optimize",
        "--distribution",
        "strike.toe=normal(0mm,6mm)",
        "--maximize",
        "mean(carry)",
    ];
    let output = on_one_line(&longdrive(&beside).out);
    assert!(
        output.contains("the gear effect, and the scatter from it, is known to about 30 %"),
        "{output}"
    );
    // a setup file names its goal
    let best = folder.path().join("best.toml").display().to_string();
    assert_eq!(
        longdrive(&[&["optimize", "-o", &best][..], &speed].concat()).status,
        0
    );
    let text = std::fs::read_to_string(&best).unwrap();
    assert!(
        text.contains("over swings: swing.speed") && text.contains("normal"),
        "{text}"
    );
}

/// The table of docs/swings.md, computed by the command.
#[test]
fn documents_say_the_best_lofts_of_a_beginner_and_of_a_professional() {
    let document = include_str!("../../docs/swings.md");
    let beginner = [
        "swing.speed=truncated(93.4 mph, 6 mph, 81.4 mph, 105.4 mph)",
        "swing.attack_angle=truncated(-1.6 deg, 4 deg, -9.6 deg, 6.4 deg)",
        "strike.high=truncated(-2.6 mm, 8 mm, -18.6 mm, 13.4 mm)",
    ];
    let professional = [
        "swing.speed=normal(115 mph, 1.2 mph)",
        "swing.attack_angle=normal(-0.9 deg, 1 deg)",
        "strike.high=normal(6 mm, 3 mm)",
    ];
    for (golfer, preset, swings) in [
        ("beginner", "amateur-average", beginner),
        ("professional", "tour-average", professional),
    ] {
        let mut command = vec!["optimize", preset];
        command.extend(swings.iter().flat_map(|text| ["--distribution", text]));
        let output = longdrive(&command);
        let row = |name: &str| {
            let line = output
                .out
                .lines()
                .find(|line| line.trim_start().starts_with(name))
                .unwrap_or_default();
            line.split_whitespace()
                .map(str::to_owned)
                .collect::<Vec<_>>()
        };
        let (loft, carry) = (row("club.loft"), row("mean(carry)"));
        let message = format!(
            "| {golfer} | `{preset}` | {} | {} | {} yd | {} yd |",
            loft[1], loft[2], carry[1], carry[5]
        );
        assert!(
            document.contains(&message),
            "docs/swings.md has no row '{message}'"
        );
    }
}

#[test]
fn scenarios_by_a_rule_that_does_not_fit_the_swings_are_refused() {
    let setup = Setup::modern_driver();
    let distributed = swings(&setup, &["swing.speed=normal(100mph,2mph)"]);
    let three = ["swing.speed", "swing.path", "swing.attack_angle"].map(|name| {
        let (value, unit) = if name == "swing.speed" {
            (45, "m/s")
        } else {
            (0, "deg")
        };
        format!("{name}=normal({value}{unit},1{unit})")
    });
    let three = swings(&setup, &three.each_ref().map(String::as_str));
    let recorded = Swings::recorded(
        vec![setup.variable("swing.speed").unwrap()],
        vec![vec![45.0], vec![46.0]],
    )
    .unwrap();
    let sequence = Rule::Sequence { count: 4, seed: 0 };
    for (swings, rule) in [
        (&distributed, Rule::Recorded),
        (&recorded, Rule::Quadrature(4)),
        (&recorded, sequence),
        (&distributed, Rule::Quadrature(0)),
        (&distributed, Rule::Quadrature(100_001)),
        (&three, Rule::Quadrature(47)),
    ] {
        let error = Scenarios::new(swings, rule).unwrap_err().to_string();
        assert!(
            error.contains("the rule of the scenarios"),
            "{rule:?}: {error}"
        );
    }
}

#[test]
fn a_share_of_swings_beyond_the_table_of_strokes_is_not_rounded_up() {
    let folder = tempfile::tempdir().unwrap();
    let warning = |longest: &str| {
        let file = file_with(
            folder.path(),
            "strokes.csv",
            &format!("distance [yd],strokes\n0,0\n{longest},3\n"),
        );
        let (_, found) = json(&[
            "optimize",
            "--distribution",
            "swing.speed=normal(100mph,4mph)",
            "--minimize",
            "strokes(400yd)",
            "--strokes",
            &file,
        ]);
        found["warnings"].to_string()
    };
    let ends = "of the swings end outside of the table of strokes";
    let (few, more) = (warning("210"), warning("200"));
    assert!(
        few.contains(&format!("the balls of less than 0.1 % {ends}")),
        "{few}"
    );
    assert!(
        more.contains(&format!("the balls of 0.4 % {ends}")),
        "{more}"
    );
}

#[test]
fn recorded_swings_without_one_value_for_each_parameter_are_refused() {
    let setup = Setup::modern_driver();
    let parameters = ["swing.speed", "swing.path"].map(|name| setup.variable(name).unwrap());
    for row in [vec![45.0], vec![45.0, 0.0, 0.0]] {
        let rows = vec![vec![45.0, 0.0], row];
        let error = Swings::recorded(parameters.to_vec(), rows).unwrap_err();
        let error = error.to_string();
        assert!(
            error.contains("recorded swing 2") && error.contains("for 2 parameters"),
            "{error}"
        );
    }
}

/// Two swings with the same strike, beside the face. Only the ball of the first swing lands.
#[test]
fn the_share_of_swings_beyond_a_limit_is_a_share_of_those_that_land() {
    let mut setup = Setup::modern_driver();
    setup.set("strike.toe", "70 mm").unwrap();
    let attack = vec![setup.variable("swing.attack_angle").unwrap()];
    let recorded = Swings::recorded(attack, vec![vec![0.0], vec![-0.7]]).unwrap();
    let search = Search {
        of: Goal::read("mean(ball_speed)", None).unwrap(),
        vary: vec![Vary::read(&setup, "swing.path=-1deg..1deg").unwrap()],
        scenarios: Scenarios::new(&recorded, Rule::Recorded).unwrap(),
        ..Search::largest(Outcome::BallSpeed)
    };
    let best = optimum(&setup, search, Observer::default()).unwrap();
    let warnings = best.warnings(&AtomicBool::new(false));
    let about_face = "100 % of the swings: the strike lies outside";
    assert!(
        warnings
            .iter()
            .any(|warning| warning.to_string().contains(about_face)),
        "{warnings:?}"
    );
}

/// The error of a quadrature is its difference from a rule with more nodes. A rule with one node
/// would have the error 0 if the other rule also had one node.
#[test]
fn the_error_of_a_goal_over_one_node_is_above_0() {
    let setup = Setup::modern_driver();
    let all = swings(&setup, &["swing.attack_angle=uniform(-6deg, 6deg)"]);
    let best = searched(
        &setup,
        "mean(carry)",
        &["club.loft=4deg..30deg"],
        Scenarios::new(&all, Rule::Quadrature(1)).unwrap(),
    );
    let analysis = analyse_over_swings(&setup, &all, &best, &Arc::default());
    let errors = analysis.unwrap().unwrap().errors;
    assert!(
        matches!(errors[..], [GoalError::Quadrature(error)] if error > 0.0),
        "{errors:?}"
    );
}

/// A goal with an edge takes a sequence of swings by default, also over few parameters: over Gauss's
/// nodes its smoothed value has steps. The best share then is no worse than that of the setup and of
/// a search with other swings.
#[test]
fn same_best_share_of_drives_with_other_swings() {
    let search = [
        "optimize",
        "--distribution",
        "swing.face_angle=normal(0deg,2deg)",
        "--maximize",
        "within(lateral,15yd)",
        "--set",
        "wind.right=3m/s",
        "--vary",
        "swing.path=-3deg..3deg",
    ];
    let best = |more: &[&str]| {
        let (status, found) = json(&[&search[..], more].concat());
        assert_eq!(status, 0, "{found:#}");
        assert_eq!(found["swings"]["rule"], "sequence", "{found:#}");
        number(&found["value"])
    };
    let usual = best(&[]);
    let others = best(&["--scenarios", "2048", "--seed", "5"]);
    close(usual, others, 1.0, 0.005, "share within 15 yd");
    best(&["--seed", "7"]);
}
