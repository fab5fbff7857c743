//! One design for several models of impact and flight.

use crate::command::args::{SearchArgs, SetupArgs, SwingsArgs, U32_MAX, whole};
use crate::command::files::OutputRule;
use crate::command::interrupt;
use crate::command::output::{Answer, note, note_detail, spinner, system, warn};
use crate::command::request::{Request, replaced, warn_of_idle};
use crate::command::search::{SearchRequest, allowed_loss};
use crate::command::swings::swing_ranges;
use crate::optimize::Observers;
use crate::report::{RobustReport, robust_setup};
use crate::study::swings::{Model, robust};
use crate::study::{Goal, Search};
use crate::units::{Message, Quantity, YARD};
use crate::{Error, Result, Setup};
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub search: SearchArgs,

    #[command(flatten)]
    pub swings: SwingsArgs,

    /// Make each search from this many starts, spread evenly over the ranges (the first is the
    /// setup's own).
    #[arg(
        long,
        value_name = "N",
        default_value_t = 1,
        value_parser = whole::<u32>(1..=U32_MAX, "`starts 8`"),
        allow_negative_numbers = true,
    )]
    pub starts: u32,

    /// A model in addition to the setup itself: changes of the setup, e.g. "aero.law=ferguson" or
    /// "impact.friction=0.3,impact.gear_scale=0.5". Repeatable [default: the laws launch-monitor
    /// and ferguson, and gear effects of 0.5 and 1, each as its own model].
    #[arg(long, value_name = "NAME=VALUE,…", allow_hyphen_values = true)]
    pub model: Vec<String>,

    /// Report whether the robust design is within this amount of the best design of every model
    /// [default: 1 yd for a distance].
    #[arg(long, value_name = "AMOUNT", allow_hyphen_values = true)]
    pub within: Option<String>,

    /// Write the setup with the robust design into this setup file.
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Replace the file if it exists.
    #[arg(long, requires = "output")]
    pub overwrite: bool,
}

pub fn run(args: &Args) -> Result<Answer> {
    args.swings.refuse_stray()?;
    let request = args.setup_args.request()?;
    let rule = OutputRule::new(request.inputs().chain(args.swings.inputs()), args.overwrite);
    let output = rule.setup_file(args.output.as_deref())?;
    let drives = args.swings.drives(&request, false)?;
    let ranges = drives.ranges(&args.search.vary, &request)?;
    let SearchRequest {
        setup,
        search,
        origin,
    } = args
        .search
        .search(&request, &drives, ranges, drives.default_goal())?;
    let within = args.within(&search.of)?;
    let ranges = swing_ranges(&search.vary, &search.scenarios);
    let mut models = args.models(&setup, &search)?;
    for model in &mut models {
        model.setup = request.stepped(model.setup, &ranges)?;
    }
    let setups: Vec<_> = models.iter().map(|model| model.setup).collect();
    warn_of_idle(request.given(), &setups);
    note_models(&models);
    warn(lost_settings(&request, &setup, &models));
    let spinner = spinner("searching for one design for all models");
    let work = interrupt::enable("stopping with the best design so far");
    let follow = Observers {
        interrupt: work.stop.clone(),
        ..Observers::default()
    };
    let found = robust(models, search, args.starts as usize, &follow);
    spinner.finish();
    let found = found?;
    let is_found = found.is_found();
    let mut warnings = found.warnings(&work.stop);
    drop(work);
    let mut written = None;
    if let Some(output) = &output {
        if is_found {
            let setup = robust_setup(&found, within, &request.source.content, system());
            let file = request.write_setup(output, setup)?;
            note(&format!(
                "wrote the setup with the robust design into {file}"
            ));
            written = Some(file);
        } else {
            warnings.push(output.not_written("there is no robust design"));
        }
    }
    warn(warnings);
    let mut report = RobustReport::new(&found, within);
    report.file = written;
    let answer = Answer::report(&report, &origin);
    Ok(answer.found(is_found))
}

/// Warnings about values of the command line, the host or the setup file that a model replaces
/// without naming them: another law has coefficients of its own, another turf has its own friction,
/// and a temperature determines the density.
fn lost_settings(request: &Request, setup: &Setup<f64>, models: &[Model]) -> Vec<Message> {
    let lost_in = |model: &Model| {
        let names = request.given().filter(|name| !model.names(name));
        replaced(names, setup, &model.setup)
            .into_iter()
            .map(|name| {
                Message::from(format!(
                    "{name} as given has no effect in the model '{}', which replaces it",
                    model.name
                ))
            })
            .collect::<Vec<_>>()
    };
    models.iter().flat_map(lost_in).collect()
}

fn note_models(models: &[Model]) {
    for (k, model) in models.iter().enumerate() {
        let reason = if model.reason.is_empty() {
            String::new()
        } else {
            format!(" ({})", model.reason)
        };
        note_detail(&format!("model {}: {}{reason}", k + 1, model.name));
    }
}

impl Args {
    /// The model of the setup, and the alternative models.
    fn models(&self, setup: &Setup<f64>, search: &Search) -> Result<Vec<Model>> {
        if self.model.is_empty() {
            return Model::defaults(setup);
        }
        let mut all = vec![Model::as_set_up(setup)];
        for text in &self.model {
            let model = Model::read(setup, text)?;
            let refuse =
                |source: String| Error::unreadable(format!("`model {}`", model.name), source);
            if let Some(same) = all.iter().find(|other| other.setup == model.setup) {
                return Err(refuse(format!(
                    "it is the same as '{}'; leave it out",
                    same.name
                )));
            }
            let mut taken = search
                .vary
                .iter()
                .map(|vary| vary.parameter)
                .chain(search.scenarios.parameters.iter().copied());
            if let Some(parameter) = taken.find(|parameter| model.names(parameter.name)) {
                return Err(refuse(format!(
                    "{} is varied, by the search or by the swings, so this value would have no \
                     effect; leave it out",
                    parameter.name
                )));
            }
            all.push(model);
        }
        Ok(all)
    }

    /// The allowed loss, SI: the stated value, or one yard if the objective is a distance.
    /// Otherwise `None`.
    fn within(&self, of: &Goal) -> Result<Option<f64>> {
        let Some(text) = &self.within else {
            return Ok((of.quantity.si == Quantity::LENGTH.si).then_some(YARD));
        };
        allowed_loss("within", text, of.quantity, true).map(Some)
    }
}
