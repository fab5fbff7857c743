use crate::drive::Outcome;
use crate::parameters::Parameter;
use crate::report::shown::words;
use crate::units::{Quantity, System, printed};

/// A quantity along an axis or of a colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    /// The name: "carry".
    pub label: String,
    /// Its kind of quantity; values are SI.
    pub quantity: Quantity,
    /// The unit that golfers read it in, whichever of the two systems it belongs to.
    pub unit: &'static str,
}

impl Measure {
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

    /// The size of the unit of a system, in SI units. SI values are divided by it, since reading a
    /// unit takes much longer.
    pub fn unit_size(&self, system: System) -> f64 {
        self.quantity.size_of(system.unit(self.unit)).unwrap_or(1.0)
    }

    /// An SI value in the unit of a system with the digits of a launch monitor: "251.1 yd".
    pub fn show(&self, value: f64, system: System) -> String {
        self.quantity.read_off(value, system.unit(self.unit))
    }

    /// A value in the units of both systems: "251.1 yd (229.6 m)".
    pub fn show_both(&self, value: f64, system: System) -> String {
        let [chosen, other] = [system, system.other()].map(|system| self.show(value, system));
        if chosen == other {
            chosen
        } else {
            format!("{chosen} ({other})")
        }
    }

    /// A difference or an uncertainty, which has one decimal more: "4.12 yd".
    pub fn show_difference(&self, value: f64, system: System) -> String {
        self.quantity
            .read_off_difference(value, system.unit(self.unit))
    }

    /// The name with the unit of a system: `carry [yd]`, `club loft [°]`.
    pub fn titled(&self, system: System) -> String {
        with_unit(&self.label, &printed(system.unit(self.unit)))
    }

    /// The name with the SI unit: `carry [m]`.
    pub fn titled_si(&self) -> String {
        with_unit(&self.label, self.quantity.si)
    }
}

fn with_unit(label: &str, unit: &str) -> String {
    if unit.is_empty() {
        label.into()
    } else {
        format!("{label} [{unit}]")
    }
}

/// How values lie along an axis.
#[derive(Clone, Debug, PartialEq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// Evenly, distances to the right of a line (+) and to the left of it (−), as seen from above
    /// by one who looks along the horizontal axis: right is below. They are labelled without signs,
    /// `20 R` and `20 L`.
    LeftRight,
    /// By their logarithm; what is not above zero has no place.
    Log,
    /// Whole numbers from 0, a name for each, the first on top: the bars of a tornado.
    Names(Vec<String>),
}

/// An axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// The quantity.
    pub measure: Measure,
    /// How.
    pub scale: Scale,
    /// Least range, SI; the data may extend it.
    pub reach: Option<[f64; 2]>,
    /// The axis ends exactly at `reach`, and data beyond are not drawn.
    pub is_exact: bool,
}

impl Axis {
    /// An axis as wide as its data.
    pub fn linear(measure: Measure) -> Self {
        Self {
            measure,
            scale: Scale::Linear,
            reach: None,
            is_exact: false,
        }
    }

    /// A logarithmic axis as wide as its data.
    pub fn log(measure: Measure) -> Self {
        Self {
            scale: Scale::Log,
            ..Self::linear(measure)
        }
    }

    /// Distances to the right of a line, with right below left, as wide as the data.
    pub fn left_right(measure: Measure) -> Self {
        Self {
            scale: Scale::LeftRight,
            ..Self::linear(measure)
        }
    }

    /// Names, one below the other.
    pub fn names(names: impl IntoIterator<Item = String>) -> Self {
        Self {
            scale: Scale::Names(names.into_iter().collect()),
            ..Self::linear(Measure::plain(""))
        }
    }

    /// Extends the axis to at least `low` and `high`, SI.
    #[must_use]
    pub fn reaching(self, low: f64, high: f64) -> Self {
        Self {
            reach: Some([low, high]),
            ..self
        }
    }

    /// Limits the axis to `low` and `high` exactly, SI.
    #[must_use]
    pub fn exactly(self, low: f64, high: f64) -> Self {
        Self {
            is_exact: true,
            ..self.reaching(low, high)
        }
    }
}
