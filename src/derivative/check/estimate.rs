//! Differences extrapolated to steps of 0 (Richardson 1911), with an estimate of what is left of truncation and rounding
//! (after Ridders 1982: what the last orders change the result by).

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
    /// The powers of the step that the error of a difference grows with: 2, 4, 6 … or 1, 2, 3 ….
    fn power(self) -> i32 {
        if self == Self::Both { 2 } else { 1 }
    }

    /// Most differences that are combined: an error of h⁸ is left, of either kind.
    fn most(self) -> usize {
        if self == Self::Both { 4 } else { 8 }
    }
}

/// A difference over a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Difference {
    pub step: f64,
    pub value: f64,
    /// How much of it may be rounding.
    pub rounding: f64,
}

/// A derivative from differences.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The derivative.
    pub value: f64,
    /// How far off it may be, by truncation and rounding.
    pub uncertainty: f64,
}

impl Estimate {
    /// Whether both may be of the same number.
    fn agrees_with(&self, other: &Self) -> bool {
        (self.value - other.value).abs() <= 2.0 * (self.uncertainty + other.uncertainty)
    }
}

/// The best estimate of all stretches of consecutive differences. A derivative is the limit of small steps: it goes from small steps to
/// large ones, and ends where one is no further off than is enough, or where larger steps contradict smaller ones beyond what both may
/// be off.
pub(super) fn estimate(differences: &[Option<Difference>], side: Side, enough: f64) -> Option<Estimate> {
    let mut best: Option<Estimate> = None;
    for first in (0..differences.len()).rev() {
        for count in 2..=side.most().min(differences.len() - first) {
            let stretch = differences[first..first + count].iter().copied().collect::<Option<Vec<_>>>();
            let Some(found) = stretch.map(|stretch| extrapolated(&stretch, side)) else { continue };
            match best {
                Some(finer) if !finer.agrees_with(&found) => return best,
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
    let (value, rounding) = at_zero(differences, side);
    let (without_largest, _) = at_zero(&differences[1..], side);
    let (without_smallest, _) = at_zero(&differences[..differences.len() - 1], side);
    let truncation = (value - without_largest).abs().max((value - without_smallest).abs());
    Estimate { value, uncertainty: truncation + rounding }
}

/// The value at 0 of the polynomial in hᵖ through the differences, after Lagrange, and what their rounding makes of it.
fn at_zero(differences: &[Difference], side: Side) -> (f64, f64) {
    let power = side.power();
    let (mut value, mut rounding) = (0.0, 0.0);
    for (j, this) in differences.iter().enumerate() {
        let others = differences.iter().enumerate().filter(|(k, _)| *k != j);
        let own = this.step.powi(power);
        let weight: f64 = others.map(|(_, other)| other.step.powi(power)).map(|other| other / (other - own)).product();
        value += weight * this.value;
        rounding += weight.abs() * this.rounding;
    }
    (value, rounding)
}

#[cfg(test)]
mod tests {
    use super::super::{Ladder, STEPS};
    use super::{Difference, Side, estimate};

    #[test]
    fn exact_polynomials_are_extrapolated_to_the_last_digits() {
        // central differences of x⁷ at 1: 7 + 35 h² + 21 h⁴ + h⁶, of which four steps leave nothing
        let d = |h: f64| 7.0 + 35.0 * h.powi(2) + 21.0 * h.powi(4) + h.powi(6);
        let steps = [0.4, 0.2, 0.1, 0.05].map(|h| Some(Difference { step: h, value: d(h), rounding: 1e-16 / h }));
        let found = estimate(&steps, Side::Both, 0.0).unwrap();
        assert!((found.value - 7.0).abs() < 1e-13 && found.uncertainty < 1e-3, "{found:?}");
    }

    #[test]
    fn exact_uncertainties_hold_the_truth_for_functions_of_every_kind() {
        type Case = (&'static str, fn(f64) -> f64, f64, f64);
        let cases: [Case; 6] = [
            ("exp", f64::exp, 0.7, 0.7_f64.exp()),
            ("sin at a top", f64::sin, std::f64::consts::FRAC_PI_2, std::f64::consts::FRAC_PI_2.cos()),
            ("large offset", |x| 1e8 + x * x, 1.5, 3.0),
            ("steep", |x| (20.0 * x).tanh(), 0.02, 20.0 / 0.4_f64.cosh().powi(2)),
            ("constant", |_| 3.0, 1.0, 0.0),
            ("a ripple far below the first step", |x| x + 1e-7 * (1e4 * x).sin(), 0.0, 1.001),
        ];
        for (name, f, at, exact) in cases {
            let scale = if at == 0.0 { 1.0 } else { at };
            let ladder = Ladder::sample(at, scale, STEPS, &mut |x| vec![f(x)]).pop().unwrap();
            let found = ladder.slope(Side::Both, 0.0).unwrap();
            assert!((found.value - exact).abs() <= 2.0 * found.uncertainty, "{name}: {found:?} against {exact}");
            assert!(found.uncertainty <= 1e-6 * exact.abs().max(1.0), "{name}: {found:?}");
        }
    }
}
