//! Decimal marks of a table: comma or point, and thousands separators that look like them.

use super::numbers::{digits, has_thousands};

/// A decimal mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DecimalMark {
    Comma,
    Point,
}

impl DecimalMark {
    fn sign(self) -> char {
        match self {
            Self::Comma => ',',
            Self::Point => '.',
        }
    }

    /// The mark of a number that contains only commas or only points; `None` for other numbers.
    fn only_in(number: &str) -> Option<Self> {
        match (number.contains(','), number.contains('.')) {
            (true, false) => Some(Self::Comma),
            (false, true) => Some(Self::Point),
            _ => None,
        }
    }

    /// Detects the decimal mark of a table from `columns` of some rows. `None` if no mark occurs,
    /// or if both occur. Marks that may separate thousands do not count.
    pub fn detect(
        columns: impl Iterator<Item = usize> + Clone,
        rows: &[Vec<String>],
    ) -> Option<Self> {
        let cells = rows
            .iter()
            .flat_map(|row| columns.clone().filter_map(|at| row.get(at)));
        let mut found = None;
        for number in cells.map(|cell| digits(cell)) {
            let is_number = number
                .bytes()
                .all(|byte| byte.is_ascii_digit() || b"-.,".contains(&byte));
            let Some(mark) = Self::only_in(number).filter(|_| is_number) else {
                continue;
            };
            if has_thousands(number, mark.sign()) {
                continue;
            }
            if found.is_some_and(|found| found != mark) {
                return None;
            }
            found = Some(mark);
        }
        found
    }

    /// Message if the mark in a cell may separate either decimals or thousands; otherwise `None`.
    /// `of_table` is the decimal mark of the table, `None` if it is not known.
    pub fn ambiguity(of_table: Option<Self>, cell: &str) -> Option<String> {
        if of_table.is_some() {
            return None;
        }
        let number = digits(cell);
        let mark = Self::only_in(number).filter(|mark| has_thousands(number, mark.sign()))?;
        let thousands = number.replace(mark.sign(), "");
        let decimals = number.replace(mark.sign(), ".");
        Some(format!(
            "the mark in '{cell}' may separate decimals or thousands ({decimals} or {thousands}); \
             write thousands without a mark, and decimals with more or fewer than three digits"
        ))
    }
}
