use crate::error::{Error, Result};

/// Runge–Kutta method with a fixed step. The interpolation of the landing is the same for all.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Method {
    /// The classical Runge–Kutta method, order 4 (Kutta 1901).
    #[default]
    Rk4,
    /// Dormand & Prince's method of order 8 with 12 evaluations a step (Hairer, Nørsett & Wanner
    /// 1993, DOP853).
    DormandPrince8,
}

impl Method {
    /// All methods, from the lowest order.
    pub const ALL: &'static [Self] = &[Self::Rk4, Self::DormandPrince8];

    /// Name in `flight.method`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rk4 => "rk4",
            Self::DormandPrince8 => "dp8",
        }
    }

    /// Order p: the error is proportional to the p-th power of the step.
    pub fn order(self) -> u32 {
        match self {
            Self::Rk4 => 4,
            Self::DormandPrince8 => 8,
        }
    }

    /// Evaluations of the force a step.
    pub fn stages(self) -> u32 {
        match self {
            Self::Rk4 => 4,
            Self::DormandPrince8 => 12,
        }
    }
}

/// Name of the setting: `flight.method = "dp8"`.
pub const METHOD: &str = "flight.method";

impl Method {
    /// The method of this name.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the nearest name.
    pub fn named(name: &str) -> Result<Self> {
        let name = name.trim();
        Self::ALL
            .iter()
            .copied()
            .find(|method| method.name() == name)
            .ok_or_else(|| {
                let names = Self::ALL.iter().map(|method| method.name());
                let advice = format!(
                    "the methods are {}",
                    names.clone().collect::<Vec<_>>().join(", ")
                );
                Error::unknown("method of integration", name, names, advice)
            })
    }
}
