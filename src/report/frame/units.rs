//! Texts of a page in both systems of units, between which the reader can switch.

use crate::units::{System, typeset};
use maud::{Markup, html};

/// True if a part of a page has a text that differs between the systems of units.
pub(super) fn has_both(part: &Markup) -> bool {
    [r#"<span class="us""#, r#" us">"#]
        .iter()
        .any(|class| part.0.contains(class))
}

/// The text that `write` returns for each system of units. If both texts are equal, the page has
/// the text once.
pub(in crate::report) fn both(write: impl Fn(System) -> String) -> Markup {
    let [us, metric] = [System::Us, System::Metric].map(|system| typeset(&write(system)));
    html! {
        @if us == metric { (us) } @else { span.us { (us) } span.metric { (metric) } }
    }
}

/// A text in metric and in US units. If both are equal, the page has the text once.
pub(in crate::report) fn chosen(metric: &str, us: &str) -> Markup {
    both(|system| if system == System::Us { us } else { metric }.to_owned())
}

/// The switch of units, which needs no script.
pub(super) fn switch(system: System) -> Markup {
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
