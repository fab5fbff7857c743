//! Plots of a drive and its optimum: landings, launches, and strikes on the face.

use super::args::{PlotFairway, PlotSearch, PlotStrike};
use crate::command::args::{SearchArgs, SetupArgs};
use crate::command::names::sigmas;
use crate::command::output::{Answer, note, spinner, system, warn};
use crate::command::picture::{PictureArgs, PlotDestination};
use crate::command::request::{Request, Source};
use crate::command::search::DriveSearch;
use crate::report::figures::{face_figure, fairway_figure, launches_figure, strikes_figure};
use crate::report::plot::Figure;
use crate::report::{Ending, SetupOrigin, computed_text, with_constraints};
use crate::study::{
    Cause, DriveRole, Face, Landing, Launches, NamedDrive, Optimum, causes, with_defaults,
};
use crate::units::Message;
use crate::{Drive, Error, Outcome, Result, Setup};

pub fn fairway(args: &PlotFairway) -> Result<Answer> {
    let request = args.setup_args.request()?;
    let target = PlotDestination::new(request.inputs(), &args.drawing)?;
    let (setup, found) = setup_and_optimum(&request, &args.search)?;
    let target = target.ended(found.ending).about(found.origin);
    let best = found.best;
    let setup = request.with_assumed_launch(setup)?;
    let given = sigmas(&setup, &args.sigma)?;
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
    let target = PlotDestination::new(request.inputs(), &args.drawing)?;
    let (setup, found) = setup_and_optimum(&request, &args.search)?;
    let target = target.ended(found.ending).about(found.origin);
    let best = found.best;
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

pub fn strikes(args: &PlotStrike) -> Result<Answer> {
    let request = args.setup_args.request()?;
    // no settings: the command line sets parameters of the first design only
    let other = |after: &String| Request::new(Source::read(after)?, vec![], &args.setup_args);
    let after = args.after.as_ref().map(other).transpose()?;
    let inputs = request
        .inputs()
        .chain(after.iter().flat_map(Request::inputs));
    let target = PlotDestination::new(inputs, &args.drawing)?;
    if let (Some(_), Some(option)) = (&after, args.search.stated().next()) {
        let source = "`after` gives the other design, so no optimum is searched for; leave one of the two \
             out";
        return Err(Error::unreadable(option, source));
    }
    refuse_launch(&request.setup()?, &target)?;
    let designs = match &after {
        Some(after) => Designs::before_and_after(&request, after, &target)?,
        None => Designs::with_optimum(&request, &args.search)?,
    };
    let Designs {
        setup,
        other,
        best,
        difference_warnings,
        ending,
        origin,
    } = designs;
    let target = target.ended(ending).about(origin);
    let names = other
        .as_ref()
        .map_or([NamedDrive::AS_SET_UP, ""], |(names, _)| *names);
    let spinner = spinner("computing strikes");
    let faces = std::iter::once(&setup)
        .chain(other.iter().map(|(_, other)| other))
        .map(Face::of);
    let faces = faces.collect::<Result<Vec<_>>>()?;
    spinner.finish();
    let designs: Vec<_> = names.into_iter().zip(&faces).collect();
    let figure = strikes_figure(&designs, system()).ok_or(Error::Nothing {
        doing: "draw",
        what: "design",
    })?;
    let figure = with_optimum(figure, best.as_ref());
    let mut warnings = warnings(&setup, best.as_ref(), &Face::OUTCOMES);
    warnings.extend(difference_warnings);
    target.write(&figure, warnings)
}

/// The designs of a plot of strikes.
struct Designs {
    setup: Setup<f64>,
    /// The second design, with the names of both.
    other: Option<([&'static str; 2], Setup<f64>)>,
    /// The optimum, if it is the second design.
    best: Option<Optimum>,
    /// A warning about differences of the designs that are not of the club.
    difference_warnings: Vec<Message>,
    ending: Ending,
    origin: SetupOrigin,
}

impl Designs {
    /// The design of the request, and another one that the request states.
    fn before_and_after(
        request: &Request,
        after: &Request,
        target: &PlotDestination<'_>,
    ) -> Result<Self> {
        let other = after.for_many(after.setup()?, &[])?;
        refuse_launch(&other, target)?;
        let setup = request.for_many(request.setup()?, &[])?;
        refuse_other_hand(&setup, &other, target)?;
        Ok(Self {
            difference_warnings: other_differences(&setup, &other),
            setup,
            other: Some((["before", "after"], other)),
            best: None,
            ending: Ending::DONE,
            origin: request.origin(),
        })
    }

    /// The drive as set up and its optimum.
    fn with_optimum(request: &Request, search: &SearchArgs) -> Result<Self> {
        let (setup, found) = setup_and_optimum(request, search)?;
        let names = [NamedDrive::AS_SET_UP, NamedDrive::OPTIMUM];
        Ok(Self {
            setup,
            difference_warnings: vec![],
            other: found.best.as_ref().map(|best| (names, best.setup)),
            best: found.best,
            ending: found.ending,
            origin: found.origin,
        })
    }
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

/// The optimum of a plot.
pub struct DrawnOptimum {
    /// The optimum; `None` if there is no search, or if it finds none.
    pub best: Option<Optimum>,
    /// The status of the plot: that of the search if the request states an option of the search and
    /// there is no optimum, otherwise `done`.
    pub ending: Ending,
    /// The setup of the plot, with advice on the search.
    pub origin: SetupOrigin,
}

impl DrawnOptimum {
    /// The optimum of a search. Warns if the search finds none; the plot then shows only the drive.
    pub fn of(request: &Request, drive_search: &DriveSearch, args: &SearchArgs) -> Result<Self> {
        let origin = drive_search.origin(request);
        let best = drive_search.optimum()?;
        if best.is_converged() {
            return Ok(Self {
                best: Some(best),
                ending: Ending::DONE,
                origin,
            });
        }
        let (status, message) = (best.status(), best.message());
        let reason = Message::from(format!("no optimum is drawn: {status}: "));
        warn([reason.message(message.clone())]);
        let ending = match args.stated().next() {
            Some(_) => Ending {
                status,
                message: Some(message.to_string()),
            },
            None => Ending::DONE,
        };
        Ok(Self {
            best: None,
            ending,
            origin,
        })
    }
}

/// The setup and its optimum. If there is nothing to vary and the request states no option of a
/// search, a remark says that there is no optimum.
fn setup_and_optimum(request: &Request, search: &SearchArgs) -> Result<(Setup<f64>, DrawnOptimum)> {
    let setup = request.setup()?;
    let reason = search.nothing_to_vary(request)?;
    if let Some(reason) = reason.filter(|_| search.stated().next().is_none()) {
        note(&format!("no optimum is drawn: {reason}"));
        let none = DrawnOptimum {
            best: None,
            ending: Ending::DONE,
            origin: request.origin(),
        };
        return Ok((request.for_many(setup, &[])?, none));
    }
    let drive_search = search.of_drive(request, None, None)?;
    // before the search, refuse a drive that does not land: the plot needs its landing
    Drive::new(&drive_search.setup)?.landed()?;
    let drawn = DrawnOptimum::of(request, &drive_search, search)?;
    Ok((drive_search.setup, drawn))
}
