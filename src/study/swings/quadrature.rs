use crate::study::gauss::{gauss, legendre};
use crate::study::uncertainty::{Distribution, dense_part};

/// Number of standard deviations at which normal distributions are truncated. Only 6 of 100,000
/// swings lie beyond, and many of these miss the ball.
pub(super) const REACH: f64 = 4.0;
/// Number of samples of a density on each interval in which the density is smooth.
const SAMPLED: usize = 96;

/// Gauss rule with this number of nodes for a density. `parts` are adjacent intervals on each of
/// which the density is smooth. The recurrence is computed from many samples of the density
/// (Stieltjes; Gautschi 1982).
fn rule_of(parts: &[[f64; 2]], density: &dyn Fn(f64) -> f64, nodes: usize) -> Vec<(f64, f64)> {
    let bounds = [parts[0][0], parts[parts.len() - 1][1]];
    let (middle, half) = (0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[1] - bounds[0]));
    let sampled = parts
        .iter()
        .filter(|[low, high]| low < high)
        .flat_map(|part| {
            legendre(*part, SAMPLED)
                .into_iter()
                .map(move |(x, weight)| (x, weight * (part[1] - part[0])))
        });
    // map x to [−1, 1], where the polynomials stay small
    let sampled: Vec<(f64, f64)> = sampled
        .map(|(x, weight)| ((x - middle) / half, weight * density(x)))
        .collect();
    let dot = |p: &[f64], q: &[f64]| {
        sampled
            .iter()
            .zip(p)
            .zip(q)
            .map(|(((_, w), p), q)| w * p * q)
            .sum::<f64>()
    };
    let (mut previous, mut current) = (vec![0.0; sampled.len()], vec![1.0; sampled.len()]);
    let (mut diagonal, mut off_diagonal) = (vec![], vec![]);
    let (mut size, mut ratio) = (dot(&current, &current), 0.0);
    for _ in 0..nodes {
        let moved: Vec<f64> = sampled
            .iter()
            .zip(&current)
            .map(|((x, _), p)| x * p)
            .collect();
        let centre = dot(&moved, &current) / size;
        let next: Vec<f64> = moved
            .iter()
            .zip(&current)
            .zip(&previous)
            .map(|((moved, current), previous)| moved - centre * current - ratio * previous)
            .collect();
        (previous, current) = (current, next);
        let of_next = dot(&current, &current);
        ratio = of_next / size;
        size = of_next;
        diagonal.push(centre);
        off_diagonal.push(ratio.sqrt());
    }
    gauss(&diagonal, &off_diagonal)
        .into_iter()
        .map(|(x, weight)| (middle + half * x, weight))
        .collect()
}

/// Gauss rule of a distribution: values with weights that sum to 1. With n nodes it is exact for
/// polynomials up to degree 2 n − 1. A normal distribution is truncated at ±`REACH`.
pub(super) fn rule(distribution: &Distribution, nodes: usize) -> Vec<(f64, f64)> {
    let bell =
        |mean: f64, deviation: f64| move |x: f64| (-0.5 * ((x - mean) / deviation).powi(2)).exp();
    match *distribution {
        Distribution::Normal { mean, deviation } => {
            let bounds = [mean - REACH * deviation, mean + REACH * deviation];
            rule_of(&[bounds], &bell(mean, deviation), nodes)
        }
        Distribution::Uniform { low, high } => legendre([low, high], nodes),
        Distribution::Triangular { low, mode, high } => rule_of(
            &[[low, mode], [mode, high]],
            &|x| {
                if x < mode {
                    (x - low) / (mode - low)
                } else {
                    (high - x) / (high - mode)
                }
            },
            nodes,
        ),
        Distribution::Truncated {
            mean,
            deviation,
            low,
            high,
        } => {
            let dense = dense_part(mean, deviation, [low, high]);
            rule_of(&[dense], &bell(mean, deviation), nodes)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::rule;
    use crate::study::uncertainty::Distribution;

    fn moments(distribution: &Distribution) -> [f64; 4] {
        let rule = rule(distribution, 8);
        assert!((rule.iter().map(|(_, w)| w).sum::<f64>() - 1.0).abs() < 1e-13);
        let mean: f64 = rule.iter().map(|(x, w)| x * w).sum();
        let about = |k: i32| {
            rule.iter()
                .map(|(x, w)| (x - mean).powi(k) * w)
                .sum::<f64>()
        };
        [mean, about(2), about(3), about(4)]
    }

    /// The rules reproduce the mean and the central moments 2, 3 and 4, which have closed forms.
    #[test]
    fn moments_of_each_rule_by_closed_forms() {
        let all = [
            // truncation at 4 standard deviations lowers the variance by a thousandth
            (
                Distribution::Normal {
                    mean: 2.0,
                    deviation: 0.5,
                },
                2e-3,
            ),
            (
                Distribution::Uniform {
                    low: -1.0,
                    high: 3.0,
                },
                1e-12,
            ),
            (
                Distribution::Triangular {
                    low: 0.0,
                    mode: 1.0,
                    high: 4.0,
                },
                1e-11,
            ),
            (
                Distribution::Triangular {
                    low: 0.0,
                    mode: 0.0,
                    high: 4.0,
                },
                1e-11,
            ),
        ];
        for (distribution, bar) in all {
            let [mean, second, third, fourth] = moments(&distribution);
            let closed = distribution.central_moments();
            let pairs = [
                (mean, distribution.mean()),
                (second, closed[0]),
                (third, closed[1]),
                (fourth, closed[2]),
            ];
            for (found, exact) in pairs {
                assert!(
                    (found - exact).abs() < bar * exact.abs().max(1.0),
                    "{distribution:?}: {found} {exact}"
                );
            }
        }
    }

    /// The expected moments come from Simpson's rule with 200,000 intervals, summed without
    /// rounding.
    #[test]
    fn independent_moments_of_a_normal_distribution_between_two_ends() {
        let found = moments(&Distribution::Truncated {
            mean: 1.0,
            deviation: 2.0,
            low: -1.0,
            high: 2.5,
        });
        let exact = [
            0.8074994843391808,
            0.9187882798861596,
            -0.05769299804279981,
            1.6153037903424834,
        ];
        for (found, exact) in found.into_iter().zip(exact) {
            assert!((found - exact).abs() < 1e-13, "{found} {exact}");
        }
    }
}
