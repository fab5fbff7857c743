//! The frame of a page: a self-contained HTML file with its head, a switch of units, tables and
//! pictures.

mod picture;
mod units;

pub use picture::TextFile;
pub(super) use picture::{Pair, picture_files, pictures, svg_name};
pub(super) use units::{both, chosen};

use super::plot::dark_rules;
use crate::units::System;
use maud::{DOCTYPE, Markup, PreEscaped, html};

/// The HTML of a page with a window title, a header, content and a footer. If a text differs
/// between the systems of units, a switch of units is below the header. The page opens in the units
/// of `system`.
pub(super) fn page(
    title: &str,
    header: &Markup,
    main: &Markup,
    footer: Option<Markup>,
    system: System,
) -> String {
    let dark = format!(
        "@media screen and (prefers-color-scheme: dark) {{\n{}{}}}",
        include_str!("dark.css"),
        dark_rules("figure")
    );
    let has_units = [header, main].into_iter().any(units::has_both);
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                style { (PreEscaped(include_str!("style.css"))) (PreEscaped(dark)) }
            }
            body {
                header { (header) @if has_units { (units::switch(system)) } }
                main { (main) }
                @if let Some(footer) = footer { footer { (footer) } }
            }
        }
    };
    page.into_string()
}

/// A table that scrolls sideways if it is wider than the page, also by keyboard. `label` describes
/// its content.
pub(super) fn scrolled(label: &str, table: Markup) -> Markup {
    html! { section.wide tabindex="0" aria-label=(label) { (table) } }
}
