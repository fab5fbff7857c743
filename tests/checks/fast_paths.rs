//! Fast paths compared with the general one: directions in lanes, drives in lanes, the chain rule
//! between impact and flight, methods of higher order.

use crate::common::{all_blocks, close, landing, mixed};
use longdrive::batch::{Batch, Grid, GridAxis, Points, Sequence, Status};
use longdrive::derivative::{Evaluator, Order, Taylor};
use longdrive::integration::accuracy;
use longdrive::number::{Jet, Number};
use longdrive::parameters::{Law, Method, Parameter, Vary};
use longdrive::{Drive, Outcome, Setup};
use std::cell::Cell;

const TWO: [&str; 2] = ["club.loft", "swing.attack_angle"];

fn variables(setup: &Setup<f64>, names: &[&str]) -> Vec<&'static Parameter> {
    names
        .iter()
        .map(|name| setup.variable(name).unwrap())
        .collect()
}

fn fast(setup: &Setup<f64>, of: Outcome, wrt: &[&'static Parameter], order: Order) -> Taylor {
    let x: Vec<f64> = wrt.iter().map(|row| setup.value(row).unwrap()).collect();
    Evaluator::new(setup, &[of], wrt, order)
        .unwrap()
        .at(&x)
        .unwrap()
        .remove(0)
}

/// An outcome by `Drive::new` over a number type: without lanes and without the chain rule.
fn by_drive<D: Number>(setup: &Setup<f64>, of: Outcome, variable: impl Fn(f64, usize) -> D) -> D {
    let lifted = setup.map(
        |row, value| match TWO.iter().position(|name| *name == row.name) {
            Some(k) => variable(value, k),
            None => D::constant(value),
        },
    );
    of.of(&Drive::new(&lifted).unwrap()).unwrap()
}

/// Setups with every law and method, whose drives stay in a vertical plane or curve to the side.
fn for_planar_and_spatial_setups(check: impl Fn(&Setup<f64>)) {
    let sideways = [
        ("swing.path", "2 deg"),
        ("strike.toe", "8 mm"),
        ("wind.right", "3 m/s"),
    ];
    let windy = [
        ("wind.downrange", "-5 m/s"),
        ("aero.spin_damping", "2e-5"),
        ("wind.roughness", "30 mm"),
    ];
    for law in Law::NAMES {
        for method in Method::ALL {
            for changes in [&[][..], &sideways, &windy] {
                let mut setup = Setup::modern_driver();
                setup.set_law(law).unwrap();
                setup.method = method;
                setup.set_all(changes.iter().copied()).unwrap();
                setup
                    .set_all([("swing.attack_angle", "2 deg"), ("flight.step", "0.1 s")])
                    .unwrap();
                check(&setup);
            }
        }
    }
}

fn agrees(setup: &Setup<f64>) {
    let wrt = variables(setup, &TWO);
    for of in [
        Outcome::Carry,
        Outcome::Lateral,
        Outcome::ApexHeight,
        Outcome::DescentAngle,
        Outcome::Total,
    ] {
        let jet = by_drive(setup, of, Jet::<2>::variable);
        let (value, first, second) = (
            fast(setup, of, &wrt, Order::Value),
            fast(setup, of, &wrt, Order::First),
            fast(setup, of, &wrt, Order::Second),
        );
        let size = jet.re.abs().max(0.1);
        for taylor in [&value, &first, &second] {
            close(taylor.value, jet.re, size, 1e-13, "value");
        }
        let steep = jet.gradient[0].abs().max(jet.gradient[1].abs()).max(1.0);
        for k in 0..2 {
            close(first.gradient[k], jet.gradient[k], steep, 1e-12, "gradient");
            close(
                second.gradient[k],
                jet.gradient[k],
                steep,
                1e-12,
                "gradient of the second order",
            );
        }
        let bent = second
            .hessian
            .iter()
            .flatten()
            .fold(1.0, |most: f64, h| most.max(h.abs()));
        for (i, j) in [(0, 0), (0, 1), (1, 1)] {
            let jet2 = by_drive(setup, of, |value, k| mixed(value, k == i, k == j));
            close(
                second.hessian[i][j],
                jet2.gradient[0].gradient[0],
                bent,
                1e-10,
                "Hessian",
            );
        }
    }
}

#[test]
fn same_derivatives_by_the_fast_paths_and_the_general_one() {
    for_planar_and_spatial_setups(agrees);
}

/// Decay rates from 0 to 50/s, at which the spin vanishes within a tenth of a second.
#[test]
fn same_derivatives_for_any_spin_decay() {
    let mut setup = Setup::modern_driver();
    setup.set_law("robinson").unwrap();
    setup
        .set_all([("swing.attack_angle", "2 deg"), ("flight.step", "0.02 s")])
        .unwrap();
    for decay in [0.0, 1e-3, 0.5, 1.0, 1.3, 1.5, 2.0, 5.0, 50.0] {
        setup.aero.spin_decay = decay;
        agrees(&setup);
    }
    let decay = setup.variable("aero.spin_decay").unwrap();
    let mut points = Grid::new(vec![
        GridAxis::read(&setup, "aero.spin_decay=0/s..3/s:61").unwrap(),
    ])
    .unwrap();
    let alone = Evaluator::new(&setup, &[Outcome::Carry], &[decay], Order::First).unwrap();
    let batch = Batch::new(&setup, points.parameters(), &[Outcome::Carry], &[decay]).unwrap();
    for block in all_blocks(&batch, &mut points) {
        for row in 0..block.rows() {
            let taylor = alone.at(block.point(row)).unwrap().remove(0);
            close(
                block.outcome(row, 0).unwrap(),
                taylor.value,
                taylor.value,
                1e-13,
                "carry",
            );
            close(
                block.derivatives(row).next().unwrap().unwrap(),
                taylor.gradient[0],
                1.0,
                1e-11,
                "derivative",
            );
        }
    }
}

#[test]
fn same_derivatives_by_the_chain_rule_between_impact_and_flight() {
    // derivatives by all parameters are chained through the inputs of the flight; derivatives by
    // two parameters are computed directly
    for setup in landing(25) {
        let all = setup.variables();
        for of in [
            Outcome::Carry,
            Outcome::ApexTime,
            Outcome::SmashFactor,
            Outcome::Total,
            Outcome::LateralTotal,
        ] {
            let chained = fast(&setup, of, &all, Order::First);
            let steep = chained
                .gradient
                .iter()
                .fold(1e-6, |most: f64, d| most.max(d.abs()));
            for (pair, gradient) in all.chunks(2).zip(chained.gradient.chunks(2)) {
                let direct = fast(&setup, of, pair, Order::First);
                close(
                    chained.value,
                    direct.value,
                    direct.value.abs().max(1.0),
                    1e-12,
                    "value",
                );
                for (a, b) in gradient.iter().zip(&direct.gradient) {
                    close(*a, *b, b.abs().max(1e-3 * steep), 1e-11, pair[0].name);
                }
            }
        }
    }
}

#[test]
fn same_derivatives_by_the_chain_rule_between_launch_and_flight() {
    // eight parameters of club and swing are more than a launch has components, so their Hessians
    // are chained through these components; Hessians by two parameters are computed directly
    let groups = ["swing.", "club.", "strike.", "impact."];
    let of_strike =
        |row: &&'static Parameter| groups.iter().any(|group| row.name.starts_with(group));
    for setup in landing(12) {
        let all: Vec<_> = setup.variables().into_iter().filter(of_strike).collect();
        let eight: Vec<_> = all.iter().copied().step_by(all.len() / 8).take(8).collect();
        for of in [
            Outcome::Carry,
            Outcome::ApexTime,
            Outcome::Lateral,
            Outcome::Sidespin,
            Outcome::Total,
        ] {
            let chained = fast(&setup, of, &eight, Order::Second);
            let size = |i: usize| {
                chained.gradient[i]
                    .abs()
                    .max(1e-3 * setup.value(eight[i]).unwrap().abs())
            };
            let curved = |i: usize| chained.hessian[i][i].abs().sqrt().max(1e-3);
            for (i, j) in (0..8).flat_map(|i| (0..i).map(move |j| (i, j))) {
                let direct = fast(&setup, of, &[eight[i], eight[j]], Order::Second);
                let names = format!("{} by {} and {}", of.name(), eight[i].name, eight[j].name);
                close(
                    chained.value,
                    direct.value,
                    direct.value.abs().max(1.0),
                    1e-12,
                    &names,
                );
                let bent = direct.hessian[0][1].abs().max(1e-3 * curved(i) * curved(j));
                close(
                    chained.hessian[i][j],
                    direct.hessian[0][1],
                    bent,
                    1e-8,
                    &names,
                );
                assert_eq!(chained.hessian[i][j], chained.hessian[j][i]);
                for (k, place) in [i, j].into_iter().enumerate() {
                    close(
                        chained.gradient[place],
                        direct.gradient[k],
                        size(place).max(1e-6),
                        1e-10,
                        &names,
                    );
                    let bent = direct.hessian[k][k]
                        .abs()
                        .max(1e-3 * curved(place).powi(2))
                        .max(1e-6);
                    close(
                        chained.hessian[place][place],
                        direct.hessian[k][k],
                        bent,
                        1e-8,
                        &names,
                    );
                }
            }
        }
    }
}

#[test]
fn same_drives_in_lanes_and_alone() {
    let ranges = [
        "club.loft=1deg..25deg",
        "swing.attack_angle=-12deg..10deg",
        "swing.speed=25m/s..60m/s",
    ];
    for_planar_and_spatial_setups(|setup| {
        let vary: Vec<Vary> = ranges
            .iter()
            .map(|text| Vary::read(setup, text).unwrap())
            .collect();
        let wrt: Vec<_> = vary.iter().map(|vary| vary.parameter).collect();
        let of = [
            Outcome::Carry,
            Outcome::Lateral,
            Outcome::ApexHeight,
            Outcome::BallSpeed,
            Outcome::Total,
        ];
        let alone = Evaluator::new(setup, &of, &wrt, Order::First).unwrap();
        let mut points = Sequence::new(vary, 150, 7).unwrap();
        let landed = Cell::new(0);
        let batch = Batch::new(setup, points.parameters(), &of, &wrt).unwrap();
        for block in all_blocks(&batch, &mut points) {
            for row in 0..block.rows() {
                let taylors = alone.at(block.point(row));
                assert_eq!(
                    block.status(row) == Status::Landed,
                    taylors.is_ok(),
                    "{:?}",
                    block.point(row)
                );
                let Ok(taylors) = taylors else { continue };
                landed.set(landed.get() + 1);
                for (i, taylor) in taylors.iter().enumerate() {
                    let size = taylor.value.abs().max(0.1);
                    close(
                        block.outcome(row, i).unwrap(),
                        taylor.value,
                        size,
                        1e-12,
                        of[i].name(),
                    );
                }
                let gradients = taylors.iter().flat_map(|taylor| {
                    let steep = taylor
                        .gradient
                        .iter()
                        .fold(1.0, |most: f64, d| most.max(d.abs()));
                    taylor.gradient.iter().map(move |d| (d, steep))
                });
                for (ours, (theirs, steep)) in block.derivatives(row).zip(gradients) {
                    close(ours.unwrap(), *theirs, steep, 1e-11, "derivative");
                }
            }
        }
        assert!(landed.get() > 75, "{}", landed.get());
    });
}

#[test]
fn statuses_of_a_mixed_grid_agree_with_single_drives() {
    let setup = Setup::preset("mae494").unwrap();
    let axis = |text| GridAxis::read(&setup, text).unwrap();
    let axes = vec![
        axis("club.loft=-20deg..30deg:41"),
        axis("swing.attack_angle=-20deg..20deg:33"),
    ];
    let mut grid = Grid::new(axes).unwrap();
    let wrt = variables(&setup, &TWO);
    let (mut landed, mut down) = (0, 0);
    let batch = Batch::new(&setup, grid.parameters(), &[Outcome::Carry], &wrt).unwrap();
    for block in all_blocks(&batch, &mut grid) {
        for row in 0..block.rows() {
            let mut alone = setup;
            (alone.club.loft, alone.swing.attack_angle) =
                (block.point(row)[0], block.point(row)[1]);
            let flies = Drive::new(&alone).unwrap().landed().is_ok();
            assert_eq!(
                block.status(row),
                if flies {
                    Status::Landed
                } else {
                    Status::NoFlight
                }
            );
            assert_eq!(block.outcome(row, 0).is_some(), flies);
            *(if flies { &mut landed } else { &mut down }) += 1;
        }
    }
    assert!(landed > 300 && down > 300, "{landed} {down}");
}

#[test]
fn order_of_each_method_is_its_own_in_value_and_gradient() {
    let mut setup = Setup::preset("mae494").unwrap();
    setup
        .set_all([("club.loft", "14 deg"), ("wind.right", "3 m/s")])
        .unwrap();
    let wrt = variables(&setup, &TWO);
    let at = |method: Method, step: f64| {
        let mut setup = Setup { method, ..setup };
        setup.flight.step = step;
        fast(&setup, Outcome::FlightTime, &wrt, Order::First)
    };
    let exact = at(Method::DormandPrince8, 0.02);
    for method in Method::ALL {
        // a step so long that the integration error exceeds rounding
        let step = match method {
            Method::Rk4 => 0.1,
            Method::DormandPrince8 => 0.8,
        };
        // the mean over eight slightly different steps, because the error depends on the position
        // of the landing within the last step
        let error = |step: f64| {
            let all: Vec<f64> = (0..8)
                .map(|k| {
                    let taylor = at(method, step * (1.0 + 0.03 * f64::from(k)));
                    let slope =
                        (taylor.gradient[0] - exact.gradient[0]).abs() / exact.gradient[0].abs();
                    (taylor.value - exact.value).abs().max(slope)
                })
                .collect();
            all.iter().sum::<f64>() / all.len() as f64
        };
        let measured = (error(step) / error(step / 2.0)).log2();
        assert!(
            measured > f64::from(method.order()) - 0.7,
            "{} shows order {measured}",
            method.name()
        );
    }
}

#[test]
fn same_drives_between_the_checked_ones_within_the_tolerance() {
    for (preset, tolerance) in [
        ("mae494", 1e-6),
        ("modern-driver", 1e-6),
        ("modern-driver", 1e-3),
    ] {
        let setup = Setup::preset(preset).unwrap();
        let ranges = ["club.loft=5deg..20deg", "swing.attack_angle=-5deg..5deg"];
        let ranges: Vec<Vary> = ranges
            .iter()
            .map(|text| Vary::read(&setup, text).unwrap())
            .collect();
        let found = accuracy(&setup, &ranges, &[Outcome::Carry], tolerance).unwrap();
        assert!(found.error <= tolerance && found.step > 0.01, "{found:?}");
        let mut flown = Setup {
            method: found.method,
            ..setup
        };
        flown.flight.step = found.step;
        let mut fine = Setup {
            method: Method::Rk4,
            ..setup
        };
        fine.flight.step = 0.002;
        for k in 0..40 {
            let loft = (5.0 + 15.0 * f64::from(k) / 39.0).to_radians();
            let carry = |setup: &Setup<f64>| {
                let mut moved = *setup;
                (moved.club.loft, moved.swing.attack_angle) =
                    (loft, (f64::from(k % 7) - 3.0).to_radians());
                Drive::new(&moved).unwrap().landed().unwrap().carry
            };
            close(carry(&flown), carry(&fine), 1.0, tolerance, preset);
        }
    }
    assert!(
        [0.0, f64::NAN]
            .iter()
            .all(|none| accuracy(&Setup::modern_driver(), &[], &[], *none).is_err())
    );
}
