//! Arrays of NumPy as the points of a batch.

use crate::boundary::{Answer, Failure, kind_of, shown, text_of};
use crate::degrees::Degrees;
use crate::pool::check_signals;
use longdrive::batch::Points;
use longdrive::parameters::{Parameter, Vary};
use longdrive::{Error, Setup};
use numpy::ndarray::s;
use numpy::{PyArray1, PyArrayDescrMethods, PyArrayMethods, PyUntypedArray, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyList, PyMapping, PyString, PyTuple};

/// Number of rows that are copied from the arrays in one block. During the copy, other threads of
/// Python wait.
const GATHERED: usize = 65_536;

/// Number of rows that are scanned before other threads of Python may run.
const ROWS_PER_SCAN: usize = 1 << 20;

/// Imports NumPy's functions at the start. Otherwise the first use of an array would import them,
/// and a Ctrl-C during that import would panic. If NumPy is missing, the first use of an array
/// raises the error.
pub fn prepared(py: Python<'_>) {
    if py.import("numpy").is_ok() {
        let array = PyArray1::<f64>::zeros(py, [0], false);
        drop(array.readonly());
    }
}

/// The values of one parameter: one value for all rows, or one value for each row.
enum Column {
    Same(f64),
    Each(Py<PyArray1<f64>>),
}

/// The values of some parameters, a row for each drive.
pub struct Arrays {
    parameters: Vec<&'static Parameter>,
    columns: Vec<Column>,
    rows: usize,
    ranges: Vec<Vary>,
    /// Warnings about columns that look like degrees.
    in_degrees: Vec<String>,
    next: usize,
    /// Copied rows, from row `first` on.
    gathered: Vec<f64>,
    first: usize,
}

impl Arrays {
    /// The points of a dict from names to arrays or numbers. Arrays of 64-bit floats are not
    /// copied, whatever their strides; other floats and whole numbers are converted. The values are
    /// not checked here.
    pub fn of(setup: &Setup<f64>, points: &Bound<'_, PyAny>) -> Answer<Self> {
        let Ok(points) = points.cast::<PyMapping>() else {
            let kind = kind_of(points);
            return Err(Failure::Input(format!(
                "points is {kind}; expected a dict of parameters with arrays, like \
                 {{\"club.loft\": array}}, SI; sweep(points=…) takes tables, with \
                 their units in the heads"
            )));
        };
        if points.len()? == 0 {
            let what = "points is empty; give at least one parameter with its values, as in \
                        {\"club.loft\": [0.16, 0.18]}";
            return Err(Failure::Input(what.into()));
        }
        let (mut parameters, mut columns, mut rows) =
            (vec![], vec![], None::<(&'static str, usize)>);
        for item in points.items()?.iter() {
            let (name, value): (Bound<'_, PyAny>, Bound<'_, PyAny>) = item.extract()?;
            let Ok(name) = name.cast::<PyString>() else {
                return Err(Failure::Input(format!(
                    "points: the key {} is no text; expected the name of a parameter",
                    shown(&name)
                )));
            };
            let parameter = setup.column(text_of("points: a name", name)?)?;
            let column = column(parameter, &value)?;
            if let Column::Each(array) = &column {
                let length = array.bind(points.py()).len();
                match rows {
                    Some((first, rows)) if rows != length => {
                        return Err(Failure::Input(format!(
                            "points: {} has shape ({length},), and {first} has ({rows},); expected \
                             arrays of one length, or numbers",
                            parameter.name
                        )));
                    }
                    _ => rows = Some((parameter.name, length)),
                }
            }
            parameters.push(parameter);
            columns.push(column);
        }
        let rows = rows.map_or(usize::from(!columns.is_empty()), |(_, rows)| rows);
        let (ranges, in_degrees, gathered) = (vec![], vec![], vec![]);
        Ok(Self {
            parameters,
            columns,
            rows,
            ranges,
            in_degrees,
            next: 0,
            gathered,
            first: 0,
        })
    }

    pub fn len(&self) -> usize {
        self.rows
    }

    pub fn in_degrees(&self) -> Vec<String> {
        self.in_degrees.clone()
    }

    /// Finds the range of each parameter's valid values, and columns that look like degrees. Lets
    /// other Python threads run between blocks of rows. `is_bare` is true if the user gave the
    /// numbers without a unit; only then is a warning about degrees possible.
    pub fn scan(&mut self, py: Python<'_>, is_bare: bool) -> PyResult<()> {
        for (parameter, column) in self.parameters.iter().zip(&self.columns) {
            let mut range = None::<(f64, f64)>;
            let mut degrees = Degrees::default();
            for first in (0..self.rows).step_by(ROWS_PER_SCAN) {
                check_signals(py)?;
                column.each(
                    py,
                    first..self.rows.min(first + ROWS_PER_SCAN),
                    &mut |value| {
                        if parameter.range.contains(value) && value.is_finite() {
                            let (low, high) = range.unwrap_or((value, value));
                            range = Some((low.min(value), high.max(value)));
                        } else {
                            degrees.count(parameter, value);
                        }
                    },
                );
            }
            self.ranges.extend(range.map(|(low, high)| Vary {
                parameter,
                low,
                high,
            }));
            self.in_degrees.extend(
                degrees
                    .warning(parameter, self.rows as u64)
                    .filter(|_| is_bare),
            );
        }
        Ok(())
    }

    /// Copies the next rows of the arrays, one row after the other.
    fn gather(&mut self, py: Python<'_>) {
        let (width, end) = (self.columns.len(), self.rows.min(self.next + GATHERED));
        self.first = self.next;
        self.gathered.clear();
        self.gathered.resize((end - self.next) * width, 0.0);
        for (k, column) in self.columns.iter().enumerate() {
            let mut places = self.gathered.iter_mut().skip(k).step_by(width.max(1));
            column.each(py, self.next..end, &mut |value| {
                if let Some(place) = places.next() {
                    *place = value;
                }
            });
        }
    }
}

impl Column {
    /// Calls `take` with the value of this column in each of the `rows`, in order.
    fn each(&self, py: Python<'_>, rows: std::ops::Range<usize>, take: &mut dyn FnMut(f64)) {
        match self {
            Self::Same(value) => rows.for_each(|_| take(*value)),
            Self::Each(array) => {
                let array = array.bind(py).readonly();
                match array.as_slice() {
                    Ok(values) => values[rows].iter().for_each(|value| take(*value)),
                    Err(_) => array
                        .as_array()
                        .slice(s![rows])
                        .iter()
                        .for_each(|value| take(*value)),
                }
            }
        }
    }
}

/// The argument `given` as a column of `parameter`.
fn column(parameter: &'static Parameter, given: &Bound<'_, PyAny>) -> Answer<Column> {
    let name = parameter.name;
    if let Ok(text) = given.cast::<PyString>() {
        let value = parameter.read(text_of(&format!("points: {name}"), text)?, false)?;
        let value = value.ok_or_else(|| {
            Failure::Input(format!(
                "points: {name} is unset; give a value for each row"
            ))
        })?;
        return Ok(Column::Same(value));
    }
    let refuse = |found: String| {
        Failure::Input(format!(
            "points: {name} {found}; expected a number or a one-dimensional array of numbers in {}",
            si(parameter)
        ))
    };
    let array = floats(
        given,
        " (a NaN, not None, makes a row without a drive)",
        &refuse,
    )?;
    match array.cast::<PyArray1<f64>>() {
        Ok(array) => Ok(Column::Each(array.clone().unbind())),
        Err(_) => {
            let shape = array.getattr("shape")?;
            // an array without dimensions is a single number
            if shape.len()? == 0 {
                Ok(Column::Same(array.extract()?))
            } else {
                Err(refuse(format!("has shape {shape}")))
            }
        }
    }
}

/// Converts whole numbers and floats to an array of 64-bit floats of any shape. `refuse` makes the
/// error for other values. `missing` is advice on missing values for its message.
pub fn floats<'py>(
    given: &Bound<'py, PyAny>,
    missing: &str,
    refuse: &dyn Fn(String) -> Failure,
) -> Answer<Bound<'py, PyAny>> {
    let numpy = given.py().import("numpy")?;
    if given.is_instance_of::<PyList>() || given.is_instance_of::<PyTuple>() {
        // NumPy converts True among numbers to 1
        let truth = numpy.getattr("bool_")?;
        for (at, item) in given.try_iter()?.enumerate() {
            let item = item?;
            if item.is_instance_of::<PyBool>() || item.is_instance(&truth)? {
                return Err(refuse(format!(
                    "has the truth value {item} as element {at}"
                )));
            }
        }
    }
    let array = numpy
        .call_method1("asanyarray", (given,))
        .map_err(|error| refuse(format!("is no array ({})", error.value(given.py()))))?;
    // do not import numpy.ma here: another thread may fork during the import
    if array.hasattr("mask")? {
        return Err(refuse(format!("is a masked array: fill it{missing}")));
    }
    let array = numpy.call_method1("asarray", (array,))?;
    let array = array
        .cast::<PyUntypedArray>()
        .map_err(|_| refuse("is no array".into()))?;
    let kind = array.dtype().kind();
    // only whole numbers and floats are quantities
    if !matches!(kind, b'i' | b'u' | b'f') {
        // an array with None has Python objects as elements
        let objects = if kind == b'O' { missing } else { "" };
        return Err(refuse(format!("has dtype {}{objects}", array.dtype())));
    }
    let converted = array.call_method1("astype", ("f8", "K", "safe", true, false));
    converted.map_err(|_| {
        refuse(format!(
            "has dtype {}, which 64-bit floats do not hold",
            array.dtype()
        ))
    })
}

fn si(parameter: &Parameter) -> &'static str {
    if parameter.quantity.si.is_empty() {
        "numbers without a unit"
    } else {
        parameter.quantity.si
    }
}

impl Points for Arrays {
    fn parameters(&self) -> &[&'static Parameter] {
        &self.parameters
    }

    fn ranges(&self) -> Vec<Vary> {
        self.ranges.clone()
    }

    fn rows(&self) -> u64 {
        self.rows as u64
    }

    fn seek(&mut self, row: u64) -> longdrive::Result<()> {
        self.next = usize::try_from(row).unwrap_or(usize::MAX).min(self.rows);
        (self.first, self.gathered) = (self.next, vec![]);
        Ok(())
    }

    fn read(&mut self, most: usize, values: &mut Vec<f64>) -> Result<usize, Error> {
        let width = self.columns.len();
        let known = self.gathered.len() / width.max(1);
        if self.next == self.first + known && self.next < self.rows {
            // reading the arrays needs Python's lock
            Python::attach(|py| self.gather(py));
        }
        let begin = self.next - self.first;
        let rows = most.min(self.gathered.len() / width.max(1) - begin);
        values.extend_from_slice(&self.gathered[begin * width..(begin + rows) * width]);
        self.next += rows;
        Ok(rows)
    }

    fn identity(&self) -> String {
        format!("{} rows of arrays", self.rows)
    }
}
