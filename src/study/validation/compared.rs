use crate::units::Quantity;

/// A quantity of a published drive that a law is compared by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Compared {
    /// Distance from the tee to where the ball lands.
    Carry,
    /// Height of the highest point above the tee.
    Apex,
    /// Angle of descent below horizontal.
    Descent,
    /// Distance at landing from the line along which the ball started, + right.
    Curve,
    /// Carry beyond that of the first drive of the set.
    Gain,
    /// Launch angle of the optimum.
    LaunchAngle,
    /// Spin of the optimum.
    Spin,
}

impl Compared {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::Carry,
        Self::Apex,
        Self::Descent,
        Self::Curve,
        Self::Gain,
        Self::LaunchAngle,
        Self::Spin,
    ];

    /// Its name, which is that of its column in the data.
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

    /// What it is called in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::LaunchAngle => "launch angle",
            Self::Gain => "gain of carry",
            of => of.name(),
        }
    }

    /// Its quantity, and the unit that people read it in.
    pub fn unit(self) -> (Quantity, &'static str) {
        match self {
            Self::Carry | Self::Apex | Self::Curve | Self::Gain => (Quantity::LENGTH, "yd"),
            Self::Descent | Self::LaunchAngle => (Quantity::ANGLE, "deg"),
            Self::Spin => (Quantity::ANGULAR_VELOCITY, "rpm"),
        }
    }
}
