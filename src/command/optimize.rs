pub use crate::command::args::OptimizeArgs as Args;

use crate::Result;
use crate::command::output::{Answer, note, warn};
use crate::command::search::write;
use crate::report::OptimizeReport;
use crate::study::{OptimumWindows, default_loss, windows};
use std::sync::atomic::AtomicBool;

pub fn run(args: &Args) -> Result<Answer> {
    args.swings.refuse_stray()?;
    if args.swings.is_given() {
        return crate::command::swings::run(args);
    }
    let args = &args.optimum;
    let request = args.setup_args.request()?;
    let instead = "`simulate()` flies the drive as stated";
    let drive_search = args.search.of_drive(&request, None, Some(instead))?;
    let output = args.destination(&request, std::iter::empty())?;
    let mut optima = args.optima(&drive_search)?;
    let club = optima.improve_from_club_alone()?;
    let best = &optima.best;
    if let Some(moved) = best.moved_start() {
        note(&moved);
    }
    warn(best.warnings(&AtomicBool::new(false)));
    let written = write(output.as_ref(), &request, &optima, None)?;
    let is_converged = best.is_converged();
    let loss = default_loss(best);
    let windows = is_converged.then(|| windows(best, loss)).transpose()?;
    let around = windows.as_deref().map(|windows| OptimumWindows {
        loss,
        windows,
        club_alone: club.as_ref(),
    });
    let report = OptimizeReport::new(&optima, None, around, written);
    let answer = Answer::report(&report, &drive_search.origin);
    Ok(answer.found(optima.is_found()))
}
