use crate::Result;
use crate::command::args::OwnLaw;
use crate::command::output::{Answer, system};
use crate::report::{LawsReport, Line, Reply, Report};

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
    if args.json {
        return Ok(Answer::json(&Reply::of(&report, vec![])));
    }
    let mut document = report.document(system());
    document.list([
        Line::item("choose one with `set aero.law=NAME`; `parameters()` lists the coefficients"),
        Line::item("or your own table with `set aero.table=mine.csv`; `plot laws()` draws them"),
    ]);
    Ok(Answer::document(&document))
}
