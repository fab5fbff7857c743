use crate::Result;
use crate::command::args::Parameters;
use crate::command::output::Answer;
use crate::report::ParametersReport;

pub fn run(args: &Parameters) -> Result<Answer> {
    let request = args.setup_args.request()?;
    let setup = request.setup()?;
    let report = ParametersReport::new(&setup);
    Ok(Answer::report(&report, setup.warnings(), request.is_json()))
}
