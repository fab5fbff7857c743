use crate::Result;
use crate::command::args::Laws;
use crate::command::output::{Answer, system};
use crate::report::{laws_reply, laws_text};

pub fn run(args: &Laws) -> Result<Answer> {
    let own = args.own.law()?;
    Ok(if args.json {
        Answer::json(&laws_reply(own))
    } else {
        Answer::text(laws_text(own, system()))
    })
}
