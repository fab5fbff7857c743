//! Continuation of an optimum along a parameter: adaptive steps, the predictor, and the search for
//! the parameter value at which a property of the optimum changes.

use super::domain::{Bounds, scaled_distance};

/// Longest step, as a fraction of the range.
pub(crate) const LONGEST: f64 = 1.0 / 16.0;
/// Shortest step, as a fraction of the range.
const SHORTEST: f64 = 1.0 / 65_536.0;
/// Largest accepted distance between the predicted and the corrected optimum, in units of the
/// variables' scales. If the distance is larger, the step is halved.
pub(crate) const TOO_FAR: f64 = 0.02;
/// If the predicted and the corrected optimum are closer than this distance, the next step is
/// doubled.
const NEAR: f64 = 0.002;
/// Trust-region radius of the corrector. It keeps the search at the followed optimum.
pub(crate) const RADIUS: f64 = 0.05;

/// Adaptive step length along a range, from the distance between predicted and corrected optima.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AdaptiveStep {
    width: f64,
    step: f64,
}

impl AdaptiveStep {
    /// Starts with the longest step for a range of this width.
    pub fn new(width: f64) -> Self {
        Self {
            width,
            step: LONGEST * width,
        }
    }

    /// Next parameter value, at most `end`.
    pub fn to(&self, here: f64, end: f64) -> f64 {
        // avoid a tiny last step
        if here + 1.001 * self.step >= end {
            end
        } else {
            here + self.step
        }
    }

    /// Halves the step. Returns false if the step is already the shortest.
    fn halve(&mut self) -> bool {
        let can = self.step > SHORTEST * self.width;
        if can {
            self.step *= 0.5;
        }
        can
    }

    /// Accepts or rejects the result of the corrector: the corrected optimum and its distance from
    /// the prediction. If the distance is too large or the corrector failed, halves the step and
    /// returns `None`. A failure after an interruption does not halve the step.
    ///
    /// If the step is already the shortest, an optimum is accepted at any distance.
    ///
    /// # Errors
    /// The error of the corrector, if the step is already the shortest.
    pub fn accept_or_halve<P, E>(
        &mut self,
        corrected: Result<(P, f64), E>,
        is_interrupted: bool,
    ) -> Result<Option<(P, f64)>, E> {
        match corrected {
            Ok((_, distance)) if distance > TOO_FAR && self.halve() => Ok(None),
            Err(_) if is_interrupted || self.halve() => Ok(None),
            corrected => corrected.map(Some),
        }
    }

    /// Doubles the step if the predicted optimum was near the corrected optimum.
    pub fn adapt(&mut self, distance: f64) {
        if distance < NEAR {
            self.step = (2.0 * self.step).min(LONGEST * self.width);
        }
    }
}

/// Predictor: the optimum, to first order, after the parameter p has changed by `change`. `rates`
/// is dx*/dp. The result is projected on the bounds.
pub(crate) fn predicted(x: &[f64], rates: &[f64], change: f64, bounds: &Bounds) -> Vec<f64> {
    let moved: Vec<f64> = x
        .iter()
        .zip(rates)
        .map(|(x, rate)| x + rate * change)
        .collect();
    bounds.project(&moved)
}

/// Distance of two points in the maximum norm, in units of the variables' scales at `x`.
pub(crate) fn relative_distance(x: &[f64], predicted: &[f64], bounds: &Bounds) -> f64 {
    scaled_distance(x, predicted, &bounds.scale(x))
}

/// Locates a change between the points `before` and `after` by bisection, and returns a point after
/// the change. The change is at most `tolerance` before this point. `is_as_before` is true for
/// points before the change, and `at` returns the location of a point. `guess` predicts the
/// location of the change. `next` computes the point at a location from an earlier point. If `next`
/// fails, returns the earliest known point after the change.
pub(crate) fn locate_change<P>(
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
        // try just after or just before the predicted location, alternating with bisection, so that
        // a bad prediction costs little
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_relative_distances_in_finite_and_infinite_ranges() {
        let distance = |low: f64, high: f64, x: f64, predicted: f64| {
            let bounds = Bounds::new(vec![low], vec![high]).unwrap();
            relative_distance(&[x], &[predicted], &bounds)
        };
        assert_eq!(distance(0.0, 4.0, 1.0, 2.0), 0.25);
        assert_eq!(distance(f64::NEG_INFINITY, f64::INFINITY, 0.5, 2.0), 1.5);
        assert_eq!(distance(0.0, f64::INFINITY, 8.0, 2.0), 0.75);
        assert_eq!(distance(1.0, 1.0, 1.0, 1.0), 0.0);
    }
}
