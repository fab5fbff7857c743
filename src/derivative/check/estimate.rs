//! Differences extrapolated to steps of 0 (Richardson 1911), with an estimate of what is left of
//! truncation and rounding (after Ridders 1982: what the last orders change the result by).

/// The sides of a place that differences are taken to.
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
    /// p, where the error of a difference over a step h is a series in hᵖ.
    pub(super) fn power(self) -> u8 {
        if self == Self::Both { 2 } else { 1 }
    }
}

/// A step, and the difference over it; how far that may be off by rounding.
pub(super) type Difference = (f64, Estimate);

/// The power of the step that is left of the error by the most differences that are combined.
const MOST_POWER: u8 = 8;

/// A derivative from differences.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The derivative.
    pub value: f64,
    /// How far off it may be, by truncation and rounding.
    pub uncertainty: f64,
}

/// The best estimate of all stretches of consecutive differences. A derivative is the limit of
/// small steps: it goes from small steps to large ones, and ends where one is no further off than
/// is enough, or where larger steps contradict smaller ones beyond what both may be off.
pub(super) fn estimate(
    differences: &[Option<Difference>],
    side: Side,
    enough: f64,
) -> Option<Estimate> {
    let mut best: Option<Estimate> = None;
    for first in (0..differences.len()).rev() {
        for count in 2..=usize::from(MOST_POWER / side.power()).min(differences.len() - first) {
            let stretch = differences[first..first + count]
                .iter()
                .copied()
                .collect::<Option<Vec<_>>>();
            let Some(found) = stretch.map(|stretch| extrapolated(&stretch, side)) else {
                continue;
            };
            let agrees = |finer: Estimate| {
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

/// The polynomial through some differences, at a step of 0.
fn extrapolated(differences: &[Difference], side: Side) -> Estimate {
    let all = at_zero(differences, side);
    let but_one = [&differences[1..], &differences[..differences.len() - 1]];
    let truncation = but_one
        .map(|rest| (all.value - at_zero(rest, side).value).abs())
        .into_iter()
        .fold(0.0, f64::max);
    Estimate {
        value: all.value,
        uncertainty: truncation + all.uncertainty,
    }
}

/// The value at 0 of the polynomial in hᵖ through the differences, after Lagrange, and what their
/// rounding makes of it.
fn at_zero(differences: &[Difference], side: Side) -> Estimate {
    let power = |step: f64| step.powi(side.power().into());
    let mut found = Estimate {
        value: 0.0,
        uncertainty: 0.0,
    };
    for (j, (step, this)) in differences.iter().enumerate() {
        let others = differences
            .iter()
            .enumerate()
            .filter(|(k, _)| *k != j)
            .map(|(_, (step, _))| power(*step));
        let weight: f64 = others.map(|other| other / (other - power(*step))).product();
        found.value += weight * this.value;
        found.uncertainty += weight.abs() * this.uncertainty;
    }
    found
}
