//! Batches of drives at points from arrays.

use crate::arrays::Arrays;
use crate::boundary::{Answer, Failure, answer};
use crate::hessians::Hessians;
use crate::names::{listed, outcomes_named, refuse_repeated, variables};
use crate::pool;
use crate::results::Results;
use crate::setup::PySetup;
use crate::step::{PyIntegration, step_choice};
use longdrive::batch::{Batch, Block, CHUNK, Points, Run};
use longdrive::integration::{Integration, StepChoice};
use longdrive::parameters::{Parameter, Vary};
use longdrive::units::{Message, System, ratio};
use longdrive::{Drive, Outcome, Setup};
use numpy::ndarray::{Array2, Array4, ShapeError};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArray4};
use pyo3::exceptions::PyBaseException;
use pyo3::prelude::*;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex};

/// The drives of a batch, without the values of the points.
#[derive(Clone)]
struct Request {
    setup: Setup<f64>,
    /// Parameters of the points.
    points: Vec<&'static Parameter>,
    of: Vec<Outcome>,
    wrt: Vec<&'static Parameter>,
    /// True if second derivatives are requested.
    has_hessians: bool,
}

impl Request {
    /// Number of outcomes and first derivatives of a row.
    fn width(&self) -> usize {
        self.of.len() * (1 + self.wrt.len())
    }

    /// Allocates memory for the results of `rows` rows.
    fn results(&self, rows: usize) -> Answer<Results> {
        let of_hessians = if self.has_hessians {
            self.of.len() * self.wrt.len() * self.wrt.len()
        } else {
            0
        };
        Results::new(rows, self.points.len() + self.width(), of_hessians)
    }

    /// The SI units of the points' parameters, the outcomes and the derivatives.
    fn units(&self) -> Vec<String> {
        let points = self.points.iter().map(|row| row.quantity.si.to_owned());
        let outcomes = self.of.iter().map(|of| of.quantity().si.to_owned());
        let derivatives = self.of.iter().flat_map(|of| {
            self.wrt
                .iter()
                .map(|row| ratio(of.quantity().si, row.quantity.si))
        });
        points.chain(outcomes).chain(derivatives).collect()
    }

    /// The results for Python. The arrays are moved, not copied.
    fn result(
        self,
        py: Python<'_>,
        results: Results,
        warnings: Vec<String>,
        rows: usize,
        raised: Option<PyErr>,
    ) -> Answer<BatchResult> {
        let (of, wrt, room) = (self.of.len(), self.wrt.len(), results.room);
        let shape = (self.points.len() + self.width(), room);
        let columns = shaped(Array2::from_shape_vec(shape, results.columns))?;
        let shape = (room, of, wrt, wrt);
        let hessians = self
            .has_hessians
            .then(|| shaped(Array4::from_shape_vec(shape, results.hessians)))
            .transpose()?;
        Ok(BatchResult {
            status: results.status.into_pyarray(py).unbind(),
            columns: columns.into_pyarray(py).unbind(),
            hessians: hessians.map(|array| array.into_pyarray(py).unbind()),
            of: self.of.iter().map(|of| of.name()).collect(),
            wrt: names(&self.wrt),
            parameters: names(&self.points),
            units: self.units(),
            warnings,
            done: results.done,
            rows,
            raised: raised.map(|error| error.into_value(py)),
        })
    }

    /// The warnings about the drives. `is_whole` is true if every row was computed.
    fn warnings(&self, results: &Results, is_whole: bool) -> Vec<String> {
        let exceeded = results.status_counts.warnings(&self.setup.law);
        let mut warnings = in_units(&exceeded);
        if is_whole && !results.status_counts.has_any(&self.of) {
            warnings.push(self.without_outcomes(results));
        }
        warnings
    }

    /// The warning of a batch without any requested outcome: the number of drives by status, and
    /// the reason for row 0.
    fn without_outcomes(&self, results: &Results) -> String {
        let which = if self.of.len() == 1 {
            "the requested outcome"
        } else {
            "any of the requested outcomes"
        };
        let why = self
            .first_drive(results)
            .err()
            .map_or(String::new(), |why| format!("; row 0: {why}"));
        format!("no drive has {which}: {}{why}", results.status_counts)
    }

    /// Computes the drive of row 0 again.
    ///
    /// # Errors
    /// The reason why it has no landing.
    fn first_drive(&self, results: &Results) -> Result<(), String> {
        let text = |error: longdrive::Error| error.to_string();
        let mut first = self.setup;
        let columns = results.columns.chunks_exact(results.room.max(1));
        for (parameter, column) in self.points.iter().zip(columns) {
            if column[0].is_nan() {
                return Err(format!("{} is NaN", parameter.name));
            }
            first.set_value(parameter, Some(column[0])).map_err(text)?;
        }
        let drive = Drive::new(&first).map_err(text)?;
        drive.landed().map(drop).map_err(text)
    }
}

/// A batch for Python.
#[pyclass(get_all, frozen, module = "longdrive._longdrive")]
pub struct BatchResult {
    /// Status of each row of the table. After an interruption, only the first `done` rows of the
    /// table are results, in this array, `columns` and `hessians`.
    status: Py<PyArray1<i8>>,
    /// The table, transposed: each row of this array is a column of the table. The columns are the
    /// parameters of the points, the outcomes, and the derivatives.
    columns: Py<PyArray2<f64>>,
    /// Second derivatives, shape (rows, outcomes, parameters, parameters); None if not requested.
    hessians: Option<Py<PyArray4<f64>>>,
    /// Names of the outcomes.
    of: Vec<&'static str>,
    /// Names of the parameters of the derivatives.
    wrt: Vec<&'static str>,
    /// Names of the parameters of the points.
    parameters: Vec<&'static str>,
    /// Units of the columns.
    units: Vec<String>,
    warnings: Vec<String>,
    /// Number of computed rows.
    done: usize,
    /// Number of points.
    rows: usize,
    /// The exception that ended the batch early.
    raised: Option<Py<PyBaseException>>,
}

/// The computation of a batch.
struct Work {
    request: Request,
    arrays: Arrays,
    first_row: usize,
    threads: usize,
    choice: StepChoice,
    /// Ranges of the parameters for which `choice` chooses method and step.
    ranges: Vec<Vary>,
    /// Method and step, if they were chosen before.
    chosen: Option<Arc<Integration>>,
    /// The results; `None` once Python has taken them.
    to: Arc<Mutex<Option<Results>>>,
}

impl Work {
    fn rows(&self) -> usize {
        self.arrays.len() - self.first_row
    }

    /// True if the step is known and the drives are few: then Python need not check for Ctrl-C
    /// while they are computed.
    fn is_short(&self) -> bool {
        let chosen = self.chosen.as_ref();
        let setup = chosen.map_or(&self.request.setup, |chosen| &chosen.setup);
        let is_known = chosen.is_some() || self.choice.is_own(setup);
        let rows = self.rows();
        is_known && rows <= CHUNK && !self.request.has_hessians && !pool::is_long(setup, rows)
    }

    /// Runs the work, and returns the warnings about the setup and the step. Long work runs on
    /// other threads.
    fn run(self, py: Python<'_>, progress: Option<&Bound<'_, PyAny>>) -> Answer<Vec<String>> {
        if self.is_short() {
            return Ok(py.detach(|| self.compute(&AtomicBool::new(false)))?);
        }
        let (rows, to) = (self.rows(), Arc::clone(&self.to));
        let watch = || {
            let Some(progress) = progress else {
                return Ok(());
            };
            let done = pool::lock(&to).as_ref().map_or(0, |results| results.done);
            progress.call1((done, rows)).map(drop)
        };
        Ok(pool::run(py, move |stop| self.compute(stop), watch)??)
    }

    fn compute(self, stop: &AtomicBool) -> longdrive::Result<Vec<String>> {
        let Request {
            setup,
            points,
            of,
            wrt,
            has_hessians,
        } = &self.request;
        let integration = match &self.chosen {
            Some(chosen) => Arc::clone(chosen),
            None => Arc::new(self.choice.for_ranges(setup, &self.ranges, of, stop)?),
        };
        let batch = integration.batch(points, of, wrt)?;
        let hessians = has_hessians
            .then(|| Hessians::new(&integration, points, of, wrt))
            .transpose()?;
        let warnings = setup.warnings();
        self.fill(&batch, hessians.as_ref(), stop)?;
        Ok(in_units(warnings.iter().chain(&integration.warning)))
    }

    /// Computes the rows, and appends them to the shared results. Rows are dropped if Python has
    /// already taken the results.
    fn fill(
        mut self,
        batch: &Batch,
        hessians: Option<&Hessians>,
        stop: &AtomicBool,
    ) -> longdrive::Result<()> {
        let width = self.request.width();
        let chunk = |block: Block| Results::of_chunk(&block, width, hessians);
        let to = Arc::clone(&self.to);
        let append = |chunk: &Results| {
            if let Some(results) = pool::lock(&to).as_mut() {
                results.append(chunk);
            }
        };
        let run = Run {
            first_row: self.first_row as u64,
            threads: self.threads,
            stop: Some(stop),
            ..Run::default()
        };
        if self.rows() > CHUNK {
            let sink = |chunk: Results| {
                append(&chunk);
                Ok(())
            };
            batch.run(&mut self.arrays, &run, chunk, sink)?;
            return Ok(());
        }
        // all rows in one chunk: this thread computes them alone
        self.arrays.seek(run.first_row)?;
        let mut values = vec![];
        if self.arrays.read(CHUNK, &mut values)? == 0 {
            return Ok(());
        }
        if let Some(block) = batch.evaluate_until(run.first_row, values, stop) {
            append(&chunk(block));
        }
        Ok(())
    }
}

/// The drives at the points of arrays; see :func:`longdrive.batch`.
#[pyfunction]
#[pyo3(
    signature = (setup, points, of, wrt, tolerance, own_step, threads, progress, first_row, hessians, ranges = None, function = None),
)]
#[expect(
    clippy::too_many_arguments,
    reason = "only longdrive.batch calls this function, and with all arguments"
)]
pub fn batch<'py>(
    py: Python<'py>,
    setup: &Bound<'py, PyAny>,
    points: &Bound<'py, PyAny>,
    of: &Bound<'py, PyAny>,
    wrt: Option<&Bound<'py, PyAny>>,
    tolerance: Option<&Bound<'py, PyAny>>,
    own_step: bool,
    threads: usize,
    progress: Option<&Bound<'py, PyAny>>,
    first_row: usize,
    hessians: bool,
    ranges: Option<Vec<(String, f64, f64)>>,
    function: Option<&PyIntegration>,
) -> PyResult<BatchResult> {
    answer(|| {
        let setup = PySetup::of(setup)?;
        let of = outcomes_named(&listed("of", of)?)?;
        let mut arrays = Arrays::of(&setup.setup, points)?;
        let wrt = match wrt {
            None => vec![],
            Some(wrt) => by_names(&setup, &of, &arrays, wrt)?,
        };
        let request = Request {
            setup: setup.setup,
            points: arrays.parameters().to_vec(),
            of,
            wrt,
            has_hessians: hessians,
        };
        refuse_first_row(first_row, arrays.len())?;
        setup.setup.refuse_replaced(&names(&request.points))?;
        let choice = step_choice(tolerance, own_step)?;
        let results = request.results(arrays.len() - first_row)?;
        let shared = Arc::new(Mutex::new(Some(results)));
        // scan the values only after the allocation has succeeded, because the scan takes long
        arrays.scan(py, ranges.is_none())?;
        let (whole, in_degrees) = (arrays.len(), arrays.in_degrees());
        let work = Work {
            ranges: match ranges {
                None => arrays.ranges(),
                Some(given) => given_ranges(&setup, &given)?,
            },
            request: request.clone(),
            arrays,
            first_row,
            threads,
            choice,
            chosen: function.map(|function| Arc::clone(&function.0)),
            to: Arc::clone(&shared),
        };
        let rows = work.rows();
        let (mut warnings, mut raised) = match work.run(py, progress) {
            Ok(warnings) => (warnings, None),
            Err(Failure::Python(raised)) => (vec![], Some(raised)),
            Err(other) => return Err(other),
        };
        if let (Some(progress), None, true) = (progress, &raised, rows > 0) {
            // Ctrl-C in this call does not discard the rows
            raised = progress.call1((rows, rows)).err();
        }
        let results = pool::lock(&shared)
            .take()
            .ok_or_else(|| Failure::Internal("a batch without results".into()))?;
        warnings.extend(request.warnings(&results, raised.is_none() && first_row == 0));
        warnings.extend(in_degrees);
        request.result(py, results, warnings, whole, raised)
    })
}

/// Refuses a first row that does not begin a chunk.
fn refuse_first_row(first_row: usize, rows: usize) -> Answer<()> {
    if first_row == rows || (first_row < rows && first_row.is_multiple_of(CHUNK)) {
        return Ok(());
    }
    Err(Failure::Input(format!(
        "first_row = {first_row}; expected a multiple of {CHUNK} up to the {rows} rows: the number \
         of rows of an interrupted table"
    )))
}

/// The ranges for which a sweep chooses its step, from names and ends in `given`. A part of a sweep
/// has the ranges of the whole sweep, although its own points may cover less.
fn given_ranges(setup: &PySetup, given: &[(String, f64, f64)]) -> Answer<Vec<Vary>> {
    let range = |(name, low, high): &(String, f64, f64)| {
        Ok(Vary {
            parameter: setup.setup.column(name)?,
            low: *low,
            high: *high,
        })
    };
    given.iter().map(range).collect()
}

/// The parameters to differentiate by; the name "points" stands for the parameters of the points.
fn by_names(
    setup: &PySetup,
    of: &[Outcome],
    arrays: &Arrays,
    wrt: &Bound<'_, PyAny>,
) -> Answer<Vec<&'static Parameter>> {
    let names = listed("wrt", wrt)?;
    let of_points = arrays.parameters();
    if names == ["points"] {
        return Ok(of_points.to_vec());
    }
    let of_point = |name: &String| of_points.iter().find(|row| row.name == name).copied();
    if !names.iter().any(|name| of_point(name).is_some()) {
        return variables(&setup.setup, of, Some(wrt));
    }
    refuse_repeated("wrt", names.iter().map(String::as_str))?;
    // a parameter of the points need not have a value in the setup
    let row = |name: &String| of_point(name).map_or_else(|| setup.setup.variable(name), Ok);
    Ok(names.iter().map(row).collect::<longdrive::Result<_>>()?)
}

fn names(parameters: &[&'static Parameter]) -> Vec<&'static str> {
    parameters.iter().map(|row| row.name).collect()
}

/// Messages as texts.
pub fn in_units<'a>(messages: impl IntoIterator<Item = &'a Message>) -> Vec<String> {
    let in_units = |message: &Message| message.in_units(System::default());
    messages.into_iter().map(in_units).collect()
}

fn shaped<T>(array: Result<T, ShapeError>) -> Answer<T> {
    array.map_err(|error| Failure::Internal(format!("the arrays of a batch: {error}")))
}
