use super::ladder::rounding_of;
use super::{Ladder, Rung};

/// A remainder is usable if it exceeds this many times the rounding error of the function.
const ABOVE_ROUNDING: f64 = 100.0;

/// Number of steps in a fit. The smallest usable steps are fitted; five steps span two decades.
const FITTED: usize = 5;

/// Orders of the Taylor remainders |f(x+h) − f|, |f(x+h) − f − h f′| and |f(x+h) − f − h f′ − ½ h²
/// f″|: slopes in double-logarithmic scale. With exact derivatives they are 1, 2 and 3, or more if
/// the next derivative is 0. `None` if too few remainders exceed rounding.
pub fn taylor_slopes(ladder: &Ladder, first: f64, second: f64) -> [Option<f64>; 3] {
    [
        slope(ladder, |_| 0.0),
        slope(ladder, |h| h * first),
        slope(ladder, |h| h * (first + 0.5 * h * second)),
    ]
}

/// Order of the remainder f(x + h) − f(x) − `polynomial`(h), fitted over the smallest steps at
/// which the remainder exceeds rounding. Returns the higher of the orders for h > 0 and for h < 0.
fn slope(ladder: &Ladder, polynomial: impl Fn(f64) -> f64) -> Option<f64> {
    let (size, rounding) = (ladder.scale, ladder.rounding());
    let to_a_side = |sign: f64| {
        let above_rounding = |rung: &Rung| {
            let value = if sign > 0.0 { rung.above? } else { rung.below? };
            let remainder = (value - ladder.centre - polynomial(sign * rung.step)).abs();
            // rounding error of the change f(x + h) − f(x): it is relative to the terms of f, which
            // are larger than f if they cancel
            let of_the_change = rounding_of(ladder.rounding_size * rung.step / size);
            (remainder > ABOVE_ROUNDING * rounding.max(rounding_of(value)).max(of_the_change))
                .then(|| ((rung.step / size).log10(), remainder.log10()))
        };
        // consecutive steps, upwards from the smallest one whose remainder exceeds rounding; a
        // later remainder below rounding, near a zero, ends the sequence
        let left = ladder
            .rungs
            .iter()
            .rev()
            .map(above_rounding)
            .skip_while(Option::is_none);
        let mut points: Vec<_> = left.map_while(|point| point).take(FITTED).collect();
        points.reverse();
        (points.len() == FITTED).then(|| line_slope(&points))
    };
    // the higher order: terms of the remainder that cancel on one side add on the other side
    [1.0, -1.0]
        .into_iter()
        .filter_map(to_a_side)
        .max_by(f64::total_cmp)
}

/// Slope of the least-squares line through `points`.
pub(crate) fn line_slope(points: &[(f64, f64)]) -> f64 {
    let mean = |f: fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / points.len() as f64;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let covariance: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let variance: f64 = points.iter().map(|p| (p.0 - x) * (p.0 - x)).sum();
    covariance / variance
}
