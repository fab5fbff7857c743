use crate::args::ChartArgs;
use crate::output::{Answer, tell, warn};
use crate::search::{BEST_SO_FAR, interrupt};
use longdrive::Result;
use longdrive::report::{ChartReport, chart_csv, chart_text};
use longdrive::study::{Chart, Vary, chart};
use std::sync::atomic::Ordering;

pub fn run(args: &ChartArgs) -> Result<Answer> {
    let setup = args.question.setup()?;
    let search = args.search.search(&setup)?;
    let along = Vary::read(&setup, &args.along)?;
    let ranges: Vec<_> = search.vary.iter().copied().chain([along]).collect();
    let setup = args.question.within_tolerance(setup, &ranges)?;
    let warnings = setup.warnings();
    warn(&warnings);
    let stop = interrupt(BEST_SO_FAR);
    let of = search.maximize;
    let chart = chart(&setup, &search, along, |point| {
        let value = point.best.value().map_or("–".into(), |value| of.show(value));
        tell(&format!("{} {}: {} {value}", along.parameter.name, along.parameter.show(Some(point.at)), of.name()));
        !stop.load(Ordering::Relaxed)
    });
    let chart = match chart {
        Err(error) if error.is_an_outcome() => {
            tell(&format!("error: {error}"));
            let none = Chart { along, points: vec![], begun: None, ended: Some(error.to_string()) };
            let answer = if args.question.json {
                Answer::json(&ChartReport::reply(&none, of, warnings))
            } else {
                Answer::text(String::new())
            };
            return Ok(answer.found(false));
        }
        chart => chart?,
    };
    let answer = if args.question.json {
        Answer::json(&ChartReport::reply(&chart, of, warnings))
    } else if args.csv {
        Answer::text(chart_csv(&chart)?)
    } else {
        Answer::text(chart_text(&chart))
    };
    Ok(answer.found(chart.begun.is_none() && chart.ended.is_none()))
}
