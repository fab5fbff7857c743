//! Integration method and step of a request: stated, for a tolerance, or chosen for many drives.

use super::Request;
use super::setting::{Setting, bad_tolerance, is_of_step};
use crate::command::output::{tell, warn_early};
use crate::parameters::Vary;
use crate::report::{setup_toml, with_step_of, without_step};
use crate::study::{Accuracy, accuracy};
use crate::units::{Message, counted};
use crate::{Error, Outcome, Result, Setup};

/// Default tolerance of commands with many drives, m.
const MICROMETRE: f64 = 1e-6;

impl Request {
    /// The setup with a step for `--tolerance`; unchanged without this option.
    ///
    /// # Errors
    /// [`Error::Tolerance`] if no step is fine enough; if a setting states method or step too.
    pub fn within_tolerance(&self, setup: Setup<f64>) -> Result<Setup<f64>> {
        Ok(self
            .accuracy_of_tolerance(&setup, &[], &of_the_flight())?
            .map_or(setup, |found| found.applied_to(&setup)))
    }

    /// The setup with a step for many drives whose parameters are in these ranges.
    ///
    /// # Errors
    /// The errors of [`within_tolerance`](Self::within_tolerance).
    pub fn for_many(&self, setup: Setup<f64>, ranges: &[Vary]) -> Result<Setup<f64>> {
        let begun = Vary::initialised(&setup, ranges)?;
        Ok(self
            .accuracy_for_many(&begun, ranges, &of_the_flight())?
            .map_or(setup, |found| found.applied_to(&setup)))
    }

    /// Method and step for many drives. The tolerance is `--tolerance`, or one micrometre; `None`
    /// if `flight.method` and `flight.step` of the setup apply.
    ///
    /// # Errors
    /// The errors of [`within_tolerance`](Self::within_tolerance).
    pub fn accuracy_for_many(
        &self,
        setup: &Setup<f64>,
        ranges: &[Vary],
        of: &[Outcome],
    ) -> Result<Option<Accuracy>> {
        if self.tolerance.is_some() || !self.chooses_step() {
            return self.accuracy_of_tolerance(setup, ranges, of);
        }
        match accuracy(setup, ranges, of, MICROMETRE) {
            Err(Error::Tolerance { reason, .. }) => {
                warn_early(Message::from(format!(
                    "flown with flight.method = {} and flight.step = {} s of the setup, since no \
                     step is within 1 um: {reason}",
                    setup.method.name(),
                    setup.flight.step
                )));
                Ok(None)
            }
            found => none_without_flight(found),
        }
    }

    fn accuracy_of_tolerance(
        &self,
        setup: &Setup<f64>,
        ranges: &[Vary],
        of: &[Outcome],
    ) -> Result<Option<Accuracy>> {
        let Some(tolerance) = self.tolerance else {
            return Ok(None);
        };
        if let Some(setting) = self.setting_of_step() {
            return Err(bad_tolerance(format!(
                "it chooses method and step, and {} states one of them; leave out one of these \
                 options",
                setting.named()
            )));
        }
        let found = none_without_flight(accuracy(setup, ranges, of, tolerance))?;
        if let Some(found) = found {
            tell(&format!(
                "method {} with a step of {:.4} s: lengths are within {:.1e} m of their exact \
                 values in the {} checked",
                found.method.name(),
                found.step,
                found.error,
                counted(found.drives as u64, "drive")
            ));
        }
        Ok(found)
    }

    /// Returns true if the command chooses method and step, because neither `--own-step`, a setting
    /// nor the setup states them.
    fn chooses_step(&self) -> bool {
        !self.own_step && self.setting_of_step().is_none() && !self.source.gives_step()
    }

    /// The text of a setup file for other commands. It has method and step only if the user stated
    /// them: an automatically chosen step is valid only for the drives of this command.
    ///
    /// # Errors
    /// If the setup cannot be written.
    pub fn with_stated_step(&self, toml: String) -> Result<String> {
        if self.chooses_step() {
            return Ok(without_step(&toml));
        }
        if self.tolerance.is_none() {
            return Ok(toml);
        }
        let stated = setup_toml(self.source.setup(), self.source.preset(), &[], &[])?;
        Ok(with_step_of(&stated, &toml))
    }

    /// The first setting of flight.method or flight.step.
    fn setting_of_step(&self) -> Option<&Setting> {
        let mut settings = self.stated.iter();
        settings.find(|setting| is_of_step(&setting.parameter))
    }
}

/// All outcomes except those of the roll-out, whose step error is unknown.
fn of_the_flight() -> Vec<Outcome> {
    Outcome::ALL
        .iter()
        .copied()
        .filter(|of| !of.needs_run())
        .collect()
}

/// `None` if no drive lands, so that there is no error to limit.
fn none_without_flight(found: Result<Accuracy>) -> Result<Option<Accuracy>> {
    match found {
        Err(Error::NoFlight { .. }) => Ok(None),
        found => found.map(Some),
    }
}
