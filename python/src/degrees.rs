//! Degrees that were given for radians.

use longdrive::parameters::Parameter;
use longdrive::units::Quantity;

/// The values of an angle that lie outside of its range.
#[derive(Default)]
pub struct Degrees {
    range: Option<(f64, f64)>,
    /// Whether one of them lies outside of it in degrees too.
    is_beyond: bool,
}

impl Degrees {
    /// Looks at a value outside of the range of its parameter; NaN stands for none.
    pub fn look(&mut self, parameter: &Parameter, value: f64) {
        if parameter.quantity != Quantity::ANGLE || value.is_nan() {
            return;
        }
        let (low, high) = self.range.unwrap_or((value, value));
        self.range = Some((low.min(value), high.max(value)));
        self.is_beyond |= !parameter.range.contains(value.to_radians());
    }

    /// What deserves a word where all values of a parameter lie outside of its range, and in degrees within it.
    pub fn told(&self, parameter: &Parameter) -> Option<String> {
        let (low, high) = self.range.filter(|_| !self.is_beyond)?;
        let name = parameter.name;
        let values = if low == high { format!("{low}") } else { format!("{low} to {high}") };
        let allowed = parameter.range.show(parameter.quantity, "rad");
        Some(format!(
            "points: every value of {name} is out of range: {values}, and it may be {allowed}; numbers are radians, and these look like degrees: give \
             numpy.radians(…) of them"
        ))
    }
}
