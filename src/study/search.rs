//! What to look for: an outcome as large or as small as possible, the parameters to vary, and what
//! is held meanwhile.

use super::constraint::Constraint;
use crate::drive::Outcome;
use crate::error::Result;
use crate::optimize::Options;
use crate::parameters::{Setup, Vary};

/// Whether the largest or the smallest value of an outcome is looked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sense {
    /// The largest.
    #[default]
    Maximize,
    /// The smallest.
    Minimize,
}

impl Sense {
    /// What an outcome is multiplied by to be minimised: −1 or 1.
    pub fn sign(self) -> f64 {
        match self {
            Self::Maximize => -1.0,
            Self::Minimize => 1.0,
        }
    }

    /// `maximize` or `minimize`, as on the command line and in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::Maximize => "maximize",
            Self::Minimize => "minimize",
        }
    }

    /// `largest` or `smallest`.
    pub fn adjective(self) -> &'static str {
        match self {
            Self::Maximize => "largest",
            Self::Minimize => "smallest",
        }
    }
}

/// What to look for.
#[derive(Clone, Debug, PartialEq)]
pub struct Search {
    /// The outcome to make as large or as small as possible.
    pub of: Outcome,
    /// Which of the two.
    pub sense: Sense,
    /// The parameters to vary.
    pub vary: Vec<Vary>,
    /// Outcomes to hold between limits.
    pub subject_to: Vec<Constraint>,
    /// The optimizer's settings.
    pub options: Options,
}

impl Search {
    /// The largest value of an outcome, with nothing varied yet.
    pub fn largest(of: Outcome) -> Self {
        let (sense, options) = (Sense::Maximize, Options::default());
        Self {
            of,
            sense,
            vary: vec![],
            subject_to: vec![],
            options,
        }
    }

    /// The outcomes that it asks for: the one sought, then those that are held within limits.
    pub fn outcomes(&self) -> Vec<Outcome> {
        std::iter::once(self.of)
            .chain(self.subject_to.iter().map(|constraint| constraint.outcome))
            .collect()
    }

    /// The longest carry over loft 4–20° and attack angle −5…+5°.
    ///
    /// # Errors
    /// [`Error::NotVariable`](crate::Error::NotVariable) where the setup gives the launch of the
    /// ball: then there is no club to vary.
    pub fn longest_drive(setup: &Setup<f64>) -> Result<Self> {
        let vary = ["club.loft=4deg..20deg", "swing.attack_angle=-5deg..5deg"];
        let vary = vary
            .iter()
            .map(|text| Vary::read(setup, text))
            .collect::<Result<_>>()?;
        Ok(Self {
            vary,
            ..Self::largest(Outcome::Carry)
        })
    }
}
