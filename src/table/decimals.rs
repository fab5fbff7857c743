//! The mark of decimals in the numbers of a table.

use super::cell_number::digits;
use super::numbers::has_thousands;

/// The mark of decimals in a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Decimals {
    Point,
    Comma,
    /// No number at the beginning tells.
    Unknown,
}

impl Decimals {
    /// Detects the mark from the numbers of some rows.
    pub fn found(
        separator: u8,
        read: impl Iterator<Item = usize> + Clone,
        rows: &[Vec<String>],
    ) -> Self {
        if separator == b',' {
            return Self::Point;
        }
        let (mut commas, mut points) = (false, false);
        for cells in rows {
            for cell in read.clone().filter_map(|at| cells.get(at)) {
                let number = digits(cell);
                let is_number = number
                    .bytes()
                    .all(|byte| byte.is_ascii_digit() || b"-.,".contains(&byte));
                let has = |mark, other| {
                    number.contains(mark) && !number.contains(other) && !has_thousands(number, mark)
                };
                commas |= is_number && has(',', '.');
                points |= is_number && has('.', ',');
            }
        }
        match (commas, points) {
            (true, false) => Self::Comma,
            (false, true) => Self::Point,
            _ => Self::Unknown,
        }
    }

    /// True if the mark may separate thousands or decimals.
    pub fn is_ambiguous(self, cell: &str) -> bool {
        let of = |mark, other| {
            let number = digits(cell);
            has_thousands(number, mark) && !number.contains(other)
        };
        match self {
            Self::Point => false,
            Self::Comma => of('.', ','),
            Self::Unknown => of('.', ',') || of(',', '.'),
        }
    }
}
