#[cfg(test)]
use crate::json::JsonRange;
use crate::json::range;
use crate::units::{Digits, Message, Quantity};
use serde::{Serialize, Serializer};
use std::fmt::{self, Display, Formatter};

/// A variable of a law, and the range to which the law was fitted.
#[derive(Clone, Copy, Debug)]
pub struct FittedRange {
    /// The name of the variable.
    pub variable: &'static str,
    /// Kind of quantity of the variable.
    pub quantity: Quantity,
    /// Unit in which texts print the variable; empty for a pure number.
    pub unit: &'static str,
    /// The range, SI; `None` if it is unknown.
    pub range: Option<[f64; 2]>,
}

impl FittedRange {
    /// Appends a range of this variable to a message: "70000 to 230000", or "at least 71000"
    /// without an upper end.
    pub fn in_words(&self, before: Message, [low, high]: [f64; 2]) -> Message {
        let digits = Digits::Significant(3);
        if high.is_infinite() {
            return before
                .words("at least ")
                .quantity(self.quantity, self.unit, low, digits);
        }
        before
            .quantity(self.quantity, self.unit, low, digits)
            .words(" to ")
            .quantity(self.quantity, self.unit, high, digits)
    }
}

/// How a law continues beyond the ends of its ranges.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Continuation {
    /// The law is extrapolated at all ends.
    Extrapolated,
    /// The variable is clamped at all ends.
    Held,
    /// The law is extrapolated at some ends. At the other ends the variable is clamped.
    ExtrapolatedOrHeld,
}

impl Display for Continuation {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Extrapolated => "extrapolated",
            Self::Held => "held",
            Self::ExtrapolatedOrHeld => "extrapolated or held",
        })
    }
}

/// The measurements to which a law was fitted, and the range of each quantity; `null` for an
/// unknown range.
// outside of a range, the law is extrapolated or the variable is clamped (`held`); the error of the
// law is unknown there
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "FittedReport"))]
pub struct Fitted {
    /// The measurements; `null` if they are unknown.
    // an empty text is serialized as `null`
    #[serde(serialize_with = "unless_empty")]
    #[cfg_attr(test, schemars(with = "Option<String>"))]
    pub to: &'static str,
    /// Spin ratio R ω/v.
    #[serde(serialize_with = "range")]
    #[cfg_attr(test, schemars(with = "Option<JsonRange>"))]
    pub spin_ratio: Option<[f64; 2]>,
    /// Spin, rad/s.
    #[serde(serialize_with = "range")]
    #[cfg_attr(test, schemars(with = "Option<JsonRange>"))]
    pub spin: Option<[f64; 2]>,
    /// Reynolds number.
    #[serde(serialize_with = "range")]
    #[cfg_attr(test, schemars(with = "Option<JsonRange>"))]
    pub reynolds: Option<[f64; 2]>,
    /// Speed through the air, m/s.
    #[serde(serialize_with = "range")]
    #[cfg_attr(test, schemars(with = "Option<JsonRange>"))]
    pub speed: Option<[f64; 2]>,
    /// For each end (below, above) of each range in [`ranges`](Self::ranges): true if the variable
    /// is clamped beyond this end, false if the law is extrapolated.
    #[serde(skip)]
    pub held: [[bool; 2]; 4],
}

fn unless_empty<S: Serializer>(text: &str, serializer: S) -> Result<S::Ok, S::Error> {
    Some(text)
        .filter(|text| !text.is_empty())
        .serialize(serializer)
}

impl Fitted {
    /// All ranges are unknown: the law has no measurements, or its source does not state the
    /// ranges.
    pub const UNKNOWN: Self = Self {
        spin_ratio: None,
        spin: None,
        reynolds: None,
        speed: None,
        to: "",
        held: [[false; 2]; 4],
    };

    /// The ranges of spin ratio, spin, Reynolds number and airspeed.
    pub fn ranges(&self) -> [FittedRange; 4] {
        [
            FittedRange {
                variable: "spin ratio",
                quantity: Quantity::NUMBER,
                unit: "",
                range: self.spin_ratio,
            },
            FittedRange {
                variable: "spin",
                quantity: Quantity::ANGULAR_VELOCITY,
                unit: "rpm",
                range: self.spin,
            },
            FittedRange {
                variable: "Reynolds number",
                quantity: Quantity::NUMBER,
                unit: "",
                range: self.reynolds,
            },
            FittedRange {
                variable: "speed through the air",
                quantity: Quantity::SPEED,
                unit: "m/s",
                range: self.speed,
            },
        ]
    }

    /// Appends the known ranges to a message: "spin ratio 0.06 to 0.33, Reynolds number 70000 to
    /// 230000".
    pub fn in_words(&self, before: Message) -> Message {
        let known = self
            .ranges()
            .into_iter()
            .filter_map(|fitted| Some((fitted, fitted.range?)));
        known
            .enumerate()
            .fold(before, |message, (i, (fitted, range))| {
                let comma = if i == 0 { "" } else { ", " };
                let message = message.words(format!("{comma}{} ", fitted.variable));
                fitted.in_words(message, range)
            })
    }

    /// How the law continues beyond the exceeded ends of its ranges. For each range,
    /// `exceeded_ends` is true for an exceeded end (below, above).
    pub(crate) fn continuation(&self, exceeded_ends: [[bool; 2]; 4]) -> Continuation {
        let exceeded = exceeded_ends
            .as_flattened()
            .iter()
            .zip(self.held.as_flattened())
            .filter(|(is_exceeded, _)| **is_exceeded);
        let (mut has_held, mut has_extrapolated) = (false, false);
        for (_, is_held) in exceeded {
            has_held |= is_held;
            has_extrapolated |= !is_held;
        }
        match (has_extrapolated, has_held) {
            (true, true) => Continuation::ExtrapolatedOrHeld,
            (false, true) => Continuation::Held,
            (_, false) => Continuation::Extrapolated,
        }
    }

    /// For each range, true for the ends (below, above) that a flight exceeds. `flown` has the
    /// least and the greatest value of each variable in the flight.
    pub(crate) fn exceeded_ends(&self, flown: [[f64; 2]; 4]) -> [[bool; 2]; 4] {
        let ranges = self
            .ranges()
            .map(|fitted| fitted.range.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]));
        std::array::from_fn(|k| [flown[k][0] < ranges[k][0], flown[k][1] > ranges[k][1]])
    }

    /// True if spin ratio, spin, Reynolds number and airspeed are within all known ranges. Always
    /// true in a vacuum (Reynolds number 0).
    #[inline]
    pub fn contains(&self, [spin_ratio, spin, reynolds, speed]: [f64; 4]) -> bool {
        let is_in = |range: Option<[f64; 2]>, value: f64| {
            range.is_none_or(|[low, high]| (low..=high).contains(&value))
        };
        reynolds == 0.0
            || is_in(self.spin_ratio, spin_ratio)
                && is_in(self.spin, spin)
                && is_in(self.reynolds, reynolds)
                && is_in(self.speed, speed)
    }
}
