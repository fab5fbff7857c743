use super::golfer::Swings;
use super::quadrature::{REACH, rule};
use crate::error::{Error, Result};
use crate::optimize::sobol;
use crate::parameters::{Parameter, Vary};
use crate::statistics::extent;
use crate::study::Goal;
use crate::study::uncertainty::{Distribution, Uncertain};
use rayon::prelude::*;
use statrs::distribution::{ContinuousCDF, Normal};

/// Rule that generates scenarios.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// Product of Gauss's rules with this number of nodes for each parameter. [`Rule::of`] chooses
    /// this rule for smooth goals over up to three parameters.
    Quadrature(usize),
    /// A scrambled Sobol' sequence.
    Sequence {
        /// The number of points.
        count: usize,
        /// Seed of the scrambling. Equal seeds give equal points, bit by bit.
        seed: u32,
    },
    /// The recorded swings.
    Recorded,
}

/// Swings that represent all swings of a golfer. They do not depend on the design, so that an
/// expectation is a smooth function of the design.
#[derive(Clone, Debug, PartialEq)]
pub struct Scenarios {
    /// The parameters with a value in each scenario.
    pub parameters: Vec<&'static Parameter>,
    /// Values of the parameters, SI, a row for each scenario.
    pub points: Vec<Vec<f64>>,
    /// The weight of each scenario. The weights sum to 1.
    pub weights: Vec<f64>,
    /// Rule that generated the scenarios.
    pub rule: Rule,
    /// The distributions of the points; `None` for recorded swings, one drive and the mean swing.
    distributed: Option<Swings>,
}

/// Largest number of parameters integrated by Gauss's rules.
const MOST_INTEGRATED: usize = 3;
/// Number of Gauss nodes per parameter, for one, two and three parameters.
const NODES: [usize; MOST_INTEGRATED] = [32, 16, 8];
/// Number of scenarios of a sequence.
const SCENARIOS: usize = 512;
/// Largest number of scenarios in a search.
const MOST_SCENARIOS: usize = 100_000;
/// Number of independent sequences that estimate the error of a goal.
const SEQUENCES: u32 = 8;
/// Minimum number of points of a sequence that estimates the error of a goal.
const POINTS: usize = 2048;

impl Rule {
    /// The name in JSON: `quadrature`, `sequence` or `recorded`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Quadrature(_) => "quadrature",
            Self::Sequence { .. } => "sequence",
            Self::Recorded => "recorded",
        }
    }

    /// The rule for some swings and all goals of a search: [`Rule::Recorded`] for recorded swings,
    /// and a sequence of `count` scenarios for distributed swings. Without `count`, up to three
    /// distributed parameters are integrated by Gauss's rules. More than three, and goals with a
    /// kink or jump, are integrated by a sequence: Gauss's rules converge for smooth goals only.
    ///
    /// # Errors
    /// [`Error::Unreadable`] for fewer than 2 scenarios or more than 100,000, and for a `count`
    /// with recorded swings.
    pub fn of<'a>(
        swings: &Swings,
        goals: impl IntoIterator<Item = &'a Goal>,
        count: Option<usize>,
        seed: u32,
    ) -> Result<Self> {
        let is_smooth = !goals.into_iter().any(Goal::has_edge);
        let refuse = |count: usize, reason: String| {
            Err(Error::unreadable(format!("`scenarios {count}`"), reason))
        };
        match (swings, count) {
            (Swings::Recorded { .. }, Some(count)) => refuse(
                count,
                "recorded swings are the scenarios themselves; leave `scenarios` out".into(),
            ),
            (Swings::Recorded { .. }, None) => Ok(Self::Recorded),
            (_, Some(count)) if !(2..=MOST_SCENARIOS).contains(&count) => {
                refuse(count, format!("give a number from 2 to {MOST_SCENARIOS}"))
            }
            (_, Some(count)) => Ok(Self::Sequence { count, seed }),
            (Swings::Distributed { inputs, .. }, None) => Ok(match inputs.len() {
                n @ 1..=MOST_INTEGRATED if is_smooth => Self::Quadrature(NODES[n - 1]),
                _ => Self::Sequence {
                    count: SCENARIOS,
                    seed,
                },
            }),
        }
    }

    /// Refuses a seed that has no effect on the scenarios.
    ///
    /// # Errors
    /// [`Error::Unreadable`] for a seed with Gauss's rule or with recorded swings.
    pub fn refuse_idle_seed(self, seed: Option<u32>) -> Result<()> {
        let why = match (self, seed) {
            (Self::Sequence { .. }, _) | (_, None) => return Ok(()),
            (Self::Quadrature(_), _) => {
                "smooth goals over up to 3 distributed parameters are integrated by Gauss's rules, \
                 which need no seed; give `scenarios` too, or leave the seed out"
            }
            (Self::Recorded, _) => {
                "recorded swings are the scenarios themselves, without a seed; leave the seed out"
            }
        };
        Err(Error::unreadable("`seed`", why))
    }

    /// Refuses a rule without scenarios, and a rule with more than [`MOST_SCENARIOS`] scenarios for
    /// this number of parameters. [`Rule::Recorded`] is not checked, because it makes no scenarios.
    fn check_count(self, parameters: usize) -> Result<()> {
        let count = match self {
            Self::Quadrature(nodes) => nodes.saturating_pow(parameters as u32),
            Self::Sequence { count, .. } => count,
            Self::Recorded => return Ok(()),
        };
        if (1..=MOST_SCENARIOS).contains(&count) {
            return Ok(());
        }
        let source = format!(
            "it gives {count} scenarios, and a search takes 1 to {MOST_SCENARIOS}; give another \
             number of nodes or points, or give fewer parameters a distribution"
        );
        Err(Error::unreadable("the rule of the scenarios", source))
    }
}

impl Scenarios {
    /// The range of each parameter's values.
    pub fn ranges(&self) -> Vec<Vary> {
        let range = |(i, parameter): (usize, &&'static Parameter)| {
            let [low, high] = extent(self.points.iter().map(|point| point[i]));
            Vary {
                parameter,
                low,
                high,
            }
        };
        self.parameters.iter().enumerate().map(range).collect()
    }

    /// One scenario: the setup's own drive. The mean of an outcome is then the outcome itself.
    pub fn one_drive() -> Self {
        Self {
            parameters: vec![],
            points: vec![vec![]],
            weights: vec![1.0],
            rule: Rule::Quadrature(1),
            distributed: None,
        }
    }

    /// True if there is one drive only, without parameters that vary.
    pub fn is_one_drive(&self) -> bool {
        self.parameters.is_empty()
    }

    /// The scenarios of some swings.
    ///
    /// # Errors
    /// The errors of [`Uncertain::check`], and [`Error::Unreadable`]
    /// - for [`Rule::Recorded`] with distributions, or another rule with recorded swings;
    /// - for a rule without scenarios, or with more than 100,000;
    /// - for a value outside the parameter's allowed range. A `truncated` distribution with bounds
    ///   inside this range has no such values.
    pub fn new(swings: &Swings, rule: Rule) -> Result<Self> {
        if let Swings::Distributed { inputs, .. } = swings {
            inputs.iter().try_for_each(Uncertain::check)?;
        }
        let parameters = swings.parameters();
        rule.check_count(parameters.len())?;
        let (points, weights) = match (swings, rule) {
            (Swings::Recorded { rows, .. }, Rule::Recorded) => equally_weighted(rows.clone()),
            (Swings::Distributed { inputs, factor }, Rule::Sequence { count, seed }) => {
                let point = |k: usize| sequence_point(inputs, factor, k as u64, seed);
                equally_weighted((0..count).into_par_iter().map(point).collect())
            }
            (Swings::Distributed { inputs, factor }, Rule::Quadrature(nodes)) => {
                quadrature_points(inputs, factor, nodes)
            }
            (Swings::Distributed { .. }, Rule::Recorded) => {
                let source = "Rule::Recorded is for recorded swings, and these have distributions; \
                              give Rule::Quadrature or Rule::Sequence";
                return Err(Error::unreadable("the rule of the scenarios", source));
            }
            (Swings::Recorded { .. }, _) => {
                let source = "recorded swings are the scenarios themselves; give Rule::Recorded";
                return Err(Error::unreadable("the rule of the scenarios", source));
            }
        };
        for point in &points {
            for (parameter, value) in parameters.iter().zip(point) {
                parameter.check(*value).map_err(|source| {
                    Error::unreadable(
                        format!("a swing of the distribution of {}", parameter.name),
                        format!("{source}; limit it with truncated(MEAN,DEVIATION,LOW,HIGH)"),
                    )
                })?;
            }
        }
        let distributed = matches!(swings, Swings::Distributed { .. }).then(|| swings.clone());
        Ok(Self {
            parameters,
            points,
            weights,
            rule,
            distributed,
        })
    }

    /// Independent scramblings of Sobol's sequence over the same distributions, for estimates from
    /// points that no search has used. Each has [`POINTS`] points. If the rule is a sequence with
    /// more points, each has the number of points of the rule. Empty without distributions.
    pub(in crate::study) fn sequences(&self) -> Vec<Result<Self>> {
        let Some(swings) = &self.distributed else {
            return vec![];
        };
        let (count, seed) = match self.rule {
            Rule::Sequence { count, seed } => (count.max(POINTS), seed),
            _ => (POINTS, 0),
        };
        // keep the seeds far from the seeds that users usually choose
        let seed = |round: u32| seed.wrapping_add(0x9e37_79b9_u32.wrapping_mul(round + 1));
        (0..SEQUENCES)
            .map(|round| {
                Self::new(
                    swings,
                    Rule::Sequence {
                        count,
                        seed: seed(round),
                    },
                )
            })
            .collect()
    }

    /// Bounds, SI, of the distribution of the parameter with index `of`; they may be infinite.
    /// `None` without distributions.
    fn bounds(&self, of: usize) -> Option<[f64; 2]> {
        match &self.distributed {
            Some(Swings::Distributed { inputs, .. }) => Some(inputs[of].distribution.bounds()),
            _ => None,
        }
    }

    /// The points of the scenarios, followed by copies. In a copy, the parameters with the indices
    /// `of` have values at the bounds of their distributions. There are copies for all combinations
    /// of lower and upper bounds. A parameter with an infinite bound keeps its value.
    pub(crate) fn with_bounds<'a>(&'a self, of: &[usize]) -> impl Iterator<Item = Vec<f64>> + 'a {
        let bounds = |k: &usize| Some((*k, self.bounds(*k)?));
        let (bounded, unbounded): (Vec<_>, Vec<_>) = of
            .iter()
            .filter_map(bounds)
            .partition(|(_, bounds)| bounds.iter().all(|bound| bound.is_finite()));
        let corners = if bounded.is_empty() {
            0
        } else {
            1_usize << bounded.len()
        };
        // if all parameters of `of` are bounded, they have the same values in the copies of every
        // scenario: copies of the first scenario are enough
        let others = if unbounded.is_empty() {
            1
        } else {
            self.points.len()
        };
        let cornered = (0..corners).flat_map(move |corner| {
            let bounded = bounded.clone();
            self.points.iter().take(others).map(move |point| {
                let mut point = point.clone();
                for (i, (k, bounds)) in bounded.iter().enumerate() {
                    point[*k] = bounds[(corner >> i) & 1];
                }
                point
            })
        });
        self.points.iter().cloned().chain(cornered)
    }

    /// True if the distribution of the parameter with index `of` has an infinite bound. The
    /// distribution then has values beyond the values of the scenarios.
    pub(crate) fn is_unbounded(&self, of: usize) -> bool {
        self.bounds(of)
            .is_some_and(|bounds| bounds.iter().any(|bound| bound.is_infinite()))
    }

    /// One scenario: the mean of each parameter.
    pub fn mean(swings: &Swings) -> Self {
        Self {
            parameters: swings.parameters(),
            points: vec![swings.means()],
            weights: vec![1.0],
            rule: Rule::Recorded,
            distributed: None,
        }
    }
}

fn equally_weighted(points: Vec<Vec<f64>>) -> (Vec<Vec<f64>>, Vec<f64>) {
    let weights = vec![1.0 / points.len() as f64; points.len()];
    (points, weights)
}

/// Point `k` of a scrambled Sobol' sequence. Its coordinates are converted to independent normal
/// scores within ±`REACH`. `factor` correlates the scores. Each score is converted to the value of
/// its distribution.
fn sequence_point(inputs: &[Uncertain], factor: &[Vec<f64>], k: u64, seed: u32) -> Vec<f64> {
    let normal = Normal::standard();
    let beyond = normal.cdf(-REACH);
    let score = |i: usize| {
        let share = beyond + (1.0 - 2.0 * beyond) * sobol::coordinate(k, i, seed);
        normal.inverse_cdf(share)
    };
    let scores: Vec<f64> = (0..inputs.len()).map(score).collect();
    inputs
        .iter()
        .zip(correlated(factor, &scores))
        .map(|(input, score)| at_score(input, score))
        .collect()
}

/// Product of Gauss rules, one for each parameter. A parameter without correlations has the rule of
/// its distribution. A correlated parameter has the rule of its normal score.
fn quadrature_points(
    inputs: &[Uncertain],
    factor: &[Vec<f64>],
    nodes: usize,
) -> (Vec<Vec<f64>>, Vec<f64>) {
    const SCORE: Distribution = Distribution::Normal {
        mean: 0.0,
        deviation: 1.0,
    };
    let is_correlated = |i: usize| {
        factor[i][..i].iter().any(|l| *l != 0.0)
            || factor.iter().skip(i + 1).any(|row| row[i] != 0.0)
    };
    let mut points = vec![(vec![], 1.0)];
    for (i, input) in inputs.iter().enumerate() {
        let distribution = if is_correlated(i) {
            &SCORE
        } else {
            &input.distribution
        };
        let rule = rule(distribution, nodes);
        let longer = |(point, weight): &(Vec<f64>, f64)| {
            rule.iter()
                .map(|(node, part)| ([point.as_slice(), &[*node]].concat(), weight * part))
                .collect::<Vec<_>>()
        };
        points = points.iter().flat_map(longer).collect();
    }
    let placed = |(nodes, weight): (Vec<f64>, f64)| {
        let scores = correlated(factor, &nodes);
        let value = |(i, input): (usize, &Uncertain)| {
            if is_correlated(i) {
                at_score(input, scores[i])
            } else {
                nodes[i]
            }
        };
        let point: Vec<f64> = inputs.iter().enumerate().map(value).collect();
        (point, weight)
    };
    points.into_iter().map(placed).unzip()
}

/// Value of the distribution whose normal score is `score`.
fn at_score(input: &Uncertain, score: f64) -> f64 {
    match input.distribution {
        Distribution::Normal { mean, deviation } => mean + deviation * score,
        other => other.quantile(Normal::standard().cdf(score)),
    }
}

/// Correlated normal scores L z from independent scores z.
fn correlated(factor: &[Vec<f64>], scores: &[f64]) -> Vec<f64> {
    factor
        .iter()
        .map(|row| row.iter().zip(scores).map(|(l, z)| l * z).sum())
        .collect()
}
