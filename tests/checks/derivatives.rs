//! Derivatives: the number types agree with each other and with differences, and the other
//! requested outcomes have no effect.

use crate::command_line::WHOLE;
use crate::common::{close, landing, mixed, panic_of};
use longdrive::batch::Batch;
use longdrive::derivative::{Evaluator, Order, Taylor, diagonal, evaluate, gradient, hessian};
use longdrive::number::{Jet, Number, Numbers};
use longdrive::parameters::Parameter;
use longdrive::report::{GradientReport, Report};
use longdrive::units::System;
use longdrive::{Drive, Error, Outcome, Setup};
use num_dual::{Dual2_64, Dual3_64, Dual64, HyperDual64};
use std::cell::RefCell;

/// Outcomes of a setup over the number type `D`. The variables are loft and attack angle.
fn outcomes_with_variables<D: Number, const N: usize>(
    setup: &Setup<f64>,
    of: [Outcome; N],
    variable: impl Fn(f64, usize) -> D,
) -> [D; N] {
    let lifted = setup.map(|row, value| match row.name {
        "club.loft" => variable(value, 0),
        "swing.attack_angle" => variable(value, 1),
        _ => D::constant(value),
    });
    let drive = Drive::new(&lifted).unwrap();
    of.map(|of| of.of(&drive).unwrap())
}

/// Values of parameters that make a launch or a wind only together.
#[test]
fn values_that_are_incomplete_or_without_effect_are_refused_as_in_a_batch() {
    let setup = Setup::modern_driver();
    let column = |name: &str| setup.column(name).unwrap();
    for (names, says) in [
        (&["launch.ball_speed"][..], "launch_angle is missing"),
        (&["wind.speed"], "wind.speed is given without wind.from"),
        (
            &["air.pressure", "air.altitude"],
            "air.pressure and air.altitude are both given",
        ),
        (
            &[
                "launch.ball_speed",
                "launch.launch_angle",
                "launch.spin",
                "club.loft",
            ],
            "no club strikes the ball",
        ),
    ] {
        let parameters: Vec<_> = names.iter().map(|name| column(name)).collect();
        let of = [Outcome::Carry];
        let evaluator = Evaluator::new(&setup, &of, &parameters, Order::Value).unwrap_err();
        assert!(evaluator.to_string().contains(says), "{evaluator}");
        let batch = Batch::new(&setup, &parameters, &of, &[]).unwrap_err();
        assert_eq!(evaluator.to_string(), batch.to_string());
    }
}

#[test]
fn same_value_with_a_wind_of_the_setup_and_with_a_wind_given_as_values() {
    let mut windy = Setup::modern_driver();
    let calm = windy;
    windy
        .set_all([("wind.speed", "5 m/s"), ("wind.from", "90 deg")])
        .unwrap();
    let wind = ["wind.speed", "wind.from"].map(|name| calm.column(name).unwrap());
    let lateral = Evaluator::new(&calm, &[Outcome::Lateral], &wind, Order::Value).unwrap();
    let given = lateral.at(&[5.0, 90.0_f64.to_radians()]).unwrap()[0].value;
    let set = Outcome::Lateral.of(&Drive::new(&windy).unwrap()).unwrap();
    close(given, set, 10.0, 1e-13, "lateral");
}

#[test]
fn independent_number_types_of_num_dual_agree_with_ours() {
    for setup in landing(60) {
        let of = [Outcome::Carry, Outcome::Lateral, Outcome::DescentAngle];
        let first = outcomes_with_variables(&setup, of, Jet::<2>::variable);
        let duals = [0, 1].map(|i| {
            outcomes_with_variables(&setup, of, |value, k| Dual64::new(value, f64::from(k == i)))
        });
        let pairs = [(0, 0), (1, 0), (1, 1), (0, 1)];
        let seconds = pairs.map(|(i, j)| {
            outcomes_with_variables(&setup, of, |value, k| mixed(value, k == i, k == j))
        });
        let hypers = pairs.map(|(i, j)| {
            outcomes_with_variables(&setup, of, |value, k| {
                HyperDual64::new(value, f64::from(k == i), f64::from(k == j), 0.0)
            })
        });
        for n in 0..of.len() {
            let (both, hyper, first) = (seconds[3][n], hypers[3][n], first[n]);
            let scale = first
                .gradient
                .iter()
                .fold(1.0, |most: f64, d| most.max(d.abs()));
            for k in 0..2 {
                for other in [
                    duals[k][n].eps,
                    [both.re.gradient[0], both.gradient[0].re][k],
                    [hyper.eps1, hyper.eps2][k],
                ] {
                    close(first.gradient[k], other, scale, 1e-11, "first derivative");
                }
            }
            let scale = hypers
                .iter()
                .fold(1.0, |most: f64, hyper| most.max(hyper[n].eps1eps2.abs()));
            for (second, hyper) in seconds.iter().zip(&hypers) {
                close(
                    second[n].gradient[0].gradient[0],
                    hyper[n].eps1eps2,
                    scale,
                    1e-9,
                    "second derivative",
                );
            }
        }
    }
}

#[test]
fn differences_of_values_agree_with_the_gradient_by_every_parameter() {
    for setup in landing(25) {
        let wrt = setup.variables();
        let of = [Outcome::Carry, Outcome::Lateral, Outcome::ApexHeight];
        let exact = evaluate(&setup, &of, &wrt, Order::First).unwrap();
        for (k, parameter) in wrt.iter().enumerate() {
            let value = setup.value(parameter).unwrap();
            let (h, values) = differences(&setup, parameter, value, &of);
            for (taylor, [below, above]) in exact.iter().zip(values) {
                let difference = (above - below) / (2.0 * h);
                // allowed error: truncation of the difference, and rounding of the values divided
                // by the step
                let allowed = 1e-6 * difference.abs() + 1e-11 * taylor.value.abs().max(1.0) / h;
                assert!(
                    (taylor.gradient[k] - difference).abs() <= allowed,
                    "{}: {} against {difference}",
                    parameter.name,
                    taylor.gradient[k]
                );
            }
        }
    }
}

/// The step h, and each outcome at p − h and p + h.
fn differences(
    setup: &Setup<f64>,
    parameter: &'static Parameter,
    value: f64,
    of: &[Outcome],
) -> (f64, Vec<[f64; 2]>) {
    let h = 1e-5 * value.abs().max(1e-6);
    let at = |value: f64| {
        let mut moved = *setup;
        // the value may be outside of the range of the parameter, because a central difference at
        // the end of the range needs such a value
        moved = moved.map(|row, old| if row == parameter { value } else { old });
        let drive = Drive::new(&moved).unwrap();
        of.iter()
            .map(|outcome| outcome.of(&drive).unwrap())
            .collect::<Vec<_>>()
    };
    let values = at(value - h)
        .into_iter()
        .zip(at(value + h))
        .map(|(below, above)| [below, above])
        .collect();
    (h, values)
}

#[test]
fn differences_of_gradients_agree_with_a_hessian_of_many_parameters() {
    let mut setup = Setup::modern_driver();
    setup
        .set_all([
            ("strike.toe", "9 mm"),
            ("wind.right", "3 m/s"),
            ("swing.attack_angle", "4 deg"),
        ])
        .unwrap();
    let names = [
        "club.loft",
        "swing.speed",
        "strike.toe",
        "air.density",
        "club.inertia.xx",
        "aero.cl_max",
        "wind.right",
    ];
    let wrt = names.map(|name| setup.variable(name).unwrap());
    let exact = hessian(&setup, Outcome::Carry, &wrt).unwrap();
    for (i, parameter) in wrt.iter().enumerate() {
        let value = setup.value(parameter).unwrap();
        let h = 1e-4 * value;
        let at = |value: f64| {
            let mut moved = setup;
            moved.set_value(parameter, Some(value)).unwrap();
            gradient(&moved, Outcome::Carry, &wrt).unwrap().gradient
        };
        let (below, above) = (at(value - h), at(value + h));
        for j in 0..wrt.len() {
            let difference = (above[j] - below[j]) / (2.0 * h);
            let size = exact.gradient[j].abs() / value;
            close(
                exact.hessian[i][j],
                difference,
                difference.abs().max(size),
                1e-6,
                &format!("{} {}", names[i], names[j]),
            );
            assert_eq!(exact.hessian[i][j], exact.hessian[j][i]);
        }
    }
}

/// With massless weights, a central strike and a straight shaft, these ten parameters do not change
/// the flight. Derivatives by so many parameters are chained from derivatives of impact and flight;
/// here no input of the flight varies. On a given launch, the ball's inertia has no effect either.
#[test]
fn exact_value_and_zero_gradient_of_a_flight_without_parameters() {
    let idle = [
        ("club.weight_1.depth", "20 mm"),
        ("club.weight_1.toe", "-10 mm"),
        ("club.weight_1.high", "5 mm"),
        ("club.weight_2.depth", "30 mm"),
        ("club.weight_2.toe", "10 mm"),
        ("club.weight_2.high", "-5 mm"),
        ("club.bulge_radius", "0.3 m"),
        ("club.roll_radius", "0.28 m"),
        ("club.face_semi_axis", "0.3 m"),
        ("swing.shaft_growth", "2"),
    ];
    let mut struck = Setup::preset("mae494").unwrap();
    struck
        .set_all([
            ("club.weight_1.mass", "0 g"),
            ("club.weight_2.mass", "0 g"),
            ("swing.shaft_bend", "0 deg"),
        ])
        .unwrap();
    struck.set_all(idle).unwrap();
    let mut launched = Setup::modern_driver();
    launched
        .set_all([
            ("launch.ball_speed", "70 m/s"),
            ("launch.launch_angle", "0.2 rad"),
        ])
        .unwrap();
    launched
        .set_all([
            ("launch.backspin", "280 rad/s"),
            ("ball.inertia", "83 g cm^2"),
        ])
        .unwrap();
    for (setup, names) in [
        (struck, idle.map(|(name, _)| name).to_vec()),
        (launched, vec!["ball.inertia"]),
    ] {
        let wrt: Vec<_> = names
            .iter()
            .map(|name| setup.variable(name).unwrap())
            .collect();
        let carry = evaluate(&setup, &[Outcome::Carry], &[], Order::Value).unwrap()[0].value;
        for order in [Order::First, Order::Second] {
            let found = evaluate(&setup, &[Outcome::Carry], &wrt, order)
                .unwrap()
                .remove(0);
            assert!(
                (found.value - carry).abs() < 1e-15 * carry && carry > 100.0,
                "{} {carry}",
                found.value
            );
            assert!(
                found
                    .gradient
                    .iter()
                    .chain(found.hessian.iter().flatten())
                    .all(|d| *d == 0.0),
                "{found:?}"
            );
        }
    }
}

/// A Hessian by many parameters is computed by the chain rule from Hessians of impact and flight. A
/// Hessian by a few parameters is computed directly.
#[test]
fn same_hessian_by_all_parameters_and_by_a_few() {
    let mut setup = Setup::modern_driver();
    setup
        .set_all([
            ("strike.toe", "9 mm"),
            ("wind.right", "3 m/s"),
            ("swing.attack_angle", "4 deg"),
        ])
        .unwrap();
    let all = setup.variables();
    let names = [
        "club.loft",
        "swing.path",
        "strike.toe",
        "air.density",
        "aero.cl_max",
        "wind.right",
        "ball.radius",
    ];
    let few = names.map(|name| setup.variable(name).unwrap());
    assert!(all.len() > 30, "{}", all.len());
    for of in [
        Outcome::Carry,
        Outcome::Lateral,
        Outcome::DescentAngle,
        Outcome::Spin,
    ] {
        let (many, few_of) = (
            hessian(&setup, of, &all).unwrap(),
            hessian(&setup, of, &few).unwrap(),
        );
        close(many.value, few_of.value, many.value.abs(), 1e-13, "value");
        let place = few.map(|parameter| all.iter().position(|row| *row == parameter).unwrap());
        let most = few_of
            .hessian
            .iter()
            .flatten()
            .fold(1.0, |most: f64, h| most.max(h.abs()));
        for (i, row) in few_of.hessian.iter().enumerate() {
            close(
                many.gradient[place[i]],
                few_of.gradient[i],
                few_of.gradient[i].abs().max(1e-9),
                1e-10,
                names[i],
            );
            for (j, theirs) in row.iter().enumerate() {
                close(
                    many.hessian[place[i]][place[j]],
                    *theirs,
                    most,
                    1e-11,
                    &format!("{} {}", names[i], names[j]),
                );
            }
        }
    }
}

/// For 3 parameters, Hessian and diagonal come from the same passes and are equal to the bit. For
/// all parameters, the Hessian comes from the chain rule.
#[test]
fn same_diagonal_as_that_of_the_hessian() {
    let setup = Setup::modern_driver();
    let of = [Outcome::Carry, Outcome::Total, Outcome::LaunchAngle];
    let all = setup.variables();
    for (wrt, tolerance) in [(&all[..3], 0.0), (&all[..], 1e-10)] {
        let whole = evaluate(&setup, &of, wrt, Order::Second).unwrap();
        let diagonals = diagonal(&setup, &of, wrt).unwrap();
        for (of, (whole, diagonal)) in of.iter().zip(whole.iter().zip(&diagonals)) {
            assert_eq!(whole.value, diagonal.value, "{}", of.name());
            for (i, parameter) in wrt.iter().enumerate() {
                let (ours, theirs) = (diagonal.gradient[i], whole.gradient[i]);
                close(ours, theirs, theirs.abs(), tolerance, parameter.name);
                let (ours, theirs) = (diagonal.hessian[i][i], whole.hessian[i][i]);
                let size = whole.hessian[i]
                    .iter()
                    .map(|d| d.abs())
                    .fold(theirs.abs(), f64::max);
                close(ours, theirs, size, tolerance, parameter.name);
                assert!((0..i).all(|k| diagonal.hessian[i][k] == 0.0));
            }
        }
    }
}

/// The ground changes only the run. Carry has the same derivatives whether the run is computed or
/// not, and its derivatives by the ground are 0.
#[test]
fn exact_carry_does_not_depend_on_the_ground() {
    let setup = Setup::modern_driver();
    let all = setup.variables();
    for order in [Order::First, Order::Second] {
        let of_carry = evaluate(&setup, &[Outcome::Carry], &all, order)
            .unwrap()
            .remove(0);
        let [carry, total] = evaluate(&setup, &[Outcome::Carry, Outcome::Total], &all, order)
            .unwrap()
            .try_into()
            .unwrap();
        for (i, parameter) in all.iter().enumerate() {
            let (alone, both) = (of_carry.gradient[i], carry.gradient[i]);
            close(alone, both, both.abs().max(1e-9), 1e-12, parameter.name);
            if parameter.affects_only_run() {
                assert_eq!((alone, both), (0.0, 0.0), "{}", parameter.name);
                assert!(
                    of_carry
                        .hessian
                        .iter()
                        .flatten()
                        .skip(i)
                        .step_by(all.len())
                        .all(|d| *d == 0.0)
                );
            }
        }
        let of_the_run = (0..all.len()).filter(|i| all[*i].affects_only_run());
        let moves: Vec<_> = of_the_run
            .filter(|i| total.gradient[*i] != 0.0)
            .map(|i| all[i].name)
            .collect();
        assert!(moves.len() >= 3, "{moves:?}");
    }
}

#[test]
fn derivatives_do_not_depend_on_other_requested_outcomes() {
    let mut setup = Setup::preset("mae494").unwrap();
    setup.set("strike.toe", "5 mm").unwrap();
    let all = setup.variables();
    assert!(all.len() > 30);
    let together = gradient(&setup, Outcome::Carry, &all).unwrap();
    for (k, parameter) in all.iter().enumerate() {
        let alone = gradient(&setup, Outcome::Carry, &[parameter]).unwrap();
        close(
            alone.gradient[0],
            together.gradient[k],
            together.gradient[k].abs().max(1e-9),
            1e-11,
            parameter.name,
        );
    }
    let three = ["club.loft", "swing.attack_angle", "swing.speed"]
        .map(|name| setup.variable(name).unwrap());
    let block = hessian(&setup, Outcome::Carry, &three).unwrap();
    let pair = hessian(&setup, Outcome::Carry, &three[..2]).unwrap();
    let one = hessian(&setup, Outcome::Carry, &three[..1]).unwrap();
    close(
        block.hessian[0][1],
        pair.hessian[0][1],
        pair.hessian[0][1].abs(),
        1e-12,
        "mixed",
    );
    close(
        one.hessian[0][0],
        pair.hessian[0][0],
        pair.hessian[0][0].abs(),
        1e-10,
        "pure",
    );
    assert_eq!((one.gradient.len(), block.hessian.len()), (1, 3));

    let seen = RefCell::new(vec![]);
    Evaluator::new(&setup, &[Outcome::Carry], &three, Order::Second)
        .unwrap()
        .at_setup(None, &|done, passes| seen.borrow_mut().push((done, passes)))
        .unwrap();
    let seen = seen.into_inner();
    // the three pairs of parameters need one to three passes, fewer on a processor with wider
    // registers
    let passes = seen.len();
    assert!((1..=3).contains(&passes));
    assert!(
        seen.iter()
            .enumerate()
            .all(|(done, progress)| *progress == (done + 1, passes)),
        "{seen:?}"
    );
}

#[test]
fn values_alone_carry_no_derivatives() {
    let setup = Setup::modern_driver();
    let taylors = evaluate(&setup, &[Outcome::Carry, Outcome::Spin], &[], Order::Value).unwrap();
    assert!(taylors.iter().all(
        |Taylor {
             gradient, hessian, ..
         }| gradient.is_empty() && hessian.is_empty()
    ));
}

#[test]
fn an_undefined_derivative_is_an_error_and_not_nan() {
    // straight up: the launch has no horizontal direction
    let mut setup = Setup::preset("mae494").unwrap();
    setup
        .set_all([
            ("club.loft", "0 deg"),
            ("swing.attack_angle", "0 deg"),
            ("swing.shaft_lean", "0 deg"),
        ])
        .unwrap();
    setup.swing.attack_angle = 89.9999999_f64.to_radians();
    let drive = Drive::new(&setup).unwrap();
    for outcome in Outcome::OF_DRIVES {
        assert!(
            outcome.value(&drive).is_none_or(f64::is_finite),
            "{}",
            outcome.name()
        );
    }
    // no spin: its axis has no direction
    let mut setup = Setup::preset("mae494").unwrap();
    setup
        .set_all([("club.loft", "0 deg"), ("swing.attack_angle", "0.2 rad")])
        .unwrap();
    setup.impact.friction = Some(0.0);
    setup.set("club.loft", "5 deg").unwrap();
    let drive = Drive::new(&setup).unwrap();
    assert_eq!(Outcome::SpinAxis.value(&drive), None);
    let wrt = [setup.variable("club.loft").unwrap()];
    assert!(matches!(
        gradient(&setup, Outcome::SpinAxis, &wrt),
        Err(Error::Undefined { .. })
    ));
    assert!(gradient(&setup, Outcome::Carry, &wrt).is_ok());
    assert!(matches!(
        gradient(&setup, Outcome::Carry, &[]),
        Err(Error::Nothing { .. })
    ));
}

#[test]
fn zero_spin_is_a_corner_of_laws_with_drag_that_grows_with_spin() {
    let mut setup = Setup::preset("mae494").unwrap();
    setup
        .set_all([("club.loft", "0 deg"), ("swing.attack_angle", "20 deg")])
        .unwrap();
    let drive = Drive::new(&setup).unwrap();
    assert_eq!(drive.corners(&setup).len(), 1);
    setup.set_law("linear").unwrap();
    assert!(drive.corners(&setup).is_empty());
}

/// A report of fewer derivatives than parameters would omit parameters without a message.
#[test]
fn reports_of_fewer_or_more_derivatives_than_parameters_panic_with_both_numbers() {
    let setup = Setup::modern_driver();
    let wrt = ["club.loft", "swing.speed"].map(|name| setup.variable(name).unwrap());
    let carry = hessian(&setup, Outcome::Carry, &wrt).unwrap();
    let text = |wrt: &[&'static Parameter], taylor: &Taylor| {
        let found = [(Outcome::Carry, Ok(taylor.clone()))];
        GradientReport::new(&found, wrt)
            .document(System::Us)
            .text(&WHOLE)
    };
    let output = panic_of(|| text(&wrt[..1], &carry));
    assert!(
        output.contains("1 parameters, and 2 derivatives"),
        "{output}"
    );
    let short = Taylor {
        gradient: carry.gradient[..1].to_vec(),
        ..carry.clone()
    };
    let output = panic_of(|| text(&wrt, &short));
    assert!(
        output.contains("2 parameters, and 1 derivatives"),
        "{output}"
    );
    let narrow = Taylor {
        hessian: vec![vec![0.0; 1]; 2],
        ..carry.clone()
    };
    let output = panic_of(|| text(&wrt, &narrow));
    assert!(
        output.contains("second derivatives in rows of [1, 1]"),
        "{output}"
    );
    assert!(text(&wrt, &carry).contains("swing.speed"));
}

#[test]
fn exact_atan2_has_derivatives_in_every_direction() {
    // d/dt atan2(sin t, cos t) = 1, and its second derivative is 0
    for k in 0..16 {
        let t = Dual2_64::from(f64::from(k) * std::f64::consts::FRAC_PI_8 - 3.0).derivative();
        let (y, x) = Numbers::sin_cos(t);
        let angle = Number::atan2(y, x);
        assert!((angle.v1 - 1.0).abs() < 1e-14, "{angle:?}");
        assert!(angle.v2.abs() < 1e-14, "{angle:?}");
    }
    let vertical = Number::atan2(Dual64::from(1.0), Dual64::from(0.0).derivative());
    assert_eq!(vertical.eps, -1.0);
}

#[test]
fn exact_tanh_is_finite_for_large_arguments_and_precise_near_zero() {
    assert_eq!(Numbers::tanh(Dual64::from(800.0).derivative()).re, 1.0);
    assert_eq!(Numbers::tanh(Dual64::from(-800.0).derivative()).eps, 0.0);
    let small = Numbers::tanh(Dual64::from(1e-9).derivative());
    assert!((small.re / 1e-9 - 1.0).abs() < 1e-15 && (small.eps - 1.0).abs() < 1e-15);
}

/// An unset parameter has no value and no derivative. A request with it does not change the drive.
#[test]
fn exact_zero_derivative_by_an_unset_parameter() {
    let setup = Setup::modern_driver();
    let unset = setup.column("aero.spin_damping").unwrap();
    let value = evaluate(&setup, &[Outcome::Carry], &[unset], Order::Value).unwrap()[0].value;
    let carry = Outcome::Carry.of(&Drive::new(&setup).unwrap()).unwrap();
    assert!((value - carry).abs() < 1e-12 * carry, "{value} {carry}");
}

/// Stack that derivatives need. A thread has 2 MiB; a build without optimization needs more
/// (docs/library.md). At optimization level 1, these derivatives take 135 KiB.
#[test]
fn derivatives_need_little_stack() {
    let work = || {
        let setup = Setup::modern_driver();
        let (two, all) = (
            ["club.loft", "swing.attack_angle"].map(|name| setup.variable(name).unwrap()),
            setup.variables(),
        );
        for (wrt, order) in [(&two[..], Order::Second), (&all, Order::First)] {
            let x: Vec<f64> = wrt.iter().map(|row| setup.value(row).unwrap()).collect();
            let found = Evaluator::new(&setup, &[Outcome::Total], wrt, order)
                .unwrap()
                .at(&x)
                .unwrap();
            assert!(found[0].value > 200.0);
        }
        let batch = Batch::new(&setup, &two, &[Outcome::Total], &two).unwrap();
        assert!(
            batch
                .evaluate(0, vec![0.17, 0.0, 0.2, 0.0])
                .outcome(1, 0)
                .is_some()
        );
    };
    std::thread::Builder::new()
        .stack_size(512 << 10)
        .spawn(work)
        .unwrap()
        .join()
        .unwrap();
}

/// xᵃ with its first two derivatives, over every number type. An integer exponent is allowed for
/// any base; other exponents are tested with the bases 4 and 0.
#[test]
fn exact_powers_of_negative_numbers_and_of_zero() {
    const NONE: f64 = f64::INFINITY;
    for (x, a, [value, first, second]) in [
        (-2.0, 3.0, [-8.0, 12.0, -12.0]),
        (-2.0, 2.0, [4.0, -4.0, 2.0]),
        (-2.0, 1.0, [-2.0, 1.0, 0.0]),
        (-2.0, 0.0, [1.0, 0.0, 0.0]),
        (-2.0, -1.0, [-0.5, -0.25, -0.25]),
        (-2.0, -2.0, [0.25, 0.25, 0.375]),
        (0.0, 0.0, [1.0, 0.0, 0.0]),
        (0.0, 1.0, [0.0, 1.0, 0.0]),
        (0.0, 2.0, [0.0, 0.0, 2.0]),
        (0.0, 3.0, [0.0, 0.0, 0.0]),
        (0.0, 2.5, [0.0, 0.0, 0.0]),
        (0.0, 1.5, [0.0, 0.0, NONE]),
        (-0.0, 3.7, [0.0, 0.0, 0.0]),
        (4.0, 2.5, [32.0, 20.0, 7.5]),
        (4.0, -0.5, [0.5, -0.0625, 0.0234375]),
    ] {
        let about = |found: f64, exact: f64| {
            assert!(
                found == exact || (found - exact).abs() < 4e-15 * exact.abs(),
                "{x}^{a}: {found} for {exact}"
            );
        };
        about(Numbers::powf(x, a), value);
        let jet = Numbers::powf(Jet::<3>::variable(x, 1), a);
        let dual = Numbers::powf(Dual64::from(x).derivative(), a);
        for (found, exact) in [
            (jet.re, value),
            (jet.gradient[1], first),
            (dual.re, value),
            (dual.eps, first),
        ] {
            about(found, exact);
        }
        assert_eq!((jet.gradient[0], jet.gradient[2]), (0.0, 0.0));
        let mixed = Numbers::powf(mixed(x, true, true), a);
        let dual = Numbers::powf(Dual2_64::from(x).derivative(), a);
        let hyper = Numbers::powf(HyperDual64::new(x, 1.0, 1.0, 0.0), a);
        for (found, exact) in [
            (mixed.re.re, value),
            (mixed.re.gradient[0], first),
            (mixed.gradient[0].re, first),
        ] {
            about(found, exact);
        }
        for found in [mixed.gradient[0].gradient[0], dual.v2, hyper.eps1eps2] {
            about(found, second);
        }
        about(dual.v1, first);
    }
    let third = |a: f64| Numbers::powf(Dual3_64::from(0.0).derivative(), a).v3;
    assert_eq!([3.0, 3.5, 2.5].map(third), [6.0, 0.0, NONE]);
    assert_eq!(
        Numbers::powf(Jet::<1>::variable(0.0, 0), 0.5).gradient,
        [NONE]
    );
    assert!(Numbers::powf(-2.0, 0.5).is_nan() && Numbers::powf(0.0, -0.5) == NONE);
}
