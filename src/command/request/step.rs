//! Integration method and step of a request: stated, for a tolerance, or chosen for many drives.

use super::Request;
use crate::command::output::{tell, warn_early};
use crate::integration::{Accuracy, StepChoice, of_the_flight};
use crate::parameters::{Vary, is_of_step};
use crate::report::{setup_toml, with_step_of};
use crate::units::counted;
use crate::{Error, Outcome, Result, Setup};
use std::sync::atomic::AtomicBool;

impl Request {
    /// The setup with a step for `--tolerance`; unchanged without this option.
    ///
    /// # Errors
    /// [`Error::Tolerance`] if no step is fine enough, and [`Error::Unreadable`] if a setting
    /// states method or step, which `--tolerance` chooses.
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

    /// Method and step for many drives, for the tolerance of `--tolerance`, or for one micrometre
    /// without this option. `None` if `flight.method` and `flight.step` of the setup apply.
    ///
    /// # Errors
    /// The errors of [`within_tolerance`](Self::within_tolerance).
    pub fn accuracy_for_many(
        &self,
        setup: &Setup<f64>,
        ranges: &[Vary],
        of: &[Outcome],
    ) -> Result<Option<Accuracy>> {
        if self.tolerance.is_some() {
            return self.accuracy_of_tolerance(setup, ranges, of);
        }
        let choice = if self.own_step {
            StepChoice::Own
        } else {
            StepChoice::Micrometre
        };
        let found = choice.for_ranges(setup, ranges, of, &AtomicBool::new(false))?;
        if let Some(warning) = found.warning {
            warn_early(warning);
        }
        Ok(found.accuracy)
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
        let mut settings = self.settings.iter();
        if let Some(setting) = settings.find(|setting| is_of_step(&setting.parameter)) {
            let source = format!(
                "it chooses method and step, and {} states one of them; leave out one of these \
                 options",
                setting.named()
            );
            return Err(Error::unreadable("`tolerance`", source));
        }
        let choice = StepChoice::Within(tolerance);
        let found = choice.for_ranges(setup, ranges, of, &AtomicBool::new(false))?;
        let found = found.accuracy;
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

    /// The text of a setup file for other commands. If the user stated method or step, the text has
    /// the stated values. The values for `--tolerance` are valid only for the drives of this
    /// command.
    ///
    /// # Errors
    /// If the setup cannot be written.
    pub fn with_stated_step(&self, toml: String) -> Result<String> {
        if self.tolerance.is_none() || !self.source.setup().states_step {
            return Ok(toml);
        }
        let stated = setup_toml(self.source.setup(), self.source.preset(), &[], &[])?;
        Ok(with_step_of(&stated, &toml))
    }
}
