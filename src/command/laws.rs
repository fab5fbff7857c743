use crate::Result;
use crate::command::args::OwnLaw;
use crate::command::output::Answer;
use crate::report::{LawsReport, SetupOrigin};

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
    Ok(Answer::report(&report, &SetupOrigin::default()))
}
