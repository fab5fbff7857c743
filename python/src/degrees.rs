//! Angles that were probably given in degrees although radians are expected.

use longdrive::parameters::Parameter;
use longdrive::units::{Quantity, counted_of};

/// Number, smallest and largest of those values of an angle that are outside of its range.
#[derive(Default)]
pub struct Degrees {
    range: Option<(f64, f64)>,
    count: u64,
    /// True if a counted value would be outside of the range in degrees, too.
    is_beyond: bool,
}

impl Degrees {
    /// Counts a value that is outside of its parameter's range. NaN is a missing value and is not
    /// counted.
    pub fn count(&mut self, parameter: &Parameter, value: f64) {
        if parameter.quantity != Quantity::ANGLE || value.is_nan() {
            return;
        }
        let (low, high) = self.range.unwrap_or((value, value));
        self.range = Some((low.min(value), high.max(value)));
        self.count += 1;
        self.is_beyond |= !parameter.range.contains(value.to_radians());
    }

    /// The warning about values in radians outside of a parameter's range, if all of them would be
    /// within the range in degrees. `all` is the number of all values of the parameter.
    pub fn warning(&self, parameter: &Parameter, all: u64) -> Option<String> {
        let (low, high) = self.range.filter(|_| !self.is_beyond)?;
        let name = parameter.name;
        let which = counted_of(self.count, all, ["value", "values"]);
        let values = if low == high {
            format!("{low}")
        } else {
            format!("{low} to {high}")
        };
        let allowed = parameter.range.show(parameter.quantity, "rad");
        Some(format!(
            "points: out of range: {which} of {name} ({values}; it may be {allowed}); numbers are \
             radians, and these look like degrees: if they are, give numpy.radians(…) of them"
        ))
    }
}
