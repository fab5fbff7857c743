use super::strokes::Strokes;
use crate::derivative::Order;
use crate::drive::Outcome;
use crate::number::Taylor;
use crate::parameters::Parameter;
use crate::statistics::extent;
use crate::units::{DisplayUnit, Quantity};

/// A statistic of the drives of all scenarios.
#[derive(Clone, Debug, PartialEq)]
pub enum Measure {
    /// The mean of an outcome.
    Mean(Outcome),
    /// Standard deviation of an outcome.
    Deviation(Outcome),
    /// Root mean square of an outcome.
    RootMeanSquare(Outcome),
    /// Conditional value at risk: mean of an outcome over the drives with the lowest values. The
    /// number is the share of these drives in all drives. The search smooths the mean (after Chen &
    /// Harker 1993; Kanzow 1996; Smale 1987).
    Lowest(Outcome, f64),
    /// Mean of an outcome over the drives with the highest values. The number is the share of these
    /// drives in all drives.
    Highest(Outcome, f64),
    /// Share of drives whose outcome is within this distance of 0. The search smooths the jump at
    /// either limit over one display unit.
    Within(Outcome, f64),
    /// Expected strokes to hole out from the ball's final position, on a hole of this length, m.
    Strokes(Strokes, f64),
    /// A parameter of the design, which is equal for all drives.
    Parameter(&'static Parameter),
    /// The constant 1.
    One,
}

/// Deviation whose square is added to a variance or a mean square, in the display unit of the
/// outcome. The square root of the sum is smooth at 0.
const LEAST_DEVIATION: f64 = 1e-9;
/// Smoothing width of [`LowestShare`], in the display unit of the outcome.
const SMOOTHING: f64 = 0.1;

impl Measure {
    /// Outcomes that the measure needs.
    pub fn outcomes(&self) -> Vec<Outcome> {
        match self {
            Self::Mean(of)
            | Self::Deviation(of)
            | Self::RootMeanSquare(of)
            | Self::Lowest(of, _)
            | Self::Highest(of, _)
            | Self::Within(of, _) => vec![*of],
            Self::Strokes(strokes, _) => strokes.outcomes.to_vec(),
            Self::Parameter(_) | Self::One => vec![],
        }
    }

    /// Physical quantity of the measure, with its display unit.
    pub fn unit(&self) -> DisplayUnit {
        match self {
            Self::Within(..) | Self::Strokes(..) | Self::One => DisplayUnit {
                quantity: Quantity::NUMBER,
                unit: "",
            },
            Self::Parameter(parameter) => (*parameter).into(),
            _ => self.outcomes()[0].into(),
        }
    }

    /// True if the measure has a kink or jump as a function of a drive's outcome.
    pub(in crate::study) fn has_edge(&self) -> bool {
        matches!(
            self,
            Self::Lowest(..) | Self::Highest(..) | Self::Within(..)
        )
    }

    /// The exact measure, without smoothing. `columns` has, for each outcome of the measure, its
    /// values in all scenarios. The result is 0 for `Parameter` and `One`, which have no outcomes;
    /// the search evaluates them itself.
    pub(in crate::study) fn exact(&self, columns: &[&[f64]], weights: &[f64]) -> f64 {
        let each = || columns[0].iter().copied().zip(weights.iter().copied());
        let mean = |f: &dyn Fn(f64) -> f64| each().map(|(x, weight)| weight * f(x)).sum::<f64>();
        match self {
            Self::Mean(_) => mean(&|x| x),
            Self::Deviation(_) => {
                let centre = mean(&|x| x);
                mean(&|x| (x - centre).powi(2)).sqrt()
            }
            Self::RootMeanSquare(_) => mean(&|x| x * x).sqrt(),
            Self::Lowest(_, share) => lowest_mean(each(), *share),
            Self::Highest(_, share) => -lowest_mean(each().map(|(x, weight)| (-x, weight)), *share),
            Self::Within(_, half) => mean(&|x| f64::from(u8::from(x.abs() <= *half))),
            Self::Strokes(strokes, hole) => {
                let left = columns[0]
                    .iter()
                    .zip(columns[1])
                    .map(|(downrange, right)| (hole - downrange).hypot(*right));
                left.zip(weights)
                    .map(|(left, weight)| weight * strokes.at(left)[0])
                    .sum()
            }
            Self::Parameter(_) | Self::One => 0.0,
        }
    }

    /// The measure with smoothed kinks and jumps, and its derivatives up to `order`. `drives` has
    /// the measure's outcomes in each scenario. A missing Hessian of an outcome counts as 0. The
    /// result is 0 for `Parameter` and `One`, which have no outcomes; the search evaluates them
    /// itself.
    pub(in crate::study) fn smoothed(
        &self,
        drives: &[Vec<&Taylor>],
        weights: &[f64],
        order: Order,
    ) -> Taylor {
        let first = drives.iter().filter_map(|outcomes| outcomes.first());
        let each: Vec<(&Taylor, f64)> = first.copied().zip(weights.iter().copied()).collect();
        let one = |of: &Outcome| DisplayUnit::from(*of).size();
        let is_second = order == Order::Second;
        let sum = |h: &dyn Fn(f64) -> [f64; 3]| {
            let terms = each
                .iter()
                .map(|(f, weight)| (*f, h(f.value).map(|part| weight * part)));
            summed(terms, &[], is_second)
        };
        let lowest = |sign: f64, of: &Outcome, share: f64| {
            let share = LowestShare {
                drives: &each,
                sign,
                share,
                smoothing: SMOOTHING * one(of),
            };
            share.mean(is_second)
        };
        match self {
            Self::Mean(_) => sum(&|f| [f, 1.0, 0.0]),
            Self::Deviation(of) => deviation(&each, LEAST_DEVIATION * one(of), is_second),
            Self::RootMeanSquare(of) => {
                root(&sum(&|f| [f * f, 2.0 * f, 2.0]), LEAST_DEVIATION * one(of))
            }
            Self::Lowest(of, share) => lowest(1.0, of, *share),
            Self::Highest(of, share) => lowest(-1.0, of, *share).negated(),
            Self::Within(of, half) => sum(&|f| within(f, *half, one(of))),
            Self::Strokes(strokes, hole) => {
                let strokes = drives
                    .iter()
                    .map(|end| strokes.from(end[0], end[1], *hole, is_second));
                let strokes: Vec<_> = strokes.zip(weights).collect();
                Taylor::sum(strokes.iter().map(|(strokes, weight)| (strokes, **weight)))
            }
            Self::Parameter(_) | Self::One => Taylor::default(),
        }
    }
}

/// Sum over the drives k of hₖ(fₖ − m), where fₖ is an outcome of drive k, and m is a centre, such
/// as the mean. `terms` has fₖ with its derivatives, and the values hₖ, hₖ′ and hₖ″. `centre` is
/// ∇m, or empty without a centre. The second derivatives of a mean m are not needed, because their
/// factor Σ hₖ′ is 0.
///
/// ```text
///   value    = Σ hₖ
///   gradient = Σ hₖ′ (∇fₖ − ∇m)
///   Hessian  = Σ hₖ″ (∇fₖ − ∇m)(∇fₖ − ∇m)ᵀ + Σ hₖ′ ∇²fₖ, without the last term if ∇²fₖ is missing
/// ```
fn summed<'a>(
    terms: impl Iterator<Item = (&'a Taylor, [f64; 3])>,
    centre: &[f64],
    is_second: bool,
) -> Taylor {
    let mut all: Option<Taylor> = None;
    for (f, [value, slope, curvature]) in terms {
        let n = f.gradient.len();
        let sum = all.get_or_insert_with(|| Taylor::zero(n, if is_second { n } else { 0 }));
        let change = |i: usize| f.gradient[i] - centre.get(i).copied().unwrap_or_default();
        sum.value += value;
        for i in 0..n {
            sum.gradient[i] += slope * change(i);
        }
        for (i, row) in sum.hessian.iter_mut().enumerate() {
            let along = curvature * change(i);
            row.iter_mut()
                .enumerate()
                .for_each(|(j, second)| *second += along * change(j));
        }
        for (row, seconds) in sum.hessian.iter_mut().zip(&f.hessian) {
            row.iter_mut()
                .zip(seconds)
                .for_each(|(sum, second)| *sum += slope * second);
        }
    }
    all.unwrap_or_default()
}

/// Mean of the lowest values, up to a total weight of `share`. `drives` has the value and the
/// weight of each drive. The last drive counts only with the part of its weight that completes the
/// share.
fn lowest_mean(drives: impl Iterator<Item = (f64, f64)>, share: f64) -> f64 {
    let mut sorted: Vec<_> = drives.collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut counted, mut sum) = (0.0, 0.0);
    for (value, weight) in sorted {
        let part = weight.min(share - counted);
        counted += part;
        sum += part * value;
    }
    sum / counted
}

/// Standard deviation of weighted drives, smoothed at 0.
fn deviation(drives: &[(&Taylor, f64)], least: f64, is_second: bool) -> Taylor {
    let weighted = drives.iter().map(|(f, w)| (*f, [w * f.value, *w, 0.0]));
    let mean = summed(weighted, &[], false);
    // the Hessian of the mean is not needed, because its factor Σ w (f − mean) is 0
    let squares = drives.iter().map(|(f, w)| {
        let off = f.value - mean.value;
        (*f, [w * off * off, 2.0 * w * off, 2.0 * w])
    });
    root(&summed(squares, &mean.gradient, is_second), least)
}

/// √(f + `least`²).
fn root(f: &Taylor, least: f64) -> Taylor {
    let root = (f.value + least * least).sqrt();
    f.chained([root, 0.5 / root, -0.25 / root.powi(3)])
}

/// Smoothed indicator of −`half` ≤ f ≤ `half`, with two derivatives by f: σ((`half` − f)/`edge`) −
/// σ((−`half` − f)/`edge`) with the logistic function σ.
fn within(f: f64, half: f64, edge: f64) -> [f64; 3] {
    let at = |end: f64| {
        let s = 1.0 / (1.0 + ((f - end) / edge).exp());
        let slope = s * (1.0 - s) / edge;
        [s, -slope, slope * (1.0 - 2.0 * s) / edge]
    };
    let (above, below) = (at(half), at(-half));
    std::array::from_fn(|k| above[k] - below[k])
}

/// The mean of the lowest values of weighted drives, which have the share α of the total weight.
/// Drive k has the weight wₖ, and the value uₖ is its outcome times `sign`.
///
/// The smoothed mean is the maximum over t of G(t) = t − 1/α Σ wₖ φ(t − uₖ), with
/// φ(z) = (z + √(z² + 4ε²))/2. For ε → 0, it is the exact mean.
struct LowestShare<'a> {
    /// Outcome, with derivatives up to the required order, and weight of each drive.
    drives: &'a [(&'a Taylor, f64)],
    /// 1 for the mean of the lowest values, −1 for the mean of the highest values.
    sign: f64,
    /// α.
    share: f64,
    /// ε.
    smoothing: f64,
}

impl LowestShare<'_> {
    /// The smoothed mean. At the maximum ∂G/∂t = 0, so the gradient does not depend on the change
    /// of t. The Hessian includes this change.
    fn mean(&self, is_second: bool) -> Taylor {
        let t = self.threshold();
        let terms = self.drives.iter().map(|(f, weight)| {
            let [value, slope, curvature] = self.smoothed_positive_part(t - self.sign * f.value);
            // derivatives of −φ(t − u) by f
            let by_f = [-value, self.sign * slope, -curvature];
            (*f, by_f.map(|part| weight / self.share * part))
        });
        let mut mean = summed(terms, &[], is_second);
        mean.value += t;
        self.add_threshold_change(t, &mut mean.hessian);
        mean
    }

    /// φ, φ′ and φ″: the smoothed positive part of z.
    fn smoothed_positive_part(&self, z: f64) -> [f64; 3] {
        let smoothing = self.smoothing;
        let width = (z * z + 4.0 * smoothing * smoothing).sqrt();
        [
            0.5 * (z + width),
            0.5 * (1.0 + z / width),
            2.0 * smoothing * smoothing / width.powi(3),
        ]
    }

    /// The t at which G is maximal. It is the zero of the excess Σ wₖ φ′(t − uₖ) − α, which rises
    /// with t from −α to 1 − α. Bisection finds it to the last bit.
    fn threshold(&self) -> f64 {
        let excess = |t: f64| {
            let weighted = |(f, weight): &(&Taylor, f64)| {
                weight * self.smoothed_positive_part(t - self.sign * f.value)[1]
            };
            self.drives.iter().map(weighted).sum::<f64>() - self.share
        };
        let values = self.drives.iter().map(|(f, _)| self.sign * f.value);
        let [mut low, mut high] = extent(values);
        let mut reach = self.smoothing;
        while excess(low) > 0.0 {
            low -= reach;
            reach *= 2.0;
        }
        reach = self.smoothing;
        while excess(high) < 0.0 {
            high += reach;
            reach *= 2.0;
        }
        loop {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                return middle;
            }
            if excess(middle) > 0.0 {
                high = middle
            } else {
                low = middle
            }
        }
    }

    /// Adds the term of the Hessian that arises because t changes with the variables x:
    /// (∂²G/∂t∂x)(∂²G/∂t∂x)ᵀ / (−∂²G/∂t²).
    fn add_threshold_change(&self, t: f64, hessian: &mut [Vec<f64>]) {
        let curvatures: Vec<f64> = self
            .drives
            .iter()
            .map(|(f, weight)| {
                weight / self.share * self.smoothed_positive_part(t - self.sign * f.value)[2]
            })
            .collect();
        let curvature: f64 = curvatures.iter().sum();
        // ∂²G/∂t∂x up to the sign, which cancels in the product
        let mixed = |i: usize| {
            let drives = curvatures.iter().zip(self.drives);
            drives
                .map(|(curvature, (f, _))| curvature * f.gradient[i])
                .sum()
        };
        let mixed: Vec<f64> = (0..hessian.len()).map(mixed).collect();
        for (row, across) in hessian.iter_mut().zip(&mixed) {
            for (second, along) in row.iter_mut().zip(&mixed) {
                *second += across * along / curvature;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Measure, Order, Taylor};
    use crate::drive::Outcome;
    use crate::number::{Jet, Mixed, Numbers};

    /// "Drive" `k` of ten: a smooth function of two variables.
    fn drive(k: usize, x: Mixed, y: Mixed) -> Mixed {
        let k = k as f64;
        Numbers::sin(x * (1.0 + 0.1 * k)) * 20.0 + y * x * (k - 4.0) + y * y * 3.0 + k * k * 0.3
    }

    /// A number with derivative 1 in the first direction if `first`, and in the second if `second`.
    fn mixed(value: f64, first: bool, second: bool) -> Mixed {
        let change = |is: bool| f64::from(u8::from(is));
        Jet {
            re: Jet {
                re: value,
                gradient: [change(first)],
            },
            gradient: [Jet {
                re: change(second),
                gradient: [0.0],
            }],
        }
    }

    fn taylors(at: [f64; 2]) -> Vec<Taylor> {
        let one = |k: usize| {
            let second = |i: usize, j: usize| {
                drive(
                    k,
                    mixed(at[0], i == 0, j == 0),
                    mixed(at[1], i == 1, j == 1),
                )
            };
            Taylor {
                value: second(0, 0).re.re,
                gradient: (0..2).map(|i| second(i, i).re.gradient[0]).collect(),
                hessian: (0..2)
                    .map(|i| {
                        (0..2)
                            .map(|j| second(i, j).gradient[0].gradient[0])
                            .collect()
                    })
                    .collect(),
            }
        };
        (0..10).map(one).collect()
    }

    fn measured(measure: &Measure, at: [f64; 2]) -> Taylor {
        let taylors = taylors(at);
        let drives: Vec<Vec<&Taylor>> = taylors.iter().map(|taylor| vec![taylor]).collect();
        let weights: Vec<f64> = (0..10).map(|k| f64::from(k + 1) / 55.0).collect();
        measure.smoothed(&drives, &weights, Order::Second)
    }

    /// Compares gradients and Hessians of every measure of one outcome with central differences of
    /// its values and gradients.
    #[test]
    fn differences_certify_the_derivatives_of_every_measure() {
        let of = Outcome::Lateral;
        let all = [
            Measure::Mean(of),
            Measure::Deviation(of),
            Measure::RootMeanSquare(of),
            Measure::Lowest(of, 0.2),
            Measure::Highest(of, 0.35),
            Measure::Within(of, 9.0),
        ];
        let at = [0.7, -0.4];
        for measure in all {
            let here = measured(&measure, at);
            for i in 0..2 {
                let h = 1e-4;
                let beside = [-2.0, -1.0, 1.0, 2.0].map(|side| {
                    let mut moved = at;
                    moved[i] += side * h;
                    measured(&measure, moved)
                });
                let slope = |f: &dyn Fn(&Taylor) -> f64| {
                    let [a, b, c, d] = [&beside[0], &beside[1], &beside[2], &beside[3]].map(f);
                    (a - 8.0 * b + 8.0 * c - d) / (12.0 * h)
                };
                let size = here.value.abs().max(1.0);
                assert!(
                    (slope(&|f| f.value) - here.gradient[i]).abs() < 1e-8 * size,
                    "{measure:?}"
                );
                for j in 0..2 {
                    let difference = slope(&|f| f.gradient[j]) - here.hessian[i][j];
                    assert!(
                        difference.abs() < 1e-7 * size * 10.0,
                        "{measure:?} {i}{j}: {difference}"
                    );
                }
            }
        }
    }

    /// Compares the exact and the smoothed form of each measure with its definition, for ten
    /// numbers of equal weight.
    #[test]
    fn exact_measures_of_ten_numbers() {
        let values: Vec<f64> = taylors([0.7, -0.4])
            .iter()
            .map(|taylor| taylor.value)
            .collect();
        let taylors: Vec<Taylor> = values
            .iter()
            .map(|value| Taylor {
                value: *value,
                ..Taylor::default()
            })
            .collect();
        let drives: Vec<Vec<&Taylor>> = taylors.iter().map(|taylor| vec![taylor]).collect();
        let mean = values.iter().sum::<f64>() / 10.0;
        let about = |centre: f64| {
            (values
                .iter()
                .map(|value| (value - centre).powi(2))
                .sum::<f64>()
                / 10.0)
                .sqrt()
        };
        let mut sorted = values.clone();
        sorted.sort_by(f64::total_cmp);
        let low = sorted[..2].iter().sum::<f64>() / 2.0;
        // the highest third of ten numbers: three numbers, and a third of the fourth
        let high = (sorted[7..].iter().sum::<f64>() + sorted[6] / 3.0) / (10.0 / 3.0);
        let inside = values.iter().filter(|value| value.abs() <= 9.0).count() as f64 / 10.0;
        let of = Outcome::Carry;
        let cases = [
            (Measure::Mean(of), mean, 1e-13),
            (Measure::Deviation(of), about(mean), 1e-12),
            (Measure::RootMeanSquare(of), about(0.0), 1e-12),
            // smoothing shifts the mean, because φ(z) exceeds max(z, 0) near z = 0
            (Measure::Lowest(of, 0.2), low, 0.1),
            (Measure::Highest(of, 1.0 / 3.0), high, 0.1),
            (Measure::Within(of, 9.0), inside, 0.1),
        ];
        for (measure, expected, smoothing) in cases {
            let exact = measure.exact(&[&values], &[0.1; 10]);
            assert!(
                (exact - expected).abs() < 1e-13 * expected.abs().max(1.0),
                "{measure:?}: {exact} {expected}"
            );
            let smoothed = measure.smoothed(&drives, &[0.1; 10], Order::Value).value;
            assert!(
                (smoothed - expected).abs() < smoothing,
                "{measure:?}: {smoothed} {expected}"
            );
        }
    }

    /// All drives are equal, so the mean of every share is their common value, for any weights.
    #[test]
    fn exact_shares_of_identical_drives() {
        let weights = [0.5, 0.25, 0.15, 0.1];
        for share in [0.05, 0.1, 0.6, 0.99] {
            for measure in [
                Measure::Lowest(Outcome::LaunchAngle, share),
                Measure::Highest(Outcome::LaunchAngle, share),
            ] {
                let value = measure.exact(&[&[12.7; 4]], &weights);
                assert!((value - 12.7).abs() < 1e-14, "{measure:?}: {value}");
            }
        }
    }
}
