//! The flight: closed forms, order of the integration, accuracy at the default step, and drives
//! without a flight.

use crate::common::close;
use longdrive::batch::{Batch, Status};
use longdrive::derivative::{Evaluator, Order, evaluate, gradient};
use longdrive::flight::{Flight, NoFlight, fly, trajectory, trajectory_until};
use longdrive::impact::strike;
use longdrive::integration::StepChoice;
use longdrive::launch::Launch;
use longdrive::number::Vector;
use longdrive::parameters::Law;
use longdrive::{Drive, Error, Outcome, Result, Setup};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

fn carry(setup: &Setup<f64>) -> f64 {
    Outcome::Carry.of(&Drive::new(setup).unwrap()).unwrap()
}

#[test]
fn exact_parabola_in_a_vacuum() {
    let mut setup = Setup::modern_driver();
    (setup.air.density, setup.ground.height) = (0.0, 3.0);
    let launch = Launch {
        velocity: Vector::new(20.0, 3.0, 50.0),
        spin: Vector::new(10.0, 300.0, 0.0),
    };
    let Flight::Landed(landed) = fly(&setup, &launch).unwrap() else {
        panic!("it flies")
    };
    let g = setup.flight.gravity;
    let time = (20.0 + (400.0 - 2.0 * g * 3.0_f64).sqrt()) / g;
    close(landed.flight_time, time, time, 1e-13, "time");
    close(landed.carry, 50.0 * time, 50.0 * time, 1e-13, "carry");
    close(landed.lateral, 3.0 * time, 3.0 * time, 1e-13, "lateral");
    close(
        landed.velocity.x,
        20.0 - g * time,
        20.0,
        1e-12,
        "landing velocity",
    );
    close(
        landed.apex.unwrap().height,
        200.0 / g,
        200.0 / g,
        1e-13,
        "apex",
    );
    close(
        landed.apex.unwrap().time,
        20.0 / g,
        20.0 / g,
        1e-13,
        "apex time",
    );
}

#[test]
fn exact_hop_shorter_than_a_step() {
    let mut setup = Setup::modern_driver();
    setup.air.density = 0.0;
    let rise = 0.01;
    let launch = Launch {
        velocity: Vector::new(rise, 0.0, 10.0),
        spin: Vector::zero(),
    };
    let Flight::Landed(landed) = fly(&setup, &launch).unwrap() else {
        panic!("it flies")
    };
    close(
        landed.flight_time,
        2.0 * rise / setup.flight.gravity,
        1e-2,
        1e-13,
        "time",
    );
    assert_eq!(landed.steps, 1);
}

#[test]
fn exact_terminal_fall_from_a_hill() {
    // a ball dropped without spin: at time t its speed is v_t tanh(g t/v_t), and it has fallen by
    // v_t²/g ln cosh(g t/v_t)
    let mut setup = Setup::modern_driver();
    setup.set_law("linear").unwrap();
    (setup.ground.height, setup.flight.step) = (-100.0, 0.002);
    let launch = Launch {
        velocity: Vector::zero(),
        spin: Vector::zero(),
    };
    let Flight::Landed(landed) = fly(&setup, &launch).unwrap() else {
        panic!("it falls")
    };
    let area = std::f64::consts::PI * setup.ball.radius.powi(2);
    let terminal =
        (2.0 * setup.ball.mass * setup.flight.gravity / (setup.air.density * area * 0.25)).sqrt();
    let time = terminal / setup.flight.gravity
        * (100.0 * setup.flight.gravity / terminal.powi(2))
            .exp()
            .acosh();
    // the error exceeds rounding, because the speed through the air has a lower clamp of 1e-6 m/s
    close(landed.flight_time, time, time, 1e-11, "time");
    close(
        landed.velocity.x,
        -terminal * (setup.flight.gravity * time / terminal).tanh(),
        terminal,
        1e-11,
        "speed",
    );
    assert_eq!(landed.apex.unwrap().height, 0.0);
}

#[test]
fn exact_uniform_wind_is_a_moving_frame() {
    // in the frame that moves with the wind w, the air is still, and the ball is launched at v − w;
    // in time t this frame moves by w t
    let mut setup = Setup::modern_driver();
    let still = Launch {
        velocity: Vector::new(15.0, -6.0, 55.0),
        spin: Vector::new(0.0, 250.0, 0.0),
    };
    let Flight::Landed(a) = fly(&setup, &still).unwrap() else {
        panic!("it flies")
    };
    (setup.wind.right, setup.wind.downrange) = (6.0, -4.0);
    let moving = Launch {
        velocity: Vector::new(15.0, 0.0, 51.0),
        ..still
    };
    let Flight::Landed(b) = fly(&setup, &moving).unwrap() else {
        panic!("it flies")
    };
    close(b.flight_time, a.flight_time, a.flight_time, 1e-12, "time");
    close(
        b.carry,
        a.carry - 4.0 * a.flight_time,
        a.carry,
        1e-12,
        "carry",
    );
    close(
        b.lateral,
        a.lateral + 6.0 * a.flight_time,
        a.carry,
        1e-12,
        "lateral",
    );
}

#[test]
fn order_of_value_and_gradient_in_the_step_is_four() {
    for law in Law::NAMES {
        let mut setup = Setup::modern_driver();
        setup.set_law(law).unwrap();
        setup.set("swing.attack_angle", "4 deg").unwrap();
        setup.aero.spin_damping = Some(2e-5);
        let wrt = [setup.variable("club.loft").unwrap()];
        let at = |step: f64| {
            let mut setup = setup;
            setup.flight.step = step;
            gradient(&setup, Outcome::Carry, &wrt).unwrap()
        };
        let exact = at(0.0025);
        let error = |step| {
            let taylor = at(step);
            [
                (taylor.value - exact.value).abs(),
                (taylor.gradient[0] - exact.gradient[0]).abs(),
            ]
        };
        let (coarse, fine) = (error(0.08), error(0.02));
        // at its grid lines the law bearman-harvey has two continuous derivatives. The gradient of
        // the flight depends on the first derivative of the law, which has one continuous
        // derivative
        let of_gradient = if *law == "bearman-harvey" { 3.0 } else { 4.0 };
        for ((coarse, fine), exact) in coarse.into_iter().zip(fine).zip([4.0, of_gradient]) {
            let order = (coarse / fine).log(4.0);
            assert!(
                (exact - 0.5..exact + 0.8).contains(&order),
                "{law}: order {order} ({coarse:e}, {fine:e})"
            );
        }
    }
}

#[test]
fn same_carry_in_shorter_steps_within_a_micrometre() {
    for preset in ["modern-driver", "winfield-tan", "mae494"] {
        for (attack, wind, roughness) in [
            ("-3 deg", 0.0, None),
            ("5 deg", 8.0, None),
            ("5 deg", -8.0, Some(0.01)),
            ("12 deg", 10.0, Some(0.003)),
        ] {
            let mut setup = Setup::preset(preset).unwrap();
            setup.set("swing.attack_angle", attack).unwrap();
            (setup.wind.downrange, setup.wind.right, setup.wind.roughness) =
                (wind, wind, roughness);
            let coarse = carry(&setup);
            setup.flight.step /= 8.0;
            // a step 8 times shorter has an error 4096 times smaller, so the difference is the
            // error of the default step
            let error = (coarse - carry(&setup)).abs();
            assert!(
                error < 1e-6,
                "{preset}, attack {attack}, wind {wind}, {roughness:?}: {error:e} m"
            );
        }
    }
}

#[test]
fn exact_gradient_of_carry_by_gravity_in_a_vacuum() {
    let mut setup = Setup::modern_driver();
    setup.air.density = 0.0;
    let wrt = [setup.variable("gravity").unwrap()];
    let carry = &evaluate(&setup, &[Outcome::Carry], &wrt, Order::Second).unwrap()[0];
    let g = setup.flight.gravity;
    close(
        carry.gradient[0],
        -carry.value / g,
        carry.value / g,
        1e-13,
        "first derivative",
    );
    close(
        carry.hessian[0][0],
        2.0 * carry.value / (g * g),
        carry.value,
        1e-13,
        "second derivative",
    );
}

#[test]
fn a_ball_that_does_not_rise_has_no_flight_and_no_carry() {
    let launch = |up: f64| Launch {
        velocity: Vector::new(up, 0.0, 60.0),
        spin: Vector::new(0.0, 300.0, 0.0),
    };
    let mut setup = Setup::modern_driver();
    for up in [0.0, -1.0] {
        assert!(matches!(
            fly(&setup, &launch(up)).unwrap(),
            Flight::None(NoFlight::LaunchedDown { .. })
        ));
    }
    setup.ground.height = 5.0;
    setup.air.density = 0.0;
    // a height of 5 m needs a launch speed of √(2 g · 5 m) = 9.9 m/s
    assert!(
        matches!(fly(&setup, &launch(9.9)).unwrap(), Flight::None(NoFlight::BelowGround { apex_height, .. }) if apex_height > 4.9)
    );
    assert!(matches!(
        fly(&setup, &launch(9.91)).unwrap(),
        Flight::Landed(_)
    ));
    setup.ground.height = -5.0;
    assert!(matches!(
        fly(&setup, &launch(-9.0)).unwrap(),
        Flight::Landed(_)
    ));

    let mut setup = Setup::modern_driver();
    setup.set("swing.attack_angle", "-15 deg").unwrap();
    let drive = Drive::new(&setup).unwrap();
    assert!(matches!(
        Outcome::Carry.of(&drive),
        Err(Error::NoFlight { .. })
    ));
    assert_eq!(Outcome::Carry.value(&drive), None);
    assert!(Outcome::BallSpeed.value(&drive).is_some());
    let wrt = [setup.variable("club.loft").unwrap()];
    assert!(matches!(
        gradient(&setup, Outcome::Carry, &wrt),
        Err(Error::NoFlight { .. })
    ));
    assert!(gradient(&setup, Outcome::BallSpeed, &wrt).is_ok());
}

#[test]
fn a_flight_without_end_stops_at_the_time_limit() {
    let mut setup = Setup::modern_driver();
    setup.wind.up = 60.0;
    setup.flight.time_limit = 20.0;
    let drive = Drive::new(&setup).unwrap();
    assert!(matches!(
        drive.flight,
        Flight::None(NoFlight::Aloft { time: 20.0, .. })
    ));
}

/// Time limits just below and just above the flight time. Both end within the last step, whatever
/// its size, in a single flight and in lanes.
#[test]
fn exact_time_limit_between_aloft_and_landed() {
    for (method, step) in [("rk4", "0.01 s"), ("rk4", "0.3 s"), ("dp8", "1.1 s")] {
        let mut setup = Setup::modern_driver();
        setup
            .set_all([("flight.method", method), ("flight.step", step)])
            .unwrap();
        let time = Outcome::FlightTime
            .of(&Drive::new(&setup).unwrap())
            .unwrap();
        let loft = setup.variable("club.loft").unwrap();
        for (limit, lands) in [(time - 1e-6, false), (time + 1e-6, true)] {
            setup.flight.time_limit = limit;
            let flight = Drive::new(&setup).unwrap().flight;
            assert_eq!(
                matches!(flight, Flight::Landed(_)),
                lands,
                "{method} {step}: {flight:?}"
            );
            if !lands {
                assert!(
                    matches!(flight, Flight::None(NoFlight::Aloft { time, height }) if time == limit && (0.0..1e-4).contains(&height)),
                    "{flight:?}"
                );
            }
            let batch = Batch::new(&setup, &[loft], &[Outcome::Carry], &[]).unwrap();
            let block = batch.evaluate(0, vec![setup.club.loft; 3]);
            let status = if lands { Status::Landed } else { Status::Aloft };
            assert!(
                (0..3).all(|row| block.status(row) == status),
                "{method} {step}: {:?}",
                block.status(0)
            );
        }
    }
}

#[test]
fn a_step_too_coarse_for_the_drag_is_an_error_not_a_number() {
    let mut setup = Setup::modern_driver();
    setup.air.density = 1000.0;
    setup.set("flight.step", "1 s").unwrap();
    setup.set("swing.attack_angle", "20 deg").unwrap();
    assert!(matches!(Drive::new(&setup), Err(Error::Diverged { .. })));
}

#[test]
fn a_trajectory_starts_on_the_tee_and_ends_at_the_landing() {
    let setup = Setup::modern_driver();
    let path = trajectory(&setup, &strike(&setup).unwrap().launch).unwrap();
    let (first, last) = (path.points[0], path.points[path.points.len() - 1]);
    assert_eq!((first.time, first.position), (0.0, Vector::zero()));
    assert_eq!(last.position.z, carry(&setup));
    assert!(
        path.points
            .windows(2)
            .all(|pair| pair[0].time < pair[1].time)
    );
}

/// Still air is isotropic, so the carry distance does not depend on the direction of the aim.
/// `carry` is the component of this distance along the target line.
#[test]
fn exact_carry_distance_is_the_same_in_every_direction() {
    let mut setup = Setup::modern_driver();
    setup
        .set_all([("strike.toe", "8 mm"), ("swing.face_angle", "5 deg")])
        .unwrap();
    let outcomes = |aim: f64| {
        let mut turned = setup;
        (turned.swing.path, turned.swing.face_angle) =
            (setup.swing.path + aim, setup.swing.face_angle + aim);
        let drive = Drive::new(&turned).unwrap();
        [Outcome::CarryDistance, Outcome::Carry, Outcome::Lateral].map(|of| of.of(&drive).unwrap())
    };
    let [straight, carry, lateral] = outcomes(0.0);
    assert!(
        straight > carry + 0.1,
        "it curves to the side: {straight} {carry}"
    );
    for aim in [-1.0_f64, 0.3, 1.4] {
        let [distance, downrange, right] = outcomes(aim);
        close(distance, straight, straight, 1e-13, "distance");
        close(
            downrange,
            carry * aim.cos() - lateral * aim.sin(),
            straight,
            1e-13,
            "downrange",
        );
        close(
            right,
            carry * aim.sin() + lateral * aim.cos(),
            straight,
            1e-13,
            "right",
        );
    }
}

/// The trajectory of a ball that bounces returns to the plane of the ground after each bounce, and
/// ends at rest. The trajectory of a ball that embeds ends at the landing.
#[test]
fn same_total_by_the_trajectory_and_by_the_drive() {
    let mut setup = Setup::preset("tour-average").unwrap();
    setup
        .set_all([
            ("swing.face_angle", "2 deg"),
            ("ground.slope", "-2 deg"),
            ("ground.side_slope", "1 deg"),
        ])
        .unwrap();
    let path = trajectory(&setup, &strike(&setup).unwrap().launch).unwrap();
    let drive = Drive::new(&setup).unwrap();
    let value = |of: Outcome| of.value(&drive).unwrap();
    let rest = path.run.last().unwrap();
    close(
        value(Outcome::Carry) + rest.z,
        value(Outcome::Total),
        300.0,
        1e-9,
        "total",
    );
    close(
        value(Outcome::Lateral) + rest.y,
        value(Outcome::LateralTotal),
        300.0,
        1e-9,
        "lateral total",
    );
    // n · position is the height above the plane with n ∝ (1, −tan β_y, −tan β_z)
    let (side, along) = (setup.ground.side_slope.tan(), setup.ground.slope.tan());
    let heights: Vec<f64> = path
        .run
        .iter()
        .map(|way| way.x - side * way.y - along * way.z)
        .collect();
    assert!(heights.iter().all(|height| *height > -1e-9), "{heights:?}");
    let on_the_ground = heights.iter().filter(|height| height.abs() < 1e-9).count();
    assert!(
        on_the_ground >= 5 && heights.iter().any(|height| *height > 0.5),
        "{heights:?}"
    );
    setup.set("ground.turf", "wet").unwrap();
    assert!(
        trajectory(&setup, &strike(&setup).unwrap().launch)
            .unwrap()
            .run
            .is_empty()
    );
}

/// Refused steps: 0, negative, NaN, and so short that a flight would need more than 1e8 steps. No
/// such flight would end in acceptable time.
#[test]
fn steps_with_which_a_flight_would_not_end_are_refused_before_it_begins() {
    let setup = Setup::modern_driver();
    let launch = strike(&setup).unwrap().launch;
    for (step, says) in [
        (0.0, "flight.step = 0 s"),
        (-1.0, "flight.step = -1 s"),
        (1e-300, "1e-300"),
        (1e-9, "1e-9"),
    ] {
        let mut endless = setup;
        endless.flight.step = step;
        let refused = [
            Drive::new(&endless).map(|_| ()),
            fly(&endless, &launch).map(|_| ()),
            trajectory(&endless, &launch).map(|_| ()),
            endless.validate(),
        ];
        for error in refused.map(Result::unwrap_err) {
            assert!(
                matches!(error, Error::OutOfRange { .. }) && error.to_string().contains(says),
                "{step}: {error}"
            );
        }
    }
    let mut setups = [setup; 3];
    setups[0].flight.step = f64::NAN;
    setups[1].flight.time_limit = f64::NAN;
    for setup in &setups[..2] {
        let error = Drive::new(setup).unwrap_err();
        assert!(matches!(error, Error::NotANumber { .. }), "{error}");
    }
    setups[2].flight.time_limit = f64::INFINITY;
    assert!(matches!(
        Drive::new(&setups[2]),
        Err(Error::OutOfRange { .. })
    ));
}

/// The shortest accepted step: 1e8 steps fill the default time limit.
#[test]
fn every_step_size_that_can_be_set_is_flown() {
    let mut setup = Setup::modern_driver();
    let shortest = setup.parameter("flight.step").unwrap().range.low;
    assert_eq!(setup.flight.time_limit / shortest, 1e8);
    for text in ["1e-9 s", "1e-300 s", "5.9e-6 s", "0 s"] {
        assert!(
            matches!(
                setup.set("flight.step", text),
                Err(Error::OutOfRange { .. })
            ),
            "{text}"
        );
    }
    setup.set("flight.step", "6e-6 s").unwrap();
    setup.validate().unwrap();
    // a longer time limit needs more steps
    setup.set("flight.time_limit", "601 s").unwrap();
    let [validated, flown] = [
        setup.validate().unwrap_err(),
        Drive::new(&setup).map(|_| ()).unwrap_err(),
    ];
    assert_eq!(validated.to_string(), flown.to_string());
    assert!(
        validated
            .to_string()
            .contains("s ≤ …: at most 1e8 steps up to flight.time_limit = 601 s"),
        "{validated}"
    );
}

#[test]
fn unusual_values_of_a_diverging_flight_are_named_and_the_step_only_if_long() {
    let usual = || Setup {
        law: Law::named("linear").unwrap(),
        ..Setup::modern_driver()
    };
    let launch = |speed: f64, spin: f64| Launch {
        velocity: Vector::new(0.2 * speed, 0.0, speed),
        spin: Vector::new(0.0, spin, 0.0),
    };
    let fast = launch(1e5, -280.0);
    let message = |change: &dyn Fn(&mut Setup<f64>), launch: &Launch<f64>| {
        let mut setup = usual();
        // a step of 40 ms is not long, so the message does not advise a shorter one
        setup.flight.step = 0.04;
        change(&mut setup);
        match fly(&setup, launch) {
            Err(Error::Diverged { advice, .. }) => advice,
            other => panic!("it can be followed: {other:?}"),
        }
    };
    let ordinary = launch(70.0, -280.0);
    let far_too_large = |setup: &mut Setup<f64>| setup.law = steep();
    for (advice, says, is_long) in [
        (
            message(&far_too_large, &ordinary),
            "check the coefficients of the law linear",
            false,
        ),
        (
            message(&|setup| setup.flight.step = 3.0, &ordinary),
            "reduce flight.step",
            true,
        ),
        (
            message(&|_| (), &fast),
            "the ball leaves at 102000 m/s",
            false,
        ),
        (message(&|_| (), &launch(70.0, -1e6)), "its spin is", false),
        (
            message(&|setup| setup.air.density = 1000.0, &ordinary),
            "per m (0.018 for a golf ball in air)",
            false,
        ),
        (
            message(&|setup| setup.wind.downrange = 1e4, &ordinary),
            "the wind is 10000 m/s",
            false,
        ),
    ] {
        assert!(
            advice.contains(says) && is_long == advice.contains("flight.step"),
            "{says}: {advice}"
        );
    }
}

/// A law with so much lift that the ball turns within hundredths of a second.
fn steep() -> Law<f64> {
    let Law::Linear(linear) = Law::named("linear").unwrap() else {
        unreachable!()
    };
    Law::Linear(longdrive::parameters::Linear {
        cl_slope: 1e5,
        ..linear
    })
}

/// The ball hardly falls, and its flight has 10 million short steps up to the time limit. The
/// interrupt flag ends this flight, and its row of a batch. A drive of a few hundred steps does not
/// begin if the flag is set already.
#[test]
fn a_flag_ends_a_flight_of_millions_of_steps() {
    let mut endless = Setup::modern_driver();
    endless
        .set_all([("gravity", "0.001 m/s^2"), ("flight.step", "6e-5 s")])
        .unwrap();
    let loft = endless.variable("club.loft").unwrap();
    let launch = strike(&endless).unwrap().launch;
    let stop = AtomicBool::new(false);
    let work: [&(dyn Fn() -> Result<()> + Sync); 5] = [
        &|| Drive::until(&endless, &stop).map(drop),
        &|| trajectory_until(&endless, &launch, &stop).map(drop),
        &|| {
            let carry = Evaluator::new(&endless, &[Outcome::Carry], &[loft], Order::First)?;
            carry.at_until(&[0.2], &stop).map(drop)
        },
        &|| {
            let batch = Batch::new(&endless, &[loft], &[Outcome::Carry], &[loft])?;
            let block = batch.evaluate_until(0, vec![0.2], &stop);
            block.map_or(Err(Error::Stopped), |_| Ok(()))
        },
        &|| {
            StepChoice::Own
                .for_setup(&endless)?
                .drive_until(&stop)
                .map(drop)
        },
    ];
    for (n, work) in work.iter().enumerate() {
        stop.store(false, Ordering::Relaxed);
        let ended = std::thread::scope(|scope| {
            let flown = scope.spawn(work);
            std::thread::sleep(Duration::from_millis(5));
            stop.store(true, Ordering::Relaxed);
            flown.join().unwrap()
        });
        assert!(matches!(ended, Err(Error::Stopped)), "{n}: {ended:?}");
    }
    // the flag is still set
    let (setup, of) = (Setup::modern_driver(), [Outcome::Carry]);
    let drive = Drive::until(&setup, &stop);
    assert!(matches!(drive, Err(Error::Stopped)), "{drive:?}");
    let carry = Evaluator::new(&setup, &of, &[loft], Order::First).unwrap();
    let found = carry.at_until(&[0.2], &stop);
    assert!(matches!(found, Err(Error::Stopped)), "{found:?}");
    assert_eq!(Error::Stopped.status(), "interrupted");
}
