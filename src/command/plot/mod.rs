//! Plots, each a subcommand.

mod args;
mod drive;

pub use args::Args;

use crate::atmosphere::AirState;
use crate::command::args::SetupArgs;
use crate::command::compare::{PairArgs, origin_of_pair};
use crate::command::gradient::DerivativeArgs;
use crate::command::host::Progress;
use crate::command::names::{outcomes, sigmas};
use crate::command::output::{Answer, bar, note, spinner, system, warn, with_bar};
use crate::command::pareto;
use crate::command::picture::{PictureArgs, PlotDestination};
use crate::command::ranges::SearchRanges;
use crate::command::request::Request;
use crate::command::search::SearchRequest;
use crate::command::verify::note_missing_outcomes;
use crate::optimize::Observer;
use crate::parameters::{Law, Parameter};
use crate::repeated::first_repeated;
use crate::report::figures::{
    ChartFigures, OnMap, Over, View, chart_figures, difference_figure, laws_figure, map_figure,
    tornado_figure, trajectory_figure, vcurve_figure,
};
use crate::report::plot::Figure;
use crate::reproduce::while_loop;
use crate::study::certificate::certify;
use crate::study::{
    ChartObserver, Constraint, DriveRole, Fineness, Map, NamedDrive, Optimum, Region, Search, Vary,
    chart, default_loss, effects, map, optimum, short_drive, with_defaults,
};
use crate::units::Quantity;
use crate::{Error, Outcome, Result, Setup};
use args::{PlotKind, PlotLaws, PlotSearch, PlotTornado};
use drive::{drawn_optimum, face, fairway, launches, strikes};
use std::rc::Rc;
use std::sync::Arc;

pub fn run(args: &Args) -> Result<Answer> {
    match &args.kind {
        PlotKind::Trajectory {
            setup_args,
            drawing,
            view,
        } => trajectory(setup_args, drawing, *view),
        PlotKind::Contour(args) => contour(args),
        PlotKind::Chart { plot, along, show } => optima_along(plot, along, show.as_deref()),
        PlotKind::Pareto {
            setup_args,
            requested,
            drawing,
        } => pareto::draw(setup_args, requested, drawing),
        PlotKind::Tornado(args) => tornado(args),
        PlotKind::Compare { pair, drawing, of } => difference(pair, drawing, of),
        PlotKind::Vcurve {
            setup_args,
            drawing,
            derivatives,
        } => vcurve(setup_args, drawing, derivatives),
        PlotKind::Laws(args) => laws(args),
        PlotKind::Fairway { plot, sigma } => fairway(plot, sigma),
        PlotKind::Face {
            setup_args,
            drawing,
        } => face(setup_args, drawing),
        PlotKind::Strike {
            setup_args,
            search,
            after,
            drawing,
        } => strikes(setup_args, search, after.as_deref(), drawing),
        PlotKind::Launch(args) => launches(args),
    }
}

fn trajectory(setup_args: &SetupArgs, drawing: &PictureArgs, view: View) -> Result<Answer> {
    let request = setup_args.request()?;
    let target = PlotDestination::new(request.inputs(), drawing)?.about(request.origin());
    let setup = request.setup_within_tolerance()?;
    let flown = NamedDrive::new(DriveRole::Alone, &setup)?;
    flown.drive.landed()?;
    let figure = trajectory_figure(&[flown], view, system()).map_err(|error| match error {
        Error::Plot { reason, .. } if view == View::Top => {
            target.refused(format!("{reason}; take `view side`"))
        }
        error => error,
    })?;
    let warnings = setup.drive_warnings(&[Outcome::Carry, Outcome::Total]);
    target.write(&figure, warnings)
}

fn contour(args: &PlotSearch) -> Result<Answer> {
    let request = args.setup_args.request()?;
    let mut target = PlotDestination::new(request.inputs(), &args.drawing)?;
    let drive_search = args.search.of_drive(&request, None, None)?;
    let SearchRequest { setup, search, .. } = &drive_search;
    let spinner = spinner("computing the map");
    let [across, up, ..] = search.vary[..] else {
        let examples = SearchRanges::of_map(setup)?;
        return Err(Error::SearchRange {
            name: "`vary`".into(),
            reason: format!(
                "a map needs two parameters; give `vary` twice, for example {examples}"
            ),
        });
    };
    let best = drawn_optimum(&mut target, &drive_search, &args.search)?;
    let best = best.as_ref();
    let around = match best {
        Some(best) => best.setup,
        None => Vary::initialized(setup, &search.vary)?,
    };
    let map = map(&around, search.outcome(), across, up, Fineness::default())?;
    if let Some(flat) = map.flat() {
        let reason = format!("{flat}; vary parameters that change it");
        return Err(target.refused(reason));
    }
    let limits = limits(&around, search)?;
    if let Some((_, message)) = best.and_then(short_drive) {
        note(message);
    }
    let region = best
        .map(|best| Region::around(best, across, up, default_loss(best)))
        .transpose()?
        .flatten();
    spinner.finish();
    if best.is_some() && region.is_none() {
        note(
            "no region around the optimum is drawn: no other drive of the map loses little and \
             meets every constraint",
        );
    }
    let on = OnMap {
        // without the start values of the search: these are not values of the drive as set up
        setup: &request.partial_setup,
        preset: request.source.content.preset,
        limits: &limits,
        best,
        region: region.as_ref(),
    };
    let warnings = drive::warnings(setup, best, &search.outcomes());
    target.write(&map_figure(&map, &on, system()), warnings)
}

/// The constraints of a search, each with a map of the limited outcome over the first two varied
/// parameters. Empty if fewer than two parameters vary.
pub fn limits(around: &Setup<f64>, search: &Search) -> Result<Vec<(Constraint, Map)>> {
    let [across, up, ..] = search.vary[..] else {
        return Ok(vec![]);
    };
    let values = Fineness {
        slopes: 0,
        ..Fineness::default()
    };
    let limit = |constraint: &Constraint| {
        let outcome = constraint.goal.outcome()?;
        let limited = map(around, outcome, across, up, values);
        Some(limited.map(|limited| (constraint.clone(), limited)))
    };
    search.subject_to.iter().filter_map(limit).collect()
}

fn optima_along(plot: &PlotSearch, along: &str, show: Option<&str>) -> Result<Answer> {
    let request = plot.setup_args.request()?;
    let target = PlotDestination::new(request.inputs(), &plot.drawing)?;
    let along = Vary::read_column(&request.partial_setup, along)?;
    request.refuse_stated_besides_launch(&[along.parameter], "`along` gives its values")?;
    let drive_search = plot.search.of_drive(&request, Some(along), None)?;
    let SearchRequest { setup, search, .. } = &drive_search;
    let shown = shown_curve(show, search)?;
    let bar = bar("optima");
    let chart = chart(setup, search, along, &[], &counted_points(&bar));
    bar.finish();
    let chart = chart?;
    for message in chart.begun.iter().chain(&chart.ended) {
        note(&message.in_units(system()));
    }
    let own = request.partial_setup.value(along.parameter);
    let own = own
        .map(|_| optimum(setup, search.clone(), Observer::default()))
        .transpose()?
        .filter(Optimum::is_converged);
    // without the start values of the search: these are not values of the drive as set up
    let setup_as_stated = &request.partial_setup;
    let preset = request.source.content.preset;
    let figures = chart_figures(&chart, setup_as_stated, preset, own.as_ref(), system());
    let figure = figure_of(&figures, search, shown, &target)?;
    let warnings = [setup.drive_warnings(&[]), chart.warnings()].concat();
    let target = target.about(drive_search.origin);
    target.write(figure, warnings)
}

/// Counts the points of a chart in a progress bar.
pub fn counted_points(bar: &Arc<dyn Progress>) -> ChartObserver {
    let bar = bar.clone();
    ChartObserver {
        point: Some(Rc::new(move |_| bar.inc(1))),
        ..ChartObserver::default()
    }
}

/// The varied parameter to plot; `None` for the outcome.
fn shown_curve(show: Option<&str>, search: &Search) -> Result<Option<&'static Parameter>> {
    let Some(name) = show.filter(|name| *name != search.outcome().name()) else {
        return Ok(None);
    };
    if let Some(parameter) = search.parameters().find(|parameter| parameter.name == name) {
        return Ok(Some(parameter));
    }
    let names: Vec<_> = search
        .parameters()
        .map(|parameter| parameter.name)
        .chain([search.outcome().name()])
        .collect();
    let advice = format!("a chart shows {}", names.join(", "));
    Err(Error::unknown("curve", name, names, advice))
}

/// The figure of the parameter `shown`, or of the outcome if `shown` is `None`. In `figures.drawn`,
/// the outcome comes first, then the varied parameters in the order of the search. Parameters at a
/// bound are not drawn.
fn figure_of<'a>(
    figures: &'a ChartFigures,
    search: &Search,
    shown: Option<&'static Parameter>,
    target: &PlotDestination<'_>,
) -> Result<&'a Figure> {
    let mut kept = figures.at_bound.iter();
    if let Some((_, why)) = kept.find(|(vary, _)| Some(vary.parameter) == shown) {
        return Err(target.refused(format!("it does not change: {why}")));
    }
    let moves = |vary: &&Vary| {
        let mut kept = figures.at_bound.iter();
        kept.all(|(kept, _)| kept.parameter != vary.parameter)
    };
    let place = search
        .vary
        .iter()
        .filter(moves)
        .position(|vary| Some(vary.parameter) == shown);
    let figure = figures.drawn.get(place.map_or(0, |place| 1 + place));
    figure.ok_or(Error::Nothing {
        doing: "draw",
        what: "optimum",
    })
}

fn tornado(args: &PlotTornado) -> Result<Answer> {
    let request = args.setup_args.request()?;
    let target = PlotDestination::new(request.inputs(), &args.drawing)?.about(request.origin());
    let setup = request.setup_within_tolerance()?;
    let setup = request.with_assumed_launch(setup)?;
    let of = Outcome::named(&args.of)?;
    let given = sigmas(&setup, &args.sigma)?;
    let sigmas = with_defaults(&setup, &given, &[of])?;
    let found = with_bar("uncertainties", |show| {
        effects(&setup, &[of], &sigmas, show)
    })?;
    let figure = found
        .first()
        .and_then(|effects| tornado_figure(effects, args.show, system()));
    let Some(figure) = figure else {
        let reason = format!(
            "no uncertainty of this kind has an effect on {} here; take another `show` (control, \
             model, all), or give `sigma`",
            of.name()
        );
        return Err(target.refused(reason));
    };
    target.write(&figure, setup.drive_warnings(&[of]))
}

fn difference(pair: &PairArgs, drawing: &PictureArgs, of: &str) -> Result<Answer> {
    let requests = pair.requests()?;
    let target = PlotDestination::new(requests.iter().flat_map(Request::inputs), drawing)?
        .about(origin_of_pair(&requests));
    let of = Outcome::named(of)?;
    let comparison = pair.comparison(&requests)?;
    if !comparison.differs() {
        return Err(target.refused("drives a and b are equal, so there is nothing to draw"));
    }
    let warnings = comparison.warnings(&[of]);
    let figure = difference_figure(&comparison.of(of)?, system());
    target.write(&figure, warnings)
}

fn vcurve(
    setup_args: &SetupArgs,
    drawing: &PictureArgs,
    derivatives: &DerivativeArgs,
) -> Result<Answer> {
    let request = setup_args.request()?;
    let target = PlotDestination::new(request.inputs(), drawing)?.about(request.origin());
    let setup = request.setup_within_tolerance()?;
    let of = outcomes(&derivatives.of)?;
    let wrt = derivatives.variables(&setup, &of)?;
    let certificate = with_bar("parameters", |show| {
        certify(&setup, &of, &wrt, &|done, all| {
            show(done, all);
            true
        })
    })?;
    note_missing_outcomes(&certificate);
    // draw the derivatives in the requested order; the rows of a certificate are sorted by verdict
    let requested = of
        .iter()
        .flat_map(|of| wrt.iter().map(move |parameter| (*of, *parameter)));
    let row = |(of, parameter)| {
        certificate
            .rows
            .iter()
            .find(|row| row.of == of && row.parameter == parameter)
    };
    let loops = while_loop(&setup, &certificate.rows);
    let figure = vcurve_figure(requested.filter_map(row), &loops, system());
    target.write(&figure, setup.drive_warnings(&of))
}

fn laws(args: &PlotLaws) -> Result<Answer> {
    let request = args.drive.request()?;
    let target = PlotDestination::new(request.inputs(), &args.drawing)?;
    let setup = request.setup()?;
    let constant = args.constant()?;
    if AirState::of(&setup.air).density == 0.0 {
        let reason = "there is no air, and so no drag and no lift; set air.density above 0";
        return Err(target.refused(reason));
    }
    let own = setup.law.table().map(|_| setup.law.name());
    let is_of_law = |name: &str| {
        let is_of_group = name.starts_with("aero.") || name.starts_with("air.");
        is_of_group && name != "aero.spin_decay" || name == "ball.radius"
    };
    warn(request.unused_warning(
        is_of_law,
        "this plot, which depends on the law, the air and the ball's radius only; leave it out",
    ));
    let all = || Law::NAMES.iter().copied().chain(own);
    // the setup's law has the coefficients of the setup; the other laws have their published
    // coefficients
    let named = |name: &str| {
        let mut other = setup;
        other.set_law(name).map(|()| other.law)
    };
    let requested: Vec<&str> = args.laws.iter().map(|name| name.trim()).collect();
    if let Some([_, again]) = first_repeated(&requested, |a, b| a == b) {
        let (name, number) = (requested[again], again + 1);
        let source = format!("'{name}' (law {number}) is named twice; keep one");
        return Err(Error::unreadable("`laws`", source));
    }
    let laws = if requested.is_empty() {
        all().map(named).collect::<Result<Vec<_>>>()
    } else {
        requested.into_iter().map(named).collect()
    }?;
    target.write(
        &laws_figure(&laws, &setup, args.over, constant, args.show, system()),
        vec![],
    )
}

impl PlotLaws {
    /// The value of the variable that is constant in the plot: the Reynolds number or the spin
    /// ratio.
    fn constant(&self) -> Result<f64> {
        let unused = |name: &str, over: &str| {
            let source = format!(
                "the laws are drawn over the {over} itself, so this is not used; leave it out, or \
                 take another `over`"
            );
            Err(Error::unreadable(name, source))
        };
        match self.over {
            Over::SpinRatio if self.spin_ratio.is_some() => unused("`spin_ratio`", "spin ratio"),
            Over::Reynolds if self.reynolds.is_some() => unused("`reynolds`", "Reynolds number"),
            Over::SpinRatio => number_within("`reynolds`", &self.reynolds, 1.5e5, [1.0, 1e7]),
            Over::Reynolds => number_within("`spin_ratio`", &self.spin_ratio, 0.1, [0.0, 10.0]),
        }
    }
}

/// Parses `text`, which is the value of the option `name`. Without a text, returns `default`. A
/// number outside of `least` to `most` is an error.
fn number_within(
    name: &str,
    text: &Option<String>,
    default: f64,
    [least, most]: [f64; 2],
) -> Result<f64> {
    let Some(text) = text else { return Ok(default) };
    let unreadable = |e| Error::unreadable(name, e);
    let value = Quantity::NUMBER.read(text).map_err(unreadable)?;
    if (least..=most).contains(&value) {
        return Ok(value);
    }
    Err(Error::OutOfRange {
        name: name.into(),
        si: value,
        value: value.to_string(),
        range: format!("{least} .. {most}"),
        advice: "give a number in this range".into(),
    })
}
