use super::axis::{Axis, NamedQuantity};

/// A plot as data, in SI. Pictures and tables are made from it.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
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
    pub fn new(name: impl Into<String>, title: impl Into<String>, x: Axis, y: Axis) -> Self {
        let (name, title) = (name.into(), title.into());
        Self {
            name,
            title,
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

/// A layer of a plot. The picture does not show an empty name.
#[derive(Clone, Debug, PartialEq)]
pub enum Layer {
    /// A line through points; it breaks where a coordinate is not finite.
    Line {
        /// The name.
        name: String,
        /// The colour.
        hue: Hue,
        /// True for a dashed line.
        is_dashed: bool,
        /// The points.
        points: Vec<[f64; 2]>,
    },
    /// Points.
    Dots {
        /// The name.
        name: String,
        /// The colour.
        hue: Hue,
        /// The coordinates.
        points: Vec<[f64; 2]>,
    },
    /// The area between two lines.
    Band {
        /// The name.
        name: String,
        /// The colour.
        hue: Hue,
        /// The boundaries: x, low, high.
        points: Vec<[f64; 3]>,
    },
    /// Horizontal bars, for an axis that shows names.
    Bars {
        /// The name.
        name: String,
        /// The colour.
        hue: Hue,
        /// The bars.
        bars: Vec<HorizontalBar>,
    },
    /// Contour lines with coloured regions between them.
    Contours(Field),
    /// A point with a label.
    Mark {
        /// The label.
        name: String,
        /// The colour.
        hue: Hue,
        /// The coordinates.
        at: [f64; 2],
    },
    /// A label without a symbol.
    Text {
        /// The label.
        name: String,
        /// The colour.
        hue: Hue,
        /// The coordinates of the label's middle.
        at: [f64; 2],
    },
    /// Arrows. With a name, arrows that a label would cover are omitted. Without a name, every
    /// arrow is drawn.
    Arrows {
        /// The name of the field; may be empty.
        name: String,
        /// The colour.
        hue: Hue,
        /// The start and the end of each arrow.
        arrows: Vec<[[f64; 2]; 2]>,
    },
    /// A region of the plane.
    Region {
        /// The name.
        name: String,
        /// The colour.
        hue: Hue,
        /// True for a forbidden region, which is hatched; other regions are tinted and outlined.
        is_hatched: bool,
        /// The outlines. If an area has holes, its outline also contains their rings, joined by
        /// straight lines.
        rings: Vec<Vec<[f64; 2]>>,
    },
}

impl Layer {
    /// A line.
    pub fn line(name: impl Into<String>, hue: usize, points: Vec<[f64; 2]>) -> Self {
        Self::Line {
            name: name.into(),
            hue: Hue::Series(hue),
            is_dashed: false,
            points,
        }
    }

    /// Points.
    pub fn dots(name: impl Into<String>, hue: usize, points: Vec<[f64; 2]>) -> Self {
        Self::Dots {
            name: name.into(),
            hue: Hue::Series(hue),
            points,
        }
    }

    /// The points of the layer. Contours have two opposite corners of the field instead.
    pub(in crate::report) fn points(&self) -> Vec<[f64; 2]> {
        match self {
            Self::Line { points, .. } | Self::Dots { points, .. } => points.clone(),
            Self::Band { points, .. } => points
                .iter()
                .flat_map(|[x, low, high]| [[*x, *low], [*x, *high]])
                .collect(),
            Self::Bars { bars, .. } => bars
                .iter()
                .flat_map(|bar| [0.0, bar.to].map(|x| [x, bar.row as f64]))
                .collect(),
            Self::Contours(field) => vec![[field.x[0], field.y[0]], [field.x[1], field.y[1]]],
            Self::Mark { at, .. } | Self::Text { at, .. } => vec![*at],
            Self::Region { rings, .. } => rings.concat(),
            Self::Arrows { arrows, .. } => arrows.iter().flatten().copied().collect(),
        }
    }

    /// The name and the colour; `None` for contours, which have no single colour.
    pub fn named(&self) -> (&str, Option<Hue>) {
        match self {
            Self::Line { name, hue, .. }
            | Self::Dots { name, hue, .. }
            | Self::Band { name, hue, .. }
            | Self::Bars { name, hue, .. }
            | Self::Mark { name, hue, .. }
            | Self::Text { name, hue, .. }
            | Self::Arrows { name, hue, .. }
            | Self::Region { name, hue, .. } => (name, Some(*hue)),
            Self::Contours(field) => (&field.quantity.label, None),
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
