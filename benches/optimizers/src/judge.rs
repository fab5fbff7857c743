//! Judges the results of all solvers in one way: does x meet the KKT conditions? The judge reads
//! only x and the problem.
//!
//! A bound or limit is active if x is within 1e-6 · max(|limit|, 1) of it. Multipliers of active
//! bounds and limits are computed by nonnegative least squares. Each component of the stationarity
//! is relative to its largest term, |f| and 1. A violation is relative to max(|limit|, 1),
//! complementarity to max(|f|, 1).

use crate::nnls;
use crate::oracle::evaluate;
use crate::problems::Case;
use longdrive::optimize::Evaluation;
use nalgebra::{DMatrix, DVector};

const ACTIVE: f64 = 1e-6;

/// KKT residual of a point.
#[derive(Clone, Copy, Debug)]
pub struct Judgement {
    pub value: f64,
    pub feasibility: f64,
    pub stationarity: f64,
    pub complementarity: f64,
}

impl Judgement {
    pub fn residual(&self) -> f64 {
        [self.feasibility, self.stationarity, self.complementarity]
            .into_iter()
            .fold(0.0, |most, part| {
                if part.is_nan() {
                    f64::INFINITY
                } else {
                    part.max(most)
                }
            })
    }

    pub fn is_at_published_optimum(&self, case: &Case) -> bool {
        (self.value - case.optimum).abs() <= 1e-5 * case.optimum.abs().max(1.0)
    }
}

/// An active bound or limit. The sum of ∇f and of every multiplier times its `slope` is 0 at a KKT
/// point. A multiplier is ≥ 0; the multiplier of an equality may have any sign.
struct Active {
    slope: Vec<f64>,
    is_equality: bool,
    distance: f64,
}

pub fn judge(case: &Case, x: &[f64]) -> Judgement {
    let lost = Judgement {
        value: f64::NAN,
        feasibility: f64::INFINITY,
        stationarity: f64::INFINITY,
        complementarity: f64::INFINITY,
    };
    if x.len() != case.start.len() || x.iter().any(|x| !x.is_finite()) {
        return lost;
    }
    let at = evaluate(case, x);
    let is_defined = at.objective.is_finite() && at.constraints.iter().all(|c| c.is_finite());
    if !is_defined {
        return lost;
    }
    let value = at.objective.value;
    let (active, feasibility) = active_set(case, x, &at);
    let (stationarity, complementarity) = multipliers_fit(&active, &at.objective.gradient, value);
    Judgement {
        value,
        feasibility,
        stationarity,
        complementarity,
    }
}

fn active_set(case: &Case, x: &[f64], at: &Evaluation) -> (Vec<Active>, f64) {
    let (mut active, mut worst) = (vec![], 0.0_f64);
    let mut limit = |value: f64, low: f64, high: f64, slope: Vec<f64>| {
        let scaled = |distance: f64, limit: f64| distance / limit.abs().max(1.0);
        let (above, below) = (value - low, high - value);
        if low.is_finite() {
            worst = worst.max(scaled(-above, low));
        }
        if high.is_finite() {
            worst = worst.max(scaled(-below, high));
        }
        if low == high {
            active.push(Active {
                slope,
                is_equality: true,
                distance: 0.0,
            });
            return;
        }
        if low.is_finite() && scaled(above, low) <= ACTIVE {
            active.push(Active {
                slope: slope.iter().map(|s| -s).collect(),
                is_equality: false,
                distance: above.max(0.0),
            });
        }
        if high.is_finite() && scaled(below, high) <= ACTIVE {
            active.push(Active {
                slope,
                is_equality: false,
                distance: below.max(0.0),
            });
        }
    };
    for i in 0..x.len() {
        let unit = (0..x.len())
            .map(|k| if k == i { 1.0 } else { 0.0 })
            .collect();
        limit(x[i], case.low[i], case.high[i], unit);
    }
    for (j, c) in at.constraints.iter().enumerate() {
        limit(c.value, case.least[j], case.most[j], c.gradient.clone());
    }
    (active, worst)
}

/// Stationarity and complementarity with the best multipliers of three least-squares fits. Each fit
/// scales the components of the stationarity by their largest terms in the previous fit. The fit
/// with the smallest residual is kept.
fn multipliers_fit(active: &[Active], gradient: &[f64], value: f64) -> (f64, f64) {
    let n = gradient.len();
    let least = value.abs().max(1.0);
    let free: Vec<bool> = active.iter().map(|a| a.is_equality).collect();
    let mut sizes: Vec<f64> = gradient.iter().map(|g| g.abs().max(least)).collect();
    let mut best = (f64::INFINITY, f64::INFINITY);
    for _ in 0..3 {
        let slopes = DMatrix::from_fn(n, active.len(), |i, j| active[j].slope[i] / sizes[i]);
        let target = DVector::from_fn(n, |i, _| -gradient[i] / sizes[i]);
        let multipliers = nnls::solve(&slopes, &target, &free);
        let mut stationarity = 0.0_f64;
        for i in 0..n {
            let pulls = || {
                active
                    .iter()
                    .zip(multipliers.iter())
                    .map(|(a, m)| a.slope[i] * m)
            };
            let size = pulls().fold(gradient[i].abs().max(least), |most, pull| {
                pull.abs().max(most)
            });
            stationarity = stationarity.max((gradient[i] + pulls().sum::<f64>()).abs() / size);
            sizes[i] = size;
        }
        let gaps = active
            .iter()
            .zip(multipliers.iter())
            .map(|(a, m)| (a.distance * m).abs() / least);
        let found = (stationarity, gaps.fold(0.0, f64::max));
        if found.0.max(found.1) < best.0.max(best.1) {
            best = found;
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    fn residual(name: &str, x: &[f64]) -> f64 {
        let cases = crate::all();
        judge(cases.iter().find(|case| case.name == name).unwrap(), x).residual()
    }

    /// The published optimum of HS35 is (4/3, 7/9, 4/9); its constraint is active there.
    #[test]
    fn an_optimum_passes_and_its_neighbours_do_not() {
        let at = [4.0 / 3.0, 7.0 / 9.0, 4.0 / 9.0];
        assert!(residual("HS35", &at) < 1e-14);
        assert!(residual("HS35", &[at[0] + 1e-4, at[1] - 1e-4, at[2]]) > 1e-5);
        assert!(residual("HS35", &[at[0], at[1], at[2] + 1e-4]) > 1e-5);
    }

    /// HS4 minimizes f = (x₁ + 1)³/3 + x₂, which increases with both variables. Only at both lower
    /// bounds, (1, 0), are the multipliers nonnegative.
    #[test]
    fn multipliers_of_the_wrong_sign_do_not_pass() {
        assert!(residual("HS4", &[1.0, 0.0]) < 1e-14);
        assert!(residual("HS4", &[2.0, 0.0]) > 0.1);
        assert!(residual("HS4", &[1.0, 1.0]) > 0.1);
        // HS45: f = 2 − Πx/120 decreases with every variable, so the minimum is at the upper bounds
        assert!(residual("HS45", &[1.0, 2.0, 3.0, 4.0, 5.0]) < 1e-14);
        assert!(residual("HS45", &[0.0, 2.0, 3.0, 4.0, 5.0]) > 0.1);
    }
}
