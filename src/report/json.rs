//! Values in the JSON of a report: ranges, vectors, matrices, and values by name.

pub use crate::json::{JsonNumber, JsonRange};

use crate::atmosphere::in_effect;
use crate::json::by_name;
use crate::number::Vector;
use crate::parameters::{GOLFER, LAW, METHOD, SPEED_OF, Setup, TABLE, Vary};
use crate::study::{Active, BoundSide};
use serde::{Serialize, Serializer};
use std::borrow::Cow;

/// The components of a vector: up, right, downrange.
pub(super) fn components(vector: Vector<f64>) -> [JsonNumber; 3] {
    vector.to_array().map(JsonNumber::from)
}

/// Values by name. In JSON they are an object with the members in this order.
#[derive(Clone, Debug, PartialEq)]
pub struct ByName<V>(pub Vec<(Cow<'static, str>, V)>);

impl ByName<JsonNumber> {
    /// Values of varied parameters.
    pub(super) fn of_varied(vary: &[Vary], values: &[f64]) -> Self {
        let names = vary.iter().map(|vary| vary.parameter.name);
        names.zip(values.iter().copied()).collect()
    }
}

impl ByName<BoundSide> {
    /// The active bound of each parameter that is at a bound.
    pub(super) fn of_bounds(active: &[Active]) -> Self {
        let bounds = active.iter();
        bounds
            .filter_map(|active| Some((active.name.clone(), active.end?)))
            .collect()
    }
}

impl<V, N: Into<Cow<'static, str>>, U: Into<V>> FromIterator<(N, U)> for ByName<V> {
    fn from_iter<I: IntoIterator<Item = (N, U)>>(pairs: I) -> Self {
        let pairs = pairs.into_iter();
        Self(
            pairs
                .map(|(name, value)| (name.into(), value.into()))
                .collect(),
        )
    }
}

impl<V: Serialize> Serialize for ByName<V> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        by_name(&self.0, serializer)
    }
}

#[cfg(test)]
impl<V: schemars::JsonSchema> schemars::JsonSchema for ByName<V> {
    fn schema_name() -> Cow<'static, str> {
        format!("ByName_of_{}", V::schema_name()).into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        <std::collections::BTreeMap<String, V>>::json_schema(generator)
    }
}

/// A matrix whose rows and columns are parameters.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Matrix {
    /// The parameters of the rows and columns.
    pub names: Vec<&'static str>,
    /// The rows.
    pub values: Vec<Vec<JsonNumber>>,
}

impl Matrix {
    /// The matrix over the parameters `names`, with `entry(row, column)` as entries.
    pub(super) fn new<N: Into<JsonNumber>>(
        names: impl IntoIterator<Item = &'static str>,
        entry: impl Fn(usize, usize) -> N,
    ) -> Self {
        let names: Vec<&str> = names.into_iter().collect();
        let all = 0..names.len();
        let row = |row: usize| -> Vec<JsonNumber> {
            let entries = all.clone().map(|column| entry(row, column).into());
            entries.collect()
        };
        let values = all.clone().map(row).collect();
        Self { names, values }
    }
}

/// The value of a parameter: a number, or the name of a choice.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum Setting {
    /// A number in SI, or radians.
    Number(JsonNumber),
    /// The name of a choice, such as a law, or the file of a table.
    Choice(String),
}

/// Every parameter of a setup by its dotted name, with its value in the drive, and the choices:
/// hand, point of the club speed, law, method.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(extend(
    "properties" = choices(),
    "required" = [GOLFER, SPEED_OF, LAW, METHOD]
)))]
pub struct Settings(ByName<Setting>);

#[cfg(test)]
fn choices() -> serde_json::Value {
    use crate::parameters::{Golfer, Method, SpeedOf};
    let of = |names: &[&str]| serde_json::json!({ "enum": names });
    serde_json::json!({
        GOLFER: of(&Golfer::NAMES),
        SPEED_OF: of(&SpeedOf::NAMES),
        METHOD: of(&Method::NAMES),
        LAW: { "type": "string" },
        TABLE: { "type": "string" }
    })
}

/// Every parameter and choice of a setup. If the setup states weather, density and viscosity are
/// computed from the weather. If it states a wind direction, the wind components are computed from
/// the direction.
pub(super) fn settings(setup: &Setup<f64>) -> Settings {
    let setup = &in_effect(setup);
    let choice = |name: &'static str| Some((name, Setting::Choice(setup.choice(name)?.to_owned())));
    let mut all: Vec<(&'static str, Setting)> = Vec::from_iter(choice(GOLFER));
    let mut has_law = false;
    for parameter in setup.parameters() {
        if parameter.law.is_some() && !has_law {
            has_law = true;
            all.extend(choice(LAW));
            all.extend(choice(TABLE));
        }
        let value = setup.value(parameter).into();
        all.push((parameter.name, Setting::Number(value)));
        if parameter.name == "swing.speed" {
            all.extend(choice(SPEED_OF));
        }
        if parameter.name == "flight.step" {
            all.extend(choice(METHOD));
        }
    }
    Settings(all.into_iter().collect())
}
