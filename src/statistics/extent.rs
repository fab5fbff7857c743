use std::borrow::Borrow;

/// Smallest and largest of some numbers; \[∞, −∞\] without numbers.
pub(crate) fn extent(values: impl IntoIterator<Item = f64>) -> [f64; 2] {
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    values.into_iter().fold(none, |[least, greatest], value| {
        [least.min(value), greatest.max(value)]
    })
}

/// Largest absolute value of some numbers; 0 without numbers.
pub(crate) fn largest_magnitude(values: impl IntoIterator<Item = impl Borrow<f64>>) -> f64 {
    values
        .into_iter()
        .map(|value| value.borrow().abs())
        .fold(0.0, f64::max)
}
