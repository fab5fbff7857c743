//! Correct derivatives pass at the ends of ranges, in coarse steps, and where numbers cancel.

use crate::common::close;
use longdrive::derivative::check::Verdict;
use longdrive::parameters::{Law, Parameter};
use longdrive::study::certificate::{Certificate, certify};
use longdrive::{Drive, Error, Outcome, Setup};
use rayon::prelude::*;

const OF: [Outcome; 5] = [
    Outcome::Carry,
    Outcome::Lateral,
    Outcome::FlightTime,
    Outcome::Backspin,
    Outcome::Spin,
];

fn certificate(setup: &Setup<f64>, of: &[Outcome], by: &str) -> Certificate {
    certify(setup, of, &[setup.variable(by).unwrap()], &|_, _| true).unwrap()
}

/// The failures of a certificate, if any.
fn faults(certificate: &Certificate) -> String {
    let Certificate {
        rows,
        landing,
        continuity,
        convergence,
        planted,
        ..
    } = certificate;
    let rows: Vec<_> = rows
        .iter()
        .filter(|row| row.verdict() == Verdict::Fail)
        .map(|row| &row.first)
        .collect();
    let landing: Vec<_> = landing
        .iter()
        .filter(|row| row.check.failed())
        .map(|row| &row.check)
        .collect();
    format!("{rows:?} {landing:?} {continuity:?} {convergence:?} {planted:?}")
}

/// A setup with `parameter` at the end `end` of its range; `None` if the ball does not land.
fn at_the_end(law: &str, parameter: &'static Parameter, end: f64) -> Option<Setup<f64>> {
    let mut setup = Setup::modern_driver();
    setup.set_law(law).unwrap();
    // large steps take less time; derivatives belong to the drive in its own steps
    setup.set("flight.step", "50 ms").unwrap();
    if parameter.is_of_launch() {
        let spin = if parameter.name.contains("launch.spin") {
            "launch.spin"
        } else {
            "launch.backspin"
        };
        setup
            .set_all([
                ("launch.ball_speed", "167 mph"),
                ("launch.launch_angle", "10.9 deg"),
                (spin, "2686 rpm"),
            ])
            .unwrap();
    }
    setup.set_value(parameter, Some(end)).ok()?;
    setup.variable(parameter.name).ok()?;
    setup.validate().ok()?;
    Drive::new(&setup)
        .ok()
        .filter(|drive| drive.landed().is_ok())
        .map(|_| setup)
}

#[test]
fn differences_certify_derivatives_at_both_ends_of_every_range() {
    let all = Law::NAMES.iter().flat_map(|law| {
        let mut setup = Setup::modern_driver();
        setup.set_law(law).unwrap();
        // the coefficients of a law are checked with this law, all other parameters with the
        // default law
        let is_asked = |row: &&&Parameter| {
            row.law
                .map_or(*law == Setup::modern_driver().law.name(), |owner| {
                    owner == *law
                })
        };
        let rows: Vec<&'static Parameter> = setup
            .parameters()
            .iter()
            .filter(is_asked)
            .copied()
            .collect();
        rows.into_iter()
            .flat_map(move |row| [row.range.low, row.range.high].map(|end| (*law, row, end)))
    });
    let requested: Vec<_> = all
        .filter(|(_, row, end)| end.is_finite() && row.range.contains(*end))
        .collect();
    let judged = requested.par_iter().filter_map(|(law, row, end)| {
        let certificate = certificate(&at_the_end(law, row, *end)?, &OF, row.name);
        let corners = certificate
            .rows
            .iter()
            .filter(|row| row.verdict() == Verdict::Corner)
            .count();
        let fault = (!certificate.passed())
            .then(|| format!("{law}, {} = {end}: {}", row.name, faults(&certificate)));
        Some((row.name, corners, fault))
    });
    let judged: Vec<_> = judged.collect();
    let failed: Vec<_> = judged
        .iter()
        .filter_map(|(.., fault)| fault.as_deref())
        .collect();
    assert!(
        failed.is_empty(),
        "{} of {}:\n{}",
        failed.len(),
        judged.len(),
        failed.join("\n")
    );
    assert!(judged.len() > 40, "{} ends were checked", judged.len());
    // a drive with zero spin has a kink, also at the end of a range
    for name in [
        "impact.friction",
        "impact.tangential_restitution",
        "launch.spin",
    ] {
        assert!(
            judged
                .iter()
                .any(|(of, corners, _)| *of == name && *corners > 0),
            "{name} has no corner"
        );
    }
}

/// At the end of its range a parameter has only a one-sided slope. At other kinks the derivative is
/// the mean of both one-sided slopes, so it is not compared with the one-sided slope here.
#[test]
fn differences_confirm_the_one_sided_slope_of_a_corner_at_the_end_of_a_range() {
    let mut setup = Setup::modern_driver();
    setup.set("impact.friction", "0").unwrap();
    let carry = certificate(&setup, &[Outcome::Carry], "impact.friction");
    assert!(
        carry.passed() && carry.rows[0].verdict() == Verdict::Corner,
        "{}",
        faults(&carry)
    );
    let [None, Some(above)] = carry.rows[0].first.sides.unwrap() else {
        panic!("{:?}", carry.rows[0].first.sides)
    };
    // expected: the difference between the carries with a little friction and without
    let [none, little] = [0.0, 1e-6].map(|friction| {
        let mut setup = setup;
        setup.impact.friction = Some(friction);
        Outcome::Carry.of(&Drive::new(&setup).unwrap()).unwrap()
    });
    close(above, (little - none) / 1e-6, above, 1e-4, "slope");
}

/// At the lower end of a range there are one-sided differences only. The check passes there even for
/// a small derivative: that of lateral is below 0.01 m.
#[test]
fn differences_to_one_side_show_a_small_derivative() {
    let mut setup = Setup::modern_driver();
    let settings = [
        ("aero.law", "robinson"),
        ("club.loft", "24.6407 deg"),
        ("swing.attack_angle", "-4.78311 deg"),
        ("swing.speed", "79.8881 mph"),
        ("strike.toe", "5.01871 mm"),
        ("strike.high", "-0.346004 mm"),
        ("impact.friction", "0.05"),
        ("wind.downrange", "7.66065 m/s"),
        ("wind.right", "-1.11702 m/s"),
        ("air.density", "1.5 kg/m^3"),
        ("impact.tangential_restitution", "-1"),
        ("impact.gear_scale", "none"),
    ];
    setup.set_all(settings).unwrap();
    let found = certificate(&setup, &[Outcome::Lateral], "impact.tangential_restitution");
    assert!(
        found.passed() && !found.landing.is_empty(),
        "{}",
        faults(&found)
    );
    assert!(found.rows[0].first.exact.abs() < 0.01 && found.rows[0].first.curve.is_empty());
}

/// At zero spin the total spin has a kink, even if the law has none.
#[test]
fn a_corner_of_the_spin_itself_is_no_failure() {
    let mut setup = Setup::modern_driver();
    setup
        .set_all([("aero.law", "linear"), ("impact.friction", "0")])
        .unwrap();
    let found = certificate(&setup, &[Outcome::Carry, Outcome::Spin], "impact.friction");
    let verdict = |of: Outcome| {
        found
            .rows
            .iter()
            .find(|row| row.of == of)
            .unwrap()
            .verdict()
    };
    assert!(found.passed(), "{}", faults(&found));
    assert_eq!(
        [Outcome::Carry, Outcome::Spin].map(verdict),
        [Verdict::Pass, Verdict::Corner]
    );
}

/// Without friction the spin is only the rounding error of numbers that cancel.
#[test]
fn a_spin_that_cancels_has_a_correct_derivative() {
    let mut square = Setup::modern_driver();
    square.set("impact.friction", "0").unwrap();
    let mut oblique = square;
    let settings = [
        ("swing.attack_angle", "4.30771 deg"),
        ("swing.path", "-7.73954 deg"),
        ("strike.toe", "-15.9545 mm"),
        ("strike.high", "-7.45492 mm"),
    ];
    oblique.set_all(settings).unwrap();
    for (setup, by) in [
        (square, "swing.speed"),
        (oblique, "swing.speed"),
        (oblique, "club.bulge_radius"),
    ] {
        let spins = certificate(&setup, &[Outcome::Backspin, Outcome::Sidespin], by);
        assert!(spins.passed(), "by {by}: {}", faults(&spins));
    }
}

/// The check of the landing adjusts the time step so that a step ends at the landing. In coarse
/// steps this shifts the landing, so the check repeats the adjustment; then the differences agree.
#[test]
fn differences_at_the_landing_agree_at_coarse_steps() {
    let mut setup = Setup::preset("winfield-tan").unwrap();
    setup
        .set_all([
            ("swing.face_angle", "9.16018 deg"),
            ("club.mass", "588.187 g"),
        ])
        .unwrap();
    for step in ["82.3021 ms", "0.2 s", "0.4 s"] {
        setup.set("flight.step", step).unwrap();
        let found = certificate(&setup, &[Outcome::Carry], "swing.face_angle");
        assert!(found.passed(), "{step}: {}", faults(&found));
        // the errors are only rounding errors
        let worst = found
            .landing
            .iter()
            .map(|row| row.check.error / row.check.exact.abs())
            .fold(0.0, f64::max);
        assert!(worst < 1e-8 && found.landing.len() == 3, "{step}: {worst}");
    }
}

/// If the spin decays away within each step, the order of convergence cannot be measured.
#[test]
fn no_order_is_required_where_the_spin_decays_within_a_step() {
    let mut setup = Setup::modern_driver();
    for (damping, is_measured) in [("2e-5", true), ("1", false)] {
        setup.set("aero.spin_damping", damping).unwrap();
        let found = certificate(&setup, &[Outcome::Carry], "swing.speed");
        assert!(
            found.passed() && found.convergence.is_empty() != is_measured,
            "{damping}: {}",
            faults(&found)
        );
        let text = found
            .not_examined
            .iter()
            .any(|it| it.check.contains("convergence") && it.reason.contains("decay of its spin"));
        assert_eq!(text, !is_measured, "{damping}: {:?}", found.not_examined);
    }
}

#[test]
fn a_drive_without_a_requested_outcome_gives_the_reason() {
    let mut setup = Setup::modern_driver();
    setup.set("club.loft", "-1.73663 deg").unwrap();
    let wind = [setup.variable("wind.downrange").unwrap()];
    let certified = |of: &[Outcome]| certify(&setup, of, &wind, &|_, _| true);
    assert!(matches!(
        certified(&[Outcome::Carry, Outcome::Lateral]),
        Err(Error::NoFlight { .. })
    ));
    // the remaining derivatives are certified
    let found = certified(&[Outcome::Carry, Outcome::BallSpeed]).unwrap();
    assert!(
        found.passed() && found.missing.len() == 1,
        "{:?}",
        found.missing
    );
}

#[test]
fn a_stopped_certificate_has_its_finished_rows_and_does_not_pass() {
    let setup = Setup::modern_driver();
    let wrt = setup.variables();
    let found = certify(&setup, &[Outcome::Carry], &wrt, &|done, _| done < 3).unwrap();
    let [done, all] = found.stopped.unwrap();
    assert!(
        done >= 3 && done < all && found.rows.len() == done,
        "{done} of {all}, {} rows",
        found.rows.len()
    );
    assert!(!found.passed() && found.rows.iter().all(|row| row.verdict() == Verdict::Pass));
    assert!(
        found.landing.is_empty() && found.continuity.is_empty() && found.convergence.is_empty()
    );
    assert!(
        found.not_examined.len() == 3
            && found
                .not_examined
                .iter()
                .all(|it| it.reason.contains("interrupted"))
    );
}
