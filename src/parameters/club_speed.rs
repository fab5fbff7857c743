use crate::error::{Error, Result};

/// Point of the head whose velocity `swing.speed`, `swing.attack_angle` and `swing.path` give. The
/// points of a rotating head have different velocities (docs/model.md, eq. 1a).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum SpeedOf {
    /// The centre of mass. Radars measure the centre of the head's outline, within millimetres of
    /// it.
    #[default]
    CentreOfMass,
    /// The centre of the face, where the markers of camera systems are.
    FaceCentre,
}

/// Name of the setting: `swing.speed_of = "face-centre"`.
pub const SPEED_OF: &str = "swing.speed_of";

impl SpeedOf {
    /// All points.
    pub const ALL: &'static [Self] = &[Self::CentreOfMass, Self::FaceCentre];

    /// Its name in `swing.speed_of`.
    pub fn name(self) -> &'static str {
        match self {
            Self::CentreOfMass => "centre-of-mass",
            Self::FaceCentre => "face-centre",
        }
    }

    /// The point of this name.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the nearest name.
    pub fn named(name: &str) -> Result<Self> {
        let name = name.trim();
        Self::ALL
            .iter()
            .copied()
            .find(|point| point.name() == name)
            .ok_or_else(|| {
                let names = Self::ALL.iter().map(|point| point.name());
                let advice =
                    "the speed of the club is that of its centre-of-mass or of its face-centre";
                Error::unknown(SPEED_OF, name, names, advice)
            })
    }
}
