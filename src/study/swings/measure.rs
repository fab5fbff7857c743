use super::chained::chained;
use super::strokes::Strokes;
use crate::drive::Outcome;
use crate::number::Taylor;
use crate::parameters::Parameter;
use crate::units::Quantity;

/// A number that is made of the drives of all scenarios.
#[derive(Clone, Debug, PartialEq)]
pub enum Measure {
    /// The mean of an outcome.
    Mean(Outcome),
    /// Its standard deviation.
    Deviation(Outcome),
    /// The root of the mean of its square.
    RootMeanSquare(Outcome),
    /// The mean of its lowest share: the conditional value at risk, smoothed (after Chen & Harker 1993; Kanzow 1996; Smale 1987).
    Lowest(Outcome, f64),
    /// The mean of its highest share.
    Highest(Outcome, f64),
    /// The share of drives within so much of 0, of which each counts by how far inside it is: the edges are as wide as a unit.
    Within(Outcome, f64),
    /// Expected strokes to hole out from where the ball ends, on a hole of a length, m.
    Strokes(Strokes, f64),
    /// A parameter of the design: no drive changes it.
    Parameter(&'static Parameter),
    /// 1: a term that nothing changes.
    One,
}

/// A standard deviation below this part of a unit is none: it keeps the root smooth.
const LEAST_DEVIATION: f64 = 1e-9;
/// How much the edge of a lowest or highest share is smoothed, in units of the outcome.
const SMOOTHING: f64 = 0.1;

impl Measure {
    /// The outcomes that it needs.
    pub fn outcomes(&self) -> Vec<Outcome> {
        match self {
            Self::Mean(of)
            | Self::Deviation(of)
            | Self::RootMeanSquare(of)
            | Self::Lowest(of, _)
            | Self::Highest(of, _)
            | Self::Within(of, _) => vec![*of],
            Self::Strokes(strokes, _) => strokes.outcomes().to_vec(),
            Self::Parameter(_) | Self::One => vec![],
        }
    }

    /// What kind of number it is.
    pub fn quantity(&self) -> Quantity {
        match self {
            Self::Within(..) | Self::Strokes(..) | Self::One => Quantity::NUMBER,
            Self::Parameter(parameter) => parameter.quantity,
            _ => self.outcomes()[0].quantity(),
        }
    }

    /// The unit that it is shown in.
    pub fn unit(&self) -> &'static str {
        match self {
            Self::Within(..) | Self::Strokes(..) | Self::One => "",
            Self::Parameter(parameter) => parameter.unit,
            _ => self.outcomes()[0].unit(),
        }
    }

    /// The measure from its outcomes in each scenario, and the weights of these: exact value, gradient and Hessian, as far as the
    /// outcomes have these. Parameters of the design are none of theirs: they are 0 here.
    pub(super) fn of(&self, drives: &[Vec<&Taylor>], weights: &[f64]) -> Taylor {
        let each = || drives.iter().map(|outcomes| outcomes[0]).zip(weights.iter().copied());
        let one = |of: &Outcome| of.quantity().size_of(of.unit()).unwrap_or(1.0);
        match self {
            Self::Mean(_) => Taylor::sum(each()),
            Self::Deviation(of) => {
                let mean = Taylor::sum(each());
                // of the difference from the mean the square, whose slope by the mean is 0 in the sum
                let squares = each().map(|(drive, weight)| (square(&minus(drive, &mean)), weight)).collect::<Vec<_>>();
                root(&Taylor::sum(squares.iter().map(|(drive, weight)| (drive, *weight))), LEAST_DEVIATION * one(of))
            }
            Self::RootMeanSquare(of) => {
                let squares = each().map(|(drive, weight)| (square(drive), weight)).collect::<Vec<_>>();
                root(&Taylor::sum(squares.iter().map(|(drive, weight)| (drive, *weight))), LEAST_DEVIATION * one(of))
            }
            Self::Lowest(of, share) => lowest(&each().collect::<Vec<_>>(), *share, SMOOTHING * one(of)),
            Self::Highest(of, share) => {
                let negated: Vec<_> = each().map(|(drive, weight)| (drive.clone().negated(), weight)).collect();
                let negated: Vec<_> = negated.iter().map(|(drive, weight)| (drive, *weight)).collect();
                lowest(&negated, *share, SMOOTHING * one(of)).negated()
            }
            Self::Within(of, half) => {
                let scores = each().map(|(drive, weight)| (within(drive, *half, one(of)), weight)).collect::<Vec<_>>();
                Taylor::sum(scores.iter().map(|(drive, weight)| (drive, *weight)))
            }
            Self::Strokes(strokes, hole) => {
                let strokes = drives.iter().map(|outcomes| strokes.from(outcomes[0], outcomes[1], *hole));
                let strokes: Vec<_> = strokes.zip(weights).collect();
                Taylor::sum(strokes.iter().map(|(strokes, weight)| (strokes, **weight)))
            }
            Self::Parameter(_) | Self::One => Taylor::default(),
        }
    }
}

fn minus(a: &Taylor, b: &Taylor) -> Taylor {
    Taylor::sum([(a, 1.0), (b, -1.0)])
}

fn square(f: &Taylor) -> Taylor {
    chained(f, [f.value * f.value, 2.0 * f.value, 2.0])
}

/// √(f + η²).
fn root(f: &Taylor, least: f64) -> Taylor {
    let root = (f.value + least * least).sqrt();
    chained(f, [root, 0.5 / root, -0.25 / root.powi(3)])
}

/// σ((h − f)/e) − σ((−h − f)/e) with the logistic σ.
fn within(f: &Taylor, half: f64, edge: f64) -> Taylor {
    let at = |end: f64| {
        let s = 1.0 / (1.0 + ((f.value - end) / edge).exp());
        let slope = s * (1.0 - s) / edge;
        [s, -slope, slope * (1.0 - 2.0 * s) / edge]
    };
    let (above, below) = (at(half), at(-half));
    chained(f, std::array::from_fn(|k| above[k] - below[k]))
}

/// max over t of t − 1/α Σ wₖ φ(t − fₖ), φ(z) = (z + √(z² + 4ε²))/2: for ε → 0 the mean of the lowest share α.
///
/// At the maximum the slope by t is 0, so that gradients are those at a fixed t; the Hessian has the way that t moves.
fn lowest(drives: &[(&Taylor, f64)], share: f64, smoothing: f64) -> Taylor {
    let plus = |z: f64| {
        let width = (z * z + 4.0 * smoothing * smoothing).sqrt();
        [0.5 * (z + width), 0.5 * (1.0 + z / width), 2.0 * smoothing * smoothing / width.powi(3)]
    };
    let excess = |t: f64| drives.iter().map(|(f, weight)| weight * plus(t - f.value)[1]).sum::<f64>() - share;
    // it rises with t from −α to 1 − α: halved to the last bit
    let ends = |start: f64, pick: fn(f64, f64) -> f64| drives.iter().map(|(f, _)| f.value).fold(start, pick);
    let (mut low, mut high) = (ends(f64::INFINITY, f64::min), ends(f64::NEG_INFINITY, f64::max));
    let mut reach = smoothing;
    while excess(low) > 0.0 {
        low -= reach;
        reach *= 2.0;
    }
    reach = smoothing;
    while excess(high) < 0.0 {
        high += reach;
        reach *= 2.0;
    }
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if excess(middle) > 0.0 { high = middle } else { low = middle }
    }
    let t = 0.5 * (low + high);
    let parts = drives.iter().map(|(f, weight)| {
        let [value, slope, bend] = plus(t - f.value);
        // −φ(t − f) by f
        (chained(f, [-value, slope, -bend]), weight / share)
    });
    let parts: Vec<_> = parts.collect();
    let mut all = Taylor::sum(parts.iter().map(|(part, weight)| (part, *weight)));
    all.value += t;
    let bends: Vec<f64> = drives.iter().map(|(f, weight)| weight / share * plus(t - f.value)[2]).collect();
    let bend: f64 = bends.iter().sum();
    // ∂²/∂t∂x
    let mixed = |i: usize| bends.iter().zip(drives).map(|(bend, (f, _))| bend * f.gradient[i]).sum::<f64>();
    let mixed: Vec<f64> = (0..all.gradient.len()).map(mixed).collect();
    for (row, across) in all.hessian.iter_mut().zip(&mixed) {
        row.iter_mut().zip(&mixed).for_each(|(second, along)| *second += across * along / bend);
    }
    all
}

#[cfg(test)]
mod tests {
    use super::{Measure, Taylor};
    use crate::drive::Outcome;
    use crate::number::{Jet, Mixed, Numbers};

    /// Ten "drives" that are smooth functions of two variables.
    fn drive(k: usize, x: Mixed, y: Mixed) -> Mixed {
        let k = k as f64;
        Numbers::sin(x * (1.0 + 0.1 * k)) * 20.0 + y * x * (k - 4.0) + y * y * 3.0 + k * k * 0.3
    }

    /// A value that changes in the first, the second, or both of two directions.
    fn mixed(value: f64, first: bool, second: bool) -> Mixed {
        let change = |is: bool| f64::from(u8::from(is));
        Jet {
            re: Jet { re: value, gradient: [change(first)] },
            gradient: [Jet { re: change(second), gradient: [0.0] }],
        }
    }

    fn taylors(at: [f64; 2]) -> Vec<Taylor> {
        let one = |k: usize| {
            let second = |i: usize, j: usize| drive(k, mixed(at[0], i == 0, j == 0), mixed(at[1], i == 1, j == 1));
            Taylor {
                value: second(0, 0).re.re,
                gradient: (0..2).map(|i| second(i, i).re.gradient[0]).collect(),
                hessian: (0..2).map(|i| (0..2).map(|j| second(i, j).gradient[0].gradient[0]).collect()).collect(),
            }
        };
        (0..10).map(one).collect()
    }

    fn measured(measure: &Measure, at: [f64; 2]) -> Taylor {
        let taylors = taylors(at);
        let drives: Vec<Vec<&Taylor>> = taylors.iter().map(|taylor| vec![taylor]).collect();
        let weights: Vec<f64> = (0..10).map(|k| f64::from(k + 1) / 55.0).collect();
        measure.of(&drives, &weights)
    }

    /// Gradients and Hessians of every measure of one outcome beside central differences of its values and gradients.
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
                assert!((slope(&|f| f.value) - here.gradient[i]).abs() < 1e-8 * size, "{measure:?}");
                for j in 0..2 {
                    let difference = slope(&|f| f.gradient[j]) - here.hessian[i][j];
                    assert!(difference.abs() < 1e-7 * size * 10.0, "{measure:?} {i}{j}: {difference}");
                }
            }
        }
    }

    /// The smoothed mean of a lowest share beside the mean of the sorted values, and the other measures beside their definitions.
    #[test]
    fn exact_measures_of_ten_numbers() {
        let at = [0.7, -0.4];
        let values: Vec<f64> = taylors(at).iter().map(|taylor| taylor.value).collect();
        let taylors: Vec<Taylor> = values.iter().map(|value| Taylor { value: *value, ..Taylor::default() }).collect();
        let drives: Vec<Vec<&Taylor>> = taylors.iter().map(|taylor| vec![taylor]).collect();
        let of = |measure: Measure| measure.of(&drives, &[0.1; 10]).value;
        let mean = values.iter().sum::<f64>() / 10.0;
        let variance = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / 10.0;
        assert!((of(Measure::Mean(Outcome::Carry)) - mean).abs() < 1e-13);
        assert!((of(Measure::Deviation(Outcome::Carry)) - variance.sqrt()).abs() < 1e-12);
        let mut sorted = values.clone();
        sorted.sort_by(f64::total_cmp);
        let (low, high) = (sorted[..2].iter().sum::<f64>() / 2.0, sorted[7..].iter().sum::<f64>() / 3.0);
        // the smoothing takes off what φ has at the edge of the share
        assert!(
            (of(Measure::Lowest(Outcome::Carry, 0.2)) - low).abs() < 0.1,
            "{} {low}",
            of(Measure::Lowest(Outcome::Carry, 0.2))
        );
        assert!((of(Measure::Highest(Outcome::Carry, 0.3)) - high).abs() < 0.1);
    }
}
