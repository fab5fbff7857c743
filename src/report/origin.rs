//! The first line of an answer: its preset or setup file, with the changed parameters.

use super::document::{Document, Line};
use super::shown;
use crate::parameters::{Parameter, Setup};
use crate::units::System;

/// The setup that an answer is about. The text of an answer begins with it; the JSON has it as
/// `from`.
#[derive(Clone, Debug, Default)]
pub struct SetupOrigin {
    /// The preset or file, followed by the settings and swings of the request: "tour-average,
    /// swing.speed=95mph". Empty if the answer itself names its setups.
    pub title: String,
    /// False if the request does not name the setup, as with a setup from standard input.
    pub has_name: bool,
    /// Parameters that a search would vary by default, but keeps at the values that the request
    /// states.
    pub held: Vec<(&'static Parameter, f64)>,
    /// Advice on the setup; empty if there is none.
    pub advice: String,
}

impl SetupOrigin {
    /// Sets `self.held` to the parameters `held` with their values in the setup.
    #[must_use]
    pub fn with_held(self, held: &[&'static Parameter], setup: &Setup<f64>) -> Self {
        let held = held
            .iter()
            .filter_map(|parameter| Some((*parameter, setup.value(parameter)?)))
            .collect();
        Self { held, ..self }
    }

    /// Appends a text about more that the request states, such as its swings, to the title.
    #[must_use]
    pub fn with_stated(self, stated: &str) -> Self {
        let title = self.title + stated;
        Self { title, ..self }
    }

    /// Puts the setup before the other lines of an answer.
    pub fn put_before(&self, document: &mut Document, system: System) {
        if self.title.is_empty() {
            return;
        }
        let held: Vec<_> = self
            .held
            .iter()
            .map(|(parameter, value)| {
                let value = shown::stated(parameter, *value, system);
                format!("{} {value}", parameter.name)
            })
            .collect();
        let lines = [
            Some(format!("from {}", self.title)),
            (!held.is_empty()).then(|| format!("held, as stated: {}", held.join(", "))),
            (!self.advice.is_empty()).then(|| self.advice.clone()),
        ];
        document.put_first(lines.into_iter().flatten().map(Line::flush));
    }
}
