use crate::units::{DisplayUnit, Quantity};

/// A quantity in which laws are compared with published drives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Compared {
    /// Distance from tee to landing point.
    Carry,
    /// Maximum height above the tee.
    Apex,
    /// Angle of descent below horizontal.
    Descent,
    /// Lateral distance of the landing point from the initial direction, + right.
    Curve,
    /// Carry minus the carry of the first drive of the set.
    Gain,
    /// Launch angle of the drive at the loft of longest carry.
    LaunchAngle,
    /// Spin of the drive at the loft of longest carry.
    Spin,
}

variant_names! {
    /// Name of the quantity. The data column has this name and a unit as its head.
    Compared as "Compared" {
        Carry = "carry",
        Apex = "apex",
        Descent = "descent",
        Curve = "curve",
        Gain = "gain",
        LaunchAngle = "launch_angle",
        Spin = "spin",
    }
}

impl Compared {
    /// Name of the quantity in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::LaunchAngle => "launch angle",
            Self::Gain => "gain of carry",
            of => of.name(),
        }
    }

    /// Physical quantity with its display unit.
    pub fn unit(self) -> DisplayUnit {
        let (quantity, unit) = match self {
            Self::Carry | Self::Apex | Self::Curve | Self::Gain => (Quantity::LENGTH, "yd"),
            Self::Descent | Self::LaunchAngle => (Quantity::ANGLE, "deg"),
            Self::Spin => (Quantity::ANGULAR_VELOCITY, "rpm"),
        };
        DisplayUnit { quantity, unit }
    }
}
