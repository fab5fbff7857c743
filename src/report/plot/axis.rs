use crate::drive::Outcome;
use crate::parameters::Parameter;
use crate::report::shown::words;
use crate::units::{Quantity, System, TableUnits, printed};

/// A quantity along an axis, or of a colour scale.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedQuantity {
    /// The name: "carry".
    pub label: String,
    /// The physical quantity; values are in SI.
    pub quantity: Quantity,
    /// A unit that is customary in golf, of either system. It determines the unit in the other.
    pub unit: &'static str,
}

impl NamedQuantity {
    /// A measure of this name.
    pub fn new(label: impl Into<String>, quantity: Quantity, unit: &'static str) -> Self {
        Self {
            label: label.into(),
            quantity,
            unit,
        }
    }

    /// A number without unit.
    pub fn plain(label: impl Into<String>) -> Self {
        Self::new(label, Quantity::NUMBER, "")
    }

    /// An outcome.
    pub fn outcome(outcome: Outcome) -> Self {
        Self::new(words(outcome.name()), outcome.quantity(), outcome.unit())
    }

    /// A parameter: "club speed".
    pub fn parameter(parameter: &Parameter) -> Self {
        Self::new(words(parameter.name), parameter.quantity, parameter.unit)
    }

    /// The size of the unit of a system, in SI units. To divide by this size is much faster than to
    /// parse the unit for each value.
    pub fn unit_size(&self, system: System) -> f64 {
        self.quantity.size_of(system.unit(self.unit)).unwrap_or(1.0)
    }

    /// An SI value in the unit of a system with the digits of a launch monitor: "251.1 yd".
    pub fn show(&self, value: f64, system: System) -> String {
        self.quantity.read_off(value, system.unit(self.unit))
    }

    /// The name with the unit of a system: `carry [yd]`, `club loft [°]`.
    pub fn titled(&self, system: System) -> String {
        match printed(system.unit(self.unit)).as_str() {
            "" => self.label.clone(),
            unit => format!("{} [{unit}]", self.label),
        }
    }

    /// The name with the unit of a table: `carry [m]`.
    pub fn head(&self, units: TableUnits) -> String {
        units.head(&self.label, self.quantity, self.unit)
    }

    /// An SI value as a number in the units of a table, with all digits; empty without a finite
    /// value.
    pub(in crate::report) fn cell(&self, value: Option<f64>, units: TableUnits) -> String {
        let number = value.map(|value| units.number(value, self.quantity, self.unit));
        number
            .filter(|number| number.is_finite())
            .map_or(String::new(), |number| format!("{number:?}"))
    }
}

/// The scale of an axis.
#[derive(Clone, Debug, PartialEq)]
pub enum AxisScale {
    /// Linear.
    Linear,
    /// Linear: distances to the right (+) and left (−) of a line, seen from above along the
    /// horizontal axis, so that right is at the bottom. Labels have R or L in place of a
    /// sign: `20 R` and `20 L`.
    LeftRight,
    /// Logarithmic. Values that are not positive have no position.
    Log,
    /// Names at whole numbers from 0, the first name on top, as in a tornado plot.
    Names(Vec<String>),
}

/// An axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// The quantity.
    pub measure: NamedQuantity,
    /// The scale.
    pub scale: AxisScale,
    /// The range, SI; data outside are not drawn. `None` for the range of the data.
    pub reach: Option<[f64; 2]>,
}

impl Axis {
    /// A linear axis with the range of the data.
    pub fn linear(measure: NamedQuantity) -> Self {
        Self {
            measure,
            scale: AxisScale::Linear,
            reach: None,
        }
    }

    /// A logarithmic axis with the range of the data.
    pub fn log(measure: NamedQuantity) -> Self {
        Self {
            scale: AxisScale::Log,
            ..Self::linear(measure)
        }
    }

    /// Distances to the right of a line, with right at the bottom, and with the range of the data.
    pub fn left_right(measure: NamedQuantity) -> Self {
        Self {
            scale: AxisScale::LeftRight,
            ..Self::linear(measure)
        }
    }

    /// Names, one below the other.
    pub fn names(names: impl IntoIterator<Item = String>) -> Self {
        Self {
            scale: AxisScale::Names(names.into_iter().collect()),
            ..Self::linear(NamedQuantity::plain(""))
        }
    }

    /// Sets the range, SI.
    #[must_use]
    pub fn exactly(self, low: f64, high: f64) -> Self {
        Self {
            reach: Some([low, high]),
            ..self
        }
    }
}
