//! The points of a sweep as arrays: those of `longdrive sweep`, number for number.

use crate::boundary::{Answer, Failure, answer};
use crate::setup::PySetup;
use longdrive::batch::{Axis, CHUNK, Grid, Points, Sequence};
use longdrive::parameters::Vary;
use longdrive::table::open_table;
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;

/// Points by parameter, and the names of the parameters with the ends of their ranges.
type Plan<'py> = (Bound<'py, PyDict>, Vec<(&'static str, f64, f64)>);

/// The points as a dict of arrays, and the range of each parameter that the step is chosen for.
///
/// Args:
///     setup: a setup, the name of a preset, or a dict.
///     over: ranges, as ``longdrive sweep --over`` has them; with `sample` without counts.
///     sample: so many points of a quasi-random sequence.
///     seed: another seed gives other points.
///     file: a table of points in their place.
#[pyfunction]
pub fn plan<'py>(
    py: Python<'py>,
    setup: &Bound<'py, PyAny>,
    over: Vec<String>,
    sample: Option<u64>,
    seed: u32,
    file: Option<PathBuf>,
) -> PyResult<Plan<'py>> {
    answer(|| {
        let setup = PySetup::of(setup)?.setup;
        let mut points: Box<dyn Points> = match (file, sample) {
            (Some(file), _) => open_table(&setup, &file)?,
            (None, Some(rows)) => {
                let ranges = over.iter().map(|text| Vary::read_column(&setup, text));
                Box::new(Sequence::new(
                    ranges.collect::<longdrive::Result<_>>()?,
                    rows,
                    seed,
                )?)
            }
            (None, None) => {
                let axes = over.iter().map(|text| Axis::read(&setup, text));
                Box::new(Grid::new(axes.collect::<longdrive::Result<_>>()?)?)
            }
        };
        let columns = columns(points.as_mut())?;
        let dict = PyDict::new(py);
        for (parameter, column) in points.parameters().iter().zip(columns) {
            dict.set_item(parameter.name, column.into_pyarray(py))?;
        }
        let ranges = points
            .ranges()
            .iter()
            .map(|vary| (vary.parameter.name, vary.low, vary.high))
            .collect();
        Ok((dict, ranges))
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
