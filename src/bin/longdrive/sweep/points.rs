use crate::args::Sweep;
use longdrive::batch::{Axis, CHUNK, Grid, Points, Sequence, open_table};
use longdrive::parameters::{Parameter, Vary};
use longdrive::{Error, Result, Setup};

/// The points that are asked for.
pub fn points(setup: &Setup<f64>, args: &Sweep) -> Result<Box<dyn Points>> {
    if let Some(table) = &args.points {
        return open_table(setup, table);
    }
    let Some(rows) = args.sample else { return Ok(Box::new(Grid::new(axes(setup, args)?)?)) };
    Ok(Box::new(Sequence::new(varied(setup, args)?, rows, args.seed)?))
}

/// The ranges that the points lie in; a table is read through for them.
pub fn ranges(setup: &Setup<f64>, args: &Sweep) -> Result<Vec<Vary>> {
    match (&args.points, args.sample) {
        (Some(_), _) => of_table(points(setup, args)?.as_mut()),
        (None, Some(_)) => varied(setup, args),
        (None, None) => Ok(axes(setup, args)?.into_iter().map(|axis| axis.over).collect()),
    }
}

/// The ranges of a table's columns. Values that no drive can have are passed over: their rows have a status of their own.
fn of_table(points: &mut dyn Points) -> Result<Vec<Vary>> {
    let none = |parameter: &&'static Parameter| Vary { parameter, low: f64::INFINITY, high: f64::NEG_INFINITY };
    let mut ranges: Vec<Vary> = points.parameters().iter().map(none).collect();
    let mut values = vec![];
    while points.read(CHUNK, &mut values)? > 0 {
        for row in values.chunks(ranges.len()) {
            for (range, value) in ranges.iter_mut().zip(row) {
                if range.parameter.range.contains(*value) {
                    (range.low, range.high) = (range.low.min(*value), range.high.max(*value));
                }
            }
        }
        values.clear();
    }
    ranges.retain(|range| range.low <= range.high);
    Ok(ranges)
}

fn axes(setup: &Setup<f64>, args: &Sweep) -> Result<Vec<Axis>> {
    args.over.iter().map(|text| Axis::read(setup, text)).collect()
}

fn varied(setup: &Setup<f64>, args: &Sweep) -> Result<Vec<Vary>> {
    let over = args.over.iter().map(|text| match text.rsplit_once(':') {
        Some((range, _)) => Err(Error::SearchRange {
            name: text.clone(),
            reason: format!("--sample says how many points there are; write {range}, without a count"),
        }),
        None => Vary::read_column(setup, text),
    });
    over.collect()
}
