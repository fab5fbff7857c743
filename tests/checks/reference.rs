//! Values, gradients, Hessians and optima compared with `data/reference_drives.json`, which was
//! computed independently of this project and checked there to 34 digits; the file prints 12.

use crate::common::{close, drives, number, outcome_of, setup_of};
use longdrive::flight::Flight;
use longdrive::impact::Grip;
use longdrive::number::Vector;
use longdrive::{Drive, Outcome, derivative};
use serde_json::Value;

fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().map(f64::abs).fold(0.0, f64::max)
}

#[test]
fn independent_values_of_every_outcome() {
    for drive in drives("reference_drives.json") {
        let name = drive["name"].as_str().unwrap();
        let ours = Drive::new(&setup_of(&drive)).unwrap();
        let theirs = &drive["outcomes"];
        assert!(matches!(ours.flight, Flight::Landed(_)) && theirs["status"] == "landed");
        assert_eq!(
            matches!(ours.impact.unwrap().grip, Grip::Slips(_)),
            theirs["slipped"].as_bool().unwrap(),
            "{name}"
        );
        for outcome in Outcome::OF_DRIVES {
            let expected = outcome_of(&drive, *outcome);
            let what = format!("{name}: {}", outcome.name());
            match outcome {
                // +π and −π are the same direction, and without spin the axis has no direction
                Outcome::SpinAxis if number(&theirs["spin"]) > 1e-6 => {
                    let value = outcome.value(&ours).unwrap();
                    close((value - expected).sin(), 0.0, 1.0, 1e-10, &what);
                    close(value.cos(), expected.cos(), 1.0, 1e-10, &what);
                }
                Outcome::SpinAxis => {}
                _ => close(
                    outcome.value(&ours).unwrap(),
                    expected,
                    expected.abs().max(1e-3),
                    1e-9,
                    &what,
                ),
            }
        }
        let impact = &ours.impact.unwrap();
        for (key, vector) in [
            ("ball_velocity", impact.launch.velocity),
            ("ball_spin", impact.launch.spin),
            ("club_velocity_after", impact.club_velocity),
            ("club_spin_after", impact.club_spin),
            ("impulse", impact.impulse),
            ("face_normal", impact.face_normal),
            ("contact_point", impact.contact_point),
        ] {
            let expected = Vector::from_array([0, 1, 2].map(|i| number(&theirs[key][i])));
            let (error, size) = ((vector - expected).norm(), expected.norm().max(1e-2));
            assert!(
                error <= 1e-10 * size,
                "{name}: {key} {vector:?} against {expected:?}"
            );
        }
    }
}

#[test]
fn independent_gradients_by_every_parameter() {
    for drive in drives("reference_drives.json") {
        let setup = setup_of(&drive);
        for of in [Outcome::Carry, Outcome::Lateral] {
            let theirs = drive["gradient"][of.name()].as_object().unwrap();
            let wrt: Vec<_> = theirs
                .keys()
                .map(|name| setup.variable(name).unwrap())
                .collect();
            let ours = derivative::gradient(&setup, of, &wrt).unwrap();
            for (parameter, derivative) in wrt.iter().zip(ours.gradient) {
                let expected = number(&theirs[parameter.name]);
                // the error is relative to the derivative, or to 1e-4 · outcome / parameter if that
                // is larger
                let change = setup.value(parameter).unwrap().abs().max(1e-3);
                let scale = expected
                    .abs()
                    .max(1e-4 * ours.value.abs().max(1.0) / change);
                close(
                    derivative,
                    expected,
                    scale,
                    1e-8,
                    &format!("{}: d {}/d {}", drive["name"], of.name(), parameter.name),
                );
            }
        }
    }
}

#[test]
fn independent_hessians_by_loft_and_attack_angle() {
    for drive in drives("reference_drives.json") {
        let setup = setup_of(&drive);
        let wrt = ["club.loft", "swing.attack_angle"].map(|name| setup.variable(name).unwrap());
        for of in [Outcome::Carry, Outcome::Lateral] {
            let Value::Array(theirs) = &drive[format!("hessian_{}_loft_attack", of.name())] else {
                continue;
            };
            let theirs: Vec<Vec<f64>> = theirs
                .iter()
                .map(|row| row.as_array().unwrap().iter().map(number).collect())
                .collect();
            let ours = derivative::hessian(&setup, of, &wrt).unwrap().hessian;
            let scale = largest(theirs.concat()).max(1.0);
            for (ours, theirs) in ours.concat().into_iter().zip(theirs.concat()) {
                close(
                    ours,
                    theirs,
                    scale,
                    1e-8,
                    &format!("{}: Hessian of {}", drive["name"], of.name()),
                );
            }
        }
    }
}
