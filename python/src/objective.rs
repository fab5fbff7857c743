//! An outcome as a function of some parameters, for optimizers that take functions.

use crate::boundary::{Answer, Failure, answer};
use crate::derivatives::{matrix, vector};
use crate::names::{outcomes_named, variables};
use crate::setup::PySetup;
use longdrive::derivative::{Evaluator, Order, Taylor};
use longdrive::parameters::Range;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;
use std::sync::{Mutex, PoisonError};

/// The point asked about last, and what is known of it.
struct Point {
    x: Vec<f64>,
    /// Bits of the order to which it was computed, and of what was asked of it.
    order: Order,
    asked: Order,
    found: Option<Taylor>,
}

/// An outcome as a function of some parameters, for ``scipy.optimize`` and the like: ``fun``, ``jac`` and ``hess`` of a point.
///
/// See :func:`longdrive.objective`, which makes one.
#[pyclass(name = "Objective", module = "longdrive", frozen)]
pub struct PyObjective {
    setup: PySetup,
    of: String,
    evaluators: [Evaluator; 3],
    /// The sense as it was given, and the factor that turns a greatest value into a least one.
    sense: Option<String>,
    sign: f64,
    /// Whether a point without an answer is NaN.
    gives_nan: bool,
    last: Mutex<Option<Point>>,
}

const ORDERS: [Order; 3] = [Order::Value, Order::First, Order::Second];

/// The least and the greatest number in a range: an end that does not belong to it is left out.
fn ends(range: Range) -> (f64, f64) {
    let low = if range.low_included || range.low.is_infinite() { range.low } else { range.low.next_up() };
    let high = if range.high_included || range.high.is_infinite() { range.high } else { range.high.next_down() };
    (low, high)
}

impl PyObjective {
    /// What it is at a point, to an order. Optimizers ask for value, gradient and Hessian of a point one after the other: what was asked for at
    /// the point before is computed together at this one, and kept until the next.
    fn at(&self, x: &Bound<'_, PyAny>, order: Order) -> Answer<Option<Taylor>> {
        let x = self.point(x)?;
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        let mut to = order;
        let mut asked = order;
        if let Some(point) = &mut *last {
            if point.x == x {
                point.asked = point.asked.max(order);
                asked = point.asked;
                if point.order >= order {
                    return Ok(point.found.clone());
                }
            } else {
                to = order.max(point.asked);
            }
        }
        let found = match self.evaluators[to as usize].at(&x) {
            Ok(mut taylors) => taylors.pop(),
            // derivatives may be missing where the value is not
            Err(_) if to > order => {
                to = order;
                self.lone(&x, order)?
            }
            Err(_) if self.gives_nan => None,
            Err(error) => return Err(error.into()),
        };
        let found = found.map(|taylor| if self.sign < 0.0 { taylor.negated() } else { taylor });
        *last = Some(Point { x, order: to, asked, found: found.clone() });
        Ok(found)
    }

    /// As much as is asked for, and no more.
    fn lone(&self, x: &[f64], order: Order) -> Answer<Option<Taylor>> {
        match self.evaluators[order as usize].at(x) {
            Ok(mut taylors) => Ok(taylors.pop()),
            Err(_) if self.gives_nan => Ok(None),
            Err(error) => Err(error.into()),
        }
    }

    /// A point from any one-dimensional array or sequence of numbers, with a value for each parameter.
    fn point(&self, x: &Bound<'_, PyAny>) -> Answer<Vec<f64>> {
        let wanted = self.wrt().len();
        let refuse = |found: String| {
            let names: Vec<_> = self.wrt().iter().map(|row| row.name).collect();
            Failure::Input(format!("x {found}; expected shape ({wanted},): {}, SI", names.join(", ")))
        };
        let values = match x.cast::<PyArray1<f64>>() {
            Ok(array) => match array.readonly().as_slice() {
                Ok(values) => values.to_vec(),
                Err(_) => array.to_owned_array().to_vec(),
            },
            Err(_) => {
                let array = x.py().import("numpy")?.call_method1("asarray", (x, "f8"));
                let array =
                    array.map_err(|error| refuse(format!("is no array of numbers ({})", error.value(x.py()))))?;
                match array.extract::<PyReadonlyArray1<'_, f64>>() {
                    Ok(array) => array.as_array().to_vec(),
                    Err(_) => return Err(refuse(format!("has shape {}", array.getattr("shape")?))),
                }
            }
        };
        if values.len() == wanted { Ok(values) } else { Err(refuse(format!("has shape ({},)", values.len()))) }
    }

    fn wrt(&self) -> &[&'static longdrive::parameters::Parameter] {
        self.evaluators[0].parameters()
    }

    fn gradient<'py>(&self, py: Python<'py>, found: Option<&Taylor>) -> Bound<'py, PyArray1<f64>> {
        vector(py, found.map_or_else(|| vec![f64::NAN; self.wrt().len()], |taylor| taylor.gradient.clone()))
    }
}

fn value(found: Option<&Taylor>) -> f64 {
    found.map_or(f64::NAN, |taylor| taylor.value)
}

#[pymethods]
impl PyObjective {
    #[new]
    #[pyo3(signature = (setup, of = "carry", wrt = None, sense = None, invalid = "raise"))]
    fn new(
        setup: &Bound<'_, PyAny>,
        of: &str,
        wrt: Option<&Bound<'_, PyAny>>,
        sense: Option<String>,
        invalid: &str,
    ) -> PyResult<Self> {
        answer(|| {
            let setup = PySetup::of(setup)?;
            let named = outcomes_named(&[of.to_owned()])?;
            if named.len() != 1 {
                return Err(Failure::Input("of = 'all': an objective is one outcome; name it".into()));
            }
            let wrt = variables(&setup.setup, wrt)?;
            let sign = match sense.as_deref() {
                None | Some("min") => 1.0,
                Some("max") => -1.0,
                Some(other) => {
                    let what = format!("sense = '{other}'; expected 'max', 'min' or None");
                    return Err(Failure::Input(what));
                }
            };
            let gives_nan = match invalid {
                "raise" => false,
                "nan" => true,
                other => return Err(Failure::Input(format!("invalid = '{other}'; expected 'raise' or 'nan'"))),
            };
            let [values, gradients, hessians] = ORDERS.map(|order| Evaluator::new(&setup.setup, &named, &wrt, order));
            let evaluators = [values?, gradients?, hessians?];
            Ok(Self { setup, of: of.to_owned(), evaluators, sense, sign, gives_nan, last: Mutex::new(None) })
        })
    }

    /// The value at x, a number: that of the outcome in SI, with its sign changed where ``sense`` is ``"max"``.
    ///
    /// Args:
    ///     x: shape (parameters,), SI: a list or any one-dimensional array.
    fn fun(&self, x: &Bound<'_, PyAny>) -> PyResult<f64> {
        answer(|| Ok(value(self.at(x, Order::Value)?.as_ref())))
    }

    /// The gradient at x, shape (parameters,).
    fn jac<'py>(&self, py: Python<'py>, x: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        answer(|| Ok(self.gradient(py, self.at(x, Order::First)?.as_ref())))
    }

    /// The Hessian at x, shape (parameters, parameters).
    fn hess<'py>(&self, py: Python<'py>, x: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        answer(|| {
            let wanted = self.wrt().len();
            let rows = self
                .at(x, Order::Second)?
                .map_or_else(|| vec![vec![f64::NAN; wanted]; wanted], |taylor| taylor.hessian);
            matrix(py, &rows, wanted)
        })
    }

    /// Value and gradient at x together, for ``scipy.optimize.minimize(…, jac=True)``.
    fn fun_and_jac<'py>(&self, py: Python<'py>, x: &Bound<'py, PyAny>) -> PyResult<(f64, Bound<'py, PyArray1<f64>>)> {
        answer(|| {
            let found = self.at(x, Order::First)?;
            Ok((value(found.as_ref()), self.gradient(py, found.as_ref())))
        })
    }

    fn __call__(&self, x: &Bound<'_, PyAny>) -> PyResult<f64> {
        self.fun(x)
    }

    /// The parameters, in the order of x.
    #[getter]
    fn names(&self) -> Vec<&'static str> {
        self.wrt().iter().map(|row| row.name).collect()
    }

    /// The outcome.
    #[getter]
    fn of(&self) -> &str {
        &self.of
    }

    /// The setup that x moves.
    #[getter]
    fn setup(&self) -> PySetup {
        self.setup
    }

    /// The setup's own values of the parameters, shape (parameters,), SI.
    #[getter]
    fn x0<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let own = self.wrt().iter().map(|row| self.setup.setup.value(row).unwrap_or(f64::NAN));
        vector(py, own.collect())
    }

    /// What each parameter may physically be, a pair (low, high) each, SI: not what a golfer or club maker can do.
    #[getter]
    fn bounds(&self) -> Vec<(f64, f64)> {
        self.wrt().iter().map(|row| ends(row.range)).collect()
    }

    fn __repr__(&self) -> PyResult<String> {
        let sense = self.sense.as_ref().map_or_else(String::new, |sense| format!(", {sense}"));
        Ok(format!("<longdrive.Objective {} of {}{sense}>", self.of, self.names().join(", ")))
    }

    #[expect(clippy::type_complexity, reason = "what pickle asks for")]
    fn __reduce__<'py>(
        &self,
        py: Python<'py>,
    ) -> (Bound<'py, PyAny>, (PySetup, &str, Vec<&'static str>, Option<&str>, &'static str)) {
        let invalid = if self.gives_nan { "nan" } else { "raise" };
        let class = py.get_type::<Self>().into_any();
        (class, (self.setup, &self.of, self.names(), self.sense.as_deref(), invalid))
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }
}
