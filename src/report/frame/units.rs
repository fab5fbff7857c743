//! What a page shows in both systems of units, of which the reader chooses one.

use crate::units::{System, typeset};
use maud::{Markup, html};

/// A part of a page differs between the units.
pub(super) fn has_both(part: &Markup) -> bool {
    [r#"<span class="us""#, r#" us">"#]
        .iter()
        .any(|class| part.0.contains(class))
}

/// A text in each system of units; once, if both are equal.
pub(in crate::report) fn both(write: impl Fn(System) -> String) -> Markup {
    let [us, metric] = [System::Us, System::Metric].map(|system| typeset(&write(system)));
    html! {
        @if us == metric { (us) } @else { span.us { (us) } span.metric { (metric) } }
    }
}

/// The choice of the units, without any script.
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
