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
    /// How far the goal at the best design is known: by other scenarios of the same swings. `None` where there are no others.
    pub doubt: Option<Doubt>,
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
    /// How much one and a half times as many nodes change the goal: the error of the quadrature.
    Quadrature(f64),
    /// The 95 % interval of the goal, by how it scatters over so many independent sequences of as many scenarios, each.
    Sampling(Interval, usize),
    /// It is not known, since one of the other scenarios does not fly: the swing, and why.
    Unknown(String),
}

/// Independent sequences that the error of sampling is read from.
const SEQUENCES: u32 = 8;

/// The price of ignoring that swings vary, and how far the goal is known.
///
/// Neither the mean swing nor the other scenarios were asked about: where they do not fly, that is told in place of what they would say.
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
    if stop.load(Ordering::Relaxed) { Ok(None) } else { found.map(Some) }
}

/// The price; of no use once `stop` is true.
fn computed(setup: &Setup<f64>, swings: &Swings, best: &SwingsOptimum, stop: &Arc<AtomicBool>) -> Result<Price> {
    let search = &best.search;
    let alone = posed(setup, search, Scenarios::mean(swings), stop)?;
    let observer = Observer { interrupt: Arc::clone(stop), ..Observer::default() };
    let design = minimize_observed(&alone, &alone.domain, &alone.start(), &search.options, observer)?.x;
    let kept = posed(setup, search, best.scenarios.clone(), stop)?.values(&design).ok();
    let nominal = alone.values(&design).map(|promised| Nominal { design, promised, kept });
    let nominal = nominal.map_err(|error| error.to_string());
    let others = (0..SEQUENCES).map_while(|round| best.scenarios.rule.other(round));
    let others = others.map(|rule| {
        let problem = posed(setup, search, Scenarios::new(swings, rule)?, stop)?;
        Ok(problem.values(&best.solution.x)?[0])
    });
    let others = others.collect::<Result<Vec<f64>>>();
    let doubt = match (best.value(), others.as_deref()) {
        (None, _) | (_, Ok([])) => None,
        (_, Err(error)) => Some(Doubt::Unknown(error.to_string())),
        (Some(value), Ok([other])) => Some(Doubt::Quadrature((other - value).abs())),
        (Some(value), Ok(others)) => Some(Doubt::Sampling(interval(&search.of, value, others), others.len())),
    };
    Ok(Price { nominal, doubt })
}

/// The 95 % interval of a goal of which these are independent estimates, about the one that is shown.
fn interval(goal: &Goal, value: f64, others: &[f64]) -> Interval {
    let all = || others.iter().copied().chain([value]);
    let n = all().count() as f64;
    let mean = all().sum::<f64>() / n;
    let variance = all().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0);
    let reach = StudentsT::new(0.0, 1.0, n - 1.0).map_or(f64::NAN, |t| t.inverse_cdf(0.975)) * variance.sqrt();
    let (mut low, mut high) = (value - reach, value + reach);
    if let [(1.0, Measure::Within(..))] = goal.terms.as_slice() {
        (low, high) = (low.max(0.0), high.min(1.0));
    }
    Interval { value, low, high }
}
