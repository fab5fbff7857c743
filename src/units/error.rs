/// An error in a quantity string.
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
        /// A valid unit; empty for a plain number.
        unit: &'static str,
    },
    /// The number NaN.
    #[error("\"{text}\" is not a number; write for example \"{}\"", example(unit))]
    NotANumber {
        /// The string.
        text: String,
        /// A valid unit; empty for a plain number.
        unit: &'static str,
    },
    /// An unknown unit.
    #[error("\"{text}\" has the unknown unit '{unit}'{hint}; {wanted} takes {examples}")]
    UnknownUnit {
        /// The string.
        text: String,
        /// The unit in the string.
        unit: String,
        /// Words that follow the unit: the unit that was probably meant, or the advice to write a
        /// decimal point. May be empty.
        hint: String,
        /// The required quantity.
        wanted: &'static str,
        /// Valid units.
        examples: String,
    },
    /// A unit of another quantity.
    #[error("\"{text}\" is not {wanted}; {wanted} takes {examples}")]
    WrongKind {
        /// The string.
        text: String,
        /// The required quantity.
        wanted: &'static str,
        /// Valid units.
        examples: String,
    },
    /// A missing unit.
    #[error("\"{text}\" has no unit; {wanted} takes {examples}")]
    NoUnit {
        /// The string.
        text: String,
        /// The required quantity.
        wanted: &'static str,
        /// Valid units.
        examples: String,
    },
}

fn example(unit: &str) -> String {
    if unit.is_empty() {
        "0.5".into()
    } else {
        format!("10.5 {unit}")
    }
}
