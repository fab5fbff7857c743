//! Settings that select by name: the golfer, the point of the head, the method of integration.

/// Handedness of the golfer. Two golfers of different hands with the same values of swing, strike
/// and club hit drives that are mirror images.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Golfer {
    /// A right-handed golfer: out, open and the toe are to the right.
    #[default]
    Right,
    /// A left-handed golfer: out, open and the toe are to the left.
    Left,
}

/// Name of the setting, as in `golfer = "left"`.
pub const GOLFER: &str = "golfer";

variant_names! {
    /// The value of `golfer` that selects the hand.
    Golfer {
        Right = "right",
        Left = "left",
    }
}

/// Point of the head to which `swing.speed`, `swing.attack_angle` and `swing.path` refer. The
/// points of a rotating head have different velocities (docs/model.md, eq. 1a).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum SpeedOf {
    /// The centre of mass. Radars measure the centre of the head's outline, which is within
    /// millimetres of the centre of mass.
    #[default]
    CentreOfMass,
    /// The centre of the face, where the markers of camera systems are.
    FaceCentre,
}

/// Name of the setting, as in `swing.speed_of = "face-centre"`.
pub const SPEED_OF: &str = "swing.speed_of";

variant_names! {
    /// The value of `swing.speed_of` that selects the point.
    SpeedOf {
        CentreOfMass = "centre-of-mass",
        FaceCentre = "face-centre",
    }
}

/// Runge–Kutta method with a fixed step. The interpolation of the landing is the same for all
/// methods.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Method {
    /// The classical Runge–Kutta method, order 4 (Kutta 1901).
    #[default]
    Rk4,
    /// Dormand & Prince's method of order 8 with 12 evaluations per step (Hairer, Nørsett & Wanner
    /// 1993, DOP853).
    DormandPrince8,
}

variant_names! {
    /// The value of `flight.method` that selects the method.
    Method {
        Rk4 = "rk4",
        DormandPrince8 = "dp8",
    }
}

impl Method {
    /// Order p: the error is proportional to the p-th power of the step.
    pub fn order(self) -> u32 {
        match self {
            Self::Rk4 => 4,
            Self::DormandPrince8 => 8,
        }
    }
}

/// Name of the setting, as in `flight.method = "dp8"`.
pub const METHOD: &str = "flight.method";
