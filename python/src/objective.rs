//! An outcome, or a goal over swings, as a function of some parameters, for optimizers that take
//! functions.

use crate::arrays::floats;
use crate::boundary::{Answer, Failure, answer};
use crate::derivatives::{matrix, vector};
use crate::names::{outcomes_named, variables};
use crate::pool;
use crate::setup::PySetup;
use crate::step::{for_function, step_choice};
use longdrive::command::SwingsArgs;
use longdrive::derivative::{Evaluator, Order, Taylor};
use longdrive::integration::StepChoice;
use longdrive::parameters::Parameter;
use longdrive::study::Goal;
use longdrive::study::swings::{GoalFunction, Swings};
use longdrive::{Outcome, Setup};
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyUntypedArray};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PySequenceMethods, PyTuple};
use std::path::PathBuf;
use std::sync::{Arc, Mutex};

/// The last point at which the function was evaluated, with its results. `found` is `None` for a
/// point without a value.
struct Point {
    x: Vec<f64>,
    /// The order of the computed derivatives; `requested` is the highest requested order.
    order: Order,
    requested: Order,
    found: Option<Taylor>,
}

/// The function to evaluate.
enum ObjectiveKind {
    /// An outcome of one drive, by an evaluator for each order of derivatives.
    Drive {
        evaluators: Arc<[Evaluator; 3]>,
        /// True if one evaluation may take so long that Python has to check for Ctrl-C meanwhile.
        is_long: bool,
    },
    Swings(Arc<GoalFunction>),
}

impl ObjectiveKind {
    fn over_swings(
        py: Python<'_>,
        choice: StepChoice,
        setup: &Setup<f64>,
        of: &str,
        wrt: &[&'static Parameter],
        swing_arguments: &SwingsArgs,
        swings: &Swings,
    ) -> Answer<Self> {
        let goal = goal_of(swing_arguments, of)?;
        let scenarios = swing_arguments.scenarios(swings, [&goal], false)?;
        let (own, by, swings) = (*setup, wrt.to_vec(), scenarios.clone());
        let integration = pool::run_drive(py, !choice.is_own(setup), move |stop| {
            choice.for_swings(&own, &by, &swings, stop)
        })??;
        Ok(Self::Swings(Arc::new(
            integration.goal_function(&goal, wrt, scenarios)?,
        )))
    }

    fn of_drive(
        py: Python<'_>,
        choice: StepChoice,
        setup: &Setup<f64>,
        of: &str,
        wrt: &[&'static Parameter],
    ) -> Answer<Self> {
        if of.contains('(') && Outcome::named(of).is_err() {
            let what = format!(
                "of: {of} is a goal over many swings; give the swings too, with swings or \
                 distribution"
            );
            return Err(Failure::Input(what));
        }
        let named = outcomes_named(&[of.to_owned()])?;
        if named.len() != 1 {
            return Err(Failure::Input(
                "of = 'all': an objective is one outcome; name it".into(),
            ));
        }
        let integration = for_function(py, choice, setup, named.clone(), wrt.to_vec())?;
        let evaluators = ORDERS.map(|order| integration.evaluator(&named, wrt, order));
        let [values, gradients, hessians] = evaluators;
        Ok(Self::Drive {
            evaluators: Arc::new([values?, gradients?, hessians?]),
            is_long: pool::is_long(&integration.setup, wrt.len() * wrt.len()),
        })
    }

    /// The value at a point, with the derivatives up to `order`. Many swings are computed on
    /// several threads, while the thread of Python checks for Ctrl-C and lets other threads of
    /// Python run.
    fn at(
        &self,
        py: Python<'_>,
        x: &[f64],
        order: Order,
    ) -> Answer<longdrive::Result<Option<Taylor>>> {
        match self {
            Self::Drive {
                evaluators,
                is_long,
            } => {
                let (evaluators, x) = (Arc::clone(evaluators), x.to_vec());
                pool::run_drive(py, *is_long, move |stop| {
                    let taylors = evaluators[order as usize].at_until(&x, stop);
                    taylors.map(|mut taylors| taylors.pop())
                })
            }
            Self::Swings(goal) => {
                let (goal, x) = (Arc::clone(goal), x.to_vec());
                pool::run(
                    py,
                    move |stop| goal.at_until(&x, order, stop).map(Some),
                    || Ok(()),
                )
            }
        }
    }

    fn parameters(&self) -> &[&'static Parameter] {
        match self {
            Self::Drive { evaluators, .. } => evaluators[0].parameters(),
            Self::Swings(goal) => goal.parameters(),
        }
    }
}

/// The parameters of the function, from the argument `wrt`.
fn parameters_of(
    swing_arguments: &SwingsArgs,
    setup: &Setup<f64>,
    of: &str,
    wrt: Option<&Bound<'_, PyAny>>,
) -> Answer<Vec<&'static Parameter>> {
    let is_over_swings = swing_arguments.is_given();
    if wrt.is_none() && is_over_swings && !setup.launch.is_given() {
        // over swings only the loft varies by default: the attack angle belongs to the golfer, and
        // varies from swing to swing
        return Ok(vec![setup.variable("club.loft")?]);
    }
    let outcomes = match is_over_swings {
        true => goal_of(swing_arguments, of).map(|goal| goal.outcomes()),
        false => outcomes_named(&[of.to_owned()]),
    };
    // an invalid goal is refused later, where the function is made
    variables(setup, &outcomes.unwrap_or_default(), wrt)
}

/// The goal over the swings, from the argument `of`.
fn goal_of(swing_arguments: &SwingsArgs, of: &str) -> Answer<Goal> {
    Ok(swing_arguments.goal("of", of, "of=\"strokes(400yd)\"")?)
}

/// An outcome, or a goal over swings, as a function of some parameters. Its methods ``fun``,
/// ``jac`` and ``hess`` take a point, as ``scipy.optimize`` and similar optimizers expect.
///
/// See :func:`longdrive.objective`, which makes one.
#[pyclass(name = "Objective", module = "longdrive", frozen)]
pub struct PyObjective {
    setup: PySetup,
    of: String,
    choice: StepChoice,
    function: ObjectiveKind,
    swing_arguments: SwingsArgs,
    /// The argument `sense`.
    sense: Option<String>,
    /// −1 for `sense="max"`, else 1: the factor of the outcome in the function.
    sign: f64,
    /// True if a point without a value gives NaN; false if it gives an error.
    gives_nan: bool,
    last: Mutex<Option<Point>>,
}

const ORDERS: [Order; 3] = [Order::Value, Order::First, Order::Second];

impl PyObjective {
    /// The derivatives at a point, up to `order`. Optimizers request value, gradient and Hessian of
    /// a point one after the other. At a new point, all orders that were requested at the previous
    /// point are therefore computed together, and cached.
    fn at(&self, x: &Bound<'_, PyAny>, order: Order) -> Answer<Option<Taylor>> {
        let (py, x) = (x.py(), self.point(x)?);
        let mut to = order;
        let mut requested = order;
        // release the lock before the computation, because other Python code may call this method
        // meanwhile
        if let Some(point) = &mut *pool::lock(&self.last) {
            if point.x == x {
                point.requested = point.requested.max(order);
                requested = point.requested;
                if point.order >= order {
                    return Ok(point.found.clone());
                }
            } else {
                to = order.max(point.requested);
            }
        }
        let found = match self.function.at(py, &x, to)? {
            Ok(found) => found,
            // higher derivatives may not exist at this point: retry with the requested order
            Err(_) if to > order => {
                to = order;
                self.value_or_error(self.function.at(py, &x, order)?)?
            }
            found => self.value_or_error(found)?,
        };
        let found = found.map(|taylor| {
            if self.sign < 0.0 {
                taylor.negated()
            } else {
                taylor
            }
        });
        *pool::lock(&self.last) = Some(Point {
            x,
            order: to,
            requested,
            found: found.clone(),
        });
        Ok(found)
    }

    /// The value in `found`. An error becomes `None` if `gives_nan` is true.
    fn value_or_error(&self, found: longdrive::Result<Option<Taylor>>) -> Answer<Option<Taylor>> {
        match found {
            Ok(found) => Ok(found),
            Err(_) if self.gives_nan => Ok(None),
            Err(error) => Err(error.into()),
        }
    }

    /// Reads a point from any one-dimensional array or sequence, with a value for each parameter.
    fn point(&self, x: &Bound<'_, PyAny>) -> Answer<Vec<f64>> {
        let wanted = self.wrt().len();
        let refuse = |found: String| {
            let names: Vec<_> = self.wrt().iter().map(|row| row.name).collect();
            Failure::Input(format!(
                "x {found}; expected shape ({wanted},): {}, SI",
                names.join(", ")
            ))
        };
        let values = match x.cast::<PyArray1<f64>>() {
            Ok(array) if is_masked(array)? => return Err(refuse("is a masked array".into())),
            Ok(array) => match array.readonly().as_slice() {
                Ok(values) => values.to_vec(),
                Err(_) => array.to_owned_array().to_vec(),
            },
            Err(_) => {
                let py = x.py();
                let units = PyDict::new(py);
                self.wrt()
                    .iter()
                    .try_for_each(|row| units.set_item(row.name, row.quantity.si))?;
                let x = py
                    .import("longdrive.quantities")?
                    .getattr("point_in_si")?
                    .call1((x, units))?;
                let array = floats(&x, "", &refuse)?;
                // `minimize_scalar` of SciPy gives x as a number: convert it to an array
                let array = if wanted == 1 {
                    py.import("numpy")?.call_method1("atleast_1d", (array,))?
                } else {
                    array
                };
                match array.extract::<PyReadonlyArray1<'_, f64>>() {
                    Ok(array) => array.as_array().to_vec(),
                    Err(_) => return Err(refuse(format!("has shape {}", array.getattr("shape")?))),
                }
            }
        };
        if values.len() == wanted {
            Ok(values)
        } else {
            Err(refuse(format!("has shape ({},)", values.len())))
        }
    }

    fn wrt(&self) -> &[&'static Parameter] {
        self.function.parameters()
    }

    fn gradient<'py>(&self, py: Python<'py>, found: Option<&Taylor>) -> Bound<'py, PyArray1<f64>> {
        match found {
            Some(taylor) => vector(py, &taylor.gradient),
            None => vector(py, &vec![f64::NAN; self.wrt().len()]),
        }
    }
}

/// True for a masked array. NumPy's plain arrays have no attribute `mask`: the search for one would
/// raise and catch an exception at each call.
fn is_masked(array: &Bound<'_, PyArray1<f64>>) -> PyResult<bool> {
    Ok(!array.is_exact_instance_of::<PyUntypedArray>() && array.hasattr("mask")?)
}

/// The factor that turns the requested extremum into a minimum.
fn sign_of(sense: Option<&str>) -> Answer<f64> {
    match sense {
        None | Some("min") => Ok(1.0),
        Some("max") => Ok(-1.0),
        Some(other) => Err(Failure::Input(format!(
            "sense = '{other}'; expected 'max', 'min' or None"
        ))),
    }
}

/// True if a point without a value gives NaN.
fn gives_nan(invalid: &str) -> Answer<bool> {
    match invalid {
        "raise" => Ok(false),
        "nan" => Ok(true),
        other => Err(Failure::Input(format!(
            "invalid = '{other}'; expected 'raise' or 'nan'"
        ))),
    }
}

fn value(found: Option<&Taylor>) -> f64 {
    found.map_or(f64::NAN, |taylor| taylor.value)
}

#[pymethods]
impl PyObjective {
    #[new]
    #[pyo3(
        signature = (setup, of = "carry", wrt = None, sense = None, invalid = "raise", swings = None, distribution = vec![], correlation = vec![], scenarios = None, seed = None, strokes = None, tolerance = None, own_step = false, stated = vec![]),
    )]
    #[expect(clippy::too_many_arguments, reason = "each is one that Python names")]
    fn new(
        setup: &Bound<'_, PyAny>,
        of: &str,
        wrt: Option<&Bound<'_, PyAny>>,
        sense: Option<String>,
        invalid: &str,
        swings: Option<PathBuf>,
        distribution: Vec<String>,
        correlation: Vec<String>,
        scenarios: Option<usize>,
        seed: Option<u32>,
        strokes: Option<PathBuf>,
        tolerance: Option<&Bound<'_, PyAny>>,
        own_step: bool,
        stated: Vec<String>,
    ) -> PyResult<Self> {
        answer(|| {
            let choice = step_choice(tolerance, own_step)?;
            let (py, setup) = (setup.py(), PySetup::of(setup)?);
            let swing_arguments = SwingsArgs {
                swings,
                distribution,
                correlation,
                scenarios,
                seed,
                strokes,
            };
            let wrt = parameters_of(&swing_arguments, &setup.setup, of, wrt)?;
            let function = if swing_arguments.is_given() {
                let swings = swing_arguments.read(&setup.setup)?;
                let why = "the swings have values of it";
                setup.refuse_idle(&stated, &swings.parameters(), why)?;
                let arguments = &swing_arguments;
                ObjectiveKind::over_swings(py, choice, &setup.setup, of, &wrt, arguments, &swings)?
            } else {
                swing_arguments.refuse_stray()?;
                setup.refuse_idle(&stated, &[], "")?;
                ObjectiveKind::of_drive(py, choice, &setup.setup, of, &wrt)?
            };
            Ok(Self {
                setup,
                of: of.to_owned(),
                choice,
                function,
                swing_arguments,
                sign: sign_of(sense.as_deref())?,
                sense,
                gives_nan: gives_nan(invalid)?,
                last: Mutex::new(None),
            })
        })
    }

    /// The value at x, SI; with its sign changed for ``sense="max"``.
    ///
    /// Parameters
    /// ----------
    /// x
    ///     Shape (parameters,), SI: a list or any one-dimensional array.
    fn fun(&self, x: &Bound<'_, PyAny>) -> PyResult<f64> {
        answer(|| Ok(value(self.at(x, Order::Value)?.as_ref())))
    }

    /// The gradient at x, shape (parameters,).
    fn jac<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        answer(|| Ok(self.gradient(py, self.at(x, Order::First)?.as_ref())))
    }

    /// The Hessian at x, shape (parameters, parameters).
    fn hess<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        answer(|| {
            let wanted = self.wrt().len();
            let rows = self.at(x, Order::Second)?.map_or_else(
                || vec![vec![f64::NAN; wanted]; wanted],
                |taylor| taylor.hessian,
            );
            matrix(py, &rows, wanted)
        })
    }

    /// Value and gradient at x together, for ``scipy.optimize.minimize(…, jac=True)``.
    fn fun_and_jac<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
    ) -> PyResult<(f64, Bound<'py, PyArray1<f64>>)> {
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

    /// The outcome, or the goal over swings.
    #[getter]
    fn of(&self) -> &str {
        &self.of
    }

    /// The setup. A point x replaces the values of its parameters.
    #[getter]
    fn setup(&self) -> PySetup {
        self.setup.clone()
    }

    /// The setup's own values of the parameters, shape (parameters,), SI.
    #[getter]
    fn x0<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        let own = self
            .wrt()
            .iter()
            .map(|row| self.setup.setup.value(row).unwrap_or(f64::NAN));
        vector(py, &own.collect::<Vec<_>>())
    }

    /// The physical range of each parameter, a pair (low, high), SI: wider than what a golfer or
    /// club maker can do.
    #[getter]
    fn bounds(&self) -> Vec<(f64, f64)> {
        self.wrt()
            .iter()
            .map(|row| row.range.ends().into())
            .collect()
    }

    fn __repr__(&self) -> PyResult<String> {
        let sense = self
            .sense
            .as_ref()
            .map_or_else(String::new, |sense| format!(", {sense}"));
        let over = if self.swing_arguments.is_given() {
            " over swings"
        } else {
            ""
        };
        Ok(format!(
            "<longdrive.Objective {}{over} of {}{sense}>",
            self.of,
            self.names().join(", ")
        ))
    }

    fn __reduce__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let invalid = if self.gives_nan { "nan" } else { "raise" };
        let SwingsArgs {
            swings,
            distribution,
            correlation,
            scenarios,
            seed,
            strokes,
        } = self.swing_arguments.clone();
        let of_swings =
            (swings, distribution, correlation, scenarios, seed, strokes).into_pyobject(py)?;
        let tolerance = match self.choice {
            StepChoice::Within(tolerance) => Some(tolerance),
            _ => None,
        };
        let of_step = (tolerance, self.choice == StepChoice::Own).into_pyobject(py)?;
        let own = (
            self.setup.clone(),
            &self.of,
            self.names(),
            self.sense.as_deref(),
            invalid,
        )
            .into_pyobject(py)?;
        Ok((
            py.get_type::<Self>().into_any(),
            own.as_sequence()
                .concat(of_swings.as_sequence())?
                .concat(of_step.as_sequence())?
                .to_tuple()?,
        ))
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }
}
