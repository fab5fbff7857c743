use crate::error::{Error, Result};

/// The point of the head whose motion `swing.speed`, `swing.attack_angle` and `swing.path` state. A
/// head that turns moves differently at each of its points (docs/model.md, eq. 1a).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum SpeedOf {
    /// The centre of mass. Radars state the centre of the head's outline, which lies within
    /// millimetres of it.
    #[default]
    CentreOfMass,
    /// The centre of the face, to whose markers camera systems hold.
    FaceCentre,
}

/// The name by which the point is chosen: `swing.speed_of = "face-centre"`.
pub const SPEED_OF: &str = "swing.speed_of";

impl SpeedOf {
    /// Both.
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
