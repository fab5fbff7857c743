//! Texts of a page in both systems of units, between which the reader can switch.

use crate::units::{System, typeset};
use maud::{Markup, html};

/// True if a part of a page differs between the systems.
pub(super) fn has_both(part: &Markup) -> bool {
    [r#"<span class="us""#, r#" us">"#]
        .iter()
        .any(|class| part.0.contains(class))
}

/// A text in both systems of units; only once if both are equal.
pub(in crate::report) fn both(write: impl Fn(System) -> String) -> Markup {
    let [us, metric] = [System::Us, System::Metric].map(|system| typeset(&write(system)));
    html! {
        @if us == metric { (us) } @else { span.us { (us) } span.metric { (metric) } }
    }
}

/// A text given in each system of units; only once if both are equal.
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
