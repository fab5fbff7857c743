use crate::args::Optimize;
use crate::output::{Answer, tell, warn};
use longdrive::optimize::Status;
use longdrive::report::{OptimumReport, optima_text, optimum_text};
use longdrive::study::Optimum;
use longdrive::{Result, Setup};

pub fn run(args: &Optimize) -> Result<Answer> {
    let setup = args.question.setup()?;
    let search = args.search.search(&setup)?;
    let setup = args.question.within_tolerance(setup, &search.vary)?;
    let optima = args.work.run(&setup, &search)?;
    let best = optima.best()?;
    let warnings = remarks(&setup, best);
    warn(&warnings);
    let answer = if args.question.json {
        Answer::json(&OptimumReport::reply(&optima, warnings)?)
    } else {
        let listed = if args.work.starts > 1 { optima_text(&optima) } else { String::new() };
        Answer::text(optimum_text(best) + &listed)
    };
    Ok(answer.found(best.solution.status == Status::Converged && optima.stopped() == 0))
}

/// What deserves a word about an optimum.
pub fn remarks(setup: &Setup<f64>, best: &Optimum) -> Vec<String> {
    if let Some(moved) = best.moved_start() {
        tell(&moved);
    }
    let mut warnings = setup.warnings();
    if let Some(drive) = &best.drive {
        warnings.extend(drive.corners(&best.setup));
    }
    warnings
}
