use crate::study::uncertainty::Distribution;
use nalgebra::{DMatrix, SymmetricEigen};

/// The nodes and weights of a Gauss rule, from the recurrence of its orthogonal polynomials (Golub & Welsch 1969): `off(k)` is the entry
/// k, k + 1 of the symmetric tridiagonal matrix, whose diagonal is 0. The weights add up to 1.
fn gauss(nodes: usize, off: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    let mut jacobi = DMatrix::zeros(nodes, nodes);
    for k in 1..nodes {
        let entry = off(k as f64);
        (jacobi[(k - 1, k)], jacobi[(k, k - 1)]) = (entry, entry);
    }
    let eigen = SymmetricEigen::new(jacobi);
    let node = |k: usize| (eigen.eigenvalues[k], eigen.eigenvectors[(0, k)].powi(2));
    let mut rule: Vec<(f64, f64)> = (0..nodes).map(node).collect();
    rule.sort_by(|a, b| a.0.total_cmp(&b.0));
    rule
}

/// Hermite's rule: for a standard normal number.
pub(super) fn hermite(nodes: usize) -> Vec<(f64, f64)> {
    gauss(nodes, f64::sqrt)
}

/// Legendre's rule: for a number between 0 and 1, all alike.
fn legendre(nodes: usize) -> Vec<(f64, f64)> {
    let rule = gauss(nodes, |k| k / (4.0 * k * k - 1.0).sqrt());
    rule.into_iter().map(|(node, weight)| (0.5 + 0.5 * node, weight)).collect()
}

/// Values of a distributed number with weights that add up to 1: exact for polynomials of a high degree.
pub(super) fn rule(distribution: &Distribution, nodes: usize) -> Vec<(f64, f64)> {
    let between = |low: f64, high: f64, nodes: usize| {
        legendre(nodes).into_iter().map(move |(node, weight)| (low + (high - low) * node, weight * (high - low)))
    };
    // by the density on each part on which it is smooth
    let by_density = |parts: &[(f64, f64)], density: &dyn Fn(f64) -> f64| {
        let each = parts.iter().filter(|(low, high)| low < high).flat_map(|(low, high)| between(*low, *high, nodes));
        let weighted: Vec<_> = each.map(|(value, width)| (value, width * density(value))).collect();
        let sum: f64 = weighted.iter().map(|(_, weight)| weight).sum();
        weighted.into_iter().map(|(value, weight)| (value, weight / sum)).collect()
    };
    match *distribution {
        Distribution::Normal { mean, deviation } => {
            hermite(nodes).into_iter().map(|(node, weight)| (mean + deviation * node, weight)).collect()
        }
        Distribution::Uniform { low, high } => by_density(&[(low, high)], &|_| 1.0),
        Distribution::Triangular { low, mode, high } => by_density(&[(low, mode), (mode, high)], &|x| {
            if x < mode { (x - low) / (mode - low) } else { (high - x) / (high - mode) }
        }),
        Distribution::Truncated { mean, deviation, low, high } => {
            by_density(&[(low, high)], &|x| (-0.5 * ((x - mean) / deviation).powi(2)).exp())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::rule;
    use crate::study::uncertainty::Distribution;

    fn moments(distribution: &Distribution) -> [f64; 4] {
        let rule = rule(distribution, 24);
        assert!((rule.iter().map(|(_, w)| w).sum::<f64>() - 1.0).abs() < 1e-13);
        let mean: f64 = rule.iter().map(|(x, w)| x * w).sum();
        let about = |k: i32| rule.iter().map(|(x, w)| (x - mean).powi(k) * w).sum::<f64>();
        [mean, about(2), about(3), about(4)]
    }

    /// The rules hold the mean and the next three moments about it, which have closed forms; those of the normal distribution between two
    /// ends are as good as the library's error function.
    #[test]
    fn exact_moments_of_each_rule() {
        let all = [
            (Distribution::Normal { mean: 2.0, deviation: 0.5 }, 1e-12),
            (Distribution::Uniform { low: -1.0, high: 3.0 }, 1e-12),
            (Distribution::Triangular { low: 0.0, mode: 1.0, high: 4.0 }, 1e-11),
            (Distribution::Triangular { low: 0.0, mode: 0.0, high: 4.0 }, 1e-11),
            (Distribution::Truncated { mean: 1.0, deviation: 2.0, low: -1.0, high: 2.5 }, 1e-8),
        ];
        for (distribution, bar) in all {
            let [mean, second, third, fourth] = moments(&distribution);
            let closed = distribution.central_moments();
            let pairs = [(mean, distribution.mean()), (second, closed[0]), (third, closed[1]), (fourth, closed[2])];
            for (found, exact) in pairs {
                assert!((found - exact).abs() < bar * exact.abs().max(1.0), "{distribution:?}: {found} {exact}");
            }
        }
    }

    /// The last of these beside Simpson's rule with 200,000 parts, summed without rounding.
    #[test]
    fn independent_moments_of_a_normal_distribution_between_two_ends() {
        let found = moments(&Distribution::Truncated { mean: 1.0, deviation: 2.0, low: -1.0, high: 2.5 });
        let exact = [0.8074994843391808, 0.9187882798861596, -0.05769299804279981, 1.6153037903424834];
        for (found, exact) in found.into_iter().zip(exact) {
            assert!((found - exact).abs() < 1e-13, "{found} {exact}");
        }
    }
}
