use crate::parameters::Setup;

/// Parameters that the report varies.
pub(super) const LOFT: &str = "club.loft";
pub(super) const ATTACK_ANGLE: &str = "swing.attack_angle";

/// Delivery with its carry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Delivery {
    /// Loft, rad.
    pub loft: f64,
    /// Attack angle, rad (the report's swing elevation).
    pub attack_angle: f64,
    /// Carry, m.
    pub carry: f64,
}

impl Delivery {
    pub(super) fn in_degrees(loft: f64, attack_angle: f64, carry: f64) -> Self {
        Self {
            loft: loft.to_radians(),
            attack_angle: attack_angle.to_radians(),
            carry,
        }
    }

    /// The setup with this delivery.
    pub(super) fn set(&self, setup: &Setup<f64>) -> Setup<f64> {
        let mut setup = *setup;
        (setup.club.loft, setup.swing.attack_angle) = (self.loft, self.attack_angle);
        setup
    }
}
