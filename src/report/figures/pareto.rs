use super::map::capital;
use crate::report::pareto::role;
use crate::report::plot::{Axis, Figure, Hue, Layer, Measure};
use crate::report::shown;
use crate::study::Goal;
use crate::study::swings::{Pareto, ParetoPoint};
use crate::units::System;

/// Length of the tangent at the knee, relative to the width of the front.
const REACH: f64 = 0.2;

/// The Pareto front of two goals: the first goal over the second, with the ends, the knee, the
/// slope at the knee, and the design before the search. Texts are in the units of `system`.
pub fn pareto_figure(found: &Pareto, system: System) -> Figure {
    let [first, second] = found.search.goals.each_ref().map(|(goal, _)| goal);
    let measure =
        |goal: &Goal| Measure::new(shown::words(&goal.expression), goal.quantity, goal.unit);
    let (x, y) = (measure(second), measure(first));
    let place = |point: &ParetoPoint| [point.goals[1], point.goals[0]];
    let points: Vec<[f64; 2]> = found.points.iter().map(place).collect();
    let slope_of = |point: &ParetoPoint| {
        let slope = point.slope?;
        Some(shown::ratio(
            (first.quantity, first.unit),
            (second.quantity, second.unit),
            slope,
            system,
            3,
        ))
    };
    let title = format!("{} against {}", capital(&y.label), x.label);
    let mut figure = Figure::new("pareto", title, Axis::linear(x), Axis::linear(y));
    let knee = found.knee.and_then(|knee| found.points.get(knee));
    if let Some((knee, slope)) = knee.and_then(|knee| Some((knee, knee.slope?))) {
        let across =
            |end: fn(f64, f64) -> f64, from: f64| points.iter().map(|[x, _]| *x).fold(from, end);
        let reach = REACH * (across(f64::max, f64::NEG_INFINITY) - across(f64::min, f64::INFINITY));
        let [x, y] = place(knee);
        let line = [-reach, reach].map(|by| [x + by, y + slope * by]).to_vec();
        let name =
            slope_of(knee).map_or(String::new(), |slope| format!("slope at the knee: {slope}"));
        figure.layers.push(Layer::Line {
            name,
            hue: Hue::Faint,
            is_dashed: true,
            points: line,
        });
    }
    // the line is interrupted where no designs connect two points
    let gap = |point: &ParetoPoint| point.is_apart.then_some([f64::NAN; 2]);
    let line = found
        .points
        .iter()
        .flat_map(|point| gap(point).into_iter().chain([place(point)]))
        .collect();
    figure = figure
        .with(Layer::Line {
            name: "best compromises".into(),
            hue: Hue::OPTIMUM,
            is_dashed: true,
            points: line,
        })
        .with(Layer::Dots {
            name: String::new(),
            hue: Hue::OPTIMUM,
            points,
        });
    for (i, point) in found.points.iter().enumerate() {
        if let Some(name) = role(found, i).map(|role| shown::words(&role)) {
            figure.layers.push(Layer::Mark {
                name,
                hue: Hue::OPTIMUM,
                at: place(point),
            });
        }
    }
    if let Some([own, against]) = found.as_set_up {
        figure.layers.push(Layer::Mark {
            name: "as set up".into(),
            hue: Hue::SET_UP,
            at: [against, own],
        });
    }
    let beside = |i: usize, goal: &Goal| {
        let slope = found.points.get(i).and_then(slope_of)?;
        Some(format!(
            "{slope} beside the best {}",
            shown::words(&goal.expression)
        ))
    };
    let near_ends = match found.points.len() {
        all @ 4.. => [beside(1, first), beside(all - 2, second)],
        _ => [None, None],
    };
    let at_knee = knee
        .and_then(slope_of)
        .map(|slope| format!("{slope} at the knee"));
    let [begins, ends] = near_ends;
    let slopes: Vec<String> = [begins, at_knee, ends].into_iter().flatten().collect();
    let mut notes = vec![];
    if !slopes.is_empty() {
        let [first, second] = [first, second].map(|goal| shown::words(&goal.expression));
        let what = format!("Change of {first} for each unit of {second}");
        notes.push(format!("{what}, along the front: {}.", slopes.join(", ")));
    }
    notes.extend(found.no_knee().map(|why| format!("{}.", capital(&why))));
    notes.extend(found.ended.as_ref().map(|why| format!("{}.", capital(why))));
    figure.noted(notes.join(" "))
}
