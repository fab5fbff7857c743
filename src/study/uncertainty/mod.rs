//! What is uncertain about a drive whose parameters are: by its derivatives, and by many drives.
//!
//! ```text
//!   distributions ──▶ delta method: exact gradient and Hessian at the means
//!                 └─▶ sample, flown ──▶ moments, Sobol' shares, landing ellipses
//!                                   └─▶ exact gradients at the sample ──▶ bounds on the total shares
//! ```

mod delta;
mod distribution;
mod ellipse;
mod model;

pub use delta::{Moments, delta_method};
pub use distribution::{Distribution, Uncertain};
pub use ellipse::LandingEllipse;
pub use model::{Design, Indices, Interval, Plan, Statistics};

use crate::batch::{Batch, CHUNK, Status, Tally};
use crate::derivative::{Order, Taylor, evaluate};
use crate::drive::{Outcome, OutcomeGroup};
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup};
use crate::units::{Message, counted, significant};
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The shares of the landings that ellipses are drawn for.
pub const SHARES: [f64; 2] = [0.5, 0.95];

/// What is uncertain about a drive.
#[derive(Clone, Debug)]
pub struct Uncertainty {
    /// The uncertain parameters.
    pub inputs: Vec<Uncertain>,
    /// Each outcome.
    pub outcomes: Vec<OutcomeUncertainty>,
    /// How the drives of the sample ended, all N (d + 2) of them.
    pub tally: Tally,
    /// How the sample was taken.
    pub plan: Plan,
    /// Ellipses of the landings; empty unless carry and lateral are asked for.
    pub ellipses: Vec<SampledEllipse>,
}

impl Uncertainty {
    /// The part of the drives of the sample that do not land, though their values are allowed.
    pub fn part_without_landing(&self) -> f64 {
        self.part_of(|status| !matches!(status, Status::Landed | Status::OutOfRange))
    }

    /// Warns where many values are such as no drive has, or many drives do not land: the others are
    /// no sample of the distributions any more.
    pub fn warnings(&self) -> Vec<Message> {
        /// A normal distribution that is cut at two standard deviations leaves out as much.
        const MANY: f64 = 0.02;
        let percent = |part: f64| significant(100.0 * part, 2);
        let outside = self.part_of(|status| status == Status::OutOfRange);
        let outside = (outside > MANY).then(|| {
            format!(
                "{} % of the drives have a value outside of what is allowed and are left out: \
                 mean, deviation and shares are of the others; \
                 cut the distribution, as in truncated(MEAN,DEVIATION,LOW,HIGH)",
                percent(outside)
            )
        });
        let (missing, flies) = (
            self.part_without_landing(),
            self.outcomes
                .iter()
                .any(|each| each.of.group() == OutcomeGroup::Flight),
        );
        let missing = (flies && missing > MANY).then(|| {
            format!(
                "{} % of the drives do not land: mean, deviation and shares of a flight are of \
                 those that do, and are no longer those of the distributions",
                percent(missing)
            )
        });
        outside
            .into_iter()
            .chain(missing)
            .map(Message::from)
            .collect()
    }

    fn part_of(&self, is_meant: impl Fn(Status) -> bool) -> f64 {
        let all: u64 = self.tally.counts().map(|(_, count)| count).sum();
        let meant: u64 = self
            .tally
            .counts()
            .filter(|(status, _)| is_meant(*status))
            .map(|(_, count)| count)
            .sum();
        meant as f64 / all as f64
    }
}

/// What is uncertain about an outcome.
#[derive(Clone, Debug)]
pub struct OutcomeUncertainty {
    /// The outcome.
    pub of: Outcome,
    /// Its value, gradient and Hessian by the uncertain parameters at their means; `None` where the
    /// drive there has none.
    pub at_means: Option<Taylor>,
    /// By the gradient, and by gradient and Hessian, at the means; `None` where the drive there has
    /// none.
    pub delta: Option<(Moments, Option<Moments>)>,
    /// By flying; `None` where no drive of the sample has the outcome.
    pub sampled: Option<Statistics>,
    /// An estimate of an upper bound of each uncertain parameter's total share, by exact gradients
    /// (Sobol' & Kucherenko 2009; Lamboni et al. 2013).
    pub slopes: Vec<Option<Slopes>>,
}

/// A derivative-based global sensitivity measure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slopes {
    /// The mean of (∂f/∂p)², SI.
    pub mean_square: f64,
    /// C mean((∂f/∂p)²) / variance, C the Poincaré constant of the distribution. With the true mean
    /// and variance the total share is at most this; here both are those of the sample, so that it
    /// is an estimate, with its interval.
    pub bound: Interval,
}

/// A landing ellipse by the gradients, with the share of the flown landings in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SampledEllipse {
    /// The ellipse.
    pub ellipse: LandingEllipse,
    /// Whether it is of the gradients at the means, or of the sample.
    pub by_gradient: bool,
    /// The share of the landings flown that lie in it.
    pub holds: f64,
}

impl OutcomeUncertainty {
    /// Whether the outcome varies by more than rounding; where it does not, it is the same in every
    /// drive of the sample.
    pub fn varies(&self) -> bool {
        self.sampled
            .as_ref()
            .is_none_or(|sampled| sampled.deviation.value > 0.0)
    }

    /// The parameter to measure first: the one whose knowledge takes most off the variance, and the
    /// standard deviation that is left on average. `None` where the outcome does not vary, or no
    /// parameter's knowledge alone takes anything off.
    pub fn measure_first(&self, inputs: &[Uncertain]) -> Option<(&'static Parameter, f64)> {
        let sampled = self.sampled.as_ref()?;
        let share = |(at, indices): (usize, &Option<Indices>)| Some((at, indices.as_ref()?.first));
        let (first, share) = sampled
            .indices
            .iter()
            .enumerate()
            .filter_map(share)
            .max_by(|a, b| a.1.value.total_cmp(&b.1.value))
            .filter(|best| best.1.value > 0.0)?;
        let others = sampled
            .indices
            .iter()
            .enumerate()
            .filter(|(at, _)| *at != first);
        let totals: Option<f64> = others
            .map(|(_, indices)| Some(indices.as_ref()?.total.value))
            .sum();
        // no more is left than the others' total shares together: next to a share of nearly all
        // these are far better known
        let left = totals
            .filter(|most| *most < 1.0 - share.low)
            .unwrap_or(1.0 - share.value);
        Some((
            inputs[first].parameter,
            sampled.deviation.value * left.max(0.0).sqrt(),
        ))
    }
}

/// What is uncertain about some outcomes where these parameters are, independently of each other;
/// `progress` is told how many drives of how many are done.
///
/// # Errors
/// [`Error::Nothing`] without outcomes or uncertain parameters; [`Error::SearchRange`] for a
/// parameter given twice; [`Error::Together`] for a sample of fewer than 2 points; what
/// [`Uncertain::check`] and [`Batch::new`] refuse.
pub fn uncertainty(
    setup: &Setup<f64>,
    of: &[Outcome],
    inputs: &[Uncertain],
    plan: Plan,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<Uncertainty> {
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
    inputs.iter().try_for_each(Uncertain::check)?;
    let parameters: Vec<_> = inputs.iter().map(|input| input.parameter).collect();
    let distributions: Vec<_> = inputs.iter().map(|input| input.distribution).collect();
    let values = Batch::new(setup, &parameters, of, &[])?;
    let gradients = Batch::new(setup, &parameters, of, &parameters)?;

    let design = Design::new(&distributions, plan)?;
    let total = design.points.len() * plan.samples;
    let done = AtomicUsize::new(0);
    let fly = |(set, points): (usize, &Vec<Vec<f64>>)| {
        // exact gradients at the first set of points
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
    let sets: Vec<_> = design.points.iter().enumerate().map(fly).collect();
    let mut tally = Tally::default();
    sets.iter().flatten().for_each(|block| tally.add(block));

    let at_means = at_means(setup, of, inputs);
    let column = |blocks: &[crate::batch::Block], i: usize| {
        blocks
            .iter()
            .flat_map(|block| block.result(i))
            .collect::<Vec<_>>()
    };
    // directions within half a turn of the one at the means or, where there is none, of the first
    // of the sample
    let column_of = |blocks: &[crate::batch::Block], i: usize| {
        let first = || column(&sets[0], i).into_iter().flatten().next();
        let reference = at_means[i]
            .as_ref()
            .map(|taylor| taylor.value)
            .or_else(first)
            .unwrap_or_default();
        column(blocks, i)
            .into_iter()
            .map(|value| Some(of[i].unwrap_angle(value?, reference)))
            .collect::<Vec<_>>()
    };
    let of_len = of.len();
    let outcome = |(i, of): (usize, &Outcome)| {
        let values: Vec<_> = sets.iter().map(|blocks| column_of(blocks, i)).collect();
        let squared = |slope: Option<f64>| slope.map(|slope| slope * slope);
        // the outcomes' columns, then those of their derivatives
        let squares = (0..inputs.len()).map(|k| column(&sets[0], of_len + i * inputs.len() + k));
        let squares: Vec<Vec<_>> = squares
            .map(|slopes| slopes.into_iter().map(squared).collect())
            .collect();
        OutcomeUncertainty {
            of: *of,
            at_means: at_means[i].clone(),
            delta: at_means[i]
                .as_ref()
                .map(|taylor| delta_method(taylor, &distributions))
                .and_then(existing),
            slopes: slopes(&design, &values, &squares, &distributions),
            sampled: design.statistics(&values),
        }
    };
    let outcomes: Vec<_> = of.iter().enumerate().map(outcome).collect();
    let place = |wanted: Outcome| of.iter().position(|of| *of == wanted);
    let ellipses = match (place(Outcome::Lateral), place(Outcome::Carry)) {
        (Some(lateral), Some(carry)) => {
            let landings = |i: usize| {
                sets[..2]
                    .iter()
                    .flat_map(|blocks| column(blocks, i))
                    .collect::<Vec<_>>()
            };
            let landings = landings(lateral)
                .into_iter()
                .zip(landings(carry))
                .filter_map(|(y, z)| Some([y?, z?]));
            let by_gradient = at_means[lateral].as_ref().zip(at_means[carry].as_ref());
            ellipses(&landings.collect::<Vec<_>>(), by_gradient, &distributions)
        }
        _ => vec![],
    };
    Ok(Uncertainty {
        inputs: inputs.to_vec(),
        outcomes,
        tally,
        plan,
        ellipses,
    })
}

/// The moments that are numbers: an uncertainty beyond all measure has squares that are none.
fn existing((first, second): (Moments, Option<Moments>)) -> Option<(Moments, Option<Moments>)> {
    let exists = |moments: &Moments| moments.mean.is_finite() && moments.deviation.is_finite();
    exists(&first).then(|| (first, second.filter(exists)))
}

/// Each outcome with gradient and Hessian where all uncertain parameters have their means; `None`
/// where there is none.
fn at_means(setup: &Setup<f64>, of: &[Outcome], inputs: &[Uncertain]) -> Vec<Option<Taylor>> {
    let mut at = *setup;
    let is_set = inputs.iter().all(|input| {
        at.set_value(input.parameter, Some(input.distribution.mean()))
            .is_ok()
    });
    let parameters: Vec<_> = inputs.iter().map(|input| input.parameter).collect();
    let taylor = |of: &Outcome| {
        let of_order = |order| evaluate(&at, &[*of], &parameters, order).ok()?.pop();
        // a gradient may exist where a Hessian does not
        is_set
            .then(|| of_order(Order::Second).or_else(|| of_order(Order::First)))
            .flatten()
    };
    of.iter().map(taylor).collect()
}

/// The measure of each parameter from the squares of its derivatives at the first set of points,
/// those that exist.
fn slopes(
    design: &Design,
    values: &[Vec<Option<f64>>],
    squares: &[Vec<Option<f64>>],
    distributions: &[Distribution],
) -> Vec<Option<Slopes>> {
    let mean = |squares: &Vec<Option<f64>>| {
        let (sum, count) = squares
            .iter()
            .flatten()
            .fold((0.0, 0.0), |(sum, count), square| {
                (sum + square, count + 1.0)
            });
        sum / count
    };
    let one = |((bound, squares), distribution): (
        (Option<Interval>, &Vec<Option<f64>>),
        &Distribution,
    )| {
        let Interval { value, low, high } = bound?;
        let [value, low, high] = [value, low, high].map(|end| distribution.poincare() * end);
        let slopes = Slopes {
            mean_square: mean(squares),
            bound: Interval { value, low, high },
        };
        (slopes.mean_square.is_finite() && high.is_finite()).then_some(slopes)
    };
    design
        .means_by_variance(values, squares)
        .into_iter()
        .zip(squares)
        .zip(distributions)
        .map(one)
        .collect()
}

/// The covariance of two outcomes of independent parameters with these variances, by their
/// gradients: JΣJᵀ.
pub(super) fn covariance(of: [&Taylor; 2], variances: &[f64]) -> [[f64; 2]; 2] {
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

/// The ellipses of landings [lateral, carry], by the sample and by the gradients at the means.
fn ellipses(
    landings: &[[f64; 2]],
    by_gradient: Option<(&Taylor, &Taylor)>,
    distributions: &[Distribution],
) -> Vec<SampledEllipse> {
    if landings.len() < 2 {
        return vec![];
    }
    let n = landings.len() as f64;
    let mean = [0, 1].map(|row| landings.iter().map(|landing| landing[row]).sum::<f64>() / n);
    let product = |i: usize, j: usize| {
        landings
            .iter()
            .map(|landing| (landing[i] - mean[i]) * (landing[j] - mean[j]))
            .sum::<f64>()
            / (n - 1.0)
    };
    let sampled = [
        [product(0, 0), product(0, 1)],
        [product(1, 0), product(1, 1)],
    ];
    let linear = by_gradient.map(|(lateral, carry)| {
        let variances: Vec<f64> = distributions
            .iter()
            .map(|distribution| distribution.central_moments()[0])
            .collect();
        (
            [lateral.value, carry.value],
            covariance([lateral, carry], &variances),
        )
    });
    let ellipse = |by_gradient: bool, centre: [f64; 2], covariance: [[f64; 2]; 2], share: f64| {
        let ellipse = LandingEllipse::new(share, centre, covariance);
        let within = landings
            .iter()
            .filter(|landing| ellipse.contains(**landing))
            .count();
        SampledEllipse {
            ellipse,
            by_gradient,
            holds: within as f64 / n,
        }
    };
    let sampled = SHARES.map(|share| ellipse(false, mean, sampled, share));
    let exists =
        |covariance: &[[f64; 2]; 2]| covariance.iter().flatten().all(|entry| entry.is_finite());
    let linear = linear.filter(|(_, covariance)| exists(covariance));
    let linear = linear
        .map(|(centre, covariance)| SHARES.map(|share| ellipse(true, centre, covariance, share)));
    sampled
        .into_iter()
        .chain(linear.into_iter().flatten())
        .collect()
}
