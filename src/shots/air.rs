//! The air of each row, where the export states it.

use super::head::ExportHead;
use crate::table::{Column, air_as_given, air_of_rows, air_of_setup};

impl ExportHead {
    /// The place of its column among the further ones.
    fn air_at(&self) -> Option<usize> {
        self.further_columns.iter().position(Column::is_stated_air)
    }

    /// Remark for the user.
    pub fn air_told(&self) -> Option<String> {
        self.air_at()
            .map(|at| air_of_rows(&self.further_columns[at].head))
    }

    /// Leaves the air out that the export states, where it is given otherwise; whether there was
    /// any.
    pub fn leave_air_out(&mut self) -> bool {
        let (Some(at), Some(told)) = (self.air_at(), self.air_told()) else {
            return false;
        };
        self.further.remove(at);
        let column = self.further_columns.remove(at);
        for remark in self
            .remarks
            .iter_mut()
            .filter(|remark| remark.to_string() == told)
        {
            *remark = air_as_given(&column.head).into();
        }
        true
    }

    /// Message for rows without usable air.
    pub fn air_assumed<S: AsRef<str>>(&self, row: &[S]) -> Option<String> {
        let at = self.air_at()?;
        let stated = self.further_columns[at].stated_air(row[self.further[at].at].as_ref());
        stated.err().map(|why| air_of_setup(&why))
    }
}
