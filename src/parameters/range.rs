use crate::json::number;
use crate::units::{Quantity, significant};
use serde::Serialize;

/// The allowed values of a parameter: all physically possible values, not just usual values.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(
    test,
    derive(schemars::JsonSchema),
    schemars(rename = "ParameterRange")
)]
pub struct Range {
    /// Lower end, SI.
    #[serde(serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub low: f64,
    /// True if the lower end is allowed.
    pub low_included: bool,
    /// Upper end, SI.
    #[serde(serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub high: f64,
    /// True if the upper end is allowed.
    pub high_included: bool,
}

impl Range {
    /// low ≤ value ≤ high.
    pub const fn from_to(low: f64, high: f64) -> Self {
        Self {
            low,
            high,
            low_included: true,
            high_included: true,
        }
    }

    /// low < value < high.
    pub const fn between(low: f64, high: f64) -> Self {
        Self {
            low,
            high,
            low_included: false,
            high_included: false,
        }
    }

    /// low < value ≤ high.
    pub const fn above_to(low: f64, high: f64) -> Self {
        Self {
            low,
            high,
            low_included: false,
            high_included: true,
        }
    }

    /// −high° < value < high°.
    pub const fn within_degrees(high: f64) -> Self {
        let high = high.to_radians();
        Self::between(-high, high)
    }

    /// Every finite number.
    pub const FINITE: Self = Self::between(f64::NEG_INFINITY, f64::INFINITY);

    /// True if the range contains the value. No range contains NaN; a range contains an infinite
    /// value only if an included end is infinite.
    pub fn contains(self, value: f64) -> bool {
        let above = value > self.low || (self.low_included && value == self.low);
        let below = value < self.high || (self.high_included && value == self.high);
        above && below
    }

    /// The smallest and the largest number in the range. An infinite end is returned even if it is
    /// excluded.
    pub fn ends(self) -> [f64; 2] {
        let is_low = self.low_included || self.low.is_infinite();
        let is_high = self.high_included || self.high.is_infinite();
        [
            if is_low { self.low } else { self.low.next_up() },
            if is_high {
                self.high
            } else {
                self.high.next_down()
            },
        ]
    }

    /// The range as text: "0 kg < … ≤ 2 kg".
    pub fn show(self, quantity: Quantity, unit: &str) -> String {
        if self == Self::FINITE {
            return "any finite number".into();
        }
        let sign = |included| if included { "≤" } else { "<" };
        let end = |value: f64| {
            let number = quantity.number_in(value, unit);
            let rounded: f64 = significant(number, 7).parse().unwrap_or(number);
            let is_long = rounded.is_finite() && rounded.abs() >= 1e6;
            if is_long {
                format!("{rounded:e} {unit}").trim_end().into()
            } else {
                quantity.show(value, unit)
            }
        };
        let low = (self.low != f64::NEG_INFINITY)
            .then(|| format!("{} {} ", end(self.low), sign(self.low_included)));
        let high = (self.high != f64::INFINITY || self.high_included)
            .then(|| format!(" {} {}", sign(self.high_included), end(self.high)));
        format!("{}…{}", low.unwrap_or_default(), high.unwrap_or_default())
    }
}
