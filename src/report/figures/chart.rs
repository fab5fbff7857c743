use super::map::capital;
use crate::report::plot::{Axis, Figure, Hue, Layer, Measure};
use crate::report::shown;
use crate::study::{Chart, ChartPoint, Optimum, Vary};
use crate::units::System;

/// The optimum along a parameter, as small plots with a common horizontal axis.
#[derive(Clone, Debug)]
pub struct ChartFigures {
    /// A plot of the optimal value, and one of each varied parameter that changes.
    pub drawn: Vec<Figure>,
    /// The parameters that are at the same bound in every optimum, each with a sentence instead of
    /// a plot.
    pub held: Vec<(Vary, String)>,
}

/// The optimum along a parameter: plots of its value, and of each varied parameter with the bounds
/// of its range. `own` is the optimum of the drive as set up; the plots mark it. Texts are in the
/// units of `system`.
pub fn chart_figures(chart: &Chart, own: Option<&Optimum>, system: System) -> ChartFigures {
    let mut found = ChartFigures {
        drawn: vec![],
        held: vec![],
    };
    let Some(first) = chart.points.first() else {
        return found;
    };
    let search = &first.best.search;
    let along = Measure::parameter(chart.along.parameter);
    let tag = chart.along.parameter.name.replace('.', "-");
    let x = || Axis::linear(along.clone());
    let of = Measure::outcome(search.outcome());
    let own = own.and_then(|best| Some((best.setup.value(chart.along.parameter)?, best)));
    let own = own.filter(|(at, _)| (chart.along.low..=chart.along.high).contains(at));
    let yours = |y: Option<f64>, told: &dyn Fn(f64) -> String| {
        let (at, y) = own.map(|(at, _)| at).zip(y)?;
        let name = format!(
            "{}: {}",
            shown::stated(chart.along.parameter, at, system),
            told(y)
        );
        Some(Layer::Mark {
            name,
            hue: Hue::SET_UP,
            at: [at, y],
        })
    };
    let line = |points: Vec<[f64; 2]>| Layer::Line {
        name: "optimum".into(),
        hue: Hue::OPTIMUM,
        is_dashed: true,
        points,
    };
    let value = chart
        .points
        .iter()
        .filter_map(|point| Some([point.at, point.best.value()?]))
        .collect();
    let name = format!("chart-{}-by-{tag}", search.outcome().name());
    let title = format!("Best {} against {}", of.label, along.label);
    let mut best = Figure::new(name, title, x(), Axis::linear(of)).with(line(value));
    let own_value = own.and_then(|(_, best)| best.value());
    best.layers.extend(yours(own_value, &|value| {
        shown::outcome(search.outcome(), value, system)
    }));
    best = marked(best, chart, system, |point| point.best.value());

    for (i, vary) in search.vary.iter().enumerate() {
        if let Some(end) = held(chart, i, vary) {
            let measure = Measure::parameter(vary.parameter);
            let at = shown::stated(
                vary.parameter,
                if end == "lower" { vary.low } else { vary.high },
                system,
            );
            let why = if vary.low == vary.high {
                "the only value it may have".into()
            } else {
                format!("its {end} bound")
            };
            found.held.push((
                *vary,
                format!(
                    "{}: {at}, {why}, in every optimum.",
                    capital(&measure.label)
                ),
            ));
            continue;
        }
        let measure = Measure::parameter(vary.parameter);
        let title = format!(
            "{} of the best drive against {}",
            capital(&measure.label),
            along.label
        );
        let name = format!("chart-{}-by-{tag}", vary.parameter.name.replace('.', "-"));
        let path = chart
            .points
            .iter()
            .map(|point| [point.at, point.best.solution.x[i]])
            .collect();
        let bound = |name: &str, at: f64| {
            let points = vec![[chart.along.low, at], [chart.along.high, at]];
            Layer::Line {
                name: name.into(),
                hue: Hue::Faint,
                is_dashed: true,
                points,
            }
        };
        let mut figure = Figure::new(name, title, x(), Axis::linear(measure))
            .with(bound("bounds", vary.low))
            .with(bound("", vary.high))
            .with(line(path));
        let told = |value: f64| shown::parameter(vary.parameter, value, system);
        figure.layers.extend(yours(
            own.and_then(|(_, best)| best.solution.x.get(i).copied()),
            &told,
        ));
        found
            .drawn
            .push(marked(figure, chart, system, move |point| {
                Some(point.best.solution.x[i])
            }));
    }
    let notes =
        std::iter::once(best.note.clone()).chain(found.held.iter().map(|(_, why)| why.clone()));
    best.note = notes
        .filter(|note| !note.is_empty())
        .collect::<Vec<_>>()
        .join(" ");
    found.drawn.insert(0, best);
    found
}

/// The bound at which a varied parameter is in every optimum, if there is one.
fn held(chart: &Chart, i: usize, vary: &Vary) -> Option<&'static str> {
    // tolerance for rounding errors
    let lies = |end: f64| {
        let rounding = 1e-12 * (vary.high - vary.low);
        chart
            .points
            .iter()
            .all(|point| (point.best.solution.x[i] - end).abs() <= rounding)
    };
    [("lower", vary.low), ("upper", vary.high)]
        .into_iter()
        .find(|(_, end)| lies(*end))
        .map(|(name, _)| name)
}

/// Marks the points where a bound or constraint becomes active or inactive; the note explains them.
fn marked(
    mut figure: Figure,
    chart: &Chart,
    system: System,
    y: impl Fn(&ChartPoint) -> Option<f64>,
) -> Figure {
    let mut notes = vec![];
    for point in &chart.points {
        if let (Some(event), Some(y)) = (&point.event, y(point)) {
            let number = format!("{}", notes.len() + 1);
            let at = Measure::parameter(chart.along.parameter).show(point.at, system);
            let event = event
                .words(|active| shown::active(active, &point.best.search, system, shown::words));
            notes.push(format!("{number}: at {at} {event}."));
            figure.layers.push(Layer::Mark {
                name: number,
                hue: Hue::Ink,
                at: [point.at, y],
            });
        }
    }
    notes.extend(
        chart
            .begun
            .iter()
            .chain(&chart.ended)
            .map(|why| why.in_units(system)),
    );
    figure.noted(notes.join(" "))
}
