use super::cases::Case;
use super::compared::Compared;
use super::sets::{Computation, Set};
use crate::derivative;
use crate::drive::{Drive, Outcome};
use crate::error::Result;
use crate::optimize::Observer;
use crate::parameters::{Law, Method, Setup, Vary};
use crate::study::{Search, optimum};
use crate::units::{DEGREE, MPH, RPM};
use std::collections::HashMap;

/// The compared quantities of a case, SI, computed with a law. If the case does not state its air,
/// the air is that of sea level at `temperature` (25 °C by default). A quantity is missing if the
/// ball does not fly, or if no optimum was found.
pub(super) fn predicted(
    set: &Set,
    case: &Case,
    base: Option<&Case>,
    law: Law<f64>,
    temperature: Option<f64>,
) -> Result<HashMap<Compared, f64>> {
    let mut setup = match set.preset.or(case.preset.as_deref()) {
        Some(preset) => Setup::preset(preset)?,
        None => Setup::modern_driver(),
    };
    // the preset may have other coefficients than the published ones
    setup.law = law;
    // error of carry with this step: 1 µm; for the laws in pieces, 4 µm (`usga-itr`) and 40 µm
    // (`nathan`)
    (setup.method, setup.flight.step) = (Method::DormandPrince8, 0.1);
    let setup = in_air_of(case, setup, temperature);
    let found = match set.computation {
        Computation::Launch => Drive::new(&launched(setup, case)).map_or(vec![], |drive| {
            let of = [
                (Compared::Carry, Outcome::CarryDistance),
                (Compared::Apex, Outcome::ApexHeight),
                (Compared::Descent, Outcome::DescentAngle),
            ];
            quantities_of(&drive, of)
        }),
        Computation::Altitude | Computation::AltitudeAlone => base.map_or(vec![], |base| {
            let from = if set.computation == Computation::Altitude {
                case
            } else {
                base
            };
            let below = in_air_of(base, setup, temperature);
            let carry = |setup, case| {
                let drive = Drive::new(&launched(setup, case)).ok()?;
                Outcome::CarryDistance.value(&drive)
            };
            let gain = carry(setup, from)
                .zip(carry(below, base))
                .map(|(there, here)| there - here);
            gain.map(|gain| (Compared::Gain, gain))
                .into_iter()
                .collect()
        }),
        Computation::FaceToPath => curve_of(setup, case)
            .map(|curve| (Compared::Curve, curve))
            .into_iter()
            .collect(),
        Computation::Optimum => at_best_loft(setup, case)?,
    };
    Ok(found.into_iter().collect())
}

fn in_air_of(case: &Case, mut setup: Setup<f64>, temperature: Option<f64>) -> Setup<f64> {
    match case.density {
        Some(density) => setup.air.density = density,
        None => setup.air.temperature = temperature,
    }
    setup
}

/// The setup with the published launch.
fn launched(mut setup: Setup<f64>, case: &Case) -> Setup<f64> {
    (
        setup.launch.ball_speed,
        setup.launch.launch_angle,
        setup.launch.spin,
    ) = (case.ball_speed, case.launch_angle, case.spin);
    setup
}

/// Assumed standard deviations, SI, of drives about the published average: ball speed 5.5 mph,
/// launch angle 2°, spin 400 rpm, spin axis 9°, and wind 4 m/s from any direction.
pub const SCATTER: [(&str, f64); 6] = [
    ("launch.ball_speed", 5.5 * MPH),
    ("launch.launch_angle", 2.0 * DEGREE),
    ("launch.spin", 400.0 * RPM),
    ("launch.spin_axis", 9.0 * DEGREE),
    ("wind.right", 4.0 * std::f64::consts::FRAC_1_SQRT_2),
    ("wind.downrange", 4.0 * std::f64::consts::FRAC_1_SQRT_2),
];

/// Mean carry, m, of drives scattered by [`SCATTER`], minus the carry of the average launch. To
/// second order, this is half the sum of second derivative × variance. `None` if the derivatives do
/// not exist.
pub(super) fn mean_carry_change_by_scatter(case: &Case, law: Law<f64>) -> Option<f64> {
    let mut setup = launched(in_air_of(case, Setup::modern_driver(), None), case);
    setup.law = law;
    setup.launch.spin_axis = Some(0.0);
    let wrt: Option<Vec<_>> = SCATTER
        .iter()
        .map(|(name, _)| setup.variable(name).ok())
        .collect();
    let carry = derivative::hessian(&setup, Outcome::CarryDistance, &wrt?).ok()?;
    Some(
        SCATTER
            .iter()
            .enumerate()
            .map(|(i, (_, sigma))| 0.5 * carry.hessian[i][i] * sigma * sigma)
            .sum(),
    )
}

/// Lateral distance of the landing point from the initial direction, m, + right.
fn curve_of(mut setup: Setup<f64>, case: &Case) -> Option<f64> {
    setup.swing.face_angle = case.face_to_path?;
    let drive = Drive::new(&setup).ok()?;
    let [carry, lateral, direction] =
        [Outcome::Carry, Outcome::Lateral, Outcome::LaunchDirection].map(|of| of.value(&drive));
    let (sin, cos) = direction?.sin_cos();
    Some(lateral? * cos - carry? * sin)
}

/// Quantities of the drive at the loft of longest carry.
fn at_best_loft(mut setup: Setup<f64>, case: &Case) -> Result<Vec<(Compared, f64)>> {
    if let (Some(speed), Some(attack)) = (case.club_speed, case.attack_angle) {
        (setup.swing.speed, setup.swing.attack_angle) = (speed, attack);
    }
    let vary = vec![Vary::read(&setup, "club.loft=0deg..30deg")?];
    let search = Search {
        vary,
        ..Search::largest(Outcome::CarryDistance)
    };
    let found = optimum(&setup, search, Observer::default())?;
    let drive = found.drive.filter(|_| found.is_converged());
    let of = [
        (Compared::Carry, Outcome::CarryDistance),
        (Compared::LaunchAngle, Outcome::LaunchAngle),
        (Compared::Spin, Outcome::Spin),
    ];
    Ok(drive.map_or(vec![], |drive| quantities_of(&drive, of)))
}

fn quantities_of(drive: &Drive<f64>, of: [(Compared, Outcome); 3]) -> Vec<(Compared, f64)> {
    of.into_iter()
        .filter_map(|(compared, outcome)| Some((compared, outcome.value(drive)?)))
        .collect()
}
