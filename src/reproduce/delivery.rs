use crate::parameters::Setup;
use serde::Serialize;

/// Name of the loft, which the studies vary.
pub(super) const LOFT: &str = "club.loft";
/// Name of the attack angle, which the studies vary.
pub(super) const ATTACK_ANGLE: &str = "swing.attack_angle";

/// A delivery with its carry.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Delivery {
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

impl Delivery {
    /// A delivery with its angles in degrees.
    pub(super) fn in_degrees(loft: f64, attack_angle: f64, carry: f64) -> Self {
        Self {
            loft: loft.to_radians(),
            attack_angle: attack_angle.to_radians(),
            carry,
        }
    }

    /// The setup with this delivery.
    pub(super) fn set(&self, setup: &Setup<f64>) -> Setup<f64> {
        delivered(setup, self.loft, self.attack_angle)
    }
}

/// The setup with this loft and attack angle.
pub(super) fn delivered(setup: &Setup<f64>, loft: f64, attack_angle: f64) -> Setup<f64> {
    let mut setup = *setup;
    (setup.club.loft, setup.swing.attack_angle) = (loft, attack_angle);
    setup
}
