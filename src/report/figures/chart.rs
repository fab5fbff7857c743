use super::map::capital;
use crate::report::plot::{Axis, Figure, Hue, Layer, Measure};
use crate::study::{Chart, ChartPoint};
use crate::units::System;

/// The optimum along a parameter: a plot of its value, and one of each parameter varied with the bounds of its range. The notes
/// are in the units of `system` first.
pub fn chart_figures(chart: &Chart, system: System) -> Vec<Figure> {
    let Some(first) = chart.points.first() else { return vec![] };
    let search = &first.best.search;
    let along = Measure::parameter(chart.along.parameter);
    let tag = chart.along.parameter.name.replace('.', "-");
    let x = || Axis::linear(along.clone());
    let of = Measure::outcome(search.of);
    let title = format!("Best {} against {}", of.label, along.label);
    let line =
        |points: Vec<[f64; 2]>| Layer::Line { name: "optimum".into(), hue: Hue::OPTIMUM, is_dashed: true, points };
    let value = chart.points.iter().filter_map(|point| Some([point.at, point.best.value()?])).collect();
    let name = format!("chart-{}-by-{tag}", search.of.name());
    let best = Figure::new(name, title, x(), Axis::linear(of)).with(line(value));
    let best = marked(best, chart, system, |point| point.best.value());

    let varied = search.vary.iter().enumerate().map(|(i, vary)| {
        let measure = Measure::parameter(vary.parameter);
        let title = format!("{} of the best drive against {}", capital(&measure.label), along.label);
        let name = format!("chart-{}-by-{tag}", vary.parameter.name.replace('.', "-"));
        let path = chart.points.iter().map(|point| [point.at, point.best.solution.x[i]]).collect();
        let bound = |name: &str, at: f64| {
            let points = vec![[chart.along.low, at], [chart.along.high, at]];
            Layer::Line { name: name.into(), hue: Hue::Faint, is_dashed: true, points }
        };
        let figure = Figure::new(name, title, x(), Axis::linear(measure))
            .with(bound("bounds", vary.low))
            .with(bound("", vary.high))
            .with(line(path));
        marked(figure, chart, system, move |point| Some(point.best.solution.x[i]))
    });
    std::iter::once(best).chain(varied).collect()
}

/// Marks where a bound or constraint begins or ends to hold, and says what in the note.
fn marked(mut figure: Figure, chart: &Chart, system: System, y: impl Fn(&ChartPoint) -> Option<f64>) -> Figure {
    let mut notes = vec![];
    for point in &chart.points {
        if let (Some(event), Some(y)) = (&point.event, y(point)) {
            let number = format!("{}", notes.len() + 1);
            notes.push(format!(
                "{number}: at {} {event}.",
                Measure::parameter(chart.along.parameter).show_both(point.at, system)
            ));
            figure.layers.push(Layer::Mark { name: number, hue: Hue::Ink, at: [point.at, y] });
        }
    }
    notes.extend(chart.begun.iter().chain(&chart.ended).map(|why| why.in_units(system)));
    figure.noted(notes.join(" "))
}
