use crate::Result;
use crate::command::args::OwnLaw;
use crate::command::output::Answer;
use crate::report::{LawsReport, Line, Reply, Report, SetupOrigin};

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub own: OwnLaw,

    /// Print the laws as JSON.
    #[arg(long)]
    pub json: bool,
}

pub fn run(args: &Args) -> Result<Answer> {
    let report = LawsReport::new(args.own.law()?);
    let advice = [
        Line::item("choose one with `set aero.law=NAME`; `parameters()` lists the coefficients"),
        Line::item("or your own table with `set aero.table=mine.csv`; `plot laws()` draws them"),
    ];
    Ok(Answer::of(
        args.json,
        &SetupOrigin::default(),
        |warnings| Reply::of(&report, warnings),
        |system| {
            let mut document = report.document(system);
            document.list(advice);
            document
        },
    ))
}
