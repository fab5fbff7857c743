//! Tables of a page.

use maud::{Markup, html};

/// A table that scrolls sideways if it is wider than the page, also by keyboard. `label` describes
/// its content.
pub(in crate::report) fn scrolled(label: &str, table: Markup) -> Markup {
    html! { section.wide tabindex="0" aria-label=(label) { (table) } }
}

/// True if most cells of a column are numbers, with an optional unit of up to three letters
/// ("rpm"). Empty cells and dashes do not count.
pub(in crate::report) fn is_of_numbers<'a>(cells: impl Iterator<Item = &'a str>) -> bool {
    let cells: Vec<&str> = cells.filter(|cell| !["", "–"].contains(cell)).collect();
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
