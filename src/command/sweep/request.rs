use super::args::Args;
use crate::batch::{Batch, Points};
use crate::command::names::{outcomes, variables};
use crate::command::output::note_each;
use crate::command::request::Request;
use crate::table::sweep_points;
use crate::{Error, Result};

/// The inputs of a sweep: the points, and the setup, outcomes and derivatives of the batch.
pub struct SweepRequest {
    pub points: Box<dyn Points>,
    pub batch: Batch,
}

impl SweepRequest {
    pub fn of(args: &Args, request: &Request) -> Result<Self> {
        let setup = request.partial_setup;
        let of = outcomes(&args.outcomes)?;
        let table = args.points.as_deref();
        let points = sweep_points(&setup, table, &args.over, args.sample, args.seed)?;
        let shown = table.map_or("`over`".into(), |table| table.display().to_string());
        note_each(shown, &points.notes());
        if let (Some(table), 0) = (&args.points, points.rows()) {
            let reason = "it has a head and no rows; give a row for each drive";
            return Err(Error::table(table.display().to_string(), "", reason));
        }
        request.refuse_columns(
            points.parameters(),
            "every drive of the sweep has a value of its own",
        )?;
        let ranges = points.ranges();
        request.warn_of_ranges(&setup, &ranges);
        request.warn_of_idle_in(&setup, &ranges);
        let integration = request.integration(&setup, &ranges, &of)?;
        let swept = points.parameters().iter().copied();
        let mut wrt: Vec<_> = swept.filter(|_| args.gradient).collect();
        for parameter in variables(&integration.setup, &args.wrt, &of)? {
            if !wrt.contains(&parameter) {
                wrt.push(parameter);
            }
        }
        let mut batch = integration.batch(points.parameters(), &of, &wrt)?;
        if let Some(instructions) = args.instructions {
            batch = batch.with_level(instructions)?;
        }
        Ok(Self { points, batch })
    }
}
