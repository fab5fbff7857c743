//! Definition of a search: objective, direction, varied parameters, constraints, and the drives to
//! evaluate.

use super::goal::{Constraint, Goal};
use super::swings::{Measure, Scenarios};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::optimize::{Domain, Options};
use crate::parameters::{Parameter, Setup, Vary};
use crate::repeated::first_repeated;
use crate::units::Message;

/// Direction of a search: the largest or the smallest value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sense {
    /// The largest.
    #[default]
    Maximize,
    /// The smallest.
    Minimize,
}

variant_names! {
    /// `maximize` or `minimize`, as on the command line and in JSON.
    Sense as "Sense" {
        Maximize = "maximize",
        Minimize = "minimize",
    }
}

impl Sense {
    /// Factor that turns the objective into a function to minimize: −1 or 1.
    pub fn sign(self) -> f64 {
        match self {
            Self::Maximize => -1.0,
            Self::Minimize => 1.0,
        }
    }

    /// `largest` or `smallest`.
    pub fn adjective(self) -> &'static str {
        match self {
            Self::Maximize => "largest",
            Self::Minimize => "smallest",
        }
    }

    /// The optimum of a goal in words: "largest carry".
    pub fn best_of(self, goal: &Goal) -> String {
        format!("{} {}", self.adjective(), goal.expression)
    }

    /// Warning that the best value of a goal with a side, such as `lateral`, is the value farthest
    /// to one side.
    pub(super) fn side_warning(self, goal: &Goal) -> Option<Message> {
        // a value of one drive, or the mean over the swings
        let [(weight, Measure::Mean(of))] = goal.terms.as_slice() else {
            return None;
        };
        if !of.is_to_the_right() {
            return None;
        }
        // the sign is negative for the largest value
        let is_right = self.sign() * weight < 0.0;
        let side = if is_right { "right" } else { "left" };
        let text = format!(
            "the {} is farthest to the {side}, not nearest to 0; to end at 0, choose another goal, \
             such as carry, and add `subject_to \"{} == 0 {}\"`",
            self.best_of(goal),
            goal.expression,
            of.unit()
        );
        Some(text.into())
    }
}

/// A search for the best drive, or for the best design over swings that vary.
///
/// ```text
///   maximize   of(drives of x)                   x: the varied parameters
///   subject to low ≤ x ≤ high
///              low ≤ goal(drives of x) ≤ high    for each constraint
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Search {
    /// The objective: an outcome of one drive, or measures over swings.
    pub of: Goal,
    /// The direction.
    pub sense: Sense,
    /// The varied parameters, with their ranges.
    pub vary: Vec<Vary>,
    /// The constraints.
    pub subject_to: Vec<Constraint>,
    /// Drives to evaluate: [one drive](Scenarios::one_drive), or the drives of a golfer's swings.
    pub scenarios: Scenarios,
    /// Settings of the optimizer.
    pub options: Options,
}

impl Search {
    /// Search for the largest value of an outcome of one drive; no parameter is varied yet.
    pub fn largest(of: Outcome) -> Self {
        Self {
            of: of.into(),
            sense: Sense::Maximize,
            vary: vec![],
            subject_to: vec![],
            scenarios: Scenarios::one_drive(),
            options: Options::default(),
        }
    }

    /// Search for the longest carry over loft 4–20° and attack angle −5…+5°.
    ///
    /// # Errors
    /// [`Error::NotVariable`] if the setup gives the launch of the ball, so that there is no club
    /// to vary.
    pub fn longest_drive(setup: &Setup<f64>) -> Result<Self> {
        let vary = ["club.loft=4deg..20deg", "swing.attack_angle=-5deg..5deg"];
        Ok(Self {
            vary: Vary::read_all(setup, vary)?,
            ..Self::largest(Outcome::Carry)
        })
    }

    /// The varied parameters.
    pub fn parameters(&self) -> impl Iterator<Item = &'static Parameter> {
        self.vary.iter().map(|vary| vary.parameter)
    }

    /// The objective, then the limited goals.
    pub fn goals(&self) -> impl Iterator<Item = &Goal> {
        let limited = self.subject_to.iter().map(|constraint| &constraint.goal);
        std::iter::once(&self.of).chain(limited)
    }

    /// Outcomes that the goals need, in the order of the goals.
    pub fn outcomes(&self) -> Vec<Outcome> {
        self.goals().flat_map(Goal::outcomes).collect()
    }

    /// The first outcome in the objective. For one drive, it usually is the objective.
    /// [`Outcome::Carry`] if the objective contains no outcome.
    pub fn outcome(&self) -> Outcome {
        // only an objective that was not parsed from text has no outcome
        self.of
            .outcomes()
            .first()
            .copied()
            .unwrap_or(Outcome::Carry)
    }

    /// Refuses a search that a study of one drive cannot treat.
    ///
    /// # Errors
    /// [`Error::Unreadable`] for a search over swings, and for a goal that is not a single outcome.
    pub fn refuse_swings(&self) -> Result<()> {
        if self.is_of_outcomes() {
            return Ok(());
        }
        let why = match self.scenarios.is_one_drive() {
            true => "a goal is not a single outcome",
            false => "it is over swings that vary",
        };
        let source =
            format!("{why}; this study needs an outcome of one drive, and constraints on outcomes");
        let name = format!("the search for {}", self.of.expression);
        Err(Error::unreadable(name, source))
    }

    /// True if every goal is an outcome of one drive.
    pub(super) fn is_of_outcomes(&self) -> bool {
        self.scenarios.is_one_drive() && self.goals().all(|goal| goal.outcome().is_some())
    }

    /// The ranges of the parameters and the limits of the constraints.
    ///
    /// # Errors
    /// [`Error::SearchRange`] for ranges or limits that are reversed or not numbers.
    pub(super) fn domain(&self) -> Result<Domain> {
        self.vary.iter().try_for_each(Vary::check)?;
        self.subject_to.iter().try_for_each(Constraint::check)?;
        let (low, high) = self.vary.iter().map(|vary| (vary.low, vary.high)).unzip();
        let limits = self.subject_to.iter();
        let (least, most) = limits.map(|limit| (limit.low, limit.high)).unzip();
        Domain::new(low, high)?.with_constraints(least, most)
    }

    /// Refuses a search without a parameter to vary, and a search that varies a parameter twice.
    ///
    /// # Errors
    /// [`Error::Nothing`] without a parameter to vary; [`Error::SearchRange`] for a repeated
    /// parameter.
    pub(super) fn check(&self) -> Result<()> {
        if self.vary.iter().all(|vary| vary.low == vary.high) {
            return Err(Error::Nothing {
                doing: "vary",
                what: "parameter with a range wider than a single value, as in \
                       `vary club.loft=4deg..20deg`",
            });
        }
        let is_same = |a: &Vary, b: &Vary| a.parameter == b.parameter;
        match first_repeated(&self.vary, is_same) {
            Some([_, again]) => Err(Error::SearchRange {
                name: self.vary[again].parameter.name.into(),
                reason: "it is varied twice; give it one range".into(),
            }),
            None => Ok(()),
        }
    }
}
