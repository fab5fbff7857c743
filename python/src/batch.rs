//! Batches of drives at the points of arrays.

use crate::arrays::Arrays;
use crate::boundary::{Answer, Failure, answer};
use crate::hessians::Hessians;
use crate::names::{listed, outcomes_named, variables};
use crate::pool;
use crate::setup::PySetup;
use crate::step::{PyIntegration, step_choice};
use longdrive::batch::{Batch, Block, CHUNK, Points, Run, Status, StatusCounts};
use longdrive::drive::CheckScope;
use longdrive::parameters::Parameter;
use longdrive::parameters::Vary;
use longdrive::units::{System, ratio};
use longdrive::{Drive, Outcome, Setup};
use numpy::ndarray::{Array2, Array4};
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArray4};
use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

/// The status number of a drive that landed without a requested outcome or derivative: the first
/// number after the numbers of `longdrive::batch::Status`.
const UNDEFINED: i8 = Status::ALL.len() as i8;

/// The results of a batch, column after column.
struct Results {
    /// Number of allocated rows.
    room: usize,
    /// Number of computed rows.
    done: usize,
    /// Columns of `room` numbers each: first the points, then the outcomes, then the derivatives.
    columns: Vec<f64>,
    status: Vec<i8>,
    /// Hessians of the rows.
    hessians: Vec<f64>,
    status_counts: StatusCounts,
}

/// The results of a chunk.
struct Piece {
    columns: Vec<f64>,
    status: Vec<i8>,
    hessians: Vec<f64>,
    status_counts: StatusCounts,
}

impl Piece {
    fn of(block: &Block, width: usize, hessians: Option<&Hessians>) -> Self {
        let rows = block.rows();
        let mut status: Vec<i8> = (0..rows).map(|row| block.status(row) as i8).collect();
        let of_point = if rows > 0 { block.point(0).len() } else { 0 };
        let mut points = Vec::with_capacity(rows * (of_point + width));
        for k in 0..of_point {
            points.extend((0..rows).map(|row| block.point(row)[k]));
        }
        let mut columns = Vec::with_capacity(rows * width);
        for column in 0..width {
            columns.extend(block.result(column).map(|value| value.unwrap_or(f64::NAN)));
        }
        let mut seconds = vec![];
        if let Some(hessians) = hessians {
            seconds.reserve(rows * hessians.width());
            for row in 0..rows {
                match hessians.of_row(block, row) {
                    Some(found) => seconds.extend(found),
                    None => seconds.extend(std::iter::repeat_n(f64::NAN, hessians.width())),
                }
            }
        }
        for (row, status) in status
            .iter_mut()
            .enumerate()
            .filter(|(_, status)| **status == Status::Landed as i8)
        {
            let of_row = hessians.map_or(0, Hessians::width);
            let mut numbers = columns
                .iter()
                .skip(row)
                .step_by(rows)
                .chain(seconds.iter().skip(row * of_row).take(of_row));
            if numbers.any(|number| number.is_nan()) {
                *status = UNDEFINED;
            }
        }
        let mut status_counts = StatusCounts::default();
        status_counts.add(block);
        points.append(&mut columns);
        Self {
            columns: points,
            status,
            hessians: seconds,
            status_counts,
        }
    }
}

impl Results {
    /// Allocates memory for `room` rows, each with `width` numbers in the columns and
    /// `of_hessians` second derivatives.
    fn new(room: usize, width: usize, of_hessians: usize) -> Answer<Self> {
        let numbers = room.checked_mul(width).zip(room.checked_mul(of_hessians));
        let has_room = |numbers: usize| Vec::<f64>::new().try_reserve_exact(numbers).is_ok();
        let Some((of_columns, of_hessians)) =
            numbers.filter(|(one, two)| has_room(one.saturating_add(*two)))
        else {
            let message = format!(
                "{room} drives with {} numbers each do not fit into memory; compute fewer at a \
                 time, or let the program write them to a file (longdrive sweep)",
                width + of_hessians
            );
            return Err(Failure::Input(message));
        };
        // the system allocates the memory of these zeros only at the first access
        let (columns, hessians, status) =
            (vec![0.0; of_columns], vec![0.0; of_hessians], vec![0; room]);
        Ok(Self {
            room,
            done: 0,
            columns,
            status,
            hessians,
            status_counts: StatusCounts::default(),
        })
    }

    /// Appends a piece.
    fn take(&mut self, piece: &Piece) {
        let rows = piece.status.len();
        for (to, from) in self
            .columns
            .chunks_exact_mut(self.room.max(1))
            .zip(piece.columns.chunks_exact(rows))
        {
            to[self.done..self.done + rows].copy_from_slice(from);
        }
        self.status[self.done..self.done + rows].copy_from_slice(&piece.status);
        let width = piece.hessians.len() / rows;
        self.hessians[self.done * width..(self.done + rows) * width]
            .copy_from_slice(&piece.hessians);
        self.status_counts.merge(&piece.status_counts);
        self.done += rows;
    }
}

/// The state shared by the thread of Python and the computing threads.
struct Shared {
    results: Mutex<Option<Results>>,
    done: AtomicU64,
}

impl Shared {
    fn with<R>(&self, work: impl FnOnce(&mut Option<Results>) -> R) -> R {
        work(&mut self.results.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

/// The results for Python, in this order:
///
/// - status;
/// - columns: a row of the array for each point parameter, outcome and derivative;
/// - Hessians;
/// - names of the outcomes, of the parameters of the derivatives, and of the points' parameters;
/// - units of the columns;
/// - warnings;
/// - number of computed rows, and number of points;
/// - exception that ended the batch early.
///
/// After the computed rows, the arrays have space for the remaining points.
type Found<'py> = (
    Bound<'py, PyArray1<i8>>,
    Bound<'py, PyArray2<f64>>,
    Option<Bound<'py, PyArray4<f64>>>,
    Vec<&'static str>,
    Vec<&'static str>,
    Vec<&'static str>,
    Vec<String>,
    Vec<String>,
    (usize, usize),
    Option<PyErr>,
);

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
) -> PyResult<Found<'py>> {
    answer(|| {
        let setup = PySetup::of(setup)?;
        let of = outcomes_named(&listed("of", of)?)?;
        let mut arrays = Arrays::of(&setup.setup, points)?;
        let wrt = match wrt {
            None => vec![],
            Some(wrt) => by_names(&setup, &arrays, wrt)?,
        };
        if first_row > arrays.len()
            || (!first_row.is_multiple_of(CHUNK) && first_row != arrays.len())
        {
            let message = format!(
                "first_row = {first_row}; expected a multiple of {CHUNK} up to the {} rows, as a \
                 table that was interrupted ends with",
                arrays.len()
            );
            return Err(Failure::Input(message));
        }
        let given: Vec<_> = arrays.parameters().iter().map(|row| row.name).collect();
        setup.setup.refuse_replaced(&given)?;
        let (whole, rows) = (arrays.len(), arrays.len().saturating_sub(first_row));
        let width = arrays.parameters().len() + of.len() * (1 + wrt.len());
        let of_hessians = if hessians {
            of.len() * wrt.len() * wrt.len()
        } else {
            0
        };
        let choice = step_choice(tolerance, own_step)?;
        let chosen = function.map(|function| Arc::clone(&function.0));
        let shared = Arc::new(Shared {
            results: Mutex::new(Some(Results::new(rows, width, of_hessians)?)),
            done: AtomicU64::new(0),
        });
        // the values are examined last: this takes long, and the allocation above may fail
        arrays.look(py, ranges.is_none())?;
        let ranges = match ranges {
            None => arrays.ranges(),
            Some(given) => given_ranges(&setup, &given)?,
        };
        let shape = (of.len(), wrt.len());
        let (units, in_degrees) = (units(&arrays, &of, &wrt), arrays.in_degrees());
        let names = (
            of.iter().map(|of| of.name()).collect(),
            wrt.iter().map(|row| row.name).collect(),
            given,
        );
        let parameters = arrays.parameters().to_vec();
        let (to, sought) = (Arc::clone(&shared), of.clone());
        let flown = function.map_or(setup.setup, |function| function.0.setup);
        let is_known = function.is_some() || choice.is_own(&flown);
        let is_short = rows <= CHUNK && !hessians && !pool::is_long(&flown, rows);
        let own = setup.setup;
        let work = move |stop: &AtomicBool| -> longdrive::Result<Vec<String>> {
            let integration = match chosen {
                Some(chosen) => chosen,
                None => Arc::new(choice.for_ranges(&setup.setup, &ranges, &sought, stop)?),
            };
            let batch = integration.batch(arrays.parameters(), &sought, &wrt)?;
            let seconds = hessians
                .then(|| Hessians::new(&integration, arrays.parameters(), &sought, &wrt))
                .transpose()?;
            compute(
                &batch,
                arrays,
                seconds.as_ref(),
                first_row,
                threads,
                stop,
                &to,
            )?;
            Ok(setup
                .setup
                .warnings()
                .iter()
                .chain(&integration.warning)
                .map(|message| message.in_units(System::default()))
                .collect())
        };
        let total = rows;
        let watch = || match progress {
            Some(progress) => progress
                .call1((shared.done.load(Ordering::Relaxed), total))
                .map(|_| ()),
            None => Ok(()),
        };
        // compute a few drives without threads: they take less time than a check for Ctrl-C
        let ended = if is_short && is_known {
            py.detach(|| work(&AtomicBool::new(false)))
                .map_err(Failure::from)
        } else {
            pool::run(py, work, watch).and_then(|done| Ok(done?))
        };
        let (mut warnings, mut raised) = match ended {
            Ok(warnings) => (warnings, None),
            Err(Failure::Python(raised)) => (vec![], Some(raised)),
            Err(other) => return Err(other),
        };
        if let (Some(progress), None, true) = (progress, &raised, total > 0) {
            // a Ctrl-C in this call does not discard the rows
            raised = progress.call1((total, total)).err();
        }
        let results = shared
            .with(Option::take)
            .ok_or_else(|| Failure::Panic("a batch without results".into()))?;
        let done = results.done;
        let beyond = results.status_counts.exceeded().warnings(
            &own.law,
            ["drive that landed", "drives that landed"],
            CheckScope::Launch,
        );
        warnings.extend(
            beyond
                .iter()
                .map(|message| message.in_units(System::default())),
        );
        let is_whole = raised.is_none();
        if is_whole && first_row == 0 && !results.status_counts.has_any(&of) {
            warnings.push(none(&own, &parameters, &results, &of));
        }
        warnings.extend(in_degrees);
        let (of_names, wrt, given) = names;
        let (status, columns, seconds) = moved(py, results, width, shape, hessians)?;
        Ok((
            status,
            columns,
            seconds,
            of_names,
            wrt,
            given,
            units,
            warnings,
            (done, whole),
            raised,
        ))
    })
}

/// The warning of a batch in which no drive has a requested outcome: the number of drives by
/// status, and the reason for row 0.
fn none(
    setup: &Setup<f64>,
    parameters: &[&'static Parameter],
    results: &Results,
    of: &[Outcome],
) -> String {
    let which = if of.len() == 1 {
        "the requested outcome"
    } else {
        "any of the requested outcomes"
    };
    let why = (|| {
        let mut first = *setup;
        for (parameter, column) in parameters
            .iter()
            .zip(results.columns.chunks_exact(results.room.max(1)))
        {
            if column[0].is_nan() {
                return Err(format!("{} is NaN", parameter.name));
            }
            first
                .set_value(parameter, Some(column[0]))
                .map_err(|error| error.to_string())?;
        }
        let drive = Drive::new(&first).map_err(|error| error.to_string())?;
        drive.landed().map(drop).map_err(|error| error.to_string())
    })();
    let why = why
        .err()
        .map_or(String::new(), |why| format!("; row 0: {why}"));
    format!("no drive has {which}: {}{why}", results.status_counts)
}

/// The ranges for which a sweep chooses its step, from the names and ends in `given`. The points
/// may cover only a part of these ranges.
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
    arrays: &Arrays,
    wrt: &Bound<'_, PyAny>,
) -> Answer<Vec<&'static Parameter>> {
    let names = listed("wrt", wrt)?;
    let of_points = arrays.parameters();
    if names == ["points"] {
        return Ok(of_points.to_vec());
    }
    // a parameter of the points may have no value in `setup`
    let is_of_points = |name: &String| of_points.iter().any(|row| row.name == name);
    if names.iter().any(is_of_points) {
        let mut rows = vec![];
        for name in &names {
            let found = of_points.iter().find(|row| row.name == name).copied();
            let row = match found {
                Some(row) => row,
                None => setup.setup.variable(name)?,
            };
            if rows.contains(&row) {
                return Err(Failure::Input(format!(
                    "wrt names '{name}' twice; keep one"
                )));
            }
            rows.push(row);
        }
        return Ok(rows);
    }
    variables(&setup.setup, Some(wrt))
}

/// The SI units of the points' parameters, the outcomes and the derivatives.
fn units(arrays: &Arrays, of: &[Outcome], wrt: &[&'static Parameter]) -> Vec<String> {
    let points = arrays
        .parameters()
        .iter()
        .map(|row| row.quantity.si.to_owned());
    let outcomes = of.iter().map(|of| of.quantity().si.to_owned());
    let derivatives = of.iter().flat_map(|of| {
        wrt.iter()
            .map(|row| ratio(of.quantity().si, row.quantity.si))
    });
    points.chain(outcomes).chain(derivatives).collect()
}

/// Computes the rows and appends them to the results in `to`. Rows that are computed after Python
/// took the results are dropped.
fn compute(
    batch: &Batch,
    mut arrays: Arrays,
    hessians: Option<&Hessians>,
    first_row: usize,
    threads: usize,
    stop: &AtomicBool,
    to: &Shared,
) -> longdrive::Result<()> {
    let width = batch.outcomes().len() * (1 + batch.wrt().len());
    let piece = |block: Block| Piece::of(&block, width, hessians);
    let sink = |piece: Piece| {
        to.with(|results| {
            if let Some(results) = results {
                results.take(&piece);
                to.done.store(results.done as u64, Ordering::Relaxed);
            }
        });
        Ok(())
    };
    let run = Run {
        first_row: first_row as u64,
        threads,
        stop: Some(stop),
        ..Run::default()
    };
    if arrays.len() - first_row > CHUNK {
        batch.run(&mut arrays, &run, piece, sink)?;
        return Ok(());
    }
    // a single chunk needs no other threads
    arrays.seek(run.first_row)?;
    let mut values = vec![];
    match arrays.read(CHUNK, &mut values)? {
        0 => Ok(()),
        _ => batch
            .evaluate_until(run.first_row, values, stop)
            .map_or(Ok(()), |block| sink(piece(block))),
    }
}

/// Status, columns and Hessians.
type Moved<'py> = (
    Bound<'py, PyArray1<i8>>,
    Bound<'py, PyArray2<f64>>,
    Option<Bound<'py, PyArray4<f64>>>,
);

/// Moves the results into arrays of NumPy without a copy.
fn moved(
    py: Python<'_>,
    results: Results,
    width: usize,
    (of, wrt): (usize, usize),
    hessians: bool,
) -> Answer<Moved<'_>> {
    let rows = results.room;
    let columns = shaped(Array2::from_shape_vec((width, rows), results.columns))?.into_pyarray(py);
    let seconds = hessians.then(|| {
        shaped(Array4::from_shape_vec(
            (rows, of, wrt, wrt),
            results.hessians,
        ))
    });
    let seconds = seconds.transpose()?.map(|array| array.into_pyarray(py));
    Ok((results.status.into_pyarray(py), columns, seconds))
}

fn shaped<T>(array: Result<T, numpy::ndarray::ShapeError>) -> Answer<T> {
    array.map_err(|error| Failure::Panic(format!("the arrays of a batch: {error}")))
}
