//! The `design` command: the best head and face.

use crate::command::args::{DesignArgs, Optimize};
use crate::command::interrupt;
use crate::command::output::{Answer, system};
use crate::command::ranges::DefaultRanges;
use crate::command::request::Request;
use crate::command::swings::{SwingsSearch, found, sought};
use crate::parameters::Parameter;
use crate::report::Designed;
use crate::study::design::{Design, GOLFER, golfer, improvements, usual_vary};
use crate::study::swings::{Scenarios, Swings};
use crate::study::{Goal, Search, Sense};
use crate::{Error, Result, Setup};

/// The default objective.
const GOAL: &str = "mean(carry) - 0.5*rms(lateral)";

pub fn run(args: &DesignArgs) -> Result<Answer> {
    let search = &args.optimize;
    let request = search.setup_args.request()?;
    refuse_unnamed_preset(&request)?;
    let setup = request.setup()?;
    refuse_launch(&request, &setup)?;
    let swings = if search.swings.is_given() {
        search.swings.read(&setup)?
    } else {
        search.swings.refuse_correlation()?;
        golfer(&setup)?
    };
    request.refuse_stated(&distributed(args, &swings), "the swings have values of it")?;
    let setup = request.with_values(
        setup,
        swings.parameters().into_iter().zip(swings.means()),
        "varies about",
    )?;
    let asked = sought(
        &search.search,
        &search.swings,
        &request.with_starts(setup, &search.search.vary)?,
        &|| Ok((Goal::read(GOAL, None)?, Sense::Maximize)),
        &|setup| DefaultRanges::new(usual_vary(setup)?, &request).vary(),
    )?;
    request.note_starts(&setup, &asked.vary);
    let mut notes = notes_on_defaults(args, &asked);
    let scenarios = Scenarios::new(&swings, search.swings.rule(&swings, true)?)?;
    let asked = Search { scenarios, ..asked };
    let design = Design::new(&setup, asked, args.rules == "golf")?;
    notes.extend(design.notes.iter().cloned());
    let found = found(
        search,
        &request,
        SwingsSearch {
            setup,
            swings,
            search: design.search.clone(),
        },
    )?;
    let improvements = if found.optima.best.value().is_some() {
        improvements(&found.setup, &found.optima.best, &found.stop)?
    } else {
        vec![]
    };
    interrupt::ends();
    let designed = Designed {
        design: &design,
        setup: &found.setup,
        best: &found.optima.best,
        improvements: &improvements,
        notes: &notes,
    };
    let answer = if request.is_json() {
        Answer::json(&designed.reply(found.reply(&request.origin())))
    } else {
        let document = designed.document(found.over(), system());
        Answer::document_about(document, &request.origin())
    };
    Ok(answer.found(found.is_found()))
}

/// Refuses a file that names no preset: the default preset of the other commands is above the Rules
/// of Golf, so this command has another one.
fn refuse_unnamed_preset(request: &Request) -> Result<()> {
    if request.source().names_preset() {
        return Ok(());
    }
    let source = "it names no preset; name the one that it starts from in its first line, as in \
                  preset = \"modern-driver\"";
    Err(Error::Unreadable {
        name: request.source().name().into(),
        source: source.into(),
    })
}

/// Refuses a setup that gives the launch.
fn refuse_launch(request: &Request, setup: &Setup<f64>) -> Result<()> {
    if !setup.launch.is_given() {
        return Ok(());
    }
    let source = "it gives the launch, so no club strikes the ball and there is nothing to \
                  design; leave it out, or give the swing";
    Err(Error::Unreadable {
        name: request.launch_from(),
        source: source.into(),
    })
}

/// Notes on the defaults for what the user did not state: swings, goal and varied parameters.
fn notes_on_defaults(args: &DesignArgs, asked: &Search) -> Vec<String> {
    let Optimize { search, swings, .. } = &args.optimize;
    let mut notes = vec![];
    if !swings.is_given() {
        notes.push(format!(
            "the swings scatter like those of {GOLFER}, about the setup's swing; for yours give \
             `swings FILE`"
        ));
    }
    if search.maximize.is_none() && search.minimize.is_none() {
        notes.push(format!(
            "default goal: the largest {GOAL}; for another give `maximize GOAL`"
        ));
    }
    if search.vary.is_empty() {
        let varied: Vec<_> = asked.vary.iter().map(|vary| vary.parameter.name).collect();
        notes.push(format!(
            "varied by default: {}; others: `vary NAME=LOW..HIGH`",
            varied.join(", ")
        ));
    }
    notes
}

/// The parameters whose distributions the user stated. A setting may override the parameters of the
/// default golfer.
fn distributed(args: &DesignArgs, swings: &Swings) -> Vec<&'static Parameter> {
    if args.optimize.swings.is_given() {
        swings.parameters()
    } else {
        vec![]
    }
}
