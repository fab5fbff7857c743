//! Measured shots beyond what the law was fitted to, or struck beside any face.

use super::residuals::at_shot;
use super::shot::Shot;
use crate::drive::{BeyondCount, Drive, Looked};
use crate::parameters::Setup;

/// How many shots, flown with a setup, lie beyond; those that do not land are not counted.
pub fn beyond(setup: &Setup<f64>, shots: &[Shot]) -> BeyondCount {
    let mut count = BeyondCount::default();
    for shot in shots {
        if let Ok(setup) = at_shot(setup, shot)
            && let Ok(drive) = Drive::new(&setup)
            && drive.landed().is_ok()
        {
            let of: Vec<_> = shot.measured.iter().map(|measurement| measurement.outcome).collect();
            count.add(drive.beyond(&setup, Looked::AtFlight, &of));
        }
    }
    count
}
