use crate::Result;
use crate::command::args::Parameters;
use crate::command::output::{Answer, system};
use crate::report::{parameters_reply, parameters_text};

pub fn run(args: &Parameters) -> Result<Answer> {
    let request = args.setup_args.request()?;
    let setup = request.setup()?;
    Ok(if request.is_json() {
        Answer::json(&parameters_reply(&setup, setup.warnings()))
    } else {
        Answer::text(parameters_text(&setup, system()))
    })
}
