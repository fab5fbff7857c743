use crate::drive::{Drive, Outcome};
use crate::error::{Error, Result};
use crate::parameters::{Setup, Vary};
use crate::study::{Optimum, Search};
use serde::Serialize;

/// Name of the loft, which the studies vary.
pub(super) const LOFT: &str = "club.loft";
/// Name of the attack angle, which the studies vary.
pub(super) const ATTACK_ANGLE: &str = "swing.attack_angle";

/// A delivery with its carry.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "Delivery"))]
pub struct DeliveryCarry {
    /// The loft, rad.
    #[serde(rename = "club.loft")]
    pub loft: f64,
    /// The attack angle (the report's swing elevation), rad.
    #[serde(rename = "swing.attack_angle")]
    pub attack_angle: f64,
    /// The carry, m.
    pub carry: f64,
}

/// A loft with its carry.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct LoftCarry {
    /// The loft, rad.
    #[serde(rename = "club.loft")]
    pub loft: f64,
    /// The carry, m.
    pub carry: f64,
}

impl DeliveryCarry {
    /// A delivery from a loft, deg, an attack angle, deg, and a carry, m.
    pub(super) fn in_degrees(loft: f64, attack_angle: f64, carry: f64) -> Self {
        Self {
            loft: loft.to_radians(),
            attack_angle: attack_angle.to_radians(),
            carry,
        }
    }

    /// Computes the carry of the delivery with this loft and attack angle, rad.
    pub(super) fn flown(setup: &Setup<f64>, loft: f64, attack_angle: f64) -> Result<Self> {
        Ok(Self {
            loft,
            attack_angle,
            carry: carry(&with_delivery(setup, loft, attack_angle))?,
        })
    }

    /// The delivery of the longest carry that a search found.
    pub(super) fn of(longest: &Optimum) -> Self {
        Self {
            loft: longest.setup.club.loft,
            attack_angle: longest.setup.swing.attack_angle,
            carry: longest.value().unwrap_or_default(),
        }
    }
}

/// The setup with this loft and attack angle.
pub(super) fn with_delivery(setup: &Setup<f64>, loft: f64, attack_angle: f64) -> Setup<f64> {
    let mut setup = *setup;
    (setup.club.loft, setup.swing.attack_angle) = (loft, attack_angle);
    setup
}

/// Carry of a drive, m.
pub(super) fn carry(setup: &Setup<f64>) -> Result<f64> {
    Ok(Drive::new(setup)?.landed()?.carry)
}

/// Carry of a drive, m; `None` if the ball does not fly.
pub(super) fn carry_if_flown(setup: &Setup<f64>) -> Result<Option<f64>> {
    match carry(setup) {
        Err(Error::NoFlight { .. }) => Ok(None),
        carry => carry.map(Some),
    }
}

/// Search ranges of the delivery, deg.
#[derive(Clone, Copy)]
pub(super) struct Ranges {
    pub loft: [f64; 2],
    pub attack_angle: [f64; 2],
}

impl Ranges {
    /// The search for the longest carry over the parameters `names`, within these ranges.
    pub(super) fn longest_carry(self, setup: &Setup<f64>, names: &[&str]) -> Result<Search> {
        let range = |name: &&str| {
            let ends = if *name == LOFT {
                self.loft
            } else {
                self.attack_angle
            };
            let [low, high] = ends.map(f64::to_radians);
            Vary::new(setup.variable(name)?, low, high)
        };
        Ok(Search {
            vary: names.iter().map(range).collect::<Result<_>>()?,
            ..Search::largest(Outcome::Carry)
        })
    }
}
