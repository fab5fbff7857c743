use super::scale::{Grows, to_scale, with_margin};
use super::style::field;
use crate::drive::Outcome;
use crate::parameters::Golfer;
use crate::report::plot::{Axis, Figure, Hue, Layer, NamedQuantity, Shape};
use crate::report::shown;
use crate::statistics::largest_magnitude;
use crate::study::Face;
use crate::units::{DisplayUnit, Quantity, System, significant};

/// Contour levels of the carry lost relative to the longest carry, in the displayed unit.
const RINGS: [f64; 3] = [1.0, 5.0, 10.0];

/// Length of the longest arrow, m on the face.
const LONGEST_ARROW: f64 = 0.013;

/// The coordinates of a point on the face, seen from the front: the toe of a right-handed club is
/// on the left.
pub(super) fn seen(face: &Face, [toe, high]: [f64; 2]) -> [f64; 2] {
    match face.golfer {
        Golfer::Right => [-toe, high],
        Golfer::Left => [toe, high],
    }
}

/// The axes of a face as seen from the front.
pub(super) fn axes(face: &Face) -> [Axis; 2] {
    let [left, right] = match face.golfer {
        Golfer::Right => ["toe", "heel"],
        Golfer::Left => ["heel", "toe"],
    };
    let origin = origin(face);
    let across = format!("← {left} · from {origin} · {right} →");
    [across, format!("above {origin}")]
        .map(|label| Axis::linear(NamedQuantity::new(label, Quantity::LENGTH, "mm")))
}

/// The name of the origin of the coordinates on the face.
fn origin(face: &Face) -> &'static str {
    if face.is_from_centre {
        "the centre of the face"
    } else {
        "the sweet spot"
    }
}

/// The name of the reference point on the face. Tilts are relative to a strike at this point;
/// slopes are the derivatives at this point.
pub(super) fn reference(face: &Face) -> &'static str {
    if face.sweet_spot.is_some() {
        "the sweet spot"
    } else {
        "the centre of the face"
    }
}

/// Marks of the sweet spot, and of the strike if it is elsewhere.
pub(super) fn marks(face: &Face, hue: Hue) -> impl Iterator<Item = Layer> {
    let mark = |name: &str, hue, at| Layer::new(name, hue, Shape::Mark(seen(face, at)));
    let spot = face.sweet_spot.map(|at| mark("sweet spot", Hue::Ink, at));
    spot.into_iter()
        .chain((!face.is_struck_sweetly()).then(|| mark("strike", hue, face.strike)))
}

/// Arrows for the tilts of the spin axis, relative to a strike at the point that [`reference()`]
/// names. A tilt of size `largest` has the length `LONGEST_ARROW`. The face is seen from the front,
/// so a tilt to the right points to the left.
pub(super) fn tilt_arrows(face: &Face, name: String, largest: f64) -> Layer {
    let arrow = |(at, tilt): &([f64; 2], f64)| {
        let [x, y] = seen(face, *at);
        [[x, y], [x - LONGEST_ARROW * tilt / largest, y]]
    };
    Layer::new(
        name,
        Hue::Faint,
        Shape::Arrows(face.tilts.iter().map(arrow).collect()),
    )
}

/// The face of a club from the front, at true scale: the strike, the sweet spot, the strike of the
/// longest carry, contours of the carry lost relative to the longest carry, and the tilt of the
/// spin axis.
pub fn face_figure(face: &Face, system: System) -> Figure {
    let [wide, tall] = face.half;
    // margin for the labels above and below the face
    let ranges = [
        with_margin([-wide, wide], 0.04, 0.04),
        with_margin([-tall, tall], 0.3, 0.3),
    ];
    let [x, y] = axes(face);
    let mut figure = to_scale(
        Figure::new(
            system,
            "face",
            "Carry lost by where the face is struck",
            x,
            y,
        ),
        ranges,
        [0.3, 1.2],
        [Grows::Evenly; 2],
    );
    figure.layers.push(outline(face));
    figure.layers.extend(rings(face, system));
    let largest = largest_magnitude(face.tilts.iter().map(|(_, tilt)| tilt));
    if largest > 0.0 {
        let name = format!(
            "spin axis tilt, longest {}",
            Quantity::ANGLE.read_off(largest, "deg")
        );
        figure.layers.push(tilt_arrows(face, name, largest));
    }
    let longest = if face.is_longest_at_edge() {
        "longest carry, at the edge"
    } else {
        "longest carry"
    };
    figure.layers.push(Layer::new(
        longest,
        Hue::Series(1),
        Shape::Mark(seen(face, face.longest.0)),
    ));
    figure.layers.extend(marks(face, Hue::Series(0)));
    figure.noted(note(face, largest, system))
}

/// The outline of the face.
pub(super) fn outline(face: &Face) -> Layer {
    let points = face.outline().into_iter();
    Layer::new(
        "",
        Hue::Faint,
        Shape::line(points.map(|at| seen(face, at)).collect()),
    )
}

/// Contours of the carry lost relative to the longest carry. A part outside of the face is not
/// drawn.
fn rings(face: &Face, system: System) -> Vec<Layer> {
    let (_, most) = face.longest;
    let carries = field(&face.plane, 0, Outcome::Carry);
    let unit = system.unit("yd");
    let size = DisplayUnit::from(Outcome::Carry).size_in(system);
    let on_face = |at: [f64; 2]| match face.holds(at) {
        true => seen(face, at),
        false => [f64::NAN; 2],
    };
    let ring = |(i, lost): (usize, f64)| {
        let points = carries.line_at(most - lost * size).into_iter().map(on_face);
        let name = format!("−{} {unit}", significant(lost, 3));
        Layer::line(name, 2 + i, points.collect())
    };
    let is_on_face = |ring: &Layer| ring.points().iter().any(|[x, _]| x.is_finite());
    let rings = RINGS.into_iter().enumerate().map(ring);
    rings.filter(is_on_face).collect()
}

fn note(face: &Face, largest: f64, system: System) -> String {
    let carry = |value: f64| shown::outcome(Outcome::Carry, value, system);
    let place = |[toe, high]: [f64; 2]| {
        let mm = |value: f64| format!("{:.1} mm", 1e3 * value.abs());
        let side = if toe < 0.0 {
            "towards the heel"
        } else {
            "towards the toe"
        };
        let level = if high < 0.0 { "below" } else { "above" };
        format!(
            "{} {side} and {} {level} {}",
            mm(toe),
            mm(high),
            origin(face)
        )
    };
    let own = face.carry.map_or("does not fly".into(), |own| {
        format!("carries {}", carry(own))
    });
    let (longest, most) = face.longest;
    let edge = if face.is_longest_at_edge() {
        ", at the edge of the searched face"
    } else {
        ""
    };
    let struck = match face.is_struck_sweetly() {
        true => "at the sweet spot".into(),
        false if face.strike == [0.0, 0.0] => "at the centre of the face".into(),
        false => place(face.strike),
    };
    let spot = match face.sweet_spot {
        Some(at) if face.is_from_centre => format!(", {}", place(at)),
        Some(_) => String::new(),
        None => ": this face is too curved to have a sweet spot".into(),
    };
    format!(
        "The strike is {struck} and {own}. The longest carry, {}, is from a strike {}{edge}. \
         Rings: carry lost against the longest carry. The sweet spot is where the line from the \
         centre of mass meets the face at a right angle{spot}. Longest arrow: the spin axis tilts \
         {} further than for a strike at {}. Seen from the front, so that right of the target line \
         is on the left. {}. The outline is that of a usual driver, for scale only.",
        carry(most),
        place(longest),
        Quantity::ANGLE.read_off(largest, "deg"),
        reference(face),
        shown::capital(shown::GEAR_EFFECT),
    )
}
