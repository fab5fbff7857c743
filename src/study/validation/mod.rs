//! Validation of all aerodynamic laws against published drives: bias and mean absolute error.

mod cases;
mod compared;
mod predicted;
mod sets;

pub use cases::Case;
pub use compared::Compared;
pub use predicted::SCATTER;
pub use sets::{Computation, SETS, Set};

use crate::error::Result;
use crate::parameters::Law;

/// Temperature range for drives without a stated air, K: 15 and 35 °C.
pub const SWEPT: [f64; 2] = [288.15, 308.15];

/// A computed and a published value, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residual {
    /// Index of the case in its set.
    pub case: usize,
    /// Computed value.
    pub predicted: f64,
    /// Published value.
    pub published: f64,
}

impl Residual {
    /// Computed − published.
    pub fn difference(&self) -> f64 {
        self.predicted - self.published
    }
}

/// Errors of a law in one quantity of a set.
#[derive(Clone, Debug, PartialEq)]
pub struct Score {
    /// The quantity.
    pub of: Compared,
    /// Cases with both a published and a computed value.
    pub residuals: Vec<Residual>,
}

impl Score {
    /// Mean of computed − published; `None` without cases.
    pub fn bias(&self) -> Option<f64> {
        self.mean(|residual| residual.difference())
    }

    /// Mean absolute difference.
    pub fn mean_absolute(&self) -> Option<f64> {
        self.mean(|residual| residual.difference().abs())
    }

    fn mean(&self, of: impl Fn(&Residual) -> f64) -> Option<f64> {
        let sum: f64 = self.residuals.iter().map(of).sum();
        (!self.residuals.is_empty()).then(|| sum / self.residuals.len() as f64)
    }
}

/// Errors of a law on a set.
#[derive(Clone, Debug)]
pub struct LawScores {
    /// The law.
    pub law: &'static str,
    /// All quantities of the set, the most important first.
    pub scores: Vec<Score>,
    /// Bias of the first quantity at the temperatures of [`SWEPT`]; `None` if the air is stated,
    /// and for optima.
    pub swept: Option<[Option<f64>; 2]>,
    /// Bias of carry for the mean of scattered drives ([`SCATTER`]) instead of the average launch;
    /// `None` unless the cases are averages.
    pub averaged: Option<f64>,
}

/// A set with the errors of all laws.
#[derive(Clone, Debug)]
pub struct SetScores {
    /// The set.
    pub set: &'static Set,
    /// The cases of the set.
    pub cases: Vec<Case>,
    /// The laws in the order of [`Law::NAMES`], then a user's own law.
    pub laws: Vec<LawScores>,
}

/// Validates every published law on every set, and optionally a user's own table.
///
/// ```
/// let found = longdrive::study::validation::validation(None).unwrap();
/// let drivers = &found[0];
/// assert_eq!((drivers.set.name, drivers.cases.len()), ("pga-driver", 3));
/// assert!(drivers.laws.iter().all(|law| law.scores[0].bias().is_some()));
/// ```
///
/// # Errors
/// [`Error::Unreadable`](crate::Error::Unreadable) if the data cannot be read.
pub fn validation(own: Option<Law<f64>>) -> Result<Vec<SetScores>> {
    SETS.iter().map(|set| scores(set, own)).collect()
}

fn scores(set: &'static Set, own: Option<Law<f64>>) -> Result<SetScores> {
    let mut cases = cases::cases(set.rows)?;
    let base = set.computation.has_base().then(|| cases.remove(0));
    let is_stated = cases.iter().all(|case| case.density.is_some());
    let laws = Law::NAMES
        .iter()
        .filter_map(|name| Law::named(name))
        .chain(own)
        .map(|law| {
            let at = |temperature| -> Result<Vec<Score>> {
                let computed = cases
                    .iter()
                    .map(|case| predicted::predicted(set, case, base.as_ref(), law, temperature));
                let computed = computed.collect::<Result<Vec<_>>>()?;
                let score = |of: &Compared| {
                    let residual = |(case, found): (usize, &predicted::Predicted)| {
                        let (predicted, published) = (found.of(*of)?, cases[case].published(*of)?);
                        Some(Residual {
                            case,
                            predicted,
                            published,
                        })
                    };
                    Score {
                        of: *of,
                        residuals: computed.iter().enumerate().filter_map(residual).collect(),
                    }
                };
                let is_published =
                    |of: &&Compared| cases.iter().any(|case| case.published(**of).is_some());
                Ok(set
                    .computation
                    .compared()
                    .iter()
                    .filter(is_published)
                    .map(score)
                    .collect())
            };
            let scores = at(None)?;
            let averaged = || {
                let bias = scores.first().and_then(Score::bias)?;
                let less = cases
                    .iter()
                    .map(|case| predicted::of_averaging(case, law))
                    .collect::<Option<Vec<_>>>()?;
                Some(bias + less.iter().sum::<f64>() / less.len() as f64)
            };
            let averaged = if set.is_averaged { averaged() } else { None };
            let swept = if is_stated || set.computation == Computation::Optimum {
                None
            } else {
                let [cold, warm] = SWEPT.map(|temperature| at(Some(temperature)));
                Some([cold?, warm?].map(|scores| scores.first().and_then(Score::bias)))
            };
            Ok(LawScores {
                law: law.name(),
                scores,
                swept,
                averaged,
            })
        });
    let laws = laws.collect::<Result<_>>()?;
    Ok(SetScores { set, laws, cases })
}
