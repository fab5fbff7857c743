use crate::command::args::SensitivityArgs;
use crate::command::names::outcomes;
use crate::command::output::{Answer, bar, show, system, tell, warn};
use crate::optimize::{Observer, Status};
use crate::parameters::Parameter;
use crate::report::{EffectsReport, by_reason};
use crate::study::{
    Bar, Effects, Sensitivity, Sigma, effects, flown_off, optimum, sensitivities, with_defaults,
};
use crate::units::Message;
use crate::{Drive, Error, Outcome, Result, Setup};

pub fn run(args: &SensitivityArgs) -> Result<Answer> {
    let request = args.setup_args.request()?;
    let mut setup = request.within_tolerance(request.setup()?)?;
    let of = outcomes(&args.of)?;
    let given = args
        .sigma
        .iter()
        .map(|text| Sigma::read(&setup, text))
        .collect::<Result<Vec<_>>>()?;
    let mut best = None;
    if let ([option, ..], false) = (args.search.given().as_slice(), args.at_optimum) {
        let source =
            "it is about the search for an optimum; add `at_optimum`, or leave it out".into();
        return Err(Error::Unreadable {
            name: (*option).into(),
            source,
        });
    }
    if args.at_optimum {
        let search = args.search.search(&setup)?;
        setup = request.for_many(setup, &search.vary)?;
        let found = optimum(&setup, search, Observer::default())?;
        if found.solution.status != Status::Converged {
            return Err(Error::NotConverged {
                status: found.status(),
                message: found.message(),
            });
        }
        tell(&found.message().in_units(system()));
        setup = found.setup;
        best = Some(found);
    }
    let sigmas = if args.no_defaults {
        given
    } else {
        with_defaults(&setup, &given, &of)?
    };
    let drive = Drive::new(&setup)?;
    let mut warnings = drive.warnings_about(&setup, &of);
    warn(&warnings);
    let bar = bar("uncertainties");
    let found = effects(&setup, &of, &sigmas, &mut |done, all| show(&bar, done, all));
    bar.finish_and_clear();
    let found = found?;
    // a dash in its column would not say why
    let unflown = found
        .first()
        .map_or(vec![], |effects| unflown(&setup, &of, effects));
    warn(&unflown);
    warnings.extend(unflown);
    let totals = match &best {
        Some(best) => {
            let varied = |row: &&_| !best.search.vary.iter().any(|vary| vary.parameter == *row);
            let runs = best.search.outcomes().iter().any(|of| of.needs_run());
            let counts = |row: &&Parameter| runs || !row.affects_only_run();
            let wrt: Vec<_> = setup
                .variables()
                .into_iter()
                .filter(varied)
                .filter(counts)
                .collect();
            Some((
                best.search.outcome(),
                sensitivities(best, &wrt, &mut |_, _| ())?,
            ))
        }
        None => None,
    };
    // a dash in its column would not say why
    let why = |(row, slope): &(&Parameter, Result<Sensitivity>)| {
        Some((row.name, slope.as_ref().err()?.to_string()))
    };
    let missing = by_reason(totals.iter().flat_map(|(_, all)| all).filter_map(why));
    let missing: Vec<_> = missing
        .iter()
        .map(|line| format!("no slope of the optimum by {line}").into())
        .collect();
    warn(&missing);
    warnings.extend(missing);
    let totals = totals.as_ref().map(|(of, all)| (*of, all.as_slice()));
    let report = EffectsReport::new(&found, best.as_ref(), totals);
    Ok(Answer::report(&report, warnings, request.is_json()))
}

/// Why there is no drive at one end of an uncertainty, for each that has none.
fn unflown(setup: &Setup<f64>, of: &[Outcome], effects: &Effects) -> Vec<Message> {
    let why = |bar: &Bar, sign: f64| flown_off(setup, of, &bar.sigma, sign).err();
    let ends = effects
        .effects
        .iter()
        .filter_map(|effect| effect.bar)
        .flat_map(|bar| {
            let ends = bar
                .flown
                .into_iter()
                .zip([-1.0, 1.0])
                .filter(|(flown, _)| flown.is_none());
            ends.filter_map(move |(_, sign)| {
                let end = if sign < 0.0 { "−σ" } else { "+σ" };
                Some(
                    format!(
                        "no drive at {end} of {}: {}",
                        bar.sigma.parameter.name,
                        why(&bar, sign)?
                    )
                    .into(),
                )
            })
        });
    ends.collect()
}
