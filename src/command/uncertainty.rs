use crate::command::args::UncertaintyArgs;
use crate::command::names::outcomes;
use crate::command::output::{Answer, bar, show, system, tell_detail, warn};
use crate::command::request::Request;
use crate::report::{UncertaintyReport, parameter_difference_text};
use crate::study::uncertainty::{SamplePlan, Uncertain, uncertainty};
use crate::study::{Sigma, given_twice, with_defaults};
use crate::{Drive, Outcome, Result, Setup};

pub fn run(args: &UncertaintyArgs) -> Result<Answer> {
    let request = args.setup_args.request()?;
    let setup = request.setup()?;
    let of = outcomes(&args.of)?;
    let inputs = inputs(&request, &setup, args, &of)?;
    let means = inputs
        .iter()
        .map(|input| (input.parameter, input.distribution.mean()));
    let setup = request.with_values(setup, means, "varies about")?;
    let setup = request.for_many(
        setup,
        &inputs.iter().map(Uncertain::range).collect::<Vec<_>>(),
    )?;
    let mut warnings = Drive::new(&setup).map_or_else(
        |_| setup.warnings(),
        |drive| drive.warnings_about(&setup, &of),
    );
    warn(&warnings);
    let plan = SamplePlan {
        samples: args.samples as usize,
        seed: args.seed,
    };
    let bar = bar("drives");
    let found = uncertainty(&setup, &of, &inputs, plan, &|done, all| {
        show(&bar, done, all)
    });
    bar.finish();
    let found = found?;
    let of_sample = found.warnings();
    warn(&of_sample);
    warnings.extend(of_sample);
    let is_found = found
        .outcomes
        .iter()
        .all(|outcome| outcome.sampled.is_some());
    let report = UncertaintyReport::new(&found);
    let answer = Answer::report(&report, &request.origin(), warnings, request.is_json());
    Ok(answer.found(is_found))
}

/// The uncertain parameters that the options state, or the defaults.
fn inputs(
    request: &Request,
    setup: &Setup<f64>,
    args: &UncertaintyArgs,
    of: &[Outcome],
) -> Result<Vec<Uncertain>> {
    let sigmas = args
        .sigma
        .iter()
        .map(|text| Sigma::read(setup, text))
        .collect::<Result<Vec<_>>>()?;
    let distributions = args
        .distribution
        .iter()
        .map(|text| Uncertain::read(setup, text))
        .collect::<Result<Vec<_>>>()?;
    let distributed: Vec<_> = distributions.iter().map(|input| input.parameter).collect();
    request.refuse_stated_with_default(&distributed, "`distribution` gives its values")?;
    let is_given = !(sigmas.is_empty() && distributions.is_empty());
    let sigmas = if is_given {
        sigmas
    } else {
        with_defaults(setup, &[], of)?
    };
    for sigma in sigmas.iter() {
        if let Some(source) = sigma.source {
            let shown = parameter_difference_text(sigma.parameter, sigma.value, system());
            tell_detail(&format!(
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
    for (i, input) in inputs.iter().enumerate() {
        if inputs[..i]
            .iter()
            .any(|other| other.parameter == input.parameter)
        {
            return Err(given_twice(input.parameter));
        }
    }
    Ok(inputs)
}
