//! One drive.

use crate::batch::in_units;
use crate::boundary::answer;
use crate::json::to_python;
use crate::names::{listed, outcomes_named};
use crate::pool;
use crate::setup::PySetup;
use crate::step::step_choice;
use longdrive::flight::{Trajectory, TrajectoryPoint, trajectory_until};
use longdrive::number::Vector;
use longdrive::report::{DriveReport, Reply};
use longdrive::units::Message;
use longdrive::{Drive, Error, Outcome, Setup};
use numpy::ndarray::Array2;
use numpy::{IntoPyArray, PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::atomic::AtomicBool;

/// A trajectory as arrays: time, position, velocity, spin.
type Path<'py> = (
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
    Bound<'py, PyArray2<f64>>,
);

/// One drive; see :func:`longdrive.simulate`. The report is computed only on request, because it
/// takes longer than the drive.
#[pyclass(name = "Simulated", module = "longdrive._longdrive", frozen)]
pub struct PySimulated {
    setup: Setup<f64>,
    drive: Drive<f64>,
    of: Vec<Outcome>,
    warnings: Vec<Message>,
    trajectory: Option<Trajectory>,
}

#[pymethods]
impl PySimulated {
    /// The outcomes by name, SI; None for an outcome without a value.
    #[getter]
    fn outcomes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let outcomes = PyDict::new(py);
        for outcome in &self.of {
            outcomes.set_item(outcome.name(), outcome.value(&self.drive))?;
        }
        Ok(outcomes)
    }

    /// The warnings, a list of sentences.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        in_units(&self.warnings)
    }

    /// The answer of ``longdrive simulate --json``.
    fn report<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        answer(|| {
            let report = DriveReport::new(&self.setup, &self.drive);
            to_python(py, &Reply::of(&report, self.warnings.clone()))
        })
    }

    /// The path of the ball, if it was requested and the ball flies.
    #[getter]
    fn path<'py>(&self, py: Python<'py>) -> Option<Path<'py>> {
        self.trajectory
            .as_ref()
            .map(|trajectory| path(py, trajectory))
    }
}

/// One drive; see :func:`longdrive.simulate`. `warnings` are those about the setup of the call.
#[pyfunction]
#[pyo3(signature = (setup, of, is_traced, tolerance, own_step, warnings))]
pub fn simulate<'py>(
    py: Python<'py>,
    setup: Option<&Bound<'py, PyAny>>,
    of: Option<&Bound<'py, PyAny>>,
    is_traced: bool,
    tolerance: Option<&Bound<'py, PyAny>>,
    own_step: bool,
    warnings: Vec<String>,
) -> PyResult<PySimulated> {
    answer(|| {
        let of = of.map_or_else(
            || Ok(Outcome::OF_DRIVES.to_vec()),
            |of| outcomes_named(&listed("of", of)?),
        )?;
        let choice = step_choice(tolerance, own_step)?;
        let setup = PySetup::of_any(setup)?;
        let integration = setup.integration(py, choice)?;
        let is_long = pool::is_long(&integration.setup, 1);
        let found = pool::run_drive(py, is_long, move |stop| {
            let drive = integration.drive_until(stop)?;
            let of_drive = integration.warnings_until(&drive, &of, stop);
            let of_setup = warnings.into_iter().map(Message::from);
            let warnings = of_setup.chain(integration.warning.clone()).chain(of_drive);
            let trajectory = match is_traced {
                true => traced(&integration.setup, &drive, stop)?,
                false => None,
            };
            Ok::<_, Error>(PySimulated {
                setup: integration.setup,
                drive,
                warnings: warnings.collect(),
                of,
                trajectory,
            })
        });
        Ok(found??)
    })
}

/// The path of the ball; `None` for a ball that does not fly.
fn traced(
    setup: &Setup<f64>,
    drive: &Drive<f64>,
    stop: &AtomicBool,
) -> longdrive::Result<Option<Trajectory>> {
    match trajectory_until(setup, &drive.launch, stop) {
        // no flight: the ball leaves the face downwards
        Ok(trajectory) if trajectory.points.len() < 2 => Ok(None),
        Ok(trajectory) => Ok(Some(trajectory)),
        Err(error) => Err(error),
    }
}

fn path<'py>(py: Python<'py>, trajectory: &Trajectory) -> Path<'py> {
    let points = &trajectory.points;
    let vectors = |of: fn(&TrajectoryPoint) -> Vector<f64>| {
        Array2::from_shape_fn((points.len(), 3), |(row, axis)| {
            let vector = of(&points[row]);
            [vector.x, vector.y, vector.z][axis]
        })
        .into_pyarray(py)
    };
    let time: Vec<f64> = points.iter().map(|point| point.time).collect();
    (
        time.into_pyarray(py),
        vectors(|point| point.position),
        vectors(|point| point.velocity),
        vectors(|point| point.spin),
    )
}
