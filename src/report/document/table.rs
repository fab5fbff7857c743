use super::line::Line;
use crate::report::shown::NONE;

/// A table with remarks below it.
#[derive(Clone, Debug)]
pub struct DocumentTable {
    pub(super) head: Vec<String>,
    pub(super) rows: Vec<Vec<String>>,
    /// For each column: true if it is right-aligned.
    pub(super) is_right: Vec<bool>,
    /// A line directly above the table; omitted if it is empty.
    pub caption: String,
    /// Details below each row: a text for each row, or no texts. An empty text is omitted.
    pub row_notes: Vec<String>,
    /// Lines directly below the table.
    pub remarks: Vec<Line>,
    /// Number of rows in a plain text without the option `all`.
    pub first_rows: usize,
}

impl DocumentTable {
    /// A table with these column heads. Columns of numbers are right-aligned.
    pub fn new<H: Into<String>>(
        head: impl IntoIterator<Item = H>,
        rows: impl IntoIterator<Item = Vec<String>>,
    ) -> Self {
        let head: Vec<String> = head.into_iter().map(Into::into).collect();
        let rows: Vec<Vec<String>> = rows.into_iter().collect();
        let is_right = (0..head.len())
            .map(|column| {
                let cells = rows.iter().filter_map(|row| row.get(column));
                is_of_numbers(cells.map(String::as_str))
            })
            .collect();
        Self {
            head,
            rows,
            is_right,
            caption: String::new(),
            row_notes: vec![],
            remarks: vec![],
            first_rows: usize::MAX,
        }
    }

    /// Right-aligns exactly these columns.
    #[must_use]
    pub fn right(mut self, columns: impl IntoIterator<Item = usize>) -> Self {
        self.is_right.fill(false);
        for column in columns {
            self.is_right[column] = true;
        }
        self
    }

    /// Adds a remark directly below the table.
    pub fn remark(&mut self, text: impl Into<String>) {
        self.remarks.push(Line::item(text));
    }

    /// The heads, cells, caption, row notes and remarks, as mutable texts.
    pub(super) fn texts(&mut self) -> impl Iterator<Item = &mut String> {
        let remarks = self.remarks.iter_mut().map(|line| &mut line.text);
        self.head
            .iter_mut()
            .chain(self.rows.iter_mut().flatten())
            .chain([&mut self.caption])
            .chain(&mut self.row_notes)
            .chain(remarks)
    }

    /// The row notes, then the remarks.
    pub(super) fn notes(&self) -> impl Iterator<Item = &str> {
        let remarks = self.remarks.iter().map(|line| line.text.as_str());
        self.row_notes.iter().map(String::as_str).chain(remarks)
    }
}

/// True if more than half of the cells are numbers. A number may have a unit of up to three letters
/// ("rpm"). Empty cells and dashes do not count.
fn is_of_numbers<'a>(cells: impl Iterator<Item = &'a str>) -> bool {
    let cells: Vec<&str> = cells.filter(|cell| !["", NONE].contains(cell)).collect();
    let numbers = cells.iter().filter(|cell| is_number(cell)).count();
    2 * numbers > cells.len()
}

fn is_number(cell: &str) -> bool {
    let digits = cell.trim_start_matches(['+', '-', '−', '±', '<', '≤', ' ']);
    let has_words = || {
        cell.split(|c: char| !c.is_alphabetic())
            .any(|word| word.chars().count() > 3)
    };
    digits.starts_with(|c: char| c.is_ascii_digit()) && !has_words()
}

#[cfg(test)]
mod tests {
    use super::is_of_numbers;

    #[test]
    fn columns_of_numbers_and_of_words_are_aligned() {
        for (cells, is) in [
            (vec!["8.75°", "−0.5 deg", "–"], true),
            (
                vec!["248.48 m (271.74 yd)", "does not fly", "114.3 m"],
                true,
            ),
            (vec!["0.1497 .. 0.1502 1/s"], true),
            (vec!["1 club.loft", "2 swing.speed"], false),
            (vec!["smooth", "the report's loop"], false),
            (vec!["", "–"], false),
        ] {
            assert_eq!(is_of_numbers(cells.iter().copied()), is, "{cells:?}");
        }
    }
}
