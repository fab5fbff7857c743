//! Active bounds and constraints at an optimum in words, with their multipliers.

use super::shown;
use crate::optimize::{ConstraintValue, Status};
use crate::study::{Constraint, Sense};
use crate::units::{DisplayUnit, System, signed};

/// The objective at the end of a search. Multipliers have a meaning only at an optimum.
#[derive(Clone, Copy)]
pub(super) struct Objective {
    pub of: DisplayUnit,
    /// The value, SI.
    pub value: f64,
    pub sense: Sense,
    pub is_converged: bool,
}

/// The gain of the objective for each unit by which a limit is relaxed; for an equation, for each
/// unit by which its right side is raised.
pub(super) fn gain(constraint: &Constraint, at: &ConstraintValue) -> f64 {
    // the multiplier is the gain for each unit by which the limit is raised, < 0 at a lower limit
    if constraint.is_equation() {
        at.multiplier
    } else {
        at.multiplier.abs()
    }
}

impl Objective {
    /// The gain for each unit of `by`, with its sign: "+2.11 yd for each degree". Texts for golfers
    /// call this gain the price of the limit.
    pub fn price(self, amount: f64, by: impl Into<DisplayUnit>, system: System) -> String {
        // for a minimized objective, a decrease is a gain
        let amount = -self.sense.sign() * amount;
        let by = by.into();
        let one = by.size();
        let amount = shown::settled(amount * one, self.value, self.of, &[]) / one;
        signed(amount, shown::price(self.of, amount, by, system))
    }

    /// The state of a constraint in words, such as "active: +0.52 yd for each degree that the limit
    /// is relaxed". If there are two limits, the text names the active limit. `slopes` is the
    /// gradient of the limited goal by the varied parameters; `gain` is the gain of the objective
    /// for each unit by which the limit is relaxed, or by which the right side of an equation is
    /// raised.
    pub fn limit(
        self,
        constraint: &Constraint,
        at: &ConstraintValue,
        slopes: &[f64],
        gain: f64,
        system: System,
    ) -> String {
        let Constraint {
            goal, low, high, ..
        } = constraint;
        let price = |amount: f64| self.price(amount, goal, system);
        if low == high {
            let off = shown::goal_difference(goal, at.value - low, system);
            // an equation is active even if its multiplier is 0
            let price = match slopes.iter().any(|slope| *slope != 0.0) {
                true => format!(", {} that the value is raised", price(gain)),
                false => ", and no varied parameter changes it".into(),
            };
            return format!(
                "equality: off by {off}{}",
                if self.is_converged { &price } else { "" }
            );
        }
        match at.multiplier {
            _ if !self.is_converged => String::new(),
            0.0 => "not active".into(),
            _ if !(low.is_finite() && high.is_finite()) => {
                format!("active: {} that the limit is relaxed", price(gain))
            }
            0.0.. => format!(
                "active at its upper limit: {} that it is raised",
                price(gain)
            ),
            _ => format!(
                "active at its lower limit: {} that it is lowered",
                price(gain)
            ),
        }
    }
}

/// The state of a bound in words, such as "at its upper bound: +2.11 yd for each degree that it is
/// raised". The bound with a positive multiplier (`lower`, `upper`) is active. `prices` are the
/// gains of both bounds; `shown` formats a gain.
pub(super) fn bound(
    [lower, upper]: [f64; 2],
    prices: [f64; 2],
    shown: impl Fn(f64) -> String,
) -> String {
    if upper > 0.0 {
        format!("at its upper bound: {} that it is raised", shown(prices[1]))
    } else if lower > 0.0 {
        format!(
            "at its lower bound: {} that it is lowered",
            shown(prices[0])
        )
    } else {
        "free".into()
    }
}

/// The column head for the values at the end of a search; `converged` is the column head for an
/// optimum.
pub(super) fn ended_at(status: Status, converged: &'static str) -> &'static str {
    match status {
        Status::Converged => converged,
        Status::Infeasible => "nearest point",
        _ => "last point",
    }
}
