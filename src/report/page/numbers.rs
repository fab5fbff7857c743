//! Numbers of a page, in both systems of units.

use crate::drive::Outcome;
use crate::parameters::Parameter;
use crate::report::shown;
use crate::units::{System, typeset};
use maud::{Markup, html};

/// What is written in each system, as pages print it; once, where both are the same.
pub(super) fn both(write: impl Fn(System) -> String) -> Markup {
    let [us, metric] = [System::Us, System::Metric].map(|system| typeset(&write(system)));
    html! {
        @if us == metric { (us) } @else { span.us { (us) } span.metric { (metric) } }
    }
}

/// The value of an outcome; a dash where there is none.
pub(super) fn outcome(of: Outcome, found: Option<f64>) -> Markup {
    both(|system| shown::outcome_or_dash(of, found, system))
}

/// A loss of an outcome.
pub(super) fn loss(of: Outcome, loss: f64) -> Markup {
    both(|system| shown::spread(of, loss, system))
}

/// A value of a parameter that was computed.
pub(super) fn parameter(parameter: &Parameter, found: f64) -> Markup {
    both(|system| shown::parameter(parameter, found, system))
}

/// A value of a parameter that was stated.
pub(super) fn stated(parameter: &Parameter, value: f64) -> Markup {
    both(|system| shown::stated(parameter, value, system))
}
