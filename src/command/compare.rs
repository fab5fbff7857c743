use crate::command::args::SetupArgs;
use crate::command::names::outcomes;
use crate::command::output::{Answer, is_json, note, note_error, spinner, warn};
use crate::command::request::{CommandSetting, Request, Source, refuse_duplicates, warn_of_idle};
use crate::report::{ComparisonReport, SetupOrigin};
use crate::study::Comparison;
use crate::{Error, Outcome, Result};
use std::collections::BTreeSet;

/// The two drives.
#[derive(clap::Args)]
pub struct PairArgs {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    /// The second drive, b: a preset's name or a TOML file; SETUP is the first drive, a [default:
    /// the setup of a].
    #[arg(value_name = "SETUP_B")]
    pub other: Option<String>,

    /// Set a parameter of drive a only, in place of --set. --set and --launch apply to both drives.
    /// Repeatable.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set_a: Vec<String>,

    /// Set a parameter of drive b only, in place of --set, e.g. club.loft=10.5deg. Repeatable.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set_b: Vec<String>,

    /// The launch conditions of drive a, as in --launch.
    #[arg(long, value_name = "NAME=VALUE,…", value_delimiter = ',')]
    pub launch_a: Vec<String>,

    /// The launch conditions of drive b, as in --launch.
    #[arg(long, value_name = "NAME=VALUE,…", value_delimiter = ',')]
    pub launch_b: Vec<String>,
}

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub pair: PairArgs,

    /// The outcomes whose difference is split, separated by commas; "all" for every outcome of a
    /// drive.
    #[arg(
        long,
        value_name = "OUTCOME,…",
        value_delimiter = ',',
        default_value = "carry"
    )]
    pub of: Vec<String>,
}

pub fn run(args: &Args) -> Result<Answer> {
    let of = outcomes(&args.of)?;
    let requests = args.pair.requests()?;
    let comparison = args.pair.comparison(&requests)?;
    warn(comparison.warnings(Outcome::OF_DRIVES));
    let origin = origin_of_pair(&requests);
    if !is_json() && !origin.advice.is_empty() {
        note(&origin.advice);
    }
    let spinner = spinner("splitting the difference");
    let found = comparison.of_each(&of);
    spinner.finish();
    let (mut each, mut is_complete) = (vec![], true);
    for (of, difference) in of.into_iter().zip(found) {
        match difference {
            // report the other outcomes if one has no value (no landing, no direction)
            Err(error) if error.has_valid_input() => {
                is_complete = false;
                note_error(&error);
                each.push((of, Err(error)));
            }
            difference => each.push((of, Ok(difference?))),
        }
    }
    let report = ComparisonReport::new(&comparison, &each, requests.each_ref().map(Request::title));
    Ok(Answer::report(&report, &origin).found(is_complete))
}

/// The advice on the loft of the first drive that needs it. There is no title: the answer itself
/// names both setups.
pub fn origin_of_pair(requests: &[Request; 2]) -> SetupOrigin {
    let advice = requests.iter().find_map(Request::loft_advice);
    SetupOrigin {
        advice: advice.unwrap_or_default(),
        ..SetupOrigin::default()
    }
}

/// Names of the drives in errors.
const A: &str = Comparison::NAMES[0];
const B: &str = Comparison::NAMES[1];

impl PairArgs {
    /// The requests of the two drives.
    ///
    /// # Errors
    /// [`Error::Unreadable`] if the command line states no difference, and the errors of
    /// [`SetupArgs::request`] for each drive.
    pub fn requests(&self) -> Result<[Request; 2]> {
        let own = [&self.set_a, &self.set_b, &self.launch_a, &self.launch_b];
        if self.other.is_none() && own.iter().all(|options| options.is_empty()) {
            let source = "there is one drive; name a second setup, or state a change for drive b, \
                          for example `set_b club.loft=10.5deg`";
            return Err(Error::unreadable("compare", source));
        }
        let source_a =
            Source::read(&self.setup_args.drive.setup).map_err(|error| error.of_drive(A))?;
        let source_b = match &self.other {
            Some(other) => Source::read(other).map_err(|error| error.of_drive(B))?,
            None => source_a.clone(),
        };
        let settings_a = self.settings(
            CommandSetting::read_all("set_a", &self.set_a)?,
            CommandSetting::read_all_launch("launch_a", &self.launch_a)?,
        )?;
        let settings_b = self.settings(
            CommandSetting::read_all("set_b", &self.set_b)?,
            CommandSetting::read_all_launch("launch_b", &self.launch_b)?,
        )?;
        Ok([
            Request::new(source_a, settings_a, &self.setup_args)
                .map_err(|error| error.of_drive(A))?,
            Request::new(source_b, settings_b, &self.setup_args)
                .map_err(|error| error.of_drive(B))?,
        ])
    }

    /// The settings of a drive: its own settings, and the common settings. An own setting replaces
    /// a common setting of the same parameter.
    fn settings(
        &self,
        own_set: Vec<CommandSetting>,
        own_launch: Vec<CommandSetting>,
    ) -> Result<Vec<CommandSetting>> {
        let own = [own_set, own_launch].concat();
        let common = self.setup_args.drive.settings()?;
        refuse_duplicates(&common)?;
        let is_replaced =
            |setting: &CommandSetting| own.iter().any(|own| own.parameter == setting.parameter);
        let common = common.into_iter().filter(|setting| !is_replaced(setting));
        let settings: Vec<_> = common.chain(own.iter().cloned()).collect();
        refuse_duplicates(&settings)?;
        Ok(settings)
    }

    /// The comparison of the two drives.
    ///
    /// # Errors
    /// The errors of [`Request::one_of_two_within_tolerance`] and [`Comparison::new`].
    pub fn comparison(&self, [a, b]: &[Request; 2]) -> Result<Comparison> {
        let setups = [
            a.one_of_two_within_tolerance()
                .map_err(|error| error.of_drive(A))?,
            b.one_of_two_within_tolerance()
                .map_err(|error| error.of_drive(B))?,
        ];
        let given: BTreeSet<_> = a.given().chain(b.given()).collect();
        warn_of_idle(given, &setups);
        let comparison = Comparison::new(&setups[0], &setups[1])?;
        if comparison.is_refined {
            let setup = &comparison.setups[0];
            note(&format!(
                "note: both drives are flown with flight.method = {} and flight.step = {} s: the \
                 higher order and the shorter step of the two setups",
                setup.method.name(),
                setup.flight.step
            ));
        }
        Ok(comparison)
    }
}
