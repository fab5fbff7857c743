//! Numbers of a page, in both systems of units.

use crate::drive::Outcome;
use crate::parameters::Parameter;
use crate::units::{Quantity, System, significant};
use maud::{Markup, html};

/// What is written in each system; once, where both are the same.
pub(super) fn both(write: impl Fn(System) -> String) -> Markup {
    let [us, metric] = [System::Us, System::Metric].map(write);
    html! {
        @if us == metric { (us) } @else { span.us { (us) } span.metric { (metric) } }
    }
}

/// A value in the units that golfers read.
fn value(quantity: Quantity, unit: &'static str, value: f64) -> Markup {
    both(|system| {
        let unit = system.unit(unit);
        let size = quantity.size_of(unit).unwrap_or(1.0);
        format!("{} {unit}", significant(value / size, 5)).trim_end().to_owned()
    })
}

/// The value of an outcome; a dash where there is none.
pub(super) fn outcome(of: Outcome, found: Option<f64>) -> Markup {
    found.map_or(html! { "–" }, |found| value(of.quantity(), of.unit(), found))
}

/// The value of a parameter.
pub(super) fn parameter(parameter: &Parameter, found: f64) -> Markup {
    value(parameter.quantity, parameter.unit, found)
}
