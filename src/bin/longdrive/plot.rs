use crate::args::{
    Drawing, Drawn, LawsOver, Moved, Plot, PlotChart, PlotCompare, PlotContour, PlotKind, PlotLaws, PlotTornado,
    PlotTrajectory, PlotVcurve, Question, Seen,
};
use crate::compare::warnings;
use crate::files::{Destination, Rule};
use crate::names::{outcomes, usual, variables};
use crate::output::{Answer, bar, show, spinner, system, tell, warn};
use crate::verify::tell_left_out;
use longdrive::atmosphere::AirState;
#[cfg(not(feature = "png"))]
use longdrive::features::how_to_get;
use longdrive::optimize::Observer;
use longdrive::parameters::Law;
use longdrive::report::Reply;
use longdrive::report::figures::{
    At, Causes, Coefficient, Flown, Over, View, chart_figures, difference_figure, laws_figure, map_figure,
    tornado_figure, trajectory_figure, vcurve_figure,
};
use longdrive::report::plot::{Figure, Look, Shades, figure_csv, figure_svg};
use longdrive::reproduce::while_loop;
use longdrive::study::certificate::certify;
use longdrive::study::{
    Constraint, Fineness, Map, Optimum, Search, Sigma, Vary, chart, effects, flatness, map, optimum, usual_loss,
    with_defaults,
};
use longdrive::units::{Message, Quantity};
use longdrive::{Drive, Error, Outcome, Result, Setup};
use serde_json::json;
use std::path::{Path, PathBuf};

pub fn run(args: &Plot) -> Result<Answer> {
    match &args.kind {
        PlotKind::Trajectory(args) => trajectory(args),
        PlotKind::Contour(args) => contour(args),
        PlotKind::Chart(args) => along(args),
        PlotKind::Tornado(args) => tornado(args),
        PlotKind::Compare(args) => difference(args),
        PlotKind::Vcurve(args) => vcurve(args),
        PlotKind::Laws(args) => laws(args),
    }
}

fn trajectory(args: &PlotTrajectory) -> Result<Answer> {
    let target = Target::new(&args.question, &args.drawing)?;
    let setup = args.question.within_tolerance(args.question.setup()?)?;
    let flown = Flown::new("", &setup)?;
    flown.drive.landed()?;
    let view = match args.view {
        Seen::Side => View::Side,
        Seen::Top => View::Top,
    };
    target.written(&args.question, &setup, &args.drawing, &trajectory_figure(&[flown], view), vec![])
}

fn contour(args: &PlotContour) -> Result<Answer> {
    let target = Target::new(&args.question, &args.drawing)?;
    let setup = args.question.setup()?;
    let search = args.search.search(&setup)?;
    let setup = args.question.for_many(setup, &search.vary)?;
    let spinner = spinner("computing the map");
    let (best, map) = mapped(&setup, &search)?;
    let best = best.as_ref();
    let limits = limits(best.map_or(&setup, |best| &best.setup), &search)?;
    let of_best = best.map_or(vec![], at_optimum);
    let flatness = best.map(|best| flatness(best, usual_loss(best))).transpose()?;
    spinner.finish_and_clear();
    target.written(
        &args.question,
        &setup,
        &args.drawing,
        &map_figure(&map, &limits, best, flatness.as_ref(), system()),
        of_best,
    )
}

/// What deserves a word about the drive of an optimum.
pub fn at_optimum(best: &Optimum) -> Vec<Message> {
    let warnings =
        best.drive.as_ref().map_or_else(Vec::new, |drive| drive.warnings_about(&best.setup, &best.search.outcomes()));
    warnings.into_iter().map(|warning| Message::from("at the optimum: ").message(warning)).collect()
}

/// The map around an optimum; around the setup itself, where there is none.
fn mapped(setup: &Setup<f64>, search: &Search) -> Result<(Option<Optimum>, Map)> {
    let [across, up, ..] = search.vary[..] else {
        let (name, reason) = ("--vary".into(), "a map needs two parameters; give --vary twice".into());
        return Err(Error::SearchRange { name, reason });
    };
    let best = optimum(setup, search.clone(), Observer::default())?;
    let is_found = best.solution.status == longdrive::optimize::Status::Converged;
    if !is_found {
        tell(&format!("no optimum is drawn: {}: {}", best.status(), best.message().in_units(system())));
    }
    let around = if is_found { &best.setup } else { setup };
    let map = map(around, search.of, across, up, Fineness::default())?;
    Ok((is_found.then_some(best), map))
}

/// The constraints of a search with the map of each one's outcome, over the first two parameters varied.
pub fn limits(around: &Setup<f64>, search: &Search) -> Result<Vec<(Constraint, Map)>> {
    let [across, up, ..] = search.vary[..] else { return Ok(vec![]) };
    let values = Fineness { slopes: 0, ..Fineness::default() };
    let limit =
        |constraint: &Constraint| Ok((constraint.clone(), map(around, constraint.outcome, across, up, values)?));
    search.subject_to.iter().map(limit).collect()
}

fn along(args: &PlotChart) -> Result<Answer> {
    let target = Target::new(&args.question, &args.drawing)?;
    let setup = args.question.setup()?;
    let search = args.search.search(&setup)?;
    let along = Vary::read(&setup, &args.along)?;
    args.question.refuse_unused(&setup, &[along.parameter], "--along gives its values")?;
    let shown = match &args.show {
        Some(name) if name != search.of.name() => {
            let names = || search.vary.iter().map(|vary| vary.parameter.name).chain([search.of.name()]);
            let advice = || format!("a chart shows {}", names().collect::<Vec<_>>().join(", "));
            let at = search.vary.iter().position(|vary| vary.parameter.name == name);
            1 + at.ok_or_else(|| Error::unknown("curve", name, names(), advice()))?
        }
        _ => 0,
    };
    let ranges: Vec<_> = search.vary.iter().copied().chain([along]).collect();
    let setup = args.question.for_many(setup, &ranges)?;
    let bar = bar("optima");
    let chart = chart(&setup, &search, along, |_| {
        bar.inc(1);
        true
    });
    bar.finish_and_clear();
    let chart = chart?;
    for note in chart.begun.iter().chain(&chart.ended) {
        tell(&note.in_units(system()));
    }
    match chart_figures(&chart, system()).get(shown) {
        Some(figure) => target.written(&args.question, &setup, &args.drawing, figure, chart.warnings()),
        None => Err(Error::Nothing { doing: "draw", what: "optimum" }),
    }
}

fn tornado(args: &PlotTornado) -> Result<Answer> {
    let target = Target::new(&args.question, &args.drawing)?;
    let setup = args.question.within_tolerance(args.question.setup()?)?;
    let of = Outcome::named(&args.of)?;
    let given = args.sigma.iter().map(|text| Sigma::read(&setup, text)).collect::<Result<Vec<_>>>()?;
    let bar = bar("uncertainties");
    let found = effects(&setup, &[of], &with_defaults(&setup, &given, &[of])?, |done, all| show(&bar, done, all));
    bar.finish_and_clear();
    let found = found?;
    let causes = match args.show {
        Moved::Control => Causes::Control,
        Moved::Model => Causes::Model,
        Moved::All => Causes::All,
    };
    let figure = found.first().and_then(|effects| tornado_figure(effects, causes, At::SetUp, system()));
    let Some(figure) = figure else {
        let reason = format!(
            "no uncertainty of this kind has an effect on {} here; take another --show (control, model, all), or give --sigma",
            of.name()
        );
        return Err(Error::Plot { name: args.drawing.output.display().to_string(), reason });
    };
    target.written(&args.question, &setup, &args.drawing, &figure, vec![])
}

fn difference(args: &PlotCompare) -> Result<Answer> {
    let [a, b] = args.pair.questions();
    let target = Target::beside(a.inputs().chain(b.inputs()), &args.drawing)?;
    let of = Outcome::named(&args.of)?;
    let comparison = args.pair.comparison()?;
    if !comparison.differs() {
        let reason = "nothing differs between drives a and b, so that there is nothing to draw".into();
        return Err(Error::Plot { name: args.drawing.output.display().to_string(), reason });
    }
    let warnings = warnings(&comparison);
    let figure = difference_figure(&comparison.of(of)?, system());
    target.put(a.json, &args.drawing, &figure, warnings)
}

fn vcurve(args: &PlotVcurve) -> Result<Answer> {
    let target = Target::new(&args.question, &args.drawing)?;
    let setup = args.question.within_tolerance(args.question.setup()?)?;
    let of = outcomes(&args.of)?;
    let wrt = if args.wrt.is_empty() { usual(&setup)? } else { variables(&setup, &args.wrt, &of)? };
    let bar = bar("parameters");
    let certificate = certify(&setup, &of, &wrt, |done, all| {
        show(&bar, done, all);
        true
    });
    bar.finish_and_clear();
    let certificate = certificate?;
    tell_left_out(&certificate);
    // in the order asked for, without what is looked at beside
    let asked = of.iter().flat_map(|of| wrt.iter().map(move |parameter| (*of, *parameter)));
    let row = |(of, parameter)| certificate.rows.iter().find(|row| row.of == of && row.parameter == parameter);
    target.written(
        &args.question,
        &setup,
        &args.drawing,
        &vcurve_figure(asked.filter_map(row), &while_loop(&setup, &certificate.rows), At::SetUp),
        vec![],
    )
}

fn laws(args: &PlotLaws) -> Result<Answer> {
    let target = Target::new(&args.question, &args.drawing)?;
    let setup = args.question.setup()?;
    let over = args.over()?;
    if AirState::of(&setup.air).density == 0.0 {
        let reason = "there is no air, and so no drag and no lift; set air.density above 0".into();
        return Err(Error::Plot { name: args.drawing.output.display().to_string(), reason });
    }
    let own = setup.law.table().map(|_| setup.law.name());
    let all = || Law::NAMES.iter().copied().chain(own);
    // the law of the setup with its coefficients, and the others as published
    let named = |name: &str| {
        let mut other = setup;
        other.set_law(name).map(|()| other.law)
    };
    let asked: Vec<&str> = args.laws.iter().map(|name| name.trim()).collect();
    if let Some((i, name)) = asked.iter().enumerate().find(|(i, name)| asked[..*i].contains(name)) {
        let source = format!("'{name}' is named twice, as number {} too; keep one", i + 1).into();
        return Err(Error::Unreadable { name: "--laws".into(), source });
    }
    let laws = if asked.is_empty() {
        all().map(named).collect::<Result<Vec<_>>>()
    } else {
        asked.into_iter().map(named).collect()
    }?;
    let of = match args.show {
        Drawn::Cd => Coefficient::Drag,
        Drawn::Cl => Coefficient::Lift,
    };
    target.put(args.question.json, &args.drawing, &laws_figure(&laws, &setup, over, of), vec![])
}

impl PlotLaws {
    /// What is drawn over, and at which value of the other.
    fn over(&self) -> Result<Over> {
        let unused = |name: &str, over: &str| {
            let source = format!(
                "the laws are drawn over the {over} itself, so this is not used; leave it out, or take another --over"
            );
            Err(Error::Unreadable { name: name.into(), source: source.into() })
        };
        match self.over {
            LawsOver::SpinRatio if self.spin_ratio.is_some() => unused("--spin-ratio", "spin ratio"),
            LawsOver::Reynolds if self.reynolds.is_some() => unused("--reynolds", "Reynolds number"),
            LawsOver::SpinRatio => Ok(Over::SpinRatio(held("--reynolds", &self.reynolds, 1.5e5, [1.0, 1e7])?)),
            LawsOver::Reynolds => Ok(Over::Reynolds(held("--spin-ratio", &self.spin_ratio, 0.1, [0.0, 10.0])?)),
        }
    }
}

/// A plain number of an option, within a range.
fn held(name: &str, text: &Option<String>, default: f64, [least, most]: [f64; 2]) -> Result<f64> {
    let Some(text) = text else { return Ok(default) };
    let unreadable = |e| Error::Unreadable { name: name.into(), source: Box::new(e) };
    let value = Quantity::NUMBER.read(text).map_err(unreadable)?;
    if (least..=most).contains(&value) {
        return Ok(value);
    }
    let advice = format!("it must be from {least} to {most}");
    Err(Error::OutOfRange { name: name.into(), value: value.to_string(), range: format!("{least} .. {most}"), advice })
}

/// The width of a picture, pixels.
const WIDTH: u32 = 480;

/// What a plot is written as.
#[derive(Clone, Copy)]
enum Format {
    Svg,
    #[cfg(feature = "png")]
    Png,
    Csv,
}

impl Format {
    /// What a file's name asks for.
    fn of(file: &Path) -> Result<Self> {
        let ending = file.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        match ending.as_deref() {
            Some("svg") => Ok(Self::Svg),
            #[cfg(feature = "png")]
            Some("png") => Ok(Self::Png),
            #[cfg(not(feature = "png"))]
            Some("png") => Err(Error::Plot { name: file.display().to_string(), reason: how_to_get("png") }),
            Some("csv") => Ok(Self::Csv),
            _ => Err(Error::Plot {
                name: file.display().to_string(),
                reason: "its ending does not name a format; use .svg or .png for a picture, or .csv for its data"
                    .into(),
            }),
        }
    }
}

/// Where a plot goes, and as what.
struct Target {
    format: Format,
    destination: Destination,
}

impl Target {
    /// What was asked for, if it may be written.
    fn new(question: &Question, drawing: &Drawing) -> Result<Self> {
        Self::beside(question.inputs(), drawing)
    }

    /// The same for a plot that reads these files.
    fn beside(inputs: impl Iterator<Item = PathBuf>, drawing: &Drawing) -> Result<Self> {
        let format = Format::of(&drawing.output)?;
        if let (Format::Csv, [option, ..]) = (format, drawing.look().as_slice()) {
            let source =
                "it is about pictures, and a .csv file has only the data; leave it out, or write a .svg or .png file";
            return Err(Error::Unreadable { name: (*option).into(), source: source.into() });
        }
        let rule = Rule::new(inputs, drawing.overwrite);
        Ok(Self { format, destination: rule.file(&drawing.output)? })
    }

    /// Writes the plot; `of_optima` is what deserves a word about the optima in it, beside the setup's own drive.
    fn written(
        &self,
        question: &Question,
        setup: &Setup<f64>,
        drawing: &Drawing,
        figure: &Figure,
        of_optima: Vec<Message>,
    ) -> Result<Answer> {
        let mut warnings = Drive::new(setup).map_or_else(|_| setup.warnings(), |drive| drive.warnings(setup));
        warnings.extend(of_optima);
        self.put(question.json, drawing, figure, warnings)
    }

    /// Writes the plot, with what is to be said about its drives.
    fn put(&self, is_json: bool, drawing: &Drawing, figure: &Figure, warnings: Vec<Message>) -> Result<Answer> {
        warn(&warnings);
        let shades = if drawing.dark { Shades::Dark } else { Shades::Light };
        let look = Look { system: system(), shades, width: drawing.width.unwrap_or(WIDTH) };
        let bytes = match self.format {
            Format::Svg => figure_svg(figure, &look)?.into_bytes(),
            #[cfg(feature = "png")]
            Format::Png => longdrive::report::plot::figure_png(figure, &look, 2.0)?,
            Format::Csv => figure_csv(figure)?.into_bytes(),
        };
        let file = drawing.output.display().to_string();
        self.destination.write(&bytes)?;
        tell(&format!("{file}: {}", figure.title));
        if !figure.note.is_empty() {
            tell(&figure.note);
        }
        Ok(if is_json {
            let (name, title, note) = (&figure.name, &figure.title, &figure.note);
            let body = json!({ "name": name, "file": file, "title": title, "note": note, "bytes": bytes.len() });
            Answer::json(&Reply::done("plot", warnings, body))
        } else {
            Answer::text(String::new())
        })
    }
}
