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
use serde::Serialize;

/// Temperature range for drives without a stated air, K: 15 and 35 °C.
pub const SWEPT: [f64; 2] = [288.15, 308.15];

/// A computed and a published value, SI.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct Residual {
    /// Index of the case in its set, from 0.
    pub case: usize,
    /// Computed value, SI.
    pub predicted: f64,
    /// Published value, SI.
    pub published: f64,
}

impl Residual {
    /// Computed − published.
    pub fn difference(&self) -> f64 {
        self.predicted - self.published
    }
}

/// Errors of an aerodynamic law in one quantity (such as carry) on a set of published drives.
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

/// Errors of an aerodynamic law in all quantities of a set of published drives.
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
    let mut found = SetScores {
        set,
        cases,
        laws: vec![],
    };
    found.laws = Law::NAMES
        .iter()
        .filter_map(|name| Law::named(name))
        .chain(own)
        .map(|law| found.law_scores(base.as_ref(), law))
        .collect::<Result<_>>()?;
    Ok(found)
}

impl SetScores {
    /// The errors of an aerodynamic law; `base` is the case with which the other cases are
    /// compared.
    fn law_scores(&self, base: Option<&Case>, law: Law<f64>) -> Result<LawScores> {
        let scores = self.scores(base, law, None)?;
        let averaged = if self.set.is_averaged {
            self.bias_of_scattered(law, &scores)
        } else {
            None
        };
        let has_density = self.cases.iter().all(|case| case.density.is_some());
        let swept = if has_density || self.set.computation == Computation::Optimum {
            None
        } else {
            let [cold, warm] = SWEPT.map(|temperature| self.scores(base, law, Some(temperature)));
            Some([cold?, warm?].map(|scores| scores.first().and_then(Score::bias)))
        };
        Ok(LawScores {
            law: law.name(),
            scores,
            swept,
            averaged,
        })
    }

    /// The errors of an aerodynamic law in each published quantity, in air of this temperature.
    fn scores(
        &self,
        base: Option<&Case>,
        law: Law<f64>,
        temperature: Option<f64>,
    ) -> Result<Vec<Score>> {
        let predict = |case| predicted::predicted(self.set, case, base, law, temperature);
        let predicted: Vec<_> = self.cases.iter().map(predict).collect::<Result<_>>()?;
        let residual = |of: Compared, case: usize| {
            Some(Residual {
                case,
                predicted: *predicted[case].get(&of)?,
                published: self.cases[case].published(of)?,
            })
        };
        let is_published =
            |of: &&Compared| self.cases.iter().any(|case| case.published(**of).is_some());
        let compared = self.set.computation.compared();
        Ok(compared
            .iter()
            .filter(is_published)
            .map(|of| Score {
                of: *of,
                residuals: (0..self.cases.len())
                    .filter_map(|case| residual(*of, case))
                    .collect(),
            })
            .collect())
    }

    /// Bias of the first quantity for the mean of scattered drives; `None` if a case has no such
    /// mean.
    fn bias_of_scattered(&self, law: Law<f64>, scores: &[Score]) -> Option<f64> {
        let bias = scores.first().and_then(Score::bias)?;
        let less = self
            .cases
            .iter()
            .map(|case| predicted::of_averaging(case, law))
            .collect::<Option<Vec<_>>>()?;
        Some(bias + less.iter().sum::<f64>() / less.len() as f64)
    }
}
