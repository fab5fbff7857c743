//! Pictures in which a length is as long upwards as across.

use crate::report::plot::{Axis, Figure};

/// How a range grows to the shape of a picture.
#[derive(Clone, Copy)]
pub(super) enum Grows {
    /// To both sides.
    Evenly,
    /// At its high end.
    Up,
}

/// The extent of some points along an axis.
pub(super) fn extent(points: impl Iterator<Item = f64>) -> [f64; 2] {
    points.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| {
        [low.min(at), high.max(at)]
    })
}

/// A range that is larger by parts of its own size.
pub(super) fn with_margin([low, high]: [f64; 2], below: f64, above: f64) -> [f64; 2] {
    let size = high - low;
    [low - below * size, high + above * size]
}

/// A figure whose axes end at these ranges, of which one grows until the picture is no flatter and
/// no taller than stated, height over width.
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
