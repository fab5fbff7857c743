use crate::report::lines::{INDENT, wrapped};

/// A line of a list.
#[derive(Clone, Debug)]
pub struct Line {
    pub(super) indent: Indent,
    pub(super) text: String,
}

/// The indent of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Indent {
    /// No indent.
    Flush,
    /// An item of a list.
    Item,
    /// Details of the item above.
    Note,
}

impl Line {
    /// A line without indent.
    pub fn flush(text: impl Into<String>) -> Self {
        Self {
            indent: Indent::Flush,
            text: text.into(),
        }
    }

    /// An item of a list.
    pub fn item(text: impl Into<String>) -> Self {
        Self {
            indent: Indent::Item,
            text: text.into(),
        }
    }

    /// Details of the item above.
    pub fn note(text: impl Into<String>) -> Self {
        Self {
            indent: Indent::Note,
            text: text.into(),
        }
    }
}

impl Indent {
    /// A text with this indent, in lines of at most `width` columns.
    pub fn lines(self, text: &str, width: usize) -> String {
        let indent = match self {
            Self::Flush => 0,
            Self::Item => INDENT,
            Self::Note => 3 * INDENT,
        };
        wrapped(text, [indent; 2], width)
    }
}
