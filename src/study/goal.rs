//! The objective of a search (a weighted sum of measures of drives) and its constraints (weighted
//! sums between limits).

use super::swings::{Measure, Strokes};
use crate::drive::Outcome;
use crate::error::{Error, Result};
use crate::optimize::ConstraintValue;
use crate::units::{Digits, DisplayUnit, Message, Quantity};
use serde::{Serialize, Serializer};

/// A weighted sum of measures, such as `mean(carry) - 0.5*std(lateral)`, or an outcome of one
/// drive.
#[derive(Clone, Debug, PartialEq)]
pub struct Goal {
    /// The text from which the goal was parsed, or the name of the outcome.
    pub expression: String,
    /// Each measure with its weight, SI.
    pub terms: Vec<(f64, Measure)>,
    /// The kind of quantity of the sum.
    pub quantity: Quantity,
    /// Display unit of the goal.
    pub unit: &'static str,
}

/// Serialized as its text.
impl Serialize for Goal {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.expression)
    }
}

#[cfg(test)]
impl schemars::JsonSchema for Goal {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Goal".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        String::json_schema(generator)
    }
}

/// A goal between limits: `std(lateral) <= 12 yd` over swings, or `descent_angle >= 38 deg` for one
/// drive.
#[derive(Clone, Debug, PartialEq)]
pub struct Constraint {
    /// The text from which the constraint was parsed.
    pub expression: String,
    /// The constrained quantity.
    pub goal: Goal,
    /// Lower limit, SI, or −∞.
    pub low: f64,
    /// Upper limit, SI, or ∞.
    pub high: f64,
}

/// A constraint at the end of a search.
#[derive(Clone, Copy, Debug)]
pub struct ConstraintAtEnd<'a> {
    /// The constraint.
    pub constraint: &'a Constraint,
    /// Exact value of the limited goal, and the multiplier of the constraint.
    pub at: ConstraintValue,
    /// Gradient of the limited goal by the variables of the search; empty if it is unknown.
    pub slopes: &'a [f64],
    /// Improvement of the objective for each SI unit by which the limit is relaxed. An equation has
    /// the improvement for each SI unit by which its right side is raised.
    pub gain: f64,
}

impl Goal {
    /// The smallest and the largest possible value of the goal, −∞ or ∞ where it is unlimited.
    pub(super) fn range(&self) -> [f64; 2] {
        match self.terms.as_slice() {
            [(1.0, Measure::Within(..))] => [0.0, 1.0],
            [(1.0, Measure::Deviation(_) | Measure::RootMeanSquare(_))] => [0.0, f64::INFINITY],
            _ => [f64::NEG_INFINITY, f64::INFINITY],
        }
    }

    /// The mean of an outcome over the swings.
    pub fn mean(of: Outcome) -> Self {
        Self {
            expression: format!("mean({})", of.name()),
            ..Self::from(of)
        }
    }

    /// The outcome, if the goal is an outcome of one drive.
    pub fn outcome(&self) -> Option<Outcome> {
        match self.terms.as_slice() {
            [(1.0, Measure::Mean(of))] if self.expression == of.name() => Some(*of),
            _ => None,
        }
    }

    /// Outcomes that the measures of the goal need.
    pub fn outcomes(&self) -> Vec<Outcome> {
        self.terms
            .iter()
            .flat_map(|(_, measure)| measure.outcomes())
            .collect()
    }

    /// Tables of strokes that the measures need, each with the length of the hole, m.
    pub fn strokes(&self) -> impl Iterator<Item = (&Strokes, f64)> {
        self.terms.iter().filter_map(|(_, measure)| match measure {
            Measure::Strokes(strokes, hole) => Some((strokes, *hole)),
            _ => None,
        })
    }

    /// Change of the goal that counts as no effect of a parameter over its range, SI: 1 mm, or 1e-6
    /// of the value if it is not a length.
    pub(super) fn negligible(&self, value: f64) -> f64 {
        match self.quantity {
            Quantity::LENGTH => 1e-3,
            _ => 1e-6 * value.abs(),
        }
    }

    /// True if a measure has a kink or jump, which the search smooths.
    pub(super) fn has_edge(&self) -> bool {
        self.terms.iter().any(|(_, measure)| measure.has_edge())
    }
}

/// An outcome of one drive as a goal: its mean over this drive.
impl From<Outcome> for Goal {
    fn from(of: Outcome) -> Self {
        Self {
            expression: of.name().into(),
            terms: vec![(1.0, Measure::Mean(of))],
            quantity: of.quantity(),
            unit: of.unit(),
        }
    }
}

impl From<&Goal> for DisplayUnit {
    fn from(goal: &Goal) -> Self {
        Self {
            quantity: goal.quantity,
            unit: goal.unit,
        }
    }
}

impl Constraint {
    /// The constraint in words, such as `apex_height <= 27 yd`, with its limits in the units in
    /// which the message is shown.
    pub fn message(&self) -> Message {
        let limit = |message: Message, value: f64| {
            let (quantity, unit) = (self.goal.quantity, self.goal.unit);
            message.quantity(quantity, unit, value, Digits::Significant(7))
        };
        let mut message = Message::default();
        if self.has_two_limits() && !self.is_equation() {
            message = limit(message, self.low).words(" <= ");
        }
        message = message.words(self.goal.expression.as_str());
        match self.high.is_finite() {
            _ if self.is_equation() => limit(message.words(" = "), self.low),
            true => limit(message.words(" <= "), self.high),
            false => limit(message.words(" >= "), self.low),
        }
    }

    /// A goal with infinite limits: it is computed, but not limited.
    pub(super) fn unlimited(goal: Goal) -> Self {
        Self {
            expression: goal.expression.clone(),
            goal,
            low: f64::NEG_INFINITY,
            high: f64::INFINITY,
        }
    }

    /// True if both limits are equal.
    pub fn is_equation(&self) -> bool {
        self.low == self.high
    }

    /// True if both limits are finite.
    pub fn has_two_limits(&self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }

    /// Distance of a value from the range: positive above the upper limit, negative below the lower
    /// limit, 0 between them.
    pub fn violation(&self, value: f64) -> f64 {
        value - value.clamp(self.low, self.high)
    }

    /// The constraint at the end of a search. The exact value of the goal replaces the smoothed
    /// value in `at`.
    pub(super) fn exactly(&self, value: f64, at: &ConstraintValue) -> ConstraintValue {
        ConstraintValue {
            value,
            violation: self.violation(value),
            ..*at
        }
    }

    /// True if a value is within the limits, up to the rounding of a search: 1e-6 · max(|value|,
    /// one display unit).
    pub fn is_met(&self, value: f64) -> bool {
        let rounding = limit_rounding(value, (&self.goal).into());
        (self.low - rounding..=self.high + rounding).contains(&value)
    }

    /// Refuses reversed limits, and limits that are not numbers. Constraints parsed from text never
    /// have such limits.
    ///
    /// # Errors
    /// [`Error::SearchRange`] for these limits.
    pub(super) fn check(&self) -> Result<()> {
        if self.low <= self.high {
            return Ok(());
        }
        let show = |limit: f64| DisplayUnit::from(&self.goal).show(limit);
        let (low, high) = (show(self.low), show(self.high));
        Err(Error::SearchRange {
            name: self.expression.clone(),
            reason: format!(
                "its limits are {low} and {high}; the lower limit must be a number not above the \
                 upper limit"
            ),
        })
    }
}

/// Tolerance with which a search meets a limit, SI: 1e-6 · max(|value|, one display unit).
pub(super) fn limit_rounding(value: f64, unit: DisplayUnit) -> f64 {
    1e-6 * value.abs().max(unit.size())
}
