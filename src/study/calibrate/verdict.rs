//! Final status of a fit, with regard to the data: a converged search may leave parameters
//! undetermined.

use super::calibration::{Calibration, Remainder};
use super::statistics::{Uncertainties, Undetermined};
use crate::optimize::least_squares::{Fit, FitStatus, Loss};
use crate::units::{counted, significant};

/// Sets the status of the best of several searches. `is_settled`: the curvatures of carry in the
/// stationary parameters no longer change. Returns the number of interrupted searches, and true if
/// the best search converged to a minimum.
pub(super) fn of_searches(
    fits: &mut [Fit],
    is_settled: bool,
    is_interrupted: bool,
) -> (usize, bool) {
    let (all, stopped) = (
        fits.len(),
        fits.iter()
            .filter(|fit| fit.status == FitStatus::Interrupted)
            .count(),
    );
    let Some(best) = fits.first_mut() else {
        return (stopped, false);
    };
    let (ended, is_minimum) = (
        best.status,
        best.status == FitStatus::Converged && is_settled,
    );
    if stopped > 0 && ended != FitStatus::Interrupted {
        best.status = FitStatus::Interrupted;
        best.message = format!(
            "{} of {all} searches ended, and {stopped} were stopped before their end; the best \
             finished search is {ended}: {}",
            all - stopped,
            best.message
        );
    }
    if !is_settled && ended == FitStatus::Converged {
        best.status = if is_interrupted {
            FitStatus::Interrupted
        } else {
            FitStatus::Stalled
        };
        best.message = format!(
            "{}; but the curvatures of carry, computed again at the optima, still change",
            best.message
        );
    }
    (stopped, is_minimum)
}

/// A fit counts as a misfit if the root mean square of its residuals, in standard uncertainties,
/// exceeds this number.
const MISFIT: f64 = 6.0;

/// Sets the status for undetermined parameters, a dominating row, or a model that does not describe
/// the data.
pub(super) fn of_data(found: &mut Calibration, loss: Loss, uncertainties: Uncertainties) {
    // a search also stalls if the data hardly depend on the parameters
    if !matches!(found.fit.status, FitStatus::Converged | FitStatus::Stalled) {
        return;
    }
    if let Some(row) = outweighing(&found.remainders, loss) {
        found.fit.status = FitStatus::DominatedByOneResidual;
        found.fit.message = format!(
            "row {}: {} differs by {:.1e} of its standard uncertainties from every fit. All other \
             rows together are less than a millionth of the sum of squares; correct the row or \
             its sigma, or remove the row",
            row.row,
            row.outcome.name(),
            row.residual.abs()
        );
        return;
    }
    let undetermined = &found.statistics.undetermined;
    if !undetermined.is_empty() {
        let all: Vec<String> = undetermined
            .iter()
            .map(|direction| parameter_names(found, direction))
            .collect();
        found.fit.status = FitStatus::Undetermined;
        found.fit.message = format!(
            "the data do not determine {}: many other values of these fit as well as those shown. \
             Fit fewer parameters, give narrower ranges, or measure outcomes that depend on them \
             ({})",
            all.join(", nor "),
            found.fit.message
        );
        return;
    }
    // Huber's loss expects rows that the model does not describe
    let is_judged = loss == Loss::Squares && uncertainties != Uncertainties::Weights;
    if let Some(off) = found
        .statistics
        .misfit()
        .filter(|off| is_judged && *off > MISFIT)
    {
        found.fit.status = FitStatus::Misfit;
        found.fit.message = format!(
            "the values miss the fit by {} of their standard uncertainties (root mean square, with \
             {} of freedom), where noise alone gives 1: the fitted model does not describe them, \
             or their uncertainties are too small; look at the largest residuals",
            significant(off, 3),
            counted(found.statistics.degrees_of_freedom as u64, "degree")
        );
    }
}

/// The row that dominates the fit: the squared gradient of all other rows together is less than
/// 1e-6 of the row's, and the row's residual exceeds 1000 standard uncertainties. With Huber's
/// loss, which limits the gradient of each row, a row dominates only if its loss hides the other
/// rows by rounding.
fn outweighing(remainders: &[Remainder], loss: Loss) -> Option<&Remainder> {
    /// Threshold for the squared gradient of all other rows, as a fraction of the largest row's
    /// squared gradient.
    const PART: f64 = 1e-6;
    /// If the loss of all other rows is below this fraction of the largest row's loss, rounding
    /// hides the other rows. This holds for any loss function.
    const ROUNDING: f64 = 1e-15;
    let most = remainders
        .iter()
        .max_by(|a, b| a.residual.abs().total_cmp(&b.residual.abs()))?;
    let outweighs = |part: f64, of: &dyn Fn(f64) -> f64| {
        let others = remainders
            .iter()
            .filter(|other| !std::ptr::eq(*other, most));
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
