//! The optimizer on drives with known optima and on functions with known difficulties.

use crate::common::{close, data, number, setup_of};
use longdrive::optimize::{
    Domain, Evaluation, Observer, Options, Solution, Status, Taylor, minimize, minimize_observed,
    sensitivity,
};
use longdrive::study::{Constraint, Search, Vary, optimum};
use longdrive::{Drive, Error, Setup, study::Optimum};
use std::cell::{Cell, RefCell};
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

type Evaluated = Result<Evaluation, String>;

fn solve(f: impl Fn(&[f64]) -> Evaluated, bounds: &[(f64, f64)], start: &[f64]) -> Solution {
    let (low, high) = bounds.iter().copied().unzip();
    minimize(
        &f,
        &Domain::new(low, high).unwrap(),
        start,
        &Options::default(),
    )
    .unwrap()
}

/// A function without constraints.
fn plain(value: f64, gradient: Vec<f64>, hessian: Vec<Vec<f64>>) -> Evaluation {
    Evaluation::unconstrained(Taylor {
        value,
        gradient,
        hessian,
    })
}

fn mae494(attack: f64, loft: f64, ranges: [&str; 2]) -> Optimum {
    let mut setup = Setup::preset("mae494").unwrap();
    (setup.swing.attack_angle, setup.club.loft) = (attack.to_radians(), loft.to_radians());
    let vary = ranges
        .map(|text| Vary::read(&setup, text).unwrap())
        .to_vec();
    let search = Search {
        vary,
        ..Search::longest_drive(&setup).unwrap()
    };
    optimum(&setup, search, Observer::default()).unwrap()
}

/// Starts that are spread evenly over a box.
fn starts(count: u32, low: [f64; 2], high: [f64; 2]) -> impl Iterator<Item = [f64; 2]> {
    // a quasi-random sequence: fractions of multiples of two powers of the inverse plastic number
    (0..count).map(move |k| {
        let part =
            |step: f64, i: usize| low[i] + (f64::from(k) * step + 0.5).fract() * (high[i] - low[i]);
        [
            part(0.754_877_666_246_692_8, 0),
            part(0.569_840_290_998_053_3, 1),
        ]
    })
}

#[test]
fn independent_optima_from_the_reference_file() {
    for reference in data("reference_drives.json")["optima"].as_array().unwrap() {
        let setup = setup_of(reference);
        let vary = |i: usize| {
            let parameter = setup
                .variable(reference["variables"][i].as_str().unwrap())
                .unwrap();
            Vary::new(
                parameter,
                number(&reference["bounds"][i][0]),
                number(&reference["bounds"][i][1]),
            )
            .unwrap()
        };
        let search = Search {
            vary: vec![vary(0), vary(1)],
            ..Search::longest_drive(&setup).unwrap()
        };
        let best = optimum(&setup, search, Observer::default()).unwrap();
        assert_eq!(best.solution.status, Status::Converged);
        close(
            best.value().unwrap(),
            number(&reference["carry"]),
            1.0,
            1e-8,
            "carry",
        );
        for i in 0..2 {
            close(
                best.solution.x[i],
                number(&reference["optimum"][i]),
                1.0,
                1e-10,
                "optimum",
            );
            let multiplier =
                best.solution.lower_multipliers[i] + best.solution.upper_multipliers[i];
            close(
                multiplier,
                number(&reference["multipliers"][i]),
                1.0,
                1e-8,
                "multiplier",
            );
            let bound = match reference["active"][i].as_str().unwrap() {
                "lower" => number(&reference["bounds"][i][0]),
                "upper" => number(&reference["bounds"][i][1]),
                _ => continue,
            };
            assert_eq!(best.solution.x[i], bound, "an active bound is exact");
        }
    }
}

#[test]
fn steps_of_a_constrained_optimum_are_exact_and_most_need_no_interior_point_method() {
    let mut setup = Setup::preset("modern-driver").unwrap();
    setup
        .set_all([
            ("swing.path", "2 deg"),
            ("swing.face_angle", "1 deg"),
            ("strike.toe", "8 mm"),
        ])
        .unwrap();
    let ranges = [
        "club.loft=4deg..20deg",
        "swing.attack_angle=-5deg..5deg",
        "swing.face_angle=-3deg..3deg",
    ];
    let vary = ranges
        .map(|text| Vary::read(&setup, text).unwrap())
        .to_vec();
    let subject_to = vec![Constraint::read("-2 m <= lateral <= 2 m").unwrap()];
    let search = Search {
        vary,
        subject_to,
        ..Search::longest_drive(&setup).unwrap()
    };
    let Solution { status, effort, .. } = optimum(&setup, search, Observer::default())
        .unwrap()
        .solution;
    assert_eq!(status, Status::Converged);
    assert!(
        effort.unpolished == 0 && effort.clarabel >= 1 && effort.warm_starts >= 1,
        "{effort:?}"
    );
}

#[test]
fn independent_mae494_optimum_from_every_start_with_a_flight() {
    let mut flying = 0;
    for [loft, attack] in starts(300, [0.0, -10.0], [20.0, 10.0]) {
        let best = mae494(
            attack,
            loft,
            ["club.loft=0deg..20deg", "swing.attack_angle=-10deg..10deg"],
        );
        assert_eq!(
            best.solution.status,
            Status::Converged,
            "from {loft}, {attack}: {}",
            best.solution.message
        );
        close(
            best.solution.x[0].to_degrees(),
            14.682_922_531_9,
            1.0,
            1e-8,
            "loft",
        );
        assert_eq!(best.solution.x[1], 10.0_f64.to_radians());
        close(
            best.value().unwrap(),
            153.333_552_730_536,
            1.0,
            1e-9,
            "carry at step 0.01 s",
        );
        close(
            best.solution.upper_multipliers[1],
            60.292_494_887_4,
            1.0,
            1e-6,
            "multiplier",
        );
        if best.solution.undefined_at_start.is_none() {
            flying += 1;
            assert!(
                best.solution.iterations <= 15,
                "{} iterations from {loft}, {attack}",
                best.solution.iterations
            );
        }
    }
    assert!((200..300).contains(&flying), "{flying} starts fly");
}

#[test]
fn every_start_in_a_box_twice_as_wide_ends_at_the_same_kkt_point() {
    let mut values = vec![];
    for [loft, attack] in starts(200, [-10.0, -20.0], [30.0, 20.0]) {
        let best = mae494(
            attack,
            loft,
            [
                "club.loft=-10deg..30deg",
                "swing.attack_angle=-20deg..20deg",
            ],
        );
        assert_eq!(
            best.solution.status,
            Status::Converged,
            "from {loft}, {attack}: {}",
            best.solution.message
        );
        assert!(best.solution.residual.largest() <= 1e-10 && best.solution.iterations <= 15);
        assert_eq!(best.solution.x[1], 20.0_f64.to_radians());
        values.push(best.value().unwrap());
    }
    let (least, most) = values
        .iter()
        .fold((f64::MAX, f64::MIN), |(a, b), v| (v.min(a), v.max(b)));
    assert!(most - least < 1e-9 && least > 162.0, "{least} to {most}");
}

#[test]
fn independent_corner_at_zero_spin_from_every_start_in_a_wide_box() {
    // the optimum of docs/model.md: loft 0°, attack angle 38.53°, carry 170.574 m. The slope of
    // carry by loft jumps there from +83.7 to −29.7 m/rad
    for loft_range in ["club.loft=-10deg..20deg", "club.loft=0deg..20deg"] {
        for [loft, attack] in starts(40, [0.0, -5.0], [20.0, 60.0]) {
            let best = mae494(
                attack,
                loft,
                [loft_range, "swing.attack_angle=-10deg..60deg"],
            );
            let solution = &best.solution;
            // at loft 0° carry has a kink: inside the range of loft, or at the end of the range
            let is_inside = loft_range.contains("-10");
            assert_eq!(
                solution.status,
                Status::Converged,
                "from {loft}, {attack}: {}",
                solution.message
            );
            close(best.value().unwrap(), 170.5743156, 1.0, 1e-6, "carry");
            close(solution.x[0].to_degrees(), 0.0, 1.0, 1e-6, "loft");
            close(
                solution.x[1].to_degrees(),
                38.532,
                1.0,
                1e-3,
                "attack angle",
            );
            let kink = solution.kink.unwrap();
            assert_eq!(kink.variable, 0);
            close(
                kink.slope_above.unwrap(),
                29.66,
                1.0,
                0.05,
                "slope of −carry above",
            );
            if is_inside {
                close(
                    kink.slope_below.unwrap(),
                    -83.72,
                    1.0,
                    0.05,
                    "slope of −carry below",
                );
            } else {
                assert_eq!((solution.x[0], kink.slope_below), (0.0, None));
                close(
                    solution.lower_multipliers[0],
                    29.66,
                    1.0,
                    0.05,
                    "price inside the bound",
                );
            }
            assert!(
                best.message().to_string().contains("club.loft"),
                "{}",
                best.message()
            );
        }
    }
}

#[test]
fn a_start_without_a_flight_is_replaced_and_reported() {
    let best = mae494(
        -9.0,
        1.0,
        ["club.loft=0deg..20deg", "swing.attack_angle=-10deg..10deg"],
    );
    assert_eq!(best.solution.status, Status::Converged);
    assert!(best.moved_start().unwrap().contains("no flight"));

    let none = mae494(
        -9.0,
        1.0,
        ["club.loft=0deg..2deg", "swing.attack_angle=-10deg..-8deg"],
    );
    assert_eq!(
        (none.solution.status, none.status(), none.value()),
        (Status::Undefined, "no-flight", None)
    );
    assert!(
        none.drive.is_none()
            && none
                .message()
                .to_string()
                .contains("no drive of the search flies")
    );
}

#[test]
fn a_setup_cannot_be_searched_over_nothing_or_twice_over_the_same() {
    let setup = Setup::modern_driver();
    let fixed = Vary::read(&setup, "club.loft=5deg..5deg").unwrap();
    let search = Search {
        vary: vec![fixed],
        ..Search::longest_drive(&setup).unwrap()
    };
    assert!(matches!(
        optimum(&setup, search, Observer::default()),
        Err(Error::Nothing { .. })
    ));
    let loft = Vary::read(&setup, "club.loft=5deg..10deg").unwrap();
    let search = Search {
        vary: vec![loft, loft],
        ..Search::longest_drive(&setup).unwrap()
    };
    assert!(matches!(
        optimum(&setup, search, Observer::default()),
        Err(Error::SearchRange { .. })
    ));
}

#[test]
fn differences_confirm_optimum_and_price_of_the_default_search() {
    let setup = Setup::modern_driver();
    let best = optimum(
        &setup,
        Search::longest_drive(&setup).unwrap(),
        Observer::default(),
    )
    .unwrap();
    assert_eq!(best.solution.status, Status::Converged);
    let carry = |loft: f64, attack: f64| {
        let mut moved = best.setup;
        (moved.club.loft, moved.swing.attack_angle) = (loft, attack);
        Drive::new(&moved).unwrap().landed().unwrap().carry
    };
    let [loft, attack] = [best.solution.x[0], best.solution.x[1]];
    // the value of the optimum equals the carry of `Drive::new`, to rounding
    assert!((carry(loft, attack) / best.value().unwrap() - 1.0).abs() < 1e-13);
    for (d_loft, d_attack) in [(0.01, 0.0), (-0.01, 0.0), (0.0, -0.01)] {
        assert!(carry(loft + d_loft, attack + d_attack) < best.value().unwrap());
    }
    // the multiplier is the derivative of carry by the upper bound of the attack angle
    let gain = carry(loft, attack + 1e-6) - carry(loft, attack - 1e-6);
    close(
        best.solution.upper_multipliers[1],
        gain / 2e-6,
        100.0,
        1e-5,
        "price",
    );
}

/// (1 − x)² + 100 (y − x²)².
fn rosenbrock(v: &[f64]) -> Evaluated {
    let (x, y) = (v[0], v[1]);
    let r = y - x * x;
    Ok(plain(
        (1.0 - x).powi(2) + 100.0 * r * r,
        vec![-2.0 * (1.0 - x) - 400.0 * x * r, 200.0 * r],
        vec![
            vec![2.0 - 400.0 * r + 800.0 * x * x, -400.0 * x],
            vec![-400.0 * x, 200.0],
        ],
    ))
}

#[test]
fn exact_rosenbrock_free_and_against_a_bound() {
    let free = solve(rosenbrock, &[(-5.0, 5.0), (-5.0, 5.0)], &[-1.2, 1.0]);
    assert_eq!(free.status, Status::Converged);
    assert!((free.x[0] - 1.0).abs() < 1e-9 && (free.x[1] - 1.0).abs() < 1e-9);

    // with x ≤ ½ the minimum is at (½, ¼), and the bound has the multiplier 2 (1 − ½) = 1
    let held = solve(rosenbrock, &[(-5.0, 0.5), (-5.0, 5.0)], &[-1.2, 1.0]);
    assert_eq!((held.status, held.x[0]), (Status::Converged, 0.5));
    assert!((held.x[1] - 0.25).abs() < 1e-10 && (held.upper_multipliers[0] - 1.0).abs() < 1e-8);

    let unbounded = solve(
        rosenbrock,
        &[
            (f64::NEG_INFINITY, f64::INFINITY),
            (f64::NEG_INFINITY, f64::INFINITY),
        ],
        &[-1.2, 1.0],
    );
    assert_eq!(unbounded.status, Status::Converged);
    assert!((unbounded.x[0] - 1.0).abs() < 1e-8);
}

#[test]
fn exact_minima_of_indefinite_functions_lie_in_corners_of_the_box() {
    // x y on [−1, 2]²: saddle at 0, minima −2 at (−1, 2) and (2, −1)
    let saddle = |v: &[f64]| {
        Ok(plain(
            v[0] * v[1],
            vec![v[1], v[0]],
            vec![vec![0.0, 1.0], vec![1.0, 0.0]],
        ))
    };
    for start in [[0.1, 0.3], [0.5, -0.2], [1.9, 1.8], [-0.9, -0.8]] {
        let s = solve(saddle, &[(-1.0, 2.0), (-1.0, 2.0)], &start);
        assert_eq!(
            (s.status, s.value),
            (Status::Converged, Some(-2.0)),
            "from {start:?}: {s:?}"
        );
        assert_eq!(
            s.lower_multipliers
                .iter()
                .chain(&s.upper_multipliers)
                .copied()
                .fold(0.0, f64::max),
            2.0
        );
    }
    // the search starts where the curvature of cos 3x is negative; the minimum is at π/3
    let wave = |v: &[f64]| {
        let (sin, cos) = (3.0 * v[0]).sin_cos();
        Ok(plain(cos, vec![-3.0 * sin], vec![vec![-9.0 * cos]]))
    };
    let s = solve(wave, &[(-0.5, 2.0)], &[0.1]);
    assert_eq!(s.status, Status::Converged);
    assert!((s.x[0] - std::f64::consts::FRAC_PI_3).abs() < 1e-9);
}

#[test]
fn exact_minimum_at_the_corner_of_an_absolute_value() {
    // |x − 0.3| + (y − x)²: the minimum 0 at x = 0.3 = y
    let f = |v: &[f64]| {
        let (side, d) = ((v[0] - 0.3).signum(), v[1] - v[0]);
        Ok(plain(
            (v[0] - 0.3).abs() + d * d,
            vec![side - 2.0 * d, 2.0 * d],
            vec![vec![2.0, -2.0], vec![-2.0, 2.0]],
        ))
    };
    for start in [[-0.9, 0.8], [0.7, -0.4], [0.31, 0.9]] {
        let s = solve(f, &[(-1.0, 1.0), (-1.0, 1.0)], &start);
        assert_eq!(s.status, Status::Converged, "from {start:?}: {}", s.message);
        assert!(
            (s.x[0] - 0.3).abs() < 1e-8 && (s.x[1] - 0.3).abs() < 1e-8,
            "{:?}",
            s.x
        );
        let kink = s.kink.unwrap();
        assert!(
            (kink.slope_below.unwrap() + 1.0).abs() < 1e-4
                && (kink.slope_above.unwrap() - 1.0).abs() < 1e-4
        );
        // x is fixed at the kink. By y the curvature is 2, or 2 · 2² = 8 in units of the range of y
        let domain = Domain::new(vec![-1.0; 2], vec![1.0; 2]).unwrap();
        let (_, curvatures) = sensitivity::reduced_hessian(&s, &domain);
        assert_eq!((curvatures.shape(), curvatures[(0, 0)]), ((1, 1), 8.0));
    }
}

#[test]
fn exact_minimum_at_a_kink_of_the_objective_on_a_constraint() {
    // |x − 0.3| + 1.5 x + y²/2 with x + y ≥ 1: at x = 0.3, y = 0.7 the multiplier is −0.7. The
    // slopes of f by x are 0.5 and 2.5, those of the Lagrangian −0.2 and 1.8
    let f = |v: &[f64]| {
        let side = (v[0] - 0.3).signum();
        let objective = Taylor {
            value: (v[0] - 0.3).abs() + 1.5 * v[0] + 0.5 * v[1] * v[1],
            gradient: vec![side + 1.5, v[1]],
            hessian: vec![vec![0.0, 0.0], vec![0.0, 1.0]],
        };
        let sum = Taylor {
            value: v[0] + v[1],
            gradient: vec![1.0, 1.0],
            hessian: vec![vec![0.0; 2]; 2],
        };
        vec![objective, sum]
    };
    for start in [[-0.9, 0.8], [0.7, -0.4], [0.31, 0.9]] {
        let found = solve_subject_to(f, &[(1.0, f64::INFINITY)], [(-2.0, 2.0); 2], start);
        assert_eq!(found.status, Status::Converged, "{}", found.message);
        close(found.value.unwrap(), 0.695, 1.0, 1e-8, "value");
        close(
            found.constraints[0].multiplier,
            -0.7,
            1.0,
            1e-6,
            "multiplier",
        );
        assert_eq!(found.kink.map(|kink| kink.variable), Some(0));
    }
}

#[test]
fn exact_tangents_of_constraints_in_units_of_different_sizes() {
    // ½ (x² + y² + z²) with x + y + z ≥ 3 and x − y ≥ 2: at (2, 0, 1) both limits are active, so
    // the only tangent is (1, 1, −2)/√6. The curvature is 1, or 10² in units of the ranges
    for unit in [1e-9, 1.0, 1e9] {
        let problem = |v: &[f64]| {
            let linear = |value: f64, gradient: [f64; 3]| Taylor {
                value,
                gradient: gradient.to_vec(),
                hessian: vec![vec![0.0; 3]; 3],
            };
            let identity = |i: usize| (0..3).map(|k| f64::from(i == k)).collect();
            Ok(Evaluation {
                objective: Taylor {
                    value: 0.5 * v.iter().map(|x| x * x).sum::<f64>(),
                    gradient: v.to_vec(),
                    hessian: (0..3).map(identity).collect(),
                },
                constraints: vec![
                    linear((v[0] + v[1] + v[2]) * unit, [unit; 3]),
                    linear(v[0] - v[1], [1.0, -1.0, 0.0]),
                ],
            })
        };
        let domain = Domain::new(vec![-5.0; 3], vec![5.0; 3])
            .unwrap()
            .with_constraints(vec![3.0 * unit, 2.0], vec![f64::INFINITY; 2])
            .unwrap();
        let found = minimize(&problem, &domain, &[0.5; 3], &Options::default()).unwrap();
        assert_eq!(found.status, Status::Converged, "{}", found.message);
        let (tangents, curvatures) = sensitivity::reduced_hessian(&found, &domain);
        assert_eq!(tangents.shape(), (3, 1), "unit {unit}");
        let sign = tangents[0].signum();
        let expected = [1.0, 1.0, -2.0].map(|part| part / 6.0_f64.sqrt());
        for (tangent, expected) in tangents.iter().zip(expected) {
            close(sign * tangent, expected, 1.0, 1e-12, "tangent");
        }
        close(curvatures[0], 100.0, 100.0, 1e-12, "curvature");
    }
}

#[test]
fn a_kink_along_a_line_oblique_to_the_axes_is_not_taken_for_a_minimum() {
    // |x − y| + (x + y − 1)²: along the line of the kink y moves with x
    let f = |v: &[f64]| {
        let (side, sum) = ((v[0] - v[1]).signum(), v[0] + v[1] - 1.0);
        Ok(plain(
            (v[0] - v[1]).abs() + sum * sum,
            vec![side + 2.0 * sum, 2.0 * sum - side],
            vec![vec![2.0; 2]; 2],
        ))
    };
    let found = solve(f, &[(-1.0, 1.0), (-1.0, 1.0)], &[0.8, -0.6]);
    assert_eq!(found.status, Status::StalledAtKink, "{}", found.message);
}

#[test]
fn a_kink_is_found_beside_a_variable_with_an_undefined_side() {
    // x² + |y − 0.3|, undefined for x < 0: the minimum x = 0 is at the edge
    let f = |v: &[f64]| {
        if v[0] < -1e-9 {
            return Err("x is negative".into());
        }
        let side = (v[1] - 0.3).signum();
        Ok(plain(
            v[0] * v[0] + (v[1] - 0.3).abs(),
            vec![2.0 * v[0], side],
            vec![vec![2.0, 0.0], vec![0.0, 0.0]],
        ))
    };
    let found = solve(f, &[(-1.0, 1.0), (-1.0, 1.0)], &[0.8, -0.6]);
    assert_eq!(found.status, Status::Converged, "{}", found.message);
    assert_eq!(found.kink.map(|kink| kink.variable), Some(1));
}

#[test]
fn iterations_after_a_kink_on_a_bound_are_shown_and_counted_in_the_limit() {
    // a smoothed kink at x = 0, the lower bound of x; after x reaches the bound, y needs further
    // iterations
    let f = |v: &[f64]| {
        let (tip, d) = (v[0].hypot(1e-8), v[1] - 1.0 - v[0]);
        Ok(plain(
            tip - 0.5 * v[0] + d * d,
            vec![v[0] / tip - 0.5 - 2.0 * d, 2.0 * d],
            vec![vec![1e-16 / tip.powi(3) + 2.0, -2.0], vec![-2.0, 2.0]],
        ))
    };
    let domain = Domain::new(vec![0.0, -5.0], vec![1.0, 5.0]).unwrap();
    let search = |max_iterations: u64| {
        let options = Options {
            max_iterations,
            ..Options::default()
        };
        let numbers = Rc::new(RefCell::new(vec![]));
        let shown = numbers.clone();
        let observer =
            Observer::showing(move |iteration| shown.borrow_mut().push(iteration.number));
        let found = minimize_observed(&f, &domain, &[0.5, -3.0], &options, observer).unwrap();
        (found, numbers.take())
    };
    let (whole, numbers) = search(500);
    assert_eq!(whole.status, Status::Converged, "{}", whole.message);
    assert!(whole.kink.is_some());
    assert_eq!(numbers, (0..=whole.iterations).collect::<Vec<_>>());
    for limit in 1..whole.iterations {
        let (found, _) = search(limit);
        assert_eq!(
            (found.status, found.iterations),
            (Status::IterationLimit, limit)
        );
    }
    // interrupt before the last iteration, in which x stays on its bound
    let (flag, last) = (Arc::new(AtomicBool::new(false)), whole.iterations);
    let stop = flag.clone();
    let observer = Observer {
        interrupt: flag,
        ..Observer::showing(move |iteration| {
            stop.store(iteration.number + 1 == last, Ordering::Relaxed);
        })
    };
    let options = Options::default();
    let found = minimize_observed(&f, &domain, &[0.5, -3.0], &options, observer).unwrap();
    assert_eq!(
        (found.status, found.iterations),
        (Status::Interrupted, last - 1)
    );
}

#[test]
fn exact_minimum_next_to_an_undefined_region() {
    // x − ln x, undefined for x ≤ 0: the first steps from the far right lead there
    let f = |v: &[f64]| {
        if v[0] <= 0.0 {
            return Err(format!("ln {} does not exist", v[0]));
        }
        Ok(plain(
            v[0] - v[0].ln(),
            vec![1.0 - 1.0 / v[0]],
            vec![vec![v[0].powi(-2)]],
        ))
    };
    for start in [9.0, 0.01, -4.0] {
        let s = solve(f, &[(-10.0, 10.0)], &[start]);
        assert_eq!(s.status, Status::Converged, "from {start}: {}", s.message);
        assert!((s.x[0] - 1.0).abs() < 1e-8);
        assert_eq!(s.undefined_at_start.is_some(), start < 0.0);
    }
    let never = solve(
        |_: &[f64]| Err("it has no value".into()),
        &[(0.0, 1.0)],
        &[0.5],
    );
    assert_eq!((never.status, never.value), (Status::Undefined, None));
    assert!(never.message.contains("it has no value"));
    let nan = solve(
        |_: &[f64]| Ok(plain(f64::NAN, vec![0.0], vec![vec![0.0]])),
        &[(0.0, 1.0)],
        &[0.5],
    );
    assert_eq!(nan.status, Status::Undefined);
}

#[test]
fn functions_of_wrong_dimensions_are_refused_at_the_first_evaluation() {
    let square = || vec![vec![0.0; 2]; 2];
    let (short, constrained) = (
        plain(0.0, vec![0.0], vec![vec![0.0]]),
        Evaluation {
            constraints: vec![taylor(0.0, [0.0; 2], [[0.0; 2]; 2])],
            ..plain(0.0, vec![0.0; 2], square())
        },
    );
    let no_square = plain(0.0, vec![0.0; 2], vec![vec![0.0; 2]]);
    for (evaluation, words) in [
        (short, "a gradient of length 1"),
        (no_square, "a Hessian of 1 row,"),
        (constrained, "the problem has 1 constraint function,"),
    ] {
        let evaluations = Cell::new(0);
        let problem = |_: &[f64]| {
            evaluations.set(evaluations.get() + 1);
            Ok(evaluation.clone())
        };
        let domain = Domain::new(vec![0.0; 2], vec![1.0; 2]).unwrap();
        let error = minimize(&problem, &domain, &[0.5; 2], &Options::default()).unwrap_err();
        assert!(
            matches!(&error, Error::Optimizer(text) if text.contains(words)),
            "{error}"
        );
        assert_eq!(evaluations.get(), 1);
    }
}

#[test]
fn exact_badly_scaled_quadratic() {
    // curvatures 1e-9 and 1e9, and a minimum at (2e4, 3e-5)
    let f = |v: &[f64]| {
        let (a, b) = (v[0] - 2e4, v[1] - 3e-5);
        Ok(plain(
            0.5e-9 * a * a + 0.5e9 * b * b,
            vec![1e-9 * a, 1e9 * b],
            vec![vec![1e-9, 0.0], vec![0.0, 1e9]],
        ))
    };
    let s = solve(f, &[(-1e5, 1e5), (-1e-4, 1e-4)], &[0.0, 0.0]);
    assert_eq!(s.status, Status::Converged);
    assert!(
        (s.x[0] / 2e4 - 1.0).abs() < 1e-8 && (s.x[1] / 3e-5 - 1.0).abs() < 1e-8,
        "{s:?}"
    );
}

#[test]
fn a_fixed_variable_stays_and_a_linear_function_runs_into_its_bounds() {
    let f = |v: &[f64]| {
        Ok(plain(
            3.0 * v[0] - v[1],
            vec![3.0, -1.0],
            vec![vec![0.0; 2]; 2],
        ))
    };
    let s = solve(f, &[(-1.0, 1.0), (0.25, 0.25)], &[0.5, 0.25]);
    assert_eq!(
        (s.status, s.x.as_slice()),
        (Status::Converged, [-1.0, 0.25].as_slice())
    );
    assert_eq!((s.lower_multipliers[0], s.upper_multipliers[1]), (3.0, 1.0));
}

#[test]
fn running_out_of_iterations_is_a_status_with_numbers() {
    let bounds = Domain::new(vec![-5.0; 2], vec![5.0; 2]).unwrap();
    let options = Options {
        max_iterations: 3,
        ..Options::default()
    };
    let s = minimize(&rosenbrock, &bounds, &[-1.2, 1.0], &options).unwrap();
    assert_eq!((s.status, s.iterations), (Status::IterationLimit, 3));
    assert!(s.message.contains("3 iterations") && s.residual.largest() > 1e-10);
}

#[test]
fn iterations_are_shown_in_order_and_never_get_worse() {
    let seen = Rc::new(RefCell::new(vec![]));
    let shown = Rc::clone(&seen);
    let bounds = Domain::new(vec![-5.0; 2], vec![5.0; 2]).unwrap();
    let observer = Observer::showing(move |i| shown.borrow_mut().push(i.clone()));
    let s = minimize_observed(
        &rosenbrock,
        &bounds,
        &[-1.2, 1.0],
        &Options::default(),
        observer,
    )
    .unwrap();
    let seen = seen.borrow();
    assert_eq!(seen.len() as u64, s.iterations + 1);
    assert!(seen.iter().enumerate().all(|(k, i)| i.number == k as u64));
    assert!(seen.windows(2).all(|pair| pair[1].value <= pair[0].value));
}

#[test]
fn exact_models_of_the_iterations_predict_their_steps() {
    let seen = Rc::new(RefCell::new(vec![]));
    let shown = Rc::clone(&seen);
    let observer = Observer {
        models: true,
        ..Observer::showing(move |i| shown.borrow_mut().push(i.clone()))
    };
    let bounds = Domain::new(vec![-5.0; 2], vec![0.5, 5.0]).unwrap();
    let start = [-1.2, 1.0];
    let options = Options::default();
    minimize_observed(&rosenbrock, &bounds, &start, &options, observer).unwrap();
    let seen = seen.borrow();
    assert!(seen.iter().any(|i| i.number > 0 && !i.accepted));
    for pair in seen.windows(2) {
        let [here, next] = pair else { unreachable!() };
        let model = here.model.as_ref().unwrap();
        let exact = rosenbrock(&here.x).unwrap().objective;
        assert_eq!(model.gradient, exact.gradient);
        assert_eq!(model.hessian, exact.hessian);
        let d = [0, 1].map(|k| model.trial[k] - here.x[k]);
        let of_row = |row: &Vec<f64>| row[0] * d[0] + row[1] * d[1];
        let second: f64 = (0..2).map(|k| d[k] * of_row(&exact.hessian[k])).sum();
        let change = of_row(&exact.gradient) + 0.5 * second;
        let size = 1.0 + here.value;
        close(next.predicted_reduction, -change, size, 1e-12, "predicted");
        let there = rosenbrock(&model.trial).unwrap().objective.value;
        assert_eq!(next.actual_reduction, here.value - there);
        let end = if next.accepted { &model.trial } else { &here.x };
        assert_eq!(next.x, *end);
        for k in 0..2 {
            let bound = [-5.0, [0.5, 5.0][k]];
            assert!(bound[0] <= model.low[k] && model.high[k] <= bound[1]);
            assert!(model.low[k] <= model.trial[k] && model.trial[k] <= model.high[k]);
        }
    }
}

#[test]
fn bounds_starts_and_options_that_make_no_sense_are_errors() {
    assert!(Domain::new(vec![1.0], vec![0.0]).is_err());
    assert!(Domain::new(vec![f64::NAN], vec![0.0]).is_err());
    assert!(Domain::new(vec![f64::INFINITY], vec![f64::INFINITY]).is_err());
    assert!(Domain::new(vec![], vec![]).is_err());
    let bounds = Domain::new(vec![0.0], vec![1.0]).unwrap();
    let f = |v: &[f64]| Ok(plain(v[0], vec![1.0], vec![vec![0.0]]));
    assert!(minimize(&f, &bounds, &[0.1, 0.2], &Options::default()).is_err());
    assert!(minimize(&f, &bounds, &[f64::NAN], &Options::default()).is_err());
    assert!(
        minimize(
            &f,
            &bounds,
            &[0.1],
            &Options {
                kkt_tolerance: 0.0,
                ..Options::default()
            }
        )
        .is_err()
    );
    assert!(
        minimize(
            &f,
            &bounds,
            &[0.1],
            &Options {
                initial_radius: -1.0,
                ..Options::default()
            }
        )
        .is_err()
    );
}

const FREE: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

/// Minimizes the first of the functions; the others are constraints within `limits`.
fn solve_subject_to(
    f: impl Fn(&[f64]) -> Vec<Taylor>,
    limits: &[(f64, f64)],
    bounds: [(f64, f64); 2],
    start: [f64; 2],
) -> Solution {
    let problem = |x: &[f64]| {
        let mut all = f(x);
        Ok(Evaluation {
            constraints: all.split_off(1),
            objective: all.swap_remove(0),
        })
    };
    let (low, high) = bounds.into_iter().unzip();
    let (least, most) = limits.iter().copied().unzip();
    let domain = Domain::new(low, high)
        .unwrap()
        .with_constraints(least, most)
        .unwrap();
    minimize(&problem, &domain, &start, &Options::default()).unwrap()
}

fn taylor(value: f64, gradient: [f64; 2], hessian: [[f64; 2]; 2]) -> Taylor {
    Taylor {
        value,
        gradient: gradient.to_vec(),
        hessian: hessian.map(|row| row.to_vec()).to_vec(),
    }
}

const FLAT: [[f64; 2]; 2] = [[0.0; 2]; 2];

#[test]
fn objectives_that_decrease_without_limit_are_unbounded() {
    // −x³ + y²
    let cubic = |v: &[f64]| {
        let (x, y) = (v[0], v[1]);
        Ok(plain(
            -x.powi(3) + y * y,
            vec![-3.0 * x * x, 2.0 * y],
            vec![vec![-6.0 * x, 0.0], vec![0.0, 2.0]],
        ))
    };
    let found = solve(cubic, &[FREE, FREE], &[1.0, 1.0]);
    assert_eq!(
        (found.status, found.status.name()),
        (Status::Unbounded, "unbounded"),
        "{}",
        found.message
    );
    assert!(
        found.message.contains("variable x[0]") && found.value.unwrap() < -1e30,
        "{}",
        found.message
    );
    // with x ≤ 7 it has a minimum: −343
    let held = solve(cubic, &[(f64::NEG_INFINITY, 7.0), FREE], &[1.0, 1.0]);
    assert_eq!(
        (held.status, held.value),
        (Status::Converged, Some(-343.0)),
        "{}",
        held.message
    );

    let line = |v: &[f64]| Ok(plain(-v[0], vec![-1.0], vec![vec![0.0]]));
    let logarithm = |v: &[f64]| match v[0] > 0.0 {
        true => Ok(plain(
            -v[0].ln(),
            vec![-1.0 / v[0]],
            vec![vec![v[0].powi(-2)]],
        )),
        false => Err("there is no logarithm".to_owned()),
    };
    let exponential = |v: &[f64]| {
        let e = -v[0].exp();
        Ok(plain(e, vec![e], vec![vec![e]]))
    };
    // overflows at x = 6.6
    let overflowing = |v: &[f64]| {
        let (inner, f) = (v[0].exp(), -v[0].exp().exp());
        Ok(plain(
            f,
            vec![f * inner],
            vec![vec![f * inner * (1.0 + inner)]],
        ))
    };
    type Named<'a> = (&'a str, &'a dyn Fn(&[f64]) -> Evaluated);
    let functions: [Named<'_>; 4] = [
        ("−x", &line),
        ("−ln x", &logarithm),
        ("−eˣ", &exponential),
        ("−exp eˣ", &overflowing),
    ];
    for (name, f) in functions {
        let found = solve(f, &[FREE], &[1.0]);
        assert_eq!(
            found.status,
            Status::Unbounded,
            "{name}: {} at {:?}",
            found.message,
            found.x
        );
    }
}

#[test]
fn exact_minima_far_away_are_not_unbounded() {
    // (x − 1e9)²: nine powers of ten from the start
    let far = |v: &[f64]| {
        let d = v[0] - 1e9;
        Ok(plain(d * d, vec![2.0 * d], vec![vec![2.0]]))
    };
    let found = solve(far, &[FREE], &[0.0]);
    assert_eq!(
        (found.status, found.x[0]),
        (Status::Converged, 1e9),
        "{}",
        found.message
    );
    // −x³ + 1e-8 x⁴: the minimum at x = 3/4 · 1e8
    let late = |v: &[f64]| {
        let x = v[0];
        let (f, slope) = (
            -x.powi(3) + 1e-8 * x.powi(4),
            -3.0 * x * x + 4e-8 * x.powi(3),
        );
        Ok(plain(f, vec![slope], vec![vec![-6.0 * x + 12e-8 * x * x]]))
    };
    let found = solve(late, &[FREE], &[1.0]);
    assert_eq!(found.status, Status::Converged, "{}", found.message);
    assert!((found.x[0] / 0.75e8 - 1.0).abs() < 1e-9, "{:?}", found.x);
    // e⁻ˣ has no minimum, but comes nearer to its infimum 0 than any tolerance
    let flat = |v: &[f64]| {
        let e = (-v[0]).exp();
        Ok(plain(e, vec![-e], vec![vec![e]]))
    };
    assert_eq!(solve(flat, &[FREE], &[0.0]).status, Status::Converged);
}

#[test]
fn objectives_unbounded_along_constraints_are_detected() {
    // −x − y on the line x = y
    let line = |v: &[f64]| {
        vec![
            taylor(-v[0] - v[1], [-1.0, -1.0], FLAT),
            taylor(v[0] - v[1], [1.0, -1.0], FLAT),
        ]
    };
    let found = solve_subject_to(line, &[(0.0, 0.0)], [FREE; 2], [0.5, 0.0]);
    assert_eq!(
        found.status,
        Status::Unbounded,
        "{} {:?}",
        found.message,
        found.x
    );
    // −x above the parabola y ≥ x²: unbounded along a curve; with y ≤ 9 the minimum is −3
    let parabola = |v: &[f64]| {
        vec![
            taylor(-v[0], [-1.0, 0.0], FLAT),
            taylor(
                v[1] - v[0] * v[0],
                [-2.0 * v[0], 1.0],
                [[-2.0, 0.0], [0.0, 0.0]],
            ),
        ]
    };
    let above = [(0.0, f64::INFINITY)];
    let found = solve_subject_to(
        parabola,
        &above,
        [FREE, (f64::NEG_INFINITY, 9.0)],
        [1.0, 2.0],
    );
    assert_eq!(found.status, Status::Converged, "{}", found.message);
    assert!((found.x[0] - 3.0).abs() < 1e-8, "{:?}", found.x);
    let found = solve_subject_to(parabola, &above, [FREE; 2], [1.0, 2.0]);
    assert_ne!(
        found.status,
        Status::Converged,
        "{} {:?}",
        found.message,
        found.x
    );
}

#[test]
fn exact_minima_from_stationary_points_of_the_violation() {
    // (x − 20)² + (y + 20)² on the ellipse 0.01 x² + 100 y² = 1, from its centre, where the
    // constraint's gradient vanishes
    let ellipse = |v: &[f64]| {
        let (x, y) = (v[0], v[1]);
        vec![
            taylor(
                (x - 20.0).powi(2) + (y + 20.0).powi(2),
                [2.0 * (x - 20.0), 2.0 * (y + 20.0)],
                [[2.0, 0.0], [0.0, 2.0]],
            ),
            taylor(
                0.01 * x * x + 100.0 * y * y,
                [0.02 * x, 200.0 * y],
                [[0.02, 0.0], [0.0, 200.0]],
            ),
        ]
    };
    // expected: with x = 10 cos t and y = 0.1 sin t, bisection of the derivative by t
    let slope = |t: f64| {
        let (sin, cos) = t.sin_cos();
        -20.0 * sin * (10.0 * cos - 20.0) + 0.2 * cos * (0.1 * sin + 20.0)
    };
    let (mut low, mut high) = (-0.5, 0.5);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if slope(middle) < 0.0 {
            low = middle
        } else {
            high = middle
        }
    }
    let least = (10.0 * low.cos() - 20.0).powi(2) + (0.1 * low.sin() + 20.0).powi(2);
    assert!((least - 499.960_01).abs() < 1e-4, "{least}");
    for start in [[0.0, 0.0], [1e-9, 0.0], [0.0, -1e-12]] {
        let found = solve_subject_to(ellipse, &[(1.0, 1.0)], [FREE; 2], start);
        assert_eq!(
            found.status,
            Status::Converged,
            "from {start:?}: {}",
            found.message
        );
        assert!(
            (found.value.unwrap() - least).abs() < 1e-8,
            "from {start:?}: {:?}",
            found.value
        );
    }
    // x + y² with x³ ≥ 1 from 0, where gradient and curvature of x³ both vanish
    let cubic = |v: &[f64]| {
        let (x, y) = (v[0], v[1]);
        vec![
            taylor(x + y * y, [1.0, 2.0 * y], [[0.0, 0.0], [0.0, 2.0]]),
            taylor(x.powi(3), [3.0 * x * x, 0.0], [[6.0 * x, 0.0], [0.0, 0.0]]),
        ]
    };
    let found = solve_subject_to(cubic, &[(1.0, f64::INFINITY)], [(-5.0, 5.0); 2], [0.0, 0.0]);
    assert_eq!(found.status, Status::Converged, "{}", found.message);
    assert!((found.x[0] - 1.0).abs() < 1e-8, "{:?}", found.x);
    // the violation has a positive local minimum: (x² − 1)² + x/4 ≤ −0.1 holds near x = −1, and the
    // left side has a second minimum near x = 1, where it is above −0.1
    let valleys = |v: &[f64]| {
        let (x, y) = (v[0], v[1]);
        let (w, slope) = (x * x - 1.0, 4.0 * x * (x * x - 1.0) + 0.25);
        vec![
            taylor(y * y - x, [-1.0, 2.0 * y], [[0.0, 0.0], [0.0, 2.0]]),
            taylor(
                w * w + 0.25 * x,
                [slope, 0.0],
                [[12.0 * x * x - 4.0, 0.0], [0.0, 0.0]],
            ),
        ]
    };
    let found = solve_subject_to(
        valleys,
        &[(f64::NEG_INFINITY, -0.1)],
        [(-3.0, 3.0); 2],
        [1.1, 0.5],
    );
    assert_eq!(
        found.status,
        Status::Converged,
        "{} {:?}",
        found.message,
        found.x
    );
    assert!(
        found.x[0] < 0.0 && (found.constraints[0].value + 0.1).abs() < 1e-9,
        "{:?}",
        found.x
    );
}

#[test]
fn exact_minima_from_starts_with_zero_gradients() {
    let [bowl, hill, x_y] = [
        [[2.0, 0.0], [0.0, 2.0]],
        [[-2.0, 0.0], [0.0, 2.0]],
        [[0.0, 1.0], [1.0, 0.0]],
    ];
    let squares = |v: &[f64]| taylor(v[0] * v[0] + v[1] * v[1], [2.0 * v[0], 2.0 * v[1]], bowl);
    let ends =
        |f: &dyn Fn(&[f64]) -> Vec<Taylor>, limits: &[(f64, f64)], start: [f64; 2], least: f64| {
            let found = solve_subject_to(f, limits, [(-2.0, 2.0); 2], start);
            assert_eq!(
                found.status,
                Status::Converged,
                "from {start:?}: {} {:?}",
                found.message,
                found.x
            );
            assert!(
                (found.value.unwrap() - least).abs() < 1e-9,
                "from {start:?}: {:?} at {:?}",
                found.value,
                found.x
            );
        };
    // y² − x² on the unit circle. All gradients vanish at the first start, (0, 0). The second
    // start, (0, 1), is the maximum on the circle
    let saddle = |v: &[f64]| {
        vec![
            taylor(v[1] * v[1] - v[0] * v[0], [-2.0 * v[0], 2.0 * v[1]], hill),
            squares(v),
        ]
    };
    ends(&saddle, &[(1.0, 1.0)], [0.0, 0.0], -1.0);
    ends(&saddle, &[(1.0, 1.0)], [0.0, 1.0], -1.0);
    // y² − x² in the unit disc: the start (0, 0) is feasible
    ends(&saddle, &[(f64::NEG_INFINITY, 1.0)], [0.0, 0.0], -1.0);
    // x y on the lines x² = y², from their intersection (0, 0): the minimum −4 is in a corner of
    // the box
    let lines = |v: &[f64]| {
        let (x, y) = (v[0], v[1]);
        vec![
            taylor(x * y, [y, x], x_y),
            taylor(y * y - x * x, [-2.0 * x, 2.0 * y], hill),
        ]
    };
    ends(&lines, &[(0.0, 0.0)], [0.0, 0.0], -4.0);
    // y with x − y² = 0 and x + y² = 2, which both hold at (1, ±1). At the start y = 0 the
    // linearized equations are dependent, and contradict each other
    let parabolas = |v: &[f64]| {
        let (x, y) = (v[0], v[1]);
        let bend = |bend: f64| {
            taylor(
                x + bend * y * y,
                [1.0, 2.0 * bend * y],
                [[0.0, 0.0], [0.0, 2.0 * bend]],
            )
        };
        vec![taylor(y, [0.0, 1.0], FLAT), bend(-1.0), bend(1.0)]
    };
    let found = solve_subject_to(
        parabolas,
        &[(0.0, 0.0), (2.0, 2.0)],
        [(-2.0, 2.0); 2],
        [0.3, 0.0],
    );
    assert_eq!(
        found.status,
        Status::Converged,
        "{} {:?}",
        found.message,
        found.x
    );
    assert!(
        (found.x[0] - 1.0).abs() < 1e-9 && (found.x[1].abs() - 1.0).abs() < 1e-9,
        "{:?}",
        found.x
    );
}

#[test]
fn contradicting_constraints_are_infeasible() {
    // x² + y² ≤ −1, from the centre and from another point; then x + y = 0 and x + y = 1
    let never = |v: &[f64]| {
        let (x, y) = (v[0], v[1]);
        vec![
            taylor(x, [1.0, 0.0], FLAT),
            taylor(x * x + y * y, [2.0 * x, 2.0 * y], [[2.0, 0.0], [0.0, 2.0]]),
        ]
    };
    for start in [[0.0, 0.0], [0.7, -0.3]] {
        let found = solve_subject_to(never, &[(f64::NEG_INFINITY, -1.0)], [FREE; 2], start);
        assert_eq!(
            found.status,
            Status::Infeasible,
            "from {start:?}: {}",
            found.message
        );
        assert!(found.x.iter().all(|x| x.abs() < 1e-2), "{:?}", found.x);
    }
    let apart = |v: &[f64]| {
        let sum = || taylor(v[0] + v[1], [1.0, 1.0], FLAT);
        vec![taylor(v[0], [1.0, 0.0], FLAT), sum(), sum()]
    };
    let found = solve_subject_to(
        apart,
        &[(0.0, 0.0), (1.0, 1.0)],
        [(-5.0, 5.0); 2],
        [0.3, 0.0],
    );
    assert_eq!(found.status, Status::Infeasible, "{}", found.message);
}

/// Without an unbounded variable, the bounds alone determine the points at which a restoration
/// begins; the centre of the bounds is one of them. The violation 2 + sin 6x + x/2 has two minima,
/// and the search begins at the higher one.
#[test]
fn exact_points_of_a_restoration_within_bounds_are_evaluated_once() {
    let at_the_centre = RefCell::new(0);
    let waves = |v: &[f64]| {
        if v == [0.0, 0.0] {
            *at_the_centre.borrow_mut() += 1;
        }
        let value = 2.0 + (6.0 * v[0]).sin() + 0.5 * v[0];
        let slope = 6.0 * (6.0 * v[0]).cos() + 0.5;
        let curvature = -36.0 * (6.0 * v[0]).sin();
        vec![
            taylor(v[1], [0.0, 1.0], FLAT),
            taylor(value, [slope, 0.0], [[curvature, 0.0], [0.0, 0.0]]),
        ]
    };
    let limit = [(f64::NEG_INFINITY, 0.0)];
    let found = solve_subject_to(waves, &limit, [(-1.0, 1.0); 2], [0.8, 0.5]);
    // at a minimum of the violation its derivative 6 cos 6x + 1/2 is 0
    let lowest = -f64::acos(-1.0 / 12.0) / 6.0;
    assert_eq!(found.status, Status::Infeasible, "{}", found.message);
    close(found.x[0], lowest, 1.0, 1e-6, "the smallest violation");
    assert_eq!(
        *at_the_centre.borrow(),
        1,
        "{} evaluations",
        found.effort.evaluations
    );
}

/// x + y on the unit square with x ≥ 1 − gap is smallest at the vertex (1 − gap, 0). There the
/// constraint and the lower bound of y have the multiplier 1. The search starts at x = 1.
#[test]
fn exact_vertex_beside_a_bound_without_curvature() {
    for exponent in 1..=12 {
        let gap = 10_f64.powi(-exponent);
        let plane = |x: &[f64]| {
            let flat = vec![vec![0.0; 2]; 2];
            Ok(Evaluation {
                objective: Taylor {
                    value: x[0] + x[1],
                    gradient: vec![1.0, 1.0],
                    hessian: flat.clone(),
                },
                constraints: vec![Taylor {
                    value: -x[0],
                    gradient: vec![-1.0, 0.0],
                    hessian: flat,
                }],
            })
        };
        let limit = -1.0 + gap;
        let domain = Domain::new(vec![0.0; 2], vec![1.0; 2]).unwrap();
        let domain = domain
            .with_constraints(vec![f64::NEG_INFINITY], vec![limit])
            .unwrap();
        for y in [0.9, 0.5, 0.1] {
            let found = minimize(&plane, &domain, &[1.0, y], &Options::default()).unwrap();
            assert_eq!(
                found.status,
                Status::Converged,
                "gap {gap:e} from y = {y}: {}",
                found.message
            );
            assert!(
                (found.x[0] + limit).abs() <= 1e-15 && found.x[1] == 0.0,
                "gap {gap:e}: {:?}",
                found.x
            );
            let multipliers = [found.constraints[0].multiplier, found.lower_multipliers[1]];
            assert!(
                multipliers.iter().all(|price| (price - 1.0).abs() < 1e-9),
                "gap {gap:e}: {multipliers:?}"
            );
        }
    }
}
