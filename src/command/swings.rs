//! The drives of a search: one drive, or the swings of a golfer.

use crate::command::args::{SwingsArgs, stated};
use crate::command::output::{note, note_each, system};
use crate::command::ranges::{SearchRanges, loft, loft_and_attack_angle};
use crate::command::request::Request;
use crate::parameters::Vary;
use crate::report::computed_text;
use crate::study::swings::{Correlation, Rule, Scenarios, Strokes, Swings};
use crate::study::uncertainty::Uncertain;
use crate::study::{Constraint, Goal};
use crate::{Error, Outcome, Result, Setup};
use std::path::PathBuf;

/// The drives of a search: one drive, or many swings.
pub struct SearchedDrives {
    /// The setup, with a value for each parameter that varies from swing to swing.
    pub setup: Setup<f64>,
    /// The swings; `None` for one drive.
    pub swings: Option<Swings>,
    /// The options of the swings; all are unset for one drive.
    pub args: SwingsArgs,
    /// The table of expected strokes, if one is given.
    strokes: Option<Strokes>,
    /// True if the command resamples recorded swings.
    is_resampled: bool,
}

impl SearchedDrives {
    /// One drive: the setup of the request.
    pub fn one(request: &Request) -> Self {
        Self {
            setup: request.partial_setup,
            swings: None,
            args: SwingsArgs::default(),
            strokes: None,
            is_resampled: false,
        }
    }

    /// The ranges of `--vary` (`given`), or the default ranges of a search over these drives.
    ///
    /// # Errors
    /// The errors of [`SearchRanges::new`].
    pub fn ranges(&self, given: &[String], request: &Request) -> Result<SearchRanges> {
        let defaults = match self.swings {
            Some(_) => loft,
            None => loft_and_attack_angle,
        };
        SearchRanges::new(given, request, self.setup, None, defaults)
    }

    /// The goal to maximize by default.
    pub fn default_goal(&self) -> Goal {
        match self.swings {
            Some(_) => Goal::mean(Outcome::Carry),
            None => Outcome::Carry.into(),
        }
    }

    /// The goal in `text`, the value of the option `option`.
    ///
    /// # Errors
    /// The errors of [`of_a_drive`] and of [`Goal::read`].
    pub fn goal(&self, option: &str, text: &str) -> Result<Goal> {
        match self.swings {
            Some(_) => goal(option, text, self.strokes.as_ref()),
            None => Ok(of_a_drive(option, text)?.into()),
        }
    }

    /// The constraints of a search for the objectives `of`. Over swings, a constraint limits a goal
    /// or an expression of parameters.
    ///
    /// # Errors
    /// [`Error::Constraint`]; [`Error::Unreadable`] for a table of strokes that neither an
    /// objective nor a constraint uses.
    pub fn limits<const N: usize>(
        &self,
        setup: &Setup<f64>,
        texts: &[String],
        of: [&Goal; N],
    ) -> Result<Vec<Constraint>> {
        let strokes = self.strokes.as_ref();
        let read = |text: &String| match self.swings {
            None => Constraint::read(text),
            Some(_) if Constraint::is_relation(text) => Constraint::read_relation(setup, text),
            Some(_) => Constraint::read_over_swings(text, strokes),
        };
        let limits = texts.iter().map(read).collect::<Result<Vec<_>>>()?;
        let goals = of.into_iter().chain(limits.iter().map(|limit| &limit.goal));
        refuse_unused_strokes(strokes, goals, "`minimize \"strokes(400yd)\"`")?;
        Ok(limits)
    }

    /// The scenarios for all goals of a search.
    ///
    /// # Errors
    /// The errors of [`SwingsArgs::scenarios`].
    pub fn scenarios<'a>(&self, goals: impl IntoIterator<Item = &'a Goal>) -> Result<Scenarios> {
        match &self.swings {
            Some(swings) => self.args.scenarios(swings, goals, self.is_resampled),
            None => Ok(Scenarios::one_drive()),
        }
    }
}

impl SwingsArgs {
    /// True if swings are given, by a file or by distributions.
    pub fn is_given(&self) -> bool {
        self.swings.is_some() || !self.distribution.is_empty()
    }

    /// Refuses options about swings if no swings are given.
    ///
    /// # Errors
    /// [`Error::Unreadable`], which names the option.
    pub fn refuse_stray(&self) -> Result<()> {
        let options = [
            ("`correlation`", !self.correlation.is_empty()),
            ("`scenarios`", self.scenarios.is_some()),
            ("`seed`", self.seed.is_some()),
            ("`strokes`", self.strokes.is_some()),
        ];
        match stated(options).next().filter(|_| !self.is_given()) {
            Some(option) => {
                let source = "it is about many swings; give the swings too, with `swings FILE` or \
                              `distribution NAME=KIND(…)`";
                Err(Error::unreadable(option, source))
            }
            None => Ok(()),
        }
    }

    /// The drives of a request. `is_resampled` is true if the command resamples recorded swings.
    ///
    /// # Errors
    /// The errors of [`swings_of`](Self::swings_of) and of [`drives_over`](Self::drives_over).
    pub(super) fn drives(&self, request: &Request, is_resampled: bool) -> Result<SearchedDrives> {
        if !self.is_given() {
            return Ok(SearchedDrives::one(request));
        }
        self.drives_over(self.swings_of(request)?, request, is_resampled)
    }

    /// Reads the swings of a request. Refuses settings of the parameters that vary between the
    /// swings.
    pub(super) fn swings_of(&self, request: &Request) -> Result<Swings> {
        let swings = self.read(&request.partial_setup)?;
        request
            .refuse_stated_besides_launch(&swings.parameters(), "the swings have values of it")?;
        Ok(swings)
    }

    /// These swings, with a setup that has their means.
    pub(super) fn drives_over(
        &self,
        swings: Swings,
        request: &Request,
        is_resampled: bool,
    ) -> Result<SearchedDrives> {
        note_replaced(request, &swings);
        let setup = request.fill_missing(
            request.partial_setup,
            swings.parameters().into_iter().zip(swings.means()),
            "varies about",
        )?;
        Ok(SearchedDrives {
            setup,
            swings: Some(swings),
            args: self.clone(),
            strokes: self.strokes()?,
            is_resampled,
        })
    }

    /// The scenarios of swings for all goals of a search. Refuses a seed that has no effect:
    /// recorded swings use a seed only if they are resampled.
    ///
    /// # Errors
    /// The errors of [`Rule::of`], [`Rule::refuse_idle_seed`] and [`Scenarios::new`].
    pub fn scenarios<'a>(
        &self,
        swings: &Swings,
        goals: impl IntoIterator<Item = &'a Goal>,
        is_resampled: bool,
    ) -> Result<Scenarios> {
        let rule = Rule::of(swings, goals, self.scenarios, self.seed.unwrap_or(0))?;
        if !(is_resampled && rule == Rule::Recorded) {
            rule.refuse_idle_seed(self.seed)?;
        }
        Scenarios::new(swings, rule)
    }

    /// Parses a goal. `name` and `text` are the argument and its value; `example`, for the message,
    /// is an argument with a goal that uses strokes.
    ///
    /// # Errors
    /// [`Error::Unreadable`] for a text that is no goal, and for a table of strokes that the goal
    /// does not use; the errors of [`Strokes::open`].
    pub fn goal(&self, name: &str, text: &str, example: &str) -> Result<Goal> {
        let strokes = self.strokes()?;
        let goal = goal(name, text, strokes.as_ref())?;
        refuse_unused_strokes(strokes.as_ref(), [&goal], example)?;
        Ok(goal)
    }

    /// The table of expected strokes, if one is given.
    fn strokes(&self) -> Result<Option<Strokes>> {
        self.strokes
            .as_ref()
            .map(|file| Strokes::open(file, false))
            .transpose()
    }

    /// The end of the title of an answer: ", swings golfer.csv", or the distributions and
    /// correlations, each after a comma. Empty without swings.
    pub(super) fn end_of_title(&self) -> String {
        let file = self.swings.iter();
        let file = file.map(|file| format!(", swings {}", file.display()));
        let texts = self.distribution.iter().chain(&self.correlation);
        file.chain(texts.map(|text| format!(", {text}"))).collect()
    }

    /// The files that these options read.
    pub(super) fn inputs(&self) -> impl Iterator<Item = PathBuf> {
        self.swings.iter().chain(&self.strokes).cloned()
    }

    /// The swings of the file, or of the distributions and correlations.
    ///
    /// # Errors
    /// [`Error::Unreadable`] for a file beside distributions or correlations, and for swings of
    /// launch conditions if `setup` is no launch; the errors of [`Swings::open`],
    /// [`Uncertain::read`], [`Correlation::read`] and [`Swings::distributed`].
    pub fn read(&self, setup: &Setup<f64>) -> Result<Swings> {
        let swings = self.read_any(setup)?;
        let mut parameters = swings.parameters().into_iter();
        match parameters.find(|parameter| parameter.is_of_launch()) {
            Some(condition) if !setup.launch.is_given() => {
                let source = "it is a quantity of the ball, but swings have parameters of swing \
                              and strike; `delivery()` with `shots` finds the swings behind \
                              launches; or give a whole launch with `launch`";
                Err(Error::unreadable(condition.name, source))
            }
            _ => Ok(swings),
        }
    }

    fn read_any(&self, setup: &Setup<f64>) -> Result<Swings> {
        if let Some(file) = &self.swings {
            if let Some(option) = self
                .distribution
                .first()
                .map(|_| "`distribution`")
                .or(self.correlation.first().map(|_| "`correlation`"))
            {
                let source = format!(
                    "{} gives the swings; write it into that file, or leave `swings` out",
                    file.display()
                );
                return Err(Error::unreadable(option, source));
            }
            let swings = Swings::open(setup, file)?;
            if let Swings::Recorded { remarks, .. } = &swings {
                note_each(file.display(), remarks);
            }
            return Ok(swings);
        }
        let inputs = self
            .distribution
            .iter()
            .map(|text| Uncertain::read(setup, text))
            .collect::<Result<Vec<_>>>()?;
        let correlations = self
            .correlation
            .iter()
            .map(|text| Correlation::read(setup, text))
            .collect::<Result<Vec<_>>>()?;
        Swings::distributed(inputs, &correlations)
    }
}

/// Prints a note on parameters of the setup file whose values differ from the means of the swings.
/// The swings replace the values of the setup file.
fn note_replaced(request: &Request, swings: &Swings) {
    let setup = &request.partial_setup;
    let means = swings.parameters().into_iter().zip(swings.means());
    let replaced: Vec<_> = means
        .filter(|(parameter, _)| request.source.content.given.contains(parameter))
        .filter_map(|(parameter, mean)| {
            let [own, mean] = [setup.value(parameter)?, mean]
                .map(|value| computed_text(parameter, value, system()));
            (own != mean).then(|| format!("{} {mean} (in the setup {own})", parameter.name))
        })
        .collect();
    if !replaced.is_empty() {
        let replaced = replaced.join(", ");
        note(&format!(
            "the swings replace values of {}; their means: {replaced}",
            request.source.name()
        ));
    }
}

/// Refuses a table of strokes that none of the goals uses. `example` is an argument with a goal
/// that uses strokes.
fn refuse_unused_strokes<'a>(
    strokes: Option<&Strokes>,
    goals: impl IntoIterator<Item = &'a Goal>,
    example: &str,
) -> Result<()> {
    let is_used = goals
        .into_iter()
        .any(|goal| goal.strokes().next().is_some());
    if strokes.is_none() || is_used {
        return Ok(());
    }
    let source = format!("no goal uses strokes; write for example {example}, or leave it out");
    Err(Error::unreadable("`strokes`", source))
}

/// The goal in `text`, the value of the option `option`. An error shows the position of the fault
/// in `text`.
fn goal(option: &str, text: &str, strokes: Option<&Strokes>) -> Result<Goal> {
    Goal::read(text, strokes).map_err(|error| match error {
        Error::Constraint {
            expression,
            column,
            reason,
        } => {
            let source = format!("{reason}\n  {expression}\n  {}^", " ".repeat(column));
            Error::unreadable(option, source)
        }
        error => error,
    })
}

/// The outcome that `text`, the value of `option`, names. A goal over many swings is an error,
/// because it needs a distribution of swings.
pub fn of_a_drive(option: &str, text: &str) -> Result<Outcome> {
    Outcome::named(text.trim()).map_err(|error| match text.contains('(') {
        true => {
            let source = format!(
                "{text} is a goal over many swings; give the swings too, with `swings FILE` or \
                 `distribution NAME=KIND(…)`"
            );
            Error::unreadable(option, source)
        }
        false => error,
    })
}

/// The ranges of all drives in a search: the ranges of the varied parameters, and the ranges of the
/// parameters that differ between the swings.
pub fn swing_ranges(vary: &[Vary], scenarios: &Scenarios) -> Vec<Vary> {
    let vary = vary.iter().copied();
    vary.chain(scenarios.ranges()).collect()
}
