use super::csv_text::csv_text;
use super::document::{Document, DocumentTable};
use super::json::{ByName, JsonNumber};
use super::plot::NamedQuantity;
use super::reply::{Ending, Report};
use super::shown;
use crate::drive::Outcome;
use crate::error::Result;
use crate::parameters::Parameter;
use crate::study::{Active, BoundSide, Chart, ChartPoint, Search};
use crate::units::{DisplayUnit, Message, System, TableUnits};
use serde::Serialize;

/// Optima along a parameter, SI and radians.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ChartReport<'a> {
    #[serde(skip)]
    chart: &'a Chart,
    /// The parameter along which the chart runs.
    pub parameter: &'static str,
    /// The outcome that is optimized.
    pub objective: Outcome,
    /// `maximize` or `minimize`.
    #[cfg_attr(test, schemars(with = "crate::study::Sense"))]
    pub sense: &'static str,
    /// The points of the chart, in order.
    pub points: Vec<ChartPointReport>,
    /// The reason why the chart begins after the start of the range; `null` if the chart covers the
    /// start.
    pub begun: Option<String>,
    /// The reason why the chart ends before the end of the range; `null` if the chart covers the
    /// end.
    pub ended: Option<String>,
}

/// An optimum of a chart.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct ChartPointReport {
    /// The value of the chart's parameter, SI.
    pub at: f64,
    /// The optimal value of the objective, SI.
    pub value: JsonNumber,
    /// The varied parameters at the optimum, SI.
    pub optimum: ByName<JsonNumber>,
    /// The launch of the optimal drive: ball speed (m/s), launch angle (rad) and backspin (rad/s).
    pub launch: ByName<JsonNumber>,
    /// The active bounds and constraints.
    pub active: Vec<String>,
    /// The active bound of each parameter that is at a bound.
    pub bounds: ByName<BoundSide>,
    /// A change of the active bounds and constraints at this point, or a jump to another local
    /// optimum; `null` if there is neither.
    pub event: Option<String>,
}

impl<'a> ChartReport<'a> {
    /// The report of a chart of this search.
    pub fn new(chart: &'a Chart, search: &Search) -> Self {
        Self {
            chart,
            parameter: chart.along.parameter.name,
            objective: search.outcome(),
            sense: search.sense.name(),
            points: chart.points.iter().map(ChartPointReport::new).collect(),
            begun: chart.begun.as_ref().map(Message::to_string),
            ended: chart.ended.as_ref().map(Message::to_string),
        }
    }

    /// The chart as CSV. The column heads contain the units: `swing.speed [m/s]`.
    ///
    /// # Errors
    /// [`Error::Output`](crate::Error::Output).
    pub fn csv(&self, units: TableUnits) -> Result<String> {
        let chart = self.chart;
        let columns = columns(chart);
        let heads = columns.iter().map(|column| column.head(units));
        let head = heads.chain(["active".into(), "event".into()]).collect();
        let rows = chart.points.iter().map(|point| {
            let optimum = point.best.solution.x.iter().copied().map(Some);
            let values = [Some(point.at), point.best.value()]
                .into_iter()
                .chain(optimum)
                .chain(launch(point));
            let numbers = columns
                .iter()
                .zip(values)
                .map(|(column, value)| column.cell(value, units));
            let words = [
                listed(point, "; ", Active::to_string),
                point
                    .event
                    .as_ref()
                    .map(ToString::to_string)
                    .unwrap_or_default(),
            ];
            numbers.chain(words).collect()
        });
        csv_text(head, rows)
    }
}

impl ChartPointReport {
    fn new(point: &ChartPoint) -> Self {
        let vary = &point.best.search.vary;
        Self {
            at: point.at,
            value: point.best.value().into(),
            optimum: ByName::of_varied(vary, &point.best.solution.x),
            launch: LAUNCH
                .iter()
                .map(|of| of.name())
                .zip(launch(point))
                .collect(),
            active: point
                .active
                .iter()
                .map(|active| active.name.clone())
                .collect(),
            bounds: ByName::of_bounds(&point.active),
            event: point.event.as_ref().map(ToString::to_string),
        }
    }
}

impl Report for ChartReport<'_> {
    const COMMAND: &'static str = "chart";

    #[cfg(test)]
    const STATUSES: &'static [&'static str] = &["done", "partial", "no-answer", "interrupted"];

    /// `partial` if the optimum is missing for a part of the range, `no-answer` if it is missing
    /// everywhere.
    fn ending(&self) -> Ending {
        let reasons: Vec<&str> = self
            .begun
            .iter()
            .chain(&self.ended)
            .map(String::as_str)
            .collect();
        let status = match (reasons.is_empty(), self.points.is_empty()) {
            _ if self.chart.interrupted => "interrupted",
            (true, _) => "done",
            (false, true) => "no-answer",
            (false, false) => "partial",
        };
        Ending {
            status,
            message: (!reasons.is_empty()).then(|| reasons.join("; ")),
        }
    }

    /// A row for each optimum, then the reasons why the chart does not cover its range.
    fn document(&self, system: System) -> Document {
        let chart = self.chart;
        let mut document = Document::default();
        let columns = columns(chart);
        let numbers = columns.len();
        let heads = columns.into_iter().map(|column| column.label);
        let is_active = |point: &ChartPoint| !point.active.is_empty() || point.event.is_some();
        // omit the last column if no point of the chart has an active bound, a constraint or an
        // event
        let column_count = numbers + usize::from(chart.points.iter().any(is_active));
        let head = heads.chain(["active".into()]).take(column_count);
        let rows = chart.points.iter().map(|point| {
            let mut cells = row(chart, point, system);
            cells.truncate(column_count);
            cells
        });
        let mut table = DocumentTable::new(head, rows).right(0..numbers);
        if let Some(first) = chart.points.first() {
            table.caption = caption(chart, &first.best.search, system);
        }
        document.add(table);
        for why in chart.begun.iter().chain(&chart.ended) {
            document.paragraph(why.in_units(system));
        }
        document
    }
}

/// The contents of the rows of a chart: "largest carry for each swing.speed; varied: club.loft 4°
/// .. 20°".
fn caption(chart: &Chart, search: &Search, system: System) -> String {
    let varied: Vec<_> = search
        .vary
        .iter()
        .map(|vary| format!("{} {}", vary.parameter.name, shown::range(vary, system)))
        .collect();
    format!(
        "{} for each {}; varied: {}",
        search.sense.best_of(&search.of),
        chart.along.parameter.name,
        varied.join(", ")
    )
}

/// The outcomes of the launch in each row of a chart.
const LAUNCH: [Outcome; 3] = [Outcome::BallSpeed, Outcome::LaunchAngle, Outcome::Backspin];

fn launch(point: &ChartPoint) -> [Option<f64>; 3] {
    LAUNCH.map(|of| of.value(point.best.drive.as_ref()?))
}

/// The columns with numbers: the chart's parameter, the objective, the varied parameters and the
/// outcomes of `LAUNCH`. A chart without points has only the outcomes of `LAUNCH`.
fn columns(chart: &Chart) -> Vec<NamedQuantity> {
    let column = |name: &str, of: DisplayUnit| NamedQuantity {
        label: name.into(),
        of,
    };
    let of_parameter = |parameter: &Parameter| column(parameter.name, parameter.into());
    let mut columns = vec![];
    if let Some(first) = chart.points.first() {
        let search = &first.best.search;
        let objective = search.outcome().name();
        columns.push(of_parameter(chart.along.parameter));
        columns.push(column(objective, (&search.of).into()));
        columns.extend(search.vary.iter().map(|vary| of_parameter(vary.parameter)));
    }
    columns.extend(LAUNCH.map(|of| column(of.name(), of.into())));
    columns
}

fn row(chart: &Chart, point: &ChartPoint, system: System) -> Vec<String> {
    let search = &point.best.search;
    let mut cells = vec![
        shown::parameter(chart.along.parameter, point.at, system),
        shown::outcome_or_dash(search.outcome(), point.best.value(), system),
    ];
    let varied = search.vary.iter().zip(&point.best.solution.x);
    cells.extend(varied.map(|(vary, x)| shown::parameter(vary.parameter, *x, system)));
    let launch = LAUNCH.into_iter().zip(launch(point));
    cells.extend(launch.map(|(of, value)| shown::outcome_or_dash(of, value, system)));
    let words = |active: &Active| shown::active(active, search, system, str::to_owned);
    let active = if point.active.is_empty() {
        shown::NONE.into()
    } else {
        listed(point, ", ", words)
    };
    cells.push(match &point.event {
        Some(event) => format!("{active}\n<- {}", event.words(words)),
        None => active,
    });
    cells
}

/// The active bounds and constraints of a point, formatted by `words` and joined by `separator`.
fn listed(point: &ChartPoint, separator: &str, words: impl Fn(&Active) -> String) -> String {
    point
        .active
        .iter()
        .map(words)
        .collect::<Vec<_>>()
        .join(separator)
}
