//! Messages that contain quantities.

use super::spelling::{typed, with_unit};
use super::{Quantity, System};
use serde::{Serialize, Serializer};
use std::fmt;

/// A message with quantities as numbers, so that it can be displayed in metric or in US units.
/// `Display` and JSON use the given unit of each quantity, in the spelling of input: `deg`.
///
/// ```
/// use longdrive::units::{Digits, Message, Quantity, System};
/// let message = Message::from("stopped at ")
///     .quantity(Quantity::SPEED, "mph", 44.704, Digits::Significant(5));
/// assert_eq!(message.to_string(), "stopped at 100 mph");
/// assert_eq!(message.in_units(System::Metric), "stopped at 44.704 m/s");
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Message {
    parts: Vec<MessagePart>,
}

#[derive(Clone, Debug, PartialEq)]
enum MessagePart {
    Words(String),
    Quantity {
        quantity: Quantity,
        unit: &'static str,
        value: f64,
        digits: Digits,
    },
}

/// The digits of a quantity in a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Digits {
    /// At most this number of significant digits.
    Significant(usize),
    /// The digits that a launch monitor shows.
    LaunchMonitor,
    /// One decimal more than a launch monitor shows, for computed settings such as an optimum's
    /// loft.
    Fine,
    /// For a difference or an uncertainty: one decimal more than a launch monitor shows, and at
    /// least two significant digits.
    Difference,
}

impl Message {
    /// Appends words.
    #[must_use]
    pub fn words(mut self, words: impl Into<String>) -> Self {
        match self.parts.last_mut() {
            Some(MessagePart::Words(last)) => last.push_str(&words.into()),
            _ => self.parts.push(MessagePart::Words(words.into())),
        }
        self
    }

    /// Appends a quantity with its SI value. `Display` shows the value in `unit`;
    /// [`in_units`](Self::in_units) converts `unit` by [`System::unit`].
    #[must_use]
    pub fn quantity(
        mut self,
        quantity: Quantity,
        unit: &'static str,
        value: f64,
        digits: Digits,
    ) -> Self {
        self.parts.push(MessagePart::Quantity {
            quantity,
            unit,
            value,
            digits,
        });
        self
    }

    /// Appends another message.
    #[must_use]
    pub fn message(self, other: Self) -> Self {
        other.parts.into_iter().fold(self, |all, part| match part {
            MessagePart::Words(words) => all.words(words),
            MessagePart::Quantity {
                quantity,
                unit,
                value,
                digits,
            } => all.quantity(quantity, unit, value, digits),
        })
    }

    /// Rewrites the words; quantities are unchanged.
    #[must_use]
    pub fn map_words(mut self, write: impl Fn(&str) -> String) -> Self {
        for part in &mut self.parts {
            if let MessagePart::Words(words) = part {
                *words = write(words);
            }
        }
        self
    }

    /// Joins messages with words between them.
    pub fn joined(messages: impl IntoIterator<Item = Self>, between: &str) -> Self {
        let mut messages = messages.into_iter();
        let first = messages.next().unwrap_or_default();
        messages.fold(first, |all, next| all.words(between).message(next))
    }

    /// The text in the units of a system, in the spelling of output: `°`.
    pub fn in_units(&self, system: System) -> String {
        self.text(|unit| system.unit(unit), with_unit)
    }

    fn text(
        &self,
        of: impl Fn(&'static str) -> &'static str,
        spelled: fn(&str, &str) -> String,
    ) -> String {
        let text = |part: &MessagePart| match part {
            MessagePart::Words(words) => words.clone(),
            MessagePart::Quantity {
                quantity,
                unit,
                value,
                digits,
            } => {
                let unit = of(unit);
                spelled(&quantity.number_text(*value, unit, *digits), unit)
            }
        };
        self.parts.iter().map(text).collect()
    }
}

impl From<&str> for Message {
    fn from(words: &str) -> Self {
        Self::default().words(words)
    }
}

impl From<String> for Message {
    fn from(words: String) -> Self {
        Self::default().words(words)
    }
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(|unit| unit, typed))
    }
}

impl Serialize for Message {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

#[cfg(test)]
impl schemars::JsonSchema for Message {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        String::schema_name()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        String::json_schema(generator)
    }
}
