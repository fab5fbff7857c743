use super::canvas::{Area, FINE, LINE, Labels, TEXT, failed, fine, font, stroke, words};
use super::contour::grounds;
use super::figure::{Figure, Layer};
use super::hover::titles as hover_titles;
use super::layers::{Plane, draw, field_arrows, label};
use super::layout::{Layout, MARGIN, NUMBER, TITLE};
use super::line_names::write_line_names;
use super::marks::write_marks;
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
    let palette = look.shades.palette();
    let layout = Layout::new(figure, look.system, look.width)?;
    let (width, frame) = (f64::from(look.width), layout.frame);
    let mut svg = String::new();
    let hover;
    {
        let size = (fine(width) as u32, fine(layout.height) as u32);
        let area = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        area.fill(&palette.ground).map_err(failed)?;
        let lines = |lines: &[String],
                     first: [f64; 2],
                     side: HPos,
                     style: &dyn Fn() -> TextStyle<'static>| {
            let mut lines = lines.iter().enumerate();
            lines.try_for_each(|(i, line)| {
                words(
                    &area,
                    line,
                    [first[0], first[1] + i as f64 * LINE],
                    side,
                    style(),
                )
            })
        };
        let faint = || font(TEXT, palette.faint, false);
        lines(
            &layout.titles,
            [MARGIN, 0.5 * LINE + 3.0],
            HPos::Left,
            &|| font(TITLE, palette.ink, true),
        )?;
        let below = layout.titles.len() as f64 * LINE;
        lines(
            &layout.subtitles,
            [MARGIN, below + 0.5 * LINE + 3.0],
            HPos::Left,
            &faint,
        )?;
        let legend_top = below + layout.subtitles.len() as f64 * LINE + 5.0;
        layout
            .legend
            .iter()
            .try_for_each(|entry| entry.draw(&area, palette, [MARGIN, legend_top]))?;
        let above = frame[1] - (layout.y_title.len() as f64 - 0.5) * LINE - 8.0;
        lines(&layout.y_title, [MARGIN, above], HPos::Left, &faint)?;
        lines(
            &layout.x_title,
            [frame[2], frame[3] + 1.6 * LINE + 1.0],
            HPos::Right,
            &faint,
        )?;

        let plane = Plane {
            x: &layout.x,
            y: &layout.y,
            frame,
        };
        let is_map = figure
            .layers
            .iter()
            .any(|layer| matches!(layer, Layer::Contours(_)));
        axes(&area, &plane, palette, is_map)?;
        // computed once for drawing, labels and tooltips
        let grounds: Vec<_> = figure
            .layers
            .iter()
            .map(|layer| {
                if let Layer::Contours(field) = layer {
                    grounds(field, look.system)
                } else {
                    vec![]
                }
            })
            .collect();
        for (layer, grounds) in figure.layers.iter().zip(&grounds) {
            draw(&area, &plane, palette, layer, grounds)?;
        }
        if let Some(rows) = &layout.rows {
            rows.draw(&area, &plane, palette)?;
            (0..figure.layers.len()).try_for_each(|layer| {
                rows.bars(&area, &plane, palette, look.system, figure, layer)
            })?;
        }
        let mut labels = Labels {
            area: &area,
            palette,
            taken: vec![],
        };
        write_marks(&mut labels, &plane, figure)?;
        write_line_names(&mut labels, &plane, figure)?;
        label(&mut labels, &plane, look.system, figure, &grounds)?;
        field_arrows(&labels, &plane, figure)?;
        hover = hover_titles(figure, &plane, look.system, &grounds);
        area.present().map_err(failed)?;
    }
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
