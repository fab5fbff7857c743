//! Values of further parameters that a row has beside its launch.

use crate::parameters::Parameter;
use crate::table::Refusal;

/// The value, where it is in the parameter's range; `name` is that of its column.
///
/// # Errors
/// Why the row cannot be flown.
pub(super) fn within(parameter: &Parameter, value: f64, name: &str) -> Result<f64, Refusal> {
    if parameter.range.contains(value) {
        return Ok(value);
    }
    let shown = parameter.show(Some(value));
    let range = parameter.range.show(parameter.quantity, parameter.unit);
    Err(Refusal::new(Refusal::RANGE, format!("{name}: {shown} is outside of its range {range}")))
}
