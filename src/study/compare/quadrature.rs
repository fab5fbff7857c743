use crate::error::Result;
use std::collections::VecDeque;

/// The positive nodes of Gauss and Legendre's rule with 8 nodes on [−1, 1], with their weights: exact for polynomials of degree 15
/// (Abramowitz & Stegun 1964, table 25.4).
const RULE: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];

/// Parts that are halved at most: enough to close in on a corner to the last digit.
const MOST: usize = 100;

/// Changes below this part of the largest integral are rounding.
const ROUNDING: f64 = 1e-12;

/// The integrals of some functions over a range. Parts of the range are halved until that changes no integral by more than `tolerance`
/// or rounding, or until they are very many: next to a corner of the functions. `f` is the value of each function.
pub(super) fn integrals(
    [low, high]: [f64; 2],
    tolerance: f64,
    mut f: impl FnMut(f64) -> Result<Vec<f64>>,
) -> Result<Vec<f64>> {
    let whole = by_rule(low, high, &mut f)?;
    let mut sums = vec![0.0; whole.len()];
    let mut parts = VecDeque::from([(low, high, whole)]);
    let mut halved = 0;
    while let Some((low, high, whole)) = parts.pop_front() {
        if halved == MOST {
            sums.iter_mut().zip(&whole).for_each(|(sum, part)| *sum += part);
            continue;
        }
        halved += 1;
        let middle = 0.5 * (low + high);
        let (left, right) = (by_rule(low, middle, &mut f)?, by_rule(middle, high, &mut f)?);
        let halves: Vec<f64> = left.iter().zip(&right).map(|(left, right)| left + right).collect();
        // the rounding of one derivative is that of the largest
        let rounding = ROUNDING * whole.iter().fold(0.0, |most: f64, part| most.max(part.abs()));
        let is_settled = |(whole, halves): (&f64, &f64)| (whole - halves).abs() <= tolerance.max(rounding);
        if whole.iter().zip(&halves).all(is_settled) {
            sums.iter_mut().zip(&halves).for_each(|(sum, part)| *sum += part);
        } else {
            parts.extend([(low, middle, left), (middle, high, right)]);
        }
    }
    Ok(sums)
}

fn by_rule(low: f64, high: f64, f: &mut impl FnMut(f64) -> Result<Vec<f64>>) -> Result<Vec<f64>> {
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    let mut sums = vec![];
    for (node, weight) in RULE {
        for at in [middle - half * node, middle + half * node] {
            let values = f(at)?;
            sums.resize(values.len(), 0.0);
            sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += half * weight * value);
        }
    }
    Ok(sums)
}

#[cfg(test)]
mod tests {
    use super::{by_rule, integrals};

    #[test]
    fn exact_for_polynomials_of_degree_15_and_no_further() {
        let power = |n: i32| by_rule(0.0, 1.0, &mut |x: f64| Ok(vec![x.powi(n)])).unwrap()[0];
        for n in 0..=15 {
            assert!((power(n) - 1.0 / f64::from(n + 1)).abs() < 1e-15, "{n}: {}", power(n));
        }
        assert!((power(16) - 1.0 / 17.0).abs() > 1e-12);
    }

    #[test]
    fn exact_beside_a_corner_too() {
        let found = integrals([0.0, 1.0], 1e-13, |x| Ok(vec![(x - 0.3).abs(), x.exp(), 1.0])).unwrap();
        for (found, exact) in found.iter().zip([0.29, 1_f64.exp() - 1.0, 1.0]) {
            assert!((found - exact).abs() < 1e-12, "{found} {exact}");
        }
    }
}
