//! The frame of a page: a self-contained HTML file with its head, a switch of units, tables and
//! pictures.

mod picture;
mod table;
mod units;

pub use picture::TextFile;
pub(super) use picture::{Pair, in_each, picture_files, pictures, svg_name};
pub(super) use table::{is_of_numbers, scrolled};
pub(super) use units::both;

use super::plot::dark_rules;
use crate::units::System;
use maud::{DOCTYPE, Markup, PreEscaped, html};

/// A page.
pub(super) struct Frame<'a> {
    /// The title of the window.
    pub title: &'a str,
    /// The heading, above the switch of units.
    pub header: Markup,
    /// The content.
    pub main: Markup,
    /// The footer.
    pub footer: Option<Markup>,
    /// The units shown when the page opens.
    pub system: System,
}

impl Frame<'_> {
    /// The HTML of the page, with a switch of units if a text differs between the systems.
    pub fn page(self) -> String {
        let Self {
            title,
            header,
            main,
            footer,
            system,
        } = self;
        let dark = format!(
            "@media screen and (prefers-color-scheme: dark) {{\n{}{}}}",
            include_str!("dark.css"),
            dark_rules("figure")
        );
        let has_units = [&header, &main].into_iter().any(units::has_both);
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
}
