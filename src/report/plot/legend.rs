//! The legend: names of layers, in lines above the plot.

use super::canvas::{Anchor, Canvas, Font, LINE, SIGN};
use super::figure::{Figure, Layer, LineNames, Shape};
use super::layers::{arrow, point, region, series};
use super::palette::{BAND_OPACITY, BAR_OPACITY};
use super::text_width::{SMALL_TEXT, widest, wrapped};
use crate::units::typeset;

/// Distance between a symbol and its name, and between a name and the next symbol, pixels.
const GAPS: [f64; 2] = [6.0, 14.0];

/// A legend with more names than this is arranged in columns if it does not fit in one line.
const FEW: usize = 4;

/// A layer in a legend.
pub(super) struct LegendEntry<'a> {
    layer: &'a Layer,
    /// The name of the layer, wrapped into lines.
    lines: Vec<String>,
    /// The start of the symbol, pixels from the top left of the legend.
    at: [f64; 2],
}

/// The legend, with its height in pixels. A single layer has no legend, because the title names it.
pub(super) fn laid_out(figure: &Figure, width: f64) -> (Vec<LegendEntry<'_>>, f64) {
    let layers: Vec<&Layer> = figure
        .layers
        .iter()
        .filter(|layer| is_named(figure, layer))
        .collect();
    if layers.is_empty() || (layers.len() == 1 && figure.layers.len() == 1) {
        return (vec![], 0.0);
    }
    let lines = |layer: &Layer| {
        wrapped(
            &typeset(&layer.name),
            width - SIGN - GAPS[0],
            SMALL_TEXT,
            false,
        )
    };
    let named: Vec<(&Layer, Vec<String>)> = layers
        .into_iter()
        .map(|layer| (layer, lines(layer)))
        .collect();
    let wide = |lines: &[String]| SIGN + GAPS[0] + widest(lines, false);
    let all_lines = named.iter().flat_map(|(_, lines)| lines);
    let widest_entry = SIGN + GAPS[0] + widest(all_lines, false);
    let all = named
        .iter()
        .map(|(_, lines)| wide(lines) + GAPS[1])
        .sum::<f64>()
        - GAPS[1];
    // use columns if there are many names, so that a name is easy to find
    let column = (named.len() > FEW && all > width).then_some(widest_entry + GAPS[1]);
    let (mut at, mut tallest, mut entries) = ([0.0, 0.5 * LINE], 1, vec![]);
    for (layer, lines) in named {
        let wide = wide(&lines);
        if at[0] > 0.0 && at[0] + column.map_or(wide, |column| column - GAPS[1]) > width {
            at = [0.0, at[1] + LINE * tallest as f64];
            tallest = 1;
        }
        tallest = tallest.max(lines.len());
        entries.push(LegendEntry { layer, lines, at });
        at[0] += column.unwrap_or(wide + GAPS[1]);
    }
    (entries, at[1] + LINE * (tallest as f64 - 0.5) + 3.0)
}

/// True if the legend names a layer: it is the first of its name, and its name is not elsewhere.
/// Marks and texts have labels, and contours the values of their levels. Names of lines are in the
/// legend only with [`LineNames::Legend`].
fn is_named(figure: &Figure, layer: &Layer) -> bool {
    let is_named_elsewhere = match layer.shape {
        Shape::Mark(_) | Shape::Text(_) | Shape::Contours(_) => true,
        Shape::Line { .. } => figure.line_names != LineNames::Legend,
        Shape::Region { is_hatched, .. } => is_hatched && figure.line_names == LineNames::OnLines,
        _ => false,
    };
    let has_label = |other: &Layer| matches!(other.shape, Shape::Mark(_) | Shape::Text(_));
    let mut alike = figure
        .layers
        .iter()
        .filter(|other| other.name == layer.name && !has_label(other));
    let is_first = alike.next().is_some_and(|first| std::ptr::eq(first, layer));
    !layer.name.is_empty() && !is_named_elsewhere && is_first
}

impl LegendEntry<'_> {
    /// Draws the symbol and the name of a layer; `left` and `top` are the corner of the legend.
    pub fn draw(&self, canvas: &mut Canvas, [left, top]: [f64; 2]) {
        let hue = self.layer.hue;
        let color = canvas.palette.of(hue);
        let [x, y] = [left + self.at[0], top + self.at[1]];
        let ends = [[x, y], [x + SIGN, y]];
        let [low, high] = [[x, y - 6.0], [x + SIGN, y + 6.0]];
        match self.layer.shape {
            Shape::Line { is_dashed, .. } => series(canvas, &ends, hue, is_dashed),
            Shape::Region { is_hatched, .. } => {
                let corners = vec![low, [high[0], low[1]], high, [low[0], high[1]]];
                region(canvas, &[corners], hue, is_hatched);
            }
            Shape::Dots(_) => point(canvas, [x + 0.5 * SIGN, y], hue),
            Shape::Band(_) => canvas.rectangle(low, high, color, BAND_OPACITY),
            Shape::Bars(_) => canvas.rectangle(low, high, color, BAR_OPACITY),
            Shape::Arrows(_) => arrow(canvas, ends[0], ends[1], color),
            Shape::Contours(_) | Shape::Mark(_) | Shape::Text(_) => {}
        }
        let font = Font::new(SMALL_TEXT, canvas.palette.ink);
        for (i, line) in self.lines.iter().enumerate() {
            let at = [x + SIGN + GAPS[0], y + i as f64 * LINE];
            canvas.text(line, at, Anchor::Left, font);
        }
    }
}
