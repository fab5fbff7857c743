use crate::args::Report;
use crate::output::Answer;
use longdrive::Result;
pub fn run(_args: &Report) -> Result<Answer> {
    Ok(Answer::text(String::new()))
}
