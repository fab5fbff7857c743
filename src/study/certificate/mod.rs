//! A certificate of a drive's derivatives: each beside differences and beside num-dual's, the
//! landing as an implicit function, smoothness where the number of steps changes, convergence with
//! the step, and errors planted to see that they are caught.

mod agreement;
mod continuity;
mod convergence;
mod landing;
mod order;
mod planted;
mod rows;
mod scale;
mod step;

pub use agreement::Agreement;
pub use continuity::Continuity;
pub use convergence::Convergence;
pub use landing::AtLanding;
use planted::LandingTerms;
pub use planted::{Plant, Planted};
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

/// So many of what failed in a part are named.
const NAMED: usize = 3;

/// An outcome without derivatives, and why.
pub type Missing = (Outcome, Message);

/// A check that was not made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotExamined {
    /// The check: "convergence with the time step".
    pub check: String,
    /// Why not.
    pub reason: &'static str,
}

/// What was found of the derivatives of a drive.
#[derive(Clone, Debug)]
pub struct Certificate {
    /// Each outcome by each parameter, the worst first.
    pub rows: Vec<Row>,
    /// Derivatives at the landing beside differences at a fixed time; empty where there is no
    /// landing that can be held so.
    pub landing: Vec<AtLanding>,
    /// Each outcome of the flight where the number of steps changes.
    pub continuity: Vec<Continuity>,
    /// How each outcome of the flight converges with the step.
    pub convergence: Vec<Convergence>,
    /// What the time step leaves of an error in each outcome of the flight and its derivatives:
    /// measured, and not judged.
    pub step: Vec<StepError>,
    /// The checks that were not made of this drive, and why.
    pub not_examined: Vec<NotExamined>,
    /// The planted errors.
    pub planted: [Planted; 3],
    /// Outcomes that the drive has no derivatives of, and why.
    pub missing: Vec<Missing>,
    /// Corners that the drive lies on, in words.
    pub corners: Vec<String>,
    /// Where it was stopped before its end: by how many parameters of how many there are rows.
    pub stopped: Option<[usize; 2]>,
}

impl Certificate {
    /// Whether there was something to certify, it was looked at to the end, nothing failed, and
    /// every planted error was caught.
    pub fn passed(&self) -> bool {
        !self.rows.is_empty() && self.stopped.is_none() && self.failures().is_empty()
    }

    /// The parts that failed, in words: "convergence with the time step (landing_speed)"; empty
    /// where none did.
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
                    .map(|it| format!("\"{}\"", it.plant.name())),
            ),
        ];
        parts.into_iter().flatten().collect()
    }

    /// Whether every planted error was caught wherever it was planted.
    pub fn caught(&self) -> bool {
        self.planted.iter().all(Planted::is_caught)
    }
}

/// Certifies the derivatives of some outcomes by some parameters, telling `progress`, again and
/// again, how many parameters of how many are done. It ends with what there is once `progress` says
/// that it is not to go on: between any two drives.
///
/// # Errors
/// What [`evaluate`] refuses. Outcomes that the drive does not have are listed as missing; where it
/// has none of them, the first says why.
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
    let exact = evaluate(setup, &of, wrt, Order::First)?;
    let (done, stopped) = (AtomicUsize::new(0), AtomicBool::new(false));
    let is_stopped = |done: usize| {
        // once it is to stop, it stays so
        if !stopped.load(Ordering::Relaxed) && !progress(done, wrt.len()) {
            stopped.store(true, Ordering::Relaxed);
        }
        stopped.load(Ordering::Relaxed)
    };
    let by_parameter = wrt.par_iter().enumerate().map(|(k, parameter)| {
        let slopes: Vec<f64> = exact.iter().map(|taylor| taylor.gradient[k]).collect();
        if is_stopped(done.load(Ordering::Relaxed)) {
            return Ok(vec![]);
        }
        let is_stopped_now = || is_stopped(done.load(Ordering::Relaxed));
        let Some(rows) = rows::rows(setup, &drive, &of, parameter, &slopes, &is_stopped_now)?
        else {
            return Ok(vec![]);
        };
        is_stopped(done.fetch_add(1, Ordering::Relaxed) + 1);
        Ok(rows)
    });
    let mut rows = by_parameter.collect::<Result<Vec<_>>>()?.concat();
    let planted = planted::planted(setup, &rows, LandingTerms::new(setup, wrt).as_ref());
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
    // at a corner of the model nothing is smooth, and what is said of each parameter is said in its
    // row
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
    let (is_interrupted, has_log_wind) = (
        stopped.load(Ordering::Relaxed),
        setup.wind.roughness.is_some(),
    );
    let why = |otherwise: &'static str| match (is_interrupted, has_corner, has_log_wind) {
        (true, ..) => "it was interrupted before",
        (_, true, _) => "an outcome has a corner here",
        (_, _, true) => {
            "the logarithmic wind changes over half a metre of height above the ground, which most \
             of the time steps compared cross at once"
        }
        _ => otherwise,
    };
    let mut not_examined = vec![];
    let mut skipped = |is_skipped: bool, check: String, reason: &'static str| {
        if is_skipped && !flown.is_empty() {
            not_examined.push(NotExamined { check, reason });
        }
    };
    skipped(
        landing.is_empty(),
        "the landing as an implicit function".into(),
        why("the ground is too far down"),
    );
    let unchanged = "the number does not change within a tenth of the first parameter's size";
    let reason = if has_corner || is_interrupted {
        why("")
    } else {
        unchanged
    };
    skipped(
        continuity.is_empty(),
        "smoothness where the number of time steps changes".into(),
        reason,
    );
    skipped(
        convergence.is_empty(),
        "convergence with the time step".into(),
        why(
            "the flight cannot be followed, or the spin fades, within the steps that an order \
             shows at",
        ),
    );
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

/// The outcomes that the drive has derivatives of, at least one, and those that it has not.
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
