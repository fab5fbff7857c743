use crate::Result;
use crate::command::output::Answer;
use crate::command::running::running;

#[derive(clap::Args)]
pub struct Args {
    /// The shell.
    #[arg(value_enum, value_name = "SHELL")]
    pub shell: clap_complete::Shell,
}

pub fn run(args: &Args) -> Result<Answer> {
    let mut script = vec![];
    clap_complete::generate(
        args.shell,
        &mut running().program.clone(),
        "longdrive",
        &mut script,
    );
    Ok(Answer::text(String::from_utf8_lossy(&script).into_owned()))
}
