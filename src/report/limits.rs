//! Active bounds and constraints at an optimum in words, with their multipliers.

use super::shown;
use crate::optimize::Status;
use crate::study::{Constraint, ConstraintAtEnd, Optimum, Sense};
use crate::units::{DisplayUnit, System, signed};

/// The objective at the end of a search.
#[derive(Clone, Copy)]
pub(super) struct Objective {
    pub of: DisplayUnit,
    /// The value, SI.
    pub value: f64,
    pub sense: Sense,
    /// False if the end is not an optimum; multipliers have no meaning then.
    pub is_converged: bool,
}

/// The signed change of an objective that improves by `gain`. It is negative for a minimized
/// objective.
pub(in crate::report) fn change_of(sense: Sense, gain: f64) -> f64 {
    -sense.sign() * gain
}

impl Objective {
    /// The objective of an optimum.
    pub fn at(optimum: &Optimum) -> Self {
        Self {
            of: (&optimum.search.of).into(),
            value: optimum.value().unwrap_or_default(),
            sense: optimum.search.sense,
            is_converged: optimum.is_converged(),
        }
    }

    /// The price of a limit: the change of the objective for each unit by which the limit is
    /// relaxed, such as "+2.11 yd for each degree". The price of a minimized objective is negative
    /// if the objective improves. `gain` is the improvement for each SI unit; `by` has the unit of
    /// the limit.
    pub fn price(self, gain: f64, by: impl Into<DisplayUnit>, system: System) -> String {
        let by = by.into();
        let one = by.size();
        let change = change_of(self.sense, gain);
        let change = shown::zero_if_rounding(change * one, self.value, self.of, &[]) / one;
        signed(change, shown::price(self.of, change, by, system))
    }

    /// The state of a constraint in words, such as "active: +0.52 yd for each degree that the limit
    /// is relaxed". If the search did not converge, there is no price: the text is the deviation of
    /// an equation, and empty for other constraints.
    pub fn limit(self, limit: &ConstraintAtEnd<'_>, system: System) -> String {
        let Constraint { goal, low, .. } = limit.constraint;
        if limit.constraint.is_equation() {
            let off = shown::goal_difference(goal, limit.at.value - low, system);
            // an equation may have a multiplier of 0 although varied parameters change its value
            let price = match limit.slopes.iter().any(|slope| *slope != 0.0) {
                _ if !self.is_converged => String::new(),
                true => {
                    let price = self.price(limit.gain, goal, system);
                    format!(", {price} that the value is raised")
                }
                false => ", and no varied parameter changes it".into(),
            };
            return format!("equality: off by {off}{price}");
        }
        match self.active_limit(limit, system) {
            _ if !self.is_converged => String::new(),
            None => "not active".into(),
            Some(active) if limit.constraint.has_two_limits() => format!("active {active}"),
            Some(active) => format!("active: {active}"),
        }
    }

    /// The price of the active limit of a constraint, such as "+0.52 yd for each degree that the
    /// limit is relaxed". If the constraint has two limits, the text says which of them is active.
    /// `None` for an equation, or if no limit is active.
    pub fn active_limit(self, limit: &ConstraintAtEnd<'_>, system: System) -> Option<String> {
        let ConstraintAtEnd { constraint, at, .. } = limit;
        if at.multiplier == 0.0 || constraint.is_equation() {
            return None;
        }
        let price = self.price(limit.gain, &constraint.goal, system);
        Some(match at.multiplier {
            _ if !limit.constraint.has_two_limits() => format!("{price} that the limit is relaxed"),
            0.0.. => format!("at its upper limit: {price} that it is raised"),
            _ => format!("at its lower limit: {price} that it is lowered"),
        })
    }
}

/// The value of a limited goal, marked if it violates its limits.
pub(super) fn limited_value(constraint: &Constraint, value: f64, system: System) -> String {
    let text = shown::goal(&constraint.goal, value, system);
    if constraint.is_met(value) {
        text
    } else {
        format!("{text} (broken)")
    }
}

/// The state of a parameter's bounds in words: "free", or for example "at its upper bound: +2.11 yd
/// for each degree that it is raised". `lower` and `upper` are the multipliers; a bound with a
/// positive multiplier is active. `prices` are the gains if the lower or the upper bound is
/// relaxed, and `shown` formats a gain.
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

/// The column head for the values at the end of a search. If the search converged, the head is
/// `converged`.
pub(super) fn ended_at(status: Status, converged: &'static str) -> &'static str {
    match status {
        Status::Converged => converged,
        Status::Infeasible => "nearest point",
        _ => "last point",
    }
}
