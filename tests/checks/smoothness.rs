//! Continuity of value, gradient and Hessian along lines of lofts. The jumps are measured between
//! the two adjacent floating-point lofts at each change of the number of steps.

use crate::common::jump;
use longdrive::derivative::{Order, evaluate, hessian};
use longdrive::flight::Flight;
use longdrive::{Drive, Outcome, Setup};

/// The number of steps of a flight, and the time of the flight, s.
fn flight(setup: &Setup<f64>) -> (usize, f64) {
    match Drive::new(setup).unwrap().flight {
        Flight::Landed(landed) => (landed.steps, landed.flight_time),
        Flight::None(why) => panic!("{why}"),
    }
}

fn steps(setup: &Setup<f64>) -> usize {
    flight(setup).0
}

fn at(setup: &Setup<f64>, loft: f64) -> Setup<f64> {
    let mut moved = *setup;
    moved.club.loft = loft;
    moved
}

/// The two adjacent floating-point lofts between `low` and `high` at which the number of steps
/// changes.
fn change_between(setup: &Setup<f64>, low: f64, high: f64) -> [f64; 2] {
    let flown = |loft: f64| (loft, flight(&at(setup, loft)));
    let mut ends = [low, high].map(flown);
    let few = ends[0].1.0;
    let narrow = |ends: &mut [(f64, (usize, f64)); 2], loft: f64| {
        if ends[0].0 < loft && loft < ends[1].0 {
            let found = flown(loft);
            ends[usize::from(found.1.0 != few)] = found;
        }
    };
    // the number of steps changes at the loft whose flight time is a whole number of steps; the
    // flight time is nearly linear in the loft, so an interpolation moves both ends close to this
    // loft
    for _ in 0..4 {
        let [(low, (_, first)), (high, (_, last))] = ends;
        let whole = setup.flight.step
            * if first < last {
                few as f64
            } else {
                few as f64 - 1.0
            };
        let (crossed, near) = (
            low + (whole - first) / (last - first) * (high - low),
            1e-3 * (high - low),
        );
        narrow(&mut ends, crossed - near);
        narrow(&mut ends, crossed + near);
    }
    while ends[1].0.next_down() > ends[0].0 {
        let middle = (ends[0].0 + ends[1].0) / 2.0;
        narrow(&mut ends, middle);
    }
    ends.map(|(loft, _)| loft)
}

/// The number of changes of the step count along a line of lofts, and the largest relative jumps of
/// value, gradient and Hessian of each outcome at these changes.
fn jumps(setup: &Setup<f64>, of: &[Outcome], degrees: (f64, f64)) -> (usize, Vec<[f64; 3]>) {
    let wrt = ["club.loft", "swing.attack_angle"].map(|name| setup.variable(name).unwrap());
    let (mut changes, mut worst) = (0, vec![[0.0_f64; 3]; of.len()]);
    let loft = |k: usize| (degrees.0 + (degrees.1 - degrees.0) * k as f64 / 200.0).to_radians();
    let lofts: Vec<_> = (0..=200)
        .map(|k| (loft(k), steps(&at(setup, loft(k)))))
        .collect();
    for pair in lofts.windows(2).filter(|pair| pair[0].1 != pair[1].1) {
        changes += 1;
        let sides = change_between(setup, pair[0].0, pair[1].0);
        let [left, right] =
            sides.map(|loft| evaluate(&at(setup, loft), of, &wrt, Order::Second).unwrap());
        for (worst, (a, b)) in worst.iter_mut().zip(left.iter().zip(&right)) {
            for (worst, jump) in worst.iter_mut().zip(jump(a, b)) {
                *worst = worst.max(jump);
            }
        }
    }
    (changes, worst)
}

#[test]
fn exact_continuity_of_every_outcome_across_numbers_of_steps() {
    let questions = [
        ("mae494", "rk4", 0.01),
        ("modern-driver", "rk4", 0.005),
        ("modern-driver", "rk4", 0.05),
        ("modern-driver", "dp8", 0.3),
        ("modern-driver", "dp8", 0.2),
        ("winfield-tan", "rk4", 0.2),
    ];
    for (preset, method, step) in questions {
        let mut setup = Setup::preset(preset).unwrap();
        setup.set("flight.method", method).unwrap();
        setup.flight.step = step;
        setup
            .set_all([("swing.attack_angle", "3 deg"), ("wind.right", "4 m/s")])
            .unwrap();
        let at_landing = [
            Outcome::Carry,
            Outcome::Lateral,
            Outcome::FlightTime,
            Outcome::DescentAngle,
            Outcome::LandingSpeed,
        ];
        let (changes, worst) = jumps(&setup, &at_landing, (8.0, 18.0));
        assert!(changes > if step > 0.05 { 5 } else { 20 }, "{changes}");
        for (of, worst) in at_landing.iter().zip(worst) {
            println!(
                "{preset}, step {step} s, {}: {changes} changes, jumps {worst:?}",
                of.name()
            );
            assert!(
                worst[0] < 1e-13 && worst[1] < 1e-12 && worst[2] < 1e-10,
                "{preset} at {step} s: {worst:?}"
            );
        }
    }
}

#[test]
fn exact_continuity_of_the_apex_across_steps() {
    let mut setup = Setup::preset("mae494").unwrap();
    setup.flight.step = 0.05;
    for of in [
        Outcome::ApexHeight,
        Outcome::ApexTime,
        Outcome::ApexDownrange,
    ] {
        let (changes, worst) = apex_jumps(&setup, of);
        assert!(changes > 5);
        assert!(
            worst[0] < 1e-13 && worst[1] < 1e-12 && worst[2] < 1e-10,
            "{}: {worst:?}",
            of.name()
        );
    }
}

/// The number of lofts at which the apex moves to another step, and the largest relative jumps at
/// these lofts: of the outcome, of its slope and of its second derivative by loft.
fn apex_jumps(setup: &Setup<f64>, of: Outcome) -> (usize, [f64; 3]) {
    let wrt = ["club.loft", "swing.attack_angle"].map(|name| setup.variable(name).unwrap());
    let apex_step = |loft: f64| {
        let time = Outcome::ApexTime
            .of(&Drive::new(&at(setup, loft)).unwrap())
            .unwrap();
        (time / setup.flight.step).floor()
    };
    let (mut changes, mut worst) = (0, [0.0_f64; 3]);
    for k in 0..100 {
        let [mut low, mut high] = [k, k + 1].map(|k| (8.0 + 0.1 * f64::from(k)).to_radians());
        if apex_step(low) == apex_step(high) {
            continue;
        }
        changes += 1;
        let first = apex_step(low);
        while high.next_down() > low {
            let middle = (low + high) / 2.0;
            if apex_step(middle) == first {
                low = middle
            } else {
                high = middle
            }
        }
        let [a, b] = [low, high].map(|loft| hessian(&at(setup, loft), of, &wrt).unwrap());
        worst[0] = worst[0].max(((a.value - b.value) / a.value).abs());
        worst[1] = worst[1].max(((a.gradient[0] - b.gradient[0]) / a.gradient[0]).abs());
        worst[2] = worst[2].max(((a.hessian[0][0] - b.hessian[0][0]) / a.hessian[0][0]).abs());
    }
    (changes, worst)
}
