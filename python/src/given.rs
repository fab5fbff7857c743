//! Values of Python for the parameters of a setup: numbers, texts with units, quantities of pint,
//! nested or dotted dicts.

use crate::boundary::{Answer, Failure, kind_of, shown, text_of};
use longdrive::Setup;
use longdrive::parameters::{CHOICES, Kind, LAW, Law, SettingText, TABLE, UNSET};
use longdrive::units::Quantity;
use pyo3::exceptions::PyOverflowError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyMapping, PyString};
use std::collections::HashSet;

/// The key that names the preset from which a dict starts, as in a setup file.
pub const PRESET: &str = "preset";

/// Largest depth of nested dicts, because a dict may contain itself. Names such as
/// `club.inertia.xx` need three levels.
const DEEPEST: usize = 4;

/// True if the argument `angles` names degrees as the unit of angles that are given as numbers.
/// False for radians, and without this argument.
pub fn are_degrees(angles: Option<&Bound<'_, PyAny>>) -> Answer<bool> {
    let Some(angles) = angles else {
        return Ok(false);
    };
    let name = angles.extract::<String>().unwrap_or_default();
    match name.as_str() {
        "rad" => Ok(false),
        "deg" => Ok(true),
        _ => Err(Failure::Input(format!(
            "angles = {}; expected 'rad' or 'deg'",
            shown(angles)
        ))),
    }
}

/// Parameter and value (rad) of an angle that Python gave without a unit.
pub type BareAngle = (String, f64);

/// A parameter with its value from Python.
pub struct Given<'py> {
    /// The dotted name of the parameter.
    pub name: String,
    value: Bound<'py, PyAny>,
}

impl Given<'_> {
    /// Returns true for the text that unsets a parameter.
    pub fn is_unset(&self) -> bool {
        self.value
            .cast::<PyString>()
            .is_ok_and(|text| text == UNSET)
    }

    /// The value as a text, and true if this text is a number in SI without its unit.
    fn text(&self, setup: &Setup<f64>) -> Answer<(String, bool)> {
        let value = &self.value;
        if value.is_none() {
            // an unknown name is an error later
            let may_be_unset = match setup.parameter(&self.name) {
                Ok(row) => row.kind == Kind::Optional,
                Err(_) => !CHOICES.contains(&self.name.as_str()),
            };
            return if may_be_unset {
                Ok((UNSET.into(), false))
            } else {
                Err(self.lacks_value(setup))
            };
        }
        if let Ok(text) = value.cast::<PyString>() {
            return Ok((
                text_of(&format!("'{}'", self.name), text)?.to_owned(),
                false,
            ));
        }
        if let Some(number) = self.of_pint(setup)? {
            return Ok((format!("{number:?}"), true));
        }
        match value.extract::<f64>() {
            // Python treats True as the number 1
            Ok(number) if !is_bool(value) => Ok((format!("{number:?}"), true)),
            Err(error) if error.is_instance_of::<PyOverflowError>(value.py()) => {
                Err(Failure::Input(format!(
                    "'{}' = {} is too large for a 64-bit float, which ends at 1.8e308",
                    self.name,
                    shown(value)
                )))
            }
            _ => {
                if !CHOICES.contains(&self.name.as_str()) {
                    setup.parameter(&self.name)?;
                }
                let kind = kind_of(value);
                let expected = "expected a number (SI), a text like \"10.5 deg\", or None for what \
                                may be unset";
                Err(Failure::Input(format!(
                    "'{}' is {kind}; {expected}",
                    self.name
                )))
            }
        }
    }

    fn is_of_pint(&self) -> bool {
        ["to", "magnitude", "units"]
            .iter()
            .all(|name| self.value.hasattr(*name).unwrap_or(false))
    }

    /// The error of None for a parameter that needs a value.
    fn lacks_value(&self, setup: &Setup<f64>) -> Failure {
        let name = &self.name;
        let wanted = match setup.parameter(name) {
            Ok(row) if row.quantity.si.is_empty() => "a number".to_owned(),
            Ok(row) => format!(
                "a number in {}, or a text with its unit like \"{}\"",
                row.quantity.si,
                row.show(row.default_value())
            ),
            Err(_) if name == TABLE => {
                "the name of a CSV file with a table of drag and lift".into()
            }
            Err(_) => "a name in quotes".into(),
        };
        Failure::Input(format!(
            "'{name}' is None, and cannot be unset; expected {wanted}, or leave it out"
        ))
    }

    /// The SI number of a quantity of pint; `None` for another value. The check looks at the
    /// attributes of the value, because pint need not be installed.
    fn of_pint(&self, setup: &Setup<f64>) -> Answer<Option<f64>> {
        if !self.is_of_pint() {
            return Ok(None);
        }
        let (py, si) = (self.value.py(), setup.parameter(&self.name)?.quantity.si);
        let in_si = py.import("longdrive.quantities")?.getattr("to_si")?;
        let number = in_si
            .call1((&self.value, si))
            .and_then(|number| number.extract());
        let refused = |error: PyErr| Failure::Input(format!("{}: {}", self.name, error.value(py)));
        number.map(Some).map_err(refused)
    }
}

/// True for a bool of Python or NumPy.
fn is_bool(value: &Bound<'_, PyAny>) -> bool {
    let name = value.get_type().name();
    value.is_instance_of::<PyBool>() || name.is_ok_and(|name| name == "bool" || name == "bool_")
}

/// The entries of a dict under their dotted names. A name may repeat.
pub fn flattened<'py>(dict: &Bound<'py, PyAny>) -> Answer<Vec<Given<'py>>> {
    let Ok(mapping) = dict.cast::<PyMapping>() else {
        return Err(Failure::Input(format!(
            "a setup cannot be made of {}; give the name of a preset, or a dict like \
             {{\"preset\": \"tour-average\", \
             \"club.loft\": \"10.5 deg\"}}; a file is read by Setup.read",
            kind_of(dict)
        )));
    };
    let mut all = vec![];
    flatten(mapping, "", 1, &mut all)?;
    Ok(all)
}

/// Refuses a repeated name.
pub fn refuse_repeated(all: &[Given<'_>]) -> Answer<()> {
    first_repeated(all.iter().map(|given| given.name.as_str())).map_or(Ok(()), |twice| {
        Err(Failure::Input(format!(
            "'{twice}' is given twice; keep one"
        )))
    })
}

/// The first name that repeats an earlier one.
pub fn first_repeated<'a>(names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let mut known = HashSet::new();
    names.into_iter().find(|name| !known.insert(*name))
}

/// Collects the entries of a nested dict; `depth` is 1 for the outermost dict.
fn flatten<'py>(
    dict: &Bound<'py, PyMapping>,
    prefix: &str,
    depth: usize,
    all: &mut Vec<Given<'py>>,
) -> Answer<()> {
    for item in dict.items()?.iter() {
        let (key, value): (Bound<'_, PyAny>, Bound<'_, PyAny>) = item.extract()?;
        let Ok(key) = key.cast::<PyString>() else {
            return Err(Failure::Input(format!(
                "the key {} of a setup is no text; expected a name like 'club.loft'",
                shown(&key)
            )));
        };
        let name = format!("{prefix}{}", text_of("a name of a setup", key)?);
        match value.cast::<PyMapping>() {
            Ok(_) if depth == DEEPEST => {
                return Err(Failure::Input(format!(
                    "'{name}' is a dict within {DEEPEST} others, or within itself; a name has \
                     three parts at most, as \
                     'club.inertia.xx' has: give {{\"club\": {{\"inertia\": {{\"xx\": …}}}}}}, or \
                     {{\"club.inertia.xx\": …}}"
                )));
            }
            // an empty dict for a group sets nothing
            Ok(inner) if inner.is_empty()? && is_group(&name) => {}
            Ok(inner) if !inner.is_empty()? => flatten(inner, &format!("{name}."), depth + 1, all)?,
            _ => all.push(Given { name, value }),
        }
    }
    Ok(())
}

/// Returns true for the name of a group of parameters, including groups of coefficients that only
/// another law has.
fn is_group(name: &str) -> bool {
    let begins = |row: &str| {
        row.strip_prefix(name)
            .is_some_and(|rest| rest.starts_with('.'))
    };
    let setup = Setup::<f64>::modern_driver();
    setup
        .parameters()
        .into_iter()
        .chain(Law::all_rows())
        .any(|row| begins(row.name))
}

/// Sets the parameters `given`. Numbers without a unit are SI, but angles are in degrees if
/// `in_degrees`. Returns the angles that were given as numbers in radians.
pub fn apply(
    setup: &mut Setup<f64>,
    given: &[Given<'_>],
    in_degrees: bool,
) -> Answer<Vec<BareAngle>> {
    // the law determines which coefficients exist
    let mut of_law = *setup;
    let is_choice = |given: &&Given<'_>| matches!(given.name.as_str(), LAW | TABLE);
    for choice in given.iter().filter(is_choice) {
        // ignore errors in this choice here: the loop below reports them
        let _ = of_law.set(&choice.name, &choice.text(setup)?.0);
    }
    let mut texts = given
        .iter()
        .map(|given| given.text(&of_law))
        .collect::<Answer<Vec<_>>>()?;
    let mut bare_angles = vec![];
    for (given, (text, is_bare)) in given.iter().zip(&mut texts) {
        let is_angle = of_law
            .parameter(&given.name)
            .is_ok_and(|row| row.quantity == Quantity::ANGLE);
        if !is_angle || !*is_bare || given.is_of_pint() {
            continue;
        }
        let Ok(number) = text.parse::<f64>() else {
            continue;
        };
        if in_degrees {
            *text = format!("{:?}", number.to_radians());
        } else {
            bare_angles.push((given.name.clone(), number));
        }
    }
    let settings: Vec<_> = given
        .iter()
        .zip(&texts)
        .map(|(given, (text, is_bare))| SettingText {
            name: &given.name,
            text: text.into(),
            is_bare: *is_bare,
        })
        .collect();
    setup.set_each(&settings)?;
    Ok(bare_angles)
}

/// Removes the name of the preset from the entries of a dict, and returns it; `None` if the dict
/// names no preset.
pub fn preset(given: &mut Vec<Given<'_>>) -> Answer<Option<String>> {
    let Some(at) = given.iter().position(|given| given.name == PRESET) else {
        return Ok(None);
    };
    let named = given.remove(at);
    match named.value.cast::<PyString>() {
        Ok(name) => Ok(Some(text_of("'preset'", name)?.to_owned())),
        Err(_) => Err(Failure::Input(format!(
            "'preset' is {}; expected the name of a preset in quotes",
            shown(&named.value)
        ))),
    }
}
