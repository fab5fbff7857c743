#[cfg(test)]
use crate::json::JsonRange;
use crate::json::range;
use crate::parameters::LawVariable;
use crate::units::Message;
use serde::{Serialize, Serializer};
use std::fmt::{self, Display, Formatter};

/// An end of a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RangeEnd {
    /// The lower end.
    Low,
    /// The upper end.
    High,
}

/// How a law continues beyond the exceeded ends of its ranges.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Continuation {
    /// True if the law is extrapolated at an exceeded end.
    pub is_extrapolated: bool,
    /// True if the variable is clamped at an exceeded end.
    pub is_held: bool,
}

impl Display for Continuation {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(match (self.is_extrapolated, self.is_held) {
            (true, true) => "extrapolated or held",
            (false, true) => "held",
            (_, false) => "extrapolated",
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
    /// The ends of the ranges beyond which the variable is clamped. Beyond the other ends the law
    /// is extrapolated.
    #[serde(skip)]
    pub held: &'static [(LawVariable, RangeEnd)],
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
        held: &[],
    };

    /// The range of a variable, SI; `None` if it is unknown.
    pub fn range(&self, variable: LawVariable) -> Option<[f64; 2]> {
        match variable {
            LawVariable::SpinRatio => self.spin_ratio,
            LawVariable::Spin => self.spin,
            LawVariable::Reynolds => self.reynolds,
            LawVariable::Speed => self.speed,
        }
    }

    /// True if the range of no variable is known.
    pub fn is_unknown(&self) -> bool {
        LawVariable::ALL
            .iter()
            .all(|variable| self.range(*variable).is_none())
    }

    /// Appends the known ranges to a message: "spin ratio 0.06 to 0.33, Reynolds number 70000 to
    /// 230000".
    pub fn in_words(&self, mut message: Message) -> Message {
        let mut separator = "";
        for variable in LawVariable::ALL {
            if let Some(range) = self.range(variable) {
                message = message.words(format!("{separator}{} ", variable.name()));
                message = variable.append_range(message, range);
                separator = ", ";
            }
        }
        message
    }

    /// How the law continues beyond those ends of a variable's range that the flight exceeds.
    /// `flown` has the least and the greatest value of the variable in the flight.
    pub(crate) fn continuation(&self, variable: LawVariable, flown: [f64; 2]) -> Continuation {
        let Some([low, high]) = self.range(variable) else {
            return Continuation::default();
        };
        let mut continuation = Continuation::default();
        for (is_exceeded, end) in [
            (flown[0] < low, RangeEnd::Low),
            (flown[1] > high, RangeEnd::High),
        ] {
            let is_held = self.held.contains(&(variable, end));
            continuation.is_held |= is_exceeded && is_held;
            continuation.is_extrapolated |= is_exceeded && !is_held;
        }
        continuation
    }

    /// How the law continues at all exceeded ends. `flown` has the range of each variable in the
    /// flight.
    pub(crate) fn continuation_of_all(
        &self,
        flown: impl Fn(LawVariable) -> [f64; 2],
    ) -> Continuation {
        let mut all = Continuation::default();
        for variable in LawVariable::ALL {
            let one = self.continuation(variable, flown(variable));
            all.is_held |= one.is_held;
            all.is_extrapolated |= one.is_extrapolated;
        }
        all
    }

    /// True if spin ratio, spin, Reynolds number and airspeed ([`Stream::variables`]) are within
    /// all known ranges. Always true in a vacuum (Reynolds number 0).
    ///
    /// [`Stream::variables`]: super::Stream::variables
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
