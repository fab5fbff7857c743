use crate::parameters::{Parameter, Setup};

/// The size of a parameter, of which the steps of differences are parts: its value, or for one that may be 0 or of either sign what is
/// usual of it, whichever is larger.
pub(super) fn scale(setup: &Setup<f64>, parameter: &Parameter) -> f64 {
    let value = setup.value(parameter).unwrap_or_default().abs();
    let default = parameter.default_value().filter(|default| default.is_finite()).unwrap_or_default().abs();
    let usual = if default > 0.0 { default } else { usual(parameter) };
    let has_a_sign = parameter.range.low < 0.0;
    if value == 0.0 || has_a_sign { value.max(usual) } else { value }
}

/// What is usual of parameters that are 0 by default, SI.
fn usual(parameter: &Parameter) -> f64 {
    let units = match parameter.unit {
        "deg" => 5.0,
        "mm" | "rad/s" => 10.0,
        "g cm^2" => 1000.0,
        "" => 0.1,
        _ => 1.0,
    };
    units * parameter.quantity.size_of(parameter.unit).unwrap_or(1.0)
}
