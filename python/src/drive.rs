//! One drive.

use crate::boundary::{Answer, answer};
use crate::json::to_python;
use crate::names::{listed, outcomes_named};
use crate::setup::PySetup;
use longdrive::flight::{TrajectoryPoint, trajectory};
use longdrive::number::Vector;
use longdrive::report::{DriveReport, Reply};
use longdrive::{Drive, Error, Outcome, Setup};
use numpy::ndarray::Array2;
use numpy::{IntoPyArray, PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// A trajectory as arrays: time, position, velocity, spin.
type Path<'py> = (
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
);

/// A drive: its outcomes by name, SI (None for an outcome without a value); the answer of
/// ``longdrive simulate --json``; and its path, if it was requested and the ball flies.
type Simulated<'py> = (Bound<'py, PyDict>, Bound<'py, PyAny>, Option<Path<'py>>);

/// One drive; see :func:`longdrive.simulate`.
#[pyfunction]
#[pyo3(signature = (setup, of, is_traced))]
pub fn simulate<'py>(
    py: Python<'py>,
    setup: Option<&Bound<'py, PyAny>>,
    of: Option<&Bound<'py, PyAny>>,
    is_traced: bool,
) -> PyResult<Simulated<'py>> {
    answer(|| {
        let of = of.map_or_else(
            || Ok(Outcome::ALL.to_vec()),
            |of| outcomes_named(&listed("of", of)?),
        )?;
        let setup = PySetup::of_any(setup)?.setup;
        setup.validate()?;
        let drive = Drive::new(&setup)?;
        let outcomes = PyDict::new(py);
        for outcome in &of {
            outcomes.set_item(outcome.name(), outcome.value(&drive))?;
        }
        let warnings = drive.warnings_about(&setup, &of);
        let report = to_python(py, &Reply::of(DriveReport::new(&setup, &drive), warnings))?;
        let path = match is_traced {
            true => path(py, &setup, &drive)?,
            false => None,
        };
        Ok((outcomes, report, path))
    })
}

/// The path of the ball; `None` for a ball that does not fly.
fn path<'py>(py: Python<'py>, setup: &Setup<f64>, drive: &Drive<f64>) -> Answer<Option<Path<'py>>> {
    let points = match trajectory(setup, &drive.launch) {
        // the ball leaves the face downwards
        Ok(trajectory) if trajectory.points.len() < 2 => return Ok(None),
        Ok(trajectory) => trajectory.points,
        Err(Error::NoFlight { .. }) => return Ok(None),
        Err(error) => return Err(error.into()),
    };
    let vectors = |of: fn(&TrajectoryPoint) -> Vector<f64>| {
        Array2::from_shape_fn((points.len(), 3), |(row, axis)| {
            let vector = of(&points[row]);
            [vector.x, vector.y, vector.z][axis]
        })
        .into_pyarray(py)
    };
    let time: Vec<f64> = points.iter().map(|point| point.time).collect();
    Ok(Some((
        time.into_pyarray(py),
        vectors(|point| point.position),
        vectors(|point| point.velocity),
        vectors(|point| point.spin),
    )))
}
