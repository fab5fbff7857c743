//! `Setup`: everything a drive depends on.

use crate::boundary::{Answer, Failure, answer, kind_of, shown, text_of};
use crate::given::{self, PRESET};
use longdrive::atmosphere::in_effect;
use longdrive::parameters::{
    DEFAULT_PRESET, GOLFER, LAW, METHOD, Parameter, Preset, SPEED_OF, SetupFile, TABLE, TURF,
};
use longdrive::report::{Change, changes, setup_toml, setup_toml_without_step};
use longdrive::units::System;
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyIterator, PyList, PyString};
use std::hash::{Hash, Hasher};
use std::path::{Path, PathBuf};

/// Changes that a short text shows.
const SHOWN: usize = 4;

/// Everything a drive depends on: head, swing, strike, ball, air, ground and how the flight is
/// integrated.
///
/// ``Setup()`` is the preset ``tour-average``, ``Setup("modern-driver")`` another one, and a dict
/// starts from its ``preset`` (without one: ``tour-average``, as a setup file does) with nested or
/// dotted names:
///
/// >>> import longdrive
/// >>> setup = longdrive.Setup({"preset": "tour-average", "club": {"loft": "10.5 deg"}, "swing.speed": "110 mph"})
/// >>> setup["swing.speed"]
/// 49.1744
/// >>> setup
/// <longdrive.Setup tour-average with club speed 110 mph, club loft 10.5°>
///
/// A number is SI (m, kg, s, rad, K); a text carries its unit; a quantity of pint is converted.
/// None unsets what may be unset. A setup cannot be changed: ``replace`` makes another one. Setups
/// are equal whose numbers and choices are.
#[pyclass(name = "Setup", module = "longdrive", frozen, eq, hash)]
#[derive(Clone, Copy)]
pub struct PySetup {
    /// The setup itself.
    pub setup: longdrive::Setup<f64>,
    /// The preset that it started from.
    pub preset: &'static Preset,
    /// True if flight.method or flight.step was stated.
    pub gives_step: bool,
}

impl PartialEq for PySetup {
    fn eq(&self, other: &Self) -> bool {
        self.setup == other.setup
    }
}

impl Hash for PySetup {
    fn hash<H: Hasher>(&self, state: &mut H) {
        for parameter in self.setup.parameters() {
            // 0 and −0 are equal
            self.setup
                .value(parameter)
                .map(|value| (value + 0.0).to_bits())
                .hash(state);
        }
        (
            self.setup.law.name(),
            self.setup.method.name(),
            self.setup.golfer.name(),
        )
            .hash(state);
    }
}

impl PySetup {
    /// A preset, unchanged.
    pub fn of_preset(name: &str) -> Answer<Self> {
        let setup = longdrive::Setup::preset(name).map_err(|error| not_a_preset(name, error))?;
        let preset = Preset::named(name)
            .ok_or_else(|| Failure::Input(format!("unknown preset '{name}'")))?;
        let gives_step = preset.entries.iter().any(|entry| is_of_step(entry.name));
        Ok(Self {
            setup,
            preset,
            gives_step,
        })
    }

    /// A setup from Python: a setup, the name of a preset, a dict, or None for the preset
    /// `tour-average`.
    pub fn of(given: &Bound<'_, PyAny>) -> Answer<Self> {
        if let Ok(setup) = given.cast::<Self>() {
            return Ok(*setup.get());
        }
        if given.is_none() {
            return Self::of_preset(DEFAULT_PRESET);
        }
        if let Ok(name) = given.cast::<PyString>() {
            return Self::of_preset(text_of("setup", name)?);
        }
        let mut given = given::flattened(given)?;
        given::refuse_repeated(&given)?;
        let preset = given::preset(&mut given)?;
        Self::of_preset(preset.as_deref().unwrap_or(DEFAULT_PRESET))?.with(&given)
    }

    /// A setup from Python, or None.
    pub fn of_any(given: Option<&Bound<'_, PyAny>>) -> Answer<Self> {
        given.map_or_else(|| Self::of_preset(DEFAULT_PRESET), Self::of)
    }

    fn of_file(file: SetupFile) -> Answer<Self> {
        file.setup.validate_but_launch()?;
        Ok(Self {
            setup: file.setup,
            preset: file.preset,
            gives_step: file.gives_step,
        })
    }

    /// Changes the values of some parameters.
    fn with(mut self, given: &[given::Given<'_>]) -> Answer<Self> {
        given::apply(&mut self.setup, given)?;
        self.gives_step |= given.iter().any(|given| is_of_step(&given.name));
        // a value given before must not be replaced in silence by what it follows from
        let base = longdrive::Setup::preset(self.preset.name)?;
        let is_given = |row: &&&'static Parameter| {
            given.iter().any(|given| given.name == row.name)
                || base
                    .parameter(row.name)
                    .is_ok_and(|_| base.value(row) != self.setup.value(row))
        };
        // a parameter unset by "none" is not given
        let is_back = |row: &Parameter| {
            given
                .iter()
                .any(|given| given.name == row.name && given.is_unset())
        };
        let rows = self.setup.parameters();
        let set = rows
            .iter()
            .filter(is_given)
            .filter(|row| self.setup.value(row).is_some() && !is_back(row));
        let names: Vec<_> = set.map(|row| row.name).collect();
        self.setup.refuse_replaced(&names)?;
        self.setup.validate_but_launch()?;
        Ok(self)
    }

    fn changes(&self) -> Answer<Vec<Change>> {
        Ok(changes(&self.setup, self.preset, System::default())?)
    }

    /// The value of a parameter or choice.
    fn item<'py>(&self, py: Python<'py>, name: &str) -> Answer<Bound<'py, PyAny>> {
        let setup = &self.setup;
        let choice = match name {
            LAW => Some(setup.law.name()),
            METHOD => Some(setup.method.name()),
            GOLFER => Some(setup.golfer.name()),
            SPEED_OF => Some(setup.speed_of.name()),
            PRESET => Some(self.preset.name),
            TABLE if setup.law.table().is_none() => return Ok(py.None().into_bound(py)),
            TABLE => setup.law.table().map(|table| table.file()),
            _ => None,
        };
        Ok(match choice {
            Some(choice) => choice.into_bound_py_any(py)?,
            None if name == TURF => {
                let told = format!(
                    "'{TURF}' only chooses the other numbers of the ground, which the setup has: \
                     setup[\"ground.restitution\"]"
                );
                return Err(Failure::Key(told));
            }
            None => {
                let row = setup
                    .parameter(name)
                    .map_err(|error| Failure::Key(error.to_string()))?;
                // what follows from the weather, or from the wind's speed and direction, is what
                // the drive has
                let is_replaced = setup.why_replaced(row).is_some();
                let value = if is_replaced {
                    in_effect(setup).value(row)
                } else {
                    setup.value(row)
                };
                value.into_bound_py_any(py)?
            }
        })
    }

    /// The names of the choices and parameters that make the setup, without those that follow from
    /// others.
    fn names(&self) -> Vec<&'static str> {
        let used = self
            .setup
            .parameters()
            .into_iter()
            .filter(|row| self.setup.why_replaced(row).is_none());
        let table = self.setup.law.table().map(|_| TABLE);
        [PRESET, GOLFER, SPEED_OF, LAW, METHOD]
            .into_iter()
            .chain(table)
            .chain(used.map(|row| row.name))
            .collect()
    }

    /// The content of the user's own table of drag and lift: setup files have its name only.
    fn table(&self) -> Option<String> {
        self.setup.law.table().map(|table| format!("{table:?}"))
    }

    fn toml(&self) -> Answer<String> {
        Ok(setup_toml(&self.setup, self.preset, &[], &[])?)
    }
}

/// The state of a pickled setup: its text, whether the step was stated, and the content of its
/// table.
type State = (String, bool, Option<String>);

/// The error of an argument of a wrong type.
fn not_of_the_kind(name: &str, given: &Bound<'_, PyAny>, expected: &str) -> Failure {
    Failure::Input(format!("{name} is {}; expected {expected}", kind_of(given)))
}

/// The error of an unknown preset; for the name of a file, with the function that reads it.
fn not_a_preset(name: &str, error: longdrive::Error) -> Failure {
    if name.ends_with(".toml") || Path::new(name).is_file() {
        return Failure::Input(format!(
            "{name:?} is a file, and no preset; Setup.read({name:?}) reads it"
        ));
    }
    error.into()
}

fn is_of_step(name: &str) -> bool {
    matches!(name, METHOD | "flight.step")
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

#[pymethods]
impl PySetup {
    #[new]
    #[pyo3(signature = (given = None, /))]
    fn new(given: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        answer(|| Self::of_any(given))
    }

    /// Reads a setup file, TOML as the program's.
    ///
    /// Args:
    ///     path: the file, a text or a path.
    ///
    /// Raises:
    ///     InputError: for a file that cannot be read, with line and column of what is wrong.
    #[staticmethod]
    fn read(path: &Bound<'_, PyAny>) -> PyResult<Self> {
        answer(|| {
            if let Ok(name) = path.cast::<PyString>() {
                // only names of files may have surrogates for bytes
                path.py()
                    .import("os")?
                    .getattr("fsencode")?
                    .call1((name,))?;
            }
            let file: PathBuf = path
                .extract()
                .map_err(|_| not_of_the_kind("path", path, "the name of a file"))?;
            Self::of_file(SetupFile::open(&file)?)
        })
    }

    /// Reads the text of a setup file.
    ///
    /// >>> import longdrive
    /// >>> longdrive.Setup.from_toml("preset = 'mae494'\n[club]\nloft = '12 deg'")["club.loft"]
    /// 0.20943951023931953
    ///
    /// Args:
    ///     text: TOML.
    ///     file: what messages call it.
    #[staticmethod]
    #[pyo3(signature = (text, file = "setup.toml"))]
    fn from_toml(text: &Bound<'_, PyAny>, file: &str) -> PyResult<Self> {
        answer(|| {
            let toml = text
                .cast::<PyString>()
                .map_err(|_| not_of_the_kind("text", text, "the text of a setup file"))?;
            Self::of_file(SetupFile::read(text_of("text", toml)?, file)?)
        })
    }

    #[staticmethod]
    fn _from_state(toml: &str, gives_step: bool, table: Option<&str>) -> PyResult<Self> {
        answer(|| {
            let read = Self {
                gives_step,
                ..Self::of_file(SetupFile::read(toml, "a pickled setup")?)?
            };
            if read.table().as_deref() == table {
                return Ok(read);
            }
            let file = read.setup.law.table().map_or("", |table| table.file());
            Err(Failure::Input(format!(
                "the table of drag and lift '{file}' is not what it was when the setup was \
                 pickled; make the setup anew"
            )))
        })
    }

    /// Another setup, with other values of some parameters.
    ///
    /// >>> import longdrive
    /// >>> setup = longdrive.Setup().replace({"club.loft": "11 deg"}, swing={"speed": 50})
    /// >>> setup["swing.speed"]
    /// 50.0
    ///
    /// Args:
    ///     changes: names with values, as in the constructor.
    ///     named: the same by keyword; ``**{"club.loft": "11 deg"}`` for dotted names.
    #[pyo3(signature = (changes = None, /, **named))]
    fn replace(
        &self,
        changes: Option<&Bound<'_, PyAny>>,
        named: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        answer(|| {
            let mut all = changes.map_or_else(|| Ok(vec![]), given::flattened)?;
            if let Some(named) = named {
                all.extend(given::flattened(named.as_any())?);
            }
            given::refuse_repeated(&all)?;
            if let Some(preset) = given::preset(&mut all)? {
                let message = format!(
                    "'preset' = '{preset}': a setup keeps the preset it started from; make another \
                     with Setup({{\"preset\": …}})"
                );
                return Err(Failure::Input(message));
            }
            self.with(&all)
        })
    }

    /// The value of a parameter in SI, None where it is unset; a choice such as ``aero.law`` as a
    /// text. What follows from other parameters that are set (``air.density`` from the weather,
    /// ``wind.right`` from ``wind.speed``) has the value that the drive has, as in
    /// :func:`longdrive.parameters`; it is not among the :meth:`keys`, which make the setup.
    fn __getitem__<'py>(
        &self,
        py: Python<'py>,
        name: &Bound<'_, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        answer(|| match name.cast::<PyString>() {
            Ok(name) => self.item(py, &name.to_string_lossy()),
            Err(_) => Err(Failure::Key(format!(
                "{} is no name of a setup; expected one like 'club.loft'",
                shown(name)
            ))),
        })
    }

    /// Returns true if the name has a value.
    fn __contains__(&self, name: &Bound<'_, PyAny>) -> bool {
        let Ok(name) = name.cast::<PyString>() else {
            return false;
        };
        let name = name.to_string_lossy();
        [LAW, METHOD, GOLFER, SPEED_OF, PRESET, TABLE].contains(&&*name)
            || self.setup.parameter(&name).is_ok()
    }

    /// The names of the choices and parameters that make the setup, without those that follow from
    /// others.
    fn keys(&self) -> Vec<&'static str> {
        self.names()
    }

    /// Through the names, as through those of a dict.
    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyIterator>> {
        PyList::new(py, self.names())?.try_iter()
    }

    fn __len__(&self) -> usize {
        self.names().len()
    }

    /// The preset that it started from.
    #[getter]
    fn preset(&self) -> &'static str {
        self.preset.name
    }

    /// The setup for a command: the name of its preset or the text of a setup file, and true for a
    /// text. The text has method and step if they were stated.
    fn _asked(&self) -> PyResult<(String, bool)> {
        answer(|| {
            let is_chosen_anew = self.gives_step
                && !self
                    .preset
                    .entries
                    .iter()
                    .any(|entry| is_of_step(entry.name));
            if self.setup == longdrive::Setup::preset(self.preset.name)? && !is_chosen_anew {
                return Ok((self.preset.name.to_owned(), false));
            }
            if self.gives_step {
                return Ok((self.toml()?, true));
            }
            // those of the preset follow from its name, and nobody has chosen them
            Ok((setup_toml_without_step(&self.setup, self.preset)?, true))
        })
    }

    /// The setup as the text of a setup file, every number with its source; it reads back as the
    /// same setup to the last bit.
    #[expect(clippy::wrong_self_convention, reason = "an object of Python is lent")]
    fn to_toml(&self) -> PyResult<String> {
        answer(|| self.toml())
    }

    /// The setup as a dict of dotted names: numbers in SI, None for what is unset, choices as
    /// texts. ``Setup(setup.to_dict())`` is the same setup.
    #[expect(clippy::wrong_self_convention, reason = "an object of Python is lent")]
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        answer(|| {
            let dict = PyDict::new(py);
            for name in self.names() {
                dict.set_item(name, self.item(py, name)?)?;
            }
            Ok(dict)
        })
    }

    /// The warnings about the setup, a list of sentences.
    fn warnings(&self) -> PyResult<Vec<String>> {
        answer(|| {
            let mut told: Vec<_> = self
                .setup
                .warnings()
                .iter()
                .map(|message| message.in_units(System::default()))
                .collect();
            if self.setup.launch.is_given() {
                let changed = self.changes()?;
                let of_club = changed
                    .iter()
                    .filter_map(|change| change.parameter)
                    .filter(|row| row.is_of_strike());
                let names: Vec<_> = of_club.map(|row| row.name).collect();
                if !names.is_empty() {
                    told.push(format!(
                        "not used, since the drive is given by its launch: {}",
                        names.join(", ")
                    ));
                }
            }
            Ok(told)
        })
    }

    fn __repr__(&self) -> PyResult<String> {
        answer(|| {
            let changes = self.changes()?;
            let shown = changes
                .iter()
                .take(SHOWN)
                .map(|change| format!("{} {}", change.name, change.to));
            let mut shown: Vec<_> = shown.collect();
            if changes.len() > SHOWN {
                shown.push(format!("{} more changes", changes.len() - SHOWN));
            }
            let with = if shown.is_empty() {
                String::new()
            } else {
                format!(" with {}", shown.join(", "))
            };
            Ok(format!("<longdrive.Setup {}{with}>", self.preset.name))
        })
    }

    /// A table for notebooks: what differs from the preset.
    fn _repr_html_(&self) -> PyResult<String> {
        answer(|| {
            let changes = self.changes()?;
            let caption = format!("<caption>setup: preset {}</caption>", self.preset.name);
            let row = |change: &Change| {
                let cells = [&change.name, &change.to, &change.from]
                    .map(|text| format!("<td>{}</td>", escaped(text)));
                format!("<tr>{}</tr>", cells.concat())
            };
            let head = "<thead><tr><th>parameter</th><th>value</th><th>preset</th></tr></thead>";
            let rows: String = changes.iter().map(row).collect();
            Ok(format!(
                "<table>{caption}{head}<tbody>{rows}</tbody></table>"
            ))
        })
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, State)> {
        answer(|| {
            let made = py.get_type::<Self>().getattr("_from_state")?;
            Ok((made, (self.toml()?, self.gives_step, self.table())))
        })
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }
}
