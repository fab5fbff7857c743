pub use crate::command::args::OptimizeArgs as Args;

use crate::command::args::OptimumArgs;
use crate::command::interrupt::{self, BEST_SO_FAR, InterruptibleWork};
use crate::command::output::{Answer, note, warn};
use crate::command::request::Request;
use crate::command::search::{SearchRequest, write};
use crate::command::swings::swing_ranges;
use crate::report::OptimizeReport;
use crate::study::swings::{Swings, SwingsAnalysis, analyse_over_swings, bootstrap_optimum};
use crate::study::{Optima, OptimumWindows, Search, default_loss, windows};
use crate::units::Message;
use crate::{Result, Setup};
use std::sync::atomic::AtomicBool;

/// Number of bootstrap samples of recorded swings.
const RESAMPLES: usize = 200;

pub fn run(args: &Args) -> Result<Answer> {
    args.swings.refuse_stray()?;
    let optimum = &args.optimum;
    let request = optimum.setup_args.request()?;
    let drives = args.swings.drives(&request, true)?;
    let Some(swings) = &drives.swings else {
        return one_drive(optimum, &request);
    };
    let ranges = drives.ranges(&optimum.search.vary, &request)?;
    let SearchRequest {
        setup,
        search,
        origin,
    } = optimum
        .search
        .search(&request, &drives, ranges, drives.default_goal())?;
    let found = optimize_and_write(args, &request, swings, setup, &search)?;
    let answer = Answer::report(&found.report(), &origin);
    Ok(answer.found(found.optima.is_found()))
}

/// The optimum of one drive, with the ranges around it.
fn one_drive(args: &OptimumArgs, request: &Request) -> Result<Answer> {
    let instead = "`simulate()` flies the drive as stated";
    let drive_search = args.search.of_drive(request, None, Some(instead))?;
    let output = args.destination(request, std::iter::empty())?;
    let mut optima = args.optima(&drive_search)?;
    let club = optima.improve_from_club_alone()?;
    let best = &optima.best;
    if let Some(moved) = best.moved_start() {
        note(&moved);
    }
    warn(best.warnings(&AtomicBool::new(false)));
    let written = write(output.as_ref(), request, &optima, None)?;
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

/// The best design over swings, with its analyses.
pub struct SwingsOptimum {
    /// The setup before the search.
    pub setup: Setup<f64>,
    pub optima: Optima,
    /// `None` without an optimum, and after an interrupt.
    pub analysis: Option<SwingsAnalysis>,
    /// The search and its analyses, which Ctrl-C can interrupt until this value is dropped.
    pub work: InterruptibleWork,
    /// The file that was written.
    file: Option<String>,
}

impl SwingsOptimum {
    pub fn report(&self) -> OptimizeReport<'_> {
        OptimizeReport::new(
            &self.optima,
            self.analysis.as_ref(),
            None,
            self.file.clone(),
        )
    }
}

/// Runs the search, which Ctrl-C can stop, and writes the setup if a file is given.
pub fn optimize_and_write(
    args: &Args,
    request: &Request,
    swings: &Swings,
    setup: Setup<f64>,
    search: &Search,
) -> Result<SwingsOptimum> {
    let setup = request.for_many(setup, &swing_ranges(&search.vary, &search.scenarios))?;
    let output = args.optimum.destination(request, args.swings.inputs())?;
    let work = interrupt::enable(BEST_SO_FAR);
    let stop = &work.stop;
    let optima = args.optimum.optima_until(&setup, search, stop)?;
    let best = &optima.best;
    let is_found = best.is_converged();
    let mut analysis = None;
    if is_found {
        analysis = analyse_over_swings(&setup, swings, best, stop)?;
        if let (Swings::Recorded { .. }, Some(analysis)) = (swings, &mut analysis) {
            let seed = u64::from(args.swings.seed.unwrap_or(0));
            analysis.resampled = bootstrap_optimum(&setup, best, RESAMPLES, seed, stop)?;
        }
    }
    let mut warnings = best.warnings(stop);
    if let Some(share) = best.beyond_strokes.filter(|share| *share > 0.0) {
        let percent = 100.0 * share;
        let percent = match percent < 0.1 {
            true => "less than 0.1".into(),
            false => format!("{percent:.1}"),
        };
        warnings.push(Message::from(format!(
            "the balls of {percent} % of the swings end outside of the table of strokes, where \
             it is extrapolated linearly"
        )));
    }
    warn(warnings);
    let file = write(output.as_ref(), request, &optima, Some(swings))?;
    Ok(SwingsOptimum {
        setup,
        optima,
        analysis,
        work,
        file,
    })
}
