//! Certificate of a drive's derivatives: comparison with finite differences and with num-dual, an
//! implicit function test of the landing, smoothness where the number of steps changes, convergence
//! with the time step, and detection tests with injected errors.

mod agreement;
mod continuity;
mod convergence;
mod detection;
mod landing;
mod order;

mod rows;
mod scale;
mod step;

pub use agreement::Agreement;
pub use continuity::Continuity;
pub use convergence::Convergence;
use detection::LandingTerms;
pub use detection::{DetectionTest, InjectedError};
pub use landing::AtLanding;
pub use rows::Row;
pub use step::StepError;

use crate::derivative::check::Verdict;
use crate::derivative::{Order, evaluate};
use crate::drive::{Drive, Outcome, OutcomeGroup};
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup};
use crate::units::Message;
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Maximum number of failures named per check.
const NAMED: usize = 3;

/// An outcome without derivatives, with the reason.
pub type Missing = (Outcome, Message);

/// A check that was not run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotExamined {
    /// Name of the check: "convergence with the time step".
    pub check: String,
    /// Reason.
    pub reason: &'static str,
}

/// Results of all checks of a drive's derivatives.
#[derive(Clone, Debug)]
pub struct Certificate {
    /// Each outcome by each parameter, in descending order of severity.
    pub rows: Vec<Row>,
    /// Derivatives at the landing compared with differences at a fixed time; empty without a
    /// suitable landing.
    pub landing: Vec<AtLanding>,
    /// Smoothness of each flight outcome where the number of steps changes.
    pub continuity: Vec<Continuity>,
    /// Convergence of each flight outcome with the time step.
    pub convergence: Vec<Convergence>,
    /// Truncation error of each flight outcome and its derivatives; reported without verdict.
    pub step: Vec<StepError>,
    /// Checks that were not run.
    pub not_examined: Vec<NotExamined>,
    /// Detection tests with injected errors.
    pub planted: [DetectionTest; 3],
    /// Outcomes that have no derivatives at this drive, with the reason.
    pub missing: Vec<Missing>,
    /// Non-differentiable points that the drive lies on.
    pub corners: Vec<String>,
    /// Numbers of finished and of all parameters, if the certificate was interrupted.
    pub stopped: Option<[usize; 2]>,
}

impl Certificate {
    /// True if the certificate is complete and not empty, no check failed, and every injected error
    /// was detected.
    pub fn passed(&self) -> bool {
        !self.rows.is_empty() && self.stopped.is_none() && self.failures().is_empty()
    }

    /// The failed checks: "convergence with the time step (landing_speed)"; empty if none failed.
    pub fn failures(&self) -> Vec<String> {
        fn part(name: &str, failed: impl Iterator<Item = String>) -> Option<String> {
            let all: Vec<String> = failed.collect();
            let shown = all[..all.len().min(NAMED)].join(", ");
            let others = all.len().saturating_sub(NAMED);
            let others = if others > 0 {
                format!(" and {others} more")
            } else {
                String::new()
            };
            (!all.is_empty()).then(|| format!("{name} ({shown}{others})"))
        }
        let of = |of: Outcome| of.name().to_owned();
        let second = |row: &&Row| row.first.verdict == Verdict::Pass && row.second_fails();
        let by = |row: &Row| format!("{} by {}", row.of.name(), row.parameter.name);
        let parts = [
            part(
                "first derivatives",
                self.rows
                    .iter()
                    .filter(|row| row.first.verdict == Verdict::Fail)
                    .map(by),
            ),
            part(
                "first derivatives by num-dual",
                self.rows.iter().filter(|row| row.num_dual_fails()).map(by),
            ),
            part(
                "second derivatives",
                self.rows.iter().filter(second).map(by),
            ),
            part(
                "the landing as an implicit function",
                self.landing
                    .iter()
                    .filter(|row| row.check.verdict == Verdict::Fail)
                    .map(|row| format!("{} by {}", row.of.name(), row.parameter.name)),
            ),
            part(
                "smoothness where the number of time steps changes",
                self.continuity
                    .iter()
                    .filter(|found| !found.passed())
                    .map(|found| of(found.of)),
            ),
            part(
                "convergence with the time step",
                self.convergence
                    .iter()
                    .filter(|found| !found.passed())
                    .map(|found| of(found.of)),
            ),
            part(
                "planted errors that were not found",
                self.planted
                    .iter()
                    .filter(|it| !it.is_caught())
                    .map(|it| format!("\"{}\"", it.error.name())),
            ),
        ];
        parts.into_iter().flatten().collect()
    }

    /// True if every injected error was detected in every row.
    pub fn caught(&self) -> bool {
        self.planted.iter().all(DetectionTest::is_caught)
    }
}

/// Certifies the derivatives of outcomes by parameters. `progress` receives the numbers of finished
/// and of all parameters. Once it returns false, the work stops between two drives, and the results
/// so far are returned.
///
/// # Errors
/// The errors of [`evaluate`]. Outcomes that the drive does not have are listed as missing. If the
/// drive has none of the outcomes, the error of the first outcome is returned.
pub fn certify(
    setup: &Setup<f64>,
    of: &[Outcome],
    wrt: &[&'static Parameter],
    progress: &(dyn Fn(usize, usize) -> bool + Sync),
) -> Result<Certificate> {
    if of.is_empty() {
        return Err(Error::Nothing {
            doing: "evaluate",
            what: "outcome",
        });
    }
    let (of, missing) = present(setup, of, wrt)?;
    let drive = Drive::new(setup)?;
    let (done, stopped) = (AtomicUsize::new(0), AtomicBool::new(false));
    let is_stopped = |done: usize| {
        // once stopped, stay stopped
        if !stopped.load(Ordering::Relaxed) && !progress(done, wrt.len()) {
            stopped.store(true, Ordering::Relaxed);
        }
        stopped.load(Ordering::Relaxed)
    };
    let mut rows = rows_by_parameter(setup, &drive, &of, wrt, &done, &is_stopped)?;
    let planted = detection::detection_tests(setup, &rows, LandingTerms::new(setup, wrt).as_ref());
    rows.sort_by(|a, b| {
        a.verdict()
            .cmp(&b.verdict())
            .then(b.severity().total_cmp(&a.severity()))
    });

    let has_corner = rows.iter().any(|row| row.verdict() == Verdict::Corner);
    let flown: Vec<Outcome> = of
        .iter()
        .copied()
        .filter(|of| of.group() == OutcomeGroup::Flight)
        .collect();
    // at a corner no outcome is smooth; the row of each parameter reports the corner
    let is_smooth = !flown.is_empty() && !has_corner;
    let done = done.into_inner();
    let goes_on = || is_smooth && !is_stopped(done);
    let pair = &wrt[..wrt.len().min(2)];
    let landing = if goes_on() {
        landing::at_landing(setup, wrt)?
    } else {
        vec![]
    };
    let continuity = if goes_on() {
        continuity::continuity(setup, &flown, pair, &goes_on)?
    } else {
        vec![]
    };
    let convergence = if goes_on() {
        convergence::convergence(setup, &flown, pair, &goes_on)?
    } else {
        vec![]
    };
    let step = if flown.is_empty() || is_stopped(done) {
        vec![]
    } else {
        step::step_errors(setup, &flown, wrt)?
    };
    let is_interrupted = stopped.load(Ordering::Relaxed);
    let conditions = Conditions {
        is_interrupted,
        has_corner,
        has_log_wind: setup.wind.roughness.is_some(),
    };
    let empty = [
        landing.is_empty(),
        continuity.is_empty(),
        convergence.is_empty(),
    ];
    let not_examined = if flown.is_empty() {
        vec![]
    } else {
        conditions.not_examined(empty)
    };
    Ok(Certificate {
        stopped: is_interrupted.then_some([done, wrt.len()]),
        step,
        not_examined,
        landing,
        continuity,
        convergence,
        planted,
        rows,
        missing,
        corners: drive.corners(setup),
    })
}

/// The rows of all parameters, in parallel; `done` counts the finished parameters.
fn rows_by_parameter(
    setup: &Setup<f64>,
    drive: &Drive<f64>,
    of: &[Outcome],
    wrt: &[&'static Parameter],
    done: &AtomicUsize,
    is_stopped: &(dyn Fn(usize) -> bool + Sync),
) -> Result<Vec<Row>> {
    let exact = evaluate(setup, of, wrt, Order::First)?;
    let is_stopped_now = || is_stopped(done.load(Ordering::Relaxed));
    let by_parameter = wrt.par_iter().enumerate().map(|(k, parameter)| {
        if is_stopped_now() {
            return Ok(vec![]);
        }
        let slopes: Vec<f64> = exact.iter().map(|taylor| taylor.gradient[k]).collect();
        let rows = rows::rows(setup, drive, of, parameter, &slopes, &is_stopped_now)?;
        let Some(rows) = rows else {
            return Ok(vec![]);
        };
        is_stopped(done.fetch_add(1, Ordering::Relaxed) + 1);
        Ok(rows)
    });
    Ok(by_parameter.collect::<Result<Vec<_>>>()?.concat())
}

/// Conditions that prevent the checks of the flight.
struct Conditions {
    is_interrupted: bool,
    has_corner: bool,
    has_log_wind: bool,
}

impl Conditions {
    /// The checks without a result, with the reason; `empty` is in the order landing, continuity,
    /// convergence.
    fn not_examined(&self, empty: [bool; 3]) -> Vec<NotExamined> {
        let checks = [
            (
                "the landing as an implicit function",
                self.reason("the ground is too far down"),
            ),
            (
                "smoothness where the number of time steps changes",
                self.interruption_or_corner().unwrap_or(
                    "the number does not change within a tenth of the first parameter's size",
                ),
            ),
            (
                "convergence with the time step",
                self.reason(
                    "the steps at which an order shows are too long for this flight, or for the \
                     decay of its spin",
                ),
            ),
        ];
        checks
            .into_iter()
            .zip(empty)
            .filter(|(_, is_empty)| *is_empty)
            .map(|((check, reason), _)| NotExamined {
                check: check.into(),
                reason,
            })
            .collect()
    }

    fn reason(&self, otherwise: &'static str) -> &'static str {
        match self.interruption_or_corner() {
            Some(reason) => reason,
            None if self.has_log_wind => {
                "the logarithmic wind changes within half a metre above the ground, and most of \
                 the compared time steps cross this layer in one step"
            }
            None => otherwise,
        }
    }

    fn interruption_or_corner(&self) -> Option<&'static str> {
        match (self.is_interrupted, self.has_corner) {
            (true, _) => Some("it was interrupted before"),
            (_, true) => Some("an outcome has a corner here"),
            _ => None,
        }
    }
}

/// Separates outcomes that exist, with derivatives, from missing outcomes; at least one must exist.
fn present(
    setup: &Setup<f64>,
    of: &[Outcome],
    wrt: &[&'static Parameter],
) -> Result<(Vec<Outcome>, Vec<Missing>)> {
    let (mut present, mut missing, mut first) = (vec![], vec![], None);
    for &one in of {
        match evaluate(setup, &[one], wrt, Order::First) {
            Ok(_) => present.push(one),
            Err(error) if error.is_an_outcome() => {
                missing.push((one, error.message()));
                first = first.or(Some(error));
            }
            Err(error) => return Err(error),
        }
    }
    match first {
        Some(error) if present.is_empty() => Err(error),
        _ => Ok((present, missing)),
    }
}
