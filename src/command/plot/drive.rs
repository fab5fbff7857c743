//! Plots of a drive and its optimum: landings, launches, and strikes on the face.

use super::args::PlotSearch;
use crate::command::args::{SearchArgs, SetupArgs};
use crate::command::names::sigmas;
use crate::command::output::{Answer, note, spinner, system, warn};
use crate::command::picture::{PictureArgs, PlotDestination};
use crate::command::request::{Request, Source};
use crate::command::search::SearchRequest;
use crate::report::figures::{face_figure, fairway_figure, launches_figure, strikes_figure};
use crate::report::plot::Figure;
use crate::report::{Ending, computed_text, with_constraints};
use crate::study::{
    Cause, DriveRole, Face, Landing, Launches, NamedDrive, Optimum, causes, with_defaults,
};
use crate::units::Message;
use crate::{Drive, Error, Outcome, Result, Setup};

pub fn fairway(plot: &PlotSearch, sigma: &[String]) -> Result<Answer> {
    let request = plot.setup_args.request()?;
    let mut target = PlotDestination::new(request.inputs(), &plot.drawing)?;
    let (setup, best) = setup_and_optimum(&mut target, &request, &plot.search)?;
    let setup = request.with_assumed_launch(setup)?;
    let given = sigmas(&setup, sigma)?;
    let of = [Outcome::Carry, Outcome::Lateral];
    let mut landings = vec![Landing::of(
        DriveRole::AsSetUp,
        &setup,
        &with_defaults(&setup, &given, &of)?,
    )?];
    if let Some(best) = &best {
        let setup = best.setup.with_assumed_launch()?;
        let sigmas = with_defaults(&setup, &given, &of)?;
        landings.push(Landing::of(DriveRole::Optimum, &setup, &sigmas)?);
    }
    let figure = with_optimum(fairway_figure(&landings, system()), best.as_ref());
    let shown = [Outcome::Carry, Outcome::Lateral, Outcome::Total];
    let warnings = warnings(&setup, best.as_ref(), &shown);
    target.write(&figure, warnings)
}

pub fn launches(args: &PlotSearch) -> Result<Answer> {
    let request = args.setup_args.request()?;
    let mut target = PlotDestination::new(request.inputs(), &args.drawing)?;
    let (setup, best) = setup_and_optimum(&mut target, &request, &args.search)?;
    let optimum = best.iter().map(|best| (DriveRole::Optimum, &best.setup));
    let drives: Vec<_> = std::iter::once((DriveRole::AsSetUp, &setup))
        .chain(optimum)
        .collect();
    let spinner = spinner("computing the map");
    let map = Launches::around(&drives)?;
    spinner.finish();
    let figure = with_optimum(launches_figure(&map, system()), best.as_ref());
    let warnings = warnings(&setup, best.as_ref(), &[Outcome::Carry]);
    target.write(&figure, warnings)
}

pub fn face(setup_args: &SetupArgs, drawing: &PictureArgs) -> Result<Answer> {
    let request = setup_args.request()?;
    let target = PlotDestination::new(request.inputs(), drawing)?.about(request.origin());
    let setup = request.for_many(request.setup()?, &[])?;
    refuse_launch(&setup, &target)?;
    let spinner = spinner("computing strikes");
    let face = Face::of(&setup)?;
    spinner.finish();
    let warnings = warnings(&setup, None, &[Outcome::Carry]);
    target.write(&face_figure(&face, system()), warnings)
}

pub fn strikes(
    setup_args: &SetupArgs,
    search: &SearchArgs,
    after: Option<&str>,
    drawing: &PictureArgs,
) -> Result<Answer> {
    let request = setup_args.request()?;
    // no settings: the command line sets parameters of the first design only
    let other = |after: &str| Request::new(Source::read(after)?, vec![], setup_args);
    let after = after.map(other).transpose()?;
    let inputs = request
        .inputs()
        .chain(after.iter().flat_map(Request::inputs));
    let mut target = PlotDestination::new(inputs, drawing)?;
    if let (Some(_), Some(option)) = (&after, search.stated().next()) {
        let source = "`after` gives the other design, so no optimum is searched for; leave one of the two \
             out";
        return Err(Error::unreadable(option, source));
    }
    refuse_launch(&request.setup()?, &target)?;
    let mut best = None;
    let mut difference_warnings = vec![];
    let mut designs = vec![];
    if let Some(after) = &after {
        target.origin = request.origin();
        let [before, after] = before_and_after(&request, after, &target)?;
        difference_warnings = other_differences(&before, &after);
        designs.extend([("before", before), ("after", after)]);
    } else {
        let (setup, found) = setup_and_optimum(&mut target, &request, search)?;
        designs.push((NamedDrive::AS_SET_UP, setup));
        designs.extend(found.iter().map(|best| (NamedDrive::OPTIMUM, best.setup)));
        best = found;
    }
    let spinner = spinner("computing strikes");
    let faces = designs.iter().map(|(_, setup)| Face::of(setup));
    let faces = faces.collect::<Result<Vec<_>>>()?;
    spinner.finish();
    let names = designs.iter().map(|(name, _)| *name);
    let faces: Vec<_> = names.zip(&faces).collect();
    let figure = strikes_figure(&faces, system()).ok_or(Error::Nothing {
        doing: "draw",
        what: "design",
    })?;
    let figure = with_optimum(figure, best.as_ref());
    let mut warnings = warnings(&designs[0].1, best.as_ref(), &Face::OUTCOMES);
    warnings.extend(difference_warnings);
    target.write(&figure, warnings)
}

/// The design of the request, and the other one that it states.
fn before_and_after(
    request: &Request,
    after: &Request,
    target: &PlotDestination<'_>,
) -> Result<[Setup<f64>; 2]> {
    let other = after.for_many(after.setup()?, &[])?;
    refuse_launch(&other, target)?;
    let setup = request.for_many(request.setup()?, &[])?;
    refuse_other_hand(&setup, &other, target)?;
    Ok([setup, other])
}

/// Adds the parameters of the optimum and its constraints to the caption.
fn with_optimum(figure: Figure, best: Option<&Optimum>) -> Figure {
    let Some(best) = best else {
        return figure;
    };
    let varied = best.search.vary.iter().zip(&best.solution.x);
    let varied: Vec<_> = varied
        .map(|(vary, value)| {
            let value = computed_text(vary.parameter, *value, system());
            format!("{} {value}", vary.parameter.name)
        })
        .collect();
    let note = format!(
        "{} The optimum has {}{}.",
        figure.note,
        varied.join(", "),
        with_constraints(&best.search.subject_to, system())
    );
    figure.noted(note)
}

/// Refuses a drive given by its launch, because such a drive has no club face.
fn refuse_launch(setup: &Setup<f64>, target: &PlotDestination<'_>) -> Result<()> {
    if !setup.launch.is_given() {
        return Ok(());
    }
    let reason = "the drive is given by its launch: no club strikes the ball, so there is no face \
                  to draw; give a swing and a club instead";
    Err(target.refused(reason))
}

/// Refuses designs for golfers of different hands: the toe is on opposite sides.
fn refuse_other_hand(
    before: &Setup<f64>,
    after: &Setup<f64>,
    target: &PlotDestination<'_>,
) -> Result<()> {
    if before.golfer == after.golfer {
        return Ok(());
    }
    Err(target.refused(format!(
        "the golfer is {} before and {} after, so the toe is on opposite sides; give both setups \
         the same golfer (`set` changes only the first design; in the setup file of `after` write \
         golfer = \"{}\")",
        before.golfer.name(),
        after.golfer.name(),
        before.golfer.name()
    )))
}

/// A warning if two designs differ in more than the club.
fn other_differences(before: &Setup<f64>, after: &Setup<f64>) -> Vec<Message> {
    let names = causes(before, after)
        .into_iter()
        .map(Cause::name)
        .filter(|name| !name.starts_with("club."));
    let names: Vec<_> = names.collect();
    if names.is_empty() {
        return vec![];
    }
    let message = format!(
        "before and after differ in more than the club: {}; to see the effect of the club alone, \
         give the setup that the design was made for \
         (plot strike SETUP `after FILE`)",
        names.join(", ")
    );
    vec![message.into()]
}

/// The warnings about the drive as set up, then those about the drive at an optimum. `shown` are
/// the outcomes that the plot shows.
pub fn warnings(setup: &Setup<f64>, best: Option<&Optimum>, shown: &[Outcome]) -> Vec<Message> {
    let of_best = best.and_then(|best| {
        let of = [shown, &best.search.outcomes()].concat();
        let drive = best.drive.as_ref()?;
        Some(drive.warnings_about(&best.setup, &of))
    });
    let mut warnings = setup.drive_warnings(shown);
    // a warning about the setup, such as its temperature, is about both drives
    let of_best_alone = of_best
        .into_iter()
        .flatten()
        .filter(|warning| !warnings.contains(warning))
        .map(|warning| Message::from("at the optimum: ").message(warning))
        .collect::<Vec<_>>();
    warnings.extend(of_best_alone);
    warnings
}

/// The optimum to draw; `None` if the search finds none. In that case warns, and the plot shows only
/// the drive. Sets the origin of `target`. If the request states an option of the search and there
/// is no optimum, also sets the ending of `target` to the status of the search.
pub fn drawn_optimum(
    target: &mut PlotDestination<'_>,
    drive_search: &SearchRequest,
    args: &SearchArgs,
) -> Result<Option<Optimum>> {
    target.origin = drive_search.origin.clone();
    let best = drive_search.optimum()?;
    if best.is_converged() {
        return Ok(Some(best));
    }
    let (status, message) = (best.status(), best.message());
    let reason = Message::from(format!("no optimum is drawn: {status}: "));
    warn([reason.message(message.clone())]);
    if args.stated().next().is_some() {
        target.ending = Ending {
            status,
            message: Some(message.to_string()),
        };
    }
    Ok(None)
}

/// The setup and its optimum, for the plot `target`. If there is nothing to vary and the request
/// states no option of a search, a remark says that there is no optimum.
fn setup_and_optimum(
    target: &mut PlotDestination<'_>,
    request: &Request,
    args: &SearchArgs,
) -> Result<(Setup<f64>, Option<Optimum>)> {
    let setup = request.setup()?;
    let reason = args.nothing_to_vary(request)?;
    if let Some(reason) = reason.filter(|_| args.stated().next().is_none()) {
        note(&format!("no optimum is drawn: {reason}"));
        target.origin = request.origin();
        return Ok((request.for_many(setup, &[])?, None));
    }
    let drive_search = args.of_drive(request, None, None)?;
    // before the search, refuse a drive that does not land: the plot needs its landing
    Drive::new(&drive_search.setup)?.landed()?;
    let best = drawn_optimum(target, &drive_search, args)?;
    Ok((drive_search.setup, best))
}
