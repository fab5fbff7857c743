use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup, Vary};
use crate::study::Sigma;
use crate::study::gauss::legendre;
use crate::study::sigma::{AmountKind, amount_of};
use statrs::distribution::{ContinuousCDF, Normal, Triangular, Uniform};
use std::sync::LazyLock;

/// Distribution of an uncertain number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Distribution {
    /// Normal distribution.
    Normal {
        /// Mean.
        mean: f64,
        /// Standard deviation.
        deviation: f64,
    },
    /// Uniform distribution between two bounds.
    Uniform {
        /// Lower bound.
        low: f64,
        /// Upper bound.
        high: f64,
    },
    /// Triangular distribution.
    Triangular {
        /// Lower bound.
        low: f64,
        /// Most probable value.
        mode: f64,
        /// Upper bound.
        high: f64,
    },
    /// Normal distribution truncated to an interval.
    Truncated {
        /// Mean before truncation.
        mean: f64,
        /// Standard deviation before truncation.
        deviation: f64,
        /// Lower bound.
        low: f64,
        /// Upper bound.
        high: f64,
    },
}

/// j₀,₁: the first zero of the Bessel function J₀.
const FIRST_ZERO_OF_J0: f64 = 2.404_825_557_695_773;

impl Distribution {
    /// The names of the distributions.
    pub const NAMES: [&'static str; 4] = ["normal", "uniform", "triangular", "truncated"];

    /// The name, one of [`NAMES`](Self::NAMES).
    pub fn name(&self) -> &'static str {
        match self {
            Self::Normal { .. } => "normal",
            Self::Uniform { .. } => "uniform",
            Self::Triangular { .. } => "triangular",
            Self::Truncated { .. } => "truncated",
        }
    }

    /// The numbers that define the distribution, in the order of its fields.
    pub fn numbers(&self) -> Vec<f64> {
        match *self {
            Self::Normal { mean, deviation } => vec![mean, deviation],
            Self::Uniform { low, high } => vec![low, high],
            Self::Triangular { low, mode, high } => vec![low, mode, high],
            Self::Truncated {
                mean,
                deviation,
                low,
                high,
            } => vec![mean, deviation, low, high],
        }
    }

    /// The distribution with this name and these numbers, which are not checked. `None` if the name
    /// is unknown, or if the number of numbers is wrong.
    fn named(name: &str, numbers: &[f64]) -> Option<Self> {
        Some(match (name, numbers) {
            ("normal", &[mean, deviation]) => Self::Normal { mean, deviation },
            ("truncated", &[mean, deviation, low, high]) => Self::Truncated {
                mean,
                deviation,
                low,
                high,
            },
            ("uniform", &[low, high]) => Self::Uniform { low, high },
            ("triangular", &[low, mode, high]) => Self::Triangular { low, mode, high },
            _ => return None,
        })
    }

    /// Checks the numbers of the distribution.
    ///
    /// # Errors
    /// [`Error::Unreadable`] for numbers that are not finite or not in ascending order, a standard
    /// deviation ≤ 0, and a truncation that leaves no probability.
    pub fn check(&self) -> Result<()> {
        match self.why_invalid() {
            Some(why) => Err(Error::unreadable(format!("the distribution {self:?}"), why)),
            None => Ok(()),
        }
    }

    fn why_invalid(&self) -> Option<&'static str> {
        let numbers = self.numbers();
        let deviation = match *self {
            Self::Normal { deviation, .. } | Self::Truncated { deviation, .. } => Some(deviation),
            Self::Uniform { .. } | Self::Triangular { .. } => None,
        };
        let [low, high] = self.bounds();
        let rises = low < high && (!matches!(self, Self::Triangular { .. }) || numbers.is_sorted());
        if deviation.is_some_and(|deviation| !(deviation > 0.0 && deviation.is_finite())) {
            return Some("the standard deviation must be a finite number above 0");
        }
        if !numbers.iter().all(|number| number.is_finite()) {
            return Some("its numbers must be finite");
        }
        if !rises {
            return Some("its values must rise from the lower end to the upper");
        }
        let is_left = self.deviation() > 0.0
            && self.deviation().is_finite()
            && (low..=high).contains(&self.mean());
        (!is_left).then_some(
            "the distribution has no probability between its ends; move the ends nearer to its mean",
        )
    }

    /// Quantile for a probability 0 ≤ p ≤ 1, for a distribution that [`check`](Self::check)
    /// accepts. For 0 and 1 it is a bound of the support.
    ///
    /// # Panics
    /// If `p` is not a probability.
    pub fn quantile(&self, p: f64) -> f64 {
        assert!(
            (0.0..=1.0).contains(&p),
            "a probability must be from 0 to 1, but it is {p}"
        );
        // the constructors below need positive widths, which `check` requires
        match *self {
            Self::Normal { mean, deviation } => {
                Normal::new(mean, deviation).map_or(f64::NAN, |d| d.inverse_cdf(p))
            }
            Self::Uniform { low, high } => {
                Uniform::new(low, high).map_or(f64::NAN, |d| d.inverse_cdf(p))
            }
            Self::Triangular { low, mode, high } => {
                Triangular::new(low, high, mode).map_or(f64::NAN, |d| d.inverse_cdf(p))
            }
            Self::Truncated {
                mean,
                deviation,
                low,
                high,
            } => {
                if low < high && high - low < FLAT * deviation {
                    return low + p * (high - low);
                }
                let normal = Normal::standard();
                let [from, to] = [low, high].map(|end| (end - mean) / deviation);
                // bounds above the mean are mirrored to below the mean: probabilities of the upper
                // tail suffer cancellation, those of the lower tail keep their relative precision
                let is_mirrored = from > 0.0;
                let ends = if is_mirrored {
                    [-to, -from]
                } else {
                    [from, to]
                };
                let [below, above] = ends.map(|end| normal.cdf(end));
                let p = if is_mirrored { 1.0 - p } else { p };
                let sign = if is_mirrored { -1.0 } else { 1.0 };
                let value =
                    mean + deviation * sign * normal.inverse_cdf(below + (above - below) * p);
                if low < high {
                    value.clamp(low, high)
                } else {
                    f64::NAN
                }
            }
        }
    }

    /// Bounds of the support; may be infinite.
    pub fn bounds(&self) -> [f64; 2] {
        match *self {
            Self::Normal { .. } => [f64::NEG_INFINITY, f64::INFINITY],
            Self::Uniform { low, high }
            | Self::Triangular { low, high, .. }
            | Self::Truncated { low, high, .. } => [low, high],
        }
    }

    /// The mean.
    pub fn mean(&self) -> f64 {
        match *self {
            Self::Normal { mean, .. } => mean,
            Self::Uniform { low, high } => 0.5 * (low + high),
            Self::Triangular { low, mode, high } => (low + mode + high) / 3.0,
            Self::Truncated {
                mean,
                deviation,
                low,
                high,
            } => truncated_moments(mean, deviation, [low, high]).mean,
        }
    }

    /// Central moments of order 2, 3 and 4.
    pub fn central_moments(&self) -> [f64; 3] {
        match *self {
            Self::Normal { deviation, .. } => [deviation.powi(2), 0.0, 3.0 * deviation.powi(4)],
            Self::Uniform { low, high } => [
                (high - low).powi(2) / 12.0,
                0.0,
                (high - low).powi(4) / 80.0,
            ],
            Self::Triangular { low, mode, high } => {
                let (a, c, b) = (low, mode, high);
                let second = (a * a + b * b + c * c - a * b - a * c - b * c) / 18.0;
                let third = (a + b - 2.0 * c) * (2.0 * a - b - c) * (a - 2.0 * b + c) / 270.0;
                // the kurtosis of a triangular distribution is 12/5
                [second, third, 2.4 * second * second]
            }
            Self::Truncated {
                mean,
                deviation,
                low,
                high,
            } => truncated_moments(mean, deviation, [low, high]).central,
        }
    }

    /// The standard deviation.
    pub fn deviation(&self) -> f64 {
        match *self {
            Self::Normal { deviation, .. } => deviation,
            _ => self.central_moments()[0].sqrt(),
        }
    }

    /// Upper bound of the Poincaré constant C, for which Var f ≤ C · E f′² for any f:
    ///
    /// - normal: σ²;
    /// - uniform: (width/π)²;
    /// - triangular: (longer side/j₀,₁)² (Roustant, Barthe & Iooss 2017);
    /// - truncated normal: σ² before truncation, or (width/π)² if that is smaller (Bakry & Émery
    ///   1985; Payne & Weinberger 1960).
    pub fn poincare(&self) -> f64 {
        match *self {
            Self::Normal { deviation, .. } => deviation.powi(2),
            Self::Uniform { low, high } => ((high - low) / std::f64::consts::PI).powi(2),
            Self::Triangular { low, mode, high } => {
                ((mode - low).max(high - mode) / FIRST_ZERO_OF_J0).powi(2)
            }
            Self::Truncated {
                deviation,
                low,
                high,
                ..
            } => deviation.min((high - low) / std::f64::consts::PI).powi(2),
        }
    }
}

/// A truncated normal distribution counts as uniform if its width is below this fraction of its
/// standard deviation before truncation: its density then varies by less than 4e-7, even 38 standard
/// deviations from the mean. Probabilities of the normal distribution do not resolve such a width.
const FLAT: f64 = 1e-8;

/// Gauss–Legendre rule on [0, 1] for the moments of a truncated normal distribution.
static UNIT_RULE: LazyLock<Vec<(f64, f64)>> = LazyLock::new(|| legendre([0.0, 1.0], 96));

/// The part of the support of a truncated normal distribution outside of which the density is below
/// e⁻⁴¹ (1.6e-18) of its maximum. `mean` and `deviation` are those before truncation.
pub(in crate::study) fn dense_part(mean: f64, deviation: f64, [low, high]: [f64; 2]) -> [f64; 2] {
    let nearest = (mean.max(low).min(high) - mean) / deviation;
    let farthest = deviation * (nearest * nearest + 82.0).sqrt();
    [low.max(mean - farthest), high.min(mean + farthest)]
}

/// Moments of a distribution.
struct DistributionMoments {
    mean: f64,
    /// Central moments of order 2, 3 and 4.
    central: [f64; 3],
}

/// Moments of a truncated normal distribution by quadrature. The closed forms are differences of
/// nearly equal numbers where the support is narrow or in a tail. NaN if the density rounds to 0.
fn truncated_moments(mean: f64, deviation: f64, ends: [f64; 2]) -> DistributionMoments {
    let [low, high] = dense_part(mean, deviation, ends);
    let density = |part: f64| {
        let score = (low + part * (high - low) - mean) / deviation;
        (-0.5 * score * score).exp()
    };
    let weighted: Vec<_> = UNIT_RULE
        .iter()
        .map(|&(part, weight)| (part, weight * density(part)))
        .collect();
    let sum: f64 = weighted.iter().map(|(_, weight)| weight).sum();
    let expected = |f: &dyn Fn(f64) -> f64| {
        let terms = weighted.iter().map(|&(part, weight)| weight * f(part));
        terms.sum::<f64>() / sum
    };
    let middle = expected(&|part| part);
    let central =
        |order: i32| (high - low).powi(order) * expected(&|part: f64| (part - middle).powi(order));
    DistributionMoments {
        mean: low + middle * (high - low),
        central: [2, 3, 4].map(central),
    }
}

/// An uncertain parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uncertain {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// The distribution of the parameter, SI.
    pub distribution: Distribution,
}

impl Uncertain {
    /// Normal distribution with the setup's value as its mean.
    pub fn normal(setup: &Setup<f64>, sigma: &Sigma) -> Self {
        let mean = setup.value(sigma.parameter).unwrap_or_default();
        Self {
            parameter: sigma.parameter,
            distribution: Distribution::Normal {
                mean,
                deviation: sigma.value,
            },
        }
    }

    /// The range from the 0.05 % to the 99.95 % quantile.
    pub fn range(&self) -> Vary {
        let [low, high] = [0.0005, 0.9995].map(|share| self.distribution.quantile(share));
        Vary {
            parameter: self.parameter,
            low,
            high,
        }
    }

    /// Parses `NAME=normal(MEAN,DEVIATION)`, `NAME=uniform(LOW,HIGH)`,
    /// `NAME=triangular(LOW,MODE,HIGH)` or `NAME=truncated(MEAN,DEVIATION,LOW,HIGH)`, a truncated
    /// normal distribution. A percentage is relative to the parameter's value; a mean or an end of a
    /// dimensionless parameter is a number, not a percentage.
    ///
    /// ```
    /// use longdrive::{Setup, study::uncertainty::{Distribution, Uncertain}};
    /// let setup = Setup::modern_driver();
    /// let speed = Uncertain::read(&setup, "swing.speed=uniform(45 m/s, 50 m/s)").unwrap();
    /// assert_eq!(speed.distribution, Distribution::Uniform { low: 45.0, high: 50.0 });
    /// assert!(Uncertain::read(&setup, "swing.speed=uniform(50 m/s, 45 m/s)").is_err());
    /// ```
    ///
    /// # Errors
    /// [`Error::Unreadable`] for invalid text; [`Error::OutOfRange`] if the mean of a normal
    /// distribution, or a bound of another distribution, is not an allowed value; the errors of
    /// [`Setup::column`]. The setup need not have a value of the parameter.
    pub fn read(setup: &Setup<f64>, text: &str) -> Result<Self> {
        let unreadable = |source| Error::Unreadable {
            name: format!("the distribution {}", text.trim()),
            source,
        };
        let how = "write NAME=normal(MEAN,DEVIATION), NAME=uniform(LOW,HIGH), \
                   NAME=triangular(LOW,MODE,HIGH) or \
                   NAME=truncated(MEAN,DEVIATION,LOW,HIGH)";
        let (name, rest) = text.split_once('=').ok_or_else(|| unreadable(how.into()))?;
        let parameter = setup.column(name.trim())?;
        let (kind, rest) = rest.split_once('(').ok_or_else(|| unreadable(how.into()))?;
        if let Some((_, next)) = rest.split_once(')').filter(|(_, next)| next.contains('=')) {
            let next = next.trim_matches([',', ';', ' ']);
            return Err(unreadable(
                format!("it has a second distribution, {next}; give each distribution separately")
                    .into(),
            ));
        }
        let inside = rest
            .trim()
            .strip_suffix(')')
            .ok_or_else(|| unreadable("the closing ) is missing".into()))?;
        if !Distribution::NAMES.contains(&kind.trim()) {
            return Err(unreadable(
                format!("there is no distribution \"{}\"; {how}", kind.trim()).into(),
            ));
        }
        // a standard deviation is a difference: convert it without the offset of its unit (°C)
        let is_difference = |at: usize| matches!(kind.trim(), "normal" | "truncated") && at == 1;
        let amounts = inside.split(',').enumerate().map(|(at, part)| {
            let amount = if is_difference(at) {
                AmountKind::Deviation
            } else {
                AmountKind::Value
            };
            amount_of(setup, parameter, part, amount)
        });
        let amounts = amounts
            .collect::<std::result::Result<Vec<_>, _>>()
            .map_err(unreadable)?;
        let distribution =
            Distribution::named(kind.trim(), &amounts).ok_or_else(|| unreadable(how.into()))?;
        let read = Self {
            parameter,
            distribution,
        };
        match distribution.why_invalid() {
            Some(why) => Err(unreadable(why.into())),
            None => read.check_range().map(|()| read),
        }
    }

    /// Checks the distribution, and that the parameter allows its values.
    ///
    /// # Errors
    /// The errors of [`Distribution::check`]; [`Error::OutOfRange`] if the mean of a normal
    /// distribution, or a bound of another distribution, is not an allowed value.
    pub fn check(&self) -> Result<()> {
        if let Some(why) = self.distribution.why_invalid() {
            let name = format!("the distribution of {}", self.parameter);
            return Err(Error::unreadable(name, why));
        }
        self.check_range()
    }

    fn check_range(&self) -> Result<()> {
        let parameter = self.parameter;
        match self.distribution {
            Distribution::Normal { mean, .. } => parameter.check(mean),
            Distribution::Uniform { low, high }
            | Distribution::Triangular { low, high, .. }
            | Distribution::Truncated { low, high, .. } => {
                parameter.check(low).and_then(|()| parameter.check(high))
            }
        }
    }
}
