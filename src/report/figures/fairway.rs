use super::capital;
use super::scale::{Grows, extent, to_scale, with_margin};
use super::style::style;
use crate::drive::Outcome;
use crate::report::plot::{Axis, Figure, Hue, Layer, Measure};
use crate::report::shown;
use crate::study::Landing;
use crate::study::uncertainty::LandingEllipse;
use crate::units::{Quantity, System, significant, with_unit};

/// Limits of the picture's aspect ratio, height over width.
const SHAPE: [f64; 2] = [0.8, 1.25];

/// Number of points of an ellipse.
const AROUND: u32 = 120;

/// The landings of drives from above at true scale, with the target at the top. Each landing has
/// the ellipses of 50 % and 95 % of the landings for the variation of the golfer's inputs, and the
/// point where the ball comes to rest.
pub fn fairway_figure(landings: &[Landing], system: System) -> Figure {
    let layers: Vec<Layer> = landings
        .iter()
        .enumerate()
        .flat_map(|(i, landing)| layers_of(landing, i, system))
        .collect();
    let mut figure = empty(&layers);
    let [low, high] = figure.y.reach.unwrap_or_default();
    figure.layers.push(Layer::Line {
        name: "target line".into(),
        hue: Hue::Faint,
        is_dashed: true,
        points: vec![[0.0, low], [0.0, high]],
    });
    figure.layers.extend(layers);

    let mut notes: Vec<String> = landings
        .iter()
        .map(|landing| note_of(landing, system))
        .collect();
    notes.extend(spread(landings, system));
    notes.extend(
        landings
            .iter()
            .filter(|landing| landing.is_too_wide)
            .map(too_wide),
    );
    if landings.iter().any(|landing| landing.rest.is_some()) {
        notes.push("Small points: where the ball comes to rest.".into());
    }
    notes.push("True scale; the tee is at 0.".into());
    figure.noted(notes.join(" "))
}

/// A figure at true scale without layers, whose axes contain these layers.
fn empty(layers: &[Layer]) -> Figure {
    let points = || {
        layers.iter().flat_map(|layer| match layer {
            Layer::Line { points, .. } | Layer::Dots { points, .. } => points.clone(),
            Layer::Mark { at, .. } => vec![*at],
            _ => vec![],
        })
    };
    let widest = points().map(|[x, _]| x.abs()).fold(0.0, f64::max);
    // a single point gets a margin too
    let around = |[low, high]: [f64; 2]| {
        if high - low > 1.0 {
            [low, high]
        } else {
            [low - 5.0, high + 5.0]
        }
    };
    let y = with_margin(around(extent(points().map(|[_, y]| y))), 0.08, 0.08);
    let x = with_margin(around([-widest, widest]), 0.1, 0.1);
    let length = |label: &str| Axis::linear(Measure::new(label, Quantity::LENGTH, "yd"));
    let figure = Figure::new(
        "fairway",
        "Landings from above",
        length("right of the target line (left: −)"),
        length("downrange"),
    );
    to_scale(figure, [x, y], SHAPE, [Grows::Evenly; 2])
}

/// The ellipses, the roll-out and the marks of a drive. The legend names each drive once, at its
/// largest ellipse, or else at its landing.
fn layers_of(landing: &Landing, i: usize, system: System) -> Vec<Layer> {
    let (hue, is_dashed) = style(&landing.name, i);
    let carry = shown::outcome(Outcome::Carry, landing.at[1], system);
    let name = format!("{}: carry {carry}", landing.name);
    let part = |of: &str| format!("{name} ({of})");
    let mut layers = vec![];
    for (k, ellipse) in landing.ellipses.iter().rev().enumerate() {
        layers.push(Layer::Line {
            name: if k == 0 {
                name.clone()
            } else {
                part(&format!("{:.0} %", 100.0 * ellipse.share))
            },
            hue,
            is_dashed,
            points: outline(ellipse),
        });
    }
    if landing.ellipses.is_empty() {
        layers.push(Layer::Dots {
            name: name.clone(),
            hue,
            points: vec![landing.at],
        });
    }
    if let Some(rest) = landing.rest {
        // only the first roll-out has a name in the legend
        layers.push(Layer::Line {
            name: if i == 0 {
                "run".into()
            } else {
                format!("run ({})", landing.name)
            },
            hue,
            is_dashed: false,
            points: vec![landing.at, rest],
        });
        layers.push(Layer::Dots {
            name: part("at rest"),
            hue,
            points: vec![rest],
        });
    }
    layers.push(Layer::Mark {
        name: String::new(),
        hue,
        at: landing.at,
    });
    layers
}

/// Points around an ellipse.
fn outline(ellipse: &LandingEllipse) -> Vec<[f64; 2]> {
    let [long, short] = ellipse.half_axes;
    let point = |step: u32| {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(step) / f64::from(AROUND)).sin_cos();
        [0, 1].map(|axis| ellipse.centre[axis] + cos * long[axis] + sin * short[axis])
    };
    (0..=AROUND).map(point).collect()
}

/// A description of a drive's landing.
fn note_of(landing: &Landing, system: System) -> String {
    let [lateral, carry] = landing.at;
    let total = landing.rest.map_or(String::new(), |rest| {
        let total = shown::outcome(Outcome::Total, rest[1], system);
        format!(", total {total}")
    });
    format!(
        "{}: carry {}, {}{total}.",
        capital(&landing.name),
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

/// The note about the ellipses.
fn spread(landings: &[Landing], system: System) -> Option<String> {
    let Some(landing) = landings.iter().find(|landing| !landing.ellipses.is_empty()) else {
        let is_known = landings.iter().all(|landing| !landing.is_too_wide);
        return is_known
            .then(|| "No parameter of the golfer is uncertain, so there are no ellipses.".into());
    };
    let sigma = |sigma: &crate::study::Sigma| {
        let measure = Measure::parameter(sigma.parameter);
        let unit = system.unit(measure.unit);
        let amount = significant(sigma.value / measure.unit_size(system), 3);
        format!("{} ± {}", measure.label, with_unit(&amount, unit))
    };
    let sigmas: Vec<String> = landing.sigmas.iter().map(sigma).collect();
    Some(format!(
        "The inner and the outer ellipse hold 50 % and 95 % of the landings when these vary from \
         drive to drive, one standard deviation each: {}; by exact \
         derivatives. Everything else is the same in all.",
        sigmas.join(", ")
    ))
}

/// The reason why a drive has no ellipses although its inputs vary.
fn too_wide(landing: &Landing) -> String {
    format!(
        "{}: no ellipses are drawn: the standard deviation of the speed is more than a third of \
         the speed, or an ellipse is larger than the carry, too much for derivatives to predict \
         the landings.",
        capital(&landing.name)
    )
}
