use crate::args::Parameters;
use crate::output::{Answer, system};
use longdrive::Result;
use longdrive::report::{parameters_reply, parameters_text};

pub fn run(args: &Parameters) -> Result<Answer> {
    let setup = args.question.setup()?;
    Ok(if args.question.json {
        Answer::json(&parameters_reply(&setup, setup.warnings()))
    } else {
        Answer::text(parameters_text(&setup, system()))
    })
}
