use crate::error::{Error, Result};

/// Handedness of the golfer. Swing, strike and club are in the golfer's own terms: the same numbers
/// give mirror images for the two hands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Golfer {
    /// A right-handed golfer: out, open and the toe are to the right.
    #[default]
    Right,
    /// A left-handed golfer: out, open and the toe are to the left.
    Left,
}

/// Name of the setting: `golfer = "left"`.
pub const GOLFER: &str = "golfer";

impl Golfer {
    /// Both hands.
    pub const ALL: &'static [Self] = &[Self::Right, Self::Left];

    /// Its name in `golfer`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Right => "right",
            Self::Left => "left",
        }
    }

    /// The golfer of this name.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the nearest name.
    pub fn named(name: &str) -> Result<Self> {
        let name = name.trim();
        Self::ALL
            .iter()
            .copied()
            .find(|golfer| golfer.name() == name)
            .ok_or_else(|| {
                let names = Self::ALL.iter().map(|golfer| golfer.name());
                Error::unknown(
                    GOLFER,
                    name,
                    names,
                    "a golfer is right or left, by the hand",
                )
            })
    }
}
