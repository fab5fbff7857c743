//! What the layers are called, in lines above the plot.

use super::canvas::{Area, CHARACTER, LINE, SIGN, TEXT, block, font, words};
use super::figure::{Figure, Hue, Layer};
use super::layers::{arrow, line, point, region, series};
use super::palette::Palette;
use crate::error::Result;
use plotters::style::text_anchor::HPos;

/// The layers that a legend names, each with its place, pixels from the legend's top left, and the height of it all. One
/// layer alone needs no legend: the title names it.
pub(super) fn laid_out(figure: &Figure, width: f64) -> (Vec<(&Layer, [f64; 2])>, f64) {
    let is_named = |layer: &&Layer| {
        let (name, hue) = layer.named();
        let is_named_where_it_is = matches!(layer, Layer::Mark { .. })
            || (figure.names_on_lines && matches!(layer, Layer::Line { .. } | Layer::Region { is_hatched: true, .. }));
        !name.is_empty() && hue.is_some() && !is_named_where_it_is && !is_part_of_another(figure, name)
    };
    let layers: Vec<&Layer> = figure.layers.iter().filter(is_named).collect();
    if layers.is_empty() || (layers.len() == 1 && figure.layers.len() == 1) {
        return (vec![], 0.0);
    }
    let mut at = [0.0, 0.5 * LINE];
    let mut placed = vec![];
    for layer in layers {
        let wide = SIGN + 6.0 + CHARACTER * layer.named().0.chars().count() as f64;
        if at[0] > 0.0 && at[0] + wide > width {
            at = [0.0, at[1] + LINE];
        }
        placed.push((layer, at));
        at[0] += wide + 14.0;
    }
    (placed, at[1] + 0.5 * LINE + 3.0)
}

/// Whether a layer goes with another, named as that one with a remark behind: "ferguson (extrapolated)".
fn is_part_of_another(figure: &Figure, name: &str) -> bool {
    let whole = name.rsplit_once(" (").map(|(whole, _)| whole);
    whole.is_some_and(|whole| {
        figure.layers.iter().any(|layer| layer.named().0 == whole && !matches!(layer, Layer::Mark { .. }))
    })
}

/// Draws a layer's sign and name.
pub(super) fn entry(area: &Area<'_>, palette: &Palette, layer: &Layer, [x, y]: [f64; 2]) -> Result<()> {
    let (name, hue) = layer.named();
    let hue = hue.unwrap_or(Hue::Ink);
    let color = palette.of(hue);
    let ends = [[x, y], [x + SIGN, y]];
    match layer {
        Layer::Line { is_dashed, .. } => series(area, &ends, palette, hue, *is_dashed)?,
        Layer::Region { is_hatched, .. } => {
            let corners = [[x, y - 6.0], [x + SIGN, y - 6.0], [x + SIGN, y + 6.0], [x, y + 6.0]];
            region(area, &[corners.to_vec()], color, *is_hatched)?;
        }
        Layer::Frame { .. } => line(area, &ends, color, true)?,
        Layer::Dots { .. } => point(area, [x + 0.5 * SIGN, y], palette, hue)?,
        Layer::Band { .. } => block(area, [x, y - 6.0], [x + SIGN, y + 6.0], color, 0.22)?,
        Layer::Bars { .. } => block(area, [x, y - 6.0], [x + SIGN, y + 6.0], color, 0.85)?,
        Layer::Arrows { .. } => arrow(area, ends[0], ends[1], color)?,
        Layer::Contours(_) | Layer::Mark { .. } => {}
    }
    words(area, name, [x + SIGN + 6.0, y], HPos::Left, font(TEXT - 0.5, palette.ink, false))
}
