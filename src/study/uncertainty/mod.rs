//! Uncertainty propagation: outcomes of a drive with uncertain parameters, by derivatives and by
//! sampling.
//!
//! ```text
//!   distributions ──▶ delta method: exact gradient and Hessian at the means
//!                 └─▶ sample, flown ──▶ moments, Sobol' indices, landing ellipses
//!                                   └─▶ exact gradients at the sample ──▶ bounds of total indices
//! ```

pub(super) mod bootstrap;
mod delta;
mod distribution;
mod ellipse;
mod model;

pub use bootstrap::Interval;
pub use delta::{DeltaMoments, delta_method};
pub(super) use distribution::dense_part;
pub use distribution::{Distribution, Uncertain};
use ellipse::LandingMoments;
pub use ellipse::{EllipseSource, LandingEllipse, LandingPoint, SampledEllipse};
use model::LEAST_POINTS;
use model::mean;
pub(super) use model::varies;
pub use model::{Indices, SaltelliDesign, SampleEstimate, SamplePlan, Statistics};

use crate::batch::{Batch, Block, CHUNK, Status, StatusCounts};
use crate::derivative::{Order, Taylor, evaluate};
use crate::drive::{Outcome, OutcomeGroup};
use crate::error::{Error, Result};
use crate::json::number;
use crate::parameters::{Parameter, Setup};
use crate::units::{Message, counted, significant};
use rayon::prelude::*;
use serde::Serialize;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Fractions of the landings for which ellipses are computed.
pub const SHARES: [f64; 2] = [0.5, 0.95];

/// Largest fraction of sampled drives without a landing whose other drives still represent the
/// distributions. Example: if the allowed range ends 2 standard deviations above the mean of a
/// normal distribution, 2.3 % of the values are outside, which is too many.
pub(super) const MOST_LOST: f64 = 0.02;

/// A total index up to this share of the variance counts as zero.
const NO_SHARE: f64 = 1e-6;
/// An upper bound is wrong if its interval lies below this fraction of the lower end of the total
/// index: the outcome jumps, so that its slopes say nothing. A bound nearer to the index may differ
/// by noise.
const BELOW: f64 = 0.9;

/// Uncertainty of a drive.
#[derive(Clone, Debug)]
pub struct Uncertainty {
    /// The uncertain parameters.
    pub inputs: Vec<Uncertain>,
    /// Uncertainty of each outcome.
    pub outcomes: Vec<OutcomeUncertainty>,
    /// Number of drives by status. The sample has N (d + 2) drives for N points and d parameters.
    pub status_counts: StatusCounts,
    /// Size and seed of the sample.
    pub plan: SamplePlan,
    /// Landing ellipses; empty unless carry and lateral are requested.
    pub ellipses: Vec<SampledEllipse>,
}

impl Uncertainty {
    /// Number of drives that do not land although their values are allowed, as a fraction of all
    /// drives.
    pub fn part_without_landing(&self) -> f64 {
        self.part_of(|status| !matches!(status, Status::Landed | Status::OutOfRange))
    }

    /// Warnings if the values of many drives are not allowed, or if many drives do not land: the
    /// results are computed from the other drives, which do not represent the distributions. A
    /// warning if the sample is too small for intervals, quantiles and shares of the variance.
    pub fn warnings(&self) -> Vec<Message> {
        let percent = |part: f64| significant(100.0 * part, 2);
        let outside = self.part_of(|status| status == Status::OutOfRange);
        let outside = (outside > MOST_LOST).then(|| {
            format!(
                "{} % of the drives have a value outside of its allowed range and are left out: \
                 mean, deviation and shares are computed from the other drives; limit the \
                 distribution with truncated(MEAN,DEVIATION,LOW,HIGH)",
                percent(outside)
            )
        });
        let (missing, flies) = (
            self.part_without_landing(),
            self.outcomes
                .iter()
                .any(|each| each.of.group() == OutcomeGroup::Flight),
        );
        let missing = (flies && missing > MOST_LOST).then(|| {
            format!(
                "{} % of the drives do not land: mean, deviation and shares of each outcome of the \
                 flight are computed from the drives that land, which are not a sample of the \
                 distributions",
                percent(missing)
            )
        });
        let is_small = |outcome: &&OutcomeUncertainty| {
            let sampled = outcome.monte_carlo.as_ref();
            outcome.varies && sampled.is_some_and(|sampled| sampled.quantiles.is_none())
        };
        let small: Vec<_> = self.outcomes.iter().filter(is_small).collect();
        let small = (!small.is_empty()).then(|| {
            let names: Vec<_> = small.iter().map(|outcome| outcome.of.name()).collect();
            format!(
                "{}: 95 % intervals, quantiles and shares of the variance need {LEAST_POINTS} \
                 points or more that have the outcome; `samples` sets the number of points",
                names.join(", ")
            )
        });
        outside
            .into_iter()
            .chain(missing)
            .chain(small)
            .map(Message::from)
            .collect()
    }

    fn part_of(&self, is_meant: impl Fn(Status) -> bool) -> f64 {
        let meant: u64 = self
            .status_counts
            .counts()
            .filter(|(status, _)| is_meant(*status))
            .map(|(_, count)| count)
            .sum();
        meant as f64 / self.status_counts.total() as f64
    }
}

/// The uncertainty of an outcome.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "OutcomeUncertaintyReport"))]
pub struct OutcomeUncertainty {
    /// The outcome.
    pub of: Outcome,
    /// True if the outcome varies by more than rounding errors.
    pub varies: bool,
    /// Value, gradient and Hessian by the uncertain parameters, at the means of the parameters.
    /// `None` if the value or the gradient does not exist.
    #[serde(skip)]
    pub at_means: Option<Taylor>,
    /// The moments from the gradient at the means; `null` if the gradient does not exist.
    pub delta: Option<DeltaMoments>,
    /// The moments from gradient and Hessian at the means; `null` if these do not exist.
    pub second_order: Option<DeltaMoments>,
    /// The statistics of the sample; `null` if fewer than two drives of the sample have the
    /// outcome.
    pub monte_carlo: Option<Statistics>,
    /// The Sobol' indices of each uncertain parameter: its shares in the variance.
    pub indices: Vec<Contribution>,
    /// The parameter whose exact knowledge reduces the uncertainty most; `null` if the outcome does
    /// not vary, if no index is positive, and for a sample of fewer than 100 points.
    pub measure_first: Option<MeasureFirst>,
}

/// The contribution of an uncertain parameter to the variance of an outcome.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "IndicesReport"))]
pub struct Contribution {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// The first-order Sobol' index; `null` for a sample of fewer than 100 points.
    pub first: Option<Interval>,
    /// The total Sobol' index; `null` for a sample of fewer than 100 points.
    pub total: Option<Interval>,
    /// The mean of the squared derivative over the sample, SI.
    // None if the outcome does not vary, if no drive has the derivative, or for too few points
    #[serde(serialize_with = "number")]
    #[cfg_attr(test, schemars(with = "crate::json::JsonNumber"))]
    pub mean_square_slope: Option<f64>,
    /// An estimated upper bound of the total index, from the derivatives of the sample; `null` if
    /// it lies below an index: the outcome jumps, or the sample is too small.
    // C · mean((∂f/∂p)²) / variance, with the Poincaré constant C of the distribution (Sobol' &
    // Kucherenko 2009; Lamboni et al. 2013). The true mean and variance give an upper bound. The
    // sample gives an estimate of this bound, with an interval. Poincaré's inequality does not hold
    // for functions with jumps.
    pub bound: Option<Interval>,
}

/// The parameter whose exact knowledge reduces the uncertainty of an outcome most.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct MeasureFirst {
    /// The parameter.
    pub parameter: &'static Parameter,
    /// The standard uncertainty of the outcome once the parameter is known exactly, SI.
    pub standard_uncertainty: f64,
}

/// The parameter with the largest first-order index, and the root of the mean variance that remains
/// once this parameter is known. `None` if the outcome does not vary, or if no index is positive.
fn measure_first(sampled: &Statistics, indices: &[Contribution]) -> Option<MeasureFirst> {
    let (first, share) = indices
        .iter()
        .filter_map(|one| Some((one.parameter, one.first?)))
        .max_by(|a, b| a.1.value.total_cmp(&b.1.value))
        .filter(|best| best.1.value > 0.0)?;
    let totals: Option<f64> = indices
        .iter()
        .filter(|one| one.parameter != first)
        .map(|one| Some(one.total?.value))
        .sum();
    // knowledge of the parameter leaves the fraction 1 − `share` of the variance. The sum of the
    // other total indices is an upper bound of this fraction. If `share` is close to 1, the sum is
    // the more accurate estimate
    let left = totals
        .filter(|most| *most < 1.0 - share.low)
        .unwrap_or(1.0 - share.value);
    Some(MeasureFirst {
        parameter: first,
        standard_uncertainty: sampled.standard_uncertainty.value * left.max(0.0).sqrt(),
    })
}

/// Uncertainty of outcomes for independent uncertain parameters. `progress` receives the number of
/// finished drives and the number of all drives.
///
/// # Errors
/// [`Error::Nothing`] if `of` or `inputs` is empty; [`Error::SearchRange`] for a parameter given
/// twice; [`Error::Together`] for a sample of fewer than 2 points; the errors of
/// [`Uncertain::check`] and [`Batch::new`].
pub fn uncertainty(
    setup: &Setup<f64>,
    of: &[Outcome],
    inputs: &[Uncertain],
    plan: SamplePlan,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Uncertainty> {
    check(inputs, plan)?;
    let parameters: Vec<_> = inputs.iter().map(|input| input.parameter).collect();
    let distributions: Vec<_> = inputs.iter().map(|input| input.distribution).collect();
    let values = Batch::new(setup, &parameters, of, &[])?;
    let gradients = Batch::new(setup, &parameters, of, &parameters)?;

    let design = SaltelliDesign::new(&distributions, plan)?;
    let total = design.points.len() * plan.samples;
    let done = AtomicUsize::new(0);
    let fly = |(set, points): (usize, &Vec<Vec<f64>>)| {
        // only the drives at the first set of points have gradients
        let batch = if set == 0 { &gradients } else { &values };
        let blocks = points.par_chunks(CHUNK).map(|chunk| {
            let block = batch.evaluate(0, chunk.concat());
            progress(
                done.fetch_add(chunk.len(), Ordering::Relaxed) + chunk.len(),
                total,
            );
            block
        });
        blocks.collect::<Vec<_>>()
    };
    let blocks: Vec<_> = design.points.iter().enumerate().map(fly).collect();
    let mut status_counts = StatusCounts::default();
    blocks
        .iter()
        .flatten()
        .for_each(|block| status_counts.add(block));
    let sample = SampledDrives {
        outcomes: of,
        inputs,
        distributions,
        design,
        at_means: at_means(setup, of, inputs),
        blocks,
    };
    Ok(Uncertainty {
        inputs: inputs.to_vec(),
        outcomes: (0..of.len()).map(|i| sample.outcome(i)).collect(),
        status_counts,
        plan,
        ellipses: sample.ellipses(),
    })
}

fn check(inputs: &[Uncertain], plan: SamplePlan) -> Result<()> {
    if plan.samples < 2 {
        let given = format!("a sample of {}", counted(plan.samples as u64, "point"));
        return Err(Error::Together {
            given,
            reason: "it needs 2 points or more".into(),
        });
    }
    if inputs.is_empty() {
        return Err(Error::Nothing {
            doing: "take samples of",
            what: "uncertain parameter",
        });
    }
    inputs.iter().try_for_each(Uncertain::check)
}

/// The results of the drives at the points of a [`SaltelliDesign`].
struct SampledDrives<'a> {
    outcomes: &'a [Outcome],
    inputs: &'a [Uncertain],
    distributions: Vec<Distribution>,
    design: SaltelliDesign,
    at_means: Vec<Option<Taylor>>,
    /// Results of each set of points of `design`, in blocks.
    blocks: Vec<Vec<Block>>,
}

impl SampledDrives<'_> {
    /// A column of the results at a set of points. The first columns are the outcomes. In set A,
    /// the derivatives of each outcome by each input follow.
    fn column(&self, set: usize, column: usize) -> Vec<Option<f64>> {
        self.blocks[set]
            .iter()
            .flat_map(|block| block.result(column))
            .collect()
    }

    /// Values of outcome `i` at a set of points. Directions are unwrapped: they lie within half a
    /// turn of the value at the means of the parameters. If that value does not exist, the first
    /// sampled value replaces it.
    fn unwrapped(&self, set: usize, i: usize) -> Vec<Option<f64>> {
        let first = || self.column(0, i).into_iter().flatten().next();
        let reference = self.at_means[i]
            .as_ref()
            .map(|taylor| taylor.value)
            .or_else(first)
            .unwrap_or_default();
        self.column(set, i)
            .into_iter()
            .map(|value| Some(self.outcomes[i].unwrap_angle(value?, reference)))
            .collect()
    }

    fn outcome(&self, i: usize) -> OutcomeUncertainty {
        let values: Vec<_> = (0..self.blocks.len())
            .map(|set| self.unwrapped(set, i))
            .collect();
        let squared = |slope: Option<f64>| slope.map(|slope| slope * slope);
        let inputs = self.inputs.len();
        let squares: Vec<Vec<_>> = (0..inputs)
            .map(|k| self.column(0, self.outcomes.len() + i * inputs + k))
            .map(|slopes| slopes.into_iter().map(squared).collect())
            .collect();
        let sampled = self.design.statistics(&values);
        let indices = self.contributions(&values, &squares, sampled.as_ref());
        let exists = |moments: &DeltaMoments| {
            moments.mean.is_finite() && moments.standard_uncertainty.is_finite()
        };
        let at_means = self.at_means[i].clone();
        let moments = at_means
            .as_ref()
            .map(|taylor| delta_method(taylor, &self.distributions))
            .filter(|(first, _)| exists(first));
        OutcomeUncertainty {
            of: self.outcomes[i],
            varies: sampled
                .as_ref()
                .is_none_or(|sampled| sampled.standard_uncertainty.value > 0.0),
            at_means,
            delta: moments.map(|(first, _)| first),
            second_order: moments.and_then(|(_, second)| second).filter(exists),
            measure_first: sampled
                .as_ref()
                .and_then(|sampled| measure_first(sampled, &indices)),
            indices,
            monte_carlo: sampled,
        }
    }

    /// The contribution of each parameter to the variance of an outcome: its indices from
    /// `sampled`, and the upper bound of its total index from `squares`, the squared derivatives at
    /// the points of set A.
    fn contributions(
        &self,
        values: &[Vec<Option<f64>>],
        squares: &[Vec<Option<f64>>],
        sampled: Option<&Statistics>,
    ) -> Vec<Contribution> {
        let ratios = self.design.means_by_variance(values, squares);
        let contribution = |(k, ratio): (usize, Option<Interval>)| {
            let Uncertain {
                parameter,
                distribution,
            } = self.inputs[k];
            let indices = sampled.and_then(|sampled| sampled.indices[k]);
            let mean_square = mean(squares[k].iter().copied());
            let poincare = distribution.poincare();
            let bound = ratio.map(|ratio| Interval {
                value: poincare * ratio.value,
                low: poincare * ratio.low,
                high: poincare * ratio.high,
            });
            let bound = bound.filter(|bound| mean_square.is_finite() && bound.high.is_finite());
            let is_below = |bound: &Interval| {
                let total = indices.map_or(0.0, |indices| indices.total.low);
                total > NO_SHARE && bound.high < BELOW * total
            };
            Contribution {
                parameter,
                first: indices.map(|indices| indices.first),
                total: indices.map(|indices| indices.total),
                mean_square_slope: bound.map(|_| mean_square),
                bound: bound.filter(|bound| !is_below(bound)),
            }
        };
        ratios.into_iter().enumerate().map(contribution).collect()
    }

    fn ellipses(&self) -> Vec<SampledEllipse> {
        let place = |wanted: Outcome| self.outcomes.iter().position(|of| *of == wanted);
        let (Some(lateral), Some(carry)) = (place(Outcome::Lateral), place(Outcome::Carry)) else {
            return vec![];
        };
        let values = |i: usize| (0..2).flat_map(move |set| self.column(set, i));
        let landings: Vec<_> = values(lateral)
            .zip(values(carry))
            .filter_map(|(y, z)| Some([y?, z?]))
            .collect();
        let by_gradient = self.at_means[lateral]
            .as_ref()
            .zip(self.at_means[carry].as_ref());
        ellipses(&landings, by_gradient, &self.distributions)
    }
}

/// Each outcome with its gradient and Hessian at the means of all uncertain parameters; `None` if
/// the outcome or its gradient does not exist.
fn at_means(setup: &Setup<f64>, of: &[Outcome], inputs: &[Uncertain]) -> Vec<Option<Taylor>> {
    let parameters: Vec<_> = inputs.iter().map(|input| input.parameter).collect();
    let means: Vec<_> = inputs
        .iter()
        .map(|input| input.distribution.mean())
        .collect();
    let at = setup.with_values(&parameters, &means).ok();
    let taylor = |of: &Outcome| {
        let of_order = |order| {
            evaluate(at.as_ref()?, &[*of], &parameters, order)
                .ok()?
                .pop()
        };
        // the gradient may exist even if the Hessian does not
        of_order(Order::Second).or_else(|| of_order(Order::First))
    };
    of.iter().map(taylor).collect()
}

/// Covariance J Σ Jᵀ of two outcomes to first order, for independent parameters with these
/// variances. J is the Jacobian.
fn covariance(of: [&Taylor; 2], variances: &[f64]) -> [[f64; 2]; 2] {
    let product = |i: usize, j: usize| {
        let terms = of[i].gradient.iter().zip(&of[j].gradient).zip(variances);
        terms
            .map(|((a, b), variance)| a * b * variance)
            .sum::<f64>()
    };
    [
        [product(0, 0), product(0, 1)],
        [product(1, 0), product(1, 1)],
    ]
}

/// Ellipses of landings [lateral, carry], m: first from the covariance of the sample, then from the
/// gradients at the means. Empty for fewer than two landings.
fn ellipses(
    landings: &[[f64; 2]],
    by_gradient: Option<(&Taylor, &Taylor)>,
    distributions: &[Distribution],
) -> Vec<SampledEllipse> {
    if landings.len() < 2 {
        return vec![];
    }
    let n = landings.len() as f64;
    let linear = by_gradient.map(|(lateral, carry)| {
        let variances: Vec<f64> = distributions
            .iter()
            .map(|distribution| distribution.central_moments()[0])
            .collect();
        LandingMoments {
            mean: [lateral.value, carry.value],
            covariance: covariance([lateral, carry], &variances),
        }
    });
    let ellipse = |by: EllipseSource, moments: LandingMoments, share: f64| {
        let ellipse = LandingEllipse::new(share, moments.mean, moments.covariance);
        let within = landings
            .iter()
            .filter(|landing| ellipse.contains(**landing))
            .count();
        SampledEllipse {
            ellipse,
            by,
            holds: within as f64 / n,
        }
    };
    let sampled = LandingMoments::of_sample(landings);
    let sampled = SHARES.map(|share| ellipse(EllipseSource::Sample, sampled, share));
    let exists = |linear: &LandingMoments| {
        let mut entries = linear.covariance.iter().flatten();
        entries.all(|entry| entry.is_finite())
    };
    let linear = linear.filter(exists);
    let linear =
        linear.map(|linear| SHARES.map(|share| ellipse(EllipseSource::Gradient, linear, share)));
    sampled
        .into_iter()
        .chain(linear.into_iter().flatten())
        .collect()
}
