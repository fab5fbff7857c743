use super::block::Block;
use super::in_order::in_order;
use super::instructions::Instructions;
use super::points::{Points, refuse_repeated};
use super::question::Kernel;
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::number::Level;
use crate::parameters::{NO_CLUB, Parameter, Setup};
use std::sync::atomic::{AtomicBool, Ordering};

/// Rows of a chunk: the piece of a batch that one thread computes at a time.
pub const CHUNK: usize = 1024;

/// How a batch is run.
#[derive(Clone, Copy, Debug, Default)]
pub struct Run<'a> {
    /// The first row to compute (0): a multiple of [`CHUNK`] where the blocks are to be those of an uninterrupted run.
    pub first_row: u64,
    /// The row to end before (`None`: after the last point).
    pub end_row: Option<u64>,
    /// Threads (0: as many as there are processors); never more than there are chunks to compute.
    pub threads: usize,
    /// Ends the batch, after the chunks under way, once it is true.
    pub stop: Option<&'a AtomicBool>,
}

/// What is asked of every point.
#[derive(Clone, Debug)]
pub struct Batch {
    kernel: Kernel,
}

impl Batch {
    /// Outcomes of the setup at the points of some parameters, with their derivatives by `wrt`, if any.
    ///
    /// # Errors
    /// What [`Setup::validate`] refuses; [`Error::Nothing`] without outcomes or swept parameters;
    /// [`Error::NotVariable`], [`Error::Unknown`] and [`Error::OtherLaw`] as [`Setup::variable`].
    pub fn new(
        setup: &Setup<f64>,
        parameters: &[&'static Parameter],
        of: &[Outcome],
        wrt: &[&'static Parameter],
    ) -> Result<Self> {
        setup.validate_but_launch()?;
        if of.is_empty() {
            return Err(Error::Nothing { doing: "evaluate", what: "outcome" });
        }
        refuse_repeated(parameters)?;
        for parameter in parameters {
            setup.column(parameter.name)?;
        }
        for parameter in wrt.iter().filter(|parameter| !parameters.contains(parameter)) {
            setup.variable(parameter.name)?;
        }
        let names: Vec<_> = parameters.iter().map(|parameter| parameter.name).collect();
        setup.check_launch(&names)?;
        setup.check_air(&names)?;
        let is_launched = setup.launch.is_given() || parameters.iter().any(|parameter| parameter.is_of_launch());
        if let Some(of_club) = parameters.iter().chain(wrt).find(|parameter| is_launched && parameter.is_of_strike()) {
            return Err(Error::NotVariable { name: of_club.name.into(), reason: NO_CLUB.into() });
        }
        let (parameters, of, wrt) = (parameters.to_vec(), of.to_vec(), wrt.to_vec());
        Ok(Self {
            kernel: Kernel { setup: *setup, parameters, of, wrt, largest_defect: f64::INFINITY, level: Level::here() },
        })
    }

    /// The same with another step for each drive that the setup's own step does not follow closely enough: one whose steps have
    /// a larger defect than this, m (docs/model.md, eq. 16a), is flown again in steps half as long, and again. One that stays above it
    /// in the shortest has the status `diverged`.
    pub fn with_largest_defect(mut self, defect: f64) -> Self {
        self.kernel.largest_defect = defect;
        self
    }

    /// The same with these instructions of the processor in place of the best it has.
    ///
    /// # Errors
    /// [`Error::Together`] where the processor does not have them.
    pub fn with_instructions(mut self, instructions: Instructions) -> Result<Self> {
        self.kernel.level = instructions.checked()?.level();
        Ok(self)
    }

    /// The instructions that it is computed with.
    pub fn instructions(&self) -> Instructions {
        Instructions::of(self.kernel.level)
    }

    /// The largest defect that a drive may have, m; infinite where the setup's own step is kept.
    pub fn largest_defect(&self) -> f64 {
        self.kernel.largest_defect
    }

    /// The setup that the points move.
    pub fn setup(&self) -> &Setup<f64> {
        &self.kernel.setup
    }

    /// The swept parameters.
    pub fn parameters(&self) -> &[&'static Parameter] {
        &self.kernel.parameters
    }

    /// The outcomes.
    pub fn outcomes(&self) -> &[Outcome] {
        &self.kernel.of
    }

    /// What the outcomes are differentiated by.
    pub fn wrt(&self) -> &[&'static Parameter] {
        &self.kernel.wrt
    }

    /// The names of the columns of results, as in files: the outcomes, then their derivatives, as in `d_carry/d_club.loft`.
    pub fn columns(&self) -> Vec<String> {
        let derivative = |of: &Outcome| self.wrt().iter().map(|by| format!("d_{}/d_{}", of.name(), by.name)).collect();
        let derivatives = self.outcomes().iter().flat_map::<Vec<_>, _>(derivative);
        self.outcomes().iter().map(|of| of.name().to_owned()).chain(derivatives).collect()
    }

    /// The drives of some points, given one after the other.
    pub fn evaluate(&self, first_row: u64, points: Vec<f64>) -> Block {
        self.kernel.evaluate(first_row, points)
    }

    /// Computes the drives of all points. Each block goes through `work` on the thread that computed it, and what that
    /// makes of it to `sink`, in the order of the points. Returns the row after the last one handed on: the number of
    /// points or the end that was asked for, unless it was stopped.
    ///
    /// # Errors
    /// What `points` and `sink` return; rows before an unreadable point are handed on first.
    pub fn run<R: Send>(
        &self,
        points: &mut dyn Points,
        run: &Run<'_>,
        work: impl Fn(Block) -> R + Sync,
        mut sink: impl FnMut(R) -> Result<()>,
    ) -> Result<u64> {
        points.seek(run.first_row)?;
        let end = run.end_row.unwrap_or(u64::MAX).min(points.rows());
        // no more threads than there are chunks to compute
        let chunks = end.saturating_sub(run.first_row).div_ceil(CHUNK as u64).max(1);
        let threads = run.threads.min(usize::try_from(chunks).unwrap_or(usize::MAX));
        let is_stopped = || run.stop.is_some_and(|stop| stop.load(Ordering::Relaxed));
        let (mut row, mut done) = (run.first_row, run.first_row);
        let next = || {
            let mut values = Vec::with_capacity(CHUNK * self.kernel.parameters.len());
            let most = end.saturating_sub(row).min(CHUNK as u64) as usize;
            let rows = if is_stopped() || most == 0 { 0 } else { points.read(most, &mut values)? as u64 };
            let first_row = row;
            row += rows;
            Ok((rows > 0).then_some((first_row, rows, values)))
        };
        in_order(
            threads,
            next,
            |(first_row, rows, values)| (rows, work(self.kernel.evaluate(first_row, values))),
            |(rows, result)| {
                sink(result)?;
                done += rows;
                Ok(())
            },
        )?;
        Ok(done)
    }
}

/// Outcomes of the drives at all points, handed to `sink` in order, a block of at most [`CHUNK`] rows at a time.
/// Returns the row after the last one handed on.
///
/// # Errors
/// As [`Batch::new`] and [`Batch::run`]. A drive that does not fly is no error but has its [`Status`](super::Status).
pub fn simulate_batch(
    setup: &Setup<f64>,
    points: &mut dyn Points,
    of: &[Outcome],
    run: &Run<'_>,
    mut sink: impl FnMut(&Block) -> Result<()>,
) -> Result<u64> {
    of_batch(&Batch::new(setup, points.parameters(), of, &[])?, points, run, &mut sink)
}

/// As [`simulate_batch`], with the exact derivatives of every outcome by each parameter of `wrt`.
///
/// # Errors
/// As [`simulate_batch`]; [`Error::Nothing`] without parameters to differentiate by.
pub fn gradient_batch(
    setup: &Setup<f64>,
    points: &mut dyn Points,
    of: &[Outcome],
    wrt: &[&'static Parameter],
    run: &Run<'_>,
    mut sink: impl FnMut(&Block) -> Result<()>,
) -> Result<u64> {
    if wrt.is_empty() {
        return Err(Error::Nothing { doing: "differentiate by", what: "parameter" });
    }
    of_batch(&Batch::new(setup, points.parameters(), of, wrt)?, points, run, &mut sink)
}

/// Compiled once, whatever becomes of the blocks.
fn of_batch(
    batch: &Batch,
    points: &mut dyn Points,
    run: &Run<'_>,
    sink: &mut dyn FnMut(&Block) -> Result<()>,
) -> Result<u64> {
    batch.run(points, run, |block| block, |block| sink(&block))
}
