//! Decimal marks of a table: comma or point, and thousands separators that look like them.

use super::column::Column;
use super::numbers::{digits, has_thousands};

/// A decimal mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DecimalMark {
    Comma,
    Point,
}

impl DecimalMark {
    const ALL: [Self; 2] = [Self::Comma, Self::Point];

    fn sign(self) -> char {
        match self {
            Self::Comma => ',',
            Self::Point => '.',
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Comma => "comma",
            Self::Point => "point",
        }
    }

    fn other(self) -> Self {
        match self {
            Self::Comma => Self::Point,
            Self::Point => Self::Comma,
        }
    }

    /// The mark of a number that contains only commas or only points; `None` for other numbers.
    fn only_in(number: &str) -> Option<Self> {
        Self::ALL
            .into_iter()
            .find(|mark| number.contains(mark.sign()) && !number.contains(mark.other().sign()))
    }

    /// Detects the decimal mark of a table from `columns` of some rows. `None` if no mark occurs,
    /// or if both occur. Marks that may separate thousands do not count.
    pub fn detect(
        separator: u8,
        columns: impl Iterator<Item = usize> + Clone,
        rows: &[Vec<String>],
    ) -> Option<Self> {
        if separator == b',' {
            return Some(Self::Point);
        }
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
            if found == Some(mark.other()) {
                return None;
            }
            found = Some(mark);
        }
        found
    }

    /// True if the mark in a cell may separate either decimals or thousands. `of_table` is the
    /// decimal mark of the table, `None` if it is not known.
    pub fn is_ambiguous(of_table: Option<Self>, cell: &str) -> bool {
        if of_table == Some(Self::Point) {
            return false;
        }
        let number = digits(cell);
        Self::only_in(number)
            .is_some_and(|mark| of_table != Some(mark) && has_thousands(number, mark.sign()))
    }
}

/// Checks that all numbers of a table use the same decimal mark. If a table contains points and
/// commas, a number such as `2.500` is ambiguous.
#[derive(Clone, Debug, Default)]
pub(crate) struct DecimalMarkCheck {
    /// The first cell with a comma, and the first cell with a point.
    first: [Option<MarkedCell>; 2],
    /// The first cell with a comma that may separate thousands, and the first cell with such a
    /// point.
    first_ambiguous: [Option<MarkedCell>; 2],
}

/// A cell with a mark, for messages.
#[derive(Clone, Debug)]
struct MarkedCell {
    row: u64,
    head: String,
    text: String,
}

impl DecimalMarkCheck {
    /// Checks a cell against all cells so far.
    ///
    /// # Errors
    /// A message if this cell and an earlier cell have different marks, and one of the two marks
    /// may separate either decimals or thousands.
    pub fn check(&mut self, row: u64, column: &Column, text: &str) -> Result<(), String> {
        let has_numbers = column.quantity().is_some() && !column.is_weather;
        if !(column.format.has_decimal_comma && has_numbers) {
            return Ok(());
        }
        let number = digits(text);
        let Some(mark) = DecimalMark::only_in(number) else {
            return Ok(());
        };
        let cell = || MarkedCell {
            row,
            head: column.head.clone(),
            text: text.to_owned(),
        };
        let is_ambiguous = has_thousands(number, mark.sign());
        let other = mark.other();
        if is_ambiguous && let Some(reference) = &self.first[other as usize] {
            return Err(ambiguous(mark, &cell(), reference));
        }
        if !is_ambiguous && let Some(doubtful) = &self.first_ambiguous[other as usize] {
            return Err(ambiguous(other, doubtful, &cell()));
        }
        self.first[mark as usize].get_or_insert_with(cell);
        if is_ambiguous {
            self.first_ambiguous[mark as usize].get_or_insert_with(cell);
        }
        Ok(())
    }
}

/// Message on an ambiguous cell; `reference` is a cell with the other mark.
fn ambiguous(mark: DecimalMark, doubtful: &MarkedCell, reference: &MarkedCell) -> String {
    let [decimal, thousands] = [".", ""].map(|read| doubtful.text.replace(mark.sign(), read));
    format!(
        "the {} in '{}' (row {}, column {}) may separate decimals or thousands ({decimal} or \
         {thousands}), since '{}' (row {}, column \
         {}) has a {}; write all decimals of the table with the same mark, and nothing between \
         thousands",
        mark.name(),
        doubtful.text,
        doubtful.row,
        doubtful.head,
        reference.text,
        reference.row,
        reference.head,
        mark.other().name()
    )
}
