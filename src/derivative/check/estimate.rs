//! Richardson (1911) extrapolation of differences to step 0, with an estimate of truncation and
//! rounding errors. The truncation error is estimated by the change of the result if one difference
//! is omitted (after Ridders 1982).

/// Sides on which differences are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Central differences.
    Both,
    /// Backward differences.
    Below,
    /// Forward differences.
    Above,
}

impl Side {
    /// Power p: the error of a difference is a series in hᵖ.
    pub(super) fn power(self) -> u8 {
        if self == Self::Both { 2 } else { 1 }
    }
}

/// The difference quotient over a step.
#[derive(Clone, Copy)]
pub(super) struct DifferenceQuotient {
    /// The step h.
    pub step: f64,
    pub value: f64,
    /// Rounding error of the value.
    pub rounding: f64,
}

/// Largest order of an extrapolation: its error is O(h⁸) with four central or eight one-sided
/// differences.
const LARGEST_ORDER: u8 = 8;

/// Derivative from differences.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DerivativeEstimate {
    /// Derivative.
    pub value: f64,
    /// Error estimate: truncation and rounding.
    pub uncertainty: f64,
}

/// The extrapolation of consecutive differences with the smallest uncertainty. The search goes from
/// small steps to large steps. It ends when the uncertainty is at most `enough`, or when an
/// estimate differs from the best one by more than twice the sum of both uncertainties. `None` if
/// no two consecutive differences exist.
pub(super) fn estimate(
    differences: &[Option<DifferenceQuotient>],
    side: Side,
    enough: f64,
) -> Option<DerivativeEstimate> {
    let mut best: Option<DerivativeEstimate> = None;
    for first in (0..differences.len()).rev() {
        for count in 2..=usize::from(LARGEST_ORDER / side.power()).min(differences.len() - first) {
            let stretch = differences[first..first + count]
                .iter()
                .copied()
                .collect::<Option<Vec<_>>>();
            let Some(found) = stretch.map(|stretch| extrapolated(&stretch, side)) else {
                continue;
            };
            let agrees = |finer: DerivativeEstimate| {
                (finer.value - found.value).abs() <= 2.0 * (finer.uncertainty + found.uncertainty)
            };
            match best {
                Some(finer) if !agrees(finer) => return best,
                Some(finer) if finer.uncertainty <= found.uncertainty => {}
                _ => best = Some(found),
            }
        }
        if best.is_some_and(|best| best.uncertainty <= enough) {
            return best;
        }
    }
    best
}

/// Extrapolates `differences` to step 0. Two further extrapolations omit the first or the last
/// difference; the larger change of the result estimates the truncation error.
fn extrapolated(differences: &[DifferenceQuotient], side: Side) -> DerivativeEstimate {
    let all = at_zero(differences, side);
    let but_one = [&differences[1..], &differences[..differences.len() - 1]];
    let truncation = but_one
        .map(|rest| (all.value - at_zero(rest, side).value).abs())
        .into_iter()
        .fold(0.0, f64::max);
    DerivativeEstimate {
        value: all.value,
        uncertainty: truncation + all.uncertainty,
    }
}

/// Value at h = 0 of Lagrange's polynomial in hᵖ through the differences. The uncertainty is the
/// propagated rounding error.
fn at_zero(differences: &[DifferenceQuotient], side: Side) -> DerivativeEstimate {
    let power = |step: f64| step.powi(side.power().into());
    let mut found = DerivativeEstimate {
        value: 0.0,
        uncertainty: 0.0,
    };
    for (j, this) in differences.iter().enumerate() {
        let others = differences
            .iter()
            .enumerate()
            .filter(|(k, _)| *k != j)
            .map(|(_, other)| power(other.step));
        let own = power(this.step);
        let weight: f64 = others.map(|other| other / (other - own)).product();
        found.value += weight * this.value;
        found.uncertainty += weight.abs() * this.rounding;
    }
    found
}
