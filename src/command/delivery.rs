use crate::command::args::DriveArgs;
use crate::command::files::{Destination, OutputRule, ending};
use crate::command::interrupt::{self, BEST_SO_FAR};
use crate::command::names::sigmas;
use crate::command::output::{Answer, command_line, note, stated_system, system, warn};
use crate::command::request::{CommandSetting, LOFT, Request, Source};
use crate::parameters::{Vary, is_of_strike};
use crate::report::{
    DeliveryReport, SetupOrigin, bound_warnings, delivery_setup, difference_warnings,
    parameter_difference_text, parameter_text, population_warnings, recovered_csv, recovered_toml,
    setting_text, unusual_warnings,
};
use crate::study::calibrate::ShotTable;
use crate::study::delivery::{
    Population, ShotDelivery, Spread, Unknown, deliveries, delivery, launches, unknowns,
};
use crate::table::RowFilter;
use crate::units::{Message, counted};
use crate::{Error, Result, Setup};
use std::ffi::OsString;
use std::path::{Path, PathBuf};

#[derive(clap::Args)]
#[command(group(clap::ArgGroup::new("written").args(["output", "swings"]).multiple(true)))]
pub struct Args {
    #[command(flatten)]
    pub drive: DriveArgs,

    /// The measured speed of the ball, e.g. 167mph.
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    pub ball_speed: Option<String>,

    /// The measured angle of the launch above horizontal, e.g. 10.9deg.
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub launch_angle: Option<String>,

    /// The measured direction of the launch, + right of the target line [default: not measured].
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub launch_direction: Option<String>,

    /// The measured total spin, e.g. 2686rpm; --spin-axis may be added.
    #[arg(long, value_name = "SPIN", allow_hyphen_values = true)]
    pub spin: Option<String>,

    /// The measured tilt of the spin axis, + for a ball that curves to the right [default: not
    /// measured].
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub spin_axis: Option<String>,

    /// The measured backspin, in place of --spin; --sidespin may be added.
    #[arg(long, value_name = "SPIN", allow_hyphen_values = true)]
    pub backspin: Option<String>,

    /// The measured sidespin, + for a ball that curves to the right [default: not measured].
    #[arg(long, value_name = "SPIN", allow_hyphen_values = true)]
    pub sidespin: Option<String>,

    /// Measured shots as CSV, one row per shot, as a launch monitor exports them or as calibrate
    /// reads them. Club values in a row count as measured too.
    #[arg(long, value_name = "FILE")]
    pub shots: Option<PathBuf>,

    /// Read only the rows with this text in a column, e.g. Club=Driver, in upper or lower case;
    /// several texts of one column are alternatives. Repeatable.
    #[arg(long, value_name = "COLUMN=VALUE", requires = "shots")]
    pub only: Vec<String>,

    /// A parameter to find and its range, e.g. club.loft=4deg..20deg. Repeatable [default: the
    /// speed, attack angle, shaft lean, path and face angle of the swing, and the impact point on
    /// the face].
    #[arg(long, value_name = "NAME=LOW..HIGH", allow_hyphen_values = true)]
    pub vary: Vec<String>,

    /// The prior standard uncertainty of a parameter about its value in the setup, e.g.
    /// swing.attack_angle=1deg. Repeatable [default: for a club value that an option or a row
    /// gives, the error of a launch monitor; for others, the spread among golfers].
    #[arg(long, value_name = "NAME=AMOUNT")]
    pub sigma: Vec<String>,

    /// Write the setup with the delivery into this file; for several shots, with the mean of the
    /// deliveries that explain their launches. If there is none, no file is written.
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Write the swings that explain the shots into this file, for "longdrive optimize --swings": a
    /// table with a row for each shot (.csv), or distributions with correlations, without the
    /// errors of the launch monitor (.toml).
    #[arg(long, value_name = "FILE", requires = "shots")]
    pub swings: Option<PathBuf>,

    /// Replace files that exist.
    #[arg(long, requires = "written")]
    pub overwrite: bool,

    /// Print the answer as JSON (SI units and radians), and nothing else, to standard output.
    #[arg(long)]
    pub json: bool,
}

pub fn run(args: &Args) -> Result<Answer> {
    let requests = Requests::new(args)?;
    let inputs = requests.club.inputs().chain(args.shots.clone());
    let rule = OutputRule::new(inputs, args.overwrite);
    let output = rule.setup_file(args.output.as_deref())?;
    let rule = rule.and_not(args.output.as_deref());
    let swings_output = match &args.swings {
        Some(path) => Some(swings_destination(&rule, path)?),
        None => None,
    };
    let setup = requests.club.setup()?;
    let launched = requests.setup_of_launch(args)?;
    // a delivery depends on the impact only, not on the weather
    warn(setup.club_warnings());
    warn(idle_settings_warning(args, &requests.club));
    let unknowns = read_unknowns(args, &requests.club, &setup)?;
    let found = match &args.shots {
        None => {
            note_assumed(&unknowns);
            warn(loft_warning(&requests.club, &setup, &unknowns));
            of_launch(&setup, &launched, &unknowns)?
        }
        Some(file) => {
            let filter = RowFilter::read(&args.only)?;
            let table = ShotTable::open_launches(&setup, file, filter)?;
            of_shots(table, &requests, &setup, &unknowns)?
        }
    };
    warn(found.warnings());
    let written = match &output {
        Some(output) => write_setup(output, &found, &requests.club, &setup)?,
        None => None,
    };
    // the printed command needs no settings of the unknowns: the file of swings has their values
    let unknown: Vec<_> = unknowns.iter().map(|unknown| unknown.parameter).collect();
    let setup_words = match written {
        Some(file) => vec![file],
        None => [
            requests.club.as_arguments(&unknown),
            found.given_arguments(),
        ]
        .concat(),
    };
    let is_whole = match &swings_output {
        Some(output) => write_swings(output, &found, setup_words)?,
        None => true,
    };
    let is_found = found.explained() == found.all.len() && found.left_out == 0 && is_whole;
    let population = found
        .population
        .as_ref()
        .and_then(|found| found.as_ref().ok());
    let is_table = args.shots.is_some();
    let report = DeliveryReport::new(&found.all, population, is_table, found.left_out);
    let answer = Answer::report(&report, &SetupOrigin::default());
    Ok(answer.found(is_found))
}

/// The deliveries found; for a table of shots, also the population of their swings.
struct Deliveries {
    all: Vec<ShotDelivery>,
    population: Option<Result<Population>>,
    /// The source of the measurement, for the written files: the table, or "a measured launch".
    from: String,
    /// Number of rows that an interruption left out.
    left_out: usize,
}

impl Deliveries {
    /// The number of deliveries that explain their measured launch.
    fn explained(&self) -> usize {
        self.all.iter().filter_map(ShotDelivery::explained).count()
    }

    /// The arguments that give the values in the rows of the table, except launch and unknowns, to
    /// another command.
    fn given_arguments(&self) -> Vec<String> {
        let given = Spread::of_given(&self.all).into_iter();
        let setting = |given: Spread| ["--set".into(), setting_text(given.parameter, given.mean)];
        given.flat_map(setting).collect()
    }

    /// The warnings about the deliveries.
    fn warnings(&self) -> Vec<Message> {
        let mut warnings = vec![];
        if self.left_out > 0 {
            let rows = counted(self.left_out as u64, "row");
            warnings.push(format!("interrupted: {rows} were not computed").into());
        }
        warnings.extend(bound_warnings(&self.all, system()));
        warnings.extend(difference_warnings(&self.all, system()));
        warnings.extend(unusual_warnings(&self.all, system()));
        let population = self.population.iter().flatten();
        warnings.extend(population.flat_map(|found| population_warnings(found, system())));
        warnings
    }
}

/// The delivery of one measured launch.
fn of_launch(
    setup: &Setup<f64>,
    launched: &Setup<f64>,
    unknowns: &[Unknown],
) -> Result<Deliveries> {
    let found = delivery(setup, &launches(launched), unknowns)?;
    Ok(Deliveries {
        all: vec![ShotDelivery {
            row: 1,
            found: Ok(found),
        }],
        population: None,
        from: "a measured launch".into(),
        left_out: 0,
    })
}

/// The deliveries of the shots in a table.
fn of_shots(
    mut table: ShotTable,
    requests: &Requests,
    setup: &Setup<f64>,
    unknowns: &[Unknown],
) -> Result<Deliveries> {
    let given = table.given(setup);
    let why = format!("every row of {} has a value of its own", table.file);
    // a value that is set is used in the rows with an empty cell
    let mut of_all = given.clone();
    of_all.retain(|parameter| table.shots.iter().all(|shot| shot.gives(parameter)));
    requests.club.refuse_stated(&of_all, &why)?;
    requests.launched.refuse_stated(&of_all, &why)?;
    if !given.iter().any(|parameter| parameter.name == LOFT) {
        table
            .warnings
            .extend(loft_warning(&requests.club, setup, unknowns));
    }
    warn(table.warnings.iter().cloned());
    let remarks = table.remarks.iter();
    remarks.for_each(|remark| note(&remark.in_units(system())));
    note(&format!(
        "{}: only the launch of each row is used, not the flight",
        table.file
    ));
    let (measured, assumed): (Vec<_>, Vec<_>) = unknowns
        .iter()
        .partition(|unknown| table.gives(unknown.parameter));
    note_assumed(&assumed);
    note_measured(setup, &measured, &table);
    let work = interrupt::enable(BEST_SO_FAR);
    let all = deliveries(setup, &table, unknowns, &work.stop);
    drop(work);
    let population = Population::of(setup, &all, unknowns);
    Ok(Deliveries {
        left_out: table.shots.len() - all.len(),
        all,
        population: Some(population),
        from: table.file,
    })
}

/// The range of printed commands that search for the best loft. Without it, a search does not vary
/// a stated loft.
const LOFTS: &str = "club.loft=4deg..20deg";

/// A warning if the loft is neither stated nor varied, and the setup is the preset of an average
/// golfer. The delivery is then found for the loft of the preset, and a later search finds a best
/// loft relative to the loft of the preset.
fn loft_warning(club: &Request, setup: &Setup<f64>, unknowns: &[Unknown]) -> Vec<Message> {
    let is_varied = unknowns
        .iter()
        .any(|unknown| unknown.parameter.name == LOFT);
    if is_varied || !club.has_average(|name| name == LOFT) {
        return vec![];
    }
    let loft = setup.variable(LOFT).ok().map(|parameter| {
        let loft = parameter_text(parameter, setup.club.loft, system());
        format!(
            "{LOFT} = {loft} is the loft of {}; if yours differs, this delivery and a best loft found \
             from it are wrong: state the loft of your club, for example `set {LOFT}=10.5deg`",
            club.source.content.preset.name
        )
    });
    loft.into_iter().map(Message::from).collect()
}

/// A warning about stated parameters that have no effect on the impact, such as air or ground.
/// `None` if a file is written, because the setup file or the printed command contains these
/// parameters.
fn idle_settings_warning(args: &Args, club: &Request) -> Option<Message> {
    if args.output.is_some() || args.swings.is_some() {
        return None;
    }
    // the parameters of strike and ball determine the impact
    let is_of_impact = |name: &str| is_of_strike(name) || name.starts_with("ball.");
    club.unused_warning(
        is_of_impact,
        "the delivery, which depends on the impact only; leave it out, or write the setup with \
         `output FILE`",
    )
}

/// The parameters to find, each with its prior. A stated club value counts as measured by a launch
/// monitor, with the uncertainty of a launch monitor.
fn read_unknowns(args: &Args, request: &Request, setup: &Setup<f64>) -> Result<Vec<Unknown>> {
    let vary = Vary::read_all(setup, &args.vary)?;
    let sigmas = sigmas(setup, &args.sigma)?;
    let measured = |unknown: Unknown| match setup.value(unknown.parameter) {
        Some(value) if request.states(unknown.parameter.name) => Unknown {
            range: unknown.range,
            ..unknown.with_measured_prior(value)
        },
        _ => unknown,
    };
    let all = unknowns(setup, &vary, &sigmas)?;
    Ok(all.into_iter().map(measured).collect())
}

/// The destination of the swings: a table (.csv), or distributions (.toml).
fn swings_destination(rule: &OutputRule, path: &Path) -> Result<Destination> {
    let destination = rule.file(path)?;
    if ["csv", "toml"].contains(&ending(path).as_str()) {
        return Ok(destination);
    }
    let source = format!(
        "the extension of {} is neither .csv nor .toml; write .csv for a row of each shot, or \
         .toml for distributions",
        path.display()
    );
    Err(Error::unreadable("`swings`", source))
}

/// Writes the setup with the delivery, and returns the name of the file; `None` if there is no
/// delivery to write.
fn write_setup(
    output: &Destination,
    found: &Deliveries,
    request: &Request,
    setup: &Setup<f64>,
) -> Result<Option<String>> {
    let why_not = match (found.explained(), found.left_out) {
        (0, _) => Some("no delivery explains its launch"),
        (_, 0) => None,
        _ => Some("the work was interrupted"),
    };
    if let Some(why) = why_not {
        warn([output.not_written(why)]);
        return Ok(None);
    }
    let base = &request.source.content;
    let written = delivery_setup(setup, &found.all, base, &found.from, system())?;
    let file = request.write_setup(output, written)?;
    let what = match found.all.len() {
        1 => "this delivery".into(),
        all => format!("the mean of {} of {all} deliveries", found.explained()),
    };
    note(&format!("wrote the setup with {what} into {file}"));
    note(&format!(
        "to find the loft of the longest carry with this delivery: {}",
        command_line(["optimize", &file, "--vary", LOFTS])
    ));
    Ok(Some(file))
}

/// Writes the swings that explain the shots, and prints the command that optimizes a design over
/// these swings. `setup` has the arguments of this command that give the setup. Returns false if
/// the swings are not written.
fn write_swings(output: &Destination, found: &Deliveries, setup: Vec<String>) -> Result<bool> {
    let Some(population) = &found.population else {
        return Ok(true);
    };
    let is_table = ending(&output.shown) == "csv";
    if let Some(why) = why_no_swings(found, population, is_table) {
        warn([output.not_written(&why)]);
        return Ok(false);
    }
    let text = match population {
        Ok(population) if !is_table => recovered_toml(population, &found.from, system()),
        _ => recovered_csv(&found.all, stated_system().into())?,
    };
    output.write(text.as_bytes())?;
    let file = output.shown.display();
    let explained = found.explained();
    let count = counted(explained as u64, "swing");
    note(&if is_table {
        format!(
            "wrote {count} into {file}: a parameter that a shot does not identify is close to its \
             prior value, so these swings scatter less than the golfer's; for their distribution, \
             name a file that ends in .toml"
        )
    } else {
        format!("wrote the distribution of {count} into {file}")
    });
    if found.all.len() > explained {
        note(&format!(
            "left out of the file: {} whose delivery was not found",
            counted((found.all.len() - explained) as u64, "row")
        ));
    }
    let mut optimize: Vec<OsString> = vec!["optimize".into()];
    optimize.extend(setup.into_iter().map(OsString::from));
    optimize.extend(["--swings".into(), output.shown.clone().into()]);
    optimize.extend(["--vary".into(), LOFTS.into()]);
    note(&format!(
        "to find the best design over these swings: {}",
        command_line(optimize)
    ));
    Ok(true)
}

/// The reason why the swings cannot be written; `None` if they can.
fn why_no_swings(
    found: &Deliveries,
    population: &Result<Population>,
    is_table: bool,
) -> Option<String> {
    if found.left_out > 0 {
        return Some("the work was interrupted".into());
    }
    match population {
        _ if is_table => (found.explained() == 0).then(|| "no delivery was found".into()),
        Ok(_) => None,
        Err(Error::Delivery { reason }) => Some(reason.clone()),
        Err(error) => Some(error.to_string()),
    }
}

/// A parameter's prior, such as "swing.speed = 110 mph ± 15 mph".
fn prior_text(unknown: &Unknown) -> String {
    let value = parameter_text(unknown.parameter, unknown.prior, system());
    let sigma = parameter_difference_text(unknown.parameter, unknown.sigma, system());
    format!("{} = {value} ± {sigma}", unknown.parameter.name)
}

/// Prints the default priors: one note for each source.
fn note_assumed(unknowns: &[Unknown]) {
    let mut sources: Vec<&str> = vec![];
    for source in unknowns.iter().filter_map(|unknown| unknown.source) {
        if !sources.contains(&source) {
            sources.push(source);
        }
    }
    for source in sources {
        let from_source = unknowns
            .iter()
            .filter(|unknown| unknown.source == Some(source));
        let priors: Vec<String> = from_source.map(prior_text).collect();
        note(&format!(
            "prior, ± one standard deviation: {}; {source}",
            priors.join(", ")
        ));
    }
}

/// Prints a note for each unknown that a column of the table measures, with its uncertainty, and
/// with the prior of the rows that do not state it.
fn note_measured(setup: &Setup<f64>, unknowns: &[Unknown], table: &ShotTable) {
    for unknown in unknowns {
        let name = unknown.parameter.name;
        let measured =
            unknown.with_measured_prior(setup.value(unknown.parameter).unwrap_or_default());
        let sigma = parameter_difference_text(unknown.parameter, measured.sigma, system());
        let source = measured.source.unwrap_or("as given");
        let mut shots = table.shots.iter();
        let (rows, others) = if shots.all(|shot| shot.gives(unknown.parameter)) {
            ("each row", String::new())
        } else {
            let source = unknown.source.unwrap_or("as given");
            let others = format!(". In the other rows: {}; {source}", prior_text(unknown));
            ("the rows that state it", others)
        };
        note(&format!(
            "prior: {name} as in {rows} ± {sigma} (one standard deviation); {source}{others}"
        ));
    }
}

/// The requests for the club and for the measured launch, from one command line.
struct Requests {
    club: Request,
    launched: Request,
}

impl Requests {
    fn new(args: &Args) -> Result<Self> {
        let mut source = Source::read(&args.drive.setup)?;
        let mut club = source.clone();
        (source.stated, club.stated) = source
            .stated
            .into_iter()
            .partition(|name| name.starts_with("launch."));
        source.content.given.retain(|row| !is_of_strike(row.name));
        let own = &mut club.content.setup;
        for condition in own.given_launch_conditions() {
            own.set_value(condition, None)?;
        }
        let (mut of_launch, of_club): (Vec<_>, Vec<_>) = args
            .drive
            .settings()?
            .into_iter()
            .partition(CommandSetting::is_of_launch);
        let options = [
            ("ball_speed", &args.ball_speed),
            ("launch_angle", &args.launch_angle),
            ("launch_direction", &args.launch_direction),
            ("backspin", &args.backspin),
            ("sidespin", &args.sidespin),
            ("spin", &args.spin),
            ("spin_axis", &args.spin_axis),
        ];
        for (name, text) in options {
            if let Some(text) = text {
                of_launch.push(CommandSetting::of_launch(name, name, text)?);
            }
        }
        Ok(Self {
            club: Request::of_drive(club, of_club)?,
            launched: Request::of_drive(source, of_launch)?,
        })
    }

    /// The setup with the measured launch. A launch condition in the arguments is an error with
    /// `--shots`, because each shot has its own launch.
    fn setup_of_launch(&self, args: &Args) -> Result<Setup<f64>> {
        if args.shots.is_some() {
            self.launched.refuse_launch(
                &self.launched.partial_setup,
                "each shot has its own launch; give the shots or a launch, not both",
            )?;
        }
        let launched = self.launched.setup()?;
        if args.shots.is_none() && !launched.launch.is_given() {
            return Err(Error::unreadable(
                "delivery",
                "no launch is given; add `ball_speed`, `launch_angle` and `spin` (or \
                 `backspin`), or `shots FILE`",
            ));
        }
        Ok(launched)
    }
}
