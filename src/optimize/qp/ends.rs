use super::program::{End, Step};
use nalgebra::DVector;

/// Rounding of a variable, of the largest of the step.
const BEYOND: f64 = 1e-14;

/// Where a variable ends instead, with what its place and its pull contradict put right. Beyond an end by rounding it is at it,
/// and needs nothing to hold it there. `size` is that of the largest variable.
pub(in crate::optimize) fn corrected_end(
    (low, high): (f64, f64),
    end: End,
    d: f64,
    pull: f64,
    size: impl Fn() -> f64,
) -> End {
    let beyond = |excess: f64| excess > 0.0 && excess > BEYOND * size();
    match end {
        _ if low == high => End::Low,
        End::Free if beyond(low - d) => End::Low,
        End::Free if beyond(d - high) => End::High,
        End::Low if pull < 0.0 => End::Free,
        End::High if pull > 0.0 => End::Free,
        same => same,
    }
}

/// Moves a step inside the ends; what is within rounding of an end is at it.
pub(in crate::optimize) fn clamp(low: &DVector<f64>, high: &DVector<f64>, step: &mut Step) {
    let rounding = BEYOND * step.d.amax();
    for i in 0..step.d.len() {
        let (low, high) = (low[i], high[i]);
        (step.ends[i], step.d[i]) = match step.d[i] {
            d if d - low <= rounding => (End::Low, low),
            d if high - d <= rounding => (End::High, high),
            d => (End::Free, d),
        };
    }
}
