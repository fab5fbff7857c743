//! What following an optimum along a number needs: steps that adapt, predictions, and the place
//! where something changes.

use super::domain::Bounds;

/// The longest step, as a part of the range.
pub(crate) const LONGEST: f64 = 1.0 / 16.0;
/// The shortest.
const SHORTEST: f64 = 1.0 / 65_536.0;
/// Steps whose predicted optimum is farther than this from the one found, in units of the ranges,
/// are halved …
pub(crate) const TOO_FAR: f64 = 0.02;
/// … and those nearer than this are followed by longer ones.
const NEAR: f64 = 0.002;
/// The trust region of a corrector: it stays with the optimum it follows.
pub(crate) const RADIUS: f64 = 0.05;

/// A step along a range that adapts to how far optima lie from where they were predicted.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stride {
    width: f64,
    step: f64,
}

impl Stride {
    /// The longest step of a range of this width.
    pub fn new(width: f64) -> Self {
        Self {
            width,
            step: LONGEST * width,
        }
    }

    /// Where the next optimum is looked for, in a range that ends there.
    pub fn to(&self, here: f64, end: f64) -> f64 {
        // no short step is left for the end
        if here + 1.001 * self.step >= end {
            end
        } else {
            here + self.step
        }
    }

    /// Halves it; `false` where it cannot be shorter.
    pub fn halve(&mut self) -> bool {
        let can = self.step > SHORTEST * self.width;
        if can {
            self.step *= 0.5;
        }
        can
    }

    /// A longer one after an optimum that was predicted well.
    pub fn adapt(&mut self, apart: f64) {
        if apart < NEAR {
            self.step = (2.0 * self.step).min(LONGEST * self.width);
        }
    }
}

/// Where an optimum that moves at these rates is after a change, within its bounds.
pub(crate) fn predicted(x: &[f64], rates: &[f64], change: f64, bounds: &Bounds) -> Vec<f64> {
    let moved: Vec<f64> = x
        .iter()
        .zip(rates)
        .map(|(x, rate)| x + rate * change)
        .collect();
    bounds.project(&moved)
}

/// How far two points are apart in any variable, in units of its range.
pub(crate) fn apart(x: &[f64], predicted: &[f64], bounds: &Bounds) -> f64 {
    let parts = x
        .iter()
        .zip(predicted)
        .enumerate()
        .map(|(i, (x, predicted))| {
            let width = bounds.high[i] - bounds.low[i];
            if width > 0.0 {
                (x - predicted).abs() / width
            } else {
                0.0
            }
        });
    parts.fold(0.0, f64::max)
}

/// The first place found, within a tolerance, that is no longer as `before`: `guess` says where
/// that is expected, `next` finds what is at a place, starting from what is known before it. Where
/// nothing is found, the last place that was.
pub(crate) fn located<P>(
    [mut before, mut after]: [P; 2],
    tolerance: f64,
    at: impl Fn(&P) -> f64,
    guess: impl Fn(&P, f64) -> Option<f64>,
    next: impl Fn(&P, f64) -> Option<P>,
    is_as_before: impl Fn(&P) -> bool,
) -> P {
    let mut is_guessed = true;
    while at(&after) - at(&before) > tolerance {
        let (low, high) = (at(&before), at(&after));
        // just beyond the place that is expected or just before it, and every other time the
        // middle, so that a bad guess costs little
        let expected = guess(&before, high).filter(|_| is_guessed);
        let beside = expected.map(|place| [place + 0.4 * tolerance, place - 0.4 * tolerance]);
        let place = beside
            .into_iter()
            .flatten()
            .find(|place| *place > low && *place < high);
        is_guessed = !is_guessed;
        match next(&before, place.unwrap_or(0.5 * (low + high))) {
            Some(found) if is_as_before(&found) => before = found,
            Some(found) => after = found,
            None => break,
        }
    }
    after
}
