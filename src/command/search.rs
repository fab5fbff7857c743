//! The search that several commands begin with: who follows it and keeps it.

use crate::command::args::{SearchArgs, WorkArgs};
use crate::command::interrupt::{self, BEST_SO_FAR};
use crate::command::names::tell_of_the_run;
use crate::command::output::{bar_of, system, tell};
use crate::command::running::running;
use crate::optimize::{Checkpoint, Follow, Iteration, Options};
use crate::report::{iteration_line, outcome_text};
use crate::study::{Constraint, Optima, Search, Sense, Vary, optima};
use crate::{Error, Outcome, Result, Setup};
use indicatif::ProgressBar;
use std::sync::{Arc, Mutex, PoisonError};

impl SearchArgs {
    /// What is looked for.
    pub fn search(&self, setup: &Setup<f64>) -> Result<Search> {
        let vary = match self.vary.as_slice() {
            [] if setup.launch.is_given() => {
                let source = "the drive is given by its launch, so there is no loft and no attack \
                              angle to vary; give what to vary of the \
                              launch, for example `vary launch.launch_angle=5deg..20deg`";
                return Err(Error::Unreadable {
                    name: "`vary`".into(),
                    source: source.into(),
                });
            }
            [] => Search::longest_drive(setup)?.vary,
            given => given
                .iter()
                .map(|text| Vary::read(setup, text))
                .collect::<Result<_>>()?,
        };
        let (of, sense) = self.sought()?;
        let options = Options::default();
        let search = Search {
            of,
            sense,
            vary,
            subject_to: self
                .subject_to
                .iter()
                .map(|text| Constraint::read(text))
                .collect::<Result<_>>()?,
            options: Options {
                max_iterations: self.max_iterations.unwrap_or(options.max_iterations),
                ..options
            },
        };
        tell_of_the_run(&search.outcomes());
        Ok(search)
    }

    /// The outcome that is looked at, and which value of it is sought.
    pub fn sought(&self) -> Result<(Outcome, Sense)> {
        Ok(match (&self.maximize, &self.minimize) {
            (_, Some(of)) => (of_a_drive("`minimize`", of)?, Sense::Minimize),
            (Some(of), None) => (of_a_drive("`maximize`", of)?, Sense::Maximize),
            (None, None) => (Outcome::Carry, Sense::Maximize),
        })
    }

    /// The options that were given.
    pub fn given(&self) -> Vec<&'static str> {
        let given = [
            ("`maximize`", self.maximize.is_some()),
            ("`minimize`", self.minimize.is_some()),
            ("`vary`", !self.vary.is_empty()),
            ("`subject_to`", !self.subject_to.is_empty()),
            ("`max_iterations`", self.max_iterations.is_some()),
        ];
        given
            .into_iter()
            .filter(|(_, is_given)| *is_given)
            .map(|(name, _)| name)
            .collect()
    }
}

impl WorkArgs {
    /// Searches, with its progress on standard error.
    pub fn run(&self, setup: &Setup<f64>, search: &Search) -> Result<Optima> {
        let checkpoint = match &self.checkpoint {
            Some(path) => Some(Arc::new(Checkpoint::open(
                path,
                &question(setup, search, self.starts),
            )?)),
            None => None,
        };
        let mut follow = Follow {
            interrupt: interrupt::stops(BEST_SO_FAR),
            checkpoint,
            ..Follow::default()
        };
        let (of, sense, system) = (search.of, search.sense, system());
        let bar = match self.starts {
            1 => one(search, &mut follow),
            _ => self.many(&mut follow, move |value| {
                outcome_text(of, sense.sign() * value, system)
            }),
        };
        let found = optima(setup, search, self.starts as usize, &follow);
        bar.finish_and_clear();
        interrupt::ends();
        if let Ok(optima) = &found
            && let Some(interrupted) = optima.interrupted()
        {
            tell(&interrupted);
        }
        found
    }

    /// A bar of the searches that have ended, with the best value so far as `show` has what is
    /// minimized.
    pub fn many(
        &self,
        follow: &mut Follow,
        show: impl Fn(f64) -> String + Send + Sync + 'static,
    ) -> ProgressBar {
        let bar = bar_of(
            u64::from(self.starts),
            "{bar:40} {pos}/{len} searches, {eta} left, best {msg}",
        );
        let best: Mutex<Option<f64>> = Mutex::new(None);
        let shown = bar.clone();
        follow.end = Some(Arc::new(move |_, solution| {
            let mut best = best.lock().unwrap_or_else(PoisonError::into_inner);
            let is_feasible = solution.residual.feasibility <= 1e-6;
            *best = [*best, solution.value.filter(|_| is_feasible)]
                .into_iter()
                .flatten()
                .reduce(f64::min);
            shown.set_message(best.map_or("–".into(), &show));
            shown.inc(1);
        }));
        bar
    }
}

/// The outcome of one drive that an option asks for; what is asked of many swings needs these.
pub fn of_a_drive(option: &str, text: &str) -> Result<Outcome> {
    Outcome::named(text.trim()).map_err(|error| match text.contains('(') {
        true => {
            let source = format!(
                "{text} is of many swings; give these too, with `swings FILE` or \
                         `distribution NAME=KIND(…)`"
            );
            Error::Unreadable {
                name: option.into(),
                source: source.into(),
            }
        }
        false => error,
    })
}

/// The question in words that tell it from any other: every number of the setup and the search is
/// in their debug form, to the last digit. More iterations make no other question.
fn question(setup: &Setup<f64>, search: &Search, starts: u32) -> String {
    let options = Options {
        max_iterations: 0,
        ..search.options.clone()
    };
    let search = Search {
        options,
        ..search.clone()
    };
    format!("{setup:?} {search:?} {starts}")
}

/// Every iteration as a line.
fn one(search: &Search, follow: &mut Follow) -> ProgressBar {
    let (shown, running) = (search.clone(), running());
    let line = move |_, iteration: &Iteration| {
        running.tell(&iteration_line(&shown, iteration, running.system()))
    };
    follow.iteration = Some(Arc::new(line));
    ProgressBar::hidden()
}
