use super::constants::subtitle;
use crate::drive::Outcome;
use crate::parameters::{Preset, Setup};
use crate::report::plot::{Axis, Figure, Hue, Layer, NamedQuantity, Shape};
use crate::report::shown::{self, capital};
use crate::study::{BoundSide, Chart, ChartPoint, NamedDrive, Optimum, Vary};
use crate::units::System;

/// The optimum along a parameter, as small plots with a common horizontal axis.
#[derive(Clone, Debug)]
pub struct ChartFigures {
    /// A plot of the optimal value, and a plot of each varied parameter that changes.
    pub drawn: Vec<Figure>,
    /// The parameters that are at the same bound in every optimum. Each has a sentence instead of a
    /// plot.
    pub at_bound: Vec<(Vary, String)>,
}

/// The optimum along a parameter: a plot of the optimal value, and a plot of each varied parameter
/// that changes, with the bounds of its range. The plots mark `own`, the optimum at the parameter's
/// value in `setup`. The parameter and varied parameters may be unset in `setup`. The subtitle names
/// the differences between `setup` and `preset`. Texts are in the units of `system`.
pub fn chart_figures(
    chart: &Chart,
    setup: &Setup<f64>,
    preset: &Preset,
    own: Option<&Optimum>,
    system: System,
) -> ChartFigures {
    let mut found = ChartFigures {
        drawn: vec![],
        at_bound: vec![],
    };
    let Some(first) = chart.points.first() else {
        return found;
    };
    let search = &first.best.search;
    let along = chart.along;
    let varies = |name: &str| {
        let mut varied = search.parameters().chain([along.parameter]);
        varied.any(|parameter| parameter.name == name)
    };
    let marked = own.and_then(|best| Some((best.setup.value(along.parameter)?, best)));
    let marked = marked.filter(|(at, _)| (along.low..=along.high).contains(at));
    let drawing = ChartDrawing {
        chart,
        own: marked,
        other: marked.and_then(|(at, best)| other_optimum(chart, at, best, system)),
        system,
        along: NamedQuantity::parameter(along.parameter),
        subtitle: subtitle(setup, preset, varies, None, system)
            + &shown::with_constraints(&search.subject_to, system),
    };
    for (i, vary) in search.vary.iter().enumerate() {
        match common_bound(chart, own, i, vary) {
            Some(side) => found
                .at_bound
                .push((*vary, bound_sentence(vary, side, system))),
            None => found.drawn.push(drawing.parameter(i, vary)),
        }
    }
    let mut best = drawing.value(search.outcome());
    let notes = found.at_bound.iter().map(|(_, why)| why.as_str());
    let notes = std::iter::once(best.note.as_str()).chain(notes);
    let notes: Vec<&str> = notes.filter(|note| !note.is_empty()).collect();
    best.note = notes.join(" ");
    found.drawn.insert(0, best);
    found
}

/// A chart with the data that all its plots share.
struct ChartDrawing<'a> {
    chart: &'a Chart,
    /// The setup's value of the chart's parameter, with the optimum at this value. `None` if the
    /// chart does not contain the value, or if there is no optimum.
    own: Option<(f64, &'a Optimum)>,
    /// The sentence about `own`, if the chart follows another optimum at the setup's value.
    other: Option<String>,
    system: System,
    along: NamedQuantity,
    /// The constant parameters, and the constraints.
    subtitle: String,
}

impl ChartDrawing<'_> {
    fn value(&self, of: Outcome) -> Figure {
        let quantity = NamedQuantity::outcome(of);
        let title = format!("Best {} against {}", quantity.label, self.along.label);
        let figure = self.figure(of.name(), title, quantity);
        let text = |value: f64| shown::outcome(of, value, self.system);
        self.with_optima(figure, Optimum::value, text)
    }

    /// The plot of the optimal value of the varied parameter `i`, with the bounds of its range.
    fn parameter(&self, i: usize, vary: &Vary) -> Figure {
        let quantity = NamedQuantity::parameter(vary.parameter);
        let title = format!(
            "{} of the best drive against {}",
            capital(&quantity.label),
            self.along.label
        );
        let name = vary.parameter.name.replace('.', "-");
        let figure = self
            .figure(&name, title, quantity)
            .with(self.bound_line("bounds", vary.low))
            .with(self.bound_line("", vary.high));
        let text = |value: f64| shown::parameter(vary.parameter, value, self.system);
        self.with_optima(figure, |best| best.solution.x.get(i).copied(), text)
    }

    fn figure(&self, of: &str, title: String, quantity: NamedQuantity) -> Figure {
        let tag = self.chart.along.parameter.name.replace('.', "-");
        let name = format!("chart-{of}-by-{tag}");
        let [x, y] = [self.along.clone(), quantity].map(Axis::linear);
        Figure {
            subtitle: self.subtitle.clone(),
            ..Figure::new(self.system, name, title, x, y)
        }
    }

    fn bound_line(&self, name: &str, bound: f64) -> Layer {
        Layer::new(
            name,
            Hue::Faint,
            Shape::dashed(vec![
                [self.chart.along.low, bound],
                [self.chart.along.high, bound],
            ]),
        )
    }

    /// Adds the optima to a plot of `value` as a line, with a labelled mark of the optimum for the
    /// setup. Numbered marks show where a bound or constraint becomes active or inactive; the note
    /// explains the numbers.
    fn with_optima(
        &self,
        figure: Figure,
        value: impl Fn(&Optimum) -> Option<f64>,
        text: impl Fn(f64) -> String,
    ) -> Figure {
        let (chart, system) = (self.chart, self.system);
        let along = chart.along.parameter;
        let place = |point: &ChartPoint| Some([point.at, value(&point.best)?]);
        let mut figure = figure.with(Layer::new(
            NamedDrive::OPTIMUM,
            Hue::OPTIMUM,
            Shape::dashed(chart.points.iter().filter_map(place).collect()),
        ));
        let own = self.own.and_then(|(at, best)| Some([at, value(best)?]));
        figure.layers.extend(own.map(|at| {
            Layer::new(
                format!("{}: {}", shown::stated(along, at[0], system), text(at[1])),
                Hue::OPTIMUM,
                Shape::Mark(at),
            )
        }));
        let mut notes: Vec<String> = self.other.iter().cloned().collect();
        let events = chart.points.iter().filter(|point| point.event.is_some());
        for (i, point) in events.enumerate() {
            if let (Some(event), Some(place)) = (&point.event, place(point)) {
                let number = format!("{}", i + 1);
                let at = self.along.of.read_off(point.at, system);
                let search = &point.best.search;
                let event =
                    event.words(|active| shown::active(active, search, system, shown::words));
                notes.push(format!("{number}: at {at} {event}."));
                figure
                    .layers
                    .push(Layer::new(number, Hue::Ink, Shape::Mark(place)));
            }
        }
        let ends = chart.begun.iter().chain(&chart.ended);
        notes.extend(ends.map(|why| why.in_units(system)));
        figure.noted(notes.join(" "))
    }
}

/// The sentence about the optimum `own` at the value `at`, if the chart follows another optimum
/// there.
fn other_optimum(chart: &Chart, at: f64, own: &Optimum, system: System) -> Option<String> {
    let of = own.search.outcome();
    let lost = chart.loss_at(own)?;
    let than = if lost > 0.0 { "better" } else { "worse" };
    Some(format!(
        "At {} the line follows another optimum than the mark, which is {than} by {}.",
        shown::stated(chart.along.parameter, at, system),
        shown::difference(of, lost.abs(), system)
    ))
}

/// The sentence about a parameter that is at the same bound in every optimum, in place of a plot.
fn bound_sentence(vary: &Vary, side: BoundSide, system: System) -> String {
    let at = shown::stated(vary.parameter, bound(vary, side), system);
    let why = if vary.low == vary.high {
        "the only value it may have".into()
    } else {
        format!("its {} bound", side.name())
    };
    let label = capital(&shown::words(vary.parameter.name));
    format!("{label}: {at}, {why}, in every optimum.")
}

/// The bound that a varied parameter reaches in every optimum of the chart and in `own`; `None` if
/// there is no such bound.
fn common_bound(chart: &Chart, own: Option<&Optimum>, i: usize, vary: &Vary) -> Option<BoundSide> {
    // tolerance for rounding errors
    let rounding = 1e-12 * (vary.high - vary.low);
    let is_common = |side: &BoundSide| {
        let end = bound(vary, *side);
        let optima = chart.points.iter().map(|point| &point.best);
        optima
            .chain(own)
            .all(|best| (best.solution.x[i] - end).abs() <= rounding)
    };
    [BoundSide::Lower, BoundSide::Upper]
        .into_iter()
        .find(is_common)
}

fn bound(vary: &Vary, side: BoundSide) -> f64 {
    match side {
        BoundSide::Lower => vary.low,
        BoundSide::Upper => vary.high,
    }
}
