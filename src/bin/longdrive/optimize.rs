use crate::args::Optimize;
use crate::output::{Answer, tell, warn};
use longdrive::optimize::{Options, Status};
use longdrive::report::{OptimumReport, iteration_line, optimum_text};
use longdrive::study::{Search, Vary, optimum};
use longdrive::{Outcome, Result};

pub fn run(args: &Optimize) -> Result<Answer> {
    let setup = args.question.setup()?;
    let vary = args.vary.iter().map(|text| Vary::read(&setup, text)).collect::<Result<Vec<_>>>()?;
    let default = Search::longest_drive(&setup);
    let search = Search {
        maximize: Outcome::named(&args.maximize)?,
        vary: if vary.is_empty() { default?.vary } else { vary },
        options: Options { max_iterations: args.max_iterations, ..Options::default() },
    };

    let shown = search.clone();
    let optimum = optimum(&setup, search, move |iteration| tell(&iteration_line(&shown, iteration)))?;
    if let Some(moved) = optimum.moved_start() {
        tell(&moved);
    }
    let mut warnings = setup.warnings();
    if let Some(drive) = &optimum.drive {
        warnings.extend(drive.corners(&optimum.setup));
    }
    warn(&warnings);
    let answer = if args.question.json {
        Answer::json(&OptimumReport::new(&optimum, warnings))
    } else {
        Answer::text(optimum_text(&optimum))
    };
    Ok(answer.found(optimum.solution.status == Status::Converged))
}
