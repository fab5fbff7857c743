use crate::command::args::ChartArgs;
use crate::command::interrupt::{self, BEST_SO_FAR};
use crate::command::output::{Answer, spinner, system, tell, tell_error, warn};
use crate::optimize::Iteration;
use crate::report::{ChartReport, iteration_line, outcome_text, parameter_text};
use crate::study::{Chart, ChartObserver, Search, Vary, chart_at};
use crate::{Error, Result, Setup};
use indicatif::ProgressBar;
use std::cell::{Cell, RefCell};
use std::rc::Rc;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

pub fn run(args: &ChartArgs) -> Result<Answer> {
    let request = args.setup_args.request()?;
    let setup = request.setup_with_starts(&args.search.vary)?;
    let (along, at) = args.places(&setup)?;
    let setup = request.with_values(
        setup,
        [(along.parameter, 0.5 * (along.low + along.high))],
        "begins at",
    )?;
    let search = args.search.search(&setup)?;
    request.refuse_stated_with_default(&[along.parameter], "`along` gives its values")?;
    let ranges: Vec<_> = search.vary.iter().copied().chain([along]).collect();
    let setup = request.for_many(setup, &ranges)?;
    let mut warnings = setup.warnings();
    warn(&warnings);
    let stop = interrupt::stops(BEST_SO_FAR);
    request.note_starts(&setup, &search.vary);
    let of = search.outcome();
    let spinner = spinner("following the optimum");
    let beginning = {
        let (spinner, last) = (spinner.clone(), RefCell::new(String::new()));
        move |at| {
            let place = parameter_text(along.parameter, at, system());
            // where the chart ends is searched for in ever smaller steps, which read alike
            if last.replace(place.clone()) != place {
                spinner.suspend(|| {
                    tell(&format!(
                        "searching for an optimum at {} {place}",
                        along.parameter.name
                    ))
                });
            }
        }
    };
    if !at.is_sorted_by(|a, b| a < b) {
        tell("the values of `at` are taken in rising order, each once");
    }
    let observer = ChartObserver {
        interrupt: stop.clone(),
        beginning: Some(Rc::new(beginning)),
        iteration: Some(Rc::new(progress(&search, &spinner))),
    };
    let chart = chart_at(&setup, &search, along, &at, &observer, &mut |point| {
        if at.is_empty() || at.contains(&point.at) {
            let value = point
                .best
                .value()
                .map_or("–".into(), |value| outcome_text(of, value, system()));
            let place = parameter_text(along.parameter, point.at, system());
            spinner.suspend(|| {
                tell(&format!(
                    "{} {place}: {} {value}",
                    along.parameter.name,
                    of.name()
                ))
            });
        }
        true
    });
    spinner.finish_and_clear();
    interrupt::ends();
    let chart = match chart {
        Err(error) if error.is_an_outcome() => {
            tell_error(&error);
            let interrupted = stop.load(Ordering::Relaxed);
            let none = Chart {
                along,
                points: vec![],
                begun: None,
                ended: Some(error.message()),
                interrupted,
            };
            let answer = if request.is_json() {
                Answer::report(&ChartReport::new(&none, &search), warnings, true)
            } else {
                Answer::text(String::new())
            };
            return Ok(answer.found(false));
        }
        chart => chart?,
    };
    let beyond = chart.warnings();
    warn(&beyond);
    warnings.extend(beyond);
    let report = ChartReport::new(&chart, &search);
    let answer = if args.csv && !request.is_json() {
        for note in chart.begun.iter().chain(&chart.ended) {
            tell(&note.in_units(system()));
        }
        Answer::text(report.csv()?)
    } else {
        Answer::report(&report, warnings, request.is_json())
    };
    Ok(answer.found(chart.begun.is_none() && chart.ended.is_none()))
}

/// Tells of an iteration where nothing was told for a second: most searches of a chart are done
/// before.
fn progress(search: &Search, spinner: &ProgressBar) -> impl Fn(&Iteration) + use<> {
    const SILENCE: Duration = Duration::from_secs(1);
    let (search, spinner, told) = (search.clone(), spinner.clone(), Cell::new(Instant::now()));
    move |iteration| {
        if told.get().elapsed() >= SILENCE {
            told.set(Instant::now());
            spinner.suspend(|| tell(&iteration_line(&search, iteration, system())));
        }
    }
}

impl ChartArgs {
    /// The parameter with its range, and the values asked for in it.
    fn places(&self, setup: &Setup<f64>) -> Result<(Vary, Vec<f64>)> {
        if !self.along.contains('=') && self.at.is_empty() {
            let reason =
                "write NAME=LOW..HIGH, for example swing.speed=80mph..130mph, or give the places \
                 with `at`"
                    .into();
            return Err(Error::SearchRange {
                name: self.along.clone(),
                reason,
            });
        }
        if self.along.contains('=') {
            let along = Vary::read_column(setup, &self.along)?;
            let read = |text: &String| {
                along
                    .parameter
                    .read(text, false)
                    .map(Option::unwrap_or_default)
            };
            return Ok((along, self.at.iter().map(read).collect::<Result<_>>()?));
        }
        let parameter = setup.column(self.along.trim())?;
        let read = |text: &String| parameter.read(text, false).map(Option::unwrap_or_default);
        let at = self.at.iter().map(read).collect::<Result<Vec<_>>>()?;
        let (low, high) = (
            at.iter().copied().fold(f64::INFINITY, f64::min),
            at.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        );
        Ok((Vary::new(parameter, low, high)?, at))
    }
}
