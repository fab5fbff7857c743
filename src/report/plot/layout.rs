//! Positions of titles, legend, axes and frame. The text size is constant; text that is too wide is
//! wrapped or moved.

use super::axis::Axis;
use super::bars::{BarRows, with_room};
use super::canvas::LINE;
use super::end_names::EndNames;
use super::figure::{Figure, Layer, Shape};
use super::layers::PlotArea;
use super::legend::{LegendEntry, laid_out};
use super::text_width::{SMALL_TEXT, TEXT, text_width, wrapped};
use super::ticks::DrawnAxis;
use crate::error::{Error, Result};
use crate::units::typeset;

/// Margin of a picture, pixels.
pub(super) const MARGIN: f64 = 6.0;

/// Text size of the title, pixels.
pub(super) const TITLE: f64 = TEXT + 2.0;
/// Minimum width of the frame of the axes, pixels.
const LEAST_WIDTH: f64 = 100.0;

/// Maximum number of ticks on a vertical axis.
const MOST_TICKS: usize = 6;
/// Approximate distance of ticks on a horizontal axis, pixels.
const TICK_SPACING: f64 = 60.0;

/// The layout of a figure for a width.
pub(super) struct Layout<'a> {
    pub titles: Vec<String>,
    pub subtitles: Vec<String>,
    pub legend: Vec<LegendEntry<'a>>,
    /// The axes in their frame.
    pub area: PlotArea,
    /// The titles of the axes, wrapped into lines.
    pub x_title: Vec<String>,
    pub y_title: Vec<String>,
    /// The rows of an axis that shows names.
    pub rows: Option<BarRows>,
    /// The names at the ends of lines.
    pub end_names: Option<EndNames<'a>>,
    pub height: f64,
}

impl<'a> Layout<'a> {
    /// # Errors
    /// [`Error::Plot`] if no part of the figure can be shown on its axes, or if the width is too
    /// small for them.
    pub fn new(figure: &'a Figure, width: u32) -> Result<Self> {
        let failed = |reason: String| Error::Plot {
            name: figure.name.clone(),
            reason,
        };
        let width = f64::from(width);
        let room = width - 2.0 * MARGIN;
        let titles = wrapped(&typeset(&figure.title), room, TITLE, true);
        let subtitles = wrapped(&typeset(&figure.subtitle), room, TEXT, false);
        let (legend, legend_height) = laid_out(figure, room);
        let titled = |drawn: &DrawnAxis| wrapped(&typeset(&drawn.title()), room, TEXT, false);
        let rows = BarRows::of(figure, width);
        let end_names = EndNames::of(figure, width);
        let mut area = axes(figure, width, rows.as_ref(), end_names.as_ref())
            .map_err(|axis| failed(format!("it has no number that its {axis} axis can show")))?;
        let [left, _, right, tall] = area.frame;
        if right - left < LEAST_WIDTH {
            let least = (width + LEAST_WIDTH - (right - left)).ceil();
            return Err(failed(format!(
                "a width of {width} pixels leaves no room for its axes; take {least} or more"
            )));
        }
        let (x_title, y_title) = (titled(&area.x), titled(&area.y));
        let top =
            (titles.len() + subtitles.len() + y_title.len()) as f64 * LINE + legend_height + 23.0;
        area.frame = [left, top, right, top + tall];
        let height = (area.frame[3] + (1.0 + x_title.len() as f64) * LINE + 10.0).ceil();
        Ok(Self {
            titles,
            subtitles,
            legend,
            area,
            x_title,
            y_title,
            rows,
            end_names,
            height,
        })
    }
}

/// The axes, in a frame whose top is at 0. The vertical axis has as many ticks as possible without
/// overlapping texts. The error is the name of an axis that can show none of the values.
fn axes(
    figure: &Figure,
    width: f64,
    rows: Option<&BarRows>,
    end_names: Option<&EndNames<'_>>,
) -> std::result::Result<PlotArea, &'static str> {
    let ys = || figure.layers.iter().flat_map(Layer::points).map(|at| at[1]);
    let beside = end_names.map_or(0.0, |names| names.room);
    let mut found = Err("vertical");
    for count in (1..=MOST_TICKS).rev() {
        let y = DrawnAxis::new(&figure.y, ys(), figure.system, count).ok_or("vertical")?;
        let left = rows.map_or(15.0 + y.widest(), |rows| rows.left);
        let (x, left, right) = across(figure, left, width, beside).ok_or("horizontal")?;
        let tall = match (rows, end_names) {
            (Some(rows), _) => rows.heights(),
            (None, names) => {
                let names = names.map_or(0.0, EndNames::height);
                names.max(figure.aspect * (right - left))
            }
        };
        let is_readable = rows.is_some() || y.is_readable(tall, |_, _| LINE - 2.0);
        found = Ok(PlotArea {
            x,
            y,
            frame: [left, 0.0, right, tall],
        });
        if is_readable {
            break;
        }
    }
    found
}

/// The horizontal axis and the left and right end of the frame. The axis has as many ticks as
/// possible without overlapping texts. The frame leaves the width `beside` free on its right.
fn across(figure: &Figure, left: f64, width: f64, beside: f64) -> Option<(DrawnAxis, f64, f64)> {
    let xs = || figure.layers.iter().flat_map(Layer::points).map(|at| at[0]);
    let has_bars = figure
        .layers
        .iter()
        .any(|layer| matches!(layer.shape, Shape::Bars(_)));
    let mut last = None;
    let most = ((width - left - beside) / TICK_SPACING).max(4.0) as usize;
    for count in (1..=most).rev() {
        let x = DrawnAxis::new(&figure.x, xs(), figure.system, count)?;
        // half of the text at the first and at the last tick lies beyond the end of the axis
        let half = 0.5 * x.widest() + 4.0;
        let (left, right) = (left.max(half), width - half.max(16.0).max(beside));
        let widened: Option<Axis> = if has_bars {
            with_room(figure, right - left)
        } else {
            None
        };
        let x = match widened {
            Some(axis) => DrawnAxis::new(&axis, xs(), figure.system, count)?,
            None => x,
        };
        let is_readable = x.is_readable(right - left, |a, b| {
            0.5 * (text_width(a, SMALL_TEXT, false) + text_width(b, SMALL_TEXT, false)) + 6.0
        });
        last = Some((x, left, right));
        if is_readable {
            break;
        }
    }
    last
}
