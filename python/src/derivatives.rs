//! Exact derivatives of the outcomes of one drive.

use crate::boundary::{Answer, Failure, answer};
use crate::names::{listed, outcomes_named, variables};
use crate::pool;
use crate::setup::PySetup;
use crate::step::step_choice;
use longdrive::derivative::{Order, Taylor};
use longdrive::integration::StepChoice;
use numpy::ndarray::Array2;
use numpy::{IntoPyArray, PyArray1, PyArray2};
use pyo3::prelude::*;

/// The values of a row as an array.
pub fn vector<'py>(py: Python<'py>, values: &[f64]) -> Bound<'py, PyArray1<f64>> {
    PyArray1::from_slice(py, values)
}

/// The rows of a matrix as an array.
pub fn matrix<'py>(
    py: Python<'py>,
    rows: &[Vec<f64>],
    columns: usize,
) -> Answer<Bound<'py, PyArray2<f64>>> {
    let values = Array2::from_shape_vec((rows.len(), columns), rows.concat());
    let values =
        values.map_err(|error| Failure::Internal(format!("a matrix of derivatives: {error}")))?;
    Ok(values.into_pyarray(py))
}

fn computed(
    setup: &Bound<'_, PyAny>,
    of: &[String],
    wrt: Option<&Bound<'_, PyAny>>,
    choice: StepChoice,
    order: Order,
) -> Answer<Vec<Taylor>> {
    let (py, setup) = (setup.py(), PySetup::of(setup)?);
    let of = outcomes_named(of)?;
    let wrt = variables(&setup.setup, &of, wrt)?;
    let integration = setup.integration(py, choice)?;
    let drives = match order {
        Order::Second => wrt.len() * wrt.len(),
        _ => wrt.len(),
    };
    let is_long = pool::is_long(&integration.setup, drives);
    let taylors = pool::run_drive(py, is_long, move |stop| {
        integration.evaluate_until(&of, &wrt, order, stop)
    });
    Ok(taylors??)
}

fn one(mut taylors: Vec<Taylor>) -> Answer<Taylor> {
    taylors.pop().filter(|_| taylors.is_empty()).ok_or_else(|| {
        Failure::Input("of names several outcomes; name one, or call longdrive.jacobian".into())
    })
}

type Gradient<'py> = (f64, Bound<'py, PyArray1<f64>>);
type Jacobian<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray2<f64>>);
type Hessian<'py> = (f64, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray2<f64>>);

/// Value of an outcome and its gradient, shape (parameters,).
#[pyfunction]
#[pyo3(signature = (setup, of, wrt, tolerance, own_step))]
pub fn gradient<'py>(
    py: Python<'py>,
    setup: &Bound<'py, PyAny>,
    of: &str,
    wrt: Option<&Bound<'py, PyAny>>,
    tolerance: Option<&Bound<'py, PyAny>>,
    own_step: bool,
) -> PyResult<Gradient<'py>> {
    answer(|| {
        let choice = step_choice(tolerance, own_step)?;
        let taylor = one(computed(
            setup,
            &[of.to_owned()],
            wrt,
            choice,
            Order::First,
        )?)?;
        Ok((taylor.value, vector(py, &taylor.gradient)))
    })
}

/// Values of outcomes, shape (outcomes,), and their Jacobian, shape (outcomes, parameters).
#[pyfunction]
#[pyo3(signature = (setup, of, wrt, tolerance, own_step))]
pub fn jacobian<'py>(
    py: Python<'py>,
    setup: &Bound<'py, PyAny>,
    of: &Bound<'py, PyAny>,
    wrt: Option<&Bound<'py, PyAny>>,
    tolerance: Option<&Bound<'py, PyAny>>,
    own_step: bool,
) -> PyResult<Jacobian<'py>> {
    answer(|| {
        let choice = step_choice(tolerance, own_step)?;
        let taylors = computed(setup, &listed("of", of)?, wrt, choice, Order::First)?;
        let values: Vec<_> = taylors.iter().map(|taylor| taylor.value).collect();
        let rows: Vec<_> = taylors.into_iter().map(|taylor| taylor.gradient).collect();
        let columns = rows.first().map_or(0, Vec::len);
        Ok((vector(py, &values), matrix(py, &rows, columns)?))
    })
}

/// Value of an outcome, its gradient, shape (parameters,), and its Hessian, shape (parameters,
/// parameters).
#[pyfunction]
#[pyo3(signature = (setup, of, wrt, tolerance, own_step))]
pub fn hessian<'py>(
    py: Python<'py>,
    setup: &Bound<'py, PyAny>,
    of: &str,
    wrt: Option<&Bound<'py, PyAny>>,
    tolerance: Option<&Bound<'py, PyAny>>,
    own_step: bool,
) -> PyResult<Hessian<'py>> {
    answer(|| {
        let choice = step_choice(tolerance, own_step)?;
        let taylor = one(computed(
            setup,
            &[of.to_owned()],
            wrt,
            choice,
            Order::Second,
        )?)?;
        let columns = taylor.gradient.len();
        Ok((
            taylor.value,
            vector(py, &taylor.gradient),
            matrix(py, &taylor.hessian, columns)?,
        ))
    })
}
