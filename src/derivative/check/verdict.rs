use super::ladder::{LEAST_STEP, rounding_of};
use super::{Estimate, Ladder, Side};

/// What differences say of an exact derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// It is not the slope of the function, or differences cannot tell.
    Fail,
    /// The function has a corner here, and no one slope.
    Corner,
    /// It is the slope of the function.
    Pass,
}

impl Verdict {
    /// Its name in JSON: `pass`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fail => "fail",
            Self::Corner => "corner",
            Self::Pass => "pass",
        }
    }
}

/// The error that a derivative may have, in estimated uncertainties of the differences it is held
/// against. The estimates are rough: of ten thousand right derivatives a few are off by more than
/// four.
pub const BAR: f64 = 5.0;

/// A derivative is next to nothing where the variable, moved by the whole of its scale, moves the
/// function by less than this part of it.
pub const NEXT_TO_NOTHING: f64 = 1e-2;

/// What is asked of differences.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Demand {
    /// The bar is not set below this part of a derivative, or of the size below which it is next to
    /// nothing: where a higher derivative jumps (as with a flight's number of steps) differences
    /// wobble by a little that no estimate from small steps shows.
    pub least_bar: f64,
    /// The relative error that they must be able to see, unless the derivative is next to nothing
    /// ([`NEXT_TO_NOTHING`]): then this part of the size below which it is.
    pub seen: Option<f64>,
}

impl Demand {
    /// Of differences of values: an error of a millionth is seen, with a hundredfold margin.
    pub const FIRST: Self = Self {
        least_bar: 1e-8,
        seen: Some(1e-6),
    };
    /// Of differences of gradients, whose own derivative may jump: what they can tell, they must.
    pub const SECOND: Self = Self {
        least_bar: 1e-7,
        seen: None,
    };
}

/// Rounding of the exact derivative itself, in sizes of the numbers that the function is computed
/// from over the scale.
const OWN_ROUNDING: f64 = 64.0 * f64::EPSILON;

/// One step of a V-curve: the error of the plain central difference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The step, in the variable's unit.
    pub step: f64,
    /// (f(x + h) − f(x − h))/2h.
    pub difference: f64,
    /// How far the exact derivative is from it.
    pub error: f64,
}

/// An exact derivative beside differences.
#[derive(Clone, Debug)]
pub struct Check {
    /// The derivative that is checked.
    pub exact: f64,
    /// The best that differences make of it; `None` where the function has values to neither side.
    pub best: Option<Estimate>,
    /// The slopes below and above, where they differ; `None` for a side to which the function has
    /// no values.
    pub sides: Option<[Option<f64>; 2]>,
    /// |exact − best|.
    pub error: f64,
    /// The error that it may have: [`BAR`] times the uncertainty of the differences, and no less
    /// than [`Demand::least_bar`] asks.
    pub bar: f64,
    /// The verdict.
    pub verdict: Verdict,
    /// The V-curve of plain central differences, the largest step first.
    pub curve: Vec<Point>,
}

impl Check {
    /// Whether differences do not show it to be the slope.
    pub fn failed(&self) -> bool {
        self.verdict == Verdict::Fail
    }

    /// The step at which a plain central difference comes nearest, and how near.
    pub fn best_step(&self) -> Option<Point> {
        self.curve
            .iter()
            .copied()
            .min_by(|a, b| a.error.total_cmp(&b.error))
    }
}

impl Ladder {
    /// Holds a derivative against the differences of the samples.
    pub fn judge(&self, exact: f64, demand: Demand) -> Check {
        let plain = |rung: &super::Rung| {
            let difference = self.difference(rung, Side::Both)?;
            Some(Point {
                step: rung.step,
                difference,
                error: (exact - difference).abs(),
            })
        };
        let curve = self.rungs.iter().filter_map(plain).collect();
        let sides = self.corner();
        let worth = exact.abs().max(self.next_to_nothing());
        let least = demand.least_bar * worth + OWN_ROUNDING * self.rounded / self.scale;
        let bar_of = |best: &Estimate| least.max(BAR * best.uncertainty);
        let is_seen = |bar: f64| demand.seen.is_none_or(|seen| bar <= seen * worth);
        // differences to one side see what central ones do not: a slope whose own slope jumps here
        let estimates =
            [Side::Both, Side::Above, Side::Below].map(|side| self.slope(side, least / BAR));
        let estimates = || estimates.iter().flatten().copied();
        let best = estimates()
            .find(|best| is_seen(bar_of(best)))
            .or_else(|| estimates().min_by(|a, b| a.uncertainty.total_cmp(&b.uncertainty)));
        let error = best.map_or(f64::INFINITY, |best| (exact - best.value).abs());
        let bar = best.as_ref().map_or(0.0, bar_of);
        let verdict = if sides.is_some() {
            Verdict::Corner
        } else if error <= bar && is_seen(bar) {
            Verdict::Pass
        } else {
            Verdict::Fail
        };
        Check {
            exact,
            best,
            sides,
            error,
            bar,
            verdict,
            curve,
        }
    }

    /// The same of a function that is known to have a corner here. At the end of its range it has
    /// one of the two slopes, and a derivative that lies between them is not held against that one.
    pub fn judge_on_a_corner(&self, exact: f64, demand: Demand) -> Check {
        let check = self.judge(exact, demand);
        let sides =
            [Side::Below, Side::Above].map(|side| self.slope(side, 0.0).map(|slope| slope.value));
        if check.failed() && sides.iter().flatten().count() == 1 {
            Check {
                sides: Some(sides),
                verdict: Verdict::Corner,
                ..check
            }
        } else {
            check
        }
    }

    /// The size below which a derivative is next to nothing.
    pub fn next_to_nothing(&self) -> f64 {
        NEXT_TO_NOTHING * self.size / self.scale
    }

    /// The slopes to both sides, where they are not the same: by more than rounding of the numbers
    /// that the function is computed from makes of slopes over the least step. Where these cancel,
    /// no difference from the centre over the smallest steps may show their rounding.
    fn corner(&self) -> Option<[Option<f64>; 2]> {
        let (below, above) = (self.slope(Side::Below, 0.0)?, self.slope(Side::Above, 0.0)?);
        let apart = (above.value - below.value).abs();
        let size = above.value.abs().max(below.value.abs());
        let rounding = rounding_of(self.rounded) / (LEAST_STEP * self.scale);
        let bar = (10.0 * (above.uncertainty + below.uncertainty))
            .max(1e-4 * size)
            .max(rounding);
        (apart > bar).then_some([Some(below.value), Some(above.value)])
    }
}
