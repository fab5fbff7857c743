use crate::report::lines::INDENT;

/// A line of a list.
#[derive(Clone, Debug)]
pub struct Line {
    /// Number of spaces before the line in a plain text.
    pub(super) indent: usize,
    pub(super) text: String,
}

impl Line {
    /// A line without indent.
    pub fn flush(text: impl Into<String>) -> Self {
        Self {
            indent: 0,
            text: text.into(),
        }
    }

    /// An item of a list.
    pub fn item(text: impl Into<String>) -> Self {
        Self {
            indent: INDENT,
            text: text.into(),
        }
    }

    /// Details of the item above.
    pub fn note(text: impl Into<String>) -> Self {
        Self {
            indent: DETAILS,
            text: text.into(),
        }
    }
}

/// Spaces before details of an item.
pub(super) const DETAILS: usize = 3 * INDENT;
