use super::block::Block;
use super::in_order::in_order;
use super::instructions::Instructions;
use super::points::Points;
use super::question::Kernel;
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::number::Level;
use crate::parameters::{NO_CLUB, Parameter, Setup, refuse_twice};
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
    /// [`Error::NotVariable`], [`Error::Unknown`] and [`Error::OtherLaw`] as [`Setup::variable`], also for a coefficient of another law of the
    /// same name; [`Error::SearchRange`] and [`Error::Together`] for a parameter given twice.
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
        super::points::refuse_repeated(parameters)?;
        for parameter in parameters {
            setup.check_column(parameter)?;
        }
        for parameter in wrt.iter().filter(|parameter| !parameters.contains(parameter)) {
            setup.check_variable(parameter)?;
        }
        refuse_twice(wrt)?;
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
    /// in the shortest has the status `diverged`. Infinity keeps the setup's own step, as does a batch that has not been given any.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for NaN, 0 and below, which no drive meets.
    pub fn with_largest_defect(mut self, defect: f64) -> Result<Self> {
        if defect > 0.0 {
            self.kernel.largest_defect = defect;
            return Ok(self);
        }
        Err(Error::OutOfRange {
            name: "the largest defect of a drive".into(),
            value: format!("{defect} m"),
            range: "0 m < …".into(),
            advice: "take that of study::accuracy, or infinity for the setup's own step".into(),
        })
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
    ///
    /// # Panics
    /// Where the points are not whole: where the number of their values is no multiple of the number of the swept parameters.
    pub fn evaluate(&self, first_row: u64, points: Vec<f64>) -> Block {
        let (values, parameters) = (points.len(), self.kernel.parameters.len());
        assert!(
            values.is_multiple_of(parameters),
            "points of {parameters} parameters need a multiple of {parameters} values; there are {values}"
        );
        self.kernel.evaluate(first_row, points)
    }

    /// Computes the drives of all points. Each block goes through `work` on the thread that computed it, and what that
    /// makes of it to `sink`, in the order of the points. Returns the row after the last one handed on: the number of
    /// points or the end that was asked for, unless it was stopped; `run.first_row` where none was, as there is no point from there on.
    ///
    /// # Errors
    /// [`Error::Together`] for points of other parameters than those of the batch, or in another order, and for points whose
    /// [`read`](Points::read) does not append as many values as the rows it tells of have, or more rows than it was asked for; what `points`
    /// and `sink` return. Rows before an unreadable point are handed on first.
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
        // no more threads than there are chunks to compute
        let chunks = end.saturating_sub(run.first_row).div_ceil(CHUNK as u64).max(1);
        let threads = run.threads.min(usize::try_from(chunks).unwrap_or(usize::MAX));
        let is_stopped = || run.stop.is_some_and(|stop| stop.load(Ordering::Relaxed));
        let (mut row, mut done) = (run.first_row, run.first_row);
        let next = || {
            let mut values = Vec::with_capacity(CHUNK * self.kernel.parameters.len());
            let most = end.saturating_sub(row).min(CHUNK as u64) as usize;
            let rows = if is_stopped() || most == 0 { 0 } else { points.read(most, &mut values)? };
            self.check_chunk(rows, most, values.len())?;
            let (first_row, rows) = (row, rows as u64);
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

    /// Whether points are of the swept parameters, in their order.
    fn check_parameters(&self, of_points: &[&'static Parameter]) -> Result<()> {
        if of_points == self.parameters() {
            return Ok(());
        }
        let named = |all: &[&'static Parameter]| all.iter().map(|one| one.name).collect::<Vec<_>>().join(", ");
        let given = format!("points of {}", named(of_points));
        let reason = format!("the batch is of {}; give points of these, in this order", named(self.parameters()));
        Err(Error::Together { given, reason })
    }

    /// Whether so many rows, of which there were to be `most`, have so many values.
    fn check_chunk(&self, rows: usize, most: usize, values: usize) -> Result<()> {
        let parameters = self.parameters().len();
        if rows <= most && Some(values) == rows.checked_mul(parameters) {
            return Ok(());
        }
        let given = format!("Points::read, asked for at most {most} rows, tells of {rows} and appends {values} values");
        let reason = format!("it must append {parameters} values for each row, and no more rows than asked for");
        Err(Error::Together { given, reason })
    }
}

/// Outcomes of the drives at all points, handed to `sink` in order, a block of at most [`CHUNK`] rows at a time.
/// Returns the row after the last one handed on, or `run.first_row` where there was none. The drives are integrated as the setup says:
/// [`accuracy`](crate::study::accuracy()) finds method and step for a stated error.
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
