use crate::command::args::Simulate;
use crate::command::output::{Answer, system, warn};
use crate::flight::Flight;
use crate::report::{DriveReport, air_text, drive_text};
use crate::{Drive, Outcome, Result};

pub fn run(args: &Simulate) -> Result<Answer> {
    let request = args.setup_args.request()?;
    let setup = request.within_tolerance(request.setup()?)?;
    let drive = Drive::new(&setup);
    let mut warnings = drive.as_ref().map_or_else(
        |_| setup.warnings(),
        |drive| drive.warnings_about(&setup, Outcome::ALL),
    );
    warnings.extend(setup.wind_profile_warning());
    warn(&warnings);
    let drive = drive?;
    let answer = if request.is_json() {
        Answer::json(&DriveReport::reply(&setup, &drive, warnings))
    } else {
        Answer::text(drive_text(&drive, system()) + &air_text(&setup, system()))
    };
    Ok(answer.found(matches!(drive.flight, Flight::Landed(_))))
}
