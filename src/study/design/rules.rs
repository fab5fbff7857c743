//! Numerical limits of the Rules of Golf for head and ball.

use crate::drive::Outcome;
use crate::parameters::Setup;
use crate::units::{DisplayUnit, Quantity};

/// A rule: a limit on one number.
#[derive(Debug)]
pub struct GolfRule {
    /// Name.
    pub name: &'static str,
    /// The limited quantity.
    pub of: LimitedQuantity,
    /// True for a maximum, false for a minimum.
    pub is_greatest: bool,
    /// The limit, with unit.
    pub limit: &'static str,
    /// Tolerance of the test, if any.
    pub tolerance: Option<&'static str>,
    /// Change of the limit, with unit. Reports state the effect of this change on the goal.
    pub reported_change: &'static str,
    /// Source.
    pub source: &'static str,
    /// Advice for a setup that breaks the rule.
    pub hint: &'static str,
}

/// The quantity that a rule limits.
#[derive(Clone, Copy, Debug)]
pub enum LimitedQuantity {
    /// A parameter, by name.
    Parameter(&'static str),
    /// An outcome of the head.
    Outcome(Outcome),
    /// A quantity that no parameter has. A user may compute it by a relation with this name.
    Relation(&'static str, Quantity),
}

/// The rules (R&A and USGA, Equipment Rules).
pub static RULES: [GolfRule; 5] = [
    GolfRule {
        name: "moment of inertia",
        of: LimitedQuantity::Outcome(Outcome::HeadMoi),
        is_greatest: true,
        limit: "5900 g cm^2",
        tolerance: Some("100 g cm^2"),
        reported_change: "100 g cm^2",
        source: "Equipment Rules, part 2, 4b: about the vertical axis through the centre of \
                 gravity",
        hint: "",
    },
    GolfRule {
        name: "volume",
        of: LimitedQuantity::Relation("volume", Quantity::VOLUME),
        is_greatest: true,
        limit: "460 cm^3",
        tolerance: Some("10 cm^3"),
        reported_change: "10 cm^3",
        source: "Equipment Rules, part 2, 4b",
        hint: "",
    },
    GolfRule {
        name: "spring effect",
        of: LimitedQuantity::Parameter("impact.restitution"),
        is_greatest: true,
        limit: "0.822",
        tolerance: Some("0.008"),
        reported_change: "0.01",
        source: "Equipment Rules, part 2, 4c: as a restitution; the test of today measures the \
                 time of contact, 239 + 18 µs",
        hint: " (the restitution of tour-average and lpga-average was tested on no club: it is \
               chosen so that the ball speed agrees with the published averages, and compensates \
               all other errors, such as a head speed that was measured too low; design with the \
               limit, or with modern-driver)",
    },
    GolfRule {
        name: "weight of the ball",
        of: LimitedQuantity::Parameter("ball.mass"),
        is_greatest: true,
        limit: "45.93 g",
        tolerance: None,
        reported_change: "0.1 g",
        source: "Equipment Rules, part 4: at most 1.620 oz",
        hint: "",
    },
    GolfRule {
        name: "size of the ball",
        of: LimitedQuantity::Parameter("ball.radius"),
        is_greatest: false,
        limit: "21.335 mm",
        tolerance: None,
        reported_change: "0.1 mm",
        source: "Equipment Rules, part 4: a diameter of at least 42.67 mm",
        hint: "",
    },
];

impl GolfRule {
    /// Physical quantity of the limited number.
    pub fn quantity(&self) -> Quantity {
        match self.of {
            LimitedQuantity::Outcome(of) => of.quantity(),
            LimitedQuantity::Relation(_, quantity) => quantity,
            LimitedQuantity::Parameter(name) => Setup::<f64>::modern_driver()
                .parameter(name)
                .map_or(Quantity::NUMBER, |parameter| parameter.quantity),
        }
    }

    /// Name of the limited quantity: `head_moi`.
    pub fn limited(&self) -> &'static str {
        match self.of {
            LimitedQuantity::Outcome(of) => of.name(),
            LimitedQuantity::Parameter(name) | LimitedQuantity::Relation(name, _) => name,
        }
    }

    /// Limit with tolerance, SI.
    pub fn bound(&self) -> f64 {
        let read = |text: &str| self.quantity().read(text).unwrap_or(f64::NAN);
        let tolerance = self.tolerance.map_or(0.0, read);
        read(self.limit)
            + if self.is_greatest {
                tolerance
            } else {
                -tolerance
            }
    }

    /// Lower and upper limit with tolerance, SI.
    pub(super) fn range(&self) -> [f64; 2] {
        if self.is_greatest {
            [f64::NEG_INFINITY, self.bound()]
        } else {
            [self.bound(), f64::INFINITY]
        }
    }

    /// True if a value conforms to the rule, including the tolerance.
    pub fn allows(&self, value: f64) -> bool {
        // allow for the rounding of a unit conversion
        let rounding = 1e-12 * self.bound().abs();
        if self.is_greatest {
            value <= self.bound() + rounding
        } else {
            value >= self.bound() - rounding
        }
    }

    /// The worst value: the largest for a rule with a maximum, the smallest for a rule with a
    /// minimum. `None` without values.
    pub(super) fn worst(&self, values: impl IntoIterator<Item = f64>) -> Option<f64> {
        let values = values.into_iter();
        values.reduce(if self.is_greatest { f64::max } else { f64::min })
    }

    /// Expression: `head_moi <= 5900 g cm^2 + 100 g cm^2`.
    pub fn expression(&self) -> String {
        let (sign, outward) = if self.is_greatest {
            ("<=", '+')
        } else {
            (">=", '-')
        };
        let tolerance = self
            .tolerance
            .map_or(String::new(), |tolerance| format!(" {outward} {tolerance}"));
        format!("{} {sign} {}{tolerance}", self.limited(), self.limit)
    }

    /// The limited quantity with the unit of the limit.
    pub fn unit(&self) -> DisplayUnit {
        DisplayUnit {
            quantity: self.quantity(),
            unit: self.limit.split_once(' ').map_or("", |(_, unit)| unit),
        }
    }

    /// A value in the unit of the limit.
    pub fn show(&self, value: f64) -> String {
        self.unit().show(value)
    }
}
