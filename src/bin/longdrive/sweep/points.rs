use crate::args::Sweep;
use longdrive::batch::{Axis, Grid, Points, Sequence, open_table};
use longdrive::parameters::Vary;
use longdrive::{Error, Result, Setup};

/// The points that are asked for.
pub fn points(setup: &Setup<f64>, args: &Sweep) -> Result<Box<dyn Points>> {
    if let Some(table) = &args.points {
        return open_table(setup, table);
    }
    let Some(rows) = args.sample else {
        let axes = args.over.iter().map(|text| Axis::read(setup, text)).collect::<Result<_>>()?;
        return Ok(Box::new(Grid::new(axes)?));
    };
    let over = args.over.iter().map(|text| match text.rsplit_once(':') {
        Some((range, _)) => Err(Error::SearchRange {
            name: text.clone(),
            reason: format!("--sample says how many points there are; write {range}, without a count"),
        }),
        None => Vary::read(setup, text),
    });
    Ok(Box::new(Sequence::new(over.collect::<Result<_>>()?, rows, args.seed)?))
}
