use crate::Result;
use crate::command::args::SetupArgs;
use crate::command::output::Answer;
use crate::command::request::Source;
use crate::command::running::running;
use crate::parameters::DEFAULT_PRESET;
use crate::report::ParametersReport;

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub setup_args: SetupArgs,

    /// List only the parameters with this word in their names or groups, e.g. loft. Without a
    /// SETUP it may be the first word: longdrive parameters swing.
    #[arg(value_name = "WORD")]
    pub word: Option<String>,
}

pub fn run(args: &Args) -> Result<Answer> {
    let (setup_args, word) = args.setup_and_word();
    setup_args.refuse_step("parameters computes no flight")?;
    let request = setup_args.request()?;
    let setup = request.setup()?;
    let report = ParametersReport::new(&setup);
    let report = match &word {
        Some(word) => report.with_word(word)?,
        None => report,
    };
    // the list shows the setup; its warnings are only in the JSON
    running().warnings().extend(setup.warnings());
    let origin = request.origin();
    Ok(Answer::report(&report, &origin, request.is_json))
}

impl Args {
    /// The setup and the search word. A single argument is the search word, unless it names a
    /// setup.
    fn setup_and_word(&self) -> (SetupArgs, Option<String>) {
        let mut setup_args = self.setup_args.clone();
        if self.word.is_some() || Source::is_named_by(&setup_args.drive.setup) {
            return (setup_args, self.word.clone());
        }
        let word = std::mem::replace(&mut setup_args.drive.setup, DEFAULT_PRESET.into());
        (setup_args, Some(word))
    }
}
