use crate::Result;
use crate::command::args::{Args, Completions};
use crate::command::output::Answer;
use clap::CommandFactory;

pub fn run(args: &Completions) -> Result<Answer> {
    let mut script = vec![];
    clap_complete::generate(args.shell, &mut Args::command(), "longdrive", &mut script);
    Ok(Answer::text(String::from_utf8_lossy(&script).into_owned()))
}
