//! The drawing area of a plot, in pixels of the picture.

use super::palette::Palette;
use super::text_width::text_width;
use crate::error::{Error, Result};
use crate::units::typeset;
use plotters::backend::SVGBackend;
use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind};
use plotters::element::{PathElement, Rectangle, Text};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontStyle, IntoFont, RGBColor, ShapeStyle, TextStyle};

/// Plotters has integer coordinates. This many make a pixel, so that curves are smooth.
pub(super) const FINE: i32 = 10;

/// Size of the text, pixels.
pub(super) const TEXT: f64 = 13.5;

/// Width of a symbol in the legend, pixels.
pub(super) const SIGN: f64 = 24.0;

/// The height of a line of text, pixels.
pub(super) const LINE: f64 = 19.0;

pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// An error of Plotters as [`Error::Plot`].
pub(super) fn failed<E: std::error::Error + Send + Sync>(error: DrawingAreaErrorKind<E>) -> Error {
    Error::Plot {
        name: "SVG".into(),
        reason: error.to_string(),
    }
}

/// Pixels as integer coordinates of Plotters.
pub(super) fn fine(pixels: f64) -> i32 {
    (pixels * f64::from(FINE)).round() as i32
}

/// The style of a line with a width in pixels.
pub(super) fn stroke(color: RGBColor, width: f64) -> ShapeStyle {
    color.stroke_width(fine(width) as u32)
}

/// A font with a size in pixels. (A size of Plotters is 1.24 times the size in SVG.)
pub(super) fn font(size: f64, color: RGBColor, is_bold: bool) -> TextStyle<'static> {
    let style = if is_bold {
        FontStyle::Bold
    } else {
        FontStyle::Normal
    };
    ("sans-serif", size * 1.24 * f64::from(FINE))
        .into_font()
        .style(style)
        .color(&color)
}

/// Typeset text with its vertical middle at a position, pixels.
pub(super) fn words(
    area: &Area<'_>,
    text: &str,
    at: [f64; 2],
    align: HPos,
    style: TextStyle<'static>,
) -> Result<()> {
    let style = style.pos(Pos::new(align, VPos::Center));
    area.draw(&Text::new(typeset(text), (fine(at[0]), fine(at[1])), style))
        .map_err(failed)
}

/// A rectangle in pixels with an opacity.
pub(super) fn block(
    area: &Area<'_>,
    low: [f64; 2],
    high: [f64; 2],
    color: RGBColor,
    alpha: f64,
) -> Result<()> {
    let corners = [low, high].map(|[x, y]| (fine(x), fine(y)));
    area.draw(&Rectangle::new(corners, color.mix(alpha).filled()))
        .map_err(failed)
}

/// A line in pixels.
pub(super) fn path(area: &Area<'_>, points: &[[f64; 2]], style: ShapeStyle) -> Result<()> {
    let points: Vec<_> = points.iter().map(|[x, y]| (fine(*x), fine(*y))).collect();
    area.draw(&PathElement::new(points, style)).map_err(failed)
}

/// Labels on a background that makes them readable; `taken` are the occupied rectangles.
pub(super) struct Labels<'a, 'b> {
    pub area: &'a Area<'b>,
    pub palette: &'a Palette,
    pub taken: Vec<[[f64; 2]; 2]>,
}

impl Labels<'_, '_> {
    /// The rectangle of a text around a point, pixels, large enough for bold text.
    pub fn extent(text: &str, middle: [f64; 2]) -> [[f64; 2]; 2] {
        let half = [
            0.5 * text_width(&typeset(text), TEXT - 0.5, true) + 3.0,
            0.5 * LINE - 1.0,
        ];
        [
            [middle[0] - half[0], middle[1] - half[1]],
            [middle[0] + half[0], middle[1] + half[1]],
        ]
    }

    /// True if a rectangle overlaps no occupied rectangle.
    pub fn is_free(&self, [low, high]: [[f64; 2]; 2]) -> bool {
        let apart = |other: &[[f64; 2]; 2]| {
            (0..2).any(|axis| high[axis] < other[0][axis] || low[axis] > other[1][axis])
        };
        self.taken.iter().all(apart)
    }

    /// Writes a text centred on a point.
    pub fn write(
        &mut self,
        text: &str,
        middle: [f64; 2],
        color: RGBColor,
        is_bold: bool,
    ) -> Result<()> {
        let extent = Self::extent(text, middle);
        block(self.area, extent[0], extent[1], self.palette.ground, 0.72)?;
        self.taken.push(extent);
        words(
            self.area,
            text,
            middle,
            HPos::Center,
            font(TEXT - 0.5, color, is_bold),
        )
    }
}
