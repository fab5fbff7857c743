//! Searches, with their progress and checkpoints.

use crate::command::args::{OptimumArgs, SearchArgs, stated};
use crate::command::files::{Destination, OutputRule};
use crate::command::host::{Progress, Work};
use crate::command::interrupt::{self, BEST_SO_FAR};
use crate::command::names::note_the_run;
use crate::command::output::{note, shown, system, warn};
use crate::command::ranges::{SearchRanges, loft_and_attack_angle};
use crate::command::request::Request;
use crate::command::running::running;
use crate::command::swings::SearchedDrives;
use crate::lock::lock;
use crate::optimize::{Checkpoint, Iteration, Observer, Observers, Options};
use crate::parameters::Vary;
use crate::report::{SetupOrigin, goal_text, iteration_line, optimum_setup};
use crate::study::swings::{Scenarios, Swings};
use crate::study::{
    Goal, Optima, Optimum, Search, Sense, improve_from_club_alone, optima, optimum,
};
use crate::units::Quantity;
use crate::{Error, Result, Setup};
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex};

/// A search as a request states it.
pub struct SearchRequest<S = Search> {
    /// The setup of the request. It is the drive as set up: a varied parameter may have no value.
    pub setup: Setup<f64>,
    pub search: S,
    /// The description of the setup for the first lines of the answer.
    pub origin: SetupOrigin,
}

impl SearchRequest {
    /// The optimum from one start, or from the optimum of the club alone if that is better. Shows
    /// no progress and cannot be interrupted.
    ///
    /// # Errors
    /// The errors of [`optimum`] and [`improve_from_club_alone`].
    pub fn optimum(&self) -> Result<Optimum> {
        let mut best = optimum(&self.setup, self.search.clone(), Observer::default())?;
        improve_from_club_alone(&mut best)?;
        Ok(best)
    }
}

impl SearchArgs {
    /// The search for the optimum of one drive, with method and step for its drives. By default it
    /// varies loft and attack angle, except for a parameter that the request states. With the
    /// parameter `along` of a chart and its range, the search does not vary this parameter by
    /// default, and the setup has method and step for the whole range. `instead` is advice on the
    /// drive as stated, for the refusal of a search with nothing to vary.
    ///
    /// # Errors
    /// [`Error::Unreadable`] if there is nothing to vary; the errors of [`SearchRanges::new`],
    /// [`search`](Self::search) and [`Request::for_many`].
    pub fn of_drive(
        &self,
        request: &Request,
        along: Option<Vary>,
        instead: Option<&str>,
    ) -> Result<SearchRequest> {
        let drives = SearchedDrives::one(request);
        let defaults = loft_and_attack_angle;
        let ranges = SearchRanges::new(&self.vary, request, drives.setup, along, defaults)?;
        if let (Some(reason), Some(instead)) = (ranges.reason(), instead) {
            let source = format!("{reason}; {instead}");
            return Err(Error::unreadable("the search", source));
        }
        let mut requested = self.search(request, &drives, ranges, drives.default_goal())?;
        let vary = requested.search.vary.iter().copied();
        let ranges: Vec<_> = vary.chain(along).collect();
        requested.setup = request.for_many(requested.setup, &ranges)?;
        Ok(requested)
    }

    /// The search over these drives and ranges. Without an objective it maximizes `default`.
    ///
    /// # Errors
    /// [`Error::Unreadable`] if there is nothing to vary; the errors of
    /// [`objective`](Self::objective), [`SearchedDrives::limits`] and
    /// [`SearchedDrives::scenarios`].
    pub fn search(
        &self,
        request: &Request,
        drives: &SearchedDrives,
        ranges: SearchRanges,
        default: Goal,
    ) -> Result<SearchRequest> {
        let origin = ranges.origin(request);
        let initialized = ranges.initialized;
        let vary = ranges.vary()?;
        let (of, sense) = self.objective(|option, text| drives.goal(option, text), default)?;
        let subject_to = drives.limits(&initialized, &self.subject_to, [&of])?;
        let mut search = Search {
            of,
            sense,
            vary,
            subject_to,
            scenarios: Scenarios::one_drive(),
            options: options(self.max_iterations),
        };
        search.scenarios = drives.scenarios(search.goals())?;
        note_the_run(&search.outcomes());
        request.note_starts(&initialized, &search.vary);
        Ok(SearchRequest {
            setup: drives.setup,
            search,
            origin: origin.with_stated(&drives.args.end_of_title()),
        })
    }

    /// The reason why there is nothing to vary; `None` if `--vary` or a default range gives a
    /// parameter.
    ///
    /// # Errors
    /// The errors of [`loft_and_attack_angle`].
    pub fn nothing_to_vary(&self, request: &Request) -> Result<Option<String>> {
        if !self.vary.is_empty() {
            return Ok(None);
        }
        let setup = request.partial_setup;
        Ok(SearchRanges::defaults(loft_and_attack_angle(&setup)?, request, setup).reason())
    }

    /// The objective and its sense. Without an option, `default` is maximized. `read` takes the
    /// name and the value of an option, and returns the objective.
    ///
    /// # Errors
    /// [`Error::Unreadable`] for two objectives, and the errors of `read`.
    pub fn objective<Of>(
        &self,
        read: impl Fn(&str, &str) -> Result<Of>,
        default: Of,
    ) -> Result<(Of, Sense)> {
        match (&self.maximize, &self.minimize) {
            (Some(most), Some(least)) => {
                let source = format!(
                    "a search has one goal; leave one of `maximize {most}` and `minimize {least}` \
                     out, or take the command \"pareto\", which finds the best compromises of the \
                     two"
                );
                Err(Error::unreadable("`minimize`", source))
            }
            (None, Some(of)) => Ok((read("`minimize`", of)?, Sense::Minimize)),
            (Some(of), None) => Ok((read("`maximize`", of)?, Sense::Maximize)),
            (None, None) => Ok((default, Sense::Maximize)),
        }
    }

    /// The names of the stated options.
    pub fn stated(&self) -> impl Iterator<Item = &'static str> {
        stated([
            ("`maximize`", self.maximize.is_some()),
            ("`minimize`", self.minimize.is_some()),
            ("`vary`", !self.vary.is_empty()),
            ("`subject_to`", !self.subject_to.is_empty()),
            ("`max_iterations`", self.max_iterations.is_some()),
        ])
    }
}

impl OptimumArgs {
    /// Runs the search, which Ctrl-C interrupts.
    pub fn optima(&self, drive_search: &SearchRequest) -> Result<Optima> {
        let work = interrupt::enable(BEST_SO_FAR);
        self.optima_until(&drive_search.setup, &drive_search.search, &work.stop)
    }

    /// Runs the search and writes its checkpoint. `stop` interrupts the search. The progress is the
    /// last iteration, or a bar for several searches.
    pub fn optima_until(
        &self,
        setup: &Setup<f64>,
        search: &Search,
        stop: &Arc<AtomicBool>,
    ) -> Result<Optima> {
        let checkpoint = match &self.checkpoint {
            Some(path) => Some(Arc::new(Checkpoint::open(
                path,
                &checkpoint_identity(setup, search, self.starts),
            )?)),
            None => None,
        };
        let mut follow = Observers {
            interrupt: stop.clone(),
            checkpoint,
            ..Observers::default()
        };
        let bar = match self.starts {
            1 => show_iterations(search, &mut follow),
            _ => self.show_searches(search, &mut follow),
        };
        let found = optima(setup, search, self.starts as usize, &follow);
        bar.finish();
        let found = found?;
        if let Some(interrupted) = found.interrupted() {
            note(&interrupted);
        }
        Ok(found)
    }

    /// A bar with the number of completed searches and the best value so far.
    fn show_searches(&self, search: &Search, follow: &mut Observers) -> Arc<dyn Progress> {
        let (of, sign, system) = (search.of.clone(), search.sense.sign(), system());
        let show = move |value: f64| goal_text(&of, sign * value, system);
        let bar = shown(Work::Searches);
        bar.set_length(u64::from(self.starts));
        let best: Mutex<Option<f64>> = Mutex::new(None);
        let progress = bar.clone();
        follow.end = Some(Arc::new(move |_, solution| {
            let mut best = lock(&best);
            let is_feasible = solution.residual.feasibility <= 1e-6;
            *best = [*best, solution.value.filter(|_| is_feasible)]
                .into_iter()
                .flatten()
                .reduce(f64::min);
            progress.set_message(best.map_or("–".into(), &show));
            progress.inc(1);
        }));
        bar
    }

    /// The destination of the setup file of the optimum. `other_inputs` are files that the command
    /// reads besides those of the setup.
    pub fn destination(
        &self,
        request: &Request,
        other_inputs: impl Iterator<Item = PathBuf>,
    ) -> Result<Option<Destination>> {
        let inputs = request.inputs().chain(self.checkpoint.clone());
        let inputs = inputs.chain(other_inputs);
        OutputRule::new(inputs, self.overwrite).setup_file(self.output.as_deref())
    }
}

/// Writes the setup at the optimum into the given file, and returns the name of the file. Without a
/// file or without an optimum, writes nothing and returns `None`.
pub fn write(
    output: Option<&Destination>,
    request: &Request,
    optima: &Optima,
    swings: Option<&Swings>,
) -> Result<Option<String>> {
    let Some(output) = output else {
        return Ok(None);
    };
    if !optima.best.is_converged() {
        warn([output.not_written("there is no optimum")]);
        return Ok(None);
    }
    let setup = optimum_setup(
        &optima.best,
        swings,
        optima.interrupted(),
        &request.source.content,
        system(),
    );
    let file = request.write_setup(output, setup)?;
    let place = match swings {
        Some(_) => "with the best design",
        None => "at the optimum",
    };
    note(&format!("wrote the setup {place} into {file}"));
    Ok(Some(file))
}

/// Reads an allowed loss of a goal, SI, from the value `text` of `option`.
///
/// # Errors
/// [`Error::Unreadable`] for a negative or infinite loss, and for zero unless `may_be_zero`.
pub fn allowed_loss(
    option: &str,
    text: &str,
    quantity: Quantity,
    may_be_zero: bool,
) -> Result<f64> {
    let name = format!("`{option} {text}`");
    let loss = match quantity.read_difference(text) {
        Ok(loss) => loss,
        Err(error) => return Err(Error::unreadable(name, error)),
    };
    if loss.is_finite() && (loss > 0.0 || loss == 0.0 && may_be_zero) {
        return Ok(loss);
    }
    let least = if may_be_zero { "0 or more" } else { "above 0" };
    let source = format!("it must be {least} and finite, for example 1yd");
    Err(Error::unreadable(name, source))
}

/// The options of a search with this limit of iterations, or with the default limit.
pub fn options(max_iterations: Option<u64>) -> Options {
    let options = Options::default();
    Options {
        max_iterations: max_iterations.unwrap_or(options.max_iterations),
        ..options
    }
}

/// The identity of a search for its checkpoint: setup, search and number of starts in debug form,
/// which has all digits. The iteration limit is excluded.
fn checkpoint_identity(setup: &Setup<f64>, search: &Search, starts: u32) -> String {
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

/// Shows the last iteration in one line; with `--verbose`, prints a line for each iteration.
fn show_iterations(search: &Search, follow: &mut Observers) -> Arc<dyn Progress> {
    let (followed, running) = (search.clone(), running());
    let bar = match running.is_verbose() {
        true => Arc::new(()),
        false => shown(Work::Iterations),
    };
    let last = bar.clone();
    let line = move |_, iteration: &Iteration| {
        let line = iteration_line(&followed, iteration, running.system());
        if running.is_verbose() {
            running.note(&line);
        } else {
            last.set_message(line);
        }
    };
    follow.iteration = Some(Arc::new(line));
    bar
}
