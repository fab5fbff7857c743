//! Status of a calibration, by its searches and by the data: a converged search may leave
//! parameters undetermined.

use super::calibration::{Calibration, CalibrationStatus, CalibrationVerdict, FitResidual};
use super::statistics::{FitStatistics, SigmaOrigin, Undetermined};
use crate::optimize::least_squares::{Fit, FitStatus, Loss};
use crate::units::{counted, significant};

/// The verdict on the searches: status and message of the best one, the first of `fits`. Two
/// exceptions: another search was interrupted, or `is_settled` is false.
pub(super) fn of_searches(
    fits: &[Fit],
    is_settled: bool,
    is_interrupted: bool,
) -> CalibrationVerdict {
    let all = fits.len();
    let is_stopped = |fit: &&Fit| fit.status == FitStatus::Interrupted;
    let stopped = fits.iter().filter(is_stopped).count();
    let Fit {
        status, message, ..
    } = &fits[0];
    let mut verdict = CalibrationVerdict {
        status: CalibrationStatus::Search(*status),
        message: message.clone(),
    };
    if stopped > 0 && *status != FitStatus::Interrupted {
        verdict.status = CalibrationStatus::INTERRUPTED;
        verdict.message = format!(
            "{} of {all} searches ended, and {stopped} were stopped before their end; the best \
             finished search is {status}: {message}",
            all - stopped,
        );
    }
    if !is_settled && *status == FitStatus::Converged {
        verdict.status = CalibrationStatus::Search(match is_interrupted {
            true => FitStatus::Interrupted,
            false => FitStatus::Stalled,
        });
        verdict.message = format!(
            "{}; but the curvatures of carry, computed again at the optima, still change",
            verdict.message
        );
    }
    verdict
}

/// A fit gets a warning if the root mean square of its residuals, in standard uncertainties,
/// exceeds this number. With Huber's loss, their robust scale replaces the root mean square. Noise
/// alone gives 1. The number is a choice: an uncertainty may well be stated too small by a factor
/// of 2.
pub(super) const WARNED_MISFIT: f64 = 3.0;

/// A fit has the status [`CalibrationStatus::Misfit`] if the root mean square exceeds this number,
/// twice [`WARNED_MISFIT`]. Uncertainties that are stated too small do not explain so much.
const MISFIT: f64 = 6.0;

/// Text for a fit whose residuals have a root mean square above `most` standard uncertainties;
/// `None` for any other fit. With Huber's loss, the robust scale of the residuals replaces the root
/// mean square, which grows with each outlier.
pub(super) fn misfit_text(statistics: &FitStatistics, most: f64) -> Option<String> {
    let (freedom, chi_square) = (statistics.degrees_of_freedom, statistics.chi_square);
    let misfit = match statistics.loss {
        Loss::Squares => Some((chi_square / freedom as f64).sqrt()),
        Loss::Huber(_) => statistics.scale,
    };
    if freedom == 0 || statistics.is_exact || misfit.is_some_and(|misfit| misfit <= most) {
        return None;
    }
    let size = match (statistics.loss, misfit) {
        (Loss::Squares, misfit) => format!(
            "{} of their standard uncertainties (root mean square; χ² = {} with {} of freedom), \
             where noise alone gives 1",
            significant(misfit?, 3),
            significant(chi_square, 5),
            counted(freedom as u64, "degree")
        ),
        (Loss::Huber(_), Some(scale)) => format!(
            "{} of their standard uncertainties (robust scale of Huber's loss), where noise alone \
             gives 1",
            significant(scale, 3)
        ),
        (Loss::Huber(limit), None) => {
            format!("more than {limit} of their standard uncertainties, without exception")
        }
    };
    Some(format!(
        "the values miss the fit by {size}: the fitted model does not describe them, or their \
         uncertainties are too small; look at the largest residuals"
    ))
}

/// The verdict on a converged or stalled fit if one residual dominates it, if parameters are
/// undetermined, or if the model does not describe the data. `None` if the verdict on the searches
/// stays.
pub(super) fn of_data(
    found: &Calibration,
    loss: Loss,
    origin: SigmaOrigin,
) -> Option<CalibrationVerdict> {
    // a search also stalls if the data hardly depend on the parameters
    if !matches!(
        found.verdict.status,
        CalibrationStatus::Search(FitStatus::Converged | FitStatus::Stalled)
    ) {
        return None;
    }
    if let Some(row) = dominating_residual(&found.residuals, loss) {
        let message = format!(
            "row {}: {} is {:.1e} standard uncertainties from the fit. All other residuals \
             together are less than a millionth of the sum of squares; correct the row or its \
             sigma, or remove the row",
            row.row,
            row.outcome.name(),
            row.residual.abs()
        );
        return Some(CalibrationVerdict {
            status: CalibrationStatus::DominatedByOneResidual,
            message,
        });
    }
    let undetermined = &found.statistics.undetermined;
    if !undetermined.is_empty() {
        let mut all: Vec<String> = undetermined
            .iter()
            .map(|direction| parameter_names(found, direction))
            .collect();
        // several directions of the same parameters
        all.dedup();
        let message = format!(
            "the data do not determine {}: many other values of these fit as well as those shown. \
             Fit fewer parameters, give narrower ranges, or measure outcomes that depend on them \
             ({})",
            all.join(", nor "),
            found.verdict.message
        );
        return Some(CalibrationVerdict {
            status: CalibrationStatus::Undetermined,
            message,
        });
    }
    // no verdict if rows may deviate from the model (Huber's loss), or if the uncertainties are
    // unknown
    if loss != Loss::Squares || origin == SigmaOrigin::Weights {
        return None;
    }
    Some(CalibrationVerdict {
        status: CalibrationStatus::Misfit,
        message: misfit_text(&found.statistics, MISFIT)?,
    })
}

/// The residual r of largest magnitude, if it dominates the fit. It dominates if it meets one of
/// two conditions (w is the weight of a residual in the loss):
///
/// - (w r)² exceeds 1e6, and 1e6 times the sum of (w r)² over the other residuals.
/// - Its loss exceeds 1e15, and 1e15 times the sum of the losses of the other residuals. Rounding
///   then hides the other residuals. Huber's loss needs this condition, because it limits w r.
fn dominating_residual(residuals: &[FitResidual], loss: Loss) -> Option<&FitResidual> {
    /// Limit of Σ (w r)² over the other residuals, divided by (w r)² of the largest residual.
    const PART: f64 = 1e-6;
    /// Limit of the summed losses of the other residuals, divided by the loss of the largest
    /// residual.
    const ROUNDING: f64 = 1e-15;
    let most = residuals
        .iter()
        .max_by(|a, b| a.residual.abs().total_cmp(&b.residual.abs()))?;
    let outweighs = |part: f64, of: &dyn Fn(f64) -> f64| {
        let others = residuals.iter().filter(|other| !std::ptr::eq(*other, most));
        let rest: f64 = others.map(|other| of(other.residual)).sum();
        of(most.residual) * part > rest.max(1.0)
    };
    let pull = |residual: f64| (loss.weight(residual) * residual).powi(2);
    (outweighs(PART, &pull) || outweighs(ROUNDING, &|residual| loss.of(residual))).then_some(most)
}

fn parameter_names(found: &Calibration, direction: &Undetermined) -> String {
    let names: Vec<&str> = direction
        .parts
        .iter()
        .map(|(at, _)| found.estimates[*at].parameter.name)
        .collect();
    match &names[..] {
        [only] => (*only).to_owned(),
        [rest @ .., last] => format!("{} and {last} separately", rest.join(", ")),
        [] => "any parameter".into(),
    }
}
