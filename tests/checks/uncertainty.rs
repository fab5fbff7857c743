//! The uncertainty of outcomes: shares of the variance of known functions, moments of known
//! distributions, ellipses and gusts, and messages.

use crate::command_line::{WHOLE, json, longdrive, on_one_line};
use crate::common::{LARGE_STEPS, close, panic_of};
use longdrive::batch::Status;
use longdrive::derivative::Taylor;
use longdrive::report::{Reply, Report, UncertaintyReport};
use longdrive::study::swings::{Rule, Scenarios, Swings};
use longdrive::study::uncertainty::Distribution::{Normal, Triangular, Uniform};
use longdrive::study::uncertainty::{
    Distribution, LandingEllipse, SaltelliDesign, SamplePlan, Statistics, Uncertain, delta_method,
    uncertainty,
};
use longdrive::study::{DriveRole, Landing, Sigma, effects, with_defaults};
use longdrive::{Drive, Error, Outcome, Setup, derivative};
use std::f64::consts::PI;

fn statistics(
    inputs: &[Distribution],
    plan: SamplePlan,
    f: impl Fn(&[f64]) -> Option<f64>,
) -> Statistics {
    let design = SaltelliDesign::new(inputs, plan).unwrap();
    let values = design
        .points
        .iter()
        .map(|points| points.iter().map(|point| f(point)).collect())
        .collect::<Vec<_>>();
    design.statistics(&values).unwrap()
}

/// sin x₁ + 7 sin² x₂ + 0.1 x₃⁴ sin x₁ on (−π, π)³ (Ishigami & Homma 1990).
fn ishigami(x: &[f64]) -> Option<f64> {
    Some(x[0].sin() + 7.0 * x[1].sin().powi(2) + 0.1 * x[2].powi(4) * x[0].sin())
}

/// Variance of Ishigami's function, and the first-order and total shares of its parameters, by
/// hand.
fn ishigami_shares() -> (f64, [f64; 3], [f64; 3]) {
    let (a, b) = (7.0_f64, 0.1_f64);
    let alone = [0.5 * (1.0 + b * PI.powi(4) / 5.0).powi(2), a * a / 8.0, 0.0];
    let together = 8.0 * b * b * PI.powi(8) / 225.0; // of x₁ and x₃
    let variance = alone.iter().sum::<f64>() + together;
    let total = [alone[0] + together, alone[1], together];
    (
        variance,
        alone.map(|share| share / variance),
        total.map(|share| share / variance),
    )
}

const CIRCLE: Distribution = Distribution::Uniform { low: -PI, high: PI };

#[test]
fn sampled_shares_of_ishigamis_function_lie_within_their_intervals() {
    let (variance, first, total) = ishigami_shares();
    close(variance, 13.8446, 1.0, 1e-4, "variance");
    let found = statistics(
        &[CIRCLE; 3],
        SamplePlan {
            samples: 16_384,
            seed: 1,
        },
        ishigami,
    );
    assert!(
        found.mean.interval().unwrap().contains(3.5)
            && found
                .standard_uncertainty
                .interval()
                .unwrap()
                .contains(variance.sqrt()),
        "{found:?}"
    );
    for (i, indices) in found.indices.iter().enumerate() {
        let indices = indices.unwrap();
        assert!(
            indices.first.contains(first[i]) && indices.total.contains(total[i]),
            "{i}: {indices:?}"
        );
        assert!(
            indices.first.high - indices.first.low < 0.06,
            "{i}: {indices:?}"
        );
        close(indices.total.value, total[i], 1.0, 0.02, "total");
    }
}

#[test]
fn sampled_shares_of_the_g_function_lie_within_their_intervals() {
    // Π (|4 xᵢ − 2| + aᵢ)/(1 + aᵢ) on the unit cube; the variance of a factor is 1/(3 (1 + aᵢ)²)
    // (Saltelli & Sobol' 1995)
    let a = [0.0, 1.0, 4.5, 9.0];
    let alone = a.map(|a: f64| 1.0 / (3.0 * (1.0 + a).powi(2)));
    let variance = alone.iter().map(|v| 1.0 + v).product::<f64>() - 1.0;
    let g = |x: &[f64]| {
        Some(
            x.iter()
                .zip(a)
                .map(|(x, a)| ((4.0 * x - 2.0).abs() + a) / (1.0 + a))
                .product(),
        )
    };
    let unit = Distribution::Uniform {
        low: 0.0,
        high: 1.0,
    };
    let found = statistics(
        &[unit; 4],
        SamplePlan {
            samples: 16_384,
            seed: 3,
        },
        g,
    );
    let mut held = vec![
        found.mean.interval().unwrap().contains(1.0),
        found
            .standard_uncertainty
            .interval()
            .unwrap()
            .contains(variance.sqrt()),
    ];
    for (i, indices) in found.indices.iter().enumerate() {
        let indices = indices.unwrap();
        let others: f64 = alone
            .iter()
            .enumerate()
            .filter(|(j, _)| *j != i)
            .map(|(_, v)| 1.0 + v)
            .product();
        let (first, total) = (alone[i] / variance, alone[i] * others / variance);
        held.extend([indices.first.contains(first), indices.total.contains(total)]);
        close(indices.first.value, first, 1.0, 0.03, "first");
        close(indices.total.value, total, 1.0, 0.03, "total");
    }
    // a 95 % interval may miss the exact share: one of the ten may do so
    assert!(
        held.iter().filter(|is_within| !**is_within).count() <= 1,
        "{held:?} {found:?}"
    );
}

#[test]
fn sampled_coverage_of_95_percent_intervals_of_shares() {
    let (variance, first, total) = ishigami_shares();
    let (mut within, mut all) = (0, 0);
    for seed in 0..60 {
        let found = statistics(
            &[CIRCLE; 3],
            SamplePlan {
                samples: 1024,
                seed,
            },
            ishigami,
        );
        let shares = found
            .indices
            .iter()
            .map(|indices| indices.unwrap())
            .enumerate();
        let held = shares.flat_map(|(i, indices)| {
            [
                indices.first.contains(first[i]),
                indices.total.contains(total[i]),
            ]
        });
        let held = held.chain([
            found.mean.interval().unwrap().contains(3.5),
            found
                .standard_uncertainty
                .interval()
                .unwrap()
                .contains(variance.sqrt()),
        ]);
        held.for_each(|is_within| {
            within += usize::from(is_within);
            all += 1;
        });
    }
    // 480 intervals, some of them dependent. Three standard deviations of 480 independent ones are
    // 3 %
    let share = f64::from(u32::try_from(within).unwrap()) / f64::from(u32::try_from(all).unwrap());
    assert!((0.92..=0.98).contains(&share), "{within} of {all}");
}

/// The upper bound C E(∂f/∂xᵢ)²/V of a total share, by hand; V is the variance of f. For Ishigami's
/// function the Poincaré constant C is (b − a)²/π² = 4, with the range b − a of xᵢ. For a linear
/// function of a normal variable, C is the variance of the variable, and the bound is 1.
#[test]
fn sampled_coverage_of_95_percent_intervals_of_upper_bounds() {
    let (variance, _, total) = ishigami_shares();
    let slopes = |x: &[f64]| {
        let by_third = 0.4 * x[2].powi(3) * x[0].sin();
        [
            x[0].cos() * (1.0 + 0.1 * x[2].powi(4)),
            7.0 * (2.0 * x[1]).sin(),
            by_third,
        ]
    };
    let mean_squares = [
        0.5 * (1.0 + 0.2 * PI.powi(4) / 5.0 + 0.01 * PI.powi(8) / 9.0),
        24.5,
        0.5 * 0.16 * PI.powi(6) / 7.0,
    ];
    let bounds = mean_squares.map(|mean| 4.0 * mean / variance);
    assert!(
        bounds
            .iter()
            .zip(total)
            .all(|(bound, total)| *bound > total),
        "{bounds:?} {total:?}"
    );
    assert!((CIRCLE.poincare() - 4.0).abs() < 1e-14);
    let line = Distribution::Normal {
        mean: 1.0,
        deviation: 2.0,
    };
    let (mut within, mut all) = (0, 0);
    for seed in 0..60 {
        let design = SaltelliDesign::new(
            &[CIRCLE; 3],
            SamplePlan {
                samples: 1024,
                seed,
            },
        )
        .unwrap();
        let values = |point: &Vec<f64>| ishigami(point);
        let values: Vec<Vec<_>> = design
            .points
            .iter()
            .map(|points| points.iter().map(values).collect())
            .collect();
        let squares = |k: usize| {
            design.points[0]
                .iter()
                .map(|point| Some(slopes(point)[k].powi(2)))
                .collect()
        };
        let found = design.means_by_variance(&values, &[0, 1, 2].map(squares));
        let mut held: Vec<bool> = found
            .iter()
            .zip(bounds)
            .map(|(found, bound)| found.unwrap().contains(bound / 4.0))
            .collect();
        let design = SaltelliDesign::new(
            &[line],
            SamplePlan {
                samples: 1024,
                seed,
            },
        )
        .unwrap();
        let values: Vec<Vec<_>> = design
            .points
            .iter()
            .map(|points| points.iter().map(|x| Some(3.0 * x[0])).collect())
            .collect();
        let found = design.means_by_variance(&values, &[vec![Some(9.0); 1024]])[0].unwrap();
        held.push(found.contains(1.0 / line.poincare()));
        within += held.iter().filter(|is_within| **is_within).count();
        all += held.len();
    }
    // 240 intervals: three standard deviations of the share that contains the exact value are 4 %
    let share = within as f64 / all as f64;
    assert!((0.91..=0.99).contains(&share), "{within} of {all}");
}

/// A single uncertain parameter causes the whole variance of any function in any sample: its share
/// is 1, without a sampling error.
#[test]
fn exact_share_of_a_single_uncertain_parameter_is_one() {
    for seed in 0..5 {
        let found = statistics(&[CIRCLE], SamplePlan { samples: 200, seed }, |x| {
            Some(x[0].sin() + x[0].powi(3))
        });
        let indices = found.indices[0].unwrap();
        for share in [indices.first, indices.total] {
            assert_eq!((share.value, share.low, share.high), (1.0, 1.0, 1.0));
        }
    }
    let mut setup = Setup::modern_driver();
    setup.set_all(crate::common::LARGE_STEPS).unwrap();
    let inputs = [Uncertain::read(&setup, "club.loft=uniform(1deg,17deg)").unwrap()];
    let found = uncertainty(
        &setup,
        &[Outcome::Carry],
        &inputs,
        SamplePlan {
            samples: 300,
            seed: 1,
        },
        &|_, _| (),
    )
    .unwrap();
    let first = found.outcomes[0].measure_first.unwrap();
    assert_eq!(
        (first.parameter.name, first.standard_uncertainty),
        ("club.loft", 0.0)
    );
}

#[test]
fn sampled_moments_are_those_of_the_distributions() {
    let triangle = Distribution::Triangular {
        low: 1.0,
        mode: 2.0,
        high: 5.0,
    };
    let normal = Distribution::Normal {
        mean: -3.0,
        deviation: 0.5,
    };
    for distribution in [triangle, normal, CIRCLE] {
        let found = statistics(
            &[distribution],
            SamplePlan {
                samples: 20_000,
                seed: 5,
            },
            |x| Some(x[0]),
        );
        assert!(
            found.mean.interval().unwrap().contains(distribution.mean())
                && found
                    .standard_uncertainty
                    .interval()
                    .unwrap()
                    .contains(distribution.deviation()),
            "{found:?}"
        );
        let indices = found.indices[0].unwrap();
        assert!(
            indices.first.contains(1.0) || (indices.first.value - 1.0).abs() < 0.02,
            "{indices:?}"
        );
        // a Poincaré constant is at least the variance of its distribution; for a normal
        // distribution they are equal
        assert!(
            distribution.deviation().powi(2) <= distribution.poincare() * (1.0 + 1e-15),
            "{distribution:?}"
        );
    }
}

#[test]
fn missing_values_are_counted_and_not_replaced() {
    let found = statistics(
        &[CIRCLE],
        SamplePlan {
            samples: 1000,
            seed: 0,
        },
        |x| (x[0] > 0.0).then_some(x[0]),
    );
    assert!(
        found.rows_left_out > 500 && found.rows_left_out < 900,
        "{}",
        found.rows_left_out
    );
    close(
        found.mean.value,
        PI / 2.0,
        1.0,
        0.1,
        "the mean of those there are",
    );
    let design = SaltelliDesign::new(
        &[CIRCLE],
        SamplePlan {
            samples: 10,
            seed: 0,
        },
    )
    .unwrap();
    assert!(design.statistics(&vec![vec![None; 10]; 3]).is_none());
    let constant = statistics(
        &[CIRCLE],
        SamplePlan {
            samples: 10,
            seed: 0,
        },
        |_| Some(2.0),
    );
    assert!(constant.indices[0].is_none() && constant.standard_uncertainty.value == 0.0);
}

fn drive() -> (Setup<f64>, Vec<Uncertain>) {
    let mut setup = Setup::modern_driver();
    // gradients and samples use the same integration step, so that they belong to the same drives
    setup.set_all(crate::common::LARGE_STEPS).unwrap();
    setup.set_all(crate::common::RIGID).unwrap();
    let sigmas = [
        "swing.speed=1 mph",
        "club.loft=0.2 deg",
        "swing.face_angle=1 deg",
        "air.density=1%",
    ];
    let inputs = sigmas.map(|text| Uncertain::normal(&setup, &Sigma::read(&setup, text).unwrap()));
    (setup, inputs.to_vec())
}

#[test]
fn sampled_drives_agree_with_gradients_where_nearly_linear() {
    let (setup, inputs) = drive();
    let of = [Outcome::Carry, Outcome::Lateral];
    let plan = SamplePlan {
        samples: 2048,
        seed: 7,
    };
    let found = uncertainty(&setup, &of, &inputs, plan, &|_, _| ()).unwrap();
    for outcome in &found.outcomes {
        let first = outcome.delta.unwrap();
        let second = outcome.second_order;
        let (second, sampled) = (second.unwrap(), outcome.monte_carlo.as_ref().unwrap());
        close(
            first.standard_uncertainty,
            sampled.standard_uncertainty.value,
            first.standard_uncertainty,
            0.05,
            outcome.of.name(),
        );
        assert!(
            sampled
                .standard_uncertainty
                .interval()
                .unwrap()
                .contains(second.standard_uncertainty),
            "{}: {sampled:?} {second:?}",
            outcome.of.name()
        );
        assert!(
            sampled.mean.interval().unwrap().contains(second.mean),
            "{}: {sampled:?} {second:?}",
            outcome.of.name()
        );
        for one in &outcome.indices {
            // the bound is at least the total share, except for sampling errors
            let (total, bound) = (one.total.unwrap(), one.bound.unwrap());
            assert!(
                bound.high >= total.low,
                "{}: {total:?} {bound:?}",
                outcome.of.name()
            );
        }
    }
    let [carry, lateral] = found.outcomes.as_slice() else {
        panic!()
    };
    assert_eq!(carry.measure_first.unwrap().parameter.name, "swing.speed");
    assert_eq!(
        lateral.measure_first.unwrap().parameter.name,
        "swing.face_angle"
    );
    assert_eq!(found.ellipses.len(), 4);
    for sampled in &found.ellipses {
        close(
            sampled.holds,
            sampled.ellipse.share,
            1.0,
            0.03,
            "share of the landings",
        );
    }
    assert_eq!(
        found
            .status_counts
            .counts()
            .map(|(_, count)| count)
            .sum::<u64>(),
        6 * 2048
    );

    // an equal seed gives equal bits, another seed other bits
    let again = uncertainty(&setup, &of, &inputs, plan, &|_, _| ()).unwrap();
    assert_eq!(
        format!("{:?}", again.outcomes),
        format!("{:?}", found.outcomes)
    );
    let other = uncertainty(
        &setup,
        &of,
        &inputs,
        SamplePlan { seed: 8, ..plan },
        &|_, _| (),
    )
    .unwrap();
    assert_ne!(
        format!("{:?}", other.outcomes),
        format!("{:?}", found.outcomes)
    );
}

#[test]
fn drives_that_do_not_fly_are_counted() {
    let mut setup = Setup::modern_driver();
    setup
        .set_all([("club.loft", "1 deg"), ("swing.attack_angle", "0 deg")])
        .unwrap();
    let inputs = [Uncertain::read(&setup, "club.loft=uniform(-2 deg, 4 deg)").unwrap()];
    let found = uncertainty(
        &setup,
        &[Outcome::Carry],
        &inputs,
        SamplePlan {
            samples: 300,
            seed: 0,
        },
        &|_, _| (),
    )
    .unwrap();
    let count = |wanted: Status| {
        found
            .status_counts
            .counts()
            .find(|(status, _)| *status == wanted)
            .unwrap()
            .1
    };
    // in a third of the range of attack angles the ball is launched downwards
    assert!(
        count(Status::NoFlight) > 200 && count(Status::NoFlight) < 400,
        "{:?}",
        found.status_counts
    );
    assert_eq!(count(Status::NoFlight) + count(Status::Landed), 900);
    assert!(
        found.outcomes[0]
            .monte_carlo
            .as_ref()
            .unwrap()
            .rows_left_out
            > 0
    );
}

#[test]
fn exact_effects_are_gradients_times_uncertainties_ranked_by_size() {
    let setup = Setup::modern_driver();
    let given = [
        Sigma::read(&setup, "swing.speed=2 mph").unwrap(),
        Sigma::read(&setup, "ball.mass=1%").unwrap(),
    ];
    let sigmas = with_defaults(&setup, &given, &[Outcome::Carry]).unwrap();
    assert!(sigmas.len() > 8 && sigmas.iter().skip(2).all(|sigma| sigma.source.is_some()));
    let found = effects(&setup, &[Outcome::Carry], &sigmas, &|_, _| ())
        .unwrap()
        .remove(0);
    let carry = Outcome::Carry.of(&Drive::new(&setup).unwrap()).unwrap();
    close(found.value, carry, carry, 1e-14, "value");
    let bars: Vec<_> = found
        .effects
        .iter()
        .filter_map(|effect| Some((effect, effect.sigma_effect?)))
        .collect();
    assert_eq!(bars.len(), sigmas.len());
    assert!(
        bars.windows(2)
            .all(|pair| pair[0].1.first_order.abs() >= pair[1].1.first_order.abs())
    );
    for (effect, bar) in bars {
        let exact = derivative::hessian(&setup, Outcome::Carry, &[effect.parameter]).unwrap();
        let sigma = bar.sigma.value;
        close(
            bar.first_order,
            sigma * exact.gradient[0],
            carry,
            1e-13,
            effect.parameter.name,
        );
        close(
            bar.second_order.unwrap(),
            0.5 * sigma * sigma * exact.hessian[0][0],
            carry,
            1e-13,
            effect.parameter.name,
        );
        // the flown change agrees with Taylor's polynomial of degree 2, to a remainder of third
        // order
        let third = 0.1 * (bar.first_order.abs() + bar.second_order.unwrap().abs()) * 0.2 + 1e-9;
        for (flown, sign) in bar.flown.into_iter().zip([-1.0, 1.0]) {
            close(
                flown.unwrap(),
                sign * bar.first_order + bar.second_order.unwrap(),
                1.0,
                third,
                effect.parameter.name,
            );
        }
    }
    // ball speed is proportional to club speed: an elasticity of 1
    let speed = effects(&setup, &[Outcome::BallSpeed], &given, &|_, _| ())
        .unwrap()
        .remove(0);
    let of_speed = speed
        .effects
        .iter()
        .find(|effect| effect.parameter.name == "swing.speed")
        .unwrap();
    close(of_speed.elasticity.unwrap(), 1.0, 1.0, 1e-12, "elasticity");
}

#[test]
fn mistakes_in_uncertainties_are_named() {
    let setup = Setup::modern_driver();
    for text in [
        "swing.speed",
        "swing.speed=fast",
        "swing.speed=0 mph",
        "swing.speed=-1 mph",
        "swing.speed=inf",
        "swing.speed=1 kg",
    ] {
        assert!(
            matches!(Sigma::read(&setup, text), Err(Error::Unreadable { .. })),
            "{text}"
        );
    }
    assert!(matches!(
        Sigma::read(&setup, "swing.sped=1 mph"),
        Err(Error::Unknown { .. })
    ));
    assert!(matches!(
        Sigma::read(&setup, "flight.step=1 ms"),
        Err(Error::NotVariable { .. })
    ));
    for text in [
        "normal(1 deg)",
        "normal(1 deg,0 deg)",
        "uniform(2 deg,1 deg)",
        "triangular(1 deg,5 deg,2 deg)",
        "gauss(1,2)",
        "uniform(1 deg,2 deg",
        "1 deg",
    ] {
        let text = format!("club.loft={text}");
        assert!(
            matches!(
                Uncertain::read(&setup, &text),
                Err(Error::Unreadable { .. })
            ),
            "{text}"
        );
    }
    assert!(matches!(
        Uncertain::read(&setup, "club.mass=uniform(0 g,200 g)"),
        Err(Error::OutOfRange { .. })
    ));
    let (setup, inputs) = drive();
    let twice = [inputs[0], inputs[0]];
    let plan = SamplePlan {
        samples: 100,
        seed: 0,
    };
    let of = [Outcome::Carry];
    assert!(matches!(
        uncertainty(&setup, &of, &twice, plan, &|_, _| ()),
        Err(Error::SearchRange { .. })
    ));
    assert!(matches!(
        uncertainty(&setup, &of, &[], plan, &|_, _| ()),
        Err(Error::Nothing { .. })
    ));
    assert!(matches!(
        uncertainty(&setup, &[], &inputs, plan, &|_, _| ()),
        Err(Error::Nothing { .. })
    ));
    let too_small = SamplePlan {
        samples: 1,
        seed: 0,
    };
    assert!(matches!(
        uncertainty(&setup, &of, &inputs, too_small, &|_, _| ()),
        Err(Error::Together { .. })
    ));
}

/// Ball speed does not depend on the air: its variance is 0 and has no shares, and no measurement
/// would improve it.
#[test]
fn an_outcome_without_uncertain_parameters_says_so() {
    let setup = Setup::modern_driver();
    let density = Uncertain::normal(&setup, &Sigma::read(&setup, "air.density=1%").unwrap());
    let plan = SamplePlan {
        samples: 300,
        seed: 0,
    };
    let of = [Outcome::BallSpeed, Outcome::Lateral, Outcome::Carry];
    let found = uncertainty(&setup, &of, &[density], plan, &|_, _| ()).unwrap();
    let drive = Drive::new(&setup).unwrap();
    for outcome in &found.outcomes[..2] {
        let sampled = outcome.monte_carlo.as_ref().unwrap();
        assert_eq!(
            sampled.mean.value,
            outcome.of.of(&drive).unwrap(),
            "to the last bit"
        );
        assert_eq!(
            (
                sampled.standard_uncertainty.value,
                sampled.standard_uncertainty.low,
                sampled.standard_uncertainty.high
            ),
            (0.0, Some(0.0), Some(0.0))
        );
        let [one] = outcome.indices[..] else { panic!() };
        assert!(one.first.is_none() && one.total.is_none() && one.bound.is_none());
        assert!(sampled.indices == [None] && !outcome.varies);
        assert_eq!(one.mean_square_slope, None);
        assert_eq!(outcome.measure_first, None);
    }
    let carry = &found.outcomes[2];
    assert!(carry.varies && carry.measure_first.unwrap().parameter.name == "air.density");
    let report = UncertaintyReport::new(&found);
    let text = report.document(longdrive::units::System::Us).text(&WHOLE);
    assert!(
        text.contains("ball_speed is 162.0 mph in every drive")
            && text.contains("it does not depend on the uncertain parameter\n"),
        "{text}"
    );
    assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
    let json = serde_json::to_value(Reply::of(&report, vec![])).unwrap();
    assert_eq!(json["outcomes"][0]["varies"], false);
    assert_eq!(
        json["outcomes"][0]["measure_first"],
        serde_json::Value::Null
    );
    assert_eq!(
        json["outcomes"][0]["monte_carlo"]["standard_uncertainty"]["value"],
        0.0
    );
}

#[test]
fn a_constant_with_rounding_is_a_constant() {
    let constant = statistics(
        &[CIRCLE],
        SamplePlan {
            samples: 100,
            seed: 0,
        },
        |x| Some(0.1 + x[0].sin() * 1e-17),
    );
    assert!(constant.indices[0].is_none() && constant.standard_uncertainty.value == 0.0);
    let rounded = statistics(
        &[CIRCLE],
        SamplePlan {
            samples: 100,
            seed: 0,
        },
        |x| Some(0.1 * (1.0 + 1e-15 * x[0].signum())),
    );
    assert!(rounded.indices[0].is_none() && rounded.standard_uncertainty.value == 0.0);
    let varies = statistics(
        &[CIRCLE],
        SamplePlan {
            samples: 100,
            seed: 0,
        },
        |x| Some(0.1 * (1.0 + 1e-12 * x[0])),
    );
    assert!(varies.indices[0].is_some() && varies.standard_uncertainty.value > 0.0);
}

/// The remaining deviation of an outcome if its dominant parameter is known, compared with the root
/// of the mean variance at three fixed values of this parameter (Gauss's nodes of a normal
/// distribution). The difference 1 − S₁ would be 0 with one seed, and four times too large with
/// another.
#[test]
fn independent_remaining_deviation_where_one_parameter_dominates() {
    let mut setup = Setup::modern_driver();
    setup.set_all(LARGE_STEPS).unwrap();
    let input = |text: &str| Uncertain::normal(&setup, &Sigma::read(&setup, text).unwrap());
    let others = ["swing.speed=2mph", "club.loft=1deg"].map(input);
    let all = [others[0], others[1], input("swing.face_angle=2deg")];
    let plan = |seed| SamplePlan {
        samples: 4096,
        seed,
    };
    let run = |setup: &Setup<f64>, inputs: &[Uncertain], seed| {
        uncertainty(setup, &[Outcome::Lateral], inputs, plan(seed), &|_, _| ())
            .unwrap()
            .outcomes
            .remove(0)
    };
    let at = |deg: f64| {
        let mut fixed = setup;
        fixed.swing.face_angle += deg.to_radians();
        run(&fixed, &others, 0)
            .monte_carlo
            .unwrap()
            .standard_uncertainty
            .value
            .powi(2)
    };
    let node = 2.0 * 3.0_f64.sqrt();
    let exact = (at(0.0) * 2.0 / 3.0 + (at(node) + at(-node)) / 6.0).sqrt();
    for seed in 0..4 {
        let first = run(&setup, &all, seed).measure_first.unwrap();
        assert_eq!(first.parameter.name, "swing.face_angle");
        close(
            first.standard_uncertainty,
            exact,
            exact,
            0.1,
            "what is left",
        );
    }
}

/// An uncertainty whose square overflows gives no NaN and no infinity.
#[test]
fn huge_uncertainties_give_no_infinity() {
    let setup = Setup::modern_driver();
    let sigma = Sigma::read(&setup, "wind.downrange=1e200 m/s").unwrap();
    let input = [Uncertain::normal(&setup, &sigma)];
    let plan = SamplePlan {
        samples: 10,
        seed: 0,
    };
    let found = uncertainty(
        &setup,
        &[Outcome::Carry, Outcome::Lateral],
        &input,
        plan,
        &|_, _| (),
    )
    .unwrap();
    for outcome in &found.outcomes {
        let first = outcome.delta.unwrap();
        let second = outcome.second_order;
        assert!(
            first.standard_uncertainty.is_finite() && second.is_none(),
            "{outcome:?}"
        );
    }
    let report = UncertaintyReport::new(&found);
    let text = report.document(longdrive::units::System::Us).text(&WHOLE);
    assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
    let found = effects(&setup, &[Outcome::Carry], &[sigma], &|_, _| ())
        .unwrap()
        .remove(0);
    let bar = found.effects[0].sigma_effect.unwrap();
    assert!(bar.first_order > 1e199 && bar.second_order.is_none());
    close(
        found.standard_uncertainty(),
        bar.first_order,
        bar.first_order,
        1e-15,
        "of one bar",
    );
    assert_eq!(found.linearity(), 0.0);
}

/// Gusts add a deviation σ_u = u/ln(z/z₀) along the wind, and 0.8 σ_u across it, to the 1 m/s of
/// the mean wind.
#[test]
fn exact_gusts_in_the_uncertainty_of_the_wind() {
    let sigma = |settings: &[(&str, &str)], name: &str| {
        let mut setup = Setup::modern_driver();
        setup.set_all(settings.iter().copied()).unwrap();
        let all =
            longdrive::study::with_defaults(&setup, &[], &[longdrive::Outcome::Carry]).unwrap();
        all.into_iter()
            .find(|sigma| sigma.parameter.name == name)
            .unwrap()
            .value
    };
    let polar = [("wind.speed", "8 m/s"), ("wind.from", "30 deg")];
    let open = 8.0 / 200.0_f64.ln();
    assert!((sigma(&polar, "wind.speed") - 1.0_f64.hypot(open)).abs() < 1e-14);
    let mown = [polar[0], polar[1], ("wind.roughness", "2.4 mm")];
    assert!(
        (sigma(&mown, "wind.speed") - 1.0_f64.hypot(8.0 / (10.0_f64 / 0.0024).ln())).abs() < 1e-14
    );
    let head = [("wind.downrange", "-8 m/s")];
    assert!((sigma(&head, "wind.downrange") - 1.0_f64.hypot(open)).abs() < 1e-14);
    assert!((sigma(&head, "wind.right") - 1.0_f64.hypot(0.8 * open)).abs() < 1e-14);
    // calm air has no gusts; if the roughness exceeds the reference height, the deviation of gusts
    // is limited to the wind speed
    assert_eq!(sigma(&[], "wind.downrange"), 1.0);
    let rough = [
        polar[0],
        polar[1],
        ("wind.roughness", "10 m"),
        ("wind.reference_height", "1 m"),
    ];
    assert_eq!(sigma(&rough, "wind.speed"), 1.0_f64.hypot(8.0));
}

/// If the height of the centre of mass is stated, a strike is measured from the face centre: only
/// the mark of the ball is uncertain. If it is not stated, the sweet spot is uncertain, too.
#[test]
fn the_uncertainty_of_a_strike_has_the_source_of_its_size() {
    let sigma = |setup: &Setup<f64>| {
        let all = with_defaults(setup, &[], &[Outcome::Carry]).unwrap();
        let mut all = all.into_iter();
        all.find(|sigma| sigma.parameter.name == "strike.high")
            .unwrap()
    };
    let mut setup = Setup::modern_driver();
    setup.set("club.cg_high", "none").unwrap();
    let spot = sigma(&setup);
    setup.set("club.cg_high", "0 mm").unwrap();
    let stated = sigma(&setup);
    close(
        spot.value,
        1e-3_f64.hypot(3e-3),
        1e-3,
        1e-12,
        "from the sweet spot",
    );
    close(stated.value, 1e-3, 1e-3, 1e-12, "from the face centre");
    assert_eq!(
        [spot, stated].map(|sigma| sigma.source.unwrap().contains("sweet spot")),
        [true, false]
    );
    // beside a stated toe position, strike.high is measured from the face centre, at whose height
    // the sweet spot is assumed
    setup.set("club.cg_high", "none").unwrap();
    setup.set("club.cg_toe", "2 mm").unwrap();
    let beside_toe = sigma(&setup);
    assert_eq!(beside_toe.value, spot.value);
    assert!(!beside_toe.source.unwrap().contains("from which"));
}

#[test]
fn an_unset_wind_is_refused_with_advice() {
    for name in ["wind.speed", "wind.from"] {
        let error = longdrive::Setup::modern_driver()
            .variable(name)
            .unwrap_err()
            .to_string();
        let words = "it is unset here, which means: wind.right and wind.downrange give the \
                     wind; give it a value";
        assert!(error.contains(words), "{error}");
    }
}

/// Distributions built in code are checked like distributions that `Uncertain::read` reads, before
/// any drive is flown.
#[test]
fn impossible_distributions_are_refused() {
    let setup = Setup::modern_driver();
    let speed = setup.variable("swing.speed").unwrap();
    let plan = SamplePlan {
        samples: 8,
        seed: 0,
    };
    for (distribution, says) in [
        (
            Distribution::Normal {
                mean: f64::NAN,
                deviation: 1.0,
            },
            "finite",
        ),
        (
            Distribution::Normal {
                mean: 50.0,
                deviation: -1.0,
            },
            "standard deviation",
        ),
        (
            Distribution::Normal {
                mean: 50.0,
                deviation: 0.0,
            },
            "standard deviation",
        ),
        (
            Distribution::Normal {
                mean: 50.0,
                deviation: f64::INFINITY,
            },
            "standard deviation",
        ),
        (
            Distribution::Uniform {
                low: 50.0,
                high: 40.0,
            },
            "rise",
        ),
        (
            Distribution::Uniform {
                low: 50.0,
                high: 50.0,
            },
            "rise",
        ),
        (
            Distribution::Uniform {
                low: 50.0,
                high: f64::INFINITY,
            },
            "finite",
        ),
        (
            Distribution::Triangular {
                low: 40.0,
                mode: 60.0,
                high: 50.0,
            },
            "rise",
        ),
        (
            Distribution::Truncated {
                mean: 50.0,
                deviation: 1.0,
                low: 90.0,
                high: 91.0,
            },
            "the distribution has no probability",
        ),
        (
            Distribution::Truncated {
                mean: 50.0,
                deviation: 1.0,
                low: 9.0,
                high: 10.0,
            },
            "the distribution has no probability",
        ),
        (
            Distribution::Truncated {
                mean: 50.0,
                deviation: 0.0,
                low: 40.0,
                high: 60.0,
            },
            "standard deviation",
        ),
        (
            Distribution::Truncated {
                mean: 50.0,
                deviation: 1.0,
                low: 60.0,
                high: 40.0,
            },
            "rise",
        ),
    ] {
        let input = Uncertain {
            parameter: speed,
            distribution,
        };
        let swings = || Swings::distributed(vec![input], &[]).unwrap();
        let refused = [
            uncertainty(&setup, &[Outcome::Carry], &[input], plan, &|_, _| ()).map(|_| ()),
            Scenarios::new(&swings(), Rule::Quadrature(4)).map(|_| ()),
            Scenarios::new(&swings(), Rule::Sequence { count: 4, seed: 0 }).map(|_| ()),
        ];
        for error in refused.map(Result::unwrap_err) {
            let words = error.to_string();
            assert!(
                matches!(error, Error::Unreadable { .. }) && words.contains(says),
                "{distribution:?}: {words}"
            );
            assert!(words.contains("swing.speed"), "{words}");
        }
        let alone = SaltelliDesign::new(&[distribution], plan)
            .unwrap_err()
            .to_string();
        assert!(alone.contains(says), "{alone}");
    }
    let beyond = Uncertain {
        parameter: speed,
        distribution: Distribution::Uniform {
            low: -1.0,
            high: 1.0,
        },
    };
    let refused = uncertainty(&setup, &[Outcome::Carry], &[beyond], plan, &|_, _| ()).unwrap_err();
    assert!(matches!(refused, Error::OutOfRange { .. }), "{refused}");
    let none = uncertainty(&setup, &[Outcome::Carry], &[], plan, &|_, _| ())
        .unwrap_err()
        .to_string();
    assert!(
        none.contains("at least one uncertain parameter") && !none.contains("sweep"),
        "{none}"
    );
    for value in [f64::NAN, f64::INFINITY, 0.0, -1.0] {
        let sigma = Sigma {
            parameter: speed,
            value,
            source: None,
        };
        let refused = [
            effects(&setup, &[Outcome::Carry], &[sigma], &|_, _| ()).map(|_| ()),
            Landing::of(DriveRole::AsSetUp, &setup, &[sigma]).map(|_| ()),
        ];
        for error in refused.map(Result::unwrap_err) {
            assert!(
                error
                    .to_string()
                    .contains("the standard uncertainty of swing.speed"),
                "{error}"
            );
        }
    }
}

/// A normal distribution truncated to 9 to 10 standard deviations above its mean, and to 9 to 10
/// below it. Mean, central moments and quantiles are from mpmath with 40 digits. In the upper tail
/// the distribution function rounds to 1.
#[test]
fn independent_both_tails_of_a_truncated_normal_distribution_are_those_of_40_digits() {
    let setup = Setup::modern_driver();
    let mean = 9.108_456_288_012;
    let moments = [
        0.011_448_805_821_64,
        0.002_325_759_361_667,
        0.001_058_215_090_716,
    ];
    let quantiles = [
        (0.1, 9.011_559_170_906),
        (0.5, 9.075_779_713_739),
        (0.9, 9.249_353_376_365),
    ];
    for side in [-1.0, 1.0] {
        let [low, high] = if side > 0.0 {
            [9.0, 10.0]
        } else {
            [-10.0, -9.0]
        };
        let tail = Distribution::Truncated {
            mean: 0.0,
            deviation: 1.0,
            low,
            high,
        };
        tail.check().unwrap();
        close(tail.mean(), side * mean, 1.0, 1e-12, "mean");
        let [second, third, fourth] = tail.central_moments();
        close(second, moments[0], moments[0], 1e-11, "second");
        close(third, side * moments[1], moments[1], 1e-11, "third");
        close(fourth, moments[2], moments[2], 1e-11, "fourth");
        for (share, value) in quantiles {
            let share = if side > 0.0 { share } else { 1.0 - share };
            close(tail.quantile(share), side * value, 1.0, 1e-8, "quantile");
        }
        let text = format!(
            "swing.speed=truncated(50 m/s, 1 m/s, {} m/s, {} m/s)",
            50.0 + low,
            50.0 + high
        );
        let read = Uncertain::read(&setup, &text).unwrap().distribution;
        close(read.mean(), 50.0 + side * mean, 1.0, 1e-9, "mean as read");
    }
}

/// Mean and central moments of a standard normal distribution between two ends, by mpmath with 60
/// digits. The widths are 1e-9 to 40 standard deviations, and some ends are in a tail.
#[test]
fn independent_moments_of_a_truncated_normal_distribution_of_any_width() {
    let cases: [([f64; 2], f64, [f64; 3]); 6] = [
        ([-5e-10, 5e-10], 0.0, [8.333333333333333e-20, 0.0, 1.25e-38]),
        (
            [-1e-5, 2e-5],
            4.999999999625e-6,
            [
                7.499999999775e-11,
                3.374999999710714e-26,
                1.012499999956607e-20,
            ],
        ),
        (
            [-1.0, 3.0],
            0.282786110727154,
            [0.6161417353578293, 0.260827182899374, 1.060756088952412],
        ),
        ([-20.0, 20.0], 0.0, [1.0, 0.0, 3.0]),
        (
            [8.0, 15.0],
            8.121368112236113,
            [
                0.01432488344334091,
                0.003291876566344136,
                0.00172089895245107,
            ],
        ),
        ([-1000.0, 1200.0], 0.0, [1.0, 0.0, 3.0]),
    ];
    for (ends, mean, [second, third, fourth]) in cases {
        for side in [1.0_f64, -1.0] {
            let mirrored = [side * ends[0], side * ends[1]];
            let distribution = Distribution::Truncated {
                mean: 0.0,
                deviation: 1.0,
                low: mirrored[0].min(mirrored[1]),
                high: mirrored[0].max(mirrored[1]),
            };
            distribution.check().unwrap();
            let sigma = second.sqrt();
            close(
                distribution.mean(),
                side * mean,
                sigma,
                1e-11,
                "mean in standard deviations",
            );
            let found = distribution.central_moments();
            close(found[0], second, second, 1e-11, "second");
            close(found[1], side * third, sigma.powi(3), 1e-11, "third");
            close(found[2], fourth, fourth, 1e-11, "fourth");
        }
    }
}

/// With a standard deviation far above the width, a truncated normal distribution is uniform to
/// rounding: mean, central moments and quantiles have closed forms.
#[test]
fn exact_uniform_distribution_of_a_wide_normal_one_between_near_ends() {
    for deviation in [1e8, 1e10, 1e15, 1e20, 1e300] {
        for mean in [105.0, 104.0, 120.0] {
            let distribution = Distribution::Truncated {
                mean,
                deviation,
                low: 104.0,
                high: 106.0,
            };
            distribution.check().unwrap();
            close(distribution.mean(), 105.0, 1.0, 1e-7, "mean");
            let [second, third, fourth] = distribution.central_moments();
            close(second, 1.0 / 3.0, 1.0, 1e-7, "second");
            close(third, 0.0, 1.0, 1e-7, "third");
            close(fourth, 0.2, 1.0, 1e-7, "fourth");
            for share in [0.0, 0.1, 0.5, 0.75, 1.0] {
                close(
                    distribution.quantile(share),
                    104.0 + 2.0 * share,
                    1.0,
                    1e-7,
                    "quantile",
                );
            }
        }
    }
}

/// If the ends of a truncated normal distribution are far from its mean, its Gauss rule has the
/// mean and the variance of the normal distribution.
#[test]
fn exact_rule_of_a_truncated_normal_distribution_with_far_ends() {
    let speed = Setup::modern_driver().variable("swing.speed").unwrap();
    let input = Uncertain {
        parameter: speed,
        distribution: Distribution::Truncated {
            mean: 50.0,
            deviation: 0.05,
            low: 1.0,
            high: 90.0,
        },
    };
    let swings = Swings::distributed(vec![input], &[]).unwrap();
    let found = Scenarios::new(&swings, Rule::Quadrature(5)).unwrap();
    let swings = || found.points.iter().zip(&found.weights);
    let mean: f64 = swings().map(|(x, weight)| x[0] * weight).sum();
    let variance = swings().map(|(x, weight)| (x[0] - mean).powi(2) * weight);
    close(mean, 50.0, 0.05, 1e-10, "mean");
    close(variance.sum(), 0.0025, 0.0025, 1e-10, "variance");
}

/// An interval or quantile of few points is too narrow: there is none, and a warning says so.
#[test]
fn a_small_sample_has_no_intervals_quantiles_or_shares() {
    let request = ["uncertainty", "modern-driver", "--of", "carry", "--samples"];
    let says = "carry: 95 % intervals, quantiles and shares of the variance need 100 points";
    for (samples, is_enough) in [("99", false), ("100", true)] {
        let request = [&request[..], &[samples]].concat();
        let (status, answer) = json(&request);
        let carry = &answer["outcomes"][0];
        let sampled = &carry["monte_carlo"];
        assert_eq!(status, 0);
        assert!(sampled["mean"]["value"].is_number(), "{sampled}");
        for one in [
            &sampled["mean"]["low"],
            &sampled["standard_uncertainty"]["high"],
            &sampled["quantiles"]["2.5 %"],
            &carry["indices"][0]["first"]["value"],
            &carry["indices"][0]["total"]["low"],
            &carry["indices"][0]["bound"]["value"],
            &carry["measure_first"]["parameter"],
        ] {
            assert_eq!(one.is_null(), !is_enough, "{samples}: {carry}");
        }
        assert_eq!(answer["warnings"].to_string().contains(says), !is_enough);
        let output = longdrive(&[&request[..], &["--all"]].concat());
        assert_eq!(on_one_line(&output.err).contains(says), !is_enough);
        assert_eq!(output.out.contains("95 %"), is_enough, "{}", output.out);
    }
}

/// The spin axis jumps from 0° to 180° where the spin changes its sign, and its slope is 0 on both
/// sides: the slopes give no upper bound.
#[test]
fn an_outcome_that_jumps_has_no_upper_bound_from_its_slopes() {
    let mut setup = Setup::preset("modern-driver").unwrap();
    setup.set("club.loft", "5 deg").unwrap();
    let input = |text: &str| Uncertain::normal(&setup, &Sigma::read(&setup, text).unwrap());
    let inputs = ["club.loft=3 deg", "swing.speed=2 mph"].map(input);
    let plan = SamplePlan {
        samples: 512,
        seed: 0,
    };
    let of = [Outcome::SpinAxis, Outcome::BallSpeed];
    let found = uncertainty(&setup, &of, &inputs, plan, &|_, _| ()).unwrap();
    let [loft, _] = found.outcomes[0].indices[..] else {
        panic!("{found:?}")
    };
    assert!(loft.total.unwrap().low > 0.8, "{loft:?}");
    assert!(
        loft.bound.is_none() && loft.mean_square_slope.is_some(),
        "{loft:?}"
    );
    let smooth = &found.outcomes[1].indices;
    assert!(smooth.iter().all(|one| one.bound.is_some()), "{smooth:?}");
    let report = UncertaintyReport::new(&found);
    let text = report.document(longdrive::units::System::Us).text(&WHOLE);
    let says = "no upper bound where it would lie below an index: the outcome jumps";
    assert_eq!(on_one_line(&text).matches(says).count(), 1, "{text}");
}

/// Wrong lengths are programming errors: they panic with a message that has both lengths. An
/// infinite value or NaN counts as missing.
#[test]
fn statistics_of_other_lengths_panic_with_both_and_leave_no_nan() {
    let inputs = [Distribution::Normal {
        mean: 0.0,
        deviation: 1.0,
    }; 2];
    let design = SaltelliDesign::new(
        &inputs,
        SamplePlan {
            samples: 3,
            seed: 0,
        },
    )
    .unwrap();
    for values in [
        vec![],
        vec![vec![Some(1.0); 3]; 2],
        vec![vec![Some(1.0); 3], vec![], vec![], vec![]],
    ] {
        let output = panic_of(|| design.statistics(&values));
        let lengths: Vec<usize> = values.iter().map(Vec::len).collect();
        assert!(
            output.contains("[3, 3, 3, 3] points")
                && output.contains(&format!("{lengths:?} values")),
            "{output}"
        );
    }
    assert!(
        design
            .statistics(&vec![vec![Some(f64::NAN); 3]; 4])
            .is_none()
    );
    let one_missing: Vec<Vec<_>> = [f64::NAN, 2.0, 3.0, 4.0]
        .map(|first| vec![Some(first), Some(5.0), Some(7.0)])
        .into();
    let found = design.statistics(&one_missing).unwrap();
    assert!(
        found.rows_left_out == 1
            && found.mean.value.is_finite()
            && found.standard_uncertainty.value.is_finite(),
        "{found:?}"
    );

    let taylor = |n: usize| derivative::Taylor {
        value: 1.0,
        gradient: vec![1.0; n],
        hessian: vec![],
    };
    for n in [1, 3] {
        let output = panic_of(|| delta_method(&taylor(n), &inputs));
        assert!(
            output.contains(&format!("2 distributions, and {n} derivatives")),
            "{output}"
        );
        let output = panic_of(|| derivative::Taylor::sum([(&taylor(2), 1.0), (&taylor(n), 1.0)]));
        assert!(
            output.contains(&format!(
                "2 derivatives of the first term, and {n} derivatives"
            )),
            "{output}"
        );
    }
    let with_hessian = derivative::Taylor {
        hessian: vec![vec![0.0; 2]; 2],
        ..taylor(2)
    };
    let output = panic_of(|| derivative::Taylor::sum([(&taylor(2), 1.0), (&with_hessian, 1.0)]));
    assert!(
        output.contains("0 rows of second derivatives of the first term, and 2"),
        "{output}"
    );
    assert!(panic_of(|| inputs[0].quantile(2.0)).contains("it is 2"));
}

#[test]
fn exact_moments_of_a_linear_function_of_any_distributions() {
    // 3 x − 2 y + z: variances 9·4 + 4·6²/12 + 3²/18
    let inputs = [
        Normal {
            mean: 1.0,
            deviation: 2.0,
        },
        Uniform {
            low: -3.0,
            high: 3.0,
        },
        Triangular {
            low: 0.0,
            mode: 0.0,
            high: 3.0,
        },
    ];
    let value = 3.0 * 1.0 - 0.0 + 1.0;
    let hessian = vec![vec![0.0; 3]; 3];
    let (first, second) = delta_method(
        &Taylor {
            value,
            gradient: vec![3.0, -2.0, 1.0],
            hessian,
        },
        &inputs,
    );
    assert!((first.mean - 4.0).abs() < 1e-15);
    assert!((first.standard_uncertainty - (36.0_f64 + 12.0 + 0.5).sqrt()).abs() < 1e-15);
    assert_eq!(second, Some(first));
}

#[test]
fn exact_moments_of_squares_and_products() {
    // x², x normal (0, 1): mean 1, variance 2; x y: mean 0, variance 1
    let normal = Normal {
        mean: 0.0,
        deviation: 1.0,
    };
    let square = Taylor {
        value: 0.0,
        gradient: vec![0.0],
        hessian: vec![vec![2.0]],
    };
    let second = delta_method(&square, &[normal]).1.unwrap();
    assert!(
        (second.mean - 1.0).abs() < 1e-15
            && (second.standard_uncertainty - 2.0_f64.sqrt()).abs() < 1e-15
    );
    let product = Taylor {
        value: 0.0,
        gradient: vec![0.0; 2],
        hessian: vec![vec![0.0, 1.0], vec![1.0, 0.0]],
    };
    let second = delta_method(&product, &[normal, normal]).1.unwrap();
    assert_eq!((second.mean, second.standard_uncertainty), (0.0, 1.0));
    // (x + 1)² for x uniform on [0, 1], expanded about ½: mean 7/3, variance ∫(x+1)⁴ − (7/3)² =
    // 31/5 − 49/9
    let uniform = Uniform {
        low: 0.0,
        high: 1.0,
    };
    let shifted = Taylor {
        value: 2.25,
        gradient: vec![3.0],
        hessian: vec![vec![2.0]],
    };
    let second = delta_method(&shifted, &[uniform]).1.unwrap();
    assert!((second.mean - 7.0 / 3.0).abs() < 1e-15);
    assert!((second.standard_uncertainty.powi(2) - (31.0 / 5.0 - 49.0 / 9.0)).abs() < 1e-14);
    // x² of a skew triangle on [0, 1] with its mode at 0, density 2 (1 − x): E x² = 1/6, E x⁴ =
    // 1/15
    let triangle = Triangular {
        low: 0.0,
        mode: 0.0,
        high: 1.0,
    };
    let square = Taylor {
        value: 1.0 / 9.0,
        gradient: vec![2.0 / 3.0],
        hessian: vec![vec![2.0]],
    };
    let second = delta_method(&square, &[triangle]).1.unwrap();
    assert!((second.mean - 1.0 / 6.0).abs() < 1e-15);
    assert!((second.standard_uncertainty.powi(2) - (1.0 / 15.0 - 1.0 / 36.0)).abs() < 1e-15);
}

#[test]
fn exact_points_in_a_flat_ellipse_and_in_a_point() {
    let flat = LandingEllipse::new(0.95, [0.0, 200.0], [[0.0, 0.0], [0.0, 4.0]]);
    // 95 % of a normal distribution lie within 1.960 standard deviations; the standard
    // deviation here is 2
    assert!(flat.contains([0.0, 203.919]) && !flat.contains([0.0, 203.921]));
    // 95 % of a bivariate normal distribution lie within √(−2 ln 0.05) = 2.448 standard
    // deviations
    let round = LandingEllipse::new(0.95, [0.0, 200.0], [[4.0, 0.0], [0.0, 4.0]]);
    assert!(round.contains([0.0, 204.89]) && !round.contains([0.0, 204.91]));
    assert!(!flat.contains([0.1, 200.0]));
    let point = LandingEllipse::new(0.95, [3.0, 200.0], [[0.0; 2]; 2]);
    assert!(
        point.contains([3.0, 200.0])
            && !point.contains([3.0, 201.0])
            && !point.contains([2.0, 200.0])
    );
}

/// A percentage is relative to the parameter's value: with its sign for means, ends and changes, and
/// its magnitude for standard deviations; also for a dimensionless parameter.
#[test]
fn exact_percentages_are_relative_to_the_value() {
    use longdrive::study::{Change, Sigma};
    let mut setup = Setup::modern_driver();
    setup.set("swing.attack_angle", "-2 deg").unwrap();
    setup.set("air.temperature", "10 degC").unwrap();
    setup.set("air.humidity", "50%").unwrap();
    let value = |name: &str| setup.value(setup.parameter(name).unwrap()).unwrap();
    let (angle, lift) = (value("swing.attack_angle"), value("aero.cl_max"));
    let sigma = |text: &str| Sigma::read(&setup, text).unwrap().value;
    assert_eq!(sigma("swing.attack_angle=10%"), 0.1 * -angle);
    assert_eq!(sigma("aero.cl_max=10%"), 0.1 * lift);
    let change = |text: &str| Change::read(&setup, text).unwrap().delta;
    assert_eq!(change("swing.attack_angle=+10%"), 0.1 * angle);
    assert_eq!(change("aero.cl_max=-20%"), -0.2 * lift);
    let read = |text: &str| Uncertain::read(&setup, text).unwrap().distribution;
    assert_eq!(
        read("swing.attack_angle=normal(100%,10%)"),
        Distribution::Normal {
            mean: angle,
            deviation: 0.1 * -angle
        }
    );
    assert_eq!(
        read("swing.attack_angle=uniform(110%,90%)"),
        Distribution::Uniform {
            low: 1.1 * angle,
            high: 0.9 * angle
        }
    );
    let refusals = [
        Sigma::read(&setup, "air.temperature=5%").unwrap_err(),
        Change::read(&setup, "air.temperature=5%").unwrap_err(),
        Uncertain::read(&setup, "air.temperature=normal(10 degC,5%)").unwrap_err(),
        Uncertain::read(&setup, "launch.spin=normal(100%,5%)").unwrap_err(),
        Sigma::read(&setup, "swing.path=5%").unwrap_err(),
        Uncertain::read(&setup, "air.humidity=uniform(40%,60%)").unwrap_err(),
    ];
    let reasons = [
        "the zero of degC is arbitrary; write an amount, for example 1 degC",
        "the zero of degC is arbitrary; write an amount, for example 1 degC",
        "the zero of degC is arbitrary; write an amount, for example 1 degC",
        "launch.spin is unset; write an amount, for example 1 rpm",
        "swing.path is 0; write an amount, for example 1 deg",
        "here 40% could also mean the number 0.4; write an amount, for example 1",
    ];
    for (refusal, reason) in refusals.iter().zip(reasons) {
        let text = refusal.to_string();
        assert!(text.contains(reason), "{text}");
    }
}
