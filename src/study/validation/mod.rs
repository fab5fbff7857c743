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
use crate::json::number;
use crate::parameters::Law;
use rayon::prelude::*;
use serde::{Serialize, Serializer};

/// Two temperatures, K, below and above the default of 25 °C: 15 and 35 °C. Drives whose source
/// does not state the air are also computed at these.
pub const OTHER_TEMPERATURES: [f64; 2] = [288.15, 308.15];

/// The error of a quantity for one drive.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "ResidualReport"))]
pub struct Residual {
    /// Index of the case in its set, from 0.
    pub case: usize,
    /// Computed value, SI.
    pub predicted: f64,
    /// Published value, SI.
    pub published: f64,
    /// The computed minus the published value, SI.
    pub difference: f64,
}

/// The errors of a quantity.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "ScoreReport"))]
pub struct Score {
    /// The quantity.
    #[serde(skip)]
    pub of: Compared,
    /// Number of drives that have the quantity and fly.
    pub count: usize,
    /// The mean difference, computed minus published, SI; `null` if `count` is 0.
    #[serde(serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub bias: Option<f64>,
    /// The mean absolute difference, SI; `null` if `count` is 0.
    #[serde(serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub mean_absolute_error: Option<f64>,
    /// The error of each drive.
    pub residuals: Vec<Residual>,
}

impl Score {
    fn new(of: Compared, residuals: Vec<Residual>) -> Self {
        let count = residuals.len();
        let mean = |of: fn(&Residual) -> f64| {
            let sum: f64 = residuals.iter().map(of).sum();
            (count > 0).then(|| sum / count as f64)
        };
        Self {
            of,
            count,
            bias: mean(|residual| residual.difference),
            mean_absolute_error: mean(|residual| residual.difference.abs()),
            residuals,
        }
    }
}

/// The errors of a law on a set.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "LawScoresReport"))]
pub struct LawScores {
    /// The law.
    pub law: &'static str,
    /// The errors of each quantity.
    // the most important first
    #[serde(serialize_with = "by_quantity")]
    #[cfg_attr(test, schemars(with = "std::collections::BTreeMap<Compared, Score>"))]
    pub scores: Vec<Score>,
    /// The bias of the first quantity in colder and warmer air; `null` for a set whose source
    /// states the air, and for a set of optima.
    pub bias_in_other_air: Option<BiasInOtherAir>,
    /// The bias of carry, m, if the mean carry of scattered launches replaces the carry of the
    /// average launch; `null` if the published drives are not averages.
    // scattered by [`SCATTER`]
    #[serde(rename = "bias_averaged", serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub averaged: Option<f64>,
}

fn by_quantity<S: Serializer>(
    scores: &[Score],
    serializer: S,
) -> std::result::Result<S::Ok, S::Error> {
    serializer.collect_map(scores.iter().map(|score| (score.of.name(), score)))
}

/// The bias of a quantity in colder and in warmer air than the default air.
#[derive(Clone, Copy, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct BiasInOtherAir {
    /// The bias at 15 °C, SI.
    #[serde(rename = "at_15_degC", serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub cold: Option<f64>,
    /// The bias at 35 °C, SI.
    #[serde(rename = "at_35_degC", serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub warm: Option<f64>,
}

/// The errors of every law on a set of published drives.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "SetReport"))]
pub struct SetScores {
    /// The set.
    #[serde(flatten)]
    pub set: &'static Set,
    /// The drives.
    pub cases: Vec<Case>,
    /// The laws.
    // in the order of [`Law::NAMES`], then a user's own law
    pub laws: Vec<LawScores>,
}

/// Validates every published law on every set, and optionally a user's own table.
///
/// ```
/// let found = longdrive::study::validation::validation(None).unwrap();
/// let drivers = &found[0];
/// assert_eq!((drivers.set.name, drivers.cases.len()), ("pga-driver", 3));
/// assert!(drivers.laws.iter().all(|law| law.scores[0].bias.is_some()));
/// ```
///
/// # Errors
/// [`Error::Unreadable`](crate::Error::Unreadable) if the data cannot be read.
pub fn validation(own: Option<Law<f64>>) -> Result<Vec<SetScores>> {
    let published = Law::NAMES.iter().filter_map(|name| Law::named(name));
    let laws: Vec<_> = published.chain(own).collect();
    let mut all = vec![];
    for set in &SETS {
        let mut cases = cases::cases(set.data_name)?;
        // the gain of carry is relative to the first case
        let base = (set.computation.compared() == [Compared::Gain]).then(|| cases.remove(0));
        let mut found = SetScores {
            set,
            cases,
            laws: vec![],
        };
        found.laws = laws
            .par_iter()
            .map(|law| found.law_scores(base.as_ref(), *law))
            .collect::<Result<_>>()?;
        all.push(found);
    }
    Ok(all)
}

impl SetScores {
    /// The errors of an aerodynamic law. `base` is the reference case of the gains of carry; `None`
    /// for a set without gains.
    fn law_scores(&self, base: Option<&Case>, law: Law<f64>) -> Result<LawScores> {
        let scores = self.scores(base, law, None)?;
        let averaged = if self.set.is_averaged {
            self.bias_of_scattered(law, &scores)
        } else {
            None
        };
        let has_density = self.cases.iter().all(|case| case.density.is_some());
        let bias_in_other_air = if has_density || self.set.computation == Computation::Optimum {
            None
        } else {
            let [cold, warm] =
                OTHER_TEMPERATURES.map(|temperature| self.scores(base, law, Some(temperature)));
            let [cold, warm] =
                [cold?, warm?].map(|scores| scores.first().and_then(|score| score.bias));
            Some(BiasInOtherAir { cold, warm })
        };
        Ok(LawScores {
            law: law.name(),
            scores,
            bias_in_other_air,
            averaged,
        })
    }

    /// The errors of an aerodynamic law in each published quantity. A case whose source does not
    /// state the air is computed at `temperature`, by default 25 °C.
    fn scores(
        &self,
        base: Option<&Case>,
        law: Law<f64>,
        temperature: Option<f64>,
    ) -> Result<Vec<Score>> {
        let predict = |case| predicted::predicted(self.set, case, base, law, temperature);
        let predicted: Vec<_> = self.cases.iter().map(predict).collect::<Result<_>>()?;
        let residual = |of: Compared, case: usize| {
            let computed = *predicted[case].get(&of)?;
            let published = self.cases[case].published(of)?;
            Some(Residual {
                case,
                predicted: computed,
                published,
                difference: computed - published,
            })
        };
        let is_published =
            |of: &&Compared| self.cases.iter().any(|case| case.published(**of).is_some());
        let compared = self.set.computation.compared();
        Ok(compared
            .iter()
            .filter(is_published)
            .map(|of| {
                let cases = 0..self.cases.len();
                Score::new(*of, cases.filter_map(|case| residual(*of, case)).collect())
            })
            .collect())
    }

    /// Bias of carry if each published value is compared with the mean of drives scattered by
    /// [`SCATTER`]. `None` if this mean cannot be computed for a case.
    fn bias_of_scattered(&self, law: Law<f64>, scores: &[Score]) -> Option<f64> {
        let bias = scores.first()?.bias?;
        let less = self
            .cases
            .iter()
            .map(|case| predicted::mean_carry_change_by_scatter(case, law))
            .collect::<Option<Vec<_>>>()?;
        Some(bias + less.iter().sum::<f64>() / less.len() as f64)
    }
}
