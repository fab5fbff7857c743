//! Outcomes and parameters by name, and the lists of both.

use crate::boundary::{Answer, Failure, answer, kind_of, text_of};
use crate::given::{first_repeated, flattened};
use crate::json::to_python;
use crate::setup::PySetup;
use longdrive::command::{quantity_of, quantity_of_goal};
use longdrive::derivative::{all_variables, default_variables};
use longdrive::drive::OutcomeGroup;
use longdrive::parameters::Parameter;
use longdrive::report::{ParametersReport, PresetsReport, Reply};
use longdrive::{Outcome, Setup};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PySequence, PyString};

/// The names in `given`: one, or several. `what` is the name of the argument in messages.
pub fn listed(what: &str, given: &Bound<'_, PyAny>) -> Answer<Vec<String>> {
    // a NumPy array is no `Sequence` of Python, but its list is one
    if given.hasattr("dtype")? && given.hasattr("tolist")? && !given.is_instance_of::<PyString>() {
        return listed(what, &given.call_method0("tolist")?);
    }
    if let Ok(name) = given.cast::<PyString>() {
        return Ok(vec![text_of(what, name)?.to_owned()]);
    }
    let Ok(names) = given.cast::<PySequence>() else {
        let kind = kind_of(given);
        return Err(Failure::Input(format!(
            "{what} is {kind}; expected a name or a list of names"
        )));
    };
    let named = |(at, name): (usize, Bound<'_, PyAny>)| match name.cast::<PyString>() {
        Ok(name) => Ok(text_of(&format!("{what}[{at}]"), name)?.to_owned()),
        Err(_) => Err(Failure::Input(format!(
            "{what}[{at}] is {}; expected a name",
            kind_of(&name)
        ))),
    };
    names.to_list()?.iter().enumerate().map(named).collect()
}

/// The outcomes with these names. "all" means all outcomes of a drive. A repeated name is an error.
pub fn outcomes_named(names: &[String]) -> Answer<Vec<Outcome>> {
    let mut of = vec![];
    for name in names {
        let named = if name == "all" {
            Outcome::OF_DRIVES.to_vec()
        } else {
            vec![Outcome::named(name)?]
        };
        of.extend(named);
    }
    refuse_repeated("of", of.iter().map(|of| of.name()))?;
    Ok(of)
}

/// The parameters to differentiate these outcomes by, with the default of the program.
pub fn variables(
    setup: &Setup<f64>,
    of: &[Outcome],
    given: Option<&Bound<'_, PyAny>>,
) -> Answer<Vec<&'static Parameter>> {
    let Some(given) = given else {
        return Ok(default_variables(setup)?);
    };
    let names = listed("wrt", given)?;
    if names == ["all"] {
        return Ok(all_variables(setup, of));
    }
    refuse_repeated("wrt", names.iter().map(String::as_str))?;
    Ok(setup.variables_named(names)?)
}

/// Refuses a repeated name, which would have two places in an array.
pub fn refuse_repeated<'a>(what: &str, names: impl IntoIterator<Item = &'a str>) -> Answer<()> {
    first_repeated(names).map_or(Ok(()), |twice| {
        Err(Failure::Input(format!(
            "{what} names '{twice}' twice; keep one"
        )))
    })
}

/// The dotted names of the parameters in a dict that describes a setup.
#[pyfunction]
pub fn parameter_names_in(dict: &Bound<'_, PyAny>) -> PyResult<Vec<String>> {
    answer(|| {
        Ok(flattened(dict)?
            .into_iter()
            .map(|given| given.name)
            .collect())
    })
}

/// The names of the outcomes and of the parameters to differentiate by.
#[pyfunction]
pub fn requested_names<'py>(
    setup: &Bound<'py, PyAny>,
    of: &Bound<'py, PyAny>,
    wrt: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Vec<&'static str>, Vec<&'static str>)> {
    answer(|| {
        let of = outcomes_named(&listed("of", of)?)?;
        let wrt = variables(&PySetup::of(setup)?.setup, &of, wrt)?;
        Ok((
            of.iter().map(|of| of.name()).collect(),
            wrt.iter().map(|row| row.name).collect(),
        ))
    })
}

/// The SI unit of a parameter or an outcome; None for an unknown name.
#[pyfunction]
pub fn unit_of(name: &str) -> Option<&'static str> {
    quantity_of(name).map(|quantity| quantity.si)
}

/// The SI unit of a goal such as ``mean(carry)``; empty for a goal without a unit.
#[pyfunction]
pub fn unit_of_goal(goal: &str) -> &'static str {
    quantity_of_goal(goal).map_or("", |quantity| quantity.si)
}

/// True if a value, SI, is outside of the range of its parameter.
#[pyfunction]
pub fn is_out_of_range(name: &str, value: f64) -> bool {
    Setup::<f64>::modern_driver()
        .parameter(name)
        .is_ok_and(|row| !row.range.contains(value))
}

/// The message for an unknown key, with the nearest known key and the advice.
#[pyfunction]
pub fn unknown_key(
    what: &str,
    key: &Bound<'_, PyAny>,
    keys: Vec<String>,
    advice: String,
) -> PyResult<String> {
    let what = ["column", "parameter"]
        .into_iter()
        .find(|known| *known == what)
        .unwrap_or("outcome");
    let key = key.str()?;
    let key = key.to_string_lossy();
    Ok(longdrive::Error::unknown(what, &key, keys.iter().map(String::as_str), advice).to_string())
}

/// Every parameter of a setup with its value, range, unit and meaning, as ``longdrive parameters
/// --json``.
///
/// Parameters
/// ----------
/// setup : Setup, str or dict, optional
///     A setup, the name of a preset, or a dict.
///
/// Returns
/// -------
/// dict
///     The parameters under ``parameters``.
///
/// Examples
/// --------
/// >>> import longdrive
/// >>> rows = {row["parameter"]: row for row in longdrive.parameters()["parameters"]}
/// >>> rows["swing.speed"]["unit"]
/// 'm/s'
#[pyfunction]
#[pyo3(signature = (setup = None))]
pub fn parameters<'py>(
    py: Python<'py>,
    setup: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    answer(|| {
        let setup = PySetup::of_any(setup)?.setup;
        let report = ParametersReport::new(&setup);
        to_python(py, &Reply::of(&report, setup.warnings()))
    })
}

/// Every preset with its numbers and their sources, as ``longdrive presets --json``.
///
/// Returns
/// -------
/// dict
///     The presets under ``presets``.
///
/// Examples
/// --------
/// >>> import longdrive
/// >>> "mae494" in [preset["name"] for preset in longdrive.presets()["presets"]]
/// True
#[pyfunction]
pub fn presets(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    answer(|| to_python(py, &Reply::of(&PresetsReport::new(None)?, vec![])))
}

/// Every outcome.
///
/// Returns
/// -------
/// list of dict
///     For each outcome its ``name``, ``symbol``, ``si`` unit, usual ``unit``, ``doc``, and
///     ``part``: ``launch``, ``flight`` or ``head``. Outcomes of the head must be named:
///     ``of="all"`` means all other outcomes.
///
/// Examples
/// --------
/// >>> import longdrive
/// >>> {row["name"]: row["si"] for row in longdrive.outcomes()}["carry"]
/// 'm'
#[pyfunction]
pub fn outcomes(py: Python<'_>) -> PyResult<Bound<'_, PyList>> {
    answer(|| {
        let all = PyList::empty(py);
        for outcome in Outcome::OF_DRIVES.iter().chain(Outcome::OF_HEAD) {
            let part = match outcome.group() {
                OutcomeGroup::Launch => "launch",
                OutcomeGroup::Flight => "flight",
                OutcomeGroup::Head => "head",
            };
            let row = PyDict::new(py);
            row.set_item("name", outcome.name())?;
            row.set_item("symbol", outcome.symbol())?;
            row.set_item("si", outcome.quantity().si)?;
            row.set_item("unit", outcome.unit())?;
            row.set_item("doc", outcome.doc())?;
            row.set_item("part", part)?;
            all.append(row)?;
        }
        Ok(all)
    })
}
