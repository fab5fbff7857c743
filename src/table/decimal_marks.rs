//! Which mark separates the decimals of a table's numbers.

use super::cell_number::digits;
use super::column::Column;
use super::numbers::has_thousands;

/// The marks in the numbers of a table whose cells may have a decimal comma. Where points and
/// commas both stand in its numbers, one that might separate thousands, as in `2.500`, has two
/// meanings.
#[derive(Clone, Debug, Default)]
pub(crate) struct DecimalMarks {
    of: [Seen; 2],
}

/// The first cells with a mark, as a message tells of them.
#[derive(Clone, Debug, Default)]
struct Seen {
    any: Option<Cell>,
    /// One in which the mark may separate thousands.
    ambiguous: Option<Cell>,
}

#[derive(Clone, Debug)]
struct Cell {
    row: u64,
    head: String,
    text: String,
}

/// The marks, with what a message calls them.
const MARKS: [(char, &str); 2] = [(',', "comma"), ('.', "point")];

impl DecimalMarks {
    /// Looks at the cell of a row that is read as a number.
    ///
    /// # Errors
    /// A sentence where its mark, or that of a cell before it, has two meanings.
    pub fn check(&mut self, row: u64, column: &Column, text: &str) -> Result<(), String> {
        if !(column.has_decimal_comma() && column.is_a_number()) {
            return Ok(());
        }
        let number = digits(text);
        let of_one_mark =
            |at: &usize| number.contains(MARKS[*at].0) && !number.contains(MARKS[1 - at].0);
        let Some(at) = (0..MARKS.len()).find(of_one_mark) else {
            return Ok(());
        };
        let cell = || Cell {
            row,
            head: column.head.clone(),
            text: text.to_owned(),
        };
        let (is_ambiguous, other) = (has_thousands(number, MARKS[at].0), &self.of[1 - at]);
        let (mark, doubtful, beside) = match (is_ambiguous, &other.any, &other.ambiguous) {
            (true, Some(beside), _) => (at, cell(), beside.clone()),
            (false, _, Some(doubtful)) => (1 - at, doubtful.clone(), cell()),
            _ => {
                let seen = &mut self.of[at];
                seen.any.get_or_insert_with(cell);
                if is_ambiguous {
                    seen.ambiguous.get_or_insert_with(cell);
                }
                return Ok(());
            }
        };
        let ((sign, name), (_, other)) = (MARKS[mark], MARKS[1 - mark]);
        let [decimal, thousands] = [".", ""].map(|read| doubtful.text.replace(sign, read));
        Err(format!(
            "the {} in '{}' (row {}, column {}) may separate decimals or thousands ({decimal} or \
             {thousands}), since '{}' (row {}, column \
             {}) has a {other}; write all decimals of the table with the same mark, and nothing \
             between thousands",
            name, doubtful.text, doubtful.row, doubtful.head, beside.text, beside.row, beside.head
        ))
    }
}
