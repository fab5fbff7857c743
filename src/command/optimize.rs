use crate::command::args::Optimize;
use crate::command::files::{Destination, Rule};
use crate::command::output::{Answer, system, tell, warn};
use crate::command::request::Request;
use crate::optimize::Status;
use crate::report::{OptimumReport, optima_text, optimum_text, optimum_toml};
use crate::study::{Optima, Optimum};
use crate::units::Message;
use crate::{Result, Setup};

pub fn run(args: &Optimize) -> Result<Answer> {
    args.swings.refuse_stray()?;
    if args.swings.is_given() {
        return crate::command::swings::run(args);
    }
    let request = args.setup_args.request()?;
    let setup = request.setup_with_starts(&args.search.vary)?;
    let search = args.search.search(&setup)?;
    request.note_starts(&setup, &search.vary);
    let setup = request.for_many(setup, &search.vary)?;
    let output = args.destination(&request)?;
    let optima = args.work.run(&setup, &search)?;
    let best = optima.best()?;
    let warnings = remarks(&setup, best);
    warn(&warnings);
    let written = output
        .as_ref()
        .map(|output| write(output, &request, &optima))
        .transpose()?
        .flatten();
    let answer = if request.is_json() {
        let mut reply = OptimumReport::reply(&optima, warnings)?;
        reply.body.file = written;
        Answer::json(&reply)
    } else {
        let listed = if args.work.starts > 1 {
            optima_text(&optima, system())
        } else {
            String::new()
        };
        // of one search alone the text below says so
        let stopped = optima.interrupted().filter(|_| optima.starts > 1);
        let stopped = stopped.map_or(String::new(), |stopped| {
            format!("interrupted: {stopped}; the best so far:\n")
        });
        Answer::text(stopped + &optimum_text(best, system()) + &listed)
    };
    Ok(answer.found(best.solution.status == Status::Converged && optima.stopped() == 0))
}

impl Optimize {
    /// Where the setup at the optimum goes, if it may be written there.
    pub fn destination(&self, request: &Request) -> Result<Option<Destination>> {
        let inputs = request.inputs().chain(self.work.checkpoint.clone());
        let rule = Rule::new(inputs, self.overwrite);
        self.output
            .as_ref()
            .map(|file| rule.setup_file(file))
            .transpose()
    }
}

/// Writes the setup at the optimum, into the file returned; without an optimum, nothing.
pub fn write(output: &Destination, request: &Request, optima: &Optima) -> Result<Option<String>> {
    let file = output.path().display();
    let best = optima.best()?;
    if best.solution.status != Status::Converged {
        warn(&[Message::from(format!(
            "{file} is not written: there is no optimum"
        ))]);
        return Ok(None);
    }
    let toml = optimum_toml(optima, request.source().preset())?;
    output.write(request.with_stated_step(toml)?.as_bytes())?;
    tell(&format!("wrote the setup at the optimum into {file}"));
    Ok(Some(file.to_string()))
}

/// What deserves a word about an optimum.
pub fn remarks(setup: &Setup<f64>, best: &Optimum) -> Vec<Message> {
    if let Some(moved) = best.moved_start() {
        tell(&moved);
    }
    best.drive.as_ref().map_or_else(
        || setup.warnings(),
        |drive| drive.warnings_about(&best.setup, &best.search.outcomes()),
    )
}
