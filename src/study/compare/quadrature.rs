use crate::error::Result;
use crate::statistics::largest_magnitude;

/// Positive nodes and weights of the 8-point Gauss–Legendre rule on [−1, 1], exact for polynomials
/// of degree 15 (Abramowitz & Stegun 1964, table 25.4).
const RULE: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];

/// Relative error below which an integral counts as exact up to rounding.
const ROUNDING: f64 = 1e-12;

/// Number of bisections after which the tolerance rises from [`ROUNDING`] to [`ENOUGH`]. A smooth
/// function, or a function with a single kink, needs fewer bisections to reach [`ROUNDING`].
const USUAL: usize = 100;

/// Relative tolerance for functions with hundreds of kinks. The derivatives of a drive with a
/// piecewise C² law have a kink wherever a stage of a time step reaches the end of a piece.
const ENOUGH: f64 = 1e-8;

/// Maximum number of bisections.
const MOST: usize = 1000;

/// Integrals of several functions.
pub(super) struct Integrals {
    /// The values.
    pub values: Vec<f64>,
    /// Sum of the error estimates of all intervals. An interval is bisected, which changes the
    /// integral of each function; the largest change is the error estimate of the interval.
    pub error: f64,
}

/// An interval of the adaptive quadrature.
struct Subinterval {
    range: [f64; 2],
    /// Integrals by the rule over the whole interval.
    whole: Vec<f64>,
    /// Integrals by the rule over each half; `None` before bisection.
    halves: Option<[Vec<f64>; 2]>,
    /// Largest difference between `whole` and the sum of `halves`. Before bisection, half the error
    /// of the parent interval.
    error: f64,
}

/// Adaptive integrals of several functions over a range; `f` returns the values of all functions.
/// Bisects the interval with the largest error until the sum of the errors is below [`ROUNDING`].
/// After [`USUAL`] bisections, a sum below [`ENOUGH`] is sufficient. Both limits are relative to
/// `size`, or to the largest integral if that is larger.
pub(super) fn integrals(
    range: [f64; 2],
    size: f64,
    mut f: impl FnMut(f64) -> Result<Vec<f64>>,
) -> Result<Integrals> {
    let whole = by_rule(range, &mut f)?;
    let mut parts = vec![Subinterval {
        range,
        whole,
        halves: None,
        error: f64::INFINITY,
    }];
    let mut halved = 0;
    loop {
        let found = sum(&parts);
        let size = largest_magnitude(&found.values).max(size);
        let is_enough = |part: f64| found.error <= part * size;
        let worst = (0..parts.len()).max_by(|a, b| parts[*a].error.total_cmp(&parts[*b].error));
        let (Some(worst), true) = (worst, halved < MOST) else {
            return Ok(found);
        };
        if is_enough(ROUNDING) || halved >= USUAL && is_enough(ENOUGH) {
            return Ok(found);
        }
        let part = parts.swap_remove(worst);
        let [low, high] = part.range;
        let middle = 0.5 * (low + high);
        let ranges = [[low, middle], [middle, high]];
        if let Some(halves) = part.halves {
            let error = 0.5 * part.error;
            let half = |(range, whole)| Subinterval {
                range,
                whole,
                halves: None,
                error,
            };
            parts.extend(ranges.into_iter().zip(halves).map(half));
        } else {
            halved += 1;
            let halves = [by_rule(ranges[0], &mut f)?, by_rule(ranges[1], &mut f)?];
            let changes = part
                .whole
                .iter()
                .zip(&halves[0])
                .zip(&halves[1])
                .map(|((whole, a), b)| whole - a - b);
            let error = largest_magnitude(changes);
            parts.push(Subinterval {
                halves: Some(halves),
                error,
                ..part
            });
        }
    }
}

fn sum(parts: &[Subinterval]) -> Integrals {
    let mut values = vec![];
    for part in parts {
        let of_part = part
            .halves
            .as_ref()
            .map_or(std::slice::from_ref(&part.whole), |halves| &halves[..]);
        of_part.iter().for_each(|more| add(&mut values, more, 1.0));
    }
    Integrals {
        values,
        error: parts.iter().map(|part| part.error).sum(),
    }
}

fn by_rule([low, high]: [f64; 2], f: &mut impl FnMut(f64) -> Result<Vec<f64>>) -> Result<Vec<f64>> {
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    let mut sums = vec![];
    for (node, weight) in RULE {
        for at in [middle - half * node, middle + half * node] {
            add(&mut sums, &f(at)?, half * weight);
        }
    }
    Ok(sums)
}

/// Adds `weight` times the values to the sums. Empty sums count as 0.
fn add(sums: &mut Vec<f64>, values: &[f64], weight: f64) {
    sums.resize(values.len(), 0.0);
    sums.iter_mut()
        .zip(values)
        .for_each(|(sum, value)| *sum += weight * value);
}

#[cfg(test)]
mod tests {
    use super::{by_rule, integrals};
    use std::cell::Cell;

    #[test]
    fn exact_for_polynomials_up_to_degree_15() {
        let power = |n: i32| by_rule([0.0, 1.0], &mut |x: f64| Ok(vec![x.powi(n)])).unwrap()[0];
        for n in 0..=15 {
            assert!(
                (power(n) - 1.0 / f64::from(n + 1)).abs() < 1e-15,
                "{n}: {}",
                power(n)
            );
        }
        assert!((power(16) - 1.0 / 17.0).abs() > 1e-12);
    }

    #[test]
    fn exact_integral_of_a_function_with_a_corner() {
        let found =
            integrals([0.0, 1.0], 1.0, |x| Ok(vec![(x - 0.3).abs(), x.exp(), 1.0])).unwrap();
        for (found, exact) in found.values.iter().zip([0.29, 1_f64.exp() - 1.0, 1.0]) {
            assert!((found - exact).abs() < 1e-12, "{found} {exact}");
        }
        assert!(found.error < 1e-11, "{}", found.error);
    }

    /// A sum of |x − c|³ over hundreds of positions c: its second derivative has kinks, like the
    /// derivatives of a drive.
    #[test]
    fn exact_integral_with_hundreds_of_corners_is_within_the_error_estimate() {
        let places: Vec<f64> = (0..300)
            .map(|k| (f64::from(k) * 0.618_033_988_749_895).fract())
            .collect();
        let f = |x: f64| {
            places
                .iter()
                .map(|c| 4.0 * (x - c).abs().powi(3))
                .sum::<f64>()
        };
        let exact: f64 = places.iter().map(|c| c.powi(4) + (1.0 - c).powi(4)).sum();
        let found = integrals([0.0, 1.0], 0.0, |x| Ok(vec![f(x)])).unwrap();
        let error = (found.values[0] - exact).abs();
        assert!(
            error <= found.error && found.error <= 1e-8 * exact,
            "{error} of {}, told {}",
            exact,
            found.error
        );
    }

    #[test]
    fn regress_a_smooth_function_is_evaluated_twenty_four_times() {
        let count = Cell::new(0);
        let f = |x: f64| {
            count.set(count.get() + 1);
            Ok(vec![x.exp()])
        };
        integrals([0.0, 1.0], 1.0, f).unwrap();
        assert_eq!(count.get(), 24);
    }
}
