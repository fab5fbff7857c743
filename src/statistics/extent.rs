/// Smallest and largest of some numbers; \[∞, −∞\] without numbers.
pub(crate) fn extent(values: impl IntoIterator<Item = f64>) -> [f64; 2] {
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    values.into_iter().fold(none, |[least, greatest], value| {
        [least.min(value), greatest.max(value)]
    })
}
