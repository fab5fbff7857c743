//! Air of each row, from an export that states it.

use super::head::Export;
use crate::table::{Column, air_as_given, air_of_rows, air_of_setup};

impl Export {
    /// Index of the air column among the further columns.
    fn air_at(&self) -> Option<usize> {
        self.further_columns.iter().position(Column::is_stated_air)
    }

    /// Remark on the air of the export; `None` if the export states no air.
    pub(super) fn air_remark(&self) -> Option<String> {
        self.air_at()
            .map(|at| air_of_rows(&self.further_columns[at].head))
    }

    /// Ignores the air of the export, because the setup gives it explicitly; true if there was any.
    pub(super) fn ignore_air(&mut self) -> bool {
        let (Some(at), Some(replaced)) = (self.air_at(), self.air_remark()) else {
            return false;
        };
        self.further.remove(at);
        let column = self.further_columns.remove(at);
        for remark in self
            .remarks
            .iter_mut()
            .filter(|remark| remark.to_string() == replaced)
        {
            *remark = air_as_given(&column.head).into();
        }
        true
    }

    /// Message for a row without usable air.
    pub(super) fn air_note<S: AsRef<str>>(&self, row: &[S]) -> Option<String> {
        let at = self.air_at()?;
        let stated = self.further_columns[at].stated_air(row[self.further[at].at].as_ref());
        stated.err().map(|why| air_of_setup(&why))
    }
}
