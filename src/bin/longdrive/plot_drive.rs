//! Pictures of a drive beside the best one: where they land, how they leave, and where the face is struck.

use crate::args::{PlotFace, PlotFairway, PlotLaunch, Question, SearchArgs};
use crate::output::{Answer, spinner, system, tell};
use crate::picture::Target;
use longdrive::optimize::{Observer, Status};
use longdrive::report::figures::{face_figure, fairway_figure, launches_figure};
use longdrive::study::{Face, Landing, Launches, Optimum, Sigma, optimum, with_defaults};
use longdrive::units::Message;
use longdrive::{Drive, Error, Outcome, Result, Setup};

pub fn fairway(args: &PlotFairway) -> Result<Answer> {
    let target = Target::new(&args.question, &args.drawing)?;
    let (setup, best) = searched(&args.question, &args.search)?;
    let given = args.sigma.iter().map(|text| Sigma::read(&setup, text)).collect::<Result<Vec<_>>>()?;
    let of = [Outcome::Carry, Outcome::Lateral];
    let mut landings = vec![Landing::of("as set up", &setup, &with_defaults(&setup, &given, &of)?)?];
    if let Some(best) = &best {
        landings.push(Landing::of("optimum", &best.setup, &with_defaults(&best.setup, &given, &of)?)?);
    }
    let figure = fairway_figure(&landings, system());
    target.written(&args.question, &setup, &args.drawing, &figure, best.as_ref().map_or(vec![], at_optimum))
}

pub fn launches(args: &PlotLaunch) -> Result<Answer> {
    let target = Target::new(&args.question, &args.drawing)?;
    let (setup, best) = searched(&args.question, &args.search)?;
    let optimum = best.iter().map(|best| ("optimum", &best.setup));
    let drives: Vec<_> = std::iter::once(("as set up", &setup)).chain(optimum).collect();
    let spinner = spinner("computing the map");
    let map = Launches::around(&drives)?;
    spinner.finish_and_clear();
    let figure = launches_figure(&map, system());
    target.written(&args.question, &setup, &args.drawing, &figure, best.as_ref().map_or(vec![], at_optimum))
}

pub fn face(args: &PlotFace) -> Result<Answer> {
    let target = Target::new(&args.question, &args.drawing)?;
    let setup = args.question.for_many(args.question.setup()?, &[])?;
    if setup.launch.is_given() {
        let name = args.drawing.output.display().to_string();
        let reason = "the drive is given by its launch: no club strikes the ball, so that there is no face to draw; give a swing and a club instead";
        return Err(Error::Plot { name, reason: reason.into() });
    }
    let spinner = spinner("computing strikes");
    let face = Face::of(&setup)?;
    spinner.finish_and_clear();
    target.written(&args.question, &setup, &args.drawing, &face_figure(&face, system()), vec![])
}

/// What deserves a word about the drive of an optimum.
pub fn at_optimum(best: &Optimum) -> Vec<Message> {
    let warnings =
        best.drive.as_ref().map_or_else(Vec::new, |drive| drive.warnings_about(&best.setup, &best.search.outcomes()));
    warnings.into_iter().map(|warning| Message::from("at the optimum: ").message(warning)).collect()
}

/// The setup and its optimum. Where a launch is given of which nothing is varied, or no optimum is found, the drive is drawn alone, and
/// that is said.
fn searched(question: &Question, search: &SearchArgs) -> Result<(Setup<f64>, Option<Optimum>)> {
    let setup = question.setup()?;
    if setup.launch.is_given() && search.given().is_empty() {
        tell(
            "no optimum is drawn: the drive is given by its launch; give what to vary of it, for example --vary launch.launch_angle=5deg..20deg",
        );
        return Ok((question.for_many(setup, &[])?, None));
    }
    let search = search.search(&setup)?;
    let setup = question.for_many(setup, &search.vary)?;
    // without a drive there is nothing to draw
    Drive::new(&setup)?.landed()?;
    let best = optimum(&setup, search, Observer::default())?;
    if best.solution.status == Status::Converged {
        return Ok((setup, Some(best)));
    }
    tell(&format!("no optimum is drawn: {}: {}", best.status(), best.message().in_units(system())));
    Ok((setup, None))
}
