//! Certificate of a drive's derivatives: comparison with finite differences and with num-dual, an
//! implicit function test of the landing, smoothness where the number of steps changes, convergence
//! with the time step, and detection tests with planted errors.

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
use convergence::LOG_WIND;
pub use detection::{DetectionTest, PlantedError};
pub use landing::AtLanding;
pub use rows::DerivativeRow;
pub use step::StepError;

use crate::derivative::check::Verdict;
use crate::derivative::{Order, evaluate};
use crate::drive::{Drive, Outcome, OutcomeGroup};
use crate::error::{Error, Result};
use crate::parameters::{Parameter, Setup};
use crate::units::Message;
use rayon::prelude::*;
use serde::Serialize;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Names of the checks of the flight.
const LANDING: &str = "the landing as an implicit function";
const CONTINUITY: &str = "smoothness where the number of time steps changes";
const CONVERGENCE: &str = "convergence with the time step";

/// Maximum number of failures named per check.
const NAMED: usize = 3;

/// An outcome without derivatives.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
#[cfg_attr(test, schemars(rename = "MissingOutcome"))]
pub struct Missing {
    /// The outcome.
    pub of: Outcome,
    /// The reason.
    #[serde(rename = "message")]
    pub reason: Message,
}

/// A check that was not run.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub struct NotExamined {
    /// Name of the check: "convergence with the time step".
    pub check: String,
    /// Reason.
    #[serde(rename = "message")]
    pub reason: &'static str,
}

/// Results of all checks of a drive's derivatives.
#[derive(Clone, Debug)]
pub struct Certificate {
    /// Each derivative of an outcome by a parameter: failures first, then corners, then passes,
    /// each in descending order of severity.
    pub rows: Vec<DerivativeRow>,
    /// Derivatives at the landing compared with differences at a fixed time; empty if no landing
    /// can be tested.
    pub landing: Vec<AtLanding>,
    /// Smoothness of each flight outcome where the number of steps changes.
    pub continuity: Vec<Continuity>,
    /// Convergence of each flight outcome with the time step.
    pub convergence: Vec<Convergence>,
    /// Truncation error of each flight outcome and its derivatives; reported without verdict.
    pub step: Vec<StepError>,
    /// Checks that were not run.
    pub not_examined: Vec<NotExamined>,
    /// Detection tests with planted errors.
    pub planted: [DetectionTest; 3],
    /// Outcomes that have no derivatives at this drive, with the reason.
    pub missing: Vec<Missing>,
    /// Non-differentiable points that the drive lies on.
    pub corners: Vec<String>,
    /// Number of finished parameters and number of all parameters, if the certificate was
    /// interrupted.
    pub stopped: Option<[usize; 2]>,
}

impl Certificate {
    /// True if the certificate is complete and not empty, no check failed, and every planted error
    /// was detected.
    pub fn passed(&self) -> bool {
        !self.rows.is_empty() && self.stopped.is_none() && self.failures().is_empty()
    }

    /// The failed checks, such as "convergence with the time step (landing_speed)"; empty if none
    /// failed.
    pub fn failures(&self) -> Vec<String> {
        let by =
            |of: Outcome, parameter: &Parameter| format!("{} by {}", of.name(), parameter.name);
        let rows = |fails: fn(&DerivativeRow) -> bool| -> Vec<String> {
            let failed = self.rows.iter().filter(|row| fails(row));
            failed.map(|row| by(row.of, row.parameter)).collect()
        };
        let landing = self.landing.iter();
        let landing = landing.filter(|row| row.check.verdict == Verdict::Fail);
        let continuity = self.continuity.iter();
        let continuity = continuity.filter(|check| check.verdict == Verdict::Fail);
        let convergence = self.convergence.iter();
        let convergence = convergence.filter(|check| check.verdict == Verdict::Fail);
        let planted = self.planted.iter().filter(|test| !test.is_caught());
        let checks = [
            (
                "first derivatives",
                rows(|row| row.first.verdict == Verdict::Fail),
            ),
            (
                "first derivatives by num-dual",
                rows(|row| row.num_dual_fails()),
            ),
            (
                "second derivatives",
                rows(|row| row.first.verdict == Verdict::Pass && row.second_fails()),
            ),
            (
                LANDING,
                landing.map(|row| by(row.of, row.parameter)).collect(),
            ),
            (
                CONTINUITY,
                continuity.map(|check| check.of.name().into()).collect(),
            ),
            (
                CONVERGENCE,
                convergence.map(|check| check.of.name().into()).collect(),
            ),
            (
                "planted errors that were not found",
                planted
                    .map(|test| format!("\"{}\"", test.error.name()))
                    .collect(),
            ),
        ];
        checks
            .into_iter()
            .filter(|(_, failed)| !failed.is_empty())
            .map(|(check, failed)| failed_check(check, &failed))
            .collect()
    }

    fn check_flight(
        &mut self,
        setup: &Setup<f64>,
        of: &[Outcome],
        wrt: &[&'static Parameter],
        has_corner: bool,
        work: &CertificateProgress<'_>,
    ) -> Result<()> {
        // skip these checks at a corner: no outcome is smooth there, and the rows report the corner
        let goes_on = || !has_corner && !work.report_progress();
        let pair = &wrt[..wrt.len().min(2)];
        if goes_on() {
            self.landing = landing::at_landing(setup, wrt)?;
        }
        if goes_on() {
            self.continuity = continuity::continuity(setup, of, pair, &goes_on)?;
        }
        let mut no_convergence = "";
        if goes_on() {
            match convergence::convergence(setup, of, pair, &goes_on)? {
                Ok(found) => self.convergence = found,
                Err(reason) => no_convergence = reason,
            }
        }
        if !work.report_progress() {
            self.step = step::step_errors(setup, of, wrt)?;
        }
        let prevented = match (work.is_interrupted(), has_corner) {
            (true, _) => Some("it was interrupted before"),
            (_, true) => Some("an outcome has a corner here"),
            _ => None,
        };
        self.not_examined = self.not_examined(prevented, setup, no_convergence);
        Ok(())
    }

    /// The checks of the flight that have no result, each with its reason. `prevented` is the
    /// common reason of all these checks, if there is one. `no_convergence` is the reason for the
    /// convergence check.
    fn not_examined(
        &self,
        prevented: Option<&'static str>,
        setup: &Setup<f64>,
        no_convergence: &'static str,
    ) -> Vec<NotExamined> {
        let checks = [
            (
                LANDING,
                self.landing.is_empty(),
                match setup.wind.roughness {
                    Some(_) => LOG_WIND,
                    None => {
                        "the check lowers the ground by 2000 m, below the range of ground.height"
                    }
                },
            ),
            (
                CONTINUITY,
                self.continuity.is_empty(),
                "the number of time steps stays the same if the first parameter changes by up to \
                 a tenth of its value, or of a typical value",
            ),
            (CONVERGENCE, self.convergence.is_empty(), no_convergence),
        ];
        let not_examined = checks.into_iter().filter(|(_, is_empty, _)| *is_empty);
        not_examined
            .map(|(check, _, reason)| NotExamined {
                check: check.into(),
                reason: prevented.unwrap_or(reason),
            })
            .collect()
    }

    /// True if every planted error was detected in every row.
    pub fn caught(&self) -> bool {
        self.planted.iter().all(DetectionTest::is_caught)
    }
}

/// A failed check with its first failures: "second derivatives (carry by club.loft and 2 more)".
fn failed_check(check: &str, failed: &[String]) -> String {
    let shown = failed[..failed.len().min(NAMED)].join(", ");
    let others = failed.len().saturating_sub(NAMED);
    if others > 0 {
        format!("{check} ({shown} and {others} more)")
    } else {
        format!("{check} ({shown})")
    }
}

/// Certifies the derivatives of outcomes by parameters. `progress` receives the number of finished
/// parameters and the number of all parameters. Once `progress` returns false, the work stops
/// between two drives, and the results so far are returned.
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
    let work = CertificateProgress {
        progress,
        all: wrt.len(),
        done: AtomicUsize::new(0),
        stopped: AtomicBool::new(false),
    };
    let mut rows = rows_by_parameter(setup, &drive, &of, wrt, &work)?;
    let planted = detection::detection_tests(setup, wrt, &rows);
    rows.sort_by(|a, b| {
        a.verdict()
            .cmp(&b.verdict())
            .then(b.severity().total_cmp(&a.severity()))
    });
    let has_corner = rows.iter().any(|row| row.verdict() == Verdict::Corner);
    let flown: Vec<Outcome> = of
        .into_iter()
        .filter(|of| of.group() == OutcomeGroup::Flight)
        .collect();
    let mut certificate = Certificate {
        rows,
        landing: vec![],
        continuity: vec![],
        convergence: vec![],
        step: vec![],
        not_examined: vec![],
        planted,
        missing,
        corners: drive.corners(setup),
        stopped: None,
    };
    if !flown.is_empty() {
        certificate.check_flight(setup, &flown, wrt, has_corner, &work)?;
    }
    let done = work.done.load(Ordering::Relaxed);
    certificate.stopped = work.is_interrupted().then_some([done, work.all]);
    Ok(certificate)
}

struct CertificateProgress<'a> {
    /// Receives the number of finished parameters and the number of all parameters; false stops the
    /// work.
    progress: &'a (dyn Fn(usize, usize) -> bool + Sync),
    /// Number of parameters.
    all: usize,
    /// Number of finished parameters.
    done: AtomicUsize,
    stopped: AtomicBool,
}

impl CertificateProgress<'_> {
    /// Reports the progress; true once the work is stopped.
    fn report_progress(&self) -> bool {
        let done = self.done.load(Ordering::Relaxed);
        // once stopped, stay stopped
        if !self.is_interrupted() && !(self.progress)(done, self.all) {
            self.stopped.store(true, Ordering::Relaxed);
        }
        self.is_interrupted()
    }

    fn is_interrupted(&self) -> bool {
        self.stopped.load(Ordering::Relaxed)
    }
}

fn rows_by_parameter(
    setup: &Setup<f64>,
    drive: &Drive<f64>,
    of: &[Outcome],
    wrt: &[&'static Parameter],
    work: &CertificateProgress<'_>,
) -> Result<Vec<DerivativeRow>> {
    let exact = evaluate(setup, of, wrt, Order::First)?;
    let by_parameter = wrt.par_iter().enumerate().map(|(k, parameter)| {
        if work.report_progress() {
            return Ok(vec![]);
        }
        let slopes: Vec<f64> = exact.iter().map(|taylor| taylor.gradient[k]).collect();
        let is_stopped = || work.report_progress();
        let rows = rows::rows(setup, drive, of, parameter, &slopes, &is_stopped)?;
        let Some(rows) = rows else {
            return Ok(vec![]);
        };
        work.done.fetch_add(1, Ordering::Relaxed);
        work.report_progress();
        Ok(rows)
    });
    Ok(by_parameter.collect::<Result<Vec<_>>>()?.concat())
}

/// Separates the outcomes that have derivatives from the missing outcomes.
///
/// # Errors
/// The error of the first missing outcome, if no outcome has derivatives.
fn present(
    setup: &Setup<f64>,
    of: &[Outcome],
    wrt: &[&'static Parameter],
) -> Result<(Vec<Outcome>, Vec<Missing>)> {
    let (mut present, mut missing, mut first) = (vec![], vec![], None);
    for &one in of {
        match evaluate(setup, &[one], wrt, Order::First) {
            Ok(_) => present.push(one),
            Err(error) if error.has_valid_input() => {
                let reason = error.message();
                missing.push(Missing { of: one, reason });
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
