use crate::args::Sweep;
use longdrive::batch::{Axis, Grid, Points, Sequence, open_table};
use longdrive::parameters::Vary;
use longdrive::{Error, Result, Setup};

/// The points that are asked for.
pub fn points(setup: &Setup<f64>, args: &Sweep) -> Result<Box<dyn Points>> {
    if let Some(table) = &args.points {
        return open_table(setup, table);
    }
    let Some(rows) = args.sample else { return Ok(Box::new(Grid::new(axes(setup, args)?)?)) };
    Ok(Box::new(Sequence::new(varied(setup, args)?, rows, args.seed)?))
}

/// The ranges that the points lie in, as far as they are known beforehand: a table's are not.
pub fn ranges(setup: &Setup<f64>, args: &Sweep) -> Result<Vec<Vary>> {
    match (&args.points, args.sample) {
        (Some(_), _) => Ok(vec![]),
        (None, Some(_)) => varied(setup, args),
        (None, None) => Ok(axes(setup, args)?.into_iter().map(|axis| axis.over).collect()),
    }
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
        None => Vary::read(setup, text),
    });
    over.collect()
}
