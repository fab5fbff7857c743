use crate::drive::Outcome;
use crate::parameters::Parameter;
use crate::report::csv_text;
use crate::report::shown::words;
use crate::units::{DisplayUnit, Quantity, TableUnits};

/// A quantity with its name, for an axis or a colour scale.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedQuantity {
    /// The name: "carry".
    pub label: String,
    /// The physical quantity, whose values are in SI, with its display unit.
    pub of: DisplayUnit,
}

impl NamedQuantity {
    /// A quantity with this name. `unit` is the customary unit in golf; a plot in another system of
    /// units converts it.
    pub fn new(label: impl Into<String>, quantity: Quantity, unit: &'static str) -> Self {
        Self {
            label: label.into(),
            of: DisplayUnit { quantity, unit },
        }
    }

    /// A number without unit.
    pub fn plain(label: impl Into<String>) -> Self {
        Self::new(label, Quantity::NUMBER, "")
    }

    /// An outcome.
    pub fn outcome(outcome: Outcome) -> Self {
        Self {
            label: words(outcome.name()),
            of: outcome.into(),
        }
    }

    /// A parameter: "club speed".
    pub fn parameter(parameter: &Parameter) -> Self {
        Self {
            label: words(parameter.name),
            of: parameter.into(),
        }
    }

    /// The name with the unit of a table: `carry [m]`.
    pub fn head(&self, units: TableUnits) -> String {
        units.head(&self.label, self.of)
    }

    /// An SI value as a number in the units of a table, with all digits; empty without a finite
    /// value.
    pub(in crate::report) fn cell(&self, value: Option<f64>, units: TableUnits) -> String {
        value.map_or(String::new(), |value| {
            csv_text::number(units.number(value, self.of))
        })
    }
}

/// The scale of an axis.
#[derive(Clone, Debug, PartialEq)]
pub enum AxisScale {
    /// Linear.
    Linear,
    /// Linear, for distances from the target line: + is right. Labels have R or L in place of a
    /// sign: `20 R` and `20 L`.
    LeftRight,
    /// Logarithmic. Values that are not positive have no position.
    Log,
    /// Names from top to bottom, as in a tornado plot. Name `i`, counted from 0, is at the value i.
    Names(Vec<String>),
}

/// An axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// The quantity.
    pub quantity: NamedQuantity,
    /// The scale.
    pub scale: AxisScale,
    /// The range, SI; data outside are not drawn. `None` for the range of the data.
    pub range: Option<[f64; 2]>,
    /// True if the values increase downwards or to the left.
    pub is_reversed: bool,
}

impl Axis {
    /// A linear axis with the range of the data.
    pub fn linear(quantity: NamedQuantity) -> Self {
        Self {
            quantity,
            scale: AxisScale::Linear,
            range: None,
            is_reversed: false,
        }
    }

    /// Distances from the target line, with R or L in place of a sign.
    pub fn left_right() -> Self {
        let quantity = NamedQuantity::new("right of the target line", Quantity::LENGTH, "yd");
        Self {
            scale: AxisScale::LeftRight,
            ..Self::linear(quantity)
        }
    }

    /// A logarithmic axis with the range of the data.
    pub fn log(quantity: NamedQuantity) -> Self {
        Self {
            scale: AxisScale::Log,
            ..Self::linear(quantity)
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
            range: Some([low, high]),
            ..self
        }
    }
}
