use crate::command::args::{SearchArgs, SetupArgs};
use crate::command::names::{outcomes, sigmas};
use crate::command::output::{Answer, note, system, warn, with_bar};
use crate::command::request::Request;
use crate::derivative::all_variables;
use crate::parameters::{Parameter, Vary};
use crate::report::{SensitivityReport, SetupOrigin, by_reason};
use crate::study::{
    Effects, Optimum, Sensitivity, Sigma, SigmaEffect, effects, flown_off, sensitivities,
    with_defaults,
};
use crate::units::Message;
use crate::{Drive, Error, Outcome, Result, Setup};

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    /// The outcomes, separated by commas; "all" for every one.
    #[arg(
        long,
        value_name = "OUTCOME,…",
        value_delimiter = ',',
        default_value = "carry"
    )]
    pub of: Vec<String>,

    /// The standard uncertainty of a parameter, as an amount (swing.speed=1mph) or as a percentage
    /// of its value (air.density=0.5%). Repeatable.
    #[arg(long, value_name = "NAME=AMOUNT")]
    pub sigma: Vec<String>,

    /// Use no default uncertainties: only parameters with a --sigma are uncertain.
    #[arg(long)]
    pub no_defaults: bool,

    /// Compute the slopes and effects at the optimum of a search, and show the total derivatives of
    /// the optimum too.
    #[arg(long)]
    pub at_optimum: bool,

    #[command(flatten)]
    pub search: SearchArgs,
}

pub fn run(args: &Args) -> Result<Answer> {
    let request = args.setup_args.request()?;
    let of = outcomes(&args.of)?;
    if args.at_optimum {
        let instead = "without `at_optimum`, the answer is about the drive as stated";
        let mut drive_search = args.search.of_drive(&request, None, Some(instead))?;
        drive_search.setup = args.with_assumed_launch(&request, drive_search.setup)?;
        // refuse wrong names before the search; the amounts are read at the optimum, because a
        // percentage is relative to the value there
        let initialized = Vary::initialized(&drive_search.setup, &drive_search.search.vary)?;
        for text in &args.sigma {
            Sigma::named(&initialized, text)?;
        }
        let best = drive_search.optimum()?;
        best.check_converged()?;
        note(&best.message().in_units(system()));
        return answer(args, &of, &best.setup, Some(&best), &drive_search.origin);
    }
    let setup = request.setup_within_tolerance()?;
    if let Some(option) = args.search.stated().next() {
        let source = "it is an option of the search for an optimum; add `at_optimum`, or leave it \
                      out";
        return Err(Error::unreadable(option, source));
    }
    let setup = args.with_assumed_launch(&request, setup)?;
    answer(args, &of, &setup, None, &request.origin())
}

/// The slopes and effects at the drive `setup`. With `--at-optimum`, `best` is the optimum with this
/// setup.
fn answer(
    args: &Args,
    of: &[Outcome],
    setup: &Setup<f64>,
    best: Option<&Optimum>,
    origin: &SetupOrigin,
) -> Result<Answer> {
    let given = sigmas(setup, &args.sigma)?;
    let sigmas = if args.no_defaults {
        given
    } else {
        with_defaults(setup, &given, of)?
    };
    let drive = Drive::new(setup)?;
    warn(drive.warnings_about(setup, of));
    let found = with_bar("uncertainties", |show| effects(setup, of, &sigmas, show))?;
    // the report has no value where the drive at −σ or +σ is missing: warn with the reason
    let unflown = found.first().map(|effects| unflown(setup, of, effects));
    warn(unflown.into_iter().flatten());
    let slopes = best.map(total_slopes).transpose()?;
    warn(slopes.iter().flat_map(|slopes| missing_slopes(slopes)));
    let totals = slopes.as_deref().unwrap_or_default();
    let report = SensitivityReport::new(&found, best, totals);
    Ok(Answer::report(&report, origin))
}

impl Args {
    /// The setup with assumed launch conditions, which default uncertainties need. Unchanged with
    /// `--no-defaults`.
    fn with_assumed_launch(&self, request: &Request, setup: Setup<f64>) -> Result<Setup<f64>> {
        match self.no_defaults {
            true => Ok(setup),
            false => request.with_assumed_launch(setup),
        }
    }
}

/// Total derivatives of the optimal outcome by every parameter that is not varied, with the varied
/// parameters re-optimized. Omits the parameters of the roll-out if no outcome of the search
/// depends on the roll-out.
fn total_slopes(best: &Optimum) -> Result<Vec<(&'static Parameter, Result<Sensitivity>)>> {
    let varied: Vec<_> = best.search.parameters().collect();
    let mut wrt = all_variables(&best.setup, &best.search.outcomes());
    wrt.retain(|parameter| !varied.contains(parameter));
    sensitivities(best, &wrt, &|_, _| ())
}

/// Warnings about missing total derivatives, with the reasons.
fn missing_slopes(slopes: &[(&'static Parameter, Result<Sensitivity>)]) -> Vec<Message> {
    let reasons = slopes
        .iter()
        .filter_map(|(parameter, slope)| Some((parameter.name, slope.as_ref().err()?)))
        .map(|(name, error)| (name, error.in_units(system())));
    by_reason(reasons)
        .iter()
        .map(|line| format!("no slope of the optimum by {line}").into())
        .collect()
}

/// A warning for each end (−σ or +σ) of an uncertainty at which the drive is missing, with the
/// reason.
fn unflown(setup: &Setup<f64>, of: &[Outcome], effects: &Effects) -> Vec<Message> {
    let why = |bar: &SigmaEffect, sign: f64| flown_off(setup, of, &bar.sigma, sign).err();
    let ends = effects.sigma_effects().flat_map(|bar| {
        let ends = bar
            .flown
            .into_iter()
            .zip([-1.0, 1.0])
            .filter(|(flown, _)| flown.is_none());
        ends.filter_map(move |(_, sign)| {
            let end = if sign < 0.0 { "−σ" } else { "+σ" };
            let missing = format!("no drive at {end} of {}: ", bar.sigma.parameter.name);
            Some(Message::from(missing).message(why(bar, sign)?.message()))
        })
    });
    ends.collect()
}
