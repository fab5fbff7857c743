use comfy_table::{CellAlignment, ColumnConstraint, ContentArrangement, Table, presets};

/// Minimum width of a column whose text is wrapped.
const NARROWEST: usize = 20;

/// Number of spaces before the first column, and after each column.
const MARGIN: usize = 2;

/// A table within `most` columns of a terminal, without lines between the cells; the columns
/// `right` are right-aligned. In a table that is too wide, the last column is wrapped if it
/// contains text. Otherwise the table continues below with the remaining columns, after a
/// repetition of the first column.
pub(super) fn table(
    head: &[&str],
    right: &[usize],
    rows: impl IntoIterator<Item = Vec<String>>,
    most: usize,
) -> String {
    let rows: Vec<Vec<String>> = rows.into_iter().collect();
    let all: Vec<usize> = (0..head.len()).collect();
    let widths: Vec<usize> = all
        .iter()
        .map(|&column| width(head, &rows, column))
        .collect();
    let last = head.len().saturating_sub(1);
    let of_others = MARGIN
        + widths
            .iter()
            .take(last)
            .map(|width| width + MARGIN)
            .sum::<usize>();
    if of_others + widths.last().unwrap_or(&0) <= most {
        return part(head, right, &rows, &all, None);
    }
    if !right.contains(&last) && of_others + NARROWEST <= most {
        return part(head, right, &rows, &all, Some(most));
    }
    let mut parts = vec![];
    let mut begun = 1;
    while begun < head.len() {
        let mut reach = MARGIN + widths[0] + MARGIN + widths[begun];
        let mut end = begun + 1;
        while end < head.len() && reach + MARGIN + widths[end] <= most {
            reach += MARGIN + widths[end];
            end += 1;
        }
        let columns: Vec<usize> = std::iter::once(0).chain(begun..end).collect();
        parts.push(part(head, right, &rows, &columns, None));
        begun = end;
    }
    parts.join("\n")
}

/// The width of a column.
fn width(head: &[&str], rows: &[Vec<String>], column: usize) -> usize {
    let lines = rows
        .iter()
        .filter_map(|row| row.get(column))
        .flat_map(|cell| cell.lines());
    lines
        .map(|line| line.chars().count())
        .chain([head[column].chars().count()])
        .max()
        .unwrap_or(0)
}

/// Some columns of a table. With the width `narrowed`, the last column is wrapped.
fn part(
    head: &[&str],
    right: &[usize],
    rows: &[Vec<String>],
    columns: &[usize],
    narrowed: Option<usize>,
) -> String {
    let mut table = Table::new();
    table.load_style(presets::NOTHING);
    match narrowed {
        Some(width) => table
            .set_content_arrangement(ContentArrangement::Dynamic)
            .set_width(width as u16),
        None => table.set_content_arrangement(ContentArrangement::Disabled),
    };
    table.set_header(columns.iter().map(|&column| head[column]));
    for row in rows {
        table.add_row(
            columns
                .iter()
                .map(|&column| row.get(column).map_or("", String::as_str)),
        );
    }
    for (at, column) in table.column_iter_mut().enumerate() {
        column.set_padding((if at == 0 { MARGIN as u16 } else { 0 }, MARGIN as u16));
        if right.contains(&columns[at]) {
            column.set_cell_alignment(CellAlignment::Right);
        }
        if narrowed.is_some() && at + 1 < columns.len() {
            column.set_constraint(ColumnConstraint::ContentWidth);
        }
    }
    table.trim_fmt() + "\n"
}

#[cfg(test)]
mod tests {
    use super::table;

    const WIDTH: usize = 100;

    fn widest(text: &str) -> usize {
        text.lines()
            .map(|line| line.chars().count())
            .max()
            .unwrap_or(0)
    }

    #[test]
    fn no_table_is_wider_than_a_terminal_and_nothing_is_lost() {
        let words =
            "a long explanation of what this row is about and what to do with it ".repeat(3);
        let text = table(
            &["name", "meaning"],
            &[],
            [vec!["x".repeat(40), words.trim().to_owned()]],
            WIDTH,
        );
        assert!(widest(&text) <= WIDTH && text.lines().count() > 3, "{text}");
        let kept: Vec<_> = text.split_whitespace().skip(3).collect();
        assert_eq!(kept.join(" "), words.trim());

        let names: Vec<String> = (0..12).map(|i| format!("column-{i:02}")).collect();
        let head: Vec<&str> = ["by"]
            .into_iter()
            .chain(names.iter().map(String::as_str))
            .collect();
        let right: Vec<usize> = (1..head.len()).collect();
        let row = std::iter::once("first".to_owned()).chain((0..12).map(|i| format!("{i}.25")));
        let text = table(&head, &right, [row.collect::<Vec<_>>()], WIDTH);
        assert!(widest(&text) <= WIDTH, "{text}");
        assert_eq!(text.matches("first").count(), 2, "{text}");
        assert!(
            (0..12)
                .all(|i| text.contains(&format!(" {i}.25"))
                    && text.contains(&format!("column-{i:02}"))),
            "{text}"
        );
    }
}
