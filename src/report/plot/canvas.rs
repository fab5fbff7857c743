//! The canvas of a plot: SVG elements, in pixels of the picture.

use super::palette::{Color, Palette};
use super::text_width::{SMALL_TEXT, text_width};
use crate::units::typeset;
use maud::{Markup, html};

/// Width of a symbol in the legend, pixels.
pub(super) const SIGN: f64 = 24.0;

/// The height of a line of text, pixels.
pub(super) const LINE: f64 = 19.0;

/// The part of a text that is at a given position: its left end, middle or right end.
#[derive(Clone, Copy)]
pub(super) enum Anchor {
    Left,
    Middle,
    Right,
}

/// The appearance of a text.
#[derive(Clone, Copy)]
pub(super) struct Font {
    /// The size, pixels.
    pub size: f64,
    pub color: Color,
    pub is_bold: bool,
}

impl Font {
    /// A regular font.
    pub fn new(size: f64, color: Color) -> Self {
        Self {
            size,
            color,
            is_bold: false,
        }
    }
}

/// The appearance of a line.
#[derive(Clone, Copy)]
pub(super) struct Stroke {
    pub color: Color,
    /// The width, pixels.
    pub width: f64,
    pub is_dashed: bool,
}

impl Stroke {
    /// A solid line.
    pub fn new(color: Color, width: f64) -> Self {
        Self {
            color,
            width,
            is_dashed: false,
        }
    }
}

/// A picture in progress. Each element covers the elements drawn before it.
pub(super) struct Canvas {
    pub palette: &'static Palette,
    /// The height, pixels.
    pub height: f64,
    /// The elements.
    pub svg: String,
    /// The rectangles of labels and marks, which another label must not cover.
    pub labelled: Vec<[[f64; 2]; 2]>,
}

impl Canvas {
    fn draw(&mut self, element: Markup) {
        self.svg.push_str(&element.0);
        self.svg.push('\n');
    }

    /// Draws a text whose vertical middle is at `y`.
    pub fn text(&mut self, text: &str, [x, y]: [f64; 2], anchor: Anchor, font: Font) {
        let anchor = match anchor {
            Anchor::Left => "start",
            Anchor::Middle => "middle",
            Anchor::Right => "end",
        };
        let weight = font.is_bold.then_some("bold");
        self.draw(html! {
            text x=(pixels(x)) y=(pixels(y)) dy="0.5ex" text-anchor=(anchor)
                font-family="sans-serif" font-size=(font.size) font-weight=[weight]
                fill=(font.color) { (typeset(text)) }
        });
    }

    /// A rectangle with an opacity.
    pub fn rectangle(&mut self, low: [f64; 2], high: [f64; 2], color: Color, opacity: f64) {
        let [left, top] = low.map(pixels);
        let [width, height] = [0, 1].map(|axis| pixels(high[axis] - low[axis]));
        self.draw(html! {
            rect x=(left) y=(top) width=(width) height=(height) fill=(color) opacity=(opacity) {}
        });
    }

    /// A line through points.
    pub fn line(&mut self, points: &[[f64; 2]], stroke: Stroke) {
        let dashes = stroke.is_dashed.then_some("6 4");
        self.draw(html! {
            polyline points=(list(points)) fill="none" stroke=(stroke.color)
                stroke-width=(stroke.width) stroke-dasharray=[dashes] {}
        });
    }

    /// A filled polygon with an opacity.
    pub fn polygon(&mut self, points: &[[f64; 2]], color: Color, opacity: f64) {
        self.draw(html! { polygon points=(list(points)) fill=(color) opacity=(opacity) {} });
    }

    /// A filled circle.
    pub fn disc(&mut self, [x, y]: [f64; 2], radius: f64, color: Color) {
        self.draw(html! { circle cx=(pixels(x)) cy=(pixels(y)) r=(radius) fill=(color) {} });
    }

    /// An invisible circle with a tooltip.
    pub fn point_tooltip(&mut self, tooltip: &str, [x, y]: [f64; 2], radius: f64) {
        self.draw(html! {
            circle cx=(pixels(x)) cy=(pixels(y)) r=(radius) fill="none" pointer-events="all" {
                title { (typeset(tooltip)) }
            }
        });
    }

    /// An invisible line with a tooltip.
    pub fn line_tooltip(&mut self, tooltip: &str, points: &[[f64; 2]], width: f64) {
        self.draw(html! {
            path d={ "M" (list(points)) } fill="none" stroke="none" stroke-width=(width)
                pointer-events="stroke" { title { (typeset(tooltip)) } }
        });
    }

    /// The rectangle that a label needs around its middle. It is large enough for bold text.
    pub fn label_extent(text: &str, middle: [f64; 2]) -> [[f64; 2]; 2] {
        let half = [
            0.5 * text_width(&typeset(text), SMALL_TEXT, true) + 3.0,
            0.5 * LINE - 1.0,
        ];
        [
            [middle[0] - half[0], middle[1] - half[1]],
            [middle[0] + half[0], middle[1] + half[1]],
        ]
    }

    /// True if a rectangle overlaps no label and no mark.
    pub fn is_free(&self, [low, high]: [[f64; 2]; 2]) -> bool {
        let apart = |other: &[[f64; 2]; 2]| {
            (0..2).any(|axis| high[axis] < other[0][axis] || low[axis] > other[1][axis])
        };
        self.labelled.iter().all(apart)
    }

    /// Writes a label centred on a point, on a background that makes it readable.
    pub fn label(&mut self, text: &str, middle: [f64; 2], color: Color, is_bold: bool) {
        let extent = Self::label_extent(text, middle);
        self.rectangle(extent[0], extent[1], self.palette.background, 0.72);
        self.labelled.push(extent);
        let font = Font {
            size: SMALL_TEXT,
            color,
            is_bold,
        };
        self.text(text, middle, Anchor::Middle, font);
    }
}

/// Pixels with one decimal, below the resolution of the eye.
fn pixels(pixels: f64) -> f64 {
    (10.0 * pixels).round() / 10.0
}

/// Points in the syntax of an SVG attribute: "x,y x,y".
fn list(points: &[[f64; 2]]) -> String {
    let points: Vec<String> = points
        .iter()
        .map(|[x, y]| format!("{},{}", pixels(*x), pixels(*y)))
        .collect();
    points.join(" ")
}
