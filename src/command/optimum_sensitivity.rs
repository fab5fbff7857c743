use crate::command::args::OptimumArgs;
use crate::command::names::variables;
use crate::command::output::{Answer, note, note_error, spinner, warn, with_bar};
use crate::command::search::{SearchRequest, allowed_loss, write};
use crate::parameters::{Parameter, Vary};
use crate::report::{OptimizeReport, OptimumSensitivityReport};
use crate::study::{
    Change, Optimum, OptimumAnalysis, change, default_loss, flatness, refuse_varied, sensitivities,
    short_drive,
};
use crate::{Result, Setup};
use std::sync::atomic::AtomicBool;

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    pub optimum: OptimumArgs,

    /// The parameters that the optimum depends on, separated by commas; "all" for every one that
    /// has a value in this setup and is not varied.
    #[arg(
        long,
        value_name = "NAME,…",
        value_delimiter = ',',
        default_value = "all"
    )]
    pub wrt: Vec<String>,

    /// A change of a parameter, e.g. swing.speed=+5mph or air.density=-20% of its value: its effect
    /// on the optimum is predicted, and compared with a new search. Repeatable.
    #[arg(long, value_name = "NAME=AMOUNT", allow_hyphen_values = true)]
    pub change: Vec<String>,

    /// The allowed loss of the outcome, for the range in which each varied parameter may move
    /// [default: 1 yd for a distance, or 1 % of the carry if the carry is below 10 yd; 1 % of the
    /// outcome otherwise].
    #[arg(long, value_name = "AMOUNT", allow_hyphen_values = true)]
    pub loss: Option<String>,
}

pub fn run(args: &Args) -> Result<Answer> {
    let OptimumArgs {
        setup_args, search, ..
    } = &args.optimum;
    let request = setup_args.request()?;
    let instead = "`sensitivity()` is about the drive as stated";
    let drive_search = search.of_drive(&request, None, Some(instead))?;
    let requested = AnalysisRequest::new(args, &drive_search)?;
    let output = args.optimum.destination(&request, std::iter::empty())?;
    let mut optima = args.optimum.optima(&drive_search)?;
    optima.improve_from_club_alone()?;
    let best = &optima.best;
    let written = write(output.as_ref(), &request, &optima, None)?;
    if let Some(moved) = best.moved_start() {
        note(&moved);
    }
    warn(best.warnings(&AtomicBool::new(false)));
    // a changed setup gets the integration step that `optimize` would choose for it
    let integrated = |mut changed: Setup<f64>| {
        let own = request.partial_setup;
        (changed.method, changed.flight.step) = (own.method, own.flight.step);
        request.for_many(changed, &drive_search.search.vary)
    };
    let (mut analysis, mut reason) = (None, None);
    if optima.stopped() == 0 {
        match analyse(best, &requested, &integrated) {
            Err(error) if error.has_valid_input() => {
                note_error(&error);
                reason = Some(error);
            }
            found => analysis = Some(found?),
        }
    }
    let analysis = analysis.as_ref();
    let windows = analysis.map(|analysis| analysis.flatness.windows_with(None));
    let search = OptimizeReport::new(&optima, None, windows, written);
    let report = OptimumSensitivityReport::new(search, analysis, reason.as_ref());
    let answer = Answer::report(&report, &drive_search.origin);
    Ok(answer.found(analysis.is_some_and(OptimumAnalysis::is_answered)))
}

/// The requested derivatives and changes.
struct AnalysisRequest {
    wrt: Vec<&'static Parameter>,
    changes: Vec<Change>,
    /// The value of `--loss`, in the SI unit of the outcome.
    loss: Option<f64>,
}

impl AnalysisRequest {
    fn new(args: &Args, drive_search: &SearchRequest) -> Result<Self> {
        let search = &drive_search.search;
        // with start values, a varied parameter in `wrt` is refused because it is varied, and not
        // because it has no value
        let setup = &Vary::initialized(&drive_search.setup, &search.vary)?;
        let wrt = variables(setup, &args.wrt, &search.outcomes())?;
        let changes = args
            .change
            .iter()
            .map(|text| Change::read(setup, text))
            .collect::<Result<Vec<_>>>()?;
        let is_named =
            |parameter: &Parameter| args.wrt.iter().any(|name| name.trim() == parameter.name);
        let named = wrt.iter().copied().filter(|parameter| is_named(parameter));
        for parameter in named.chain(changes.iter().map(|change| change.parameter)) {
            refuse_varied(search, parameter)?;
        }
        let loss = args
            .loss
            .as_deref()
            .map(|text| allowed_loss("loss", text, search.outcome().quantity(), false))
            .transpose()?;
        Ok(Self { wrt, changes, loss })
    }
}

/// Analyses an optimum; `integrated` chooses the integration step of a changed setup.
fn analyse(
    best: &Optimum,
    requested: &AnalysisRequest,
    integrated: &dyn Fn(Setup<f64>) -> Result<Setup<f64>>,
) -> Result<OptimumAnalysis> {
    let wrt: Vec<_> = requested
        .wrt
        .iter()
        .copied()
        .filter(|parameter| !best.search.parameters().any(|varied| varied == *parameter))
        .collect();
    let sensitivities = with_bar("parameters", |show| sensitivities(best, &wrt, show));
    if let (None, Some((_, message))) = (requested.loss, short_drive(best)) {
        note(message);
    }
    let loss = requested.loss.unwrap_or_else(|| default_loss(best));
    let spinner = spinner("computing drives around the optimum");
    let changes = requested
        .changes
        .iter()
        .map(|stated| change(best, *stated, integrated))
        .collect::<Result<Vec<_>>>()?;
    let flatness = flatness(best, loss)?;
    spinner.finish();
    Ok(OptimumAnalysis {
        sensitivities: sensitivities?,
        flatness,
        changes,
    })
}
