use crate::command::args::SetupArgs;
use crate::command::names::{outcomes, variables};
use crate::command::output::{Answer, note_error, warn, with_bar};
use crate::derivative::{Evaluator, Order, Taylor, default_variables, evaluate};
use crate::parameters::Parameter;
use crate::report::GradientReport;
use crate::{Drive, Outcome, Result, Setup};

/// The outcomes and the parameters of derivatives.
#[derive(clap::Args)]
pub struct DerivativeArgs {
    /// The outcomes, separated by commas.
    #[arg(
        long,
        value_name = "OUTCOME,…",
        value_delimiter = ',',
        default_value = "carry"
    )]
    pub of: Vec<String>,

    /// The parameters, separated by commas; "all" for every one that has a value in this setup.
    /// By default: loft and attack angle, or the launch conditions if they are given.
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    wrt: Vec<String>,
}

impl DerivativeArgs {
    /// The parameters by which the outcomes `of` are differentiated.
    ///
    /// # Errors
    /// For an unknown name, and for a parameter without a value.
    pub fn variables(&self, setup: &Setup<f64>, of: &[Outcome]) -> Result<Vec<&'static Parameter>> {
        if self.wrt.is_empty() {
            return default_variables(setup);
        }
        variables(setup, &self.wrt, of)
    }
}

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub derivatives: DerivativeArgs,

    /// Compute the second derivatives (the Hessian) too.
    #[arg(long)]
    pub hessian: bool,
}

pub fn run(args: &Args) -> Result<Answer> {
    let request = args.setup_args.request()?;
    let setup = request.setup_within_tolerance()?;
    let of = outcomes(&args.derivatives.of)?;
    let wrt = args.derivatives.variables(&setup, &of)?;
    let drive = Drive::new(&setup)?;
    warn(drive.warnings_about(&setup, &of));

    let order = if args.hessian {
        Order::Second
    } else {
        Order::First
    };
    let evaluated = with_bar("passes", |show| {
        Evaluator::new(&setup, &of, &wrt, order)?.at_setup(None, show)
    });
    let each: Vec<Result<Taylor>> = match evaluated {
        // report the other outcomes if one has no value (no landing, no direction)
        Err(error) if error.has_valid_input() => {
            let one = |of| Ok(evaluate(&setup, &[of], &wrt, order)?.swap_remove(0));
            of.iter().copied().map(one).collect()
        }
        evaluated => evaluated?.into_iter().map(Ok).collect(),
    };
    let mut is_complete = true;
    for error in each.iter().filter_map(|taylor| taylor.as_ref().err()) {
        is_complete = false;
        note_error(error);
    }

    let found: Vec<_> = of.into_iter().zip(each).collect();
    let report = GradientReport::new(&found, &wrt);
    let answer = Answer::report(&report, &request.origin());
    Ok(answer.found(is_complete))
}
