//! Constraints, searches from many starts, sensitivity and flatness of an optimum, and charts.

use crate::common::{LARGE_STEPS, close};
use longdrive::optimize::{Bounds, Observer, Observers, Solution, Status};
use longdrive::study::{
    Change, ChartObserver, Constraint, Fineness, Goal, Optimum, Region, Search, Sense, Vary,
    change, chart, flatness, map, optima, optimum, sensitivities, sensitivity,
};
use longdrive::units::System;
use longdrive::{Drive, Error, Outcome, Setup};

fn search(setup: &Setup<f64>, vary: &[&str], subject_to: &[&str]) -> Search {
    Search {
        vary: vary
            .iter()
            .map(|text| Vary::read(setup, text).unwrap())
            .collect(),
        subject_to: subject_to
            .iter()
            .map(|text| Constraint::read(text).unwrap())
            .collect(),
        ..Search::longest_drive(setup).unwrap()
    }
}

fn best(setup: &Setup<f64>, search: &Search) -> Optimum {
    let best = optimum(setup, search.clone(), Observer::default()).unwrap();
    assert_eq!(
        best.solution.status,
        Status::Converged,
        "{}",
        best.message()
    );
    best
}

fn names(best: &Optimum) -> Vec<String> {
    best.active().iter().map(ToString::to_string).collect()
}

const BOX: [&str; 2] = ["club.loft=0deg..20deg", "swing.attack_angle=-10deg..10deg"];

/// A drive in three dimensions: an off-centre strike, wind, and a face that is not square to the
/// path.
fn off_centre() -> Setup<f64> {
    let mut setup = Setup::modern_driver();
    for (name, value) in [
        ("strike.high", "6 mm"),
        ("strike.toe", "-9 mm"),
        ("swing.path", "2 deg"),
        ("swing.face_angle", "1 deg"),
        ("swing.shaft_lean", "1.5 deg"),
        ("wind.right", "2 m/s"),
        ("wind.downrange", "-3 m/s"),
        ("ground.height", "-2 m"),
        ("flight.step", "0.01 s"),
    ] {
        setup.set(name, value).unwrap();
    }
    setup
}

/// Compares dx*/dp and df*/dp with central differences, for every parameter p that is not varied.
/// x* and f* are the optimum and its value; each difference needs two new searches. One Richardson
/// extrapolation improves the differences.
fn differences_agree(setup: &Setup<f64>, search: &Search) {
    let best = best(setup, search);
    let parameters = best.setup.variables();
    let wrt: Vec<_> = parameters
        .into_iter()
        .filter(|p| search.vary.iter().all(|vary| vary.parameter.name != p.name))
        .collect();
    let mut compared = 0;
    for (parameter, sensitivity) in sensitivities(&best, &wrt, &|_, _| ()).unwrap() {
        let exact = sensitivity.unwrap_or_else(|e| panic!("{}: {e}", parameter.name));
        let value = best.setup.value(parameter).unwrap();
        // the step is proportional to the value of the parameter; a value of 0 counts as 0.1 of the
        // unit
        let unit = parameter.quantity.size_of(parameter.unit).unwrap_or(1.0);
        let size = if value == 0.0 {
            0.1 * unit
        } else {
            value.abs()
        };
        let moved = |delta: f64| {
            let mut setup = best.setup;
            setup.set_value(parameter, Some(value + delta)).ok()?;
            let mut tight = search.clone();
            tight.options.kkt_tolerance = 1e-13;
            let best = optimum(&setup, tight, Observer::default()).unwrap();
            assert!(
                best.solution.residual.largest() < 1e-9,
                "{}: {}",
                parameter.name,
                best.message()
            );
            Some((best.value().unwrap(), best.solution.x))
        };
        let central = |h: f64| {
            let ((above, x_above), (below, x_below)) = (moved(h)?, moved(-h)?);
            let rates = x_above
                .iter()
                .zip(&x_below)
                .map(|(a, b)| (a - b) / (2.0 * h));
            Some(
                std::iter::once((above - below) / (2.0 * h))
                    .chain(rates)
                    .collect::<Vec<f64>>(),
            )
        };
        let h = 2e-3 * size;
        // a parameter at the end of its range has no central difference, and is not compared
        let (Some(wide), Some(narrow)) = (central(h), central(0.5 * h)) else {
            continue;
        };
        let found: Vec<f64> = narrow
            .iter()
            .zip(&wide)
            .map(|(narrow, wide)| (4.0 * narrow - wide) / 3.0)
            .collect();
        let f = best.value().unwrap();
        let expected =
            std::iter::once((exact.value, f)).chain(exact.optimum.iter().map(|rate| (*rate, 1.0)));
        for ((exact, scale), found) in expected.zip(found) {
            let allowed = 1e-5 * exact.abs() + 1e-8 * scale.abs() / size;
            assert!(
                (exact - found).abs() <= allowed,
                "{}: {exact:e} against {found:e}",
                parameter.name
            );
        }
        compared += 1;
    }
    assert!(compared >= 25, "{compared} parameters");
}

#[test]
fn differences_of_new_optima_confirm_every_sensitivity_on_a_bound() {
    let setup = Setup::preset("mae494").unwrap();
    differences_agree(&setup, &search(&setup, &BOX, &[]));
}

#[test]
fn differences_of_new_optima_confirm_every_sensitivity_at_a_constraint() {
    let setup = off_centre();
    let search = search(
        &setup,
        &[
            "club.loft=2deg..20deg",
            "swing.attack_angle=-5deg..8deg",
            "swing.face_angle=-6deg..6deg",
        ],
        &[
            "descent_angle >= 40 deg",
            "lateral == 0 m",
            "apex_height <= 35 yd",
        ],
    );
    differences_agree(&setup, &search);
}

#[test]
fn differences_confirm_the_price_of_a_constraint() {
    let setup = Setup::modern_driver();
    let at = |limit: &str| {
        best(
            &setup,
            &search(
                &setup,
                &["club.loft=4deg..20deg", "swing.attack_angle=-5deg..5deg"],
                &[limit],
            ),
        )
    };
    let held = at("apex_height <= 32 m");
    let constrained = &held.solution.constraints[0];
    close(
        constrained.value,
        32.0,
        1.0,
        1e-10,
        "the limit is met exactly",
    );
    let gain = (at("apex_height <= 32.001 m").value().unwrap()
        - at("apex_height <= 31.999 m").value().unwrap())
        / 0.002;
    close(constrained.multiplier, gain, 1.0, 1e-5, "price");
    assert_eq!(
        names(&held).last().map(String::as_str),
        Some("apex_height <= 32 m")
    );
    // a range, an equation, and an inequality with its limit on the left
    for (text, value) in [
        ("30 m <= apex_height <= 32 m", 32.0),
        ("apex_height == 31 m", 31.0),
        ("31.5 m >= apex_height", 31.5),
    ] {
        close(
            at(text).solution.constraints[0].value,
            value,
            1.0,
            1e-10,
            text,
        );
    }
}

#[test]
fn contradictory_constraints_end_as_infeasible_with_the_smallest_violation() {
    let setup = Setup::modern_driver();
    let search = search(
        &setup,
        &["club.loft=4deg..20deg", "swing.attack_angle=-5deg..5deg"],
        &["apex_height <= 30 m", "apex_height >= 31 m"],
    );
    let none = optimum(&setup, search.clone(), Observer::default()).unwrap();
    assert_eq!(
        (none.solution.status, none.status()),
        (Status::Infeasible, "infeasible"),
        "{}",
        none.message()
    );
    let message = none.message().in_units(System::Metric);
    assert!(
        message.contains("apex_height <= 30 m") && message.contains("apex_height >= 31 m"),
        "{message}"
    );
    // the sum of the squared violations is smallest halfway between the two limits: both violations
    // have the same unit
    let violations: Vec<f64> = none
        .solution
        .constraints
        .iter()
        .map(|c| c.violation)
        .collect();
    close(violations[0], 0.5, 1.0, 1e-6, "too high");
    close(violations[1], -0.5, 1.0, 1e-6, "too low");
    assert!(matches!(
        sensitivity(&none, setup.variable("gravity").unwrap()),
        Err(Error::NotConverged { .. })
    ));
    assert!(matches!(
        flatness(&none, 1.0),
        Err(Error::NotConverged { .. })
    ));
}

#[test]
fn a_fixed_variable_beside_a_constraint_stays_where_it_is() {
    let setup = Setup::modern_driver();
    let search = search(
        &setup,
        &["club.loft=4deg..20deg", "swing.attack_angle=2deg..2deg"],
        &["apex_height <= 30 m"],
    );
    let best = best(&setup, &search);
    assert_eq!(best.solution.x[1], 2.0_f64.to_radians());
    close(best.solution.constraints[0].value, 30.0, 1.0, 1e-9, "apex");
    assert_eq!(names(&best), ["apex_height <= 30 m"]);
}

#[test]
fn every_error_in_a_constraint_has_its_position() {
    for (text, column, says) in [
        (
            "descent_angel >= 38 deg",
            0,
            "did you mean 'descent_angle'?",
        ),
        ("descent_angle >= 38 kg", 17, "not an angle"),
        ("descent_angle >= 38", 17, "has no unit"),
        ("descent_angle => 38 deg", 14, "comparison"),
        ("descent_angle > 38 deg", 14, "comparison"),
        ("descent_angle >= ", 17, "missing"),
        ("descent_angle", 0, "comparison"),
        ("", 0, "missing"),
        ("40 deg <= descent_angle <= 38 deg", 0, "reversed"),
        (
            "40 deg <= descent_angle >= 38 deg",
            24,
            "same comparison twice",
        ),
        ("descent_angle <= inf", 17, "finite"),
        ("carry >= 1 m <= 3 m >= 4 m", 6, "comparison"),
    ] {
        let Err(Error::Constraint {
            column: found,
            reason,
            ..
        }) = Constraint::read(text)
        else {
            panic!("{text}")
        };
        assert!(
            found == column && reason.contains(says),
            "{text:?}: column {found}: {reason}"
        );
    }
}

/// The longest carries of mae494 in these ranges, m, one for each of four batches of sixteen
/// starts.
fn best_of_batches(vary: &[&str]) -> [f64; 4] {
    let setup = Setup::preset("mae494").unwrap();
    [0.0, 1.0, 2.0, 3.0].map(|batch| {
        let mut start = setup;
        // the first start differs from batch to batch; the other starts are the same
        start.swing.attack_angle = batch * 0.02;
        let search = search(&start, vary, &[]);
        let found = optima(&start, &search, 16, &Observers::default()).unwrap();
        let starts = found.locals.iter().map(|local| local.starts.len());
        assert_eq!(starts.sum::<usize>(), 16);
        let first = &found.best;
        assert!(
            matches!(
                first.solution.status,
                Status::Converged | Status::StalledAtKink
            ),
            "{}",
            first.message()
        );
        let values = found.locals.iter().filter_map(|local| local.value);
        assert!(
            values.is_sorted_by(|a, b| *a >= b - 1e-9),
            "{:?}",
            found.locals
        );
        first.value().unwrap()
    })
}

#[test]
fn independent_mae494_optimum_from_every_batch_of_sixteen() {
    for found in best_of_batches(&BOX) {
        close(found, 153.333_552_730_5, 1.0, 1e-9, "best of sixteen");
    }
}

/// The ranges are twice as wide as those of [`BOX`], and contain the kink at zero spin.
#[test]
fn same_mae494_optimum_in_ranges_with_a_kink_from_every_batch_of_sixteen() {
    let values = best_of_batches(&[
        "club.loft=-10deg..30deg",
        "swing.attack_angle=-20deg..20deg",
    ]);
    assert!(
        values.iter().all(|value| (value - values[0]).abs() < 1e-7),
        "{values:?}"
    );
}

#[test]
fn exact_loss_at_the_ends_of_windows() {
    let setup = Setup::modern_driver();
    for vary in [
        ["club.loft=4deg..20deg", "swing.attack_angle=-5deg..5deg"],
        ["club.loft=4deg..11deg", "swing.attack_angle=-25deg..40deg"],
    ] {
        let best = best(&setup, &search(&setup, &vary, &[]));
        let flat = flatness(&best, 0.9144).unwrap();
        let lost = |i: usize, to: f64| {
            let mut moved = best.setup;
            moved
                .set_value(best.search.vary[i].parameter, Some(to))
                .unwrap();
            best.value().unwrap() - Outcome::Carry.of(&Drive::new(&moved).unwrap()).unwrap()
        };
        for (i, window) in flat.windows.iter().enumerate() {
            let x = best.solution.x[i];
            assert!(window.low <= x && x <= window.high);
            for (end, limit) in [
                (window.low, &window.low_limit),
                (window.high, &window.high_limit),
            ] {
                match limit {
                    longdrive::study::WindowLimit::Loss => {
                        close(lost(i, end), 0.9144, 1.0, 1e-9, "loss at the window's end")
                    }
                    other => assert_eq!(*other, longdrive::study::WindowLimit::Bound),
                }
                for part in 1..20 {
                    assert!(lost(i, x + f64::from(part) / 20.0 * (end - x)) <= 0.9144 + 1e-9);
                }
            }
        }
        for direction in &flat.directions {
            for lost in direction.losses.iter().flatten() {
                // the quadratic model predicts a loss of 1 yd; terms of third order change it by up
                // to a third
                assert!((lost / 0.9144 - 1.0).abs() < 0.35, "{direction:?}");
            }
        }
    }
}

#[test]
fn order_of_the_predicted_change_is_second_and_third() {
    let setup = Setup::modern_driver();
    let best = best(
        &setup,
        &search(
            &setup,
            &["club.loft=4deg..20deg", "swing.attack_angle=-5deg..5deg"],
            &[],
        ),
    );
    let error = |text: &str| {
        let changed = change(&best, Change::read(&setup, text).unwrap(), &Ok).unwrap();
        assert!(changed.event.is_none() && changed.differences.is_empty());
        let anew = changed.resolved.value().unwrap();
        let loft = (changed.predicted[0] - changed.resolved.solution.x[0]).abs();
        [
            (changed.first_order - anew).abs(),
            (changed.second_order - anew).abs(),
            loft,
        ]
    };
    let (wide, narrow) = (error("swing.speed=+2mph"), error("swing.speed=+1mph"));
    let orders = [0, 1, 2].map(|k| (wide[k] / narrow[k]).log2());
    assert!(
        (orders[0] - 2.0).abs() < 0.1
            && (orders[1] - 3.0).abs() < 0.15
            && (orders[2] - 2.0).abs() < 0.15,
        "{orders:?}"
    );
}

#[test]
fn a_change_of_the_active_set_is_predicted_and_confirmed() {
    let setup = Setup::modern_driver();
    // the optimum is just inside the limit: more speed raises the apex to the limit
    let search = search(
        &setup,
        &["club.loft=4deg..20deg", "swing.attack_angle=-5deg..5deg"],
        &["apex_height <= 39 yd"],
    );
    let best = best(&setup, &search);
    assert_eq!(names(&best), ["swing.attack_angle at its upper bound"]);
    let changed = change(
        &best,
        Change::read(&setup, "swing.speed=+10mph").unwrap(),
        &Ok,
    )
    .unwrap();
    let event = changed.event.unwrap();
    assert!(
        event.after > 0.0
            && event.after < 1.0
            && event.message.to_string() == "apex_height <= 39 yd becomes active",
        "{event:?}"
    );
    assert_eq!(
        event.message.in_units(System::Metric),
        "apex_height <= 35.6616 m becomes active"
    );
    let differences = changed.differences.iter().map(ToString::to_string);
    let differences: Vec<_> = differences.collect();
    assert!(
        differences.contains(&"apex_height <= 39 yd has become active".into()),
        "{differences:?}"
    );
}

#[test]
fn same_optima_on_the_chart_and_in_single_searches() {
    let setup = Setup::modern_driver();
    let search = search(
        &setup,
        &["club.loft=4deg..20deg", "swing.attack_angle=-5deg..5deg"],
        &["apex_height <= 35 yd"],
    );
    let along = Vary::read(&setup, "swing.speed=80mph..130mph").unwrap();
    let chart = chart(&setup, &search, along, &[], &ChartObserver::default()).unwrap();
    assert!(chart.ended.is_none());
    assert_eq!(
        (chart.points[0].at, chart.points.last().unwrap().at),
        (along.low, along.high)
    );
    assert!(chart.points.windows(2).all(|pair| pair[0].at < pair[1].at));
    for point in chart.points.iter().step_by(3) {
        let mut fresh = setup;
        fresh.swing.speed = point.at;
        let anew = best(&fresh, &search);
        close(
            point.best.value().unwrap(),
            anew.value().unwrap(),
            1.0,
            1e-8,
            "carry on the chart",
        );
    }
    // the first event of the chart: the apex reaches its limit
    let event = chart
        .points
        .iter()
        .find(|point| point.event.is_some())
        .unwrap();
    assert!(
        event
            .event
            .as_ref()
            .unwrap()
            .to_string()
            .contains("apex_height <= 35 yd from here on"),
        "{:?}",
        event.event
    );
    let mut before = setup;
    before.swing.speed = event.at - 1e-6;
    assert!(!names(&best(&before, &search)).contains(&"apex_height <= 35 yd".to_owned()));
    let along_itself = Vary::read(&setup, "club.loft=5deg..6deg").unwrap();
    assert!(matches!(
        longdrive::study::chart(
            &setup,
            &search,
            along_itself,
            &[],
            &ChartObserver::default()
        ),
        Err(Error::Unreadable { .. })
    ));
}

/// The constraint is a carry of at least 280 yd. The chart begins at the speed whose longest carry
/// is 280 yd.
#[test]
fn same_begin_of_a_chart_and_of_the_feasible_range() {
    let mut setup = Setup::modern_driver();
    setup.set_all(LARGE_STEPS).unwrap();
    let vary = ["club.loft=4deg..20deg", "swing.attack_angle=-5deg..5deg"];
    let (free, limited) = (
        search(&setup, &vary, &[]),
        search(&setup, &vary, &["carry >= 280 yd"]),
    );
    let along = Vary::read(&setup, "swing.speed=80mph..130mph").unwrap();
    let chart = chart(&setup, &limited, along, &[], &ChartObserver::default()).unwrap();
    let begun = chart.points[0].at;
    let at = |speed: f64| {
        let mut setup = setup;
        setup.swing.speed = speed;
        setup
    };
    close(
        best(&at(begun), &free).value().unwrap(),
        280.0 * 0.9144,
        1.0,
        1e-6,
        "the largest carry at the beginning",
    );
    let below = optimum(&at(begun * (1.0 - 1e-6)), limited, Observer::default()).unwrap();
    assert_eq!(
        below.solution.status,
        Status::Infeasible,
        "{}",
        below.message()
    );
    assert!(chart.ended.is_none());
    let output = chart.begun.unwrap().to_string();
    assert!(
        output.contains(
            "no optimum was found at 80 mph: infeasible: no point was found that meets \
                       the constraints"
        ),
        "{output}"
    );
    assert_eq!(
        output.matches("no optimum was found").count(),
        1,
        "{output}"
    );
}

#[test]
fn a_search_leaves_a_saddle_for_a_maximum() {
    // by symmetry the landing speed has its minimum at zero cross wind
    let setup = Setup::modern_driver();
    let search = Search {
        of: Outcome::LandingSpeed.into(),
        ..search(&setup, &["wind.right=-20m/s..20m/s"], &[])
    };
    let best = best(&setup, &search);
    assert_eq!(best.solution.x[0].abs(), 20.0);
    let bounds = Bounds::new(vec![0.0], vec![1.0]).unwrap();
    assert_eq!(
        (
            bounds.excess(0, 1.5),
            bounds.excess(0, -1.0),
            bounds.excess(0, 0.5)
        ),
        (0.5, -1.0, 0.0)
    );
}

/// A change of the attack angle pitches the head too. In the frame of the head the impact does not
/// change, so the spin depends only on the loft.
#[test]
fn an_optimum_that_does_not_depend_on_a_variable_has_no_sensitivity() {
    let setup = Setup::modern_driver();
    let vary = ["club.loft=4deg..20deg", BOX[1]];
    let search = Search {
        of: Outcome::Spin.into(),
        sense: Sense::Minimize,
        ..search(&setup, &vary, &[])
    };
    let found = best(&setup, &search);
    assert!(!found.is_idle(0) && found.is_idle(1));
    let message = found.message().to_string();
    assert!(
        message.ends_with("within its range it changes spin by less than a millionth of it"),
        "{message}"
    );
    let spin = |attack: f64| {
        let mut setup = found.setup;
        setup.swing.attack_angle = attack;
        Outcome::Spin.of(&Drive::new(&setup).unwrap()).unwrap()
    };
    for attack in [-0.17, -0.05, 0.1, 0.17] {
        close(spin(attack), found.value().unwrap(), 1.0, 1e-12, "spin");
    }
    let error = sensitivity(&found, found.setup.variable("swing.speed").unwrap()).unwrap_err();
    assert!(error.to_string().contains("not isolated"), "{error}");
}

/// Searches that maximize and that minimize report the same point: that with the smallest
/// violation.
#[test]
fn same_nearest_point_of_many_starts_for_both_senses() {
    let setup = Setup::modern_driver();
    let limits = ["descent_angle >= 45 deg", "apex_height <= 30 yd"];
    let nearest = [Sense::Maximize, Sense::Minimize].map(|sense| {
        let search = Search {
            sense,
            ..search(
                &setup,
                &["club.loft=4deg..20deg", "swing.attack_angle=-5deg..5deg"],
                &limits,
            )
        };
        let found = optima(&setup, &search, 8, &Observers::default()).unwrap();
        let ends: Vec<_> = found.locals.iter().map(|local| &local.solution).collect();
        assert!(ends.len() > 1 && ends.iter().all(|end| end.status == Status::Infeasible));
        // for a comparison of different units, each violation is divided by the largest derivative
        // of its outcome by the variables
        let missed = |end: &&Solution| -> f64 {
            let slope = |j: usize| {
                ends.iter()
                    .map(|end| {
                        end.jacobian[j][0]
                            .abs()
                            .max(end.jacobian[j][1].abs() * 0.625)
                    })
                    .fold(0.0, f64::max)
            };
            end.constraints
                .iter()
                .enumerate()
                .map(|(j, limit)| (limit.violation / slope(j)).powi(2))
                .sum()
        };
        let least = ends.iter().map(missed).fold(f64::INFINITY, f64::min);
        close(
            missed(&ends[0]),
            least,
            1.0,
            1e-12,
            "the nearest comes first",
        );
        ends[0].x.clone()
    });
    nearest[0]
        .iter()
        .zip(&nearest[1])
        .for_each(|(a, b)| close(*a, *b, 1.0, 1e-6, "nearest point"));
}

#[test]
fn a_chart_of_a_sum_of_outcomes_is_refused_with_this_reason() {
    let setup = Setup::modern_driver();
    let mut search = search(&setup, &["club.loft=8deg..14deg"], &[]);
    search.of = Goal::read("mean(carry) - 2*mean(apex_height)", None).unwrap();
    let error = search.refuse_swings().unwrap_err().to_string();
    assert!(
        error.contains("a goal is not a single outcome") && !error.contains("swings that vary"),
        "{error}"
    );
}

#[test]
fn no_starts_and_no_nodes_are_refused() {
    let setup = Setup::modern_driver();
    let search = search(
        &setup,
        &["club.loft=8deg..12deg", "swing.attack_angle=-2deg..2deg"],
        &[],
    );
    let error = optima(&setup, &search, 0, &Observers::default())
        .unwrap_err()
        .to_string();
    assert!(error.contains("at least one start"), "{error}");
    let nodes = |nodes| {
        map(
            &setup,
            Outcome::BallSpeed,
            search.vary[0],
            search.vary[1],
            Fineness { nodes, slopes: 0 },
        )
    };
    for count in [0, 1] {
        assert!(
            nodes(count)
                .unwrap_err()
                .to_string()
                .contains("2 nodes or more"),
            "{count}"
        );
    }
    assert_eq!(nodes(2).unwrap().plane.values[0].len(), 4);
}

#[test]
fn a_loss_that_is_not_above_0_and_finite_is_refused_with_its_unit() {
    let best = best(
        &Setup::modern_driver(),
        &search(&Setup::modern_driver(), &BOX, &[]),
    );
    let [across, up] = [best.search.vary[0], best.search.vary[1]];
    for loss in [0.0, -0.9144, f64::NAN, f64::INFINITY] {
        let refusals = [
            flatness(&best, loss).unwrap_err().to_string(),
            Region::around(&best, across, up, loss)
                .unwrap_err()
                .to_string(),
        ];
        for refusal in refusals {
            assert!(
                refusal.contains(" yd; it must be finite and above 0"),
                "{refusal}"
            );
        }
    }
}

/// The ball speed is stated, so that the equation holds everywhere, within the rounding of the
/// length of the velocity. The objective is 0 everywhere.
#[test]
fn an_equation_that_holds_up_to_rounding_excludes_no_point_of_a_region() {
    let mut setup = Setup::modern_driver();
    for (name, value) in [
        ("launch.ball_speed", "74.7 m/s"),
        ("launch.launch_angle", "11 deg"),
        ("launch.backspin", "2700 rpm"),
    ] {
        setup.set(name, value).unwrap();
    }
    let vary = [
        "launch.launch_angle=8deg..14deg",
        "launch.backspin=2000rpm..3000rpm",
    ];
    let search = Search {
        vary: vary.map(|text| Vary::read(&setup, text).unwrap()).into(),
        subject_to: vec![Constraint::read("ball_speed == 74.7 m/s").unwrap()],
        ..Search::largest(Outcome::Lateral)
    };
    let best = optimum(&setup, search, Observer::default()).unwrap();
    let [across, up] = [best.search.vary[0], best.search.vary[1]];
    let region = Region::around(&best, across, up, 1.0).unwrap().unwrap();
    assert_eq!(region.equation, None);
}
