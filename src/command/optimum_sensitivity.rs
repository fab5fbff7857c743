use crate::command::args::{Optimize, OptimumSensitivity};
use crate::command::names::variables;
use crate::command::output::{Answer, bar, show, spinner, system, tell, tell_error, warn};
use crate::command::search::write;
use crate::parameters::Parameter;
use crate::report::{Analysis, OverSwings, SensitivityReport, optimum_text};
use crate::study::{
    Change, Changed, Flatness, Optimum, Sensitivity, change, flatness, refuse_varied,
    sensitivities, short_drive, usual_loss,
};
use crate::{Error, Outcome, Result, Setup};
use std::sync::atomic::AtomicBool;

pub fn run(args: &OptimumSensitivity) -> Result<Answer> {
    let Optimize {
        setup_args,
        search,
        swings,
        work,
        ..
    } = &args.optimize;
    swings.refuse_stray()?;
    if swings.is_given() {
        let source =
            "the sensitivity of an optimum is that of one drive; leave it out, or use \"optimize\"";
        return Err(Error::Unreadable {
            name: "`swings` or `distribution`".into(),
            source: source.into(),
        });
    }
    let request = setup_args.request()?;
    let setup = request.setup_with_starts(&search.vary)?;
    let search = search.search(&setup)?;
    let asked = setup;
    let setup = request.for_many(asked, &search.vary)?;
    let wrt = variables(&setup, &args.wrt, &search.outcomes())?;
    let changes = args
        .change
        .iter()
        .map(|text| Change::read(&setup, text))
        .collect::<Result<Vec<_>>>()?;
    let is_named =
        |parameter: &Parameter| args.wrt.iter().any(|name| name.trim() == parameter.name);
    let named = wrt.iter().copied().filter(|parameter| is_named(parameter));
    for parameter in named.chain(changes.iter().map(|change| change.parameter)) {
        refuse_varied(&search, parameter)?;
    }
    let loss = args
        .loss
        .as_deref()
        .map(|text| loss(search.outcome(), text))
        .transpose()?;

    let output = args.optimize.destination(&request)?;
    let optima = work.run(&setup, &search)?;
    let best = &optima.best;
    let written = output
        .as_ref()
        .map(|output| write(output, &request, &optima, None))
        .transpose()?
        .flatten();
    if let Some(moved) = best.moved_start() {
        tell(&moved);
    }
    let warnings = best.warnings(&AtomicBool::new(false));
    warn(&warnings);
    if optima.stopped() > 0 {
        let answer = if request.is_json() {
            Answer::json(&SensitivityReport::none(&optima, None, warnings))
        } else {
            Answer::text(optimum_text(best, OverSwings::default(), system()))
        };
        return Ok(answer.found(false));
    }
    // each search chooses its own step, as "optimize" there does
    let integrated = |mut changed: Setup<f64>| {
        (changed.method, changed.flight.step) = (asked.method, asked.flight.step);
        request.for_many(changed, &search.vary)
    };
    let changed = |stated: &Change| change(best, *stated, &integrated);
    let found = analysed(best, &wrt, &|| changes.iter().map(changed).collect(), loss);
    let (sensitivities, flatness, changes) = match found {
        Err(error) if error.is_an_outcome() => {
            tell_error(&error);
            let answer = if request.is_json() {
                let mut reply = SensitivityReport::none(&optima, Some(&error), warnings);
                reply.body.optimum.file = written;
                Answer::json(&reply)
            } else {
                Answer::text(optimum_text(best, OverSwings::default(), system()))
            };
            return Ok(answer.found(false));
        }
        found => found?,
    };
    // where nothing that was asked for exists, there is no answer
    let is_answered = sensitivities.is_empty()
        || sensitivities
            .iter()
            .any(|(_, sensitivity)| sensitivity.is_ok());
    let analysis = Analysis {
        best,
        sensitivities: &sensitivities,
        flatness: &flatness,
        changes: &changes,
    };
    let answer = if request.is_json() {
        let mut reply = SensitivityReport::reply(&optima, &analysis, warnings);
        reply.body.optimum.file = written;
        Answer::json(&reply)
    } else {
        let text = optimum_text(best, OverSwings::default(), system());
        Answer::text(text + "\n" + &analysis.document(system()).text())
    };
    Ok(answer.found(is_answered))
}

/// Sensitivities, flatness, and the effects of stated changes.
type Found = (
    Vec<(&'static Parameter, Result<Sensitivity>)>,
    Flatness,
    Vec<Changed>,
);

fn analysed(
    best: &Optimum,
    wrt: &[&'static Parameter],
    changes: &dyn Fn() -> Result<Vec<Changed>>,
    loss: Option<f64>,
) -> Result<Found> {
    let wrt: Vec<_> = wrt
        .iter()
        .copied()
        .filter(|p| best.search.vary.iter().all(|vary| vary.parameter != *p))
        .collect();
    let bar = bar("parameters");
    let sensitivities = sensitivities(best, &wrt, &mut |done, of| show(&bar, done, of));
    bar.finish_and_clear();
    if let (None, Some((_, said))) = (loss, short_drive(best)) {
        tell(said);
    }
    let loss = loss.unwrap_or_else(|| usual_loss(best));
    let spinner = spinner("computing drives around the optimum");
    let changed = changes()?;
    let flatness = flatness(best, loss)?;
    spinner.finish_and_clear();
    Ok((sensitivities?, flatness, changed))
}

fn loss(of: Outcome, text: &str) -> Result<f64> {
    let refuse = |source| Error::Unreadable {
        name: format!("`loss {text}`"),
        source,
    };
    match of.quantity().read(text) {
        Ok(loss) if loss > 0.0 && loss.is_finite() => Ok(loss),
        Ok(_) => Err(refuse(
            "it must be above 0 and finite, for example 1yd".into(),
        )),
        Err(error) => Err(refuse(Box::new(error))),
    }
}
