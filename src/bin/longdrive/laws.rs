use crate::args::Laws;
use crate::output::{Answer, system};
use longdrive::report::{laws_reply, laws_text};

pub fn run(args: &Laws) -> Answer {
    if args.json { Answer::json(&laws_reply()) } else { Answer::text(laws_text(system())) }
}
