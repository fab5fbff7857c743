use crate::units::Quantity;

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
    /// Launch angle at the optimum.
    LaunchAngle,
    /// Spin at the optimum.
    Spin,
}

impl Compared {
    /// All quantities.
    pub const ALL: [Self; 7] = [
        Self::Carry,
        Self::Apex,
        Self::Descent,
        Self::Curve,
        Self::Gain,
        Self::LaunchAngle,
        Self::Spin,
    ];

    /// Name of the quantity, which is also the head of its data column.
    pub fn name(self) -> &'static str {
        match self {
            Self::Carry => "carry",
            Self::Apex => "apex",
            Self::Descent => "descent",
            Self::Curve => "curve",
            Self::Gain => "gain",
            Self::LaunchAngle => "launch_angle",
            Self::Spin => "spin",
        }
    }

    /// Name of the quantity in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::LaunchAngle => "launch angle",
            Self::Gain => "gain of carry",
            of => of.name(),
        }
    }

    /// Physical quantity and display unit.
    pub fn unit(self) -> (Quantity, &'static str) {
        match self {
            Self::Carry | Self::Apex | Self::Curve | Self::Gain => (Quantity::LENGTH, "yd"),
            Self::Descent | Self::LaunchAngle => (Quantity::ANGLE, "deg"),
            Self::Spin => (Quantity::ANGULAR_VELOCITY, "rpm"),
        }
    }
}

schema_of_names!(Compared, "Compared");
