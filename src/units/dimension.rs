/// Powers of length, mass, time, angle and temperature. The angle is a dimension, so that 10 rpm are
/// not 10 per minute.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Dimension(pub [i8; 5]);

impl Dimension {
    pub const NONE: Self = Self([0, 0, 0, 0, 0]);
    pub const LENGTH: Self = Self([1, 0, 0, 0, 0]);
    pub const MASS: Self = Self([0, 1, 0, 0, 0]);
    pub const TIME: Self = Self([0, 0, 1, 0, 0]);
    pub const ANGLE: Self = Self([0, 0, 0, 1, 0]);
    pub const TEMPERATURE: Self = Self([0, 0, 0, 0, 1]);

    pub fn times(self, other: Self, power: i8) -> Self {
        let Self(mut exponents) = self;
        for (mine, theirs) in exponents.iter_mut().zip(other.0) {
            *mine = mine.saturating_add(theirs.saturating_mul(power));
        }
        Self(exponents)
    }
}
