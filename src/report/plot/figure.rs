use super::axis::{Axis, NamedQuantity};
use crate::units::System;

/// A plot as data, in SI. Pictures and tables are made from it.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// The units of the axes and of the texts.
    pub system: System,
    /// The name in file names: "trajectory-side".
    pub name: String,
    /// The title: a few words.
    pub title: String,
    /// A line below the title with the constant parameters and their values; may be empty.
    pub subtitle: String,
    /// A note of a sentence or two; may be empty.
    pub note: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// Height over width of the frame of the axes. If an axis shows names, each row has a fixed
    /// height instead.
    pub aspect: f64,
    /// The layers, from the lowest to the highest.
    pub layers: Vec<Layer>,
    /// The position of the names of lines.
    pub line_names: LineNames,
    /// Further views, drawn after this view. The data file contains only those with contours,
    /// because the others repeat the data of this view.
    pub panels: Vec<Figure>,
    /// Number of views side by side, if the picture is wide enough.
    pub columns: usize,
}

impl Figure {
    /// An empty plot.
    pub fn new(
        system: System,
        name: impl Into<String>,
        title: impl Into<String>,
        x: Axis,
        y: Axis,
    ) -> Self {
        Self {
            system,
            name: name.into(),
            title: title.into(),
            subtitle: String::new(),
            note: String::new(),
            x,
            y,
            aspect: 0.72,
            layers: vec![],
            line_names: LineNames::Legend,
            panels: vec![],
            columns: 1,
        }
    }

    /// Adds a layer on top.
    #[must_use]
    pub fn with(mut self, layer: Layer) -> Self {
        self.layers.push(layer);
        self
    }

    /// Sets the note.
    #[must_use]
    pub fn noted(self, note: impl Into<String>) -> Self {
        Self {
            note: note.into(),
            ..self
        }
    }
}

/// The position of the names of lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineNames {
    /// In a legend above the plot.
    Legend,
    /// On the lines.
    OnLines,
    /// At the right ends of the lines, beside the plot.
    AtEnds,
}

/// The colour of a layer: a role, or the number of a series. The palette of the picture, light or
/// dark, determines the displayed colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hue {
    /// Text and axes.
    Ink,
    /// Background elements.
    Faint,
    /// A series, by number. The colours repeat after [`Hue::SERIES`] series. Each repetition adds
    /// one cross bar to lines and points.
    Series(usize),
}

impl Hue {
    /// The drive as set up: a solid line in every plot.
    pub const SET_UP: Self = Self::Series(0);

    /// The optimum: a dashed line in every plot.
    pub const OPTIMUM: Self = Self::Series(1);

    /// Number of colours for series.
    pub const SERIES: usize = 6;

    /// Number of short cross bars on lines and points. They distinguish series with the same
    /// colour.
    pub fn cross_bars(self) -> usize {
        match self {
            Self::Series(i) => i / Self::SERIES,
            Self::Ink | Self::Faint => 0,
        }
    }
}

/// A layer of a plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// The name. The picture does not show an empty name. Layers with the same name share one entry
    /// in the legend, or one name at the end of their lines.
    pub name: String,
    /// The difference from other layers with the same name, for the data and the tooltips; may be
    /// empty.
    pub remark: String,
    /// The colour. Contours do not use it, because they have no single colour.
    pub hue: Hue,
    /// The content.
    pub shape: Shape,
}

/// The content of a layer.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A line through points; it breaks where a coordinate is not finite.
    Line {
        /// True for a dashed line.
        is_dashed: bool,
        /// The points.
        points: Vec<[f64; 2]>,
    },
    /// Points.
    Dots(Vec<[f64; 2]>),
    /// The area between two lines: x, low, high.
    Band(Vec<[f64; 3]>),
    /// Horizontal bars, for an axis that shows names.
    Bars(Vec<HorizontalBar>),
    /// Contour lines with coloured regions between them.
    Contours(Box<Field>),
    /// A point, with the name of the layer as its label.
    Mark([f64; 2]),
    /// The name of the layer as a label without a symbol, with this middle.
    Text([f64; 2]),
    /// Arrows, each with its start and its end. If the layer has a name, arrows that a label would
    /// cover are omitted. Without a name, every arrow is drawn.
    Arrows(Vec<[[f64; 2]; 2]>),
    /// A region of the plane.
    Region {
        /// True for a forbidden region, which is hatched; other regions are tinted and outlined.
        is_hatched: bool,
        /// The outlines. If an area has holes, its outline also contains their rings, joined by
        /// straight lines.
        rings: Vec<Vec<[f64; 2]>>,
    },
}

impl Shape {
    /// A solid line through points.
    pub fn line(points: Vec<[f64; 2]>) -> Self {
        Self::Line {
            is_dashed: false,
            points,
        }
    }

    /// A dashed line through points.
    pub fn dashed(points: Vec<[f64; 2]>) -> Self {
        Self::Line {
            is_dashed: true,
            points,
        }
    }
}

impl Layer {
    /// A layer without a remark.
    pub fn new(name: impl Into<String>, hue: Hue, shape: Shape) -> Self {
        Self {
            name: name.into(),
            remark: String::new(),
            hue,
            shape,
        }
    }

    /// A solid line of a series.
    pub fn line(name: impl Into<String>, series: usize, points: Vec<[f64; 2]>) -> Self {
        let is_dashed = false;
        Self::new(name, Hue::Series(series), Shape::Line { is_dashed, points })
    }

    /// The points of a series.
    pub fn dots(name: impl Into<String>, series: usize, points: Vec<[f64; 2]>) -> Self {
        Self::new(name, Hue::Series(series), Shape::Dots(points))
    }

    /// The contours of a field, with the name of its quantity.
    pub fn contours(field: Field) -> Self {
        let name = field.quantity.label.clone();
        Self::new(name, Hue::Ink, Shape::Contours(Box::new(field)))
    }

    /// Sets the remark.
    #[must_use]
    pub fn remarked(self, remark: impl Into<String>) -> Self {
        Self {
            remark: remark.into(),
            ..self
        }
    }

    /// The name for data and tooltips: "ferguson (extrapolated)", the name with its remark.
    pub fn full_name(&self) -> String {
        if self.remark.is_empty() {
            self.name.clone()
        } else {
            format!("{} ({})", self.name, self.remark)
        }
    }

    /// The points of the layer. Contours have two opposite corners of the field instead.
    pub(in crate::report) fn points(&self) -> Vec<[f64; 2]> {
        match &self.shape {
            Shape::Line { points, .. } | Shape::Dots(points) => points.clone(),
            Shape::Band(points) => points
                .iter()
                .flat_map(|[x, low, high]| [[*x, *low], [*x, *high]])
                .collect(),
            Shape::Bars(bars) => bars
                .iter()
                .flat_map(|bar| [0.0, bar.to].map(|x| [x, bar.row as f64]))
                .collect(),
            Shape::Contours(field) => vec![[field.x[0], field.y[0]], [field.x[1], field.y[1]]],
            Shape::Mark(at) | Shape::Text(at) => vec![*at],
            Shape::Region { rings, .. } => rings.concat(),
            Shape::Arrows(arrows) => arrows.iter().flatten().copied().collect(),
        }
    }
}

/// A horizontal bar that begins at 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HorizontalBar {
    /// The index of the bar's name on the axis, from 0.
    pub row: usize,
    /// The value at which the bar ends, SI.
    pub to: f64,
}

/// Values on a uniform grid over the ranges of both axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// The quantity.
    pub quantity: NamedQuantity,
    /// The coordinates of the first and last column.
    pub x: [f64; 2],
    /// The coordinates of the first and last row.
    pub y: [f64; 2],
    /// The number of columns.
    pub columns: usize,
    /// The values by rows, the lowest row first; `None` for a missing value.
    pub values: Vec<Option<f64>>,
    /// The derivatives by x and y at each node, SI; empty if they are unknown. With derivatives,
    /// contours follow a cubic interpolation of the field. Without derivatives, a field is linear
    /// between nodes.
    pub gradients: Vec<Option<[f64; 2]>>,
    /// The values of this field and of all fields that share its levels and colours, SI. Empty if
    /// this field has levels and colours of its own.
    pub common_values: Vec<f64>,
}

impl Field {
    /// The number of rows.
    pub fn rows(&self) -> usize {
        self.values.len().checked_div(self.columns).unwrap_or(0)
    }

    /// The coordinates of a column and a row, counted from 0. A fractional column or row lies
    /// between nodes.
    pub fn coordinates(&self, column: f64, row: f64) -> [f64; 2] {
        let along = |[low, high]: [f64; 2], part: f64, count: usize| {
            low + (high - low) * part / (count.max(2) - 1) as f64
        };
        [
            along(self.x, column, self.columns),
            along(self.y, row, self.rows()),
        ]
    }

    /// The value at a point by bilinear interpolation; `None` outside of the grid, and next to a
    /// node without a value.
    pub fn at(&self, [x, y]: [f64; 2]) -> Option<f64> {
        let cell = |[low, high]: [f64; 2], at: f64, count: usize| {
            let along = (at - low) / (high - low) * (count.checked_sub(1)?) as f64;
            let first = along.floor().min(count.checked_sub(2)? as f64);
            (along >= 0.0 && along <= (count - 1) as f64).then_some((first as usize, along - first))
        };
        let ((column, right), (row, above)) = (
            cell(self.x, x, self.columns)?,
            cell(self.y, y, self.rows())?,
        );
        let node = |column: usize, row: usize| self.values[row * self.columns + column];
        let mix = |a: f64, b: f64, part: f64| a + part * (b - a);
        let low = mix(node(column, row)?, node(column + 1, row)?, right);
        let high = mix(node(column, row + 1)?, node(column + 1, row + 1)?, right);
        Some(mix(low, high, above))
    }
}
