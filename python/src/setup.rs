//! `Setup`: everything a drive depends on.

use crate::boundary::{Answer, Failure, answer, kind_of, shown, text_of};
use crate::given::{self, BareAngle, PRESET, are_degrees};
use crate::pool;
use longdrive::atmosphere::in_effect;
use longdrive::command::refuse_idle;
use longdrive::integration::{Integration, StepChoice};
use longdrive::parameters::{
    CHOICES, DEFAULT_PRESET, GOLFER, LAW, Law, METHOD, Parameter, SPEED_OF, SetupFile, TABLE, TURF,
    is_of_step, is_of_strike,
};
use longdrive::report::{ChangedSetting, changes, given_toml, setup_toml};
use longdrive::units::System;
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyIterator, PyList, PyMapping, PyString};
use std::hash::{Hash, Hasher};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, OnceLock};

/// Largest `flight.time_limit`, s, for which the step is chosen on the thread of Python. Up to this
/// limit, the choice takes at most tenths of a second.
const LONG_FLIGHT: f64 = 600.0;

/// Number of changes that `repr` shows.
const SHOWN: usize = 4;

/// All parameters of a drive: head, swing, strike, ball, air, ground, and integration of the flight.
///
/// ``Setup()`` is the preset ``tour-average``, ``Setup("modern-driver")`` another preset. A dict
/// starts from its ``preset`` (without one ``tour-average``, as a setup file) and has nested or
/// dotted names. A number is SI (m, kg, s, rad, K); a text has its unit; a quantity of pint is
/// converted. None unsets an optional parameter.
///
/// A setup is an immutable mapping: ``replace`` and ``|`` make another one. Setups are equal if
/// their parameters are equal, and if both or neither state ``flight.method`` or ``flight.step``:
/// if these are not stated, functions of many drives choose a step.
///
/// Parameters
/// ----------
/// given : Setup, str or dict, optional
///     A setup, the name of a preset, or a dict.
/// angles : {"rad", "deg"}
///     The unit of angles without a unit.
///
/// Raises
/// ------
/// InputError
///     For an unknown name, and a value outside its range.
///
/// Warns
/// -----
/// LongdriveWarning
///     For an angle in radians that was probably meant in degrees.
///
/// Examples
/// --------
/// >>> import longdrive
/// >>> setup = longdrive.Setup({"club": {"loft": "10.5 deg"}, "swing.speed": "110 mph"})
/// >>> setup["swing.speed"]
/// 49.1744
/// >>> setup
/// <longdrive.Setup tour-average with club speed 110 mph, club loft 10.5°>
/// >>> (setup | {"club.loft": "11 deg"}) == setup.replace({"club.loft": "11 deg"})
/// True
/// >>> longdrive.Setup({"club.loft": 10.5}, angles="deg")["club.loft"]
/// 0.1832595714594046
#[pyclass(name = "Setup", module = "longdrive", frozen, eq, hash)]
#[derive(Clone)]
pub struct PySetup {
    /// The setup itself.
    pub setup: longdrive::Setup<f64>,
    /// The preset or file on which the setup is based, with the parameters that Python gives.
    pub file: Arc<SetupFile>,
    /// Method and step for an error of a micrometre, chosen when a function first needs them.
    chosen: Arc<OnceLock<Arc<Integration>>>,
}

/// A setup from Python in a call.
struct CallSetup {
    setup: PySetup,
    /// Parameters that a dict in place of a setup states, except launch conditions. A dict must
    /// state all conditions of a launch, also those that a column replaces.
    stated: Vec<String>,
    /// Angles that the dict gives as numbers.
    bare_angles: Vec<BareAngle>,
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
            self.setup.states_step,
        )
            .hash(state);
    }
}

impl PySetup {
    /// The setup of a preset.
    pub fn of_preset(name: &str) -> Answer<Self> {
        // one setup for each preset, so that its step is chosen only once. The thread that holds
        // this lock also holds Python's lock, so no other thread can fork the process meanwhile
        static KNOWN: Mutex<Vec<PySetup>> = Mutex::new(vec![]);
        let mut known = pool::lock(&KNOWN);
        if let Some(read) = known.iter().find(|read| read.file.preset.name == name) {
            return Ok(read.clone());
        }
        let is_file = || name.ends_with(".toml") || Path::new(name).is_file();
        let file = match SetupFile::of_preset(name) {
            Err(_) if is_file() => {
                return Err(Failure::Input(format!(
                    "{name:?} is a file, not a preset; Setup.read({name:?}) reads it"
                )));
            }
            file => file?,
        };
        let read = Self::based_on(file.setup, Arc::new(file));
        known.push(read.clone());
        Ok(read)
    }

    fn based_on(setup: longdrive::Setup<f64>, file: Arc<SetupFile>) -> Self {
        Self {
            setup,
            file,
            chosen: Arc::default(),
        }
    }

    /// Method and step for the drive of this setup. The choice for an error of a micrometre is
    /// cached.
    pub fn integration(&self, py: Python<'_>, choice: StepChoice) -> Answer<Arc<Integration>> {
        let is_usual = choice == StepChoice::Micrometre;
        if let Some(known) = self.chosen.get().filter(|_| is_usual) {
            return Ok(Arc::clone(known));
        }
        let setup = self.setup;
        let is_long = !choice.is_own(&setup) && setup.flight.time_limit > LONG_FLIGHT;
        let found = pool::run_drive(py, is_long, move |stop| {
            choice.for_setup_until(&setup, stop)
        });
        let found = Arc::new(found??);
        if is_usual {
            // another thread may have stored its equal result first
            let _ = self.chosen.set(Arc::clone(&found));
        }
        Ok(found)
    }

    /// A setup from Python: a setup, the name of a preset, a dict, or None for the preset
    /// `tour-average`. Refuses values of a dict that have no effect, and warns of its angles.
    pub fn of(given: &Bound<'_, PyAny>) -> Answer<Self> {
        let call = Self::of_call(given, false, None)?;
        call.setup.refuse_idle(&call.stated, &[], "")?;
        call.setup.warn_of(given.py(), call.bare_angles)?;
        Ok(call.setup)
    }

    /// A setup as the argument of a call. A dict that names no preset starts from `base`, by
    /// default the preset `tour-average`.
    fn of_call(
        given: &Bound<'_, PyAny>,
        in_degrees: bool,
        base: Option<&Self>,
    ) -> Answer<CallSetup> {
        let setup = if let Ok(setup) = given.cast::<Self>() {
            setup.get().clone()
        } else if given.is_none() {
            Self::of_preset(DEFAULT_PRESET)?
        } else if let Ok(name) = given.cast::<PyString>() {
            Self::of_preset(text_of("setup", name)?)?
        } else {
            return Self::of_dict(given, in_degrees, base);
        };
        Ok(CallSetup {
            setup,
            stated: vec![],
            bare_angles: vec![],
        })
    }

    fn of_dict(
        dict: &Bound<'_, PyAny>,
        in_degrees: bool,
        base: Option<&Self>,
    ) -> Answer<CallSetup> {
        let mut given = given::flattened(dict)?;
        given::refuse_repeated(&given)?;
        let preset = given::preset(&mut given)?;
        let base = match (preset, base) {
            (Some(preset), _) => Self::of_preset(&preset)?,
            (None, Some(base)) => base.clone(),
            (None, None) => Self::of_preset(DEFAULT_PRESET)?,
        };
        let (setup, bare_angles) = base.with(&given, in_degrees)?;
        let names = given.into_iter().map(|given| given.name);
        Ok(CallSetup {
            setup,
            stated: names.filter(|name| !name.starts_with("launch.")).collect(),
            bare_angles,
        })
    }

    /// Refuses `stated` parameters without effect, as the commands do. `columns` have a value of
    /// their own in each drive; `why` is the reason for the message.
    pub fn refuse_idle(
        &self,
        stated: &[String],
        columns: &[&'static Parameter],
        why: &str,
    ) -> Answer<()> {
        if stated.is_empty() {
            return Ok(());
        }
        let content = SetupFile {
            setup: self.setup,
            ..SetupFile::clone(&self.file)
        };
        Ok(refuse_idle(content, stated, columns, why)?)
    }

    /// The warning about changed values of the club, if the launch is given.
    fn warning_of_club(&self) -> Answer<Option<String>> {
        if !self.setup.launch.is_given() {
            return Ok(None);
        }
        let changed = self.changes()?;
        let names = changed.iter().map(|change| change.key);
        let names: Vec<_> = names.filter(|name| is_of_strike(name)).collect();
        Ok((!names.is_empty()).then(|| {
            let names = names.join(", ");
            format!("not used, since the drive is given by its launch: {names}")
        }))
    }

    /// Warns of angles that were probably meant in degrees.
    fn warn_of(&self, py: Python<'_>, bare_angles: Vec<BareAngle>) -> Answer<()> {
        if !bare_angles.is_empty() {
            py.import("longdrive.angles")?
                .getattr("warn_of_angles")?
                .call1((bare_angles, self.clone()))?;
        }
        Ok(())
    }

    /// Like [`of`](Self::of). Without an argument, returns the preset `tour-average`.
    pub fn of_any(given: Option<&Bound<'_, PyAny>>) -> Answer<Self> {
        given.map_or_else(|| Self::of_preset(DEFAULT_PRESET), Self::of)
    }

    fn of_file(file: SetupFile) -> Answer<Self> {
        file.setup.validate_values()?;
        Ok(Self::based_on(file.setup, Arc::new(file)))
    }

    /// Changes the values of some parameters. Returns also the angles that were given as numbers.
    fn with(&self, given: &[given::Given<'_>], in_degrees: bool) -> Answer<(Self, Vec<BareAngle>)> {
        let mut setup = self.setup;
        let bare_angles = given::apply(&mut setup, given, in_degrees)?;
        // refuse a stated value that has no effect because other parameters, such as the weather,
        // replace it
        let base = longdrive::Setup::preset(self.file.preset.name)?;
        let of_base = base.parameters();
        let is_given = |row: &&&'static Parameter| {
            given.iter().any(|given| given.name == row.name)
                || base.value(row) != setup.value(row) && of_base.contains(row)
        };
        // a parameter that the call sets to "none" is not stated
        let is_back = |row: &Parameter| {
            given
                .iter()
                .any(|given| given.name == row.name && given.is_unset())
        };
        let rows = setup.parameters();
        let set = rows
            .iter()
            .filter(is_given)
            .filter(|row| setup.value(row).is_some() && !is_back(row));
        let names: Vec<_> = set.map(|row| row.name).collect();
        setup.refuse_replaced(&names)?;
        setup.validate_values()?;
        let mut file = SetupFile::clone(&self.file);
        for change in given {
            for row in setup.set_by(&change.name) {
                file.given.retain(|given| *given != row);
                if !change.is_unset() {
                    file.given.push(row);
                }
            }
        }
        Ok((Self::based_on(setup, Arc::new(file)), bare_angles))
    }

    fn changes(&self) -> Answer<Vec<ChangedSetting>> {
        Ok(changes(&self.setup, self.file.preset, System::default())?)
    }

    fn item<'py>(&self, py: Python<'py>, name: &str) -> Answer<Bound<'py, PyAny>> {
        let setup = &self.setup;
        if name == PRESET {
            return Ok(self.file.preset.name.into_bound_py_any(py)?);
        }
        if name == TURF {
            let message = format!(
                "'{TURF}' only chooses the other numbers of the ground, which the setup has: \
                 setup[\"ground.restitution\"]"
            );
            return Err(Failure::Key(message));
        }
        if CHOICES.contains(&name) {
            return Ok(setup.choice(name).into_bound_py_any(py)?);
        }
        let row = setup
            .parameter(name)
            .map_err(|error| Failure::Key(error.to_string()))?;
        // the weather, or the wind's speed and direction, determine the value
        let is_replaced = setup.why_replaced(row).is_some();
        let value = if is_replaced {
            in_effect(setup).value(row)
        } else {
            setup.value(row)
        };
        Ok(value.into_bound_py_any(py)?)
    }

    /// The names of the choices and parameters that determine the setup. A parameter that follows
    /// from others is not among them.
    fn names(&self) -> Vec<&'static str> {
        let used = self
            .setup
            .parameters()
            .into_iter()
            .filter(|row| self.setup.why_replaced(row).is_none())
            .map(|row| row.name);
        let table = self.setup.law.table().map(|_| TABLE);
        [PRESET, GOLFER, SPEED_OF, LAW, METHOD]
            .into_iter()
            .chain(table)
            .chain(used)
            // an unstated step is not part of the setup: each request chooses it again
            .filter(|name| self.setup.states_step || !is_of_step(name))
            .collect()
    }

    /// Hash of the user's table of drag and lift. A setup file contains only the name of this
    /// table's file.
    fn table(&self) -> Option<String> {
        self.setup.law.table().map(|table| format!("{table:?}"))
    }

    /// The preset, and the choices and values that differ from it or are given.
    fn differences<'py>(&self, py: Python<'py>) -> Answer<Bound<'py, PyDict>> {
        let (own, mut base) = (
            &self.setup,
            longdrive::Setup::preset(self.file.preset.name)?,
        );
        let differences = PyDict::new(py);
        differences.set_item(PRESET, self.file.preset.name)?;
        let states_step = own.states_step && !base.states_step;
        let table = own
            .law
            .table()
            .map(|table| std::path::absolute(&table.file));
        let table = table.transpose().map_err(PyErr::from)?;
        let choices = [
            (LAW, own.law.name() != base.law.name() && table.is_none()),
            (METHOD, states_step || own.method != base.method),
            (GOLFER, own.golfer != base.golfer),
            (SPEED_OF, own.speed_of != base.speed_of),
        ];
        for (name, _) in choices.into_iter().filter(|(_, differs)| *differs) {
            differences.set_item(name, own.choice(name))?;
        }
        if let Some(table) = table {
            differences.set_item(TABLE, table.display().to_string())?;
        }
        // if the preset has another law, show only coefficients that differ from the published
        // coefficients of this setup's law
        base.law = if own.law.name() == base.law.name() {
            base.law
        } else {
            Law::named(own.law.name()).unwrap_or(base.law)
        };
        let replaced = |row: &Parameter| own.why_replaced(row).is_some();
        for row in own.parameters() {
            let is_given = self.file.given.contains(&row);
            if (is_given || own.value(row) != base.value(row)) && !replaced(row) {
                differences.set_item(row.name, own.value(row))?;
            }
        }
        Ok(differences)
    }

    fn toml(&self) -> Answer<String> {
        Ok(setup_toml(&self.setup, &self.file, &[], &[])?)
    }
}

/// The state of a pickled setup: its preset with the values that differ from it, and the hash of
/// the content of its table.
type State<'py> = (Bound<'py, PyDict>, Option<String>);

impl PySetup {
    /// The setup with changes, and the angles that were given as numbers.
    fn replaced(
        &self,
        changes: Option<&Bound<'_, PyAny>>,
        angles: Option<&Bound<'_, PyAny>>,
        named: Option<&Bound<'_, PyDict>>,
    ) -> Answer<(Self, Vec<BareAngle>)> {
        let in_degrees = are_degrees(angles)?;
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
        self.with(&all, in_degrees)
    }
}

/// The error of an argument of a wrong type.
fn not_of_the_kind(name: &str, given: &Bound<'_, PyAny>, expected: &str) -> Failure {
    Failure::Input(format!("{name} is {}; expected {expected}", kind_of(given)))
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

#[pymethods]
impl PySetup {
    #[new]
    #[pyo3(signature = (given = None, /, *, angles = None))]
    fn new(given: Option<&Bound<'_, PyAny>>, angles: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        answer(|| {
            let in_degrees = are_degrees(angles)?;
            match given {
                Some(given)
                    if given.cast::<PyMapping>().is_ok() && !given.is_instance_of::<Self>() =>
                {
                    let call = Self::of_dict(given, in_degrees, None)?;
                    call.setup.warn_of(given.py(), call.bare_angles)?;
                    Ok(call.setup)
                }
                given => Self::of_any(given),
            }
        })
    }

    /// Reads a setup file, TOML as the program's.
    ///
    /// Parameters
    /// ----------
    /// path
    ///     The file, a text or a path.
    ///
    /// Raises
    /// ------
    /// InputError
    ///     For a file that cannot be read, with line and column of the error.
    #[staticmethod]
    fn read(path: &Bound<'_, PyAny>) -> PyResult<Self> {
        answer(|| {
            if let Ok(name) = path.cast::<PyString>() {
                // `fsencode` refuses a lone surrogate that does not stand for a byte of a file name
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
    /// Parameters
    /// ----------
    /// text
    ///     TOML.
    /// file
    ///     Name of the text in messages.
    ///
    /// Examples
    /// --------
    /// >>> import longdrive
    /// >>> longdrive.Setup.from_toml("preset = 'mae494'\n[club]\nloft = '12 deg'")["club.loft"]
    /// 0.20943951023931956
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

    /// The setup for an argument of a function, the parameters that a dict states, and its angles
    /// without a unit. A dict that names no preset starts from `base`.
    #[staticmethod]
    fn _of_call(
        given: &Bound<'_, PyAny>,
        angles: &Bound<'_, PyAny>,
        base: Option<&Self>,
    ) -> PyResult<(Self, Vec<String>, Vec<BareAngle>)> {
        answer(|| {
            let call = Self::of_call(given, are_degrees(Some(angles))?, base)?;
            Ok((call.setup, call.stated, call.bare_angles))
        })
    }

    /// Refuses stated parameters without effect; see `longdrive.setups.CallSetup.refuse_idle`.
    fn _refuse_idle(
        &self,
        stated: Vec<String>,
        columns: Vec<Bound<'_, PyString>>,
        why: &str,
    ) -> PyResult<()> {
        answer(|| {
            // an unknown column is refused later
            let rows = columns
                .iter()
                .filter_map(|name| self.setup.parameter(&name.to_string_lossy()).ok());
            self.refuse_idle(&stated, &rows.collect::<Vec<_>>(), why)
        })
    }

    /// The warning about values of the club that a given launch replaces, in a list.
    fn _warnings_of_club(&self) -> PyResult<Vec<String>> {
        answer(|| Ok(self.warning_of_club()?.into_iter().collect()))
    }

    #[staticmethod]
    fn _from_state(differences: &Bound<'_, PyAny>, table: Option<&str>) -> PyResult<Self> {
        answer(|| {
            let mut given = given::flattened(differences)?;
            let preset = given::preset(&mut given)?;
            let base = Self::of_preset(preset.as_deref().unwrap_or(DEFAULT_PRESET))?;
            let (read, _) = base.with(&given, false)?;
            if read.table().as_deref() == table {
                return Ok(read);
            }
            let file = read
                .setup
                .law
                .table()
                .map_or("", |table| table.file.as_str());
            Err(Failure::Input(format!(
                "the table of drag and lift '{file}' is not what it was when the setup was \
                 pickled; make the setup anew"
            )))
        })
    }

    /// A setup with other values of some parameters.
    ///
    /// Parameters
    /// ----------
    /// changes : dict, optional
    ///     Names with values, as in the constructor.
    /// angles : {"rad", "deg"}
    ///     The unit of angles without a unit.
    /// **named
    ///     Names with values, as keywords; ``**{"club.loft": "11 deg"}`` for dotted names.
    ///
    /// Returns
    /// -------
    /// Setup
    ///     The new setup.
    ///
    /// Examples
    /// --------
    /// >>> import longdrive
    /// >>> setup = longdrive.Setup().replace({"club.loft": "11 deg"}, swing={"speed": 50})
    /// >>> setup["swing.speed"]
    /// 50.0
    #[pyo3(signature = (changes = None, /, *, angles = None, **named))]
    fn replace(
        &self,
        py: Python<'_>,
        changes: Option<&Bound<'_, PyAny>>,
        angles: Option<&Bound<'_, PyAny>>,
        named: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        answer(|| {
            let (setup, bare_angles) = self.replaced(changes, angles, named)?;
            setup.warn_of(py, bare_angles)?;
            Ok(setup)
        })
    }

    /// The setup with computed values, SI; large angles get no warning.
    fn _with_values(&self, values: &Bound<'_, PyAny>) -> PyResult<Self> {
        answer(|| Ok(self.replaced(Some(values), None, None)?.0))
    }

    /// ``setup | changes``: a setup with other values of some parameters, as :meth:`replace`.
    fn __or__(&self, changes: &Bound<'_, PyAny>) -> PyResult<Py<PyAny>> {
        let py = changes.py();
        if changes.cast::<PyMapping>().is_err() {
            return Ok(py.NotImplemented());
        }
        self.replace(py, Some(changes), None, None)?.into_py_any(py)
    }

    /// The value of a parameter in SI, None if it is unset; a choice such as ``aero.law`` as a
    /// text. A parameter that follows from others (``air.density`` from the weather, ``wind.right``
    /// from ``wind.speed``) has the value that the drive uses, as in :func:`longdrive.parameters`.
    /// It is not among the :meth:`keys`, which make the setup.
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

    /// Returns true for the name of a choice, or of a parameter of this setup, also of an unset
    /// one.
    fn __contains__(&self, name: &Bound<'_, PyAny>) -> bool {
        let Ok(name) = name.cast::<PyString>() else {
            return false;
        };
        let name = name.to_string_lossy();
        let is_choice = name == PRESET || (name != TURF && CHOICES.contains(&&*name));
        is_choice || self.setup.parameter(&name).is_ok()
    }

    /// The names of the choices and parameters that make the setup, without parameters that other
    /// parameters determine.
    fn keys<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.to_dict(py)?.call_method0("keys")
    }

    /// The values, in the order of :meth:`keys`.
    fn values<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.to_dict(py)?.call_method0("values")
    }

    /// Pairs of a name and its value, in the order of :meth:`keys`.
    fn items<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.to_dict(py)?.call_method0("items")
    }

    /// The value of a name, or `default` for an unknown name.
    ///
    /// Examples
    /// --------
    /// >>> import longdrive
    /// >>> longdrive.Setup().get("club.colour", "black")
    /// 'black'
    #[pyo3(signature = (name, default = None, /))]
    fn get<'py>(
        &self,
        py: Python<'py>,
        name: &Bound<'_, PyAny>,
        default: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        match self.__contains__(name) {
            true => self.__getitem__(py, name),
            false => Ok(default.unwrap_or_else(|| py.None().into_bound(py))),
        }
    }

    /// Iterates over the names.
    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyIterator>> {
        PyList::new(py, self.names())?.try_iter()
    }

    fn __len__(&self) -> usize {
        self.names().len()
    }

    /// The preset on which the setup is based.
    #[getter]
    fn preset(&self) -> &'static str {
        self.file.preset.name
    }

    /// The setup as an argument of a command: the name of its preset and false, or the text of a
    /// setup file and true. The text gives what Python gives; it has method and step only if the
    /// setup states them.
    fn _for_command(&self) -> PyResult<(String, bool)> {
        answer(|| {
            let is_preset = self.setup == longdrive::Setup::preset(self.file.preset.name)?;
            if is_preset && self.file.given.is_empty() {
                return Ok((self.file.preset.name.to_owned(), false));
            }
            Ok((given_toml(&self.setup, &self.file)?, true))
        })
    }

    /// The setup as the text of a setup file. Each number has its source, or the comment of the
    /// file from which it was read. Reading the text gives the same setup to the last bit.
    fn to_toml(&self) -> PyResult<String> {
        answer(|| self.toml())
    }

    /// The setup as a dict of dotted names: numbers in SI, None for unset parameters, choices as
    /// texts. ``Setup(setup.to_dict())`` is the same setup.
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
            let warnings = self.setup.warnings();
            let warnings = warnings
                .iter()
                .map(|message| message.in_units(System::default()));
            Ok(warnings.chain(self.warning_of_club()?).collect())
        })
    }

    fn __repr__(&self) -> PyResult<String> {
        answer(|| {
            let changes = self.changes()?;
            let base = longdrive::Setup::preset(self.file.preset.name)?;
            let shown = changes
                .iter()
                .take(SHOWN)
                .map(|change| format!("{} {}", change.name, change.to));
            let mut shown: Vec<_> = shown.collect();
            if changes.len() > SHOWN {
                shown.push(format!("{} more changes", changes.len() - SHOWN));
            }
            if self.setup.states_step != base.states_step {
                shown.push("stated flight.method and flight.step".into());
            }
            let with = if shown.is_empty() {
                String::new()
            } else {
                format!(" with {}", shown.join(", "))
            };
            Ok(format!("<longdrive.Setup {}{with}>", self.file.preset.name))
        })
    }

    /// A table for notebooks: the differences from the preset.
    fn _repr_html_(&self) -> PyResult<String> {
        answer(|| {
            let changes = self.changes()?;
            let caption = format!("<caption>setup: preset {}</caption>", self.file.preset.name);
            let row = |change: &ChangedSetting| {
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

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, State<'py>)> {
        answer(|| {
            let made = py.get_type::<Self>().getattr("_from_state")?;
            Ok((made, (self.differences(py)?, self.table())))
        })
    }

    fn __copy__(slf: Py<Self>) -> Py<Self> {
        slf
    }

    fn __deepcopy__(slf: Py<Self>, _memo: &Bound<'_, PyAny>) -> Py<Self> {
        slf
    }
}
