use super::lines::paragraph;
use super::table::table;
use super::{Reply, json, shown};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::study::{Active, Chart, ChartPoint, Search, Vary};
use crate::units::{Message, Quantity, System};
use serde::Serialize;
use serde_json::{Map, Value};

/// A chart as JSON, SI and radians.
#[derive(Clone, Debug, Serialize)]
pub struct ChartReport {
    /// The parameter it runs along.
    pub parameter: &'static str,
    /// The outcome that is sought.
    pub objective: &'static str,
    /// Which value of it: `maximize` or `minimize`.
    pub sense: &'static str,
    /// Its points, in order.
    pub points: Vec<ChartPointReport>,
    /// Why it begins after the range does; `null` where it does not.
    pub begun: Option<String>,
    /// Why it ends before the range does; `null` where it does not.
    pub ended: Option<String>,
}

/// A point of a chart.
#[derive(Clone, Debug, Serialize)]
pub struct ChartPointReport {
    /// The parameter's value.
    pub at: f64,
    /// The outcome's best value there.
    pub value: Value,
    /// Where it is, by parameter.
    pub optimum: Map<String, Value>,
    /// The ball as it leaves there: speed, launch angle and backspin.
    pub launch: Map<String, Value>,
    /// What holds it: parameters at a bound, and constraints.
    pub active: Vec<String>,
    /// At which bound, `lower` or `upper`.
    pub bounds: Map<String, Value>,
    /// What changes here.
    pub event: Option<String>,
}

impl ChartReport {
    /// The answer of `chart`: `done`, `interrupted`, `partial` where the optimum is missing for a
    /// part of the range, or `no-answer`.
    pub fn reply(chart: &Chart, search: &Search, warnings: Vec<Message>) -> Reply<Self> {
        let notes: Vec<String> = chart
            .begun
            .iter()
            .chain(&chart.ended)
            .map(Message::to_string)
            .collect();
        let status = match (notes.is_empty(), chart.points.is_empty()) {
            _ if chart.interrupted => "interrupted",
            (true, _) => "done",
            (false, true) => "no-answer",
            (false, false) => "partial",
        };
        let message = (!notes.is_empty()).then(|| notes.join("; "));
        Reply::done("chart", warnings, Self::new(chart, search)).ended(status, message)
    }

    fn new(chart: &Chart, search: &Search) -> Self {
        let point = |point: &ChartPoint| {
            let names = point
                .best
                .search
                .vary
                .iter()
                .map(|vary| vary.parameter.name);
            let bounds = point
                .active
                .iter()
                .filter_map(|active| Some((active.name.clone(), active.end?.into())));
            ChartPointReport {
                at: point.at,
                value: json::number(point.best.value()),
                optimum: json::named(names.zip(point.best.solution.x.iter().map(|x| Some(*x)))),
                launch: json::named(LAUNCH.iter().map(|of| of.name()).zip(launch(point))),
                active: point
                    .active
                    .iter()
                    .map(|active| active.name.clone())
                    .collect(),
                bounds: bounds.collect(),
                event: point.event.as_ref().map(ToString::to_string),
            }
        };
        Self {
            parameter: chart.along.parameter.name,
            objective: search.outcome().name(),
            sense: search.sense.name(),
            points: chart.points.iter().map(point).collect(),
            begun: chart.begun.as_ref().map(Message::to_string),
            ended: chart.ended.as_ref().map(Message::to_string),
        }
    }
}

/// What is told of the ball as it leaves at each optimum.
const LAUNCH: [Outcome; 3] = [Outcome::BallSpeed, Outcome::LaunchAngle, Outcome::Backspin];

fn launch(point: &ChartPoint) -> [Option<f64>; 3] {
    LAUNCH.map(|of| of.value(point.best.drive.as_ref()?))
}

/// The parameters and the outcome that the columns of a chart hold, in order.
fn head(chart: &Chart) -> Vec<(&'static str, Quantity)> {
    let Some(first) = chart.points.first() else {
        return vec![];
    };
    let search = &first.best.search;
    let along = chart.along.parameter;
    let varied = search
        .vary
        .iter()
        .map(|vary| (vary.parameter.name, vary.parameter.quantity));
    [
        (along.name, along.quantity),
        (search.outcome().name(), search.of.quantity),
    ]
    .into_iter()
    .chain(varied)
    .collect()
}

/// A chart as a table.
pub fn chart_text(chart: &Chart, system: System) -> String {
    let mut columns: Vec<&str> = head(chart).into_iter().map(|(name, _)| name).collect();
    columns.extend(LAUNCH.iter().map(|of| of.name()));
    let right: Vec<usize> = (0..columns.len()).collect();
    columns.push("active");
    let rows = chart.points.iter().map(|point| {
        let show = |(vary, x): (&Vary, &f64)| shown::parameter(vary.parameter, *x, system);
        let value = shown::outcome_or_dash(point.best.search.outcome(), point.best.value(), system);
        let told =
            |active: &Active| shown::active(active, &point.best.search, system, str::to_owned);
        let event = point
            .event
            .as_ref()
            .map(|event| format!("<- {}", event.words(told)));
        let words = if point.active.is_empty() {
            shown::NONE.into()
        } else {
            listed(point, ", ", told)
        };
        [
            shown::parameter(chart.along.parameter, point.at, system),
            value,
        ]
        .into_iter()
        .chain(
            point
                .best
                .search
                .vary
                .iter()
                .zip(&point.best.solution.x)
                .map(show),
        )
        .chain(
            LAUNCH
                .into_iter()
                .zip(launch(point))
                .map(|(of, value)| shown::outcome_or_dash(of, value, system)),
        )
        .chain([[Some(words), event]
            .into_iter()
            .flatten()
            .collect::<Vec<_>>()
            .join("\n")])
        .collect()
    });
    let notes = chart
        .begun
        .iter()
        .chain(&chart.ended)
        .map(|why| format!("\n{}", paragraph(&why.in_units(system))));
    table(&columns, &right, rows) + &notes.collect::<String>()
}

/// A chart as CSV, SI and radians; the head names the unit of each column, `swing.speed [m/s]`.
///
/// # Errors
/// [`Error::Output`].
pub fn chart_csv(chart: &Chart) -> Result<String> {
    let failed = |error: csv::Error| Error::Output(error.into());
    let mut writer = csv::Writer::from_writer(vec![]);
    let launched = LAUNCH.iter().map(|of| (of.name(), of.quantity()));
    let numbers = head(chart)
        .into_iter()
        .chain(launched)
        .map(|(name, quantity)| quantity.head(name));
    writer
        .write_record(numbers.chain(["active".into(), "event".into()]))
        .map_err(failed)?;
    for point in &chart.points {
        let numbers = [point.at, point.best.value().unwrap_or(f64::NAN)];
        let launch = launch(point).map(|value| value.unwrap_or(f64::NAN));
        let numbers = numbers.iter().chain(&point.best.solution.x).chain(&launch);
        let numbers = numbers.map(|number| {
            if number.is_nan() {
                String::new()
            } else {
                format!("{number:?}")
            }
        });
        let words = [
            listed(point, "; ", Active::to_string),
            point
                .event
                .as_ref()
                .map(ToString::to_string)
                .unwrap_or_default(),
        ];
        writer.write_record(numbers.chain(words)).map_err(failed)?;
    }
    let bytes = writer
        .into_inner()
        .map_err(|error| Error::Output(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// The bounds and constraints that are active at a point, as `told` writes them.
fn listed(point: &ChartPoint, separator: &str, told: impl Fn(&Active) -> String) -> String {
    point
        .active
        .iter()
        .map(told)
        .collect::<Vec<_>>()
        .join(separator)
}
