//! The arguments that choose method and step.

use crate::boundary::{Answer, Failure, answer, text_of};
use crate::names::{listed, outcomes_named, variables};
use crate::pool;
use crate::setup::PySetup;
use longdrive::integration::{Integration, StepChoice};
use longdrive::parameters::Parameter;
use longdrive::units::Quantity;
use longdrive::{Outcome, Setup};
use pyo3::prelude::*;
use pyo3::types::PyString;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// The choice that the arguments `tolerance` and `own_step` make.
pub fn step_choice(tolerance: Option<&Bound<'_, PyAny>>, own_step: bool) -> Answer<StepChoice> {
    let Some(given) = tolerance else {
        return Ok(if own_step {
            StepChoice::Own
        } else {
            StepChoice::default()
        });
    };
    if own_step {
        return Err(Failure::Input(
            "tolerance and own_step are both given; keep one of the two".into(),
        ));
    }
    if let Ok(text) = given.cast::<PyString>() {
        let read = Quantity::LENGTH.read(text_of("tolerance", text)?);
        return read
            .map(StepChoice::Within)
            .map_err(|error| Failure::Input(format!("tolerance: {error}")));
    }
    let refuse = |_| {
        Failure::Input(format!(
            "tolerance = {given}; expected a length, in m or as a text like \"1 um\""
        ))
    };
    given.extract().map(StepChoice::Within).map_err(refuse)
}

/// Chooses method and step for outcomes as functions of parameters.
pub fn for_function(
    py: Python<'_>,
    choice: StepChoice,
    setup: &Setup<f64>,
    of: Vec<Outcome>,
    wrt: Vec<&'static Parameter>,
) -> Answer<Integration> {
    let own = *setup;
    let work = move |stop: &AtomicBool| choice.for_function_until(&own, &of, &wrt, stop);
    Ok(pool::run_drive(py, !choice.is_own(setup), work)??)
}

/// Method and step of a function of parameters, chosen once.
#[pyclass(name = "Integration", module = "longdrive._longdrive", frozen)]
pub struct PyIntegration(pub Arc<Integration>);

#[pymethods]
impl PyIntegration {
    #[new]
    fn new(
        py: Python<'_>,
        setup: &PySetup,
        of: &Bound<'_, PyAny>,
        wrt: &Bound<'_, PyAny>,
        tolerance: Option<&Bound<'_, PyAny>>,
        own_step: bool,
    ) -> PyResult<Self> {
        answer(|| {
            let choice = step_choice(tolerance, own_step)?;
            let of = outcomes_named(&listed("of", of)?)?;
            let wrt = variables(&setup.setup, &of, Some(wrt))?;
            Ok(Self(Arc::new(for_function(
                py,
                choice,
                &setup.setup,
                of,
                wrt,
            )?)))
        })
    }
}
