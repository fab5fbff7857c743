//! Pictures at true scale: one metre has the same length on both axes.

use crate::report::plot::{Axis, Figure};

/// The ends at which a range is extended to fit the aspect ratio of a picture.
#[derive(Clone, Copy)]
pub(super) enum Grows {
    /// Both ends, by equal lengths.
    Evenly,
    /// The high end.
    Up,
}

/// A range with margins; `below` and `above` are fractions of its width.
pub(super) fn with_margin([low, high]: [f64; 2], below: f64, above: f64) -> [f64; 2] {
    let size = high - low;
    [low - below * size, high + above * size]
}

/// A figure at true scale with these ranges. If the aspect ratio (height over width) is outside of
/// the limits, one of the ranges grows.
pub(super) fn to_scale(
    figure: Figure,
    [mut x, mut y]: [[f64; 2]; 2],
    [flattest, tallest]: [f64; 2],
    [x_grows, y_grows]: [Grows; 2],
) -> Figure {
    let size = |[low, high]: [f64; 2]| high - low;
    x = grown(x, size(y) / tallest, x_grows);
    y = grown(y, size(x) * flattest, y_grows);
    let axis = |axis: Axis, [low, high]: [f64; 2]| axis.exactly(low, high);
    Figure {
        aspect: size(y) / size(x),
        x: axis(figure.x, x),
        y: axis(figure.y, y),
        ..figure
    }
}

fn grown([low, high]: [f64; 2], size: f64, grows: Grows) -> [f64; 2] {
    let more = (size - (high - low)).max(0.0);
    match grows {
        Grows::Evenly => [low - 0.5 * more, high + 0.5 * more],
        Grows::Up => [low, high + more],
    }
}
