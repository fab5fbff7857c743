use crate::Result;
use crate::command::args::DriveArgs;
use crate::command::output::Answer;
use crate::command::request::Source;
use crate::command::running::running;
use crate::lock::lock;
use crate::parameters::DEFAULT_PRESET;
use crate::report::ParametersReport;

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub drive: DriveArgs,

    /// List only the parameters with this word in their names or, if there is none, in their
    /// meanings, e.g. loft or MOI. Without a SETUP it may be the first word: longdrive parameters
    /// swing.
    #[arg(value_name = "WORD")]
    pub word: Option<String>,

    /// Print the answer as JSON (SI units and radians), and nothing else, to standard output.
    #[arg(long)]
    pub json: bool,
}

pub fn run(args: &Args) -> Result<Answer> {
    let mut drive = args.drive.clone();
    let mut word = args.word.clone();
    // a single argument is the search word, unless it names a setup
    if word.is_none() && !Source::is_named_by(&drive.setup) {
        word = Some(std::mem::replace(&mut drive.setup, DEFAULT_PRESET.into()));
    }
    let request = drive.request()?;
    let setup = request.setup()?;
    let report = ParametersReport::new(&setup);
    let report = match &word {
        Some(word) => report.with_word(word)?,
        None => report,
    };
    // add the warnings of the setup to the JSON, without printing them
    lock(&running().warnings).extend(setup.warnings());
    let origin = request.origin();
    Ok(Answer::report(&report, &origin))
}
