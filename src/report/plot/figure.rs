use super::axis::{Axis, Measure};

/// A plot as data: what is drawn, not how. Pictures and tables are views of it. All numbers are SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// A name for files: "trajectory-side".
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
    /// Height over width of the frame of the axes; rows of an axis of names have a height of their
    /// own.
    pub aspect: f64,
    /// The layers, the lowest first.
    pub layers: Vec<Layer>,
    /// Names are written on the lines, in place of a legend.
    pub names_on_lines: bool,
    /// Other views, drawn after it. Those without contours are of the same data.
    pub panels: Vec<Figure>,
    /// Number of views in a row, if the picture is broad enough.
    pub columns: usize,
}

impl Figure {
    /// A plot without anything in it yet.
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
            names_on_lines: false,
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

/// The colour of a layer, the same in all plots of a report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hue {
    /// Text and axes.
    Ink,
    /// Background elements.
    Faint,
    /// A series, by number. Colours begin again after [`Hue::SERIES`], with one more bar across its
    /// lines and points each time.
    Series(usize),
}

impl Hue {
    /// The drive as set up, in every plot: no dashes.
    pub const SET_UP: Self = Self::Series(0);

    /// The optimum, in every plot: dashed.
    pub const OPTIMUM: Self = Self::Series(1);

    /// Number of colours for series.
    pub const SERIES: usize = 6;

    /// Number of short bars across its lines and points. They distinguish series of the same
    /// colour.
    pub fn bars(self) -> usize {
        match self {
            Self::Series(i) => i / Self::SERIES,
            Self::Ink | Self::Faint => 0,
        }
    }
}

/// A layer of a plot. A name that is not empty appears in the legend and in the table of the data.
#[derive(Clone, Debug, PartialEq)]
pub enum Layer {
    /// A line through points; it breaks where a coordinate is not finite.
    Line {
        /// Its name.
        name: String,
        /// Its colour.
        hue: Hue,
        /// The line is dashed.
        is_dashed: bool,
        /// Its points.
        points: Vec<[f64; 2]>,
    },
    /// Points.
    Dots {
        /// Their name.
        name: String,
        /// Their colour.
        hue: Hue,
        /// The coordinates.
        points: Vec<[f64; 2]>,
    },
    /// The area between two lines.
    Band {
        /// Its name.
        name: String,
        /// Its colour.
        hue: Hue,
        /// Its edges: x, low, high.
        points: Vec<[f64; 3]>,
    },
    /// Horizontal bars, for an axis of names.
    Bars {
        /// Their name.
        name: String,
        /// Their colour.
        hue: Hue,
        /// Each bar: the number of its name, from, to.
        bars: Vec<Bar>,
    },
    /// Lines of equal value with the ground between them coloured.
    Contours(Field),
    /// A place with a word beside it.
    Mark {
        /// The word.
        name: String,
        /// Its colour.
        hue: Hue,
        /// The coordinates.
        at: [f64; 2],
    },
    /// Arrows.
    Arrows {
        /// Their name.
        name: String,
        /// Their colour.
        hue: Hue,
        /// Each from where to where.
        arrows: Vec<[[f64; 2]; 2]>,
    },
    /// A part of the plane.
    Region {
        /// Its name.
        name: String,
        /// Its colour.
        hue: Hue,
        /// A forbidden region is hatched; others are tinted and outlined.
        is_hatched: bool,
        /// Its outlines; a hole is reached along a line without width.
        rings: Vec<Vec<[f64; 2]>>,
    },
    /// A rectangle.
    Frame {
        /// Its name.
        name: String,
        /// Its colour.
        hue: Hue,
        /// Its low corner.
        low: [f64; 2],
        /// Its high corner.
        high: [f64; 2],
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

    /// A dashed line.
    pub fn dashed(name: impl Into<String>, hue: usize, points: Vec<[f64; 2]>) -> Self {
        Self::Line {
            name: name.into(),
            hue: Hue::Series(hue),
            is_dashed: true,
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

    /// Its name, and its colour if it has one of its own.
    pub fn named(&self) -> (&str, Option<Hue>) {
        match self {
            Self::Line { name, hue, .. }
            | Self::Dots { name, hue, .. }
            | Self::Band { name, hue, .. }
            | Self::Bars { name, hue, .. }
            | Self::Mark { name, hue, .. }
            | Self::Arrows { name, hue, .. }
            | Self::Region { name, hue, .. }
            | Self::Frame { name, hue, .. } => (name, Some(*hue)),
            Self::Contours(field) => (&field.measure.label, None),
        }
    }
}

/// A horizontal bar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar {
    /// The number of its name on the axis.
    pub place: usize,
    /// The start.
    pub from: f64,
    /// The end.
    pub to: f64,
}

/// Values over a grid that spans both axes' ends evenly.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// The quantity.
    pub measure: Measure,
    /// First and last column.
    pub x: [f64; 2],
    /// First and last row.
    pub y: [f64; 2],
    /// Columns.
    pub columns: usize,
    /// Row by row from the lowest; `None` where there is no value.
    pub values: Vec<Option<f64>>,
    /// The meaning of a missing value: "no flight".
    pub nothing: &'static str,
    /// The values of other fields with which it has its levels and colours in common, SI.
    pub beside: Vec<f64>,
}

impl Field {
    /// Rows.
    pub fn rows(&self) -> usize {
        self.values.len().checked_div(self.columns).unwrap_or(0)
    }

    /// The place of a column and a row, counted from 0; parts of them lie between.
    pub fn place(&self, column: f64, row: f64) -> [f64; 2] {
        let along = |[low, high]: [f64; 2], part: f64, count: usize| {
            low + (high - low) * part / (count.max(2) - 1) as f64
        };
        [
            along(self.x, column, self.columns),
            along(self.y, row, self.rows()),
        ]
    }

    /// The value at a place, between its four nodes; `None` off the grid, and beside a node without
    /// value.
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
