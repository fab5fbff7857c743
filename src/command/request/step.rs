//! Integration method and step of a request: those of the setup, or chosen for a tolerance or for
//! many drives.

use super::Request;
use crate::command::args::SetupArgs;
use crate::command::files::Destination;
use crate::command::output::{note, warn, warn_early};
use crate::integration::{Integration, StepChoice, of_the_flight};
use crate::parameters::{Vary, idle_warnings, is_of_step};
use crate::report::CommentedSetup;
use crate::units::{Quantity, counted};
use crate::{Error, Outcome, Result, Setup};
use std::collections::BTreeSet;
use std::sync::atomic::AtomicBool;

impl SetupArgs {
    /// The choice of method and step.
    ///
    /// # Errors
    /// If the value of `--tolerance` is not a positive length.
    pub fn step(&self) -> Result<StepChoice> {
        Ok(match &self.tolerance {
            Some(text) => StepChoice::Within(read_tolerance(text)?),
            None if self.own_step => StepChoice::Own,
            None => StepChoice::Micrometre,
        })
    }
}

/// The setups at the low and at the high ends of these ranges. If an end is not an allowed value,
/// as the values of a table may be, the setup keeps its own value.
fn ends(setup: &Setup<f64>, ranges: &[Vary]) -> [Setup<f64>; 2] {
    let ends: [fn(&Vary) -> f64; 2] = [|vary| vary.low, |vary| vary.high];
    ends.map(|end| {
        let mut there = *setup;
        for vary in ranges {
            let _ = there.set_value(vary.parameter, Some(end(vary)));
        }
        there
    })
}

/// Warns of those of the parameters `names` that have no effect in any of these setups.
pub fn warn_of_idle<'a>(names: impl IntoIterator<Item = &'a str>, setups: &[Setup<f64>]) {
    idle_warnings(names, setups)
        .into_iter()
        .for_each(warn_early);
}

impl Request {
    /// The setup of a single drive, with an integration step for `--tolerance`. Without this
    /// option, the step is unchanged. Warns of given values that have no effect.
    ///
    /// # Errors
    /// The errors of [`setup`](Self::setup) and [`integration`](Self::integration).
    pub fn setup_within_tolerance(&self) -> Result<Setup<f64>> {
        warn_of_idle(self.given(), &[self.setup()?]);
        self.one_of_two_within_tolerance()
    }

    /// Like [`setup_within_tolerance`](Self::setup_within_tolerance), for one of two drives to
    /// compare. Does not warn of values without an effect on this drive: they may have an effect on
    /// the other drive.
    ///
    /// # Errors
    /// The errors of [`setup`](Self::setup) and [`integration`](Self::integration).
    pub fn one_of_two_within_tolerance(&self) -> Result<Setup<f64>> {
        let setup = self.setup()?;
        match self.step {
            StepChoice::Within(_) => {
                let found = self.integration(&setup, &[], &of_the_flight())?;
                Ok(found.setup)
            }
            StepChoice::Micrometre | StepChoice::Own => Ok(setup),
        }
    }

    /// The setup with method and step for many drives whose parameters are in these ranges. Warns
    /// of given and of varied values that have no effect.
    ///
    /// # Errors
    /// The errors of [`integration`](Self::integration).
    pub fn for_many(&self, setup: Setup<f64>, ranges: &[Vary]) -> Result<Setup<f64>> {
        self.warn_of_idle_in(&setup, ranges);
        self.stepped(setup, ranges)
    }

    /// Like [`for_many`](Self::for_many), for one of several models. Does not warn of values without
    /// an effect on this model.
    ///
    /// # Errors
    /// The errors of [`integration`](Self::integration).
    pub fn stepped(&self, setup: Setup<f64>, ranges: &[Vary]) -> Result<Setup<f64>> {
        let begun = Vary::initialized(&setup, ranges)?;
        let found = self.integration(&begun, ranges, &of_the_flight())?;
        let accuracy = found.accuracy;
        Ok(accuracy.map_or(setup, |accuracy| accuracy.applied_to(&setup)))
    }

    /// Method and step for drives whose parameters are in these ranges. The error of a length is
    /// within `--tolerance`, or within one micrometre without this option. The method and step of
    /// the setup are kept with `--own-step`. They are also kept if the setup states one of them and
    /// neither option is given.
    ///
    /// # Errors
    /// [`Error::Tolerance`] if no step is fine enough, and [`Error::Unreadable`] if a setting
    /// states method or step, which `--tolerance` chooses.
    pub fn integration(
        &self,
        setup: &Setup<f64>,
        ranges: &[Vary],
        of: &[Outcome],
    ) -> Result<Integration> {
        let is_within = self.is_within_tolerance();
        let mut settings = self.settings.iter();
        let stated = settings.find(|setting| is_of_step(&setting.parameter));
        if let Some(setting) = stated.filter(|_| is_within) {
            let source = format!(
                "it chooses method and step, and {} states one of them; leave out one of these \
                 options",
                setting.named()
            );
            return Err(Error::unreadable("`tolerance`", source));
        }
        let stop = AtomicBool::new(false);
        let found = self.step.for_ranges(setup, ranges, of, &stop)?;
        if let Some(warning) = &found.warning {
            warn_early(warning.clone());
        }
        if let Some(found) = found.accuracy.filter(|_| is_within) {
            note(&format!(
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

    /// Warns of the setup at both ends of these ranges.
    pub fn warn_of_ranges(&self, setup: &Setup<f64>, ranges: &[Vary]) {
        let [mut warnings, at_high] = ends(setup, ranges).map(|end| end.warnings());
        let further = at_high.into_iter();
        let further: Vec<_> = further.filter(|one| !warnings.contains(one)).collect();
        warnings.extend(further);
        warn(warnings);
    }

    /// Warns of those given and varied values that have no effect at either end of these ranges.
    pub fn warn_of_idle_in(&self, setup: &Setup<f64>, ranges: &[Vary]) {
        let varied = ranges.iter().map(|vary| vary.parameter.name);
        let names: BTreeSet<_> = self.given().chain(varied).collect();
        warn_of_idle(names, &ends(setup, ranges));
    }

    fn is_within_tolerance(&self) -> bool {
        matches!(self.step, StepChoice::Within(_))
    }

    /// Writes a setup into a file, and returns the name of the file.
    ///
    /// # Errors
    /// If the setup cannot be written.
    pub fn write_setup(&self, output: &Destination, mut written: CommentedSetup) -> Result<String> {
        let source = &self.source.content;
        if self.is_within_tolerance() && source.setup.states_step {
            // the method and the step for `--tolerance` are valid only for the drives of this
            // command
            written.setup.method = source.setup.method;
            written.setup.flight.step = source.setup.flight.step;
        }
        output.write(written.toml(source)?.as_bytes())?;
        Ok(output.shown.display().to_string())
    }
}

/// Reads the length of `--tolerance`, m.
fn read_tolerance(text: &str) -> Result<f64> {
    let tolerance = Quantity::LENGTH
        .read(text)
        .map_err(|error| Error::unreadable("`tolerance`", error))?;
    if tolerance > 0.0 && tolerance.is_finite() {
        return Ok(tolerance);
    }
    let source = format!("\"{text}\" is no tolerance; give a length above 0, for example 1um");
    Err(Error::unreadable("`tolerance`", source))
}
