//! Names of lines at their right ends, beside the plot.

use super::canvas::{Anchor, Canvas, Font, LINE, Stroke};
use super::figure::{Figure, Hue, LineNames, Shape};
use super::layers::PlotArea;
use super::text_width::{SMALL_TEXT, widest, wrapped};
use crate::units::typeset;

/// Distance between lines of a name, pixels.
const LINE_SPACING: f64 = LINE - 3.0;
/// Additional distance between names, pixels.
const NAME_GAP: f64 = 3.0;

/// Length of the connector between the plot and a name, pixels.
const CONNECTOR: f64 = 16.0;

/// A line ends at a side of the plot if its end is at most this far from the side, pixels.
const END_TOLERANCE: f64 = 3.0;
/// Maximum height of a connector above the plot, pixels.
const CONNECTOR_HEIGHT: f64 = 10.0;

/// Maximum width of the names relative to the picture; wider names are wrapped.
const WIDEST: f64 = 0.42;

/// Minimum width for the axes and the connectors, pixels. The names have the rest.
const FRAME: f64 = 160.0;

/// The names of a figure's lines.
pub(super) struct EndNames<'a> {
    names: Vec<Name<'a>>,
    /// The width that the names need beside the frame of the axes, pixels.
    pub room: f64,
}

/// A name with the colour of its line.
struct Name<'a> {
    name: &'a str,
    hue: Hue,
    /// The name, wrapped into lines.
    lines: Vec<String>,
}

impl<'a> EndNames<'a> {
    /// The names of the lines; `None` if the figure has the names elsewhere.
    pub fn of(figure: &'a Figure, width: f64) -> Option<Self> {
        if figure.line_names != LineNames::AtEnds {
            return None;
        }
        let mut names: Vec<Name<'a>> = vec![];
        for layer in &figure.layers {
            let name = layer.name.as_str();
            let is_line = matches!(layer.shape, Shape::Line { .. });
            if !is_line || name.is_empty() || names.iter().any(|one| one.name == name) {
                continue;
            }
            let room = (WIDEST * width).min(width - FRAME);
            names.push(Name {
                name,
                hue: layer.hue,
                lines: wrapped(&typeset(name), room, SMALL_TEXT, is_bold(layer.hue)),
            });
        }
        let width = |name: &Name<'_>| widest(&name.lines, is_bold(name.hue));
        let widths = names.iter().map(width);
        Some(Self {
            room: CONNECTOR + widths.fold(0.0, f64::max) + 4.0,
            names,
        })
    }

    /// The height of all names, pixels.
    pub fn height(&self) -> f64 {
        self.names.iter().map(Name::height).sum()
    }

    /// Writes each name beside the end of its line, as near as the other names allow.
    pub fn draw(&self, canvas: &mut Canvas, area: &PlotArea, figure: &Figure) {
        let [_, top, right, bottom] = area.frame;
        let placed = self.names.iter();
        let placed = placed.filter_map(|name| Some((name, name.end(area, figure)?)));
        // true for a line that leaves the plot through its top edge
        let leaves = |at: [f64; 2]| at[1] < top + END_TOLERANCE && at[0] < right - END_TOLERANCE;
        let (mut leaving, mut placed): (Vec<_>, Vec<_>) = placed.partition(|(_, at)| leaves(*at));
        // the connectors of these lines are above the plot; the line that leaves at the smallest x
        // has the highest connector
        leaving.sort_by(|(_, a), (_, b)| a[0].total_cmp(&b[0]));
        placed.sort_by(|(_, a), (_, b)| a[1].total_cmp(&b[1]));
        let above = leaving.len();
        let all = [leaving, placed].concat();
        let wanted: Vec<f64> = all.iter().map(|(_, at)| at[1]).collect();
        let heights: Vec<f64> = all.iter().map(|(name, _)| name.height()).collect();
        let middles = stacked_middles(&wanted, &heights, [top, bottom]);
        for (i, ((name, end), middle)) in all.into_iter().zip(middles).enumerate() {
            let color = canvas.palette.of(name.hue);
            let start = [right + CONNECTOR, middle];
            let mut connector = vec![end];
            if i < above {
                let up = top - CONNECTOR_HEIGHT * (above - i) as f64 / above as f64;
                let across = right + (CONNECTOR - 3.0) * (above - i) as f64 / (above + 1) as f64;
                connector.extend([[end[0], up], [across, up], [across, middle]]);
            }
            connector.push([start[0] - 3.0, middle]);
            canvas.line(&connector, Stroke::new(color, 0.7));
            let font = Font {
                size: SMALL_TEXT,
                color,
                is_bold: is_bold(name.hue),
            };
            let first = middle - 0.5 * LINE_SPACING * (name.lines.len() - 1) as f64;
            for (i, line) in name.lines.iter().enumerate() {
                let at = [start[0], first + LINE_SPACING * i as f64];
                canvas.text(line, at, Anchor::Left, font);
            }
        }
    }
}

/// True if the name of a line is bold: a series is more important than a background line.
fn is_bold(hue: Hue) -> bool {
    matches!(hue, Hue::Series(_))
}

impl Name<'_> {
    fn height(&self) -> f64 {
        LINE_SPACING * self.lines.len() as f64 + NAME_GAP
    }

    /// The rightmost point of the line inside the axes, pixels; `None` if no point is inside.
    fn end(&self, area: &PlotArea, figure: &Figure) -> Option<[f64; 2]> {
        let points = figure.layers.iter().filter_map(|layer| match &layer.shape {
            Shape::Line { points, .. } if layer.name == self.name => Some(area.all(points)),
            _ => None,
        });
        points.flatten().max_by(|a, b| a[0].total_cmp(&b[0]))
    }
}

/// The middles of boxes with these heights. The boxes are stacked in this order between `top` and
/// `bottom` without overlap, with the minimum sum of squared distances from the `wanted` middles.
/// This is the isotonic regression of wanted − offset, where the offset of a box is its middle in a
/// stack without gaps.
fn stacked_middles(wanted: &[f64], heights: &[f64], [top, bottom]: [f64; 2]) -> Vec<f64> {
    let mut above = 0.0;
    let offsets: Vec<f64> = heights
        .iter()
        .map(|height| {
            above += height;
            above - 0.5 * height
        })
        .collect();
    // for each block of touching boxes: the number of boxes, and the sum of wanted − offset
    let mut blocks: Vec<(usize, f64)> = vec![];
    for (wanted, offset) in wanted.iter().zip(&offsets) {
        let mut block = (1, wanted - offset);
        while let Some((count, sum)) = blocks.pop() {
            if sum / (count as f64) < block.1 / (block.0 as f64) {
                blocks.push((count, sum));
                break;
            }
            block = (block.0 + count, block.1 + sum);
        }
        blocks.push(block);
    }
    let starts = blocks.into_iter().flat_map(|(count, sum)| {
        let start = (sum / count as f64).min(bottom - above).max(top);
        std::iter::repeat_n(start, count)
    });
    starts
        .zip(offsets)
        .map(|(start, offset)| start + offset)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::stacked_middles;

    #[test]
    fn exact_middles_of_boxes_that_would_overlap() {
        let heights = [10.0; 4];
        let ends = [0.0, 100.0];
        for (wanted, middles) in [
            // the wanted middles are far apart, so each box has its wanted middle
            ([10.0, 30.0, 50.0, 90.0], [10.0, 30.0, 50.0, 90.0]),
            // two boxes with the same wanted middle move by equal distances
            ([10.0, 50.0, 50.0, 90.0], [10.0, 45.0, 55.0, 90.0]),
            // boxes that are wanted at the limits stay between the limits
            ([0.0, 0.0, 50.0, 100.0], [5.0, 15.0, 50.0, 95.0]),
            ([98.0, 99.0, 100.0, 100.0], [65.0, 75.0, 85.0, 95.0]),
        ] {
            let found = stacked_middles(&wanted, &heights, ends);
            for (found, middle) in found.iter().zip(middles) {
                assert!((found - middle).abs() < 1e-9, "{wanted:?}: {found}");
            }
        }
    }
}
