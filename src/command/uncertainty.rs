use crate::command::args::{SetupArgs, whole};
use crate::command::names::{outcomes, sigmas};
use crate::command::output::{Answer, note_detail, system, warn, with_bar};
use crate::command::request::Request;
use crate::report::{UncertaintyReport, parameter_difference_text};
use crate::study::uncertainty::{SamplePlan, Uncertain, uncertainty};
use crate::study::{refuse_given_twice, with_defaults};
use crate::{Outcome, Result, Setup};

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    /// The outcomes, separated by commas; "all" for every one. For carry and lateral together,
    /// landing ellipses are computed.
    #[arg(
        long,
        value_name = "OUTCOME,…",
        value_delimiter = ',',
        default_value = "carry,lateral"
    )]
    pub of: Vec<String>,

    /// The standard deviation of a parameter that is normally distributed about its value, e.g.
    /// swing.speed=1mph or air.density=0.5% of its value. Repeatable. Unlike in "sensitivity", only
    /// the parameters of --sigma and --distribution are then uncertain [default, without both: the
    /// uncertainties that "sensitivity" uses].
    #[arg(long, value_name = "NAME=AMOUNT")]
    pub sigma: Vec<String>,

    /// The distribution of a parameter: NAME=normal(MEAN,DEVIATION), NAME=uniform(LOW,HIGH),
    /// NAME=triangular(LOW,MODE,HIGH) or NAME=truncated(MEAN,DEVIATION,LOW,HIGH). Repeatable.
    #[arg(long, value_name = "NAME=KIND(…)")]
    pub distribution: Vec<String>,

    /// The number of points N of the sample; with k uncertain parameters, N (k + 2) drives are
    /// computed.
    #[arg(
        long,
        value_name = "N",
        default_value_t = 4096,
        value_parser = whole::<u64>(2..=1_000_000, "`samples 4096`"),
        allow_negative_numbers = true,
    )]
    pub samples: u64,

    /// The seed of the sample; the same seed gives the same sample.
    #[arg(
        long,
        value_name = "SEED",
        default_value_t = 0,
        value_parser = whole::<u64>(0..=u64::MAX, "`seed 7`"),
        allow_negative_numbers = true,
    )]
    pub seed: u64,
}

pub fn run(args: &Args) -> Result<Answer> {
    let request = args.setup_args.request()?;
    let mut setup = request.partial_setup;
    if args.sigma.is_empty() && args.distribution.is_empty() {
        setup = request.with_assumed_launch(setup)?;
    }
    let of = outcomes(&args.of)?;
    let inputs = inputs(&request, &setup, args, &of)?;
    let means = inputs
        .iter()
        .map(|input| (input.parameter, input.distribution.mean()));
    let setup = request.fill_missing(setup, means, "varies about")?;
    let setup = request.for_many(
        setup,
        &inputs.iter().map(Uncertain::range).collect::<Vec<_>>(),
    )?;
    warn(setup.drive_warnings(&of));
    let plan = SamplePlan {
        samples: args.samples as usize,
        seed: args.seed,
    };
    let found = with_bar("drives", |show| {
        uncertainty(&setup, &of, &inputs, plan, show)
    })?;
    warn(found.warnings());
    let is_found = found
        .outcomes
        .iter()
        .all(|outcome| outcome.monte_carlo.is_some());
    let report = UncertaintyReport::new(&found);
    let answer = Answer::report(&report, &request.origin());
    Ok(answer.found(is_found))
}

/// The uncertain parameters: those that the options state, or else the default uncertainties.
fn inputs(
    request: &Request,
    setup: &Setup<f64>,
    args: &Args,
    of: &[Outcome],
) -> Result<Vec<Uncertain>> {
    let sigmas = sigmas(setup, &args.sigma)?;
    let distributions = args
        .distribution
        .iter()
        .map(|text| Uncertain::read(setup, text))
        .collect::<Result<Vec<_>>>()?;
    let distributed: Vec<_> = distributions.iter().map(|input| input.parameter).collect();
    request.refuse_stated_besides_launch(&distributed, "`distribution` gives its values")?;
    let is_given = !(sigmas.is_empty() && distributions.is_empty());
    let sigmas = if is_given {
        sigmas
    } else {
        with_defaults(setup, &[], of)?
    };
    for sigma in sigmas.iter() {
        if let Some(source) = sigma.source {
            let shown = parameter_difference_text(sigma.parameter, sigma.value, system());
            note_detail(&format!(
                "default uncertainty: {} ± {shown} (one standard deviation); {source}",
                sigma.parameter.name
            ));
        }
    }
    let inputs: Vec<_> = sigmas
        .iter()
        .map(|sigma| Uncertain::normal(setup, sigma))
        .chain(distributions)
        .collect();
    refuse_given_twice(inputs.iter().map(|input| input.parameter))?;
    Ok(inputs)
}
