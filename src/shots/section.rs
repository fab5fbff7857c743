//! Sections of a table: the rows below one line of column heads.

use super::head::ExportHead;
use crate::table::{DecimalMark, cells};
use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;

/// The column heads of an export, interpreted.
#[derive(Clone, Debug)]
pub struct Export {
    pub(super) head: ExportHead,
}

impl Export {
    /// Cell separator.
    pub fn separator(&self) -> u8 {
        self.head.separator
    }

    /// The column heads as written.
    pub fn heads(&self) -> &[String] {
        &self.head.heads
    }

    /// Units in a line below the column heads; `None` without this line.
    pub fn units(&self) -> Option<&[String]> {
        self.head.units.as_deref()
    }

    /// True if numbers have decimal commas.
    pub fn has_decimal_comma(&self) -> bool {
        self.head.decimal_mark == Some(DecimalMark::Comma)
    }

    /// The cells of a row.
    pub fn cells<'a>(&self, text: &'a str) -> Vec<Cow<'a, str>> {
        cells(text, self.head.separator)
    }

    /// Columns that an earlier run of `fly` added.
    pub(crate) fn added(&self) -> Range<usize> {
        self.head.added.clone()
    }
}

/// A section of a table: the rows below one line of column heads.
#[derive(Clone, Debug)]
pub struct Section {
    /// The column heads of the section.
    pub export: Arc<Export>,
    /// True if the shots of this chunk are the first of a later section.
    pub begins: bool,
}
