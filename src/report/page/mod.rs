//! A page to look at: one HTML file that needs nothing else, and its plots and their data as files beside it.

mod numbers;
mod sections;

use super::figures::{Flown, View, chart_figures, map_figure, tornado_figure, trajectory_figure, vcurve_figure};
use super::plot::{Figure, Look, Shades, dark_rules, figure_csv, figure_svg};
use crate::error::Result;
use crate::parameters::{Preset, Setup};
use crate::reproduce::LoopRow;
use crate::study::certificate::Row;
use crate::study::{Chart, Constraint, Effects, Flatness, Map, Optimum};
use crate::units::System;
use maud::{DOCTYPE, Markup, PreEscaped, html};

/// What a report tells of. What is not there is left out of the page, and `remarks` says why.
pub struct Findings<'a> {
    /// What the setup is called.
    pub name: &'a str,
    /// The setup.
    pub setup: &'a Setup<f64>,
    /// The preset that it started from.
    pub preset: &'static Preset,
    /// The drive as set up, and at the optimum.
    pub flown: &'a [Flown],
    /// The optimum.
    pub best: Option<&'a Optimum>,
    /// How flat it is.
    pub flatness: Option<&'a Flatness>,
    /// The map around it.
    pub map: Option<&'a Map>,
    /// The constraints, each with the map of its outcome.
    pub limits: &'a [(Constraint, Map)],
    /// The optimum along a parameter.
    pub chart: Option<&'a Chart>,
    /// What stated uncertainties of parameters do to outcomes.
    pub effects: &'a [Effects],
    /// Differences beside exact derivatives.
    pub rows: &'a [Row],
    /// The same of the MAE 494 report's while-loop.
    pub loops: &'a [LoopRow],
    /// The units that the page is shown in at first.
    pub system: System,
    /// What deserves a word.
    pub remarks: &'a [String],
}

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
        map: findings
            .map
            .map(|map| map_figure(map, findings.limits, findings.best, findings.flatness))
            .into_iter()
            .collect(),
        chart: findings.chart.map(chart_figures).unwrap_or_default(),
        // without any effect there is no bar to draw
        effects: findings.effects.iter().filter(|e| e.standard_uncertainty() > 0.0).map(tornado_figure).collect(),
        curves: if findings.rows.is_empty() { vec![] } else { vec![vcurve_figure(findings.rows, findings.loops)] },
    };
    let mut documents = vec![Document { name: "index.html".into(), text: page(findings, &plots)?.into_string() }];
    for figure in plots.all() {
        for system in System::ALL {
            let text = figure_svg(figure, &Look { system, ..Look::default() })?;
            documents.push(Document { name: svg_name(figure, system), text });
        }
        documents.push(Document { name: csv_name(figure), text: figure_csv(figure)? });
    }
    Ok(documents)
}

/// The paths of what flies, from both sides.
fn trajectories(flown: &[Flown]) -> Vec<Figure> {
    let flying: Vec<Flown> = flown.iter().filter(|one| !one.path.points.is_empty()).cloned().collect();
    let views: &[View] = if flying.is_empty() { &[] } else { &[View::Side, View::Top] };
    views.iter().map(|view| trajectory_figure(&flying, *view)).collect()
}

/// The plots of a page, by section.
struct Plots {
    drive: Vec<Figure>,
    map: Vec<Figure>,
    chart: Vec<Figure>,
    effects: Vec<Figure>,
    curves: Vec<Figure>,
}

impl Plots {
    fn all(&self) -> impl Iterator<Item = &Figure> {
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
                    p.faint { (findings.preset.about) }
                    div.switch { label for="units-us" { "yd, mph" } label for="units-metric" { "m, m/s" } }
                }
                main {
                    @for remark in findings.remarks { p.warning { (remark) } }
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

/// Plots side by side, each in both systems of units, of which the page shows one.
fn pictures(figures: &[Figure]) -> Result<Markup> {
    let drawn = figures.iter().map(|figure| {
        let picture = |system: System| {
            let look = Look { system, shades: Shades::Light, ..Look::default() };
            figure_svg(figure, &look).map(PreEscaped)
        };
        Ok((figure, picture(System::Us)?, picture(System::Metric)?))
    });
    let drawn = drawn.collect::<Result<Vec<_>>>()?;
    Ok(html! {
        div.figures {
            @for (figure, us, metric) in drawn {
                figure {
                    div.us { (us) }
                    div.metric { (metric) }
                    figcaption {
                        (figure.note) " "
                        a.us href=(svg_name(figure, System::Us)) { "SVG" }
                        a.metric href=(svg_name(figure, System::Metric)) { "SVG" }
                        " " a href=(csv_name(figure)) { "data" }
                    }
                }
            }
        }
    })
}
