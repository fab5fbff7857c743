//! The search for the best design over many swings.

use crate::command::args::{OptimizeArgs, OptimumArgs, SearchArgs, SwingsArgs, stated};
use crate::command::interrupt::{self, BEST_SO_FAR, InterruptibleWork};
use crate::command::names::note_the_run;
use crate::command::output::{Answer, note, note_each, system, warn};
use crate::command::ranges::{SearchRanges, loft};
use crate::command::request::Request;
use crate::command::search::{options, write};
use crate::parameters::Vary;
use crate::report::{OptimizeReport, computed_text};
use crate::study::swings::{
    Correlation, OverSwings, Rule, Scenarios, Strokes, Swings, analyse_over_swings,
    bootstrap_optimum,
};
use crate::study::uncertainty::Uncertain;
use crate::study::{Constraint, Goal, Optima, Search};
use crate::units::Message;
use crate::{Error, Outcome, Result, Setup};
use std::path::PathBuf;

/// Number of bootstrap samples of recorded swings.
const RESAMPLES: usize = 200;

/// The swings of a request, and the setup whose parameters vary from swing to swing.
pub struct SwingsRequest {
    /// The setup, with a value for each parameter that varies from swing to swing.
    pub setup: Setup<f64>,
    pub swings: Swings,
    /// True if the command resamples recorded swings.
    pub is_resampled: bool,
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

    /// Reads the swings of a request. Refuses settings of the parameters that vary between the
    /// swings. `is_resampled` is true if the command resamples recorded swings.
    pub(super) fn request(&self, request: &Request, is_resampled: bool) -> Result<SwingsRequest> {
        let swings = self.read(&request.partial_setup)?;
        request
            .refuse_stated_besides_launch(&swings.parameters(), "the swings have values of it")?;
        self.request_of(request, swings, is_resampled)
    }

    /// The setup with the means of these swings. `is_resampled` is true if the command resamples
    /// recorded swings.
    pub(super) fn request_of(
        &self,
        request: &Request,
        swings: Swings,
        is_resampled: bool,
    ) -> Result<SwingsRequest> {
        note_replaced(request, &swings);
        let setup = request.fill_missing(
            request.partial_setup,
            swings.parameters().into_iter().zip(swings.means()),
            "varies about",
        )?;
        Ok(SwingsRequest {
            setup,
            swings,
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
    pub(super) fn strokes(&self) -> Result<Option<Strokes>> {
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

/// The best design over swings, with its analyses.
pub struct SwingsOptimum {
    /// The setup before the search.
    pub setup: Setup<f64>,
    pub optima: Optima,
    pub over: OverSwings,
    /// The search and its analyses, which Ctrl-C can interrupt until this value is dropped.
    pub work: InterruptibleWork,
    /// The file that was written.
    file: Option<String>,
}

impl SwingsOptimum {
    pub fn report(&self) -> OptimizeReport<'_> {
        OptimizeReport::new(&self.optima, Some(&self.over), None, self.file.clone())
    }
}

/// Searches over swings.
pub fn run(args: &OptimizeArgs) -> Result<Answer> {
    let OptimumArgs {
        setup_args, search, ..
    } = &args.optimum;
    let request = setup_args.request()?;
    let over = args.swings.request(&request, true)?;
    let ranges = SearchRanges::over_swings(&search.vary, &request, over.setup, loft)?;
    let origin = ranges.origin(&request);
    let origin = origin.with_stated(&args.swings.end_of_title());
    let search = search_over_swings(
        search,
        &args.swings,
        &over,
        Goal::mean(Outcome::Carry),
        ranges,
    )?;
    request.note_starts(&over.setup, &search.vary);
    let found = optimize_and_write(args, &request, over.setup, over.swings, search)?;
    let answer = Answer::report(&found.report(), &origin);
    Ok(answer.found(found.optima.is_found()))
}

/// Runs the search, which Ctrl-C can stop, and writes the setup if a file is given.
pub fn optimize_and_write(
    args: &OptimizeArgs,
    request: &Request,
    setup: Setup<f64>,
    swings: Swings,
    search: Search,
) -> Result<SwingsOptimum> {
    note_the_run(&search.outcomes());
    let setup = request.for_many(setup, &swing_ranges(&search.vary, &search.scenarios))?;
    let output = args.optimum.destination(request, args.swings.inputs())?;
    let work = interrupt::enable(BEST_SO_FAR);
    let stop = &work.stop;
    let optima = args.optimum.optima_until(&setup, &search, stop)?;
    let best = &optima.best;
    let is_found = best.is_converged();
    let mut analysis = None;
    let mut resampled = None;
    if is_found {
        analysis = analyse_over_swings(&setup, &swings, best, stop)?;
        if let Swings::Recorded { .. } = swings {
            let seed = u64::from(args.swings.seed.unwrap_or(0));
            resampled = bootstrap_optimum(&setup, best, RESAMPLES, seed, stop)?;
        }
    }
    let mut warnings = best.warnings(stop);
    if let Some(share) = best.beyond_strokes.filter(|share| *share > 0.0) {
        let percent = 100.0 * share;
        let percent = match percent < 0.1 {
            true => "less than 0.1".into(),
            false => format!("{percent:.1}"),
        };
        warnings.push(Message::from(format!(
            "the balls of {percent} % of the swings end outside of the table of strokes, where \
             it is extrapolated linearly"
        )));
    }
    warn(warnings);
    let file = write(output.as_ref(), request, &optima, Some(&swings))?;
    Ok(SwingsOptimum {
        setup,
        optima,
        over: OverSwings {
            analysis,
            resampled,
        },
        work,
        file,
    })
}

/// The search over swings. Without an objective it maximizes `default`.
pub fn search_over_swings(
    search: &SearchArgs,
    swings: &SwingsArgs,
    over: &SwingsRequest,
    default: Goal,
    ranges: SearchRanges,
) -> Result<Search> {
    let strokes = swings.strokes()?;
    let strokes = strokes.as_ref();
    let read = |option: &str, text: &str| goal(option, text, strokes);
    let (of, sense) = search.objective(read, default)?;
    let initialized = ranges.initialized;
    let vary = ranges.vary()?;
    let subject_to = limits(&initialized, &search.subject_to, [&of], strokes)?;
    let mut search = Search {
        of,
        sense,
        vary,
        subject_to,
        scenarios: Scenarios::one_drive(),
        options: options(search.max_iterations),
    };
    search.scenarios = swings.scenarios(&over.swings, search.goals(), over.is_resampled)?;
    Ok(search)
}

/// The constraints of a search for the objectives `of`. A constraint limits a goal or an expression
/// of parameters.
///
/// # Errors
/// [`Error::Unreadable`] for a table of strokes that neither an objective nor a constraint uses.
pub fn limits<const N: usize>(
    setup: &Setup<f64>,
    texts: &[String],
    of: [&Goal; N],
    strokes: Option<&Strokes>,
) -> Result<Vec<Constraint>> {
    let read = |text: &String| match Constraint::is_relation(text) {
        true => Constraint::read_relation(setup, text),
        false => Constraint::read_over_swings(text, strokes),
    };
    let limits = texts.iter().map(read).collect::<Result<Vec<_>>>()?;
    let goals = of.into_iter().chain(limits.iter().map(|limit| &limit.goal));
    refuse_unused_strokes(strokes, goals, "`minimize \"strokes(400yd)\"`")?;
    Ok(limits)
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
pub fn goal(option: &str, text: &str, strokes: Option<&Strokes>) -> Result<Goal> {
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

/// The ranges of all drives in a search: the ranges of the varied parameters, and the ranges of the
/// parameters that differ between the swings.
pub fn swing_ranges(vary: &[Vary], scenarios: &Scenarios) -> Vec<Vary> {
    let vary = vary.iter().copied();
    vary.chain(scenarios.ranges()).collect()
}
