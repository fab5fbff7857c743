//! Sentences with quantities in them.

use super::spelling::{typed, with_unit};
use super::{Quantity, System, significant};
use serde::{Serialize, Serializer};
use std::fmt;

/// A sentence that keeps its quantities as numbers, so that it can be shown in the units of either
/// system. `Display` and JSON show each in the unit that it was given in, spelled as it is typed.
///
/// ```
/// use longdrive::units::{Digits, Message, Quantity, System};
/// let message = Message::from("stopped at ").quantity(Quantity::SPEED, "mph", 44.704, Digits::Significant(5));
/// assert_eq!(message.to_string(), "stopped at 100 mph");
/// assert_eq!(message.in_units(System::Metric), "stopped at 44.704 m/s");
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Message {
    parts: Vec<Part>,
}

#[derive(Clone, Debug, PartialEq)]
enum Part {
    Words(String),
    Quantity {
        quantity: Quantity,
        unit: &'static str,
        value: f64,
        digits: Digits,
    },
}

/// The digits of a quantity in a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Digits {
    /// At most so many significant digits.
    Significant(usize),
    /// As [`Quantity::read_off_finely`].
    Fine,
    /// As [`Quantity::read_off_difference`].
    Difference,
}

impl Message {
    /// The same with more words.
    #[must_use]
    pub fn words(mut self, words: impl Into<String>) -> Self {
        match self.parts.last_mut() {
            Some(Part::Words(last)) => last.push_str(&words.into()),
            _ => self.parts.push(Part::Words(words.into())),
        }
        self
    }

    /// The same with a quantity: its unit is shown in a system as [`System::unit`] says, its value
    /// is SI.
    #[must_use]
    pub fn quantity(
        mut self,
        quantity: Quantity,
        unit: &'static str,
        value: f64,
        digits: Digits,
    ) -> Self {
        self.parts.push(Part::Quantity {
            quantity,
            unit,
            value,
            digits,
        });
        self
    }

    /// The same with another message.
    #[must_use]
    pub fn message(self, other: Self) -> Self {
        other.parts.into_iter().fold(self, |all, part| match part {
            Part::Words(words) => all.words(words),
            Part::Quantity {
                quantity,
                unit,
                value,
                digits,
            } => all.quantity(quantity, unit, value, digits),
        })
    }

    /// The message with its words as `write` changes them; quantities stay.
    #[must_use]
    pub fn map_words(mut self, write: impl Fn(&str) -> String) -> Self {
        for part in &mut self.parts {
            if let Part::Words(words) = part {
                *words = write(words);
            }
        }
        self
    }

    /// Messages in a row, with these words between them.
    pub fn joined(messages: impl IntoIterator<Item = Self>, between: &str) -> Self {
        let mut messages = messages.into_iter();
        let first = messages.next().unwrap_or_default();
        messages.fold(first, |all, next| all.words(between).message(next))
    }

    /// The sentence in the units of a system, as people read them.
    pub fn in_units(&self, system: System) -> String {
        self.text(|unit| system.unit(unit), with_unit)
    }

    fn text(
        &self,
        of: impl Fn(&'static str) -> &'static str,
        spelled: fn(&str, &str) -> String,
    ) -> String {
        self.parts
            .iter()
            .map(|part| part.text(&of, spelled))
            .collect()
    }
}

impl Part {
    fn text(
        &self,
        of: impl Fn(&'static str) -> &'static str,
        spelled: fn(&str, &str) -> String,
    ) -> String {
        match self {
            Self::Words(words) => words.clone(),
            Self::Quantity {
                quantity,
                unit,
                value,
                digits,
            } => {
                let unit = of(unit);
                let number = match digits {
                    Digits::Significant(digits) => {
                        significant(value / quantity.size_of(unit).unwrap_or(1.0), *digits)
                    }
                    Digits::Fine => quantity.finely(*value, unit),
                    Digits::Difference => quantity.difference(*value, unit),
                };
                spelled(&number, unit)
            }
        }
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
