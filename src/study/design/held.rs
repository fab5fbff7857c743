//! What holds a design, and how it stands at the best one.

use super::rules::Rule;
use crate::study::Optimum;
use crate::units::Quantity;

/// What a search may leave of a limit unmet, of the change that its price is told for.
const MET: f64 = 1e-6;

/// A rule, a condition or a limit that holds a design.
#[derive(Clone, Debug)]
pub struct Held {
    /// What it is: `moment of inertia`.
    pub name: String,
    /// As an expression: `head_moi <= 5900 g cm^2 + 100 g cm^2`.
    pub expression: String,
    /// The rule of golf, if it is one.
    pub rule: Option<&'static Rule>,
    /// How it holds.
    pub by: By,
    /// The least and the greatest value, SI, or infinite.
    pub range: [f64; 2],
    /// What kind of number it is.
    pub quantity: Quantity,
    /// The unit that it is shown in.
    pub unit: &'static str,
    /// The change of the limit that its price is told for, SI.
    pub step: f64,
}

/// How a design is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum By {
    /// By a bound of this varied parameter.
    Bound(usize),
    /// By this limit of the search.
    Limit(usize),
    /// By nothing: what is varied does not change this value, which was checked.
    Value(f64),
    /// It was not checked: the number is not known.
    Unknown,
}

/// How a design that was found stands to what holds it.
#[derive(Clone, Debug)]
pub struct Standing {
    /// What holds it.
    pub held: Held,
    /// Its value, SI; `None` where it is not known.
    pub value: Option<f64>,
    /// How far it is from the nearer limit, SI; below 0 where it is violated.
    pub margin: Option<f64>,
    /// What the goal would gain for each SI unit that the limit is relaxed; `None` where the limit
    /// does not hold the design.
    pub price: Option<f64>,
}

impl Held {
    /// How it stands at the best design.
    pub fn at(&self, best: &Optimum) -> Standing {
        let solution = &best.solution;
        let margin_of = |value: f64| (value - self.range[0]).min(self.range[1] - value);
        // what is not met has no price
        let price_of = |value: Option<f64>, multiplier: f64| {
            let is_met = value.is_none_or(|value| margin_of(value) >= -MET * self.step);
            (multiplier > 0.0 && is_met).then_some(multiplier)
        };
        let (value, price) = match self.by {
            By::Bound(i) => {
                let vary = best.search.vary[i];
                // a bound of the search that is closer than the rule has the multiplier, and the
                // rule has none
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
            By::Limit(k) => {
                // the search met the limit of the smoothed goal
                let smoothed = solution.constraints.get(k);
                let value = best.constraints().get(k).map(|(_, at)| at.value);
                (
                    value,
                    smoothed.and_then(|at| price_of(Some(at.value), at.multiplier.abs())),
                )
            }
            By::Value(value) => (Some(value), None),
            By::Unknown => (None, None),
        };
        let margin = value.map(margin_of);
        Standing {
            held: self.clone(),
            value,
            margin,
            price,
        }
    }
}
