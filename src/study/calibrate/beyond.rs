//! Measured shots beyond what the law was fitted to, or struck beside any face.

use super::residuals::at_shot;
use super::shot::Shot;
use crate::drive::{CheckScope, Drive, ExceededCount};
use crate::parameters::Setup;
use crate::study::stoppable::{NOT_LOOKED_AT, each_until};
use crate::units::Message;
use std::sync::atomic::AtomicBool;

/// Warnings about shots, flown with a setup: how many of them are outside of what the model is made
/// for; those that do not land are not counted. Once `stop` is true, that they were not looked at.
pub fn beyond(setup: &Setup<f64>, shots: &[Shot], stop: &AtomicBool) -> Vec<Message> {
    let looked_at = |shot: &Shot| {
        let setup = at_shot(setup, shot).ok()?;
        let drive = Drive::new(&setup).ok()?;
        let of: Vec<_> = shot
            .measured
            .iter()
            .map(|measurement| measurement.outcome)
            .collect();
        drive
            .landed()
            .is_ok()
            .then(|| drive.exceeded_limits(&setup, CheckScope::Flight, &of))
    };
    let mut count = ExceededCount::default();
    let Some(drives) = each_until(shots, stop, looked_at) else {
        return vec![NOT_LOOKED_AT.into()];
    };
    drives
        .into_iter()
        .flatten()
        .for_each(|drive| count.add(drive));
    count.warnings(&setup.law, ["shot", "shots"], CheckScope::Flight)
}
