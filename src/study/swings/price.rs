use super::golfer::Swings;
use super::measure::Measure;
use super::optimum::{SwingsOptimum, posed};
use super::read::Goal;
use super::scenarios::Scenarios;
use crate::error::Result;
use crate::optimize::{Observer, minimize_observed};
use crate::parameters::Setup;
use crate::study::uncertainty::Interval;
use statrs::distribution::{ContinuousCDF, StudentsT};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// What it costs to ignore that swings vary.
#[derive(Clone, Debug)]
pub struct Price {
    /// The best design for the mean swing, or why there is none.
    pub nominal: std::result::Result<Nominal, String>,
    /// How far each goal at the best design is known, the objective, then what is limited: by other
    /// scenarios of the same swings. Empty where there are no others.
    pub doubts: Vec<Doubt>,
}

impl Price {
    /// How far the objective is known.
    pub fn doubt(&self) -> Option<&Doubt> {
        self.doubts.first()
    }
}

/// What is best for the mean swing alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Nominal {
    /// The design.
    pub design: Vec<f64>,
    /// The goals with it and the mean swing alone: what it promises.
    pub promised: Vec<f64>,
    /// The goals with it over all swings: what it keeps; `None` where one of them does not fly.
    pub kept: Option<Vec<f64>>,
}

/// What other scenarios make of the same design.
#[derive(Clone, Debug, PartialEq)]
pub enum Doubt {
    /// The error of the quadrature: twice what half as many nodes more change the goal by.
    Quadrature(f64),
    /// The 99 % interval of the goal over all swings, by its scatter over so many independent
    /// sequences of swings. It contains the value that is told.
    Sampling(Interval, usize),
    /// It is not known, since one of the other scenarios does not fly: the swing, and why.
    Unknown(String),
}

/// The quantile of Student's distribution for an interval of 99 %.
const QUANTILE: f64 = 0.995;

/// The price of ignoring that swings vary, and how far the goal is known.
///
/// Neither the mean swing nor the other scenarios were asked about: where they do not fly, that is
/// told in place of what they would say.
///
/// # Errors
/// As [`swings_optimum`](super::swings_optimum).
pub fn price(setup: &Setup<f64>, swings: &Swings, best: &SwingsOptimum) -> Result<Price> {
    computed(setup, swings, best, &Arc::default())
}

/// The same; nothing where `stop` became true before all of it was known.
///
/// # Errors
/// As [`price`].
pub fn price_until(
    setup: &Setup<f64>,
    swings: &Swings,
    best: &SwingsOptimum,
    stop: &Arc<AtomicBool>,
) -> Result<Option<Price>> {
    let found = computed(setup, swings, best, stop);
    if stop.load(Ordering::Relaxed) {
        Ok(None)
    } else {
        found.map(Some)
    }
}

/// The price; of no use once `stop` is true.
fn computed(
    setup: &Setup<f64>,
    swings: &Swings,
    best: &SwingsOptimum,
    stop: &Arc<AtomicBool>,
) -> Result<Price> {
    let search = &best.search;
    let alone = posed(setup, search, Scenarios::mean(swings), stop)?;
    let observer = Observer {
        interrupt: Arc::clone(stop),
        ..Observer::default()
    };
    let design = minimize_observed(
        &alone,
        &alone.domain,
        &alone.start(),
        &search.options,
        observer,
    )?
    .x;
    let kept = posed(setup, search, best.scenarios.clone(), stop)?
        .values(&design)
        .ok();
    let nominal = alone.values(&design).map(|promised| Nominal {
        design,
        promised,
        kept,
    });
    let nominal = nominal.map_err(|error| error.to_string());
    let doubts = match best.goals() {
        Some(goals) => doubts(setup, swings, best, goals, stop)
            .unwrap_or_else(|error| vec![Doubt::Unknown(error.to_string()); goals.len()]),
        None => vec![],
    };
    Ok(Price { nominal, doubts })
}

/// How far the goals at the best design are known.
fn doubts(
    setup: &Setup<f64>,
    swings: &Swings,
    best: &SwingsOptimum,
    goals: &[f64],
    stop: &Arc<AtomicBool>,
) -> Result<Vec<Doubt>> {
    let (search, x) = (&best.search, &best.solution.x);
    let of: Vec<&Goal> = [&search.of]
        .into_iter()
        .chain(search.subject_to.iter().map(|limit| &limit.goal))
        .collect();
    let finer = match best
        .scenarios
        .rule
        .finer()
        .filter(|_| !of.iter().all(|goal| goal.has_edge()))
    {
        Some(rule) => Some(posed(setup, search, Scenarios::new(swings, rule)?, stop)?.values(x)?),
        None => None,
    };
    let replications = match finer.is_none() || of.iter().any(|goal| goal.has_edge()) {
        true => posed(setup, search, best.scenarios.clone(), stop)?.replications(x)?,
        false => vec![],
    };
    let doubt = |(k, (goal, value)): (usize, (&&Goal, &f64))| match &finer {
        // the error of the finer rule is a small part of that of the other
        Some(finer) if !goal.has_edge() => Doubt::Quadrature(2.0 * (finer[k] - value).abs()),
        _ => {
            let others: Vec<f64> = replications.iter().map(|values| values[k]).collect();
            Doubt::Sampling(interval(goal, *value, &others), others.len())
        }
    };
    if finer.is_none() && replications.is_empty() {
        return Ok(vec![]);
    }
    Ok(of.iter().zip(goals).enumerate().map(doubt).collect())
}

/// The 99 % interval of a goal of which these are independent estimates: Student's about their
/// mean, as wide as to contain the value that is told.
fn interval(goal: &Goal, value: f64, others: &[f64]) -> Interval {
    let n = others.len() as f64;
    let mean = others.iter().sum::<f64>() / n;
    let variance = others.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0);
    let quantile = StudentsT::new(0.0, 1.0, n - 1.0).map_or(f64::NAN, |t| t.inverse_cdf(QUANTILE));
    let reach = quantile * (variance / n).sqrt();
    let (mut low, mut high) = (value.min(mean - reach), value.max(mean + reach));
    if let [(1.0, Measure::Within(..))] = goal.terms.as_slice() {
        (low, high) = (low.max(0.0), high.min(1.0));
    }
    Interval { value, low, high }
}
