use super::canvas::{Area, CHARACTER, FINE, LINE, Labels, TEXT, failed, fine, font, stroke, words};
use super::figure::{Figure, Layer};
use super::hover::titles as hover_titles;
use super::layers::{Plane, draw, label};
use super::legend::{entry, laid_out};
use super::palette::{DARK, LIGHT, Palette};
use super::ticks::Drawn;
use crate::error::{Error, Result};
use crate::units::System;
use plotters::backend::SVGBackend;
use plotters::chart::ChartBuilder;
use plotters::drawing::IntoDrawingArea;
use plotters::style::text_anchor::HPos;
use plotters::style::{Color, TRANSPARENT};
use std::fmt::Write;

/// How a plot is to look.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// The units on its axes.
    pub system: System,
    /// Its colours.
    pub shades: Shades,
    /// Its width, pixels. Text keeps its size.
    pub width: u32,
}

impl Default for Look {
    /// US units, light, 480 pixels: read on a phone and in a column of print.
    fn default() -> Self {
        Self { system: System::Us, shades: Shades::Light, width: 480 }
    }
}

/// The colours of a plot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shades {
    /// For a bright page and for print.
    Light,
    /// For a dark page.
    Dark,
}

impl Shades {
    fn palette(self) -> &'static Palette {
        match self {
            Self::Light => &LIGHT,
            Self::Dark => &DARK,
        }
    }
}

/// A figure as drawn: elements of SVG, and how tall they are, pixels.
pub(super) struct Panel {
    pub body: String,
    pub height: f64,
}

/// Draws a figure without its other views.
///
/// # Errors
/// [`Error::Plot`] where nothing of it has a place on its axes.
pub(super) fn panel(figure: &Figure, look: &Look) -> Result<Panel> {
    let palette = look.shades.palette();
    let width = f64::from(look.width);
    let nothing = |axis: &str| {
        let reason = format!("it has no number that its {axis} axis can show");
        Error::Plot { name: figure.name.clone(), reason }
    };
    let [xs, ys] = [0, 1].map(|axis| coordinates(figure).map(move |point| point[axis]));
    // as many numbers as find room below each other, about
    let rows = (figure.aspect * (width - 60.0) / (1.5 * LINE)).clamp(2.0, 6.0) as usize;
    let y = Drawn::new(&figure.y, ys, look.system, rows).ok_or_else(|| nothing("vertical"))?;

    let titles = wrapped(&figure.title, ((width - 12.0) / (CHARACTER * 1.25)) as usize);
    let subtitles = wrapped(&figure.subtitle, ((width - 12.0) / CHARACTER) as usize);
    let (legend, legend_height) = laid_out(figure, width - 12.0);
    let y_title = y.title();
    let heads = (titles.len() + subtitles.len()) as f64 + if y_title.is_empty() { 0.0 } else { 1.0 };
    let left = 15.0 + 1.1 * CHARACTER * y.longest() as f64;
    // as many numbers as find room beside each other
    let count = ((width - left) / 60.0).max(2.0) as usize;
    let x = Drawn::new(&figure.x, xs, look.system, count).ok_or_else(|| nothing("horizontal"))?;
    let top = heads * LINE + legend_height + 20.0;
    // the text of a tick stands under it, half of it to each side, also at the ends of the axis
    let half = Labels::half_width(x.longest());
    let (left, right) = (left.max(half), width - half.max(16.0));
    let frame = [left, top, right, top + figure.aspect * (right - left)];
    let height = (frame[3] + 2.0 * LINE + 10.0).ceil();

    let mut svg = String::new();
    let hover;
    {
        let size = (fine(width) as u32, fine(height) as u32);
        let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        area.fill(&palette.ground).map_err(failed)?;
        let title_style = || font(TEXT + 2.0, palette.ink, true);
        for (i, title) in titles.iter().enumerate() {
            words(&area, title, [6.0, (i as f64 + 0.5) * LINE + 3.0], HPos::Left, title_style())?;
        }
        let faint = || font(TEXT, palette.faint, false);
        for (i, line) in subtitles.iter().enumerate() {
            let y = ((titles.len() + i) as f64 + 0.5) * LINE + 3.0;
            words(&area, line, [6.0, y], HPos::Left, faint())?;
        }
        let legend_top = (titles.len() + subtitles.len()) as f64 * LINE + 5.0;
        for (layer, [at_x, at_y]) in &legend {
            entry(&area, palette, layer, [6.0 + at_x, legend_top + at_y])?;
        }
        words(&area, &y_title, [6.0, frame[1] - 0.5 * LINE - 5.0], HPos::Left, faint())?;
        words(&area, &x.title(), [frame[2], frame[3] + 1.6 * LINE], HPos::Right, faint())?;

        let plane = Plane { x: &x, y: &y, frame };
        let is_map = figure.layers.iter().any(|layer| matches!(layer, Layer::Contours(_)));
        axes(&area, &plane, palette, is_map)?;
        for layer in &figure.layers {
            draw(&area, &plane, palette, look.system, layer)?;
        }
        let mut labels = Labels { area: &area, palette, taken: vec![] };
        label(&mut labels, &plane, look.system, figure)?;
        hover = hover_titles(figure, &plane, look.system);
        area.present().map_err(failed)?;
    }
    // the elements alone: the picture around them may hold several panels
    let body = svg.split_once('>').map_or("", |(_, body)| body).trim_end().trim_end_matches("</svg>");
    Ok(Panel { body: format!("{body}{hover}"), height })
}

/// The axes and the mesh, by the library.
fn axes(area: &Area<'_>, plane: &Plane<'_>, palette: &Palette, is_map: bool) -> Result<()> {
    let Plane { x, y, frame } = plane;
    let (wide, tall) = area.dim_in_pixel();
    let label_height = fine(1.2 * LINE);
    let mut chart = ChartBuilder::on(area)
        .margin_top(fine(frame[1]))
        .margin_right(wide as i32 - fine(frame[2]))
        .margin_bottom(tall as i32 - fine(frame[3]) - label_height)
        .x_label_area_size(label_height)
        .y_label_area_size(fine(frame[0]))
        .build_cartesian_2d((*x).clone(), (*y).clone())
        .map_err(failed)?;
    let mut mesh = chart.configure_mesh();
    if is_map {
        mesh.disable_mesh();
    }
    mesh.light_line_style(TRANSPARENT)
        .bold_line_style(stroke(palette.mesh, 0.8))
        .axis_style(stroke(palette.faint, 1.0))
        .label_style(font(TEXT - 0.5, palette.ink, false))
        .set_all_tick_mark_size(4 * FINE)
        .x_label_formatter(&|at| x.text(*at))
        .y_label_formatter(&|at| y.text(*at))
        .draw()
        .map_err(failed)
}

/// The points that the axes must reach.
fn coordinates(figure: &Figure) -> impl Iterator<Item = [f64; 2]> + '_ {
    figure.layers.iter().flat_map(|layer| -> Vec<[f64; 2]> {
        match layer {
            Layer::Line { points, .. } | Layer::Dots { points, .. } => points.clone(),
            Layer::Band { points, .. } => points.iter().flat_map(|[x, low, high]| [[*x, *low], [*x, *high]]).collect(),
            Layer::Bars { bars, .. } => {
                bars.iter().flat_map(|bar| [bar.from, bar.to].map(|x| [x, bar.place as f64])).collect()
            }
            Layer::Contours(field) => vec![[field.x[0], field.y[0]], [field.x[1], field.y[1]]],
            Layer::Mark { at, .. } => vec![*at],
            Layer::Region { rings, .. } => rings.concat(),
            Layer::Arrows { arrows, .. } => arrows.iter().flatten().copied().collect(),
            Layer::Frame { low, high, .. } => vec![*low, *high],
        }
    })
}

/// Words in lines of at most so many characters.
fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = vec![];
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.into()),
        }
    }
    lines
}

/// Rules of CSS that turn the colours of light pictures within `inside` into those of dark ones.
pub fn dark_rules(inside: &str) -> String {
    let mut rules = String::new();
    for (light, dark) in LIGHT.all().into_iter().zip(DARK.all()) {
        let hex = |color: plotters::style::RGBColor| {
            let (r, g, b) = color.rgb();
            format!("#{r:02X}{g:02X}{b:02X}")
        };
        let (light, dark) = (hex(light), hex(dark));
        // what a string takes, it takes
        let _ =
            writeln!(rules, "{inside} [fill=\"{light}\"]{{fill:{dark}}}{inside} [stroke=\"{light}\"]{{stroke:{dark}}}");
    }
    rules
}
