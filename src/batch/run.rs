use super::block::Block;
use super::definition::Batch;
use super::in_order::in_order;
use super::points::Points;
use crate::error::{Error, Result};
use crate::parameters::Parameter;
use std::sync::atomic::{AtomicBool, Ordering};

/// Number of rows of a chunk, the unit of work of one thread.
pub const CHUNK: usize = 1024;

/// Options of a run.
#[derive(Clone, Copy, Debug, Default)]
pub struct Run<'a> {
    /// First row to compute; 0 by default. If it is a multiple of [`CHUNK`], the blocks are those
    /// of a run from row 0.
    pub first_row: u64,
    /// The row after the last row to compute. With `None`, the default, all rows are computed.
    pub end_row: Option<u64>,
    /// Number of threads, at most 256 and at most the number of chunks. 0, the default, means one
    /// per processor.
    pub threads: usize,
    /// Interrupt flag: once true, no further chunk begins, and the run ends after the chunks that
    /// have begun. Flights of thousands of steps are interrupted too.
    pub stop: Option<&'a AtomicBool>,
}

impl Batch {
    /// Computes the drives of all points, in blocks of at most [`CHUNK`] rows. The thread that
    /// computed a block also calls `work` on it. `sink` receives the results of `work` in the order
    /// of the points. Returns the number of the row after the last delivered row, or
    /// `run.first_row` if no row was delivered.
    ///
    /// A drive without a flight is not an error: its [`Status`](super::Status) reports it. The
    /// integration has the method and step of the setup;
    /// [`accuracy`](crate::integration::accuracy()) finds both for a tolerance.
    ///
    /// # Errors
    /// [`Error::Together`] if `points` does not have the swept parameters in their order, or if
    /// [`Points::read`] returns inconsistent numbers of rows and values; errors of `points` and
    /// `sink`. Rows before an unreadable point are delivered first.
    pub fn run<R: Send>(
        &self,
        points: &mut dyn Points,
        run: &Run<'_>,
        work: impl Fn(Block) -> R + Sync,
        mut sink: impl FnMut(R) -> Result<()>,
    ) -> Result<u64> {
        self.check_parameters(points.parameters())?;
        points.seek(run.first_row)?;
        let end = run.end_row.unwrap_or(u64::MAX).min(points.rows());
        let chunks = end.saturating_sub(run.first_row).div_ceil(CHUNK as u64);
        let is_stopped = || run.stop.is_some_and(|stop| stop.load(Ordering::Relaxed));
        let (mut row, mut done) = (run.first_row, run.first_row);
        let (never, mut is_cut) = (AtomicBool::new(false), false);
        let next = || {
            let mut values = Vec::with_capacity(CHUNK * self.parameters.len());
            let most = end.saturating_sub(row).min(CHUNK as u64) as usize;
            let rows = if is_stopped() || most == 0 {
                0
            } else {
                points.read(most, &mut values)?
            };
            self.check_chunk(rows, most, values.len())?;
            let (first_row, rows) = (row, rows as u64);
            row += rows;
            Ok((rows > 0).then_some((first_row, rows, values)))
        };
        in_order(
            run.threads,
            chunks,
            next,
            |(first_row, rows, values)| {
                let block = self.evaluate_until(first_row, values, run.stop.unwrap_or(&never));
                (rows, block.map(&work))
            },
            |(rows, result)| {
                // rows after an incomplete chunk are not delivered
                is_cut |= result.is_none();
                if let Some(result) = result.filter(|_| !is_cut) {
                    sink(result)?;
                    done += rows;
                }
                Ok(())
            },
        )?;
        Ok(done)
    }

    fn check_parameters(&self, of_points: &[&'static Parameter]) -> Result<()> {
        if of_points == self.parameters() {
            return Ok(());
        }
        let named = |all: &[&'static Parameter]| {
            all.iter()
                .map(|one| one.name)
                .collect::<Vec<_>>()
                .join(", ")
        };
        let given = format!("points of {}", named(of_points));
        let reason = format!(
            "the parameters of the batch are {}; give points of these parameters, in this order",
            named(self.parameters())
        );
        Err(Error::Together { given, reason })
    }

    fn check_chunk(&self, rows: usize, most: usize, values: usize) -> Result<()> {
        let parameters = self.parameters().len();
        if rows <= most && Some(values) == rows.checked_mul(parameters) {
            return Ok(());
        }
        let given = format!(
            "Points::read was called for at most {most} rows, returned {rows} and appended \
             {values} values"
        );
        let reason = format!(
            "it must append {parameters} values for each row, and at most the requested number of \
             rows"
        );
        Err(Error::Together { given, reason })
    }
}
