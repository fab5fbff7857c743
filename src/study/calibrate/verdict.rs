//! What a fit's end is called once the data have been looked at: a search that has converged may still have no answer.

use super::estimate::{Calibration, Remainder};
use super::statistics::Undetermined;
use crate::optimize::least_squares::{Fit, Loss, Status};

/// The verdict of the best of several searches, by what became of all of them: `is_settled` tells whether the curvatures of optima
/// stayed where they were. How many searches were stopped before their end is returned, and whether the best of all had ended at a minimum.
pub(super) fn of_searches(fits: &mut [Fit], is_settled: bool, is_interrupted: bool) -> (usize, bool) {
    let (all, stopped) = (fits.len(), fits.iter().filter(|fit| fit.status == Status::Interrupted).count());
    let Some(best) = fits.first_mut() else { return (stopped, false) };
    let (ended, is_minimum) = (best.status, best.status == Status::Converged && is_settled);
    if stopped > 0 && ended != Status::Interrupted {
        best.status = Status::Interrupted;
        best.message = format!(
            "{} of {all} searches ended, and {stopped} were stopped before their end; the best of those that ended is {ended}: {}",
            all - stopped,
            best.message
        );
    }
    if !is_settled && ended == Status::Converged {
        best.status = if is_interrupted { Status::Interrupted } else { Status::Stalled };
        best.message =
            format!("{}; but the curvatures of the optima, renewed there, are not the same yet", best.message);
    }
    (stopped, is_minimum)
}

/// The verdict where the data do not determine the parameters, or where one row leaves the others no say.
pub(super) fn of_data(found: &mut Calibration, loss: Loss) {
    if found.fit.status != Status::Converged {
        return;
    }
    if let Some(row) = outweighing(&found.remainders, loss) {
        found.fit.status = Status::Outweighed;
        found.fit.message = format!(
            "row {}: {} lies {:.1e} of its standard uncertainties from any fit, and beside that all other rows vanish in the \
             rounding of the sum; correct the row or its sigma, or take it out",
            row.row,
            row.outcome.name(),
            row.residual.abs()
        );
        return;
    }
    let undetermined = &found.statistics.undetermined;
    if !undetermined.is_empty() {
        let all: Vec<String> = undetermined.iter().map(|direction| names(found, direction)).collect();
        found.fit.status = Status::Undetermined;
        found.fit.message = format!(
            "the data do not determine {}: many other values of these fit as well as those shown. Fit fewer parameters, give narrower \
             ranges, or measure what depends on them ({})",
            all.join(", nor "),
            found.fit.message
        );
    }
}

/// The row whose cost is so large that the cost of all others is lost in its rounding.
fn outweighing(remainders: &[Remainder], loss: Loss) -> Option<&Remainder> {
    /// Part of a sum that its rounding hides.
    const ROUNDING: f64 = 1e-15;
    let most = remainders.iter().max_by(|a, b| a.residual.abs().total_cmp(&b.residual.abs()))?;
    let rest: f64 = remainders.iter().filter(|other| !std::ptr::eq(*other, most)).map(|r| loss.of(r.residual)).sum();
    (loss.of(most.residual) * ROUNDING > rest.max(1.0)).then_some(most)
}

fn names(found: &Calibration, direction: &Undetermined) -> String {
    let names: Vec<&str> = direction.parts.iter().map(|(at, _)| found.estimates[*at].parameter.name).collect();
    match &names[..] {
        [only] => (*only).to_owned(),
        [rest @ .., last] => format!("{} and {last} apart", rest.join(", ")),
        [] => "any parameter".into(),
    }
}
