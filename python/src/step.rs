//! Method and step of a batch, chosen as in `longdrive sweep`.

use crate::boundary::{Answer, Failure, text_of};
use crate::setup::PySetup;
use longdrive::parameters::Vary;
use longdrive::study::{Accuracy, accuracy};
use longdrive::units::Quantity;
use longdrive::{Error, Outcome};
use pyo3::prelude::*;
use pyo3::types::PyString;

/// The default tolerance, m.
const MICROMETRE: f64 = 1e-6;

/// The choice of method and step.
#[derive(Clone, Copy)]
pub enum Asked {
    /// The largest error of a length, m.
    Within(f64),
    /// A micrometre, unless the setup states method or step, or no step is that exact.
    Usual,
    /// Method and step of the setup.
    Own,
}

impl Asked {
    /// The choice that the arguments `tolerance` and `own_step` make.
    pub fn of(tolerance: Option<&Bound<'_, PyAny>>, own_step: bool) -> Answer<Self> {
        let Some(given) = tolerance else {
            return Ok(if own_step { Self::Own } else { Self::Usual });
        };
        if own_step {
            return Err(Failure::Input(
                "tolerance and own_step are both given; keep one of the two".into(),
            ));
        }
        if let Ok(text) = given.cast::<PyString>() {
            let read = Quantity::LENGTH.read(text_of("tolerance", text)?);
            return read
                .map(Self::Within)
                .map_err(|error| Failure::Input(format!("tolerance: {error}")));
        }
        let refuse = |_| {
            Failure::Input(format!(
                "tolerance = {given}; expected a length, in m or as a text like \"1 um\""
            ))
        };
        given.extract().map(Self::Within).map_err(refuse)
    }

    /// Returns true if the step is known without computing drives.
    pub fn is_known(self, setup: &PySetup) -> bool {
        matches!(self, Self::Own) || (matches!(self, Self::Usual) && setup.gives_step)
    }

    /// The step for a setup whose parameters lie in these ranges, with a warning; `None` for the
    /// setup's own step.
    pub fn found(
        self,
        setup: &PySetup,
        ranges: &[Vary],
        of: &[Outcome],
    ) -> longdrive::Result<(Option<Accuracy>, Option<String>)> {
        let (tolerance, is_asked) = match self {
            Self::Own => return Ok((None, None)),
            Self::Usual if setup.gives_step => return Ok((None, None)),
            Self::Usual => (MICROMETRE, false),
            Self::Within(tolerance) => (tolerance, true),
        };
        match accuracy(&setup.setup, ranges, of, tolerance) {
            Ok(found) => Ok((Some(found), None)),
            // no drive lands: any step is exact enough
            Err(Error::NoFlight { .. }) => Ok((None, None)),
            Err(Error::Tolerance { reason, .. }) if !is_asked => Ok((
                None,
                Some(format!(
                    "flown with flight.method = {} and flight.step = {} s of the setup, since no \
                     step is within 1 um: {reason}",
                    setup.setup.method.name(),
                    setup.setup.flight.step
                )),
            )),
            Err(error) => Err(error),
        }
    }
}
