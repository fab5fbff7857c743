//! Parts that the requests share: a setup, and ranges of parameters.

use crate::refusal::Refusal;
use crate::words::in_page_words;
use longdrive::parameters::{DEFAULT_PRESET, LAW, SettingText, SetupFile, UNSET, Vary};
use longdrive::units::{Message, System};
use longdrive::{Error, Outcome, Setup};
use serde::Deserialize;
use serde_json::{Map, Value};

/// The name of a setup file in messages.
const SETUP_FILE: &str = "setup";

/// A setup: a preset or a setup file, and changes.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct SetupRequest {
    preset: Option<String>,
    toml: Option<String>,
    set: Map<String, Value>,
}

/// A parameter and its range.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RangeRequest {
    name: String,
    low: Value,
    high: Value,
}

/// The setup of a request, and the units of its messages.
#[derive(Clone, Debug)]
pub struct CheckedSetup<'a> {
    /// The checked setup.
    pub setup: Setup<f64>,
    /// The units of messages.
    pub system: System,
    /// The part of the request that states the setup.
    text: &'a SetupRequest,
}

impl SetupRequest {
    /// Makes the setup, and checks it.
    ///
    /// # Errors
    /// The message of the program for an unknown name, and for a value that it does not accept.
    pub fn read(&self, system: System) -> Result<CheckedSetup<'_>, Refusal> {
        let mut checked = CheckedSetup {
            setup: Setup::modern_driver(),
            system,
            text: self,
        };
        if self.preset.is_some() && self.toml.is_some() {
            return Err(Refusal::of_request(
                "preset and toml are both given; keep one",
            ));
        }
        checked.setup = self.source().map_err(|error| checked.refused(&error))?;
        if let Some(Value::String(law)) = self.set.get(LAW) {
            // a refusal has the values of this law's coefficients; `set_each` refuses a wrong law
            checked.setup.set_law(law).ok();
        }
        let settings = self.set.iter();
        let settings = settings.map(|(name, value)| setting_of(name, value));
        let settings: Vec<_> = settings.collect::<Result<_, _>>()?;
        let mut setup = checked.setup;
        let applied = setup.set_each(&settings).and_then(|()| setup.validate());
        applied.map_err(|error| checked.refused(&error))?;
        Ok(CheckedSetup { setup, ..checked })
    }

    fn source(&self) -> Result<Setup<f64>, Error> {
        match (&self.toml, &self.preset) {
            (Some(text), _) => SetupFile::read(text, SETUP_FILE).map(|file| file.setup),
            (None, Some(preset)) => Setup::preset(preset),
            (None, None) => Setup::preset(DEFAULT_PRESET),
        }
    }
}

/// The setting of a parameter to a value in JSON.
fn setting_of<'a>(name: &'a str, value: &'a Value) -> Result<SettingText<'a>, Refusal> {
    let text = match value {
        Value::Null => UNSET.into(),
        Value::String(text) => text.into(),
        Value::Number(number) => format!("{:?}", number.as_f64().unwrap_or(f64::NAN)).into(),
        other => {
            let why =
                format!("{name} is {other}; expected a number in SI, a text with a unit, or null");
            return Err(Refusal::of_request(&why));
        }
    };
    Ok(SettingText {
        name,
        text,
        is_bare: value.is_number(),
    })
}

impl CheckedSetup<'_> {
    /// The refusal with the message of an error, the parameters that it names, and the values of
    /// the texts in the request.
    pub fn refused(&self, error: &Error) -> Refusal {
        let names = self.text.set.keys().map(String::as_str);
        let mut refusal = Refusal::of(error, self.system, &self.setup, names);
        for (name, value) in self.stated() {
            refusal.stated.push(name.to_owned());
            refusal.values.push(value);
        }
        refusal
    }

    /// The parameters that `set` states by a text, such as `10 km/h`, with their values in SI.
    /// Texts without a value are left out.
    pub fn stated(&self) -> impl Iterator<Item = (&str, f64)> {
        self.text.set.iter().filter_map(|(name, value)| {
            let parameter = self.setup.parameter(name).ok()?;
            let value = parameter.read(value.as_str()?, false).ok()??;
            Some((name.as_str(), value))
        })
    }

    /// A message in the units of the request.
    pub fn text(&self, message: &Message) -> String {
        in_page_words(&message.in_units(self.system))
    }

    /// The outcomes of these names. A repeated name is an error, so that a request cannot exhaust
    /// the memory.
    ///
    /// # Errors
    /// For an unknown or repeated name.
    pub fn outcomes(&self, names: &[String]) -> Result<Vec<Outcome>, Refusal> {
        let named = |name: &String| Outcome::named(name).map_err(|error| self.refused(&error));
        let outcomes: Vec<_> = names.iter().map(named).collect::<Result<_, _>>()?;
        let is_twice = |at: &usize| outcomes[..*at].contains(&outcomes[*at]);
        match (0..outcomes.len()).find(is_twice) {
            None => Ok(outcomes),
            Some(at) => {
                let why = format!("{} is given twice in of; name it once", names[at]);
                Err(Refusal::of_request(&why))
            }
        }
    }

    /// The range of a parameter.
    ///
    /// # Errors
    /// For an unknown name, an end that is not a value of the parameter, and a reversed range.
    pub fn range(&self, range: &RangeRequest) -> Result<Vary, Refusal> {
        let read = || {
            let parameter = self.setup.variable(&range.name)?;
            let end = |value: &Value| {
                let setting = setting_of(&range.name, value).ok();
                setting.map_or(Ok(None), |end| parameter.read(&end.text, end.is_bare))
            };
            let missing = || Error::SearchRange {
                name: range.name.clone(),
                reason: "give it two ends, low and high".into(),
            };
            let low = end(&range.low)?.ok_or_else(missing)?;
            let high = end(&range.high)?.ok_or_else(missing)?;
            Vary::new(parameter, low, high)
        };
        read().map_err(|error: Error| self.refused(&error))
    }
}
