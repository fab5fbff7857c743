//! The page of a report: a self-contained HTML file that begins with a summary, and separate files
//! of its plots and their data.

mod answer;
mod findings;
mod gain;
mod lofts;
mod numbers;
mod request;
mod sections;

pub use findings::{EXPLORER_FILE, Findings, SETUP_FILE};

use super::figures::{
    Causes, OnMap, View, chart_figures, face_figure, fairway_figure, launches_figure, map_figure,
    strikes_figure, tornado_figure, trajectory_figure, vcurve_figure,
};
use super::frame::{self, TextFile, both, chosen, picture_files, pictures};
use super::in_both::InBoth;
use super::optimum::optimum_setup;
use super::plot::{Figure, Look, figure_svg};
use super::setup_toml;
use super::shown::{self, capital};
use crate::error::{Error, Result};
use crate::study::NamedDrive;
use crate::units::{Message, System};
use maud::{Markup, html};

/// The files of a report: `index.html`, [`SETUP_FILE`], and for each plot `NAME-us.svg`,
/// `NAME-metric.svg` and `NAME.csv`.
///
/// # Errors
/// The errors of [`figure_svg`], [`figure_csv`](super::plot::figure_csv) and [`setup_toml`].
pub fn report_documents(findings: &Findings) -> Result<Vec<TextFile>> {
    let plots = plots(findings);
    let setup = match findings.best() {
        Some(best) => {
            optimum_setup(best, None, None, &findings.file, findings.system).toml(&findings.file)?
        }
        None => setup_toml(
            &findings.setup,
            &findings.file,
            &[format!("{}, as set up", findings.name)],
            &[],
        )?,
    };
    let mut files = vec![
        TextFile {
            name: "index.html".into(),
            text: page(findings, &plots)?,
        },
        TextFile {
            name: SETUP_FILE.into(),
            text: setup,
        },
    ];
    files.extend(picture_files(plots.all(), findings.system)?);
    Ok(files)
}

fn plots(findings: &Findings) -> Plots {
    let (mut drive, left_out) = trajectories(&findings.flown);
    if !findings.landings.is_empty() {
        // insert the landings after the view from the side
        drive.insert(
            drive.len().min(1),
            InBoth::of(|system| fairway_figure(&findings.landings, system)),
        );
    }
    let (launches, face) = (findings.launches.as_ref(), findings.face.as_ref());
    let on_map = OnMap {
        // without the chosen method and step, which the subtitle would name
        setup: &findings.stated,
        preset: findings.file.preset,
        limits: &findings.limits,
        best: findings.best(),
        region: findings.region.as_ref(),
    };
    let causes = |effects| Causes::APART.map(|causes| (effects, causes));
    Plots {
        drive,
        strike: pairs(|system| {
            let launches = launches.map(|launches| launches_figure(launches, system));
            let face = face.map(|face| face_figure(face, system));
            launches.into_iter().chain(face)
        }),
        strikes: strikes(findings),
        left_out,
        map: pairs(|system| {
            let map = findings.map.as_ref();
            map.map(|map| map_figure(map, &on_map, system))
        }),
        chart: pairs(|system| {
            let charts = findings.chart.iter();
            charts.flat_map(move |chart| {
                chart_figures(chart, on_map.setup, on_map.preset, on_map.best, system).drawn
            })
        }),
        effects: findings
            .effects
            .iter()
            .flat_map(causes)
            .flat_map(|(effects, causes)| pairs(|system| tornado_figure(effects, causes, system)))
            .collect(),
        // omit the plot if every error is 0 (as for a derivative of 0): a logarithmic axis cannot
        // show 0
        curves: pairs(|system| {
            let figure = vcurve_figure(&findings.rows, &findings.loops, system);
            Some(figure).filter(|figure| figure_svg(figure, &Look::default()).is_ok())
        }),
    }
}

/// The plot of outcomes as functions of the impact point, for the drive as set up and for the
/// optimum. Empty if no face was computed.
fn strikes(findings: &Findings) -> Vec<InBoth<Figure>> {
    let faces = [
        (NamedDrive::AS_SET_UP, &findings.face),
        (NamedDrive::OPTIMUM, &findings.best_face),
    ];
    let designs: Vec<_> = faces
        .into_iter()
        .filter_map(|(name, face)| Some((name, face.as_ref()?)))
        .collect();
    pairs(|system| strikes_figure(&designs, system))
}

/// Calls `draw` for both systems of units, and pairs the metric and the US version of each plot.
fn pairs<F: IntoIterator<Item = Figure>>(draw: impl Fn(System) -> F) -> Vec<InBoth<Figure>> {
    let InBoth { metric, us } = InBoth::of(draw);
    let plots = metric.into_iter().zip(us);
    plots.map(|(metric, us)| InBoth { metric, us }).collect()
}

/// The views of the drives that fly, from the side and from above. The second list has the reason
/// for each missing view.
fn trajectories(flown: &[NamedDrive]) -> (Vec<InBoth<Figure>>, Vec<InBoth<String>>) {
    let flying: Vec<NamedDrive> = flown
        .iter()
        .filter(|one| one.path.points.len() > 1)
        .cloned()
        .collect();
    let (mut pairs, mut left_out) = (vec![], vec![]);
    for view in [View::Side, View::Top]
        .into_iter()
        .filter(|_| !flying.is_empty())
    {
        match InBoth::of(|system| trajectory_figure(&flying, view, system)) {
            InBoth {
                metric: Ok(metric),
                us: Ok(us),
            } => pairs.push(InBoth { metric, us }),
            InBoth {
                metric: Err(Error::Plot { reason: metric, .. }),
                us: Err(Error::Plot { reason: us, .. }),
            } => left_out.push(InBoth { metric, us }),
            _ => {}
        }
    }
    (pairs, left_out)
}

/// The plots of a page, by section.
struct Plots {
    drive: Vec<InBoth<Figure>>,
    /// The reason for each missing view of the drive.
    left_out: Vec<InBoth<String>>,
    strike: Vec<InBoth<Figure>>,
    /// Plots of outcomes by impact point on the face.
    strikes: Vec<InBoth<Figure>>,
    map: Vec<InBoth<Figure>>,
    chart: Vec<InBoth<Figure>>,
    effects: Vec<InBoth<Figure>>,
    curves: Vec<InBoth<Figure>>,
}

impl Plots {
    fn all(&self) -> impl Iterator<Item = &InBoth<Figure>> {
        let sections = [
            &self.drive,
            &self.strike,
            &self.strikes,
            &self.map,
            &self.chart,
            &self.effects,
            &self.curves,
        ];
        sections.into_iter().flatten()
    }
}

fn page(findings: &Findings, plots: &Plots) -> Result<String> {
    let InBoth { metric, us } = InBoth::of(|system| request::title(findings, system));
    let (metric, us) = (metric?, us?);
    let header = html! {
        h1 { "Drive: " (chosen(&metric, &us)) }
        p.faint { (request::subtitle(findings)?) }
    };
    let title = if findings.system == System::Us {
        us
    } else {
        metric
    };
    Ok(frame::page(
        &format!("longdrive: {title}"),
        &header,
        &main(findings, plots)?,
        Some(sections::footer(findings)),
        findings.system,
    ))
}

fn main(findings: &Findings, plots: &Plots) -> Result<Markup> {
    let of = shown::words(findings.of.name());
    // omit this remark: the summary already has it
    let why = findings.why_not_flown();
    let is_told = |remark: &&Message| {
        why.as_ref()
            .is_some_and(|why| why.in_units(findings.system) == remark.in_units(findings.system))
    };
    Ok(html! {
        (answer::answer(findings))
        section { h2 { "What was asked" } (request::request(findings)?) }
        @for remark in findings.remarks.iter().filter(|remark| !is_told(remark)) { p.warning { (both(|system| shown::spoken(&remark.in_units(system)))) } }
        section {
            h2 { "The drive" }
            (pictures(&plots.drive)?)
            @for InBoth { metric, us } in &plots.left_out {
                p.faint { (chosen(&capital(metric), &capital(us))) "." }
            }
            @if let Some(state) = &findings.explorer { (sections::explorer(state)) }
            (pictures(&plots.strike)?)
            h3 { "As set up, on a launch monitor" }
            (sections::panel(findings))
        }
        @if !plots.strikes.is_empty() {
            details {
                summary { h2 { "Strikes all over the face" } }
                (pictures(&plots.strikes)?)
            }
        }
        @if let Some(plane) = &findings.lofts {
            section { h2 { "Carry and total by loft and attack angle" } (lofts::lofts(plane)) }
        }
        @if !plots.map.is_empty() { section { h2 { "The map" } (pictures(&plots.map)?) } }
        @if !plots.chart.is_empty() { section { h2 { "The optimum as a parameter changes" } (pictures(&plots.chart)?) } }
        @if !plots.effects.is_empty() {
            section { h2 { "What moves the " (of) ", at the drive as set up" } (pictures(&plots.effects)?) }
        }
        section {
            @if let Some(best) = findings.best() {
                h2 { "The optimum" }
                (sections::optimum(findings, best)?)
                h3 { "Launch and flight" }
            } @else {
                h2 { "Launch and flight" }
            }
            (sections::outcomes(&findings.flown))
        }
        @if !plots.effects.is_empty() {
            section { h2 { "The uncertainties and their sources" } (sections::uncertainties(&findings.effects)) }
        }
        @if !findings.rows.is_empty() {
            details {
                summary { h2 { "How exact the derivatives are, at the drive as set up" } }
                (pictures(&plots.curves)?)
                (sections::verdicts(&findings.rows)?)
            }
        }
        details { summary { h2 { "The setup" } } (sections::setup(findings)?) }
    })
}
