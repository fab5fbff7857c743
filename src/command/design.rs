//! The `design` command: the best head and face.

use crate::command::args::{OptimizeArgs, SwingsArgs};
use crate::command::optimize::optimize_and_write;
use crate::command::output::Answer;
use crate::command::ranges::SearchRanges;
use crate::command::request::Request;
use crate::command::search::SearchRequest;
use crate::report::DesignReport;
use crate::study::design::{Design, GOLFER, default_vary, golfer, improvements};
use crate::study::swings::Swings;
use crate::study::{Goal, Search};
use crate::{Error, Result};

/// The default objective.
const GOAL: &str = "mean(carry) - 0.5*rms(lateral)";

#[derive(clap::Args)]
#[command(
    mut_arg("setup", |arg| arg.default_value("modern-driver").help(
        "A preset's name, a TOML file that names its preset, or - to read TOML from standard input"
    )),
    mut_arg("maximize", |arg| arg.help("The goal to maximize, e.g. \"mean(carry)\" [default: \
                                        \"mean(carry) - 0.5*rms(lateral)\", unless --minimize is \
                                        given]")),
    mut_arg("minimize", |arg| arg.help("The goal to minimize, e.g. \"rms(lateral)\"")),
    mut_arg("vary", |arg| arg.help(
        "A parameter of the head to vary, with its range, e.g. club.bulge_radius=200mm..600mm or \
         club.weight_1.toe=-50mm..50mm. \
         Repeatable [default: bulge and roll 150 to 1000 mm, loft 6 to 16 deg; a parameter \
         that you set stays fixed]"
    )),
    mut_arg("subject_to", |arg| arg.help(
        "A limit of a goal or of the head, e.g. \"std(lateral) <= 20yd\" or \"head_mass <= 205 \
         g\"; or a relation with a name, linear in \
         parameters, e.g. \"volume: 120 cm^3 + 80 cm^2*club.cg_depth <= 460 cm^3\". Repeatable"
    )),
    mut_arg("swings", |arg| arg.help(
        "The swings to design for: a TOML file with [distributions] and [[correlations]], or a \
         table (CSV, Parquet, Arrow) of recorded \
         swings [default: a golfer whose drives were measured, about the setup's own swing]"
    )),
    mut_arg("output", |arg| arg.help("Write the setup with the best design into this setup file"))
)]
pub struct Args {
    #[command(flatten)]
    pub optimize: OptimizeArgs,

    /// The rules for the design: golf (moment of inertia, volume, spring effect, ball) or none.
    #[arg(long, value_name = "RULES", default_value = "golf", value_parser = ["golf", "none"])]
    pub rules: String,
}

pub fn run(args: &Args) -> Result<Answer> {
    let optimum = &args.optimize.optimum;
    let swings_args = &args.optimize.swings;
    let request = optimum.setup_args.request()?;
    // a setup file that names no preset starts from `tour-average`, which exceeds limits of the
    // Rules of Golf
    if !request.source.content.names_preset {
        let source = "it names no preset; name the one that it starts from in its first line, as \
                      in preset = \"modern-driver\"";
        return Err(Error::unreadable(request.source.name(), source));
    }
    request.refuse_launch(
        &request.partial_setup,
        "it gives the launch, so no club strikes the ball and there is nothing to design; leave it \
         out, or give the swing",
    )?;
    let swings = swings_or_golfer(swings_args, &request)?;
    let drives = swings_args.drives_over(swings.clone(), &request, true)?;
    let search_args = &optimum.search;
    let ranges = SearchRanges::new(
        &search_args.vary,
        &request,
        drives.setup,
        None,
        default_vary,
    )?;
    let SearchRequest {
        setup,
        search,
        origin,
    } = search_args.search(&request, &drives, ranges, Goal::read(GOAL, None)?)?;
    let mut notes = notes_on_defaults(args, &search);
    let design = Design::new(&setup, search, args.rules == "golf")?;
    notes.extend(design.notes.iter().cloned());
    let found = optimize_and_write(&args.optimize, &request, &swings, setup, &design.search)?;
    let improvements = if found.optima.best.value().is_some() {
        improvements(&found.setup, &found.optima.best, &found.work.stop)?
    } else {
        vec![]
    };
    let designed = DesignReport::new(found.report(), &design, &found.setup, improvements, notes);
    let answer = Answer::report(&designed, &origin);
    Ok(answer.found(found.optima.is_found()))
}

/// The stated swings or, if none are stated, the swings of a golfer whose drives were measured. The
/// golfer's swings scatter about the values of the setup, so the user may set the parameters that
/// scatter.
fn swings_or_golfer(args: &SwingsArgs, request: &Request) -> Result<Swings> {
    if args.is_given() {
        return args.swings_of(request);
    }
    if !args.correlation.is_empty() {
        args.refuse_stray()?;
    }
    golfer(&request.partial_setup)
}

/// Notes on the defaults that replace unstated arguments: swings, goal and varied parameters.
fn notes_on_defaults(args: &Args, requested: &Search) -> Vec<String> {
    let OptimizeArgs { optimum, swings } = &args.optimize;
    let search = &optimum.search;
    let mut notes = vec![];
    if !swings.is_given() {
        notes.push(format!(
            "assumed standard deviations about the setup's swing: {GOLFER}; for yours give \
             `swings FILE`"
        ));
    }
    if search.maximize.is_none() && search.minimize.is_none() {
        notes.push(format!(
            "default goal: the largest {GOAL}; for another goal give `maximize GOAL`"
        ));
    }
    if search.vary.is_empty() {
        let varied: Vec<_> = requested
            .vary
            .iter()
            .map(|vary| vary.parameter.name)
            .collect();
        notes.push(format!(
            "varied by default: {}; for other parameters give `vary NAME=LOW..HIGH`",
            varied.join(", ")
        ));
    }
    notes
}
