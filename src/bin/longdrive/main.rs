//! The program: a table of contents. Each command reads its question, asks the library, and prints the answer.

mod args;
mod calibrate;
mod chart;
mod colour;
mod compare;
mod completions;
mod date;
mod delivery;
mod design;
mod files;
mod fly;
mod gradient;
mod interrupt;
mod laws;
mod man;
mod names;
mod optimize;
mod optimum_sensitivity;
mod output;
mod parameters;
mod pareto;
mod picture;
mod plot;
mod plot_drive;
mod presets;
mod question;
mod report;
mod reproduce;
mod robust;
mod search;
mod sensitivity;
mod simulate;
mod sweep;
mod swings;
mod uncertainty;
mod validate;
mod verify;

use args::{Args, Command};
use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    let args = match Args::try_parse() {
        Ok(args) => args,
        Err(error) => {
            let words: Vec<_> = std::env::args_os().skip(1).collect();
            return output::explain(error, Command::named_in(&words), words.iter().any(|word| word == "--json"));
        }
    };
    output::begin(args.shown);
    interrupt::begin(args.command.name(), args.command.is_json());
    let answer = match &args.command {
        Command::Simulate(args) => simulate::run(args),
        Command::Gradient(args) => gradient::run(args),
        Command::Compare(args) => compare::run(args),
        Command::Optimize(args) => optimize::run(args),
        Command::OptimumSensitivity(args) => optimum_sensitivity::run(args),
        Command::Design(args) => design::run(args),
        Command::Calibrate(args) => calibrate::run(args),
        Command::Delivery(args) => delivery::run(args),
        Command::Chart(args) => chart::run(args),
        Command::Pareto(args) => pareto::run(args),
        Command::Robust(args) => robust::run(args),
        Command::Plot(args) => plot::run(args),
        Command::Report(args) => report::run(args),
        Command::Sweep(args) => sweep::run(args),
        Command::Fly(args) => fly::run(args),
        Command::Reproduce(args) => reproduce::run(args),
        Command::Validate(args) => validate::run(args),
        Command::Verify(args) => verify::run(args),
        Command::Sensitivity(args) => sensitivity::run(args),
        Command::Uncertainty(args) => uncertainty::run(args),
        Command::Parameters(args) => parameters::run(args),
        Command::Presets(args) => presets::run(args),
        Command::Laws(args) => laws::run(args),
        Command::Completions(args) => completions::run(args),
        Command::Man(args) => man::run(args),
    };
    let printed = answer.and_then(|answer| {
        interrupt::prints();
        answer.print()
    });
    match printed {
        Ok(code) => code,
        Err(error) => output::complain(&error, args.command.name(), args.command.is_json()),
    }
}
