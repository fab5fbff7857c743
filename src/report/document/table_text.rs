//! Tables as plain text.

use super::DocumentTable;
use super::line::DETAILS;
use super::text::TextOptions;
use crate::report::lines::{INDENT, wrapped};
use crate::units::counted;
use comfy_table::{CellAlignment, ColumnConstraint, ContentArrangement, presets};

/// Minimum width of a column whose text is wrapped.
const NARROWEST: usize = 20;

/// Number of spaces before the first column, and after each column.
const MARGIN: usize = 2;

impl DocumentTable {
    /// The table with its caption, notes and remarks.
    pub(super) fn text(&self, options: &TextOptions) -> String {
        let width = options.width;
        let first = if options.all {
            usize::MAX
        } else {
            self.first_rows
        };
        let rows = &self.rows[..self.rows.len().min(first)];
        // do not wrap rows with notes: the code below adds one note to each line
        let most = if self.row_notes.is_empty() {
            width
        } else {
            usize::MAX
        };
        let mut text = self.columns(rows, most);
        if !self.row_notes.is_empty() {
            // the line with the column heads has no note
            let details = self.row_notes.iter();
            let details = details.map(|details| wrapped(details, [DETAILS; 2], width));
            let details = std::iter::once(String::new()).chain(details);
            text = text
                .lines()
                .zip(details)
                .map(|(line, details)| format!("{line}\n{details}"))
                .collect();
        }
        let caption = if self.caption.is_empty() {
            String::new()
        } else {
            wrapped(&self.caption, [0; 2], width)
        };
        let left_out = match self.rows.len() - rows.len() {
            0 => String::new(),
            rows => {
                let text = format!("{}: `all`", counted(rows as u64, "more row"));
                wrapped(&text, [INDENT; 2], width)
            }
        };
        let remarks = self.remarks.iter();
        let remarks = remarks.map(|line| wrapped(&line.text, [line.indent; 2], width));
        caption + &text + &left_out + &remarks.collect::<String>()
    }

    /// The heads and cells in lines of at most `most` characters, without ruled lines. If the table
    /// is too wide, a last column of text is wrapped. If that does not suffice, the remaining
    /// columns follow below, and the key columns are repeated.
    fn columns(&self, rows: &[Vec<String>], most: usize) -> String {
        let all: Vec<usize> = (0..self.head.len()).collect();
        let widths: Vec<usize> = all.iter().map(|&column| self.width(rows, column)).collect();
        let last = all.len().saturating_sub(1);
        let of_others = MARGIN
            + widths
                .iter()
                .take(last)
                .map(|width| width + MARGIN)
                .sum::<usize>();
        if of_others + widths.last().unwrap_or(&0) <= most {
            return self.part(rows, &all, None);
        }
        if !self.is_right[last] && of_others + NARROWEST <= most {
            return self.part(rows, &all, Some(most));
        }
        let keys = self.key_columns;
        let of_keys = MARGIN
            + widths[..keys]
                .iter()
                .map(|width| width + MARGIN)
                .sum::<usize>();
        let mut parts = vec![];
        let mut begun = keys;
        while begun < all.len() {
            let mut reach = of_keys + widths[begun];
            let mut end = begun + 1;
            while end < all.len() && reach + MARGIN + widths[end] <= most {
                reach += MARGIN + widths[end];
                end += 1;
            }
            let columns: Vec<usize> = (0..keys).chain(begun..end).collect();
            parts.push(self.part(rows, &columns, None));
            begun = end;
        }
        parts.join("\n")
    }

    fn width(&self, rows: &[Vec<String>], column: usize) -> usize {
        let lines = rows
            .iter()
            .filter_map(|row| row.get(column))
            .flat_map(|cell| cell.lines());
        lines
            .map(|line| line.chars().count())
            .chain([self.head[column].chars().count()])
            .max()
            .unwrap_or(0)
    }

    /// The heads and cells of some columns. With `narrowed`, the last column is wrapped so that the
    /// table has this width, in characters.
    fn part(&self, rows: &[Vec<String>], columns: &[usize], narrowed: Option<usize>) -> String {
        let mut table = comfy_table::Table::new();
        table.load_style(presets::NOTHING);
        match narrowed {
            Some(width) => table
                .set_content_arrangement(ContentArrangement::Dynamic)
                .set_width(width as u16),
            None => table.set_content_arrangement(ContentArrangement::Disabled),
        };
        table.set_header(columns.iter().map(|&column| &self.head[column]));
        for row in rows {
            table.add_row(
                columns
                    .iter()
                    .map(|&column| row.get(column).map_or("", String::as_str)),
            );
        }
        for (at, column) in table.column_iter_mut().enumerate() {
            column.set_padding((if at == 0 { MARGIN as u16 } else { 0 }, MARGIN as u16));
            if self.is_right[columns[at]] {
                column.set_cell_alignment(CellAlignment::Right);
            }
            if narrowed.is_some() && at + 1 < columns.len() {
                column.set_constraint(ColumnConstraint::ContentWidth);
            }
        }
        table.trim_fmt() + "\n"
    }
}

#[cfg(test)]
mod tests {
    use super::DocumentTable;
    use crate::report::document::text::TextOptions;

    const WIDTH: usize = 100;

    fn widest(text: &str) -> usize {
        text.lines()
            .map(|line| line.chars().count())
            .max()
            .unwrap_or(0)
    }

    #[test]
    fn the_rows_left_out_are_counted_in_words() {
        for (rows, words) in [(11, "1 more row: `all`"), (12, "2 more rows: `all`")] {
            let rows = (0..rows).map(|row| vec![row.to_string()]);
            let mut table = DocumentTable::new(["row"], rows);
            table.first_rows = 10;
            let text = table.text(&TextOptions {
                all: false,
                ..TextOptions::default()
            });
            assert!(text.contains(words), "{text}");
        }
    }

    #[test]
    fn no_table_is_wider_than_a_terminal_and_nothing_is_lost() {
        let words =
            "a long explanation of what this row is about and what to do with it ".repeat(3);
        let rows = [vec!["x".repeat(40), words.trim().to_owned()]];
        let table = DocumentTable::new(["name", "meaning"], rows.clone());
        let text = table.columns(&rows, WIDTH);
        assert!(widest(&text) <= WIDTH && text.lines().count() > 3, "{text}");
        let kept: Vec<_> = text.split_whitespace().skip(3).collect();
        assert_eq!(kept.join(" "), words.trim());

        let names: Vec<String> = (0..12).map(|i| format!("column-{i:02}")).collect();
        let head: Vec<&str> = ["by"]
            .into_iter()
            .chain(names.iter().map(String::as_str))
            .collect();
        let columns = head.len();
        let row = std::iter::once("first".to_owned()).chain((0..12).map(|i| format!("{i}.25")));
        let rows = [row.collect::<Vec<_>>()];
        let mut table = DocumentTable::new(head, rows.clone()).right(1..columns);
        table.key_columns = 2;
        let text = table.columns(&rows, WIDTH);
        assert!(widest(&text) <= WIDTH, "{text}");
        let repeated = ["first", "column-00", " 0.25"].map(|key| text.matches(key).count());
        assert_eq!(repeated, [2; 3], "{text}");
        assert!(
            (0..12)
                .all(|i| text.contains(&format!(" {i}.25"))
                    && text.contains(&format!("column-{i:02}"))),
            "{text}"
        );
    }
}
