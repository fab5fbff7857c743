use super::canvas::{Area, FINE, LINE, Labels, TEXT, failed, fine, font, stroke, words};
use super::contour::grounds;
use super::figure::{Figure, Layer};
use super::hover::titles as hover_titles;
use super::layers::{Plane, contour_lines, draw, field_arrows, is_area, label};
use super::layout::{Layout, MARGIN, NUMBER, TITLE};
use super::line_names::write_line_names;
use super::marks::{write_marks, write_texts};
use super::palette::{DARK, LIGHT, Palette};
use crate::error::Result;
use crate::units::System;
use plotters::backend::SVGBackend;
use plotters::chart::ChartBuilder;
use plotters::drawing::IntoDrawingArea;
use plotters::style::text_anchor::HPos;
use plotters::style::{Color, TRANSPARENT, TextStyle};
use std::fmt::Write;

/// The appearance of a plot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// The units of the axes.
    pub system: System,
    /// The colours.
    pub shades: Shades,
    /// The width, pixels. The text size does not depend on it.
    pub width: u32,
}

impl Default for Look {
    /// US units, light, 480 pixels: readable on a phone and in a printed column.
    fn default() -> Self {
        Self {
            system: System::Us,
            shades: Shades::Light,
            width: 480,
        }
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

/// A drawn figure: SVG elements and their height, pixels.
pub(super) struct Panel {
    pub body: String,
    pub height: f64,
}

/// Draws a figure without its further views.
///
/// # Errors
/// [`Error::Plot`](crate::Error::Plot) if no part of the figure can be shown on its axes, or if the
/// width is too small for them.
pub(super) fn panel(figure: &Figure, look: &Look) -> Result<Panel> {
    let layout = Layout::new(figure, look.system, look.width)?;
    let mut svg = String::new();
    let hover = draw_all(&mut svg, figure, look, &layout)?;
    // only the elements: the picture may contain several panels
    let body = svg
        .split_once('>')
        .map_or("", |(_, body)| body)
        .trim_end()
        .trim_end_matches("</svg>");
    Ok(Panel {
        body: format!("{body}{hover}"),
        height: layout.height,
    })
}

/// Draws a figure and returns its tooltips.
fn draw_all(svg: &mut String, figure: &Figure, look: &Look, layout: &Layout<'_>) -> Result<String> {
    let (palette, system) = (look.shades.palette(), look.system);
    let size = (
        fine(f64::from(look.width)) as u32,
        fine(layout.height) as u32,
    );
    let area = SVGBackend::with_string(svg, size).into_drawing_area();
    area.fill(&palette.ground).map_err(failed)?;
    texts(&area, palette, layout)?;
    let plane = Plane {
        x: &layout.x,
        y: &layout.y,
        frame: layout.frame,
    };
    let is_map = |layer: &Layer| matches!(layer, Layer::Contours(_));
    axes(&area, &plane, palette, figure.layers.iter().any(is_map))?;
    // computed once for drawing, labels and tooltips
    let contours = |layer: &Layer| match layer {
        Layer::Contours(field) => grounds(field, system),
        _ => vec![],
    };
    let grounds: Vec<_> = figure.layers.iter().map(contours).collect();
    let layers = || figure.layers.iter().zip(&grounds);
    let (areas, others): (Vec<_>, Vec<_>) = layers().partition(|(layer, _)| is_area(layer));
    for (layer, grounds) in areas {
        draw(&area, &plane, palette, layer, grounds)?;
    }
    for grounds in &grounds {
        contour_lines(&area, &plane, palette, grounds)?;
    }
    for (layer, grounds) in others {
        draw(&area, &plane, palette, layer, grounds)?;
    }
    if let Some(rows) = &layout.rows {
        rows.draw(&area, &plane, palette)?;
        (0..figure.layers.len())
            .try_for_each(|layer| rows.bars(&area, &plane, palette, system, figure, layer))?;
    }
    let mut labels = Labels {
        area: &area,
        palette,
        taken: vec![],
    };
    write_marks(&mut labels, &plane, figure)?;
    write_texts(&mut labels, &plane, figure)?;
    write_line_names(&mut labels, &plane, figure)?;
    if let Some(names) = &layout.end_names {
        names.draw(&labels, &plane, figure)?;
    }
    label(&mut labels, &plane, system, figure, &grounds)?;
    field_arrows(&labels, &plane, figure)?;
    area.present().map_err(failed)?;
    Ok(hover_titles(figure, &plane, system, &grounds))
}

/// Writes the title, the line below it, the legend and the titles of the axes.
fn texts(area: &Area<'_>, palette: &Palette, layout: &Layout<'_>) -> Result<()> {
    let frame = layout.frame;
    let write = |lines: &[String], first: [f64; 2], side: HPos, style: &TextStyle<'static>| {
        lines.iter().enumerate().try_for_each(|(i, line)| {
            let at = [first[0], first[1] + i as f64 * LINE];
            words(area, line, at, side, style.clone())
        })
    };
    let bold = font(TITLE, palette.ink, true);
    let faint = font(TEXT, palette.faint, false);
    let top = 0.5 * LINE + 3.0;
    write(&layout.titles, [MARGIN, top], HPos::Left, &bold)?;
    let below = layout.titles.len() as f64 * LINE;
    write(&layout.subtitles, [MARGIN, below + top], HPos::Left, &faint)?;
    let legend = [MARGIN, below + layout.subtitles.len() as f64 * LINE + 5.0];
    let mut entries = layout.legend.iter();
    entries.try_for_each(|entry| entry.draw(area, palette, legend))?;
    let above = frame[1] - (layout.y_title.len() as f64 - 0.5) * LINE - 8.0;
    write(&layout.y_title, [MARGIN, above], HPos::Left, &faint)?;
    let x_title = [frame[2], frame[3] + 1.6 * LINE + 1.0];
    write(&layout.x_title, x_title, HPos::Right, &faint)
}

/// Draws the axes and the grid with Plotters.
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
        .label_style(font(NUMBER, palette.ink, false))
        .set_all_tick_mark_size(4 * FINE)
        .x_label_formatter(&|at| x.text(*at))
        .y_label_formatter(&|at| y.text(*at))
        .draw()
        .map_err(failed)
}

/// CSS rules that give dark colours to the light pictures inside `inside`.
pub fn dark_rules(inside: &str) -> String {
    let mut rules = String::new();
    for (light, dark) in LIGHT.all().into_iter().zip(DARK.all()) {
        let hex = |color: plotters::style::RGBColor| {
            let (r, g, b) = color.rgb();
            format!("#{r:02X}{g:02X}{b:02X}")
        };
        let (light, dark) = (hex(light), hex(dark));
        // writing to a string cannot fail
        let _ = writeln!(
            rules,
            "{inside} [fill=\"{light}\"]{{fill:{dark}}}{inside} \
             [stroke=\"{light}\"]{{stroke:{dark}}}"
        );
    }
    rules
}
