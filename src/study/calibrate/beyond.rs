//! Measured shots beyond what the law was fitted to, or struck beside any face.

use super::residuals::at_shot;
use super::shot::Shot;
use crate::drive::{BeyondCount, Drive, Looked};
use crate::error::Result;
use crate::flight::fly;
use crate::parameters::Setup;

/// How many shots, flown with a setup, lie beyond; those that do not land are not counted.
pub fn beyond(setup: &Setup<f64>, shots: &[Shot]) -> BeyondCount {
    let mut count = BeyondCount::default();
    for shot in shots {
        if let Ok((setup, drive)) = flown(setup, shot)
            && drive.landed().is_ok()
        {
            count.add(drive.beyond(&setup, Looked::AtFlight));
        }
    }
    count
}

/// A shot as it was struck or launched, with its setup.
fn flown(setup: &Setup<f64>, shot: &Shot) -> Result<(Setup<f64>, Drive<f64>)> {
    let setup = at_shot(setup, shot)?;
    let drive = match shot.launch {
        Some(launch) => Drive { launch, impact: None, flight: fly(&setup, &launch)?, club_speed: None },
        None => Drive::new(&setup)?,
    };
    Ok((setup, drive))
}
