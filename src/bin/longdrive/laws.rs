use crate::args::Laws;
use crate::output::{Answer, system};
use longdrive::Result;
use longdrive::report::{laws_reply, laws_text};

pub fn run(args: &Laws) -> Result<Answer> {
    let own = args.own.law()?;
    Ok(if args.json { Answer::json(&laws_reply(own)) } else { Answer::text(laws_text(own, system())) })
}
