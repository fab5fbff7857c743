//! The points of a sweep as arrays. The numbers are exactly those of `longdrive sweep`.

use crate::boundary::{Answer, Failure, answer};
use crate::setup::PySetup;
use longdrive::batch::{CHUNK, Points};
use longdrive::command::{with_degrees, with_memory_files};
use longdrive::table::sweep_points;
use longdrive::units::{Message, System};
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::collections::HashMap;
use std::path::PathBuf;

/// The points by parameter, each parameter's name with the ends of its range, and notes on the
/// columns of a table.
type Plan<'py> = (
    Bound<'py, PyDict>,
    Vec<(&'static str, f64, f64)>,
    Vec<String>,
);

/// Returns the points as a dict of arrays, the range of each parameter, and notes on the table,
/// such as the columns that are not read. The time step is chosen for these ranges.
///
/// Parameters
/// ----------
/// setup
///     A setup, the name of a preset, or a dict.
/// over
///     Ranges, as ``longdrive sweep --over`` takes them; without counts if `sample` is given.
/// sample
///     The number of points of a quasi-random sequence.
/// seed
///     The seed of the sequence.
/// table
///     A table of points in place of ranges, a file on disk or in `files`.
/// files
///     Files in memory.
/// bare_angles
///     The angles in `over` that were given without a unit, rad.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "only longdrive.sweep calls it")]
pub fn plan<'py>(
    py: Python<'py>,
    setup: &Bound<'py, PyAny>,
    over: Vec<String>,
    sample: Option<u64>,
    seed: u32,
    table: Option<PathBuf>,
    files: HashMap<PathBuf, Vec<u8>>,
    bare_angles: Vec<f64>,
) -> PyResult<Plan<'py>> {
    answer(|| {
        let setup = PySetup::of(setup)?.setup;
        let files = files
            .into_iter()
            .map(|(name, content)| (name, content.into()))
            .collect();
        let read = || -> Answer<_> {
            let mut points = sweep_points(&setup, table.as_deref(), &over, sample, seed)?;
            let columns = columns(points.as_mut())?;
            Ok((points, columns))
        };
        let (points, columns) =
            with_memory_files(files, read).map_err(|failure| match failure {
                Failure::Longdrive(error) => with_degrees(*error, &bare_angles).into(),
                failure => failure,
            })?;
        let dict = PyDict::new(py);
        for (parameter, column) in points.parameters().iter().zip(columns) {
            dict.set_item(parameter.name, column.into_pyarray(py))?;
        }
        let ranges = points
            .ranges()
            .iter()
            .map(|vary| (vary.parameter.name, vary.low, vary.high))
            .collect();
        let notes = points.notes();
        let of_table = |note: &Message| format!("points: {}", note.in_units(System::default()));
        Ok((dict, ranges, notes.iter().map(of_table).collect()))
    })
}

/// All points, a column for each parameter.
fn columns(points: &mut dyn Points) -> Answer<Vec<Vec<f64>>> {
    let (width, rows) = (
        points.parameters().len(),
        usize::try_from(points.rows()).unwrap_or(usize::MAX),
    );
    let mut columns: Vec<Vec<f64>> = vec![vec![]; width];
    if columns
        .iter_mut()
        .any(|column| column.try_reserve_exact(rows).is_err())
    {
        let message = format!(
            "{rows} points do not fit into memory; give output=FILE, which is written as they are \
             computed"
        );
        return Err(Failure::Input(message));
    }
    let mut values = vec![];
    points.seek(0)?;
    while points.read(CHUNK, &mut values)? > 0 {
        for (k, value) in values.drain(..).enumerate() {
            columns[k % width].push(value);
        }
    }
    Ok(columns)
}
