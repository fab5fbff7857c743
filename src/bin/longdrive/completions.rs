use crate::args::{Args, Completions};
use crate::output::Answer;
use clap::CommandFactory;
use longdrive::Result;

pub fn run(args: &Completions) -> Result<Answer> {
    let mut script = vec![];
    clap_complete::generate(args.shell, &mut Args::command(), "longdrive", &mut script);
    Ok(Answer::text(String::from_utf8_lossy(&script).into_owned()))
}
