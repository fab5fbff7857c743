//! A weighted subset of the scenarios. A search computes second derivatives only for the drives of
//! the subset. They approximate the second derivatives of all drives.

use super::scenarios::{Rule, Scenarios};
use nalgebra::{DMatrix, DVector};

/// The number of all scenarios divided by the number in the subset. The subset may be larger
/// because of [`LEAST`] and [`PER_MOMENT`].
const REDUCTION: usize = 16;
/// Minimum number of scenarios in the subset.
const LEAST: usize = 128;
/// Minimum number of scenarios in the subset, divided by the number of moments that the weights
/// reproduce.
const PER_MOMENT: usize = 2;

/// Indices of the scenarios in the subset, in order, and the number of scenarios that each of them
/// represents. The subset is all scenarios if it would contain more than half of them.
///
/// The first points of a sequence are spread as evenly as the whole sequence. Gauss's rule keeps
/// all its nodes, because a subset of them is not a quadrature rule.
pub(in crate::study) fn subset_of(scenarios: &Scenarios) -> (Vec<usize>, Vec<f64>) {
    let all = scenarios.points.len();
    let count = (all / REDUCTION)
        .max(LEAST)
        .max(PER_MOMENT * moments(scenarios.parameters.len()));
    let subset: Vec<usize> = match scenarios.rule {
        Rule::Sequence { .. } if 2 * count <= all => (0..count).collect(),
        Rule::Recorded if 2 * count <= all => (0..count).map(|k| k * all / count).collect(),
        _ => return ((0..all).collect(), vec![1.0; all]),
    };
    let weights = subset_weights(&subset, scenarios);
    let multiplicities = subset
        .iter()
        .zip(weights)
        .map(|(k, weight)| weight / scenarios.weights[*k])
        .collect();
    (subset, multiplicities)
}

/// Number of moments: the constant 1, each parameter, and each product of two parameters (squares
/// included).
fn moments(parameters: usize) -> usize {
    1 + parameters + parameters * (parameters + 1) / 2
}

/// Weights of the subset that reproduce the means, variances and covariances of the parameters over
/// all scenarios. A mean over the subset is then exact for quadratic functions of the parameters.
/// Of all such weights, these are nearest to equal weights in the least-squares sense.
fn subset_weights(subset: &[usize], scenarios: &Scenarios) -> Vec<f64> {
    /// Relative tolerance of singular values, which are 0 if parameters are constant or linearly
    /// dependent.
    const ROUNDING: f64 = 1e-9;
    let n = scenarios.parameters.len();
    let over_all = |f: &dyn Fn(&[f64]) -> f64| {
        scenarios
            .points
            .iter()
            .zip(&scenarios.weights)
            .map(|(point, weight)| weight * f(point))
            .sum::<f64>()
    };
    let means: Vec<f64> = (0..n).map(|i| over_all(&|point| point[i])).collect();
    let deviation = |i: usize| over_all(&|point| (point[i] - means[i]).powi(2)).sqrt();
    let scales: Vec<f64> = (0..n)
        .map(|i| Some(deviation(i)).filter(|d| *d > 0.0).unwrap_or(1.0))
        .collect();
    let monomials = |point: &[f64]| {
        let scores: Vec<f64> = (0..n).map(|i| (point[i] - means[i]) / scales[i]).collect();
        let products = (0..n)
            .flat_map(|i| (0..=i).map(move |j| (i, j)))
            .map(|(i, j)| scores[i] * scores[j]);
        DVector::from_iterator(
            moments(n),
            [1.0]
                .into_iter()
                .chain(scores.iter().copied())
                .chain(products),
        )
    };
    let mut wanted = DVector::zeros(moments(n));
    for (point, weight) in scenarios.points.iter().zip(&scenarios.weights) {
        wanted += monomials(point) * *weight;
    }
    let columns: Vec<_> = subset
        .iter()
        .map(|k| monomials(&scenarios.points[*k]))
        .collect();
    let of_subset = DMatrix::from_columns(&columns);
    let equal = DVector::from_element(subset.len(), 1.0 / subset.len() as f64);
    let missing = wanted - &of_subset * &equal;
    let decomposed = of_subset.svd(true, true);
    let least = ROUNDING * decomposed.singular_values.max();
    // equal weights if there is no solution
    let change = decomposed
        .solve(&missing, least)
        .unwrap_or_else(|_| DVector::zeros(subset.len()));
    (equal + change).iter().copied().collect()
}

#[cfg(test)]
mod tests {
    use super::subset_of;
    use crate::parameters::Setup;
    use crate::study::swings::golfer::Swings;
    use crate::study::swings::scenarios::{Rule, Scenarios};
    use crate::study::uncertainty::Uncertain;

    fn scenarios(count: usize) -> Scenarios {
        let setup = Setup::modern_driver();
        let texts = [
            "swing.speed=normal(107mph,3mph)",
            "swing.path=uniform(-2deg,4deg)",
            "strike.toe=normal(3mm,8mm)",
        ];
        let inputs = texts
            .iter()
            .map(|text| Uncertain::read(&setup, text).unwrap())
            .collect();
        Scenarios::new(
            &Swings::distributed(inputs, &[]).unwrap(),
            Rule::Sequence { count, seed: 3 },
        )
        .unwrap()
    }

    /// Means of quadratic functions over the subset equal the means over all scenarios.
    #[test]
    fn exact_means_of_quadratic_functions_over_a_subset() {
        let all = scenarios(500);
        let (subset, multiplicities) = subset_of(&all);
        assert_eq!(subset, (0..128).collect::<Vec<_>>());
        let speed = |k: usize| all.points[k][0] - 47.0;
        let functions: [&dyn Fn(usize) -> f64; 4] = [
            &|_| 1.0,
            &|k| all.points[k][1],
            &|k| speed(k) * all.points[k][2],
            &|k| speed(k) * (speed(k) - 2.0) + 30.0 * all.points[k][2],
        ];
        for f in functions {
            let exact = (0..500).map(f).sum::<f64>() / 500.0;
            let found = subset
                .iter()
                .zip(&multiplicities)
                .map(|(k, count)| count * f(*k))
                .sum::<f64>()
                / 500.0;
            assert!(
                (found - exact).abs() < 1e-12 * (1.0 + exact.abs()),
                "{found} {exact}"
            );
        }
    }

    #[test]
    fn few_scenarios_are_not_divided() {
        assert_eq!(
            subset_of(&scenarios(200)),
            ((0..200).collect(), vec![1.0; 200])
        );
        assert_eq!(subset_of(&scenarios(10_000)).0.len(), 625);
    }
}
