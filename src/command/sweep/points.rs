use crate::batch::{Axis, Grid, Points, Sequence};
use crate::command::args::Sweep;
use crate::parameters::Vary;
use crate::table::open_table;
use crate::{Error, Result, Setup};

/// The points of the sweep: a table, a grid or a sequence.
pub fn points(setup: &Setup<f64>, args: &Sweep) -> Result<Box<dyn Points>> {
    if let Some(table) = &args.points {
        return Ok(open_table(setup, table)?);
    }
    let over = args.over.iter();
    Ok(match args.sample {
        None => Box::new(Grid::new(
            over.map(|text| Axis::read(setup, text))
                .collect::<Result<_>>()?,
        )?),
        Some(rows) => {
            let over = over.map(|text| range(setup, text)).collect::<Result<_>>()?;
            Box::new(Sequence::new(over, rows, args.seed)?)
        }
    })
}

/// The range of a parameter in a sample.
fn range(setup: &Setup<f64>, text: &str) -> Result<Vary> {
    match text.rsplit_once(':') {
        Some((range, _)) => Err(Error::SearchRange {
            name: text.into(),
            reason: format!(
                "`sample` says how many points there are; write {range}, without a count"
            ),
        }),
        None => Vary::read_column(setup, text),
    }
}
