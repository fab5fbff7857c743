use super::surface::Surface;
use crate::units::Quantity;

/// What a table of drag and lift goes along.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// s = R|ω|/|v|.
    SpinRatio,
    /// |ω|, rad/s.
    Spin,
    /// Re.
    Reynolds,
    /// |v|, m/s.
    Speed,
}

impl Along {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::SpinRatio, Self::Spin, Self::Reynolds, Self::Speed];

    /// Its names as heads of columns, lower case.
    pub fn names(self) -> &'static [&'static str] {
        match self {
            Self::SpinRatio => &["spin_ratio", "s"],
            Self::Spin => &["spin"],
            Self::Reynolds => &["reynolds", "re"],
            Self::Speed => &["speed"],
        }
    }

    /// What it is measured in, and the unit people read it in.
    pub fn quantity(self) -> (Quantity, &'static str) {
        match self {
            Self::SpinRatio | Self::Reynolds => (Quantity::NUMBER, ""),
            Self::Spin => (Quantity::ANGULAR_VELOCITY, "rpm"),
            Self::Speed => (Quantity::SPEED, "m/s"),
        }
    }

    /// Whether it is the axis of the spin, and not that of the speed.
    pub fn is_of_spin(self) -> bool {
        matches!(self, Self::SpinRatio | Self::Spin)
    }

    /// A head for its column: `speed [m/s]`.
    pub fn head(self) -> String {
        let (_, unit) = self.quantity();
        let name = self.names()[0];
        if unit.is_empty() {
            name.into()
        } else {
            format!("{name} [{unit}]")
        }
    }
}

/// An axis of a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// What it measures.
    pub along: Along,
    /// Its first and last value, SI.
    pub ends: [f64; 2],
    /// Beyond its ends the place is held, with two continuous derivatives, over these: below the
    /// first and above the last.
    pub over: [f64; 2],
}

/// A grid of C_D and C_L with its splines: speed, or the Reynolds number, across, spin, or the spin
/// ratio, up.
#[derive(Debug)]
pub(crate) struct Grid {
    pub speed: Option<Axis>,
    pub spin: Option<Axis>,
    /// Where the lift is whole, 1/SI: below it begins without spin. `None` where the grid itself
    /// begins there.
    pub begins: Option<(Along, f64)>,
    pub surface: Surface,
}

impl Grid {
    /// The axes that it has.
    pub fn axes(&self) -> impl Iterator<Item = &Axis> {
        self.speed.iter().chain(&self.spin)
    }
}
