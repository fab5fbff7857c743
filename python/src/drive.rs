//! One drive.

use crate::boundary::answer;
use crate::json::to_python;
use crate::names::{listed, outcomes_named};
use crate::setup::PySetup;
use longdrive::report::{DriveReport, Reply};
use longdrive::{Drive, Outcome};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Outcomes of one drive by name, SI, None where it has none; and the answer of ``longdrive
/// simulate --json``, a dict of dicts.
#[pyfunction]
#[pyo3(signature = (setup = None, of = None))]
pub fn simulate<'py>(
    py: Python<'py>,
    setup: Option<&Bound<'py, PyAny>>,
    of: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Bound<'py, PyDict>, Bound<'py, PyAny>)> {
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
        Ok((
            outcomes,
            to_python(py, &Reply::of(DriveReport::new(&setup, &drive), warnings))?,
        ))
    })
}
