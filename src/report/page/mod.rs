//! A page to look at: one HTML file that needs nothing else, and its plots and their data as files beside it.

mod findings;
mod numbers;
mod sections;

pub use findings::Findings;

use super::figures::{
    At, Causes, Flown, View, chart_figures, map_figure, tornado_figure, trajectory_figure, vcurve_figure,
};
use super::plot::{Figure, Look, Shades, dark_rules, figure_csv, figure_svg};
use crate::error::Result;
use crate::study::{Chart, Effects, Map};
use crate::units::System;
use maud::{DOCTYPE, Markup, PreEscaped, html};

/// A file of a report.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Document {
    /// Its name.
    pub name: String,
    /// What is in it.
    pub text: String,
}

/// The files of a report: `index.html`, and for each plot `NAME-us.svg`, `NAME-metric.svg` and `NAME.csv`.
///
/// # Errors
/// As [`figure_svg`] and [`figure_csv`].
pub fn report_documents(findings: &Findings<'_>) -> Result<Vec<Document>> {
    let plots = Plots {
        drive: trajectories(findings.flown),
        map: findings.map.map(|map| in_each(|system| mapped(findings, map, system))).into_iter().collect(),
        chart: findings.chart.map(charts).unwrap_or_default(),
        // without any effect there is no bar to draw
        effects: findings
            .effects
            .iter()
            .flat_map(|effects| Causes::APART.map(|causes| tornados(effects, causes)))
            .flatten()
            .collect(),
        curves: match findings.rows {
            [] => vec![],
            rows => vec![alike(&vcurve_figure(rows, findings.loops, At::SetUp))],
        },
    };
    let mut documents = vec![Document { name: "index.html".into(), text: page(findings, &plots)?.into_string() }];
    for pair in plots.all() {
        for (figure, system) in pair.iter().zip(System::ALL) {
            let text = figure_svg(figure, &Look { system, ..Look::default() })?;
            documents.push(Document { name: svg_name(figure, system), text });
        }
        let [figure, _] = pair;
        documents.push(Document { name: csv_name(figure), text: figure_csv(figure)? });
    }
    Ok(documents)
}

/// A plot with its words in the units of each of [`System::ALL`].
type Pair = [Figure; 2];

fn in_each(figure: impl Fn(System) -> Figure) -> Pair {
    System::ALL.map(figure)
}

/// A plot without any unit in its words.
fn alike(figure: &Figure) -> Pair {
    in_each(|_| figure.clone())
}

fn mapped(findings: &Findings<'_>, map: &Map, system: System) -> Figure {
    map_figure(map, findings.limits, findings.best, findings.flatness, system)
}

/// The effects of some causes as set up, where they have any.
fn tornados(effects: &Effects, causes: Causes) -> Option<Pair> {
    let [metric, us] = System::ALL.map(|system| tornado_figure(effects, causes, At::SetUp, system));
    Some([metric?, us?])
}

fn charts(chart: &Chart) -> Vec<Pair> {
    let [metric, us] = System::ALL.map(|system| chart_figures(chart, system));
    metric.into_iter().zip(us).map(|(metric, us)| [metric, us]).collect()
}

/// The paths of what flies, from both sides.
fn trajectories(flown: &[Flown]) -> Vec<Pair> {
    let flying: Vec<Flown> = flown.iter().filter(|one| one.path.points.len() > 1).cloned().collect();
    let views: &[View] = if flying.is_empty() { &[] } else { &[View::Side, View::Top] };
    views.iter().map(|view| alike(&trajectory_figure(&flying, *view))).collect()
}

/// The plots of a page, by section.
struct Plots {
    drive: Vec<Pair>,
    map: Vec<Pair>,
    chart: Vec<Pair>,
    effects: Vec<Pair>,
    curves: Vec<Pair>,
}

impl Plots {
    fn all(&self) -> impl Iterator<Item = &Pair> {
        let sections = [&self.drive, &self.map, &self.chart, &self.effects, &self.curves];
        sections.into_iter().flatten()
    }
}

fn svg_name(figure: &Figure, system: System) -> String {
    format!("{}-{system}.svg", figure.name)
}

fn csv_name(figure: &Figure) -> String {
    format!("{}.csv", figure.name)
}

fn page(findings: &Findings<'_>, plots: &Plots) -> Result<Markup> {
    let dark = format!(
        "@media screen and (prefers-color-scheme: dark) {{\n{}{}}}",
        include_str!("dark.css"),
        dark_rules("figure")
    );
    let [drive, map, chart, effects, curves] =
        [&plots.drive, &plots.map, &plots.chart, &plots.effects, &plots.curves].map(|figures| pictures(figures));
    Ok(html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { "longdrive: " (findings.name) }
                style { (PreEscaped(include_str!("style.css"))) (PreEscaped(dark)) }
            }
            body {
                input.units #units-us type="radio" name="units" checked[findings.system == System::Us] aria-label="US units";
                input.units #units-metric type="radio" name="units" checked[findings.system == System::Metric]
                    aria-label="metric units";
                header {
                    h1 { "Drive: " (findings.name) }
                    p.faint { (about(findings)) }
                    div.switch { label for="units-us" { "yd, mph" } label for="units-metric" { "m, m/s" } }
                }
                main {
                    @for remark in findings.remarks { p.warning { (numbers::both(|system| remark.in_units(system))) } }
                    section {
                        h2 { "The drive" }
                        (sections::panel(findings))
                        (drive?)
                        (sections::outcomes(findings.flown))
                    }
                    @if let Some(best) = findings.best {
                        section { h2 { "The optimum" } (sections::optimum(best, findings.flatness)) (map?) }
                    } @else if !plots.map.is_empty() {
                        section { h2 { "The map" } (map?) }
                    }
                    @if !plots.chart.is_empty() {
                        section { h2 { "The optimum as a parameter changes" } (chart?) }
                    }
                    @if !plots.effects.is_empty() {
                        section { h2 { "Effects of uncertainties" } (effects?) (sections::uncertainties(findings.effects)) }
                    }
                    @if !plots.curves.is_empty() {
                        section { h2 { "How exact the derivatives are" } (curves?) (sections::verdicts(findings.rows)) }
                    }
                    section { h2 { "The setup" } (sections::setup(findings)?) }
                }
            }
        }
    })
}

/// What is drawn, in a sentence. That of a preset is about its club, which strikes nothing where the launch is given.
fn about(findings: &Findings<'_>) -> String {
    if findings.setup.launch.is_given() {
        return format!(
            "The ball leaves as its launch says, without a club; its flight is based on the preset {}.",
            findings.preset.name
        );
    }
    findings.preset.about.into()
}

/// Plots side by side, each in both systems of units, of which the page shows one.
fn pictures(pairs: &[Pair]) -> Result<Markup> {
    let picture = |figure: &Figure, system: System| {
        let look = Look { system, shades: Shades::Light, ..Look::default() };
        figure_svg(figure, &look).map(PreEscaped)
    };
    let drawn = pairs
        .iter()
        .map(|[metric, us]| Ok(((us, picture(us, System::Us)?), (metric, picture(metric, System::Metric)?))));
    let drawn = drawn.collect::<Result<Vec<_>>>()?;
    Ok(html! {
        div.figures {
            @for ((us, in_us), (metric, in_metric)) in drawn {
                figure {
                    div.us { (in_us) }
                    div.metric { (in_metric) }
                    figcaption {
                        (numbers::both(|system| if system == System::Us { &us.note } else { &metric.note }.clone())) " "
                        a.us href=(svg_name(us, System::Us)) { "SVG" }
                        a.metric href=(svg_name(metric, System::Metric)) { "SVG" }
                        " " a href=(csv_name(us)) { "data" }
                    }
                }
            }
        }
    })
}
