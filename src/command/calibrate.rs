// these doc comments are help texts, in which "carry [yd]" is a column head, not a link
#![allow(rustdoc::broken_intra_doc_links)]

use crate::command::args::{SetupArgs, U32_MAX, whole};
use crate::command::files::{Destination, OutputRule};
use crate::command::interrupt::{self, BEST_SO_FAR};
use crate::command::output::{Answer, note, system, warn};
use crate::command::reproduce::{DOCUMENT, write};
use crate::command::request::Request;
use crate::command::running::running;
use crate::optimize::least_squares::{FitObserver, FitStatus, Loss};
use crate::parameters::{Law, Vary};
use crate::report::CalibrationReport;
use crate::study::calibrate::{
    Calibration, CalibrationStatus, FitPlan, HeldOut, ShotTable, calibrate, check_folds, held_out,
    ranges, validity_warnings,
};
use crate::table::RowFilter;
use crate::units::Message;
use crate::{Error, Outcome, Result, Setup};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering::Relaxed};

#[derive(clap::Args)]
#[command(group = clap::ArgGroup::new("written").args(["output", "plot"]).multiple(true))]
pub struct Args {
    /// Measured shots as CSV, one row per shot; the head of each column names a parameter or an
    /// outcome and its unit, as in "carry [yd]"; see docs/calibration.md.
    #[arg(value_name = "DATA")]
    pub data: PathBuf,

    #[command(flatten)]
    pub setup_args: SetupArgs,

    /// Read only the rows with this text in a column, e.g. Club=Driver, in upper or lower case;
    /// several texts of one column are alternatives. Repeatable.
    #[arg(long, value_name = "COLUMN=VALUE")]
    pub only: Vec<String>,

    /// A parameter to fit, e.g. aero.cd0 or aero.cd0=0.1..0.4. Repeatable.
    #[arg(
        long,
        value_name = "NAME[=LOW..HIGH]",
        required = true,
        allow_hyphen_values = true
    )]
    pub fit: Vec<String>,

    /// Use Huber's loss: an outlier has no more influence than a residual of 1.345 σ.
    #[arg(long)]
    pub huber: bool,

    /// Search from this many starts: the setup's own values, then points spread evenly over the
    /// fitted ranges. State these ranges: the default is the whole allowed range, in which few
    /// drives fly.
    #[arg(
        long,
        value_name = "N",
        default_value_t = 1,
        value_parser = whole::<u32>(1..=U32_MAX, "`starts 8`"),
        allow_negative_numbers = true,
    )]
    pub starts: u32,

    /// Cross-validate: fit K times, each time without a K-th of the rows, and show the prediction
    /// errors of the omitted rows.
    #[arg(
        long,
        value_name = "K",
        default_value_t = 0,
        value_parser = whole::<u32>(0..=U32_MAX, "`folds 5`"),
        allow_negative_numbers = true,
    )]
    pub folds: u32,

    /// Show the cross-validation errors of another aerodynamic law too: with its published
    /// coefficients, and with all its coefficients fitted. Repeatable.
    #[arg(long, value_name = "LAW")]
    pub compare: Vec<String>,

    /// The largest number of iterations of a search.
    #[arg(
        long,
        value_name = "N",
        default_value_t = 200,
        value_parser = whole::<u64>(0..=u64::MAX, "`max_iterations 200`"),
        allow_negative_numbers = true,
    )]
    pub max_iterations: u64,

    /// Write the fitted setup into this file.
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Write the report into this folder too: a page (index.html), Markdown, and plots of the
    /// residuals with their data.
    #[arg(long, value_name = "DIR")]
    pub plot: Option<PathBuf>,

    /// Replace files that exist.
    #[arg(long, requires = "written")]
    pub overwrite: bool,
}

pub fn run(args: &Args) -> Result<Answer> {
    let request = args.setup_args.request()?;
    let setup = request.partial_setup;
    let rule = OutputRule::new(request.inputs().chain([args.data.clone()]), args.overwrite);
    let folder = match &args.plot {
        Some(path) => Some(rule.folder(path, &DOCUMENT)?),
        None => None,
    };
    let rule = rule.and_not(args.plot.as_deref());
    let output = rule.setup_file(args.output.as_deref())?;
    request.refuse_launch(&setup, &launch_columns_advice(&args.data))?;
    let table = read_shots(args, &request, &setup).or_else(|error| {
        // columns may complete the setup; if they do not, the error of the setup is more helpful
        request.setup()?;
        Err(error)
    })?;
    warn(table.warnings.clone());
    let plan = args.plan(&setup)?;
    request.note_starts(&setup, &plan.fit);
    let ranges = ranges(&table, &plan.fit);
    request.warn_of_ranges(&setup, &ranges);
    let setup = request.for_many(setup, &ranges)?;
    let validation = CrossValidation::new(args, &setup, &table, &plan)?;
    warn(table.one_drive(&setup, &plan.fit));
    warn(assumed_ground(&request, &table, &plan));
    let work = interrupt::enable(BEST_SO_FAR);
    let follow = FitObserver {
        iteration: Some(Arc::new(show_iteration(args.starts > 1))),
        interrupt: work.stop.clone(),
    };
    let found = calibrate(&setup, &table, &plan, &follow)?;
    warn(validity_warnings(
        &found.setup,
        &table.shots,
        &follow.interrupt,
    ));
    warn(found.warnings(&table));
    let held_out = match &validation {
        Some(validation) => validation.run(&setup, &table, &plan, follow.interrupt)?,
        None => vec![],
    };
    drop(work);
    let mut report = CalibrationReport::new(&table, &found, &held_out);
    let is_found = report.status() == CalibrationStatus::CONVERGED;
    if !is_found {
        warn([Message::from(format!(
            "the fit ended as '{}': {}",
            report.status(),
            report.message()
        ))]);
    }
    report.file = match &output {
        Some(output) => write_setup(output, args, &request, &found, &report)?,
        None => None,
    };
    if let Some(folder) = &folder {
        write(folder, &report, system())?;
        report.folder = Some(folder.path.display().to_string());
    }
    let answer = Answer::report(&report, &request.origin_of_shots());
    Ok(answer.found(is_found))
}

/// The reason, with advice, why a calibration refuses a stated launch.
fn launch_columns_advice(data: &Path) -> String {
    format!(
        "calibrate reads the launch of each ball from columns of the table; leave this out, and \
         add the columns to {} if it has none: ball_speed, launch_angle, and backspin or spin, \
         with their units, as in \"ball_speed [mph]\"",
        data.display()
    )
}

impl Args {
    /// The fitted parameters and the settings of the fit.
    fn plan(&self, setup: &Setup<f64>) -> Result<FitPlan> {
        let mut plan = FitPlan::read(setup, &self.fit)?;
        plan.starts = self.starts as usize;
        plan.options.max_iterations = self.max_iterations;
        if self.huber {
            plan.options.loss = Loss::HUBER;
        }
        Ok(plan)
    }
}

/// Reads the measured shots. Refuses settings of parameters that the table has as columns.
fn read_shots(args: &Args, request: &Request, setup: &Setup<f64>) -> Result<ShotTable> {
    let file = args.data.display();
    let filter = RowFilter::read(&args.only)?;
    let table = ShotTable::open(setup, &args.data, filter, request.gives_air())?;
    if table.is_launched {
        request.refuse_club(&format!("the rows of {file} are launches"))?;
    }
    let given = table.given(setup);
    request.refuse_stated(
        &given,
        &format!("every row of {file} has a value of its own"),
    )?;
    request.refuse_replaced(setup, &given)?;
    Ok(table)
}

/// A warning if the table has measured rest positions, and the ground is neither stated nor fitted.
fn assumed_ground(request: &Request, table: &ShotTable, plan: &FitPlan) -> Option<Message> {
    let measured = table.shots.iter().flat_map(|shot| &shot.measured);
    let is_at_rest = measured.map(|one| one.outcome).any(Outcome::needs_run);
    let is_fitted = plan
        .fit
        .iter()
        .any(|vary| vary.parameter.affects_only_run());
    (is_at_rest && !is_fitted && !request.gives_ground()).then(|| {
        "the measured totals are compared on a ground that is assumed; name it with `set \
         ground.turf=firm`, average, soft or wet"
            .into()
    })
}

/// Writes the fitted setup, and returns the name of the file. Writes nothing, with a warning, if an
/// interruption or the iteration limit ended the fit before a minimum.
fn write_setup(
    output: &Destination,
    args: &Args,
    request: &Request,
    found: &Calibration,
    report: &CalibrationReport<'_>,
) -> Result<Option<String>> {
    let is_unfinished = matches!(
        found.verdict.status,
        CalibrationStatus::Search(FitStatus::Interrupted | FitStatus::IterationLimit)
    );
    if is_unfinished && !found.is_minimum {
        warn([output.not_written("the fit ended before it came to a minimum")]);
        return Ok(None);
    }
    let data = args.data.display().to_string();
    let setup = report.fitted_setup(&request.source.content, &data);
    let file = request.write_setup(output, setup)?;
    note(&format!("wrote the fitted setup into {file}"));
    Ok(Some(file))
}

/// Cross-validation of the setup's law and of the laws to compare.
struct CrossValidation {
    folds: usize,
    compared: Vec<ComparedLaw>,
}

impl CrossValidation {
    /// `None` without `--folds` and `--compare`.
    fn new(
        args: &Args,
        setup: &Setup<f64>,
        table: &ShotTable,
        plan: &FitPlan,
    ) -> Result<Option<Self>> {
        if args.folds == 0 && args.compare.is_empty() {
            return Ok(None);
        }
        let folds = if args.folds > 0 {
            args.folds as usize
        } else {
            5.min(table.shots.len())
        };
        let compared = args
            .compare
            .iter()
            .map(|law| ComparedLaw::new(setup, law, plan))
            .collect::<Result<Vec<_>>>()?;
        check_folds(table, plan, folds)?;
        for ComparedLaw { setup, plan } in &compared {
            check_folds(table, plan, folds).map_err(|error| {
                let law = setup.law.name();
                Error::unreadable(format!("`compare {law}`"), error)
            })?;
        }
        Ok(Some(Self { folds, compared }))
    }

    /// The prediction errors of each law, with and without a fit. A label names the law and its
    /// coefficients.
    fn run(
        &self,
        setup: &Setup<f64>,
        table: &ShotTable,
        plan: &FitPlan,
        interrupt: Arc<AtomicBool>,
    ) -> Result<Vec<(String, HeldOut)>> {
        let folds = self.folds;
        let follow = &FitObserver {
            iteration: None,
            interrupt,
        };
        if !follow.is_interrupted() {
            note(&format!(
                "cross-validation: fitting {folds} times, each time without a part of the rows"
            ));
        }
        let own_law = setup.law.name();
        let fitted = held_out(setup, table, plan, folds, follow)?;
        let mut all = vec![(format!("{own_law}, fitted as above"), fitted)];
        let mut laws = self.compared.iter().map(|other| other.setup.law.name());
        if laws.all(|law| law != own_law) {
            let unfitted = HeldOut::as_it_stands(setup, table, follow)?;
            all.push((format!("{own_law}, {AS_SET_UP}"), unfitted));
        }
        for other in &self.compared {
            let law = other.setup.law.name();
            let label = if law == own_law {
                AS_SET_UP
            } else {
                "as published"
            };
            let unfitted = HeldOut::as_it_stands(&other.setup, table, follow)?;
            all.push((format!("{law}, {label}"), unfitted));
            let fitted = held_out(&other.setup, table, &other.plan, folds, follow)?;
            all.push((format!("{law}, all coefficients fitted"), fitted));
        }
        Ok(all)
    }
}

/// Shows each iteration. With several searches, it also shows the number of the search, because
/// every search begins with iteration 0.
fn show_iteration(is_numbered: bool) -> impl Fn(u64, f64) {
    let (running, begun) = (running(), AtomicU64::new(0));
    move |iteration, sum| {
        let begins = u64::from(iteration == 0);
        let search = begun.fetch_add(begins, Relaxed) + begins;
        let search = if is_numbered {
            format!("search {search}  ")
        } else {
            String::new()
        };
        running.note(&format!(
            "{search}iteration {iteration:3}  half the sum of squares {sum:.6e}"
        ));
    }
}

/// The label of a law with the coefficients of the setup.
const AS_SET_UP: &str = "as the setup has it";

/// A law of `--compare`. Its prediction errors are computed twice: without a fit, and with all its
/// coefficients fitted.
struct ComparedLaw {
    /// The setup with this law.
    setup: Setup<f64>,
    /// The fit of all coefficients of this law, and of the parameters to fit that belong to no law.
    plan: FitPlan,
}

impl ComparedLaw {
    fn new(setup: &Setup<f64>, law: &str, plan: &FitPlan) -> Result<Self> {
        let mut other = *setup;
        other.set_law(law)?;
        let own = Law::all_rows().filter(|row| row.law == Some(other.law.name()));
        let coefficients = own.map(|row| Vary {
            parameter: row,
            low: row.range.low,
            high: row.range.high,
        });
        let kept = plan
            .fit
            .iter()
            .filter(|vary| vary.parameter.law.is_none())
            .copied();
        let plan = FitPlan {
            fit: kept.chain(coefficients).collect(),
            ..plan.clone()
        };
        Ok(Self { setup: other, plan })
    }
}
