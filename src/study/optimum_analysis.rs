//! The analysis of an optimum: its sensitivities, its flatness, and the effects of changes.

use super::flatness::{Flatness, Window};
use super::gain::ClubAlone;
use super::sensitivity::{Changed, Sensitivity};
use crate::error::Result;
use crate::parameters::Parameter;

/// The analysis of an optimum.
#[derive(Debug)]
pub struct OptimumAnalysis {
    /// The sensitivity of the optimum to each parameter, or the reason why it does not exist.
    pub sensitivities: Vec<(&'static Parameter, Result<Sensitivity>)>,
    /// The flatness of the objective around the optimum.
    pub flatness: Flatness,
    /// The effects of stated changes.
    pub changes: Vec<Changed>,
}

impl OptimumAnalysis {
    /// True if a sensitivity exists, or if none was requested.
    pub fn is_answered(&self) -> bool {
        let mut all = self.sensitivities.iter();
        self.sensitivities.is_empty() || all.any(|(_, sensitivity)| sensitivity.is_ok())
    }
}

impl Flatness {
    /// The windows of the varied parameters, with the optimum of the club alone, if it is known.
    pub fn windows_with<'a>(&'a self, club_alone: Option<&'a ClubAlone>) -> OptimumWindows<'a> {
        OptimumWindows {
            loss: self.loss,
            windows: &self.windows,
            club_alone,
        }
    }
}

/// The windows of an optimum of a single drive, and the optimum of the club alone.
#[derive(Clone, Copy, Debug)]
pub struct OptimumWindows<'a> {
    /// The allowed loss, SI.
    pub loss: f64,
    /// For each varied parameter: the range in which the drive loses at most `loss` while the other
    /// parameters stay at the optimum.
    pub windows: &'a [Window],
    /// The best value that club and ball achieve with the swing as set up; `None` if the search
    /// does not vary both club and swing, or if this value is unknown.
    pub club_alone: Option<&'a ClubAlone>,
}
