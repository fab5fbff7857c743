//! Multipliers of constraints and bounds in words.

use super::super::limits::{self, Objective, gain};
use super::super::shown;
use crate::optimize::Status;
use crate::parameters::Vary;
use crate::study::Optimum;
use crate::units::{System, signed};

/// The state of a constraint in words, such as "active: +0.52 yd for each degree that the limit is
/// relaxed".
pub(in crate::report) fn constraint_in_words(
    optimum: &Optimum,
    j: usize,
    system: System,
) -> String {
    let all = optimum.constraints();
    let Some((constraint, at)) = all.get(j) else {
        return String::new();
    };
    let slopes = optimum.solution.jacobian.get(j);
    let slopes = slopes.map_or(&[][..], Vec::as_slice);
    let objective = Objective {
        of: (&optimum.search.of).into(),
        value: optimum.value().unwrap_or_default(),
        sense: optimum.search.sense,
        is_converged: optimum.solution.status == Status::Converged,
    };
    objective.limit(constraint, at, slopes, gain(constraint, at), system)
}

/// The state of a bound in words, such as "at its upper bound: +2.11 yd for each degree that it is
/// raised"; without the gain where the search did not converge.
pub(in crate::report) fn bound_in_words(optimum: &Optimum, i: usize, system: System) -> String {
    let vary = optimum.search.vary[i];
    let goal = &optimum.search.of;
    let lower = optimum.solution.lower_multipliers[i];
    let upper = optimum.solution.upper_multipliers[i];
    let value = optimum.value().unwrap_or_default();
    let by = vary.parameter;
    let price = |amount: f64| {
        // for a minimized objective, a decrease is a gain
        let amount = -optimum.search.sense.sign() * amount;
        let amount = shown::settled(amount, value, goal, &[by]);
        signed(amount, shown::price(goal, amount, by, system))
    };
    let is_corner = optimum.solution.kink.is_some_and(|kink| kink.variable == i);
    if vary.low == vary.high {
        "fixed".into()
    } else if optimum.solution.status != Status::Converged {
        // multipliers have a meaning only at an optimum
        reached_bound(vary, optimum.solution.x[i]).into()
    } else if is_corner && upper + lower > 0.0 {
        let (bound, side) = if lower > 0.0 {
            ("lower", "above")
        } else {
            ("upper", "below")
        };
        format!(
            "at its {bound} bound, a corner: {} {side} it",
            price(-(upper + lower))
        )
    } else if optimum.is_idle(i) {
        "no effect".into()
    } else {
        limits::bound([lower, upper], [lower, upper], price)
    }
}

/// Largest distance from a bound at which the bound counts as reached, relative to the width of the
/// range. The QP solver ends a little inside the range.
const REACHED: f64 = 1e-6;

/// The bound that a value has reached; empty between the bounds.
fn reached_bound(vary: Vary, value: f64) -> &'static str {
    let margin = REACHED * (vary.high - vary.low);
    if value <= vary.low + margin {
        return "at its lower bound";
    }
    if value >= vary.high - margin {
        return "at its upper bound";
    }
    ""
}
