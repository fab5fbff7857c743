use crate::report::plot::{Axis, Field, Figure, Hue, Layer, Measure};
use crate::study::{Constraint, Flatness, Map, Optimum, Slope, Vary};
use crate::units::System;

/// The longest arrow, as a part of the map's width.
const LONGEST_ARROW: f64 = 0.1;

/// A map with its gradients, the limits of outcomes as lines on it (each with a map of its outcome), and where the search of an
/// optimum varied both its parameters, the optimum with its window. The note is in the units of `system` first.
pub fn map_figure(
    map: &Map,
    limits: &[(Constraint, Map)],
    best: Option<&Optimum>,
    flatness: Option<&Flatness>,
    system: System,
) -> Figure {
    let Map { of, across, up, missing, slopes, .. } = map;
    let [x, y] = [across, up].map(|vary| Axis::linear(Measure::parameter(vary.parameter)).exactly(vary.low, vary.high));
    let measure = Measure::outcome(*of);
    let title = format!("{} over {} and {}", capital(&measure.label), x.measure.label, y.measure.label);
    let name = format!("map-{}", of.name());
    let field = field(map);
    let mut figure = Figure::new(name, title, x, y).with(Layer::Contours(field)).with(arrows(across, up, slopes));
    figure.aspect = 0.85;
    for (i, (constraint, map)) in limits.iter().enumerate() {
        let field = self::field(map);
        let mut ends: Vec<f64> = [constraint.low, constraint.high].into_iter().filter(|end| end.is_finite()).collect();
        ends.dedup();
        for (end, name) in ends.into_iter().zip([constraint.expression.as_str(), ""]) {
            figure.layers.push(Layer::dashed(name, 2 + i, field.line_at(end)));
        }
    }
    let mut notes =
        vec!["The edges are the bounds. The arrows are exact gradients, scaled by the ranges; their length grows with the square root of the slope.".to_owned()];
    if let Some(why) = missing {
        notes.push(format!("Grey: no value; the first reason: {}.", why.in_units(system)));
    }
    if let Some(best) = best
        && let Some([i, j]) = place(best, across, up)
    {
        let hue = Hue::OPTIMUM;
        let at = [best.solution.x[i], best.solution.x[j]];
        if let Some(flatness) = flatness {
            let (wide, tall) = (flatness.windows[i], flatness.windows[j]);
            let cross = [[[wide.low, at[1]], [wide.high, at[1]]], [[at[0], tall.low], [at[0], tall.high]]];
            for (ends, name) in cross.into_iter().zip(["window", ""]) {
                figure.layers.push(Layer::Line { name: name.into(), hue, is_dashed: false, points: ends.to_vec() });
            }
            let loss = Measure::outcome(best.search.of).show_difference(flatness.loss, system);
            notes.push(format!("The window shows how far each parameter may deviate alone for a loss of {loss}."));
            if let Some(ellipse) = ellipse(best, flatness, [i, j]) {
                figure.layers.push(ellipse);
                notes.push("The ellipse shows how far both may deviate together, by the quadratic model.".into());
            }
        }
        figure.layers.push(Layer::Mark { name: "optimum".into(), hue, at });
    }
    figure.noted(notes.join(" "))
}

/// A map as a field to draw.
fn field(map: &Map) -> Field {
    Field {
        measure: Measure::outcome(map.of),
        x: [map.across.low, map.across.high],
        y: [map.up.low, map.up.high],
        columns: map.columns,
        values: map.values.clone(),
        nothing: "no drive",
    }
}

/// Where in an optimum's search the parameters of a map stand; `None` where it did not vary both.
fn place(best: &Optimum, across: &Vary, up: &Vary) -> Option<[usize; 2]> {
    let at = |of: &Vary| best.search.vary.iter().position(|vary| vary.parameter == of.parameter);
    best.value()?;
    Some([at(across)?, at(up)?])
}

/// Gradients in units of the ranges, as the map shows them: steepest ascent on the page. Lengths go as the root of the slope:
/// in proportion to it, those near the top would be too short to show their direction.
fn arrows(across: &Vary, up: &Vary, slopes: &[Slope]) -> Layer {
    let width = [across, up].map(|vary| vary.high - vary.low);
    let scaled = |gradient: [f64; 2]| [gradient[0] * width[0], gradient[1] * width[1]];
    let size = |[x, y]: [f64; 2]| x.hypot(y);
    let longest = slopes.iter().map(|slope| size(scaled(slope.gradient))).fold(f64::MIN_POSITIVE, f64::max);
    let arrow = |slope: &Slope| {
        let scaled = scaled(slope.gradient);
        let steepness = size(scaled).max(f64::MIN_POSITIVE);
        let length = LONGEST_ARROW * (steepness / longest).sqrt();
        let [x, y] = scaled.map(|part| part / steepness * length);
        [slope.at, [slope.at[0] + x * width[0], slope.at[1] + y * width[1]]]
    };
    Layer::Arrows { name: "gradient".into(), hue: Hue::Ink, arrows: slopes.iter().map(arrow).collect() }
}

/// The ellipse of both parameters, where both are free.
fn ellipse(best: &Optimum, flatness: &Flatness, pair: [usize; 2]) -> Option<Layer> {
    let turned = [pair[1], pair[0]];
    let ellipse = flatness.ellipses.iter().find(|ellipse| ellipse.pair == pair || ellipse.pair == turned)?;
    let order = if ellipse.pair == pair { [0, 1] } else { [1, 0] };
    let point = |angle: f64| {
        let [long, short] = ellipse.half_axes;
        order.map(|k| best.solution.x[ellipse.pair[k]] + angle.cos() * long[k] + angle.sin() * short[k])
    };
    let around = (0..=120).map(|i| point(std::f64::consts::TAU * f64::from(i) / 120.0)).collect();
    Some(Layer::dashed("ellipse", 1, around))
}

/// A word that begins a line.
pub(in crate::report) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}
