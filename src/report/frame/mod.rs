//! The frame of a page: a self-contained HTML file with its head, a switch of units, tables and
//! pictures.

mod picture;

pub use picture::TextFile;
pub(super) use picture::{picture_files, pictures, svg_name};

use super::in_both::InBoth;
use super::plot::dark_rules;
use crate::units::{System, typeset};
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
    // the classes of a text in one system of units
    let of_units = [r#"<span class="us""#, r#" us">"#];
    let has_units = [header, main]
        .into_iter()
        .any(|part| of_units.iter().any(|class| part.0.contains(class)));
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
                header { (header) @if has_units { (switch(system)) } }
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

/// The text that `write` returns for each system of units. If both texts are equal, the page has
/// the text once.
pub(super) fn both(write: impl Fn(System) -> String) -> Markup {
    let InBoth { metric, us } = InBoth::of(|system| typeset(&write(system)));
    html! {
        @if us == metric { (us) } @else { span.us { (us) } span.metric { (metric) } }
    }
}

/// A text in metric and in US units. If both are equal, the page has the text once.
pub(super) fn chosen(metric: &str, us: &str) -> Markup {
    both(|system| if system == System::Us { us } else { metric }.to_owned())
}

/// The switch of units, which needs no script.
fn switch(system: System) -> Markup {
    html! {
        fieldset.switch {
            legend { "Units" }
            input.units #units-us type="radio" name="units" checked[system == System::Us];
            label for="units-us" { "yd, mph" }
            input.units #units-metric type="radio" name="units" checked[system == System::Metric];
            label for="units-metric" { "m, m/s" }
        }
    }
}
