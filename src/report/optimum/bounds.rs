//! The bounds of an optimum in words, with their multipliers.

use super::super::limits::{self, Objective};
use super::super::shown::END_TOLERANCE;
use crate::parameters::Vary;
use crate::study::Optimum;
use crate::units::System;

/// The state of the bounds of varied parameter `i` in words, such as "at its upper bound: +2.11 yd
/// for each degree that it is raised". The gain is omitted if the search did not converge.
pub(in crate::report) fn bound_in_words(optimum: &Optimum, i: usize, system: System) -> String {
    let vary = optimum.search.vary[i];
    let lower = optimum.solution.lower_multipliers[i];
    let upper = optimum.solution.upper_multipliers[i];
    let objective = Objective::at(optimum);
    let price = |gain: f64| objective.price(gain, vary.parameter, system);
    let corner = optimum.solution.kink.filter(|kink| kink.variable == i);
    if vary.low == vary.high {
        "fixed".into()
    } else if !objective.is_converged {
        // only an optimum has meaningful multipliers
        reached_bound(vary, optimum.solution.x[i]).into()
    } else if let Some(kink) = corner {
        // a step away from a minimum of f loses |∂f/∂x| for each unit
        let below = kink
            .slope_below
            .map(|below| format!("{} below it", price(below)));
        let above = kink
            .slope_above
            .map(|above| format!("{} above it", price(-above)));
        let place = match (&below, &above) {
            (None, _) => "at its lower bound, a corner",
            (_, None) => "at its upper bound, a corner",
            _ => "at a corner",
        };
        let sides: Vec<_> = below.into_iter().chain(above).collect();
        format!("{place}: {}", sides.join(", "))
    } else if optimum.is_idle(i) {
        "no effect".into()
    } else {
        limits::bound([lower, upper], [lower, upper], price)
    }
}

/// The bound that a value has reached; empty between the bounds.
fn reached_bound(vary: Vary, value: f64) -> &'static str {
    let margin = END_TOLERANCE * (vary.high - vary.low);
    if value <= vary.low + margin {
        return "at its lower bound";
    }
    if value >= vary.high - margin {
        return "at its upper bound";
    }
    ""
}
