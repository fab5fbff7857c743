use super::unknown::Unknown;
use super::untold::Untold;
use crate::optimize::least_squares::Status;
use crate::parameters::Setup;
use crate::study::calibrate::Measurement;

/// What is known of a parameter after the shot, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Known {
    /// What was known before.
    pub unknown: Unknown,
    /// The most probable value.
    pub value: f64,
    /// Its standard uncertainty; `None` where a bound holds it.
    pub sigma: Option<f64>,
    /// What part of the variance before the shot has removed, 0 to 1: 1 where the launch tells all,
    /// 0 where it tells nothing. `None` where a bound holds it.
    pub told: Option<f64>,
}

/// A measured outcome beside the one computed of the delivery, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Explained {
    /// What was measured.
    pub measured: Measurement,
    /// What the delivery gives.
    pub computed: f64,
}

impl Explained {
    /// Computed − measured, in units of the standard uncertainty of the measurement.
    pub fn residual(&self) -> f64 {
        let Measurement {
            outcome,
            value,
            sigma,
        } = self.measured;
        (outcome.unwrap_angle(self.computed, value) - value) / sigma
    }
}

/// A measured outcome that is off by more than this, in units of its standard uncertainty, is not
/// explained.
const EXPLAINED_WITHIN: f64 = 3.0;

/// The delivery that explains a launch.
#[derive(Clone, Debug)]
pub struct Delivered {
    /// The setup with it.
    pub setup: Setup<f64>,
    /// How the search ended.
    pub status: Status,
    /// The same in a sentence.
    pub message: String,
    /// Each parameter that was sought.
    pub known: Vec<Known>,
    /// Each measured outcome.
    pub explained: Vec<Explained>,
    /// The derivatives of each measured outcome by each parameter, in units of the outcome's
    /// standard uncertainty, at the delivery found.
    pub jacobian: Vec<Vec<f64>>,
    /// Changes of several parameters together that the launch does not tell, the least told first.
    pub untold: Vec<Untold>,
}

impl Delivered {
    /// The measured outcome that is off by most, where that is too much: no delivery within the
    /// ranges gives this launch.
    pub fn unexplained(&self) -> Option<&Explained> {
        let worst = self
            .explained
            .iter()
            .max_by(|a, b| a.residual().abs().total_cmp(&b.residual().abs()));
        worst.filter(|worst| worst.residual().abs() > EXPLAINED_WITHIN)
    }

    /// Whether a search that converged explains the launch.
    pub fn is_found(&self) -> bool {
        self.status == Status::Converged && self.unexplained().is_none()
    }
}
