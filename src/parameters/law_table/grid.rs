use super::surface::Surface;
use crate::units::{Digits, DisplayUnit, Message, Quantity};

/// A variable of a law of drag and lift, or of an axis of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LawVariable {
    /// Spin ratio s = R|ω|/|v|.
    SpinRatio,
    /// Spin |ω|, rad/s.
    Spin,
    /// Reynolds number.
    Reynolds,
    /// Airspeed |v|, m/s.
    Speed,
}

impl LawVariable {
    /// All variables.
    pub const ALL: [Self; 4] = [Self::SpinRatio, Self::Spin, Self::Reynolds, Self::Speed];

    /// The name in messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::SpinRatio => "spin ratio",
            Self::Spin => "spin",
            Self::Reynolds => "Reynolds number",
            Self::Speed => "speed through the air",
        }
    }

    /// Names in column heads, lower case.
    pub fn column_names(self) -> &'static [&'static str] {
        match self {
            Self::SpinRatio => &["spin_ratio", "s"],
            Self::Spin => &["spin"],
            Self::Reynolds => &["reynolds", "re"],
            Self::Speed => &["speed"],
        }
    }

    /// Quantity and display unit.
    pub fn display_unit(self) -> DisplayUnit {
        let (quantity, unit) = match self {
            Self::SpinRatio | Self::Reynolds => (Quantity::NUMBER, ""),
            Self::Spin => (Quantity::ANGULAR_VELOCITY, "rpm"),
            Self::Speed => (Quantity::SPEED, "m/s"),
        };
        DisplayUnit { quantity, unit }
    }

    /// Appends a range of this variable, SI, to a message: "70000 to 230000", or "at least 71000"
    /// without an upper end.
    pub fn append_range(self, before: Message, [low, high]: [f64; 2]) -> Message {
        let DisplayUnit { quantity, unit } = self.display_unit();
        let digits = Digits::Significant(3);
        if high.is_infinite() {
            return before
                .words("at least ")
                .quantity(quantity, unit, low, digits);
        }
        before
            .quantity(quantity, unit, low, digits)
            .words(" to ")
            .quantity(quantity, unit, high, digits)
    }

    /// True for a variable of the spin axis, false for a variable of the speed axis.
    pub fn is_of_spin(self) -> bool {
        matches!(self, Self::SpinRatio | Self::Spin)
    }
}

/// An axis of a table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LawTableAxis {
    /// Variable.
    pub variable: LawVariable,
    /// First and last value, SI.
    pub ends: [f64; 2],
    /// Widths of the smooth (C²) clamps below the first and above the last value, SI.
    pub over: [f64; 2],
}

/// A grid of C_D and C_L with its splines. Its columns are speeds or Reynolds numbers, its rows
/// spins or spin ratios.
#[derive(Debug)]
pub(crate) struct CoefficientGrid {
    pub speed: Option<LawTableAxis>,
    pub spin: Option<LawTableAxis>,
    /// Variable (spin ratio or spin) with a limit below which the lift falls smoothly to 0, and the
    /// reciprocal of this limit, SI. `None` if the grid begins at zero spin.
    pub lift_onset: Option<(LawVariable, f64)>,
    pub surface: Surface,
}

impl CoefficientGrid {
    /// True if C_D depends on the spin at zero spin. It does not if the table has no spins, or one,
    /// or if the clamp below the least spin ends above zero spin.
    pub fn has_slope_at_zero_spin(&self) -> bool {
        self.spin.is_some_and(|axis| {
            let [least, most] = axis.ends;
            least < most && least < axis.over[0]
        })
    }
}
