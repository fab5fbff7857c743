//! Bounds and limits at an optimum in words: which of them are active, and what moving them would
//! bring.

use super::shown;
use crate::optimize::{Constrained, Status};
use crate::study::Sense;
use crate::units::{Quantity, System, signed, significant};

/// What is sought: its kind and unit, its value, which value of it, and whether it was found. A
/// multiplier is a price at an optimum only.
#[derive(Clone, Copy)]
pub(super) struct Sought {
    pub of: (Quantity, &'static str),
    /// Where the search ended, SI.
    pub value: f64,
    pub sense: Sense,
    pub is_converged: bool,
}

/// A limit where a search ended.
#[derive(Clone, Copy)]
pub(super) struct Limit<'a> {
    /// The kind and unit of what is limited.
    pub by: (Quantity, &'static str),
    /// Least and greatest value, SI.
    pub range: [f64; 2],
    /// Value and multiplier, of a search that minimizes.
    pub at: &'a Constrained,
    /// The gradient of what is limited by what is varied.
    pub slopes: &'a [f64],
    /// What is gained for each unit that it is relaxed; of an equation, that it is raised.
    pub gain: f64,
}

impl<'a> Limit<'a> {
    /// A limit whose multiplier is its price.
    pub fn new(
        by: (Quantity, &'static str),
        range @ [low, high]: [f64; 2],
        at: &'a Constrained,
        slopes: &'a [f64],
    ) -> Self {
        let gain = if low == high {
            at.multiplier
        } else {
            at.multiplier.abs()
        };
        Self {
            by,
            range,
            at,
            slopes,
            gain,
        }
    }
}

impl Sought {
    /// What a unit of something brings, with its sign: "+2.11 yd for each degree".
    pub fn price(self, amount: f64, by: (Quantity, &'static str), system: System) -> String {
        // a smaller value is a gain where the smallest is looked for
        let amount = if self.sense == Sense::Maximize {
            amount
        } else {
            -amount
        };
        let one = by.0.size_of(by.1).unwrap_or(1.0);
        let amount = shown::settled(amount * one, self.value, self.of, &[]) / one;
        signed(amount, shown::price(self.of, amount, by, system))
    }

    /// "active: +0.52 yd for each degree that the limit is relaxed"; of two limits, which one.
    pub fn limit(self, limit: Limit<'_>, system: System) -> String {
        let Limit {
            by,
            range: [low, high],
            at,
            slopes,
            gain,
        } = limit;
        let price = |amount: f64| self.price(amount, by, system);
        if low == high {
            let off = match system.unit(by.1) {
                "" => significant(at.value - low, 2),
                unit => by.0.read_off_difference(at.value - low, unit),
            };
            // it holds an optimum whatever its price
            let price = match slopes.iter().any(|slope| *slope != 0.0) {
                true => format!(", {} that the value is raised", price(gain)),
                false => ", and nothing that is varied moves it".into(),
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

/// "at its upper bound: +2.11 yd for each degree that it is raised" by the multipliers of a
/// parameter's lower and upper bound, and by their prices, of which `shown` says what a unit
/// brings.
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

/// What the column of the values is called where a search ended: `converged` where they are an
/// optimum.
pub(super) fn ended_at(status: Status, converged: &'static str) -> &'static str {
    match status {
        Status::Converged => converged,
        // no point was found that meets the constraints
        Status::Infeasible => "nearest point",
        _ => "last point",
    }
}
