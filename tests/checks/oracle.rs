//! Outcomes, their derivatives by every parameter, and Hessians by six parameters, compared with
//! `data/independent_drives.json`. `oracle/oracle.cpp`, which shares no code with longdrive,
//! computed these drives in quadruple precision. They cover the laws of drag and lift, the laws of
//! spin decay, a logarithmic wind, slip, light and heavy heads, hills, and spins near zero.

use crate::common::{close, drives, gradient_of, number, outcome_of, setup_of};
use longdrive::derivative::{Order, evaluate};
use longdrive::impact::Grip;
use longdrive::parameters::Parameter;
use longdrive::{Drive, Outcome, Setup};
use serde_json::Value;

const FILE: &str = "independent_drives.json";

/// Tolerance of a derivative, relative to its size. Its terms may cancel, so the size counts as at
/// least `floor` times outcome / parameter.
///
/// `floor` is 0.01 for smooth drives. Drives that are less smooth within a step have the tolerance
/// [`ROUGH`] and a `floor` of 1. In a logarithmic wind the wind speed varies fast in the lowest
/// half metre. In the drives named "falls through", the law has a discontinuous third derivative at
/// a spin ratio on the path.
struct DerivativeTolerance {
    tolerance: f64,
    floor: f64,
}

const ROUGH: f64 = 1e-5;

impl DerivativeTolerance {
    fn of(drive: &Value, smooth: f64) -> Self {
        let rough = !drive["setup"]["wind.roughness"].is_null()
            || drive["name"].as_str().unwrap().contains("falls through");
        if rough {
            Self {
                tolerance: ROUGH,
                floor: 1.0,
            }
        } else {
            Self {
                tolerance: smooth,
                floor: 0.01,
            }
        }
    }

    #[track_caller]
    fn compare(&self, ours: f64, theirs: f64, per_parameters: f64, what: &str) {
        close(
            ours,
            theirs,
            theirs.abs().max(self.floor * per_parameters),
            self.tolerance,
            what,
        );
    }
}

/// Absolute value of a parameter, at least 0.1 in SI: scales the derivatives by this parameter.
fn size(setup: &Setup<f64>, parameter: &Parameter) -> f64 {
    setup.value(parameter).unwrap().abs().max(0.1)
}

#[test]
fn independent_values_within_1e9() {
    for drive in drives(FILE) {
        let ours = Drive::new(&setup_of(&drive)).unwrap();
        assert_eq!(
            matches!(ours.impact.unwrap().grip, Grip::Slips(_)),
            drive["outcomes"]["slipped"].as_bool().unwrap()
        );
        for outcome in Outcome::OF_DRIVES {
            let expected = outcome_of(&drive, *outcome);
            let what = format!("{}: {}", drive["name"], outcome.name());
            close(
                outcome.value(&ours).unwrap(),
                expected,
                expected.abs().max(1e-3),
                1e-9,
                &what,
            );
        }
    }
}

#[test]
fn independent_gradients_of_every_outcome_by_every_parameter_within_1e8() {
    for drive in drives(FILE) {
        let setup = setup_of(&drive);
        for outcome in Outcome::OF_DRIVES {
            let theirs = gradient_of(&drive, *outcome);
            let wrt: Vec<_> = theirs
                .keys()
                .map(|name| setup.variable(name).unwrap())
                .collect();
            let ours = &evaluate(&setup, &[*outcome], &wrt, Order::First).unwrap()[0];
            for (parameter, slope) in wrt.iter().zip(&ours.gradient) {
                let expected = theirs[parameter.name];
                let what = format!(
                    "{}: d {}/d {}",
                    drive["name"],
                    outcome.name(),
                    parameter.name
                );
                DerivativeTolerance::of(&drive, 1e-8).compare(
                    *slope,
                    expected,
                    ours.value.abs().max(1.0) / size(&setup, parameter),
                    &what,
                );
            }
        }
    }
}

#[test]
fn independent_hessians_over_six_parameters_within_1e7() {
    for drive in drives(FILE) {
        let setup = setup_of(&drive);
        let names: Vec<_> = drive["hessian"]["names"]
            .as_array()
            .unwrap()
            .iter()
            .map(|name| name.as_str().unwrap())
            .collect();
        let wrt: Vec<_> = names
            .iter()
            .map(|name| setup.variable(name).unwrap())
            .collect();
        let outcomes = [
            Outcome::Carry,
            Outcome::Lateral,
            Outcome::ApexHeight,
            Outcome::FlightTime,
        ];
        for (outcome, ours) in outcomes
            .iter()
            .zip(evaluate(&setup, &outcomes, &wrt, Order::Second).unwrap())
        {
            for i in 0..wrt.len() {
                for j in 0..wrt.len() {
                    let expected = number(&drive["hessian"][outcome.name()][i][j]);
                    let per_parameters =
                        ours.value.abs().max(1.0) / (size(&setup, wrt[i]) * size(&setup, wrt[j]));
                    let what = format!(
                        "{}: d² {}/d {} d {}",
                        drive["name"],
                        outcome.name(),
                        names[i],
                        names[j]
                    );
                    DerivativeTolerance::of(&drive, 1e-7).compare(
                        ours.hessian[i][j],
                        expected,
                        per_parameters,
                        &what,
                    );
                }
            }
        }
    }
}
