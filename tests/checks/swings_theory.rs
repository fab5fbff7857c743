//! Derivatives of goals over many swings, and convergence of the optimum over a sample of swings to
//! the optimum over all swings.

use crate::common::close;
use crate::random::Random;
use crate::swings::swings;
use longdrive::optimize::{Observer, Options};
use longdrive::study::swings::{Rule, Scenarios, Strokes, Swings};
use longdrive::study::{Goal, Search, Sense, Vary, optimum};
use longdrive::{Outcome, Setup};

/// The derivatives of every goal and of their sum agree with differences of values and of
/// gradients.
#[test]
fn differences_certify_every_goal_and_their_weighted_sum() {
    let mut setup = Setup::preset("tour-average").unwrap();
    // large steps take less time; derivatives belong to the drive in its own steps
    setup.set_all(crate::common::LARGE_STEPS).unwrap();
    let all = swings(
        &setup,
        &[
            "swing.face_angle=normal(0.4 deg, 2 deg)",
            "strike.toe=normal(2 mm, 6 mm)",
            "swing.speed=normal(110 mph, 2 mph)",
        ],
    );
    let scenarios = Scenarios::new(&all, Rule::Quadrature(3)).unwrap();
    let strokes = Strokes::new(
        &[
            (0.0, 1.0),
            (50.0, 2.6),
            (150.0, 3.0),
            (260.0, 3.6),
            (450.0, 4.6),
        ],
        "m",
        false,
    )
    .unwrap();
    let names = ["club.loft", "club.bulge_radius", "club.cg_depth"];
    let vary = [
        "club.loft=5deg..15deg",
        "club.bulge_radius=200mm..600mm",
        "club.cg_depth=20mm..60mm",
    ];
    let at = |goal: &str, moved: [f64; 3]| {
        let mut here = setup;
        for (name, by) in names.iter().zip(moved) {
            let parameter = setup.variable(name).unwrap();
            here.set_value(
                parameter,
                Some(setup.value(parameter).unwrap() * (1.0 + by)),
            )
            .unwrap();
        }
        let search = Search {
            of: Goal::read(goal, Some(&strokes)).unwrap(),
            sense: Sense::Minimize,
            vary: vary
                .iter()
                .map(|text| Vary::read(&setup, text).unwrap())
                .collect(),
            subject_to: vec![],
            options: Options {
                max_iterations: 0,
                ..Options::default()
            },
            scenarios: scenarios.clone(),
        };
        optimum(&here, search, Observer::default())
            .unwrap()
            .solution
    };
    let size = names.map(|name| setup.value(setup.variable(name).unwrap()).unwrap());
    for goal in [
        "mean(carry)",
        "std(lateral)",
        "rms(lateral)",
        "lowest(carry, 20%)",
        "highest(descent_angle, 20%)",
        "within(lateral, 15yd)",
        "strokes(420yd)",
        "mean(carry) - 0.5*std(lateral) + 20yd*within(lateral, 12yd)",
    ] {
        let here = at(goal, [0.0; 3]);
        let value = here.value.unwrap().abs();
        for i in 0..3 {
            let step = |h: f64| {
                let mut by = [0.0; 3];
                by[i] = h;
                at(goal, by)
            };
            // differences of order 4
            const H: f64 = 1e-3;
            let four = [-2.0, -1.0, 1.0, 2.0].map(|k| step(k * H));
            let slope = |f: &dyn Fn(usize) -> f64| {
                (f(0) - 8.0 * f(1) + 8.0 * f(2) - f(3)) / (12.0 * H * size[i])
            };
            let found = slope(&|k| four[k].value.unwrap());
            close(
                here.gradient[i] * size[i],
                found * size[i],
                value,
                2e-7,
                goal,
            );
            for j in 0..3 {
                let found = slope(&|k| four[k].gradient[j]);
                let scale = value / (size[i] * size[j]);
                close(here.hessian[i][j], found, scale, 2e-6, goal);
            }
        }
    }
}

/// Order of convergence: the slope of a line through the logarithms of the points.
fn order(points: &[(f64, f64)]) -> f64 {
    let logs: Vec<_> = points
        .iter()
        .map(|(n, error)| (n.ln(), error.ln()))
        .collect();
    let mean = |of: fn(&(f64, f64)) -> f64| logs.iter().map(of).sum::<f64>() / logs.len() as f64;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    logs.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>()
        / logs.iter().map(|p| (p.0 - x).powi(2)).sum::<f64>()
}

/// The error of the best loft over a sample of swings decreases with 1/√n for n random swings, and
/// faster for a quasi-random sequence.
#[test]
fn order_of_the_error_of_the_optimum_over_a_sample() {
    let mut setup = Setup::preset("mae494").unwrap();
    // large steps take a tenth of the time, and have an error of carry of 1e-8 m
    setup.set_all(crate::common::LARGE_STEPS).unwrap();
    let all = swings(
        &setup,
        &[
            "swing.attack_angle=uniform(-4 deg, 6 deg)",
            "swing.speed=uniform(90 mph, 110 mph)",
        ],
    );
    let best = |scenarios: Scenarios| {
        let search = Search {
            of: Goal::read("mean(carry)", None).unwrap(),
            sense: Sense::Maximize,
            vary: vec![Vary::read(&setup, "club.loft=4deg..25deg").unwrap()],
            scenarios,
            ..Search::largest(Outcome::Carry)
        };
        optimum(&setup, search, Observer::default())
            .unwrap()
            .solution
            .x[0]
    };
    let exact = best(Scenarios::new(&all, Rule::Quadrature(16)).unwrap());
    const SEEDS: u32 = 24;
    let root_mean_square = |of: &dyn Fn(u32) -> f64| {
        ((0..SEEDS)
            .map(|seed| (of(seed) - exact).powi(2))
            .sum::<f64>()
            / f64::from(SEEDS))
        .sqrt()
    };
    let random = |count: usize, seed: u32| {
        let mut random = Random::seeded(u64::from(seed) * 1000 + count as u64);
        let mut share = || random.between(0.0, 1.0);
        let mut row = || {
            vec![
                (10.0 * share() - 4.0).to_radians(),
                (90.0 + 20.0 * share()) * 0.44704,
            ]
        };
        let rows = (0..count).map(|_| row()).collect();
        let recorded = Swings::recorded(all.parameters(), rows).unwrap();
        best(Scenarios::new(&recorded, Rule::Recorded).unwrap())
    };
    let sequence = |count: usize, seed: u32| {
        best(Scenarios::new(&all, Rule::Sequence { count, seed }).unwrap())
    };
    let counts = [8, 32, 128];
    let points = |of: &dyn Fn(usize, u32) -> f64| {
        counts.map(|count| (count as f64, root_mean_square(&|seed| of(count, seed))))
    };
    let (by_chance, by_sequence) = (points(&random), points(&sequence));
    let orders = [order(&by_chance), order(&by_sequence)];
    println!(
        "random {by_chance:?}: order {:.2}; sequence {by_sequence:?}: order {:.2}",
        orders[0], orders[1]
    );
    assert!(
        (orders[0] + 0.5).abs() < 0.12,
        "{by_chance:?}: {}",
        orders[0]
    );
    assert!(
        orders[1] < -0.9 && by_sequence[2].1 < 0.2 * by_chance[2].1,
        "{by_sequence:?}: {}",
        orders[1]
    );
}
