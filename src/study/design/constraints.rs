//! Constraints on a design, and their slack and multiplier at the optimum.

use super::rules::GolfRule;
use crate::study::Optimum;
use crate::study::goal::limit_rounding;
use crate::units::DisplayUnit;

/// A constraint on a design: a rule of golf, a physical condition or a user's limit.
#[derive(Clone, Debug)]
pub struct DesignConstraint {
    /// Name: `moment of inertia`.
    pub name: String,
    /// Expression: `head_moi <= 5900 g cm^2 + 100 g cm^2`.
    pub expression: String,
    /// The rule of golf; `None` for other constraints.
    pub rule: Option<&'static GolfRule>,
    /// Method by which the search enforces the constraint.
    pub enforcement: Enforcement,
    /// Lower and upper limit, SI; may be infinite.
    pub range: [f64; 2],
    /// Physical quantity of the value, with its display unit.
    pub unit: DisplayUnit,
    /// Change of the limit, SI. Reports state the effect of this change on the goal.
    pub reported_change: f64,
}

/// How a constraint is enforced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Enforcement {
    /// By a bound of the search on the varied parameter with this index.
    Bound(usize),
    /// By the constraint of the search with this index.
    Limit(usize),
    /// Checked once: the varied parameters do not change this value.
    Value(f64),
    /// Unchecked: the value is unknown.
    Unknown,
}

/// State of a constraint at the optimum.
#[derive(Clone, Debug)]
pub struct ConstraintState {
    /// The constraint.
    pub constraint: DesignConstraint,
    /// Value of the limited quantity, SI; `None` if unknown.
    pub value: Option<f64>,
    /// Distance to the nearer limit, SI, negative if violated; `None` if the value is unknown.
    pub margin: Option<f64>,
    /// Gain of the goal per SI unit by which the limit is relaxed (Lagrange multiplier); `None` if
    /// the constraint is inactive, violated, or not enforced by the search.
    pub price: Option<f64>,
}

impl DesignConstraint {
    /// State at the best design.
    pub fn at(&self, best: &Optimum) -> ConstraintState {
        let solution = &best.solution;
        let margin_of = |value: f64| (value - self.range[0]).min(self.range[1] - value);
        // a violated constraint has no multiplier
        let price_of = |value: Option<f64>, multiplier: f64| {
            let is_met =
                value.is_none_or(|value| margin_of(value) >= -limit_rounding(value, self.unit));
            (multiplier > 0.0 && is_met).then_some(multiplier)
        };
        let (value, price) = match self.enforcement {
            Enforcement::Bound(i) => {
                let vary = best.search.vary[i];
                // the multiplier belongs to the rule only if the bound of the search equals the
                // limit of the rule; otherwise the bound is a tighter one of the user
                let [lower, upper] = [self.range[0] == vary.low, self.range[1] == vary.high];
                let multiplier = |is: bool, of: &[f64]| {
                    if is {
                        of.get(i).copied().unwrap_or_default()
                    } else {
                        0.0
                    }
                };
                let both = multiplier(lower, &solution.lower_multipliers)
                    + multiplier(upper, &solution.upper_multipliers);
                let value = solution.x.get(i).copied();
                (value, price_of(value, both))
            }
            Enforcement::Limit(k) => {
                // the search limits the smoothed goal, so the smoothed value decides whether the
                // limit is met
                let smoothed = solution.constraints.get(k);
                let value = best.constraints().get(k).map(|limit| limit.at.value);
                (
                    value,
                    smoothed.and_then(|at| price_of(Some(at.value), at.multiplier.abs())),
                )
            }
            Enforcement::Value(value) => (Some(value), None),
            Enforcement::Unknown => (None, None),
        };
        let margin = value.map(margin_of);
        ConstraintState {
            constraint: self.clone(),
            value,
            margin,
            price,
        }
    }
}
