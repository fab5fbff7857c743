//! The trade-off between two objectives: `pareto` and `plot pareto`.

use crate::command::args::{SetupArgs, SwingsArgs, whole};
use crate::command::files::{Destination, OutputRule, ending, refused};
use crate::command::interrupt;
use crate::command::names::note_the_run;
use crate::command::output::{Answer, note, once_a_second, spinner, stated_system, system, warn};
use crate::command::picture::{PictureArgs, PlotDestination};
use crate::command::request::Request;
use crate::command::running::running;
use crate::command::search::{SearchRequest, options};
use crate::command::swings::swing_ranges;
use crate::optimize::{Iteration, Observers};
use crate::report::figures::pareto_figure;
use crate::report::{ParetoReport, Report, pareto_csv, pareto_setup};
use crate::study::swings::{Pareto, ParetoSearch, Scenarios, pareto};
use crate::study::{Goal, Sense};
use crate::units::{Message, counted};
use crate::{Error, Outcome, Result, Setup};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// The message when the search for a front is interrupted.
const POINTS_SO_FAR: &str = "stopping with the points so far";

/// The two goals and the varied parameters.
#[derive(clap::Args)]
pub struct GoalArgs {
    /// A goal to maximize: an outcome, or over many swings a statistic of it, e.g. "mean(carry)".
    /// Give two goals in total, with --maximize and --minimize.
    #[arg(long, value_name = "GOAL")]
    pub maximize: Vec<String>,

    /// A goal to minimize, e.g. "std(lateral)".
    #[arg(long, value_name = "GOAL")]
    pub minimize: Vec<String>,

    /// A parameter to vary, with its range, e.g. club.loft=4deg..20deg. Repeatable [default: loft 4
    /// to 20 deg; for one drive also attack angle -5 to 5 deg; a parameter that you set, e.g. with
    /// --loft, stays fixed].
    #[arg(long, value_name = "NAME=LOW..HIGH", allow_hyphen_values = true)]
    pub vary: Vec<String>,

    /// A constraint on a goal, e.g. "apex_height <= 35 yd", or over many swings "mean(carry) >= 240
    /// yd". Every limit needs its unit. Repeatable.
    #[arg(long, value_name = "CONSTRAINT", allow_hyphen_values = true)]
    pub subject_to: Vec<String>,

    /// The number of points, spread evenly along the front, with its ends. Points at the knee, and
    /// where a bound or constraint becomes active or inactive, are added.
    #[arg(
        long,
        value_name = "N",
        default_value_t = 15,
        value_parser = whole::<usize>(2..=1000, "`points 15`"),
        allow_negative_numbers = true,
    )]
    pub points: usize,

    /// The largest number of iterations of a search [default: 500].
    #[arg(
        long,
        value_name = "N",
        value_parser = whole::<u64>(0..=u64::MAX, "`max_iterations 200`"),
        allow_negative_numbers = true,
    )]
    pub max_iterations: Option<u64>,

    #[command(flatten)]
    pub swings: SwingsArgs,
}

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub goals: GoalArgs,

    /// Write all points into a .csv file (each column head names its unit), or the setup of one
    /// point, which --at chooses, into a .toml file.
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// The point whose setup is written: its number in the table, or "knee", the point farthest
    /// from the straight line between the ends [default: knee].
    #[arg(
        long,
        value_name = "POINT",
        requires = "output",
        allow_negative_numbers = true
    )]
    pub at: Option<String>,

    /// Replace the file if it exists.
    #[arg(long, requires = "output")]
    pub overwrite: bool,
}

pub fn run(args: &Args) -> Result<Answer> {
    let request = args.setup_args.request()?;
    let output = ParetoFile::new(args, &request)?;
    let SearchRequest {
        setup,
        search,
        origin,
    } = args.goals.search(&request)?;
    let work = interrupt::enable(POINTS_SO_FAR);
    let found = follow(&setup, search, &work.stop)?;
    let mut warnings = [setup.warnings(), found.warnings(&work.stop)].concat();
    drop(work);
    let written = match &output {
        Some(output) => output.write(&found, &request, &mut warnings)?,
        None => None,
    };
    warn(warnings);
    let mut report = ParetoReport::new(&found);
    report.lacks_file = output.is_some() && written.is_none();
    report.file = written;
    let is_whole = report.ending().status == "done";
    let answer = Answer::report(&report, &origin);
    Ok(answer.found(is_whole))
}

/// Draws the front, for `plot pareto`.
pub fn draw(setup_args: &SetupArgs, args: &GoalArgs, drawing: &PictureArgs) -> Result<Answer> {
    let request = setup_args.request()?;
    let inputs = request.inputs().chain(args.swings.inputs());
    let target = PlotDestination::new(inputs, drawing)?;
    let SearchRequest {
        setup,
        search,
        origin,
    } = args.search(&request)?;
    let target = target.about(origin);
    let work = interrupt::enable(POINTS_SO_FAR);
    let found = follow(&setup, search, &work.stop)?;
    let warnings = [setup.warnings(), found.warnings(&work.stop)].concat();
    drop(work);
    if found.interrupted {
        let message = "stopped before the whole front was found".into();
        return Err(Error::NotConverged {
            status: "interrupted",
            message,
        });
    }
    // the subtitle has the stated values, not the time step that is chosen for the tolerance
    let (setup, preset) = (&request.partial_setup, request.source.content.preset);
    let figure = pareto_figure(&found, setup, preset, system());
    target.write(&figure, warnings)
}

/// Follows the front, until `stop` is true.
fn follow(setup: &Setup<f64>, search: ParetoSearch, stop: &Arc<AtomicBool>) -> Result<Pareto> {
    let spinner = spinner("following the front");
    let (shown, running, is_due) = (spinner.clone(), running(), once_a_second());
    let iteration = Arc::new(move |number: usize, _: &Iteration| {
        if is_due() {
            let doing = format!("following the front: {} searches so far", number + 1);
            shown.set_message(doing.clone());
            if running.is_verbose() {
                running.note(&doing);
            }
        }
    });
    let follow = Observers {
        iteration: Some(iteration),
        interrupt: stop.clone(),
        ..Observers::default()
    };
    let found = pareto(setup, search, &follow);
    spinner.finish();
    found
}

impl GoalArgs {
    /// The search for the front, with method and step for its drives.
    fn search(&self, request: &Request) -> Result<SearchRequest<ParetoSearch>> {
        self.swings.refuse_stray()?;
        let drives = self.swings.drives(request, false)?;
        let ranges = drives.ranges(&self.vary, request)?;
        let origin = ranges.origin(request);
        let initialized = ranges.initialized;
        let goals = self.goals(|option, text| drives.goal(option, text))?;
        let vary = ranges.vary()?;
        let of = goals.each_ref().map(|(goal, _)| goal);
        let subject_to = drives.limits(&initialized, &self.subject_to, of)?;
        let mut search = ParetoSearch {
            goals,
            vary,
            subject_to,
            scenarios: Scenarios::one_drive(),
            points: self.points,
            options: options(self.max_iterations),
        };
        search.scenarios = drives.scenarios(search.all_goals())?;
        let outcomes: Vec<Outcome> = search.all_goals().flat_map(Goal::outcomes).collect();
        note_the_run(&outcomes);
        request.note_starts(&initialized, &search.vary);
        let ranges = swing_ranges(&search.vary, &search.scenarios);
        Ok(SearchRequest {
            setup: request.for_many(drives.setup, &ranges)?,
            search,
            origin: origin.with_stated(&drives.args.end_of_title()),
        })
    }

    /// The two objectives, parsed by `read`.
    fn goals(
        &self,
        read: impl Fn(&'static str, &str) -> Result<Goal>,
    ) -> Result<[(Goal, Sense); 2]> {
        let given = [
            ("`maximize`", &self.maximize, Sense::Maximize),
            ("`minimize`", &self.minimize, Sense::Minimize),
        ];
        let goals = given
            .into_iter()
            .flat_map(|(option, texts, sense)| texts.iter().map(move |text| (option, text, sense)));
        let goals = goals
            .map(|(option, text, sense)| Ok((read(option, text)?, sense)))
            .collect::<Result<Vec<_>>>()?;
        let goals: [(Goal, Sense); 2] = goals.try_into().map_err(|all: Vec<_>| {
            Error::unreadable("the goals", format!(
                "{} given, but a front needs two: give them with `maximize` and `minimize`, for \
                 example `maximize carry` `minimize apex_height`",
                match all.len() {
                    0 => "none is".into(),
                    1 => "one is".into(),
                    given => format!("{given} are"),
                }
            ))
        })?;
        if goals[0].0.terms == goals[1].0.terms {
            let source = "both are the same; give another one";
            return Err(Error::unreadable("the goals", source));
        }
        Ok(goals)
    }
}

/// The output file: its destination and content.
struct ParetoFile {
    destination: Destination,
    /// True for the setup at one point; false for the table of all points.
    is_setup: bool,
    /// The number of the point in the table, from 1; `None` for the knee.
    at: Option<usize>,
}

impl ParetoFile {
    fn new(args: &Args, request: &Request) -> Result<Option<Self>> {
        let Some(path) = &args.output else {
            return Ok(None);
        };
        let is_setup = match ending(path).as_str() {
            "toml" => true,
            "csv" => false,
            _ => {
                return Err(refused(
                    path,
                    "its extension does not name a format; use .csv for all points or .toml for \
                     the setup at one point",
                ));
            }
        };
        let refuse = |source: &str| Error::unreadable("`at`", source);
        let at = match args.at.as_deref().map(str::trim) {
            Some(_) if !is_setup => {
                return Err(refuse(
                    "it chooses the point whose setup is written, and only a .toml file holds a \
                     setup; name such a file, as in `output best.toml`, or leave `at` out",
                ));
            }
            None | Some("knee") => None,
            Some(number) => {
                let number = number.parse::<usize>().ok().filter(|number| *number > 0);
                Some(number.ok_or_else(|| {
                    refuse("it is \"knee\" or the number of a point in the table, from 1")
                })?)
            }
        };
        let rule = OutputRule::new(
            request.inputs().chain(args.goals.swings.inputs()),
            args.overwrite,
        );
        Ok(Some(Self {
            destination: rule.file(path)?,
            is_setup,
            at,
        }))
    }

    /// Writes the file, and returns its name. If the requested point does not exist, adds a warning
    /// and returns `None`.
    fn write(
        &self,
        found: &Pareto,
        request: &Request,
        warnings: &mut Vec<Message>,
    ) -> Result<Option<String>> {
        if !self.is_setup {
            self.destination
                .write(pareto_csv(found, stated_system().into())?.as_bytes())?;
            let file = self.destination.shown.display().to_string();
            note(&format!(
                "wrote {} into {file}",
                counted(found.points.len() as u64, "point")
            ));
            return Ok(Some(file));
        }
        let place = match self.at {
            Some(number) => Some(number - 1).filter(|place| *place < found.points.len()),
            // a single point is best for both goals: no choice is needed
            None if found.points.len() == 1 => Some(0),
            None => found.knee,
        };
        let Some(place) = place else {
            let why = match self.at {
                Some(number) => {
                    format!(
                        "there is no point {number}; choose one with `at`, from 1 to {}",
                        found.points.len()
                    )
                }
                None => "there is no knee; choose a point by its number with `at`".into(),
            };
            warnings.push(self.destination.not_written(&why));
            return Ok(None);
        };
        let setup = pareto_setup(found, place, &request.source.content, system())?;
        let file = request.write_setup(&self.destination, setup)?;
        note(&format!(
            "wrote the setup of point {} into {file}",
            place + 1
        ));
        Ok(Some(file))
    }
}
