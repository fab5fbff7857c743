pub use crate::command::args::SetupArgs as Args;

use crate::command::output::{Answer, warn};
use crate::flight::Flight;
use crate::report::DriveReport;
use crate::{Drive, Outcome, Result};

pub fn run(args: &Args) -> Result<Answer> {
    let request = args.request()?;
    let setup = request.setup_within_tolerance()?;
    warn(setup.drive_warnings(Outcome::OF_DRIVES));
    let drive = Drive::new(&setup)?;
    let report = DriveReport::new(&setup, &drive);
    let answer = Answer::report(&report, &request.origin());
    Ok(answer.found(matches!(drive.flight, Flight::Landed(_))))
}
