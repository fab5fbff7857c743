/// What can be wrong with a quantity string.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum UnitError {
    /// No number at the start.
    #[error(
        "\"{text}\" does not start with a number; write for example \"{}\"",
        example(unit)
    )]
    NoNumber {
        /// The string.
        text: String,
        /// A unit that would fit; empty for a plain number.
        unit: &'static str,
    },
    /// The number NaN, which computers write where there is no number.
    #[error("\"{text}\" is not a number; write for example \"{}\"", example(unit))]
    NotANumber {
        /// The string.
        text: String,
        /// A unit that would fit; empty for a plain number.
        unit: &'static str,
    },
    /// A unit that is not known.
    #[error("\"{text}\" has the unknown unit '{unit}'{hint}; {wanted} takes {examples}")]
    UnknownUnit {
        /// The string.
        text: String,
        /// Its unit.
        unit: String,
        /// What was meant, where that can be told.
        hint: String,
        /// The kind of quantity wanted.
        wanted: &'static str,
        /// Units that fit.
        examples: String,
    },
    /// A unit of another kind of quantity.
    #[error("\"{text}\" is not {wanted}; {wanted} takes {examples}")]
    WrongKind {
        /// The string.
        text: String,
        /// The kind of quantity wanted.
        wanted: &'static str,
        /// Units that fit.
        examples: String,
    },
    /// A string without a unit where one is needed.
    #[error("\"{text}\" has no unit; {wanted} takes {examples}")]
    NoUnit {
        /// The string.
        text: String,
        /// The kind of quantity wanted.
        wanted: &'static str,
        /// Units that fit.
        examples: String,
    },
}

/// A text that would be right.
fn example(unit: &str) -> String {
    if unit.is_empty() {
        "0.5".into()
    } else {
        format!("10.5 {unit}")
    }
}
