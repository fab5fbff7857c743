//! Bars on an axis that shows names instead of numbers. All rows have the same height. The names
//! are on the left, or above the bars if long names do not fit in a narrow picture. The values are
//! at the ends of the bars.

use super::axis::{Axis, AxisScale};
use super::canvas::{Anchor, Canvas, Font, Stroke};
use super::figure::{Figure, HorizontalBar, Shape};
use super::layers::PlotArea;
use super::palette::BAR_OPACITY;
use super::text_width::{SMALL_TEXT, text_width, widest, wrapped};
use crate::units::{Digits, DisplayUnit, is_zero, leading_number, signed, typeset};

/// Text size of values, pixels.
const VALUE: f64 = 12.0;
/// Height of a line of a name, pixels.
const NAME_LINE: f64 = 15.0;

/// Maximum width of names on the left, as a fraction of the picture's width. Wider names are
/// wrapped.
const BESIDE: f64 = 0.38;
/// Maximum number of lines of a name on the left. If any name needs more, all names are above the
/// bars.
const MOST_LINES: usize = 2;

/// Height of a row, pixels.
const ROW: f64 = 34.0;
/// Half the height of a bar, pixels: in a row with one strip, and in a row with two strips (see
/// [`strip`]).
const HALF: [f64; 2] = [8.0, 6.0];

/// Distance between the middle of a row and the middle of each of its two strips, pixels.
const STRIP_OFFSET: f64 = 7.5;

/// Distance between a bar's end and its value, pixels.
const VALUE_GAP: f64 = 4.0;

/// The rows of an axis that shows names, and the position of the names.
pub(super) struct BarRows {
    names: Vec<Vec<String>>,
    /// Height of the names above the bars, pixels; 0 if the names are on the left.
    names_height: f64,
    /// Width of the names on the left, pixels.
    pub left: f64,
}

impl BarRows {
    /// The rows of a figure whose vertical axis shows names; `None` for other axes.
    pub fn of(figure: &Figure, width: f64) -> Option<Self> {
        let AxisScale::Names(names) = &figure.y.scale else {
            return None;
        };
        let lines = |room: f64| -> Vec<Vec<String>> {
            names
                .iter()
                .map(|name| in_lines(&typeset(name), room))
                .collect()
        };
        let beside = lines(BESIDE * width);
        if beside.iter().all(|lines| lines.len() <= MOST_LINES) {
            return Some(Self {
                names_height: 0.0,
                left: widest(beside.iter().flatten(), false) + 14.0,
                names: beside,
            });
        }
        let names = lines(width - 24.0);
        let most = names.iter().map(Vec::len).max().unwrap_or(0);
        Some(Self {
            names,
            names_height: NAME_LINE * most as f64,
            left: 12.0,
        })
    }

    fn height(&self) -> f64 {
        ROW + self.names_height
    }

    /// The height of all rows.
    pub fn heights(&self) -> f64 {
        self.height() * self.names.len() as f64
    }

    /// The middle of the bars of a row, pixels from the top of the frame.
    fn middle(&self, row: usize) -> f64 {
        row as f64 * self.height() + self.names_height + 0.5 * ROW
    }

    /// Draws the line at 0 and the names.
    pub fn draw(&self, canvas: &mut Canvas, area: &PlotArea) {
        let palette = canvas.palette;
        let [left, top, _, bottom] = area.frame;
        if let Some([x, _]) = area.pixel([0.0, 0.0]) {
            canvas.line(&[[x, top], [x, bottom]], Stroke::new(palette.faint, 1.0));
        }
        let font = Font::new(SMALL_TEXT, palette.ink);
        for (row, lines) in self.names.iter().enumerate() {
            let middle = top + self.middle(row);
            for (i, line) in lines.iter().enumerate() {
                if self.names_height == 0.0 {
                    let below = NAME_LINE * (i as f64 - 0.5 * (lines.len() - 1) as f64);
                    canvas.text(line, [left - 8.0, middle + below], Anchor::Right, font);
                    continue;
                }
                // the last line of the name is directly above the bars
                let up = 0.5 * ROW + NAME_LINE * (lines.len() as f64 - i as f64 - 0.5) - 2.0;
                let y = middle - up;
                let right = left + 8.0 + text_width(line, SMALL_TEXT, false);
                let [low, high] = [
                    [left + 2.0, y - 0.5 * NAME_LINE],
                    [right, y + 0.5 * NAME_LINE],
                ];
                canvas.rectangle(low, high, palette.background, 1.0);
                canvas.text(line, [left + 4.0, y], Anchor::Left, font);
            }
        }
    }

    /// Draws the bars of a layer with their values.
    pub fn bars(&self, canvas: &mut Canvas, area: &PlotArea, figure: &Figure, layer: usize) {
        let hue = figure.layers[layer].hue;
        let Shape::Bars(bars) = &figure.layers[layer].shape else {
            return;
        };
        let font = Font::new(VALUE, canvas.palette.ink);
        for bar in bars {
            let ends = [0.0, bar.to].map(|x| area.pixel([x, bar.row as f64]));
            let [Some([from, _]), Some([to, _])] = ends else {
                continue;
            };
            let (strip, strips) = strip(figure, layer, bar);
            let half = HALF[strips - 1];
            let middle = area.frame[1]
                + self.middle(bar.row)
                + if strips == 1 {
                    0.0
                } else {
                    STRIP_OFFSET * (2.0 * strip as f64 - 1.0)
                };
            let [low, high] = [[from.min(to), middle - half], [from.max(to), middle + half]];
            canvas.rectangle(low, high, canvas.palette.of(hue), BAR_OPACITY);
            let (x, anchor) = if is_left(figure, layer, bar) {
                (to - VALUE_GAP, Anchor::Right)
            } else {
                (to + VALUE_GAP, Anchor::Left)
            };
            let value = value(figure, layer, bar);
            canvas.text(&value, [x, middle], anchor, font);
        }
    }
}

/// A name wrapped into lines, without a break after "±".
fn in_lines(name: &str, room: f64) -> Vec<String> {
    match name.split_once(" ± ") {
        Some((words, amount)) if text_width(name, SMALL_TEXT, false) > room => {
            let amount = wrapped(
                &format!("±\u{2007}{amount}").replace(' ', "\u{2007}"),
                room,
                SMALL_TEXT,
                false,
            );
            let amount = amount.into_iter().map(|line| line.replace('\u{2007}', " "));
            wrapped(words, room, SMALL_TEXT, false)
                .into_iter()
                .chain(amount)
                .collect()
        }
        _ => wrapped(name, room, SMALL_TEXT, false),
    }
}

/// The bars that the other layers have in a row, each with the index of its layer.
fn others(figure: &Figure, layer: usize, row: usize) -> Vec<(usize, HorizontalBar)> {
    let mut others = vec![];
    for (i, other) in figure
        .layers
        .iter()
        .enumerate()
        .filter(|(i, _)| *i != layer)
    {
        if let Shape::Bars(bars) = &other.shape {
            others.extend(
                bars.iter()
                    .filter(|bar| bar.row == row)
                    .map(|bar| (i, *bar)),
            );
        }
    }
    others
}

/// The strip of a bar, and the number of strips in its row. If bars would overlap, the row has two
/// strips: 0 above 1. Otherwise it has one strip.
fn strip(figure: &Figure, layer: usize, bar: &HorizontalBar) -> (usize, usize) {
    let ends = |bar: &HorizontalBar| [bar.to.min(0.0), bar.to.max(0.0)];
    let [low, high] = ends(bar);
    let covers = |other: &HorizontalBar| {
        let [from, to] = ends(other);
        from < high && low < to
    };
    match others(figure, layer, bar.row)
        .iter()
        .find(|(_, other)| covers(other))
    {
        Some((i, _)) => (usize::from(*i < layer), 2),
        None => (0, 1),
    }
}

/// True if the value of a bar is on the left. Then the bar points left, or it has no length and the
/// other bar of the row points right.
fn is_left(figure: &Figure, layer: usize, bar: &HorizontalBar) -> bool {
    let mut others = others(figure, layer, bar.row).into_iter();
    bar.to < 0.0 || (bar.to <= 0.0 && others.any(|(_, other)| other.to > 0.0))
}

/// The value at the end of a bar, in the unit of the axis: "+3.9". The value has more digits if all
/// values of the row would be displayed as 0.
fn value(figure: &Figure, layer: usize, bar: &HorizontalBar) -> String {
    let DisplayUnit { quantity, unit } = figure.x.quantity.of;
    let unit = figure.system.unit(unit);
    let amount = bar.to;
    let text = quantity.read_off(amount, unit);
    let is_lost = |bar: &HorizontalBar| {
        let text = quantity.read_off(bar.to.abs(), unit);
        is_zero(leading_number(&text))
    };
    let is_row_lost = is_lost(bar)
        && others(figure, layer, bar.row)
            .iter()
            .all(|(_, other)| is_lost(other));
    let text = if is_row_lost {
        quantity.text(amount, unit, Digits::Difference)
    } else {
        text
    };
    signed(amount, leading_number(&text).to_owned())
}

/// The horizontal axis for a frame of this width, pixels. The range of the axis leaves space for
/// the values at the bars. `None` if the frame is too narrow for the values.
pub(super) fn with_room(figure: &Figure, width: f64) -> Option<Axis> {
    let (mut low, mut high) = (0.0_f64, 0.0_f64);
    let mut beside = [0.0_f64; 2];
    for (layer, bars) in figure.layers.iter().enumerate() {
        let Shape::Bars(bars) = &bars.shape else {
            continue;
        };
        for bar in bars.iter().filter(|bar| bar.to.is_finite()) {
            low = low.min(bar.to);
            high = high.max(bar.to);
            let side = usize::from(!is_left(figure, layer, bar));
            beside[side] = beside[side].max(
                text_width(&typeset(&value(figure, layer, bar)), VALUE, false) + 2.0 * VALUE_GAP,
            );
        }
    }
    let room = width - beside[0] - beside[1];
    let span = if high > low {
        high - low
    } else {
        return Some(figure.x.clone());
    };
    let per_pixel = span / room;
    (room > 0.25 * width).then(|| {
        figure
            .x
            .clone()
            .exactly(low - beside[0] * per_pixel, high + beside[1] * per_pixel)
    })
}
