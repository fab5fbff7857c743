//! Numbers, ranges, and objects of named values in the JSON of a result.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A number or `null`. JSON has no infinity: the radius of a flat face is `"inf"`, as in setup
/// files, and a range without a lower end has the low value `"-inf"`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct JsonNumber(pub Option<f64>);

impl From<f64> for JsonNumber {
    fn from(value: f64) -> Self {
        Self(Some(value))
    }
}

impl From<Option<f64>> for JsonNumber {
    fn from(value: Option<f64>) -> Self {
        Self(value)
    }
}

impl Serialize for JsonNumber {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0 {
            Some(f64::INFINITY) => serializer.serialize_str("inf"),
            Some(f64::NEG_INFINITY) => serializer.serialize_str("-inf"),
            // the sum turns -0 into 0
            Some(value) if value.is_finite() => serializer.serialize_f64(value + 0.0),
            _ => serializer.serialize_none(),
        }
    }
}

impl<'de> Deserialize<'de> for JsonNumber {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        use serde_json::Value;
        match Value::deserialize(deserializer)? {
            Value::Null => Ok(Self(None)),
            Value::Number(number) => Ok(Self(number.as_f64())),
            Value::String(text) if text == "inf" => Ok(Self(Some(f64::INFINITY))),
            Value::String(text) if text == "-inf" => Ok(Self(Some(f64::NEG_INFINITY))),
            other => Err(D::Error::custom(format!(
                "{other} is not a number, \"inf\", \"-inf\" or null"
            ))),
        }
    }
}

#[cfg(test)]
impl schemars::JsonSchema for JsonNumber {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Number".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "description": "A number in SI units and radians; null if it does not exist.",
            "anyOf": [{ "type": ["number", "null"] }, { "enum": ["inf", "-inf"] }]
        })
    }
}

/// A range of values; an infinite end is `"-inf"` or `"inf"`.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema), schemars(rename = "Range"))]
pub struct JsonRange {
    /// Lower end, SI.
    pub low: JsonNumber,
    /// Upper end, SI.
    pub high: JsonNumber,
}

/// Serializes the ends of a range as a [`JsonRange`], and `None` as `null`.
pub fn range<T: Copy + Into<Option<[f64; 2]>>, S: Serializer>(
    ends: &T,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    let ends: Option<[f64; 2]> = (*ends).into();
    let range = ends.map(|[low, high]| JsonRange {
        low: low.into(),
        high: high.into(),
    });
    range.serialize(serializer)
}

/// Serializes a field as a [`JsonNumber`].
pub fn number<T: Copy + Into<JsonNumber>, S: Serializer>(
    value: &T,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    (*value).into().serialize(serializer)
}

/// Serializes values by name, in order, as an object of [`JsonNumber`]s.
pub fn numbers_by_name<N: Serialize, S: Serializer>(
    values: &[(N, f64)],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_map(
        values
            .iter()
            .map(|(name, value)| (name, JsonNumber(Some(*value)))),
    )
}

/// Serializes values by name, in order, as an object.
pub fn by_name<N: Serialize, V: Serialize, S: Serializer>(
    values: &[(N, V)],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_map(values.iter().map(|(name, value)| (name, value)))
}

#[cfg(test)]
mod tests {
    use super::JsonNumber;

    #[test]
    fn exact_numbers_after_writing_and_reading() {
        for value in [
            Some(0.1),
            Some(f64::INFINITY),
            Some(f64::NEG_INFINITY),
            None,
        ] {
            let text = serde_json::to_string(&JsonNumber(value)).unwrap();
            assert_eq!(
                serde_json::from_str::<JsonNumber>(&text).unwrap(),
                JsonNumber(value)
            );
        }
        assert!(serde_json::from_str::<JsonNumber>("\"infinite\"").is_err());
    }
}
