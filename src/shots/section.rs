//! Sections of a table: the rows below one head.

use super::head::ExportHead;
use crate::table::{Decimals, cells};
use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;

/// The head of an export.
#[derive(Clone, Debug)]
pub struct Export {
    pub(super) head: ExportHead,
}

impl Export {
    /// Cell separator.
    pub fn separator(&self) -> u8 {
        self.head.separator
    }

    /// Its heads.
    pub fn heads(&self) -> &[String] {
        &self.head.heads
    }

    /// The units of a line below the heads, where there is one.
    pub fn units(&self) -> Option<&[String]> {
        self.head.units.as_deref()
    }

    /// Numbers have decimal commas.
    pub fn has_decimal_comma(&self) -> bool {
        self.head.decimals == Decimals::Comma
    }

    /// The cells of a row.
    pub fn cells<'a>(&self, text: &'a str) -> Vec<Cow<'a, str>> {
        cells(text, self.head.separator)
    }

    /// The columns that an earlier flight of the rows has added, which the table has not from its
    /// maker.
    pub(crate) fn added(&self) -> Range<usize> {
        self.head.added.clone()
    }
}

/// The part of a table that shots stand in.
#[derive(Clone, Debug)]
pub struct Section {
    /// Its head.
    pub export: Arc<Export>,
    /// These shots are its first, and it is not the first section.
    pub begins: bool,
}
