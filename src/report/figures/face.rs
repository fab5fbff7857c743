use super::scale::{Grows, to_scale, with_margin};
use super::style::field;
use crate::drive::Outcome;
use crate::report::plot::{Axis, Figure, Hue, Layer, Measure};
use crate::report::shown;
use crate::study::Face;
use crate::units::{Quantity, System, significant};

/// Rings of carry lost against the longest strike, in the unit of length shown.
const RINGS: [f64; 3] = [1.0, 5.0, 10.0];

/// The longest arrow, m on the face.
const LONGEST_ARROW: f64 = 0.013;

/// The face of a club from the front, at true scale: where the ball is struck, the sweet spot, the strike of the longest carry, rings of carry
/// lost against it, and the side to which the axis of the spin tilts.
pub fn face_figure(face: &Face, system: System) -> Figure {
    let length = |label: &str| Axis::linear(Measure::new(label, Quantity::LENGTH, "mm"));
    // from the front the toe of a club for the right hand is on the left
    let seen = |[toe, high]: [f64; 2]| [-toe, high];
    let (x, y) = (length("← toe · from the sweet spot · heel →"), length("above the sweet spot"));
    let [wide, tall] = face.half;
    // room for the names above and below the face
    let ranges = [with_margin([-wide, wide], 0.04, 0.04), with_margin([-tall, tall], 0.3, 0.3)];
    let mut figure = to_scale(
        Figure::new("face", "Carry lost by where the face is struck", x, y),
        ranges,
        [0.3, 1.2],
        [Grows::Evenly; 2],
    );
    figure.names_on_lines = true;
    let outline = face.outline().into_iter().map(seen).collect();
    figure.layers.push(Layer::Line { name: String::new(), hue: Hue::Faint, is_dashed: false, points: outline });

    let (at, most) = face.longest;
    let carries = field(&face.plane, 0, Measure::outcome(Outcome::Carry));
    let unit = system.unit("yd");
    let size = Quantity::LENGTH.size_of(unit).unwrap_or(1.0);
    for ring in RINGS {
        let points = carries.line_at(most - ring * size);
        // what lies beside the face is no ring on it
        let points: Vec<_> =
            points.into_iter().map(|at| if face.holds(at) { seen(at) } else { [f64::NAN; 2] }).collect();
        if points.iter().any(|[x, _]| x.is_finite()) {
            let name = format!("−{} {unit}", significant(ring, 3));
            figure.layers.push(Layer::Line { name, hue: Hue::Series(2), is_dashed: false, points });
        }
    }
    let largest = face.tilts.iter().map(|(_, tilt)| tilt.abs()).fold(0.0, f64::max);
    if largest > 0.0 {
        // right of the target line is on the left of one who looks at the face
        let arrow = |(at, tilt): &([f64; 2], f64)| {
            let [x, y] = seen(*at);
            [[x, y], [x - LONGEST_ARROW * tilt / largest, y]]
        };
        let arrows = face.tilts.iter().map(arrow).collect();
        figure.layers.push(Layer::Arrows { name: "spin axis tilts to this side".into(), hue: Hue::Faint, arrows });
    }
    let longest = if face.is_longest_at_edge() { "longest carry, at the edge" } else { "longest carry" };
    figure.layers.push(Layer::Mark { name: "sweet spot".into(), hue: Hue::Ink, at: [0.0, 0.0] });
    figure.layers.push(Layer::Mark { name: longest.into(), hue: Hue::Series(1), at: seen(at) });
    if face.strike != [0.0, 0.0] {
        figure.layers.push(Layer::Mark { name: "strike".into(), hue: Hue::Series(0), at: seen(face.strike) });
    }
    figure.noted(note(face, largest, system))
}

fn note(face: &Face, largest: f64, system: System) -> String {
    let carry = |value: f64| shown::outcome(Outcome::Carry, value, system);
    let place = |[toe, high]: [f64; 2]| {
        let mm = |value: f64| format!("{:.1} mm", 1e3 * value.abs());
        let side = if toe < 0.0 { "towards the heel" } else { "towards the toe" };
        let level = if high < 0.0 { "below" } else { "above" };
        format!("{} {side} and {} {level} the sweet spot", mm(toe), mm(high))
    };
    let own = face.carry.map_or("does not fly".into(), |own| format!("carries {}", carry(own)));
    let (longest, most) = face.longest;
    let edge = if face.is_longest_at_edge() { ", at the edge of the searched face" } else { "" };
    let struck = if face.strike == [0.0, 0.0] { "at the sweet spot".into() } else { place(face.strike) };
    format!(
        "The strike is {struck} and {own}. The longest carry, {}, is from a strike {}{edge}. Rings: carry lost against it. The sweet spot is where the \
         line from the centre of mass meets the face at a right angle. Longest arrow: the spin axis tilts {} further than from the sweet spot. Seen \
         from the front, so that right of the target line is on the left. The outline is that of a usual driver, for scale only.",
        carry(most),
        place(longest),
        Quantity::ANGLE.read_off(largest, "deg"),
    )
}
