use super::constants::subtitle;
use crate::parameters::{Preset, Setup};
use crate::report::pareto::role;
use crate::report::plot::{Axis, Figure, Hue, Layer, NamedQuantity, Shape};
use crate::report::shown::{self, capital};
use crate::statistics::extent;
use crate::study::NamedDrive;
use crate::study::swings::{Pareto, ParetoPoint};
use crate::units::System;

/// Half the width of the tangent at the knee, divided by the width of the front.
const HALF_WIDTH: f64 = 0.2;

/// The Pareto front of two goals: the first goal on the vertical axis, the second on the horizontal
/// axis. The plot shows the ends of the front, the knee, the slope at the knee, and the design
/// before the search, which starts from `setup` and its preset. Texts are in the units of `system`.
pub fn pareto_figure(
    found: &Pareto,
    setup: &Setup<f64>,
    preset: &Preset,
    system: System,
) -> Figure {
    let [y, x] = found
        .search
        .goals
        .each_ref()
        .map(|(goal, _)| NamedQuantity {
            label: shown::words(&goal.expression),
            of: goal.into(),
        });
    let title = format!("{} against {}", capital(&y.label), x.label);
    let mut figure = Figure::new(system, "pareto", title, Axis::linear(x), Axis::linear(y));
    let search = &found.search;
    let varies = |name: &str| {
        let of_design = search.vary.iter().map(|vary| vary.parameter);
        let mut all = of_design.chain(search.scenarios.parameters.iter().copied());
        all.any(|parameter| parameter.name == name)
    };
    figure.subtitle = subtitle(setup, preset, varies, None, system)
        + &shown::with_constraints(&search.subject_to, system);
    figure.layers.extend(tangent(found, system));
    // the line is interrupted where the front is disconnected
    let gap = |point: &ParetoPoint| point.is_after_gap.then_some([f64::NAN; 2]);
    let line = found
        .points
        .iter()
        .flat_map(|point| gap(point).into_iter().chain([place(point)]))
        .collect();
    figure = figure
        .with(Layer::new(
            "best compromises",
            Hue::OPTIMUM,
            Shape::dashed(line),
        ))
        .with(Layer::new(
            "",
            Hue::OPTIMUM,
            Shape::Dots(found.points.iter().map(place).collect()),
        ));
    for (i, point) in found.points.iter().enumerate() {
        if let Some(name) = role(found, i).map(|role| shown::words(&role)) {
            figure
                .layers
                .push(Layer::new(name, Hue::OPTIMUM, Shape::Mark(place(point))));
        }
    }
    if let Some([own, against]) = found.as_set_up {
        figure.layers.push(Layer::new(
            NamedDrive::AS_SET_UP,
            Hue::SET_UP,
            Shape::Mark([against, own]),
        ));
    }
    figure.noted(note(found, system))
}

/// The coordinates of a point: the second goal, then the first.
fn place(point: &ParetoPoint) -> [f64; 2] {
    [point.goals[1], point.goals[0]]
}

fn knee(found: &Pareto) -> Option<&ParetoPoint> {
    found.points.get(found.knee?)
}

/// The slope of the front at a point, with its unit.
fn slope(found: &Pareto, point: &ParetoPoint, system: System) -> Option<String> {
    let [(first, _), (second, _)] = &found.search.goals;
    Some(shown::ratio(first, second, point.slope?, system, 3))
}

fn tangent(found: &Pareto, system: System) -> Option<Layer> {
    let knee = knee(found)?;
    let steepness = knee.slope?;
    let slope = slope(found, knee, system)?;
    let [left, right] = extent(found.points.iter().map(|point| place(point)[0]));
    let width = right - left;
    let [x, y] = place(knee);
    let end = |by: f64| [x + by, y + steepness * by];
    Some(Layer::new(
        format!("slope at the knee: {slope}"),
        Hue::Faint,
        Shape::dashed(vec![end(-HALF_WIDTH * width), end(HALF_WIDTH * width)]),
    ))
}

/// The note about the slopes next to the ends and at the knee. It also has the reason if there is
/// no knee, and the reason if the front is not complete.
fn note(found: &Pareto, system: System) -> String {
    let [first, second] = found
        .search
        .goals
        .each_ref()
        .map(|(goal, _)| shown::words(&goal.expression));
    let beside = |i: usize, goal: &str| {
        let slope = slope(found, found.points.get(i)?, system)?;
        Some(format!("{slope} beside the best {goal}"))
    };
    let [begins, ends] = match found.points.len() {
        all @ 4.. => [beside(1, &first), beside(all - 2, &second)],
        _ => [None, None],
    };
    let at_knee = knee(found).and_then(|knee| slope(found, knee, system));
    let at_knee = at_knee.map(|slope| format!("{slope} at the knee"));
    let slopes: Vec<String> = [begins, at_knee, ends].into_iter().flatten().collect();
    let mut notes = vec![];
    if !slopes.is_empty() {
        let slopes = slopes.join(", ");
        notes.push(format!(
            "Change of {first} for each unit of {second}, along the front: {slopes}."
        ));
    }
    notes.extend(found.no_knee().map(|why| format!("{}.", capital(&why))));
    notes.extend(found.ended.as_ref().map(|why| format!("{}.", capital(why))));
    notes.join(" ")
}
