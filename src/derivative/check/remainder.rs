use super::ladder::rounding_of;
use super::{Ladder, Rung};

/// Remainders this many times above the rounding of the function are more than rounding.
const ABOVE_ROUNDING: f64 = 100.0;

/// A slope is fitted over this many of the smallest usable steps: two decades.
const FITTED: usize = 5;

/// The remainders of Taylor's polynomials: how |f(x+h) − f|, |f(x+h) − f − h f′| and |f(x+h) − f −
/// h f′ − ½ h² f″| shrink with h. With exact derivatives their slopes, in logarithms, are 1, 2 and
/// 3 or, where a next derivative is 0, more. `None` where too little is left above rounding to
/// measure one.
pub fn taylor_slopes(ladder: &Ladder, first: f64, second: f64) -> [Option<f64>; 3] {
    [
        slope(ladder, |_| 0.0),
        slope(ladder, |h| h * first),
        slope(ladder, |h| h * (first + 0.5 * h * second)),
    ]
}

/// The slope of the remainder of a polynomial over the smallest steps at which it stands out of the
/// rounding: the steeper of both sides.
fn slope(ladder: &Ladder, polynomial: impl Fn(f64) -> f64) -> Option<f64> {
    let (size, rounding) = (ladder.scale, ladder.rounding());
    let to_a_side = |sign: f64| {
        let above_rounding = |rung: &Rung| {
            let value = if sign > 0.0 { rung.above? } else { rung.below? };
            let remainder = (value - ladder.centre - polynomial(sign * rung.step)).abs();
            // where large parts of the function cancel, what it changes by over a step, and its
            // derivative, are rounded as these parts are
            let of_the_change = rounding_of(ladder.rounded * rung.step / size);
            (remainder > ABOVE_ROUNDING * rounding.max(rounding_of(value)).max(of_the_change))
                .then(|| ((rung.step / size).log10(), remainder.log10()))
        };
        // from the smallest step on that is left; a remainder that passes through 0 in a larger
        // step ends there
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
    // where two terms of the remainder cancel on one side, they add up on the other
    [1.0, -1.0]
        .into_iter()
        .filter_map(to_a_side)
        .max_by(f64::total_cmp)
}

/// The slope of the line through some points, by least squares.
pub(crate) fn line_slope(points: &[(f64, f64)]) -> f64 {
    let mean = |f: fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / points.len() as f64;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let covariance: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let variance: f64 = points.iter().map(|p| (p.0 - x) * (p.0 - x)).sum();
    covariance / variance
}
