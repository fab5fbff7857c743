use super::line::Line;

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
    /// Number of columns, from the left, that identify a row. If a text is too narrow for all
    /// columns, each of its parts begins with them. On a narrow page, their cells have no heads. At
    /// most the number of columns.
    pub key_columns: usize,
}

impl DocumentTable {
    /// A table with these column heads, whose columns are left-aligned.
    pub fn new<H: Into<String>>(
        head: impl IntoIterator<Item = H>,
        rows: impl IntoIterator<Item = Vec<String>>,
    ) -> Self {
        let head: Vec<String> = head.into_iter().map(Into::into).collect();
        Self {
            is_right: vec![false; head.len()],
            head,
            rows: rows.into_iter().collect(),
            caption: String::new(),
            row_notes: vec![],
            remarks: vec![],
            first_rows: usize::MAX,
            key_columns: 1,
        }
    }

    /// Right-aligns these columns, as columns of numbers are.
    #[must_use]
    pub fn right(mut self, columns: impl IntoIterator<Item = usize>) -> Self {
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
