use super::scale::{Grows, to_scale, with_margin};
use super::style::{clear_names, style};
use crate::drive::Outcome;
use crate::report::drive::total_uncertainty;
use crate::report::plot::{Axis, Figure, Hue, Layer, NamedQuantity, Shape, nice_step};
use crate::report::shown::{self, capital};
use crate::statistics::extent;
use crate::study::Landing;
use crate::study::uncertainty::LandingEllipse;
use crate::units::{DisplayUnit, Quantity, System, significant, with_unit};

/// Limits of the aspect ratio (height over width) of the first view, which shows only the landings.
const SHAPE: [f64; 2] = [0.8, 1.25];
/// Limits of the aspect ratio (height over width) of the view from the tee.
const FROM_TEE: [f64; 2] = [0.8, 1.1];

/// Width of the drawn fairway, m: 30 yards. The fairway is for scale only.
const FAIRWAY: f64 = 27.432;

/// Number of segments of an ellipse.
const AROUND: u32 = 120;
/// Number of segments of an arc.
const ALONG: u32 = 90;

/// Approximate number of arcs.
const ARCS: f64 = 6.0;

/// The colour of the edges of the fairway.
const EDGES: Hue = Hue::Series(2);

/// Distance of an arc's label from the target line, relative to the half-width of the picture.
const LABELLED: f64 = 0.85;

/// The landings of drives from above at true scale, with the target at the top, the edges of a
/// fairway, and arcs of equal distance from the tee. For each drive the view has the landing, the
/// point where the ball comes to rest, and two ellipses. The ellipses contain 50 % and 95 % of the
/// landings if the golfer's inputs vary. A second view begins at the tee.
pub fn fairway_figure(landings: &[Landing], system: System) -> Figure {
    let layers: Vec<Layer> = landings
        .iter()
        .enumerate()
        .flat_map(|(i, landing)| layers_of(landing, i, system))
        .collect();
    let [x, y] = extents(&layers);
    let near = view(
        system,
        "fairway",
        "Landings from above",
        [x, y],
        SHAPE,
        Grows::Evenly,
    );
    let mut figure = drawn(near, &layers);
    let whole = [x, with_margin([0.0, y[1]], 0.04, 0.0)];
    let from_tee = view(
        system,
        "fairway-tee",
        "From the tee",
        whole,
        FROM_TEE,
        Grows::Up,
    );
    let mut from_tee = drawn(from_tee, &layers);
    clear_names(&mut from_tee.layers);
    from_tee
        .layers
        .push(Layer::new("tee", Hue::Ink, Shape::Mark([0.0, 0.0])));
    figure.panels.push(from_tee);
    figure.columns = 2;

    let mut notes: Vec<String> = landings
        .iter()
        .map(|landing| note_of(landing, system))
        .collect();
    notes.extend(ellipses_note(landings, system));
    for landing in landings.iter().filter(|landing| landing.is_too_wide) {
        notes.push(format!(
            "{}: no ellipses are drawn, because the standard deviations of its inputs are too \
             large: more than 2 % of the drives would have a value outside of its allowed range \
             or would not land.",
            capital(landing.role.name())
        ));
    }
    if landings.iter().any(|landing| landing.rest.is_some()) {
        notes.push(format!(
            "The total, where the ball comes to rest, is known within {} at best.",
            total_uncertainty().in_units(system)
        ));
    }
    let unit = system.unit("yd");
    let width = FAIRWAY / DisplayUnit::from(Outcome::Carry).size_in(system);
    notes.push(format!(
        "True scale. Arcs: distance from the tee, which is at 0. The fairway is {} wide, for scale \
         only.",
        with_unit(&significant(width, 3), unit)
    ));
    figure.noted(notes.join(" "))
}

/// Ranges of the coordinates of `layers`, with margins: right of the target line, and downrange.
/// The first range is symmetric and at least as wide as the fairway.
fn extents(layers: &[Layer]) -> [[f64; 2]; 2] {
    let points = || layers.iter().flat_map(Layer::points);
    let widest = points().map(|[x, _]| x.abs()).fold(0.5 * FAIRWAY, f64::max);
    // widens a range of at most 1 m, such as that of a single point
    let around = |[low, high]: [f64; 2]| {
        if high - low > 1.0 {
            [low, high]
        } else {
            [low - 5.0, high + 5.0]
        }
    };
    [
        with_margin([-widest, widest], 0.1, 0.1),
        with_margin(around(extent(points().map(|[_, y]| y))), 0.08, 0.08),
    ]
}

/// A figure at true scale whose axes contain these ranges. It has no layers.
fn view(
    system: System,
    name: &str,
    title: &str,
    ranges: [[f64; 2]; 2],
    shape: [f64; 2],
    y_grows: Grows,
) -> Figure {
    let downrange = Axis::linear(NamedQuantity::new("downrange", Quantity::LENGTH, "yd"));
    let figure = Figure::new(system, name, title, Axis::left_right(), downrange);
    to_scale(figure, ranges, shape, [Grows::Evenly, y_grows])
}

/// Adds the arcs, the fairway, the target line and `layers` to a view.
fn drawn(mut figure: Figure, layers: &[Layer]) -> Figure {
    let [x, y] = [&figure.x, &figure.y].map(|axis| axis.range.unwrap_or_default());
    let along = |x: f64| vec![[x, y[0].max(0.0)], [x, y[1]]];
    let line = |name: &str, hue: Hue, is_dashed: bool, points: Vec<[f64; 2]>| {
        Layer::new(name, hue, Shape::Line { is_dashed, points })
    };
    figure.layers.extend(arcs([x, y], figure.system));
    figure.layers.extend([
        line("fairway", EDGES, false, along(-0.5 * FAIRWAY)),
        line("", EDGES, false, along(0.5 * FAIRWAY)),
        line("target line", Hue::Faint, true, along(0.0)),
    ]);
    figure.layers.extend_from_slice(layers);
    figure
}

/// Labelled arcs around the tee at round distances.
fn arcs([x, y]: [[f64; 2]; 2], system: System) -> Vec<Layer> {
    let unit = system.unit("yd");
    let size = DisplayUnit::from(Outcome::Carry).size_in(system);
    let step = nice_step((y[1] - y[0]) / ARCS / size) * size;
    let first = (y[0].max(0.0) / step).floor() as u32 + 1;
    let mut layers = vec![];
    for radius in (first..).map(|i| f64::from(i) * step) {
        // stop at the first arc whose top is above the picture
        if radius > y[1] {
            break;
        }
        let end = (x[1] / radius).min(1.0).asin();
        let at = |angle: f64| [radius * angle.sin(), radius * angle.cos()];
        let along = |step: u32| at(end * (2.0 * f64::from(step) / f64::from(ALONG) - 1.0));
        layers.push(Layer::new(
            "",
            Hue::Faint,
            Shape::line((0..=ALONG).map(along).collect()),
        ));
        let at = at((LABELLED * x[1] / radius).min(LABELLED).asin());
        if at[1] > y[0] {
            let name = with_unit(&significant(radius / size, 4), unit);
            layers.push(Layer::new(name, Hue::Faint, Shape::Text(at)));
        }
    }
    layers
}

/// The ellipses, the roll-out and the marks of a drive. The legend names each drive once, at its
/// largest ellipse, or else at its landing.
fn layers_of(landing: &Landing, i: usize, system: System) -> Vec<Layer> {
    let (hue, is_dashed) = style(landing.role);
    let carry = shown::outcome(Outcome::Carry, landing.at[1], system);
    let name = format!("{}: carry {carry}", landing.role.name());
    let mut layers = vec![];
    for (k, ellipse) in landing.ellipses.iter().rev().enumerate() {
        let points = outline(ellipse);
        let line = Layer::new(&name, hue, Shape::Line { is_dashed, points });
        layers.push(if k == 0 {
            line
        } else {
            line.remarked(format!("{:.0} %", 100.0 * ellipse.share))
        });
    }
    if landing.ellipses.is_empty() {
        layers.push(Layer::new(&name, hue, Shape::Dots(vec![landing.at])));
    }
    if let Some(rest) = landing.rest {
        // with dashes, another roll-out on the same line stays visible
        let points = vec![landing.at, rest];
        let run = Layer::new("run", hue, Shape::Line { is_dashed, points });
        layers.push(if i == 0 {
            run
        } else {
            run.remarked(landing.role.name())
        });
        layers.push(Layer::new(
            format!("total {}", shown::outcome(Outcome::Total, rest[1], system)),
            hue,
            Shape::Mark(rest),
        ));
    }
    layers.push(Layer::new("", hue, Shape::Mark(landing.at)));
    layers
}

fn outline(ellipse: &LandingEllipse) -> Vec<[f64; 2]> {
    let [long, short] = ellipse.half_axes;
    let centre = [ellipse.centre.lateral, ellipse.centre.carry];
    let point = |step: u32| {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(step) / f64::from(AROUND)).sin_cos();
        [0, 1].map(|axis| centre[axis] + cos * long[axis] + sin * short[axis])
    };
    (0..=AROUND).map(point).collect()
}

fn note_of(landing: &Landing, system: System) -> String {
    let [lateral, carry] = landing.at;
    let total = landing.rest.map_or(String::new(), |rest| {
        let total = shown::outcome(Outcome::Total, rest[1], system);
        format!(", total {total}")
    });
    format!(
        "{}: carry {}, {}{total}.",
        capital(landing.role.name()),
        shown::outcome(Outcome::Carry, carry, system),
        beside_target(lateral, system)
    )
}

/// The side of the target line: "3.2 yd right of the target line", "on the target line".
fn beside_target(lateral: f64, system: System) -> String {
    let shown = shown::outcome(Outcome::Lateral, lateral, system);
    let beside = [(" R", "right"), (" L", "left")]
        .into_iter()
        .find_map(|(sign, side)| Some((shown.strip_suffix(sign)?, side)));
    beside.map_or("on the target line".into(), |(size, side)| {
        format!("{size} {side} of the target line")
    })
}

/// The note about the ellipses. `None` if no drive has ellipses because the scatter of a drive is
/// too wide, which has a note of its own.
fn ellipses_note(landings: &[Landing], system: System) -> Option<String> {
    let Some(landing) = landings.iter().find(|landing| !landing.ellipses.is_empty()) else {
        let is_known = landings.iter().all(|landing| !landing.is_too_wide);
        return is_known
            .then(|| "No parameter of the golfer is uncertain, so there are no ellipses.".into());
    };
    let sigmas: Vec<String> = landing
        .sigmas
        .iter()
        .map(|sigma| shown::with_sigma(sigma, system))
        .collect();
    Some(format!(
        "The ellipses contain the landing with probabilities of 50 % and 95 %, for these standard \
         deviations: {}. Default deviations are measured or assumed uncertainties, not a golfer's \
         scatter. The shares are counted in {} drives with normally \
         distributed inputs; all other inputs are constant.",
        sigmas.join(", "),
        Landing::SAMPLED
    ))
}
