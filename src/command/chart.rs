use crate::command::args::{SearchArgs, SetupArgs};
use crate::command::interrupt::{self, BEST_SO_FAR};
use crate::command::output::{
    Answer, is_json, note, note_detail, note_error, once_a_second, spinner, stated_system, system,
    warn,
};
use crate::command::search::SearchRequest;
use crate::optimize::Iteration;
use crate::report::{ChartReport, iteration_line, outcome_text, parameter_text};
use crate::statistics::extent;
use crate::study::{Chart, ChartObserver, ChartPoint, Search, Vary, chart};
use crate::{Error, Result, Setup};
use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    #[command(flatten)]
    pub search: SearchArgs,

    /// The parameter along which optima are computed, with its range, e.g.
    /// swing.speed=80mph..130mph.
    #[arg(long, value_name = "NAME=LOW..HIGH", allow_hyphen_values = true)]
    pub along: String,

    /// The values of the parameter of --along at which the optimum is computed, separated by
    /// commas, e.g. 90mph,100mph,110mph; --along then needs only the name [default: as many values
    /// as the curve needs].
    #[arg(
        long,
        value_name = "VALUE,…",
        value_delimiter = ',',
        allow_hyphen_values = true
    )]
    pub at: Vec<String>,

    /// Print the chart as CSV; each column head names its unit.
    #[arg(long, conflicts_with = "json")]
    pub csv: bool,
}

pub fn run(args: &Args) -> Result<Answer> {
    let request = args.setup_args.request()?;
    let (along, at) = args.places(&request.partial_setup)?;
    request.refuse_stated_besides_launch(&[along.parameter], "`along` gives its values")?;
    let drive_search = args.search.of_drive(&request, Some(along), None)?;
    let SearchRequest { setup, search, .. } = &drive_search;
    request.warn_of_ranges(setup, &[along]);
    let work = interrupt::enable(BEST_SO_FAR);
    if !at.is_sorted_by(|a, b| a < b) {
        note("the values of `at` are used in ascending order, each once");
    }
    let origin = &drive_search.origin;
    let chart = follow(setup, search, along, &at, &work.stop);
    let is_interrupted = work.stop.load(Ordering::Relaxed);
    drop(work);
    let chart = match chart {
        Err(error) if error.has_valid_input() => {
            note_error(&error);
            let none = Chart {
                along,
                points: vec![],
                begun: None,
                ended: Some(error.message()),
                interrupted: is_interrupted,
            };
            let answer = if is_json() {
                let report = ChartReport::new(&none, search);
                Answer::report(&report, origin)
            } else {
                Answer::text(String::new())
            };
            return Ok(answer.found(false));
        }
        chart => chart?,
    };
    warn(chart.warnings());
    let report = ChartReport::new(&chart, search);
    let answer = if args.csv {
        for message in chart.begun.iter().chain(&chart.ended) {
            note(&message.in_units(system()));
        }
        Answer::text(report.csv(stated_system().into())?)
    } else {
        Answer::report(&report, origin)
    };
    Ok(answer.found(chart.begun.is_none() && chart.ended.is_none()))
}

/// Follows the optimum along the parameter `along`. The current value of the parameter is the
/// progress message.
fn follow(
    setup: &Setup<f64>,
    search: &Search,
    along: Vary,
    at: &[f64],
    stop: &Arc<AtomicBool>,
) -> Result<Chart> {
    let spinner = spinner("following the optimum");
    let place_text = move |at| {
        let place = parameter_text(along.parameter, at, system());
        format!("{} {place}", along.parameter.name)
    };
    let beginning = {
        let (spinner, last) = (spinner.clone(), RefCell::new(String::new()));
        move |at| {
            let place = place_text(at);
            // show each text once: near the end of a chart the steps are so small that consecutive
            // values have equal texts
            if last.replace(place.clone()) != place {
                let doing = format!("searching for an optimum at {place}");
                spinner.set_message(doing.clone());
                note_detail(&doing);
            }
        }
    };
    let iteration = {
        let (search, is_due) = (search.clone(), once_a_second());
        move |iteration: &Iteration| {
            if is_due() {
                note_detail(&iteration_line(&search, iteration, system()));
            }
        }
    };
    let point = {
        let (of, at) = (search.outcome(), at.to_vec());
        move |point: &ChartPoint| {
            if at.is_empty() || at.contains(&point.at) {
                let value = point
                    .best
                    .value()
                    .map_or("–".into(), |value| outcome_text(of, value, system()));
                let place = place_text(point.at);
                note_detail(&format!("{place}: {} {value}", of.name()));
            }
        }
    };
    let observer = ChartObserver {
        interrupt: stop.clone(),
        beginning: Some(Rc::new(beginning)),
        iteration: Some(Rc::new(iteration)),
        point: Some(Rc::new(point)),
    };
    let chart = chart(setup, search, along, at, &observer);
    spinner.finish();
    chart
}

impl Args {
    /// The parameter of `--along` with its range, and the values of `--at`, SI. With `--at`, the
    /// range is from the smallest to the largest value. Without `--at`, the list of values is
    /// empty.
    fn places(&self, setup: &Setup<f64>) -> Result<(Vary, Vec<f64>)> {
        if !self.along.contains('=') && self.at.is_empty() {
            let reason =
                "write NAME=LOW..HIGH, for example swing.speed=80mph..130mph, or give the values \
                 with `at`"
                    .into();
            return Err(Error::SearchRange {
                name: self.along.clone(),
                reason,
            });
        }
        if self.along.contains('=') {
            let along = Vary::read_column(setup, &self.along)?;
            if self.at.is_empty() {
                return Ok((along, vec![]));
            }
            let name = along.parameter.name;
            let source = format!(
                "`along` gives a range, and `at` gives values; for the range leave `at` out, for \
                 the values write `along {name}`"
            );
            return Err(Error::unreadable("`at`", source));
        }
        let parameter = setup.column(self.along.trim())?;
        let read = |text: &String| parameter.read(text, false).map(Option::unwrap_or_default);
        let at = self.at.iter().map(read).collect::<Result<Vec<_>>>()?;
        let [low, high] = extent(at.iter().copied());
        Ok((Vary::new(parameter, low, high)?, at))
    }
}
