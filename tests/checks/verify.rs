//! Certificates of derivatives: correct derivatives pass, wrong ones fail, and kinks are reported.

use crate::command_line::{WHOLE, on_one_line};
use crate::common::{RIGID, close, in_large_steps, random_setups};
use crate::parallel::in_parallel;
use longdrive::derivative::check::{Verdict, check};
use longdrive::derivative::{Taylor, gradient};
use longdrive::impact::{Grip, strike};
use longdrive::parameters::{Law, Method, PRESETS, Parameter};
use longdrive::report::{CertificateReport, Reply, Report};
use longdrive::study::certificate::{Agreement, Certificate, PlantedError, certify};
use longdrive::units::System;
use longdrive::{Drive, Outcome, Setup};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use rayon::prelude::*;

fn certificate(setup: &Setup<f64>, of: &[Outcome], wrt: &[&'static Parameter]) -> Certificate {
    certify(setup, of, wrt, &|_, _| true).unwrap()
}

fn failures(certificate: &Certificate) -> Vec<String> {
    let rows = certificate
        .rows
        .iter()
        .filter(|row| row.verdict() == Verdict::Fail);
    let landing = certificate
        .landing
        .iter()
        .filter(|row| row.check.verdict == Verdict::Fail);
    let continuity = certificate
        .continuity
        .iter()
        .filter(|found| found.verdict == Verdict::Fail);
    let convergence = certificate
        .convergence
        .iter()
        .filter(|found| found.verdict == Verdict::Fail);
    rows.map(|row| {
        let second = row
            .second
            .as_ref()
            .map(|check| (check.exact, check.error, check.tolerance));
        format!(
            "{} {}: {} off by {} of {} {second:?}",
            row.of.name(),
            row.parameter.name,
            row.first.exact,
            row.first.error,
            row.first.tolerance
        )
    })
    .chain(landing.map(|row| {
        format!(
            "at landing, {} {}: {:?}",
            row.of.name(),
            row.parameter.name,
            row.check.best_difference
        )
    }))
    .chain(continuity.map(|found| format!("{found:?}")))
    .chain(convergence.map(|found| format!("{found:?}")))
    .chain((!certificate.caught()).then(|| format!("{:?}", certificate.planted)))
    .collect()
}

#[test]
fn differences_certify_every_derivative_of_every_preset_and_catch_every_planted_error() {
    for preset in PRESETS {
        let setup = Setup::preset(preset.name).unwrap();
        let of = Outcome::OF_DRIVES;
        let certificate = certificate(&setup, of, &setup.variables());
        assert!(
            certificate.passed(),
            "{}: {:?}",
            preset.name,
            failures(&certificate)
        );
        assert!(
            certificate.missing.is_empty()
                && certificate.rows.len() == of.len() * setup.variables().len()
        );
        assert!(
            certificate
                .rows
                .iter()
                .all(|row| row.verdict() == Verdict::Pass),
            "{}",
            preset.name
        );
        for planted in certificate.planted {
            let least = if planted.error == PlantedError::LandingTerm {
                40
            } else {
                200
            };
            assert!(
                planted.rows >= least && planted.caught == planted.rows,
                "{}: {planted:?}",
                preset.name
            );
            assert_eq!(
                planted.caught_by_num_dual, planted.rows,
                "{}: {planted:?}",
                preset.name
            );
        }
        assert_eq!(certificate.landing.len(), 3 * setup.variables().len());
        assert!(!certificate.continuity.is_empty() && !certificate.convergence.is_empty());
        // Taylor's remainders have order 1 without, and order 2 with the gradient. An order is
        // missing if rounding is larger
        let slopes = |k: usize| certificate.rows.iter().filter_map(move |row| row.slopes[k]);
        assert!(slopes(0).count() > 200 && slopes(0).all(|slope| slope > 0.9));
        assert!(slopes(1).count() > 200 && slopes(1).all(|slope| slope > 1.9));
    }
}

#[test]
fn differences_certify_a_launch_without_a_club() {
    let mut setup = Setup::modern_driver();
    let launch = [
        ("launch.ball_speed", "167 mph"),
        ("launch.launch_angle", "10.9 deg"),
        ("launch.backspin", "2686 rpm"),
    ];
    setup.set_all(launch).unwrap();
    let wrt = ["air.density", "launch.backspin"].map(|name| setup.variable(name).unwrap());
    let certificate = certificate(&setup, &[Outcome::Carry, Outcome::FlightTime], &wrt);
    assert!(certificate.passed(), "{:?}", failures(&certificate));
    assert_eq!(
        certificate.landing.len(),
        6,
        "three outcomes of the landing by two parameters"
    );
}

#[test]
fn differences_certify_two_hundred_random_drives() {
    // a drive is checked by four parameters, and the next drive by the next four. A separate run
    // checked all parameters of all drives (docs/verification.md)
    const AT_A_TIME: usize = 4;
    let flies = |setup: &Setup<f64>| Drive::new(setup).is_ok_and(|drive| drive.landed().is_ok());
    let setups: Vec<_> = random_setups(220)
        .filter(flies)
        .take(200)
        .enumerate()
        .map(in_large_steps)
        .collect();
    let drives: Vec<_> = setups.iter().enumerate().collect();
    let rows = in_parallel(&drives, |(drive, setup)| {
        let all = setup.variables();
        let wrt: Vec<_> = (0..AT_A_TIME)
            .map(|k| all[(AT_A_TIME * drive + k) % all.len()])
            .collect();
        let certificate = certificate(setup, &[Outcome::Carry, Outcome::Lateral], &wrt);
        assert!(certificate.passed(), "{:?}", failures(&certificate));
        certificate.rows.len()
    });
    assert_eq!(
        (rows.iter().sum::<usize>(), setups.len()),
        (200 * 2 * AT_A_TIME, 200)
    );
}

/// A usual drive, and the index of the parameter to differentiate by. The aerodynamic law varies
/// over all laws. Some drives have wind, and some a parameter at the end of its range.
fn any_request() -> impl Strategy<Value = (Setup<f64>, usize)> {
    let deg = std::f64::consts::PI / 180.0;
    let swing = (27.0..58.0, -8.0..8.0, -8.0..8.0, -10.0..10.0);
    let strike = (-0.02..0.02, -0.012..0.012);
    let of_half = |range: std::ops::Range<f64>| prop::option::of(range);
    let air = (
        of_half(-6.0..6.0),
        of_half(-6.0..6.0),
        0.9..1.3,
        prop::option::weighted(0.1, 0.003..0.03),
    );
    let at_an_end = prop::option::weighted(0.2, 0..7_usize);
    // friction limit (often none), log₁₀ of the step in s (or the default step), and method
    let how = (
        prop::option::weighted(0.3, 0.0..0.3),
        of_half(-3.0..-1.0),
        0..Method::ALL.len(),
    );
    let question = (
        0..Law::NAMES.len(),
        swing,
        2.0..25.0,
        prop::option::of(strike),
        air,
        at_an_end,
        0..10_000_usize,
        how,
    );
    question.prop_map(
        move |(law, swing, loft, strike, air, end, parameter, (friction, step, method))| {
            let mut s = Setup::modern_driver();
            s.set_law(Law::NAMES[law]).unwrap();
            (s.swing.speed, s.swing.attack_angle, s.club.loft) =
                (swing.0, swing.1 * deg, loft * deg);
            // half of the drives have a centred strike and a square face
            if let Some((toe, high)) = strike {
                (
                    s.strike.toe,
                    s.strike.high,
                    s.swing.path,
                    s.swing.face_angle,
                ) = (toe, high, swing.2 * deg, swing.3 * deg);
            }
            (s.wind.right, s.wind.downrange) =
                (air.0.unwrap_or_default(), air.1.unwrap_or_default());
            (s.air.density, s.wind.roughness) = (air.2, air.3);
            (s.impact.friction, s.method) = (friction, Method::ALL[method]);
            if let Some(step) = step {
                s.flight.step = 10.0_f64.powf(step);
            }
            let ends = [
                ("aero.spin_decay", "0 1/s"),
                ("impact.restitution", "1"),
                ("impact.restitution", "0.2"),
                ("air.density", "0 kg/m^3"),
                ("impact.friction", "0"),
                ("impact.tangential_restitution", "-1"),
                ("aero.spin_damping", "0"),
            ];
            let end = end.and_then(|end| ends.get(end));
            if let Some((name, value)) = end {
                s.set(name, value).unwrap();
            }
            let all = s.variables();
            // a parameter at the end of its range is chosen more often than others
            let at_the_end = end
                .filter(|_| parameter % 2 == 0)
                .and_then(|end| all.iter().position(|row| row.name == end.0));
            (s, at_the_end.unwrap_or(parameter % all.len()))
        },
    )
}

/// A correct derivative of a usual drive passes. LONGDRIVE_DRIVES sets the number of drives
/// (docs/verification.md has the number of the largest run).
#[test]
fn differences_certify_random_derivatives_by_one_parameter() {
    let number = |name: &str| {
        std::env::var(name)
            .ok()
            .and_then(|text| text.parse::<usize>().ok())
    };
    let (first, count) = (
        number("LONGDRIVE_FIRST").unwrap_or(0),
        number("LONGDRIVE_DRIVES").unwrap_or(40),
    );
    let mut runner = TestRunner::deterministic();
    let questions: Vec<_> = (0..first + count)
        .map(|_| any_request().new_tree(&mut runner).unwrap().current())
        .collect();
    let wrong = |(i, (setup, parameter)): (usize, &(Setup<f64>, usize))| {
        let wrt = [setup.variables()[*parameter]];
        if !Drive::new(setup).is_ok_and(|drive| drive.landed().is_ok()) {
            return None;
        }
        let certificate = certificate(setup, Outcome::OF_DRIVES, &wrt);
        let law = setup.law.name();
        let wrong = (!certificate.passed()).then(|| {
            let failures = failures(&certificate).join("\n  ");
            format!(
                "question {i}, {law}, by {}: {setup:?}\n  {failures}",
                wrt[0].name
            )
        });
        let caught = certificate.planted.map(|planted| planted.caught);
        Some((wrong, caught))
    };
    let certificates: Vec<_> = questions
        .par_iter()
        .enumerate()
        .skip(first)
        .filter_map(wrong)
        .collect();
    let failed: Vec<_> = certificates
        .iter()
        .filter_map(|(wrong, _)| wrong.as_deref())
        .collect();
    assert!(
        failed.is_empty(),
        "{} of {}:\n{}",
        failed.len(),
        certificates.len(),
        failed.join("\n")
    );
    // most requests give a drive that lands, and many of the certificates find the planted errors
    assert!(certificates.len() > count / 2);
    let caught = |which: usize| {
        certificates
            .iter()
            .filter(|(_, caught)| caught[which] > 0)
            .count()
    };
    assert!(
        caught(0) > certificates.len() / 2
            && caught(1) > certificates.len() / 2
            && caught(2) > certificates.len() / 4
    );
}

/// Correct derivatives that an earlier version rejected. The lateral distance of one drive is a few
/// metres, but it has the rounding error of the carry. In other drives the error from the time step
/// changes sign between two steps, although it has the expected order.
#[test]
fn correct_derivatives_that_an_earlier_version_rejected_pass() {
    let of = [
        Outcome::Carry,
        Outcome::Lateral,
        Outcome::FlightTime,
        Outcome::ApexHeight,
    ];
    let first = [
        ("aero.law", "robinson"),
        ("club.loft", "0.22985145296472154 rad"),
        ("swing.attack_angle", "0.05275589592527663 rad"),
        ("strike.toe", "-0.01651820716397888 m"),
        ("swing.path", "-0.004477082973954577 rad"),
        ("wind.right", "3.6871200553488634 m/s"),
        ("wind.downrange", "4.054288512634912 m/s"),
    ];
    let second = [
        ("aero.law", "launch-monitor"),
        ("club.loft", "0.22965894243188126 rad"),
        ("swing.attack_angle", "-0.018652696218784827 rad"),
        ("strike.toe", "-0.007127080114314729 m"),
        ("swing.path", "-0.014956422701638855 rad"),
        ("wind.right", "2.4202074505492206 m/s"),
        ("wind.downrange", "2.631895586731229 m/s"),
    ];
    for (settings, by) in [(first, "aero.spin_decay"), (second, "wind.right")] {
        let mut setup = Setup::modern_driver();
        setup.set("flight.step", "5 ms").unwrap();
        setup.set_all(settings).unwrap();
        let certificate = certificate(&setup, &of, &[setup.variable(by).unwrap()]);
        assert!(certificate.passed(), "{:?}", failures(&certificate));
        assert!(!certificate.continuity.is_empty() && !certificate.convergence.is_empty());
    }
    // the descent angle of a parabola does not depend on gravity, so its difference quotient is
    // only the rounding error of the longest flight
    let mut vacuum = Setup::modern_driver();
    vacuum
        .set_all([
            ("air.density", "0 kg/m^3"),
            ("swing.attack_angle", "5.66 deg"),
            ("wind.right", "4 m/s"),
        ])
        .unwrap();
    let certificate = self::certificate(
        &vacuum,
        Outcome::OF_DRIVES,
        &[vacuum.variable("gravity").unwrap()],
    );
    assert!(certificate.passed(), "{:?}", failures(&certificate));
    // a spin decay of 0 is the lower bound of its range, so the differences are one-sided; in a
    // flight this high, rounding errors of the launch grow
    let mut high = Setup::modern_driver();
    let settings = [
        ("aero.law", "linear"),
        ("swing.speed", "54.26623663300731 m/s"),
        ("swing.attack_angle", "0.04973118961229366 rad"),
        ("swing.path", "0.007755377829948539 rad"),
        ("swing.face_angle", "-0.035969962288109766 rad"),
        ("strike.high", "-0.0046974743291991715 m"),
        ("strike.toe", "-0.012657799896050044 m"),
        ("club.loft", "0.2303628547330619 rad"),
        ("air.density", "1.277480847645975 kg/m^3"),
        ("wind.right", "3.751715743547275 m/s"),
        ("wind.downrange", "-4.752571984113859 m/s"),
        ("aero.spin_decay", "0 1/s"),
    ];
    high.set_all(settings).unwrap();
    let certificate = self::certificate(
        &high,
        Outcome::OF_DRIVES,
        &[high.variable("aero.spin_decay").unwrap()],
    );
    assert!(certificate.passed(), "{:?}", failures(&certificate));
    for law in Law::NAMES {
        let mut setup = Setup::modern_driver();
        setup
            .set_all([("aero.law", *law), ("aero.spin_decay", "0 1/s")])
            .unwrap();
        let certificate = self::certificate(
            &setup,
            Outcome::OF_DRIVES,
            &[setup.variable("aero.spin_decay").unwrap()],
        );
        assert!(certificate.passed(), "{law}: {:?}", failures(&certificate));
    }
}

/// A symmetric drive: flight and run move the ball sideways by 127 m and −131 m per metre of
/// off-centre strike, and nearly cancel. Near the centre of the face both are so small that their
/// rounding errors vanish. An earlier version took the rounding errors farther from the centre for
/// a remainder of order 1, or for a kink.
#[test]
fn order_of_remainders_of_two_cancelling_parts_in_any_time_step() {
    for step in ["5 ms", "10 ms", "15 ms", "20 ms", "30 ms", "50 ms"] {
        let mut setup = Setup::modern_driver();
        setup.set("flight.step", step).unwrap();
        let wrt = [setup.variable("strike.toe").unwrap()];
        let certificate = certificate(&setup, &[Outcome::Lateral, Outcome::LateralTotal], &wrt);
        assert!(certificate.passed(), "{step}: {:?}", failures(&certificate));
        for row in &certificate.rows {
            // by symmetry Taylor's series has only odd powers
            let expected = [1.0, 3.0, 3.0];
            for (slope, expected) in row.slopes.into_iter().zip(expected) {
                close(
                    slope.unwrap(),
                    expected,
                    1.0,
                    0.05,
                    &format!("{step}, {}", row.of.name()),
                );
            }
            let second = row.second.as_ref().unwrap();
            assert_eq!(
                (row.first.verdict, second.verdict),
                (Verdict::Pass, Verdict::Pass),
                "{step}: {second:?}"
            );
        }
    }
}

/// The flight has order 4, and so have its derivatives: a test for order 5 fails.
#[test]
fn order_of_the_flight_is_not_one_more() {
    let mut setup = Setup::modern_driver();
    setup
        .set_all([
            ("strike.toe", "8 mm"),
            ("wind.right", "3 m/s"),
            ("swing.path", "-2 deg"),
        ])
        .unwrap();
    setup.set_all(RIGID).unwrap();
    let of = [Outcome::Carry, Outcome::CarryDistance, Outcome::FlightTime];
    let found = certificate(&setup, &of, &[setup.variable("club.loft").unwrap()]).convergence;
    assert_eq!(found.len(), of.len());
    for outcome in found {
        assert!(
            outcome.verdict == Verdict::Pass && outcome.would_detect_higher_order == [true; 2],
            "{outcome:?}"
        );
    }
}

/// Correct drives that an earlier version rejected: the errors of successive steps have different
/// signs, because the path crosses joins of the spline of `bearman-harvey`.
#[test]
fn order_across_joins_of_a_law_is_that_of_its_continuous_derivatives() {
    type Settings = &'static [(&'static str, &'static str)];
    let drives: [(&str, &str, Settings); 6] = [
        (
            "modern-driver",
            "club.loft",
            &[("club.loft", "16.6715 deg")],
        ),
        (
            "modern-driver",
            "air.pressure",
            &[
                ("swing.speed", "109.9146 mph"),
                ("club.loft", "8.2595 deg"),
                ("air.pressure", "960.23 hPa"),
            ],
        ),
        ("tour-average", "air.humidity", &[("air.humidity", "0.964")]),
        (
            "modern-driver",
            "air.altitude",
            &[("air.altitude", "1032.85 m"), ("strike.toe", "-8.26 mm")],
        ),
        (
            "modern-driver",
            "air.humidity",
            &[
                ("swing.speed", "71.3239 mph"),
                ("swing.attack_angle", "-0.3179 deg"),
                ("club.loft", "9.5195 deg"),
                ("flight.method", "dp8"),
                ("air.humidity", "0.324"),
            ],
        ),
        (
            "lpga-average",
            "swing.speed",
            &[("swing.speed", "111.1114 mph"), ("club.loft", "6.9735 deg")],
        ),
    ];
    for (preset, by, settings) in drives {
        let mut setup = Setup::preset(preset).unwrap();
        setup.set("aero.law", "bearman-harvey").unwrap();
        setup.set_all(settings.iter().copied()).unwrap();
        let found = certificate(&setup, Outcome::OF_DRIVES, &[setup.variable(by).unwrap()]);
        assert!(found.passed(), "{preset} by {by}: {:?}", found.failures());
        assert!(
            found.convergence.iter().all(|it| it.expected == [4, 3]),
            "{preset} by {by}"
        );
        // most outcomes fail a test for the next order
        let shown = found
            .convergence
            .iter()
            .filter(|it| it.would_detect_higher_order != [false; 2])
            .count();
        assert!(shown >= 4, "{preset} by {by}: {shown}");
    }
    for law in Law::NAMES {
        let mut setup = Setup::modern_driver();
        setup
            .set_all([("aero.law", *law), ("air.altitude", "300 m")])
            .unwrap();
        let found = certificate(
            &setup,
            Outcome::OF_DRIVES,
            &[setup.variable("air.altitude").unwrap()],
        );
        assert!(found.passed(), "{law}: {:?}", found.failures());
    }
}

/// docs/model.md, eq. 17, for steps h that are shorter than the path through the lowest half metre
/// of the logarithmic wind. The errors of landing speed and angle decrease with h⁷, and with h²
/// where the error of the jerk dominates; the error of the jerk does not depend on h.
#[test]
fn order_of_landing_in_a_logarithmic_wind() {
    let mut setup = Setup::modern_driver();
    setup
        .set_all([
            ("wind.downrange", "15 m/s"),
            ("wind.right", "3 m/s"),
            ("wind.roughness", "100 mm"),
        ])
        .unwrap();
    setup.set("flight.method", "dp8").unwrap();
    let time = Outcome::FlightTime
        .of(&Drive::new(&setup).unwrap())
        .unwrap();
    let at = |steps: f64, of: Outcome| {
        let mut setup = setup;
        setup.flight.step = time / (steps - 0.5);
        of.of(&Drive::new(&setup).unwrap()).unwrap()
    };
    for of in [Outcome::LandingSpeed, Outcome::DescentAngle] {
        let exact = at(8192.0, of);
        let error = |steps: f64| (at(steps, of) - exact).abs();
        let order =
            |coarse: f64, fine: f64| (error(coarse) / error(fine)).log2() / (fine / coarse).log2();
        let (interpolated, of_the_jerk) = (order(64.0, 256.0), order(512.0, 1024.0));
        assert!(
            (6.3..7.7).contains(&interpolated),
            "{}: {interpolated}",
            of.name()
        );
        assert!(
            (1.5..3.0).contains(&of_the_jerk),
            "{}: {of_the_jerk}",
            of.name()
        );
    }
}

/// A certificate fails if the derivative by num-dual differs by a millionth. The message has both
/// numbers.
#[test]
fn disagreement_with_num_dual_fails_and_prints_both_numbers() {
    let setup = Setup::preset("mae494").unwrap();
    let mut found = certificate(
        &setup,
        &[Outcome::Carry],
        &[setup.variable("club.loft").unwrap()],
    );
    assert!(found.passed());
    let row = &mut found.rows[0];
    // num-dual and this library differentiate the same equations, so they differ only by rounding
    close(
        row.num_dual.num_dual,
        336.769746388603,
        1.0,
        1e-8,
        "num-dual",
    );
    row.num_dual = Agreement::new(row.first.exact, 336.770083, &row.ladder);
    assert!(!found.passed() && found.rows[0].verdict() == Verdict::Fail);
    assert_eq!(
        found.failures(),
        ["first derivatives by num-dual (carry by club.loft)"]
    );
    let report = CertificateReport::new(&found, &[]);
    let text = report.document(System::Us).text(&WHOLE);
    let words = on_one_line(&text);
    assert!(
        words.contains("fail (num-dual)")
            && words.contains("FAILED: first derivatives by num-dual"),
        "{words}"
    );
    assert!(
        words.contains("is 336.76974638")
            && words.contains("over the jets and 336.770083 over num-dual"),
        "{words}"
    );
    let reply = serde_json::to_value(Reply::of(&report, vec![])).unwrap();
    assert_eq!(
        (
            reply["status"].as_str(),
            reply["rows"][0]["num_dual"]["verdict"].as_str()
        ),
        (Some("failed"), Some("fail"))
    );
}

/// In a logarithmic wind, derivatives have an error from the time step. Differences of drives in
/// this step have the same error, so the certificate measures it with other steps, and reports it.
/// In still air the answer has no such error.
#[test]
fn differences_with_the_time_step_are_reported_in_a_logarithmic_wind() {
    let mut setup = Setup::modern_driver();
    let wrt = ["club.loft", "club.inertia.xx"].map(|name| setup.variable(name).unwrap());
    let of = [Outcome::Carry, Outcome::LandingSpeed];
    let still = certificate(&setup, &of, &wrt);
    assert!(
        still.passed() && still.step.iter().all(|found| found.warning().is_none()),
        "{:?}",
        still.step
    );
    assert!(
        still
            .step
            .iter()
            .all(|found| found.value_error < 1e-11 && found.derivative_error.unwrap() < 1e-7),
        "{:?}",
        still.step
    );
    let skipped = |found: &Certificate| {
        found
            .not_examined
            .iter()
            .map(|it| it.check.clone())
            .collect::<Vec<_>>()
    };
    assert_eq!(
        skipped(&still),
        [""; 0],
        "velocities have second derivatives too"
    );

    setup
        .set_all([
            ("wind.downrange", "-4 m/s"),
            ("wind.right", "2 m/s"),
            ("wind.roughness", "10 mm"),
        ])
        .unwrap();
    let windy = certificate(&setup, &of, &wrt);
    let speed = windy
        .step
        .iter()
        .find(|found| found.of == Outcome::LandingSpeed)
        .unwrap();
    assert!(
        speed.derivative_error.unwrap() > 1e-6
            && speed
                .warning()
                .unwrap()
                .to_string()
                .contains("landing_speed by club."),
        "{speed:?}"
    );
    // the expected error: from gradients in this step and in an eighth of it
    let parameter = speed.parameter.unwrap();
    let error = speed.derivative_error.unwrap();
    let slope = |step: f64| {
        let mut setup = setup;
        setup.flight.step = step;
        gradient(&setup, Outcome::LandingSpeed, &[parameter])
            .unwrap()
            .gradient[0]
    };
    let (coarse, fine) = (slope(setup.flight.step), slope(setup.flight.step / 8.0));
    close(
        error,
        ((coarse - fine) / fine).abs(),
        error,
        1e-3,
        "error of the step",
    );
    let skipped = skipped(&windy);
    assert!(
        skipped.len() == 2 && skipped[0].contains("landing") && skipped[1].contains("convergence"),
        "{skipped:?}"
    );
}

#[test]
fn differences_show_the_size_of_the_landing_term() {
    // the while-loop of the report ends at the end of a step, so its derivative is the derivative
    // at a fixed time, which has the wrong sign at an attack angle of 0°
    let setup = Setup::preset("mae494").unwrap();
    let loft = [setup.variable("club.loft").unwrap()];
    let certificate = certificate(&setup, &[Outcome::Carry], &loft);
    let carry = certificate
        .landing
        .iter()
        .find(|row| row.of == Outcome::Carry)
        .unwrap();
    close(
        carry.check.exact,
        336.77,
        1.0,
        0.01,
        "the derivative of the landing",
    );
    close(
        carry.check.exact - carry.landing_term,
        -65.0,
        1.0,
        0.5,
        "and at a fixed time",
    );
}

#[test]
fn independent_one_sided_slopes_at_the_corner_at_zero_spin() {
    // the global optimum of `mae494` is at a kink: the one-sided slopes are +83.7 and −29.7 m/rad
    let mut setup = Setup::preset("mae494").unwrap();
    setup
        .set_all([("club.loft", "0 deg"), ("swing.attack_angle", "38.53 deg")])
        .unwrap();
    let wrt = ["club.loft", "swing.speed", "ball.mass"].map(|name| setup.variable(name).unwrap());
    let certificate = certificate(
        &setup,
        &[Outcome::Carry, Outcome::Spin, Outcome::SpinAxis],
        &wrt,
    );
    let carry = |name: &str| {
        let is_it = |row: &&longdrive::study::certificate::DerivativeRow| {
            row.of == Outcome::Carry && row.parameter.name == name
        };
        certificate.rows.iter().find(is_it).unwrap()
    };
    assert_eq!(carry("club.loft").verdict(), Verdict::Corner);
    let [below, above] = carry("club.loft").first.sides.unwrap().map(Option::unwrap);
    close(below, 83.7, 1.0, 0.1, "below");
    close(above, -29.7, 1.0, 0.1, "above");
    // parameters that do not rotate the spin have no kink
    assert_eq!(carry("swing.speed").verdict(), Verdict::Pass);
    assert_eq!(carry("ball.mass").verdict(), Verdict::Pass);
    assert!(certificate.passed(), "{:?}", failures(&certificate));
    assert_eq!(certificate.corners.len(), 1);
    // without spin the axis has no direction: it is missing, with the reason
    assert_eq!(certificate.missing[0].of, Outcome::SpinAxis);
}

#[test]
fn the_limit_between_sticking_and_slipping_is_a_corner() {
    let mut setup = Setup::modern_driver();
    setup.set("impact.friction", "1").unwrap();
    let Grip::Sticks(used) = strike(&setup).unwrap().grip else {
        panic!("slips")
    };
    setup.impact.friction = Some(used);
    let friction = [setup.variable("impact.friction").unwrap()];
    let certificate = certificate(&setup, &[Outcome::Carry, Outcome::Backspin], &friction);
    for row in &certificate.rows {
        assert_eq!(
            row.verdict(),
            Verdict::Corner,
            "{}: {:?}",
            row.of.name(),
            row.first.best_difference
        );
        let [below, above] = row.first.sides.unwrap().map(Option::unwrap);
        // a higher friction limit changes nothing while the ball sticks
        assert!(
            below.abs() > 1.0 && above.abs() < 1e-6 * below.abs(),
            "{}: {below} {above}",
            row.of.name()
        );
    }
}

#[test]
fn derivatives_of_a_users_function_pass_and_errors_are_found() {
    // e^x sin y + x² y, and errors in its gradient and Hessian
    let f = |x: &[f64], in_gradient: f64, in_hessian: f64| {
        let (e, (sin, cos)) = (x[0].exp(), x[1].sin_cos());
        let cross = e * cos + 2.0 * x[0];
        Taylor {
            value: e * sin + x[0] * x[0] * x[1],
            gradient: vec![
                e * sin + 2.0 * x[0] * x[1],
                (e * cos + x[0] * x[0]) * in_gradient,
            ],
            hessian: vec![
                vec![e * sin + 2.0 * x[1], cross * in_hessian],
                vec![cross, -e * sin],
            ],
        }
    };
    let at = [0.7, 1.9];
    let right = check(&|x| Some(f(x, 1.0, 1.0)), &at, &at);
    assert!(right.passed());
    for slopes in right.slopes {
        for (slope, expected) in slopes.into_iter().zip([1.0, 2.0, 3.0]) {
            close(slope.unwrap(), expected, 1.0, 0.05, "slope");
        }
    }
    let wrong = check(&|x| Some(f(x, 1.0 + 1e-6, 1.0)), &at, &at);
    assert_eq!(
        [0, 1].map(|i| wrong.gradient[i].verdict),
        [Verdict::Pass, Verdict::Fail]
    );
    let wrong = check(&|x| Some(f(x, 1.0, 1.0 + 1e-6)), &at, &at);
    assert!(
        wrong
            .gradient
            .iter()
            .all(|check| check.verdict == Verdict::Pass)
    );
    assert_eq!(wrong.hessian[0][1].verdict, Verdict::Fail);
    // |x| has a kink at 0; a function without a value has no certificate
    let corner = check(
        &|x| {
            Some(Taylor {
                value: x[0].abs(),
                gradient: vec![0.0],
                hessian: vec![],
            })
        },
        &[0.0],
        &[1.0],
    );
    assert_eq!(
        (corner.gradient[0].verdict, corner.gradient[0].sides),
        (Verdict::Corner, Some([Some(-1.0), Some(1.0)]))
    );
    let nothing = check(&|_| None, &[1.0], &[1.0]);
    assert!(!nothing.passed());
}

#[test]
fn differences_to_one_side_certify_at_the_end_of_a_range() {
    let mut setup = Setup::modern_driver();
    setup.set("impact.restitution", "1").unwrap();
    let restitution = [setup.variable("impact.restitution").unwrap()];
    let certificate = certificate(&setup, &[Outcome::BallSpeed], &restitution);
    assert!(certificate.passed(), "{:?}", failures(&certificate));
    let exact = gradient(&setup, Outcome::BallSpeed, &restitution)
        .unwrap()
        .gradient[0];
    assert_eq!(certificate.rows[0].first.exact, exact);
    assert!(
        certificate.rows[0].first.curve.is_empty(),
        "no central differences beyond a range"
    );
}

/// At 10° of loft, a small difference of the report's loop gives a slope of −65 m/rad. The
/// derivative of carry is +337 m/rad (docs/validation.md).
#[test]
fn published_while_loop_has_derivatives_of_the_wrong_sign() {
    let setup = Setup::preset("mae494").unwrap();
    let loft = setup.variable("club.loft").unwrap();
    let certificate = certify(&setup, &[Outcome::Carry], &[loft], &|_, _| true).unwrap();
    let loops = longdrive::reproduce::while_loop(&setup, &certificate.rows);
    let [row] = &loops[..] else {
        panic!("{loops:?}")
    };
    let small = row.difference.unwrap();
    assert!(
        (small + 65.0).abs() < 1.0 && (row.check.exact - 337.0).abs() < 1.0,
        "{small}"
    );
    assert!(row.has_wrong_sign && row.check.verdict != Verdict::Pass);
    // parameters that the loop does not have are not compared
    let mut windy = setup;
    windy.set("wind.downrange", "3 m/s").unwrap();
    assert!(longdrive::reproduce::while_loop(&windy, &certificate.rows).is_empty());
}

/// The loop of the report computes the strike, which a stated launch replaces.
#[test]
fn the_while_loop_is_not_compared_with_a_stated_launch() {
    let mut setup = Setup::preset("mae494").unwrap();
    for (condition, value) in [
        ("launch.ball_speed", "70 m/s"),
        ("launch.launch_angle", "12 deg"),
        ("launch.backspin", "2600 rpm"),
    ] {
        setup.set(condition, value).unwrap();
    }
    let density = setup.variable("air.density").unwrap();
    let certificate = certify(&setup, &[Outcome::Carry], &[density], &|_, _| true).unwrap();
    assert!(!certificate.rows.is_empty());
    assert!(longdrive::reproduce::while_loop(&setup, &certificate.rows).is_empty());
}

/// At zero spin carry has a kink. Lateral has none: its first derivatives are correct, although its
/// second derivatives jump.
#[test]
fn derivatives_beside_a_corner_pass() {
    let mut setup = Setup::preset("mae494").unwrap();
    setup
        .set_all([("club.loft", "0 deg"), ("swing.attack_angle", "10 deg")])
        .unwrap();
    let wrt = ["strike.toe", "swing.path", "club.loft"].map(|name| setup.variable(name).unwrap());
    let certificate = certify(
        &setup,
        &[Outcome::Carry, Outcome::Lateral],
        &wrt,
        &|_, _| true,
    )
    .unwrap();
    for row in &certificate.rows {
        let expected = if row.of == Outcome::Carry {
            Verdict::Corner
        } else {
            Verdict::Pass
        };
        assert_eq!(
            row.verdict(),
            expected,
            "d {}/d {}",
            row.of.name(),
            row.parameter.name
        );
    }
}
